"""Ink lines from ids, depth and normals, never from colour (rules and figures: notes, sets and light, section 2).

Four kinds of line: outlines where one thing stands before another, steps within a thing, seams between materials,
creases. Thresholds are in pixels per metre of a picture 540 rows high, so every size is drawn alike.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from storyblender.look.gbuffer import GBuffer, View
from storyblender.look.raster import Image, Mask, blur, luminance, shrink, spread
from storyblender.look.surface import FLESH, PERSON, Surface

_BAND = 240
_MARGIN = 6
"""Rows drawn at a time and rows of overlap, more than the widest line; keeps the temporaries small."""
_ROWS = 540
_DARK_INK = np.array([0.03, 0.025, 0.03], np.float32)
_LIGHT_INK = np.array([0.27, 0.30, 0.34], np.float32)
_LIGHT_STRENGTH = 0.3
"""How much of a line stays where it turns light: it parts a figure from the dark, it does not draw it in chalk."""
_SIDE_PRESS, _TURN_PRESS = 0.8, 0.4
"""Width of a line on an upright side, and how much thinner it is on top and heavier underneath."""
_OUTLINE_JUMP = 0.025
"""Depth jump, as a share of the nearer depth, that makes an outline; below it two things touch."""
_FOLIAGE_JUMP = 0.25
_STEP = 0.012
_SMALL = 90
"""Things that cover fewer pixels (at 1080 rows) get no contact lines: clutter would become a blot."""
_CROWD_RADIUS = 3
_CROWDED = 0.34


@dataclass(frozen=True)
class _Strip:
    """The rows of the G-buffer that are drawn at one time, in the types the rules want."""

    ids: NDArray[np.uint16]
    surface: NDArray[np.uint8]
    material: NDArray[np.uint16]
    depth: NDArray[np.float32]
    normal: NDArray[np.float32]
    small: Mask
    scale: float
    """Pixels per metre at one metre, for a picture of 540 rows."""

    def __getitem__(self, window: tuple[slice, slice]) -> _Strip:
        return _Strip(
            self.ids[window],
            self.surface[window],
            self.material[window],
            self.depth[window],
            self.normal[window],
            self.small[window],
            self.scale,
        )


@dataclass(frozen=True)
class _Strokes:
    """Pixels a line starts from, by kind."""

    outline: Mask
    step: Mask
    seam: Mask
    crease: Mask


def draw_ink(gbuffer: GBuffer, step: int, through_air: Image) -> Image:
    """Return the darkness of the ink, 0 to 1, at the picture's size.

    Args:
        gbuffer: Supersampled.
        step: Supersampling factor.
        through_air: (h / step, w / step) share of light that comes through the fog; lines fade with it.
    """
    height, width = gbuffer.depth.shape
    counts = np.bincount(gbuffer.ids.ravel(), minlength=int(gbuffer.ids.max()) + 1)
    small_ids = counts < _SMALL * (height / 1080) ** 2
    scale = gbuffer.view.pixels_per_metre * _ROWS / height
    outline = np.empty((height // step, width // step), np.float32)
    interior = np.empty_like(outline)
    band = _BAND // step * step
    margin = -(-_MARGIN // step) * step
    for top in range(0, height, band):
        first, last = max(0, top - margin), min(height, top + band + margin)
        rows = slice(first, last)
        strip = _Strip(
            gbuffer.ids[rows],
            gbuffer.surface[rows],
            gbuffer.material[rows],
            gbuffer.depth[rows],
            gbuffer.normal[rows].astype(np.float32),
            small_ids[gbuffer.ids[rows]],
            scale,
        )
        bold, fine = _draw_strip(strip, height / 1080)
        inner = slice((top - first) // step, (min(height, top + band) - first) // step)
        target = slice(top // step, min(height, top + band) // step)
        outline[target] = shrink(bold, step)[inner]
        interior[target] = shrink(fine, step)[inner]
    crowd = blur(np.minimum(interior * 2, 1), _CROWD_RADIUS)
    interior *= np.clip(1.5 - crowd / _CROWDED, 0.12, 1)
    return np.maximum(outline * through_air**0.8, interior * through_air)


def apply_ink(display: Image, ink: Image, people: Image, strength: float) -> Image:
    """Lay ink over a display picture; on dark grounds the lines of people turn light, so night scenes stay readable.

    Args:
        display: 0 to 1.
        ink: Darkness, 0 to 1.
        people: (h, w) share of the neighbourhood that is people.
        strength: 0 to 1.
    """
    ground = blur(luminance(display), max(1, round(4 * display.shape[0] / _ROWS)))
    night = np.clip((0.13 - ground) / 0.08, 0, 1) * people
    color = _DARK_INK * (1 - night[..., None]) + _LIGHT_INK * night[..., None]
    cover = (strength * ink * (1 - (1 - _LIGHT_STRENGTH) * night))[..., None]
    return display * (1 - cover) + color * cover


def add_lines(picture: Image, depth: Image, view: View) -> Image:
    """Draw simple outlines on a moving frame: where depth jumps, on the nearer side; heavier on what is near.

    Args:
        picture: (h, w, 3) linear.
        depth: (h, w) metres.
        view: The camera, at this size.
    """
    at = np.zeros(depth.shape, bool)
    at.flat[np.concatenate([_outlined(depth, axis) for axis in (0, 1)])] = True
    lines, near_lines = np.flatnonzero(at), np.flatnonzero(spread(at))
    per_metre = view.pixels_per_metre * _ROWS / view.height / np.minimum(depth.take(lines), 1e3)
    strength = np.clip(per_metre / 110, 0, 0.85).astype(np.float32)
    drawn = np.moveaxis(picture, 2, 0).copy()
    for plane, ink in zip(drawn.reshape(3, -1), _DARK_INK * np.float32(0.3), strict=True):
        ground = plane.take(lines)
        plane[lines] = ground + (ink - ground) * strength
        # The frame comes without antialiasing: soften it along its lines.
        plane[near_lines] = (
            plane.take(near_lines) + _mean_around(plane, near_lines, depth.shape[0], depth.shape[1])
        ) / 2
    return np.moveaxis(drawn, 0, 2)


def _outlined(depth: Image, axis: int) -> NDArray[np.intp]:
    """Return the nearer pixels, numbered row by row, of those between which an outline runs along ``axis``."""
    here, there = _neighbours(axis)
    jump = np.abs(depth[here] - depth[there]) > _OUTLINE_JUMP * 1.6 * np.minimum(depth[here], depth[there])
    jump[: 1 if axis == 0 else None, : 1 if axis == 1 else None] = False  # no pixel before it tells how the depth bends
    rows, columns = np.nonzero(jump)
    step = depth.shape[1] if axis == 0 else 1
    places = rows * depth.shape[1] + columns
    before, own, after = (depth.take(places + shift) for shift in (-step, 0, step))
    bend = np.abs(1 / before - 2 / own + 1 / after) * np.minimum(own, after)
    return np.where(own <= after, places, places + step)[bend > _OUTLINE_JUMP]


def _mean_around(plane: Image, places: NDArray[np.intp], height: int, width: int) -> Image:
    """Return the mean of the nine pixels round each place, all numbered row by row; edges repeat."""
    rows, columns = np.divmod(places, width)
    above, below = places - width * (rows > 0), places + width * (rows < height - 1)
    left, right = -(columns > 0).astype(np.intp), (columns < width - 1).astype(np.intp)
    total = np.zeros(len(places), np.float32)
    for row in (above, places, below):
        total += plane.take(row + left) + plane.take(row) + plane.take(row + right)
    return total / np.float32(9)


def people_nearby(gbuffer: GBuffer, step: int) -> Image:
    """Return how much the lines of each pixel belong to people, 0.25 to 1, at the picture's size.

    Args:
        gbuffer: Supersampled.
        step: Supersampling factor.
    """
    return np.clip(blur(gbuffer.coverage(PERSON, step), 2) * 2.5, 0.25, 1)


def _draw_strip(strip: _Strip, size: float) -> tuple[Image, Image]:
    """Return outlines and interior lines of a strip, 0 to 1, supersampled.

    Args:
        strip: Rows to draw.
        size: Supersampled rows of the whole picture / 1080; widths grow with it.
    """
    strokes = _find_strokes(strip)
    per_metre = strip.scale / np.minimum(strip.depth, 1e3)
    person = np.isin(strip.surface, PERSON)
    press = np.where(person, np.float32(1.25), np.float32(0.85)) * (_SIDE_PRESS - _TURN_PRESS * strip.normal[..., 2])
    width = np.clip(per_metre / 150, 0, 3) * press * size + (size - 1)
    bold = np.where(strokes.outline, np.float32(0.95), np.float32(0))
    bold = _thicken(bold, width, at=(0.45, 1.5, 2.6, 3.7))
    bold *= np.where(person, np.clip(np.maximum(per_metre / 40, 0.9), 0, 1), np.clip(per_metre / 40, 0.25, 1))
    fine = np.where(strokes.step, np.float32(0.8), np.float32(0))
    fine = _thicken(fine, width, at=(1.0, 2.4))
    fine = np.maximum(fine, np.where(strokes.seam | strokes.crease, np.float32(0.6), np.float32(0)))
    fine *= np.clip(per_metre / 90, 0, 1)
    flesh = np.isin(strip.surface, FLESH)
    fine *= np.where(flesh, np.clip((per_metre - 120) / 400, 0, 0.7), np.float32(1))
    return bold.astype(np.float32), fine.astype(np.float32)


def _thicken(line: Image, width: Image, at: tuple[float, ...]) -> Image:
    """Grow a line by a pixel for each of the widths in ``at`` that its wanted width exceeds."""
    wanted = np.where(line > 0, width, np.float32(0))
    for threshold in at:
        if not (wanted > threshold).any():
            break
        wanted, grown = spread(wanted), spread(line)
        line = np.maximum(line, np.where(wanted > threshold, grown, np.float32(0)))
    return line


def _find_strokes(strip: _Strip) -> _Strokes:
    """Compare every pixel with its right and its lower neighbour; a line belongs to the nearer of the two."""
    found = _Strokes(*(np.zeros(strip.ids.shape, bool) for _ in range(4)))
    for axis in (0, 1):
        here, there = _neighbours(axis)
        near_here = strip.depth[here] <= strip.depth[there]
        edges = _edges(strip[here], strip[there], near_here, _bend(strip.depth, axis))
        for drawn, edge in zip((found.outline, found.step, found.seam, found.crease), edges, strict=True):
            drawn[here] |= edge & near_here
            drawn[there] |= edge & ~near_here
    return found


def _neighbours(axis: int) -> tuple[tuple[slice, slice], tuple[slice, slice]]:
    """Return the windows that pair every pixel with the next one along ``axis``."""
    first, second, everything = slice(None, -1), slice(1, None), slice(None)
    return ((first, everything), (second, everything)) if axis == 0 else ((everything, first), (everything, second))


def _bend(depth: Image, axis: int) -> Image:
    """Return the second difference of 1 / depth over 1 / depth: exactly zero on a plane, however it recedes."""
    inverse = 1 / depth
    bend = np.zeros_like(np.diff(depth, axis=axis))
    second = np.abs(np.diff(inverse, n=2, axis=axis))
    if axis == 0:
        bend[1:] = second * np.minimum(depth[1:-1], depth[2:])
    else:
        bend[:, 1:] = second * np.minimum(depth[:, 1:-1], depth[:, 2:])
    return bend


def _edges(a: _Strip, b: _Strip, near_a: Mask, bend: Image) -> tuple[Mask, Mask, Mask, Mask]:
    """Return where outline, step, seam and crease run between neighbours ``a`` and ``b``."""
    depth = np.minimum(a.depth, b.depth)
    nearer = np.where(near_a, a.surface, b.surface)
    jump = np.abs(a.depth - b.depth) / depth
    per_metre = a.scale / depth
    facing = np.einsum("hwc,hwc->hw", a.normal, b.normal)
    other = a.ids != b.ids
    leaves = (a.surface == Surface.FOLIAGE) & (b.surface == Surface.FOLIAGE)
    cards = (a.surface == Surface.CARD) & (b.surface == Surface.CARD)
    flesh = np.isin(a.surface, FLESH) & np.isin(b.surface, FLESH)
    bare = (a.surface == Surface.NO_INK) | (b.surface == Surface.NO_INK)
    firm = (nearer != Surface.FOLIAGE) & ~cards

    outline = other & (jump > _OUTLINE_JUMP) & ~(leaves & (jump < _FOLIAGE_JUMP)) & ~cards
    outline &= nearer != Surface.NO_INK
    contact = other & (jump <= _OUTLINE_JUMP) & ~leaves & ~cards & ~a.small & ~b.small & ~bare
    within = ~other & (bend > _STEP) & (jump > _STEP) & firm & ~((nearer == Surface.SKIN) & (per_metre < 170))
    seam = (a.material != b.material) & ~other & (per_metre > 55) & ~flesh & firm
    crease = ~other & (facing < 0.80) & (per_metre > 38) & firm
    crease &= ~np.isin(nearer, (*FLESH, Surface.HAIR, Surface.NO_INK))
    crease &= ~((nearer == Surface.CLOTH) & ((facing > 0.45) | (per_metre < 150)))
    return outline, within & ~bare | contact, seam & ~bare, crease
