"""A glTF document and its numbers: .glb and .gltf, read without trusting a single length, index or address."""

from __future__ import annotations

import base64
import binascii
import json
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.models.addresses import inside
from storyblender.blender.models.limits import CORNERS, FILE_BYTES, JSON_BYTES, MIB, PARTS
from storyblender.errors import InputError

Json = dict[str, Any]

_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_JSON_CHUNK, _BINARY_CHUNK = 0x4E4F534A, 0x004E4942


@dataclass
class Document:
    """A glTF file: its JSON, and its buffers as far as they are asked for.

    Attributes:
        json: The whole document; every list in it may hold anything.
        folder: The folder of models.
        base: The folder of the file.
        binary: The binary chunk of a .glb; empty without one.
    """

    json: Json
    folder: Path
    base: Path
    binary: bytes

    def __post_init__(self) -> None:
        self._buffers: dict[int, bytes] = {}
        self._lists: dict[str, list[Json]] = {}
        self._read = 0

    def items(self, name: str) -> list[Json]:
        """Return one of the document's lists, checked the first time it is asked for.

        Raises:
            InputError: It is no list of objects, or a very long one.
        """
        if name in self._lists:
            return self._lists[name]
        found = self.json.get(name, [])
        if not isinstance(found, list) or not all(isinstance(item, dict) for item in found):
            raise InputError(f"its {name!r} is no list of objects")
        if len(found) > PARTS * 10:
            raise InputError(f"it has {len(found)} {name}, which is too many")
        self._lists[name] = found
        return found

    def item(self, name: str, index: Any) -> Json:
        """Return one object of a list of the document.

        Args:
            name: Key of the list, for example ``meshes``.
            index: As read from the file, of any type.

        Raises:
            InputError: The index leads nowhere.
        """
        found = self.items(name)
        return found[whole(index, f"index into its {name}", len(found) - 1)]

    def bytes_of(self, view: Any) -> memoryview:
        """Return the bytes of a buffer view.

        Raises:
            InputError: It reaches beyond its buffer.
        """
        record = self.item("bufferViews", view)
        data = self._buffer(record.get("buffer"))
        start = whole(record.get("byteOffset", 0), "byteOffset", FILE_BYTES)
        length = whole(record.get("byteLength"), "byteLength", FILE_BYTES)
        if start + length > len(data):
            raise InputError("a part of it lies beyond the end of its buffer")
        return memoryview(data)[start : start + length]

    def numbers(self, accessor: Any) -> NDArray[np.float64]:
        """Return the (n, width) numbers of an accessor, normalized ones as 0..1 or -1..1.

        Raises:
            InputError: It reaches beyond its buffer, or is of an unknown kind.
        """
        record = self.item("accessors", accessor)
        kind, width = _kind(record)
        count = whole(record.get("count"), "count", CORNERS)
        if record.get("bufferView") is None:
            values = np.zeros((count, width))
        else:
            stride = self.item("bufferViews", record["bufferView"]).get("byteStride")
            start = whole(record.get("byteOffset", 0), "byteOffset", FILE_BYTES)
            values = _strided(self.bytes_of(record["bufferView"]), start, kind, (count, width), stride)
        if isinstance(sparse := record.get("sparse"), dict):
            values = self._replaced(values.copy(), sparse, kind)
        if record.get("normalized") is True and kind.kind != "f":
            values = np.maximum(values / float(np.iinfo(kind).max), -1.0)
        return values

    def _replaced(self, values: NDArray[np.float64], sparse: Json, kind: np.dtype[Any]) -> NDArray[np.float64]:
        """Return the numbers with those that a sparse accessor puts in their place."""
        count = whole(sparse.get("count"), "sparse count", len(values))
        indices, replaced = sparse.get("indices"), sparse.get("values")
        if not isinstance(indices, dict) or not isinstance(replaced, dict):
            raise InputError("its sparse numbers are not whole")
        index_kind, _ = _kind({"componentType": indices.get("componentType"), "type": "SCALAR"})
        starts = [whole(part.get("byteOffset", 0), "byteOffset", FILE_BYTES) for part in (indices, replaced)]
        which = _strided(self.bytes_of(indices.get("bufferView")), starts[0], index_kind, (count, 1), None)[:, 0]
        if count and (which.min() < 0 or which.max() >= len(values)):
            raise InputError("its sparse numbers have an index out of range")
        width = values.shape[1]
        values[which.astype(int)] = _strided(
            self.bytes_of(replaced.get("bufferView")), starts[1], kind, (count, width), None
        )
        return values

    def _buffer(self, index: Any) -> bytes:
        record = self.item("buffers", index)
        if index not in self._buffers:
            length = whole(record.get("byteLength"), "byteLength", FILE_BYTES)
            data = self.resource(record.get("uri"), index)
            if len(data) < length:
                raise InputError(f"its buffer has {len(data)} of {length} bytes")
            self._read += length
            if self._read > FILE_BYTES:
                raise InputError(f"its buffers have more than {FILE_BYTES // MIB} MiB together")
            self._buffers[index] = data[:length]
        return self._buffers[index]

    def resource(self, uri: Any, index: int = 0) -> bytes:
        """Return what an address holds: a data address, a file in the folder of models, or the binary chunk.

        Args:
            uri: As read from the file, of any type; None for the binary chunk.
            index: Number of the buffer; only buffer 0 can be the binary chunk.

        Raises:
            InputError: The address leads elsewhere.
        """
        if uri is None and index == 0:
            return self.binary
        if not isinstance(uri, str):
            raise InputError("a buffer or picture has no address")
        if not uri.startswith("data:"):
            return inside(self.folder, self.base, uri, quoted=True).read_bytes()
        head, comma, body = uri.partition(",")
        try:
            if not comma or not head.endswith(";base64"):
                raise ValueError
            return base64.b64decode(body, validate=True)
        except (ValueError, binascii.Error) as error:
            raise InputError("a data address in it is damaged") from error


