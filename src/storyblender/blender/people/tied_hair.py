"""Hair tied at the back: a ponytail as one soft brush, a braid as three woven strands."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.locks import DROP, KNOT, HairSupport, ball
from storyblender.blender.people.scalp import Scalp
from storyblender.blender.people.sheet import Sheet, rigid_sheet
from storyblender.geometry.solids import Floats

_AROUND = 20
"""Corners of a cross-section."""
_GROOVES = 5
"""Shallow grooves along a ponytail, which read as locks that stay together."""
_TAIL = ((0.0, 0.12, 0.4, 0.75, 1.0), (0.010, 0.019, 0.025, 0.020, 0.005))
"""Radius of a ponytail in metres along its length: it swells below the band and ends in a soft point."""
_BRAID_LENGTH, _TAIL_LENGTH = 0.38, 0.28
_PITCH = 0.075
"""Metres of a braid in which a strand comes back to its side."""
BACK = np.array((0.0, 1.0, 0.0))
_INWARDS, _CLEAR = 0.6, 0.02
"""Metres a tail comes inwards for each metre it falls, until its middle is this far from neck and back."""
_SWAY, _CROSS = 0.012, 0.007
"""Metres a strand of a braid moves sideways, and in and out."""
_FREE, _LAIN = 0.14, -0.06
"""Metres from the neck, at scale 1: above the first a tail follows the head, below the second it lies on the back."""
_STAYS = 0.95
"""Weight of the back on a tail that lies on it, so that a bending head does not swing it out."""


def tied_hair(scalp: Scalp, body: HairSupport) -> list[Sheet]:
    """Return what hangs from the knot, a ponytail or a braid, and the band that holds it.

    Args:
        scalp: The head, with a hairstyle that is tied.
        body: What the hair lies on.
    """
    figure, scale = scalp.figure, scalp.figure.head_scale
    braided = scalp.spec.knot == "braid"
    spine, outward = _spine(scalp, body)
    sheets = [ball(figure, spine[0], np.full(3, 0.015) * scale, np.eye(3), 8, 6)]
    at = np.linspace(0, 1, len(spine))[:, None]
    across = np.cross(np.gradient(spine, axis=0), outward)
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)
    if not braided:
        tail = _tube(spine, outward, np.interp(at[:, 0], *_TAIL) * scale, _GROOVES)
        return [_hanging(sheet, figure) for sheet in (*sheets, tail)]
    thick = np.interp(at[:, 0], (0.0, 0.1, 0.8, 0.92, 1.0), (0.007, 0.0115, 0.009, 0.006, 0.003)) * scale
    loose = np.interp(at, (0.0, 0.1, 0.8, 0.92), (0.3, 1.0, 0.8, 0.2)) * scale
    for strand in range(3):
        turn = 2 * np.pi * (at * _BRAID_LENGTH / _PITCH + strand / 3)
        woven = spine + loose * (_SWAY * np.sin(turn) * across + _CROSS * np.sin(2 * turn) * outward)
        sheets.append(_tube(woven, outward, thick, 0))
    end = round(0.92 * len(spine))
    sheets.append(ball(figure, spine[end], np.full(3, 0.009) * scale, np.eye(3), 8, 6))
    return [_hanging(sheet, figure) for sheet in sheets]


def _hanging(sheet: Sheet, figure: BodyFigure) -> Sheet:
    """Return a sheet whose weights change from the head's to the back's on the way down."""
    neck = figure.heights["neck"]
    heights = neck + _LAIN * figure.scale, neck + _FREE * figure.scale
    share = np.interp(sheet.points[:, 2], heights, (_STAYS, 0.0))[:, None]
    return replace(sheet, weights=(1 - share) * bone_weights("head") + share * bone_weights("upper_chest"))


def _spine(scalp: Scalp, body: HairSupport) -> tuple[Floats, Floats]:
    """Return the middle line from the knot down the back in even steps, and the directions away from the back."""
    spec, scale = scalp.spec, scalp.figure.head_scale
    found = scalp.hair_surface(KNOT, 0.012 * scale)
    start = found[0] if found else scalp.center
    points = [start, start + KNOT * 0.012 * scale, start + KNOT * 0.02 * scale]
    drop, length = DROP * scale, (_BRAID_LENGTH if spec.knot == "braid" else _TAIL_LENGTH) * scale
    for _ in range(round(length / drop)):
        below = points[-1] - (0.0, 0.0, drop)
        ledge = max(body.behind(below - (0.0, 0.0, step * drop)) for step in range(3))  # a collar is met from above
        below[1] = max(below[1] - _INWARDS * drop, ledge + _CLEAR * scale)
        points.append(below)
    line, outward = np.array(points), [KNOT] * 3 + [BACK] * (len(points) - 3)
    for _ in range(4):  # the back and the collar push single points out
        line[1:-1] = 0.5 * line[1:-1] + 0.25 * (line[:-2] + line[2:])
    index, at = np.arange(len(line)), np.linspace(0, len(line) - 1, 3 * len(line))
    even = np.stack([np.interp(at, index, line[:, axis]) for axis in range(3)], 1)
    away = np.stack([np.interp(at, index, np.array(outward)[:, axis]) for axis in range(3)], 1)
    along = np.gradient(even, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    away -= along * (away * along).sum(1, keepdims=True)
    return even, away / np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-9)


def _tube(line: Floats, outward: Floats, radius: Floats, grooves: int) -> Sheet:
    """Return a closed tube of varying ``radius`` about ``line``, with ``grooves`` along it."""
    along = np.gradient(line, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    across = np.cross(along, outward)
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)
    out = np.cross(across, along)
    turn = 2 * np.pi * np.arange(_AROUND) / _AROUND
    swell = 1 + (0.12 * np.abs(np.cos(grooves * turn / 2)) if grooves else 0.0 * turn)
    ring = np.cos(turn)[:, None] * across[:, None] + np.sin(turn)[:, None] * out[:, None]
    rows = line[:, None] + ring * (radius[:, None] * swell)[:, :, None]
    flat = np.concatenate([rows.reshape(-1, 3), line[:1], line[-1:]])
    count, last = len(line), len(line) * _AROUND
    faces: list[tuple[int, ...]] = []
    for step in range(_AROUND):
        after = (step + 1) % _AROUND
        for row in range(count - 1):
            a, b = row * _AROUND, (row + 1) * _AROUND
            faces.append((a + step, a + after, b + after, b + step))
        faces.append((last, after, step))
        faces.append((last + 1, last - _AROUND + step, last - _AROUND + after))
    return rigid_sheet(flat, faces, bone_weights("head"))
