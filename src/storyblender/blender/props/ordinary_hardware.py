"""Prop builders: hardware: bulb, battery, screws, tape, cutters, lock picks, padlock, keys, thread, hose, tire."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import Floats, MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, grips_pinching, grips_under, two_hands
from storyblender.blender.props.parts import bent, circle
from storyblender.blender.props.registry import PropSpec, prop


def ring_of(radius: float, count: int = 20, height: float = 0.0) -> Floats:
    """Return (count, 3) points of a flat circle about the z axis, for a closed tube.

    Args:
        radius: Metres.
        count: How many points.
        height: z of all of them, metres.
    """
    return np.c_[circle(radius, count), np.full(count, height)]


def _thread(b: MeshBuilder, metal: MaterialRef, low: float, high: float, radius: float, turns: int) -> None:
    """Add the thread of a screw about the z axis."""
    t = np.linspace(0, 1, turns * 8 + 1)
    turn = math.tau * turns * t
    b.tube(metal, np.c_[radius * np.cos(turn), radius * np.sin(turn), low + (high - low) * t], radius * 0.2, segments=4)


@prop("light_bulb")
def light_bulb(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a light bulb that stands on its screw cap."""
    r, h, cap = spec.size[0] / 2, spec.size[2], spec.material("cap")
    b.lathe("plastic_black", [(0.2 * r, 0), (0.3 * r, 0.04 * h)], segments=14)
    ribs = [((0.42 + 0.05 * (k % 2)) * r, (0.04 + 0.028 * k) * h) for k in range(10)]
    b.lathe(cap, [(0.3 * r, 0.04 * h), *ribs], segments=20)
    outline = [
        (0.42, 0.29), (0.5, 0.38), (0.84, 0.54), (1.0, 0.7), (0.92, 0.84), (0.68, 0.94), (0.36, 0.99), (0.0, 1.0),
    ]  # fmt: skip
    b.lathe(spec.material("glass"), bent([(x * r, z * h) for x, z in outline], 3), segments=24)
    return grips_around(0.45 * r, 0.2 * h, (0.7, 0.8, 0.6))


