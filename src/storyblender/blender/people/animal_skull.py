"""The skull of an animal: its rounded form with cheeks and mouth, its jaw, and the markings painted on it.

All lengths are in head radii: x to the animal's left, y back, z up, the centre of the skull at the origin.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from storyblender.catalog.materials import hex_color
from storyblender.catalog.species import Species
from storyblender.geometry.implicit import Field, ellipsoid, melted, rod
from storyblender.geometry.solids import Floats
from storyblender.memory.base import Color

DARK, WHITE = "#17171a", "#f2efe8"
MOUTH_HEIGHT = -0.2
"""Height of the mouth on the skull."""
HINGE: Floats = np.array((0.0, -0.1, -0.35))
"""Pivot of the jaw."""
_BEAKS = ("cone", "flat", "hook")


class Skull:
    """Shape and colours of an animal head.

    Args:
        species: Species of the animal.
        coat: Colour of its coat, scene-linear.
    """

    def __init__(self, species: Species, coat: Color) -> None:
        self.species = species
        self.coat: Floats = np.array(coat, float)
        own = coat == hex_color(species.coat)
        self.pale: Floats = np.array(hex_color(species.pale)) if species.pale else self.coat * (1.0 if own else 1.1)
        self.long, self.thick = species.snout
        self.root: Floats = np.array((0.0, -0.5, MOUTH_HEIGHT))
        self.tip: Floats = np.array((0.0, -0.72 - self.long, MOUTH_HEIGHT - 0.08 - species.drop))
        self.goggling = "goggles" in species.marks
        tiny = "tiny" in species.marks
        self.eye = 0.11 if tiny else 0.25 if species.mouth == "hook" and "discs" in species.marks else 0.2
        if self.goggling:
            self.eyes: Floats = np.array((0.46, -0.42, 0.86 if species.mouth == "wide" else 0.72))
        else:
            height = 0.34 if species.drop > 0.3 else 0.26
            out = 0.36 if species.mouth in _BEAKS else 0.42 if species.drop > 0.2 else 0.4
            self.eyes = np.array((out, self.front_y(out, height) + 0.62 * self.eye, height))

    @cached_property
    def form(self) -> Field:
        """Distance field of the head without its jaw and its ears."""
        species, long, thick = self.species, self.long, self.thick
        if species.mouth == "wide":
            parts = [
                ellipsoid((0, 0, 0.05), (1.02, 0.95, 0.78)),
                ellipsoid((0, -0.45 - long / 3, -0.12), (thick, 0.62, 0.4)),
            ]
        else:
            slim = 0.78 if species.drop > 0.2 else 0.86 if species.mouth in _BEAKS else 0.97
            parts = [ellipsoid((0, 0.02, 0.04), (slim, 0.95, 0.96))]
            if species.mouth in ("snout", "trunk"):
                parts += [ellipsoid((x * 0.42, -0.36, -0.36), (0.48, 0.5, 0.44)) for x in (-1, 1)]
        if self.goggling:
            parts += [ellipsoid((x * 0.46, -0.3, self.eyes[2] - 0.02), (0.29, 0.3, 0.29)) for x in (-1, 1)]
        if "ruff" in species.marks:
            parts += [
                rod(
                    (x * 0.5, -0.22, -0.3 - 0.12 * row),
                    (x * (1.22 - 0.16 * row), -0.1, -0.42 - 0.2 * row),
                    (0.26, 0.03),
                )
                for x in (-1, 1)
                for row in range(3)
            ]
        if species.mouth == "snout":
            parts.append(rod(self.root, self.tip, (thick * 1.1, thick * 0.74), flat=0.86))
            if species.drop > 0.3 or "nostrils" in species.marks or "disc" in species.marks:
                parts.append(ellipsoid(self.tip, (thick * 0.86, 0.3, thick * 0.7)))
        if species.mouth == "trunk":
            bends = [(0, -0.7, -0.1), (0, -1.25, -0.5), (0, -1.35, -1.1), (0, -1.5, -1.5), (0, -1.85, -1.62)]
            radii = (0.42, 0.32, 0.25, 0.2, 0.17)
            parts += [rod(bends[i], bends[i + 1], (radii[i], radii[i + 1])) for i in range(4)]
        return melted(parts, 0.22)

    @cached_property
    def beak(self) -> Field | None:
        """Distance field of the upper half of a bird's beak, if it has one."""
        long, thick = self.long, self.thick
        tip = (0, -0.85 - long, MOUTH_HEIGHT - 0.1)
        match self.species.mouth:
            case "cone":
                return rod((0, -0.72, -0.06), tip, (thick, 0.025), flat=0.85)
            case "flat":
                wide = rod(
                    (0, -0.9 - long * 0.3, -0.22), (0, -0.8 - long, -0.26), (thick * 0.8, thick * 0.95), flat=0.3
                )
                return melted(
                    [rod((0, -0.75, -0.05), (0, -0.9 - long / 2, -0.2), (thick * 0.8, thick * 0.6), flat=0.55), wide],
                    0.2,
                )
            case "hook":
                bend = (0, -0.86 - long * 0.6, -0.02)
                down = rod(bend, (0, -0.92 - long * 0.72, -0.36 - 0.2 * long), (thick * 0.85, 0.03))
                return melted([rod((0, -0.7, 0.02), bend, (thick * 1.15, thick * 0.85)), down], 0.1)
            case _:
                return None

    @cached_property
    def jaw(self) -> Field | None:
        """Distance field of the lower jaw, shut."""
        long, thick = self.long, self.thick
        down = np.array((0.0, 0.3, -0.42 * thick))
        match self.species.mouth:
            case "snout":
                return rod((0, -0.3, -0.5), self.tip + down, (0.5 * (0.55 + thick), thick * 0.62), flat=0.72)
            case "wide":
                return ellipsoid((0, -0.3 - long / 3, -0.34), (thick * 0.95, 0.72, 0.3))
            case "cone":
                return rod(
                    (0, -0.7, -0.2), (0, -0.72 - long * 0.9, MOUTH_HEIGHT - 0.14), (thick * 0.72, 0.02), flat=0.7
                )
            case "flat":
                return rod((0, -0.7, -0.3), (0, -0.8 - long * 0.9, -0.36), (thick * 0.7, thick * 0.78), flat=0.22)
            case "hook":
                return rod((0, -0.7, -0.2), (0, -0.78 - long * 0.4, -0.26), (thick * 0.8, 0.05))
            case "trunk":
                return rod((0, -0.4, -0.6), (0, -0.95, -0.72), (0.36, 0.2))

    def bounds(self, field: Field) -> tuple[Floats, Floats]:
        """Return two opposite corners of a box that contains a field of this head."""
        coarse = np.stack(np.meshgrid(np.arange(-2, 2.01, 0.1), np.arange(-3.4, 1.6, 0.1), np.arange(-2.3, 2, 0.1)), -1)
        inside = coarse.reshape(-1, 3)[field(coarse.reshape(-1, 3)) < 0.08]
        return inside.min(0) - 0.12, inside.max(0) + 0.12

    def front_y(self, x: float, z: float) -> float:
        """Return the y coordinate of the front surface of the head at ``x`` and ``z``, all in head radii."""
        return float(self.cast_ray((x, -3.2, z), (0, 1, 0))[1])

    def cast_ray(self, start: ArrayLike, way: ArrayLike) -> Floats:
        """Return the first point (3,) of a ray on the head, or the ray's nearest point to it if it misses; head radii.

        Args:
            start: Where the ray begins, (3,) head radii, outside the head.
            way: Unit direction, (3,).
        """
        at, step = np.array(start, float), np.asarray(way, float)
        nearest, least = at, np.inf
        for _ in range(60):
            gap = float(self.form(at[None])[0])
            if gap < least:
                nearest, least = at, gap
            if gap < 0.004:
                break
            at = at + step * min(gap * 0.7, 0.2)
        return nearest

    def paint(self, points: Floats) -> Floats:
        """Return the colours (V, 3) of the coat at places on the head."""
        species = self.species
        colors = np.tile(self.coat, (len(points), 1))
        x, y, z = np.abs(points[:, 0]), points[:, 1], points[:, 2]
        if species.pale and species.mouth in ("snout", "wide") and "bignose" not in species.marks:
            middle = np.interp(-y, (0.4, -self.tip[1]), (MOUTH_HEIGHT, self.tip[2]))
            below = _soft(middle + 0.1 * self.thick - z, 0.12) * _soft(-0.35 - y, 0.15)
            before = _soft(-0.72 - 0.35 * self.long - y, 0.12) if species.drop > 0.2 or self.long < 0.6 else 0.0 * y
            _blend(colors, np.maximum(below, before), self.pale)
        if species.belly and species.mouth in _BEAKS and not {"face", "hood"} & {*species.marks}:
            _blend(colors, _soft(-0.35 - z, 0.2) * _soft(0.2 - y, 0.2), np.array(hex_color(species.belly)))
        for mark in species.marks:
            if mark in PAINTS:
                PAINTS[mark](self, colors, x, y, z)
        return np.clip(colors, 0, 1)


