"""glTF models from outside: what a file names lies beside it, and nothing else is read for it."""

from __future__ import annotations

import json
import struct
import warnings
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import Any, Final
from urllib.parse import unquote

from storyblender.errors import ServiceFailure
from storyblender.services.archives import inside_name

MODEL: Final = "model.gltf"
"""Name of every fetched model."""
_BUFFER = "model.bin"
_MOST_TEXT = 64 << 20
"""Bytes of the text of a model."""
_MOST_PIXELS = 8192
"""Along a side of a picture."""
_HEADER, _CHUNK = struct.Struct("<4sII"), struct.Struct("<II")
_JSON, _BIN = 0x4E4F534A, 0x004E4942


def check_gltf(path: Path) -> int:
    """Check a .gltf file and what it names.

    Args:
        path: Of the file.

    Returns:
        Its triangles; 0 where it does not say.

    Raises:
        ServiceFailure: It is no glTF 2 model, or it names what is not beside it.
    """
    model = _read(path)
    for place, uri in _uris(model):
        if not uri.startswith("data:"):
            beside = path.parent / inside_name(unquote(uri))
            if not beside.is_file():
                raise ServiceFailure("the model names a file that did not come with it")
            if place == "images":
                check_picture(beside)
    return _triangles(model)


def check_picture(path: Path) -> None:
    """Check that a file is a picture, and none that unpacks to far more than it should. Raises ServiceFailure."""
    from PIL import Image

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            with Image.open(path, formats=("PNG", "JPEG", "WEBP")) as picture:
                if max(picture.size) > _MOST_PIXELS:
                    raise ServiceFailure(f"a picture has {picture.width} x {picture.height} pixels")
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
        raise ServiceFailure("a picture of the download is none") from error


def unpack_glb(path: Path, folder: Path) -> None:
    """Write a .glb file as ``MODEL`` with its buffer beside it.

    Args:
        path: Of the .glb file.
        folder: Where to.

    Raises:
        ServiceFailure: It is no glTF 2 model.
    """
    content = path.read_bytes()
    chunks = dict(_chunks(content))
    model = _parsed(chunks.get(_JSON, b""))
    buffers = model.get("buffers")
    if _BIN in chunks and isinstance(buffers, list) and buffers and isinstance(buffers[0], dict):
        buffers[0]["uri"] = _BUFFER
        part = folder / _BUFFER
        part.write_bytes(chunks[_BIN])
    part = folder / MODEL
    part.write_text(json.dumps(model), encoding="utf-8")


def _chunks(content: bytes) -> Iterator[tuple[int, bytes]]:
    """Yield the kind and the content of the chunks of a .glb file. Raises ServiceFailure."""
    if len(content) < _HEADER.size:
        raise ServiceFailure("the file is no glTF model")
    magic, version, length = _HEADER.unpack_from(content)
    if magic != b"glTF" or version != 2 or length != len(content):
        raise ServiceFailure("the file is no whole glTF model")
    at = _HEADER.size
    while at + _CHUNK.size <= length:
        size, kind = _CHUNK.unpack_from(content, at)
        at += _CHUNK.size
        if at + size > length:
            raise ServiceFailure("the file is no whole glTF model")
        yield kind, content[at : at + size]
        at += size


def _read(path: Path) -> dict[str, Any]:
    try:
        if path.stat().st_size > _MOST_TEXT:
            raise ServiceFailure("the model's text is too long")
        return _parsed(path.read_bytes())
    except OSError as error:
        raise ServiceFailure("the model cannot be read") from error


def _parsed(content: bytes) -> dict[str, Any]:
    """Return a model's text as values. Raises ServiceFailure."""
    try:
        model = json.loads(content)
        version = model["asset"]["version"]
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise ServiceFailure("the file is no glTF model") from error
    if not isinstance(version, str) or not version.startswith("2."):
        raise ServiceFailure("the model is of another version of glTF")
    return model


def _uris(model: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield ``buffers`` or ``images``, and what is named there."""
    for place in ("buffers", "images"):
        listed = model.get(place)
        for each in listed if isinstance(listed, list) else []:
            uri = each.get("uri") if isinstance(each, dict) else None
            if isinstance(uri, str):
                yield place, uri


def _triangles(model: dict[str, Any]) -> int:
    """Return the triangles of all primitives, each counted once however often it is placed."""
    accessors, total = model.get("accessors"), 0
    for mesh in _dicts(model.get("meshes")):
        for primitive in _dicts(mesh.get("primitives")):
            attributes = primitive.get("attributes")
            vertices = attributes.get("POSITION") if isinstance(attributes, dict) else None
            index = primitive.get("indices", vertices)
            if isinstance(accessors, list) and isinstance(index, int) and 0 <= index < len(accessors):
                count = accessors[index].get("count") if isinstance(accessors[index], dict) else 0
                total += count // 3 if isinstance(count, int) and 0 < count < 1 << 40 else 0
    return total


def _dicts(value: Any) -> Iterator[dict[str, Any]]:
    yield from (each for each in (value if isinstance(value, list) else []) if isinstance(each, dict))


def main_of(names: tuple[str, ...]) -> str:
    """Return which of the files of an archive is the model: a .gltf before a .glb, the one nearest to the top.

    Raises:
        ServiceFailure: There is none.
    """
    models = [name for name in names if PurePosixPath(name).suffix.lower() in (".gltf", ".glb")]
    if not models:
        raise ServiceFailure("the archive has no glTF model in it")
    return min(models, key=lambda name: (name.lower().endswith(".glb"), name.count("/"), name))
