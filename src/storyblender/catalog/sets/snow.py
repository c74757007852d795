"""Snow on a set: the ground is white, trees and hedges are laden, grass and flowers are under it. Pure."""

from __future__ import annotations

from storyblender.catalog.set_plan import Piece, SetPlan, Slab

_LADEN = frozenset({"broad_tree", "pine_tree", "palm_tree", "bush", "hedge", "vine_row"})
_BURIED = frozenset({"grass_tuft", "flowers", "fern", "reeds", "puddle", "road_marking"})
_SWEPT = ("water", "pool", "asphalt", "plank", "board", "concrete", "paint", "hull", "void")
"""Finishes that stay as they are: water, what is driven on, decks and quays."""


def under_snow(plan: SetPlan) -> SetPlan:
    """Return a set after snow has fallen; of a room, what is seen through its windows."""
    return plan.model_copy(
        update={
            "slabs": tuple(_snowed(slab, indoor=plan.indoor) for slab in plan.slabs),
            "pieces": tuple(_laden(piece) for piece in plan.pieces if piece.part not in _BURIED),
        }
    )


def _snowed(slab: Slab, *, indoor: bool) -> Slab:
    lies_open = slab.role == "patch" and slab.z < 0 if indoor else slab.role in ("ground", "patch")
    if not lies_open or any(word in slab.material for word in _SWEPT):
        return slab
    return slab.model_copy(update={"material": "snow", "wet": False})


def _laden(piece: Piece) -> Piece:
    if piece.part == "terrain":
        return piece.model_copy(update={"params": {**piece.params, "material": "snow"}})
    return piece.model_copy(update={"params": {**piece.params, "snow": True}}) if piece.part in _LADEN else piece
