"""Pieces sewn onto clothes or tied over them: buttons, pockets, ties, scarves, the bib of an apron."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from storyblender.blender.people.cloth import Bolt, single_bolt
from storyblender.blender.people.figure import FAR, BodyFigure
from storyblender.blender.people.sheet import Sheet, clip, join, loosened, normals, rigid_sheet
from storyblender.blender.people.worn_layers import FrontPoint, WornLayers
from storyblender.catalog.cuts import Bib, BowTie, Buttons, Necktie, Patches, Scarf
from storyblender.geometry.solids import Floats

Row = tuple[float, float, float]
"""Height, half width and middle of one row of a strip, metres."""


def build_buttons(cut: Buttons, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of one or two rows of round buttons on the front of the worn layers."""
    k = figure.scale
    columns = (-cut.offset, cut.offset) if cut.offset else (0.0,)
    heights = np.linspace(figure.height(cut.top), figure.height(cut.bottom), cut.count)
    spots = [layers.front(x * k, float(z)) for z in heights for x in columns]
    discs = [_disc(spot, cut.radius * k) for spot in spots if spot is not None]
    return single_bolt(cut, join(discs)) if discs else []


def _disc(spot: FrontPoint, radius: float) -> Sheet:
    """Return a round button on a point of the clothes."""
    across = np.cross(spot.normal, (0, 0, 1))
    across /= np.linalg.norm(across)
    up = np.cross(across, spot.normal)
    turns = [2 * math.pi * step / 8 for step in range(8)]
    base = spot.location + spot.normal * 0.002
    ring = [base + (across * math.cos(turn) + up * math.sin(turn)) * radius for turn in turns]
    points = [base + spot.normal * 0.4 * radius, *ring]
    return rigid_sheet(np.array(points), [(0, 1 + (i + 1) % 8, 1 + i) for i in range(8)], spot.weights)


def _strip(rows: Sequence[Row], lift: float, layers: WornLayers) -> Sheet | None:
    """Return a strip of five columns, ``lift`` metres over the front of the clothes, or None where they have a hole."""
    points, weights = [], []
    columns = (-1.0, -0.5, 0.0, 0.5, 1.0)
    for z, half, middle in rows:
        for at in columns:
            spot = layers.front(middle + at * half, z)
            if spot is None:
                return None
            points.append(spot.location + spot.normal * lift * (1.4 - 0.6 * abs(at)))
            weights.append(spot.weights)
    count = len(columns)
    faces = [
        (r * count + c, (r + 1) * count + c, (r + 1) * count + c + 1, r * count + c + 1)
        for r in range(len(rows) - 1)
        for c in range(count - 1)
    ]
    return rigid_sheet(np.array(points), faces, np.array(weights))


