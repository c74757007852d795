"""Two budgets of light: faces at their target by their own keys, the frame by a small trim (notes 1.2)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from storyblender.look.gbuffer import GBuffer
from storyblender.look.illumination import LightField
from storyblender.look.raster import LUMA, Image, Mask, luminance
from storyblender.look.surface import Surface

_HEAD_RADIUS = 0.17
"""Metres round the face's centre within which skin counts as face, for a person of scale 1."""
_FEWEST_PIXELS = 12
_KEY_GAIN = (0.35, 2.0)
_FILL_GAIN = (0.2, 3.0)
_SHADED = 0.45
"""Share of the target that the shaded side of a face has, by its fill: in profile that side is what is seen."""
_LIT_ENOUGH, _LEAST_KEY = 1.3, 0.08
_SET_ON_FACES, _LEAST_SET_LAMP = 0.8, 0.3
"""Lamps of the set may bring a face to this share of its target, and are dimmed to no less than this otherwise."""
"""Keys and fills are scaled within these. A key beyond 2x turns clothes to chalk before it lights a visor's shade; a
face without any key is flat, so where the set just lights it enough, the trim takes the rest; in the sun it may go."""
_TRIM = (-1.5, 0.8)
"""Stops by which a frame may be darkened or brightened as a whole; a burnt face is worse than a dark room."""
_READABLE, _LIFT, _SHADOW = 0.05, 2.5, 0.08
"""Least geometric mean of a frame, most stops its shadows are raised, and the luminance that counts as half shadow: a
board is read on paper, and a night without lamps is drawn dark, not black."""
_DARKER, _BRIGHTER = 0.85, 2.4
"""Faces between these multiples of the target are left alone: in the sun they may be brighter than in the shade."""
_PASSES = 3


@dataclass(frozen=True)
class Face:
    """A face in the picture.

    Attributes:
        asset_id: Whose.
        mask: (h, w) its visible skin.
    """

    asset_id: str
    mask: Mask


def find_faces(gbuffer: GBuffer, heads: Sequence[tuple[str, Sequence[float], float]]) -> tuple[Face, ...]:
    """Return the visible faces.

    Args:
        gbuffer: At the resolution of the light.
        heads: asset_id, centre of the face in world metres, and scale of each person.
    """
    skin = gbuffer.surface == Surface.SKIN
    positions = gbuffer.positions()
    faces = []
    for asset_id, center, scale in heads:
        offset = positions - np.asarray(center, np.float32)
        mask = skin & (np.einsum("hwc,hwc->hw", offset, offset) < (_HEAD_RADIUS * scale) ** 2)
        if int(mask.sum()) >= _FEWEST_PIXELS:
            faces.append(Face(asset_id, mask))
    return tuple(faces)


def bright_half(values: NDArray) -> float:
    """Return the mean of the brighter half: the lit side of a face."""
    return float(values[values >= np.median(values)].mean())


def solve_faces(
    fields: Sequence[LightField], ambient: Image, albedo: Image, faces: Sequence[Face], target: float
) -> tuple[LightField, ...]:
    """Scale each person's key, then fill, so that the lit side of the face has the target luminance, the other enough.

    The light is linear, so a face is set light + gain * its own key; a few sweeps settle the spill between people.

    Args:
        fields: Every lamp of the shot, with its shadows.
        ambient: (h, w, 3) light from all sides.
        albedo: (h, w, 3).
        faces: Visible faces.
        target: Scene-linear luminance.

    Returns:
        The fields in the same order, keys, fills and rims scaled.
    """
    solved = list(fields)
    for _ in range(_PASSES):
        for face in faces:
            shade = albedo[face.mask]
            for role, (least, most) in (("key", _KEY_GAIN), ("fill", _FILL_GAIN)):
                own = [i for i, f in enumerate(solved) if f.light.role == role and f.light.for_asset == face.asset_id]
                start = [i for i in own if fields[i].light.power > 0]
                if not start:
                    continue
                here = _luminance_at(solved, ambient, shade, face.mask)
                its = _luminance_at([solved[i] for i in start], None, shade, face.mask)
                others = here - its
                gain = _gain(others, its, target)
                if role == "fill":
                    gain = max(gain, _shade_gain(others, its, _SHADED * target))
                if role == "key" and bright_half(others) > _LIT_ENOUGH * target:
                    least = _LEAST_KEY
                for i in start:
                    so_far = solved[i].light.power / fields[i].light.power
                    solved[i] = fields[i].scaled(float(np.clip(gain * so_far, least, most)))
    return tuple(_with_rims(solved, fields))


