"""Prop builders: furnishings of nurseries, sickrooms, Japanese rooms and offices."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, grips_at_side, grips_under, seat
from storyblender.blender.props.animals import both_sides, limb
from storyblender.blender.props.beasts import scaled
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop


@prop("rocking_horse")
def rocking_horse(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wooden horse on two runners."""
    body, mane = spec.material("body"), spec.material("mane")
    with b.at(scale=scaled(spec)):
        limb(b, body, [(0, -0.26, 0.56, 0.06, 0.07), (0, -0.2, 0.56, 0.11, 0.12), (0, 0.0, 0.54, 0.1, 0.1),
                       (0, 0.2, 0.56, 0.11, 0.12), (0, 0.27, 0.56, 0.06, 0.07)])  # fmt: skip
        limb(b, body, [(0, -0.2, 0.58, 0.07, 0.09), (0, -0.3, 0.74, 0.055, 0.075), (0, -0.33, 0.85, 0.05, 0.06)])
        limb(b, body, [(0, -0.27, 0.88, 0.045, 0.05), (0, -0.37, 0.83, 0.05, 0.06), (0, -0.48, 0.74, 0.035, 0.04)])
        for leg in (*both_sides([(0.07, -0.2, 0.5, 0.035, 0.05), (0.12, -0.32, 0.12, 0.025, 0.03)]),
                    *both_sides([(0.07, 0.2, 0.5, 0.035, 0.06), (0.12, 0.32, 0.12, 0.025, 0.03)])):  # fmt: skip
            limb(b, body, leg, 10)
        for x in (-0.13, 0.13):
            arc = [(x, 0.52 * t, 0.03 + 0.16 * t * t) for t in np.linspace(-1, 1, 11)]
            b.tube(spec.material("runner"), arc, 0.024, segments=8)
        for y in (-0.26, 0.26):
            b.cylinder(spec.material("runner"), (-0.13, y, 0.09), (0.13, y, 0.09), 0.018, segments=8)
        b.tube(mane, bent([(0, -0.26, 0.92), (0, -0.2, 0.82), (0, -0.16, 0.66)]), 0.03, segments=8)
        b.tube(mane, bent([(0, 0.27, 0.6), (0, 0.36, 0.52), (0, 0.38, 0.34)]), 0.026, segments=8)
        b.cushion(spec.material("saddle"), (0, 0.02, 0.64), (0.23, 0.26, 0.07), softness=0.6)
        b.cylinder(spec.material("runner"), (-0.14, -0.28, 0.76), (0.14, -0.28, 0.76), 0.014, segments=8)
        for x in (-1, 1):
            b.sphere(mane, (x * 0.045, -0.38, 0.86), 0.011, segments=8, rings=5)
            b.cushion(body, (x * 0.03, -0.28, 0.94), (0.03, 0.02, 0.07), softness=0.9)
    return (seat((0, -0.1 * spec.size[1], 0.67 * spec.size[2] / 0.95), (0.24, 0.26)),)


