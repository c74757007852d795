"""Arithmetic on pictures: (h, w) and (h, w, 3) float32 arrays, row 0 at the top."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.float32]
Mask = NDArray[np.bool_]

LUMA = np.array([0.2126, 0.7152, 0.0722], np.float32)
"""Weights of Rec. 709 luminance."""

_SMALL = 2
"""Radius up to which adding shifted rows is faster than running sums."""


@dataclass(frozen=True)
class Window:
    """A rectangle of a picture, in pixels; ``bottom`` and ``right`` are past its end."""

    top: int
    left: int
    bottom: int
    right: int

    @property
    def cut(self) -> tuple[slice, slice]:
        """The index that takes the rectangle out of an (h, w, ...) array."""
        return slice(self.top, self.bottom), slice(self.left, self.right)

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return self.bottom - self.top, self.right - self.left

    def enlarged(self, step: int) -> Window:
        """Return the rectangle in a picture with ``step`` times as many pixels each way."""
        return Window(self.top * step, self.left * step, self.bottom * step, self.right * step)

    def moved(self, rows: int, columns: int) -> Window:
        """Return the rectangle moved by pixels: ``rows`` down and ``columns`` to the right, negative up and left."""
        return Window(self.top + rows, self.left + columns, self.bottom + rows, self.right + columns)

    def within(self, outer: Window) -> Window:
        """Return the rectangle's place in another one."""
        return self.moved(-outer.top, -outer.left)

    def grown(self, by: int, height: int, width: int) -> Window:
        """Return it larger by ``by`` pixels on each side, within a whole picture of ``height`` x ``width`` pixels."""
        return Window(
            max(0, self.top - by), max(0, self.left - by), min(height, self.bottom + by), min(width, self.right + by)
        )

    def inner(self, by: int, height: int, width: int) -> Window:
        """Return it smaller on each side that is not the edge of the whole picture.

        Args:
            by: Pixels taken off each such side.
            height: Rows of the whole picture.
            width: Columns of the whole picture.
        """
        return Window(
            self.top + by * (self.top > 0),
            self.left + by * (self.left > 0),
            self.bottom - by * (self.bottom < height),
            self.right - by * (self.right < width),
        )


def window_around(mask: Mask) -> Window:
    """Return the smallest window with all that is true of an (h, w) mask; something is."""
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    return Window(int(rows[0]), int(columns[0]), int(rows[-1]) + 1, int(columns[-1]) + 1)


def windows_round(mask: Mask, room: int, gap: int = 0) -> list[Window]:
    """Return rectangles round all that is set, with some room on every side, that do not overlap.

    Args:
        mask: (h, w).
        room: Pixels.
        gap: What lies further apart than that, in rows or columns, gets rectangles of its own; at least twice the room.
    """
    height, width = mask.shape
    gap = max(gap, 2 * room)
    found: list[Window] = []
    unsplit = [Window(0, 0, height, width)]
    while unsplit:
        window = unsplit.pop()
        part = mask[window.cut]
        rows, columns = (np.flatnonzero(part.any(axis=axis)) for axis in (1, 0))
        if not len(rows):
            continue
        row_runs, column_runs = _runs(rows + window.top, gap), _runs(columns + window.left, gap)
        if len(row_runs) * len(column_runs) > 1:
            unsplit += [Window(top, left, bottom, right) for top, bottom in row_runs for left, right in column_runs]
            continue
        ((top, bottom),), ((left, right),) = row_runs, column_runs
        found.append(
            Window(max(0, top - room), max(0, left - room), min(height, bottom + room), min(width, right + room))
        )
    return sorted(found, key=lambda window: (window.top, window.left))


def _runs(places: NDArray[np.int64], gap: int) -> list[tuple[int, int]]:
    """Return (first, past the last) of the stretches that lie further apart than the gap."""
    pieces = np.split(places, np.flatnonzero(np.diff(places) > gap) + 1)
    return [(int(piece[0]), int(piece[-1]) + 1) for piece in pieces]


