"""Set piece builders: houses seen from the street: facades with windows, doors, shops and cornices."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.blender.sets.walls import wall_shell
from storyblender.catalog.set_plan import Opening, Wall

FLOOR = 3.2
"""Height of a storey in metres."""
DEPTH = 7.0

_AWNINGS = ("cloth_red", "cloth_green", "cloth_blue")


@piece("facade")
def facade(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a house front at y = 0 with sides and a roof behind it.

    Parameters: width, floors, material, shop, plain (no cornice nor shutters: the back of a house), seed.
    """
    width, floors = spec.number("width", 8.4), int(spec.number("floors", 3))
    height = FLOOR * floors + 0.9
    shop, plain = spec.flag("shop"), spec.flag("plain")
    openings = _openings(width, floors, shop=shop)
    wall = Wall(
        node_id="facade",
        start=(0, 0),
        end=(width, 0),
        height=height,
        thickness=0.35,
        material=spec.word("material", "brick"),
        texture=spec.texture,
        openings=openings,
    )
    trim = finish("stone_light" if spec.rng.random() < 0.5 else "paint_cream")
    with builder.at((width / 2, 0, 0), (0, 0, 180)):
        wall_shell(builder, wall)
        for opening in openings:
            with builder.at((opening.x, 0, opening.sill)):
                _fill(builder, spec, opening, trim, plain=plain)
    _body(builder, spec, width, height)
    if not plain:
        _mouldings(builder, trim, width, height, floors)
    if shop:
        _shop_front(builder, spec, width)


def _openings(width: float, floors: int, *, shop: bool) -> tuple[Opening, ...]:
    """Return windows and door of a house front; the ground floor is a shop front if ``shop``."""
    count = max(2, int(width / 2.4))
    bay = width / count
    openings = [
        Opening(
            name=f"window_{f}_{i}",
            kind="window",
            x=i * bay + bay / 2 - 0.55,
            sill=f * FLOOR + 0.85,
            width=1.1,
            height=1.7,
        )
        for f in range(1, floors)
        for i in range(count)
    ]
    if shop:
        left = width * 0.42
        openings += [
            Opening(name="show_left", kind="window", x=0.5, sill=0.55, width=left, height=2.0, style="shop"),
            Opening(name="door", kind="door", x=left + 0.7, width=1.0, height=2.5, style="glass"),
            Opening(
                name="show_right",
                kind="window",
                x=left + 1.9,
                sill=0.55,
                width=width - left - 2.4,
                height=2.0,
                style="shop",
            ),
        ]
    else:
        entry = count // 2
        for i in range(count):
            x = i * bay + bay / 2
            if i == entry:
                openings.append(Opening(name="door", kind="door", x=x - 0.6, width=1.2, height=2.5))
            else:
                openings.append(
                    Opening(name=f"window_0_{i}", kind="window", x=x - 0.55, sill=0.95, width=1.1, height=1.6)
                )
    return tuple(openings)


def _fill(builder: MeshBuilder, spec: PieceSpec, opening: Opening, trim: object, *, plain: bool) -> None:
    """Add panes, sashes, sill and head of one opening; the street is at +Y of this frame."""
    width, height = opening.width, opening.height
    sash = finish("paint_brown")
    if opening.kind == "door":
        builder.box(finish("wood_dark"), (width / 2, -0.22, height / 2), (width, 0.06, height))
        glow = spec.pane("pane_warm") if opening.style == "glass" else finish("glass_dark")
        builder.box(glow, (width / 2, -0.18, height * 0.66), (width * 0.62, 0.03, height * 0.44))
        builder.box(trim, (width / 2, 0.03, height + 0.1), (width + 0.36, 0.14, 0.2))
        builder.box(finish("stone_light"), (width / 2, 0.14, 0.06), (width + 0.3, 0.42, 0.12))
        return
    lit = opening.style == "shop" or spec.rng.random() < 0.3
    key = ("pane_warm", "pane_amber", "pane_pale")[int(spec.rng.integers(3))]
    glass = spec.pane(key) if lit else finish("glass_dark")
    builder.box(glass, (width / 2, -0.26, height / 2), (width, 0.02, height))
    if opening.style != "shop" and spec.rng.random() < 0.55:
        curtain = finish("cloth_cream")
        for x in (width * 0.13, width * 0.87):
            builder.box(curtain, (x, -0.245, height / 2), (width * 0.26, 0.012, height))
    across = 2 if width < 1.5 else max(2, round(width / 1.1))
    for index in range(across + 1):
        builder.box(sash, (width * index / across, -0.22, height / 2), (0.055, 0.06, height))
    for share in (0.0, 0.5, 1.0) if width < 1.5 else (0.0, 0.78, 1.0):
        builder.box(sash, (width / 2, -0.22, height * share), (width, 0.06, 0.055))
    if opening.style != "shop":
        builder.box(trim, (width / 2, 0.05, -0.06), (width + 0.3, 0.2, 0.1))
        builder.box(trim, (width / 2, 0.03, height + 0.1), (width + (0.1 if plain else 0.3), 0.12, 0.2))


