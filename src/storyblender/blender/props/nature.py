"""Trees, bushes, rocks, logs, fire. One mesh a seed; yaw and scale make a wood of a few."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import Floats, MaterialRef, MeshBuilder
from storyblender.blender.props.lamps import flame
from storyblender.blender.props.registry import Anchors, PropSpec, lean, prop, seat, seats_in_row
from storyblender.blender.props.tableware import under


def _blob(
    b: MeshBuilder, material: MaterialRef, center: Floats, radius: float, rng: np.random.Generator, flat: float = 0.78
) -> None:
    """Add a ragged ball of leaves that inks as one outline."""
    around, rings = 13, 8
    phase = rng.uniform(0, math.tau, 4)
    angle = np.linspace(0, math.tau, around, endpoint=False)
    sections = []
    for k in range(rings + 1):
        fall = math.pi * k / rings
        rag = 1 + 0.16 * np.sin(4 * angle + 2.5 * fall + phase[0]) + 0.12 * np.sin(7 * angle - 3 * fall + phase[1])
        swell = 1 + 0.12 * math.sin(3 * fall + phase[2])
        reach = radius * max(math.sin(fall), 0.02) * rag * swell
        z = -radius * flat * math.cos(fall) + 0.12 * radius * np.sin(5 * angle + phase[3]) * math.sin(fall)
        sections.append(center + np.c_[reach * np.cos(angle), reach * np.sin(angle), z])
    b.loft(material, sections, caps=False)


def _trunk(height: float, leans: Floats, phase: float) -> tuple[Floats, Floats]:
    """Return the points of a trunk and its radii, with a flare at the root."""
    t = np.linspace(0, 1, 9)
    sway = 0.04 * height
    points = np.c_[
        leans[0] * t**2 + sway * 0.5 * np.sin(5 * t + phase) * t,
        leans[1] * t**2 + sway * 0.5 * np.cos(4 * t + phase) * t,
        t * height,
    ]
    radii = height * 0.026 * (1 - 0.72 * t) * (1 + 0.9 * np.exp(-t / 0.045))
    return points, radii


@prop("tree")
def tree(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a broad-leaved tree; ``kind`` pine gives a conifer."""
    if spec.word("kind") == "pine":
        return pine(b, spec)
    (w, _, h), leaf, bark, rng = spec.size, spec.material("leaf"), spec.material("bark"), spec.rng
    points, radii = _trunk(h * 0.8, rng.uniform(-0.05, 0.05, 2) * w, float(rng.uniform(0, 6)))
    b.tube(bark, points, list(radii), segments=12)
    crown = h * 0.66
    for k in range(9):
        turn, t = 2.4 * k + float(rng.uniform(-0.3, 0.3)), 0.42 + 0.5 * k / 9
        start = np.array([float(np.interp(t, np.linspace(0, 1, 9), points[:, axis])) for axis in range(3)])
        reach = w * 0.34 * (1 - 0.45 * t) * float(rng.uniform(0.85, 1.15))
        tip = start + np.array([reach * math.cos(turn), reach * math.sin(turn), h * float(rng.uniform(0.08, 0.16))])
        b.tube(
            bark,
            [start, (start + tip) / 2 + np.array([0, 0, 0.03 * h]), tip],
            [radii[4] * 0.6, radii[4] * 0.4, radii[4] * 0.2],
            segments=7,
        )
        twig = np.add(tip, (0.0, 0.0, 0.02 * h))
        _blob(b, leaf, twig, w * float(rng.uniform(0.17, 0.23)), rng)
    for k in range(5):
        turn = 1.3 + 1.26 * k
        place = np.array([w * 0.16 * math.cos(turn), w * 0.16 * math.sin(turn), crown + h * (0.06 + 0.03 * (k % 2))])
        _blob(b, leaf, place, w * float(rng.uniform(0.19, 0.24)), rng)
    _blob(b, leaf, np.array([points[-1, 0], points[-1, 1], h * 0.87]), w * 0.2, rng)
    return (lean((0, -radii[1], 1.2), 0.3),)


