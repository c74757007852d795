"""The builders of props by key of ``catalog.props``, and what each is given to build: a ``PropSpec``."""

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
from storyblender.memory.base import Vec3

Anchors = tuple[Anchor, ...]
Builder = Callable[[MeshBuilder, "PropSpec"], Anchors]
"""A recipe: adds the parts of a prop to the mesh builder, as the spec wants it, and returns its anchors.

Both are in one frame: metres, front -Y, up +Z; afterwards the prop's bottom centre becomes the origin.
"""

_BUILDERS: dict[str, Builder] = {}


@dataclass(frozen=True)
class PropSpec:
    """What is to be built.

    Attributes:
        entry: The catalog entry.
        size: Width, depth, height in metres to build to.
        params: The entry's parameters with the wanted values.
        rng: For everything that varies from one copy to the next.
        lettered: Whether writing comes onto it.
    """

    entry: PropEntry
    size: Vec3
    params: dict[str, ParamValue]
    rng: np.random.Generator
    lettered: bool = False

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
