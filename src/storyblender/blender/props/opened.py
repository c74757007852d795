"""Open boxes, suitcases and fridges with a visible interior."""

from __future__ import annotations

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder

WALL = 0.014
"""Thickness of a side in metres."""


def tray(b: MeshBuilder, skin: MaterialRef, lining: MaterialRef, size: tuple[float, float, float]) -> None:
    """Add a box without a lid, its floor at z = 0, lined inside.

    Args:
        b: Receives the parts.
        skin: Material outside.
        lining: Material inside.
        size: Outer width, depth and height.
    """
    w, d, h = size
    b.box(skin, (0, 0, WALL / 2), (w, d, WALL))
    b.box(lining, (0, 0, WALL + 0.002), (w - 2 * WALL, d - 2 * WALL, 0.004))
    for x in (-1, 1):
        b.box(skin, (x * (w - WALL) / 2, 0, h / 2), (WALL, d, h))
        b.box(lining, (x * (w / 2 - WALL - 0.002), 0, h / 2), (0.004, d - 2 * WALL, h - 0.004))
    for y in (-1, 1):
        b.box(skin, (0, y * (d - WALL) / 2, h / 2), (w, WALL, h))
        b.box(lining, (0, y * (d / 2 - WALL - 0.002), h / 2), (w - 2 * WALL, 0.004, h - 0.004))


def open_carton(b: MeshBuilder, skin: MaterialRef, size: tuple[float, float, float]) -> None:
    """Add an open carton with two flaps out and two up, no wider than a closed one.

    Args:
        b: Receives the parts.
        skin: Cardboard.
        size: Width, depth and height of the closed carton.
    """
    w, d, h = size
    tray(b, skin, skin, size)
    for y in (-1, 1):
        with b.at((0, y * d / 2, h), (y * -28, 0, 0)):
            b.box(skin, (0, y * d * 0.22, 0), (w, d * 0.44, 0.005))
    for x in (-1, 1):
        with b.at((x * (w / 2 - 0.01), 0, h), (0, x * -80, 0)):
            b.box(skin, (x * d * 0.2, 0, 0), (d * 0.4, d * 0.96, 0.005))


def open_case(
    b: MeshBuilder, skin: MaterialRef, metal: MaterialRef, lining: MaterialRef, size: tuple[float, float, float]
) -> None:
    """Add a suitcase that lies on its back with its lid up.

    Args:
        b: Receives the parts.
        skin: Material outside.
        metal: Of the locks and hinges.
        lining: Material inside.
        size: Width, depth and height of the suitcase when it stands closed.
    """
    w, d, h = size
    tray(b, skin, lining, (w, h, d * 0.6))
    with b.at((0, h / 2, d * 0.6), (-102, 0, 0)), b.at((0, -h / 2, d * 0.35), (180, 0, 0)):
        tray(b, skin, lining, (w, h, d * 0.35))
    for x in (-0.28, 0.28):
        b.box(metal, (x * w, -h / 2 - 0.006, d * 0.5), (0.05, 0.012, 0.04), bevel=0.003)
    path = [(x, -h / 2 - y, 0.3 * d) for x, y in ((-0.07, 0), (-0.07, 0.035), (0.07, 0.035), (0.07, 0))]
    b.tube(metal, path, 0.009, segments=6)


def open_fridge(b: MeshBuilder, skin: MaterialRef, metal: MaterialRef, size: tuple[float, float, float]) -> None:
    """Add a fridge with its door open and lit shelves with food.

    Args:
        b: Receives the parts.
        skin: Material outside.
        metal: Of the handle.
        size: Width, depth and height with the door closed.
    """
    w, d, h = size
    wall = 0.05
    b.box(skin, (0, d / 2 - wall, h / 2), (w, 2 * wall, h - 0.04))
    for x in (-1, 1):
        b.box(skin, (x * (w - wall) / 2, 0.04, h / 2), (wall, d - 0.1, h), bevel=0.02)
    for z in (0.06, h - wall / 2):
        b.box(skin, (0, 0.04, z), (w, d - 0.1, wall + 0.04), bevel=0.02)
    b.box("lamp_cool", (0, 0.1, h - wall - 0.03), (w * 0.3, 0.1, 0.02))
    for k in range(4):
        z = 0.2 + k * (h - 0.4) / 4
        b.box("porcelain", (0, 0.06, z), (w - 2 * wall, d - 0.2, 0.012))
        for x, food, tall in ((-0.2, "glass_green", 0.22), (0.0, "leaves_autumn", 0.1), (0.16, "linen", 0.16)):
            b.cylinder(food, (x * w * 1.4, 0.0, z), (x * w * 1.4, 0.0, z + tall * (1.0 - 0.12 * k)), 0.04, segments=10)
    with b.at((w / 2, -d / 2 + 0.09, 0), (0, 0, 105)), b.at((-w / 2, 0, 0)):
        b.rounded_box(skin, (0, 0, h / 2), (w - 0.02, 0.09, h - 0.06), 0.03)
        b.cylinder(metal, (-w * 0.38, -0.07, h * 0.45), (-w * 0.38, -0.07, h * 0.65), 0.011, segments=8)
