"""Prop builders: ordinary things of workshops and outdoors: gas bottles, drawers, washing, bunting, smoke, clouds."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, handle
from storyblender.blender.props.registry import PropSpec, prop


@prop("lever")
def lever(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a stick with a knob that leans out of a slotted base."""
    w, d, h = spec.size
    b.rounded_box(spec.material("base"), (0, 0, h * 0.09), (w, d, h * 0.18), 0.02)
    b.box("plastic_black", (0, 0, h * 0.182), (w * 0.18, d * 0.7, 0.004))
    b.tube("steel", [(0, 0, h * 0.16), (0, -d * 0.14, h * 0.55), (0, -d * 0.28, h * 0.86)], 0.014)
    b.sphere(spec.material("knob"), (0, -d * 0.3, h * 0.91), h * 0.09)
    return (handle((0, -d * 0.3, h * 0.9)),)


@prop("drawer")
def drawer(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an open drawer, its front with a knob to -Y."""
    (w, d, h), wood, side = spec.size, spec.material("wood"), 0.016
    b.box(wood, (0, 0, side / 2), (w - 0.02, d - 0.02, side))
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.018), 0, h * 0.42), (side, d - 0.02, h * 0.84))
    b.box(wood, (0, d / 2 - side, h * 0.42), (w - 0.03, side, h * 0.84))
    b.box(wood, (0, -d / 2 + 0.02, h / 2), (w, 0.024, h), bevel=0.005)
    b.sphere(spec.material("metal"), (0, -d / 2, h * 0.52), 0.018)
    return (handle((0, -d / 2, h * 0.52)),)


@prop("clothesline")
def clothesline(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sagging line between two posts with washing on it."""
    (w, d, h), post = spec.size, spec.material("post")
    for x in (-1, 1):
        b.cylinder(post, (x * (w / 2 - 0.05), 0, 0), (x * (w / 2 - 0.05), 0, h), 0.04, 0.035)
        b.box(post, (x * (w / 2 - 0.05), 0, h - 0.06), (0.06, d, 0.05))
    xs = np.linspace(-w / 2 + 0.05, w / 2 - 0.05, 25)
    sag = h - 0.06 - 0.14 * (1 - (2 * xs / w) ** 2)
    b.tube("linen", np.c_[xs, np.zeros(25), sag], 0.006, segments=5)
    cloths = [spec.material(role) for role in ("cloth", "other", "third", "cloth", "other")]
    for k, (cloth, wide, tall) in enumerate(
        zip(cloths, (0.52, 0.4, 0.34, 0.6, 0.36), (0.8, 0.6, 0.9, 0.7, 0.62), strict=True)
    ):
        _hung(b, cloth, (-0.38 + 0.19 * k) * w, h - 0.17, wide, tall, float(spec.rng.uniform(0, 6)))
    return ()


def _hung(b: MeshBuilder, cloth: MaterialRef, x: float, top: float, wide: float, tall: float, phase: float) -> None:
    """Add a cloth that hangs in soft folds."""
    across = np.linspace(-wide / 2, wide / 2, 15)
    rings = [
        np.c_[x + across, 0.035 * (0.3 + z) * np.sin(14 * across / wide + phase), np.full(15, top - z * tall)]
        for z in np.linspace(0, 1, 6)
    ]
    for side in (1, -1):
        b.loft(cloth, [np.add(ring[::side], (0, 0.003 * side, 0)) for ring in rings], closed=False)


@prop("bunting")
def bunting(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a hanging string of three-cornered flags."""
    w, _, h = spec.size
    colors = [spec.material(role) for role in ("flag", "other", "third")]
    xs = np.linspace(-w / 2, w / 2, 40)
    line = h - 0.02 - 0.55 * h * (1 - (2 * xs / w) ** 2)
    b.tube("linen", np.c_[xs, np.zeros(40), line], 0.006, segments=5)
    for k in range(13):
        x = (-0.46 + 0.92 * k / 12) * w
        z = float(np.interp(x, xs, line))
        corners = [(x - 0.09, 0, z), (x, 0, z - 0.24), (x + 0.09, 0, z)]
        for order in (corners, corners[::-1]):
            b.polygon(colors[k % 3], order)
    return ()


def _puffs(b: MeshBuilder, puff: MaterialRef, places: list[tuple[float, float, float, float]]) -> None:
    """Add round billows: x, y, z and radius of each."""
    for x, y, z, r in places:
        b.sphere(puff, (x, y, z), r, scale=(1.0, 0.9, 0.85), segments=18, rings=11)


@prop("smoke")
def smoke(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build billows that rise and spread."""
    (w, d, h), rng = spec.size, spec.rng
    places: list[tuple[float, float, float, float]] = []
    for k in range(22):
        up = (k + 0.5) / 22
        spread, r = (0.1 + 0.26 * up), (0.13 + 0.1 * up) * w
        angle = 2.4 * k + float(rng.uniform(-0.3, 0.3))
        reach = spread * float(rng.uniform(0.3, 0.9))
        places.append((reach * w * math.cos(angle), reach * d * math.sin(angle), max(r, up * (h - r)), r))
    _puffs(b, spec.material("puff"), places)
    return ()


@prop("cloud")
def cloud(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a heaped cloud, flatter below."""
    (w, d, h), rng = spec.size, spec.rng
    places: list[tuple[float, float, float, float]] = []
    for k in range(26):
        angle, reach = 2.4 * k, math.sqrt((k + 0.5) / 26)
        r = (0.17 - 0.08 * reach) * w * float(rng.uniform(0.85, 1.1))
        z = h * (0.3 + 0.32 * (1 - reach)) + float(rng.uniform(-0.05, 0.05)) * h
        places.append((0.42 * w * reach * math.cos(angle), 0.38 * d * reach * math.sin(angle), max(z, 0.86 * r), r))
    _puffs(b, spec.material("puff"), places)
    return ()


@prop("lighthouse")
def lighthouse(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tapering tower with bands, a gallery, a lit lamp room and a dome."""
    (w, _, h), r, wall, band, metal = (
        spec.size,
        spec.size[0] / 2,
        *(spec.material(m) for m in ("wall", "band", "metal")),
    )
    for k in range(5):
        low, high = k / 5, (k + 1) / 5
        b.cylinder(band if k % 2 else wall, (0, 0, low * h * 0.8), (0, 0, high * h * 0.8), r * (1 - 0.42 * low),
                   r * (1 - 0.42 * high), segments=36, caps=False)  # fmt: skip
    b.cylinder(metal, (0, 0, h * 0.8), (0, 0, h * 0.815), r * 0.8, segments=36)
    for k in range(18):
        angle = math.tau * k / 18
        x, y = r * 0.77 * math.cos(angle), r * 0.77 * math.sin(angle)
        b.cylinder(metal, (x, y, h * 0.815), (x, y, h * 0.86), 0.03, segments=5)
    ring = np.linspace(0, math.tau, 36, endpoint=False)
    b.tube(metal, np.c_[r * 0.77 * np.cos(ring), r * 0.77 * np.sin(ring), np.full(36, h * 0.86)], 0.035, closed=True)
    b.cylinder(spec.material("lamp"), (0, 0, h * 0.815), (0, 0, h * 0.92), r * 0.4, segments=24)
    for k in range(8):
        angle = math.tau * k / 8
        x, y = r * 0.43 * math.cos(angle), r * 0.43 * math.sin(angle)
        b.cylinder(metal, (x, y, h * 0.815), (x, y, h * 0.92), 0.05, segments=6)
    b.lathe(band, [(r * 0.5, h * 0.92), (r * 0.4, h * 0.955), (r * 0.2, h * 0.98), (0, h)], segments=28)
    b.box("wood_dark", (0, -r * 0.97, h * 0.075), (w * 0.22, 0.14, h * 0.15))
    for z in (0.32, 0.55):
        b.box("glass_dark", (0, -r * (1 - 0.52 * z) + 0.02, h * z), (w * 0.1, 0.1, h * 0.05))
    return ()


@prop("platform")
def platform(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a low stage with a step before it."""
    (w, d, h), top, side = spec.size, spec.material("top"), spec.material("side")
    b.box(side, (0, 0.15, (h - 0.03) / 2), (w - 0.04, d - 0.34, h - 0.03))
    b.box(top, (0, 0.15, h - 0.015), (w, d - 0.3, 0.03))
    b.box(side, (0, -d / 2 + 0.15, h / 4), (w * 0.3, 0.3, h / 2))
    return ()


@prop("hole")
def hole(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dark hole within a rim of heaped earth."""
    (w, d, h), rng = spec.size, spec.rng
    turn = np.linspace(0, math.tau, 48, endpoint=False)
    wobble = 1 + 0.04 * np.sin(3 * turn + float(rng.uniform(0, 6))) + 0.03 * np.sin(7 * turn)
    rise = 0.75 + 0.25 * np.sin(5 * turn + float(rng.uniform(0, 6)))
    rings = [
        np.c_[k * wobble * np.cos(turn) * w / 2, k * wobble * np.sin(turn) * d / 2, z * h * rise]
        for k, z in ((0.93, 0.0), (0.88, 0.5), (0.8, 0.9), (0.72, 0.7), (0.66, 0.03))
    ]
    b.loft(spec.material("rim"), rings, caps=False)
    b.extrude(
        spec.material("dark"), np.c_[0.7 * wobble * np.cos(turn) * w / 2, 0.7 * wobble * np.sin(turn) * d / 2], 0.012
    )
    return ()
