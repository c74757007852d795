"""The builders of props by key, and the vocabulary they speak: a spec comes in, parts and anchors go out."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import bpy
import numpy as np

from storyblender.blender.materials import material
from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.catalog.materials import hex_color
from storyblender.catalog.props.entry import PropEntry
from storyblender.memory.asset_sheet import Anchor, ParamValue
from storyblender.memory.base import Vec2, Vec3

Anchors = tuple[Anchor, ...]
Builder = Callable[[MeshBuilder, "PropSpec"], Anchors]

_BUILDERS: dict[str, Builder] = {}


@dataclass(frozen=True)
class PropSpec:
    """What is to be built.

    Attributes:
        entry: The catalog entry.
        size: Width, depth, height in metres to build to.
        params: The entry's parameters with the wanted values.
        rng: For everything that varies from one copy to the next.
    """

    entry: PropEntry
    size: Vec3
    params: dict[str, ParamValue]
    rng: np.random.Generator

    def material(self, role: str) -> bpy.types.Material:
        """Return the material of a role; the first role takes ``color`` and ``material`` from the parameters, what is
        drunk its colour from ``drink``.
        """
        key = self.entry.materials[role]
        if role == "drink" and self.params.get("drink"):
            return material(key, hex_color(str(self.params["drink"])))
        if role != next(iter(self.entry.materials)):
            return material(key)
        color = str(self.params.get("color", ""))
        return material(str(self.params.get("material", "")) or key, hex_color(color) if color else None)

    def number(self, name: str) -> float:
        """Return a numeric parameter."""
        return float(self.params[name])

    def count(self, name: str) -> int:
        """Return a whole-number parameter, at least 1."""
        return max(1, round(float(self.params[name])))

    def flag(self, name: str) -> bool:
        """Return a yes/no parameter."""
        return bool(self.params[name])

    def word(self, name: str) -> str:
        """Return a parameter that names a variant."""
        return str(self.params[name])


def prop(key: str) -> Callable[[Builder], Builder]:
    """Register a builder for a key of ``catalog.props``."""

    def register(builder: Builder) -> Builder:
        if key in _BUILDERS:
            raise ValueError(f"prop {key!r} has two builders")
        _BUILDERS[key] = builder
        return builder

    return register


@cache
def builders() -> dict[str, Builder]:
    """Return every builder, after importing all modules of this package."""
    package = importlib.import_module("storyblender.blender.props")
    for module in sorted(info.name for info in pkgutil.iter_modules(package.__path__)):
        importlib.import_module(f"{package.__name__}.{module}")
    return _BUILDERS


# ---------------------------------------------------------------------- anchors


def seat(location: Vec3, size: Vec2, direction: Vec3 = (0.0, -1.0, 0.0), name: str = "") -> Anchor:
    """Return a seat.

    Args:
        location: Middle of its front edge, at sitting height.
        size: Width and depth.
        direction: Where the sitter faces.
        name: For assets with several seats.
    """
    return Anchor(kind="seat", name=name, location=location, direction=direction, size=size)


def seats_in_row(count: int, width: float, front: float, height: float, depth: float) -> Anchors:
    """Return ``count`` seats side by side over ``width``, all facing -Y; ``front`` is the y of their front edge."""
    step = width / count
    places = [(i - (count - 1) / 2) * step for i in range(count)]
    return tuple(seat((x, front, height), (step, depth), name=f"seat_{i + 1}") for i, x in enumerate(places))


def lean(location: Vec3, width: float, direction: Vec3 = (0.0, 1.0, 0.0), name: str = "") -> Anchor:
    """Return a rail or edge to lean on; ``direction`` is where the leaning person faces."""
    return Anchor(kind="lean", name=name, location=location, direction=direction, size=(width, 0.0))


def grip(name: str, location: Vec3, fingers: Vec3, palm: Vec3, curl: Vec3) -> Anchor:
    """Return a grip.

    Args:
        name: Ends in ``_r`` or ``_l`` for the hand it is made for; see ``two_hands``.
        location: Palm centre.
        fingers: Direction of the fingers.
        palm: The palm's normal, into the object.
        curl: 0..1 of index, other fingers, thumb.
    """
    return Anchor(kind="grip", name=name, location=location, direction=fingers, normal=palm, curl=curl)


def two_hands(location: Vec3, fingers: Vec3, palm: Vec3, curl: Vec3, name: str = "grip") -> Anchors:
    """Return a grip for the right hand and its mirror image for the left; named ``grip_r`` and ``grip_l``."""

    def mirrored(vector: Vec3) -> Vec3:
        return (-vector[0], vector[1], vector[2])

    return (
        grip(f"{name}_r", location, fingers, palm, curl),
        grip(f"{name}_l", mirrored(location), mirrored(fingers), mirrored(palm), curl),
    )


def handle(location: Vec3, direction: Vec3 = (0.0, -1.0, 0.0), name: str = "") -> Anchor:
    """Return a place to open it by; ``direction`` is the way it is pulled."""
    return Anchor(kind="handle", name=name, location=location, direction=direction)
