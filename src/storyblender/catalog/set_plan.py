"""The plan of a set: walls, ground, structures, furniture, lamps, marks. What a set kit returns; pure data.

A kit is one function ``draw(params, rng) -> SetPlan`` in ``catalog/sets/``; Blender builds the plan from shared
parts, the planners read it (walls to stay inside, furniture to stage on, marks to enter from).
World frame of the scene: metres, Z up, the audience sits at -Y looking to +Y.
"""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from storyblender.catalog.registry import ParamValue
from storyblender.memory.base import Frozen, Identifier, Vec2, Vec3, is_none
from storyblender.memory.scene_context import Light, SceneSize
from storyblender.memory.texture import Texture


class Opening(Frozen):
    """A hole in a wall."""

    name: Identifier
    kind: Literal["door", "window", "arch", "gap"]
    x: float
    """Distance of its left edge from the wall's start, along the wall."""
    sill: float = 0.0
    width: float
    height: float
    style: str = ""
    """door: panel, glass, double, cell, lift, paper, bus; window: sash, grid, shop, blinds, curtains, bars, paper,
    rubber (a vehicle's); mouth is a bare hole, open no wall at all."""
    state: Literal["open", "closed"] = "closed"


class Wall(Frozen):
    """A straight wall from ``start`` to ``end``; the room is on the left-hand side when walking start to end."""

    node_id: Identifier
    start: Vec2
    end: Vec2
    height: float
    base: float = 0.0
    """Height of its foot above the floor."""
    thickness: float = 0.15
    material: Identifier
    texture: Texture | None = Field(default=None, exclude_if=is_none)
    """Pictures that it is made of, in place of the material."""
    dado: Identifier | None = None
    dado_height: float = 1.0
    openings: tuple[Opening, ...] = ()
    wild: bool = True
    """May be taken away for a shot."""

    @property
    def missing(self) -> bool:
        """Whether nothing is built: the wall only marks where the set ends."""
        return any(hole.style == "open" for hole in self.openings)


class Slab(Frozen):
    """A horizontal sheet or block: floor, rug, road, lawn, stage, ceiling, roof."""

    node_id: Identifier
    role: Literal["floor", "ground", "ceiling", "patch", "block"]
    polygon: tuple[Vec2, ...]
    """Counter-clockwise corners."""
    z: float = 0.0
    """Top surface for floor, ground, patch and block; bottom surface for ceiling."""
    thickness: float = 0.0
    material: Identifier
    texture: Texture | None = Field(default=None, exclude_if=is_none)
    """As of a wall."""
    wet: bool = False
    beams: int = 0
    """ceiling: number of beams across."""


class Piece(Frozen):
    """One part of the set that is neither wall nor slab, made by a builder of ``blender/sets/pieces``."""

    node_id: Identifier
    part: Identifier
    """Key of the part registry: facade, arch, column, stairs, railing, kerb, fence, tree, rock, cliff, ..."""
    location: Vec3
    yaw: float = 0.0
    scale: float = 1.0
    params: dict[str, ParamValue] = {}
    texture: Texture | None = Field(default=None, exclude_if=is_none)
    """Pictures in place of the finish that its parameter ``material`` names."""
    solid: bool = True
    """People walk around it."""
    footprint: Vec2 | None = None
    """Width, depth in metres, for solid parts."""
    wild: bool = False


class Backdrop(Frozen):
    """What is seen through windows and at the ends of the world, so that no frame shows a void."""

    node_id: Identifier
    kind: Literal["skyline", "treeline", "hills", "sea", "facades", "stars", "deep", "plain"]
    corners: tuple[Vec3, Vec3, Vec3, Vec3]
    """Lower left, lower right, upper right, upper left as seen from the set."""
    emission: float = 0.5


class Furnishing(Frozen):
    """A prop of ``catalog.props`` that belongs to this kind of place."""

    node_id: Identifier
    prop: Identifier
    location: Vec3
    yaw: float = 0.0
    params: dict[str, ParamValue] = {}
    required: bool = True
    """False: dressing, dropped first when room is short."""
    loose: bool = False
    """Whether it is a small thing lying about, which no prop of the script replaces."""


class PlanMark(Frozen):
    """A named place for people: where one enters, stands at the bar, waits, speaks."""

    name: Identifier
    location: Vec3
    yaw: float = 0.0
    tags: tuple[str, ...] = ()
    """``enter``, ``exit``, ``centre``, ``bar``, ``window``, ``door``, ``table`` ..."""


class SetPlan(Frozen):
    """Everything a place is made of."""

    kit: Identifier
    indoor: bool
    size: SceneSize
    """The playing area: people and props stay inside it."""
    walls: tuple[Wall, ...] = ()
    slabs: tuple[Slab, ...] = ()
    pieces: tuple[Piece, ...] = ()
    backdrops: tuple[Backdrop, ...] = ()
    furnishings: tuple[Furnishing, ...] = ()
    lamps: tuple[Light, ...] = ()
    """The place's own lamps at their night strength; the Lighting Arranger switches and tints them."""
    marks: tuple[PlanMark, ...] = ()

    @property
    def textures(self) -> tuple[Texture, ...]:
        """All pictures that its parts are made of; each once."""
        parts = (*self.walls, *self.slabs, *self.pieces)
        return tuple({part.texture: None for part in parts if part.texture is not None})

    @property
    def under_the_sky(self) -> bool:
        """Whether the sky lights it: out of doors, and in a car on a street."""
        return not self.indoor or any(wall.missing for wall in self.walls)
