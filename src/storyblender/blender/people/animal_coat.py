"""The coat of an animal on a person's body: smooth fur without muscle relief, paws, belly and tail."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from storyblender.blender.people import tailor
from storyblender.blender.people.animal_skull import DARK
from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.sheet import Sheet, join, loosened
from storyblender.blender.people.solids import ball, bar
from storyblender.blender.people.tailor import Worn
from storyblender.catalog.materials import hex_color
from storyblender.catalog.species import Species
from storyblender.geometry.solids import Floats
from storyblender.memory.base import Color

_FUR = 0.012
"""Thickness of the coat in metres, on an animal of 1.70 m."""
_BIRDS = ("cone", "flat", "hook")

_Path = tuple[tuple[float, float, float], ...]
TAILS: dict[str, tuple[_Path, tuple[float, ...]]] = {
    "stub": (((0, 0.0, 0), (0.01, 0.05, 0.02), (0.01, 0.1, 0.05)), (0.045, 0.06, 0.035)),
    "thin": (((0, 0, 0), (0.05, 0.16, -0.05), (0.16, 0.3, -0.1), (0.28, 0.36, 0.04), (0.34, 0.38, 0.22)),
             (0.022, 0.018, 0.015, 0.011, 0.005)),
    "even": (((0, 0, 0), (0.06, 0.15, -0.03), (0.16, 0.27, 0.05), (0.22, 0.3, 0.25), (0.2, 0.24, 0.42)),
             (0.035, 0.034, 0.034, 0.034, 0.022)),
    "bushy": (((0, 0, 0), (0.06, 0.14, -0.06), (0.18, 0.26, -0.08), (0.3, 0.34, 0.06), (0.36, 0.36, 0.26)),
              (0.035, 0.075, 0.105, 0.1, 0.012)),
    "plume": (((0, 0, 0), (0.04, 0.16, 0.02), (0.1, 0.26, 0.25), (0.12, 0.24, 0.5), (0.14, 0.4, 0.62),
               (0.14, 0.48, 0.5)),
              (0.04, 0.085, 0.115, 0.12, 0.1, 0.03)),
    "rings": (((0, 0, 0), (0.06, 0.14, -0.06), (0.18, 0.24, -0.06), (0.3, 0.3, 0.08), (0.36, 0.3, 0.27)),
              (0.04, 0.065, 0.075, 0.07, 0.03)),
    "tuft": (((0, 0, 0), (0.06, 0.12, -0.08), (0.12, 0.16, -0.25), (0.2, 0.2, -0.38)), (0.024, 0.02, 0.017, 0.015)),
    "hair": (((0, 0, 0.02), (0.02, 0.1, 0.04), (0.06, 0.16, -0.12), (0.1, 0.16, -0.4), (0.12, 0.15, -0.56)),
             (0.03, 0.055, 0.08, 0.07, 0.015)),
    "thick": (((0, 0, 0), (0.04, 0.2, -0.12), (0.14, 0.36, -0.26), (0.28, 0.5, -0.32), (0.42, 0.58, -0.3)),
              (0.095, 0.085, 0.065, 0.04, 0.01)),
}  # fmt: skip
"""Tail shapes: path from the root (left, back, up) and radii along it, in metres on an animal of 1.70 m."""


def build_coat(figure: BodyFigure, species: Species, coat: Color, wardrobe: Sequence[Worn]) -> tuple[Sheet, Floats]:
    """Return the visible fur with the hands, and its vertex colours.

    Args:
        figure: Body of the animal.
        species: Species of the animal.
        coat: Colour of its coat.
        wardrobe: Garments; no fur is built below them.
    """
    fur, hands = figure.part("tights"), figure.part("skin")
    hidden = tailor.covered_skin(figure, fur, wardrobe)
    fur = loosened(fur, (_FUR if not wardrobe else 0.3 * _FUR) * figure.scale, 12).keep_faces(~hidden)
    holding = (figure.along_arm(hands)[0] > 1.8) & (figure.arm_share(hands) > 0.5)
    covered = tailor.covered_skin(figure, hands, wardrobe)
    hands = hands.keep_faces((holding[hands.faces] | (hands.faces < 0)).all(1) & ~covered)
    whole = join([fur, hands])
    return whole, _painted(figure, species, coat, whole)


def _painted(figure: BodyFigure, species: Species, coat: Color, sheet: Sheet) -> Floats:
    """Return the vertex colours (V, 3) of the fur: belly, bands, blotches and limbs over the coat's colour."""
    colors = np.tile(np.array(coat), (len(sheet.points), 1))
    base, bird = sheet.base, species.mouth in _BIRDS
    if species.belly or (species.pale and not bird and "disc" not in species.marks):
        belly = np.array(hex_color(species.belly or species.pale))
        front = np.clip((base[:, 2] - 0.25) / 0.3, 0, 1) * (figure.arm_share(sheet) < 0.3)
        oval = np.hypot(base[:, 0] / 1.05, (base[:, 1] - 2.9) / 3.4)
        share = front * np.clip((1 - oval) / 0.3, 0, 1)
        colors += share[:, None] * (belly - colors)
    if "bands" in species.marks:
        wave = np.sin(5.2 * base[:, 1] + 1.6 * np.abs(base[:, 0])) + 0.4 * np.sin(2.1 * base[:, 0] + base[:, 1])
        dark = np.array(hex_color("#1d1a18")) if species.words[0] != "cat" else colors * 0.4
        share = np.clip((wave - 0.45) / 0.25, 0, 1) * (base[:, 2] < 0.75)
        colors += share[:, None] * (dark - colors)
    if "blotches" in species.marks:
        spots = np.sin(1.7 * base[:, 0] + 1) * np.cos(1.3 * base[:, 1]) + 0.6 * np.sin(1.5 * base[:, 2] + base[:, 1])
        dark = np.array(hex_color("#2a2523" if species.words[0] == "cow" else "#7a4a24"))
        colors += np.clip((spots - 0.3) / 0.1, 0, 1)[:, None] * (dark - colors)
    if species.limbs:
        limb = np.array(hex_color(species.limbs))
        place, _ = figure.along_arm(sheet)
        arm = np.clip((place - 1.55) / 0.3, 0, 1) * (figure.arm_share(sheet) > 0.5) * (not bird)
        knee, ankle = figure.heights["knee"], figure.heights["ankle"]
        line = 0.75 * knee + 0.25 * ankle if bird else 0.35 * knee + 0.65 * ankle
        leg = np.clip((line - sheet.points[:, 2]) / (0.05 * figure.scale), 0, 1) * (figure.arm_share(sheet) < 0.3)
        colors += np.maximum(arm, leg)[:, None] * (limb - colors)
    return colors


