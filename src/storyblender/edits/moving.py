"""What a person is to do in a shot, as an edit says it: names become ids, and what cannot be is refused."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches

from storyblender.agents.visual_effects_artist.speeches import SPOKEN
from storyblender.catalog.motions import MOTIONS, STANDING
from storyblender.edits.effect import name_of
from storyblender.edits.posing import held_thing, looked_at
from storyblender.errors import InputError
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_decision import DecidedMotion
from storyblender.memory.shot_context import ShotContext

Motions = Mapping[str, DecidedMotion | None]


def as_moved(
    graph: ContinuityMemoryGraph, shot: ShotContext, person: str, motions: Motions
) -> dict[str, DecidedMotion | None]:
    """Return motions with the ids of what they are aimed at and done with.

    Args:
        graph: The story.
        shot: The shot.
        person: Asset id.
        motions: By key; None for one that is taken away; a clip of the user's own says which.

    Raises:
        InputError: There is no such motion, person or thing, or it is the script's, or a posture.
    """
    scene = graph.scene(shot.scene_id)
    own = {action.motion for action in shot.character_actions if action.asset_id == person}
    decided = shot.blocking_decision.people.get(person) if shot.blocking_decision is not None else None
    own |= {key for key, motion in (decided.motions if decided is not None else {}).items() if motion is not None}
    found: dict[str, DecidedMotion | None] = {}
    for key, motion in motions.items():
        _refuse(name_of(shot), person, key, motion, own)
        if motion is None:
            found[key] = None
            continue
        update: dict[str, object] = {}
        if motion.target is not None:
            update["target"] = looked_at(graph, scene, person, motion.target)
        if motion.prop is not None:
            update["prop"] = held_thing(graph, scene, motion.prop)
        found[key] = motion.model_copy(update=update)
    return found


def merged_motions(before: Motions, now: Motions) -> dict[str, DecidedMotion | None]:
    """Return motions with later decisions on top, field by field.

    Args:
        before: What was decided before.
        now: What is decided now.
    """
    both = {
        key: was.then(motion)
        for key, motion in now.items()
        if (was := before.get(key)) is not None and motion is not None
    }
    return {**before, **now, **both}


def _refuse(name: str, person: str, key: str, motion: DecidedMotion | None, own: set[str]) -> None:
    """Refuse a motion that is unknown, that is not there to be taken away, or that something else decides."""
    if motion is not None and motion.mocap is not None and key not in MOTIONS:
        return
    if key not in MOTIONS and key not in own:
        near = get_close_matches(key, MOTIONS, n=3, cutoff=0.5)
        listed = "`storyblender catalog motions` lists them; your own clips lie in the folder that --motions names"
        mend = f"did you mean {', '.join(near)}?" if near else listed
        raise InputError(f"there is no motion {key!r}", mend=mend)
    if motion is None and key not in own:
        does = ", ".join(sorted(own)) or "nothing"
        raise InputError(f"{person} does not {key} in {name}", mend=f"they do: {does}")
    if key in SPOKEN and (motion is None or key not in own):
        raise InputError("who speaks is the script's", mend="change the line in the script")
    if motion is not None and key not in own and (MOTIONS[key].after not in (None, "stand") or key in STANDING):
        raise InputError(f"{key} changes the posture", mend="set the posture at the end of the shot instead")
