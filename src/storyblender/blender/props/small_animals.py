"""Prop builders: small and exotic animals: squirrel, frog, tortoise, monkey, crocodile, bat. They face -Y."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors
from storyblender.blender.props.animals import limb
from storyblender.blender.props.beasts import DARK, Plan, beast, scaled
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop

WHITE = "linen"
CROCODILE = Plan(1.3, 0.2, 0.14, 0.06, (0.34, 0.06), 0.17, (0.55, 0.09), (0.02, 0.02, 30), (), broad=1.25, waist=1.0)
LIZARD = Plan(
    trunk=0.12, chest=0.022, leg=0.014, foot=0.007, neck=(0.03, 0.006), head=0.02, snout=(0.03, 0.008),
    ear=(0.004, 0.004, 30), tail=((0.06, -0.02), (0.14, -0.03), (0.2, -0.03)), bushy=0.012, broad=1.2,
)  # fmt: skip


def eyes(b: MeshBuilder, x: float, y: float, z: float, radius: float, white: bool = False) -> None:
    """Add two eyes.

    Args:
        b: Receives the eyes.
        x: Metres to either side of the middle.
        y: Of both.
        z: Of both.
        radius: Of the pupil.
        white: Protruding eyeballs behind the pupils.
    """
    for side in (-1, 1):
        if white:
            b.sphere(WHITE, (side * x, y + radius * 0.5, z), radius * 1.5, segments=12, rings=8)
        b.sphere(DARK, (side * x, y - radius * 0.4 * white, z), radius, segments=10, rings=6)


@prop("squirrel")
def squirrel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a squirrel that sits up with its tail over its back."""
    coat = spec.material("coat")
    with b.at(scale=scaled(spec)):
        rings = [
            (0, 0.05, 0.02, 0.035, 0.03),
            (0, 0.035, 0.06, 0.052, 0.05),
            (0, 0.0, 0.12, 0.042, 0.042),
            (0, -0.025, 0.165, 0.028, 0.028),
        ]
        limb(b, coat, rings, 16)
        b.sphere(coat, (0, -0.04, 0.19), 0.034, scale=(0.92, 1.1, 0.95), segments=14, rings=9)
        b.sphere(WHITE, (0, -0.018, 0.1), 0.034, scale=(0.8, 0.8, 1.4), segments=12, rings=8)
        b.sphere(coat, (0, -0.07, 0.182), 0.018, segments=10, rings=7)
        b.sphere(DARK, (0, -0.088, 0.186), 0.006, segments=8, rings=5)
        eyes(b, 0.026, -0.06, 0.2, 0.007)
        for x in (-1, 1):
            b.cushion(coat, (x * 0.022, -0.03, 0.232), (0.018, 0.012, 0.04), softness=0.9, rotation=(0, x * 12, 0))
            b.cushion(coat, (x * 0.05, 0.03, 0.035), (0.045, 0.09, 0.07), softness=0.9)
            b.cushion(coat, (x * 0.045, -0.03, 0.012), (0.024, 0.07, 0.022), softness=0.8)
            path = [(x * 0.035, -0.015, 0.135), (x * 0.035, -0.06, 0.12), (x * 0.014, -0.085, 0.135)]
            b.tube(coat, path, 0.011, segments=8)
        curve = [(0, 0.07, 0.03), (0, 0.14, 0.05), (0, 0.165, 0.15), (0, 0.13, 0.25), (0, 0.17, 0.31), (0, 0.21, 0.3)]
        tail = bent(curve)
        radii = np.interp(np.linspace(0, 1, len(tail)), (0, 0.3, 0.7, 1), (0.015, 0.045, 0.05, 0.015))
        b.tube(coat, tail, tuple(float(r) for r in radii), segments=12)
    return ()


