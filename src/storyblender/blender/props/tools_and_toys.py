"""Prop builders: tools, toys, sports equipment and musical instruments. Hand props point along -Y."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, grips_around, two_hands
from storyblender.blender.props.parts import bent, wheel
from storyblender.blender.props.registry import PropSpec, prop

DARK = "plastic_black"
STAFF = ((0.25, -1.0, 0.0), (1.0, 0.2, 0.0), (0.85, 0.85, 0.6))
"""Finger direction, palm direction and curl of a hand on an upright handle."""


def _upright(height: float, radius: float = 0.02) -> Anchors:
    """Return the grips of a fist around an upright handle of ``radius`` at ``height``."""
    return two_hands((-radius, 0.0, height), *STAFF)


@prop("saw")
def saw(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a hand saw that lies on its side."""
    blade = [(-0.04, -0.25), (0.05, -0.25), (0.07, 0.18), (-0.05, 0.18)]
    b.extrude("steel", blade, 0.003, base=0.008)
    for k in range(26):
        outline = [(-0.041, -0.24 + 0.016 * k), (-0.05, -0.232 + 0.016 * k), (-0.041, -0.224 + 0.016 * k)]
        b.extrude("steel", outline, 0.003, base=0.008)
    ring = bent([(-0.05, 0.18), (-0.055, 0.3), (0.03, 0.33), (0.075, 0.28), (0.07, 0.18)], 4)
    b.tube(spec.material("handle"), np.c_[ring, np.full(len(ring), 0.011)], 0.011, segments=8)
    return two_hands((-0.03, 0.26, 0.012), (0.2, -1, 0), (0, 0, -1), (0.8, 0.8, 0.5))


