"""Growths on the head of an animal: ears, nose, horns, antlers, comb, mane, spines, whiskers, teeth."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from storyblender.blender.people.animal_heads import AnimalHead, Point, add_ear
from storyblender.blender.people.animal_skull import WHITE

_HORN, _BONE, _IVORY = "#cfc3a4", "#b59a6a", "#efe6cf"
_PINK, _RED = "#c99a8e", "#b3262a"


def add_growths(head: AnimalHead) -> None:
    """Add the ears, the nose and the growths of its species to a head."""
    _ears(head)
    _nose(head)
    for mark in head.species.marks:
        if mark in GROWTHS:
            GROWTHS[mark](head)


def _both(points: list[Point]) -> list[list[Point]]:
    """Return a path on the animal's left, and its mirror image on the right."""
    return [points, [(-x, y, z) for x, y, z in points]]


def _add_pair(head: AnimalHead, color: str, path: list[Point], radii: Sequence[float]) -> None:
    """Add a bar on the animal's left, and its mirror image."""
    for points in _both(path):
        head.add_bar(color, points, radii)


def _ears(head: AnimalHead) -> None:
    """Add both ears."""
    species, size = head.species, head.species.ears
    name = species.words[0]
    inner = _PINK if name in ("mouse", "rat", "rabbit", "cat", "pig") else "pale" if species.pale else "dark"
    back = "#1d1b1b" if name in ("fox", "panda") else "main"
    match species.ear:
        case "round":
            path: list[Point] = [(0.55, 0.1, 0.62), (0.55 + 0.4 * size, 0.14, 0.72 + 0.55 * size)]
            if "lowears" in species.marks:
                path = [(0.86, 0.1, 0.05), (1.2, 0.12, 0.42)]
            widths = [0.16 * size, 0.32 * size, 0.36 * size, 0.32 * size, 0.05]
            facing, thin = (0.25, -1.0, 0.1), 0.28
            inner = WHITE if "stripes" in species.marks else "#2c2726" if name == "panda" else inner
        case "point":
            path = [(0.5, 0.12, 0.6), (0.66 + 0.16 * size, 0.16, 0.8 + 0.62 * size)]
            widths = [0.36 * size, 0.36 * size, 0.27 * size, 0.15 * size, 0.01]
            facing, thin = (0.35, -1.0, 0.0), 0.2
        case "long":
            path = [(0.3, 0.15, 0.75), (0.42, 0.2, 0.9 + 0.8 * size), (0.52, 0.12, 0.95 + 1.5 * size)]
            widths = [0.13, 0.22, 0.25, 0.2, 0.02]
            facing, thin = (0.25, -1.0, 0.1), 0.2
        case "flop":
            path = [(0.6, 0.1, 0.72), (0.98, 0.05, 0.66), (1.1, -0.02, 0.66 - 0.62 * size)]
            path.append((1.06, -0.08, 0.5 - 0.95 * size))
            widths = [0.16, 0.27 * size, 0.34 * size, 0.34 * size, 0.06]
            facing, thin, back, inner = (1.0, -0.4, 0.2), 0.16, "dark", "dark"
        case "side":
            path = [(0.74, 0.12, 0.46), (1.15 + 0.2 * size, 0.16, 0.5), (1.3 + 0.4 * size, 0.16, 0.34)]
            widths = [0.12, 0.26 * size, 0.25 * size, 0.16 * size, 0.02]
            facing, thin = (0.0, -1.0, -0.3), 0.2
        case "fan":
            path = [(0.7, 0.15, 0.3), (1.35, 0.25, 0.25), (1.95, 0.2, -0.02)]
            widths = [0.45, 0.85, 0.92, 0.78, 0.15]
            facing, thin, inner = (0.15, -1.0, 0.0), 0.07, "#a38f90"
        case "none":
            return
    for points in _both(path):
        side = 1.0 if points[0][0] > 0 else -1.0
        add_ear(head, points, widths, (side * facing[0], facing[1], facing[2]), (back, inner), thin)


