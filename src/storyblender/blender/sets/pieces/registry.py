"""The builders of set pieces by key. Frame of a piece: its plan location, front -Y, +Z up, metres."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import bpy
import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, painted, pane
from storyblender.blender.sets.textured import skin_of
from storyblender.blender.tags import Surface
from storyblender.catalog.registry import ParamValue
from storyblender.catalog.set_plan import Piece
from storyblender.memory.texture import Texture

PieceBuilder = Callable[[MeshBuilder, "PieceSpec"], None]
"""A recipe: adds the parts of a set piece to the mesh builder, in the piece's frame, as the spec wants it."""

PIECES: dict[str, tuple[PieceBuilder, Surface]] = {}
"""Part -> its builder and how ink and light treat it; filled by ``piece``."""


@dataclass(frozen=True)
class PieceSpec:
    """The parameters of one piece, with defaults asked for by its builder.

    Attributes:
        params: As the kit gave them.
        scene: Whose daylight its lit windows follow.
        rng: For what varies; the same parameters give the same piece.
        texture: Pictures in place of the finish of the parameter ``material``.
    """

    params: dict[str, ParamValue]
    scene: bpy.types.Scene
    rng: np.random.Generator
    texture: Texture | None = None

    def number(self, name: str, default: float) -> float:
        """Return the length, angle or count ``name``; ``default`` if the kit does not give it."""
        return float(self.params.get(name, default))

    def flag(self, name: str) -> bool:
        """Return a yes/no parameter; no if it is not given."""
        return bool(self.params.get(name, False))

    def word(self, name: str, default: str) -> str:
        """Return the name of a variant; ``default`` if the kit does not give it."""
        return str(self.params.get(name, default))

    def finish(self, name: str, default: str) -> bpy.types.Material:
        """Return the material of the finish that the parameter ``name``, or else ``default``, is the key of."""
        return skin_of(str(self.params.get(name, default)), self.texture if name == "material" else None)

    def leaf(self, key: str) -> bpy.types.Material:
        """Return the material of leaves, or of the snow on them where it lies."""
        return finish("leaf_snow" if self.flag("snow") else key)

    def paint(self, name: str, default: str) -> bpy.types.Material:
        """Return paint in the hex colour of the parameter ``name``, or else of ``default``."""
        return painted(str(self.params.get(name, default)))

    def pane(self, key: str) -> bpy.types.Material:
        """Return a window with light behind it."""
        return pane(key, self.scene)


def piece(key: str, surface: Surface = Surface.SET) -> Callable[[PieceBuilder], PieceBuilder]:
    """Register the decorated function as the builder of a set piece.

    Args:
        key: Key of the piece, as kits call it.
        surface: How ink and light treat it.

    Raises:
        ValueError: The key has a builder already.
    """

    def register(builder: PieceBuilder) -> PieceBuilder:
        if key in PIECES:
            raise ValueError(f"set piece {key!r} has two builders")
        PIECES[key] = (builder, surface)
        return builder

    return register


@cache
def _load() -> None:
    """Import all modules of this package, once, so that their builders are registered."""
    package = importlib.import_module("storyblender.blender.sets.pieces")
    for module in sorted(info.name for info in pkgutil.iter_modules(package.__path__)):
        importlib.import_module(f"{package.__name__}.{module}")


def piece_mesh(plan: Piece, scene: bpy.types.Scene) -> tuple[bpy.types.Mesh, Surface]:
    """Build the mesh of a set piece.

    Args:
        plan: The piece, of a set's plan.
        scene: Scene whose daylight its lit windows follow.

    Returns:
        A new mesh in the piece's own frame, and how ink and light treat it.

    Raises:
        KeyError: No builder makes this part.
    """
    _load()
    builder, surface = PIECES[plan.part]
    seed = int(float(plan.params.get("seed", plan.params.get("variant", 0.0))))
    mesh = MeshBuilder(plan.part)
    builder(mesh, PieceSpec(plan.params, scene, np.random.default_rng(seed), plan.texture))
    return mesh.mesh(), surface