@prop("screwdriver")
def screwdriver(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a screwdriver on its side."""
    profile = [(0.010, 0.0), (0.015, 0.02), (0.012, 0.06), (0.015, 0.09), (0.006, 0.1)]
    b.lathe(spec.material("handle"), bent(profile), origin=(0, 0.11, 0.015), axis=(0, -1, 0))
    b.cylinder("steel", (0, 0.01, 0.015), (0, -0.11, 0.015), 0.0035, segments=8)
    return two_hands((0.0, 0.06, 0.028), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0), (0.7, 0.75, 0.5))


@prop("drill")
def drill(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an electric drill."""
    body = spec.material("body")
    b.rounded_box(body, (0, 0.0, 0.17), (0.07, 0.2, 0.075), 0.025)
    b.rounded_box(body, (0, 0.06, 0.085), (0.042, 0.055, 0.15), 0.016, rotation=(-10, 0, 0))
    b.rounded_box(DARK, (0, 0.06, 0.018), (0.06, 0.11, 0.036), 0.012)
    b.lathe(DARK, [(0.03, 0), (0.026, 0.03), (0.014, 0.045)], origin=(0, -0.1, 0.17), axis=(0, -1, 0))
    b.cylinder("steel", (0, -0.14, 0.17), (0, -0.24, 0.17), 0.005, segments=8)
    return two_hands((-0.02, 0.06, 0.1), *STAFF)


@prop("fishing_rod")
def fishing_rod(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fishing rod that stands, with its reel and line."""
    h = spec.size[2]
    b.lathe(spec.material("rod"), [(0.014, 0), (0.014, 0.3), (0.007, 0.32), (0.002, h)], segments=8)
    b.lathe("steel", [(0.035, -0.02), (0.035, 0.02)], origin=(0, -0.04, 0.34), axis=(1, 0, 0))
    line = bent([(0, 0, h), (0, -0.1, h * 0.7), (0, -0.14, h * 0.4)])
    b.tube("linen", line, 0.0012, segments=4)
    return _upright(0.2, 0.014)


@prop("oar")
def oar(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an oar that stands on its blade."""
    h = spec.size[2]
    b.cushion(spec.material("wood"), (0, 0, h * 0.15), (0.15, 0.025, h * 0.3), softness=0.5)
    b.cylinder(spec.material("wood"), (0, 0, h * 0.2), (0, 0, h), 0.02, segments=10)
    return _upright(h * 0.62)


@prop("rake")
def rake(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a garden rake that stands on its teeth."""
    h = spec.size[2]
    b.cylinder(spec.material("handle"), (0, 0, 0.05), (0, 0, h), 0.014, segments=8)
    b.box("iron", (0, 0, 0.07), (0.4, 0.02, 0.02))
    for k in range(11):
        b.cylinder("iron", (-0.19 + 0.038 * k, 0, 0.07), (-0.19 + 0.038 * k, -0.03, 0.0), 0.004, segments=5)
    return _upright(h * 0.62, 0.014)


@prop("pitchfork")
def pitchfork(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pitchfork, tines up."""
    h = spec.size[2]
    b.cylinder(spec.material("handle"), (0, 0, 0), (0, 0, h * 0.76), 0.016, segments=8)
    for x in (-0.09, 0.0, 0.09):
        b.tube("iron", bent([(0, 0, h * 0.75), (x, 0, h * 0.8), (x * 1.1, 0, h)]), 0.006, segments=6)
    return _upright(h * 0.45, 0.016)


@prop("crowbar")
def crowbar(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a crowbar that stands, its hook up."""
    h = spec.size[2]
    path = [(0, 0, 0), (0, 0, h * 0.85), (0, -0.03, h), (0, -0.09, h * 0.97), (0, -0.11, h * 0.9)]
    b.tube("iron", bent(path), 0.011, segments=8)
    return _upright(h * 0.3, 0.011)


@prop("watering_can")
def watering_can(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a watering can."""
    metal = spec.material("metal")
    b.lathe(metal, [(0.09, 0), (0.1, 0.02), (0.085, 0.2), (0.07, 0.22)], segments=24)
    b.tube(metal, bent([(0, -0.08, 0.05), (0, -0.2, 0.16), (0, -0.28, 0.26)]), 0.016, segments=10)
    b.lathe(metal, [(0.016, 0), (0.042, 0.04), (0.042, 0.046)], origin=(0, -0.27, 0.245), axis=(0, -0.7, 0.7))
    b.tube(metal, bent([(0, -0.05, 0.22), (0, 0.02, 0.33), (0, 0.14, 0.27), (0, 0.1, 0.08)]), 0.01, segments=8)
    return two_hands((0.0, 0.04, 0.335), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0), (0.8, 0.8, 0.5))


@prop("paintbrush")
def paintbrush(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an artist's brush with paint on it."""
    b.lathe("wood", [(0.002, 0), (0.005, 0.06), (0.0035, 0.16)], origin=(0, 0.11, 0.006), axis=(0, -1, 0), segments=8)
    b.cylinder("steel", (0, -0.05, 0.006), (0, -0.075, 0.006), 0.0045, segments=8)
    profile = [(0.0045, 0), (0.006, 0.015), (0.001, 0.035)]
    b.lathe(spec.material("paint"), profile, origin=(0, -0.075, 0.006), axis=(0, -1, 0), segments=8)
    return two_hands((0.0, 0.0, 0.014), (0.1, -1.0, -0.2), (0.0, 0.0, -1.0), (0.6, 0.65, 0.5))


@prop("palette")
def palette(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a painter's palette with dabs of paint."""
    turn = np.linspace(0, 2 * np.pi, 30)[:-1]
    b.extrude(spec.material("wood"), np.c_[0.19 * np.cos(turn), 0.14 * np.sin(turn) + 0.02 * np.cos(2 * turn)], 0.008)
    for k, skin in enumerate(("fabric_red", "fabric_blue", "leaves", "brass", "linen", "plastic_black", "clay")):
        angle = 0.6 + 0.42 * k
        b.cushion(skin, (0.14 * np.cos(angle), 0.1 * np.sin(angle), 0.012), (0.04, 0.034, 0.014), softness=0.9)
    return two_hands((-0.12, -0.02, -0.006), (0.3, -1, 0), (0, 0, 1), (0.5, 0.5, 0.3))


@prop("skateboard")
def skateboard(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a skateboard."""
    deck = [(0, -0.4, 0.14), (0, -0.3, 0.1), (0, 0.3, 0.1), (0, 0.4, 0.14)]
    rings = [
        np.array([(-w, y, z), (w, y, z), (w, y, z + 0.012), (-w, y, z + 0.012)])
        for (_, y, z), w in zip(deck, (0.06, 0.1, 0.1, 0.06), strict=True)
    ]
    b.loft(spec.material("deck"), rings)
    for y in (-0.25, 0.25):
        b.box("steel", (0, y, 0.075), (0.14, 0.04, 0.03))
        for x in (-0.085, 0.085):
            wheel(b, "rubber", "steel", (x, y, 0.03), 0.03, 0.035)
    return two_hands((-0.1, 0.0, 0.11), (0.2, -1, 0), (1, 0, 0.2), (0.7, 0.7, 0.5))


@prop("surfboard")
def surfboard(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a surfboard that stands on its tail."""
    w, d, h = spec.size
    b.cushion(spec.material("board"), (0, 0, h / 2), (w, d, h), softness=0.8)
    b.box("fabric_red", (0, -d * 0.46, h / 2), (0.05, d * 0.1, h * 0.8))
    return two_hands((-w / 2, 0.0, h * 0.5), (0.25, -1, 0), (1, 0.2, 0), (0.3, 0.3, 0.2))


@prop("kite")
def kite(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a kite with its tail."""
    outline = [(0, 0.5), (0.32, 0.78), (0, 1.2), (-0.32, 0.78)]
    with b.at((0, 0, 0), (90, 0, 0)):
        b.extrude(spec.material("cloth"), outline, 0.006)
    b.cylinder("wood", (0, -0.008, 0.5), (0, -0.008, 1.2), 0.006, segments=6)
    b.cylinder("wood", (-0.32, -0.008, 0.78), (0.32, -0.008, 0.78), 0.006, segments=6)
    tail = bent([(0, 0, 0.5), (0.06, 0, 0.35), (-0.05, 0, 0.2), (0.04, 0, 0.02)])
    b.tube("linen", tail, 0.004, segments=5)
    for k in (3, 6, 9):
        b.cushion("fabric_blue", tail[k], (0.09, 0.01, 0.03), softness=0.6)
    return two_hands((-0.006, 0, 0.62), *STAFF)


@prop("doll")
def doll(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a doll in a dress."""
    profile = [(0.085, 0.06), (0.05, 0.15), (0.032, 0.19), (0.04, 0.23), (0.02, 0.25)]
    b.lathe(spec.material("dress"), bent(profile), segments=20)
    b.sphere("wax", (0, 0, 0.295), 0.05, segments=16, rings=10)
    b.sphere("leather", (0, 0.012, 0.305), 0.052, scale=(1.02, 0.95, 1), segments=16, rings=10)
    for x in (-1, 1):
        b.cylinder("wax", (x * 0.03, 0, 0.07), (x * 0.03, -0.005, 0.0), 0.015, segments=8)
        b.tube("wax", bent([(x * 0.035, 0, 0.23), (x * 0.075, 0, 0.18), (x * 0.09, -0.02, 0.14)]), 0.012, segments=8)
        b.sphere(DARK, (x * 0.018, -0.046, 0.3), 0.005, segments=8, rings=5)
    return grips_around(0.04, 0.2, (0.4, 0.45, 0.3))


@prop("playing_cards")
def playing_cards(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fan of playing cards, or of photographs."""
    for k in range(5):
        with b.at((0, 0.03, 0.001 + 0.0012 * k), (0, 0, 24 - 12 * k)):
            b.box("paper", (0, -0.045, 0), (0.06, 0.09, 0.001))
            b.box("fabric_red" if k % 2 else DARK, (-0.018, -0.075, 0.0008), (0.012, 0.014, 0.0006))
    return two_hands((0, 0.04, -0.008), (0, -1, 0), (0, 0, 1), (0.3, 0.4, -0.2))


@prop("harmonica")
def harmonica(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a mouth organ."""
    b.rounded_box("steel", (0, 0, 0.012), (0.11, 0.026, 0.024), 0.006)
    for k in range(9):
        b.box(DARK, (-0.044 + 0.011 * k, -0.0125, 0.012), (0.006, 0.004, 0.009))
    return two_hands((-0.05, 0.0, 0.012), (0.6, -0.8, 0.0), (1.0, 0.2, 0.0), (0.6, 0.6, 0.4))


@prop("saxophone")
def saxophone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a saxophone that stands."""
    curve = [
        (0, y, z)
        for y, z in ((0.1, 0.62), (0.02, 0.66), (0, 0.56), (0, 0.12), (-0.06, 0.03), (-0.13, 0.1), (-0.17, 0.3))
    ]
    path = bent(curve, 5)
    radii = np.interp(np.linspace(0, 1, len(path)), (0, 0.15, 0.6, 0.85, 1), (0.008, 0.012, 0.032, 0.045, 0.085))
    b.tube("brass", path, tuple(float(r) for r in radii), segments=16)
    for k in range(8):
        b.lathe(
            "gold", [(0.016, 0), (0.016, 0.008)], origin=(0.0, -0.028, 0.16 + 0.045 * k), axis=(0, -1, 0), segments=12
        )
    return two_hands((-0.03, 0.0, 0.32), *STAFF)


@prop("drum_kit")
def drum_kit(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a set of drums with cymbals."""
    shell = spec.material("shell")
    b.lathe(shell, [(0.28, -0.2), (0.28, 0.2)], origin=(0, 0, 0.3), axis=(0, -1, 0), segments=30)
    b.lathe("linen", [(0.27, 0.0), (0.27, 0.01)], origin=(0, -0.2, 0.3), axis=(0, -1, 0), segments=30)
    for x, y, z, r, h in (
        (-0.22, 0.1, 0.62, 0.16, 0.16),
        (0.22, 0.1, 0.62, 0.17, 0.18),
        (-0.5, 0.35, 0.5, 0.18, 0.13),
        (0.52, 0.35, 0.3, 0.22, 0.36),
    ):
        b.lathe(shell, [(r, 0), (r, h)], origin=(x, y, z), segments=26)
        b.lathe("linen", [(r * 0.97, 0), (r * 0.97, 0.006)], origin=(x, y, z + h), segments=26)
        b.cylinder("steel", (x, y, 0), (x, y, z), 0.014, segments=8)
    for x, y, z in ((-0.6, -0.05, 1.1), (0.58, -0.05, 1.15)):
        b.cylinder("steel", (x, y, 0), (x, y, z), 0.012, segments=8)
        b.lathe("brass", [(0.24, 0), (0.05, 0.015), (0.02, 0.03)], origin=(x, y, z), axis=(0.1, 0.2, 1), segments=30)
    return ()


@prop("climbing_rope")
def climbing_rope(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a coiled rope with a harness of straps and its hooks."""
    rope = spec.material("rope")
    for k in range(6):
        turn = np.linspace(0, 2 * np.pi, 26)[:-1]
        loop = np.c_[
            (0.17 + 0.008 * (k % 2)) * np.cos(turn),
            (0.12 + 0.006 * (k % 2)) * np.sin(turn),
            np.full(25, 0.014 + 0.02 * k),
        ]
        b.tube(rope, loop, 0.011, segments=6, closed=True)
    for x in (-0.09, 0.09):
        turn = np.linspace(0, 2 * np.pi, 21)[:-1]
        line = np.c_[x + 0.07 * np.cos(turn), -0.24 + 0.07 * np.sin(turn), np.full(20, 0.02)]
        b.tube("fabric_red", line, 0.013, segments=6, closed=True)
    b.tube("fabric_red", bent([(-0.17, -0.2, 0.03), (0, -0.15, 0.05), (0.17, -0.2, 0.03)]), 0.016, segments=6)
    path = [(0, -0.18, 0.04), (0.03, -0.22, 0.05), (0, -0.27, 0.05), (-0.03, -0.22, 0.05), (0, -0.18, 0.04)]
    b.tube("steel", bent(path), 0.005, segments=6)
    return two_hands((-0.17, 0.0, 0.06), (0.25, -1, 0), (1, 0.2, 0), (0.7, 0.7, 0.5))


@prop("puddle")
def puddle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a spilled liquid: a flat puddle with drops around it."""
    skin, rng = spec.material("liquid"), spec.rng
    turn = np.linspace(0, 2 * np.pi, 40)[:-1]
    reach = 0.4 + 0.06 * np.sin(3 * turn + rng.uniform(0, 6)) + 0.04 * np.sin(5 * turn + rng.uniform(0, 6))
    with b.at(scale=(spec.size[0], spec.size[1], 1.0)):
        b.extrude(skin, np.c_[reach * np.cos(turn), reach * np.sin(turn)], 0.004)
        for k in range(5):
            angle = 2.4 * k + float(rng.uniform(0, 1))
            b.lathe(
                skin, [(0.03, 0), (0.025, 0.004)], origin=(0.47 * np.cos(angle), 0.47 * np.sin(angle), 0), segments=12
            )
    return ()


@prop("shards")
def shards(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build the shards of a broken object."""
    skin, rng = spec.material("piece"), spec.rng
    w, d, h = spec.size
    for k in range(16):
        angle, reach = 2.39996 * k, 0.46 * np.sqrt((k + 0.5) / 16)
        with b.at(
            (w * reach * np.cos(angle), d * reach * np.sin(angle), 0.0),
            (float(rng.uniform(-25, 25)), float(rng.uniform(-25, 25)), float(rng.uniform(0, 360))),
        ):
            size = float(rng.uniform(0.4, 1.0)) * min(w, d) * 0.12
            b.extrude(skin, [(-size, -size * 0.6), (size, -size * 0.3), (size * 0.2, size)], h * 0.12)
    b.cushion(skin, (0, 0, h * 0.4), (w * 0.2, d * 0.2, h * 0.8), softness=0.4, rotation=(20, 15, 0))
    return ()


@prop("flames")
def flames(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build flames without logs, for setting another object on fire."""
    w, d, h = spec.size
    for k in range(11):
        angle, reach = 2.39996 * k, 0.4 * np.sqrt(k / 11)
        tall = h * (1.0 - 0.55 * reach / 0.4)
        foot = np.array((w * reach * np.cos(angle), d * reach * np.sin(angle), 0.0))
        path = bent(
            [foot, foot * 1.05 + np.array((0, 0, tall * 0.4)), foot * 0.6 + np.array((0.03 * np.sin(k), 0, tall))]
        )
        skin = "flame" if k % 3 else "lamp_warm"
        radii = tuple(np.interp(np.linspace(0, 1, len(path)), (0, 0.35, 1), (0.6, 1.0, 0.05)) * 0.11 * w)
        b.tube(skin, path, radii, segments=7)
    return ()
