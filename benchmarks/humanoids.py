"""Humanoid models of many kinds as .glb files, which have nothing of our topology: for the benchmark and the tests."""

from __future__ import annotations

import json
import struct
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.cast.stance import COUNT, SIZE_OF, TURN_OF, stance_of
from storyblender.blender.cast.template import template_of
from storyblender.blender.people.pack import PARTS, load_body_pack
from storyblender.blender.props.build import build_prop
from storyblender.catalog.bodies import recipe
from storyblender.catalog.skeleton import BONE_INDEX, SKELETON
from storyblender.memory.asset_sheet import CharacterLook

Points = NDArray[np.float64]
Triangles = NDArray[np.int64]
Color = tuple[float, float, float]
Part = tuple[Points, Triangles, Color]
STEEL, SUIT, RED, GREEN = (0.4, 0.4, 0.42), (0.07, 0.13, 0.34), (0.5, 0.05, 0.04), (0.08, 0.3, 0.1)
PADDING = 0.006
"""Metres that a suit is thicker than the body."""
_BOX = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))


def write_glb(path: Path, parts: list[Part]) -> Path:
    """Write parts, Z up and front -Y, as one mesh with a colour each."""
    data, views, accessors, primitives, materials = b"", [], [], [], []
    for points, triangles, color in parts:
        turned = (points[:, [0, 2, 1]] * (1, 1, -1)).astype("<f4")
        for values, kind, component in ((turned, "VEC3", 5126), (triangles.astype("<u4").ravel(), "SCALAR", 5125)):
            views.append({"buffer": 0, "byteOffset": len(data), "byteLength": values.nbytes})
            accessor = {"bufferView": len(views) - 1, "componentType": component, "count": len(values), "type": kind}
            bounds = {"min": values.min(0).tolist(), "max": values.max(0).tolist()} if kind == "VEC3" else {}
            accessors.append(accessor | bounds)
            data += values.tobytes()
        count = len(accessors)
        primitives.append({"attributes": {"POSITION": count - 2}, "indices": count - 1, "material": len(materials)})
        materials.append({"pbrMetallicRoughness": {"baseColorFactor": [*color, 1], "metallicFactor": 0}})
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": primitives}], "materials": materials, "accessors": accessors,
        "bufferViews": views, "buffers": [{"byteLength": len(data)}],
    }  # fmt: skip
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    head = struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(data))
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data
    path.write_bytes(head + chunks)
    return path


def figure(raised: float = 0.0, sizes: dict[str, float] | None = None, **look: object) -> tuple[Part, Points]:
    """Return somebody in a suit, remeshed, and their joints (B, 3).

    Args:
        raised: Degrees by which the arms are above the A-pose: 45 a T, -35 hanging.
        sizes: Logarithms of the proportions of ``stance.SIZES``.
        look: Fields of ``CharacterLook``.
    """
    pack = load_body_pack()
    assert pack is not None, "the body data is there"
    whole = pack.shape(recipe(CharacterLook.model_validate(look), 4))
    joints = {name: pack.joint(whole, name) for bone in SKELETON for name in (bone.head, bone.tail)}
    body = replace(
        template_of(pack),
        heads=np.array([joints[bone.head] for bone in SKELETON]),
        tails=np.array([joints[bone.tail] for bone in SKELETON]),
    )
    values = np.zeros(COUNT)
    for name, size in (sizes or {}).items():
        values[SIZE_OF[name]] = size
    for side, sign in (("L", 1), ("R", -1)):
        values[TURN_OF[f"upper_arm.{side}"]] = (0, -np.radians(raised) * sign, 0)
    stance = stance_of(body, values[None])
    skin = PARTS["skin"]
    points = stance.points(whole[skin], pack.weights[skin])[0]
    sole = points[:, 2].min()
    faces = pack.faces[pack.faces[:, 0] < skin.stop]
    quads = np.concatenate([faces[:, [0, 1, 2]], faces[:, [0, 2, 3]]])
    suit = (*remeshed(points - (0, 0, sole), quads, 0.009, 0.35), SUIT)
    return suit, stance.heads[0] - (0, 0, sole)


def remeshed(points: Points, triangles: Triangles, voxel: float, ratio: float) -> tuple[Points, Triangles]:
    """Return a surface with other vertices: padded, remeshed at ``voxel`` metres, decimated to a share of its faces."""
    mesh = bpy.data.meshes.new("figure")
    mesh.from_pydata(points.tolist(), [], triangles.tolist())
    thing = bpy.data.objects.new("figure", mesh)
    bpy.context.scene.collection.objects.link(thing)
    pad = thing.modifiers.new("pad", "DISPLACE")
    pad.strength, pad.mid_level = PADDING, 0.0
    remesh = thing.modifiers.new("remesh", "REMESH")
    remesh.mode, remesh.voxel_size = "VOXEL", voxel
    thing.modifiers.new("decimate", "DECIMATE").ratio = ratio
    made = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    made.calc_loop_triangles()
    result = (
        np.array([vertex.co for vertex in made.vertices]),
        np.array([each.vertices for each in made.loop_triangles]),
    )
    bpy.data.objects.remove(thing)
    return result[0] - (0, 0, result[0][:, 2].min()), result[1].astype(np.int64)