def _frog(b: MeshBuilder, skin: MaterialRef, *, warts: bool) -> None:
    """Add a sitting frog, or with ``warts`` a toad."""
    rings = [
        (0, 0.07, 0.02, 0.025, 0.015), (0, 0.04, 0.035, 0.05, 0.032), (0, -0.015, 0.055, 0.054, 0.04),
        (0, -0.06, 0.07, 0.045, 0.03), (0, -0.085, 0.068, 0.022, 0.014),
    ]  # fmt: skip
    limb(b, skin, rings, 16)
    b.cushion("linen", (0, -0.03, 0.04), (0.08, 0.09, 0.05), softness=0.9)
    for x in (-1, 1):
        b.sphere(skin, (x * 0.03, -0.05, 0.1), 0.019, segments=12, rings=8)
        b.sphere("brass", (x * 0.035, -0.062, 0.103), 0.011, segments=10, rings=6)
        b.sphere(DARK, (x * 0.037, -0.07, 0.103), 0.006, segments=8, rings=5)
        line = [(x * 0.03, 0.06, 0.03), (x * 0.085, 0.0, 0.06), (x * 0.08, 0.07, 0.02), (x * 0.1, 0.02, 0.008)]
        b.tube(skin, bent(line), 0.014, segments=8)
        b.cushion(skin, (x * 0.105, -0.01, 0.006), (0.04, 0.07, 0.012), softness=0.8)
        path = [(x * 0.04, -0.045, 0.05), (x * 0.06, -0.06, 0.03), (x * 0.05, -0.075, 0.008)]
        b.tube(skin, bent(path), 0.01, segments=8)
        b.cushion(skin, (x * 0.052, -0.09, 0.006), (0.034, 0.04, 0.01), softness=0.8)
    if warts:
        for k in range(24):
            turn, along = 2.39996 * k, k / 24
            center = (0.042 * np.cos(turn), 0.05 - 0.09 * along, 0.06 + 0.03 * abs(np.sin(turn)))
            b.sphere(skin, center, 0.008, segments=7, rings=5)
    b.tube(DARK, [(-0.035, -0.078, 0.064), (0, -0.094, 0.061), (0.035, -0.078, 0.064)], 0.0018, segments=5)


