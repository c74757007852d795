"""Walls of a plan: faces with holes, reveals, skirting, dado, and the joinery of their doors and windows."""

from __future__ import annotations

import math
from itertools import pairwise

import bpy

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.joinery import door_leaf, dress_opening
from storyblender.blender.sets.textured import skin_of
from storyblender.catalog.openings import PAIR
from storyblender.catalog.set_plan import Opening, Wall

VESTIBULE = 1.4
"""Metres of dim passage behind an inner door, so that an open one never shows a void."""

_TRIMS = (
    ("log_wall", "wood_dark"), ("stone", "stone_light"), ("brick", "paint_brown"), ("limewash", "wood_dark"),
    ("boards", "wood_dark"), ("concrete", "metal_grey"), ("metal", "metal_grey"), ("wood", "wood_dark"),
    ("plaster_teal", "paint_grey"),
)  # fmt: skip


def trim_of(wall: Wall) -> str:
    """Return the finish of casings and skirting that suits a wall."""
    if wall.dado in ("dado_dark", "dado_brown"):
        return "wood_dark" if wall.dado == "dado_dark" else "wood"
    return next((trim for stem, trim in _TRIMS if wall.material.startswith(stem)), "paint_cream")


def length_of(wall: Wall) -> float:
    """Return the length of a wall in metres."""
    return math.dist(wall.start, wall.end)


def wall_mesh(wall: Wall, *, indoor: bool) -> bpy.types.Mesh:
    """Build a wall in its own frame: from the start along +X, the room at +Y, its foot at z = 0.

    Args:
        wall: The wall of the plan.
        indoor: Give it skirting, and a passage behind doors of walls without windows.
    """
    builder = MeshBuilder(wall.node_id)
    length, trim = length_of(wall), finish(trim_of(wall))
    wall_shell(builder, wall)
    if indoor:
        _skirting(builder, wall, length, trim)
    inner = indoor and not any(opening.kind == "window" for opening in wall.openings)
    for opening in wall.openings:
        with builder.at((opening.x, 0.0, opening.sill)):
            dress_opening(builder, opening, wall.thickness, trim=trim, wall=skin_of(wall.material, wall.texture))
            if inner and opening.kind in ("door", "arch"):
                _vestibule(builder, opening, wall.thickness)
    return builder.mesh()


def wall_shell(builder: MeshBuilder, wall: Wall) -> None:
    """Add the bare wall with its holes: both faces, reveals, ends and top, in the wall's own frame.

    Args:
        builder: Receives the faces.
        wall: The wall of the plan.
    """
    _faces(builder, wall, length_of(wall))
    _reveals(builder, wall)


def leaf_meshes(wall: Wall) -> list[tuple[Opening, bpy.types.Mesh, float, float]]:
    """Return the leaves of a wall's doors: opening, mesh hinged at its origin, hinge x, swing in degrees when open."""
    leaves = []
    has_view = any(opening.kind == "window" for opening in wall.openings)
    for opening in wall.openings:
        if opening.kind != "door":
            continue
        pair = opening.style == "double" or opening.width > PAIR
        width = opening.width / (2 if pair else 1)
        mesh = door_leaf(opening, width, clear=has_view)
        leaves.append((opening, mesh, opening.x, 100.0))
        if pair:
            leaves.append(
                (opening, door_leaf(opening, width, clear=has_view, mirrored=True), opening.x + opening.width, -100.0)
            )
    return leaves


def _faces(builder: MeshBuilder, wall: Wall, length: float) -> None:
    """Add both faces around the openings, the top and the ends."""
    skin, depth = skin_of(wall.material, wall.texture), -wall.thickness
    dado = finish(wall.dado) if wall.dado else skin
    edge = min(wall.dado_height, wall.height) if wall.dado else 0.0
    xs = sorted({0.0, length, *(o.x for o in wall.openings), *(o.x + o.width for o in wall.openings)})
    zs = sorted({0.0, wall.height, edge, *(o.sill for o in wall.openings), *(o.sill + o.height for o in wall.openings)})
    for x0, x1 in pairwise(xs):
        for z0, z1 in pairwise(zs):
            middle_x, middle_z = (x0 + x1) / 2, (z0 + z1) / 2
            if any(_inside(opening, middle_x, middle_z) for opening in wall.openings):
                continue
            face = dado if middle_z < edge else skin
            builder.quad(face, (x1, 0, z0), (x0, 0, z0), (x0, 0, z1), (x1, 0, z1))
            builder.quad(skin, (x0, depth, z0), (x1, depth, z0), (x1, depth, z1), (x0, depth, z1))
    top = wall.height
    builder.quad(skin, (0, depth, top), (length, depth, top), (length, 0, top), (0, 0, top))
    builder.quad(skin, (0, 0, 0), (0, depth, 0), (0, depth, top), (0, 0, top))
    builder.quad(skin, (length, depth, 0), (length, 0, 0), (length, 0, top), (length, depth, top))


