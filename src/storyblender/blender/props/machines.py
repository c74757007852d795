"""Prop builders: radios, telephones, screens, typewriters: machines that stand on tables."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, grips_under, two_hands
from storyblender.blender.props.registry import PropSpec, prop
from storyblender.blender.props.wall_fittings import WHOLE


@prop("radio")
def radio(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wooden wireless with an arched top."""
    (w, d, h), wood = spec.size, spec.material("body")
    arch = [(w / 2 * math.cos(a), h * 0.62 + h * 0.38 * math.sin(a)) for a in np.linspace(0, math.pi, 19)]
    with b.at((0, d / 2, 0), (90, 0, 0)):
        b.extrude(wood, [(w / 2, 0.02), *arch, (-w / 2, 0.02)], d - 0.01)
        inner = [(x * 0.82, 0.06 + (z - 0.06) * 0.86) for x, z in [(w / 2, h * 0.42), *arch, (-w / 2, h * 0.42)]]
        b.extrude(spec.material("cloth"), inner, 0.004, base=d - 0.01)
    b.box(wood, (0, 0, 0.012), (w + 0.02, d, 0.024), bevel=0.006)
    for k in range(4):
        x = (k - 1.5) * w * 0.17
        b.box(wood, (x, -d / 2 + 0.004, h * 0.64), (0.014, 0.012, h * 0.44), bevel=0.003)
    b.box(spec.material("dial"), (0, -d / 2 + 0.006, h * 0.3), (w * 0.5, 0.01, h * 0.16), bevel=0.003)
    for x in (-1, 0, 1):
        profile = [(0.024, 0), (0.022, 0.02), (0.016, 0.022)]
        b.lathe("plastic_black", profile, origin=(x * w * 0.3, -d / 2 + 0.01, h * 0.13), axis=(0, -1, 0), segments=18)
    return ()


@prop("gramophone")
def gramophone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a gramophone whose horn opens to -Y."""
    (w, d, _), wood, brass = spec.size, spec.material("body"), spec.material("horn")
    b.box(wood, (0, d * 0.12, 0.09), (w * 0.8, d * 0.72, 0.16), bevel=0.01)
    b.box(wood, (0, d * 0.12, 0.02), (w * 0.88, d * 0.76, 0.04), bevel=0.01)
    profile = [(0.15, 0.175), (0.15, 0.182), (0.045, 0.184)]
    b.lathe(spec.material("record"), profile, origin=(0, d * 0.1, 0), segments=32)
    b.lathe("fabric_red", [(0.045, 0.184), (0.044, 0.186), (0.002, 0.188)], origin=(0, d * 0.1, 0), segments=20)
    neck = np.multiply(
        [(0.06, 0.16, 0.2), (0.14, 0.3, 0.24), (0.12, 0.42, 0.32), (0.04, 0.4, 0.42), (0, 0.22, 0.46)], (1, d, 1)
    )
    b.tube(brass, neck, (0.012, 0.014, 0.018, 0.024, 0.035))
    outline = [
        (0.034, 0), (0.05, 0.1), (0.09, 0.2), (0.16, 0.29), (0.25, 0.34), (0.255, 0.342), (0.245, 0.342), (0.15, 0.28),
        (0.08, 0.19),
    ]  # fmt: skip
    b.lathe(brass, outline, origin=(0, d * 0.24, 0.455), axis=(0, -0.97, 0.14), segments=12, caps=False)
    b.tube("iron", [(w * x, 0.1 * d, z) for x, z in ((0.4, 0.1), (0.46, 0.1), (0.46, 0.04), (0.5, 0.04))], 0.006)
    return ()


@prop("telephone")
def telephone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dial telephone with its receiver on the cradle."""
    (w, d, h), body = spec.size, spec.material("body")
    rings = []
    for z, sx, back, front in (
        (0.0, 0.42, 0.5, -0.5),
        (0.015, 0.42, 0.5, -0.5),
        (h * 0.3, 0.36, 0.46, -0.34),
        (h * 0.62, 0.24, 0.4, 0.02),
    ):
        rings.append([(-sx * w, front * d, z), (sx * w, front * d, z), (sx * w, back * d, z), (-sx * w, back * d, z)])
    b.loft(body, rings)
    with b.at((0, -d * 0.2, h * 0.37), (52, 0, 0)):
        b.lathe(body, [(0.046, -0.01), (0.046, 0.006), (0.04, 0.01)], segments=28)
        b.lathe(spec.material("dial"), [(0.04, 0.01), (0.036, 0.013)], segments=28)
        for k in range(10):
            turn = math.radians(300 - 30 * k)
            outline = [(0.006, 0.0125), (0.006, 0.0145)]
            b.lathe(body, outline, origin=(0.027 * math.cos(turn), 0.027 * math.sin(turn), 0), segments=10)
        b.lathe(body, [(0.013, 0.013), (0.012, 0.016)], segments=14)
    for x in (-1, 1):
        b.box(body, (x * 0.045, d * 0.2, h * 0.68), (0.018, 0.08, 0.03), bevel=0.005)
        profile = [(0.022, -0.012), (0.03, 0), (0.03, 0.016), (0.02, 0.02)]
        b.lathe(body, profile, origin=(x * (w / 2 - 0.03), d * 0.2, h * 0.78), axis=(0, 0, -1), segments=18)
    path = [
        (-w / 2 + 0.03, d * 0.2, h * 0.8),
        (-0.05, d * 0.2, h - 0.014),
        (0.05, d * 0.2, h - 0.014),
        (w / 2 - 0.03, d * 0.2, h * 0.8),
    ]
    b.tube(body, path, 0.014, segments=12)
    cord = [
        (
            -w * 0.44 - 0.012 * math.cos(t * 7),
            d * (0.2 + 0.22 * t / 6),
            0.01 + 0.09 * (1 - t / 6) ** 2 + 0.006 * math.sin(t * 7),
        )
        for t in np.linspace(0, 6, 40)
    ]
    b.tube("plastic_black", cord, 0.0035, segments=5)
    return two_hands((-0.012, d * 0.2, h * 0.96), (0.3, -0.85, -0.4), (0.2, 0, -0.98), (0.8, 0.85, 0.5))


