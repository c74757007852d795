"""The state of every prop that has left its place: in a hand, on a body, lying somewhere else, or out of sight."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.scripted_props import hide_absent_props
from storyblender.catalog.carrying import body_place_of
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Vec3
from storyblender.memory.shot_context import PropState, ShotContext
from storyblender.memory.vocabulary import BodyPlace


def find_prop_states(
    shot: ShotContext,
    touched: Iterable[str],
    lying: Mapping[str, Vec3],
    holder: Callable[[str], StagedPerson | None],
    assets: Mapping[str, Asset],
) -> tuple[PropState, ...]:
    """Return the states of the props that have left their places in the layout.

    Args:
        shot: The shot.
        touched: Asset ids of these props.
        lying: Position in metres of each prop that nobody has, by asset id.
        holder: Returns the person who has a prop.
        assets: Assets of the scene by asset id.
    """
    states, instruction = [], shot.camera_instruction
    inserted = instruction.focus_on_ids if instruction.kind == "insert" else ()
    for prop in touched:
        person, place = holder(prop), lying.get(prop)
        if place is None and prop in inserted and (person is None or person.asset_id not in shot.on_stage):
            continue  # an insert shows the thing: it stays at its layout place
        if person is not None and person.asset_id in shot.on_stage:
            hand, on = person.hand_of(prop), _find_body_place(person, prop, assets)
            seen = hand is not None or on is not None
            states.append(PropState(asset_id=prop, visible=seen, held_by=person.asset_id, hand=hand, place=on))
        elif person is not None:
            states.append(PropState(asset_id=prop, visible=False, hand=person.hand_of(prop)))
        else:
            location = (round(place[0], 3), round(place[1], 3), round(place[2], 3)) if place else None
            states.append(PropState(asset_id=prop, visible=place is not None, location=location))
    return hide_absent_props(tuple(states), shot)


def _find_body_place(person: StagedPerson, prop: str, assets: Mapping[str, Asset]) -> BodyPlace | None:
    """Return the body part on which a person carries a prop; None if a hand has it or their clothes already show it."""
    if prop not in person.on_body:
        return None
    canonical = assets[prop].canonical if prop in assets else None
    key = canonical.key if canonical is not None else None
    look = assets[person.asset_id].decided_look if person.asset_id in assets else None
    clothes = {garment.key for garment in look.garments} if look is not None else set[str]()
    return None if key in clothes else body_place_of(person.on_body[prop], key)
