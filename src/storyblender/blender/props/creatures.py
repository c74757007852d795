"""Prop builders: creatures that the ``Plan`` of ``beasts`` does not fit: rabbit, snake, dragon. They look to -Y."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, grips_around
from storyblender.blender.props.animals import both_sides, limb
from storyblender.blender.props.beasts import DARK, Plan, beast, scaled
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop

DRAGON = Plan(1.7, 0.46, 0.75, 0.1, (0.75, 0.95), 0.25, (0.36, 0.12), (0.2, 0.1, 55), (), 0.1, broad=0.85, waist=0.9)


@prop("rabbit")
def rabbit(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sitting rabbit."""
    coat = spec.material("coat")
    with b.at(scale=scaled(spec)):
        trunk = [
            (0.15, 0.06, 0.03), (0.13, 0.085, 0.075), (0.05, 0.105, 0.09), (-0.05, 0.11, 0.066), (-0.1, 0.125, 0.04),
        ]  # fmt: skip
        limb(b, coat, [(0, y, z, r * 0.82, r) for y, z, r in trunk], 16)
        b.sphere(coat, (0, -0.13, 0.165), 0.05, scale=(0.85, 1.15, 0.92))
        b.sphere(coat, (0, -0.175, 0.15), 0.026, scale=(1.1, 0.9, 0.9), segments=12, rings=8)
        b.sphere(DARK, (0, -0.2, 0.155), 0.006, segments=8, rings=5)
        b.sphere("linen", (0, 0.185, 0.08), 0.034, segments=12, rings=8)
        for x in (-1, 1):
            b.sphere(DARK, (x * 0.037, -0.15, 0.178), 0.008, segments=8, rings=5)
            b.cushion(coat, (x * 0.024, -0.09, 0.25), (0.036, 0.02, 0.14), softness=0.9, rotation=(-18, x * 9, 0))
            b.cushion(coat, (x * 0.07, 0.08, 0.065), (0.05, 0.14, 0.12), softness=0.9)
            b.cushion(coat, (x * 0.072, 0.02, 0.016), (0.042, 0.15, 0.032), softness=0.8)
        front = [
            (0.035, -0.07, 0.1, 0.024, 0.026),
            (0.035, -0.1, 0.05, 0.016, 0.018),
            (0.035, -0.1, 0.01, 0.016, 0.018),
        ]
        for leg in both_sides(front):
            limb(b, coat, leg, 10)
            b.cushion(coat, (leg[-1][0], -0.115, 0.012), (0.034, 0.055, 0.024), softness=0.8)
    return grips_around(0.075, 0.1, (0.4, 0.45, 0.3))