def dim_set_lamps(
    fields: Sequence[LightField], ambient: Image, albedo: Image, faces: Sequence[Face], target: float
) -> tuple[LightField, ...]:
    """Dim the lamps of the set that alone would burn a face out, as a gaffer flags a practical; never the sun.

    Arguments as for ``solve_faces``.
    """
    dimmed = list(fields)
    for face in faces:
        shade = albedo[face.mask]
        of_set = [index for index, field in enumerate(dimmed) if field.light.for_asset is None]
        level = bright_half(_luminance_at([dimmed[i] for i in of_set], ambient, shade, face.mask))
        lamps = [i for i in of_set if dimmed[i].light.kind != "SUN"]
        given = {i: bright_half(_luminance_at([dimmed[i]], None, shade, face.mask)) for i in lamps}
        strong = [i for i in lamps if given[i] > 0.1 * level]
        surplus = level - _SET_ON_FACES * target
        if surplus <= 0 or not strong:
            continue
        gain = max(_LEAST_SET_LAMP, 1 - surplus / sum(given[i] for i in strong))
        for i in strong:
            dimmed[i] = dimmed[i].scaled(gain)
    return tuple(dimmed)


def _with_rims(solved: Sequence[LightField], fields: Sequence[LightField]) -> list[LightField]:
    """Dim rims with their keys where keys were dimmed: the ratio between them is what was designed."""
    gains = {
        after.light.for_asset: after.light.power / before.light.power
        for after, before in zip(solved, fields, strict=True)
        if after.light.role == "key" and before.light.power > 0
    }
    return [
        field.scaled(float(np.clip(gains.get(field.light.for_asset, 1.0), 0.5, 1.0)))
        if field.light.role == "rim"
        else field
        for field in solved
    ]


def _gain(others: NDArray, own: NDArray, target: float) -> float:
    """Return g so that bright_half(others + g * own) is the target; three secant steps on a monotone function."""
    gain = 1.0
    for _ in range(3):
        level = bright_half(others + gain * own)
        slope = max(bright_half(others + (gain + 0.1) * own) - level, 1e-6) / 0.1
        gain = max(gain + (target - level) / slope, 0.0)
    return gain


def _shade_gain(others: NDArray, own: NDArray, least: float) -> float:
    """Return g so that the darker half of a face has at least a luminance on average: its features are seen."""
    dark = others <= np.median(others)
    return (least - float(others[dark].mean())) / max(float(own[dark].mean()), 1e-6)


def _luminance_at(fields: Sequence[LightField], ambient: Image | None, shade: Image, mask: Mask) -> NDArray:
    light = np.zeros_like(shade) if ambient is None else ambient[mask]
    for field in fields:
        light = light + field.amount[mask][:, None] * np.asarray(field.light.color, np.float32)
    return (light * shade) @ LUMA


def trim(picture: Image, faces: Sequence[Face], target: float, set_target: float) -> float:
    """Return the exposure in stops that brings faces to their target, or without faces the frame to its level.

    Args:
        picture: Linear, with its air.
        faces: At the picture's size.
        target: Wanted luminance of the lit side of faces.
        set_target: Wanted geometric mean of a frame without faces.
    """
    light = luminance(picture)
    if faces:
        weights = [math.sqrt(int(face.mask.sum())) for face in faces]
        levels = [math.log2(bright_half(light[face.mask]) + 1e-5) for face in faces]
        level = float(np.average(levels, weights=weights)) - math.log2(target)
        stops = float(np.clip(level, math.log2(_DARKER), math.log2(_BRIGHTER))) - level
    else:
        # Half the way: an insert of something dark should stay darker than an insert of something bright.
        stops = (math.log2(set_target) - math.log2(geometric_mean(light))) / 2
    return float(np.clip(stops, *_TRIM))


def shadow_lift(picture: Image) -> float:
    """Return the stops by which the shadows of a picture are raised so that it can be read: 0 where it can.

    Args:
        picture: Linear, exposed.
    """
    steps = (step * _LIFT / 10 for step in range(10))
    raised = ((stops, luminance(with_shadows_raised(picture, stops))) for stops in steps)
    return next((stops for stops, light in raised if geometric_mean(light) >= _READABLE), _LIFT)


def with_shadows_raised(picture: Image, stops: float) -> Image:
    """Return a linear picture with its shadows raised by stops; what is bright stays as it is."""
    if stops <= 0:
        return picture
    dark = 1 / (1 + (luminance(picture) / _SHADOW) ** 2)
    return picture * np.exp2(np.float32(stops) * dark)[..., None]


def geometric_mean(light: NDArray) -> float:
    """Return the mean brightness as the eye counts it."""
    return float(np.exp(np.log(np.maximum(light, 0) + 1e-4).mean()))
