"""Prop builders: household appliances, food, a glass case and a house. Their front is -Y."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, grips_around, grips_under, two_hands
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop

DARK = "plastic_black"


@prop("washing_machine")
def washing_machine(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a washing machine; its door may be ``open``."""
    (w, d, h), body = spec.size, spec.material("body")
    b.rounded_box(body, (0, 0, h / 2), (w, d, h), 0.02)
    profile = [(0.21, 0), (0.21, 0.02), (0.17, 0.03)]
    b.lathe("chrome", profile, origin=(0, -d / 2, h * 0.45), axis=(0, -1, 0), segments=28)
    glass = (-0.2, -d / 2 - 0.17, h * 0.45) if spec.flag("open") else (0, -d / 2 - 0.028, h * 0.45)
    profile = [(0.17, 0), (0.14, 0.02)]
    b.lathe("glass_dark", profile, origin=glass, axis=(-1, -0.2, 0) if spec.flag("open") else (0, -1, 0), segments=28)
    b.box(DARK, (0.12, -d / 2 - 0.004, h * 0.9), (0.26, 0.01, 0.07))
    b.lathe("chrome", [(0.03, 0), (0.026, 0.03)], origin=(-0.16, -d / 2, h * 0.9), axis=(0, -1, 0))
    return ()


