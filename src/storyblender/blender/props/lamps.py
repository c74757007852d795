"""Prop builders: lamps, candles and torches. The entry's ``lamp`` says where the light sits."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, two_hands
from storyblender.blender.props.registry import PropSpec, prop


def _shade(b: MeshBuilder, material: MaterialRef, radius: float, top: float, low: float, high: float) -> None:
    """Add an open cone of cloth with some thickness."""
    profile = [(radius, low), (top, high), (top - 0.006, high), (radius - 0.006, low), (radius, low)]
    b.lathe(material, profile, segments=28, caps=False)


def flame(b: MeshBuilder, material: MaterialRef, x: float, y: float, z: float, height: float) -> None:
    """Add a flame.

    Args:
        b: Receives the flame.
        material: Of the flame.
        x: Of its foot.
        y: Of its foot.
        z: Of its foot.
        height: From foot to tip.
    """
    h = height
    profile = [(0.001, 0), (h * 0.2, h * 0.2), (h * 0.22, h * 0.35), (h * 0.12, h * 0.65), (0.001, h)]
    b.lathe(material, profile, origin=(x, y, z), segments=10)


@prop("floor_lamp")
def floor_lamp(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing lamp."""
    (w, _, h), shade, metal = spec.size, spec.material("shade"), spec.material("metal")
    profile = [
        (w * 0.36, 0), (w * 0.35, 0.02), (0.05, 0.05), (0.014, 0.09), (0.014, h * 0.5), (0.024, h * 0.52),
        (0.014, h * 0.54), (0.012, h - 0.3),
    ]  # fmt: skip
    b.lathe(metal, profile, segments=24)
    b.cylinder(metal, (0, 0, h - 0.3), (0, 0, h - 0.02), 0.006)
    b.sphere("lamp_warm", (0, 0, h - 0.18), 0.035)
    _shade(b, shade, w / 2, w * 0.3, h - 0.32, h)
    return ()