@prop("television")
def television(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a television: an old box on short legs, or a flat one; ``on`` lights it."""
    (w, d, tall), body = spec.size, spec.material("body")
    h = tall * 0.7  # its aerials stand over it
    glass: MaterialRef = "screen" if spec.flag("on") else spec.material("screen")
    if spec.flag("flat"):
        b.box("plastic_black", (0, 0, 0.012), (w * 0.4, d * 0.5, 0.024), bevel=0.006)
        b.box("plastic_black", (0, 0.02, h * 0.12), (0.06, 0.03, h * 0.2))
        b.box("plastic_black", (0, 0, h * 0.54), (w * 1.35, 0.04, h * 0.9), bevel=0.006)
        x, y, low, high = w * 0.65, -0.0215, h * 0.12, h * 0.96
        b.quad(glass, (-x, y, low), (x, y, low), (x, y, high), (-x, y, high), uv=WHOLE)
        return ()
    case = h - 0.1
    b.box(body, (0, 0.02, 0.1 + case / 2), (w, d - 0.04, case), bevel=0.02)
    b.rounded_box("plastic", (-w * 0.1, -d / 2 + 0.02, 0.1 + case / 2), (w * 0.74, 0.03, case * 0.86), 0.014)
    b.cushion(glass, (-w * 0.1, -d / 2 + 0.02, 0.1 + case / 2), (w * 0.66, 0.07, case * 0.74), softness=0.35)
    for z in (0.75, 0.55):
        b.lathe(
            spec.material("knob"),
            [(0.03, 0), (0.028, 0.02), (0.012, 0.024)],
            origin=(w * 0.39, -d / 2 + 0.04, 0.1 + case * z),
            axis=(0, -1, 0),
            segments=18,
        )
    for k in range(6):
        b.box("plastic_black", (w * 0.39, -d / 2 + 0.036, 0.1 + case * (0.14 + 0.045 * k)), (w * 0.14, 0.01, 0.007))
    for x in (-1, 1):
        for y in (-1, 1):
            b.cylinder(
                body, (x * (w * 0.46), y * d * 0.4, 0), (x * w * 0.4, y * d * 0.32, 0.12), 0.01, 0.018, segments=10
            )
        b.cylinder("chrome", (0, d * 0.2, h), (x * 0.2, d * 0.25, tall), 0.003, segments=6)
    return ()


@prop("computer")
def computer(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a monitor with keyboard and mouse; the user is at -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    b.box(body, (0, d * 0.28, 0.012), (0.24, 0.2, 0.024), bevel=0.006)
    b.box(body, (0, d * 0.32, h * 0.2), (0.05, 0.03, h * 0.4))
    b.box(body, (0, d * 0.26, h * 0.6), (w, 0.05, h * 0.8), bevel=0.01)
    x, y = w * 0.46, d * 0.26 - 0.0262
    b.quad(spec.material("screen"), (-x, y, h * 0.26), (x, y, h * 0.26), (x, y, h * 0.96), (-x, y, h * 0.96), uv=WHOLE)
    keyboard(b, body, "porcelain", (-0.03, -d * 0.26, 0.0), 0.42, 0.15)
    b.cushion(body, (w * 0.44, -d * 0.26, 0.016), (0.062, 0.1, 0.034), softness=0.7)
    return ()


def keyboard(
    b: MeshBuilder, case: MaterialRef, cap: MaterialRef, at: tuple[float, float, float], width: float, depth: float
) -> None:
    """Add a keyboard with five rows of keys, the user at -Y.

    Args:
        b: Receives the parts.
        case: Material of the case.
        cap: Material of the keys.
        at: Middle of its underside.
        width: Along X.
        depth: Along Y.
    """
    with b.at(at):
        b.box(case, (0, 0, 0.009), (width, depth, 0.018), bevel=0.004)
        for row in range(5):
            for k in range(14):
                center = ((k - 6.5) * width * 0.067, (row - 2) * depth * 0.17, 0.02)
                b.box(cap, center, (width * 0.056, depth * 0.13, 0.008))


@prop("laptop")
def laptop(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an open laptop; the user is at -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    deep = d * 0.76
    b.box(body, (0, -d / 2 + deep / 2, 0.008), (w, deep, 0.016), bevel=0.004)
    for row in range(5):
        for k in range(13):
            center = ((k - 6) * w * 0.068, -d / 2 + deep * (0.46 + 0.095 * row), 0.0165)
            b.box("plastic_black", center, (w * 0.058, deep * 0.078, 0.002))
    b.box("iron", (0, -d / 2 + deep * 0.2, 0.0165), (w * 0.3, deep * 0.24, 0.001))
    with b.at((0, -d / 2 + deep, 0.016), (-18, 0, 0)):
        tall = (h - 0.016) / math.cos(math.radians(18))
        b.box(body, (0, 0.004, tall / 2), (w, 0.008, tall), bevel=0.003)
        x = w * 0.47
        b.quad(
            spec.material("screen"),
            (-x, -0.0008, 0.012),
            (x, -0.0008, 0.012),
            (x, -0.0008, tall - 0.01),
            (-x, -0.0008, tall - 0.01),
            uv=WHOLE,
        )
    return grips_under(d * 0.3)


@prop("typewriter")
def typewriter(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a typewriter with a sheet of paper; the typist is at -Y."""
    (w, d, h), body, cap = spec.size, spec.material("body"), spec.material("key")
    b.rounded_box(body, (0, 0.0, 0.025), (w, d, 0.05), 0.015)
    b.rounded_box(body, (0, d * 0.2, 0.085), (w, d * 0.52, 0.12), 0.03)
    for row in range(4):
        for k in range(10):
            origin = ((k - 4.5) * w * 0.085 + 0.006 * row, -d * 0.4 + 0.032 * row, 0.056 + 0.012 * row)
            b.lathe(cap, [(0.011, 0), (0.011, 0.004), (0.008, 0.006)], origin=origin, segments=10)
    b.box(cap, (0, -d * 0.46, 0.054), (w * 0.5, 0.014, 0.008), bevel=0.003)
    b.cylinder("rubber", (-w * 0.5, d * 0.22, 0.15), (w * 0.5, d * 0.22, 0.15), 0.019, segments=16)
    for x in (-1, 1):
        b.cylinder(body, (x * w * 0.5, d * 0.22, 0.15), (x * w * 0.56, d * 0.22, 0.15), 0.017, segments=14)
    b.box(spec.material("paper"), (0, d * 0.27, h * 0.82), (0.2, 0.002, h * 0.42), rotation=(-14, 0, 0))
    b.tube("chrome", [(-w * 0.5, d * 0.2, 0.15), (-w * 0.56, d * 0.1, 0.17), (-w * 0.56, d * 0.02, 0.2)], 0.004)
    return ()


@prop("cash_register")
def cash_register(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a mechanical till; the keeper is at -Y."""
    (w, d, h), body, cap, drawer = spec.size, spec.material("body"), spec.material("key"), spec.material("drawer")
    b.box(drawer, (0, 0, h * 0.14), (w, d, h * 0.28), bevel=0.01)
    b.box(body, (0, -d / 2, h * 0.14), (w * 0.9, 0.012, h * 0.2), bevel=0.004)
    side = np.multiply([(-0.48, 0.28), (0.46, 0.28), (0.46, 0.76), (0.16, 0.8), (-0.04, 0.66), (-0.44, 0.42)], (d, h))
    with b.at((-w * 0.46, 0, 0), (90, 0, 90)):
        b.extrude(body, side, w * 0.92)
    for row in range(4):
        for k in range(6):
            end = ((k - 2.5) * w * 0.13, -d * 0.36 + 0.055 * row, h * (0.52 + 0.065 * row))
            b.cylinder(
                cap, ((k - 2.5) * w * 0.13, -d * 0.34 + 0.055 * row, h * (0.46 + 0.065 * row)), end, 0.012, segments=10
            )
    b.box(body, (0, d * 0.2, h * 0.9), (w * 0.7, d * 0.16, h * 0.2), bevel=0.012)
    b.box("lampshade", (0, d * 0.12, h * 0.9), (w * 0.56, 0.01, h * 0.11))
    b.tube("iron", [(w * 0.46, 0.0, h * 0.5), (w * 0.54, 0.0, h * 0.5), (w * 0.54, -d * 0.2, h * 0.62)], 0.008)
    return ()


@prop("sewing_machine")
def sewing_machine(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sewing machine on its board."""
    (w, d, h), body = spec.size, spec.material("body")
    b.box(spec.material("base"), (0, 0, 0.025), (w, d, 0.05), bevel=0.008)
    b.box("steel", (-w * 0.3, 0, 0.052), (w * 0.3, d * 0.6, 0.006), bevel=0.002)
    b.rounded_box(body, (w * 0.28, 0, h * 0.5), (w * 0.18, d * 0.42, h * 0.74), 0.03)
    b.rounded_box(body, (-w * 0.02, 0, h * 0.78), (w * 0.72, d * 0.36, h * 0.2), 0.03)
    b.rounded_box(body, (-w * 0.34, 0, h * 0.64), (w * 0.12, d * 0.36, h * 0.44), 0.025)
    b.cylinder("steel", (-w * 0.34, 0, h * 0.16), (-w * 0.34, 0, h * 0.46), 0.004, segments=8)
    profile = [(0.03, -0.012), (0.062, -0.01), (0.062, 0.01), (0.03, 0.012)]
    b.lathe("steel", profile, origin=(w * 0.42, 0, h * 0.74), axis=(1, 0, 0), segments=26)
    b.cylinder("fabric_red", (0.02, 0, h * 0.88), (0.02, 0, h), 0.016, segments=14)
    return ()


@prop("electric_fan")
def electric_fan(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a caged table fan that blows to -Y."""
    (w, d, h), metal, base = spec.size, spec.material("metal"), spec.material("base")
    z = h - w / 2
    b.lathe(base, [(0.1, 0), (0.095, 0.02), (0.03, 0.04), (0.02, z - 0.05)], segments=22)
    fan_head(b, metal, base, w / 2 - 0.006, d, z)
    return ()


def fan_head(b: MeshBuilder, metal: MaterialRef, base: MaterialRef, r: float, d: float, z: float) -> None:
    """Add the caged blades of a fan and its motor; they blow to -Y.

    Args:
        b: The builder.
        metal: Of the cage.
        base: Of the motor.
        r: Radius of the cage.
        d: Depth from its front to the back of the motor.
        z: Height of its middle.
    """
    b.cushion(base, (0, d * 0.2, z), (0.11, 0.16, 0.11), softness=0.6)
    for y in (-d * 0.3, -d * 0.02):
        for reach in (1.0, 0.7, 0.4):
            loop = [
                (
                    r * reach * math.cos(a),
                    y - 0.02 * (1 - reach) * (1 if y < -0.05 else -1),
                    z + r * reach * math.sin(a),
                )
                for a in np.linspace(0, math.tau, 32, endpoint=False)
            ]
            b.tube(metal, loop, 0.003, segments=5, closed=True)
    for k in range(16):
        turn = math.tau * k / 16
        c, s = math.cos(turn), math.sin(turn)
        path = [
            (0.02 * c, -d * 0.42, z + 0.02 * s),
            (r * c, -d * 0.3, z + r * s),
            (r * c, -d * 0.02, z + r * s),
            (0.03 * c, d * 0.06, z + 0.03 * s),
        ]
        b.tube(metal, path, 0.0022, segments=4)
    for k in range(4):
        with b.at((0, -d * 0.14, z), (0, 90 * k, 0)), b.at(rotation=(0, 0, 30)):
            b.cushion("paint", (0, 0, r * 0.5), (r * 0.5, 0.006, r * 0.75), softness=0.8)