@prop("dolls_house")
def dolls_house(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a little house of two floors with a pitched roof."""
    (w, d, h), wall, trim = spec.size, spec.material("wall"), spec.material("trim")
    eave = h * 0.64
    b.box(wall, (0, 0, eave / 2), (w * 0.9, d * 0.86, eave), bevel=0.004)
    gable = [(-w * 0.45, eave), (w * 0.45, eave), (0, h * 0.96)]
    with b.at((0, d * 0.43, 0), (90, 0, 0)):
        b.extrude(wall, gable, d * 0.86)
    for x in (-1, 1):
        slope = math.degrees(math.atan2(h * 0.34, w * 0.48))
        b.box(spec.material("roof"), (x * w * 0.24, 0, eave + h * 0.17), (math.hypot(w * 0.5, h * 0.34), d, 0.02),
              rotation=(0, x * slope, 0))  # fmt: skip
    for row in (0.3, 0.76):
        for x in (-0.27, 0.27) if row < 0.5 else (-0.27, 0.0, 0.27):
            b.box(trim, (x * w, -d * 0.43, eave * row), (w * 0.17, 0.012, eave * 0.26))
            b.box(spec.material("pane"), (x * w, -d * 0.438, eave * row), (w * 0.13, 0.01, eave * 0.2))
    b.box(spec.material("roof"), (0, -d * 0.435, eave * 0.2), (w * 0.14, 0.014, eave * 0.38))
    b.box(trim, (0, 0, eave * 0.52), (w * 0.92, d * 0.89, 0.012))
    return ()


@prop("toy_blocks")
def toy_blocks(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build six blocks, five about the floor and one on top."""
    w, d, h = spec.size
    edge = h * 0.44
    places = ((-0.3, -0.2, 0), (0.0, -0.25, 0), (0.28, 0.05, 0), (-0.05, 0.15, 0), (0.1, -0.02, 1), (-0.3, 0.28, 0))
    for index, (x, y, floor) in enumerate(places):
        colour = spec.material("abc"[index % 3])
        b.box(
            colour, (x * w, y * d, edge * (floor + 0.5)), (edge, edge, edge), bevel=0.006, rotation=(0, 0, 37 * index)
        )
    return grips_around(edge * 0.5, edge, (0.6, 0.65, 0.5))


def _wheeled_foot(b: MeshBuilder, spec: PropSpec, radius: float, metal: str) -> None:
    """Add five legs that end in castors, ``radius`` metres from the middle; ``metal`` is their material role."""
    for turn in np.linspace(0, math.tau, 5, endpoint=False):
        at = (radius * math.cos(turn), radius * math.sin(turn))
        b.cylinder(spec.material(metal), (0, 0, 0.09), (*at, 0.06), 0.013, segments=8)
        b.sphere(spec.material("wheel"), (*at, 0.03), 0.03, segments=10, rings=6)


@prop("heart_monitor")
def heart_monitor(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a monitor on a pole; its screen looks to -Y."""
    (w, d, h), metal = spec.size, spec.material("metal")
    _wheeled_foot(b, spec, d * 0.42, "metal")
    b.cylinder(metal, (0, 0, 0.08), (0, 0, h - 0.36), 0.018, segments=10)
    b.rounded_box(spec.material("body"), (0, 0, h - 0.19), (w * 0.92, 0.24, 0.36), 0.02)
    b.box(spec.material("screen"), (0, -0.122, h - 0.17), (w * 0.78, 0.006, 0.26))
    wave = [(-0.15, 0), (-0.07, 0), (-0.045, 0.05), (-0.02, -0.05), (0.0, 0), (0.08, 0), (0.105, 0.06), (0.15, 0)]
    b.tube(spec.material("body"), [(x, -0.128, h - 0.17 + z) for x, z in wave], 0.004, segments=6)
    b.box(metal, (0, -0.02, h * 0.62), (w * 0.7, 0.24, 0.02))
    path = [(0.12, 0.1, h - 0.3), (0.16, 0.14, h * 0.5), (0.1, 0.1, 0.3)]
    b.tube(spec.material("wheel"), bent(path), 0.008, segments=6)
    return ()


@prop("drip_stand")
def drip_stand(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pole with a bag and its tube."""
    (_, d, h), metal, bag = spec.size, spec.material("metal"), spec.material("bag")
    _wheeled_foot(b, spec, d * 0.45, "metal")
    b.cylinder(metal, (0, 0, 0.08), (0, 0, h - 0.02), 0.012, segments=10)
    b.cylinder(metal, (-0.14, 0, h - 0.02), (0.14, 0, h - 0.02), 0.008, segments=8)
    b.cushion(bag, (0.12, 0, h - 0.19), (0.13, 0.04, 0.24), softness=0.4)
    hose = bent([(0.12, 0, h - 0.3), (0.13, -0.03, h * 0.6), (0.07, -0.06, h * 0.42), (0.16, -0.1, h * 0.4)])
    b.tube(bag, hose, 0.005, segments=6)
    return ()


@prop("clipboard")
def clipboard(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a board, a sheet with lines, and the clip at its far edge."""
    (w, d, _), ink = spec.size, spec.material("clip")
    b.box(spec.material("board"), (0, 0, 0.004), (w, d, 0.008), bevel=0.002)
    b.box(spec.material("paper"), (0, -0.012, 0.009), (w * 0.9, d * 0.88, 0.002))
    for row in range(7):
        b.box(ink, (-0.01, d * (0.26 - 0.09 * row), 0.0105), (w * 0.7, 0.003, 0.001))
    b.box(ink, (0, d * 0.46, 0.014), (w * 0.42, 0.03, 0.012), bevel=0.003)
    return grips_at_side(-w / 2, 0.005) + grips_under(d * 0.35)


@prop("mop")
def mop(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pole with a head of strings that spread on the floor."""
    (w, _, h), strings = spec.size, spec.material("strings")
    b.cylinder(spec.material("handle"), (0, 0, 0.16), (0, 0, h), 0.014, segments=10)
    b.box(strings, (0, 0, 0.16), (w * 0.5, 0.05, 0.05), bevel=0.01)
    for k in range(13):
        turn = math.tau * k / 13
        reach = (w * 0.48 * math.cos(turn), 0.08 * math.sin(turn))
        b.tube(strings, bent([(reach[0] * 0.4, reach[1] * 0.3, 0.16), (reach[0] * 0.8, reach[1] * 0.8, 0.08),
                              (*reach, 0.012)]), 0.011, segments=6)  # fmt: skip
    return grips_around(0.015, h * 0.62, FIST)


@prop("tape_recorder")
def tape_recorder(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a machine with two reels on top and keys in front."""
    (w, d, h), metal = spec.size, spec.material("metal")
    b.rounded_box(spec.material("body"), (0, 0, h * 0.42), (w, d, h * 0.84), 0.012)
    b.box(metal, (0, 0.01, h * 0.845), (w * 0.92, d * 0.8, 0.004))
    for x in (-0.23, 0.23):
        b.cylinder(spec.material("reel"), (x * w, d * 0.1, h * 0.86), (x * w, d * 0.1, h * 0.95), w * 0.19, segments=28)
        b.cylinder(metal, (x * w, d * 0.1, h * 0.94), (x * w, d * 0.1, h), 0.014, segments=10)
    for k in range(5):
        b.box(
            spec.material("reel"), ((k - 2) * w * 0.12, -d * 0.36, h * 0.88), (w * 0.09, d * 0.1, h * 0.1), bevel=0.003
        )
    return grips_at_side(-w / 2, h * 0.4) + grips_under(d * 0.35)


@prop("whiteboard")
def whiteboard(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a white board with a ledge for pens and a few strokes drawn on it."""
    (w, d, h), frame, ink = spec.size, spec.material("frame"), spec.material("ink")
    y = d / 2
    b.box(spec.material("board"), (0, y - 0.015, h / 2), (w, 0.03, h))
    for x in (-1, 1):
        b.box(frame, (x * w / 2, y - 0.018, h / 2), (0.03, 0.036, h + 0.03))
    for z in (0, h):
        b.box(frame, (0, y - 0.018, z), (w + 0.03, 0.036, 0.03))
    b.box(frame, (0, y - 0.06, 0.0), (w * 0.6, 0.08, 0.02))
    face = y - 0.033
    for row, share in enumerate((0.5, 0.36, 0.44)):
        b.box(ink, (w * (-0.4 + share / 2), face, h * (0.8 - 0.13 * row)), (w * share, 0.004, 0.014))
    ring = np.linspace(0, math.tau, 20, endpoint=False)
    b.tube(ink, np.c_[w * 0.28 + 0.14 * np.cos(ring), np.full(20, face), h * 0.42 + 0.14 * np.sin(ring)], 0.007,
           segments=6, closed=True)  # fmt: skip
    b.tube(ink, [(-w * 0.1, face, h * 0.26), (w * 0.17, face, h * 0.4)], 0.007, segments=6)
    return ()


@prop("fishing_net")
def fishing_net(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a heap of net: strands over a mound, and floats along its edge."""
    (w, d, h), cord = spec.size, spec.material("cord")
    b.cushion("leather_black", (0, 0, h * 0.32), (w * 0.8, d * 0.8, h * 0.66), softness=0.9)
    for k in range(22):
        turn, lean = math.pi * k / 11, 0.35 * math.sin(2.3 * k)
        across = np.linspace(-1, 1, 11)
        rise = h * (0.72 + 0.2 * math.sin(1.7 * k)) * np.sqrt(np.clip(1 - across**2, 0, 1)) + 0.012
        x = 0.48 * w * (across * math.cos(turn) - lean * (1 - across**2) * math.sin(turn))
        y = 0.48 * d * (across * math.sin(turn) + lean * (1 - across**2) * math.cos(turn))
        b.tube(cord, np.c_[x, y, rise], 0.009, segments=5)
    for k in range(9):
        turn = math.tau * k / 9 + 0.3
        at = (0.44 * w * math.cos(turn), 0.44 * d * math.sin(turn), 0.045)
        b.sphere(spec.material("float"), at, 0.045, scale=(1.3, 1, 1), segments=10, rings=7)
    return ()


@prop("brazier")
def brazier(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an iron bowl on three feet, full of coals."""
    (w, _, h), iron, coal = spec.size, spec.material("body"), spec.material("coal")
    r = w / 2
    b.lathe(iron, [(r * 0.5, h * 0.3), (r * 0.86, h * 0.5), (r, h * 0.92), (r * 0.93, h * 0.92), (r * 0.8, h * 0.6)],
            segments=28)  # fmt: skip
    for turn in np.linspace(0, math.tau, 3, endpoint=False):
        foot = (r * 0.8 * math.cos(turn), r * 0.8 * math.sin(turn), 0.0)
        b.cylinder(iron, (foot[0] * 0.6, foot[1] * 0.6, h * 0.4), foot, 0.02, segments=8)
    for k in range(16):
        turn, reach = 2.39996 * k, r * 0.8 * math.sqrt((k + 0.5) / 16)
        b.sphere(coal, (reach * math.cos(turn), reach * math.sin(turn), h * 0.84), w * 0.085, segments=7, rings=5)
    return ()


@prop("floor_cushion")
def floor_cushion(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a flat square cushion with a tuft in its middle."""
    (w, d, h), cover = spec.size, spec.material("cover")
    b.cushion(cover, (0, 0, h / 2), (w, d, h), softness=0.45)
    b.sphere("linen", (0, 0, h * 0.97), 0.016, segments=8, rings=5)
    return ()


@prop("hanging_scroll")
def hanging_scroll(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a strip of silk with a sheet of brush strokes between two rods."""
    (w, d, h), rod, ink = spec.size, spec.material("rod"), spec.material("ink")
    y = d / 2 - 0.01
    b.box(spec.material("silk"), (0, y, h / 2), (w * 0.86, 0.008, h * 0.97))
    b.box(spec.material("paper"), (0, y - 0.005, h * 0.52), (w * 0.66, 0.006, h * 0.62))
    for z in (0.015, h - 0.015):
        b.cylinder(rod, (-w / 2, y, z), (w / 2, y, z), 0.015, segments=10)
    for row in range(3):
        z = h * (0.74 - 0.19 * row)
        line = [(-0.07, y - 0.009, z), (0.0, y - 0.009, z + 0.02), (0.07, y - 0.009, z + 0.005)]
        b.tube(ink, bent(line), 0.009, segments=6)
        path = [(0.0, y - 0.009, z + 0.06), (-0.01, y - 0.009, z), (-0.06, y - 0.009, z - 0.07)]
        b.tube(ink, bent(path), 0.008, segments=6)
        b.tube(ink, [(0.01, y - 0.009, z), (0.06, y - 0.009, z - 0.06)], 0.007, segments=6)
    return ()