def _body(builder: MeshBuilder, spec: PieceSpec, width: float, height: float) -> None:
    """Add the sides, back, roof and chimneys behind a front."""
    skin, half = spec.finish("material", "brick"), width / 2
    builder.quad(skin, (-half, DEPTH, 0), (-half, 0, 0), (-half, 0, height), (-half, DEPTH, height))
    builder.quad(skin, (half, 0, 0), (half, DEPTH, 0), (half, DEPTH, height), (half, 0, height))
    builder.quad(skin, (half, DEPTH, 0), (-half, DEPTH, 0), (-half, DEPTH, height), (half, DEPTH, height))
    top = finish("roof_slate")
    builder.quad(
        top,
        (-half, 0, height - 0.4),
        (half, 0, height - 0.4),
        (half, DEPTH, height - 0.4),
        (-half, DEPTH, height - 0.4),
    )
    for x in (-half * 0.6, half * 0.55):
        builder.box(skin, (x, 2.6, height + 0.5), (0.9, 0.6, 1.5))
        builder.box(finish("roof_tile"), (x, 2.6, height + 1.3), (0.7, 0.4, 0.2))


def _mouldings(builder: MeshBuilder, trim: object, width: float, height: float, floors: int) -> None:
    """Add cornice, string courses and plinth."""
    builder.box(trim, (0, -0.12, height - 0.15), (width + 0.1, 0.5, 0.3), bevel=0.04)
    builder.box(trim, (0, -0.05, height - 0.48), (width, 0.24, 0.12))
    builder.box(trim, (0, -0.06, FLOOR - 0.05), (width, 0.3, 0.22), bevel=0.03)
    builder.box(trim, (0, -0.03, 0.2), (width, 0.14, 0.4))
    for floor in range(2, floors):
        builder.box(trim, (0, -0.02, FLOOR * floor + 0.1), (width, 0.1, 0.09))


def _shop_front(builder: MeshBuilder, spec: PieceSpec, width: float) -> None:
    """Add the awning and the sign of a shop."""
    cloth = finish(_AWNINGS[int(spec.rng.integers(len(_AWNINGS)))])
    x0, x1 = -width / 2 + 0.4, -width / 2 + width * 0.42 + 0.6
    builder.quad(cloth, (x0, -1.25, 2.5), (x1, -1.25, 2.5), (x1, -0.02, 3.0), (x0, -0.02, 3.0))
    builder.quad(cloth, (x0, -1.25, 2.28), (x1, -1.25, 2.28), (x1, -1.25, 2.5), (x0, -1.25, 2.5))
    for x in (x0, x1):
        builder.add(cloth, [(x, -1.25, 2.5), (x, -0.02, 2.5), (x, -0.02, 3.0)], [(0, 1, 2)])
    board = finish(("paint_green", "paint_blue", "paint_red")[int(spec.rng.integers(3))])
    middle = width * 0.22
    builder.box(board, (middle, -0.1, 2.85), (width * 0.46, 0.08, 0.5), bevel=0.02)
    letters, at = finish("paint_cream"), middle - width * 0.17
    while at < middle + width * 0.16:
        wide = float(spec.rng.uniform(0.1, 0.2))
        builder.box(letters, (at, -0.15, 2.85), (wide, 0.02, 0.24))
        at += wide + 0.07


@piece("fire_escape")
def fire_escape(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build iron landings and ladders up a wall at y = 0. Parameters: floors."""
    iron = finish("iron")
    for floor in range(1, int(spec.number("floors", 3)) + 1):
        z = floor * FLOOR + 0.3
        for index in range(7):
            builder.box(iron, (0, -0.12 - 0.17 * index, z), (3.2, 0.11, 0.03))
        for height in (0.55, 1.05):
            builder.tube(iron, [(x, y, z + height) for x, y in ((-1.6, 0), (-1.6, -1.2), (1.6, -1.2), (1.6, 0))], 0.022)
        for x in np.linspace(-1.6, 1.6, 7):
            builder.cylinder(iron, (x, -1.2, z), (x, -1.2, z + 1.05), 0.015, segments=6)
        for x in (-1.4, 1.4):
            builder.cylinder(iron, (x, 0, z - 0.7), (x, -1.1, z), 0.02, segments=6)
        lean = 1.0 if floor % 2 else -1.0
        for y in (-0.35, -0.85):
            builder.cylinder(iron, (-1.2 * lean, y, z), (1.2 * lean, y, z + FLOOR), 0.022, segments=6)
        for step in range(11):
            share = (step + 0.5) / 11
            builder.box(iron, (-1.2 * lean + 2.4 * lean * share, -0.6, z + FLOOR * share), (0.18, 0.5, 0.02))


@piece("wall_lamp")
def wall_lamp(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a lamp on a bracket at a wall at y = 0."""
    iron = finish("iron")
    builder.tube(iron, [(0, 0, 0), (0, -0.25, 0.18), (0, -0.42, 0.12)], 0.018)
    builder.lathe(iron, [(0.02, 0.12), (0.16, 0.0), (0.19, -0.03)], origin=(0, -0.42, 0.0), caps=False)
    builder.sphere(finish("lamp_warm"), (0, -0.42, -0.03), 0.07, segments=12, rings=7)
