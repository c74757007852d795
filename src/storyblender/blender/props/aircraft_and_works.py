"""Prop builders: aircraft, rocket, saucer, tractor, fire engine, locomotive and tank. Their front is -Y."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, boarding_place, handle, seat
from storyblender.blender.props.parts import bent, wheel
from storyblender.blender.props.registry import PropSpec, prop

DARK = "plastic_black"


def _fuselage(b: MeshBuilder, material: MaterialRef, stations: list[tuple[float, float, float, float]]) -> None:
    """Add a rounded fuselage; stations are (y, half width, half height, z of the centre) in metres."""
    turn = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    b.loft(material, [np.c_[w * np.sin(turn), np.full(24, y), z + h * np.cos(turn)] for y, w, h, z in stations])


def _blade(
    b: MeshBuilder,
    material: MaterialRef,
    at: tuple[float, float, float],
    end: tuple[float, float, float],
    chord: tuple[float, float],
    thick: float,
) -> None:
    """Add a flat wing whose leading edge runs from ``at`` to ``end``, chord along +Y."""
    rings = [
        [(x, y, z), (x, y + c * 0.4, z + thick), (x, y + c, z), (x, y + c * 0.4, z - thick)]
        for (x, y, z), c in ((at, chord[0]), (end, chord[1]))
    ]
    b.loft(material, [np.array(ring) for ring in rings])


@prop("helicopter")
def helicopter(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a helicopter with an open cabin, two seats, its rotor and skids."""
    body = spec.material("body")
    with b.at(scale=np.array(spec.size) / spec.entry.size):
        _fuselage(b, body, [
            (-0.6, 0.85, 0.5, 1.0), (0.3, 0.85, 0.85, 1.4), (1.2, 0.7, 0.75, 1.5), (2.0, 0.3, 0.34, 1.75),
            (5.4, 0.12, 0.14, 2.0),
        ])  # fmt: skip
        _fuselage(
            b, body, [(-1.9, 0.3, 0.14, 0.8), (-1.5, 0.7, 0.3, 0.84), (-0.6, 0.85, 0.42, 0.92), (0.0, 0.85, 0.42, 0.92)]
        )
        b.cushion(body, (0, 0.1, 2.15), (1.5, 2.2, 0.34), softness=0.5)
        for x in (-1, 1):
            b.tube(body, bent([(x * 0.62, -1.6, 0.95), (x * 0.7, -1.2, 1.6), (x * 0.6, -0.5, 2.1)]), 0.04)
            b.tube("steel", bent([(x * 0.95, -1.8, 0.22), (x * 0.95, -1.4, 0.05), (x * 0.95, 1.3, 0.05)]), 0.05)
            for y in (-0.7, 0.7):
                b.tube("steel", [(x * 0.55, y, 0.7), (x * 0.95, y, 0.06)], 0.035)
            b.cushion("leather_black", (x * 0.38, -0.5, 1.24), (0.5, 0.5, 0.14), softness=0.3)
            b.cushion("leather_black", (x * 0.38, -0.22, 1.6), (0.5, 0.12, 0.66), softness=0.3)
        b.box(DARK, (0, -1.35, 1.2), (1.1, 0.3, 0.3), bevel=0.05)
        b.cylinder("steel", (0, 0.2, 2.2), (0, 0.2, 2.75), 0.09)
        for turn in (25, 205):
            with b.at((0, 0.2, 2.72), (0, 0, turn)):
                b.box(DARK, (2.3, 0, 0), (4.5, 0.2, 0.03), bevel=0.01)
        b.extrude(body, [(0, 0), (0.1, 0), (0.1, 0.1), (0, 0.1)], 0.1, base=1.9)
        with b.at((0.16, 5.3, 2.0), (0, 90, 0)):
            b.lathe(DARK, [(0.62, 0.0), (0.62, 0.02)], segments=20)
        _blade(b, body, (0, 4.9, 2.1), (0, 5.4, 2.9), (0.6, 0.35), 0.03)
    seats = tuple(seat((x * 0.38, -0.74, 1.3), (0.5, 0.5), name=name) for x, name in ((1, "driver"), (-1, "passenger")))
    return (*seats, boarding_place(1.5, -0.5), boarding_place(-1.5, -0.5, "passenger"))


