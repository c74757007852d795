"""Hanging hair as one smooth sheet: combed from the parting over the head, then falling, in shallow soft locks."""

from __future__ import annotations

import numpy as np

from storyblender.blender.people.locks import HairSupport, hair_weights
from storyblender.blender.people.scalp import Scalp
from storyblender.blender.people.sheet import Sheet, rigid_sheet
from storyblender.geometry.solids import Floats

_COLUMNS = 91
"""Columns of points from cheek to cheek."""
_COMBED = 15
"""Rows from the parting to where the hair leaves the head."""
_DROP = 0.016
"""Metres between the rows below that."""
_LOCKS = 17
"""Soft locks from cheek to cheek."""
_OPEN = np.radians(113)
"""How far to each side of the back the hair reaches round the head."""
_JAW = 0.1
"""Length below the ear from which hair can touch neck and shoulders; shorter hair turns in a little instead."""
_TURNS_IN = 0.045
"""Metres; how strongly hair to the jaw bends towards the nape. Straight down it would look like a lampshade."""
_LEAVES = -0.1
"""Height on the unit sphere at which hair leaves the head."""
_HEM = ((0.007, -0.004), (0.018, 0.010))
"""Inwards and upwards, metres: the hem turns under, so that the hair has thickness."""


def hanging_hair(scalp: Scalp, body: HairSupport, rng: np.random.Generator) -> tuple[Sheet, Floats]:
    """Return the sheet of hanging hair and the shade of each of its points, (V,), about 1.

    Args:
        scalp: The head, with the hairstyle.
        body: What long hair lies on.
        rng: Varies the locks.
    """
    spec, scale = scalp.spec, scalp.figure.head_scale
    turns = np.linspace(-_OPEN, _OPEN, _COLUMNS)
    ridge, length = _locks(rng)
    falling = max(3, round(spec.hang / _DROP))
    long = spec.hang > _JAW
    columns = []
    for column, turn in enumerate(turns):
        edge = min(1.0, (_OPEN - abs(turn)) / 0.16)  # the rims lie close, so that no sheet stands out from the face
        points = _combed(scalp, turn, ridge[column], edge)
        out = points[-1] - scalp.center
        out = np.array((out[0], out[1], 0.0)) / np.hypot(out[0], out[1])
        across = np.array((-out[1], out[0], 0.0))
        drop = spec.hang * scale * length[column] / falling
        for row in range(1, falling + 1):
            down = row / falling
            swing = spec.wave * np.sin(2.2 * np.pi * down * spec.hang / 0.16 + 1.3 * ridge[column])
            inward = 0.0 if long else -_TURNS_IN * (0.45 + 0.55 * max(np.cos(turn), 0.0)) * down**2
            flare = 0.0035 * ridge[column] * down / falling * 2 + inward / falling * 2
            sway = 3.0 * swing / falling
            step = np.array((0.0, 0.0, -drop)) + scale * (out * (flare + 0.35 * sway) + across * sway)
            point = points[-1] + step
            points.append(body.clear(point, 0.008 * scale) if long else point)
        tip = points[-1]
        points += [tip - out * inset * scale + np.array((0.0, 0.0, rise * scale)) for inset, rise in _HEM]
        columns.append(points)
    grid = np.array(columns)
    rows = grid.shape[1]
    for _ in range(3):  # shoulders and jaw push single columns out
        middle = grid[1:-1, _COMBED:]
        grid[1:-1, _COMBED:] = 0.5 * middle + 0.25 * (grid[:-2, _COMBED:] + grid[2:, _COMBED:])
    index = np.arange(_COLUMNS * rows).reshape(_COLUMNS, rows)
    corners = np.stack([index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]], -1).reshape(-1, 4)
    flat = grid.reshape(-1, 3)
    fine = rng.normal(0, 0.035, _COLUMNS)
    shade = np.repeat(1.0 + 0.09 * ridge + fine, rows).reshape(_COLUMNS, rows)
    shade *= np.interp(np.arange(rows), (0, _COMBED, rows - 1), (0.9, 1.04, 0.92))
    return rigid_sheet(
        flat, [tuple(face) for face in corners.tolist()], hair_weights(scalp.figure, flat)
    ), shade.ravel()


def _combed(scalp: Scalp, turn: float, ridge: float, edge: float) -> list[Floats]:
    """Return a column of points from the parting over the head to where the hair leaves it."""
    spec, scale = scalp.spec, scalp.figure.head_scale
    pole = np.array((0.7 * spec.parting, -0.60, 0.80))
    pole /= np.linalg.norm(pole)
    back = np.array((0.0, 1.0, 0.0)) - pole * pole[1]
    back /= np.linalg.norm(back)
    way = back * np.cos(turn) + np.cross(back, pole) * np.sin(turn)
    angles = np.linspace(0.0, np.pi, 90)
    directions = pole * np.cos(angles)[:, None] + way * np.sin(angles)[:, None]
    last = int(np.argmax(directions[:, 2] < _LEAVES))
    points: list[Floats] = []
    radius = 0.1 * scale
    for at in np.linspace(0.04, angles[last], _COMBED):
        direction = pole * np.cos(at) + way * np.sin(at)
        rooted = min(1.0, at / 0.5)
        lift = scale * (0.006 * edge * rooted + 0.0022 * ridge * rooted - 0.004 * (1 - rooted))
        found = scalp.hair_surface(direction, lift)
        if found is not None:
            radius = float(np.linalg.norm(found[0] - scalp.center))
        points.append(scalp.center + direction * radius)
    return points


def _locks(rng: np.random.Generator) -> tuple[Floats, Floats]:
    """Return for each column how high it lies in its lock, -1 to 1, and its length as a factor."""
    at = np.linspace(0, _LOCKS, _COLUMNS) + np.interp(
        np.linspace(0, 1, _COLUMNS), np.linspace(0, 1, 12), rng.uniform(-0.5, 0.5, 12)
    )
    ridge = 2 * np.abs(np.sin(np.pi * at)) ** 0.8 - 1
    each = rng.uniform(0.93, 1.03, _LOCKS + 4)
    return ridge, each[np.clip(at.astype(int), 0, _LOCKS + 3)] + 0.035 * ridge
