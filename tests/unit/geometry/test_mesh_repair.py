"""What is none of a thing is left out of its file, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.geometry import solids
from storyblender.geometry.mesh_repair import Surface, find_foreign, find_inside_out

Piece = tuple[np.ndarray, list[tuple[int, ...]]]


def box(size: tuple[float, float, float], at: tuple[float, float, float] = (0, 0, 0)) -> Piece:
    points, faces = solids.box(size)
    return np.array(points) + at, [tuple(face) for face in faces]


def sheet(width: float, depth: float, at: tuple[float, float, float]) -> Piece:
    corners = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]) * (width / 2, depth / 2, 0) + at
    return corners, [(0, 1, 2, 3)]


def surface(*pieces: Piece) -> Surface:
    faces: list[tuple[int, ...]] = []
    for number, (_, own) in enumerate(pieces):
        start = sum(len(points) for points, _ in pieces[:number])
        faces += [tuple(corner + start for corner in face) for face in own]
    sizes = np.array([len(face) for face in faces])
    return Surface(
        np.concatenate([points for points, _ in pieces]), np.array([c for face in faces for c in face]), sizes
    )


THING = box((1, 1, 1))
LOW = float(THING[0][:, 2].min())


def test_a_ground_plane_and_a_backdrop_are_left_out() -> None:
    points, faces = sheet(6, 6, (0, 0, 0))
    wall = (points[:, [0, 2, 1]] + (0, 0.6, 3), faces)
    foreign, notes = find_foreign(surface(THING, sheet(5, 5, (0, 0, LOW)), wall))
    assert foreign.tolist() == [False] * len(THING[1]) + [True, True] and len(notes) == 1


@pytest.mark.parametrize(
    "piece", [box((3, 3, 0.1), (0, 0, LOW - 0.05)), sheet(1.4, 1.4, (0, 0, LOW)), sheet(5, 5, (0, 0, LOW + 0.5))]
)
def test_a_slab_a_small_mat_and_a_table_top_stay(piece: Piece) -> None:
    assert not find_foreign(surface(THING, piece))[0].any()


def test_a_carpet_alone_stays() -> None:
    assert not find_foreign(surface(sheet(3, 2, (0, 0, 0))))[0].any()


def test_a_speck_far_away_is_left_out_and_a_second_thing_is_not() -> None:
    foreign, _ = find_foreign(surface(THING, box((0.05, 0.05, 0.05), (90, 0, 0))))
    assert foreign.sum() == len(THING[1])
    assert not find_foreign(surface(THING, box((1, 1, 1), (90, 0, 0))))[0].any()


def test_faces_that_lie_on_faces_are_left_out_once() -> None:
    points, faces = THING
    foreign, _ = find_foreign(surface(THING, (points, [face[::-1] for face in faces])))
    assert foreign.tolist() == [False] * len(faces) + [True] * len(faces)


def test_only_closed_parts_that_are_inside_out_are_turned() -> None:
    points, faces = box((1, 1, 1), (5, 0, 0))
    inverted = (points, [face[::-1] for face in faces])
    open_one = (points + 5, [face[::-1] for face in faces[1:]])
    found = find_inside_out(surface(THING, inverted, open_one))
    assert found.tolist() == [False] * len(faces) + [True] * len(faces) + [False] * (len(faces) - 1)
