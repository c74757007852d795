"""Prop builders: what stands between people or before a way: service windows, hatches, rails, gates."""

from __future__ import annotations

import math

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, handle, lean
from storyblender.blender.props.registry import PropSpec, prop

_COUNTER = 1.02
"""Height in metres of a counter that people stand at."""
_SLOT = 0.1
"""Height in metres of the slot between a counter and the pane on it."""


@prop("service_window")
def service_window(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a counter with a pane in a frame and a slot below; of the glass only its glints are drawn."""
    (w, d, h), frame = spec.size, spec.material("frame")
    top = _counter(b, spec, w, d, h)
    low, high = top + _SLOT, h - 0.06
    for x in (-w / 2 + 0.03, w / 2 - 0.03):
        b.box(frame, (x, 0, (top + h) / 2), (0.05, 0.06, h - top), bevel=0.006)
    b.box(frame, (0, 0, h - 0.03), (w, 0.08, 0.06), bevel=0.008)
    b.box(frame, (0, 0, low), (w - 0.06, 0.03, 0.025))
    b.box(frame, (0, 0, top + 0.006), (0.46, 0.34, 0.012), bevel=0.004)
    for middle in (-w * 0.3, w * 0.3):
        for shift, long in ((-0.12, 0.42), (-0.04, 0.56), (0.2, 0.3)):
            spot = (middle + shift * w / 2, 0, (low + high) / 2 + shift * 0.5)
            b.box(spec.material("glass"), spot, (0.014, 0.004, min(long, 0.8 * (high - low))), rotation=(0, 38, 0))
    return (lean((0, -d / 2, top), w * 0.8), lean((0, d / 2, top), w * 0.8, (0.0, -1.0, 0.0), "behind"))


@prop("serving_hatch")
def serving_hatch(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a counter between two posts, under a rolled-up shutter."""
    (w, d, h), frame = spec.size, spec.material("frame")
    top = _counter(b, spec, w, d, h)
    for x in (-w / 2 + 0.06, w / 2 - 0.06):
        b.box(frame, (x, 0, h / 2), (0.12, 0.16, h), bevel=0.01)
    b.box(frame, (0, 0, h - 0.17), (w, 0.2, 0.34), bevel=0.015)
    b.cylinder("sheet_metal", (-w / 2 + 0.14, -0.14, h - 0.3), (w / 2 - 0.14, -0.14, h - 0.3), 0.075, segments=18)
    b.box("sheet_metal", (0, -0.1, h - 0.4), (w - 0.3, 0.02, 0.08))
    return (lean((0, -d / 2, top), w * 0.8), lean((0, d / 2, top), w * 0.8, (0.0, -1.0, 0.0), "behind"))


def _counter(b: MeshBuilder, spec: PropSpec, w: float, d: float, h: float) -> float:
    """Add a panelled counter and return the height of its top; a low one is half as high as the whole."""
    body, top = spec.material("body"), min(_COUNTER, h * 0.5)
    b.box(body, (0, 0.02, (top - 0.05) / 2), (w - 0.08, d - 0.16, top - 0.05))
    panels = max(2, round(w / 0.6))
    for index in range(panels):
        x = (index + 0.5) * (w - 0.12) / panels - (w - 0.12) / 2
        b.box(body, (x, -d / 2 + 0.055, top * 0.5), ((w - 0.12) / panels - 0.08, 0.03, top * 0.72), bevel=0.008)
    b.box(spec.material("top"), (0, 0, top - 0.025), (w, d, 0.05), bevel=0.012)
    return top


@prop("tube_rail")
def tube_rail(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a rail of three tubes on two posts."""
    (w, d, h), metal = spec.size, spec.material("metal")
    _tubes(b, spec, w, h, (0.36, 0.68))
    for x in (-w / 2 + 0.06, w / 2 - 0.06):
        b.cylinder(metal, (x, 0, 0), (x, 0, h), d * 0.42, segments=12)
        b.cylinder(metal, (x, 0, 0), (x, 0, 0.015), d * 0.48, segments=14)
    return (lean((0, -d / 2, h), w * 0.8), lean((0, d / 2, h), w * 0.8, (0.0, -1.0, 0.0), "behind"))


@prop("field_gate")
def field_gate(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a gate of five tubes between two posts, hinged at -X; open, it is turned back to +Y."""
    (w, d, h), metal = spec.size, spec.material("metal")
    for x in (-w / 2 + 0.05, w / 2 - 0.05):
        b.cylinder(metal, (x, 0, 0), (x, 0, h), d * 0.5, segments=14)
    hinge, leaf = -w / 2 + 0.12, w - 0.24
    with b.at((hinge, 0, 0), (0, 0, 78 if spec.flag("open") else 0)), b.at((leaf / 2, 0, 0)):
        _tubes(b, spec, leaf, h - 0.08, (0.18, 0.36, 0.56, 0.78))
        for x in (-leaf / 2 + 0.02, 0.0, leaf / 2 - 0.02):
            b.cylinder(metal, (x, 0, h * 0.16), (x, 0, h - 0.08), 0.018, segments=10)
        b.box(metal, (leaf / 2 - 0.03, -0.03, h * 0.62), (0.1, 0.03, 0.04), bevel=0.005)
    return (lean((0, -d / 2, h), w * 0.7), handle((leaf / 2 - 0.1, -0.05, h * 0.62)))


def _tubes(b: MeshBuilder, spec: PropSpec, w: float, h: float, shares: tuple[float, ...]) -> None:
    """Add tubes along x at shares of a height, and one at the top."""
    for share in (*shares, 1.0):
        z = share * h - 0.022
        b.cylinder(spec.material("metal"), (-w / 2 + 0.02, 0, z), (w / 2 - 0.02, 0, z), 0.022, segments=12)


@prop("nest_box")
def nest_box(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a box of boards with an open front over a low board, a sloping lid and a longer board at its back."""
    (w, d, h), wood, dark = spec.size, spec.material("wood"), spec.material("dark")
    t, deep, wall = 0.03 * w, d * 0.84, h * 0.8
    b.box(wood, (0, d / 2 - t, h * 0.5), (w * 0.5, t, h), bevel=0.004)
    b.box(wood, (0, 0, t), (w * 0.94, deep, 2 * t), bevel=0.003)
    b.box(wood, (0, deep / 2 - t, wall / 2), (w * 0.94, 2 * t, wall))
    b.box(dark, (0, deep / 2 - 2.5 * t, wall / 2), (w * 0.86, t, wall * 0.94))
    for x in (-1, 1):
        b.box(wood, (x * (w * 0.47 - t), 0, wall / 2), (2 * t, deep, wall), bevel=0.003)
        b.box(dark, (x * (w * 0.47 - 2.4 * t), 0, wall / 2), (t * 0.8, deep * 0.9, wall * 0.94))
    b.box(wood, (0, -deep / 2 + t, wall * 0.19), (w * 0.94, 2 * t, wall * 0.38), bevel=0.003)
    b.box(wood, (0, -deep / 2 + t, wall * 0.94), (w * 0.94, 2 * t, wall * 0.12), bevel=0.003)
    slope = math.degrees(math.atan2(h * 0.1, d))
    b.box(wood, (0, -d * 0.02, wall + h * 0.05), (w, d * 0.98, 2 * t), bevel=0.004, rotation=(slope, 0, 0))
    return ()


@prop("milk_churn")
def milk_churn(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a milk churn: a wide body, a shoulder, a neck with its lid, two handles."""
    (w, _, h), metal = spec.size, spec.material("metal")
    r = w * 0.42
    b.lathe(
        metal,
        [
            (0, 0), (r, 0), (r, h * 0.04), (r * 0.97, h * 0.05), (r * 0.97, h * 0.58), (r, h * 0.6),
            (r * 0.62, h * 0.76), (r * 0.6, h * 0.88), (r * 0.72, h * 0.9), (r * 0.72, h * 0.94),
            (r * 0.3, h * 0.97), (r * 0.12, h), (0, h),
        ],
        segments=26,
    )  # fmt: skip
    for side in (-1, 1):
        x = side * r
        b.tube(
            metal,
            [(x * 0.66, 0, h * 0.82), (x * 1.12, 0, h * 0.82), (x * 1.12, 0, h * 0.64), (x * 0.86, 0, h * 0.66)],
            0.012,
        )
    return ()
