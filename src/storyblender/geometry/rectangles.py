"""Rectangles on a grid of cells. Pure."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray


def close_seams(free: NDArray[np.bool_], cell: float, seam: float) -> NDArray[np.bool_]:
    """Return the free cells and those between them that are no wider than ``seam``.

    Args:
        free: (rows, columns) of cells.
        cell: Metres of a cell's side.
        seam: Widest gap that is closed, metres.
    """
    closed = free.copy()
    for axis in (0, 1):
        there, out = np.moveaxis(free, axis, 0), np.moveaxis(closed, axis, 0)
        for gap in range(2, math.ceil(seam / cell) + 2):
            both = there[:-gap] & there[gap:]
            for inner in range(1, gap):
                out[inner : inner + len(both)] |= both
    return closed


def largest_rectangle(free: NDArray[np.bool_]) -> tuple[int, int, int, int]:
    """Return row, column, rows, columns of the largest all-true rectangle (stack over column heights)."""
    best = (0, 0, 0, 0)
    rows, columns = np.flatnonzero(free.any(1)), np.flatnonzero(free.any(0))
    left, right = int(columns[0]), int(columns[-1]) + 1  # a level is often one board among many: look only there
    heights = np.zeros(right - left, int)
    for row in range(int(rows[0]), int(rows[-1]) + 1):
        heights = np.where(free[row, left:right], heights + 1, 0)
        stack: list[tuple[int, int]] = []
        for column, tall in enumerate([*heights.tolist(), 0], left):
            start = column
            while stack and stack[-1][1] >= tall:
                start, height = stack.pop()
                if height * (column - start) > best[2] * best[3]:
                    best = (row - height + 1, start, height, column - start)
            stack.append((start, tall))
    return best
