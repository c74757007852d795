"""Cut cloth: shirts, jackets, trousers, skirts, shoes. One builder and one cover field for each kind of piece.

A builder returns bolts, sheets with the tint and fabric they are made of. A cover field is positive where the piece
hides what is worn below it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from storyblender.blender.people.figure import FAR, BodyFigure
from storyblender.blender.people.sheet import Sheet, clip, loosened, normals, smoothed
from storyblender.blender.people.worn_layers import WornLayers
from storyblender.catalog.cuts import Band, Bodice, Collar, Fabric, Footwear, GarmentPiece, Lapel, Legs, Skirt
from storyblender.catalog.skeleton import columns
from storyblender.geometry.solids import Floats

_LEGS = columns("thigh", "shin", "foot", "toe")
SKIRT_MARGIN = 0.06
"""Metres above a skirt's hem up to which the legs below it stay, because the camera can look in."""


@dataclass
class Bolt:
    """A sheet of one tint and fabric."""

    sheet: Sheet
    tint: str
    fabric: Fabric


Builder = Callable[[Any, BodyFigure, WornLayers], list[Bolt]]
"""Given the cut of a piece (``catalog.cuts``), the body and the clothes worn below, returns the bolts of the piece over
them, metres; none where they leave no place for it."""
Cover = Callable[[Any, BodyFigure, Sheet], Floats]
"""Given the cut of a piece, the body and a sheet worn below it, returns the cover field (V,) on that sheet, metres."""


def single_bolt(piece: GarmentPiece, sheet: Sheet) -> list[Bolt]:
    """Return the bolt of a ``piece`` that is made of one ``sheet``."""
    return [Bolt(sheet, piece.tint, piece.fabric)]


def cover_top(cut: Bodice, figure: BodyFigure, sheet: Sheet) -> Floats:
    """Return the cover field (V,) of a top on the vertices of ``sheet``."""
    field = np.minimum(figure.inside_sleeve(sheet, cut.sleeve), figure.above(sheet, figure.height(cut.hem)))
    # The throat stays visible inside a collar that stands off it.
    field = np.minimum(field, figure.below_neck(sheet, cut.neck - 0.02))
    return np.minimum(field, figure.beside_opening(sheet, cut.opening)) if cut.opening else field


