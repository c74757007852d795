"""Parts that many props share: legs, drawers, panelled doors, cloths, wheels, bottles, books."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from storyblender.blender.mesh_builder import Floats, MaterialRef, MeshBuilder

Profile = list[tuple[float, float]]


def four_legs(
    b: MeshBuilder,
    material: MaterialRef,
    width: float,
    depth: float,
    height: float,
    thick: float,
    *,
    splay: float = 0.0,
) -> None:
    """Add tapering square legs under the corners of a rectangle about the origin.

    Args:
        b: Receives the legs.
        material: Of the legs.
        width: Of the rectangle along X, metres.
        depth: Along Y.
        height: Of the legs.
        thick: Of a leg at its top.
        splay: Metres that each foot stands outwards.
    """
    for x in (-1, 1):
        for y in (-1, 1):
            top = np.array([x * (width - thick) / 2, y * (depth - thick) / 2, height])
            foot = np.array([top[0] + x * splay, top[1] + y * splay, 0.0])
            half = thick / 2
            rings = [square(foot, half * 0.65), square(top - (0, 0, height * 0.25), half), square(top, half)]
            b.loft(material, rings)


def square(center: ArrayLike, half: float) -> Floats:
    """Return the (4, 3) corners of a level square about ``center`` (3,) with sides of twice ``half``, metres."""
    corners = np.array([(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)])
    return np.add(center, corners)


def turned_leg(b: MeshBuilder, material: MaterialRef, x: float, y: float, height: float, radius: float) -> None:
    """Add a round leg turned on a lathe, with a ring and a bulb.

    Args:
        b: Receives the leg.
        material: Of the leg.
        x: Of its axis, metres.
        y: Of its axis.
        height: From the floor at z = 0.
        radius: At its thickest.
    """
    r, h = radius, height
    profile = [
        (r * 0.55, 0), (r * 0.7, h * 0.04), (r * 0.45, h * 0.08), (r * 0.75, h * 0.4), (r, h * 0.62),
        (r * 0.6, h * 0.72), (r * 0.95, h * 0.76), (r * 0.95, h * 0.8), (r * 0.6, h * 0.82), (r, h * 0.86), (r, h),
    ]  # fmt: skip
    b.lathe(material, profile, origin=(x, y, 0), segments=12)


def table_top(b: MeshBuilder, material: MaterialRef, width: float, depth: float, height: float, thick: float) -> None:
    """Add a level board about the z axis.

    Args:
        b: Receives the board.
        material: Of the board.
        width: Along X, metres.
        depth: Along Y.
        height: Of its upper side.
        thick: From its upper side down.
    """
    b.box(material, (0, 0, height - thick / 2), (width, depth, thick), bevel=min(0.008, thick / 4))


def drawer(
    b: MeshBuilder,
    front: MaterialRef,
    handle: MaterialRef,
    center: tuple[float, float, float],
    width: float,
    height: float,
    *,
    knob: bool = False,
) -> None:
    """Add the front of a drawer, facing -Y.

    Args:
        b: Receives the parts.
        front: Material of the board.
        handle: Material of the handle.
        center: Middle of the board.
        width: Of the board, metres.
        height: Of the board.
        knob: One knob, or two on a wide drawer, instead of a bar.
    """
    x, y, z = center
    b.box(front, (x, y, z), (width, 0.022, height), bevel=0.006)
    if knob:
        for side in (-0.25, 0.25) if width > 0.5 else (0.0,):
            b.sphere(handle, (x + side * width, y - 0.026, z), 0.016, segments=10, rings=6)
        return
    length = min(0.14, width * 0.35)
    path = [(x + length * s, y - t, z) for s, t in ((-0.5, 0.01), (-0.5, 0.035), (0.5, 0.035), (0.5, 0.01))]
    b.tube(handle, path, 0.006, segments=6)


def panel_door(
    b: MeshBuilder,
    material: MaterialRef,
    center: tuple[float, float, float],
    width: float,
    height: float,
    *,
    panels: int = 1,
) -> None:
    """Add a cupboard door that faces -Y: a frame of stiles and rails round sunken panels.

    Args:
        b: Receives the parts.
        material: Of the door.
        center: Middle of the door.
        width: Along X, metres.
        height: Along Z.
        panels: How many, one above the other.
    """
    x, y, z = center
    frame = min(0.075, width * 0.16)
    for side in (-1, 1):
        b.box(material, (x + side * (width - frame) / 2, y, z), (frame, 0.024, height), bevel=0.004)
    step = (height - frame) / panels
    for k in range(panels + 1):
        b.box(material, (x, y, z - (height - frame) / 2 + k * step), (width - 2 * frame, 0.022, frame), bevel=0.004)
    b.box(material, (x, y + 0.008, z), (width - frame, 0.008, height - frame))


def draped_cloth(
    b: MeshBuilder, material: MaterialRef, outline: Floats, top: float, drop: float, waves: int, *, flare: float = 0.05
) -> None:
    """Add a cloth over a table: flat on top, hanging in folds.

    Args:
        b: The builder.
        material: Cloth.
        outline: (n, 2) counter-clockwise edge of the table, finely sampled.
        top: Height of the cloth's upper side.
        drop: How far it hangs.
        waves: Folds around.
        flare: How far it stands off at its hem.
    """
    middle = outline.mean(axis=0)
    out = outline - middle
    out = out / np.linalg.norm(out, axis=1, keepdims=True)
    phase = np.linspace(0, 2 * math.pi * waves, len(outline), endpoint=False)
    rings = []
    for t in (1.0, 0.55, 0.12, 0.0):
        reach = 0.012 + flare * t + 0.5 * flare * t * np.sin(phase)
        z = top - drop * t if t else top
        reach = reach if t else np.full(len(outline), -0.004)
        rings.append(np.c_[outline + out * np.asarray(reach)[:, None], np.full(len(outline), z)])
    b.loft(material, rings, caps=False)
    b.polygon(material, rings[-1])


def bent(points: ArrayLike, per: int = 4) -> Floats:
    """Return a smooth curve through a few points: a path for ``tube``, a profile for ``lathe``, radii, or rings.

    Args:
        points: (n, ...) what it goes through; it begins and ends with them.
        per: Steps from one to the next.

    Returns:
        ((n - 1) * per + 1, ...) points of a Catmull-Rom spline.
    """
    at = np.asarray(points, float)
    held = np.concatenate([at[:1], at, at[-1:]])
    t = (np.arange(per) / per).reshape(per, *[1] * (at.ndim - 1))
    runs = [
        b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))
        for a, b, c, d in zip(held, held[1:], held[2:], held[3:], strict=False)
    ]
    return np.concatenate([*runs, at[-1:]])


def circle(radius: float, count: int = 48) -> Floats:
    """Return points on a circle about the origin, counter-clockwise, the first on +X.

    Args:
        radius: Metres.
        count: How many points.

    Returns:
        (count, 2) points.
    """
    angle = np.linspace(0, 2 * math.pi, count, endpoint=False)
    return radius * np.c_[np.cos(angle), np.sin(angle)]


def rectangle(width: float, depth: float, count: int = 96, corner: float = 0.04) -> Floats:
    """Return points on a rectangle with round corners about the origin, evenly spaced, counter-clockwise.

    Args:
        width: Along X, metres.
        depth: Along Y.
        count: How many points.
        corner: Radius of its corners.

    Returns:
        (count, 2) points.
    """
    arcs = []
    for quarter, (x, y) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        angle = np.linspace(quarter, quarter + 1, 5) * math.pi / 2
        middle = np.array([x * (width / 2 - corner), y * (depth / 2 - corner)])
        arcs.append(middle + corner * np.c_[np.cos(angle), np.sin(angle)])
    loop = np.concatenate(arcs)
    loop = np.r_[loop, loop[:1]]
    length = np.r_[0, np.cumsum(np.linalg.norm(np.diff(loop, axis=0), axis=1))]
    at = np.linspace(0, length[-1], count, endpoint=False)
    return np.c_[np.interp(at, length, loop[:, 0]), np.interp(at, length, loop[:, 1])]


def wheel(
    b: MeshBuilder, tyre: MaterialRef, hub: MaterialRef, center: tuple[float, float, float], radius: float, width: float
) -> None:
    """Add a tyred disc wheel whose axle runs along X; its hub shows on the side away from x = 0.

    Args:
        b: Receives the parts.
        tyre: Material of the tyre.
        hub: Material of the hub cap.
        center: Middle of the wheel.
        radius: With the tyre, metres.
        width: Of the tyre.
    """
    side = 1.0 if center[0] >= 0 else -1.0
    half, r = width / 2, radius
    outline = np.multiply([(0.58, -1), (0.94, -1), (1, -0.45), (1, 0.45), (0.94, 1), (0.58, 1)], (r, half))
    b.lathe(tyre, outline, origin=center, axis=(side, 0, 0), segments=24)
    hubcap = [
        (r * 0.58, half * 0.55), (r * 0.52, half * 0.8), (r * 0.34, half * 0.72), (r * 0.22, half * 1.1),
        (0.004, half * 1.2),
    ]  # fmt: skip
    b.lathe(hub, hubcap, origin=center, axis=(side, 0, 0), segments=20, caps=False)


def spoked_wheel(
    b: MeshBuilder,
    rim: MaterialRef,
    spoke: MaterialRef,
    center: tuple[float, float, float],
    radius: float,
    thick: float,
    count: int,
) -> None:
    """Add an open wheel with spokes whose axle runs along X.

    Args:
        b: Receives the parts.
        rim: Material of the rim.
        spoke: Material of spokes and hub.
        center: Middle of the wheel.
        radius: To the middle of the rim, metres.
        thick: Radius of the rim's section.
        count: Number of spokes.
    """
    x, y, z = center
    angle = np.linspace(0, 2 * math.pi, 28, endpoint=False)
    path = np.c_[np.full(28, x), y + radius * np.cos(angle), z + radius * np.sin(angle)]
    b.tube(rim, path, thick, segments=8, closed=True)
    b.cylinder(spoke, (x - 2 * thick, y, z), (x + 2 * thick, y, z), max(0.025, radius * 0.09), segments=10)
    for k in range(count):
        turn = 2 * math.pi * k / count
        end = (x, y + radius * math.cos(turn), z + radius * math.sin(turn))
        b.cylinder(spoke, center, end, thick * 0.35, segments=6, caps=False)


def bottle_profile(radius: float, height: float) -> Floats:
    """Return the (8, 2) outline of a bottle of this radius and height in metres, for ``MeshBuilder.lathe``."""
    outline = [(0.92, 0), (1, 0.03), (1, 0.58), (0.85, 0.66), (0.4, 0.76), (0.34, 0.94), (0.42, 0.95), (0.42, 1)]
    return np.multiply(outline, (radius, height))


def book_row(
    b: MeshBuilder,
    covers: Sequence[MaterialRef],
    rng: np.random.Generator,
    start: tuple[float, float, float],
    width: float,
    depth: float,
    height: float,
    fill: float,
) -> None:
    """Add a row of standing books of random sizes, with gaps between them.

    Args:
        b: Receives the books.
        covers: Materials to choose from.
        rng: Source of variation.
        start: Left end of the row, middle of its depth, height of the shelf; the row runs along +X.
        width: Of the row, metres.
        depth: Of the deepest book.
        height: Of the tallest book.
        fill: Share of the places that have a book, 0 to 1.
    """
    x, y, z = start
    end = x + width
    while True:
        thick = float(rng.uniform(0.022, 0.05))
        if x + thick > end:
            return
        tall = height * float(rng.uniform(0.66, 0.92))
        deep = depth * float(rng.uniform(0.72, 0.95))
        cover = covers[int(rng.integers(len(covers)))]
        if rng.random() < fill:
            b.box(cover, (x + thick / 2, y + (depth - deep) / 2, z + tall / 2), (thick * 0.94, deep, tall), bevel=0.004)
        x += thick
