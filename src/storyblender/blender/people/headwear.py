"""Hats and caps: turned profiles on the head bone."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.people.cloth import Bolt
from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.sheet import Sheet, rigid_sheet
from storyblender.blender.people.solids import bar, skinned
from storyblender.blender.people.worn_layers import WornLayers
from storyblender.catalog.cuts import Hat
from storyblender.geometry.solids import Floats, skin_faces

Profile = tuple[tuple[float, float], ...]
"""Height above the brim line in metres and radius as a share of the head's, from the bottom up."""

SEGMENTS = 28
CROWNS: dict[str, Profile] = {
    "fedora": ((0.028, 1.02), (0.06, 1.0), (0.095, 0.94), (0.112, 0.84), (0.110, 0.60), (0.098, 0.30), (0.092, 0.0)),
    "cowboy": ((0.028, 1.02), (0.07, 0.98), (0.11, 0.93), (0.13, 0.84), (0.126, 0.6), (0.11, 0.3), (0.106, 0.0)),
    "sombrero": ((0.028, 1.02), (0.07, 0.95), (0.12, 0.75), (0.145, 0.5), (0.15, 0.2), (0.15, 0.0)),
    "straw": ((0.028, 1.02), (0.06, 1.01), (0.082, 0.99), (0.088, 0.93), (0.088, 0.5), (0.088, 0.0)),
    "top": ((0.028, 1.02), (0.09, 1.0), (0.165, 1.04), (0.17, 1.02), (0.171, 0.5), (0.171, 0.0)),
    "bowler": ((0.028, 1.03), (0.062, 1.03), (0.092, 0.95), (0.112, 0.75), (0.121, 0.4), (0.123, 0.0)),
    "peaked": ((0.036, 1.03), (0.060, 1.20), (0.078, 1.29), (0.090, 1.22), (0.099, 0.70), (0.100, 0.0)),
    "flat": ((0.012, 1.03), (0.035, 1.15), (0.060, 1.10), (0.082, 0.80), (0.092, 0.40), (0.094, 0.0)),
    "beanie": ((0.030, 1.03), (0.055, 1.03), (0.085, 0.92), (0.108, 0.65), (0.118, 0.30), (0.121, 0.0)),
    "baseball": ((0.008, 1.03), (0.04, 1.03), (0.078, 0.94), (0.102, 0.68), (0.114, 0.32), (0.117, 0.0)),
    "hard": ((0.006, 1.08), (0.04, 1.1), (0.085, 1.0), (0.118, 0.75), (0.134, 0.4), (0.138, 0.0)),
    "helmet": ((-0.05, 1.12), (-0.01, 1.16), (0.045, 1.15), (0.095, 1.0), (0.125, 0.7), (0.139, 0.3), (0.142, 0.0)),
    "toque": ((0.03, 1.03), (0.07, 1.04), (0.09, 1.25), (0.14, 1.34), (0.18, 1.2), (0.192, 0.6), (0.188, 0.0)),
    "witch": ((0.028, 1.02), (0.09, 0.78), (0.17, 0.45), (0.24, 0.2), (0.29, 0.05), (0.292, 0.0)),
    "party": ((0.03, 1.0), (0.08, 0.82), (0.15, 0.5), (0.21, 0.22), (0.24, 0.08), (0.245, 0.0)),
    "turban": ((-0.012, 1.03), (0.005, 1.17), (0.045, 1.28), (0.085, 1.18), (0.112, 0.85), (0.122, 0.4), (0.12, 0.0)),
    "beret": ((0.012, 1.03), (0.03, 1.28), (0.05, 1.36), (0.068, 1.2), (0.078, 0.6), (0.08, 0.0)),
    "skullcap": ((0.052, 0.97), (0.072, 0.9), (0.095, 0.68), (0.108, 0.35), (0.112, 0.0)),
    "sailor": ((0.03, 1.03), (0.065, 1.06), (0.09, 1.06), (0.092, 0.9), (0.092, 0.4), (0.092, 0.0)),
    "mitre": ((0.03, 1.03), (0.09, 1.08), (0.15, 0.9), (0.2, 0.55), (0.235, 0.15), (0.238, 0.0)),
}
BANDS: dict[str, Profile] = {
    "peaked": ((0.0, 1.0), (0.034, 1.0), (0.036, 1.03)),
    "flat": ((0.0, 1.0), (0.012, 1.03)),
    "beanie": ((-0.012, 1.02), (-0.010, 1.06), (0.026, 1.07), (0.030, 1.03)),
    "turban": ((-0.016, 1.0), (-0.012, 1.03)),
    "baseball": ((0.0, 1.0), (0.008, 1.03)),
    "hard": ((-0.002, 1.1), (0.004, 1.12), (0.012, 1.12)),
    "helmet": ((-0.056, 1.1), (-0.05, 1.17), (-0.036, 1.17)),
    "beret": ((0.0, 1.01), (0.002, 1.035), (0.014, 1.035)),
    "skullcap": ((0.048, 0.97), (0.052, 0.985)),
}
_BAND: Profile = ((0.0, 1.01), (0.002, 1.028), (0.03, 1.028))
BRIMS: dict[str, tuple[float, float]] = {
    "fedora": (0.062, 0.020), "straw": (0.075, 0.020), "cowboy": (0.095, 0.062), "sombrero": (0.19, 0.045),
    "top": (0.048, 0.016), "bowler": (0.042, 0.02), "witch": (0.1, 0.0),
}  # fmt: skip
"""Width of the brim and its rise at the sides, metres."""
VISORS: dict[str, float] = {"peaked": 0.058, "flat": 0.045, "baseball": 0.075, "hard": 0.045}


