"""Prop builders: pig, goat, sheep and deer, built from a ``Plan`` of ``beasts``. They look to -Y."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors
from storyblender.blender.props.beasts import DARK, Plan, beast, scaled
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop

PIG = Plan(
    trunk=0.85, chest=0.26, leg=0.2, foot=0.045, neck=(0.2, 0.02), head=0.15, snout=(0.12, 0.07), ear=(0.15, 0.12, 40),
    tail=((0.06, 0.04), (0.08, 0.1), (0.03, 0.08)), bushy=0.016, hooves=True, broad=0.9, waist=1.02,
)  # fmt: skip
GOAT = Plan(
    trunk=0.68, chest=0.2, leg=0.36, foot=0.028, neck=(0.18, 0.28), head=0.1, snout=(0.13, 0.045), ear=(0.13, 0.05, 75),
    tail=((0.06, 0.06), (0.08, 0.13)), bushy=0.022, hooves=True, waist=0.98,
)  # fmt: skip
SHEEP = Plan(
    trunk=0.72, chest=0.2, leg=0.34, foot=0.028, neck=(0.17, 0.18), head=0.1, snout=(0.12, 0.048), ear=(0.13, 0.06, 85),
    tail=((0.05, -0.08), (0.05, -0.16)), bushy=0.035, hooves=True,
)  # fmt: skip
DEER = Plan(
    trunk=0.95, chest=0.21, leg=0.66, foot=0.03, neck=(0.24, 0.5), head=0.105, snout=(0.15, 0.042),
    ear=(0.18, 0.075, 50), tail=((0.06, 0.0), (0.08, -0.1)), bushy=0.03, hooves=True,
)  # fmt: skip


@prop("pig")
def pig(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pig with its disc of a snout."""
    coat = spec.material("coat")
    with b.at(scale=scaled(spec)):
        beast(b, coat, PIG)
        (y, z), r, (long, nose) = PIG.skull, PIG.head, PIG.snout
        tip = (0, y - r * 0.7 - long, z - r * 0.42)
        profile = [(nose * 0.95, -0.03), (nose * 1.08, 0.0), (nose * 0.9, 0.014)]
        b.lathe(coat, profile, origin=tip, axis=(0, -1, 0.1), segments=18)
        for x in (-1, 1):
            b.sphere(DARK, (x * nose * 0.4, tip[1] - 0.012, tip[2]), nose * 0.18, segments=8, rings=5)
    return ()


@prop("goat")
def goat(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a goat with horns and a beard."""
    coat, horn = spec.material("coat"), spec.material("horn")
    with b.at(scale=scaled(spec)):
        beast(b, coat, GOAT)
        y, z = GOAT.skull
        for x in (-1, 1):
            path = [
                (x * s, y + t, z + up)
                for s, t, up in ((0.04, 0, 0.07), (0.06, 0.03, 0.2), (0.1, 0.13, 0.26), (0.12, 0.2, 0.22))
            ]
            b.tube(horn, bent(path), tuple(bent((0.026, 0.022, 0.015, 0.005))), segments=8)
        b.cushion(coat, (0, y - 0.13, z - 0.15), (0.045, 0.05, 0.15), softness=0.9, rotation=(-10, 0, 0))
    return ()


@prop("sheep")
def sheep(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sheep in its wool."""
    wool, face = spec.material("wool"), spec.material("face")
    with b.at(scale=scaled(spec)):
        beast(b, face, SHEEP)
        middle = SHEEP.middle + 0.03
        b.cushion(wool, (0, 0.02, middle), (0.4, 0.9, 0.44), softness=0.8)
        for k in range(110):
            across, turn = np.sqrt(1 - (1 - 2 * (k + 0.5) / 110) ** 2), 2.39996 * k
            along = 1 - 2 * (k + 0.5) / 110
            at = (0.2 * across * np.cos(turn), 0.02 + 0.44 * along, middle + 0.22 * across * np.sin(turn))
            b.sphere(wool, at, 0.072, segments=8, rings=5)
        y, z = SHEEP.skull
        b.cushion(wool, (0, y + 0.03, z + 0.09), (0.14, 0.14, 0.09), softness=0.9)
        b.cushion(wool, (0, y + 0.14, z - 0.08), (0.27, 0.24, 0.34), softness=0.8, rotation=(40, 0, 0))
    return ()


@prop("deer")
def deer(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a deer; ``antlers`` are a stag's."""
    with b.at(scale=scaled(spec)):
        beast(b, spec.material("coat"), DEER)
        y, z = DEER.skull
        for x in (-1, 1) if spec.flag("antlers") else ():
            curve = [
                (x * s, y + t, z + up)
                for s, t, up in ((0.04, 0.02, 0.08), (0.1, 0.1, 0.3), (0.28, 0.12, 0.46), (0.26, 0.02, 0.66))
            ]
            stem = bent(curve)
            b.tube("wax", stem, tuple(np.linspace(0.02, 0.006, len(stem))), segments=7)
            for at, way in ((4, (0.0, -0.14, 0.06)), (8, (0.06 * x, -0.06, 0.14)), (10, (0.1 * x, 0.04, 0.1))):
                b.cylinder("wax", stem[at], stem[at] + way, 0.011, 0.003, segments=6)
    return ()