def build_patches(cut: Patches, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of pockets with a flap line."""
    k = figure.scale
    top = figure.height(cut.top)
    half, tall = cut.width / 2 * k, cut.height * k
    sheets = []
    for side in (1, -1) if cut.pair else (1,):
        rows = [(top - share * tall, half * (1 - 0.06 * share), side * cut.offset * k) for share in (0, 0.28, 0.65, 1)]
        flap = [(top + 0.004 * k - share * 0.3 * tall, half * 1.05, side * cut.offset * k) for share in (0, 0.5, 1)]
        sheets += [_strip(rows, 0.004 * k, layers), _strip(flap, 0.007 * k, layers)]
    found = [sheet for sheet in sheets if sheet is not None]
    return single_bolt(cut, join(found)) if found else []


def build_necktie(cut: Necktie, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a tie that hangs from its knot down the front."""
    k = figure.scale
    knot = figure.heights["neck"] - 0.030 * k
    lengths = (0.0, 0.012, 0.026, 0.034, 0.10, 0.17, 0.24, 0.31, cut.length - 0.03, cut.length)
    halves = (0.017, 0.022, 0.019, 0.014, 0.020, 0.024, 0.028, 0.032, 0.033, 0.003)
    rows = [(knot - down * k, half * k, 0.0) for down, half in zip(lengths, halves, strict=True)]
    strip = _strip(rows, 0.005 * k, layers)
    if strip is None:
        return []
    bulge = np.repeat((0.006, 0.009, 0.006, *[0.0] * 7), 5) * k
    return single_bolt(cut, strip.moved(strip.points + np.outer(bulge, (0.0, -1.0, 0.0))))


def build_bow_tie(cut: BowTie, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a bow at the collar."""
    k = figure.scale
    spots = (layers.front(0.0, figure.heights["neck"] - down * k) for down in np.linspace(0.005, 0.05, 8))
    spot = next((spot for spot in spots if spot is not None), None)
    if spot is None:
        return []
    center = spot.location + np.array((0.0, -0.012 * k, 0.006 * k))
    profile = ((0.0, 0.009, 0.011), (0.018, 0.017, 0.014), (0.042, 0.027, 0.010), (0.056, 0.025, 0.004))
    points, faces = [], []
    for side in (1, -1):
        first = len(points)
        for out, half, thick in profile:
            ring = ((1, -1), (1, 1), (-1, 1), (-1, -1))
            points += [center + np.array((side * out, deep * thick / 2, up * half)) * k for up, deep in ring]
        for row in range(len(profile) - 1):
            for corner in range(4):
                a, b = first + row * 4 + corner, first + row * 4 + (corner + 1) % 4
                faces.append((a, a + 4, b + 4, b) if side > 0 else (a, b, b + 4, a + 4))
        end = first + 4 * (len(profile) - 1)
        faces.append((end, end + 1, end + 2, end + 3)[::-side])
    knot = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * (0.009, 0.009, 0.012) * k + center
    first = len(points)
    points += list(knot)
    box = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    faces += [tuple(first + corner for corner in face) for face in box]
    return single_bolt(cut, rigid_sheet(np.array(points), faces, spot.weights))


def build_scarf(cut: Scarf, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a thick ring of cloth around the neck."""
    k = figure.scale
    sheet = figure.part("tights")
    sheet = clip(sheet, figure.below_neck(sheet, 0.05))
    sheet = clip(sheet, -figure.below_neck(sheet, -0.012))
    sheet = loosened(sheet, 0.016 * k, 3)
    share = np.clip((figure.up_neck(sheet) / k + 0.012) / 0.062, 0, 1)
    roll = np.sin(np.pi * share)[:, None] * 0.014 * k
    return single_bolt(cut, layers.push_out(sheet.moved(sheet.points + normals(sheet) * roll), 0.004 * k))


def build_bib(cut: Bib, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of an apron: a bib on the chest and a panel over the front of the legs."""
    k = figure.scale
    waist = figure.heights["belt"]

    def front(sheet: Sheet, half: float) -> Floats:
        return np.where(sheet.skin[:, 1] < figure.joint("pelvis")[1], half * k - np.abs(sheet.skin[:, 0]), -FAR)

    bib = figure.part("tights")
    bib = clip(bib, figure.height(cut.top) - bib.skin[:, 2])
    bib = clip(bib, figure.above(bib, waist - 0.01 * k))
    bib = clip(bib, np.where(figure.arm_share(bib) > 0.02, -FAR, front(bib, 0.105)))
    bib = loosened(bib, 0.010 * k, 10)
    panel = figure.part("skirt")
    panel = clip(panel, waist + 0.01 * k - panel.skin[:, 2])
    panel = clip(panel, panel.skin[:, 2] - figure.height(cut.hem))
    panel = clip(panel, front(panel, 0.17))
    panel = loosened(panel, 0.012 * k, 4)
    return [Bolt(layers.push_out(sheet, 0.006 * k), cut.tint, cut.fabric) for sheet in (bib, panel)]
