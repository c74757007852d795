"""What a staged shot does not do as it was read: kept on the shot, told by `check` and on the page, never dropped."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from storyblender.agents.frame_critic.frame_view import actions_to_see, things_to_see
from storyblender.agents.layout_artist.story_moment import cues_of
from storyblender.catalog.motions import clip_of
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.shot_context import Flaw, ShotContext


def staging_flaws(shot: ShotContext, assets: Mapping[str, Asset], left_out: Collection[str]) -> tuple[Flaw, ...]:
    """Return a staged shot's cheats, actions without a performer, things left out of the set, and things stood in for.

    Args:
        shot: With its cues.
        assets: Of the story, by asset id.
        left_out: Asset ids of the scene's things for which no place was found.
    """
    return (*shot.flaws, *_undone(shot), *_left_out(shot, left_out), *_stood_in(shot, assets))


def _undone(shot: ShotContext) -> Iterator[Flaw]:
    postures = {each.start.asset_id: {each.start.posture, each.end.posture} for each in shot.blocking}
    walkers = {cue.asset_id for cue in shot.cues if clip_of(cue.clip).speed is not None}
    for action in actions_to_see(shot):
        motion, person = clip_of(action.motion), action.asset_id
        taken = motion.after in postures.get(person, ()) or (motion.speed is not None and person in walkers)
        if person in shot.on_stage and not taken and not cues_of(action, shot):
            message = f"{person} does not do what is told: “{action.action_description}”"
            yield Flaw(kind="undone", subject=person, message=message)


def _left_out(shot: ShotContext, left_out: Collection[str]) -> Iterator[Flaw]:
    there = {state.asset_id for state in shot.prop_states if state.visible}
    for thing in things_to_see(shot):
        if thing in left_out and thing not in there:
            yield Flaw(kind="left_out", subject=thing, message=f"no place was found for {thing}: it is left out")


def _stood_in(shot: ShotContext, assets: Mapping[str, Asset]) -> Iterator[Flaw]:
    for thing in things_to_see(shot):
        asset = assets.get(thing)
        if asset is not None and asset.canonical is not None and asset.canonical.is_stand_in:
            shown = asset.canonical.key.replace("_", " ")
            yield Flaw(kind="stand_in", subject=thing, message=f"{thing} is stood in for by: {shown}")
