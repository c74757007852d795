"""Models for tests, whole and broken, made from nothing."""

from __future__ import annotations

import base64
import copy
import json
import struct
from typing import Any

import numpy as np

SQUARE = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], np.float32)
CORNERS = np.array([0, 1, 2, 0, 2, 3], np.uint16)


def square() -> tuple[dict[str, Any], bytes]:
    """Return the JSON and the buffer of a glTF square, one metre wide and high."""
    data = SQUARE.tobytes() + CORNERS.tobytes()
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.2, 0.1, 1]}}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 12},
        ],
        "buffers": [{"byteLength": len(data)}],
    }, data


def glb(document: Any, data: bytes = b"") -> bytes:
    """Return a .glb of a document and its buffer."""
    text = document if isinstance(document, bytes) else json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    if data:
        chunks += struct.pack("<II", len(data), 0x004E4942) + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def changed(path: str, value: Any) -> bytes:
    """Return the square with one value of its JSON replaced, as ``nodes.0.mesh``; None takes it away."""
    document, data = square()
    place: Any = document
    *way, last = [int(step) if step.isdigit() else step for step in path.split(".")]
    for step in way:
        place = place[step]
    if value is None:
        del place[last]
    else:
        place[last] = value
    return glb(document, data)


def with_points(points: np.ndarray) -> bytes:
    """Return the square with other places of its vertices."""
    document, data = square()
    return glb(document, points.astype(np.float32).tobytes() + data[48:])


def _deep(levels: int) -> bytes:
    document, data = square()
    document["nodes"] = [{"children": [index + 1]} for index in range(levels)] + [{"mesh": 0}]
    return glb(document, data)


def _many(nodes: int) -> bytes:
    document, data = square()
    document["nodes"] = [{"mesh": 0}] * nodes
    document["scenes"] = [{"nodes": list(range(nodes))}]
    return glb(document, data)


def _swarm() -> bytes:
    """Return a model of few bytes whose meshes are in it so often that it has too many vertices."""
    document, data = square()
    document["nodes"] = [{"mesh": 0}] * 15_000
    document["scenes"] = [{"nodes": list(range(15_000))}]
    document["accessors"][0] = {"componentType": 5126, "count": 100_000, "type": "VEC3"}
    return glb(document, data)


def _json_only(text: bytes) -> bytes:
    return struct.pack("<4sII", b"glTF", 2, 20 + len(text)) + struct.pack("<II", len(text), 0x4E4F534A) + text


