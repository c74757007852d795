"""Set piece builders: benches of laboratories and restaurant kitchens: glassware, fume hood, steel counters."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece

_LIQUIDS = ("paint_blue", "paint_green", "paint_yellow", "paint_red", "glass_amber")


@piece("lab_bench")
def lab_bench(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a bench along x with cupboards to -Y, a shelf of bottles behind, apparatus on top. Parameters: length."""
    length, white = spec.number("length", 3.0), finish("paint_white")
    builder.box(white, (0, 0.04, 0.43), (length, 0.6, 0.86))
    builder.box(finish("paint_black"), (0, 0, 0.89), (length + 0.04, 0.72, 0.05), bevel=0.008)
    count = max(2, round(length / 0.6))
    for index in range(count):
        x = length * ((index + 0.5) / count - 0.5)
        builder.box(finish("paint_grey"), (x, -0.265, 0.36), (length / count - 0.04, 0.02, 0.6), bevel=0.005)
        builder.box(finish("paint_grey"), (x, -0.265, 0.76), (length / count - 0.04, 0.02, 0.14), bevel=0.005)
        builder.box(finish("chrome"), (x, -0.285, 0.62), (0.12, 0.02, 0.015))
    for z in (1.3, 1.62):
        builder.box(white, (0, 0.27, z), (length, 0.2, 0.03))
        for x in np.arange(-length / 2 + 0.12, length / 2 - 0.08, 0.16):
            if spec.rng.random() < 0.8:
                _bottle(builder, spec, float(x), 0.27, z + 0.015)
    for x in (-length / 2 + 0.03, length / 2 - 0.03):
        builder.box(finish("metal_grey"), (x, 0.3, 1.26), (0.04, 0.1, 0.72))
    for index, x in enumerate(np.arange(-length / 2 + 0.35, length / 2 - 0.2, 0.5)):
        (_flask, _burner, _microscope, _rack)[(index + int(spec.number("variant", 0))) % 4](builder, spec, float(x))


def _bottle(builder: MeshBuilder, spec: PieceSpec, x: float, y: float, z: float) -> None:
    """Add a bottle of reagent."""
    tall, wide = float(spec.rng.uniform(0.12, 0.24)), float(spec.rng.uniform(0.03, 0.05))
    skin = finish(str(spec.rng.choice(("glass_amber", "glass_green", "paint_white", "glass"))))
    profile = [(wide, 0), (wide, tall * 0.62), (wide * 0.35, tall * 0.78), (wide * 0.35, tall)]
    builder.lathe(skin, profile, origin=(x, y, z), segments=10)


def _flask(builder: MeshBuilder, spec: PieceSpec, x: float) -> None:
    """Add a flask of coloured liquid on the bench at ``x``."""
    liquid = finish(str(spec.rng.choice(_LIQUIDS)))
    builder.lathe(liquid, [(0.09, 0), (0.055, 0.1)], origin=(x, -0.06, 0.915), segments=16)
    builder.lathe(finish("glass"), [(0.055, 0.1), (0.026, 0.17), (0.026, 0.26), (0.034, 0.27)],
                  origin=(x, -0.06, 0.915), segments=16, caps=False)  # fmt: skip
    builder.cylinder(liquid, (x + 0.17, -0.1, 0.915), (x + 0.17, -0.1, 1.02), 0.045, segments=14)
    builder.cylinder(finish("glass"), (x + 0.17, -0.1, 1.02), (x + 0.17, -0.1, 1.06), 0.047, segments=14, caps=False)


def _burner(builder: MeshBuilder, spec: PieceSpec, x: float) -> None:
    """Add a round flask on a stand over a gas burner at ``x``."""
    iron, liquid = finish("iron"), finish(str(spec.rng.choice(_LIQUIDS)))
    builder.box(iron, (x, -0.02, 0.925), (0.2, 0.14, 0.02))
    builder.cylinder(iron, (x - 0.08, -0.02, 0.92), (x - 0.08, -0.02, 1.5), 0.009, segments=8)
    builder.cylinder(iron, (x - 0.08, -0.02, 1.32), (x + 0.02, -0.02, 1.32), 0.008, segments=6)
    builder.sphere(liquid, (x + 0.03, -0.02, 1.22), 0.075, segments=16, rings=10)
    builder.cylinder(finish("glass"), (x + 0.03, -0.02, 1.28), (x + 0.03, -0.02, 1.42), 0.02, segments=10)
    builder.cylinder(finish("brass"), (x + 0.03, -0.02, 0.93), (x + 0.03, -0.02, 1.06), 0.014, segments=10)
    builder.lathe(finish("flame"), [(0.016, 0), (0.012, 0.04), (0.002, 0.08)], origin=(x + 0.03, -0.02, 1.06))


