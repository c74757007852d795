"""How a rig is shown: collections of bones, shapes and colours of the controls."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import bpy

from storyblender.blender.people.control_rig import CONTROLS, LIMBS, LOOK_AT, ROOT, TORSO, scale_of

WIDGETS: Final = "WIDGETS"
"""Collection with the shapes of the controls."""
_FINGERS: Final = ("thumb", "index1", "index2", "fingers1", "fingers2")
_FACE: Final = ("eye", "jaw")
_THEMES: Final = {"": "THEME09", "L": "THEME04", "R": "THEME01"}
"""Yellow in the middle, blue on the left, red on the right, as riggers have it."""
_Line = list[tuple[float, float, float]]


def show_controls(rigs: Sequence[bpy.types.Object]) -> None:
    """Give the controls of rigs shapes and colours, and sort all bones into collections of which they alone are shown.

    Args:
        rigs: Armature objects with controls.
    """
    for rig in rigs:
        rig.show_in_front = True
        scale = scale_of(rig.data)
        for name in CONTROLS:
            if name in rig.pose.bones:
                bone = rig.pose.bones[name]
                kind, size = _SHAPES[name]
                bone.custom_shape, bone.use_custom_shape_bone_size = _shape(kind), False
                bone.custom_shape_scale_xyz = (size * scale,) * 3
                bone.custom_shape_wire_width = 2.0
        _sort(rig.data)


def _sort(rig: bpy.types.Armature) -> None:
    """Sort the bones of a rig into collections, and colour them by side."""
    groups = {name: rig.collections.new(name) for name in ("Controls", "Limbs", "Fingers", "Deform")}
    for bone in rig.bones:
        stem, _, side = bone.name.partition(".")
        bone.color.palette = _THEMES[side]
        if bone.name in CONTROLS:
            groups["Controls"].assign(bone)
            continue
        groups["Deform"].assign(bone)
        if stem not in _FACE:
            groups["Fingers" if stem in _FINGERS else "Limbs"].assign(bone)
    for name, group in groups.items():
        group.is_visible = name == "Controls"


def _shape(kind: str) -> bpy.types.Object:
    """Return the object that a control is drawn as; it is in no scene, so nothing renders or exports it."""
    name = f"WGT_{kind}"
    if name not in bpy.data.objects:
        lines = _LINES[kind]
        points = [point for line in lines for point in line]
        edges, first = list[tuple[int, int]](), 0
        for line in lines:
            edges += [(first + index, first + index + 1) for index in range(len(line) - 1)]
            first += len(line)
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(points, edges, [])
        collection = bpy.data.collections.get(WIDGETS) or bpy.data.collections.new(WIDGETS)
        collection.use_fake_user = collection.hide_render = collection.hide_viewport = True
        collection.objects.link(bpy.data.objects.new(name, mesh))
    return bpy.data.objects[name]


def _circle(axis: int) -> _Line:
    """Return a circle of radius 1 about an axis."""
    turns = (math.tau * step / 24 for step in range(25))
    flat = [(math.cos(turn), math.sin(turn)) for turn in turns]
    return [(0.0, a, b) if axis == 0 else (a, 0.0, b) if axis == 1 else (a, b, 0.0) for a, b in flat]


def _box() -> list[_Line]:
    """Return the edges of a box of size 2."""
    ring = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)]
    flat = [[(x, y, z) for x, y in ring] for z in (-1.0, 1.0)]
    return [*flat, *([(x, y, -1.0), (x, y, 1.0)] for x, y in ring[:4])]


_LINES: Final[dict[str, list[_Line]]] = {
    "box": _box(),
    "ball": [_circle(axis) for axis in range(3)],
    "ring": [_circle(2)],
    "belt": [_circle(1)],
}
_SHAPES: Final[dict[str, tuple[str, float]]] = {
    ROOT: ("ring", 0.45),
    TORSO: ("belt", 0.28),
    LOOK_AT: ("ball", 0.07),
    **{limb.control: ("box", 0.075) for limb in LIMBS},
    **{limb.pole: ("ball", 0.035) for limb in LIMBS},
}
"""Shape of each control, and half its size in metres, of a grown person."""