@prop("battery")
def battery(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dry cell with a copper end and its pole on top."""
    r, h = spec.size[0] / 2, spec.size[2]
    b.lathe(spec.material("body"), [(0.9 * r, 0), (r, 0.02 * h), (r, 0.7 * h)], segments=24)
    top = [(r, 0.7 * h), (r, 0.93 * h), (0.9 * r, 0.95 * h), (0.3 * r, 0.95 * h)]
    b.lathe(spec.material("top"), top, segments=24)
    b.cylinder(spec.material("pole"), (0, 0, 0.94 * h), (0, 0, h), 0.3 * r)
    return grips_around(r, 0.5 * h, (0.7, 0.8, 0.6))


@prop("screw")
def screw(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wood screw, point down, with a slot in its head."""
    r, h, metal = spec.size[0] / 2, spec.size[2], spec.material("metal")
    b.lathe(metal, [(0.02 * r, 0), (0.38 * r, 0.2 * h), (0.42 * r, 0.86 * h), (r, 0.96 * h), (r, h)], segments=16)
    _thread(b, metal, 0.2 * h, 0.72 * h, 0.46 * r, 8)
    b.box("plastic_black", (0, 0, h - 0.0003), (1.8 * r, 0.3 * r, 0.001))
    return grips_pinching(0.0, h - 0.01)


@prop("bolt")
def bolt(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bolt that stands on its six-sided head, a nut halfway up."""
    r, h, metal = spec.size[0] / 2, spec.size[2], spec.material("metal")
    b.extrude(metal, circle(r, 6), 0.2 * h)
    b.cylinder(metal, (0, 0, 0.2 * h), (0, 0, h), 0.46 * r)
    _thread(b, metal, 0.5 * h, 0.98 * h, 0.5 * r, 7)
    b.extrude(metal, circle(r, 6), 0.2 * h, base=0.56 * h)
    return grips_pinching(0.0, h - 0.015)


@prop("nail")
def nail(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a nail that lies with its head at +Y."""
    (w, d, h), metal = spec.size, spec.material("metal")
    b.cylinder(metal, (0, d / 2, h / 2), (0, d / 2 - 0.003, h / 2), w / 2)
    shaft = [(0.22 * w, 0), (0.22 * w, 0.85 * d), (0.01 * w, 0.96 * d)]
    b.lathe(metal, shaft, origin=(0, d / 2 - 0.002, h / 2), axis=(0, -1, 0), segments=8)
    return grips_pinching(0.2 * d, h / 2 - 0.01)


@prop("tape_roll")
def tape_roll(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a roll of tape that lies flat, its loose end out."""
    r, h, tape = spec.size[0] / 2, spec.size[2], spec.material("tape")
    b.lathe(tape, [(0.72 * r, 0), (r, 0), (r, h), (0.72 * r, h)], segments=36, caps=False)
    b.lathe("cardboard", [(0.72 * r, h), (0.66 * r, h), (0.66 * r, 0), (0.72 * r, 0)], segments=36, caps=False)
    b.box(tape, (0.2 * r, -r + 0.0012, h / 2), (0.7 * r, 0.0012, 0.98 * h), rotation=(0, 0, -6))
    return two_hands((-r, 0.01, h * 0.5), (0.25, -1, 0), (1, 0.2, 0), (0.5, 0.55, 0.4))


@prop("bolt_cutters")
def bolt_cutters(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build bolt cutters that lie flat, their jaws a little open at -Y."""
    (w, d, h), handle, jaw = spec.size, spec.material("handle"), spec.material("jaw")
    z = h / 2
    for x in (-1, 1):
        arm = [(0.06 * x * w, -0.28 * d, z), (0.3 * x * w, -0.1 * d, z), (0.42 * x * w, 0.2 * d, z)]
        b.tube(jaw, bent(arm), 0.011, segments=8)
        b.tube(handle, [(0.4 * x * w, 0.14 * d, z), (0.42 * x * w, 0.49 * d, z)], [0.015, 0.017], segments=10)
        blade = [(0.02, -0.24), (0.2, -0.26), (0.24, -0.36), (0.1, -0.5), (0.02, -0.49), (0.09, -0.4), (0.01, -0.35)]
        b.extrude(jaw, [(x * across * w, along * d) for across, along in blade], 0.7 * h, base=0.15 * h)
        b.cylinder("chrome", (0.1 * x * w, -0.27 * d, 0), (0.1 * x * w, -0.27 * d, h), 0.009)
    return two_hands((-0.46 * w, 0.32 * d, z), (0.2, -0.9, 0.3), (1, 0, 0), FIST)


@prop("lock_picks")
def lock_picks(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build five picks and a tension wrench in an open leather roll."""
    (w, d, h), pick, roll = spec.size, spec.material("pick"), spec.material("roll")
    b.rounded_box(roll, (0, 0, 0.1 * h), (w, 0.92 * d, 0.2 * h), 0.001)
    b.rounded_box(roll, (0, 0.24 * d, 0.4 * h), (w, 0.42 * d, 0.4 * h), 0.002)
    for k in range(6):
        x = (k - 2.5) * w * 0.155
        tip = 0.05 * w * math.sin(2.0 * k + 1)
        path = [(x, 0.1 * d, 0.5 * h), (x, -0.3 * d, 0.5 * h), (x + 0.2 * tip, -0.4 * d, 0.5 * h)]
        b.box(pick, (x, -0.06 * d, 0.5 * h), (0.05 * w, 0.26 * d, 0.3 * h))
        b.tube(pick, [*path, (x + tip, -0.49 * d, 0.5 * h)], 0.0016, segments=6)
    return grips_under(d * 0.4)


@prop("padlock")
def padlock(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a shut padlock that stands, its keyhole to -Y."""
    w, d, h = spec.size
    b.rounded_box(spec.material("body"), (0, 0, 0.29 * h), (w, d, 0.58 * h), 0.005)
    t = np.linspace(0, math.pi, 11)
    r = 0.34 * w
    arch = np.c_[r * np.cos(t), np.zeros(11), 0.96 * h - r + r * np.sin(t) - 0.004]
    ends = [(r, 0, 0.5 * h)], [(-r, 0, 0.5 * h)]
    b.tube(spec.material("bow"), np.concatenate([ends[0], arch, ends[1]]), 0.0042, segments=10)
    for z, tall in ((0.32, 0.006), (0.24, 0.012)):
        b.box("plastic_black", (0, -d / 2, z * h), (0.006 if z > 0.3 else 0.003, 0.001, tall))
    return grips_around(0.5 * w, 0.3 * h, (0.6, 0.65, 0.5))


@prop("key_ring")
def key_ring(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build four keys fanned out towards -Y from a ring."""
    (_, d, h), metal = spec.size, spec.material("metal")
    r = 0.21 * d
    with b.at((0, d / 2 - r, 0.5 * h)):
        b.tube("steel", ring_of(r - 0.002, 28), 0.0018, segments=6, closed=True)
        for k, turn in enumerate((-38, -13, 12, 36)):
            long = (0.62 + 0.1 * (k % 2)) * d
            with b.at((0, 0, (k - 1.5) * 0.15 * h), (0, 0, turn)):
                b.lathe(metal, [(0.014, 0), (0.014, 0.002)], origin=(0, -r - 0.006, -0.001), segments=18)
                b.box(metal, (0, -r - 0.3 * long, 0), (0.006, 0.55 * long, 0.0022))
                for tooth in range(3):
                    b.box(metal, (0.004, -r - (0.38 + 0.08 * tooth) * long, 0), (0.005, 0.004, 0.0022))
    return grips_pinching(d / 2 - 0.02, 0.0)


@prop("thread_spool")
def thread_spool(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wooden spool full of thread."""
    r, h, wood = spec.size[0] / 2, spec.size[2], spec.material("wood")
    for z in (0.0, 0.88):
        b.lathe(wood, [(0.94 * r, z * h), (r, (z + 0.03) * h), (r, (z + 0.09) * h), (0.94 * r, (z + 0.12) * h)])
    wound = [((0.82 + 0.04 * (k % 2)) * r, (0.12 + 0.045 * k) * h) for k in range(18)]
    b.lathe(spec.material("thread"), wound, segments=20)
    b.cylinder("plastic_black", (0, 0, h - 0.001), (0, 0, h + 0.0004), 0.22 * r)
    return grips_around(r, 0.5 * h, (0.6, 0.7, 0.5))


@prop("needle_and_thread")
def needle_and_thread(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a needle that lies with its point to -Y, the thread curled behind it."""
    w, d, h = spec.size
    needle = [(0.0006, 0), (0.0012, 0.1 * d), (0.0012, 0.6 * d), (0.0001, 0.66 * d)]
    b.lathe(spec.material("metal"), needle, origin=(0, 0.16 * d, h / 2), axis=(0, -1, 0), segments=8)
    path = [(0, 0.14, 0), (0.1, 0.3, 0.1), (0.45, 0.36, 0), (0.3, 0.48, -0.1), (-0.3, 0.46, 0.1), (-0.48, 0.2, 0)]
    curl = np.array([(x * w, y * d, h * (0.5 + 0.3 * z)) for x, y, z in path])
    b.tube(spec.material("thread"), bent(curl, 6), 0.0008, segments=6)
    return grips_pinching(-0.1 * d, 0.0)


@prop("poker")
def poker(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fire iron, point down, with a hook beside the point and a ring on top."""
    (w, _, h), metal = spec.size, spec.material("metal")
    b.lathe(metal, [(0.001, 0), (0.006, 0.06 * h), (0.006, 0.78 * h), (0.012, 0.79 * h), (0.01, 0.93 * h)])
    b.tube(metal, bent([(0, 0, 0.12 * h), (0.8 * w, 0, 0.1 * h), (0.8 * w, 0, 0.04 * h)]), 0.004)
    with b.at((0, 0, h - 0.018), (90, 0, 0)):
        b.tube(metal, ring_of(0.015), 0.003, closed=True)
    return two_hands((-0.012, 0.006, 0.86 * h), (0.2, -1, 0), (1, 0.15, 0), FIST)


@prop("hose")
def hose(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a coiled hose with a brass nozzle out to -Y."""
    (w, d, h), rubber = spec.size, spec.material("hose")
    t = np.linspace(0, 6, 6 * 26)
    reach = (w / 2 - 0.015) * (1 - 0.1 * np.sin(t * 2.3) ** 2)
    z = 0.014 + (h - 0.03) * t / 6
    coil = np.c_[reach * np.sin(math.tau * t), (d - w) / 2 + reach * np.cos(math.tau * t), z]
    out = [coil[0] * (0.6, 1, 1), (-0.35 * w, 0.1 * d, 0.014), (-0.3 * w, -0.35 * d, 0.014), (0, -0.4 * d, 0.016)]
    b.tube(rubber, coil, 0.013, segments=7)
    b.tube(rubber, bent(out), 0.013, segments=7)
    nozzle = [(0.016, 0), (0.016, 0.03), (0.009, 0.07), (0.013, 0.08)]
    b.lathe("brass", nozzle, origin=(0, -0.4 * d, 0.017), axis=(0.6, -0.8, 0))
    return two_hands((-w / 2, (d - w) / 2, 0.5 * h), (0.3, -0.3, -0.9), (1, 0, 0), FIST)


@prop("tire")
def tire(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tire that lies flat; stacked, four of them lie on each other, a little askew."""
    r, h, rubber = spec.size[0] / 2, spec.size[2], spec.material("rubber")
    side = [(0.58, 0.24), (0.6, 0.1), (0.76, 0), (0.92, 0.06), (0.985, 0.16)]
    tread = [(0.985 if k % 2 else 0.955, 0.16 + 0.68 * k / 9) for k in range(1, 9)]
    around_it = [*side, *tread, *((x, 1 - z) for x, z in side[::-1])]
    outline = [(x * r, z * h) for x, z in [*around_it, (0.62, 0.7), (0.8, 0.5), (0.62, 0.3), (0.58, 0.24)]]
    for k in range(4 if spec.flag("stacked") else 1):
        slip = 0.05 * r * k
        with b.at((slip * math.cos(2.4 * k), slip * math.sin(2.4 * k), k * h)):
            b.lathe(rubber, outline, segments=40, caps=False)
    return grips_under(0.9 * r) + two_hands((-r, 0.0, 0.5 * h), (0.1, -0.9, -0.3), (1, 0, 0), (0.4, 0.45, 0.3), "side")


@prop("gas_cylinder")
def gas_cylinder(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a steel cylinder with a round shoulder, a valve and its collar."""
    r, h, body, valve = spec.size[0] / 2, spec.size[2], spec.material("body"), spec.material("valve")
    shell = [(0.94, 0), (0.98, 0.02), (0.98, 0.7), (0.94, 0.77), (0.74, 0.83), (0.36, 0.86), (0.3, 0.88)]
    b.lathe("iron", [(r, 0), (r, 0.05 * h)], segments=28)
    b.lathe(body, [(x * r, z * h) for x, z in shell], segments=28)
    b.lathe("plaster_white", [(0.99 * r, 0.6 * h), (0.99 * r, 0.66 * h)], segments=28, caps=False)
    b.lathe(valve, [(0.2 * r, 0.87 * h), (0.2 * r, 0.93 * h), (0.12 * r, 0.94 * h), (0.12 * r, 0.97 * h)], segments=14)
    b.cylinder(valve, (0, 0, 0.91 * h), (0, -0.42 * r, 0.91 * h), 0.11 * r)
    b.lathe("fabric_red", [(0.3 * r, 0.965 * h), (0.34 * r, 0.98 * h), (0.3 * r, h)], segments=12)
    for turn in (45, 135, 225, 315):
        with b.at(rotation=(0, 0, turn)):
            b.cylinder(body, (0.6 * r, 0, 0.84 * h), (0.56 * r, 0, 0.98 * h), 0.05 * r, segments=8)
    b.tube(body, ring_of(0.56 * r, 24, 0.98 * h), 0.06 * r, segments=8, closed=True)
    return grips_around(0.56 * r, 0.97 * h, FIST)
