"""Seats, beds and grips are found on shapes that nobody has declared any for."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.geometry import solids
from storyblender.geometry.holding import find_hold
from storyblender.geometry.resting import LevelGrid, find_bed, find_seats

Boxes = list[tuple[tuple[float, float, float], tuple[float, float, float]]]
"""Middle and size of each."""

CHAIR: Boxes = [((0, 0, 0.43), (0.46, 0.46, 0.04)), ((0, 0.21, 0.68), (0.46, 0.04, 0.5))]
ARMCHAIR: Boxes = [
    ((0, 0, 0.2), (0.6, 0.7, 0.4)),
    ((0, 0.4, 0.45), (0.9, 0.15, 0.9)),
    ((-0.37, 0, 0.3), (0.14, 0.7, 0.6)),
    ((0.37, 0, 0.3), (0.14, 0.7, 0.6)),
]
SOFA: Boxes = [((0, 0, 0.2), (1.8, 0.7, 0.44)), ((0, 0.4, 0.45), (1.8, 0.15, 0.9))]
BED: Boxes = [((0, 0, 0.25), (1.4, 2.0, 0.5)), ((0, 1.02, 0.5), (1.4, 0.05, 1.0))]
TABLE: Boxes = [((0, 0, 0.73), (1.6, 0.9, 0.04))]


def field(boxes: Boxes, quarter: int, cell: float = 0.02) -> LevelGrid:
    """Return the level places of upright boxes, turned by quarters about Z."""
    turned = []
    for (x, y, z), (w, d, h) in boxes:
        for _ in range(quarter):
            (x, y), (w, d) = (-y, x), (d, w)
        turned.append((x - w / 2, x + w / 2, y - d / 2, y + d / 2, z - h / 2, z + h / 2))
    low = np.array([min(box[0] for box in turned), min(box[2] for box in turned)])
    high = np.array([max(box[1] for box in turned), max(box[3] for box in turned)])
    columns, rows = (round(side / cell) for side in high - low)
    top = np.full((rows, columns), -np.inf)
    found = []
    for row in range(rows):
        for column in range(columns):
            x, y = low + (np.array([column, row]) + 0.5) * cell
            ceiling = np.inf
            for level in sorted((b[5] for b in turned if b[0] < x < b[1] and b[2] < y < b[3]), reverse=True):
                found.append((row, column, level, ceiling - level))
                ceiling = min(ceiling, level)
                top[row, column] = max(top[row, column], level)
    table = np.array(found)
    return LevelGrid(cell, low, top, table[:, 0].astype(int), table[:, 1].astype(int), table[:, 2], table[:, 3])


def ahead(quarter: int) -> tuple[float, float]:
    x, y = 0.0, -1.0
    for _ in range(quarter):
        x, y = -y, x
    return x, y


@pytest.mark.parametrize("quarter", range(4))
@pytest.mark.parametrize(("boxes", "count", "height"), [(CHAIR, 1, 0.45), (ARMCHAIR, 1, 0.4), (SOFA, 3, 0.42)])
@pytest.mark.parametrize("use", ["seat", ""])
def test_one_sits_with_the_back_behind_whichever_way_it_stands(
    boxes: Boxes, count: int, height: float, quarter: int, use: str
) -> None:
    places = find_seats(field(boxes, quarter), use)  # type: ignore[arg-type]
    assert places.backed and len(places.anchors) == count
    for seat in places.anchors:
        assert seat.location[2] == pytest.approx(height, abs=0.02)
        assert seat.direction[:2] == pytest.approx(ahead(quarter), abs=1e-9)
        assert min(seat.size) > 0.35
    middle = np.mean([seat.location[:2] for seat in places.anchors], axis=0)
    assert middle @ np.array(ahead(quarter)) == pytest.approx(0.23 if boxes is CHAIR else 0.35, abs=0.03)


@pytest.mark.parametrize("quarter", range(4))
@pytest.mark.parametrize("use", ["bed", ""])
def test_one_lies_with_the_head_at_the_headboard(quarter: int, use: str) -> None:
    places = find_bed(field(BED, quarter, 0.04), use)  # type: ignore[arg-type]
    bed, *edges = places.anchors
    assert (bed.kind, len(edges), places.backed) == ("bed", 2, True)
    assert bed.direction[:2] == pytest.approx(ahead(quarter), abs=1e-9)
    assert bed.location[2] == pytest.approx(0.52, abs=0.02) and bed.size == pytest.approx((1.4, 2.0), abs=0.1)
    for edge in edges:
        assert abs(np.dot(edge.direction, bed.direction)) < 1e-9 and np.dot(edge.location, edge.direction) > 0.6


def test_a_table_is_no_seat_and_no_bed_unless_it_is_called_one() -> None:
    for use in ("other", ""):
        assert not find_seats(field(TABLE, 0), use).anchors  # type: ignore[arg-type]
        assert not find_bed(field(TABLE, 0), use).anchors  # type: ignore[arg-type]


def test_nobody_sits_under_a_board() -> None:
    shelf: Boxes = [((0, 0, 0.43), (0.8, 0.4, 0.04)), ((0, 0, 0.75), (0.8, 0.4, 0.04))]
    assert all(seat.location[2] > 0.7 for seat in find_seats(field(shelf, 0), "seat").anchors)


def shape(boxes: Boxes) -> tuple[np.ndarray, np.ndarray]:
    points, triangles, count = [], [], 0
    for middle, size in boxes:
        corners, faces = solids.box(size)
        points.append(corners + np.array(middle))
        triangles += [(f[0] + count, f[i] + count, f[i + 1] + count) for f in faces for i in (1, 2)]
        count += len(corners)
    return np.concatenate(points), np.array(triangles)


@pytest.mark.parametrize("axis", range(3))
def test_a_hammer_is_held_by_its_handle(axis: int) -> None:
    handle, head = np.roll([0, 0, 0.15], axis + 1), np.roll([0, 0, 0.33], axis + 1)
    sizes = np.roll([0.03, 0.03, 0.3], axis + 1), np.roll([0.12, 0.05, 0.06], axis + 1)
    hold = find_hold(*shape([(tuple(handle), tuple(sizes[0])), (tuple(head), tuple(sizes[1]))]))  # type: ignore[list-item]
    assert hold is not None and hold.axis == axis
    assert 0.02 < hold.place[axis] < 0.3 and hold.half == pytest.approx(0.015, abs=0.003)
    assert hold.closed > 0.8


def test_a_lamp_is_held_by_its_stem_and_a_box_by_its_side() -> None:
    lamp = find_hold(
        *shape([((0, 0, 0.02), (0.16, 0.16, 0.04)), ((0, 0, 0.15), (0.03, 0.03, 0.3)), ((0, 0, 0.4), (0.3, 0.3, 0.2))])
    )
    assert lamp is not None and 0.04 < lamp.place[2] < 0.3 and lamp.half < 0.02
    box = find_hold(*shape([((0, 0, 0.1), (0.25, 0.2, 0.2))]))
    assert box is not None and box.half == pytest.approx(0.125) and box.closed < 0.4
    assert find_hold(*shape([((0, 0, 0.5), (1.5, 0.8, 1.0))])) is None


def test_the_floor_of_a_car_is_no_seat() -> None:
    floor, seat = ((0, 0, 0.25), (1.4, 2.4, 0.04)), ((0, 0.3, 0.45), (1.2, 0.5, 0.3))
    assert find_seats(field([floor], 0, 0.05), "seat", faces_front=True).anchors, "a raft's is"
    assert not find_seats(field([floor], 0, 0.05), "seat", faces_front=True, cabin=True).anchors
    found = find_seats(field([floor, seat], 0, 0.05), "seat", faces_front=True, cabin=True).anchors
    assert [anchor.location[2] for anchor in found] == pytest.approx([0.6, 0.6])