def build_hat(cut: Hat, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a hat that fits the head: crown, band, and a brim or a visor."""
    head = _HatForm(figure)
    if cut.shape == "crown":
        return [Bolt(head.crown(), cut.tint, cut.fabric)]
    if cut.shape == "globe":
        return head.globe(cut)
    crown = head.turn(CROWNS[cut.shape], dented=cut.shape in ("fedora", "cowboy"))
    bolts = [Bolt(crown, cut.tint, cut.fabric), Bolt(head.turn(BANDS.get(cut.shape, _BAND)), cut.band, cut.fabric)]
    if cut.shape in BRIMS:
        bolts.append(Bolt(head.brim(*BRIMS[cut.shape]), cut.tint, cut.fabric))
    if cut.shape in VISORS:
        stiff = "leather" if cut.shape in ("peaked", "flat") else cut.fabric
        bolts.append(Bolt(head.visor(VISORS[cut.shape]), cut.visor, stiff))
    return bolts


class _HatForm:
    """The tilted ellipse around the skull above the ears on which a hat is turned."""

    def __init__(self, figure: BodyFigure) -> None:
        skin = figure.part("skin")
        above = skin.points[(skin.base[:, 1] > 7.75) & (np.abs(skin.base[:, 0]) < 1.2)]
        low, high = above.min(0), above.max(0)
        self.scale = figure.head_scale
        self.rx = (high[0] - low[0]) / 2 + 0.013 * self.scale
        self.ry = (high[1] - low[1]) / 2 + 0.013 * self.scale
        self.center: Floats = np.array((0.0, (low[1] + high[1]) / 2, high[2] - 0.082 * self.scale), float)

    def _place(self, turn: float, radius: float, height: float) -> Floats:
        """Return a point in metres: angle in radians (0 left, -pi / 2 front), share of the radius, metres up."""
        x, y = self.rx * radius * math.cos(turn), self.ry * radius * math.sin(turn)
        offset: Floats = np.array((x, y, height * self.scale - 0.16 * y), float)
        return self.center + offset

    def turn(self, profile: Profile, dented: bool = False) -> Sheet:
        """Return the surface of a turned ``profile``; ``dented`` presses a crease into its top."""
        points = []
        for height, radius in profile:
            for step in range(SEGMENTS):
                angle = 2 * math.pi * step / SEGMENTS
                point = self._place(angle, radius, height)
                if dented and radius < 0.9:
                    point[2] -= 0.012 * self.scale * math.exp(-((radius * math.cos(angle) / 0.3) ** 2))
                points.append(point)
        return rigid_sheet(np.array(points), skin_faces(len(profile), SEGMENTS, True), bone_weights("head"))

    def crown(self) -> Sheet:
        """Return a king's crown: a two-sided hoop whose upper edge is cut into points."""
        points = []
        for out, row in ((1.03, 0), (1.05, 1), (1.0, 1), (0.99, 0)):
            for step in range(2 * SEGMENTS):
                peak = 0.075 if step % 4 == 0 else 0.055 if step % 2 else 0.036
                points.append(self._place(math.pi * step / SEGMENTS, out + 0.06 * row * (peak > 0.06), peak * row))
        return rigid_sheet(np.array(points), skin_faces(4, 2 * SEGMENTS, True), bone_weights("head"))

    def globe(self, cut: Hat) -> list[Bolt]:
        """Return a round helmet around the head, open in front of the face, with a rim around the opening."""
        middle, radius = self.center - (0, 0, 0.045 * self.scale), 0.185 * self.scale
        rings, rim = [], []
        for turn in np.linspace(0, 2 * math.pi, 33)[:-1]:
            across = np.array((math.cos(turn), 0.0, 0.86 * math.sin(turn)))
            arc = np.linspace(0.85, math.pi, 12)
            rings.append([middle + radius * (across * math.sin(t) + np.array((0, -math.cos(t), 0))) for t in arc])
            rim.append(rings[-1][0])
        shell = skinned([*np.swapaxes(np.array(rings), 0, 1)], bone_weights("head"), caps=False)
        return [
            Bolt(shell, cut.tint, cut.fabric),
            Bolt(bar(rim, 0.012 * self.scale, bone_weights("head"), closed=True), cut.band, cut.fabric),
        ]

    def brim(self, width: float, rising: float) -> Sheet:
        """Return a brim of ``width`` metres that rises by ``rising`` metres at the sides, both faces."""
        points, faces = [], []
        rings = ((0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, -0.003), (0.5, -0.003), (0.0, -0.003))
        for out, drop in rings:
            for step in range(SEGMENTS):
                angle = 2 * math.pi * step / SEGMENTS
                rise = rising * math.cos(angle) ** 2 - 0.012 * max(0.0, -math.sin(angle))
                radius = 1.0 + out * width * self.scale / self.rx
                points.append(self._place(angle, radius, 0.002 + out**1.5 * rise + drop))
        for row in range(len(rings) - 1):
            for step in range(SEGMENTS):
                a, b = row * SEGMENTS + step, row * SEGMENTS + (step + 1) % SEGMENTS
                faces.append((a, a + SEGMENTS, b + SEGMENTS, b))
        return rigid_sheet(np.array(points), faces, bone_weights("head"))

    def visor(self, width: float) -> Sheet:
        """Return a crescent of ``width`` metres in front."""
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
        return rigid_sheet(np.array(points), faces, bone_weights("head"))
