"""Hats and caps: turned profiles on the head bone."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.people.cloth import Bolt
from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.figure import Figure
from storyblender.blender.people.sheet import Sheet, rigid
from storyblender.blender.people.under import Under
from storyblender.catalog.cuts import Hat

Floats = NDArray[np.float64]
Profile = tuple[tuple[float, float], ...]
"""Height above the brim line in metres and radius as a share of the head's, from the bottom up."""

SEGMENTS = 28
CROWNS: dict[str, Profile] = {
    "fedora": ((0.028, 1.02), (0.06, 1.0), (0.095, 0.94), (0.112, 0.84), (0.110, 0.60), (0.098, 0.30), (0.092, 0.0)),
    "straw": ((0.028, 1.02), (0.06, 1.01), (0.082, 0.99), (0.088, 0.93), (0.088, 0.5), (0.088, 0.0)),
    "peaked": ((0.036, 1.03), (0.060, 1.20), (0.078, 1.29), (0.090, 1.22), (0.099, 0.70), (0.100, 0.0)),
    "flat": ((0.012, 1.03), (0.035, 1.15), (0.060, 1.10), (0.082, 0.80), (0.092, 0.40), (0.094, 0.0)),
    "beanie": ((0.030, 1.03), (0.055, 1.03), (0.085, 0.92), (0.108, 0.65), (0.118, 0.30), (0.121, 0.0)),
}
BANDS: dict[str, Profile] = {
    "fedora": ((0.0, 1.01), (0.002, 1.025), (0.028, 1.025)),
    "straw": ((0.0, 1.01), (0.002, 1.03), (0.028, 1.03)),
    "peaked": ((0.0, 1.0), (0.034, 1.0), (0.036, 1.03)),
    "flat": ((0.0, 1.0), (0.012, 1.03)),
    "beanie": ((-0.012, 1.02), (-0.010, 1.06), (0.026, 1.07), (0.030, 1.03)),
}
BRIMS: dict[str, float] = {"fedora": 0.062, "straw": 0.075}
"""Width of the brim, metres."""
VISORS: dict[str, float] = {"peaked": 0.058, "flat": 0.045}


def build_hat(cut: Hat, figure: Figure, under: Under) -> list[Bolt]:
    """Turn a hat that fits the head: crown, band, and a brim or a visor."""
    del under
    head = _Head(figure)
    bolts = [
        Bolt(head.turn(CROWNS[cut.shape], dented=cut.shape == "fedora"), cut.tint, cut.fabric),
        Bolt(head.turn(BANDS[cut.shape]), cut.band, cut.fabric),
    ]
    if cut.shape in BRIMS:
        bolts.append(Bolt(head.brim(BRIMS[cut.shape]), cut.tint, cut.fabric))
    if cut.shape in VISORS:
        bolts.append(Bolt(head.visor(VISORS[cut.shape]), cut.visor, "leather"))
    return bolts


class _Head:
    """The ellipse around the skull above the ears, tilted a little back."""

    def __init__(self, figure: Figure) -> None:
        skin = figure.part("skin")
        above = skin.points[(skin.base[:, 1] > 7.75) & (np.abs(skin.base[:, 0]) < 1.2)]
        low, high = above.min(0), above.max(0)
        self.scale = figure.head_scale
        self.rx = (high[0] - low[0]) / 2 + 0.013 * self.scale
        self.ry = (high[1] - low[1]) / 2 + 0.013 * self.scale
        self.center: Floats = np.array((0.0, (low[1] + high[1]) / 2, high[2] - 0.082 * self.scale), float)

    def _place(self, turn: float, radius: float, height: float) -> Floats:
        """Return a point at an angle (0 = left, -90 degrees = front)."""
        x, y = self.rx * radius * math.cos(turn), self.ry * radius * math.sin(turn)
        offset: Floats = np.array((x, y, height * self.scale - 0.16 * y), float)
        return self.center + offset

    def turn(self, profile: Profile, dented: bool = False) -> Sheet:
        """Return a turned surface; ``dented`` presses a crease into the top."""
        points, faces = [], []
        for height, radius in profile:
            for step in range(SEGMENTS):
                angle = 2 * math.pi * step / SEGMENTS
                point = self._place(angle, radius, height)
                if dented and radius < 0.9:
                    point[2] -= 0.012 * self.scale * math.exp(-((radius * math.cos(angle) / 0.3) ** 2))
                points.append(point)
        for row in range(len(profile) - 1):
            for step in range(SEGMENTS):
                a, b = row * SEGMENTS + step, row * SEGMENTS + (step + 1) % SEGMENTS
                faces.append((a, b, b + SEGMENTS, a + SEGMENTS))
        return rigid(np.array(points), faces, bone_weights("head"))

    def brim(self, width: float) -> Sheet:
        """Return a brim that rises at the sides, both faces."""
        points, faces = [], []
        rings = ((0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, -0.003), (0.5, -0.003), (0.0, -0.003))
        for out, drop in rings:
            for step in range(SEGMENTS):
                angle = 2 * math.pi * step / SEGMENTS
                rise = 0.020 * math.cos(angle) ** 2 - 0.012 * max(0.0, -math.sin(angle))
                radius = 1.0 + out * width * self.scale / self.rx
                points.append(self._place(angle, radius, 0.002 + out**1.5 * rise + drop))
        for row in range(len(rings) - 1):
            for step in range(SEGMENTS):
                a, b = row * SEGMENTS + step, row * SEGMENTS + (step + 1) % SEGMENTS
                faces.append((a, a + SEGMENTS, b + SEGMENTS, b))
        return rigid(np.array(points), faces, bone_weights("head"))

    def visor(self, width: float) -> Sheet:
        """Return a crescent in front."""
        points, faces = [], []
        columns, rows = 15, 4
        for row in range(rows):
            share = row / (rows - 1)
            for column in range(columns):
                swing = (column / (columns - 1) - 0.5) * 2.3
                reach = math.cos(swing * math.pi / 2.3) ** 0.6 * share if abs(swing) < 1.15 else 0.0
                point = self._place(-math.pi / 2 + swing, 1.01 + 0.05 * reach, 0.004 - 0.020 * reach)
                points.append(point + np.array((0.0, -width * reach * self.scale, 0.0)))
        for row in range(rows - 1):
            for column in range(columns - 1):
                a = row * columns + column
                faces.append((a, a + columns, a + columns + 1, a + 1))
        return rigid(np.array(points), faces, bone_weights("head"))