def _soft(value: Floats, width: float) -> Floats:
    """Return a smooth step from 0 to 1 across ``width`` where ``value`` crosses zero."""
    share = np.clip(value / width + 0.5, 0, 1)
    return share * share * (3 - 2 * share)


def _blend(colors: Floats, share: Floats, color: ArrayLike) -> None:
    """Blend ``color`` into ``colors`` (V, 3) in place, by ``share`` (V,)."""
    colors += np.clip(share, 0, 1)[:, None] * (np.asarray(color, float) - colors)


def _tint(code: str) -> Floats:
    """Return the colour of a hex code."""
    return np.array(hex_color(code))


def _stripes(skull: Skull, colors: Floats, x: Floats, y: Floats, z: Floats) -> None:
    """Paint a white face with a dark band through each eye from nose to ear."""
    _blend(colors, _soft(0.2 - y, 0.2), skull.pale)
    middle = np.interp(-y, (-0.4, 0.5, 1.0, 1.4), (0.5, 0.42, 0.34, 0.2))
    wide = np.interp(-y, (-0.4, 0.6, 1.0, 1.4), (0.2, 0.19, 0.15, 0.05))
    _blend(colors, _soft(wide - np.abs(x - middle), 0.07) * _soft(z + 0.22, 0.12), _tint("#141416"))


