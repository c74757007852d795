"""Prop builders: trucks and buses: lofted sections along their length. Their front is -Y."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, boarding_place, handle, seat
from storyblender.blender.props.parts import wheel
from storyblender.blender.props.registry import PropSpec, prop
from storyblender.memory.asset_sheet import Anchor

Section = tuple[float, float, float, float]
"""y, half width, lower z, upper z."""


def _shell(b: MeshBuilder, material: MaterialRef, sections: list[Section], round_top: float = 0.14) -> None:
    """Add a body whose sections bulge at the belt and round off at the top."""
    rings = []
    for y, half, low, high in sections:
        tall = high - low
        r = min(round_top, tall * 0.45)
        outline = [
            (0.9, low), (0.985, low + tall * 0.12), (1.0, low + tall * 0.45), (0.97, high - r), (0.93, high - r * 0.45),
            (0.84, high - r * 0.1), (0.6, high), (0.0, high + 0.012),
        ]  # fmt: skip
        right = [(half * x, y, z) for x, z in outline]
        left = [(-x, y_, z) for x, y_, z in reversed(right[:-1])]
        rings.append(np.array(right + left))
    b.loft(material, rings)


def _greenhouse(b: MeshBuilder, paint: MaterialRef, glass: MaterialRef, sections: list[Section]) -> None:
    """Add a glass cabin between pillars under a roof; the sections are belt, roof front, roof back, belt."""
    (y0, w0, z0, _), (y1, w1, _, h1), (y2, w2, _, h2), (y3, w3, z3, _) = sections
    belt = [np.array([(-w0, y0, z0), (w0, y0, z0)]), np.array([(-w3, y3, z3), (w3, y3, z3)])]
    roof = [np.array([(-w1, y1, h1), (w1, y1, h1)]), np.array([(-w2, y2, h2), (w2, y2, h2)])]
    skin = 0.012
    b.quad(glass, belt[0][0], belt[0][1], roof[0][1], roof[0][0])
    b.quad(glass, belt[1][1], belt[1][0], roof[1][0], roof[1][1])
    b.quad(glass, belt[0][1], belt[1][1], roof[1][1], roof[0][1])
    b.quad(glass, belt[1][0], belt[0][0], roof[0][0], roof[1][0])
    crown = []
    for y, half, z in (
        (y1 - 0.05, w1 * 0.97, h1 - 0.03),
        (y1 + 0.1, w1 * 1.02, h1 + 0.02),
        ((y1 + y2) / 2, (w1 + w2) / 2 * 1.03, max(h1, h2) + 0.035),
        (y2 - 0.1, w2 * 1.02, h2 + 0.02),
        (y2 + 0.05, w2 * 0.97, h2 - 0.03),
    ):
        crown.append(
            np.array(
                [
                    (half * x, y, z + up)
                    for x, up in ((-1, -0.05), (1, -0.05), (0.96, -0.01), (0.7, 0.02), (-0.7, 0.02), (-0.96, -0.01))
                ]
            )
        )
    b.loft(paint, crown)
    for side in (0, 1):
        for start, end in ((belt[0][side], roof[0][side]), (belt[1][side], roof[1][side])):
            b.tube(paint, [start, end], 0.03 + skin, segments=6)
        middle = 0.52
        low = belt[0][side] * (1 - middle) + belt[1][side] * middle
        high = roof[0][side] * (1 - middle) + roof[1][side] * middle
        b.tube(paint, [low, high], 0.035, segments=6)


def _wheels(b: MeshBuilder, spec: PropSpec, half: float, radius: float, axles: tuple[float, ...], width: float) -> None:
    """Add a wheel on both sides at each axle (y); ``half`` is half the width of the vehicle."""
    for x in (-1, 1):
        for y in axles:
            wheel(b, spec.material("tyre"), spec.material("chrome"), (x * (half - width / 2), y, radius), radius, width)


def _lamps(b: MeshBuilder, spec: PropSpec, x: float, front: float, back: float, z: float, radius: float) -> None:
    """Add headlamps at ``front`` and tail lamps at ``back`` (y), ``x`` metres to either side, at height ``z``."""
    for side in (-1, 1):
        outline = [(radius * 1.15, -0.06), (radius * 1.15, 0.01), (radius, 0.015)]
        b.lathe(spec.material("chrome"), outline, origin=(side * x, front, z), axis=(0, -1, 0), segments=18)
        profile = [(radius, 0.012), (radius * 0.6, 0.035), (0.003, 0.045)]
        b.lathe(spec.material("lamp"), profile, origin=(side * x, front, z), axis=(0, -1, 0), segments=18, caps=False)
        b.rounded_box("neon_red", (side * x, back, z), (radius * 1.6, 0.05, radius * 1.3), 0.018)


def _door_handles(half: float, places: tuple[float, float], z: float) -> Anchors:
    """Return the handles of four doors: ``places`` are the y of the front and the rear ones, ``half`` the x."""
    return tuple(
        handle((x * half, y, z), (float(x), 0.0, 0.0), f"door_{end}_{side}")
        for side, x in (("left", 1), ("right", -1))
        for end, y in zip(("front", "rear"), places, strict=True)
    )


@prop("truck")
def truck(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a truck with a cab and an open wooden bed."""
    (w, d, h), paint, glass, wood = spec.size, spec.material("body"), spec.material("glass"), spec.material("bed")
    half, f, r = w / 2, -d / 2, d / 2
    cab = half * 0.84
    _shell(b, paint, [
        (f + 0.1, cab * 0.62, 0.6, 1.2), (f + 0.2, cab * 0.72, 0.55, 1.34), (f + 1.0, cab * 0.8, 0.55, 1.4),
        (f + 1.15, cab * 0.98, 0.5, 1.42), (f + 2.3, cab, 0.5, 1.42),
    ])  # fmt: skip
    sections = [
        (f + 1.15, cab * 0.92, 1.4, 0),
        (f + 1.35, cab * 0.82, 0, h - 0.1),
        (f + 2.2, cab * 0.84, 0, h - 0.1),
        (f + 2.3, cab * 0.94, 1.4, 0),
    ]
    _greenhouse(b, paint, glass, sections)
    b.box("iron", (0, (f + r) / 2 + 0.6, 0.66), (w * 0.4, d - 1.6, 0.16))
    bed = d - 2.5
    middle = r - bed / 2
    b.box(wood, (0, middle, 0.96), (w, bed, 0.08), bevel=0.01)
    for x in (-1, 1):
        for k in range(3):
            b.box(wood, (x * (half - 0.02), middle, 1.12 + 0.24 * k), (0.04, bed, 0.19), bevel=0.008)
        for k in range(5):
            b.box("iron", (x * (half + 0.01), middle + (k - 2) * bed * 0.235, 1.3), (0.03, 0.06, 0.8), bevel=0.006)
    for y in (r - 0.02, r - bed + 0.02):
        for k in range(3):
            b.box(wood, (0, y, 1.12 + 0.24 * k), (w - 0.1, 0.04, 0.19), bevel=0.008)
    axles = (f + 0.85, r - 1.2)
    for x in (-1, 1):
        b.cushion(paint, (x * (half - 0.24), f + 0.85, 0.66), (0.46, 1.3, 0.66), softness=0.7)
    _wheels(b, spec, half - 0.02, 0.46, axles, 0.24)
    _wheels(b, spec, half - 0.3, 0.46, axles[1:], 0.24)
    _lamps(b, spec, cab * 0.85, f + 0.12, r + 0.01, 1.05, 0.11)
    b.rounded_box(spec.material("chrome"), (0, f + 0.02, 0.6), (w * 0.9, 0.08, 0.16), 0.03)
    for k in range(8):
        b.box(spec.material("chrome"), ((k - 3.5) * 0.1, f + 0.1, 0.98), (0.035, 0.03, 0.5), bevel=0.008)
    high, row = 1.05, f + 1.62
    places: list[Anchor] = []
    for x, name in ((1, "driver"), (-1, "passenger")):
        places.append(seat((x * cab * 0.45, row, high), (0.5, 0.45), name=name, headroom=h - 0.16 - high))
        places.append(boarding_place(x * (half + 0.45), row, name))
    return (*places, *_door_handles(cab, (f + 2.0, f + 2.1), 1.2))