def broken_glbs() -> dict[str, bytes]:
    """Return damaged .glb files by what is wrong with them."""
    document, data = square()
    whole = glb(document, data)
    outside = "data:application/octet-stream;base64," + base64.b64encode(b"short").decode()
    return {
        "empty": b"",
        "only the magic": b"glTF",
        "half": whole[: len(whole) // 2],
        "last byte missing": whole[:-1],
        "text": b"glTF broken, and this is no model at all",
        "version 1": whole[:4] + struct.pack("<I", 1) + whole[8:],
        "length too long": whole[:8] + struct.pack("<I", 1 << 30) + whole[12:],
        "chunk too long": whole[:12] + struct.pack("<I", 1 << 31) + whole[16:],
        "binary first": whole[:16] + struct.pack("<I", 0x004E4942) + whole[20:],
        "no json": _json_only(b"not json"),
        "json list": _json_only(b"[1, 2, 3, 4]"),
        "json number": _json_only(b"1234"),
        "nested json": _json_only(b"[" * 200_000 + b"]" * 200_000),
        "nan in json": _json_only(b'{"asset": {"version": "2.0"}, "x": NaN }'),
        "wrong utf-8": _json_only(b"\xff\xfe{}"),
        "old": changed("asset.version", "1.0"),
        "no version": changed("asset", {}),
        "compressed": changed("extensionsRequired", ["EXT_meshopt_compression"]),
        "nodes is a number": changed("nodes", 7),
        "a node is a number": changed("nodes.0", 7),
        "scene out of range": changed("scene", 9),
        "node out of range": changed("scenes.0.nodes", [5]),
        "negative node": changed("scenes.0.nodes", [-1]),
        "own child": changed("nodes", [{"children": [0], "mesh": 0}]),
        "cycle": changed("nodes", [{"children": [1]}, {"children": [2]}, {"children": [0], "mesh": 0}]),
        "two parents": changed("nodes", [{"children": [1, 2]}, {"children": [2]}, {"mesh": 0}]),
        "deep": _deep(5_000),
        "many nodes": _many(30_000),
        "swarm": _swarm(),
        "bad matrix": changed("nodes.0.matrix", [1, 2, 3]),
        "huge scale": changed("nodes.0.scale", [1e300, 1, 1]),
        "text for a place": changed("nodes.0.translation", ["a", 0, 0]),
        "mesh out of range": changed("nodes.0.mesh", 3),
        "mesh is true": changed("nodes.0.mesh", True),
        "no primitives": changed("meshes.0.primitives", None),
        "primitive is text": changed("meshes.0.primitives", ["x"]),
        "no positions": changed("meshes.0.primitives.0.attributes", {}),
        "lines only": changed("meshes.0.primitives.0.mode", 1),
        "material out of range": changed("meshes.0.primitives.0.material", 4),
        "huge count": changed("accessors.0.count", 10**12),
        "count beyond the buffer": changed("accessors.0.count", 400),
        "negative count": changed("accessors.0.count", -4),
        "unknown numbers": changed("accessors.0.componentType", 9),
        "unhashable type": changed("accessors.0.type", ["VEC3"]),
        "flat positions": changed("accessors.0.type", "VEC2"),
        "stride of nothing": changed("bufferViews.0.byteStride", 1),
        "view beyond the buffer": changed("bufferViews.0.byteLength", 10_000),
        "buffer shorter than it says": changed("buffers.0.byteLength", 1 << 20),
        "buffer address is a number": changed("buffers.0.uri", 5),
        "buffer data too short": changed("buffers.0.uri", outside),
        "damaged data address": changed("buffers.0.uri", "data:application/octet-stream;base64,???"),
        "face beyond the vertices": glb(document, data[:48] + np.array([0, 1, 9, 0, 2, 3], np.uint16).tobytes()),
        "nan": with_points(np.where(np.arange(12).reshape(4, 3) == 5, np.nan, SQUARE)),
        "infinite": with_points(SQUARE * np.float32(1e30)),
        "one point": with_points(SQUARE * 0),
        "one line": with_points(SQUARE * (1, 0, 0)),
        "no faces": changed("accessors.1.count", 0),
        "skin out of range": changed("nodes.0.skin", 0),
        "sparse beyond": changed(
            "accessors.0.sparse",
            {
                "count": 2,
                "indices": {"bufferView": 1, "componentType": 5123, "byteOffset": 1 << 20},
                "values": {"bufferView": 0},
            },
        ),
    }


def broken_objs() -> dict[str, bytes]:
    """Return damaged .obj files by what is wrong with them."""
    points = b"v 0 0 0\nv 1 0 0\nv 1 1 0\n"
    return {
        "empty": b"",
        "no faces": points,
        "faces only": b"f 1 2 3\n",
        "face beyond": points + b"f 1 2 9\n",
        "face before": points + b"f -1 -2 -9\n",
        "face zero": points + b"f 0 1 2\n",
        "face of words": points + b"f a b c\n",
        "face of a huge number": points + b"f 1 2 " + b"9" * 5000 + b"\n",
        "words": b"v a b c\n" + points + b"f 1 2 3\n",
        "nan": b"v nan 0 0\n" + points + b"f 1 2 3\n",
        "infinite": b"v 1e39 0 0\n" + points + b"f 1 2 3\n",
        "short": b"v 1\nv 2\nv 3\nf 1 2 3\n",
        "one point": b"v 0 0 0\n" * 3 + b"f 1 2 3\n",
        "binary": bytes(range(256)) * 40,
        "two corners": points + b"f 1 2\n",
    }


def mutated(seed: int) -> bytes:
    """Return the square with a few bytes or values changed by chance."""
    chance = np.random.default_rng(seed)
    document, data = square()
    if seed % 2:
        whole = bytearray(glb(document, data))
        for place in chance.integers(0, len(whole), 1 + seed % 5):
            whole[place] = int(chance.integers(0, 256))
        return bytes(whole)
    return glb(_shaken(copy.deepcopy(document), chance), data)


_ODD: tuple[Any, ...] = (
    None,
    -1,
    0,
    1,
    2,
    255,
    1 << 40,
    -(1 << 70),
    0.5,
    1e308,
    "",
    "0",
    "../x",
    [],
    [0],
    {},
    True,
    [[]],
)


def _shaken(value: Any, chance: np.random.Generator) -> Any:
    if chance.random() < 0.03:
        return _ODD[int(chance.integers(len(_ODD)))]
    if isinstance(value, dict):
        return {key: _shaken(item, chance) for key, item in value.items()}
    if isinstance(value, list):
        return [_shaken(item, chance) for item in value]
    return value
