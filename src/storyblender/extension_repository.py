"""The Blender extension as a zip, beside the list that makes the folder a repository Blender can add."""

from __future__ import annotations

import hashlib
import io
import json
import tomllib
import zipfile
from importlib.resources import files
from pathlib import Path

from storyblender.folder import Folder

INDEX = "index.json"
"""The list, as Blender's own ``extension server-generate`` writes it."""
MANIFEST = "blender_manifest.toml"
_SOURCE = Path(str(files("storyblender"))) / "blender_extension"
_EARLIEST = (1980, 1, 1, 0, 0, 0)
"""The time of every file in the zip, so that the same extension is the same zip."""


def write_repository(folder: Path) -> list[str]:
    """Write the repository, and return the names of its files.

    Args:
        folder: Made if it does not exist; what else is in it stays.

    Raises:
        InputError: The disk does not take them.
    """
    manifest = tomllib.loads((_SOURCE / MANIFEST).read_text(encoding="utf-8"))
    archive, name = extension_zip(), f"{manifest['id']}-{manifest['version']}.zip"
    listed = manifest | {
        "archive_url": f"./{name}",
        "archive_size": len(archive),
        "archive_hash": f"sha256:{hashlib.sha256(archive).hexdigest()}",
    }
    room = Folder(folder)
    room.make()
    room.write(name, archive)
    room.write(INDEX, json.dumps({"version": "v1", "blocklist": [], "data": [listed]}, indent=2))
    return [name, INDEX]


def extension_zip() -> bytes:
    """Return the extension as Blender installs it; the same bytes for the same files."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted([_SOURCE / MANIFEST, *_SOURCE.glob("*.py")]):
            entry = zipfile.ZipInfo(path.name, _EARLIEST)
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, path.read_bytes(), zipfile.ZIP_DEFLATED)
    return packed.getvalue()
