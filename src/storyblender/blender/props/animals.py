"""Prop builders: animals as standing shapes with clear outlines. They look to -Y."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, grips_around, grips_under, seat
from storyblender.blender.props.asleep import curled_cat
from storyblender.blender.props.registry import PropSpec, prop

Station = tuple[float, float, float, float, float]
"""One ellipse of a limb: x, y, z of its centre, half width along X, half height across the limb; metres."""


def limb(b: MeshBuilder, material: MaterialRef, stations: Sequence[Station], segments: int = 14) -> None:
    """Add a part of an animal's body, lofted over ellipses along a path in a YZ plane.

    Args:
        b: Receives the part.
        material: Coat or skin.
        stations: The ellipses, from one end to the other; at least two.
        segments: Points around each ellipse.
    """
    path = np.array([station[:3] for station in stations])
    along = np.gradient(path, axis=0)
    along = along / np.linalg.norm(along, axis=1, keepdims=True)
    angle = np.linspace(0, 2 * np.pi, segments, endpoint=False)
    rings = []
    for (x, y, z, wide, tall), direction in zip(stations, along, strict=True):
        up = np.cross(direction, (1.0, 0.0, 0.0))
        up = up / np.linalg.norm(up)
        rings.append(
            np.array([x, y, z]) + np.outer(wide * np.cos(angle), (1, 0, 0)) + np.outer(tall * np.sin(angle), up)
        )
    b.loft(material, rings)


def both_sides(stations: Sequence[Station]) -> list[list[Station]]:
    """Return the stations of a limb given at +X, mirrored to -X and as given."""
    return [[(side * x, y, z, w, t) for x, y, z, w, t in stations] for side in (-1, 1)]


@prop("dog")
def dog(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a shepherd dog."""
    coat, nose = spec.material("coat"), spec.material("nose")
    scale = np.array(spec.size) / (0.26, 0.95, 0.68)
    with b.at(scale=scale):
        limb(b, coat, [
            (0, -0.26, 0.42, 0.05, 0.07), (0, -0.22, 0.42, 0.1, 0.13), (0, -0.1, 0.41, 0.115, 0.14),
            (0, 0.08, 0.42, 0.1, 0.12), (0, 0.22, 0.43, 0.1, 0.12), (0, 0.3, 0.43, 0.04, 0.06),
        ])  # fmt: skip
        limb(b, coat, [(0, -0.18, 0.44, 0.09, 0.11), (0, -0.26, 0.53, 0.07, 0.085), (0, -0.31, 0.6, 0.065, 0.075)])
        sections = [
            (0, -0.25, 0.6, 0.03, 0.03), (0, -0.29, 0.605, 0.07, 0.07), (0, -0.35, 0.59, 0.065, 0.062),
            (0, -0.4, 0.565, 0.038, 0.04), (0, -0.46, 0.555, 0.032, 0.032), (0, -0.49, 0.553, 0.018, 0.018),
        ]  # fmt: skip
        limb(b, coat, sections)
        b.sphere(nose, (0, -0.492, 0.562), 0.018, segments=10, rings=6)
        for x in (-1, 1):
            b.cushion(coat, (x * 0.045, -0.28, 0.68), (0.045, 0.025, 0.1), softness=0.9, rotation=(0, x * 10, 0))
            b.sphere(nose, (x * 0.04, -0.385, 0.607), 0.009, segments=8, rings=5)
        for front in both_sides(
            [
                (0.07, -0.2, 0.42, 0.045, 0.06),
                (0.075, -0.19, 0.3, 0.034, 0.04),
                (0.075, -0.19, 0.16, 0.024, 0.026),
                (0.075, -0.2, 0.04, 0.024, 0.026),
                (0.075, -0.2, 0.03, 0.024, 0.024),
            ]
        ):
            limb(b, coat, front, 10)
        for hind in both_sides(
            [
                (0.07, 0.22, 0.44, 0.055, 0.1),
                (0.078, 0.2, 0.3, 0.045, 0.07),
                (0.078, 0.28, 0.18, 0.024, 0.03),
                (0.078, 0.27, 0.06, 0.022, 0.024),
                (0.078, 0.26, 0.03, 0.022, 0.022),
            ]
        ):
            limb(b, coat, hind, 10)
        for x in (-1, 1):
            for y in (-0.215, 0.245):
                b.cushion(coat, (x * 0.077, y, 0.02), (0.055, 0.09, 0.04), softness=0.8)
        rings = [
            (0, 0.27, 0.46, 0.03, 0.03),
            (0, 0.36, 0.4, 0.03, 0.035),
            (0, 0.4, 0.28, 0.03, 0.035),
            (0, 0.44, 0.2, 0.01, 0.012),
        ]
        limb(b, coat, rings, 10)
    return ()