def read_document(path: Path, folder: Path) -> Document:
    """Read a .glb or .gltf.

    Args:
        path: The file.
        folder: The folder of models.

    Raises:
        InputError: It is damaged, of another version, or nested too deeply.
    """
    data = path.read_bytes()
    text, binary = _chunks(data) if data[:4] == b"glTF" or path.suffix.lower() == ".glb" else (data, b"")
    if len(text) > JSON_BYTES:
        raise InputError(f"its JSON has {len(text) // MIB} MiB; at most {JSON_BYTES // MIB} are read")
    try:
        parsed = json.loads(text.decode("utf-8-sig"), parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        raise InputError("its JSON is damaged") from error
    asset = parsed.get("asset") if isinstance(parsed, dict) else None
    version = str(asset.get("version", "")) if isinstance(asset, dict) else ""
    if not version.startswith("2"):
        raise InputError(f"it is glTF version {version[:8]!r}; 2.0 is read" if version else "it is no glTF")
    return Document(parsed, folder, path.parent, binary)


def _chunks(data: bytes) -> tuple[bytes, bytes]:
    """Return the JSON and the binary chunk of a .glb."""
    if len(data) < 20 or data[:4] != b"glTF":
        raise InputError("it is no .glb, or only the beginning of one")
    version, length = struct.unpack_from("<II", data, 4)
    if version != 2:
        raise InputError(f"it is a .glb of version {version}; 2 is read")
    if length > len(data):
        raise InputError(f"it is cut off: {len(data)} of {length} bytes are there")
    chunks: dict[int, bytes] = {}
    at = 12
    while at + 8 <= length:
        size, kind = struct.unpack_from("<II", data, at)
        if at + 8 + size > length:
            raise InputError("a chunk in it is longer than the file")
        if not chunks and kind != _JSON_CHUNK:
            raise InputError("its first chunk is no JSON")
        chunks.setdefault(kind, data[at + 8 : at + 8 + size])
        at += 8 + size
    if _JSON_CHUNK not in chunks:
        raise InputError("it holds no JSON chunk")
    return chunks[_JSON_CHUNK], chunks.get(_BINARY_CHUNK, b"")


def whole(value: Any, what: str, most: int) -> int:
    """Return a value of the document that must be a whole number.

    Args:
        value: As read from the file, of any type.
        what: What it counts, for the message.
        most: Largest number allowed; the least is 0.

    Raises:
        InputError: It is no whole number, or out of range.
    """
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= most:
        raise InputError(f"its {what} is {str(value)[:24]}, which is out of range")
    return value


def _kind(record: Json) -> tuple[np.dtype[Any], int]:
    kind, width = record.get("componentType"), record.get("type")
    if not isinstance(kind, int) or kind not in _TYPES or not isinstance(width, str) or width not in _WIDTHS:
        raise InputError("its numbers are of an unknown kind")
    return np.dtype(_TYPES[kind]), _WIDTHS[width]


def _strided(
    data: memoryview, start: int, kind: np.dtype[Any], shape: tuple[int, int], stride: Any
) -> NDArray[np.float64]:
    """Return (n, width) numbers that lie ``stride`` bytes apart."""
    count, width = shape
    row = kind.itemsize * width
    step = row if stride is None else whole(stride, "byteStride", 252)
    if step < row or (count and start + step * (count - 1) + row > len(data)):
        raise InputError("its numbers lie beyond the end of their buffer")
    if not count:
        return np.zeros(shape)
    view = np.ndarray(shape, kind, data, start, (step, kind.itemsize))
    return view.astype(np.float64)


def _no_number(text: str) -> float:
    raise ValueError(text)


def finite_numbers(values: Any, count: int) -> NDArray[np.float64]:
    """Return numbers of the document as an array (count,).

    Args:
        values: As read from the file, of any type.
        count: How many there must be.

    Raises:
        InputError: They are fewer or more, no numbers, or not below 1e12.
    """
    plain = isinstance(values, list | tuple) and len(values) == count
    if not plain or not all(isinstance(value, int | float) and abs(value) < 1e12 for value in values):
        raise InputError("a matrix, colour or factor in it is no list of numbers")
    return np.array(values, float)
