"""What is out of focus, blurred: discs as large as the circle of confusion, layer over layer from back to front.

The picture is cut into layers by the size and side of its circle of confusion, each pixel shared between the two that
are nearest. A layer is blurred by its own disc without what is nearer, so that nothing sharp bleeds into a blurred
background; what is nearer then covers it, and what is blurred in the foreground spreads over what is sharp behind it
(after Kraus and Strengert, Depth-of-field rendering by pyramidal image processing, 2007, section 3).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from PIL import Image as Picture
from PIL.Image import Resampling

from storyblender.look.optics import Lens
from storyblender.look.raster import Image, Mask, Window, shrink, spread

_RADII = (0.0, 0.7, 1.2, 1.8, 2.6, 3.7, 5.2, 7.4, 10.5, 15.0, 21.0, 30.0, 42.0, 60.0, 85.0, 120.0)
"""Radii in pixels of the discs of the layers: half as large again from step to step, so that none is seen."""
_FINE = 5.0
"""Radius in pixels from which a layer is blurred at half the size, and at twice that at a quarter."""
_BRIGHTEST = 24.0
"""Scene-linear light beyond which a highlight does not grow in its disc."""
_WIDEST_LINE = 2
"""Pixels from the edge of a thing over which its outline reaches."""
_GLOW, _DIFFUSION, _HALO = 0.018, 0.4, 0.25
"""Diffusion filter: radius of its glow in picture heights, share of the picture that it spreads, light that it adds."""
_NOTHING = 1e-4
"""Share of a disc below which nothing is known there."""
SMALLEST = 0.45
"""Radius in pixels of a blur that nobody sees."""


def level_of(radius: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the place among the layers of signed radii in pixels; a whole number at a layer's own radius."""
    places = np.interp(np.abs(radius), _RADII, np.arange(len(_RADII), dtype=np.float32))
    return np.copysign(places, radius).astype(np.float32)


def blurred_frame(
    surfaces: Image, lines: Image | None, depth: Image, lens: Lens, step: int
) -> tuple[Image, Image | None]:
    """Return a frame as the lens sees it: what lies on its surfaces, and its lines.

    Args:
        surfaces: (h, w, c) scene-linear light, and masks.
        lines: (h, w) ink, 0 to 1; it belongs to the nearer of the surfaces that it parts. None where there is none.
        depth: (h * step, w * step) metres along the optical axis.
        lens: As it is set.
        step: Supersampling of the depth.
    """
    pixels = np.float32(surfaces.shape[1] / 2)
    out = blurred(surfaces, lens.blur_circle(depth) * pixels, step)
    if lines is None:
        return out, None
    nearest = lens.blur_circle(nearest_round(depth, _WIDEST_LINE * step)) * pixels
    return out, blurred(lines[..., None], nearest, step)[..., 0]


