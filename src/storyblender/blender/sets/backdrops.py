"""What stands far away, so that no frame shows a void: silhouettes in layers, lit by the scene, hazed by its fog.

The sky itself stays free behind them. A ring's cards join because every outline is a function of the azimuth.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.materials import material
from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import pane, view_outside
from storyblender.catalog.light_recipes import mix
from storyblender.catalog.materials import hex_color
from storyblender.catalog.set_plan import Backdrop
from storyblender.memory.base import Color

Floats = NDArray[np.float64]


Skin = Callable[[str, str], bpy.types.Material]
"""Gives the material of a catalog key in a hex colour."""


_HAZE: Color = (0.62, 0.72, 0.82)
"""What is bright outside a room that is exposed for its inside turns to this."""
_HOUSES = ("#6d4a3a", "#a7a08f", "#cbbfa4", "#7a4636", "#8c8272")
_TOWERS = ("#7c7f82", "#96938c", "#6a6460", "#8b7d70")
_WOODS = ("#6f8074", "#586c54", "#42563a")
_HILLS = ("#93a2ac", "#7f9092", "#6c806f")


def backdrop_mesh(card: Backdrop, scene: bpy.types.Scene, *, indoor: bool) -> bpy.types.Mesh:
    """Build a backdrop in world coordinates, two to three layers deep.

    Args:
        card: Of the plan; its corners are lower left, lower right, upper right, upper left as seen from the set.
        scene: Whose daylight the windows of towns follow.
        indoor: It is seen through windows, so it shines by day.
    """

    def skin(key: str, code: str) -> bpy.types.Material:
        color = hex_color(code)
        return view_outside(f"{key}_{code[1:]}", mix(color, _HAZE, 0.35), scene) if indoor else material(key, color)

    builder = MeshBuilder(card.node_id)
    left, right = np.array(card.corners[0]), np.array(card.corners[1])
    height = card.corners[2][2] - card.corners[1][2]
    if card.kind in ("skyline", "facades"):
        _Town(builder, scene, skin, card.kind == "facades", indoor).raise_between(left, right, height)
    elif card.kind in ("treeline", "hills"):
        _land(builder, skin, left, right, (card.corners[3][2] - card.corners[0][2], height), card.kind == "treeline")
    elif card.kind == "sea":
        _sheet(builder, skin("clay", "#86a0ab"), np.stack([left, right]), np.full(2, height))
    elif card.kind == "deep":
        _sheet(builder, skin("clay", "#1c5468"), np.stack([left, right]), np.full(2, height))
    else:
        key = "card_stars" if card.kind == "stars" else "card_plain"
        builder.quad(key, *card.corners, uv=[(0, 0), (1, 0), (1, 1), (0, 1)])
    return builder.mesh()


def _sheet(builder: MeshBuilder, skin: bpy.types.Material, foot: Floats, tops: Floats) -> None:
    """Raise a curtain on the points of its foot with the given heights, its face towards the set."""
    head = foot + np.c_[np.zeros((len(tops), 2)), np.maximum(tops, 0.3)]
    builder.loft(skin, [foot, head], closed=False)


def _land(
    builder: MeshBuilder, skin_of: Skin, left: Floats, right: Floats, heights: tuple[float, float], trees: bool
) -> None:
    """Raise woods or hills between two points; ``heights`` are those of the left and the right end."""
    span = float(np.linalg.norm(right - left))
    share = np.linspace(0, 1, max(12, int(span / (0.7 if trees else 1.5))))
    tall, high = heights[0] + share * (heights[1] - heights[0]), max(heights) > 20
    foot = left + share[:, None] * (right - left)
    angle = np.arctan2(foot[:, 1], foot[:, 0])
    outwards = np.c_[
        foot[:, :2] / np.maximum(np.linalg.norm(foot[:, :2], axis=1, keepdims=True), 1e-6), np.zeros(len(foot))
    ]
    for layer, (part, code) in enumerate(zip((1.0, 0.8, 0.6), _WOODS if trees else _HILLS, strict=True)):
        phase = 2.3 * layer
        outline = _crowns(angle, phase) if trees else _peaks(angle, phase) if high else _swells(angle, phase)
        _sheet(builder, skin_of("clay", code), foot + outwards * (4.0 - 2.0 * layer), tall * part * outline)


def _swells(angle: Floats, phase: float) -> Floats:
    """Return heights of gentle hills, as shares of the full height, at azimuths in radians."""
    return 0.62 + 0.19 * (
        np.sin(5 * angle + phase) + 0.6 * np.sin(11 * angle + 2 * phase) + 0.35 * np.sin(23 * angle - phase)
    )


def _peaks(angle: Floats, phase: float) -> Floats:
    """Return heights of jagged mountains, as shares of the full height, at azimuths in radians."""
    outline = np.full_like(angle, 0.25)
    for weight, count, shift in ((0.38, 4, 1), (0.21, 9, 2), (0.1, 21, -1), (0.06, 47, 3)):
        outline += weight * (1 - np.abs(np.sin(count * angle + shift * phase)))
    return outline


def _crowns(angle: Floats, phase: float) -> Floats:
    """Return heights of treetops, as shares of the full height, at azimuths in radians."""
    crowns = np.maximum(np.abs(np.sin(47 * angle + phase)), 0.86 * np.abs(np.sin(71 * angle + 3 * phase)))
    return 0.66 + 0.08 * np.sin(5 * angle + phase) + 0.05 * np.sin(13 * angle) + 0.2 * np.sqrt(crowns)


@dataclass(frozen=True)
class _Town:
    """Rows of houses or towers along a card, with windows; some of them are lit at night."""

    builder: MeshBuilder
    scene: bpy.types.Scene
    skin_of: Skin
    near: bool
    indoor: bool

    def raise_between(self, left: Floats, right: Floats, height: float) -> None:
        """Build the rows from the farthest and highest to the nearest.

        Args:
            left: Foot of the left end, as seen from the set.
            right: Foot of the right end.
            height: Of the highest roof, metres.
        """
        span = float(np.linalg.norm((right - left)[:2]))
        along = (right - left) / max(span, 1e-6)
        outwards = np.array([-along[1], along[0], 0.0])
        yaw = math.degrees(math.atan2(along[1], along[0]))
        rng = np.random.default_rng(int(abs(left[0] * 13.7 + left[1] * 7.3 + height * 3.1)) % 997)
        widths, shares = ((6.0, 10.0), (0.72, 1.0)) if self.near else ((4.0, 9.0), (0.5, 1.0))
        walls = _HOUSES if self.near else _TOWERS
        for row, part in enumerate((1.0,) if self.near else (1.0, 0.7, 0.45)):
            at, depth = 0.0, 7.0 - 3.0 * row
            while at < span:
                width, tall = float(rng.uniform(*widths)), height * part * float(rng.uniform(*shares))
                code = walls[int(rng.integers(len(walls)))]
                with self.builder.at(left + along * (at + width / 2) + outwards * depth, (0, 0, yaw)):
                    self.builder.box(self.skin_of("clay", code), (0, 0, tall / 2), (width, 4.0, tall))
                    if self.near or row == 2 or span < 60:
                        self._windows(width, tall, rng)
                at += width + (0.0 if self.near else float(rng.uniform(-0.5, 1.5)))

    def _windows(self, width: float, tall: float, rng: np.random.Generator) -> None:
        """Add the windows of one house; some are lit at night."""
        storey, bay, wide, high = (3.1, 2.2, 0.95, 1.5) if self.near else (2.6, 1.6, 0.7, 1.1)
        columns, dark = max(1, int(width / bay)), self.skin_of("glass_dark", "#39424b")
        for floor in range(int((tall - 1.5) / storey)):
            for column in range(columns):
                x, z = (column + 0.5) * width / columns - width / 2, 1.2 + storey * floor
                lit = rng.random() < 0.24
                key = ("pane_far", "pane_amber")[int(rng.integers(2))]
                glass = pane(key, self.scene, from_room=self.indoor) if lit else dark
                x0, x1, y = x - wide / 2, x + wide / 2, -2.02
                self.builder.quad(glass, (x0, y, z), (x1, y, z), (x1, y, z + high), (x0, y, z + high))
