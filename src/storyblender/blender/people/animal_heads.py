"""Heads of animals on people's bodies: a badger in a waistcoat has a badger's head, and hands of its coat."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.people.cloth import Bolt
from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.figure import Figure
from storyblender.blender.people.sheet import Sheet, join
from storyblender.blender.people.solids import ball, bar
from storyblender.catalog.species import Species

Floats = NDArray[np.float64]
DARK, WHITE = "#17171a", "#f2efe8"
SKULL = 0.15
"""Metres from the middle of the head to its side, on a grown-up: all of the human head is inside."""
NECK_LINE = 6.0
"""Decimetres on the base mesh: above it the person's own head is left out."""


class Head:
    """A head being built, in units of its own radius: x to the animal's left, y back, z up.

    Args:
        figure: Whose.
        species: Which animal.
    """

    def __init__(self, figure: Figure, species: Species) -> None:
        self.species = species
        self.radius = SKULL * figure.head_scale
        skin = figure.part("skin")
        above = skin.points[(skin.base[:, 1] > 6.6) & (np.abs(skin.base[:, 0]) < 0.8)]
        low, high = above.min(0), above.max(0)
        self.center: Floats = np.array((0.0, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2), float)
        self.neck = (figure.joint("neck") - self.center) / self.radius
        self.weights = bone_weights("head")
        self.parts: dict[str, list[Sheet]] = {}

    def place(self, point: tuple[float, float, float]) -> Floats:
        """Return metres of a point of the head."""
        return self.center + np.array(point) * self.radius

    def ball(
        self,
        tint: str,
        at: tuple[float, float, float],
        half: tuple[float, float, float],
        turn: tuple[float, float, float] = (0, 0, 0),
    ) -> None:
        """Add an ellipsoid."""
        sheet = ball(self.place(at), np.array(half) * self.radius, self.weights, rotation=turn)
        self.parts.setdefault(tint, []).append(sheet)

    def bar(self, tint: str, points: Sequence[tuple[float, float, float]], radii: Sequence[float]) -> None:
        """Add a bar of changing thickness."""
        path = [self.place(point) for point in points]
        sheet = bar(path, [radius * self.radius for radius in radii], self.weights)
        self.parts.setdefault(tint, []).append(sheet)

    def bolts(self) -> list[Bolt]:
        """Return one sheet for each tint."""
        return [Bolt(join(sheets), tint, "knit") for tint, sheets in self.parts.items()]


def build_animal_head(figure: Figure, species: Species) -> list[Bolt]:
    """Return the head of an animal, with a neck down into the collar; its coat has the tint ``main``."""
    head = Head(figure, species)
    head.ball("main", (0, 0, 0), (0.98, 1.02, 1.04))
    _, y, z = (float(value) for value in head.neck)
    head.bar("main", [(0, y, z - 0.25), (0, y * 0.7, z * 0.55), (0, 0, -0.3)], [0.62, 0.6, 0.66])
    _eyes(head)
    _mouth(head)
    _ears(head)
    for mark in species.marks:
        _MARKS[mark](head)
    return head.bolts()


def _eyes(head: Head) -> None:
    up, out = (0.72, 0.5) if "goggles" in head.species.marks else (0.26, 0.4)
    ahead = -0.62 if "goggles" in head.species.marks else -1.0 if "stripes" in head.species.marks else -0.86
    for x in (-1, 1):
        head.ball(WHITE, (x * out, ahead, up), (0.17, 0.1, 0.2))
        head.ball(DARK, (x * (out - 0.02), ahead - 0.08, up - 0.01), (0.09, 0.05, 0.12))
        head.ball(WHITE, (x * (out - 0.05), ahead - 0.125, up + 0.04), (0.03, 0.02, 0.03))


