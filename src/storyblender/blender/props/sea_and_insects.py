"""Prop builders: insects, sea creatures and a dinosaur. They face -Y."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors
from storyblender.blender.props.animals import both_sides, limb
from storyblender.blender.props.beasts import DARK, scaled
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop
from storyblender.blender.props.small_animals import WHITE, eyes


def _insect_legs(b: MeshBuilder, reach: float, height: float, pairs: int) -> None:
    """Add pairs of bent legs that start ``height`` metres up and end ``reach`` metres to either side."""
    for k in range(pairs):
        y = (k - (pairs - 1) / 2) * reach * 0.4
        for x in (-1, 1):
            path = [(x * reach * 0.2, y, height), (x * reach * 0.65, y * 1.8, height * 1.7), (x * reach, y * 2.2, 0.0)]
            b.tube(DARK, bent(path), reach * 0.025, segments=5)


@prop("bee")
def bee(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bee; also used for wasps."""
    with b.at(scale=scaled(spec)):
        for k, (y, r) in enumerate(((0.012, 0.011), (0.02, 0.0125), (0.028, 0.012), (0.036, 0.009), (0.043, 0.005))):
            b.sphere(DARK if k % 2 else spec.material("coat"), (0, y, 0.018), r, segments=14, rings=9)
        b.sphere(spec.material("coat"), (0, -0.004, 0.02), 0.012, segments=12, rings=8)
        b.sphere(DARK, (0, -0.02, 0.018), 0.009, segments=12, rings=8)
        for x in (-1, 1):
            center = (x * 0.026, 0.012, 0.034)
            b.cushion("porcelain", center, (0.04, 0.018, 0.002), softness=0.9, rotation=(0, x * -20, x * 25))
            b.tube(DARK, [(x * 0.004, -0.025, 0.024), (x * 0.01, -0.036, 0.032)], 0.0008, segments=5)
        _insect_legs(b, 0.02, 0.01, 3)
    return ()