@prop("microwave")
def microwave(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a microwave oven."""
    w, d, h = spec.size
    b.rounded_box(spec.material("body"), (0, 0, h / 2), (w, d, h), 0.015)
    b.rounded_box("glass_dark", (-w * 0.12, -d / 2, h / 2), (w * 0.62, 0.02, h * 0.74), 0.01)
    b.box(DARK, (w * 0.36, -d / 2 - 0.003, h / 2), (w * 0.2, 0.01, h * 0.74))
    b.box("lamp_cool", (w * 0.36, -d / 2 - 0.01, h * 0.74), (w * 0.15, 0.004, h * 0.1))
    return ()


@prop("toaster")
def toaster(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a toaster with two slices."""
    w, d, h = spec.size
    b.rounded_box(spec.material("body"), (0, 0, h * 0.42), (w, d, h * 0.8), 0.03)
    for y in (-0.035, 0.035):
        b.box(DARK, (0, y, h * 0.82), (w * 0.7, 0.028, 0.008))
        b.rounded_box("wood_light", (0, y, h * 0.85), (w * 0.5, 0.016, h * 0.3), 0.006)
    b.box(DARK, (w * 0.52, 0, h * 0.5), (0.02, 0.04, 0.03), bevel=0.005)
    return ()


@prop("coffee_machine")
def coffee_machine(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a coffee machine with its spout, handles and a cup."""
    w, d, h = spec.size
    b.rounded_box(spec.material("body"), (0, d * 0.2, h / 2), (w, d * 0.6, h), 0.02)
    b.rounded_box(spec.material("body"), (0, -d * 0.2, h * 0.82), (w, d * 0.6, h * 0.34), 0.02)
    b.box("steel", (0, -d * 0.22, 0.02), (w, d * 0.56, 0.04), bevel=0.008)
    for x in (-0.22, 0.22):
        b.cylinder("chrome", (x * w, -d * 0.25, h * 0.65), (x * w, -d * 0.25, h * 0.55), 0.025)
        b.cylinder(DARK, (x * w, -d * 0.28, h * 0.58), (x * w, -d * 0.62, h * 0.56), 0.013)
        b.lathe("porcelain", [(0.02, 0), (0.034, 0.06)], origin=(x * w, -d * 0.25, 0.04))
    return ()


@prop("vacuum_cleaner")
def vacuum_cleaner(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an upright vacuum cleaner."""
    body = spec.material("body")
    b.rounded_box(body, (0, -0.06, 0.06), (0.32, 0.26, 0.12), 0.04)
    b.cushion(body, (0, 0.06, 0.4), (0.2, 0.16, 0.62), softness=0.5, rotation=(-8, 0, 0))
    b.tube("steel", bent([(0, 0.1, 0.65), (0, 0.14, 1.0), (0, 0.1, 1.12)]), 0.014, segments=8)
    b.cylinder(DARK, (0, 0.14, 0.98), (0, 0.1, 1.12), 0.018)
    return two_hands((-0.018, 0.12, 1.05), (0.25, -1, 0), (1, 0.2, 0), (0.85, 0.85, 0.6))


@prop("clothes_iron")
def clothes_iron(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an iron."""
    sole = [(0, -0.13), (0.05, -0.05), (0.055, 0.11), (-0.055, 0.11), (-0.05, -0.05)]
    b.extrude("steel", sole, 0.012)
    b.extrude(spec.material("body"), sole, 0.05, base=0.012, taper=0.7)
    b.tube(DARK, bent([(0, -0.05, 0.06), (0, -0.04, 0.12), (0, 0.07, 0.125), (0, 0.08, 0.06)]), 0.013, segments=8)
    return two_hands((0.0, 0.02, 0.135), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0), (0.8, 0.8, 0.5))


@prop("kitchen_timer")
def kitchen_timer(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wind-up kitchen timer."""
    b.lathe(spec.material("body"), bent([(0.028, 0), (0.04, 0.02), (0.036, 0.045), (0.02, 0.062)]), segments=26)
    b.lathe("porcelain", [(0.032, 0), (0.03, 0.006)], origin=(0, -0.034, 0.034), axis=(0, -1, 0.15), segments=24)
    b.box("fabric_red", (0.004, -0.043, 0.042), (0.004, 0.003, 0.018), rotation=(0, 25, 0))
    for k in range(12):
        turn = np.pi * k / 6
        b.box(DARK, (0.026 * np.sin(turn), -0.041, 0.034 + 0.026 * np.cos(turn)), (0.003, 0.003, 0.003))
    return grips_around(0.035, 0.035, (0.5, 0.5, 0.4))


@prop("hourglass")
def hourglass(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an hourglass."""
    wood = spec.material("wood")
    for z in (0.0, 0.2):
        b.lathe(wood, [(0.055, 0), (0.055, 0.018)], origin=(0, 0, z), segments=24)
    for turn in (0.5, 2.6, 4.7):
        start = (0.045 * np.cos(turn), 0.045 * np.sin(turn), 0.01)
        b.cylinder(wood, start, (0.045 * np.cos(turn), 0.045 * np.sin(turn), 0.205), 0.006)
    b.lathe("glass", bent([(0.036, 0.02), (0.034, 0.07), (0.005, 0.109), (0.034, 0.15), (0.036, 0.2)], 4), segments=22)
    b.lathe("sand", [(0.037, 0.02), (0.036, 0.05), (0.002, 0.07)], segments=22)
    return grips_around(0.045, 0.11, (0.5, 0.5, 0.4))


@prop("glass_case")
def glass_case(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a display case on a base; its panes are left out so that the contents are visible."""
    (w, d, h), wood = spec.size, spec.material("frame")
    foot = h * 0.62
    b.box(wood, (0, 0, foot / 2), (w, d, foot), bevel=0.015)
    b.box(spec.material("cloth"), (0, 0, foot + 0.006), (w - 0.06, d - 0.06, 0.012))
    for x in (-1, 1):
        for y in (-1, 1):
            b.box("brass", (x * (w / 2 - 0.015), y * (d / 2 - 0.015), (foot + h) / 2), (0.025, 0.025, h - foot))
        b.box("brass", (x * (w / 2 - 0.015), 0, h - 0.012), (0.025, d, 0.024))
    for y in (-1, 1):
        b.box("brass", (0, y * (d / 2 - 0.015), h - 0.012), (w, 0.025, 0.024))
    return ()


@prop("sandwich")
def sandwich(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sandwich cut in half."""
    for x, turn in ((-0.035, 4.0), (0.035, 176.0)):
        with b.at((x, 0, 0), (0, 0, turn)):
            half = [(-0.05, -0.055), (0.05, -0.055), (0.05, 0.055)]
            for skin, base, thick in (
                ("linen", 0.0, 0.014),
                ("leaves", 0.014, 0.005),
                ("clay", 0.019, 0.006),
                ("brass", 0.025, 0.004),
                ("linen", 0.029, 0.014),
            ):
                b.extrude(skin, half, thick, base=base)
    return grips_under(0.05)


@prop("burger")
def burger(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a hamburger."""
    bun = spec.material("bun")
    b.lathe(bun, bent([(0.04, 0), (0.055, 0.008), (0.055, 0.018)]), segments=26)
    b.lathe("leaves", [(0.06, 0.018), (0.058, 0.024)], segments=14)
    b.lathe("leather", [(0.056, 0.024), (0.056, 0.04)], segments=26)
    b.box("brass", (0, 0, 0.043), (0.095, 0.095, 0.004), rotation=(0, 0, 40))
    b.lathe(bun, bent([(0.057, 0.045), (0.055, 0.062), (0.035, 0.082), (0.002, 0.088)]), segments=26)
    return grips_around(0.05, 0.04, (0.4, 0.4, 0.3))


@prop("ice_cream_cone")
def ice_cream_cone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an ice cream in its cone."""
    b.lathe("wood_light", [(0.006, 0), (0.034, 0.11), (0.036, 0.115)], segments=18)
    b.sphere(spec.material("ice"), (0, 0, 0.128), 0.038, segments=16, rings=10)
    b.sphere("linen", (0, 0, 0.168), 0.032, segments=16, rings=10)
    return grips_around(0.02, 0.06, (0.7, 0.7, 0.5))


@prop("doughnut")
def doughnut(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a doughnut with icing."""
    turn = np.linspace(0, 2 * np.pi, 25)[:-1]
    line = np.c_[0.033 * np.cos(turn), 0.033 * np.sin(turn), np.full(24, 0.018)]
    b.tube("wood_light", line, 0.018, segments=10, closed=True)
    path = np.c_[0.033 * np.cos(turn), 0.033 * np.sin(turn), np.full(24, 0.024)]
    b.tube(spec.material("icing"), path, 0.0165, segments=10, closed=True)
    return grips_around(0.045, 0.02, (0.5, 0.5, 0.4))


@prop("cheese")
def cheese(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wedge of cheese with holes."""
    b.extrude(spec.material("cheese"), [(0.0, -0.1), (0.07, 0.07), (0.0, 0.085), (-0.07, 0.07)], 0.07)
    for x, z, r in ((0.03, 0.045, 0.011), (-0.025, 0.03, 0.014), (0.0, 0.055, 0.008), (0.045, 0.02, 0.008)):
        b.sphere("leaves_autumn", (x, -0.1 + abs(x) * 2.4, z), r, segments=10, rings=6)
    return grips_around(0.05, 0.04, (0.5, 0.5, 0.4))


@prop("roast")
def roast(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a roast bird on its platter."""
    skin = spec.material("skin")
    b.cushion("porcelain", (0, 0, 0.012), (0.44, 0.32, 0.024), softness=0.8)
    b.sphere(skin, (0, 0.01, 0.095), 0.085, scale=(1.3, 1.0, 0.9), segments=20, rings=12)
    for x in (-1, 1):
        path = [(x * 0.07, -0.05, 0.09), (x * 0.12, -0.09, 0.1), (x * 0.15, -0.1, 0.14)]
        b.tube(skin, bent(path), (0.045, 0.045, 0.042, 0.036, 0.03, 0.024, 0.018, 0.014, 0.012), segments=10)
        b.sphere("linen", (x * 0.155, -0.102, 0.148), 0.013, segments=8, rings=5)
        b.cushion("leaves", (x * 0.16, 0.06, 0.03), (0.08, 0.07, 0.02), softness=0.8)
    return grips_under(0.15)


@prop("pie")
def pie(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pie with a lattice."""
    crust = spec.material("crust")
    b.lathe("steel", [(0.1, 0), (0.135, 0.035)], segments=28)
    b.lathe("clay", [(0.128, 0.034), (0.1, 0.042), (0.002, 0.046)], segments=28)
    turn = np.linspace(0, 2 * np.pi, 29)[:-1]
    b.tube(crust, np.c_[0.132 * np.cos(turn), 0.132 * np.sin(turn), np.full(28, 0.04)], 0.012, segments=8, closed=True)
    for k in range(-2, 3):
        reach = np.sqrt(0.13**2 - (0.045 * k) ** 2)
        b.box(crust, (0.045 * k, 0, 0.047), (0.018, 2 * reach, 0.006))
        b.box(crust, (0, 0.045 * k, 0.051), (2 * reach, 0.018, 0.006))
    return grips_under(0.12)


@prop("house")
def house(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a small house with a gable roof, a door and windows; also used for barns and sheds."""
    (w, d, h), wall = spec.size, spec.material("wall")
    eaves = h * 0.6
    b.box(wall, (0, 0, eaves / 2), (w, d, eaves))
    for y in (-1, 1):
        gable = [(-w / 2, y * d / 2, eaves), (w / 2, y * d / 2, eaves), (0, y * d / 2, h * 0.97)]
        b.polygon(wall, gable if y < 0 else gable[::-1])
    over = w * 0.06
    slope = np.degrees(np.arctan2(h - eaves, w / 2))
    long = np.hypot(h - eaves, w / 2) + 2 * over
    for x in (-1, 1):
        center = (x * (w / 4 + over * 0.4), 0, (h + eaves) / 2)
        b.box(spec.material("roof"), center, (long, d + 0.6, 0.12), rotation=(0, x * slope, 0))
    b.box("wood_dark", (0, -d / 2 - 0.01, 1.05), (1.0, 0.08, 2.1), bevel=0.02)
    b.sphere("brass", (0.38, -d / 2 - 0.07, 1.05), 0.04, segments=8, rings=5)
    for x in (-0.32, 0.32):
        b.box("linen", (x * w, -d / 2 - 0.01, eaves * 0.55), (1.1, 0.08, 1.1))
        b.box("glass_dark", (x * w, -d / 2 - 0.03, eaves * 0.55), (0.95, 0.08, 0.95))
        b.box("linen", (x * w, -d / 2 - 0.05, eaves * 0.55), (0.05, 0.08, 1.0))
        b.box("linen", (x * w, -d / 2 - 0.05, eaves * 0.55), (1.0, 0.08, 0.05))
    b.box("brick", (w * 0.24, d * 0.2, h * 0.9), (0.5, 0.5, h * 0.3))
    return ()
