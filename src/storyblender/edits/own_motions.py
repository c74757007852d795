"""Motions of the user's own in edits: a clip that an edit names is taken into the project before the edit is made."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from storyblender.catalog.motions import MOTIONS
from storyblender.errors import InputError
from storyblender.memory.edits import BlockingEdit, Edit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.mocap import MocapClip, mocap_file
from storyblender.memory.scene_decision import DecidedMotion
from storyblender.project import Project

if TYPE_CHECKING:
    from storyblender.library.mocap.folders import MotionFolders

_ASKED = "a person asked for it"
MOST_OFFERED = 500
"""Clips of the folders that are listed; edits can name the others, too."""


def with_own_motions(project: Project, folders: Sequence[Path], edits: Sequence[Edit]) -> tuple[Edit, ...]:
    """Return edits in which each motion that is a clip of the user, and not of the catalogue, says which.

    Args:
        project: Open; it keeps the clips that edits name.
        folders: Of the user's clips.
        edits: Any.

    Raises:
        InputError: A clip cannot be used, or the project does not have the one that an edit says.
    """
    library: list[MotionFolders] = []

    def resolved(motions: Mapping[str, DecidedMotion | None]) -> dict[str, DecidedMotion | None]:
        return dict(_resolved(project, folders, library, key, motion) for key, motion in motions.items())

    found: list[Edit] = []
    for edit in edits:
        if isinstance(edit, BlockingEdit) and any(
            motion is not None and (key not in MOTIONS or motion.mocap is not None)
            for key, motion in edit.marks.motions.items()
        ):
            marks = edit.marks.model_copy(update={"motions": resolved(edit.marks.motions)})
            edit = edit.model_copy(update={"marks": marks})
        found.append(edit)
    return tuple(found)


def offered_clips(graph: ContinuityMemoryGraph, folders: Sequence[Path]) -> dict[str, str]:
    """Return the clips of the user that edits can name, each with what it shows and where it is from.

    Args:
        graph: The story, which may have clips that are in no folder any more.
        folders: Of the user's clips.
    """
    found = {key: f"{clip.name} (yours, in this project)" for key, clip in own_clips(graph).items()}
    if folders:
        from storyblender.library.mocap.folders import MotionFolders

        for file in MotionFolders(folders).files[:MOST_OFFERED]:
            if file.key not in MOTIONS:
                found[file.key] = f"{file.description or file.called} (yours, {file.name})"
    return dict(sorted(found.items()))


def own_clips(graph: ContinuityMemoryGraph) -> dict[str, MocapClip]:
    """Return the clips of the user that a story has, by the key that edits have for them.

    Args:
        graph: The story.
    """
    found: dict[str, MocapClip] = {}
    for shot in graph.shots:
        people = shot.blocking_decision.people.values() if shot.blocking_decision is not None else ()
        for key, motion in (each for marks in people for each in marks.motions.items()):
            if motion is not None and motion.mocap is not None:
                found[key] = motion.mocap
    return found


def _resolved(
    project: Project,
    folders: Sequence[Path],
    library: list[MotionFolders],
    key: str,
    motion: DecidedMotion | None,
) -> tuple[str, DecidedMotion | None]:
    """Return a motion with its clip, under the clip's key."""
    if motion is None or (key in MOTIONS and motion.mocap is None):
        return key, motion
    if motion.mocap is not None:
        if not project.path(mocap_file(motion.mocap.digest)).is_file():
            raise InputError(f"there is no {mocap_file(motion.mocap.digest)}", mend="name the clip of your folder")
        return key, motion
    known = own_clips(project.graph).get(key)
    if known is not None and project.path(mocap_file(known.digest)).is_file():
        return key, motion.model_copy(update={"mocap": known})
    if not folders:
        return key, motion
    from storyblender.library.mocap.folders import MotionFolders

    if not library:
        library.append(MotionFolders(folders))
    file = library[0].called(key)
    if file is None:
        return key, motion
    return file.key, motion.model_copy(update={"mocap": library[0].take_in(file, project.files, _ASKED)})