def box(low: tuple[float, float, float], high: tuple[float, float, float], color: Color = STEEL) -> Part:
    """Return a box between two corners."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    triangles = np.array([each for a, b, c, d in _BOX for each in ((a, b, c), (a, c, d))])
    return corners * (np.array(high) - low) + low, triangles, color


def tube(rings: list[tuple[float, float]], color: Color, middle: tuple[float, float] = (0, 0), rows: int = 6) -> Part:
    """Return an open tube about a vertical axis through rings of (height, radius), a little flattened."""
    heights, radii = (np.interp(np.linspace(0, len(rings) - 1, rows * (len(rings) - 1) + 1), range(len(rings)), column)
                      for column in zip(*rings, strict=True))  # fmt: skip
    turns = 2 * np.pi * np.arange(32) / 32
    points = [(middle[0] + r * np.cos(a), middle[1] + 0.8 * r * np.sin(a), z)
              for z, r in zip(heights, radii, strict=True) for a in turns]  # fmt: skip
    quads = [(i * 32 + j, i * 32 + (j + 1) % 32) for i in range(len(heights) - 1) for j in range(32)]
    down = rings[0][0] > rings[-1][0]
    faces = [each for a, b in quads for each in ((a, a + 32, b), (b, a + 32, b + 32))]
    return np.array(points), np.array(faces)[:, :: (1 if down else -1)], color


def _skirt_and_hat() -> list[Part]:
    (suit, joints) = figure(10, gender="female", age=25.0)
    hips, crown = joints[BONE_INDEX["hips"]], suit[0][:, 2].max()
    skirt = tube([(hips[2] + 0.10, 0.155), (hips[2] - 0.02, 0.215), (0.14, 0.36)], RED, (0, hips[1]), 9)
    y = float(joints[BONE_INDEX["head"]][1]) + 0.01
    hat = tube(
        [(crown + 0.11, 0.01), (crown + 0.10, 0.10), (crown - 0.07, 0.12), (crown - 0.075, 0.27)], GREEN, (0, y), 3
    )
    return [suit, skirt, hat]


def _with_sword() -> list[Part]:
    """Return a heavy man with a sword in his right hand, who faces +Y."""
    suit, joints = figure(30, gender="male", age=50.0, build="heavy")
    points, triangles, color = box((-0.015, -0.025, -0.15), (0.015, 0.025, 0.85))
    sword = (points + joints[BONE_INDEX["fingers1.R"]], triangles, color)
    return [(points * (-1, -1, 1), triangles, color) for points, triangles, color in (suit, sword)]


def _robot() -> list[Part]:
    parts = [
        box((-0.2, -0.12, 0.95), (0.2, 0.12, 1.45)), box((-0.13, -0.13, 1.52), (0.13, 0.13, 1.82), RED),
        box((-0.05, -0.05, 1.45), (0.05, 0.05, 1.52)), box((-0.18, -0.11, 0.82), (0.18, 0.11, 0.95)),
    ]  # fmt: skip
    limbs = (
        ((0.21, 0.33), (-0.07, 0.07), (1.12, 1.42)), ((0.22, 0.32), (-0.06, 0.06), (0.84, 1.11)),
        ((0.22, 0.32), (-0.07, 0.05), (0.68, 0.83)), ((0.03, 0.17), (-0.09, 0.09), (0.46, 0.82)),
        ((0.04, 0.16), (-0.08, 0.08), (0.10, 0.45)), ((0.03, 0.17), (-0.22, 0.08), (0.0, 0.10)),
    )  # fmt: skip
    for side in (1, -1):
        for (near, far), (front, back), (low, high) in limbs:
            left, right = sorted((side * near, side * far))
            parts.append(box((left, front, low), (right, back, high)))
    return parts


HUMANOIDS: dict[str, Callable[[], list[Part]]] = {
    "man_t": lambda: [figure(45, gender="male", age=40.0)[0]],
    "arms_down": lambda: [figure(-33, gender="male", age=30.0)[0]],
    "skirt_and_hat": _skirt_and_hat,
    "robot": _robot,
    "child": lambda: [figure(20, gender="male", age=6.0)[0]],
    "cartoon": lambda: [
        figure(45, {"head": 0.9, "thigh": -0.3, "shin": -0.35, "hand": 0.2, "foot": 0.3}, gender="female", age=25.0)[0]
    ],
    "swordsman": _with_sword,
}
"""What makes each figure."""
OTHERS = (
    "chair",
    "car",
    "horse",
    "floor_lamp",
    "sofa",
    "tree",
    "ladder",
    "guitar",
    "dog",
    "dead_tree",
    "christmas_tree",
)
"""Props of the library that are no human figures."""


def write_humanoid(name: str, folder: Path) -> Path:
    """Write one of ``HUMANOIDS``."""
    return write_glb(folder / f"{name}.glb", HUMANOIDS[name]())


def write_prop(key: str, folder: Path) -> Path:
    """Write a prop of the library."""
    mesh = build_prop(key).mesh
    mesh.calc_loop_triangles()
    points = np.array([vertex.co for vertex in mesh.vertices])
    return write_glb(
        folder / f"{key}.glb", [(points, np.array([each.vertices for each in mesh.loop_triangles]), STEEL)]
    )