@prop("table_lamp")
def table_lamp(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a table lamp with a bellied foot."""
    (w, _, h), shade, metal = spec.size, spec.material("shade"), spec.material("metal")
    profile = [
        (0.07, 0), (0.07, 0.015), (0.03, 0.03), (0.055, h * 0.2), (0.06, h * 0.3), (0.03, h * 0.45), (0.014, h * 0.5),
        (0.01, h * 0.56),
    ]  # fmt: skip
    b.lathe(metal, profile, segments=20)
    b.cylinder(metal, (0, 0, h * 0.5), (0, 0, h - 0.005), 0.005)
    b.sphere("lamp_warm", (0, 0, h * 0.74), 0.03)
    _shade(b, shade, w / 2, w * 0.3, h * 0.56, h)
    return ()


@prop("bankers_lamp")
def bankers_lamp(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a banker's lamp."""
    (w, d, h), shade, metal = spec.size, spec.material("shade"), spec.material("metal")
    b.lathe(metal, [(0.08, 0), (0.08, 0.018), (0.05, 0.03), (0.012, 0.05), (0.01, h - 0.1)], segments=20)
    path = [(w * x, 0, h - z) for x, z in ((-0.36, 0.06), (-0.3, 0.12), (0, 0.13), (0.3, 0.12), (0.36, 0.06))]
    b.tube(metal, path, 0.007)
    arch = np.linspace(math.radians(15), math.radians(165), 13)
    for inner, flip in ((1.0, 1), (0.94, -1)):
        rows = [
            np.c_[np.full(13, x), inner * d / 2 * np.cos(arch), h - 0.12 + inner * 0.12 * np.sin(arch)]
            for x in np.array([-w / 2, w / 2]) * flip
        ]
        b.loft(shade, rows, closed=False)
    b.cylinder("lamp_warm", (-w * 0.3, 0, h - 0.08), (w * 0.3, 0, h - 0.08), 0.018)
    return ()


@prop("pendant_lamp")
def pendant_lamp(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an enamelled shade with a bulb on a cord."""
    (w, _, h), shade, metal = spec.size, spec.material("shade"), spec.material("metal")
    r = w / 2
    profile = [
        (r, 0.0), (r * 0.98, 0.03), (r * 0.55, 0.1), (0.05, 0.16), (0.03, 0.2), (0.03, 0.2), (0.045, 0.15),
        (r * 0.5, 0.09), (r * 0.95, 0.02), (r, 0),
    ]  # fmt: skip
    b.lathe(shade, profile, segments=32, caps=False)
    b.sphere(spec.material("bulb"), (0, 0, 0.05), 0.045)
    b.cylinder(metal, (0, 0, 0.17), (0, 0, 0.26), 0.022)
    b.cylinder(metal, (0, 0, 0.2), (0, 0, h), 0.006, segments=6)
    b.lathe(metal, [(0.05, h - 0.03), (0.045, h - 0.01), (0.05, h)], segments=16)
    return ()


@prop("chandelier")
def chandelier(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a chandelier of eight arms with drops."""
    (w, _, h), metal, bulb, crystal = spec.size, spec.material("metal"), spec.material("bulb"), spec.material("crystal")
    r = w / 2 - 0.03
    b.lathe(
        metal,
        [(0.01, 0.08), (0.05, 0.14), (0.08, 0.2), (0.03, 0.3), (0.06, 0.42), (0.03, 0.55), (0.012, 0.62), (0.01, h)],
        segments=18,
    )
    b.lathe(metal, [(0.03, h - 0.06), (0.07, h - 0.02), (0.07, h)], segments=18)
    b.sphere(crystal, (0, 0, 0.05), 0.045)
    for k in range(8):
        with b.at(rotation=(0, 0, 45 * k)):
            b.tube(metal, [(0.05, 0, 0.24), (r * 0.4, 0, 0.14), (r * 0.8, 0, 0.16), (r, 0, 0.27)], 0.011)
            b.lathe(metal, [(0.015, 0.26), (0.05, 0.29), (0.052, 0.3)], origin=(r, 0, 0), segments=12)
            b.cylinder("wax", (r, 0, 0.29), (r, 0, 0.39), 0.015, segments=10)
            flame(b, bulb, r, 0, 0.38, 0.08)
            for at, z in ((r, 0.2), (r * 0.7, 0.09), (r * 0.35, 0.09)):
                b.lathe(crystal, [(0.002, -0.07), (0.016, -0.045), (0.002, 0)], origin=(at, 0, z), segments=6)
            b.tube(crystal, [(0.03, 0, 0.55), (r * 0.4, 0, 0.36), (r * 0.75, 0, 0.28), (r, 0, 0.3)], 0.006, segments=5)
    return ()


@prop("fluorescent_light")
def fluorescent_light(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tray with two tubes."""
    (w, d, h), body, bulb = spec.size, spec.material("body"), spec.material("bulb")
    b.box(body, (0, 0, 0.06), (w, d, 0.03), bevel=0.006, taper=0.7)
    for y in (-0.045, 0.045):
        b.cylinder(bulb, (-w / 2 + 0.04, y, 0.02), (w / 2 - 0.04, y, 0.02), 0.016)
        for x in (-1, 1):
            b.box(body, (x * (w / 2 - 0.03), y, 0.03), (0.03, 0.04, 0.06), bevel=0.004)
    for x in (-0.3, 0.3):
        b.cylinder(body, (x * w, 0, 0.07), (x * w, 0, h), 0.01)
    return ()


@prop("wall_lamp")
def wall_lamp(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wall lamp on a bracket."""
    (w, d, h), shade, metal = spec.size, spec.material("shade"), spec.material("metal")
    profile = [(0.05, 0), (0.045, 0.015), (0.015, 0.025)]
    b.lathe(metal, profile, origin=(0, d / 2, h * 0.34), axis=(0, -1, 0), segments=16)
    b.tube(metal, [(0, d / 2 - 0.02, h * 0.34), (0, 0.04, h * 0.12), (0, -0.03, h * 0.2), (0, -0.03, h * 0.5)], 0.009)
    with b.at((0, -d / 2 + w / 2, 0)):
        _shade(b, shade, w / 2, w * 0.3, h * 0.5, h)
        b.sphere("lamp_warm", (0, 0, h * 0.65), 0.03)
    b.lathe(metal, [(0.001, -0.03), (0.014, -0.015), (0.006, 0.01)], origin=(0, 0.03, h * 0.12), segments=10)
    return ()


@prop("lantern")
def lantern(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a storm lantern, carried by its bail."""
    (w, _, h), metal = spec.size, spec.material("metal")
    r = w / 2
    b.lathe(metal, [(r, 0), (r, 0.03), (r * 0.7, 0.06), (r * 0.5, 0.075)], segments=20)
    profile = [(r * 0.46, 0.075), (r * 0.68, 0.13), (r * 0.62, 0.18), (r * 0.44, 0.22)]
    b.lathe(spec.material("glass"), profile, segments=18)
    b.lathe(metal, [(r * 0.5, 0.21), (r * 0.6, 0.23), (r * 0.4, 0.25), (r * 0.4, 0.28), (r * 0.2, 0.29)], segments=18)
    for x in (-1, 1):
        b.tube(metal, [(x * r * s, 0, z) for s, z in ((0.9, 0.03), (1, 0.12), (0.85, 0.23), (0.4, 0.26))], 0.008)
    bail = [(r * 0.95 * math.cos(a), 0, 0.24 + (h - 0.25) * math.sin(a)) for a in np.linspace(0, math.pi, 13)]
    b.tube(metal, bail, 0.004, segments=6)
    flame(b, spec.material("flame"), 0, 0, 0.085, 0.08)
    return two_hands((0, 0, h + 0.005), (0, -0.3, -0.95), (0.0, -0.95, 0.3), (0.9, 0.9, 0.5))


@prop("candelabra")
def candelabra(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a three-armed candlestick."""
    (w, _, h), metal, wax = spec.size, spec.material("metal"), spec.material("wax")
    profile = [(0.065, 0), (0.06, 0.015), (0.02, 0.035), (0.012, 0.1), (0.02, 0.13), (0.011, 0.16), (0.012, h * 0.55)]
    b.lathe(metal, profile, segments=18)
    for k, x in enumerate((-w / 2 + 0.03, 0.0, w / 2 - 0.03)):
        cup = h * (0.6 if k == 1 else 0.54)
        if x:
            b.tube(metal, [(0, 0, h * 0.42), (x * 0.5, 0, h * 0.36), (x, 0, h * 0.42), (x, 0, cup)], 0.008)
        b.lathe(metal, [(0.01, -0.01), (0.028, 0.008), (0.03, 0.014)], origin=(x, 0, cup), segments=14)
        b.cylinder(wax, (x, 0, cup), (x, 0, cup + h * 0.26), 0.011, segments=10)
        flame(b, spec.material("flame"), x, 0, cup + h * 0.26, 0.055)
    return two_hands((-0.02, 0.005, h * 0.22), (0.2, -1, 0), (1, 0.15, 0), (0.75, 0.8, 0.5))


@prop("torch")
def torch(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a burning torch."""
    h, wood = spec.size[2], spec.material("wood")
    b.cylinder(wood, (0, 0, 0), (0, 0, h * 0.68), 0.014, 0.022, segments=10)
    profile = [(0.026, h * 0.6), (0.045, h * 0.66), (0.05, h * 0.74), (0.03, h * 0.79)]
    b.lathe(spec.material("wrap"), profile, segments=12)
    flame(b, spec.material("flame"), 0, 0, h * 0.7, h * 0.3)
    for k in range(3):
        turn = 2.1 * k
        flame(b, spec.material("flame"), 0.028 * math.cos(turn), 0.028 * math.sin(turn), h * 0.7, h * 0.2)
    return two_hands((-0.028, 0.006, h * 0.25), (0.2, -1, 0), (1, 0.15, 0), (0.85, 0.85, 0.5))