def _microscope(builder: MeshBuilder, spec: PieceSpec, x: float) -> None:
    """Add a microscope at ``x``."""
    body, black = finish("paint_white"), finish("paint_black")
    builder.box(black, (x, -0.04, 0.93), (0.14, 0.2, 0.03), bevel=0.01)
    builder.tube(body, [(x, 0.04, 0.94), (x, 0.06, 1.08), (x, 0.02, 1.2)], 0.028)
    builder.box(black, (x, -0.05, 1.03), (0.12, 0.12, 0.015))
    builder.cylinder(body, (x, -0.05, 1.12), (x, -0.05, 1.24), 0.03, segments=12)
    builder.cylinder(finish("chrome"), (x, -0.05, 1.06), (x, -0.05, 1.12), 0.014, segments=10)
    builder.cylinder(black, (x, -0.05, 1.24), (x, -0.15, 1.34), 0.02, segments=10)


def _rack(builder: MeshBuilder, spec: PieceSpec, x: float) -> None:
    """Add a rack of test tubes at ``x``."""
    for z in (0.95, 1.03):
        builder.box(finish("wood_light"), (x, -0.06, z), (0.32, 0.08, 0.015))
    for index in range(6):
        at = x - 0.125 + 0.05 * index
        liquid = finish(_LIQUIDS[(index + int(spec.rng.integers(5))) % len(_LIQUIDS)])
        builder.cylinder(liquid, (at, -0.06, 0.95), (at, -0.06, 1.04), 0.013, segments=8)
        builder.cylinder(finish("glass"), (at, -0.06, 1.04), (at, -0.06, 1.1), 0.013, segments=8, caps=False)