@prop("light_plane")
def light_plane(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a small aeroplane: high wing, one propeller."""
    body, trim = spec.material("body"), spec.material("trim")
    with b.at(scale=np.array(spec.size) / spec.entry.size):
        _fuselage(b, body, [(-2.7, 0.35, 0.38, 1.2), (-2.3, 0.52, 0.5, 1.2), (-1.2, 0.58, 0.58, 1.2)])
        _fuselage(
            b, body, [(-1.4, 0.56, 0.36, 1.0), (0.3, 0.58, 0.36, 1.0), (0.9, 0.5, 0.56, 1.25), (4.4, 0.1, 0.16, 1.5)]
        )
        for x in (-1, 1):
            _blade(b, body, (0, -1.2, 2.08), (x * 5.1, -1.0, 2.16), (1.5, 1.1), 0.08)
            _blade(b, body, (0, 3.7, 1.55), (x * 1.6, 3.9, 1.6), (0.9, 0.5), 0.03)
            b.tube(trim, [(x * 0.55, -0.4, 0.9), (x * 2.3, -0.5, 2.04)], 0.03)
            b.tube("steel", [(x * 0.5, -0.5, 0.75), (x * 1.05, -0.6, 0.32)], 0.04)
            wheel(b, "rubber", "steel", (x * 1.1, -0.6, 0.3), 0.3, 0.16)
            for y in (-1.2, 0.7):
                b.tube(body, [(x * 0.5, y, 1.2), (x * 0.42, y + 0.1 * (y < 0), 2.04)], 0.035)
            b.cushion("leather_black", (x * 0.25, -0.15, 1.16), (0.44, 0.46, 0.12), softness=0.3)
            b.cushion("leather_black", (x * 0.25, 0.12, 1.45), (0.44, 0.1, 0.6), softness=0.3)
        b.box(DARK, (0, -1.15, 1.42), (0.9, 0.3, 0.3), bevel=0.05)
        _blade(b, trim, (0, 3.6, 1.5), (0, 4.2, 2.6), (1.0, 0.5), 0.03)
        b.lathe(trim, [(0.2, 0), (0.16, 0.2), (0.02, 0.4)], origin=(0, -2.7, 1.2), axis=(0, -1, 0))
        b.box(DARK, (0, -2.82, 1.2), (1.9, 0.04, 0.16), bevel=0.015, rotation=(0, 35, 0))
        b.tube("steel", [(0, -2.2, 0.8), (0, -2.25, 0.25)], 0.04)
        wheel(b, "rubber", "steel", (0.0, -2.25, 0.25), 0.25, 0.12)
    return (
        seat((0.25, -0.38, 1.22), (0.44, 0.46), name="driver"),
        seat((-0.25, -0.38, 1.22), (0.44, 0.46), name="passenger"),
        boarding_place(1.5, -0.3),
        boarding_place(-1.5, -0.3, "passenger"),
    )


@prop("jet")
def jet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a jet airliner with swept wings and an engine under each."""
    body, trim = spec.material("body"), spec.material("trim")
    with b.at(scale=np.array(spec.size) / spec.entry.size):
        _fuselage(b, body, [
            (-16.5, 0.2, 0.2, 3.3), (-16, 0.8, 0.7, 3.4), (-14.5, 1.6, 1.5, 3.6), (-12, 1.95, 1.95, 3.7),
            (8, 1.95, 1.95, 3.7), (13, 1.1, 1.1, 4.3), (16.5, 0.25, 0.3, 4.8),
        ])  # fmt: skip
        for x in (-1, 1):
            _blade(b, body, (x * 1.2, -4.5, 2.7), (x * 16, 4.5, 4.0), (7.0, 1.8), 0.22)
            _blade(b, body, (x * 0.4, 13, 4.6), (x * 6, 16, 5.1), (3.2, 1.2), 0.1)
            profile = [(0.75, -2), (0.95, -0.6), (0.95, 1.0), (0.8, 1.6)]
            b.lathe(trim, profile, origin=(x * 5.2, -2.6, 1.75), axis=(0, -1, 0))
            b.lathe(DARK, [(0.72, 0), (0.72, 0.02)], origin=(x * 5.2, -4.22, 1.75), axis=(0, -1, 0))
            b.box(body, (x * 5.2, -1.4, 2.6), (0.2, 1.8, 0.7))
            for k in range(22):
                b.rounded_box("glass_dark", (x * 1.9, -11 + 0.95 * k, 4.1), (0.12, 0.34, 0.46), 0.05)
            b.box("glass_dark", (x * 0.55, -15.35, 4.3), (0.9, 0.1, 0.45), rotation=(-38, 0, x * 22))
            for y in (0.6, 1.8):
                wheel(b, "rubber", "steel", (x * 2.6, y, 0.55), 0.55, 0.36)
            b.cylinder("steel", (x * 2.6, 1.2, 0.6), (x * 2.4, 1.2, 2.4), 0.16)
        _blade(b, trim, (0, 11, 5.4), (0, 15, 10.4), (5.2, 2.2), 0.16)
        b.cylinder("steel", (0, -12.4, 0.5), (0, -12.4, 2.2), 0.14)
        wheel(b, "rubber", "steel", (0.12, -12.4, 0.45), 0.45, 0.3)
        b.rounded_box(trim, (1.93, -12.2, 3.5), (0.1, 0.9, 1.8), 0.04)
    return (handle((2.0, -12.2, 3.4), (1, 0, 0), "door"),)


@prop("rocket")
def rocket(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a rocket that stands on its fins."""
    body, trim = spec.material("body"), spec.material("trim")
    with b.at(scale=np.array(spec.size) / spec.entry.size):
        profile = bent([(0.7, 0.9), (1.15, 2.2), (1.3, 4.5), (1.1, 7.2), (0.6, 9.2), (0.02, 10.4)], 5)
        b.lathe(body, profile, segments=28)
        b.lathe(DARK, [(0.85, 0.35), (0.5, 0.95)], segments=22)
        for turn in range(0, 360, 90):
            with b.at((0, 0, 0), (0, 0, turn + 45)), b.at((1.0, 0.06, 0), (90, 0, 0)):
                b.extrude(trim, [(0, 1.2), (0.15, 3.6), (1.1, 1.6), (1.25, 0.0), (0.95, 0.0), (0.7, 0.9)], 0.12)
        b.lathe("chrome", [(0.5, 0), (0.5, 0.1), (0.4, 0.14)], origin=(0, -1.22, 6.2), axis=(0, -1, 0.1))
        b.lathe("glass_dark", [(0.38, 0.1), (0.36, 0.13)], origin=(0, -1.22, 6.2), axis=(0, -1, 0.1))
        b.rounded_box(trim, (0, -1.24, 3.4), (0.9, 0.12, 1.7), 0.04)
    return ()


@prop("flying_saucer")
def flying_saucer(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a flying saucer on three legs, with its dome and ring of lamps."""
    body = spec.material("body")
    with b.at(scale=np.array(spec.size) / spec.entry.size):
        profile = [(0.9, 1.1), (2.4, 1.35), (3.9, 1.9), (4.0, 2.0), (3.6, 2.15), (1.9, 2.6), (1.5, 2.65)]
        b.lathe(body, bent(profile, 4), segments=40)
        b.lathe("glass", bent([(1.5, 2.6), (1.4, 3.1), (0.9, 3.5), (0.02, 3.65)], 4), segments=32)
        for turn in range(0, 360, 30):
            x, y = 3.2 * np.sin(np.radians(turn)), 3.2 * np.cos(np.radians(turn))
            b.sphere("neon_blue", (x, y, 1.62), 0.2, segments=10, rings=6)
        for turn in (60, 180, 300):
            x, y = np.sin(np.radians(turn)), np.cos(np.radians(turn))
            b.cylinder("steel", (1.8 * x, 1.8 * y, 1.3), (2.5 * x, 2.5 * y, 0.1), 0.09)
            b.lathe("steel", [(0.35, 0), (0.2, 0.12)], origin=(2.5 * x, 2.5 * y, 0))
    return ()


@prop("tractor")
def tractor(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a farm tractor with an open seat."""
    body = spec.material("body")
    with b.at(scale=np.array(spec.size) / spec.entry.size):
        b.rounded_box(body, (0, -0.75, 1.15), (0.62, 1.7, 0.62), 0.1)
        b.box(DARK, (0, -0.4, 0.72), (0.5, 2.2, 0.34), bevel=0.04)
        for k in range(5):
            b.box(DARK, (0, -1.61, 0.96 + 0.1 * k), (0.46, 0.03, 0.04))
        b.cylinder(DARK, (0.2, -1.0, 1.4), (0.2, -1.0, 2.15), 0.05)
        for x in (-1, 1):
            wheel(b, "rubber", "brass", (x * 0.72, 0.75, 0.72), 0.72, 0.42)
            wheel(b, "rubber", "brass", (x * 0.6, -1.3, 0.42), 0.42, 0.26)
            arch = [(x * 0.72, 0.75 + 0.85 * np.cos(t), 0.72 + 0.85 * np.sin(t)) for t in np.linspace(0.2, 2.4, 9)]
            for (x0, y0, z0), (_, y1, z1) in pairwise(arch):
                middle = (x0, (y0 + y1) / 2, (z0 + z1) / 2)
                angle = np.degrees(np.arctan2(z1 - z0, y1 - y0))
                b.box(body, middle, (0.46, 0.28, 0.04), rotation=(angle, 0, 0))
            b.lathe(spec.material("lamp"), [(0.1, 0), (0.09, 0.06)], origin=(x * 0.22, -1.6, 1.3), axis=(0, -1, 0))
        b.cushion(DARK, (0, 0.45, 1.2), (0.5, 0.46, 0.12), softness=0.3)
        b.cushion(DARK, (0, 0.68, 1.42), (0.48, 0.1, 0.4), softness=0.3)
        turn = np.linspace(0, 2 * np.pi, 20)[:-1]
        path = np.array((0, 0.02, 1.58)) + 0.2 * np.c_[np.cos(turn), 0.8 * np.sin(turn), 0.5 * np.sin(turn)]
        b.tube(DARK, path, 0.015, segments=6, closed=True)
        b.cylinder(DARK, (0, 0.02, 1.58), (0, -0.1, 1.2), 0.025)
    return (seat((0, 0.22, 1.26), (0.5, 0.46), name="driver"), boarding_place(1.4, 0.1))


@prop("fire_engine")
def fire_engine(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fire engine: open cab, lockers, a ladder on its roof and blue lamps."""
    (w, d, h), paint, chrome = spec.size, spec.material("body"), spec.material("chrome")
    half, f, r = w / 2, -d / 2, d / 2
    body, belt, floor, sit = h - 0.35, 1.5, 0.62, 1.06
    b.box(paint, (0, f + 1.2, (0.5 + floor) / 2), (w, 2.4, floor - 0.4), bevel=0.03)
    for x in (-1, 1):
        b.box(paint, (x * (half - 0.04), f + 1.2, (0.5 + belt) / 2), (0.08, 2.4, belt - 0.5), bevel=0.02)
        for y in (f + 0.08, f + 1.25):
            b.box(paint, (x * (half - 0.05), y, (belt + body) / 2), (0.09, 0.1, body - belt))
        b.rounded_box("neon_blue", (x * 0.6, f + 0.6, body + 0.12), (0.6, 0.3, 0.18), 0.06)
        b.rounded_box(spec.material("lamp"), (x * half * 0.7, f - 0.02, 0.85), (0.36, 0.1, 0.22), 0.04)
        for k in range(3):
            b.box(chrome, (x * (half + 0.002), f + 3.2 + 1.35 * k, 1.45), (0.02, 1.2, 1.3), bevel=0.01)
        b.box("wax", (x * (half + 0.006), (f + r) / 2, 0.68), (0.014, d - 0.2, 0.14))
        for y in (f + 1.25, r - 1.6):
            b.cylinder(DARK, (x * (half - 0.3), y, 0.5), (x * (half + 0.006), y, 0.5), 0.56, segments=26)
            wheel(b, "rubber", chrome, (x * (half - 0.12), y, 0.48), 0.48, 0.28)
        b.tube(chrome, [(x * 0.3, f + 1.2, h - 0.05), (x * 0.3, r, h - 0.05)], 0.05)
        b.cushion(DARK, (x * half * 0.5, f + 1.5, sit - 0.06), (0.6, 0.5, 0.14), softness=0.3)
        b.cushion(DARK, (x * half * 0.5, f + 1.8, sit + 0.32), (0.6, 0.12, 0.66), softness=0.3)
    for k in range(int((d - 1.3) / 0.35)):
        b.cylinder(chrome, (-0.3, f + 1.3 + 0.35 * k, h - 0.05), (0.3, f + 1.3 + 0.35 * k, h - 0.05), 0.025, segments=8)
    b.rounded_box(paint, (0, f + 0.06, 1.0), (w, 0.12, 1.0), 0.05)
    b.rounded_box(paint, (0, f + 1.2, body), (w, 2.4, 0.16), 0.06)
    b.rounded_box(paint, (0, (f + 2.4 + r) / 2, (0.5 + body) / 2), (w, r - f - 2.4, body - 0.5), 0.06)
    b.rounded_box(chrome, (0, f - 0.08, 0.55), (w, 0.16, 0.24), 0.05)
    b.box(DARK, (0, f + 0.3, belt - 0.12), (w - 0.2, 0.34, 0.24), bevel=0.05)
    return (
        seat((half * 0.5, f + 1.26, sit), (0.6, 0.5), name="driver"),
        seat((-half * 0.5, f + 1.26, sit), (0.6, 0.5), name="passenger"),
        boarding_place(half + 0.55, f + 1.3),
        boarding_place(-half - 0.55, f + 1.3, "passenger"),
    )


@prop("locomotive")
def locomotive(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a steam engine with its cab."""
    body, trim = spec.material("body"), spec.material("trim")
    with b.at(scale=np.array(spec.size) / spec.entry.size):
        b.box(DARK, (0, 0, 1.15), (2.3, 9.0, 0.3), bevel=0.03)
        b.lathe(body, [(0.85, 0), (0.92, 0.1), (0.92, 5.6)], origin=(0, 1.4, 2.3), axis=(0, -1, 0), segments=32)
        profile = [(0.96, 0), (0.96, 0.7), (0.8, 0.76), (0.2, 0.84)]
        b.lathe(DARK, profile, origin=(0, -3.6, 2.3), axis=(0, -1, 0), segments=32)
        for y in (-2.6, -0.9, 0.6):
            b.lathe(trim, [(0.94, 0), (0.94, 0.1)], origin=(0, y, 2.3), axis=(0, -1, 0), segments=32, caps=False)
        b.lathe(DARK, bent([(0.26, 0), (0.22, 0.5), (0.34, 0.95), (0.36, 1.0)]), origin=(0, -3.9, 3.1))
        b.lathe(trim, bent([(0.4, 0), (0.4, 0.3), (0.1, 0.55)]), origin=(0, -1.6, 3.1))
        for x in (-1, 1):
            b.box(body, (x * 1.1, 2.5, 1.9), (0.1, 2.0, 1.3))
            for y in (1.55, 3.45):
                b.box(body, (x * 1.1, y, 3.0), (0.1, 0.12, 1.0))
            for y in (-1.8, -0.1, 1.6):
                b.lathe(
                    trim,
                    [(0.78, -0.08), (0.78, 0.08), (0.62, 0.09), (0.6, 0.03), (0.14, 0.03), (0.14, 0.12), (0.02, 0.13)],
                    origin=(x * 1.05, y, 0.78),
                    axis=(x, 0, 0),
                    segments=28,
                )
            for y in (-4.0, -3.1, 3.4):
                wheel(b, DARK, trim, (x * 1.0, y, 0.45), 0.45, 0.16)
            b.box("steel", (x * 1.2, -0.1, 0.72), (0.08, 3.6, 0.14), bevel=0.02)
            b.rounded_box(DARK, (x * 1.0, -3.2, 0.95), (0.5, 0.9, 0.5), 0.1)
        b.box(body, (0, 1.5, 2.3), (2.2, 0.1, 2.2))
        b.rounded_box(DARK, (0, 2.6, 3.62), (2.5, 2.6, 0.16), 0.06)
        b.rounded_box(body, (0, 4.1, 1.9), (2.2, 0.9, 1.2), 0.05)
        with b.at((0, -4.4, 0.2)):
            rings = [
                np.array([(-1.1, 0, 0), (1.1, 0, 0), (0, -0.8, 0)]),
                np.array([(-0.9, 0, 0.7), (0.9, 0, 0.7), (0, -0.2, 0.7)]),
            ]
            b.loft(trim, rings)
        b.lathe(spec.material("lamp"), [(0.2, 0), (0.18, 0.1)], origin=(0, -4.45, 3.0), axis=(0, -1, 0))
    return (boarding_place(1.7, 2.5),)


@prop("battle_tank")
def battle_tank(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tank on its tracks, with a turret and a gun."""
    body = spec.material("body")
    with b.at(scale=np.array(spec.size) / spec.entry.size):
        rows = [
            np.array([(-1.1, y, 0.5), (1.1, y, 0.5), (1.3, y, top), (-1.3, y, top)])
            for y, top in ((-2.9, 0.9), (-2.2, 1.45), (2.6, 1.45), (2.9, 1.2))
        ]
        b.loft(body, rows)
        for x in (-1, 1):
            outline = [(-2.6, 0.3), (-2.9, 0.75), (-2.5, 1.1), (2.5, 1.1), (2.85, 0.7), (2.3, 0.0), (-2.1, 0.0)]
            with b.at((x * 1.35 - 0.25, 0, 0), (90, 0, 90)):
                b.extrude(DARK, outline, 0.5)
            for k in range(6):
                b.lathe("steel", [(0.3, 0), (0.28, 0.06)], origin=(x * 1.6, -1.9 + 0.76 * k, 0.36), axis=(x, 0, 0))
        rings = [
            np.array([(-a, -1.2 * s, z), (a, -1.2 * s, z), (a, 1.2 * s, z), (-a, 1.2 * s, z)])
            for a, s, z in ((0.95, 1.0, 1.42), (1.05, 1.1, 1.75), (0.75, 0.8, 2.15))
        ]
        b.loft(body, rings)
        b.cylinder(body, (0, -1.1, 1.82), (0, -4.6, 1.95), 0.11, 0.09)
        b.cylinder(body, (0, -4.4, 1.94), (0, -4.8, 1.96), 0.15)
        b.lathe(body, [(0.34, 0), (0.3, 0.14)], origin=(0.3, 0.3, 2.12))
    return ()