@prop("snake")
def snake(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a coiled snake with its head raised."""
    skin = spec.material("skin")
    with b.at(scale=scaled(spec)):
        t = np.linspace(0, 2.6, 54)
        reach = 0.17 - 0.03 * t
        coil = np.c_[reach * np.cos(2 * np.pi * t), reach * np.sin(2 * np.pi * t), 0.022 + 0.03 * t]
        neck = bent([coil[-1], (0.03, -0.06, 0.15), (0.0, -0.04, 0.22), (0.0, -0.08, 0.29), (0.0, -0.15, 0.3)], 5)[1:]
        path = np.r_[coil, neck]
        thick = np.interp(np.linspace(0, 1, len(path)), (0, 0.25, 0.7, 0.95, 1), (0.004, 0.022, 0.026, 0.017, 0.02))
        b.tube(skin, path, tuple(float(r) for r in thick), segments=10)
        b.cushion(skin, (0, -0.175, 0.3), (0.05, 0.085, 0.034), softness=0.8)
        b.cylinder("fabric_red", (0, -0.21, 0.295), (0, -0.25, 0.29), 0.002, segments=5)
        for x in (-1, 1):
            b.sphere(DARK, (x * 0.018, -0.185, 0.313), 0.006, segments=8, rings=5)
    return ()


@prop("dragon")
def dragon(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dragon: folded wings half open, a ridge of spikes, a long tail."""
    skin, horn = spec.material("skin"), spec.material("horn")
    with b.at(scale=scaled(spec)):
        beast(b, skin, DRAGON)
        y, z = DRAGON.skull
        tail = bent([(0, 0.7, 1.25), (0, 1.3, 1.0), (0.12, 2.0, 0.45), (0.5, 2.6, 0.16), (0.95, 2.75, 0.12)], 6)
        b.tube(skin, tail, tuple(np.linspace(0.34, 0.03, len(tail))), segments=12)
        with b.at(tail[-1], (0, 0, -70)):
            b.extrude(skin, [(0, -0.02), (0.16, -0.14), (0.14, 0.0), (0.16, 0.14), (0, 0.02)], 0.04)
        back = bent([(0, y + 0.1, z + 0.22), (0, -0.85, 1.72), (0, -0.45, 1.7), (0, 0.1, 1.7), (0, 0.7, 1.58)], 4)
        for k, at in enumerate(np.r_[back, np.add(tail[3:-6:3], (0, 0, 0.16))]):
            _spike(b, horn, at, 0.14 + 0.1 * np.sin(0.45 * k) ** 2)
        for x in (-1, 1):
            horns = bent([(x * 0.12, y + 0.08, z + 0.16), (x * 0.2, y + 0.3, z + 0.32), (x * 0.22, y + 0.55, z + 0.34)])
            b.tube(horn, horns, tuple(np.linspace(0.05, 0.008, len(horns))), segments=8)
            for across in (0.03, 0.08):
                b.cylinder(
                    horn, (x * across, y - 0.5, z - 0.15), (x * across, y - 0.5, z - 0.26), 0.018, 0.003, segments=6
                )
        for mirrored in (1, -1):
            with b.at(scale=(mirrored, 1, 1)):
                _wing(b, skin, spec.material("wing"))
    return ()


def _spike(b: MeshBuilder, material: MaterialRef, foot: np.ndarray, height: float) -> None:
    """Add a spike that leans back, its foot sunk into the skin at ``foot``."""
    with b.at(foot - (0, 0, 0.1), (-14, 0, 0)):
        rings = [
            [(-0.04, -0.1, 0), (0.04, -0.1, 0), (0.04, 0.1, 0), (-0.04, 0.1, 0)],
            [(x, y, height + 0.1) for x, y in ((-0.005, 0.06), (0.005, 0.06), (0.005, 0.08), (-0.005, 0.08))],
        ]
        b.loft(material, rings)


def _wing(b: MeshBuilder, bone: MaterialRef, skin: MaterialRef) -> None:
    """Add the wing at +X: an arm, three fingers, and skin that sags between them."""
    root, elbow, wrist = (0.28, -0.35, 1.62), (0.85, -0.1, 2.2), (1.35, -0.55, 2.75)
    tips = [(2.3, -0.1, 2.45), (2.05, 0.75, 1.9), (1.45, 1.3, 1.5), (0.35, 0.75, 1.5)]
    b.tube(bone, bent([root, elbow, wrist]), tuple(np.linspace(0.1, 0.05, 9)), segments=8)
    b.cylinder("wax", wrist, (1.42, -0.72, 2.82), 0.03, 0.004, segments=6)
    fingers = [
        bent(np.vstack([wrist, np.add(np.mean([wrist, tip], axis=0), (0.05, 0.0, 0.14)), tip])) for tip in tips[:3]
    ]
    fingers.append(bent([wrist, elbow, tips[3]]))
    for finger in fingers[:3]:
        b.tube(bone, finger, tuple(np.linspace(0.04, 0.012, len(finger))), segments=6)
    for near, far in pairwise(fingers):
        steps = np.linspace(0, 1, 6)[:, None, None]
        sheet = near + (far - near) * steps
        pull = 0.16 * np.sin(np.pi * steps) * np.linspace(0, 1, len(near))[None, :, None]
        sheet = sheet + (np.array(wrist) - sheet) * pull
        for gap in (0.006, -0.006):
            rows = np.add(sheet, (0, 0, gap))
            b.loft(skin, list(rows if gap > 0 else rows[::-1]), closed=False)