@prop("pine")
def pine(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a conifer of drooping whorls."""
    (w, _, h), leaf, rng = spec.size, spec.material("leaf"), spec.rng
    b.cylinder(spec.material("bark"), (0, 0, 0), (0, 0, h * 0.92), h * 0.021, h * 0.004, segments=10)
    tiers, spokes = 10, 14
    for k in range(tiers):
        t = k / tiers
        base, reach = h * (0.12 + 0.84 * t), w / 2 * (1 - t) ** 0.85 + 0.06
        angle = np.linspace(0, math.tau, spokes * 2, endpoint=False) + float(rng.uniform(0, 6))
        jag = np.where(np.arange(spokes * 2) % 2 == 0, 1.0, 0.66) * rng.uniform(0.88, 1.08, spokes * 2)
        rings = []
        for out, drop in ((1.0, -0.055), (0.62, 0.0), (0.1, 0.085)):
            rag = jag if out == 1.0 else np.full(spokes * 2, 0.9)
            rings.append(
                np.c_[
                    out * reach * rag * np.cos(angle),
                    out * reach * rag * np.sin(angle),
                    np.full(spokes * 2, base + drop * h * (0.55 + 0.45 * (1 - t))),
                ]
            )
        b.loft(leaf, rings)
    return (lean((0, -0.2, 1.2), 0.3),)


@prop("palm_tree")
def palm_tree(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a palm."""
    (w, _, h), leaf, bark, rng = spec.size, spec.material("leaf"), spec.material("bark"), spec.rng
    t = np.linspace(0, 1, 14)
    bend = 0.1 * w
    path = np.c_[bend * np.sin(1.6 * t) - bend * 0.5, 0 * t, t * h * 0.86]
    b.tube(bark, path, [0.16 - 0.07 * v + (0.012 if k % 2 else 0.0) for k, v in enumerate(t)], segments=12)
    top = path[-1]
    for k in range(13):
        turn, lift = 360 * k / 13 + float(rng.uniform(-8, 8)), 0.55 if k % 3 == 0 else 0.2
        with b.at(tuple(top), (0, 0, turn)):
            reach = w * 0.46
            spine = np.array(
                [
                    (0, 0, 0),
                    (reach * 0.35, 0, reach * lift),
                    (reach * 0.75, 0, reach * lift * 0.8),
                    (reach, 0, reach * (lift - 0.55)),
                ]
            )
            for lower, order in ((0.0, 1), (0.01, -1)):
                rows = [
                    np.array([(x, -wd, z - wd * 0.6 - lower), (x, 0, z - lower), (x, wd, z - wd * 0.6 - lower)])[
                        ::order
                    ]
                    for (x, _, z), wd in zip(spine, (0.05, 0.26, 0.24, 0.02), strict=True)
                ]
                b.loft(leaf, rows, closed=False)
    for k in range(4):
        b.sphere(
            bark,
            (top[0] + 0.16 * math.cos(1.6 * k), top[1] + 0.16 * math.sin(1.6 * k), top[2] - 0.1),
            0.11,
            segments=12,
            rings=7,
        )
    return (lean((0, -0.16, 1.2), 0.3),)


@prop("dead_tree")
def dead_tree(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bare tree of three generations of branches."""
    (w, _, h), bark, rng = spec.size, spec.material("bark"), spec.rng
    points, radii = _trunk(h * 0.8, rng.uniform(-0.3, 0.3, 2), float(rng.uniform(0, 6)))
    b.tube(bark, points, list(radii), segments=11)

    def branch(start: Floats, direction: Floats, length: float, thick: float, depth: int) -> None:
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
        start = np.array([float(np.interp(t, np.linspace(0, 1, 9), points[:, axis])) for axis in range(3)])
        direction = np.array([math.cos(turn), math.sin(turn), 0.65])
        branch(start, direction / np.linalg.norm(direction), w * 0.5 * (1.15 - 0.5 * t), radii[4] * 0.55, 2)
    return (lean((0, -radii[1], 1.2), 0.3),)


@prop("bush")
def bush(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bush."""
    (w, d, h), leaf, rng = spec.size, spec.material("leaf"), spec.rng
    for k in range(8):
        turn, reach = 2.4 * k, 0.25 * math.sqrt((k + 0.5) / 8)
        size = w * float(rng.uniform(0.21, 0.27))
        place = np.array([w * reach * math.cos(turn), d * reach * math.sin(turn), h * float(rng.uniform(0.4, 0.7))])
        _blob(b, leaf, place, size, rng, 0.9)
    return ()


@prop("tuft")
def tuft(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tuft of grass blades."""
    (w, _, h), leaf, rng = spec.size, spec.material("leaf"), spec.rng
    for _ in range(26):
        turn, root = float(rng.uniform(0, math.tau)), w * 0.2 * float(rng.random())
        tall, out = h * float(rng.uniform(0.5, 1.0)), w * float(rng.uniform(0.12, 0.42))
        with b.at((root * math.cos(turn), root * math.sin(turn), 0), (0, 0, math.degrees(turn))):
            blade = [
                np.array([(x, -wd, z), (x, wd, z)])
                for x, z, wd in ((0, 0, 0.009), (out * 0.3, tall * 0.6, 0.008), (out, tall, 0.001))
            ]
            b.loft(leaf, blade, closed=False)
    return ()


@prop("rock")
def rock(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a boulder with flattened sides."""
    (w, d, h), stone, rng = spec.size, spec.material("rock"), spec.rng
    around, rings = 16, 9
    cuts = rng.standard_normal((9, 3))
    cuts = cuts / np.linalg.norm(cuts, axis=1, keepdims=True)
    depth = rng.uniform(0.68, 0.88, 9)
    angle = np.linspace(0, math.tau, around, endpoint=False)
    sections = []
    for k in range(rings + 1):
        fall = math.pi * k / rings
        shell = np.c_[
            max(math.sin(fall), 0.03) * np.cos(angle),
            max(math.sin(fall), 0.03) * np.sin(angle),
            np.full(around, -math.cos(fall)),
        ]
        reach = shell @ cuts.T
        limit = np.where(reach > 0.05, depth / np.maximum(reach, 0.05), 9.0).min(axis=1)
        sections.append(
            shell * np.minimum(limit, 1.0)[:, None] * (w / 2 * 1.12, d / 2 * 1.12, h * 0.72)
            + np.array([0, 0, h * 0.36])
        )
    b.loft(stone, [np.c_[ring[:, :2], np.maximum(ring[:, 2], 0.0)] for ring in sections])
    return (seat((0, -d * 0.36, h * 0.82), (w * 0.6, d * 0.5)),) if 0.35 < h < 0.95 else ()


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
            b.tube(
                bark,
                [(w * 0.3, 0, h * 0.34), (w * 0.38, 0, h * 0.12), (w * 0.5, 0, 0.0)],
                (0.05, 0.06, 0.02),
                segments=8,
            )
    return (seat((0, -w * 0.34, h), (w * 0.66, w * 0.66)),)


@prop("campfire")
def campfire(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a camp fire; ``lit`` gives it flames."""
    (w, _, h), wood, stone, rng = spec.size, spec.material("wood"), spec.material("stone"), spec.rng
    for k in range(11):
        turn = math.tau * k / 11
        size = float(rng.uniform(0.085, 0.12))
        b.cushion(
            stone,
            (w * 0.42 * math.cos(turn), w * 0.42 * math.sin(turn), size * 0.4),
            (size * 1.5, size * 1.3, size),
            softness=0.6,
            rotation=(0, 0, float(rng.uniform(0, 180))),
        )
    for k in range(6):
        turn = 60 * k + 12
        with b.at(rotation=(0, 0, turn)):
            b.cylinder(wood, (w * 0.32, 0, 0.03), (0.02, 0, h * 0.42), 0.032, 0.026, segments=9)
    b.sphere(spec.material("ember"), (0, 0, 0.02), w * 0.24, scale=(1, 1, 0.24), segments=16, rings=8)
    if spec.flag("lit"):
        for k in range(9):
            turn, reach = 2.4 * k, w * 0.15 * math.sqrt(k / 9)
            flame(
                b,
                spec.material("fire"),
                reach * math.cos(turn),
                reach * math.sin(turn),
                0.06,
                (h - 0.06) * (1 - 0.55 * reach / (w * 0.15)),
            )
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
    (w, _, h), skin = spec.size, spec.material("skin")
    angle = np.linspace(0, math.tau, 32, endpoint=False)

    def rib(points: list[tuple[float, float, float]], radius: float) -> None:
        path = np.array(points)
        b.tube(skin, path, [radius] * (len(path) - 1) + [radius * 0.5], segments=12)

    rings = [
        np.c_[
            r * (1 + 0.07 * np.sin(10 * angle)) * np.cos(angle),
            r * (1 + 0.07 * np.sin(10 * angle)) * np.sin(angle),
            np.full(32, z),
        ]
        for r, z in ((0.17, 0), (0.2, h * 0.2), (0.2, h * 0.8), (0.15, h * 0.95), (0.03, h))
    ]
    b.loft(skin, rings)
    rib([(0.1, 0, h * 0.36), (w * 0.36, 0, h * 0.38), (w * 0.42, 0, h * 0.48), (w * 0.42, 0, h * 0.7)], 0.1)
    rib([(-0.1, 0, h * 0.5), (-w * 0.34, 0, h * 0.52), (-w * 0.4, 0, h * 0.6), (-w * 0.4, 0, h * 0.84)], 0.09)
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
    return under(w * 0.3, (0.4, 0.45, 0.2))


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
        b.tube(
            "bark",
            [(x * r * 0.6, 0, h * 0.6), (x * r * 0.9, -0.1, h * 0.7), (x * r * 1.1, -0.12, h * 0.8)],
            (0.018, 0.014, 0.008),
            segments=6,
        )
    b.cylinder(spec.material("nose"), (0, -r * 0.46, head), (0, -r * 0.46 - 0.2, head - 0.01), 0.03, 0.003, segments=10)
    for k in range(3):
        b.sphere(coal, (0, -r * 0.7, h * (0.48 + 0.07 * k)), 0.026, segments=10, rings=6)
    b.lathe("fabric_red", [(r * 0.4, -0.04), (r * 0.46, 0.0), (r * 0.4, 0.04)], origin=(0, 0, h * 0.715), segments=24)
    return ()