def diffused(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return an (h, w, 3) display picture as through a diffusion filter: soft focus, with a glow round what is bright.

    Args:
        pixels: sRGB.
    """
    light = (pixels.astype(np.float32) / 255) ** np.float32(2.2)
    radius = _GLOW * pixels.shape[0]
    glow = disc_blur(disc_blur(light, radius), radius)
    soft = light + _DIFFUSION * (glow - light) + _HALO * glow * glow
    return (np.clip(soft, 0, 1) ** np.float32(1 / 2.2) * 255 + 0.5).astype(np.uint8)


def nearest_round(depth: Image, pixels: int) -> Image:
    """Return the smallest depth near each pixel: a line drawn round a thing belongs to the thing.

    Args:
        depth: (h, w) metres along the optical axis.
        pixels: Reach, rows and columns counted together.
    """
    nearest = -depth
    for _ in range(pixels):
        nearest = spread(nearest)
    return -nearest


def blurred(planes: Image, radius: NDArray[np.float32], step: int = 1) -> Image:
    """Return a picture with each pixel spread over the disc of its circle of confusion.

    Args:
        planes: (h, w, c) scene-linear light, or anything else that lies on the surfaces.
        radius: (h * step, w * step) of the circle in pixels of ``planes``; negative in front of what is in focus.
        step: Supersampling of the radii, so that edges stay smooth.
    """
    if np.abs(radius).max() < SMALLEST:
        return planes
    level = level_of(radius)
    layers = [
        (number, share)
        for number in range(math.floor(float(level.min())), math.ceil(float(level.max())) + 1)
        if (share := shrink(np.maximum(1 - np.abs(level - number), 0), step)).any()
    ]
    light = np.minimum(planes, _BRIGHTEST)
    result = np.zeros_like(light)
    behind = np.zeros(light.shape[:2], np.float32)
    for number, share in sorted(layers, reverse=True, key=lambda layer: layer[0]):
        behind = behind + share
        disc = _RADII[abs(number)]
        if number < 0:
            result = _filled(result, behind - share, disc)
        result = _laid_over(result, light, share, behind, disc)
    return result


def _laid_over(result: Image, light: Image, share: Image, behind: Image, disc: float) -> Image:
    """Return what lies behind with one layer over it.

    Args:
        result: (h, w, c) all that is farther.
        light: (h, w, c) the sharp picture.
        share: (h, w) of each pixel that belongs to the layer.
        behind: (h, w) share of each pixel that belongs to it or is farther.
        disc: Radius of its blur, pixels.
    """
    here = _reached(share > 0, disc).cut
    own = share[here][..., None]
    if disc <= 0:
        cover = own / np.maximum(behind[here][..., None], _NOTHING)
        result[here] += (light[here] - result[here]) * cover
        return result
    weight = own * own  # a pixel on an edge has the colours of both sides: it tells little of either
    out = disc_blur(np.concatenate([light[here] * weight, weight, own, behind[here][..., None]], axis=2), disc)
    color, weight, own, seen = out[..., :-3], out[..., -3:-2], out[..., -2:-1], out[..., -1:]
    cover = np.clip(own / np.maximum(seen, _NOTHING), 0, 1)
    result[here] += (color / np.maximum(weight, _NOTHING**2) - result[here]) * cover
    return result


def _filled(result: Image, known: Image, disc: float) -> Image:
    """Return a picture with what the foreground hides guessed from what is round it.

    Args:
        result: (h, w, c).
        known: (h, w) share of each pixel that the foreground leaves free.
        disc: Radius of the foreground's blur, pixels: as far as what is behind it will show.
    """
    hidden = known < 1 - _NOTHING
    if not hidden.any():
        return result
    here = _reached(hidden, disc).cut
    weight = known[here][..., None]
    around = disc_blur(np.concatenate([result[here] * weight, weight], axis=2), max(disc, 1.0))
    guess = around[..., :-1] / np.maximum(around[..., -1:], _NOTHING)
    result[here] = result[here] * weight + guess * (1 - weight)
    return result


def _reached(mask: Mask, disc: float) -> Window:
    """Return the part of the picture that a blur of a mask depends on."""
    height, width = mask.shape
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    room = 2 * math.ceil(disc) + 2
    return Window(
        max(0, int(rows[0]) - room),
        max(0, int(columns[0]) - room),
        min(height, int(rows[-1]) + 1 + room),
        min(width, int(columns[-1]) + 1 + room),
    )


def disc_blur(planes: Image, radius: float) -> Image:
    """Return the mean of each plane over a disc round every pixel; outside the picture is nothing.

    Args:
        planes: (h, w, c).
        radius: Pixels; large discs are laid over a smaller picture, which nobody sees in what is so blurred.
    """
    if radius <= 0:
        return planes
    halvings = 0 if radius < _FINE else 1 if radius < 2 * _FINE else 2
    step = 2**halvings
    height, width = planes.shape[:2]
    padded = np.pad(planes, ((0, -height % step), (0, -width % step), (0, 0)))
    small = _disc_mean(np.ascontiguousarray(np.moveaxis(shrink(padded, step), 2, 0)), radius / step)
    if step > 1:
        size = padded.shape[1], padded.shape[0]
        small = np.stack([np.asarray(Picture.fromarray(plane).resize(size, Resampling.BILINEAR)) for plane in small])
    return np.moveaxis(small[:, :height, :width], 0, 2)


def _disc_mean(planes: Image, radius: float) -> Image:
    """Return the mean over a disc, row by row of the disc as differences of running sums; (c, h, w) planes."""
    reach = math.ceil(radius + 0.5) - 1
    chords = [_chord(radius, row) for row in range(reach + 1)]
    side = math.ceil(radius) + 1
    padded = np.pad(planes, ((0, 0), (reach, reach), (side, side)))
    sums = np.pad(np.cumsum(padded, axis=2, dtype=np.float32), ((0, 0), (0, 0), (1, 0)))
    height, width = planes.shape[1:]
    total = np.zeros_like(planes)
    for row in range(-reach, reach + 1):
        chord = chords[abs(row)]
        lines = slice(reach + row, reach + row + height)
        if chord < 1:
            total += np.float32(chord) * padded[:, lines, side : side + width]
            continue
        whole = int((chord - 1) / 2)
        first, last = side - whole, side + whole + 1
        total += sums[:, lines, last : last + width] - sums[:, lines, first : first + width]
        ends = padded[:, lines, first - 1 : first - 1 + width] + padded[:, lines, last : last + width]
        total += np.float32((chord - 1) / 2 - whole) * ends
    return total / np.float32(chords[0] + 2 * sum(chords[1:]))


def _chord(radius: float, row: int) -> float:
    """Return how wide a disc is in a row of pixels beside its middle, in the mean over the row's height."""
    heights = np.linspace(row - 0.45, row + 0.45, 10)
    return float(2 * np.sqrt(np.maximum(radius**2 - heights**2, 0)).mean())