@prop("frog")
def frog(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sitting frog."""
    with b.at(scale=scaled(spec)):
        _frog(b, spec.material("skin"), warts=False)
    return ()


@prop("toad")
def toad(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sitting toad with its warts."""
    with b.at(scale=scaled(spec)):
        _frog(b, spec.material("skin"), warts=True)
    return ()


@prop("tortoise")
def tortoise(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tortoise."""
    shell, skin = spec.material("shell"), spec.material("skin")
    with b.at(scale=scaled(spec)):
        b.sphere(shell, (0, 0.01, 0.07), 0.12, scale=(0.88, 1.15, 0.78), segments=22, rings=12)
        b.sphere(skin, (0, 0.01, 0.055), 0.122, scale=(0.9, 1.17, 0.28), segments=22, rings=8)
        for count, tilt in ((1, 0.0), (6, 0.72)):
            for k in range(count):
                turn = 2 * np.pi * k / count
                way = np.array((np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt)))
                at = np.array((0, 0.01, 0.07)) + way * (0.106, 0.138, 0.094)
                b.lathe("brass", [(0.034, -0.004), (0.03, 0.004), (0.012, 0.008)], origin=at, axis=way, segments=6)
        neck = bent([(0, -0.09, 0.06), (0, -0.14, 0.08), (0, -0.175, 0.105)])
        b.tube(skin, neck, 0.026, segments=10)
        b.sphere(skin, (0, -0.195, 0.112), 0.033, scale=(0.9, 1.2, 0.9), segments=14, rings=9)
        eyes(b, 0.024, -0.213, 0.124, 0.006)
        for x in (-1, 1):
            for y in (-0.085, 0.1):
                b.cylinder(skin, (x * 0.075, y, 0.06), (x * 0.1, y * 1.1, 0.0), 0.026, 0.03, segments=10)
        b.cylinder(skin, (0, 0.14, 0.05), (0, 0.19, 0.03), 0.012, 0.003, segments=8)
    return ()


def _ape(b: MeshBuilder, coat: MaterialRef, bare: MaterialRef, *, tail: bool, bulk: float) -> None:
    """Add an ape that sits on its haunches, a metre tall."""
    rings = [
        (0, 0.12, 0.04, 0.13 * bulk, 0.1),
        (0, 0.1, 0.2, 0.19 * bulk, 0.17 * bulk),
        (0, 0.04, 0.45, 0.19 * bulk, 0.15 * bulk),
        (0, -0.02, 0.64, 0.13 * bulk, 0.11 * bulk),
        (0, -0.04, 0.72, 0.07 * bulk, 0.07 * bulk),
    ]
    limb(b, coat, rings, 18)
    b.sphere(coat, (0, -0.07, 0.83), 0.15, scale=(0.95, 1, 1), segments=18, rings=11)
    b.sphere(bare, (0, -0.17, 0.79), 0.085, scale=(1.05, 0.8, 0.8), segments=14, rings=9)
    b.cushion(bare, (0, -0.17, 0.865), (0.19, 0.09, 0.1), softness=0.9)
    for x in (-1, 1):
        b.sphere(bare, (x * 0.15, -0.05, 0.83), 0.05, scale=(0.5, 0.8, 1), segments=12, rings=8)
        b.sphere(DARK, (x * 0.05, -0.21, 0.875), 0.018, segments=10, rings=6)
        b.sphere(DARK, (x * 0.018, -0.238, 0.8), 0.009, segments=8, rings=5)
        curve = np.multiply(
            [(0.15, -0.02, 0.6), (0.28, -0.04, 0.36), (0.22, -0.16, 0.14), (0.2, -0.2, 0.05)], (x * bulk, 1, 1)
        )
        arm = bent(curve)
        b.tube(coat, arm, tuple(np.linspace(0.07 * bulk, 0.045 * bulk, len(arm))), segments=10)
        b.cushion(bare, (x * 0.2 * bulk, -0.22, 0.03), (0.09, 0.12, 0.06), softness=0.8)
        b.cushion(coat, (x * 0.2 * bulk, 0.0, 0.14), (0.17 * bulk, 0.34, 0.22), softness=0.9, rotation=(-20, 0, 0))
        b.cushion(bare, (x * 0.22 * bulk, -0.16, 0.03), (0.09, 0.2, 0.06), softness=0.8)
    b.tube(DARK, [(-0.05, -0.235, 0.765), (0, -0.245, 0.758), (0.05, -0.235, 0.765)], 0.006, segments=5)
    if tail:
        path = bent([(0, 0.22, 0.06), (0, 0.42, 0.08), (0.05, 0.52, 0.3), (0.0, 0.46, 0.5), (-0.04, 0.54, 0.56)])
        b.tube(coat, path, tuple(np.linspace(0.03, 0.018, len(path))), segments=8)


@prop("monkey")
def monkey(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sitting monkey."""
    with b.at(scale=np.array(scaled(spec)) * (0.6, 0.6, 0.6)):
        _ape(b, spec.material("coat"), spec.material("face"), tail=True, bulk=0.85)
    return ()


@prop("gorilla")
def gorilla(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sitting gorilla."""
    with b.at(scale=np.array(scaled(spec)) * (1.4, 1.4, 1.4)):
        _ape(b, spec.material("coat"), spec.material("face"), tail=False, bulk=1.45)
    return ()


@prop("kangaroo")
def kangaroo(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a kangaroo that stands on its hind legs."""
    coat = spec.material("coat")
    with b.at(scale=scaled(spec)):
        rings = [
            (0, 0.3, 0.5, 0.1, 0.1), (0, 0.16, 0.58, 0.2, 0.22), (0, -0.02, 0.85, 0.16, 0.16),
            (0, -0.12, 1.1, 0.11, 0.11), (0, -0.18, 1.28, 0.07, 0.075),
        ]  # fmt: skip
        limb(b, coat, rings, 16)
        b.sphere(coat, (0, -0.24, 1.38), 0.09, scale=(0.85, 1.25, 0.95), segments=14, rings=9)
        limb(b, coat, [(0, -0.28, 1.36, 0.06, 0.06), (0, -0.4, 1.31, 0.035, 0.035)], 10)
        b.sphere(DARK, (0, -0.41, 1.33), 0.018, segments=8, rings=5)
        eyes(b, 0.06, -0.3, 1.42, 0.014)
        for x in (-1, 1):
            b.cushion(coat, (x * 0.055, -0.19, 1.53), (0.05, 0.03, 0.2), softness=0.9, rotation=(0, x * 12, 0))
            line = [(x * 0.1, -0.14, 1.05), (x * 0.13, -0.25, 0.9), (x * 0.1, -0.33, 0.98)]
            b.tube(coat, bent(line), 0.03, segments=8)
            b.cushion(coat, (x * 0.17, 0.12, 0.46), (0.14, 0.34, 0.42), softness=0.9, rotation=(-24, 0, 0))
            path = [(x * 0.18, -0.02, 0.36), (x * 0.18, 0.18, 0.2), (x * 0.18, 0.1, 0.05)]
            b.tube(coat, bent(path), 0.045, segments=8)
            b.cushion(coat, (x * 0.18, -0.1, 0.03), (0.09, 0.44, 0.06), softness=0.8)
        tail = bent([(0, 0.28, 0.52), (0, 0.55, 0.3), (0, 0.85, 0.09), (0, 1.1, 0.05)])
        b.tube(coat, tail, tuple(np.linspace(0.12, 0.025, len(tail))), segments=10)
    return ()


@prop("crocodile")
def crocodile(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a crocodile with its ridges and teeth."""
    skin = spec.material("skin")
    with b.at(scale=scaled(spec)):
        beast(b, skin, CROCODILE)
        tail = bent([(0, 0.6, 0.34), (0, 1.1, 0.26), (0.14, 1.6, 0.14), (0.05, 2.1, 0.06)])
        b.tube(skin, tail, tuple(np.linspace(0.2, 0.02, len(tail))), segments=12)
        y, z = CROCODILE.skull
        for k in range(18):
            at = 0.95 * (k / 17) * 2.6 - 0.75
            height = 0.52 if at < 0.55 else 0.5 - 0.17 * (at - 0.55)
            b.cylinder(skin, (0, at, height - 0.04), (0, at + 0.02, height + 0.06), 0.04, 0.004, segments=5)
        for x in (-1, 1):
            b.sphere(skin, (x * 0.09, y - 0.06, z + 0.14), 0.05, segments=10, rings=7)
            b.sphere("brass", (x * 0.1, y - 0.1, z + 0.15), 0.024, segments=8, rings=5)
            for k in range(7):
                tooth = (x * 0.085, y - 0.2 - 0.065 * k, z - 0.1)
                b.cylinder(WHITE, tooth, np.add(tooth, (0, 0, -0.06)), 0.014, 0.002, segments=5)
    return ()


@prop("lizard")
def lizard(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a lizard."""
    with b.at(scale=scaled(spec)):
        beast(b, spec.material("skin"), LIZARD)
    return ()


@prop("bat_animal")
def bat_animal(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bat with spread wings."""
    coat = spec.material("coat")
    with b.at(scale=scaled(spec)):
        b.sphere(coat, (0, 0, 0.06), 0.04, scale=(0.9, 1.3, 0.95), segments=14, rings=9)
        b.sphere(coat, (0, -0.055, 0.075), 0.027, segments=12, rings=8)
        eyes(b, 0.014, -0.078, 0.083, 0.005)
        for x in (-1, 1):
            b.cushion(coat, (x * 0.018, -0.05, 0.11), (0.022, 0.012, 0.05), softness=0.9, rotation=(0, x * 18, 0))
            rings = []
            for t, up in ((0.0, 0.0), (0.35, 0.05), (0.7, 0.03), (1.0, 0.0)):
                deep = 0.09 * (1 - 0.75 * t) + 0.03 * abs(np.sin(9 * t))
                foot = np.array((x * (0.03 + 0.24 * t), -0.04, 0.07 + up))
                rings.append(
                    [
                        foot,
                        np.add(foot, (0, 0.02, 0.004)),
                        np.add(foot, (0, deep, 0.0)),
                        np.add(foot, (0, 0.02, -0.003)),
                    ]
                )
            b.loft(spec.material("wing"), [np.array(ring) for ring in rings])
    return ()
