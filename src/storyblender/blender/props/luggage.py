"""What is carried by a handle, worn, given or played: bags, boxes, hats, jewels, instruments, toys."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.lamps import flame
from storyblender.blender.props.registry import Anchors, PropSpec, prop, two_hands
from storyblender.blender.props.tableware import around, under
from storyblender.blender.props.weapons import FIST


def hanging(height: float) -> Anchors:
    """Return the grips of a hand that carries something by a handle at its top; the handle runs along X."""
    return two_hands((0.0, 0.0, height + 0.004), (0, -0.35, -0.94), (0, -0.94, 0.35), FIST)


def _bail(b: MeshBuilder, material: MaterialRef, width: float, foot: float, rise: float, radius: float) -> None:
    """Add a handle over the top, along X."""
    arc = [
        (-width / 2, 0, foot),
        (-width / 2, 0, foot + rise * 0.6),
        (-width * 0.36, 0, foot + rise),
        (width * 0.36, 0, foot + rise),
        (width / 2, 0, foot + rise * 0.6),
        (width / 2, 0, foot),
    ]
    b.tube(material, arc, radius)


@prop("briefcase")
def briefcase(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing briefcase."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("metal")
    case = h - 0.05
    b.rounded_box(body, (0, 0, case / 2), (w, d, case), 0.02)
    b.box(brass, (0, 0, case * 0.72), (w + 0.004, d + 0.004, 0.008))
    _bail(b, body, 0.14, case - 0.005, 0.05, 0.009)
    for x in (-1, 1):
        b.box(brass, (x * w * 0.3, -d / 2 - 0.004, case * 0.72), (0.045, 0.012, 0.04), bevel=0.003)
    return hanging(h - 0.01)


@prop("suitcase")
def suitcase(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing suitcase with straps and corners."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("metal")
    case = h - 0.05
    b.rounded_box(body, (0, 0, case / 2), (w, d, case), 0.03)
    b.box("leather_black", (0, 0, case / 2), (w + 0.004, 0.012, case + 0.004), bevel=0.002)
    for x in (-1, 1):
        b.box("leather_black", (x * w * 0.28, 0, case / 2), (0.035, d + 0.01, case + 0.01), bevel=0.003)
        b.box(brass, (x * w * 0.28, -d / 2 - 0.006, case * 0.6), (0.05, 0.012, 0.04), bevel=0.003)
        for y in (-1, 1):
            for z in (0.035, case - 0.035):
                b.rounded_box(brass, (x * (w / 2 - 0.028), y * (d / 2 - 0.028), z), (0.066, 0.066, 0.076), 0.02)
    _bail(b, "leather_black", 0.16, case, 0.05, 0.01)
    return hanging(h - 0.01)


@prop("bag")
def bag(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a handbag with a clasp."""
    (w, d, h), body = spec.size, spec.material("body")
    case = h * 0.6
    outline = [
        (-w / 2, 0),
        (w / 2, 0),
        (w * 0.46, case * 0.6),
        (w * 0.38, case),
        (-w * 0.38, case),
        (-w * 0.46, case * 0.6),
    ]
    for y, s in ((1, 1.0), (-1, 1.0)):
        with b.at((0, y * d * 0.25 + d * 0.25, 0), (90, 0, 0)):
            b.extrude(body, np.asarray(outline) * s, d * 0.5, taper=0.94)
    b.box("brass", (0, 0, case + 0.004), (w * 0.74, d * 0.24, 0.016), bevel=0.005)
    b.sphere("brass", (0, 0, case + 0.02), 0.014, segments=12, rings=8)
    _bail(b, body, w * 0.56, case, h - case - 0.006, 0.007)
    return hanging(h - 0.01)