@piece("fume_hood")
def fume_hood(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a lit glass cupboard with its duct against a wall at y = 0, facing -Y. Parameters: height."""
    height, white, wide = spec.number("height", 2.8), finish("paint_white"), 1.4
    builder.box(white, (0, -0.4, 0.43), (wide, 0.8, 0.86))
    builder.box(finish("paint_black"), (0, -0.4, 0.88), (wide, 0.8, 0.04))
    builder.box(finish("paint_grey"), (0, -0.03, 1.45), (wide, 0.04, 1.1))
    for x in (-wide / 2 + 0.05, wide / 2 - 0.05):
        builder.box(white, (x, -0.4, 1.45), (0.1, 0.8, 1.1))
    builder.box(white, (0, -0.4, 2.1), (wide, 0.8, 0.24))
    builder.box(finish("lamp_cool"), (0, -0.4, 1.975), (wide - 0.3, 0.2, 0.01))
    for z in (1.62, 1.95):
        builder.box(finish("metal_grey"), (0, -0.78, z), (wide - 0.18, 0.03, 0.04))
    _flask(builder, spec, -0.3)
    _burner(builder, spec, 0.2)
    builder.cylinder(finish("chrome"), (0, -0.3, 2.2), (0, -0.3, height), 0.13, segments=16)


@piece("steel_counter")
def steel_counter(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a cook's counter along x facing -Y: steel top, shelf of pots below. Parameters: length, range, pass."""
    length, steel = spec.number("length", 2.4), finish("steel")
    builder.box(steel, (0, 0, 0.88), (length, 0.75, 0.05), bevel=0.006)
    if spec.flag("range"):
        _range(builder, spec, length, steel)
        return
    builder.box(steel, (0, 0, 0.24), (length - 0.06, 0.66, 0.03))
    for x in (-length / 2 + 0.06, length / 2 - 0.06):
        for y in (-0.3, 0.3):
            builder.cylinder(steel, (x, y, 0), (x, y, 0.86), 0.022, segments=8)
    for x in np.arange(-length / 2 + 0.3, length / 2 - 0.2, 0.42):
        wide = float(spec.rng.uniform(0.12, 0.18))
        builder.lathe(steel, [(wide, 0), (wide, wide * 1.3), (wide + 0.012, wide * 1.3)],
                      origin=(float(x), 0, 0.255), segments=18)  # fmt: skip
    if spec.flag("pass"):  # plates under lamps between cooks and waiters
        for z in (1.28, 1.6):
            builder.box(steel, (0, 0.12, z), (length, 0.4, 0.03))
        for x in (-length / 2 + 0.04, length / 2 - 0.04):
            builder.box(steel, (x, 0.12, 1.24), (0.04, 0.36, 0.72))
        for x in np.arange(-length / 2 + 0.3, length / 2 - 0.1, 0.5):
            builder.lathe(finish("porcelain"), [(0.06, 0), (0.12, 0.02)], origin=(float(x), 0.1, 1.295), segments=18)
            builder.box(finish("lamp_warm"), (float(x), 0.12, 1.575), (0.2, 0.06, 0.02))
    else:
        builder.box(finish("wood_light"), (-length * 0.2, -0.05, 0.92), (0.5, 0.32, 0.03), bevel=0.006)
        for index in range(3):
            skin = finish(("paint_red", "paint_green", "paint_yellow")[index])
            builder.sphere(skin, (-length * 0.2 - 0.12 + 0.11 * index, -0.05, 0.965), 0.045, segments=10, rings=7)


def _range(builder: MeshBuilder, spec: PieceSpec, length: float, steel: MaterialRef) -> None:
    """Add a restaurant range with its burners."""
    builder.box(steel, (0, 0.02, 0.46), (length, 0.7, 0.82))
    builder.box(finish("paint_black"), (0, -0.335, 0.4), (length - 0.3, 0.02, 0.46), bevel=0.01)
    builder.cylinder(finish("chrome"), (-length / 2 + 0.25, -0.38, 0.67), (length / 2 - 0.25, -0.38, 0.67), 0.015)
    for index, x in enumerate(np.arange(-length / 2 + 0.28, length / 2 - 0.1, 0.45)):
        builder.cylinder(finish("paint_black"), (float(x), -0.36, 0.79), (float(x), -0.33, 0.79), 0.03, segments=12)
        for y in (-0.17, 0.17):
            builder.cylinder(finish("iron"), (float(x), y, 0.905), (float(x), y, 0.925), 0.13, segments=16)
        builder.lathe(finish("paint_blue"), [(0.05, 0), (0.06, 0.02)], origin=(float(x), -0.17, 0.915), segments=12)
        if index % 2 == 0:
            builder.lathe(finish("copper" if index % 4 else "steel"), [(0.15, 0), (0.15, 0.2), (0.16, 0.2)],
                          origin=(float(x), 0.17, 0.925), segments=18)  # fmt: skip
        else:
            builder.lathe(finish("iron"), [(0.13, 0), (0.16, 0.05)], origin=(float(x), -0.17, 0.925), segments=18)
            builder.cylinder(finish("iron"), (float(x), -0.31, 0.96), (float(x), -0.52, 0.99), 0.014, segments=8)


@piece("extractor")
def extractor(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a steel hood along x over a range, its lower edge at z = 0, with lamps and a rail of pans.

    Parameters: length, duct (metres up to the ceiling).
    """
    length, duct, steel = spec.number("length", 2.6), spec.number("duct", 0.6), finish("steel")
    rings = [
        [(-w, -d, z), (w, -d, z), (w, d, z), (-w, d, z)]
        for w, d, z in ((length / 2, 0.52, 0.0), (length / 2, 0.52, 0.12), (length / 2 - 0.25, 0.3, 0.42))
    ]
    builder.loft(steel, [np.array(ring) for ring in rings])
    builder.box(steel, (0, 0.05, 0.42 + duct / 2), (0.6, 0.4, duct))
    for x in (-length / 4, length / 4):
        builder.box(finish("lamp_warm"), (x, -0.1, -0.008), (0.3, 0.2, 0.012))
    builder.cylinder(finish("chrome"), (-length / 2, -0.56, 0.02), (length / 2, -0.56, 0.02), 0.014, segments=8)
    for x in np.arange(-length / 2 + 0.2, length / 2 - 0.1, 0.36):
        skin, size = finish(str(spec.rng.choice(("copper", "iron", "steel")))), float(spec.rng.uniform(0.09, 0.14))
        builder.cylinder(skin, (float(x), -0.57, 0.0), (float(x), -0.58, -0.24), 0.01, segments=6)
        builder.lathe(skin, [(size, 0), (size * 1.1, 0.06)], origin=(float(x), -0.58, -0.24 - size), axis=(0, -1, 0))
