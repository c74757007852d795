"""Packs: entries of a library in one .zip, with all that is known of them, to carry to another library."""

from __future__ import annotations

import zipfile
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

from storyblender.errors import InputError, ServiceFailure
from storyblender.folder import Folder
from storyblender.library.model_folders import MODEL_SUFFIXES
from storyblender.library.shared.entries import LibraryEntry
from storyblender.library.shared.shared_library import SharedLibrary, read_entry
from storyblender.outputs import digest_of
from storyblender.services.archives import MODEL_FILES, ArchiveLimits, extract

_SUFFIXES: Final = MODEL_FILES | {*MODEL_SUFFIXES, ".hdr", ".exr", ".bvh", ".toml", ".txt", ".json"}
_LIMITS: Final = ArchiveLimits(files=50_000, bytes=16 << 30, depth=12)


def pack(library: SharedLibrary, entries: Sequence[LibraryEntry], out: Path) -> int:
    """Write entries with their files into a .zip; return how many, those with damaged files left out.

    Args:
        library: Has the entries.
        entries: What to pack.
        out: The file; one that is there is replaced.

    Raises:
        InputError: There is nothing to pack, or the disk cannot take it.
    """
    whole = [entry for entry in entries if library.get(entry.digest) is not None]
    if not whole:
        raise InputError("there is nothing to pack", mend="see `storyblender library list`")
    with Folder(out.parent).writing(out.name) as part, zipfile.ZipFile(part, "w", zipfile.ZIP_DEFLATED) as archive:
        for entry in whole:
            archive.writestr(f"{entry.digest}.json", entry.model_dump_json(indent=1))
            folder = library.bundle_of(entry)
            for path in sorted(each for each in folder.rglob("*") if each.is_file()):
                archive.write(path, f"{entry.digest}/{path.relative_to(folder).as_posix()}")
    return len(whole)


def unpack(library: SharedLibrary, archive: Path) -> list[LibraryEntry]:
    """Add what a pack holds to a library; return the entries.

    Nothing of it is written anywhere but into the library, and an entry whose files are not those that its digest was
    taken of refuses the pack.

    Args:
        library: Where to.
        archive: A .zip that ``pack`` wrote, here or elsewhere.

    Raises:
        InputError: It is no pack, is damaged, or is meant to do harm.
    """
    with TemporaryDirectory() as name:
        folder = Path(name)
        try:
            names = extract(archive, folder, _SUFFIXES, _LIMITS)
        except (ServiceFailure, OSError) as error:
            raise InputError(f"cannot be unpacked: {error}", path=archive) from error
        records = [folder / each for each in names if "/" not in each and each.endswith(".json")]
        entries = [_entry_of(record, archive) for record in records]
        if not entries:
            raise InputError("is not a pack of a library", path=archive)
        return [library.add(entry.facts, folder / entry.digest) for entry in entries]


def _entry_of(record: Path, archive: Path) -> LibraryEntry:
    """Return what a record in a pack says; its files are beside it. Raises InputError."""
    entry = read_entry(record.read_text(encoding="utf-8", errors="replace"))
    folder = record.with_suffix("")
    if entry is None or entry.digest != folder.name or not (folder / entry.main).is_file():
        raise InputError("is not a pack of a library", path=archive)
    if digest_of(folder) != entry.digest:
        raise InputError(f"the files of {entry.name!r} in it are not those that were packed", path=archive)
    return entry
