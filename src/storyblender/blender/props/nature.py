"""Prop builders: trees, bushes, rocks, logs, fire. One mesh a seed; yaw and scale make a wood of a few."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender import plants
from storyblender.blender.mesh_builder import Floats, MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, grips_under, lean, seat, seats_in_row
from storyblender.blender.props.registry import PropSpec, prop


@prop("tree")
def tree(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a broad-leaved tree; ``kind`` pine gives a conifer."""
    if spec.word("kind") == "pine":
        return pine(b, spec)
    (w, _, h), leaf = spec.size, spec.material("leaf")
    plants.broad_tree(b, spec.material("bark"), (leaf, leaf), (w, h), spec.rng)
    return (lean((0, -0.03 * h, 1.2), 0.3),)


@prop("pine")
def pine(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a conifer of drooping whorls."""
    w, _, h = spec.size
    plants.conifer(b, spec.material("bark"), spec.material("leaf"), (w, h), spec.rng)
    return (lean((0, -0.2, 1.2), 0.3),)


@prop("christmas_tree")
def christmas_tree(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a small conifer in a bucket, hung with balls, a star on top."""
    w, _, h = spec.size
    pot, tall = 0.28, h - 0.12
    b.cylinder("sheet_metal", (0, 0, 0), (0, 0, pot), 0.15, 0.19, segments=18)
    b.cylinder("dirt", (0, 0, pot - 0.03), (0, 0, pot - 0.01), 0.185, segments=18)
    with b.at((0, 0, pot - 0.05)):
        plants.conifer(b, spec.material("bark"), spec.material("leaf"), (w, tall - pot), spec.rng, 0.1)
    for k in range(26):
        share = (k + 0.5) / 26
        turn, reach = k * plants.GOLDEN_TURN, w * (0.4 * (1 - share) ** 0.85 + 0.04)
        spot = (reach * math.cos(turn), reach * math.sin(turn), pot + 0.12 + (tall - pot - 0.25) * share)
        b.sphere(spec.material("ball" if k % 3 else "star"), spot, 0.032, segments=10, rings=6)
    points = [
        (r * math.sin(math.pi * k / 5), r * math.cos(math.pi * k / 5))
        for k in range(10)
        for r in (0.1 - 0.06 * (k % 2),)
    ]
    with b.at((0, 0.01, h - 0.1), (90, 0, 0)):
        b.extrude(spec.material("star"), points, 0.02)
    return ()


@prop("palm_tree")
def palm_tree(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a palm."""
    w, _, h = spec.size
    plants.palm(b, spec.material("bark"), spec.material("leaf"), (w, h), spec.rng)
    return (lean((0, -0.04 * h, 1.2), 0.3),)


@prop("dead_tree")
def dead_tree(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bare tree of three generations of branches."""
    (w, _, h), bark, rng = spec.size, spec.material("bark"), spec.rng
    radius, leans = h * 0.021, rng.uniform(-0.3, 0.3, 2)
    plants.trunk(b, bark, h * 0.8, radius, leans, rng)

    def branch(start: Floats, direction: Floats, length: float, thick: float, depth: int) -> None:
        """Add a branch and, ``depth`` levels deep, the branches that grow from it."""
        middle = start + direction * length * 0.5 + rng.uniform(-0.08, 0.08, 3) * length
        tip = start + direction * length + np.array([0, 0, 0.12 * length])
        b.tube(bark, [start, middle, tip], [thick, thick * 0.7, thick * 0.25], segments=6)
        if depth:
            for _ in range(3):
                turned = direction + rng.uniform(-0.75, 0.75, 3) + np.array([0, 0, 0.25])
                branch(
                    middle + (tip - middle) * float(rng.uniform(0, 0.9)),
                    turned / np.linalg.norm(turned),
                    length * 0.55,
                    thick * 0.5,
                    depth - 1,
                )

    for k in range(7):
        t, turn = 0.45 + 0.5 * k / 6, 2.4 * k
        start = plants.along_trunk(h * 0.8, leans, t)
        direction = np.array([math.cos(turn), math.sin(turn), 0.65])
        branch(start, direction / np.linalg.norm(direction), w * 0.5 * (1.15 - 0.5 * t), radius * 0.37, 2)
    return (lean((0, -radius, 1.2), 0.3),)


@prop("bush")
def bush(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bush."""
    plants.bush(b, spec.material("leaf"), spec.size, spec.rng)
    return ()


@prop("tuft")
def tuft(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tuft of grass blades."""
    w, _, h = spec.size
    plants.blades(b, spec.material("leaf"), 26, (w * 0.2, h), 0.009, spec.rng)
    return ()


@prop("rock")
def rock(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a boulder with flattened sides; the top too, where it is as high as a seat."""
    w, d, h = spec.size
    sat_on = 0.35 < h < 0.95
    top = h * 0.82 if sat_on else math.inf
    plants.boulder(b, spec.material("rock"), (w * 0.6, d * 0.6, h * 0.86), spec.rng, foot=0.0, top=top)
    return (seat((0, -d * 0.36, top), (w * 0.6, d * 0.5)),) if sat_on else ()


@prop("standing_stone")
def standing_stone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a boulder set upright, a head and more over people."""
    w, d, h = spec.size
    plants.boulder(b, spec.material("rock"), (w * 0.6, d * 0.6, h * 0.86), spec.rng, foot=0.0)
    return ()


def _cut_trunk(
    b: MeshBuilder, bark: MaterialRef, cut: MaterialRef, length: float, radius: float, rng: np.random.Generator
) -> None:
    """Add a piece of trunk along +Z from the origin, with rings on both ends."""
    angle = np.linspace(0, math.tau, 20, endpoint=False)
    lumps = 1 + 0.05 * np.sin(3 * angle + rng.uniform(0, 6)) + 0.04 * np.sin(7 * angle)
    rings = [
        np.c_[radius * lumps * np.cos(angle) * s, radius * lumps * np.sin(angle) * s, np.full(20, z)]
        for z, s in ((0, 1.0), (length * 0.35, 0.95), (length * 0.7, 0.97), (length, 0.94))
    ]
    b.loft(bark, rings, caps=False)
    b.polygon(cut, rings[-1])
    b.polygon(cut, rings[0][::-1])
    for z, sign in ((length, 1), (0.0, -1)):
        for share in (0.3, 0.6, 0.85):
            loop = np.c_[radius * share * np.cos(angle), radius * share * np.sin(angle), np.full(20, z + sign * 0.001)]
            b.tube("wood", loop, 0.003, segments=4, closed=True)


@prop("log")
def log(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fallen trunk along X."""
    w, d, h = spec.size
    bark, cut = spec.material("bark"), spec.material("cut")
    r = min(d, h) / 2 * 0.93
    with b.at((-w / 2, 0, r), (0, 90, 0)):
        _cut_trunk(b, bark, cut, w, r, spec.rng)
    b.cylinder(bark, (w * 0.2, 0, r), (w * 0.26, -0.04, h + 0.02), 0.06, 0.05, segments=10)
    return seats_in_row(spec.entry.seats, w * 0.8, -r * 0.55, 2 * r, d * 0.6)


@prop("stump")
def stump(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tree stump with roots."""
    (w, _, h), bark = spec.size, spec.material("bark")
    _cut_trunk(b, bark, spec.material("cut"), h, w * 0.38, spec.rng)
    for k in range(6):
        with b.at(rotation=(0, 0, 60 * k + 11)):
            path = [(w * 0.3, 0, h * 0.34), (w * 0.38, 0, h * 0.12), (w * 0.5, 0, 0.0)]
            b.tube(bark, path, (0.05, 0.06, 0.02), segments=8)
    return (seat((0, -w * 0.34, h), (w * 0.66, w * 0.66)),)


def _tongue(
    b: MeshBuilder, fire: MaterialRef, reach: float, turn: float, height: float, rng: np.random.Generator
) -> None:
    """Add a tongue of flame ``reach`` metres from the middle, that licks inwards and to its side as it rises."""
    out, side = np.array((math.cos(turn), math.sin(turn), 0.0)), np.array((-math.sin(turn), math.cos(turn), 0.0))
    sway = reach * float(rng.uniform(-0.6, 0.6))
    line = [
        out * reach * share + side * sway * bend + (0.0, 0.0, 0.04 + rise * (height - 0.04))
        for share, bend, rise in (
            (0.9, 0.0, 0.0), (1.1, 0.4, 0.22), (0.75, 1.0, 0.5), (0.7, 0.2, 0.76), (0.5, 0.9, 1.0),
        )
    ]  # fmt: skip
    wide = 0.3 * height * min(1.0, 0.35 + reach / 0.3)
    b.tube(fire, line, [share * wide for share in (0.22, 0.36, 0.27, 0.13, 0.01)], segments=9)


@prop("campfire")
def campfire(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a camp fire; ``lit`` gives it flames."""
    (w, _, h), wood, stone, rng = spec.size, spec.material("wood"), spec.material("stone"), spec.rng
    for k in range(11):
        turn = math.tau * k / 11
        size = float(rng.uniform(0.085, 0.12))
        center = (w * 0.42 * math.cos(turn), w * 0.42 * math.sin(turn), size * 0.4)
        b.cushion(
            stone, center, (size * 1.5, size * 1.3, size), softness=0.6, rotation=(0, 0, float(rng.uniform(0, 180)))
        )
    for k in range(6):
        turn = 60 * k + 12
        with b.at(rotation=(0, 0, turn)):
            b.cylinder(wood, (w * 0.32, 0, 0.03), (0.02, 0, h * 0.42), 0.032, 0.026, segments=9)
    b.sphere(spec.material("ember"), (0, 0, 0.02), w * 0.24, scale=(1, 1, 0.24), segments=16, rings=8)
    if spec.flag("lit"):
        for k in range(11):
            _tongue(b, spec.material("fire"), w * 0.17, 2.4 * k, h * float(rng.uniform(0.55, 1.0)), rng)
        for k in range(3):
            _tongue(b, spec.material("core"), w * 0.05, 2.1 * k, h * float(rng.uniform(0.3, 0.45)), rng)
    return ()


@prop("hay_bale")
def hay_bale(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a square bale tied with twine."""
    (w, d, h), straw = spec.size, spec.material("straw")
    b.rounded_box(straw, (0, 0, h / 2), (w, d, h), 0.05)
    for x in (-0.22, 0.22):
        b.rounded_box("wood_dark", (x * w, 0, h / 2), (0.012, d + 0.008, h + 0.008), 0.004)
    for _ in range(40):
        face = int(spec.rng.integers(3))
        u, v = spec.rng.uniform(-0.46, 0.46, 2)
        place = ((u * w, -d / 2, h * (0.5 + v)), (u * w, v * d, h), (w / 2, u * d, h * (0.5 + v)))[face]
        tip = np.array(place) + spec.rng.uniform(-0.05, 0.05, 3)
        b.cylinder(straw, place, tip, 0.003, segments=4)
    return seats_in_row(spec.entry.seats, w, -d / 2, h, d)


@prop("cactus")
def cactus(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a saguaro with two arms."""
    w, _, h = spec.size
    plants.cactus(b, spec.material("skin"), (w, h), 2, spec.rng)
    return ()


@prop("pumpkin")
def pumpkin(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a ribbed pumpkin."""
    (w, _, h), skin = spec.size, spec.material("skin")
    angle = np.linspace(0, math.tau, 60, endpoint=False)
    ribs = 1 - 0.1 * np.abs(np.sin(5 * angle))
    rings = []
    for fall in np.linspace(0.06, math.pi - 0.1, 13):
        reach = w / 2 * math.sin(fall) ** 0.75
        dip = -0.05 * h * max(0.0, math.cos(math.pi - fall)) ** 6
        rings.append(
            np.c_[
                reach * ribs * np.cos(angle),
                reach * ribs * np.sin(angle),
                np.full(60, h * 0.42 * (1 - math.cos(fall)) + dip),
            ]
        )
    b.loft(skin, rings)
    b.tube(spec.material("stem"), [(0, 0, h * 0.8), (0.01, 0, h * 0.92), (0.04, 0, h)], (0.03, 0.02, 0.024), segments=8)
    return grips_under(w * 0.3, (0.4, 0.45, 0.2))


@prop("snowman")
def snowman(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a snowman with stick arms."""
    (w, _, h), snow, coal = spec.size, spec.material("snow"), spec.material("coal")
    r = w / 2
    for z, size in ((r * 0.85, 1.0), (h * 0.56, 0.72), (h * 0.84, 0.5)):
        b.sphere(snow, (0, 0, z), r * size, segments=24, rings=14)
    head = h * 0.84
    for x in (-1, 1):
        b.sphere(coal, (x * 0.07, -r * 0.46, head + 0.05), 0.025, segments=10, rings=6)
        path = [(x * r * 0.6, 0, h * 0.6), (x * r * 0.9, -0.1, h * 0.7), (x * r * 1.1, -0.12, h * 0.8)]
        b.tube("bark", path, (0.018, 0.014, 0.008), segments=6)
    b.cylinder(spec.material("nose"), (0, -r * 0.46, head), (0, -r * 0.46 - 0.2, head - 0.01), 0.03, 0.003, segments=10)
    for k in range(3):
        b.sphere(coal, (0, -r * 0.7, h * (0.48 + 0.07 * k)), 0.026, segments=10, rings=6)
    b.lathe("fabric_red", [(r * 0.4, -0.04), (r * 0.46, 0.0), (r * 0.4, 0.04)], origin=(0, 0, h * 0.715), segments=24)
    return ()