def build_tail(figure: BodyFigure, species: Species, coat: Color) -> tuple[Sheet, Floats] | None:
    """Return the tail and its vertex colours (V, 3), or None for an animal without one.

    Args:
        figure: The body that carries it, on its back at the height of the hips.
        species: Shape of the tail and colour of its tip.
        coat: Scene-linear colour of the fur.
    """
    if species.tail == "none":
        return None
    scale = figure.scale * (1.15 if species.height < 1.0 else 0.95)
    root = _root(figure)
    tip = (
        np.array(hex_color(species.tip or (DARK if species.tail == "tuft" else "")))
        if species.tip or species.tail == "tuft"
        else np.array(coat)
    )
    if species.tail == "fan":
        return _feathers(root, scale, np.array(coat), tip)
    if species.tail == "paddle":
        sheet = ball(root + np.array((0, 0.17, -0.1)) * scale, np.array((0.1, 0.22, 0.022)) * scale,
                     bone_weights("hips"), rotation=(-30, 0, 0))  # fmt: skip
        return sheet, np.tile(tip, (len(sheet.points), 1))
    path, radii = TAILS[species.tail]
    at, fine = np.linspace(0, 1, len(path)), np.linspace(0, 1, 33)
    line = np.stack([np.interp(fine, at, axis) for axis in np.array(path).T], 1)
    for _ in range(12):
        line[1:-1] = 0.5 * line[1:-1] + 0.25 * (line[:-2] + line[2:])
    sheet = bar(root + line * scale, list(np.interp(fine, at, radii) * scale), bone_weights("hips"))
    along = np.repeat(fine, 8)[: len(sheet.points)]
    along = np.concatenate([along, np.ones(len(sheet.points) - len(along))])
    share = np.clip((along - 0.72) / 0.06, 0, 1)
    if species.tail == "rings":
        share = np.clip((np.sin(along * 34) - 0.1) / 0.3, 0, 1)
    elif species.tail in ("hair", "thin"):
        share = np.ones(len(along)) * (along > 0.05)
    colors = np.array(coat) + share[:, None] * (tip - np.array(coat))
    if species.tail != "tuft":
        return sheet, colors
    brush = ball(root + line[-1] * scale, np.array((0.045, 0.045, 0.09)) * scale, bone_weights("hips"))
    return join([sheet, brush]), np.concatenate(
        [np.tile(np.array(coat), (len(sheet.points), 1)), np.tile(tip, (len(brush.points), 1))]
    )


def _root(figure: BodyFigure) -> Floats:
    """Return the root of the tail in metres: on the back, at the height of the pelvis."""
    skin = figure.part("skin").points
    height = float(figure.joint("pelvis")[2]) + 0.01 * figure.scale
    near = (np.abs(skin[:, 2] - height) < 0.03 * figure.scale) & (np.abs(skin[:, 0]) < 0.06 * figure.scale)
    return np.array((0.0, float(skin[near, 1].max()) - 0.015 * figure.scale, height))


def _feathers(root: Floats, scale: float, coat: Floats, tip: Floats) -> tuple[Sheet, Floats]:
    """Return a short fan of feathers at ``root`` and its vertex colours."""
    sheets, colors = [], []
    for step, lean in enumerate((-34, -17, 0, 17, 34)):
        way = np.array((np.sin(np.radians(lean)), 0.9, -0.42))
        sheet = ball(root + way * 0.11 * scale, np.array((0.034, 0.14, 0.014)) * scale, bone_weights("hips"),
                     rotation=(-24, 0, -lean))  # fmt: skip
        sheets.append(sheet)
        colors.append(np.tile(tip * (1.0 if step % 2 else 0.8) if step else coat, (len(sheet.points), 1)))
    return join(sheets), np.concatenate(colors)
