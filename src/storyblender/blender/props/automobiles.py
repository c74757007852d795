"""Prop builders: cars with an interior: a hollow body with doors that can open, seats. Their front is -Y.

Window panes are left out so that the people inside are visible. The driver's side is +X, the car's own left.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, handle, panel, part, seat
from storyblender.blender.props.car_parts import lever, mirror, pedals, seat_cushions, steering_wheel
from storyblender.blender.props.parts import wheel
from storyblender.blender.props.registry import PropSpec, prop
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec3

DARK = "plastic_black"
SILL, FLOOR, SIT = 0.27, 0.3, 0.47
"""Heights in metres of the lower door edge, the floor and the seats."""
PANEL = 0.07
"""Thickness of a door in metres."""
LINING = 0.1
"""Metres from the top of a car to the lining of its roof."""
AJAR = 62.0
"""Opening angle of an open door in degrees."""
ASIDE = 0.55
"""Distance from the body in metres of the point where a person stands to get in."""


@dataclass(frozen=True)
class Style:
    """Dimensions of a car type, in metres.

    Attributes:
        nose: From the front end to the windscreen's foot.
        tail: From the rear end to the back of the cabin.
        bonnet: Height of the bonnet at the front end.
        deck: Height of the boot at the rear end.
        belt: Height of the lower edge of the windows.
        rows: Rows of seats, 1 or 2.
        rake: How far the windscreen and the rear window lean in.
        roof: Whether it has a roof.
        rear: Type of the part behind the cabin.
        wheel: Radius of a wheel.
    """

    nose: float = 1.35
    tail: float = 0.95
    bonnet: float = 0.7
    deck: float = 0.9
    belt: float = 0.94
    rows: int = 2
    rake: tuple[float, float] = (0.62, 0.45)
    roof: bool = True
    rear: Literal["boot", "bed", "box", "none"] = "boot"
    wheel: float = 0.32


SEDAN = Style()
VINTAGE = Style(nose=1.55, tail=0.8, bonnet=1.04, deck=0.82, belt=1.06, rake=(0.16, 0.3), wheel=0.34)
OPEN_CAR = Style(roof=False, rows=2, tail=1.0, belt=0.88)
OFF_ROAD = Style(nose=1.2, tail=0.12, bonnet=1.0, deck=1.0, belt=1.08, rake=(0.28, 0.12), rear="none", wheel=0.38)
PICKUP = Style(nose=1.3, tail=1.95, bonnet=0.98, deck=0.9, belt=1.08, rows=1, rake=(0.45, 0.1), rear="bed", wheel=0.37)
VAN = Style(nose=0.85, tail=2.75, bonnet=0.95, belt=1.12, rows=1, rake=(0.62, 0.0), rear="box", wheel=0.34)


def automobile(b: MeshBuilder, spec: PropSpec, style: Style) -> Anchors:
    """Add a car of a style.

    Args:
        b: The builder.
        spec: ``open`` names the doors that stand open: driver, passenger, rear_left, rear_right, or all; roles are
            body, trim, tyre, chrome and lamp.
        style: Dimensions of the car type.

    Returns:
        Seats (driver, passenger, rear_left, rear_right), the points beside its doors and their handles, the parts
        that people handle, and the panels that a shot can hide.
    """
    (w, d, _), paint = spec.size, spec.material("body")
    half, front, back = w / 2, -d / 2 + style.nose, d / 2 - style.tail
    middle = back if style.rows == 1 else (front + back) / 2 + 0.08
    anchors = _ends(b, spec, style, front, back)
    b.box(DARK, (0, (front + back) / 2, FLOOR - 0.03), (w - 0.1, back - front + 0.2, 0.06))
    for x in (-1, 1):
        b.box(paint, (x * (half - 0.07), (front + back) / 2, SILL - 0.03), (0.1, back - front, 0.1), bevel=0.02)
    if style.roof:
        anchors += _roof(b, spec, style, front, middle, back)
    anchors += _inside(b, spec, style, front, back)
    _running_gear(b, spec, style)
    rows = [("driver", "passenger", front + 0.06, middle), ("rear_left", "rear_right", middle, back)][: style.rows]
    for left, right, start, end in rows:
        for x, name in ((1, left), (-1, right)):
            is_open = bool({name, "all"} & {*spec.word("open").split()})
            with b.panel(f"door_{name}"):
                _door(b, spec, style, x, start, end, is_open)
            anchors += _places(x, name, spec.size, start, end, style)
            size = (0.2, end - start, style.belt - SILL)
            anchors.append(panel(f"door_{name}", (x * (half - 0.06), (start + end) / 2, (SILL + style.belt) / 2), size))
    return tuple(anchors)


def _places(x: int, name: str, size: Vec3, start: float, end: float, style: Style) -> list[Anchor]:
    """Return the seat ``name``, the place to get in and the handle of the door from ``start`` to ``end`` (y)."""
    half, roof = size[0] / 2, size[2] - LINING - SIT if style.roof else None
    row = start + 0.45 if name in ("driver", "passenger") else end - 0.62
    at = Anchor(
        kind="door", name=name, location=(x * (half + ASIDE), (start + end) / 2, 0.0), direction=(-float(x), 0.0, 0.0)
    )
    return [
        seat((x * half * 0.44, row, SIT), (half * 0.6, 0.5), name=name, headroom=roof),
        at,
        handle((x * half, end - 0.14, style.belt - 0.12), (float(x), 0.0, 0.0), f"door_{name}"),
    ]


def _block(b: MeshBuilder, paint: MaterialRef, sections: list[tuple[float, float, float]]) -> None:
    """Add a closed part of the body; sections are (y, half width, upper z) in metres."""
    rings = []
    for y, half, high in sections:
        outline = [(0.93, SILL - 0.04), (1.0, SILL + 0.2), (0.98, high - 0.13), (0.9, high - 0.03), (0.6, high)]
        right = [(half * x, y, z) for x, z in outline]
        rings.append(np.array([*right, (0.0, y, high + 0.015), *((-x, at, z) for x, at, z in reversed(right))]))
    b.loft(paint, rings)


def _ends(b: MeshBuilder, spec: PropSpec, style: Style, front: float, back: float) -> list[Anchor]:
    """Add the parts in front of and behind the cabin: bonnet, boot or bed, lamps, bumpers and plates.

    Returns:
        The panel of the bonnet.
    """
    (w, d, h), paint = spec.size, spec.material("body")
    half, f, r = w / 2, -d / 2, d / 2
    hood = [(f, half * 0.84, style.bonnet - 0.12), (f + 0.12, half * 0.94, style.bonnet)]
    hood += [(f + style.nose * 0.5, half, (style.bonnet + style.belt) / 2 + 0.02), (front + 0.04, half, style.belt)]
    with b.panel("bonnet"):
        _block(b, paint, hood)
    if style.rear == "boot":
        ends = [(back - 0.04, half, style.belt + 0.02), (back + style.tail * 0.6, half * 0.98, style.deck + 0.05)]
        _block(b, paint, [*ends, (r - 0.1, half * 0.94, style.deck), (r, half * 0.86, style.deck - 0.12)])
    elif style.rear == "bed":
        length = r - back
        b.box(DARK, (0, back + length / 2, 0.62), (w - 0.1, length, 0.06))
        b.box(paint, (0, back, (SILL + style.belt) / 2), (w - 0.06, 0.06, style.belt - SILL), bevel=0.02)
        for x in (-1, 1):
            b.box(paint, (x * (half - 0.06), back + length / 2, 0.62), (0.12, length, 0.66), bevel=0.03)
        b.box(paint, (0, r - 0.04, 0.68), (w - 0.1, 0.08, 0.52), bevel=0.02)
    elif style.rear == "box":
        rings = [(back - 0.02, h - 0.08), (back + 0.3, h), (r - 0.06, h - 0.02), (r, h - 0.1)]
        _block(b, paint, [(y, half * (1.0 if y < r else 0.97), z) for y, z in rings])
        b.box(DARK, (0, r + 0.002, h / 2 + 0.1), (0.014, 0.012, h - 0.75))
    else:
        b.box(paint, (0, r - 0.06, (SILL + style.belt) / 2), (w - 0.08, 0.12, style.belt - SILL), bevel=0.03)
        profile = [(0.2, -0.09), (0.33, -0.09), (0.33, 0.09), (0.2, 0.09)]
        b.lathe(spec.material("tyre"), profile, origin=(0, r + 0.06, 0.85), axis=(0, 1, 0), segments=22)
    for x in (-1, 1):
        z = style.bonnet - 0.16
        b.rounded_box(spec.material("lamp"), (x * half * 0.64, f + 0.02, z), (half * 0.38, 0.12, 0.13), 0.04)
        b.rounded_box("neon_red", (x * half * 0.74, r - 0.02, 0.72), (half * 0.26, 0.1, 0.14), 0.03)
        b.rounded_box(paint, (x * (half + 0.07), front + 0.2, style.belt + 0.08), (0.17, 0.08, 0.12), 0.03)
    b.rounded_box(DARK, (0, f + 0.0, style.bonnet - 0.18), (half * 0.74, 0.08, 0.13), 0.02)
    for y in (f - 0.02, r + 0.02):
        b.rounded_box(spec.material("trim"), (0, y, 0.42), (w * 0.93, 0.1, 0.15), 0.04)
        b.box("porcelain", (0, y + (0.056 if y > 0 else -0.056), 0.42), (0.44, 0.012, 0.1), bevel=0.003)
    return [panel("bonnet", (0.0, (f + front) / 2, (SILL + style.belt) / 2), (w, front - f, style.belt - SILL))]


def _roof(b: MeshBuilder, spec: PropSpec, style: Style, front: float, middle: float, back: float) -> list[Anchor]:
    """Add the roof, its posts and the mirror, given the y of the windscreen, the door post and the rear window.

    Returns:
        The mirror, and the panels of the roof, of the windscreen's frame and of the other posts.
    """
    (w, _, h), paint = spec.size, spec.material("body")
    half, top, skin = w / 2, h - 0.05, 0.035
    low, wide = style.belt - 0.03, half * 0.79
    fore, aft = front + style.rake[0], back - style.rake[1]
    rings = []
    for y, reach, z in (
        (fore - 0.04, 0.96, -0.02),
        (fore + 0.12, 1.02, 0.02),
        ((fore + aft) / 2, 1.04, 0.045),
        (aft - 0.1, 1.02, 0.02),
        (aft + 0.04, 0.96, -0.02),
    ):
        x = wide * reach
        rings.append(
            [
                (x * s, y, top + z + up)
                for s, up in ((-1, -0.05), (1, -0.05), (0.95, -0.01), (0.7, 0.01), (-0.7, 0.01), (-0.95, -0.01))
            ]
        )
    with b.panel("roof"):
        b.loft(paint, [np.array(ring) for ring in rings])
    glass = top - style.belt
    anchors = [panel("roof", (0.0, (fore + aft) / 2, top), (2 * wide, aft - fore + 0.1, 0.16))]
    posts = {
        "windscreen": ((front + 0.03, half * 0.93), (fore, wide)),
        "rear": ((back - 0.03, half * 0.93), (aft, wide)),
    }
    posts |= {"middle": ((middle, half * 0.95), (middle, wide * 1.02))} if style.rows > 1 else {}
    for x, side in ((-1, "right"), (1, "left")):
        for name, ((y0, x0), (y1, x1)) in posts.items():
            with b.panel(f"post_{name}_{side}"):
                b.tube(paint, [(x * x0, y0, low), (x * x1, y1, top - 0.01)], skin, segments=8)
            at, size = (x * (x0 + x1) / 2, (y0 + y1) / 2, style.belt + glass / 2), (0.28, abs(y1 - y0) + 0.2, glass)
            anchors.append(panel(f"post_{name}_{side}", at, size))
    place = (0.0, fore + 0.04, top - 0.14)
    with b.panel("mirror"), b.at(place):
        mirror(b)
    return [*anchors, part("mirror", place, (0.24, 0.05, 0.09))]


def _inside(b: MeshBuilder, spec: PropSpec, style: Style, front: float, back: float) -> list[Anchor]:
    """Add dashboard, steering wheel and seats between the y of the windscreen and that of the rear seat's back.

    Returns:
        The parts that the driver handles, and the panel of the dashboard.
    """
    half = spec.size[0] / 2
    at, across = (0.0, front + 0.16, style.belt - 0.13), (2 * half - 0.2, 0.3, 0.22)
    with b.panel("dashboard"):
        b.box(DARK, at, across, bevel=0.05)
        for x in (-0.08, 0.08):
            b.cylinder(
                "lamp_cool",
                (half * 0.44 + x, front + 0.312, at[2] + 0.02),
                (half * 0.44 + x, front + 0.316, at[2] + 0.02),
                0.05,
            )
    anchors = [panel("dashboard", at, across)]
    left, row = half * 0.44, front + 0.45
    held = {
        "steering_wheel": (steering_wheel, (left, front + 0.42, style.belt - 0.06), (0.4, 0.2, 0.36)),
        "lever": (lever, (left, row + 0.0, SIT - 0.14), (0.34, 0.08, 0.05)),
        "pedals": (pedals, (left, front + 0.12, FLOOR + 0.1), (0.36, 0.14, 0.16)),
    }
    for name, (build, place, size) in held.items():
        with b.panel(name), b.at(place):
            build(b)
        anchors.append(part(name, place, size))
    mat = (left, front + 0.3, FLOOR + 0.006)
    with b.panel("mat"):
        b.box("rubber", mat, (0.5, 0.5, 0.012), bevel=0.004)
    anchors.append(part("mat", mat, (0.5, 0.5, 0.02)))
    rows = [("seat_driver", left, row, half * 0.62), ("seat_passenger", -left, row, half * 0.62)]
    rows += [("seat_rear", 0.0, back - 0.62, half * 1.6)] * (style.rows > 1)
    for name, x, y, wide in rows:
        with b.panel(name), b.at((x, y, SIT)):
            seat_cushions(b, wide, SIT - FLOOR)
        anchors.append(part(name, (x, y + 0.32, SIT + 0.24), (wide, 0.66, 0.82)))
    return anchors


def _door(b: MeshBuilder, spec: PropSpec, style: Style, x: int, start: float, end: float, is_open: bool) -> None:
    """Add a door from ``start`` to ``end`` along the side at ``x``, hinged at its front edge."""
    half, length = spec.size[0] / 2, end - start - 0.014
    outline = [(-PANEL, SILL), (-0.045, SILL), (0.0, SILL + 0.2), (-0.02, style.belt - 0.12), (-0.05, style.belt)]
    outline += [(-PANEL - 0.04, style.belt), (-PANEL - 0.02, SILL + 0.2)]
    with (
        b.at((x * half, start + 0.007, 0.0), scale=(x, 1, 1)),
        b.at((-0.03, 0, 0), (0, 0, -AJAR if is_open else 0.0)),
        b.at((0.03, 0, 0)),
    ):
        b.loft(spec.material("body"), [np.array([(u, y, z) for u, z in outline]) for y in (0.0, length)])
        b.box(DARK, (-PANEL - 0.05, length * 0.55, style.belt - 0.28), (0.05, length * 0.5, 0.06), bevel=0.015)
        b.box(spec.material("chrome"), (0.0, length - 0.14, style.belt - 0.14), (0.035, 0.16, 0.03), bevel=0.008)
        b.box(spec.material("chrome"), (-0.05, length / 2, style.belt), (0.03, length, 0.016))


def _running_gear(b: MeshBuilder, spec: PropSpec, style: Style) -> None:
    """Add the four wheels and the dark arches above them."""
    (w, d, _), radius = spec.size, style.wheel
    half = w / 2
    for y in (-d / 2 + max(0.8, style.nose * 0.6), d / 2 - max(0.75, min(style.tail * 0.8, 1.05))):
        for x in (-1, 1):
            arch = radius + 0.055
            b.cylinder(DARK, (x * (half - 0.26), y, arch), (x * (half + 0.004), y, arch), arch, segments=26)
            at = (x * (half - 0.085), y, radius)
            wheel(b, spec.material("tyre"), spec.material("chrome"), at, radius, 0.2)


@prop("car")
def car(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a four-door car of the wanted ``period``: 1940s or modern."""
    if spec.word("period") not in ("1940s", "past", "classic"):
        return automobile(b, spec, SEDAN)
    (w, d, _), paint, chrome = spec.size, spec.material("body"), spec.material("chrome")
    half, f, r = w / 2, -d / 2, d / 2
    anchors = automobile(b, spec, VINTAGE)
    for x in (-1, 1):
        for y, length in ((f + 0.85, 1.35), (r - 0.75, 1.1)):
            with b.panel("bonnet" if y < 0 else ""):  # the front wings go with it
                b.cushion(paint, (x * (half - 0.06), y, 0.58), (0.36, length, 0.6), softness=0.75)
        b.box(paint, (x * (half - 0.02), 0.05, 0.3), (0.26, d * 0.42, 0.05), bevel=0.012)
        b.lathe(chrome, [(0.15, -0.12), (0.15, 0.0)], origin=(x * half * 0.66, f + 0.04, 0.86), axis=(0, -1, 0))
        profile = [(0.13, 0.0), (0.08, 0.03), (0.003, 0.045)]
        b.lathe(spec.material("lamp"), profile, origin=(x * half * 0.66, f + 0.04, 0.86), axis=(0, -1, 0), caps=False)
    for k in range(8):
        b.rounded_box(chrome, (0, f - 0.01, 0.56 + 0.055 * k), (half * 0.6, 0.05, 0.022), 0.01)
    return anchors


