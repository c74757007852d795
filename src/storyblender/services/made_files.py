"""What services send back, checked before anything else opens it: a picture is a picture, a .glb holds all it needs."""

from __future__ import annotations

import io
import json
import struct
import warnings
from pathlib import Path
from typing import Any, Final

from storyblender.services.making import Unusable

MOST_PICTURE_BYTES: Final = 32 << 20
MOST_MODEL_BYTES: Final = 256 << 20
LEAST_SIDE, MOST_SIDE = 128, 1536
"""Pixels: services refuse smaller pictures, and gain nothing from larger ones."""
_MOST_PIXELS: Final = 5000 * 5000
_MOST_HEADER: Final = 16 << 20
_GLB: Final = struct.Struct("<4sIIII")


def picture_from(data: bytes) -> bytes:
    """Return a picture as an opaque PNG of 128 to 1536 pixels a side, on white, with nothing in it but pixels.

    Args:
        data: PNG, JPEG or WebP, as a service sent it.

    Raises:
        Unusable: It is no such picture.
    """
    from PIL import Image

    if len(data) > MOST_PICTURE_BYTES:
        raise Unusable("the picture that came back is too large")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            with Image.open(io.BytesIO(data), formats=("PNG", "JPEG", "WEBP")) as opened:
                if opened.width * opened.height > _MOST_PIXELS or min(opened.size) < LEAST_SIDE:
                    raise Unusable(f"the picture that came back has {opened.width} x {opened.height} pixels")
                picture = opened.convert("RGBA")
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError, Image.DecompressionBombWarning) as error:
        raise Unusable("what came back is no picture") from error
    paper = Image.new("RGBA", picture.size, "white")
    paper.alpha_composite(picture)
    paper.thumbnail((MOST_SIDE, MOST_SIDE))
    out = io.BytesIO()
    paper.convert("RGB").save(out, "PNG")
    return out.getvalue()


def check_glb(path: Path) -> None:
    """Check that a file is a binary glTF 2.0 with all of its parts inside.

    Args:
        path: Of the file.

    Raises:
        Unusable: It is none, is cut off, or refers to other files.
    """
    with path.open("rb") as file:
        head = file.read(_GLB.size)
        if len(head) < _GLB.size:
            raise Unusable("what came back is no model")
        magic, version, length, size, kind = _GLB.unpack(head)
        if magic != b"glTF" or version != 2 or kind != 0x4E4F534A:
            raise Unusable("what came back is no model in the .glb format")
        if length != path.stat().st_size or size > min(_MOST_HEADER, length - _GLB.size):
            raise Unusable("the model that came back is cut off")
        header = file.read(size)
    try:
        parts: Any = json.loads(header)
        linked = [each.get("uri") for name in ("buffers", "images") for each in parts.get(name, [])]
        meshes = parts.get("meshes")
    except (ValueError, AttributeError, TypeError, RecursionError) as error:
        raise Unusable("the model that came back is damaged") from error
    if any(uri is not None and not (isinstance(uri, str) and uri.startswith("data:")) for uri in linked):
        raise Unusable("the model that came back refers to other files")
    if not meshes:
        raise Unusable("the model that came back is empty")
