"""Edits of motion by hand: what a person animated in Blender moves in its shot, or is given back to the crew."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.edits.effect import Effect, name_of, refuse_locked, shot_names
from storyblender.edits.targets import person_or_thing, shots_named
from storyblender.errors import InputError
from storyblender.memory.base import shot_name, staged_id
from storyblender.memory.edits import ByHandEdit, Edit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.motion_by_hand import by_hand_file
from storyblender.pipeline.hand_motions import can_be_animated, read_motion
from storyblender.project import Project


def by_hand_effects(graph: ContinuityMemoryGraph, edit: ByHandEdit) -> list[Effect]:
    """Return what a motion by hand does to its shot: the scene is packed again, and cameras stay.

    Args:
        graph: The story.
        edit: A character or a thing that moves in the shot.

    Raises:
        InputError: They are not in the shot, what is given back is not there, or the blocking is locked.
    """
    [shot] = shots_named(graph, [edit.shot])
    name, who = name_of(shot), person_or_thing(graph, edit.who)
    refuse_locked(shot, "blocking")
    if shot.covers is not None:
        staged = shot_name(shot.scene_id, staged_id(shot.shot_id))
        raise InputError(f"{name} shows what is staged for {staged}", mend="animate it there")
    if edit.motion is None and who not in shot.motion_by_hand:
        there = ", ".join(shot.motion_by_hand) or "nobody"
        raise InputError(f"{who} is not animated by hand in {name}", mend=f"there is: {there}")
    if not can_be_animated(graph, shot, who):
        raise InputError(f"{who} is not in {name}", mend=f"there are: {', '.join(shot.on_stage)}")
    motions = {**shot.motion_by_hand, who: edit.motion} if edit.motion is not None else {**shot.motion_by_hand}
    if edit.motion is None:
        del motions[who]
    words = f"{who} animated by hand" if edit.motion is not None else f"{who} acted by the crew again"
    item = shot.model_copy(update={"motion_by_hand": motions})
    return [Effect(item, name, words, frozenset({"blocking"}), shot_names(graph, shot.scene_id))]


def refuse_unknown_motions(project: Project, edits: Sequence[Edit]) -> None:
    """Refuse edits that name a motion by hand which the project does not have.

    Args:
        project: Open.
        edits: Any.

    Raises:
        InputError: With the file that is missing.
    """
    for edit in edits:
        if isinstance(edit, ByHandEdit) and edit.motion is not None and read_motion(project.files, edit.motion) is None:
            raise InputError(f"there is no {by_hand_file(edit.motion)}", mend="animate it in Blender, and pull")
