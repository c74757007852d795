"""The furniture of streets and squares."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.parts import four_legs, spoked_wheel
from storyblender.blender.props.registry import Anchors, PropSpec, handle, lean, prop, seat, seats_in_row


@prop("lamppost")
def lamppost(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cast-iron lamp post with a four-sided lantern."""
    (w, _, h), metal = spec.size, spec.material("metal")
    b.lathe(
        metal,
        [
            (0.17, 0),
            (0.16, 0.1),
            (0.11, 0.25),
            (0.085, 0.7),
            (0.1, 0.74),
            (0.06, 0.82),
            (0.045, h - 0.62),
            (0.07, h - 0.58),
            (0.05, h - 0.52),
        ],
        segments=16,
    )
    b.tube(metal, [(-0.3, 0, h - 0.8), (0.3, 0, h - 0.8)], 0.018)
    for x in (-1, 1):
        b.sphere(metal, (x * 0.3, 0, h - 0.8), 0.035, segments=12, rings=8)
    low, high = h - 0.5, h - 0.12
    b.loft(spec.material("glow"), [_ring4(0.085, low), _ring4(w * 0.42, high)])
    for k in range(4):
        corner = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)][k])
        b.tube(metal, [(*(corner * 0.09), low), (*(corner * w * 0.43), high)], 0.012, segments=6)
    b.loft(metal, [_ring4(w * 0.5, high), _ring4(w * 0.46, high + 0.03), _ring4(0.06, h - 0.02), _ring4(0.02, h)])
    b.loft(metal, [_ring4(0.1, low - 0.04), _ring4(0.095, low)])
    return (lean((0, -0.1, 1.1), 0.2),)


def _ring4(half: float, z: float) -> np.ndarray:
    return np.array([(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)])


