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
            "slabs": tuple(
                _snowed(slab) if _open(slab, plan) else slab for slab in plan.slabs if not _path(slab, plan)
            ),
            "pieces": tuple(_laden(piece) for piece in plan.pieces if piece.part not in _BURIED),
        }
    )


def _open(slab: Slab, plan: SetPlan) -> bool:
    """Return whether snow lies on a part of the ground."""
    lies_open = slab.role == "patch" and slab.z < 0 if plan.indoor else slab.role in ("ground", "patch")
    return lies_open and not any(word in slab.material for word in _SWEPT)


def _path(slab: Slab, plan: SetPlan) -> bool:
    """Return whether a part of the ground is not seen under snow: a path over a lawn."""
    return not plan.indoor and slab.role == "patch" and 0 <= slab.z < 0.05 and _open(slab, plan)


def _snowed(slab: Slab) -> Slab:
    """Return a slab with snow on it."""
    return slab.model_copy(update={"material": "snow", "wet": False})


def _laden(piece: Piece) -> Piece:
    """Return a piece with snow on it."""
    if piece.part == "terrain":
        return piece.model_copy(update={"params": {**piece.params, "material": "snow"}})
    return piece.model_copy(update={"params": {**piece.params, "snow": True}}) if piece.part in _LADEN else piece
