"""What a person animated in a story's .blend becomes edits, and files that keep the motion."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.edits.blend_change import BlendChange
from storyblender.edits.effect import name_of
from storyblender.folder import Folder
from storyblender.memory.blend_values import BlendReading
from storyblender.memory.edits import ByHandEdit, Edit
from storyblender.memory.motion_by_hand import HandMotionRead, MotionByHand, by_hand_file
from storyblender.pipeline.hand_motions import read_motion
from storyblender.project import Project

_MOTION = ("strip", "keys added", "keys retimed", "posed")
"""Kinds of changes that a motion by hand takes the place of."""
_NAMED = 4
"""Most channels whose names are told."""

Motions = dict[str, MotionByHand]
"""By digest."""


def with_hand_changes(
    project: Project, changes: Sequence[BlendChange], reading: BlendReading
) -> tuple[list[BlendChange], Motions]:
    """Return changes with one for each shot in which a character moves by hand, in place of those of keys and strips.

    Args:
        project: Open; a later motion by hand lies over an earlier one.
        changes: Of a file.
        reading: Of that file.

    Returns:
        The changes, and the motions that their edits name.
    """
    moving, motions, made = {(each.scene, each.node_id) for each in reading.by_hand}, Motions(), list[BlendChange]()
    for each in reading.by_hand:
        motion = _over_former(project, each)
        motions[motion.digest] = motion
        edit = ByHandEdit(shot=each.shot, who=each.asset_id, motion=motion.digest)
        names = list(each.motion.channels)
        told = ", ".join(names) if len(names) <= _NAMED else f"{len(names)} channels"
        words = f"{each.scene}.{each.node_id} is animated by hand in {each.shot} ({told})"
        made.append(BlendChange(kind="posed", scene=each.scene, subject=each.node_id, words=words, edits=(edit,)))
    left = [each for each in changes if each.kind not in _MOTION or (each.scene, each.subject) not in moving]
    return [*left, *made], motions


def keep_motions(files: Folder, motions: Motions, edits: Sequence[Edit]) -> None:
    """Write the motions that edits name into the project.

    Args:
        files: The project folder.
        motions: By digest.
        edits: That are about to be made.
    """
    for edit in edits:
        if isinstance(edit, ByHandEdit) and edit.motion in motions:
            files.write(by_hand_file(edit.motion), motions[edit.motion].model_dump_json())


def _over_former(project: Project, read: HandMotionRead) -> MotionByHand:
    shots = {name_of(shot): shot for shot in project.graph.shots}
    former = shots[read.shot].motion_by_hand.get(read.asset_id) if read.shot in shots else None
    before = read_motion(project.files, former) if former is not None else None
    return read.motion if before is None else before.then(read.motion)