def _nose(head: AnimalHead) -> None:
    """Add the nose of a snout."""
    species, skull = head.species, head.skull
    if species.mouth != "snout" or {"disc", "nostrils", "nosehorn"} & {*species.marks}:
        return
    thick, (_, y, z) = skull.thick, skull.tip
    size = 0.4 if "bignose" not in species.marks else 0.75
    front, top = float(y) - thick * 0.58, float(z) + thick * 0.38
    head.add_ball(species.nose, (0, front, top), (max(0.1, thick * size), 0.13, max(0.09, thick * size * 0.72)))
    head.add_ball("#8d8a86", (0.04, front - 0.11, top + 0.05), (0.035, 0.015, 0.02))


def _nostrils(head: AnimalHead) -> None:
    """Add nostrils on a broad snout."""
    thick, (_, y, z) = head.skull.thick, head.skull.tip
    for x in (-1, 1):
        at = (x * thick * 0.42, y - 0.24 - 0.1 * thick, z + 0.18)
        head.add_ball("#241a18", at, (0.075, 0.06, 0.1), (0, x * 20, 0))


def _disc(head: AnimalHead) -> None:
    """Add the snout of a pig."""
    thick, (_, y, z) = head.skull.thick, head.skull.tip
    head.add_ball("pale", (0, y - 0.28, z + 0.08), (thick * 0.82, 0.1, thick * 0.7))
    for x in (-1, 1):
        head.add_ball("#5a2f2a", (x * 0.13, y - 0.36, z + 0.08), (0.065, 0.04, 0.1))


def _whiskers(head: AnimalHead) -> None:
    """Add three whiskers on each side."""
    thick, (_, y, z) = head.skull.thick, head.skull.tip
    for lift in (-0.1, 0.0, 0.1):
        path: list[Point] = [(thick * 0.5, y + 0.05, z + 0.02 + lift * 0.4), (0.8, y + 0.1, z + 0.05 + lift * 1.6)]
        _add_pair(head, "#d8d4cc", [*path, (1.2, y + 0.3, z + lift * 2.4)], [0.012, 0.01, 0.004])


def _teeth(head: AnimalHead) -> None:
    """Add two front teeth."""
    thick, (_, y, z) = head.skull.thick, head.skull.tip
    for x in (-1, 1):
        head.add_ball(_IVORY, (x * 0.062, y - thick * 0.42, z - thick * 0.52), (0.058, 0.035, 0.12))


def _antenna(head: AnimalHead) -> None:
    """Add an antenna with a lamp."""
    head.add_bar("dark", [(0, 0.1, 0.85), (0, 0.12, 1.35)], [0.05, 0.03])
    head.add_ball("#d24a2a", (0, 0.12, 1.4), (0.1, 0.1, 0.1))


def _bolts(head: AnimalHead) -> None:
    """Add a round plate at each temple."""
    for x in (-1, 1):
        head.add_ball("dark", (x * 0.98, 0.1, 0.1), (0.12, 0.3, 0.3))
        head.add_ball("pale", (x * 1.08, 0.1, 0.1), (0.08, 0.14, 0.14))


def _fangs(head: AnimalHead) -> None:
    """Add a row of teeth along each side of the snout."""
    thick, (_, y, z) = head.skull.thick, head.skull.tip
    for step in range(4):
        x, deep = thick * 0.74, float(y) + 0.05 + 0.26 * step
        _add_pair(head, _IVORY, [(x, deep, z - thick * 0.4), (x * 1.05, deep, z - thick * 0.4 - 0.15)], [0.05, 0.004])


def _tusks(head: AnimalHead) -> None:
    """Add tusks that stand up from the lower jaw."""
    thick, (_, y, z) = head.skull.thick, head.skull.tip
    path: list[Point] = [(thick * 0.7, y + 0.2, z - 0.2), (thick, y + 0.08, z), (thick * 0.9, y + 0.08, z + 0.26)]
    _add_pair(head, _IVORY, path, [0.06, 0.05, 0.005])


def _ivory(head: AnimalHead) -> None:
    """Add the tusks beside a trunk."""
    _add_pair(head, _IVORY, [(0.42, -0.7, -0.5), (0.56, -1.1, -0.85), (0.5, -1.55, -0.75)], [0.11, 0.09, 0.01])


