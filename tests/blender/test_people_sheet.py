"""The tailor's scissors and needle, on a plain grid."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from storyblender.blender.people.sheet import Sheet, clip, hemmed, join, loosened, normals, rigid_sheet, rim, smoothed

pytestmark = pytest.mark.blender


def _grid(columns: int = 8, rows: int = 6) -> Sheet:
    points = np.array([(x, 0.0, z) for z in range(rows + 1) for x in range(columns + 1)], float)
    faces = [
        (r * (columns + 1) + c, r * (columns + 1) + c + 1, (r + 1) * (columns + 1) + c + 1, (r + 1) * (columns + 1) + c)
        for r in range(rows)
        for c in range(columns)
    ]
    weights = np.zeros(35)
    weights[0] = 1
    return rigid_sheet(points, faces, weights)


def _area(sheet: Sheet) -> float:
    total = 0.0
    for face in sheet.faces:
        ring = sheet.points[face[face >= 0]] - sheet.points[face[0]]
        total += np.linalg.norm(sum(np.cross(a, b) for a, b in itertools.pairwise(ring))) / 2
    return float(total)


def test_clip_cuts_along_the_zero_line() -> None:
    sheet = _grid()
    field = 3.3 - sheet.points[:, 0] + 0.25 * sheet.points[:, 2]
    cut = clip(sheet, field)
    assert _area(cut) == pytest.approx((3.3 + 4.8) / 2 * 6)
    assert (3.3 - cut.points[:, 0] + 0.25 * cut.points[:, 2] > -1e-9).all()
    assert np.allclose(cut.weights.sum(1), 1)
    assert (cut.source == -1).all()


def test_clip_keeps_all_or_nothing() -> None:
    sheet = _grid()
    assert len(clip(sheet, np.ones(len(sheet.points))).faces) == len(sheet.faces)
    assert len(clip(sheet, -np.ones(len(sheet.points))).faces) == 0


def test_loosened_keeps_its_distance_and_smoothing_keeps_the_hem() -> None:
    sheet = _grid()
    bumpy = sheet.moved(sheet.points + np.outer(np.sin(np.arange(len(sheet.points))), (0, 0.3, 0)))
    assert np.allclose(smoothed(bumpy, 5)[rim(bumpy)], bumpy.points[rim(bumpy)])
    loose = loosened(bumpy, 0.2, 4)
    clearance = ((loose.points - bumpy.points) * normals(bumpy)).sum(1)
    assert clearance.min() > 0.2 - 1e-9


def test_a_hem_is_folded_inwards() -> None:
    sheet = _grid()
    folded = hemmed(sheet, 0.1)
    inner = folded.points[len(sheet.points) :]
    assert len(inner) == rim(sheet).sum()
    assert np.allclose(inner[:, 1], -0.1 * normals(sheet)[0, 1])


def test_join_renumbers() -> None:
    both = join([_grid(2, 2), rigid_sheet(np.eye(3), [(0, 1, 2)], np.eye(35)[3])])
    assert both.faces[-1].tolist() == [9, 10, 11, -1]
    assert both.weights[-1, 3] == 1