@prop("taxi")
def taxi(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a taxi with its sign and a band of squares."""
    (_, d, h), half = spec.size, spec.size[0] / 2
    anchors = automobile(b, spec, SEDAN)
    b.box("lamp_warm", (0, 0.1, h + 0.07), (0.5, 0.2, 0.15), bevel=0.03)
    for k in range(16):
        for x in (-1, 1):
            z = 0.62 + 0.06 * (k % 2)
            b.box(DARK, (x * (half + 0.004), -d / 2 + style_span(d, k), z), (0.008, 0.1, 0.055))
    return anchors


def style_span(length: float, step: int) -> float:
    """Return where a square of a taxi's checker band is, in metres from the front end.

    Args:
        length: Of the car, metres.
        step: Index of the square, 0 to 15.
    """
    return SEDAN.nose + 0.12 + step * (length - SEDAN.nose - SEDAN.tail - 0.24) / 15


@prop("police_car")
def police_car(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a police car: a bar of blue and red lights, a broad band along its sides."""
    (_, d, h), half = spec.size, spec.size[0] / 2
    anchors = automobile(b, spec, SEDAN)
    b.box(DARK, (0, 0.1, h + 0.035), (1.1, 0.16, 0.05), bevel=0.01)
    for x, lamp in ((-1, "neon_red"), (1, "neon_blue")):
        b.rounded_box(lamp, (x * 0.3, 0.1, h + 0.11), (0.46, 0.2, 0.12), 0.04)
        b.box(spec.material("band"), (x * (half + 0.004), 0.1, 0.62), (0.012, d - SEDAN.nose - SEDAN.tail - 0.1, 0.24))
    return anchors


@prop("convertible")
def convertible(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a convertible with a windscreen and its folded top behind the seats."""
    half = spec.size[0] / 2
    anchors = automobile(b, spec, OPEN_CAR)
    front, back = -spec.size[1] / 2 + OPEN_CAR.nose, spec.size[1] / 2 - OPEN_CAR.tail
    frame = [(half * 0.9, front + 0.04, OPEN_CAR.belt), (half * 0.8, front + 0.34, 1.28)]
    b.tube("chrome", [*frame, *((-x, y, z) for x, y, z in reversed(frame))], 0.022, segments=8)
    b.cushion("leather_black", (0, back + 0.12, OPEN_CAR.belt + 0.06), (half * 1.7, 0.42, 0.2), softness=0.5)
    return anchors


@prop("jeep")
def jeep(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an off-road car with a spare wheel on its rear."""
    return automobile(b, spec, OFF_ROAD)


@prop("pickup")
def pickup(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pickup with an open bed."""
    return automobile(b, spec, PICKUP)


@prop("van")
def van(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a delivery van with an open cab."""
    return automobile(b, spec, VAN)


@prop("ambulance")
def ambulance(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an ambulance: blue lights, red crosses and a band."""
    (_, d, h), half = spec.size, spec.size[0] / 2
    anchors = automobile(b, spec, VAN)
    y = d / 2 - VAN.tail / 2
    for x in (-1, 1):
        b.rounded_box("neon_blue", (x * 0.5, d / 2 - VAN.tail + 0.3, h + 0.06), (0.5, 0.26, 0.14), 0.05)
        for size in ((0.012, 0.5, 0.16), (0.012, 0.16, 0.5)):
            b.box("neon_red", (x * half, y, h * 0.68), size)
        b.box("neon_red", (x * (half + 0.002), y, 0.8), (0.012, VAN.tail - 0.4, 0.12))
    return anchors