def _mane(head: AnimalHead) -> None:
    """Add a ring of locks around the face and down the neck."""
    for row, (y, reach, count) in enumerate(((-0.28, 1.28, 20), (0.05, 1.42, 20), (0.4, 1.38, 18), (0.75, 1.1, 12))):
        for step in range(count):
            turn = 2 * np.pi * (step + 0.5 * (row % 2)) / count
            x, z = float(np.sin(turn)), float(np.cos(turn))
            long = reach * (1.12 if z < 0 else 1.0)
            path = [(0.7 * x, y, 0.7 * z), (1.05 * x, y + 0.02, 1.05 * z), (long * x, y + 0.2, long * z - 0.06)]
            head.add_bar("#8a4f20" if (step + row) % 3 else "#6b3a16", path, [0.2, 0.2, 0.02])


def _spines(head: AnimalHead) -> None:
    """Add spines over the back of the head."""
    for step in range(240):
        up, turn = 1 - 1.7 * (step + 0.5) / 240, 2.39996 * step
        across = np.sqrt(max(0.0, 1 - up * up))
        x, y = float(across * np.cos(turn)), float(across * np.sin(turn))
        if y > -0.12 or up > 0.72:
            end = (x * 1.38, y * 1.38 + 0.14, up * 1.36)
            head.add_bar("#5a4634" if step % 3 else "#d8c4a0", [(x * 0.9, y * 0.92, up * 0.92), end], [0.06, 0.008])


def _horns(head: AnimalHead) -> None:
    """Add a pair of horns."""
    path: list[Point] = [(0.5, 0.1, 0.72), (0.98, 0.08, 0.95), (1.12, 0.0, 1.4)]
    if head.species.words[0] in ("goat", "dragon"):  # they lean back
        path = [(0.3, 0.05, 0.82), (0.42, 0.3, 1.35), (0.55, 0.7, 1.6)]
    _add_pair(head, _HORN, path, [0.15, 0.12, 0.015])


def _curls(head: AnimalHead) -> None:
    """Add the curled horns of a ram."""
    turns = np.linspace(1.3, 6.4, 12)
    path = [
        (0.8 + 0.05 * step, 0.15 - 0.45 * float(np.cos(turn)), 0.25 + 0.45 * float(np.sin(turn)))
        for step, turn in enumerate(turns)
    ]
    _add_pair(head, _HORN, path, list(np.linspace(0.2, 0.03, 12)))


def _antlers(head: AnimalHead) -> None:
    """Add branched antlers."""
    stem: list[Point] = [(0.3, 0.1, 0.85), (0.6, 0.3, 1.4), (1.0, 0.3, 1.9), (0.95, 0.1, 2.5)]
    _add_pair(head, _BONE, stem, [0.1, 0.085, 0.07, 0.015])
    tines: list[list[Point]] = [
        [stem[1], (0.75, -0.15, 1.85)], [stem[2], (1.4, 0.2, 2.3)], [(0.4, 0.16, 1.05), (0.5, -0.3, 1.3)],
    ]  # fmt: skip
    for tine in tines:
        _add_pair(head, _BONE, tine, [0.068, 0.012])


def _palms(head: AnimalHead) -> None:
    """Add the flat, broad antlers of a moose."""
    ends = (((1.3, 1.25), (1.1, 1.8)), ((1.5, 1.4), (1.4, 2.1)), ((1.7, 1.55), (1.8, 2.3)), ((1.75, 1.45), (2.3, 1.95)),
            ((1.65, 1.25), (2.2, 1.4)))  # fmt: skip
    _add_pair(head, _BONE, [(0.4, 0.1, 0.75), (0.85, 0.15, 1.0), (1.2, 0.15, 1.15)], [0.11, 0.11, 0.12])
    for points in _both([(1.05, 0.15, 1.05), (1.6, 0.15, 1.3), (2.0, 0.1, 1.75)]):
        add_ear(head, points, [0.16, 0.4, 0.46, 0.36, 0.1], (0, -1, 0.3), (_BONE, _BONE), 0.1)
    for root, end in ends:
        _add_pair(head, _BONE, [(root[0], 0.13, root[1]), (end[0], 0.05, end[1])], [0.1, 0.015])


