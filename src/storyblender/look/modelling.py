"""The light on faces and hands: the form that coarse light loses, and hands no darker than one person's skin can be.

Light at a quarter of the picture, denoised, loses noses and lips. What key, fill and rim make of a place is known
without tracing; over its surroundings it says how much lighter or darker the place is than the coarse light has it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from storyblender.look.exposure import bright_half
from storyblender.look.gbuffer import GBuffer
from storyblender.look.illumination import light_field
from storyblender.look.raster import LUMA, Image, Mask, blur, every, luminance
from storyblender.look.surface import Surface
from storyblender.memory.scene_context import Light

_ROWS = 540
"""Rows of a picture in which ``_REACH`` counts."""
_REACH = 7
"""Pixels over which the coarse light has lost the form."""
_AROUND = 0.5
"""Light from all other sides, as a share of what these lamps give on average; it softens the form."""
_DARKEST, _LIGHTEST = 0.6, 1.35
_SHADED, _LIFT, _MOST = 0.55, 0.8, 3.0
"""Skin with less than this share of its face's light is lifted by this share of the stops it lacks, up to a factor."""


@dataclass(frozen=True)
class Flesh:
    """The visible skin of a person.

    Attributes:
        skin: (h, w) all of it.
        face: (h, w) its face; nothing where that is turned away.
    """

    skin: Mask
    face: Mask


def lift_hands(light: Image, people: Sequence[Flesh]) -> None:
    """Lighten hands and arms that get much less light than faces do, in place: else they look like another's skin.

    A person's key and fill are solved for the face alone, which is a stop or two above what the hands get.

    Args:
        light: (h, w, 3) illumination.
        people: Whose face is turned away is measured by the others'.
    """
    levels = [bright_half(luminance(light[flesh.face])) if flesh.face.any() else None for flesh in people]
    known = [level for level in levels if level is not None]
    for flesh, level in zip(people, levels, strict=True):
        if known:
            enough = _SHADED * (float(np.mean(known)) if level is None else level)
            given = np.maximum(luminance(light[flesh.skin]), 1e-6)
            light[flesh.skin] *= np.clip((enough / given) ** _LIFT, 1, _MOST)[:, None]


def model_flesh(light: Image, gbuffer: GBuffer, lamps: Sequence[Light]) -> None:
    """Give skin the form that these lamps show of it, in place.

    Args:
        light: (h, w, 3) illumination, enlarged from few pixels.
        gbuffer: Its height and width multiples of h and w.
        lamps: Key, fill and rim of everyone in the shot.
    """
    step = gbuffer.view.height // light.shape[0]
    skin = every(gbuffer.surface, step) == Surface.SKIN
    if not lamps or not skin.any():
        return
    rows, columns = np.nonzero(skin)
    sampled = rows * step + step // 2, columns * step + step // 2
    x, y = gbuffer.view.slopes()
    rays = np.stack([x[sampled[1]], y[sampled[0]], np.full(len(rows), -1, np.float32)], axis=1)
    places = (rays * gbuffer.depth[sampled][:, None]) @ gbuffer.view.axes.T + gbuffer.view.eye
    places, normal = places.astype(np.float32)[None], gbuffer.normal[sampled].astype(np.float32)[None]
    given = np.zeros(len(rows), np.float32)
    for lamp in lamps:
        given += light_field(lamp, places, normal).amount[0] * np.float32(LUMA @ np.asarray(lamp.color, np.float32))
    part = slice(rows.min(), rows.max() + 1), slice(columns.min(), columns.max() + 1)
    shown = np.zeros(skin.shape, np.float32)
    shown[skin] = given
    reach = max(1, round(_REACH * light.shape[0] / _ROWS))
    around = blur(shown[part], reach) / np.maximum(blur(skin[part].astype(np.float32), reach), 1e-3)
    even = np.float32(_AROUND * given.mean() + 1e-6)
    form = (given + even) / (around[skin[part]] + even)
    light[skin] *= np.clip(form, _DARKEST, _LIGHTEST)[:, None]
