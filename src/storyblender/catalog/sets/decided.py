"""What a person decided about the surfaces and the furniture of a set, on top of what its kit draws. Pure."""

from __future__ import annotations

import math

from storyblender.catalog.props import PROPS
from storyblender.catalog.set_plan import Furnishing, Piece, SetPlan, Slab
from storyblender.memory.asset_sheet import AssetDecision
from storyblender.memory.base import Vec2
from storyblender.memory.scene_context import Environment
from storyblender.memory.texture import Texture

_ON_IT = 0.12
"""Metres between the top of a piece of furniture and the underside of what stands on it."""
_TERRAIN = "terrain"


def with_decisions(plan: SetPlan, environment: Environment) -> SetPlan:
    """Return the plan of a set with the materials and the furniture that a person decided.

    Args:
        plan: As the kit draws it.
        environment: Its walls, ground, their pictures and furniture are what was decided.
    """
    update: dict[str, object] = {}
    if walls := _surface(environment.walls, environment.wall_texture):
        update["walls"] = tuple(wall.model_copy(update={**walls, "dado": None}) for wall in plan.walls)
    if ground := _surface(environment.ground, environment.ground_texture):
        update["slabs"] = tuple(
            slab.model_copy(update=ground) if is_ground(slab, plan) else slab for slab in plan.slabs
        )
    update["pieces"] = tuple(_finished(piece, environment) for piece in plan.pieces)
    if environment.furniture:
        update["furnishings"] = _refurnished(plan.furnishings, environment.furniture)
    return plan.model_copy(update=update)


def _surface(finish: str | None, texture: Texture | None) -> dict[str, object]:
    """Return the fields of a wall or a slab that its surface is told by; those that nobody decided are left out."""
    return {name: value for name, value in (("material", finish), ("texture", texture)) if value is not None}


def has_walls(plan: SetPlan) -> bool:
    """Return whether a set has walls that can be made of something else."""
    return any(not wall.missing for wall in plan.walls) or any(map(_is_facade, plan.pieces))


def has_ground(plan: SetPlan) -> bool:
    """Return whether a set has a floor or a ground that can be made of something else."""
    return any(is_ground(slab, plan) for slab in plan.slabs) or any(piece.part == _TERRAIN for piece in plan.pieces)


def is_ground(slab: Slab, plan: SetPlan) -> bool:
    """Return whether a slab is what people of the set stand on."""
    return slab.role == ("floor" if plan.indoor and any(each.role == "floor" for each in plan.slabs) else "ground")


def _is_facade(piece: Piece) -> bool:
    return piece.part == "facade" and "material" in piece.params


def _finished(piece: Piece, environment: Environment) -> Piece:
    """Return a facade, or terrain, in the material that was decided."""
    if _is_facade(piece):
        surface = _surface(environment.walls, environment.wall_texture)
    else:
        surface = _surface(environment.ground, environment.ground_texture) if piece.part == _TERRAIN else {}
    if "material" in surface:
        surface["params"] = {**piece.params, "material": surface.pop("material")}
    return piece.model_copy(update=surface) if surface else piece


def _refurnished(
    furnishings: tuple[Furnishing, ...], decided: dict[str, AssetDecision | None]
) -> tuple[Furnishing, ...]:
    """Return furnishings with what was put in the place of some; what stood on one that is gone goes with it."""
    kept: list[Furnishing] = []
    for item in furnishings:
        base = next((each for each in furnishings if each.node_id in decided and _stands_on(item, each)), None)
        if item.node_id in decided:
            other = decided[item.node_id]
            kept += [_replaced(item, other)] if other is not None else []
        elif base is None:
            kept.append(item)
        elif (other := decided[base.node_id]) is not None and not PROPS[other.prop].seats:
            x, y, z = item.location
            rise = _size(_replaced(base, other))[2] - _size(base)[2]
            kept.append(item.model_copy(update={"location": (x, y, z + rise)}))
    return tuple(kept)


def _replaced(item: Furnishing, other: AssetDecision) -> Furnishing:
    """Return another prop in the place of a furnishing; its back stays where it was, at the wall."""
    made = {"prop": other.prop, "params": other.params, "required": True, "loose": False}
    replaced = item.model_copy(update=made)
    turn, deeper = math.radians(item.yaw), (_size(replaced)[1] - _size(item)[1]) / 2
    x, y, z = item.location
    place = (x + deeper * math.sin(turn), y - deeper * math.cos(turn), z)
    return replaced.model_copy(update={"location": place})


def _stands_on(item: Furnishing, base: Furnishing) -> bool:
    """Return whether a furnishing stands on another."""
    width, depth, height = _size(base)
    x, y = _local(item.location[:2], base)
    lifted = item.location[2] - base.location[2]
    on_top = abs(lifted - height) < _ON_IT or (0.2 < lifted < height and PROPS[base.prop].seats > 0)
    return item is not base and on_top and abs(x) <= width / 2 and abs(y) <= depth / 2


def _local(point: Vec2, base: Furnishing) -> Vec2:
    dx, dy, turn = point[0] - base.location[0], point[1] - base.location[1], math.radians(-base.yaw)
    return dx * math.cos(turn) - dy * math.sin(turn), dx * math.sin(turn) + dy * math.cos(turn)


def _size(item: Furnishing) -> tuple[float, float, float]:
    usual = PROPS[item.prop].size if item.prop in PROPS else (0.6, 0.6, 0.8)
    width, depth, height = (
        float(item.params.get(name, size)) for name, size in zip(("width", "depth", "height"), usual, strict=True)
    )
    return width, depth, height