@prop("backpack")
def backpack(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing backpack; its straps are at +Y."""
    (w, d, h), body, strap = spec.size, spec.material("body"), spec.material("strap")
    b.rounded_box(body, (0, 0.02, h * 0.45), (w * 0.9, d * 0.72, h * 0.88), 0.07)
    b.rounded_box(body, (0, -0.0, h * 0.82), (w * 0.92, d * 0.82, h * 0.24), 0.06)
    b.rounded_box(body, (0, -d * 0.36, h * 0.3), (w * 0.66, d * 0.28, h * 0.4), 0.04)
    for x in (-1, 1):
        b.rounded_box(body, (x * w * 0.44, 0.02, h * 0.28), (w * 0.14, d * 0.5, h * 0.34), 0.03)
        b.box(strap, (x * w * 0.18, -d * 0.42, h * 0.62), (0.022, 0.012, h * 0.3), bevel=0.003, rotation=(8, 0, 0))
        b.tube(
            strap,
            [
                (x * w * 0.18, d * 0.38, h * 0.86),
                (x * w * 0.24, d * 0.52, h * 0.7),
                (x * w * 0.28, d * 0.5, h * 0.3),
                (x * w * 0.3, d * 0.36, h * 0.1),
            ],
            0.016,
        )
    loop = [(0.04 * math.cos(a), d * 0.3, h * 0.92 + 0.045 * math.sin(a)) for a in np.linspace(0, math.pi, 9)]
    b.tube(strap, loop, 0.009)
    return hanging(h - 0.01)


@prop("sack")
def sack(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a full sack, tied at its neck."""
    (w, d, h), body = spec.size, spec.material("body")
    angle = np.linspace(0, math.tau, 24, endpoint=False)
    rings = []
    for reach, z in (
        (0.6, 0),
        (0.96, 0.06),
        (1.0, 0.3),
        (0.9, 0.52),
        (0.62, 0.7),
        (0.22, 0.8),
        (0.2, 0.83),
        (0.36, 0.92),
        (0.42, 1.0),
    ):
        fold = 1 + (0.1 if 0.6 < z < 0.99 else 0.03) * np.sin(7 * angle) + 0.03 * np.sin(3 * angle + 5 * z)
        rings.append(
            np.c_[reach * w / 2 * fold * np.cos(angle), reach * d / 2 * fold * np.sin(angle), np.full(24, z * h)]
        )
    b.loft(body, rings)
    knot = [(0.24 * w / 2 * math.cos(a), 0.24 * d / 2 * math.sin(a), h * 0.815) for a in angle[::2]]
    b.tube(spec.material("rope"), knot, 0.012, closed=True)
    return around(w * 0.12, h * 0.82, FIST)


@prop("basket")
def basket(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a basket with a bow handle."""
    (w, d, h), body = spec.size, spec.material("body")
    bowl = h * 0.46
    angle = np.linspace(0, math.tau, 28, endpoint=False)
    for k in range(7):
        reach = 0.78 + 0.2 * k / 6
        ring = np.c_[
            reach * w / 2 * np.cos(angle), reach * d / 2 * np.sin(angle), np.full(28, 0.016 + (bowl - 0.02) * k / 6)
        ]
        b.tube(body, ring, 0.017, segments=6, closed=True)
    b.polygon(body, np.c_[0.78 * w / 2 * np.cos(angle), 0.78 * d / 2 * np.sin(angle), np.full(28, 0.012)])
    arc = [(w * 0.48 * math.cos(a), 0, bowl + (h - bowl - 0.012) * math.sin(a)) for a in np.linspace(0, math.pi, 15)]
    b.tube(body, arc, 0.011)
    return hanging(h - 0.01)


@prop("bucket")
def bucket(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bucket with its bail up."""
    (w, _, h), body, r = spec.size, spec.material("body"), spec.size[0] / 2
    pail = h * 0.62
    b.lathe(
        body,
        [
            (r * 0.7, 0),
            (r * 0.72, 0.012),
            (r * 0.96, pail - 0.015),
            (r, pail - 0.006),
            (r * 0.96, pail),
            (r * 0.93, pail - 0.01),
            (r * 0.69, 0.03),
        ],
        segments=30,
    )
    b.lathe("water", [(r * 0.9, pail * 0.85)] * 2, segments=30)
    arc = [
        (w * 0.49 * math.cos(a), 0, pail - 0.02 + (h - pail + 0.015) * math.sin(a)) for a in np.linspace(0, math.pi, 15)
    ]
    b.tube(spec.material("metal"), arc, 0.005)
    b.cylinder("wood", (-0.05, 0, h - 0.008), (0.05, 0, h - 0.008), 0.013, segments=10)
    return hanging(h - 0.01)


@prop("umbrella")
def umbrella(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an umbrella, open overhead or furled, its handle down."""
    (w, _, h), cloth, metal = spec.size, spec.material("cloth"), spec.material("metal")
    r = w / 2
    b.cylinder(metal, (0, 0, 0.08), (0, 0, h), 0.007, segments=10)
    crook = [(0, 0, 0.16), (0, 0, 0.05), (0, -0.02, 0.012), (0, -0.06, 0.01), (0, -0.08, 0.05)]
    b.tube(spec.material("handle"), crook, 0.011)
    if spec.flag("open"):
        angle = np.linspace(0, math.tau, 48, endpoint=False)
        scallop = 0.04 * (1 - np.abs(np.cos(4 * angle)))
        for inside in (0.0, 0.006):
            rings = []
            for t in (1.0, 0.8, 0.55, 0.3, 0.02):
                z = h - 0.05 - (h * 0.24) * t**1.8 + scallop * t - inside
                rings.append(np.c_[r * t * np.cos(angle), r * t * np.sin(angle), z])
            b.loft(cloth, rings if inside == 0 else rings[::-1], caps=False)
        for k in range(8):
            turn = math.tau * k / 8
            b.cylinder(
                metal,
                (0, 0, h * 0.6),
                (r * 0.55 * math.cos(turn), r * 0.55 * math.sin(turn), h - 0.15),
                0.003,
                segments=5,
            )
    else:
        b.lathe(cloth, [(0.016, 0.2), (0.038, 0.24), (0.03, h * 0.5), (0.012, h - 0.06)], segments=12)
    return two_hands((-0.014, 0.004, 0.13), (0.2, -1, 0.05), (1, 0.15, 0), FIST)


@prop("cane")
def cane(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a walking stick with a crook along X."""
    (w, _, h), body = spec.size, spec.material("body")
    crook = [
        (w * 0.3 - w * 0.4 + w * 0.4 * math.cos(a), 0, h - w * 0.5 + w * 0.42 * math.sin(a))
        for a in np.linspace(0, math.pi * 1.1, 11)
    ]
    b.tube(body, [(w * 0.3, 0, 0.02), *crook], 0.011)
    b.cylinder("rubber", (w * 0.3, 0, 0), (w * 0.3, 0, 0.03), 0.013)
    return two_hands((w * -0.1, 0.0, h), (0.3, -0.9, -0.3), (0, -0.3, -0.95), FIST)


@prop("hat")
def hat(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a felt hat with a creased crown."""
    (w, d, h), body = spec.size, spec.material("body")
    angle = np.linspace(0, math.tau, 36, endpoint=False)

    def ring(reach: float, z: float, dent: float = 0.0) -> np.ndarray:
        crease = -dent * np.exp(-((np.cos(angle) / 0.3) ** 2)) * 0.3 - dent * 0.5
        lift = 0.014 * np.cos(angle) ** 2 * (reach > 0.9)
        return np.c_[reach * w / 2 * np.cos(angle), reach * d / 2 * np.sin(angle), z + crease + lift]

    crown = [
        ring(0.98, 0.0),
        ring(1.0, 0.006),
        ring(0.62, 0.012),
        ring(0.6, 0.03),
        ring(0.56, h * 0.7),
        ring(0.5, h * 0.94),
        ring(0.4, h),
        ring(0.2, h, 0.03),
        ring(0.02, h, 0.04),
    ]
    b.loft(body, crown)
    band = [ring(0.625, 0.012), ring(0.615, 0.042)]
    b.loft(spec.material("band"), band, caps=False)
    return two_hands((-w * 0.44, 0.02, 0.01), (0.4, -0.9, 0), (0.3, 0, 0.95), (0.4, 0.5, 0.3)) + two_hands(
        (0.0, -d * 0.2, h * 0.9), (0, -0.7, -0.6), (0, 0.3, -0.95), (0.4, 0.5, 0.3), "top"
    )


@prop("crown")
def crown(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a crown of points with stones."""
    (_, _, h), body, gem, r = spec.size, spec.material("body"), spec.material("gem"), spec.size[0] / 2
    count = 48
    angle = np.linspace(0, math.tau, count, endpoint=False)
    tip = h * (0.55 + 0.4 * np.abs(np.cos(4 * angle)) ** 1.5)
    rings = [
        np.c_[r * s * np.cos(angle), r * s * np.sin(angle), z]
        for s, z in (
            (0.9, np.zeros(count)),
            (0.9, np.full(count, h * 0.3)),
            (0.98, tip),
            (0.95, tip),
            (0.87, np.full(count, h * 0.3)),
            (0.87, np.zeros(count)),
        )
    ]
    b.loft(body, rings, caps=False)
    b.lathe(body, [(r * 0.9, 0), (r * 0.94, 0.008), (r * 0.94, h * 0.2), (r * 0.9, h * 0.25)], segments=36, caps=False)
    for k in range(8):
        turn = math.tau * k / 8
        b.sphere(gem, (r * 0.94 * math.cos(turn), r * 0.94 * math.sin(turn), h * 0.12), 0.011, segments=8, rings=6)
        b.sphere(body, (r * 0.97 * math.cos(turn), r * 0.97 * math.sin(turn), h * 0.95), 0.009, segments=8, rings=6)
    return two_hands((-r, 0.0, h * 0.2), (0.2, -1, 0), (1, 0, 0), (0.4, 0.45, 0.3))


@prop("helmet")
def helmet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a closed helmet whose visor looks to -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    b.cushion(body, (0, 0.0, h * 0.55), (w, d, h * 0.9), softness=0.8)
    b.lathe(body, [(w * 0.42, 0), (w * 0.44, 0.02), (w * 0.42, h * 0.25)], segments=28)
    b.cushion(spec.material("visor"), (0, -d * 0.14, h * 0.56), (w * 0.86, d * 0.76, h * 0.36), softness=0.6)
    b.tube(body, [(0, -d * 0.3, h * 0.93), (0, 0, h * 1.0), (0, d * 0.4, h * 0.8)], (0.006, 0.012, 0.006))
    return two_hands((-w / 2, 0, h * 0.4), (0.1, -0.9, -0.4), (1, 0.1, 0), (0.35, 0.4, 0.2))


@prop("mask")
def mask(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a face mask that looks to -Y, standing."""
    (w, d, h), body, hole = spec.size, spec.material("body"), spec.material("hole")
    across = np.linspace(-1, 1, 15)
    rows = []
    for t in np.linspace(0, 1, 11):
        width = w / 2 * math.sin(math.pi * (0.2 + 0.7 * t)) ** 0.7
        nose = 0.16 * np.exp(-((across / 0.16) ** 2)) * (0.3 < t < 0.62) * (t - 0.3 < 0.4) * (1.2 - t)
        rows.append(
            np.c_[
                width * across,
                d * (0.42 - 0.75 * np.sqrt(np.clip(1 - across**2 * 0.95, 0, 1)) - nose),
                np.full(15, h * t),
            ]
        )
    for lift, order in ((0.0, 1), (0.006, -1)):
        b.loft(body, [(row + np.array([0, lift, 0]))[::order] for row in rows], closed=False)
    for x in (-1, 1):
        b.cushion(hole, (x * w * 0.2, -d * 0.27, h * 0.62), (w * 0.2, 0.02, h * 0.07), softness=0.9)
    b.cushion(hole, (0, -d * 0.3, h * 0.22), (w * 0.3, 0.02, h * 0.05), softness=0.9)
    return two_hands((-w * 0.45, 0.02, h * 0.4), (0.3, -0.9, 0.2), (1, 0, 0), (0.4, 0.45, 0.3))


@prop("jewel_box")
def jewel_box(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a jewel box, closed or with its lid back and pearls inside."""
    (w, d, h), body, gold = spec.size, spec.material("body"), spec.material("trim")
    base, opened = h * 0.66, spec.flag("open")
    b.box(body, (0, 0, base / 2 + 0.008), (w - 0.012, d - 0.012, base - 0.008), bevel=0.004)
    b.box("fabric_red", (0, 0, base - 0.002), (w - 0.04, d - 0.04, 0.012))
    for x in (-1, 1):
        for y in (-1, 1):
            b.sphere(gold, (x * (w / 2 - 0.016), y * (d / 2 - 0.016), 0.009), 0.011, segments=10, rings=6)
            b.box(
                gold,
                (x * (w / 2 - 0.008), y * (d / 2 - 0.008), base / 2 + 0.008),
                (0.016, 0.016, base - 0.01),
                bevel=0.003,
            )
    with b.at((0, d / 2 - 0.006, base + 0.006), (-100 if opened else 0, 0, 0)):
        b.box(
            body,
            (0, -d / 2 + 0.006, (h - base) * 0.4),
            (w - 0.004, d - 0.004, (h - base) * 0.8),
            bevel=0.006,
            taper=0.93,
        )
        b.box(gold, (0, -d / 2 + 0.006, 0.004), (w, d, 0.006), bevel=0.002)
        b.cushion(gold, (0, -d / 2 + 0.006, (h - base) * 0.84), (w * 0.4, d * 0.4, 0.008), softness=0.8)
    b.box(gold, (0, -d / 2 - 0.003, base), (0.03, 0.008, 0.032), bevel=0.003)
    if opened:
        for k in range(12):
            turn = 0.52 * k
            b.sphere(
                "porcelain", (0.05 * math.cos(turn), 0.03 * math.sin(turn), base + 0.008), 0.007, segments=8, rings=5
            )
    return two_hands((-w / 2, 0.0, h * 0.35), (0.1, -0.8, -0.5), (1, 0.1, 0.1), (0.3, 0.35, 0.25)) + under(d * 0.3)


@prop("gift")
def gift(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wrapped box with a bow."""
    (w, d, h), ribbon = spec.size, spec.material("ribbon")
    case = h * 0.76
    b.box(spec.material("body"), (0, 0, case / 2), (w - 0.006, d - 0.006, case), bevel=0.003)
    b.box(ribbon, (0, 0, case / 2), (w * 0.14, d, case + 0.006))
    b.box(ribbon, (0, 0, case / 2), (w, d * 0.14, case + 0.006))
    for turn in (35, 145, 215, 325):
        with b.at((0, 0, case), (0, 0, turn)):
            loop = [
                (0, 0, 0),
                (w * 0.16, 0, h * 0.14),
                (w * 0.3, 0, h * 0.17),
                (w * 0.3, 0, h * 0.06),
                (0.01, 0, 0.005),
            ]
            b.tube(ribbon, loop, 0.012, segments=6)
    b.sphere(ribbon, (0, 0, case + 0.015), 0.022, segments=10, rings=6)
    return two_hands((-w / 2, 0.0, case * 0.4), (0.1, -0.9, -0.4), (1, 0, 0), (0.15, 0.2, 0.15))


@prop("candle_holder")
def candle_holder(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a lit candle in a dish with a ring to hold it by."""
    (w, d, h), metal = spec.size, spec.material("metal")
    r = d / 2
    b.lathe(
        metal,
        [(r * 0.8, 0), (r, 0.014), (r, 0.018), (r * 0.78, 0.007), (0.02, 0.009), (0.018, 0.03), (0.024, 0.034)],
        origin=(w / 2 - r, 0, 0),
        segments=26,
    )
    loop = [
        (-w / 2 + 0.012 + 0.02 * math.cos(a), 0, 0.024 + 0.018 * math.sin(a))
        for a in np.linspace(0, math.tau, 16, endpoint=False)
    ]
    b.tube(metal, loop, 0.0035, segments=6, closed=True)
    b.lathe(
        spec.material("wax"),
        [(0.012, 0.02), (0.012, h * 0.68), (0.008, h * 0.7)],
        origin=(w / 2 - r, 0, 0),
        segments=12,
    )
    flame(b, spec.material("flame"), w / 2 - r, 0, h * 0.7, h * 0.3)
    return two_hands((-w / 2 - 0.01, 0.01, 0.024), (0.4, -0.9, 0), (0.95, 0.3, 0), (0.8, 0.85, 0.6))


@prop("necklace")
def necklace(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a necklace laid in a loop, its stone at -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    count = 46
    for k in range(count):
        turn = math.tau * k / count
        squeeze = 1 - 0.25 * max(0.0, math.sin(turn))
        b.sphere(
            body,
            (w * 0.46 * squeeze * math.cos(turn), 0.015 + (d * 0.42) * math.sin(turn), h * 0.4),
            h * 0.4,
            segments=8,
            rings=5,
        )
    b.cushion(spec.material("gem"), (0, -d * 0.44, h / 2), (0.022, 0.028, h), softness=0.8)
    return _pinched(d * 0.4, h)


@prop("ring")
def ring(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing ring, its stone on top."""
    (w, _, h), body = spec.size, spec.material("body")
    r = w / 2 - 0.002
    band = [(r * math.cos(a), 0, w / 2 + r * math.sin(a)) for a in np.linspace(0, math.tau, 28, endpoint=False)]
    b.tube(body, band, 0.0018, closed=True)
    b.lathe(spec.material("gem"), [(0.001, w - 0.002), (0.005, h - 0.002), (0.003, h)], segments=8)
    return _pinched(0.0, h * 0.5)


def _pinched(y: float, z: float) -> Anchors:
    return two_hands((-0.03, y + 0.03, z), (0.5, -0.85, -0.15), (0.8, 0.4, -0.4), (0.55, 0.65, 0.6))


@prop("rope")
def rope(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a coil of rope."""
    w, _, h = spec.size
    turns, r = 5, w / 2 - 0.02
    t = np.linspace(0, turns, turns * 24)
    reach = r * (1 - 0.06 * np.sin(t * 4.1))
    path = np.c_[
        reach * np.cos(math.tau * t),
        reach * np.sin(math.tau * t),
        0.016 + (h - 0.034) * t / turns + 0.006 * np.sin(9 * t),
    ]
    b.tube(
        spec.material("body"),
        np.r_[path, [(w * 0.2, -w * 0.1, h - 0.01), (w * 0.1, -w * 0.25, h - 0.04)]],
        0.015,
        segments=7,
    )
    return two_hands((-r, 0.0, h * 0.5), (0.3, -0.3, -0.9), (1, 0, 0), FIST)


@prop("flower")
def flower(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a rose on its stem."""
    h = spec.size[2]
    stem = spec.material("stem")
    b.tube(stem, [(0, 0, 0), (0.006, 0, h * 0.4), (0, 0.004, h * 0.86)], 0.003, segments=6)
    bloom(b, spec.material("petal"), (0, 0.004, h * 0.9), 0.036)
    for turn, z in ((0, 0.35), (150, 0.55)):
        with b.at((0.004, 0, h * z), (0, -35, turn)):
            b.cushion(spec.material("leaf"), (0.026, 0, 0), (0.05, 0.026, 0.004), softness=1.0)
    return around(0.006, h * 0.25, (0.7, 0.8, 0.6))


def bloom(b: MeshBuilder, material: MaterialRef, center: tuple[float, float, float], radius: float) -> None:
    """Add a round blossom of three rings of petals."""
    x, y, z = center
    b.sphere(material, center, radius * 0.55, segments=10, rings=6)
    for row, (count, reach, tilt) in enumerate(((4, 0.35, 70), (5, 0.55, 45), (6, 0.7, 15))):
        for k in range(count):
            with b.at((x, y, z), (0, -tilt, 360 * k / count + 20 * row)):
                petal = (0.4, 0.45, 0.08)
                b.sphere(material, (radius * reach, 0, 0), radius, scale=petal, segments=8, rings=4)


@prop("bouquet")
def bouquet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bunch of flowers in a cone of paper."""
    (w, _, h), leaf = spec.size, spec.material("leaf")
    angle = np.linspace(0, math.tau, 30, endpoint=False)
    wave = 1 + 0.08 * np.sin(6 * angle)
    for inside in (0.0, 0.006):
        rings = [
            np.c_[
                (r * wave - inside) * np.cos(angle),
                (r * wave - inside) * np.sin(angle),
                np.full(30, z) + 0.02 * np.sin(3 * angle) * (z > 0.1),
            ]
            for r, z in ((0.03, 0.0), (0.035, h * 0.2), (w * 0.4, h * 0.62))
        ]
        b.loft(spec.material("paper"), rings if inside == 0 else rings[::-1], caps=False)
    for k in range(9):
        turn, reach = 2.4 * k, w * 0.36 * math.sqrt((k + 0.5) / 9)
        at = (reach * math.cos(turn), reach * math.sin(turn), h * (0.82 - 0.6 * reach))
        bloom(b, spec.material("petal") if k % 3 else "linen", at, 0.045)
        b.sphere(leaf, (at[0] * 1.25, at[1] * 1.25, at[2] - 0.06), 0.05, segments=8, rings=5)
    return around(0.03, h * 0.15, FIST)


@prop("ball")
def ball(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sewn ball."""
    r = spec.size[0] / 2
    b.sphere(spec.material("body"), (0, 0, r), r, segments=28, rings=16)
    for rotation in ((0, 0, 0), (90, 0, 0), (90, 0, 90)):
        with b.at((0, 0, r), rotation):
            seam = [(r * math.cos(a), r * math.sin(a), 0) for a in np.linspace(0, math.tau, 36, endpoint=False)]
            b.tube(spec.material("seam"), seam, r * 0.012, segments=5, closed=True)
    return two_hands((-r, 0.0, r * 0.8), (0.2, -0.9, -0.3), (1, 0, 0.2), (0.25, 0.3, 0.2))


@prop("teddy_bear")
def teddy_bear(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sitting teddy bear."""
    (w, d, h), body, snout, eye = spec.size, spec.material("body"), spec.material("snout"), spec.material("eye")
    b.sphere(body, (0, 0.02, h * 0.3), h * 0.26, scale=(1, 0.9, 1.1))
    b.sphere(body, (0, 0.0, h * 0.74), h * 0.22, scale=(1.05, 0.95, 1))
    b.sphere(snout, (0, -h * 0.18, h * 0.69), h * 0.1)
    b.sphere(eye, (0, -h * 0.27, h * 0.72), h * 0.03)
    for x in (-1, 1):
        b.sphere(body, (x * h * 0.17, 0.0, h * 0.92), h * 0.08, scale=(1, 0.5, 1))
        b.sphere(eye, (x * h * 0.08, -h * 0.19, h * 0.79), h * 0.024)
        b.cushion(
            body, (x * w * 0.36, -0.03, h * 0.42), (w * 0.2, w * 0.2, h * 0.34), softness=0.9, rotation=(20, x * 25, 0)
        )
        b.cushion(body, (x * w * 0.3, -d * 0.3, h * 0.12), (w * 0.27, d * 0.5, h * 0.22), softness=0.9)
        b.cushion(snout, (x * w * 0.3, -d * 0.47, h * 0.12), (w * 0.2, 0.03, h * 0.17), softness=0.9)
    return around(w * 0.3, h * 0.4, (0.4, 0.45, 0.3))


@prop("skull")
def skull(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a skull that looks to -Y."""
    (w, d, h), body, hole = spec.size, spec.material("body"), spec.material("hole")
    b.sphere(body, (0, d * 0.12, h * 0.64), w * 0.48, scale=(1, 1.18, 0.86))
    b.rounded_box(body, (0, -d * 0.2, h * 0.4), (w * 0.62, d * 0.36, h * 0.4), 0.025)
    b.rounded_box(body, (0, -d * 0.22, h * 0.12), (w * 0.56, d * 0.36, h * 0.2), 0.02)
    for x in (-1, 1):
        b.sphere(hole, (x * w * 0.19, -d * 0.36, h * 0.52), w * 0.13, scale=(1, 0.5, 0.9))
        b.sphere(body, (x * w * 0.36, -d * 0.22, h * 0.42), w * 0.1)
    b.cushion(hole, (0, -d * 0.38, h * 0.38), (w * 0.12, 0.02, h * 0.1), softness=0.8)
    b.box(hole, (0, -d * 0.395, h * 0.21), (w * 0.48, 0.008, 0.006))
    for k in range(6):
        b.box(hole, ((k - 2.5) * w * 0.085, -d * 0.398, h * 0.21), (0.002, 0.006, h * 0.1))
    return two_hands((0.0, 0.05, -0.01), (0, -1, 0), (0, 0, 1), (0.35, 0.4, 0.2))


def _strings(
    b: MeshBuilder, material: MaterialRef, count: int, low: float, high: float, y: float, spread: float
) -> None:
    for k in range(count):
        x = (k - (count - 1) / 2) * spread / (count - 1)
        b.cylinder(material, (x * 1.3, y, low), (x, y, high), 0.0007, segments=4, caps=False)


def _bout(width: float, height: float, waist: float) -> np.ndarray:
    """Return the outline of a guitar's or violin's body, standing, foot at 0."""
    t = np.linspace(0, math.pi, 22)
    side = (
        width
        / 2
        * (np.sin(t) ** 0.5)
        * (1 - waist * np.exp(-(((t / math.pi - 0.55) / 0.13) ** 2)) - 0.2 * (t / math.pi) ** 2)
    )
    z = height * (1 - np.cos(t)) / 2
    return np.r_[np.c_[side, z], np.c_[-side, z][::-1][1:-1]]


@prop("guitar")
def guitar(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a guitar that stands, strings to -Y."""
    (w, d, h), body, neck = spec.size, spec.material("body"), spec.material("neck")
    bout = h * 0.49
    with b.at((0, d / 2, 0), (90, 0, 0)):
        b.extrude("wood_red", _bout(w, bout, 0.22), d * 0.8)
        b.extrude(body, _bout(w * 0.98, bout, 0.22), d * 0.02, base=d * 0.8)
    b.lathe(
        "plastic_black",
        [(w * 0.13, 0), (w * 0.13, 0.002)],
        origin=(0, -d * 0.32, bout * 0.62),
        axis=(0, -1, 0),
        segments=24,
    )
    b.box(neck, (0, -d * 0.3, (bout * 0.68 + h * 0.9) / 2), (0.05, 0.03, h * 0.9 - bout * 0.68), bevel=0.004)
    b.box(neck, (0, -d * 0.28, h * 0.95), (0.07, 0.02, h * 0.1), bevel=0.004)
    b.box(neck, (0, -d * 0.34, bout * 0.3), (w * 0.4, 0.012, 0.02), bevel=0.003)
    for x in (-1, 1):
        for k in range(3):
            b.sphere("silver", (x * 0.045, -d * 0.28, h * (0.92 + 0.03 * k)), 0.009, segments=8, rings=5)
    _strings(b, spec.material("string"), 6, bout * 0.3, h * 0.9, -d * 0.47, 0.036)
    return two_hands((-0.02, -d * 0.3, h * 0.72), (0.3, -0.9, 0), (1, 0.2, 0), FIST, "neck") + around(
        w * 0.2, bout * 0.6, (0.3, 0.35, 0.2)
    )


@prop("violin")
def violin(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a violin that stands, strings to -Y."""
    (w, d, h), body, neck = spec.size, spec.material("body"), spec.material("neck")
    bout = h * 0.6
    with b.at((0, d / 2, 0), (90, 0, 0)):
        b.extrude(body, _bout(w, bout, 0.36), d * 0.4)
    b.box(neck, (0, -d * 0.02, h * 0.7), (0.028, 0.016, h * 0.54), bevel=0.003)
    b.box(neck, (0, -d * 0.02, bout * 0.16), (0.035, 0.014, bout * 0.3), bevel=0.004, taper=0.6)
    b.box("wood_light", (0, -d * 0.05, bout * 0.42), (0.05, 0.006, 0.02), rotation=(0, 0, 0))
    for x in (-1, 1):
        b.tube(
            "plastic_black",
            [
                (x * w * 0.17, d * 0.09, bout * 0.32),
                (x * w * 0.15, d * 0.09, bout * 0.42),
                (x * w * 0.12, d * 0.09, bout * 0.5),
            ],
            0.004,
            segments=5,
        )
        for k in range(2):
            b.cylinder(neck, (0, 0, h * (0.9 + 0.03 * k)), (x * 0.035, 0, h * (0.9 + 0.03 * k)), 0.004, segments=6)
    b.lathe(body, [(0.014, -0.015), (0.014, 0.015)], origin=(0, d * 0.02, h - 0.015), axis=(1, 0, 0), segments=14)
    _strings(b, spec.material("string"), 4, bout * 0.2, h * 0.92, -d * 0.16, 0.018)
    return two_hands((-0.016, 0.0, h * 0.76), (0.3, -0.9, 0), (1, 0.2, 0), FIST)


@prop("trumpet")
def trumpet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a trumpet whose bell is at -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    z, r = h * 0.55, w / 2
    bell = [(r, 0), (r * 0.97, 0.004), (r * 0.62, 0.03), (r * 0.35, 0.08), (r * 0.2, 0.16), (r * 0.16, d * 0.5)]
    b.lathe(body, bell, origin=(0, -d / 2, z), axis=(0, 1, 0), segments=28, caps=False)
    b.tube(
        body,
        [
            (0, 0, z),
            (0, d * 0.28, z),
            (0, d * 0.34, z - 0.03),
            (0, d * 0.28, z - 0.06),
            (0, -d * 0.2, z - 0.06),
            (0, -d * 0.26, z - 0.03),
            (0, -d * 0.2, z),
            (0, d / 2 - 0.02, z),
        ],
        0.0075,
    )
    b.lathe(body, [(0.006, 0), (0.012, 0.015), (0.012, 0.02)], origin=(0, d / 2 - 0.02, z), axis=(0, 1, 0), segments=14)
    for k in range(3):
        y = -0.02 + 0.028 * k
        b.cylinder(body, (0, y, z - 0.08), (0, y, z + 0.045), 0.011, segments=12)
        b.cylinder("porcelain", (0, y, z + 0.045), (0, y, z + 0.06), 0.007, segments=10)
    return two_hands((-0.02, 0.0, z - 0.03), (0.25, -0.9, 0.2), (1, 0.1, 0), (0.8, 0.85, 0.5))