def stacked(planes: Sequence[Image]) -> Image:
    """Return (h, w) planes as one picture (h, w, c), each still in one piece."""
    return np.moveaxis(np.stack(planes), 0, 2)


def dot(a: Image, b: Image) -> Image:
    """Return the (...) product of two (..., 3) arrays of vectors along their last axis."""
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2]


def luminance(image: Image) -> Image:
    """Return the (h, w) luminance of a linear picture; of a display picture, its luma."""
    return image @ LUMA


def shrink(image: NDArray, factor: int) -> Image:
    """Average blocks of ``factor`` x ``factor`` pixels of an (h, w) or (h, w, c) picture.

    Raises:
        ValueError: Height or width is no multiple of ``factor``.
    """
    if factor == 1:
        return image.astype(np.float32)
    height, width = image.shape[:2]
    if height % factor or width % factor:
        raise ValueError(f"{width} x {height} is no multiple of {factor}")
    total = np.zeros((height // factor, width // factor, *image.shape[2:]), np.float32)
    for row in range(factor):  # three times as fast as the mean over two axes of the blocks
        for column in range(factor):
            total += image[row::factor, column::factor]
    return total / np.float32(factor * factor)


def every(image: NDArray, step: int) -> NDArray:
    """Take one pixel from the middle of each ``step`` x ``step`` block, as a contiguous copy."""
    return np.ascontiguousarray(image[step // 2 :: step, step // 2 :: step])


def any_of(mask: Mask, step: int) -> Mask:
    """Return of each block of ``step`` x ``step`` pixels whether one is set; (h, w) must be multiples of ``step``."""
    height, width = mask.shape
    return mask.reshape(height // step, step, width // step, step).any(axis=(1, 3))


def blur(image: Image, radius: int) -> Image:
    """Box blur of (2 ``radius`` + 1) squared pixels of an (h, w) or (h, w, c) picture; edges repeat."""
    return blur_rows(np.swapaxes(blur_rows(np.swapaxes(image, 0, 1), radius), 0, 1), radius)


def blur_rows(image: Image, radius: int) -> Image:
    """Box blur of 2 ``radius`` + 1 pixels along the columns only (a vertical smear); edges repeat.

    Args:
        image: (h, w) or (h, w, c).
        radius: Pixels; below 1 the picture is returned as it is.
    """
    if radius < 1:
        return image
    count, padding, window = image.shape[0], [(radius + 1, radius)] + [(0, 0)] * (image.ndim - 1), 2 * radius + 1
    padded = np.pad(image, padding, mode="edge")
    if radius <= _SMALL:
        total = padded[1 : 1 + count].astype(np.float32)
        for shift in range(2, window + 1):
            total += padded[shift : shift + count]
        return total / np.float32(window)
    sums = np.cumsum(padded, axis=0, dtype=np.float64)
    return ((sums[window : window + count] - sums[:count]) / window).astype(np.float32)


def spread(values: NDArray) -> NDArray:
    """Give every pixel the largest value among itself and its four neighbours."""
    grown = values.copy()
    np.maximum(grown[1:], values[:-1], out=grown[1:])
    np.maximum(grown[:-1], values[1:], out=grown[:-1])
    np.maximum(grown[:, 1:], values[:, :-1], out=grown[:, 1:])
    np.maximum(grown[:, :-1], values[:, 1:], out=grown[:, :-1])
    return grown


def noise(size: int, exponent: float, seed: int) -> Image:
    """Tileable 1/f^exponent noise, 0 to 1, mean 0.5, (size, size); the same ``seed`` gives the same noise."""
    frequency = np.fft.fftfreq(size) * size
    distance = np.hypot(frequency[None, :], frequency[:, None])
    distance[0, 0] = np.inf
    white = np.random.default_rng(seed).standard_normal((size, size))
    field = np.fft.ifft2(np.fft.fft2(white) * distance**-exponent).real
    return np.clip(0.5 + 0.22 * field / field.std(), 0, 1).astype(np.float32)