def _mask(skull: Skull, colors: Floats, x: Floats, y: Floats, z: Floats) -> None:
    """Paint white brows and muzzle, and a dark mask around the eyes down to the cheeks."""
    front = _soft(0.1 - y, 0.25)
    _blend(colors, front * _soft(0.42 - np.abs(z - 0.36) - 0.12 * x, 0.12), skull.pale)
    line = 0.22 - 0.42 * np.clip(x - 0.4, 0, 1)
    _blend(
        colors,
        front * _soft(0.24 - np.abs(z - line), 0.07) * _soft(x - 0.05, 0.1) * _soft(1.02 - x, 0.2),
        _tint("#1d1b1b"),
    )
    _blend(colors, front * _soft(0.11 - x, 0.08) * _soft(z + 0.1, 0.1), _tint("#3c3836"))


def _cheeks(skull: Skull, colors: Floats, x: Floats, y: Floats, z: Floats) -> None:
    """Paint pale cheeks up to just below the eyes."""
    _blend(colors, _soft(-0.02 - z - 0.12 * x, 0.14) * _soft(0.05 - y, 0.2) * _soft(x - 0.06, 0.1), skull.pale)
    _blend(colors, _soft(-0.45 - z, 0.15) * _soft(0.05 - y, 0.2), skull.pale)


