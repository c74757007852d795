"""Small model files for tests, and pictures of what is in none."""

from __future__ import annotations

import base64
import io
import json
import re
import struct
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from PIL import Image

_FACES = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
Box = tuple[tuple[float, float, float], tuple[float, float, float]]
CABINET: Box = (-0.25, -0.4, 0.0), (0.25, 0.4, 0.6)
DIAL: Box = (0.25, -0.3, 0.4), (0.31, -0.1, 0.55)


def write_cabinet(folder: Path, name: str = "radio") -> Path:
    """Write a grey cabinet, 0.5 m wide, 0.8 m deep and 0.6 m high, whose red dial is high up on its right side.

    Args:
        folder: Of the .obj and its materials.
        name: Of the files.
    """
    colors = {"grey": "0.4 0.4 0.4", "red": "0.9 0.05 0.05"}
    (folder / f"{name}.mtl").write_text("".join(f"newmtl {key}\nKd {color}\n" for key, color in colors.items()))
    lines = [f"mtllib {name}.mtl"]
    for number, (color, (low, high)) in enumerate((("grey", CABINET), ("red", DIAL))):
        corners = ((x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2]))
        lines += [f"v {x} {z} {-y}" for x, y, z in corners]  # Y is up in the file
        lines += [f"usemtl {color}", *(f"f {' '.join(str(corner + 8 * number) for corner in face)}" for face in _FACES)]
    path = folder / f"{name}.obj"
    path.write_text("\n".join(lines) + "\n")
    return path


def tile(number: int) -> bytes:
    """Return a PNG of one colour, which the number tells."""
    png = io.BytesIO()
    Image.new("RGB", (64, 64), (40 * number, 0, 0)).save(png, "PNG")
    return png.getvalue()


def box_gltf(size: tuple[float, float, float], colour: int = 3, name: str = "scene") -> dict[str, bytes]:
    """Return the files of a textured box as glTF with its buffer and picture beside it.

    Args:
        size: Width, depth and height in metres; it stands on the ground.
        colour: Number of its ``tile``.
        name: Of the files.
    """
    x, y, z = size[0] / 2, size[1] / 2, size[2]
    corners = [(sx * x, z * up, sy * y) for sx in (-1, 1) for sy in (-1, 1) for up in (0, 1)]  # Y is up in the file
    triangles = [corner - 1 for a, b, c, d in _FACES for corner in (a, b, c, a, c, d)]
    points = b"".join(struct.pack("<3f", *corner) for corner in corners)
    spots = b"".join(struct.pack("<2f", corner[0] > 0, corner[1] > 0) for corner in corners)
    buffer = points + spots + b"".join(struct.pack("<H", corner) for corner in triangles)
    lengths = len(points), len(spots), 2 * len(triangles)
    starts = 0, lengths[0], lengths[0] + lengths[1]
    model = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": name}],
        "meshes": [
            {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]},
        ],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}}],
        "textures": [{"source": 0}],
        "images": [{"uri": f"textures/{name}_diff_1k.png"}],
        "buffers": [{"uri": f"{name}.bin", "byteLength": len(buffer)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": start, "byteLength": length}
            for start, length in zip(starts, lengths, strict=True)
        ],
        "accessors": [
            {
                "bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
                "min": [-x, 0, -y], "max": [x, z, y],
            },
            {"bufferView": 1, "componentType": 5126, "count": 8, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": len(triangles), "type": "SCALAR"},
        ],
    }  # fmt: skip
    return {
        f"{name}.gltf": json.dumps(model).encode(),
        f"{name}.bin": buffer,
        f"textures/{name}_diff_1k.png": tile(colour),
    }


def glb_of(files: Mapping[str, bytes]) -> bytes:
    """Return the files of ``box_gltf`` as one .glb file, its picture as a data URI."""
    model = json.loads(next(content for name, content in files.items() if name.endswith(".gltf")))
    buffer = next(content for name, content in files.items() if name.endswith(".bin"))
    picture = next(content for name, content in files.items() if name.endswith(".png"))
    model["images"][0]["uri"] = "data:image/png;base64," + base64.b64encode(picture).decode()
    del model["buffers"][0]["uri"]
    chunks = b""
    for kind, content, pad in ((0x4E4F534A, json.dumps(model).encode(), b" "), (0x004E4942, buffer, b"\0")):
        content += pad * (-len(content) % 4)
        chunks += struct.pack("<II", len(content), kind) + content
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def turn_obj(path: Path, turn: np.ndarray) -> Path:
    """Turn the points of an .obj in its file.

    Args:
        path: The file, which is written anew.
        turn: (3, 3) rotation in the file's frame.
    """
    lines = []
    for line in path.read_text().splitlines():
        if line.startswith("v "):
            line = "v " + " ".join(f"{value:.6f}" for value in turn @ [float(each) for each in line.split()[1:4]])
        elif line.startswith("vn "):
            continue
        lines.append(re.sub(r"(\d+)/(\d*)/\d+", r"\1/\2", line))
    path.write_text("\n".join(lines) + "\n")
    return path


def write_globe(path: Path, steps: int, texture: bytes = b"") -> Path:
    """Write a globe of radius 0.4 m, a little bumpy, as a .glb of ``2 * steps ** 2`` triangles with a picture on it.

    Args:
        path: Of the .glb.
        steps: Around it, and from pole to pole.
        texture: PNG or JPEG; a small one if not given.
    """
    u, v = np.meshgrid(np.linspace(0, 1, steps + 1), np.linspace(0, 1, steps + 1), indexing="ij")
    radius = 0.4 + 0.01 * np.sin(16 * np.pi * u) * np.sin(12 * np.pi * v)
    around, down = 2 * np.pi * u, np.pi * v
    places = [radius * np.sin(down) * np.cos(around), radius * np.cos(down), radius * np.sin(down) * np.sin(around)]
    corner = np.arange((steps + 1) ** 2).reshape(steps + 1, steps + 1)
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    faces = np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])
    picture = texture or tile(3)
    blobs = [
        np.stack(places, -1).astype("<f4").tobytes(),
        np.stack([u, v], -1).astype("<f4").tobytes(),
        faces.astype("<u4").tobytes(),
        picture + bytes(-len(picture) % 4),
    ]
    starts = [sum(map(len, blobs[:number])) for number in range(len(blobs))]
    views = [{"buffer": 0, "byteOffset": at, "byteLength": len(blob)} for at, blob in zip(starts, blobs, strict=True)]
    views[3]["byteLength"] = len(picture)
    kind = "image/png" if picture[:4] == b"\x89PNG" else "image/jpeg"
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        "images": [{"bufferView": 3, "mimeType": kind}],
        "buffers": [{"byteLength": sum(map(len, blobs))}],
        "bufferViews": views,
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": corner.size, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": corner.size, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5125, "count": faces.size, "type": "SCALAR"},
        ],
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = [(0x4E4F534A, text), (0x004E4942, b"".join(blobs))]
    body = b"".join(struct.pack("<II", len(data), code) + data for code, data in chunks)
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)
    return path
