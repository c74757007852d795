"""Props that nobody holds any more though no action puts them down: they rest where they plausibly were put."""

from __future__ import annotations

import math

from storyblender.agents.visual_effects_artist.handling import CASE_DEPTH, fits_in_clothes
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.prop_spots import PropSpots
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.memory.base import Vec3
from storyblender.memory.shot_context import ShotContext

ARMS_REACH = 1.2
"""Metres from a person to the top on which they have put a prop between two shots."""
AT_FEET = 0.45
"""Metres from a person to a prop on the floor where there is no free spot beside them."""


def held_props(stage: StageState) -> dict[str, StagedPerson]:
    """Return the props in the hands of people on stage, with who holds them."""
    return {prop: person for person in stage.people.values() if person.present for prop in person.held.values()}


def lay_left_props(stage: StageState, held: dict[str, StagedPerson], shot: ShotContext) -> None:
    """Lay down the props that were in hand and are in none now; what fits is in clothes and not seen.

    Args:
        stage: The people and props as the shot begins.
        held: Props that were in hand before it, with who held them.
        shot: The shot.
    """
    spots = PropSpots(stage)
    for prop, person in held.items():
        gone = prop in shot.absent or prop in stage.prop_places or stage.holder_of(prop) is not None
        if gone or not person.present or prop in stage.players.values():
            continue
        told = stage.scripted_props.told_place(prop)
        if told is not None:
            stage.lay_down(prop, told)
        elif not fits_in_clothes(stage.size_of(prop)):
            stage.lay_down(prop, _place_near(stage, spots, person, prop))


def _place_near(stage: StageState, spots: PropSpots, person: StagedPerson, prop: str) -> Vec3:
    """Return a spot for a prop on the nearest top within arm's reach, else on the floor beside a person."""
    top = None if spots.is_bag(prop, min_depth=CASE_DEPTH) else stage.floor.nearest_top(person.place, ARMS_REACH)
    if top is not None:
        return spots.find_on(top, person, prop)
    x, y = person.place
    ahead = AT_FEET * person.scale
    return spots.find_beside(person, prop, None) or (
        x + ahead * math.sin(person.yaw), y - ahead * math.cos(person.yaw), 0.0
    )  # fmt: skip