def _bands(skull: Skull, colors: Floats, x: Floats, y: Floats, z: Floats) -> None:
    """Paint dark stripes over the brow and the cheeks."""
    dark = _tint("#1d1a18") if skull.species.words[0] != "cat" else skull.coat * 0.32
    brow = _soft(np.sin(7.5 * (x + 0.25 * z) + 1.2) - 0.35, 0.4) * _soft(z - 0.5, 0.15)
    side = _soft(np.sin(10 * z + 3 * x) - 0.4, 0.4) * _soft(x - 0.62, 0.12) * _soft(0.75 - np.abs(z), 0.2)
    along = 0.0 * x
    if skull.species.drop > 0.3:  # the long face of a zebra
        along = _soft(np.sin(13 * y) - 0.2, 0.5) * _soft(-0.6 - y, 0.1) * _soft(1.2 + y + 0.35, 0.1)
    _blend(colors, np.maximum.reduce([brow, side, along]), dark)


def _patches(skull: Skull, colors: Floats, x: Floats, y: Floats, z: Floats) -> None:
    """Paint dark patches around the eyes."""
    away = np.hypot((x - 0.44 - 0.2 * (0.2 - z)) / 0.27, (z - 0.18) / 0.36)
    _blend(colors, _soft(1.0 - away, 0.2) * _soft(-0.3 - y, 0.1), _tint("#17171a"))


def _face(skull: Skull, colors: Floats, x: Floats, y: Floats, z: Floats) -> None:
    """Paint a heart-shaped pale face; a penguin's has the colour of its belly."""
    color = skull.pale if skull.species.mouth == "snout" else _tint(skull.species.belly)
    away = np.hypot(x - 0.3, (z - 0.14) / 1.1)
    heart = np.maximum(_soft(0.42 - away, 0.1), _soft(0.66 - np.hypot(x, z + 0.4), 0.1))
    _blend(colors, heart * _soft(-0.15 - y, 0.1), color)


def _hood(skull: Skull, colors: Floats, x: Floats, y: Floats, z: Floats) -> None:
    """Paint the white head of an eagle."""
    _blend(colors, _soft(z + 0.75, 0.2), _tint("#efeae0"))


def _blaze(skull: Skull, colors: Floats, x: Floats, y: Floats, z: Floats) -> None:
    """Paint a white stripe down the middle of the face."""
    wide = np.interp(z, (-0.8, 0.3, 0.9), (0.12, 0.17, 0.1))
    _blend(colors, _soft(wide - x, 0.07) * _soft(z + 0.75, 0.2) * _soft(0.9 - y, 0.3), _tint(WHITE))


def _blotches(skull: Skull, colors: Floats, x: Floats, y: Floats, z: Floats) -> None:
    """Paint large dark patches on the sides of the head."""
    dark = _tint("#2a2523") if skull.species.words[0] == "cow" else _tint("#7a4a24")
    spots = np.sin(4.1 * x + 1.0) * np.cos(3.2 * z - 0.4) + 0.6 * np.sin(3.7 * y + 0.6)
    _blend(colors, _soft(spots - 0.2, 0.12) * _soft(x - 0.2, 0.1) * _soft(y + 0.95, 0.1), dark)


def _discs(skull: Skull, colors: Floats, x: Floats, y: Floats, z: Floats) -> None:
    """Paint the pale facial disc of an owl, dark at its rim."""
    away = np.hypot(x - 0.4, z - 0.22)
    front = _soft(-0.25 - y, 0.1)
    _blend(colors, front * _soft(0.58 - away, 0.06), skull.coat * 0.4)
    _blend(colors, front * _soft(0.5 - away, 0.06), _tint("#ecdfc0"))


PAINTS: dict[str, Callable[[Skull, Floats, Floats, Floats, Floats], None]] = {
    "stripes": _stripes, "mask": _mask, "cheeks": _cheeks, "bands": _bands, "patches": _patches, "face": _face,
    "hood": _hood, "blaze": _blaze, "blotches": _blotches, "discs": _discs,
}  # fmt: skip
"""Painter of each marking of the head."""