def _mouth(head: Head) -> None:
    (long, thick), pale = head.species.snout, head.species.pale or "main"
    tip = -0.72 - long
    match head.species.mouth:
        case "snout":
            radii = [thick * 1.25, thick, thick * 0.78, thick * 0.45]
            points = [(0, -0.5, -0.2), (0, -0.72 - long * 0.35, -0.24), (0, tip + 0.1, -0.27), (0, tip, -0.27)]
            head.bar(pale, points, radii)
            head.ball(DARK, (0, tip - 0.02, -0.27 + thick * 0.42), (thick * 0.42, 0.12, thick * 0.3))
            smile = [
                (-thick * 0.72, tip + 0.3, -0.42),
                (0, tip + 0.02, -0.27 - thick * 0.6),
                (thick * 0.72, tip + 0.3, -0.42),
            ]
            head.bar(DARK, smile, [0.02, 0.025, 0.02])
        case "cone":
            head.bar(
                pale, [(0, -0.7, -0.05), (0, -0.95, -0.08), (0, tip - 0.25, -0.16)], [thick * 1.1, thick * 0.9, 0.02]
            )
        case "hook":
            head.bar(pale, [(0, -0.8, 0.05), (0, -1.15, 0.0), (0, -1.18, -0.3)], [thick * 1.2, thick, 0.03])
        case "flat":
            head.ball(pale, (0, -0.75 - long * 0.5, -0.16), (thick * 1.05, long * 0.75, 0.11))
            head.ball(pale, (0, -0.7 - long * 0.42, -0.3), (thick * 0.95, long * 0.62, 0.08))
        case "wide":
            head.ball(pale, (0, -0.62, -0.3), (thick * 0.95, 0.55, 0.34))
            head.bar(
                DARK,
                [(-thick * 0.85, -0.78, -0.2), (0, -1.16, -0.3), (thick * 0.85, -0.78, -0.2)],
                [0.022, 0.03, 0.022],
            )
        case "trunk":
            points = [(0, -0.7, -0.1), (0, -1.3, -0.5), (0, -1.35, -1.2), (0, -1.45, -1.6), (0, -1.75, -1.7)]
            head.bar("main", points, [0.44, 0.34, 0.25, 0.2, 0.18])
            for x in (-1, 1):
                head.bar(
                    WHITE,
                    [(x * 0.35, -0.75, -0.45), (x * 0.5, -1.1, -0.8), (x * 0.48, -1.45, -0.75)],
                    [0.12, 0.1, 0.02],
                )


def _ears(head: Head) -> None:
    size, inner = head.species.ears, head.species.pale or "dark"
    for x in (-1, 1):
        match head.species.ear:
            case "round":
                head.ball("main", (x * 0.68, 0.05, 0.82), (0.32 * size, 0.13, 0.32 * size), (0, x * 30, 0))
                head.ball(inner, (x * 0.68, -0.05, 0.82), (0.2 * size, 0.07, 0.2 * size), (0, x * 30, 0))
            case "point":
                foot, top = (x * 0.52, 0.02, 0.7), (x * 0.78, 0.0, 0.85 + 0.62 * size)
                middle = tuple((a + b) / 2 for a, b in zip(foot, top, strict=True))
                head.bar("main", [foot, (middle[0], middle[1], middle[2]), top], [0.34 * size, 0.22 * size, 0.02])
            case "long":
                head.ball("main", (x * 0.4, 0.1, 0.95 + 0.7 * size), (0.2, 0.1, 0.9 * size), (0, x * 12, 0))
                head.ball(inner, (x * 0.4, 0.02, 0.95 + 0.7 * size), (0.11, 0.05, 0.7 * size), (0, x * 12, 0))
            case "flop":
                head.ball("dark", (x * 0.92, 0.0, 0.22), (0.14, 0.3 * size, 0.62 * size), (0, x * -14, 0))
            case "side":
                head.ball("main", (x * (0.9 + 0.3 * size), 0.1, 0.4), (0.44 * size, 0.12, 0.26 * size), (0, x * 12, 0))
            case "none":
                pass


def _stripes(head: Head) -> None:
    for x, tint, radius in ((0.0, WHITE, 0.24), (-0.42, DARK, 0.2), (0.42, DARK, 0.2)):
        points = [
            (x, 0.6, 0.86),
            (x, -0.2, 1.0),
            (x * 1.02, -0.78, 0.62),
            (x * 0.86, -0.98, 0.16),
            (x * 0.4, -1.25, -0.05),
        ]
        head.bar(tint, points, [radius * 0.8, radius, radius * 0.95, radius * 0.7, radius * 0.3])


def _spines(head: Head) -> None:
    for step in range(150):
        up, turn = 1 - 1.5 * (step + 0.5) / 150, 2.39996 * step
        across = np.sqrt(max(0.0, 1 - up * up))
        x, y = across * np.cos(turn), across * np.sin(turn)
        if (y > -0.35 and up > -0.4) or up > 0.62:
            end = (x * 1.42, y * 1.42 + 0.12, up * 1.42)
            head.bar("dark", [(x * 0.95, y * 0.95, up * 0.95), end], [0.055, 0.008])


def _cheeks(head: Head) -> None:
    for x in (-1, 1):
        head.ball(WHITE, (x * 0.5, -0.52, -0.42), (0.5, 0.42, 0.36), (0, x * 20, 0))


def _whiskers(head: Head) -> None:
    long = head.species.snout[0]
    for x in (-1, 1):
        for lift in (-0.12, 0.0, 0.12):
            foot = (x * 0.26, -0.72 - long * 0.6, -0.3 + lift * 0.4)
            head.bar(DARK, [foot, (x * 1.1, -0.75 - long * 0.4, -0.32 + lift * 2.2)], [0.014, 0.006])


def _mane(head: Head) -> None:
    for row, (y, reach, count) in enumerate(((-0.2, 1.12, 13), (0.2, 1.3, 13), (0.6, 1.15, 11))):
        for step in range(count):
            turn = 2 * np.pi * (step + 0.5 * row) / count
            head.ball("#6b4020", (reach * np.sin(turn), y, reach * np.cos(turn)), (0.34, 0.32, 0.38))


