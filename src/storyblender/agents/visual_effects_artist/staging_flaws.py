"""Flaws of staging: what a staged shot does not do as its words say, for ``check`` and the page."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from storyblender.agents.frame_critic.frame_view import actions_to_see, things_to_see
from storyblender.agents.layout_artist.story_moment import cues_of
from storyblender.catalog.motions import MOTIONS
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.shot_context import Flaw, ShotContext


def staging_flaws(shot: ShotContext, assets: Mapping[str, Asset], left_out: Collection[str]) -> tuple[Flaw, ...]:
    """Return a staged shot's cheats, actions that are not staged, things left out of the set, and stand-ins.

    Args:
        shot: The shot with its cues.
        assets: Assets of the story by asset id.
        left_out: Asset ids of the scene's things for which no place was found.
    """
    return (
        *shot.flaws,
        *_find_actions_not_staged(shot),
        *_find_things_left_out(shot, left_out),
        *_find_stand_ins(shot, assets),
    )


def _find_actions_not_staged(shot: ShotContext) -> Iterator[Flaw]:
    """Yield a flaw for every action to be seen that no cue, posture or walk stages."""
    postures = {each.start.asset_id: {each.start.posture, each.end.posture} for each in shot.blocking}
    walkers = {cue.asset_id for cue in shot.cues if MOTIONS[cue.clip].speed is not None}
    for action in actions_to_see(shot):
        motion, person = MOTIONS[action.motion], action.asset_id
        taken = motion.after in postures.get(person, ()) or (motion.speed is not None and person in walkers)
        if person in shot.on_stage and not taken and not cues_of(action, shot):
            message = f"{person} is not shown doing: “{action.action_description}”"
            yield Flaw(kind="undone", subject=person, message=message)


def _find_things_left_out(shot: ShotContext, left_out: Collection[str]) -> Iterator[Flaw]:
    """Yield a flaw for every thing to be seen that has no place in the set."""
    there = {state.asset_id for state in shot.prop_states if state.visible}
    for thing in things_to_see(shot):
        if thing in left_out and thing not in there:
            yield Flaw(kind="left_out", subject=thing, message=f"no place was found for {thing}: it is left out")


def _find_stand_ins(shot: ShotContext, assets: Mapping[str, Asset]) -> Iterator[Flaw]:
    """Yield a flaw for every thing to be seen that another prop stands in for."""
    for thing in things_to_see(shot):
        asset = assets.get(thing)
        if asset is not None and asset.canonical is not None and asset.canonical.is_stand_in:
            shown = asset.canonical.key.replace("_", " ")
            yield Flaw(kind="stand_in", subject=thing, message=f"{thing} is stood in for by: {shown}")
