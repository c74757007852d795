"""The skin: the visible body with its painted complexion and the face's shape keys."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from storyblender.blender.people import mouth
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.pack import BodyPack, to_scene
from storyblender.blender.people.scalp import above_hairline
from storyblender.blender.people.sheet import Sheet
from storyblender.catalog.bodies import Complexion
from storyblender.catalog.expressions import FACE_UNITS
from storyblender.catalog.hair import hairstyle
from storyblender.geometry.solids import Floats
from storyblender.memory.asset_sheet import CharacterLook


def expression_offsets(pack: BodyPack) -> dict[str, Floats]:
    """Return the offsets of each shape key for the whole base mesh, (V, 3) metres in Blender's axes."""
    return {
        key: to_scene(pack.displacement({f"expression/units/caucasian/{unit}": w for unit, w in units.items()}))
        for key, units in FACE_UNITS.items()
    }


def shape_keys_of(sheet: Sheet, every: Mapping[str, Floats]) -> dict[str, Floats]:
    """Return the shape keys of a sheet: offsets (V, 3) of its vertices, metres.

    Args:
        sheet: A part of the base mesh, without cuts.
        every: Offsets of each key for the whole base mesh, (V, 3) metres.
    """
    return {key: offsets[sheet.source] for key, offsets in every.items()}


def whisker_growth(base: Floats) -> Floats:
    """Return how far points of the base mesh lie inside the region where a beard grows, decimetres."""
    x, y, depth = np.abs(base[:, 0]), base[:, 1], base[:, 2]
    cheek = np.interp(x, (0.0, 0.25, 0.38, 0.55, 0.70, 0.82), (6.815, 6.80, 6.74, 6.72, 6.84, 7.10))
    lips = 0.12 * (np.hypot(x / 0.285, (y - 6.605) / 0.115) - 1)
    return np.minimum.reduce([cheek - y, lips, depth - 0.42, y - 6.08])


def paint_skin(figure: BodyFigure, sheet: Sheet, colors: Complexion, look: CharacterLook) -> Floats:
    """Return the vertex colours (V, 3): tone, blood in cheeks, nose and ears, lips, mouth, eye sockets, stubble, age.

    Args:
        figure: The body.
        sheet: Its skin, uncut.
        colors: The person's colours.
        look: Gives age, hairline and stubble.
    """
    base = sheet.base
    paint = np.tile(np.array(colors.skin), (len(base), 1))
    flush = np.array((1.12, 0.80, 0.78))
    shade = np.array((0.72, 0.58, 0.56))

    def spot(x: float, y: float, z: float, size: float) -> Floats:
        distance = (np.abs(base[:, 0]) - x) ** 2 + (base[:, 1] - y) ** 2 + (base[:, 2] - z) ** 2
        return np.exp(-distance / size**2)[:, None]

    ears = figure.pack.ears[sheet.source][:, None]
    for strength, where in ((0.55, spot(0.55, 6.95, 1.2, 0.28)), (0.4, spot(0, 7.0, 1.7, 0.18)), (0.3, ears)):
        paint *= 1 + strength * where * (flush - 1)
    old = float(np.interp(look.age, (40, 80), (0, 1)))
    folds = spot(0.42, 6.75, 1.35, 0.13) + spot(0.36, 7.13, 1.38, 0.10) + spot(0.62, 7.28, 1.15, 0.10)
    for strength, where in ((0.28, spot(0.31, 7.30, 1.35, 0.16)), (0.4 * old, folds)):
        paint *= 1 + strength * where * (shade - 1)
    lips = figure.pack.lips[sheet.source] * (base[:, 1] > 6.4) * (base[:, 1] < 7) * (base[:, 2] > 0.9)
    shadow_of = {"stubble": 0.55, "beard": 0.5, "moustache": 0.12}.get(look.facial_hair, 0.0)
    beard = (np.clip(whisker_growth(base) / 0.10 + 0.3, 0, 1) * (1 - lips) * shadow_of)[:, None]
    style = hairstyle(look.hair)
    if style.top or style.side:
        over = above_hairline(base, style, float(look.gender == "male"))
        shadow = (0.55 * np.exp(np.minimum(over, 0) / 0.05) * ~figure.pack.ears[sheet.source] * (base[:, 1] > 6.5))[
            :, None
        ]
        paint = paint * (1 - shadow) + np.array(colors.hair) * shadow
    paint = paint * (1 - beard) + np.array(colors.brow) * beard
    paint = paint * (1 - lips[:, None]) + np.array(colors.lips) * lips[:, None]
    hollow = mouth.mouth_depth(figure.pack, base)[:, None]
    return paint * (1 - hollow) + np.array(mouth.HOLLOW) * hollow
