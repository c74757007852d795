"""Beards and moustaches: a shell over the jaw and tufts that follow the face's shape keys."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from storyblender.blender.people.face import Pin
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.sheet import Sheet, clip, join, normals, rigid_sheet
from storyblender.blender.people.skin import shape_keys_of, whisker_growth
from storyblender.geometry.solids import Floats, skin_faces

Place = tuple[float, float]
"""x and y on the front of the base mesh, decimetres."""


@dataclass
class Whiskers:
    """Finished facial hair.

    Attributes:
        sheet: The surface.
        shades: (V,) brightness, a factor of the hair's colour.
        keys: Offsets (V, 3) of the shape keys.
    """

    sheet: Sheet
    shades: Floats
    keys: dict[str, Floats]


def build_whiskers(figure: BodyFigure, kind: str, seed: int, keys: Mapping[str, Floats]) -> Whiskers:
    """Return a beard, which includes a moustache, or a moustache.

    Args:
        figure: The body.
        kind: ``beard`` or ``moustache``.
        seed: Varies the tufts.
        keys: Shape keys of the whole base mesh.
    """
    rng = np.random.default_rng(seed + 5)
    tufts = [_tuft(figure, path, width, keys, rng) for path, width in _moustache(rng)]
    if kind == "beard":
        tufts = [_shell(figure, keys, rng), *tufts]
        tufts += [_tuft(figure, path, width, keys, rng) for path, width in _beard(rng)]
    return Whiskers(
        join([tuft.sheet for tuft in tufts]),
        np.concatenate([tuft.shades for tuft in tufts]),
        {key: np.concatenate([tuft.keys[key] for tuft in tufts]) for key in keys},
    )


def _moustache(rng: np.random.Generator) -> list[tuple[list[Place], float]]:
    """Return path and width of each tuft of a moustache, decimetres on the base mesh."""
    paths = []
    for side in (-1, 1):
        for step in range(7):
            start = 0.01 + 0.045 * step
            reach = start + 0.10 + 0.02 * rng.uniform(-1, 1)
            drop = 6.795 - 0.004 * step
            tip = 6.735 - 0.22 * max(0.0, reach - 0.2) - 0.015 * rng.uniform()
            middle = (0.5 * (start + reach), 0.5 * (drop + tip) + 0.012)
            path = [(start, drop), middle, (reach, tip)]
            paths.append(([(side * x, y) for x, y in path], 0.0095))
    return paths


def _beard(rng: np.random.Generator) -> list[tuple[list[Place], float]]:
    """Return path and width of each tuft of a beard, decimetres on the base mesh."""
    paths = []
    for row, top in enumerate((6.80, 6.66, 6.52, 6.38)):
        for x in np.linspace(-0.62, 0.62, 11) + (0.03 if row % 2 else -0.03):
            x = float(x + rng.normal(0, 0.015))
            start = (x, top)
            if whisker_growth(np.array([(x, top, 1.2)]))[0] < 0.02:
                continue
            length = 0.17 if row < 3 else 0.12
            paths.append(([start, (x * 0.99, top - length / 2), (x * 0.96, top - length)], 0.017))
    return paths


def _shell(figure: BodyFigure, keys: Mapping[str, Floats], rng: np.random.Generator) -> Whiskers:
    """Return the skin of the jaw, thickened, fullest on the chin."""
    skin = figure.part("skin")
    sheet = clip(skin, whisker_growth(skin.base))  # through the faces, or its edge on the cheek is a saw
    growth = whisker_growth(sheet.base)
    outward = normals(sheet)
    chin = np.clip((6.75 - sheet.base[:, 1]) / 0.5, 0, 1) * np.clip((sheet.base[:, 2] - 0.7) / 0.5, 0, 1)
    thick = (0.0005 + (0.004 + 0.010 * chin) * np.clip(growth / 0.12, 0, 1)) * figure.head_scale
    thick = thick * (1 + 0.15 * rng.standard_normal(len(thick)))
    sheet = sheet.moved(sheet.points + outward * thick[:, None])
    return Whiskers(sheet, np.full(len(sheet.points), 0.85), shape_keys_of(sheet, keys))


def _tuft(
    figure: BodyFigure, path: list[Place], width: float, keys: Mapping[str, Floats], rng: np.random.Generator
) -> Whiskers:
    """Return one tapered tuft pinned to the face along ``path``."""
    pins = [Pin(figure.pack, x, y) for x, y in path]
    scale = figure.head_scale
    middle = np.array([pin.on(figure.points) for pin in pins])
    lift = np.array((0.002, 0.007, 0.010)) * scale * rng.uniform(0.7, 1.3)
    out = middle - (figure.joint("head") + np.array((0, 0, -0.03 * scale)))
    out[:, 2] *= 0.3
    out /= np.linalg.norm(out, axis=1, keepdims=True)
    middle = middle + out * lift[:, None]
    along = np.gradient(middle, axis=0)
    across = np.cross(along, out)
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)
    half = (0.5 * width * scale * np.array((0.7, 1.0, 0.25)))[:, None]
    rows = np.stack([middle - across * half - out * half, middle, middle + across * half - out * half], 1)
    weights = np.repeat([pin.on(figure.pack.weights) for pin in pins], 3, axis=0)
    sheet = rigid_sheet(rows.reshape(-1, 3), skin_faces(3, 3, False), weights)
    shade = np.full(len(sheet.points), rng.uniform(0.85, 1.2))
    return Whiskers(sheet, shade, {key: np.repeat([pin.on(o) for pin in pins], 3, axis=0) for key, o in keys.items()})
