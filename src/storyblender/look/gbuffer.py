"""The G-buffer: what every pixel shows, before any light. All looks start from it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from storyblender.look.raster import Image, Mask, Window, every, shrink, stacked
from storyblender.look.surface import SKY

FAR = 1e4
"""Depth in metres of the sky."""


@dataclass(frozen=True)
class View:
    """A pinhole camera.

    Attributes:
        eye: (3,) position, world, metres.
        axes: (3, 3) world from camera; the camera looks along its -Z, +Y is up in the picture.
        width: Pixels.
        height: Pixels.
        half_width: Tangent of half the horizontal field of view.
        half_height: Tangent of half the vertical field of view.
        shift: Offset of the optical axis, in half widths and half heights.
    """

    eye: NDArray[np.float64]
    axes: NDArray[np.float64]
    width: int
    height: int
    half_width: float
    half_height: float
    shift: tuple[float, float] = (0.0, 0.0)

    @property
    def pixels_per_metre(self) -> float:
        """Pixels that one metre covers at a depth of one metre."""
        return self.width / (2 * self.half_width)

    def reduced(self, step: int) -> View:
        """Return the same camera with ``step`` times fewer pixels in each direction."""
        return View(
            self.eye,
            self.axes,
            self.width // step,
            self.height // step,
            self.half_width,
            self.half_height,
            self.shift,
        )

    @property
    def whole(self) -> Window:
        """All of its picture."""
        return Window(0, 0, self.height, self.width)

    def cropped(self, window: Window) -> View:
        """Return the camera of a part of the picture."""
        rows, columns = window.shape
        across, down = columns / self.width, rows / self.height
        right = (window.left + window.right) / self.width - 1 + self.shift[0]
        up = 1 - (window.top + window.bottom) / self.height + self.shift[1]
        return View(
            self.eye,
            self.axes,
            columns,
            rows,
            self.half_width * across,
            self.half_height * down,
            (right / across, up / down),
        )

    def slopes(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Return how far right the middle of each column, and how far up that of each row, lies at a depth of 1."""
        x = ((np.arange(self.width, dtype=np.float32) + 0.5) / self.width * 2 - 1 + self.shift[0]) * self.half_width
        y = (1 - (np.arange(self.height, dtype=np.float32) + 0.5) / self.height * 2 + self.shift[1]) * self.half_height
        return x.astype(np.float32), y.astype(np.float32)

    def rays(self) -> Image:
        """Return the rays in world space; position = eye + ray * depth."""
        x, y = self.slopes()
        axes = self.axes.astype(np.float32)
        return stacked([right * x[None, :] + (up * y - back)[:, None] for right, up, back in axes])

    def project(self, points: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Return column, row (pixels, float) and depth (metres, positive in front) of (..., 3) world points."""
        local = (np.asarray(points, np.float64) - self.eye) @ self.axes
        depth = -local[..., 2]
        safe = np.where(np.abs(depth) < 1e-6, 1e-6, depth)
        column = ((local[..., 0] / safe / self.half_width - self.shift[0]) + 1) / 2 * self.width
        row = (1 - (local[..., 1] / safe / self.half_height - self.shift[1])) / 2 * self.height
        return column, row, depth

    def misses(self, boxes: NDArray) -> Mask:
        """Return which of (n, corners, 3) convex bodies lie outside the picture for certain: beyond one of its sides.

        Args:
            boxes: World, metres.
        """
        local = (np.asarray(boxes, np.float64) - self.eye) @ self.axes
        away = -local[..., 2]
        x, y = local[..., 0] / self.half_width, local[..., 1] / self.half_height
        across, up = self.shift
        sides = (x > away * (1 + across), -x > away * (1 - across), y > away * (1 + up), -y > away * (1 - up), away < 0)
        return np.logical_or.reduce([side.all(axis=-1) for side in sides])


def same_view(a: View, b: View) -> bool:
    """Return whether two frames see through the same camera."""
    return (
        np.allclose(a.eye, b.eye, atol=1e-5)
        and np.allclose(a.axes, b.axes, atol=1e-6)
        and abs(a.half_width - b.half_width) < 1e-6
        and (a.width, a.height, a.shift) == (b.width, b.height, b.shift)
    )


@dataclass(frozen=True)
class GBuffer:
    """Flat passes of one frame at the supersampled size. Small types: 25 bytes a pixel.

    Attributes:
        view: The camera, with this buffer's size.
        ids: uint16 (h, w); 0 is sky, others index the frame's table of nodes.
        surface: uint8 (h, w) ``Surface``; 0 is sky.
        material: uint16 (h, w); 0 is none.
        depth: float32 (h, w) metres along the camera axis; ``FAR`` where sky.
        normal: float16 (h, w, 3) world space, unit; 0 where sky.
        albedo: float16 (h, w, 3) linear reflectance; 0 where sky.
        glow_color: float32 (materials, 3) light a material gives off, by ``material``.
        glow_gain: float32 (materials,) the same as a multiple of its albedo, for textured screens and cards.
        roughness: float32 (materials,) 0 mirror to 1 matt.
        patchy: float32 (materials,) how much ground of this material varies over metres, 0 to 1.
        relief: float16 (h, w, 3) world normals by the normal maps in view, 0 where none; None without any.
    """

    view: View
    ids: NDArray[np.uint16]
    surface: NDArray[np.uint8]
    material: NDArray[np.uint16]
    depth: NDArray[np.float32]
    normal: NDArray[np.float16]
    albedo: NDArray[np.float16]
    glow_color: NDArray[np.float32]
    glow_gain: NDArray[np.float32]
    roughness: NDArray[np.float32]
    patchy: NDArray[np.float32]
    relief: NDArray[np.float16] | None = None

    def reduced(self, step: int) -> GBuffer:
        """Return a point sample of every ``step``-th pixel, for light at low resolution."""
        if step == 1:
            return self
        return GBuffer(
            self.view.reduced(step),
            every(self.ids, step),
            every(self.surface, step),
            every(self.material, step),
            every(self.depth, step),
            every(self.normal, step),
            every(self.albedo, step),
            self.glow_color,
            self.glow_gain,
            self.roughness,
            self.patchy,
            None if self.relief is None else every(self.relief, step),
        )

    @property
    def sky(self) -> Mask:
        """True where the pixel shows no object."""
        return self.ids == SKY

    def positions(self) -> Image:
        """Return (h, w, 3) world positions; far away where sky."""
        return self.view.rays() * self.depth[..., None] + self.view.eye.astype(np.float32)

    def emission(self, step: int = 1) -> Image:
        """Return the linear light given off, averaged over blocks of ``step`` pixels."""
        out = np.zeros((self.view.height // step, self.view.width // step, 3), np.float32)
        glows = self.glow_color.any(axis=1) | (self.glow_gain > 0)
        band = 64 * step
        for top in range(0, self.view.height, band):
            rows = slice(top, top + band)
            material = self.material[rows]
            if glows[material].any():
                light = self.albedo[rows] * self.glow_gain[material][..., None] + self.glow_color[material]
                out[top // step : (top + band) // step] = shrink(light, step)
        return out

    def coverage(self, classes: tuple[int, ...], step: int = 1) -> Image:
        """Return the share, 0 to 1, of each block of ``step`` pixels whose surface is one of ``classes``.

        Args:
            classes: Values of ``Surface``.
            step: Pixels of a block's side.

        Raises:
            ValueError: The size is no multiple of ``step``.
        """
        return shrink(np.isin(self.surface, classes).astype(np.float32), step)
