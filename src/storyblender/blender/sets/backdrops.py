"""What stands far away, so that no frame shows a void: silhouettes in layers, lit by the scene, hazed by its fog.

The sky itself stays free behind them. A ring's cards join because every outline is a function of the azimuth.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.materials import material
from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, pane, view_outside
from storyblender.catalog.materials import hex_color
from storyblender.catalog.set_plan import Backdrop

Floats = NDArray[np.float64]


Skin = Callable[[str, str], bpy.types.Material]
"""Gives the material of a catalog key in a hex colour."""


_HOUSES = (("brick", "#6d4a3a"), ("plaster", "#a7a08f"), ("plaster", "#cbbfa4"), ("brick", "#7a3b28"))
_TOWERS = (("plaster", "#7c7f82"), ("plaster", "#96938c"), ("plaster", "#6a6460"), ("plaster", "#8b7d70"))


def backdrop_mesh(card: Backdrop, scene: bpy.types.Scene, *, indoor: bool) -> bpy.types.Mesh:
    """Build a backdrop in world coordinates, two to three layers deep.

    Args:
        card: Of the plan; its corners are lower left, lower right, upper right, upper left as seen from the set.
        scene: Whose daylight the windows of towns follow.
        indoor: It is seen through windows, so it shines by day.
    """

    def skin(key: str, code: str) -> bpy.types.Material:
        return view_outside(f"{key}_{code[1:]}", hex_color(code), scene) if indoor else material(key, hex_color(code))

    builder = MeshBuilder(card.node_id)
    left, right = np.array(card.corners[0]), np.array(card.corners[1])
    height = card.corners[2][2] - card.corners[1][2]
    if card.kind in ("skyline", "facades"):
        _town(builder, scene, skin, left, right, height, near=card.kind == "facades")
    elif card.kind in ("treeline", "hills"):
        _land(builder, skin, left, right, height, trees=card.kind == "treeline")
    elif card.kind == "sea":
        _sheet(builder, skin("water", "#3a5c68"), left, right, np.full(2, height))
    else:
        key = "card_stars" if card.kind == "stars" else "card_plain"
        builder.quad(key, *card.corners, uv=[(0, 0), (1, 0), (1, 1), (0, 1)])
    return builder.mesh()


def _sheet(builder: MeshBuilder, skin: bpy.types.Material, left: Floats, right: Floats, tops: Floats) -> None:
    """Raise a curtain from left to right with the given heights, its face towards the set."""
    foot = left + np.linspace(0, 1, len(tops))[:, None] * (right - left)
    head = foot + np.c_[np.zeros((len(tops), 2)), tops]
    builder.loft(skin, [foot, head], closed=False)


def _azimuths(left: Floats, right: Floats, count: int) -> Floats:
    points = left[:2] + np.linspace(0, 1, count)[:, None] * (right - left)[:2]
    return np.arctan2(points[:, 1], points[:, 0])


def _land(builder: MeshBuilder, skin_of: Skin, left: Floats, right: Floats, height: float, *, trees: bool) -> None:
    span = float(np.linalg.norm(right - left))
    away = (left + right)[:2] / 2
    outwards = away / max(float(np.linalg.norm(away)), 1e-6)
    colors = ("#6f8074", "#5a6e58", "#465a3e") if trees else ("#8fa0ac", "#7d9093", "#6d8272")
    for layer, (share, color) in enumerate(zip((1.0, 0.78, 0.55), colors, strict=True)):
        offset = np.array([*(outwards * (4.0 - 2.0 * layer)), 0.0])
        angle = _azimuths(left, right, max(12, int(span / (0.9 if trees else 2.0))))
        phase = 2.3 * layer
        swell = np.sin(5 * angle + phase) + 0.6 * np.sin(11 * angle + 2 * phase) + 0.35 * np.sin(23 * angle - phase)
        if trees:
            ragged = 0.5 * np.abs(np.sin(61 * angle + phase)) + 0.5 * np.abs(np.sin(143 * angle + 3 * phase))
            tops = height * share * (0.78 + 0.07 * swell + 0.2 * ragged)
            skin = skin_of("leaves_dark", color)
        else:
            tops = height * share * (0.62 + 0.19 * swell)
            skin = skin_of("dirt", color)
        _sheet(builder, skin, left + offset, right + offset, np.maximum(tops, 0.3))


def _town(
    builder: MeshBuilder,
    scene: bpy.types.Scene,
    skin_of: Skin,
    left: Floats,
    right: Floats,
    height: float,
    *,
    near: bool,
) -> None:
    """Raise rows of houses or towers along a card, with windows, some of them lit at night."""
    span = float(np.linalg.norm((right - left)[:2]))
    along = (right - left) / max(span, 1e-6)
    outwards = np.array([-along[1], along[0], 0.0])
    yaw = math.degrees(math.atan2(along[1], along[0]))
    seed = int(abs(left[0] * 13.7 + left[1] * 7.3 + height * 3.1)) % 997
    rng = np.random.default_rng(seed)
    walls = _HOUSES if near else _TOWERS
    for row, share in enumerate((1.0,) if near else (1.0, 0.7, 0.45)):
        at, depth = 0.0, 7.0 - 3.0 * row
        while at < span:
            width = float(rng.uniform(6.0, 10.0) if near else rng.uniform(4.0, 9.0))
            tall = height * share * float(rng.uniform(0.72, 1.0) if near else rng.uniform(0.5, 1.0))
            foot = left + along * (at + width / 2) + outwards * depth
            with builder.at(foot, (0, 0, yaw)):
                key, code = walls[int(rng.integers(len(walls)))]
                builder.box(skin_of(key, code), (0, 0, tall / 2), (width, 4.0, tall))
                if near or row == 2 or span < 60:
                    _windows(builder, scene, width, tall, rng, near=near)
            at += width + (0.0 if near else float(rng.uniform(-0.5, 1.5)))


def _windows(
    builder: MeshBuilder, scene: bpy.types.Scene, width: float, tall: float, rng: np.random.Generator, *, near: bool
) -> None:
    storey, bay, wide, high = (3.1, 2.2, 0.95, 1.5) if near else (2.6, 1.6, 0.7, 1.1)
    columns = max(1, int(width / bay))
    for floor in range(int((tall - 1.5) / storey)):
        for column in range(columns):
            x = (column + 0.5) * width / columns - width / 2
            z = 1.2 + storey * floor
            lit = rng.random() < 0.24
            glass = pane(("pane_far", "pane_amber")[int(rng.integers(2))], scene) if lit else finish("glass_dark")
            y = -2.02
            builder.quad(
                glass,
                (x - wide / 2, y, z),
                (x + wide / 2, y, z),
                (x + wide / 2, y, z + high),
                (x - wide / 2, y, z + high),
            )