def build_top(cut: Bodice, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a top: cut from the body suit, loosened, outside the worn layers."""
    k = figure.scale
    sheet = figure.part("tights")
    for field in (
        lambda s: figure.inside_sleeve(s, cut.sleeve),
        lambda s: figure.above(s, figure.height(cut.hem)),
        lambda s: figure.below_neck(s, cut.neck),
    ):
        sheet = clip(sheet, field(sheet))
    close = 1 - 0.55 * figure.arm_share(sheet)
    sheet = loosened(sheet, cut.ease * close * k, cut.drape)
    if cut.elbow:
        sheet = _fill_sleeves(sheet, figure, cut)
    sheet = layers.push_out(sheet, 0.006 * k)
    if cut.opening:
        sheet = clip(sheet, figure.beside_opening(sheet, cut.opening))
    return single_bolt(cut, sheet)


def _fill_sleeves(sheet: Sheet, figure: BodyFigure, cut: Bodice) -> Sheet:
    """Return the sheet with its sleeves widened to the radii of the cut."""
    place, radial = figure.along_arm(sheet)
    least = np.interp(place, (0.45, 1, 2), (0, cut.elbow, cut.cuff)) * figure.scale
    radius = np.maximum(np.linalg.norm(radial, axis=1), 1e-4)
    widened = (figure.arm_share(sheet) > 0.5) & (place > 0.45) & (radius < least)
    return sheet.moved(sheet.points + radial * np.where(widened, least / radius - 1, 0)[:, None])


def build_lapel(cut: Lapel, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a lapel: a strip along the opening of the jacket below it."""
    opening, k = cut.opening, figure.scale
    bottom, top = figure.height(opening.bottom), figure.heights["neck"]
    sheet = figure.part("tights")
    for field in (
        lambda s: figure.below_neck(s, 0.03),
        lambda s: figure.above(s, bottom),
        lambda s: np.where(figure.is_front(s), figure.beside_opening(s, opening), -FAR),
        lambda s: np.where(
            figure.is_front(s), _lapel_width(s, figure, cut, bottom, top) - figure.beside_opening(s, opening), -FAR
        ),
    ):
        sheet = clip(sheet, field(sheet))
    sheet = sheet.moved(sheet.points + normals(sheet) * cut.ease * k)
    return single_bolt(cut, layers.push_out(sheet, 0.004 * k))


def _lapel_width(sheet: Sheet, figure: BodyFigure, cut: Lapel, bottom: float, top: float) -> Floats:
    """Return the lapel's width (V,) in metres: widest at two thirds of its height, pointed at the button."""
    share = np.clip((sheet.skin[:, 2] - bottom) / (top - bottom), 0, 1)
    return cut.width * figure.scale * np.interp(share, (0, 0.66, 1), (0.15, 1.25, 0.7))


def build_collar(cut: Collar, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a collar: a folded band of the neck that flares out below and ends in points in front."""
    k = figure.scale
    neck = float(figure.joint("neck")[1])

    def share(s: Sheet) -> Floats:
        """Return the height on the collar, (V,): 0 at the lower edge, 1 at the fold."""
        frontal = np.clip((neck - s.skin[:, 1]) / (0.055 * k), 0, 1) ** 2
        low = cut.low - cut.point * frontal
        return (figure.up_neck(s) / k - low) / (cut.high - low)

    sheet = figure.part("tights")
    sheet = clip(sheet, figure.below_neck(sheet, cut.high))
    sheet = clip(sheet, share(sheet))
    sheet = clip(sheet, 0.13 * k - np.abs(sheet.skin[:, 0]))
    gap = (0.004 + cut.gap * np.clip(1 - share(sheet), 0, 1)) * k
    sheet = clip(sheet, np.where(figure.is_front(sheet), np.abs(sheet.skin[:, 0]) - gap, FAR))
    stand = (0.008 + cut.flare * (1 - share(sheet))) * k
    return single_bolt(cut, sheet.moved(sheet.points + normals(sheet) * stand[:, None]))


def cover_legs(cut: Legs, figure: BodyFigure, sheet: Sheet) -> Floats:
    """Return the cover field (V,) of trousers on the vertices of ``sheet``."""
    return np.minimum(figure.below(sheet, figure.height(cut.waist)), sheet.skin[:, 2] - figure.height(cut.hem))


def build_legs(cut: Legs, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of trousers: cut from the body suit, the legs widened to the cut."""
    k = figure.scale
    hem = figure.height(cut.hem)
    sheet = figure.part("tights")
    sheet = clip(sheet, figure.below(sheet, figure.height(cut.waist)))
    sheet = clip(sheet, sheet.skin[:, 2] - hem)
    place, _ = figure.along_leg(sheet)
    sheet = loosened(sheet, (0.006 + 0.008 * np.clip(place / 2, 0, 1)) * k, 8)
    place, axis = figure.along_leg(sheet)
    limb = sheet.weights[:, _LEGS].sum(1)
    start, last = 0.2, max(1.05, float(place.max()))
    least = np.interp(place, (start, 0.55, 1, last), (0, cut.thigh, cut.knee, cut.cuff)) * k
    radial = sheet.points - axis
    radius = np.maximum(np.linalg.norm(radial[:, :2], axis=1), 1e-4)
    widened = (limb > 0.5) & (place > start) & (radius < least)
    grow = np.where(widened, least / radius, 1)[:, None]
    points = sheet.points.copy()
    points[:, :2] = (axis + radial * grow)[:, :2]
    points = smoothed(sheet.moved(points), 4)
    points[sheet.skin[:, 2] < hem + 0.012 * k, 2] -= cut.drop * k
    return single_bolt(cut, layers.push_out(sheet.moved(points), 0.003 * k))


def cover_skirt(cut: Skirt, figure: BodyFigure, sheet: Sheet) -> Floats:
    """Return the cover field (V,) of a skirt; trouser legs and skin near its hem stay visible."""
    return np.minimum(
        figure.below(sheet, figure.height(cut.top)),
        sheet.skin[:, 2] - figure.height(cut.hem) - SKIRT_MARGIN * figure.scale,
    )


def build_skirt(cut: Skirt, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a skirt: cut from the skirt tube, flared and folded."""
    sheet = figure.part("skirt")
    sheet = clip(sheet, figure.height(cut.top) - sheet.skin[:, 2])
    sheet = clip(sheet, sheet.skin[:, 2] - figure.height(cut.hem))
    sheet = loosened(sheet, cut.ease * figure.scale, 3)
    middle = figure.joint("pelvis")[1]
    top = sheet.points[:, 2].max()
    fall = np.clip((top - sheet.points[:, 2]) / max(top - sheet.points[:, 2].min(), 0.05), 0, 1)
    angle = np.arctan2(sheet.points[:, 1] - middle, sheet.points[:, 0])
    ripple = 1 + cut.depth * fall * (np.sin(angle * cut.folds) + 0.4 * np.sin(angle * (cut.folds * 2 - 3) + 1))
    grow = (1 + cut.flare * fall**1.5) * ripple
    points = sheet.points.copy()
    points[:, 0] *= grow
    points[:, 1] = middle + (points[:, 1] - middle) * grow
    sheet = layers.push_out(sheet.moved(points), 0.012 * figure.scale)
    sheet.weights = _parted_between_the_legs(sheet, figure)
    if cut.opening:
        front = sheet.skin[:, 1] < middle
        sheet = clip(sheet, np.where(front, np.abs(sheet.skin[:, 0]) - cut.opening * figure.scale, FAR))
    return single_bolt(cut, sheet)


def _parted_between_the_legs(sheet: Sheet, figure: BodyFigure) -> Floats:
    """Return weights in which each half of a skirt follows the leg below it, so that a striding thigh stays inside."""
    weights = sheet.weights.copy()
    left = np.clip(0.5 + sheet.skin[:, 0] / (0.14 * figure.scale), 0, 1)
    for stem in ("thigh", "shin"):
        pair = columns(stem)
        both = weights[:, pair].sum(1)
        weights[:, pair[0]], weights[:, pair[1]] = both * left, both * (1 - left)
    return weights


def build_band(cut: Band, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a belt around what is worn at the waist."""
    sheet = figure.part("tights")
    sheet = clip(sheet, figure.above(sheet, figure.height(cut.low)))
    sheet = clip(sheet, figure.below(sheet, figure.height(cut.high)))
    sheet = loosened(sheet, cut.ease * figure.scale, 4)
    return single_bolt(cut, layers.push_out(sheet, 0.005 * figure.scale))


def cover_footwear(cut: Footwear, figure: BodyFigure, sheet: Sheet) -> Floats:
    """Return the cover field (V,) of a shoe or boot."""
    field = figure.below(sheet, figure.height(cut.top)) - 0.004
    if not cut.throat:
        return field
    # The instep is cut out along a slope from the ankle down to the toes.
    ankle, toe = figure.joint("l-ankle"), figure.joint("l-toe-3-1")
    along = (toe - ankle)[1]
    forward = (sheet.skin[:, 1] - ankle[1]) / along
    slope = ankle[2] * np.interp(forward, (-0.3, 0.1, 0.9), (1.0, 0.62, 0.30))
    return np.minimum(field, slope - sheet.skin[:, 2])


def build_footwear(cut: Footwear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a shoe, cut from the foot of the body suit; the sole is a bolt of its own."""
    k = figure.scale
    sheet = figure.part("tights")
    sheet = clip(sheet, cover_footwear(cut, figure, sheet) + 0.004)
    sheet = loosened(sheet, cut.ease * k, 6 if cut.sole else 2)
    if cut.shaft:
        place, axis = figure.along_leg(sheet)
        radial = sheet.points - axis
        radius = np.maximum(np.linalg.norm(radial[:, :2], axis=1), 1e-4)
        grow = np.where((place < 1.93) & (radius < cut.shaft * k), cut.shaft * k / radius, 1)[:, None]
        points = sheet.points.copy()
        points[:, :2] = (axis + radial * grow)[:, :2]
        sheet = sheet.moved(points)
    if not cut.sole:
        return single_bolt(cut, sheet)
    points = sheet.points.copy()
    points[:, 2] = np.maximum(points[:, 2], 0.0)
    sheet = sheet.moved(points)
    real = sheet.faces >= 0
    low = (np.where(real, points[sheet.faces, 2], 0).sum(1) / real.sum(1)) < 0.012 * k
    return [Bolt(sheet.keep_faces(~low), cut.tint, cut.fabric), Bolt(sheet.keep_faces(low), cut.sole, "rubber")]