@prop("bus")
def bus(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bus: rows of open windows, seats on both sides of the aisle, a door on its right that can stand open."""
    (w, d, h), paint, chrome = spec.size, spec.material("body"), spec.material("chrome")
    half, f, r = w / 2, -d / 2, d / 2
    belt, top, floor = 1.42, h - 0.42, 0.5
    door = (f + 0.35, f + 1.35)
    b.box(paint, (0, 0, floor - 0.08), (w - 0.02, d - 0.1, 0.14), bevel=0.02)
    b.rounded_box(paint, (0, 0, h - 0.21), (w, d, 0.42), 0.16)
    for x in (-1, 1):
        start = door[1] if x < 0 else f + 0.05
        b.box(
            paint, (x * (half - 0.03), (start + r) / 2, (0.34 + belt) / 2), (0.06, r - start, belt - 0.34), bevel=0.02
        )
        b.box(chrome, (x * (half + 0.004), (start + r) / 2, belt - 0.12), (0.02, r - start - 0.1, 0.05), bevel=0.006)
        count = max(4, round((r - door[1]) / 1.15))
        posts = [door[1] + (r - 0.06 - door[1]) * k / count for k in range(count + 1)] + [f + 0.06]
        for y in posts:
            b.box(paint, (x * (half - 0.03), y, (belt + top) / 2), (0.06, 0.09, top - belt + 0.04))
        for y in (f + 2.0, r - 2.1):
            b.cylinder("plastic_black", (x * (half - 0.3), y, 0.48), (x * (half + 0.004), y, 0.48), 0.54, segments=26)
    b.box(paint, (-half + 0.03, f + 0.2, (0.34 + belt) / 2), (0.06, 0.3, belt - 0.34), bevel=0.02)
    for y, low in ((f + 0.04, 1.2), (r - 0.04, 1.5)):
        b.rounded_box(paint, (0, y, (0.36 + low) / 2), (w - 0.02, 0.1, low - 0.36), 0.04)
        b.rounded_box(chrome, (0, y + (0.05 if y > 0 else -0.05), 0.5), (w * 0.92, 0.08, 0.18), 0.035)
    middle, wide = (door[0] + door[1]) / 2, door[1] - door[0]
    leaf = (-half - (0.32 if spec.flag("open") else 0.0), middle + (0.75 if spec.flag("open") else 0.0))
    b.box("glass_dark", (leaf[0] + 0.02, leaf[1], (0.36 + top) / 2), (0.04, wide - 0.04, top - 0.36), bevel=0.01)
    _wheels(b, spec, half + 0.02, 0.46, (f + 2.0, r - 2.1), 0.28)
    _lamps(b, spec, half * 0.74, f + 0.0, r - 0.0, 0.8, 0.12)
    b.rounded_box("lampshade", (0, f + 0.02, h - 0.24), (w * 0.6, 0.1, 0.22), 0.03)
    return (*_bus_seats(b, half, f, r), Anchor(kind="door", name="door", location=(-half - 0.5, middle, 0.0),
                                               direction=(1.0, 0.0, 0.0)))  # fmt: skip


def _bus_seats(b: MeshBuilder, half: float, front: float, back: float) -> list[Anchor]:
    """Add the driver's seat with its wheel and the passengers' rows; return them."""
    floor, sit, cover = 0.5, 0.95, "fabric_blue"
    rows = np.arange(front + 2.1, back - 0.7, 0.95)
    places = [("driver", half * 0.5, front + 0.95, 0.55)]
    places += [(f"seat_{2 * k + (x < 0) + 1}", x * (half - 0.42), float(y), 0.75) for k, y in enumerate(rows)
               for x in (1, -1)]  # fmt: skip
    for _, x, y, wide in places:
        b.box("steel", (x, y + 0.25, (floor + sit) / 2 - 0.05), (wide * 0.6, 0.3, sit - floor - 0.1))
        b.cushion(cover, (x, y + 0.24, sit - 0.05), (wide, 0.46, 0.12), softness=0.25)
        b.cushion(cover, (x, y + 0.48, sit + 0.32), (wide, 0.1, 0.66), softness=0.25, rotation=(-8, 0, 0))
    turn = np.linspace(0, 2 * np.pi, 23)[:-1]
    middle = np.array((half * 0.5, front + 0.5, sit + 0.32))
    b.tube("plastic_black", middle + 0.24 * np.c_[np.cos(turn), 0.9 * np.sin(turn), 0.43 * np.sin(turn)], 0.016,
           segments=6, closed=True)  # fmt: skip
    b.cylinder("plastic_black", middle, (half * 0.5, front + 0.3, floor), 0.03, segments=6)
    return [seat((x, y, sit), (wide, 0.5), name=name) for name, x, y, wide in places]