@prop("hydrant")
def hydrant(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fire hydrant."""
    h, body, metal = spec.size[2], spec.material("body"), spec.material("metal")
    b.lathe(
        body,
        [
            (0.15, 0),
            (0.15, 0.04),
            (0.11, 0.06),
            (0.11, h * 0.58),
            (0.14, h * 0.6),
            (0.14, h * 0.66),
            (0.11, h * 0.7),
            (0.11, h * 0.76),
            (0.13, h * 0.77),
            (0.12, h * 0.86),
            (0.06, h * 0.95),
            (0.03, h * 0.96),
            (0.03, h),
        ],
        segments=22,
    )
    for turn in (0, 90, 180):
        with b.at((0, 0, h * 0.48), (0, 0, turn)):
            b.cylinder(body, (0.08, 0, 0), (0.15, 0, 0), 0.05, segments=16)
            b.cylinder(metal, (0.15, 0, 0), (0.18, 0, 0), 0.056, segments=8)
    return ()


@prop("dumpster")
def dumpster(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dumpster with a sloping lid, on castors."""
    (w, d, h), body, metal = spec.size, spec.material("body"), spec.material("metal")
    front, rear = h * 0.72, h - 0.06
    side = [(-d * 0.44, 0.16), (d * 0.44, 0.16), (d / 2, rear), (-d / 2, front)]
    with b.at((-w / 2 + 0.06, 0, 0), (90, 0, 90)):
        b.extrude(body, side, w - 0.12)
    for k in range(6):
        b.box(
            body,
            ((k - 2.5) * (w - 0.2) / 5.4, -d * 0.48, front * 0.56),
            (0.06, 0.06, front * 0.66),
            bevel=0.01,
            rotation=(-4, 0, 0),
        )
    slope = math.degrees(math.atan2(rear - front, d))
    for x in (-1, 1):
        b.box(
            spec.material("lid"),
            (x * w * 0.24, 0, (front + rear) / 2 + 0.03),
            (w * 0.47, d + 0.06, 0.05),
            bevel=0.015,
            rotation=(slope, 0, 0),
        )
        b.box(metal, (x * (w / 2 - 0.03), 0, h * 0.5), (0.06, d * 0.3, 0.1), bevel=0.01)
        for y in (-1, 1):
            b.cylinder(
                "rubber",
                (x * (w / 2 - 0.24), y * d * 0.34 - 0.02, 0.08),
                (x * (w / 2 - 0.2), y * d * 0.34 - 0.02, 0.08),
                0.08,
                segments=16,
            )
            b.box(metal, (x * (w / 2 - 0.22), y * d * 0.34 - 0.02, 0.13), (0.1, 0.1, 0.08))
    return (handle((0, -d / 2, front), (0, -0.3, 0.95), "lid"),)


@prop("trash_can")
def trash_can(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a galvanised dustbin with its lid."""
    (w, _, h), body, r = spec.size, spec.material("body"), spec.size[0] / 2
    outline = [(r * 0.78, 0)]
    outline += [
        (r * (0.8 + 0.12 * z) + (0.008 if k % 2 else 0.0), h * 0.86 * z) for k, z in enumerate(np.linspace(0.04, 1, 17))
    ]
    b.lathe(body, outline, segments=30)
    b.lathe(body, [(r, h * 0.85), (r, h * 0.89), (r * 0.8, h * 0.93), (0.05, h * 0.96)], segments=30)
    b.tube(body, [(-0.06, 0, h * 0.95), (-0.05, 0, h * 0.99), (0.05, 0, h * 0.99), (0.06, 0, h * 0.95)], 0.01)
    for x in (-1, 1):
        b.tube(
            body,
            [
                (x * r * 0.88, -0.08, h * 0.66),
                (x * w * 0.5, -0.07, h * 0.62),
                (x * w * 0.5, 0.07, h * 0.62),
                (x * r * 0.88, 0.08, h * 0.66),
            ],
            0.009,
        )
    return (handle((0, 0, h), (0, 0, 1), "lid"),)


@prop("street_sign")
def street_sign(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sign plate on a post."""
    (w, d, h), post = spec.size, spec.material("post")
    b.cylinder(post, (0, 0, 0), (0, 0, h), 0.03)
    b.sphere(post, (0, 0, h), 0.04, segments=12, rings=8)
    tall = w * 0.62
    b.rounded_box(spec.material("plate"), (0, -0.04, h - tall / 2 - 0.08), (w, 0.02, tall), 0.008)
    for z, length in ((0.62, 0.7), (0.4, 0.5)):
        b.box(spec.material("text"), (0, -0.052, h - 0.08 - tall + tall * z), (w * length, 0.004, tall * 0.12))
    b.box(spec.material("text"), (0, -0.051, h - 0.08 - tall / 2), (w * 0.94, 0.002, 0.012))
    b.lathe(post, [(d, 0), (d * 0.9, 0.03), (0.035, 0.06)], segments=16)
    return (lean((0, -0.03, 1.1), 0.1),)


@prop("sandwich_board")
def sandwich_board(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an A-board with chalk writing."""
    (w, d, h), board, frame = spec.size, spec.material("board"), spec.material("frame")
    lean_angle = math.degrees(math.atan2(d / 2 - 0.02, h))
    for turn in (0, 180):
        with b.at(rotation=(0, 0, turn)), b.at((0, -d / 2 + 0.02, 0), (-lean_angle, 0, 0)):
            for x in (-1, 1):
                b.box(frame, (x * (w / 2 - 0.025), 0, h / 2), (0.05, 0.03, h), bevel=0.006)
            for z in (0.12, h - 0.03):
                b.box(frame, (0, 0, z), (w - 0.1, 0.028, 0.06), bevel=0.005)
            b.box(board, (0, 0, h * 0.54), (w - 0.08, 0.014, h * 0.84))
            for k in range(5):
                length = w * float(spec.rng.uniform(0.35, 0.7))
                b.box("porcelain", (0, -0.009, h * (0.84 - 0.13 * k)), (length, 0.003, 0.03 if k else 0.05))
    return ()


@prop("neon_sign")
def neon_sign(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a lit sign: a border and BAR in tubes."""
    (w, d, h), tube = spec.size, spec.material("tube")
    b.box(spec.material("board"), (0, d * 0.2, h / 2), (w, d * 0.5, h), bevel=0.02)
    front = -d * 0.28
    border = [(x * w * 0.46, front, h / 2 + z * h * 0.42) for x, z in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    b.tube("neon_blue", border, 0.014, closed=True)
    s = h * 0.25

    def letter(x: float, *strokes: tuple[tuple[float, float], ...]) -> None:
        for stroke in strokes:
            b.tube(tube, [(x + u * s, front, h / 2 + v * s) for u, v in stroke], 0.018, segments=8)

    letter(
        -w * 0.25,
        ((-0.6, -1), (-0.6, 1), (0.3, 1), (0.55, 0.5), (0.3, 0), (-0.6, 0)),
        ((0.3, 0), (0.6, -0.5), (0.3, -1), (-0.6, -1)),
    )
    letter(0.0, ((-0.7, -1), (0, 1), (0.7, -1)), ((-0.42, -0.2), (0.42, -0.2)))
    letter(w * 0.25, ((-0.6, -1), (-0.6, 1), (0.3, 1), (0.55, 0.5), (0.3, 0), (-0.6, 0)), ((0.1, 0), (0.6, -1)))
    return ()


@prop("traffic_light")
def traffic_light(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a traffic light."""
    (w, _, h), body, post = spec.size, spec.material("body"), spec.material("post")
    b.lathe(post, [(0.14, 0), (0.13, 0.1), (0.055, 0.16), (0.05, h - 0.2)], segments=16)
    b.rounded_box(body, (0, 0, h - 0.48), (w * 0.8, 0.24, 0.96), 0.05)
    for k, kind in enumerate(("leaves", "brass", "neon_red")):
        z = h - 0.78 + 0.3 * k
        b.lathe(
            kind,
            [(0.1, 0), (0.06, 0.03), (0.003, 0.04)],
            origin=(0, -0.115, z),
            axis=(0, -1, 0),
            segments=20,
            caps=False,
        )
        visor = [(0.12 * math.cos(a), 0.12 * math.sin(a)) for a in np.linspace(-0.3, math.pi + 0.3, 13)]
        for order in (1, -1):
            b.loft(
                body,
                [np.array([(x, -0.12 - y, z + up) for x, up in visor])[::order] for y in (0.0, 0.15)],
                closed=False,
            )
    return ()


@prop("traffic_cone")
def traffic_cone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a traffic cone."""
    (w, d, h), body, band = spec.size, spec.material("body"), spec.material("band")
    b.box(body, (0, 0, 0.02), (w, d, 0.04), bevel=0.01)
    b.lathe(body, [(w * 0.38, 0.03), (w * 0.1, h - 0.01), (w * 0.08, h)], segments=24)
    for low in (0.4, 0.66):
        r0, r1 = (w * (0.38 - 0.28 * t) + 0.003 for t in (low, low + 0.14))
        b.lathe(band, [(r0, h * low), (r1, h * (low + 0.14))], segments=24, caps=False)
    return ()


@prop("park_bench")
def park_bench(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a slatted bench on iron sides."""
    (w, d, h), wood, iron = spec.size, spec.material("wood"), spec.material("iron")
    sit, front, back = 0.45, -d / 2, d / 2
    for k in range(5):
        b.box(wood, (0, front + 0.07 + 0.092 * k, sit - 0.015 - 0.006 * k), (w, 0.075, 0.03), bevel=0.006)
    for k in range(4):
        b.box(
            wood,
            (0, back - 0.12 + 0.028 * k, sit + 0.1 + 0.09 * k),
            (w, 0.026, 0.072),
            bevel=0.006,
            rotation=(-16, 0, 0),
        )
    for x in (-1, 0, 1):
        at = x * (w / 2 - 0.1)
        b.tube(
            iron,
            [
                (at, front + 0.02, 0),
                (at, front + 0.08, sit * 0.5),
                (at, front + 0.05, sit - 0.04),
                (at, back - 0.16, sit - 0.06),
                (at, back - 0.02, h),
            ],
            0.022,
        )
        b.tube(iron, [(at, back - 0.02, 0), (at, back - 0.14, sit * 0.5), (at, back - 0.15, sit - 0.05)], 0.022)
        if x:
            b.tube(
                iron,
                [
                    (at, front + 0.05, sit - 0.02),
                    (at, front + 0.04, sit + 0.2),
                    (at, front + 0.14, sit + 0.23),
                    (at, back - 0.1, sit + 0.2),
                ],
                0.018,
            )
    return seats_in_row(spec.entry.seats, w - 0.16, front + 0.03, sit, d - 0.18)


@prop("mailbox")
def mailbox(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pillar box."""
    (w, _, h), body, iron, r = spec.size, spec.material("body"), spec.material("metal"), spec.size[0] / 2
    b.lathe(iron, [(r * 0.96, 0), (r * 0.96, 0.12)], segments=30)
    b.lathe(
        body,
        [(r * 0.9, 0.12), (r * 0.9, h * 0.82), (r, h * 0.84), (r, h * 0.9), (r * 0.9, h * 0.94), (r * 0.3, h)],
        segments=30,
    )
    b.box(iron, (0, -r * 0.9, h * 0.76), (w * 0.5, 0.03, 0.035), bevel=0.006)
    b.box("porcelain", (0, -r * 0.88, h * 0.6), (w * 0.36, 0.03, 0.18), bevel=0.006)
    b.box(body, (0, -r * 0.86, h * 0.38), (w * 0.56, 0.06, h * 0.4), bevel=0.012)
    return ()


@prop("phone_booth")
def phone_booth(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a glazed telephone booth, open at -Y, with its telephone inside."""
    (w, d, h), body = spec.size, spec.material("body")
    b.box(body, (0, 0, 0.06), (w, d, 0.12), bevel=0.01)
    b.box(body, (0, 0, h - 0.12), (w, d, 0.24), bevel=0.03)
    b.box("lampshade", (0, -d / 2 - 0.002, h - 0.13), (w * 0.74, 0.01, 0.12), bevel=0.003)
    for x in (-1, 1):
        for y in (-1, 1):
            b.box(body, (x * (w / 2 - 0.04), y * (d / 2 - 0.04), h / 2), (0.08, 0.08, h), bevel=0.008)
        for k in range(1, 7):
            b.box(body, (x * (w / 2 - 0.04), 0, h * 0.06 + k * h * 0.118), (0.03, d - 0.14, 0.025))
            b.box(body, (0, d / 2 - 0.04, h * 0.06 + k * h * 0.118), (w - 0.14, 0.03, 0.025))
        b.box(body, (x * (w / 2 - 0.04), 0, h * 0.12), (0.04, d - 0.14, h * 0.14))
    b.box(body, (0, d / 2 - 0.04, h * 0.12), (w - 0.14, 0.04, h * 0.14))
    b.box("plastic_black", (0, d / 2 - 0.12, h * 0.6), (0.3, 0.14, 0.46), bevel=0.01)
    b.cylinder("chrome", (0.05, d / 2 - 0.2, h * 0.62), (0.05, d / 2 - 0.18, h * 0.62), 0.06, segments=20)
    b.tube(
        "plastic_black",
        [(-0.12, d / 2 - 0.22, h * 0.53), (-0.12, d / 2 - 0.25, h * 0.6), (-0.12, d / 2 - 0.22, h * 0.68)],
        0.022,
    )
    b.box("wood", (0, d / 2 - 0.18, h * 0.46), (0.5, 0.24, 0.03), bevel=0.006)
    return (handle((-0.12, d / 2 - 0.25, h * 0.6), name="receiver"),)


@prop("market_stall")
def market_stall(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a stall with a striped awning and boxes of goods; the buyers are at -Y."""
    (w, d, h), cloth, wood = spec.size, spec.material("cloth"), spec.material("wood")
    for x in (-1, 1):
        for y, tall in ((-1, h - 0.3), (1, h - 0.08)):
            b.box(wood, (x * (w / 2 - 0.06), y * (d / 2 - 0.14), tall / 2), (0.06, 0.06, tall), bevel=0.006)
    stripes = 8
    for k in range(stripes):
        kind = cloth if k % 2 == 0 else "linen"
        x0, x1 = (-w / 2 - 0.05 + (w + 0.1) * i / stripes for i in (k, k + 1))
        edges = [(d / 2, h), (-d / 2, h - 0.34), (-d / 2 - 0.01, h - 0.5)]
        for lift, order in ((0.0, -1), (-0.008, 1)):
            b.loft(kind, [np.array([(x0, y, z + lift), (x1, y, z + lift)])[::order] for y, z in edges], closed=False)
    counter = 0.86
    b.box(wood, (0, -d * 0.12, counter - 0.02), (w - 0.08, d * 0.62, 0.04), bevel=0.006)
    for k in range(5):
        b.box(wood, (0, -d * 0.42, 0.12 + k * 0.16), (w - 0.1, 0.02, 0.13), bevel=0.004)
    goods = (spec.material("goods"), "fabric_red", "leaves", "brass", "wood_light", "leaves_dark")
    for i in range(4):
        x = (i - 1.5) * w * 0.235
        with b.at((x, -d * 0.16, counter), (12, 0, 0)):
            b.box(wood, (0, 0, 0.03), (w * 0.2, d * 0.46, 0.06), bevel=0.004)
            for row in range(3):
                for column in range(3):
                    b.sphere(
                        goods[(i + 2 * (row % 2)) % len(goods)],
                        ((column - 1) * 0.11, (row - 1) * 0.16, 0.09),
                        0.06,
                        segments=10,
                        rings=6,
                    )
    return (lean((0, -d * 0.43, counter), w), lean((0, d * 0.2, counter), w, (0, -1, 0), "keeper"))


@prop("fence_panel")
def fence_panel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a picket fence."""
    (w, d, h), wood = spec.size, spec.material("wood")
    count = max(4, round(w / 0.16))
    for k in range(count):
        x = (k - (count - 1) / 2) * w / count
        with b.at((x, -d * 0.1, 0), (90, 0, 0)):
            half = w / count * 0.34
            b.extrude(wood, [(-half, 0.04), (half, 0.04), (half, h - 0.1), (0, h), (-half, h - 0.1)], d * 0.25)
    for z in (h * 0.26, h * 0.72):
        b.box(wood, (0, d * 0.1, z), (w, d * 0.35, 0.09), bevel=0.005)
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.05), d * 0.18, h * 0.48), (0.09, d * 0.6, h * 0.96), bevel=0.006)
    return (lean((0, -d / 2, h - 0.05), w),)


@prop("barricade")
def barricade(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a striped barrier on two trestles."""
    (w, d, h), wood, stripe = spec.size, spec.material("wood"), spec.material("stripe")
    for z in (h - 0.12, h * 0.52):
        for k in range(8):
            kind = stripe if k % 2 else "porcelain"
            b.box(kind, ((k - 3.5) * w / 8, 0, z), (w / 8, 0.03, 0.2))
    for x in (-1, 1):
        for y in (-1, 1):
            b.tube(wood, [(x * (w / 2 - 0.14), y * d / 2, 0.03), (x * (w / 2 - 0.14), y * 0.03, h)], 0.03, segments=6)
    return (lean((0, -0.05, h), w),)


@prop("well")
def well(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a stone well with a winch under a little roof."""
    (w, d, h), stone, wood, roof = spec.size, spec.material("stone"), spec.material("wood"), spec.material("roof")
    r = w / 2 - 0.05
    b.lathe(
        stone, [(r, 0), (r, 0.75), (r + 0.05, 0.76), (r + 0.05, 0.86), (r - 0.16, 0.86), (r - 0.16, 0.1)], segments=28
    )
    b.lathe("water", [(r - 0.16, 0.3)] * 2, segments=24)
    for x in (-1, 1):
        b.box(wood, (x * (r - 0.02), 0, h * 0.46), (0.1, 0.1, h * 0.92), bevel=0.01)
    b.cylinder(wood, (-r, 0, 1.35), (r, 0, 1.35), 0.07, segments=12)
    b.tube("iron", [(r, 0, 1.35), (r + 0.09, 0, 1.35), (r + 0.09, -0.16, 1.25), (r + 0.16, -0.16, 1.25)], 0.014)
    b.cylinder("thatch", (0.1, 0, 1.3), (0.1, 0, 1.0), 0.014, segments=8)
    b.lathe(wood, [(0.09, 0.82), (0.12, 1.0), (0.11, 1.0), (0.08, 0.84)], origin=(0.1, 0, 0), segments=16)
    tilt = math.degrees(math.atan2(0.42, d / 2))
    for y in (-1, 1):
        b.box(roof, (0, y * d * 0.26, h - 0.24), (w * 1.06, d * 0.66, 0.05), bevel=0.01, rotation=(tilt * -y, 0, 0))
    return (lean((0, -r, 0.86), w * 0.7),)


@prop("gravestone")
def gravestone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a round-headed gravestone with an inscription."""
    (w, d, h), stone = spec.size, spec.material("stone")
    b.box(stone, (0, 0, 0.07), (w, d, 0.14), bevel=0.015)
    half = w * 0.42
    arch = [(half * math.cos(a), h - half + half * math.sin(a)) for a in np.linspace(0, math.pi, 17)]
    with b.at((0, d * 0.26, 0), (90, 0, 0)):
        b.extrude(stone, [(half, 0.1), *arch, (-half, 0.1)], d * 0.52)
    for k, length in enumerate((0.5, 0.62, 0.4, 0.56)):
        b.box("iron", (0, -d * 0.262, h * (0.68 - 0.09 * k)), (w * length, 0.006, 0.02))
    b.box("iron", (0, -d * 0.262, h * 0.8), (0.02, 0.006, 0.12))
    b.box("iron", (0, -d * 0.262, h * 0.82), (0.08, 0.006, 0.02))
    return ()


@prop("tent")
def tent(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a ridge tent whose flaps are open at -Y."""
    (w, d, h), cloth, pole = spec.size, spec.material("cloth"), spec.material("pole")
    for y in (-1, 1):
        b.cylinder(pole, (0, y * (d / 2 - 0.06), 0), (0, y * (d / 2 - 0.06), h), 0.025, segments=8)
    for x in (-1, 1):
        rows = []
        for t in np.linspace(0, 1, 7):
            sag = 0.06 * math.sin(math.pi * t)
            rows.append(
                np.array(
                    [
                        (
                            x * w / 2 * t * (1 - 0.04 * math.sin(math.pi * t)),
                            y * d / 2,
                            (h - 0.02) * (1 - t) - sag * (1 - abs(y)),
                        )
                        for y in (-1, -0.5, 0, 0.5, 1)
                    ]
                )
            )
        for lift, order in ((0.0, x), (0.012, -x)):
            b.loft(cloth, [(row - np.array([0, 0, lift]))[::order] for row in rows], closed=False)
        flap = [(x * 0.02, -d / 2, h - 0.05), (x * w / 2, -d / 2, 0.02), (x * w * 0.34, -d / 2 - 0.1, 0.02)]
        b.polygon(cloth, flap)
        b.polygon(cloth, flap[::-1])
        for y in (-0.4, 0.4):
            b.cylinder("thatch", (x * w / 2, y * d, 0.05), (x * (w / 2 + 0.2), y * d, 0.0), 0.006, segments=5)
    b.polygon(cloth, [(-w / 2, d / 2, 0), (0, d / 2, h - 0.02), (w / 2, d / 2, 0)])
    b.polygon(cloth, [(w / 2, d / 2 - 0.01, 0), (0, d / 2 - 0.01, h - 0.02), (-w / 2, d / 2 - 0.01, 0)])
    return ()


@prop("ladder")
def ladder(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a straight ladder, standing."""
    (w, d, h), wood = spec.size, spec.material("wood")
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.02), 0, h / 2), (0.04, d * 0.6, h), bevel=0.008)
    for z in np.arange(0.25, h - 0.1, 0.28):
        b.cylinder(wood, (-w / 2 + 0.02, 0, z), (w / 2 - 0.02, 0, z), 0.016, segments=10)
    return ()


@prop("flag")
def flag(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a flag that hangs from its pole."""
    (w, _, h), cloth = spec.size, spec.material("cloth")
    b.lathe("iron", [(0.15, 0), (0.14, 0.03), (0.04, 0.06), (0.03, 0.2)], segments=20)
    b.cylinder(spec.material("pole"), (0, 0, 0.1), (0, 0, h - 0.06), 0.02)
    b.sphere(spec.material("metal"), (0, 0, h - 0.04), 0.04, segments=14, rings=8)
    across = np.linspace(0, 1, 17)
    rows = []
    for t in np.linspace(0, 1, 7):
        reach = (w - 0.15) * (0.9 - 0.25 * t)
        drop = 0.35 * across**1.4 * (1 - 0.3 * t)
        rows.append(np.c_[0.02 + reach * across, 0.1 * np.sin(9 * across + 2 * t) * across, h - 0.12 - 0.85 * t - drop])
    for lift, order in ((0.0, 1), (0.006, -1)):
        b.loft(cloth, [(row + np.array([0, lift, 0]))[::order] for row in rows], closed=False)
    return ()


@prop("swing")
def swing(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a swing in its frame."""
    (w, d, h), frame = spec.size, spec.material("frame")
    for x in (-1, 1):
        for y in (-1, 1):
            b.cylinder(frame, (x * w / 2, y * d / 2, 0), (x * (w / 2 - 0.1), 0, h - 0.04), 0.03, segments=10)
        b.cylinder("iron", (x * 0.24, 0, 0.46), (x * 0.22, 0, h - 0.05), 0.008, segments=6)
    b.cylinder(frame, (-w / 2 + 0.04, 0, h - 0.04), (w / 2 - 0.04, 0, h - 0.04), 0.035, segments=12)
    b.box(spec.material("seat"), (0, 0, 0.46), (0.54, 0.22, 0.03), bevel=0.008)
    return (seat((0, -0.11, 0.475), (0.5, 0.22)),)


@prop("cannon")
def cannon(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a field gun that points to -Y."""
    (w, d, h), iron, wood = spec.size, spec.material("barrel"), spec.material("wood")
    for x in (-1, 1):
        spoked_wheel(b, wood, wood, (x * (w / 2 - 0.06), -d * 0.1, 0.55), 0.5, 0.045, 12)
        b.box(wood, (x * 0.18, d * 0.14, 0.48), (0.1, d * 0.66, 0.16), bevel=0.012, rotation=(-22, 0, 0))
    b.cylinder(iron, (-w / 2 + 0.05, -d * 0.1, 0.55), (w / 2 - 0.05, -d * 0.1, 0.55), 0.04)
    axis = np.array([0, -math.cos(0.14), math.sin(0.14)])
    barrel = [
        (0.03, -0.12),
        (0.05, -0.08),
        (0.03, -0.04),
        (0.17, 0),
        (0.18, 0.1),
        (0.16, 0.14),
        (0.14, 0.7),
        (0.16, 0.72),
        (0.12, 0.8),
        (0.1, 1.3),
        (0.13, 1.36),
        (0.13, 1.42),
        (0.07, 1.42),
        (0.065, 1.2),
    ]
    b.lathe(iron, barrel, origin=(0, d * 0.18, h * 0.62), axis=axis, segments=24)
    return ()


@prop("control_console")
def control_console(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a console of screens and buttons; the operator is at -Y."""
    (w, d, h), body, screen, light = spec.size, spec.material("body"), spec.material("screen"), spec.material("light")
    side = [
        (-d * 0.2, 0),
        (d / 2, 0),
        (d / 2, h),
        (d * 0.26, h),
        (d * 0.02, h * 0.72),
        (-d / 2, h * 0.62),
        (-d / 2, h * 0.54),
    ]
    with b.at((-w / 2, 0, 0), (90, 0, 90)):
        b.extrude(body, side, w)
    slope = math.degrees(math.atan2(h * 0.28, d * 0.24))
    for k in range(3):
        with b.at(((k - 1) * w * 0.31, d * 0.137, h * 0.862), (slope - 90, 0, 0)):
            b.box("plastic_black", (0, 0, 0), (w * 0.28, 0.02, h * 0.3), bevel=0.005)
            x, z = w * 0.13, h * 0.135
            b.quad(
                screen,
                (-x, -0.0115, -z),
                (x, -0.0115, -z),
                (x, -0.0115, z),
                (-x, -0.0115, z),
                uv=((0, 0), (1, 0), (1, 1), (0, 1)),
            )
    kinds = (light, "neon_red", "brass", "porcelain", "leaves")
    with b.at((0, -d * 0.24, h * 0.672), (math.degrees(math.atan2(h * 0.1, d * 0.52)), 0, 0)):
        for row in range(4):
            for k in range(18):
                kind = kinds[int(spec.rng.integers(len(kinds)))]
                b.box(
                    kind, ((k - 8.5) * w * 0.05, (row - 1.5) * d * 0.1, 0.008), (w * 0.03, d * 0.05, 0.02), bevel=0.003
                )
    b.box(light, (0, -d / 2 - 0.003, h * 0.58), (w * 0.96, 0.01, 0.02))
    return (lean((0, -d / 2, h * 0.62), w),)


@prop("altar")
def altar(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an altar with a cloth."""
    (w, d, h), stone, cloth = spec.size, spec.material("stone"), spec.material("cloth")
    b.box(stone, (0, 0, 0.06), (w * 0.92, d * 0.92, 0.12), bevel=0.015)
    b.box(stone, (0, 0, h / 2), (w * 0.8, d * 0.7, h - 0.1), bevel=0.012)
    b.box(stone, (0, 0, h - 0.05), (w, d, 0.1), bevel=0.02)
    b.box(cloth, (0, 0, h + 0.004), (w * 0.6, d + 0.012, 0.012))
    b.box(cloth, (0, -d / 2 - 0.008, h - 0.2), (w * 0.6, 0.012, 0.42))
    for k in range(14):
        b.box("gold", ((k - 6.5) * w * 0.043, -d / 2 - 0.009, h - 0.43), (0.012, 0.01, 0.06))
    b.box("gold", (0, -d / 2 - 0.016, h - 0.2), (0.03, 0.006, 0.24))
    b.box("gold", (0, -d / 2 - 0.016, h - 0.16), (0.14, 0.006, 0.03))
    four_legs(b, stone, w * 0.84, d * 0.78, h - 0.1, 0.12)
    return ()
