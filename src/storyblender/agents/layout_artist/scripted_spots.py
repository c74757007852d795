"""Spots of things in the script before anyone moves them."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.memory.scene_context import Relation, SceneSetup, Spot
from storyblender.memory.shot_context import ShotContext


def find_scripted_spots(setup: SceneSetup, shots: Sequence[ShotContext]) -> dict[str, Spot]:
    """Return the spot of each thing when it is first seen, by asset id.

    A thing that a person holds or handles before that is left out: it stays where they leave it.

    Args:
        setup: The setup, with the relations as the scene opens.
        shots: The shots of the scene, in order.
    """
    told = {
        each.asset_id: Spot(relation=each.kind, anchor_id=each.anchor_asset_id) for each in reversed(setup.relations)
    }
    moved: set[str] = set()
    seen: set[str] = set()
    for shot in shots:
        moved |= {prop for state in shot.states for prop in state.held}
        moved |= {action.prop_id for action in shot.character_actions if action.prop_id is not None}
        for thing, spot in shot.thing_spots.items():
            at_wall = spot.height is not None or spot.relation == "against"
            if (spot.anchor_id is not None or at_wall) and thing not in seen and thing not in moved:
                told[thing] = spot
            seen.add(thing)
    return told


def scripted_relations(setup: SceneSetup, shots: Sequence[ShotContext]) -> tuple[Relation, ...]:
    """Return the spots of things and people as relations, for the Set Dresser.

    Args:
        setup: Has the relations as the scene opens.
        shots: The shots of the scene, in order; a person's first spot counts.
    """
    own = {asset_id: relation for relation in reversed(setup.relations) for asset_id in (relation.asset_id,)}
    people = {state.asset_id: state.spot for shot in reversed(shots) for state in shot.states if state.spot is not None}
    for asset_id, spot in {**people, **find_scripted_spots(setup, shots)}.items():
        if spot.anchor_id is not None and spot.anchor_id != asset_id:
            own[asset_id] = Relation(asset_id=asset_id, kind=spot.relation, anchor_asset_id=spot.anchor_id)
    return tuple(own.values())