def _onehorn(head: AnimalHead) -> None:
    """Add the horn of a unicorn."""
    head.add_bar("#e8d8a8", [(0, -0.7, 0.7), (0, -0.95, 1.2), (0, -1.2, 1.75)], [0.12, 0.08, 0.008])


def _nosehorn(head: AnimalHead) -> None:
    """Add the horns of a rhinoceros."""
    _, y, z = head.skull.tip
    head.add_bar(
        "#b5ad9c", [(0, y + 0.05, z + 0.3), (0, y - 0.25, z + 0.75), (0, y - 0.2, z + 1.15)], [0.22, 0.15, 0.01]
    )
    head.add_bar("#b5ad9c", [(0, y + 0.5, z + 0.35), (0, y + 0.4, z + 0.7)], [0.15, 0.01])


def _knobs(head: AnimalHead) -> None:
    """Add the horns of a giraffe."""
    for x in (-1, 1):
        head.add_bar("#b5883c", [(x * 0.25, 0.1, 0.8), (x * 0.3, 0.12, 1.4)], [0.07, 0.06])
        head.add_ball("#4a3424", (x * 0.3, 0.12, 1.45), (0.1, 0.1, 0.1))


def _crest(head: AnimalHead) -> None:
    """Add a mane along the top of the head and down the neck, with a forelock."""
    color = head.species.tip or "#241a14"
    for step in range(11):
        turn = -0.45 + 0.27 * step
        head.add_ball(color, (0, float(np.sin(turn)), float(np.cos(turn))), (0.13, 0.2, 0.24))
    for x in (-0.12, 0.0, 0.12):
        head.add_bar(color, [(x, -0.35, 0.98), (x * 1.4, -0.8, 0.85), (x * 2, -0.98, 0.5)], [0.14, 0.12, 0.01])


def _beard(head: AnimalHead) -> None:
    """Add the beard of a goat."""
    thick, (_, y, z) = head.skull.thick, head.skull.tip
    top = float(z) - thick * 0.8
    for x in (-0.1, 0.0, 0.1):
        path = [(x, y + 0.22, top), (x * 0.9, y + 0.2, top - 0.4), (x * 0.2, y + 0.32, top - 0.75)]
        head.add_bar("main", path, [0.14, 0.12, 0.01])


def _wool(head: AnimalHead) -> None:
    """Add the wool of a sheep."""
    for step in range(60):
        up, turn = 1 - 1.35 * (step + 0.5) / 60, 2.39996 * step
        across = np.sqrt(max(0.0, 1 - up * up))
        x, y = float(across * np.cos(turn)), float(across * np.sin(turn))
        if y > -0.2 or up > 0.66:
            head.add_ball("main", (x * 0.9, y * 0.9, up * 0.92), (0.27, 0.27, 0.26))


def _comb(head: AnimalHead) -> None:
    """Add the comb and wattles of a rooster."""
    for step, size in enumerate((0.24, 0.34, 0.32, 0.24)):
        head.add_ball(_RED, (0, -0.5 + 0.26 * step, 1.02 - 0.05 * step), (0.08, 0.19, size))
    for x in (-1, 1):
        head.add_ball(_RED, (x * 0.14, -0.92, -0.52), (0.1, 0.1, 0.26))


GROWTHS: dict[str, Callable[[AnimalHead], None]] = {
    "spines": _spines, "whiskers": _whiskers, "mane": _mane, "disc": _disc, "nostrils": _nostrils, "horns": _horns,
    "antlers": _antlers, "palms": _palms, "crest": _crest, "beard": _beard, "wool": _wool, "comb": _comb,
    "curls": _curls, "onehorn": _onehorn, "nosehorn": _nosehorn, "knobs": _knobs, "teeth": _teeth, "fangs": _fangs,
    "antenna": _antenna, "bolts": _bolts, "tusks": _tusks, "ivory": _ivory,
}  # fmt: skip
"""Builder of each growth on the head; painted markings are in ``animal_skull``."""
