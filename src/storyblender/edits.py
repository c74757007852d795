"""What a person changes becomes the smallest set of commits, and can be taken back: a camera, undo, redo."""

from __future__ import annotations

from collections.abc import Mapping
from typing import get_args

from pydantic import Field, ValidationError

from storyblender.errors import InputError
from storyblender.memory.base import Frozen, shot_name
from storyblender.memory.history import Commit
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.memory.vocabulary import DISTANCE_OF_SIZE, Angle, CameraDirection, Movement, ShotSize
from storyblender.pipeline.run import Run
from storyblender.project import Project

PEOPLES = ("user", "director")
"""Authors whose commits a person caused: an edit, or a script that was read. The crew's follow from them."""
CHOICES = {"size": get_args(ShotSize), "angle": get_args(Angle), "movement": get_args(Movement)}


class CameraEdit(Frozen):
    """What a person wants another camera to be; fields left out stay as they are."""

    size: ShotSize | None = None
    angle: Angle | None = None
    movement: Movement | None = None
    direction: CameraDirection | None = None
    """Where a move goes; it is said with the move, as in ``pan left``."""
    lens: float | None = Field(default=None, ge=4, le=1200)
    """mm."""

    @classmethod
    def from_words(cls, words: Mapping[str, str | float]) -> CameraEdit:
        """Read an edit; ``movement`` may end in its direction.

        Raises:
            InputError: A word is not in the vocabulary.
        """
        said = dict(words)
        move, _, way = str(words.get("movement", "")).rpartition(" ")
        if way in get_args(CameraDirection):
            said |= {"movement": move, "direction": way}
        try:
            return cls.model_validate(said)
        except ValidationError as error:
            name = str(error.errors()[0]["loc"][0])
            mend = f"it is one of: {', '.join(CHOICES[name])}" if name in CHOICES else "it is a number of mm, 4 to 1200"
            raise InputError(f"{name} cannot be {words[name]!r}", mend=mend) from error


def apply_camera_edit(run: Run, shot: ShotContext, edit: CameraEdit) -> None:
    """Commit a changed camera instruction; the Camera Operator sets that one camera anew.

    Raises:
        InputError: The camera of the shot is locked.
    """
    name = shot_name(shot.scene_id, shot.shot_id)
    if "camera" in shot.locked:
        raise InputError(f"the camera of {name} is locked", mend="unlock it first")
    changes = edit.model_dump(exclude_none=True)
    if edit.size is not None:
        changes |= {"distance": DISTANCE_OF_SIZE[edit.size]}
        if edit.lens is None:
            changes |= {"lens": None}
    if edit.movement is not None:
        changes |= {"direction": edit.direction}
    instruction = CameraInstruction.model_validate({**shot.camera_instruction.model_dump(), **changes})
    said = ", ".join(f"{key} {value}" for key, value in edit.model_dump(exclude_none=True).items())
    fresh = shot.model_copy(update={"camera_instruction": instruction, "camera": None, "lights": ()})
    run.commit("user", f"{name}: {said}", fresh)


def undo_edit(project: Project) -> list[Commit]:
    """Take back a person's last change with all that the crew did in consequence; the first reading of a script stays.

    Returns:
        What was undone, oldest first: the change itself, then the crew's commits.

    Raises:
        InputError: Nothing was changed since the script was read.
    """
    undone: list[Commit] = []
    for commit in project.backwards():
        if commit.revision == 1:
            break
        undone.insert(0, commit)
        if commit.author in PEOPLES:
            project.go_to(commit.revision - 1)
            return undone
    raise InputError("there is nothing to undo", mend="nothing was changed since the script was read")


def redo_edit(project: Project) -> list[Commit]:
    """Make a change again that was undone, with the crew's work on it.

    Returns:
        What was done again, oldest first.

    Raises:
        InputError: Nothing was undone, or something else was changed since.
    """
    redone: list[Commit] = []
    for commit in project.forwards():
        if redone and commit.author in PEOPLES:
            break
        redone.append(commit)
    if not redone:
        raise InputError("there is nothing to redo", mend="a change can be redone until another one is made")
    project.go_to(redone[-1].revision)
    return redone