@prop("butterfly")
def butterfly(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a butterfly with its wings half raised."""
    wing = spec.material("wing")
    with b.at(scale=scaled(spec)):
        b.tube(DARK, bent([(0, -0.025, 0.03), (0, 0.0, 0.034), (0, 0.035, 0.026)]), (0.004,) * 9, segments=8)
        for x in (-1, 1):
            path = [(0, -0.025, 0.032), (x * 0.012, -0.045, 0.045), (x * 0.018, -0.05, 0.05)]
            b.tube(DARK, bent(path), 0.0008, segments=5)
            for outline, skin in (
                ([(0, 0), (0.02, -0.04), (0.055, -0.045), (0.06, -0.02), (0.03, 0.004)], wing),
                ([(0, 0.002), (0.034, 0.006), (0.046, 0.026), (0.026, 0.045), (0.006, 0.03)], wing),
            ):
                with b.at((0, 0, 0.034), (0, -x * 32, 0)):
                    b.extrude(skin, [(x * u, v) for u, v in outline], 0.0015)
                    b.extrude(DARK, [(x * (0.012 + 0.72 * u), 0.86 * v) for u, v in outline], 0.0008, base=-0.0006)
    return ()


@prop("spider")
def spider(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a spider."""
    skin = spec.material("skin")
    with b.at(scale=scaled(spec)):
        b.sphere(skin, (0, 0.022, 0.026), 0.02, scale=(0.9, 1.15, 0.85), segments=14, rings=9)
        b.sphere(skin, (0, -0.008, 0.022), 0.012, segments=12, rings=8)
        eyes(b, 0.005, -0.019, 0.026, 0.0025)
        for k in range(4):
            y = -0.014 + 0.008 * k
            for x in (-1, 1):
                out = 0.055 + 0.006 * (k in (0, 3))
                path = [(x * 0.008, y, 0.022), (x * out * 0.5, y * 2.4, 0.052), (x * out, y * 3.8, 0.0)]
                b.tube(skin, bent(path), 0.0016, segments=5)
    return ()


@prop("snail")
def snail(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a snail with its shell."""
    skin, shell = spec.material("skin"), spec.material("shell")
    with b.at(scale=scaled(spec)):
        rings = [
            (0, 0.05, 0.003, 0.004, 0.002), (0, 0.02, 0.007, 0.012, 0.007), (0, -0.03, 0.009, 0.012, 0.009),
            (0, -0.045, 0.018, 0.009, 0.009), (0, -0.05, 0.028, 0.007, 0.007),
        ]  # fmt: skip
        limb(b, skin, rings, 12)
        t = np.linspace(0, 2.4, 40)
        reach = 0.026 * np.exp(-0.75 * t)
        path = np.c_[0.004 * t, 0.008 + reach * np.cos(2 * np.pi * t), 0.032 + reach * np.sin(2 * np.pi * t)]
        b.tube(shell, path, tuple(0.017 * np.exp(-0.75 * t)), segments=12)
        for x in (-1, 1):
            b.tube(skin, [(x * 0.003, -0.052, 0.032), (x * 0.008, -0.06, 0.048)], 0.0012, segments=6)
            b.sphere(DARK, (x * 0.008, -0.06, 0.049), 0.0022, segments=7, rings=5)
    return ()


@prop("shark")
def shark(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a shark."""
    skin = spec.material("skin")
    with b.at(scale=scaled(spec)):
        rings = [
            (0, -1.4, 0.5, 0.05, 0.04), (0, -1.15, 0.48, 0.24, 0.2), (0, -0.6, 0.45, 0.34, 0.34),
            (0, 0.2, 0.45, 0.28, 0.28), (0, 0.9, 0.47, 0.1, 0.12), (0, 1.25, 0.5, 0.04, 0.06),
        ]  # fmt: skip
        limb(b, skin, rings, 20)
        b.cushion(WHITE, (0, -0.55, 0.26), (0.5, 1.5, 0.28), softness=0.9)
        for outline in (
            [(-0.25, 0.72), (0.2, 1.15), (0.32, 0.72)],
            [(1.1, 0.5), (1.6, 1.05), (1.4, 0.5), (1.52, 0.12)],
        ):
            with b.at((-0.03, 0, 0), (90, 0, 90)):
                b.extrude(skin, outline, 0.06)
        for x in (-1, 1):
            b.extrude(skin, [(x * 0.26, -0.5), (x * 0.85, 0.05), (x * 0.75, 0.15), (x * 0.26, -0.05)], 0.05, base=0.3)
            b.sphere(DARK, (x * 0.21, -1.08, 0.54), 0.035, segments=8, rings=5)
            for k in range(4):
                b.box(DARK, (x * (0.335 - 0.005 * k), -0.55 + 0.09 * k, 0.45), (0.02, 0.015, 0.2))
        for k in range(9):
            turn = np.radians(-70 + 140 * k / 8)
            foot = (0.17 * np.sin(turn), -1.12 - 0.1 * np.cos(turn), 0.34)
            b.cylinder(WHITE, foot, np.add(foot, (0, 0, -0.06)), 0.02, 0.002, segments=5)
    return ()


@prop("whale")
def whale(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a whale."""
    skin = spec.material("skin")
    with b.at(scale=scaled(spec)):
        rings = [
            (0, -6.0, 1.7, 0.5, 0.5), (0, -5.6, 1.6, 1.2, 1.2), (0, -3.5, 1.6, 1.55, 1.55), (0, 0.0, 1.5, 1.4, 1.35),
            (0, 3.5, 1.5, 0.6, 0.6), (0, 5.0, 1.7, 0.25, 0.25),
        ]  # fmt: skip
        limb(b, skin, rings, 24)
        b.cushion(WHITE, (0, -2.6, 0.75), (2.4, 6.4, 1.3), softness=0.9)
        for x in (-1, 1):
            b.extrude(skin, [(0, 4.6), (x * 1.7, 5.6), (x * 1.5, 6.2), (0, 5.4)], 0.18, base=1.65)
            b.extrude(skin, [(x * 1.2, -3.4), (x * 2.5, -2.0), (x * 2.2, -1.7), (x * 1.2, -2.6)], 0.16, base=0.8)
            b.sphere(DARK, (x * 1.36, -4.6, 1.6), 0.1, segments=10, rings=6)
    return ()


@prop("dolphin")
def dolphin(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dolphin; also used for seals."""
    skin = spec.material("skin")
    with b.at(scale=scaled(spec)):
        rings = [
            (0, -1.15, 0.32, 0.04, 0.03), (0, -0.95, 0.33, 0.06, 0.05), (0, -0.85, 0.36, 0.14, 0.14),
            (0, -0.4, 0.36, 0.23, 0.24), (0, 0.25, 0.34, 0.18, 0.19), (0, 0.85, 0.36, 0.06, 0.07),
        ]  # fmt: skip
        limb(b, skin, rings, 18)
        b.cushion(WHITE, (0, -0.4, 0.24), (0.34, 1.1, 0.22), softness=0.9)
        with b.at((-0.02, 0, 0), (90, 0, 90)):
            b.extrude(skin, [(-0.1, 0.54), (0.2, 0.82), (0.22, 0.5)], 0.04)
        for x in (-1, 1):
            b.extrude(skin, [(0, 0.8), (x * 0.32, 1.08), (x * 0.24, 1.15), (0, 0.98)], 0.04, base=0.34)
            b.extrude(skin, [(x * 0.18, -0.5), (x * 0.42, -0.2), (x * 0.18, -0.3)], 0.035, base=0.2)
            b.sphere(DARK, (x * 0.14, -0.78, 0.38), 0.02, segments=8, rings=5)
    return ()


@prop("octopus")
def octopus(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an octopus on its eight arms."""
    skin = spec.material("skin")
    with b.at(scale=scaled(spec)):
        b.sphere(skin, (0, 0.05, 0.42), 0.17, scale=(0.95, 1, 1.3), segments=20, rings=12)
        b.sphere(skin, (0, 0, 0.2), 0.13, segments=16, rings=10)
        eyes(b, 0.08, -0.13, 0.3, 0.02, white=True)
        for k in range(8):
            turn = np.pi / 8 + k * np.pi / 4
            way = np.array((np.cos(turn), np.sin(turn), 0))
            side = np.array((-way[1], way[0], 0))
            path = bent(
                [
                    way * 0.07 + (0, 0, 0.16),
                    way * 0.24 + (0, 0, 0.08),
                    way * 0.42 + side * 0.08 + (0, 0, 0.02),
                    way * 0.52 + side * 0.2 + (0, 0, 0.05),
                ]
            )
            b.tube(skin, path, tuple(np.linspace(0.06, 0.012, len(path))), segments=8)
    return ()


@prop("crab")
def crab(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a crab; also used for lobsters."""
    skin = spec.material("skin")
    with b.at(scale=scaled(spec)):
        b.sphere(skin, (0, 0, 0.05), 0.07, scale=(1.25, 0.9, 0.5), segments=18, rings=10)
        for x in (-1, 1):
            b.cylinder(skin, (x * 0.025, -0.05, 0.07), (x * 0.03, -0.06, 0.1), 0.004, segments=6)
            b.sphere(DARK, (x * 0.03, -0.06, 0.102), 0.008, segments=8, rings=5)
            line = [(x * 0.07, -0.03, 0.05), (x * 0.12, -0.07, 0.06), (x * 0.1, -0.11, 0.055)]
            b.tube(skin, bent(line), 0.012, segments=8)
            b.cushion(skin, (x * 0.09, -0.135, 0.055), (0.05, 0.06, 0.03), softness=0.9)
            b.cylinder(skin, (x * 0.075, -0.15, 0.055), (x * 0.065, -0.19, 0.055), 0.012, 0.002, segments=6)
            b.cylinder(skin, (x * 0.105, -0.15, 0.055), (x * 0.09, -0.195, 0.055), 0.012, 0.002, segments=6)
            for k in range(4):
                y = -0.02 + 0.025 * k
                path = [(x * 0.075, y, 0.05), (x * 0.13, y * 1.4, 0.07), (x * 0.165, y * 1.9, 0.0)]
                b.tube(skin, bent(path), 0.006, segments=6)
    return ()


@prop("dinosaur")
def dinosaur(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tyrannosaur on its hind legs."""
    skin = spec.material("skin")
    with b.at(scale=scaled(spec)):
        sections = [
            (0, 3.2, 1.5, 0.06, 0.06), (0, 2.0, 1.75, 0.28, 0.3), (0, 0.9, 2.0, 0.62, 0.72), (0, -0.2, 2.15, 0.68, 0.8),
            (0, -1.0, 2.6, 0.42, 0.55), (0, -1.45, 3.1, 0.34, 0.42),
        ]  # fmt: skip
        limb(b, skin, sections, 20)
        rings = [
            (0, -1.3, 3.3, 0.3, 0.3),
            (0, -1.75, 3.35, 0.38, 0.36),
            (0, -2.3, 3.25, 0.28, 0.24),
            (0, -2.75, 3.18, 0.2, 0.16),
        ]
        limb(b, skin, rings, 16)
        limb(b, skin, [(0, -1.6, 3.0, 0.24, 0.12), (0, -2.2, 2.86, 0.2, 0.09), (0, -2.6, 2.8, 0.12, 0.06)], 12)
        for x in (-1, 1):
            b.sphere("brass", (x * 0.32, -1.9, 3.5), 0.07, segments=10, rings=6)
            b.sphere(DARK, (x * 0.36, -1.94, 3.5), 0.035, segments=8, rings=5)
            for k in range(6):
                foot = (x * 0.2, -1.95 - 0.13 * k, 3.08)
                b.cylinder(WHITE, foot, np.add(foot, (0, 0, -0.14)), 0.03, 0.004, segments=5)
            path = [(x * 0.4, -0.95, 2.35), (x * 0.46, -1.25, 2.1), (x * 0.42, -1.5, 2.2)]
            b.tube(skin, bent(path), 0.08, segments=8)
        for leg in both_sides(
            [
                (0.5, 0.35, 2.0, 0.34, 0.6),
                (0.55, 0.1, 1.4, 0.26, 0.4),
                (0.55, 0.5, 0.8, 0.14, 0.18),
                (0.55, 0.3, 0.2, 0.12, 0.14),
                (0.55, 0.25, 0.12, 0.12, 0.14),
            ]
        ):
            limb(b, skin, leg, 12)
            b.cushion(skin, (leg[-1][0], 0.05, 0.09), (0.42, 0.75, 0.18), softness=0.8)
    return ()
