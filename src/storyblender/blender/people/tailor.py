"""Dresses a figure: builds every garment from the inside out and removes what the next one hides."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.people import cloth, gear, headwear, trimmings
from storyblender.blender.people.cloth import Bolt, Builder, Cover
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.sheet import Sheet
from storyblender.blender.people.worn_layers import WornLayers
from storyblender.catalog import cuts
from storyblender.catalog.bodies import mix
from storyblender.catalog.garments import GARMENTS, GarmentSpec
from storyblender.catalog.materials import hex_color
from storyblender.catalog.wardrobe import in_colors
from storyblender.geometry.solids import Floats
from storyblender.memory.asset_sheet import Garment
from storyblender.memory.base import Color

SKIN_MARGIN, CLOTH_MARGIN = 0.012, 0.018
"""Metres inside a cover field at which skin and cloth are hidden."""

BUILDERS: dict[type, Builder] = {
    cuts.Bodice: cloth.build_top,
    cuts.Lapel: cloth.build_lapel,
    cuts.Collar: cloth.build_collar,
    cuts.Legs: cloth.build_legs,
    cuts.Skirt: cloth.build_skirt,
    cuts.Band: cloth.build_band,
    cuts.Footwear: cloth.build_footwear,
    cuts.Buttons: trimmings.build_buttons,
    cuts.Patches: trimmings.build_patches,
    cuts.Necktie: trimmings.build_necktie,
    cuts.BowTie: trimmings.build_bow_tie,
    cuts.Scarf: trimmings.build_scarf,
    cuts.Bib: trimmings.build_bib,
    cuts.Hat: headwear.build_hat,
    cuts.HeadCloth: gear.build_head_cloth,
    cuts.Gear: gear.build_gear,
}
"""Builder of each kind of piece; ``cloth.Builder`` says what it is given."""

COVERS: dict[type, Cover] = {
    cuts.Bodice: cloth.cover_top,
    cuts.Legs: cloth.cover_legs,
    cuts.Skirt: cloth.cover_skirt,
    cuts.Footwear: cloth.cover_footwear,
}
"""Cover field of the pieces that hide what is below them."""

SOLID = {*COVERS, cuts.Band, cuts.Bib, cuts.Lapel}
"""Pieces that become a layer; the others are too small or stand off by themselves."""


@dataclass
class Worn:
    """A finished garment.

    Attributes:
        spec: Its catalog entry.
        color: Its main colour.
        bolts: Its sheets.
    """

    spec: GarmentSpec
    color: Color
    bolts: list[Bolt]


def dress_figure(figure: BodyFigure, outfit: Sequence[Garment], seed: int) -> list[Worn]:
    """Return the garments of an outfit, fitted, with hidden faces removed.

    Args:
        figure: The body.
        outfit: Innermost first.
        seed: Picks the colours that the outfit leaves open.
    """
    layers = WornLayers(float(figure.joint("neck")[1]) - 0.01 * figure.scale)
    wardrobe: list[Worn] = []
    for garment in in_colors(outfit, seed):
        spec = GARMENTS[garment.key]
        assert garment.color is not None, "every piece has its colour"
        worn = Worn(spec, garment.color, [])
        for piece in spec.pieces:
            bolts = BUILDERS[type(piece)](piece, figure, layers)
            worn.bolts += bolts
            if type(piece) in SOLID or _lies_flat(piece):
                for bolt in bolts:
                    layers.add(bolt.sheet)
        wardrobe.append(worn)
    for place, worn in enumerate(wardrobe):
        fields = _cover_fields(figure, wardrobe[place + 1 :])
        for bolt in worn.bolts:
            bolt.sheet = bolt.sheet.keep_faces(~_hidden(bolt.sheet, fields, CLOTH_MARGIN * figure.scale))
        worn.bolts = [bolt for bolt in worn.bolts if len(bolt.sheet.faces)]
    return [worn for worn in wardrobe if worn.bolts]


def _lies_flat(piece: cuts.AnyPiece) -> bool:
    """Return whether a collar lies on the shoulders, so that it goes under a jacket."""
    return isinstance(piece, cuts.Collar) and piece.low < 0


def covered_skin(figure: BodyFigure, skin: Sheet, wardrobe: Sequence[Worn]) -> NDArray[np.bool_]:
    """Return which faces of the skin are hidden by garments, (F,).

    Args:
        figure: The body.
        skin: Its skin, F faces.
        wardrobe: The garments, as ``dress_figure`` gives them.
    """
    return _hidden(skin, _cover_fields(figure, wardrobe), SKIN_MARGIN * figure.scale)


def _cover_fields(figure: BodyFigure, wardrobe: Sequence[Worn]) -> list[Callable[[Sheet], Floats]]:
    """Return the cover fields of all garments, as functions of a sheet."""
    return [
        partial(COVERS[type(piece)], piece, figure)
        for worn in wardrobe
        for piece in worn.spec.pieces
        if type(piece) in COVERS
    ]


def _hidden(sheet: Sheet, fields: Sequence[Callable[[Sheet], Floats]], margin: float) -> NDArray[np.bool_]:
    """Return which faces (F,) lie wholly inside one of ``fields`` by at least ``margin`` metres."""
    if not fields:
        return np.zeros(len(sheet.faces), bool)
    inside = np.any([field(sheet) > margin for field in fields], axis=0)
    return (inside[sheet.faces] | (sheet.faces < 0)).all(1)


def hangs_below_hips(spec: GarmentSpec) -> bool:
    """Return whether a garment lies on the lap of a person who sits."""
    return any(
        isinstance(piece, cuts.Skirt | cuts.Bib) or (isinstance(piece, cuts.Bodice) and piece.hem[0] == "crotch")
        for piece in spec.pieces
    )


def piece_color(color: Color, tint: str) -> Color:
    """Return the scene-linear colour of a piece.

    Args:
        color: Main colour of the garment, scene-linear.
        tint: ``main``, ``dark`` or ``light``, which change that colour, or a hex code instead of it.
    """
    if tint.startswith("#"):
        return hex_color(tint)
    return {"main": color, "dark": mix(color, (0, 0, 0), 0.3), "light": mix(color, (1, 1, 1), 0.35)}[tint]