@prop("cat")
def cat(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sitting cat, or one curled up ``asleep``."""
    coat, nose = spec.material("coat"), spec.material("nose")
    if spec.flag("asleep"):
        curled_cat(b, coat, nose)
        return ()
    scale = np.array(spec.size) / (0.2, 0.5, 0.42)
    with b.at(scale=scale):
        sections = [
            (0, 0.12, 0.03, 0.06, 0.06), (0, 0.1, 0.08, 0.09, 0.1), (0, 0.05, 0.16, 0.085, 0.095),
            (0, 0.0, 0.24, 0.065, 0.065), (0, -0.025, 0.3, 0.045, 0.045),
        ]  # fmt: skip
        limb(b, coat, sections)
        b.sphere(coat, (0, -0.04, 0.34), 0.062, scale=(1, 0.92, 0.88), segments=16, rings=10)
        b.sphere(coat, (0, -0.09, 0.325), 0.028, scale=(1.1, 0.9, 0.8), segments=12, rings=8)
        b.sphere(nose, (0, -0.114, 0.333), 0.008, segments=8, rings=5)
        for x in (-1, 1):
            rows = [
                np.multiply(
                    [(0.015, -0.05, 0.38), (0.058, -0.05, 0.37), (0.045, -0.02, 0.37), (0.02, -0.02, 0.38)], (x, 1, 1)
                ),
                [
                    (x * 0.043, -0.042, 0.425),
                    (x * 0.046, -0.042, 0.424),
                    (x * 0.045, -0.038, 0.424),
                    (x * 0.043, -0.038, 0.425),
                ],
            ]
            b.loft(coat, rows)
            b.sphere(nose, (x * 0.026, -0.094, 0.352), 0.008, segments=8, rings=5)
            b.cushion(coat, (x * 0.075, 0.06, 0.07), (0.07, 0.16, 0.13), softness=0.9)
            b.cushion(coat, (x * 0.075, -0.03, 0.018), (0.045, 0.11, 0.036), softness=0.8)
        for front in both_sides(
            [
                (0.035, -0.02, 0.2, 0.028, 0.03),
                (0.035, -0.05, 0.1, 0.02, 0.022),
                (0.035, -0.055, 0.02, 0.02, 0.024),
                (0.035, -0.056, 0.01, 0.02, 0.024),
            ]
        ):
            limb(b, coat, front, 10)
        rings = [
            (0, 0.16, 0.05, 0.025, 0.025),
            (0.04, 0.26, 0.03, 0.024, 0.024),
            (0.08, 0.34, 0.03, 0.022, 0.022),
            (0.1, 0.38, 0.06, 0.012, 0.012),
        ]
        limb(b, coat, rings, 10)
    return ()


@prop("horse")
def horse(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing horse, with a place to sit."""
    coat, mane, hoof = spec.material("coat"), spec.material("mane"), spec.material("hoof")
    scale = np.array(spec.size) / (0.6, 2.3, 2.15)
    with b.at(scale=scale):
        limb(b, coat, [
            (0, -0.72, 1.16, 0.1, 0.16), (0, -0.62, 1.14, 0.22, 0.29), (0, -0.35, 1.12, 0.27, 0.31),
            (0, 0.05, 1.1, 0.29, 0.31), (0, 0.4, 1.16, 0.28, 0.29), (0, 0.68, 1.17, 0.24, 0.25),
            (0, 0.84, 1.14, 0.1, 0.14),
        ], 18)  # fmt: skip
        limb(
            b,
            coat,
            [
                (0, -0.48, 1.22, 0.16, 0.28),
                (0, -0.72, 1.48, 0.12, 0.2),
                (0, -0.9, 1.76, 0.095, 0.14),
                (0, -0.98, 1.93, 0.085, 0.11),
            ],
            16,
        )
        sections = [
            (0, -0.88, 1.98, 0.04, 0.05), (0, -0.95, 1.95, 0.095, 0.12), (0, -1.08, 1.84, 0.09, 0.11),
            (0, -1.25, 1.66, 0.065, 0.075), (0, -1.36, 1.55, 0.06, 0.065), (0, -1.4, 1.51, 0.035, 0.04),
        ]  # fmt: skip
        limb(b, coat, sections, 14)
        for k in range(9):
            t = k / 8
            b.cushion(mane, (0, -0.5 - 0.42 * t, 1.5 + 0.52 * t), (0.05, 0.14, 0.2), softness=0.8, rotation=(35, 0, 0))
        for x in (-1, 1):
            b.cushion(coat, (x * 0.055, -0.93, 2.08), (0.05, 0.035, 0.15), softness=0.9, rotation=(-10, x * 12, 0))
            b.sphere(hoof, (x * 0.083, -1.04, 1.9), 0.022, segments=8, rings=5)
            b.sphere(hoof, (x * 0.035, -1.385, 1.56), 0.014, segments=8, rings=5)
        front = [
            (0.16, -0.54, 1.02, 0.1, 0.16), (0.16, -0.54, 0.78, 0.075, 0.1), (0.16, -0.55, 0.55, 0.06, 0.065),
            (0.16, -0.55, 0.3, 0.042, 0.045), (0.16, -0.56, 0.14, 0.048, 0.052), (0.16, -0.58, 0.08, 0.05, 0.055),
        ]  # fmt: skip
        hind = [
            (0.16, 0.62, 1.1, 0.13, 0.24), (0.17, 0.58, 0.82, 0.1, 0.16), (0.17, 0.72, 0.58, 0.06, 0.075),
            (0.17, 0.72, 0.32, 0.045, 0.05), (0.17, 0.69, 0.14, 0.05, 0.055), (0.17, 0.67, 0.08, 0.052, 0.058),
        ]  # fmt: skip
        for leg in (*both_sides(front), *both_sides(hind)):
            limb(b, coat, leg, 12)
            x, y = leg[-1][0], leg[-1][1]
            b.lathe(hoof, [(0.075, 0), (0.055, 0.1)], origin=(x, y - 0.015, 0), segments=14)
        rings = [
            (0, 0.8, 1.24, 0.04, 0.04),
            (0, 0.94, 1.16, 0.06, 0.06),
            (0, 0.98, 0.85, 0.07, 0.075),
            (0, 0.96, 0.55, 0.03, 0.03),
        ]
        limb(b, mane, rings, 10)
    return (seat((0.0, float(-0.25 * scale[1]), float(1.42 * scale[2])), (0.4, 0.4)),)


@prop("cow")
def cow(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing cow."""
    coat, patch, horn = spec.material("coat"), spec.material("patch"), spec.material("horn")
    scale = np.array(spec.size) / (0.75, 2.3, 1.5)
    with b.at(scale=scale):
        sections = [
            (0, -0.68, 0.98, 0.12, 0.2), (0, -0.55, 0.95, 0.27, 0.36), (0, -0.1, 0.9, 0.36, 0.4),
            (0, 0.4, 0.93, 0.33, 0.37), (0, 0.72, 1.0, 0.28, 0.3), (0, 0.86, 1.02, 0.12, 0.2),
        ]  # fmt: skip
        limb(b, coat, sections, 18)
        limb(b, coat, [(0, -0.5, 1.06, 0.2, 0.28), (0, -0.75, 1.16, 0.15, 0.2), (0, -0.92, 1.24, 0.13, 0.16)], 16)
        rings = [
            (0, -0.82, 1.34, 0.06, 0.06), (0, -0.9, 1.3, 0.14, 0.14), (0, -1.02, 1.18, 0.12, 0.13),
            (0, -1.16, 1.03, 0.1, 0.1), (0, -1.22, 0.97, 0.06, 0.07),
        ]  # fmt: skip
        limb(b, coat, rings, 14)
        b.cushion(patch, (0, -1.17, 1.0), (0.2, 0.14, 0.16), softness=0.8)
        for x in (-1, 1):
            b.cushion(coat, (x * 0.22, -0.88, 1.32), (0.2, 0.05, 0.1), softness=0.9, rotation=(0, x * 15, 0))
            path = [(x * 0.1, -0.88, 1.4), (x * 0.2, -0.9, 1.46), (x * 0.22, -0.94, 1.54)]
            b.tube(horn, path, (0.03, 0.024, 0.006), segments=8)
            b.sphere("plastic_black", (x * 0.12, -0.99, 1.28), 0.022, segments=8, rings=5)
            b.sphere(patch, (x * 0.2, 0.2, 0.98), 0.24, scale=(0.72, 1.2, 0.9), segments=16, rings=10)
        front = [
            (0.2, -0.5, 0.8, 0.12, 0.16),
            (0.2, -0.5, 0.5, 0.075, 0.085),
            (0.2, -0.5, 0.25, 0.055, 0.058),
            (0.2, -0.52, 0.07, 0.06, 0.065),
        ]
        hind = [
            (0.2, 0.64, 0.9, 0.14, 0.24),
            (0.2, 0.64, 0.6, 0.09, 0.12),
            (0.2, 0.72, 0.4, 0.058, 0.065),
            (0.2, 0.68, 0.07, 0.06, 0.065),
        ]
        for leg in (*both_sides(front), *both_sides(hind)):
            limb(b, coat, leg, 12)
            b.lathe("iron", [(0.08, 0), (0.06, 0.08)], origin=(leg[-1][0], leg[-1][1] - 0.01, 0), segments=14)
        b.sphere(patch, (0, 0.5, 0.58), 0.16, segments=14, rings=9)
        b.tube(coat, [(0, 0.86, 1.16), (0, 0.97, 1.0), (0, 0.98, 0.6)], (0.03, 0.022, 0.018), segments=8)
        b.cushion("plastic_black", (0, 0.98, 0.5), (0.07, 0.07, 0.2), softness=0.9)
    return ()


@prop("bird")
def bird(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing bird."""
    coat, beak = spec.material("coat"), spec.material("beak")
    scale = np.array(spec.size) / (0.14, 0.34, 0.26)
    with b.at(scale=scale):
        rings = [
            (0, 0.17, 0.1, 0.025, 0.006), (0, 0.1, 0.115, 0.03, 0.018), (0, 0.05, 0.13, 0.05, 0.045),
            (0, -0.02, 0.145, 0.058, 0.055), (0, -0.07, 0.17, 0.045, 0.048), (0, -0.1, 0.2, 0.03, 0.032),
        ]  # fmt: skip
        limb(b, coat, rings)
        b.sphere(coat, (0, -0.105, 0.222), 0.035, segments=14, rings=9)
        b.cylinder(beak, (0, -0.13, 0.22), (0, -0.17, 0.212), 0.011, 0.001, segments=8)
        for x in (-1, 1):
            b.sphere("plastic_black", (x * 0.026, -0.122, 0.23), 0.006, segments=8, rings=5)
            b.cushion(coat, (x * 0.055, 0.04, 0.145), (0.022, 0.2, 0.075), softness=0.9, rotation=(14, 0, 0))
            path = [(x * 0.022, 0.0, 0.1), (x * 0.024, 0.005, 0.05), (x * 0.024, -0.005, 0.006)]
            b.tube(beak, path, 0.004, segments=6)
            for turn in (-0.5, 0.0, 0.5):
                end = (x * 0.024 + 0.03 * np.sin(turn), -0.005 - 0.03 * np.cos(turn), 0.003)
                b.cylinder(beak, (x * 0.024, -0.005, 0.005), end, 0.003, segments=5)
    return grips_around(0.05, 0.13, (0.4, 0.45, 0.3))


@prop("fish")
def fish(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fish."""
    skin, eye = spec.material("skin"), spec.material("eye")
    scale = np.array(spec.size) / (0.1, 0.5, 0.2)
    with b.at(scale=scale):
        rings = [
            (0, -0.25, 0.09, 0.006, 0.008), (0, -0.22, 0.09, 0.025, 0.035), (0, -0.14, 0.092, 0.042, 0.065),
            (0, -0.02, 0.095, 0.045, 0.075), (0, 0.1, 0.095, 0.03, 0.045), (0, 0.18, 0.095, 0.012, 0.02),
        ]  # fmt: skip
        limb(b, skin, rings)
        for points in (
            [(0.16, 0.095), (0.26, 0.18), (0.235, 0.095), (0.26, 0.01)],
            [(-0.06, 0.16), (0.03, 0.2), (0.09, 0.14)],
            [(0.02, 0.03), (0.08, 0.0), (0.08, 0.05)],
        ):
            with b.at((-0.003, 0, 0), (90, 0, 90)):
                b.extrude(skin, points, 0.006)
        for x in (-1, 1):
            b.sphere(eye, (x * 0.028, -0.2, 0.105), 0.009, segments=8, rings=5)
    return grips_under(0.05, (0.4, 0.45, 0.3))