def _bands(head: Head) -> None:
    for y, wide in ((-0.55, 0.5), (-0.25, 0.75), (0.1, 0.9)):
        up = np.sqrt(max(0.0, 1.06 - y * y))
        points = [(wide * np.sin(t), y, up * np.cos(t)) for t in np.linspace(-0.8, 0.8, 7)]
        head.bar(DARK, points, [0.02, 0.05, 0.06, 0.07, 0.06, 0.05, 0.02])
    for x in (-1, 1):
        for z in (-0.35, -0.08):
            head.bar(DARK, [(x * 0.98, -0.2, z), (x * 0.8, -0.6, z - 0.04), (x * 0.6, -0.8, z)], [0.02, 0.06, 0.02])


def _patches(head: Head) -> None:
    for x in (-1, 1):
        head.ball(DARK, (x * 0.42, -0.74, 0.22), (0.28, 0.2, 0.34), (0, x * -24, 0))
        head.ball(DARK, (x * 0.68, 0.02, 0.84), (0.34, 0.16, 0.34), (0, x * 30, 0))


def _mask(head: Head) -> None:
    head.ball("#2a2826", (0, -0.6, 0.22), (0.84, 0.34, 0.26))


def _disc(head: Head) -> None:
    tip = -0.72 - head.species.snout[0]
    head.ball("dark", (0, tip, -0.24), (0.36, 0.08, 0.32))
    for x in (-1, 1):
        head.ball(DARK, (x * 0.14, tip - 0.07, -0.24), (0.07, 0.04, 0.1))


def _horns(head: Head) -> None:
    for x in (-1, 1):
        points = [(x * 0.45, 0.0, 0.85), (x * 0.85, 0.05, 1.15), (x * 0.95, 0.1, 1.6)]
        head.bar("#d8cdb0", points, [0.16, 0.12, 0.02])


def _antlers(head: Head) -> None:
    for x in (-1, 1):
        head.bar(
            "#c9b48a",
            [(x * 0.35, 0.1, 0.9), (x * 0.7, 0.2, 1.5), (x * 1.3, 0.2, 1.9), (x * 1.3, 0.1, 2.5)],
            [0.1, 0.09, 0.07, 0.03],
        )
        head.bar("#c9b48a", [(x * 0.7, 0.2, 1.5), (x * 0.7, -0.2, 2.0)], [0.07, 0.02])
        head.bar("#c9b48a", [(x * 1.3, 0.2, 1.9), (x * 1.75, 0.1, 2.2)], [0.06, 0.02])


def _crest(head: Head) -> None:
    for step in range(7):
        turn = -0.5 + 0.42 * step
        head.ball("#241a14", (0, np.sin(turn) * 1.02, np.cos(turn) * 1.02), (0.13, 0.26, 0.26))


def _beard(head: Head) -> None:
    tip = -0.72 - head.species.snout[0]
    head.bar("main", [(0, tip + 0.25, -0.5), (0, tip + 0.2, -0.95), (0, tip + 0.3, -1.3)], [0.16, 0.13, 0.02])


def _wool(head: Head) -> None:
    for step in range(46):
        up, turn = 1 - 1.25 * (step + 0.5) / 46, 2.39996 * step
        across = np.sqrt(max(0.0, 1 - up * up))
        x, y = across * np.cos(turn), across * np.sin(turn)
        if y > -0.5 or up > 0.7:
            head.ball("main", (x, y, up), (0.3, 0.3, 0.3))


def _discs(head: Head) -> None:
    for x in (-1, 1):
        head.ball("#e4d8bc", (x * 0.4, -0.76, 0.26), (0.42, 0.16, 0.44))
        head.ball("#d8a520", (x * 0.4, -0.9, 0.26), (0.25, 0.09, 0.27))
        head.ball(DARK, (x * 0.39, -0.97, 0.26), (0.12, 0.05, 0.15))


def _comb(head: Head) -> None:
    for step, size in enumerate((0.2, 0.28, 0.26, 0.2)):
        head.ball("#a3242a", (0, -0.45 + 0.28 * step, 1.1), (0.08, 0.2, size))
    head.ball("#a3242a", (0, -1.0, -0.5), (0.1, 0.14, 0.28))


def _no_mark(head: Head) -> None:
    """Goggling eyes are placed with the others."""


_MARKS: dict[str, Callable[[Head], None]] = {
    "stripes": _stripes, "spines": _spines, "cheeks": _cheeks, "whiskers": _whiskers, "mane": _mane, "bands": _bands,
    "patches": _patches, "mask": _mask, "disc": _disc, "horns": _horns, "antlers": _antlers, "crest": _crest,
    "beard": _beard, "wool": _wool, "discs": _discs, "comb": _comb, "goggles": _no_mark,
}  # fmt: skip