def _inside(opening: Opening, x: float, z: float) -> bool:
    """Return whether a point of the wall, ``x`` along it and ``z`` up, is in an opening."""
    return opening.x < x < opening.x + opening.width and opening.sill < z < opening.sill + opening.height


def _reveals(builder: MeshBuilder, wall: Wall) -> None:
    """Add the inner faces of the openings, through the thickness of the wall."""
    skin, back = skin_of(wall.material, wall.texture), -wall.thickness
    for opening in wall.openings:
        x0, x1, z0, z1 = opening.x, opening.x + opening.width, opening.sill, opening.sill + opening.height
        builder.quad(skin, (x0, back, z0), (x0, 0, z0), (x0, 0, z1), (x0, back, z1))
        builder.quad(skin, (x1, 0, z0), (x1, back, z0), (x1, back, z1), (x1, 0, z1))
        builder.quad(skin, (x0, back, z1), (x0, 0, z1), (x1, 0, z1), (x1, back, z1))
        if z0 > 0:
            builder.quad(skin, (x0, 0, z0), (x0, back, z0), (x1, back, z0), (x1, 0, z0))


def _skirting(builder: MeshBuilder, wall: Wall, length: float, trim: bpy.types.Material) -> None:
    """Add skirting boards and the dado's rail and panels between the openings."""
    gaps = sorted((o.x - 0.08, o.x + o.width + 0.08) for o in wall.openings if o.sill == 0)
    for start, end in _runs(length, gaps):
        builder.box(trim, ((start + end) / 2, 0.012, 0.06), (end - start, 0.024, 0.12))
    if wall.dado:
        over = [(o.x - 0.08, o.x + o.width + 0.08) for o in wall.openings if o.sill < wall.dado_height]
        for start, end in _runs(length, sorted(over)):
            builder.box(trim, ((start + end) / 2, 0.015, wall.dado_height), (end - start, 0.03, 0.05))
            if wall.dado.startswith("dado"):
                _panels(builder, trim, start, end, wall.dado_height)


def _panels(builder: MeshBuilder, trim: bpy.types.Material, start: float, end: float, height: float) -> None:
    """Divide wainscoting by upright stiles."""
    count = max(1, round((end - start) / 0.62))
    for index in range(count + 1):
        x = start + 0.03 + (end - start - 0.06) * index / count
        builder.box(trim, (x, 0.008, height / 2), (0.07, 0.016, height))


def _runs(length: float, gaps: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return the stretches of a wall between ``gaps``, which are sorted by their start."""
    runs, at = [], 0.0
    for start, end in gaps:
        if start - at > 0.02:
            runs.append((at, start))
        at = max(at, end)
    if length - at > 0.02:
        runs.append((at, length))
    return runs


def _vestibule(builder: MeshBuilder, opening: Opening, thickness: float) -> None:
    """Add a dim passage behind a door."""
    skin, floor = finish("plaster_soot"), finish("boards_dark")
    near, far, side, top = -thickness, -thickness - VESTIBULE, 0.35, opening.height + 0.25
    x0, x1 = -side, opening.width + side
    builder.quad(skin, (x1, far, 0), (x0, far, 0), (x0, far, top), (x1, far, top))
    builder.quad(skin, (x0, far, 0), (x0, near, 0), (x0, near, top), (x0, far, top))
    builder.quad(skin, (x1, near, 0), (x1, far, 0), (x1, far, top), (x1, near, top))
    builder.quad(skin, (x0, far, top), (x0, near, top), (x1, near, top), (x1, far, top))
    builder.quad(floor, (x0, far, 0), (x1, far, 0), (x1, near, 0), (x0, near, 0))
