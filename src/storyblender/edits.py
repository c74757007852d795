"""What a person changes becomes the smallest set of commits, and can be taken back: a camera, undo, redo."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from typing import get_args

from pydantic import ValidationError

from storyblender.errors import InputError
from storyblender.memory.base import shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import Commit
from storyblender.memory.shot_context import CameraDecision, ShotContext
from storyblender.memory.shot_sizes import ShotSize
from storyblender.memory.vocabulary import Angle, CameraDirection, Movement
from storyblender.pipeline.run import Run
from storyblender.project import Project

PEOPLES = ("user", "director")
"""Authors whose commits a person caused: an edit, or a script that was read. The crew's follow from them."""
CHOICES = {"size": get_args(ShotSize), "angle": get_args(Angle), "movement": get_args(Movement)}


def camera_decision(words: Mapping[str, str | float]) -> CameraDecision:
    """Read what a person says about a camera; ``movement`` may end in its direction.

    Raises:
        InputError: A word is not in the vocabulary.
    """
    said = dict(words)
    move, _, way = str(words.get("movement", "")).rpartition(" ")
    if way in get_args(CameraDirection):
        said |= {"movement": move, "direction": way}
    try:
        return CameraDecision.model_validate(said)
    except ValidationError as error:
        name = str(error.errors()[0]["loc"][0])
        mend = f"it is one of: {', '.join(CHOICES[name])}" if name in CHOICES else "it is a number of mm, 4 to 1200"
        raise InputError(f"{name} cannot be {words[name]!r}", mend=mend) from error


def decide_cameras(run: Run, shots: Sequence[ShotContext], decision: CameraDecision) -> None:
    """Commit what a person decided about the cameras of some shots; the Camera Operator sets those cameras anew.

    Raises:
        InputError: The camera of a shot is locked; then none is changed.
    """
    names = [shot_name(shot.scene_id, shot.shot_id) for shot in shots]
    for shot, name in zip(shots, names, strict=True):
        if "camera" in shot.locked:
            raise InputError(f"the camera of {name} is locked", mend="unlock it first")
    which = ", ".join(names) if len(names) <= 4 else f"{names[0]} to {names[-1]} ({len(names)} shots)"
    run.commit("user", f"{which}: {decision.words}", *(_decided(shot, decision) for shot in shots))


def _decided(shot: ShotContext, decision: CameraDecision) -> ShotContext:
    retake = shot.camera_retake.decision if shot.camera_retake else CameraDecision()
    before = shot.camera_decision or retake
    return shot.model_copy(
        update={
            "camera_instruction": decision.applied(shot.camera_instruction),
            "camera_decision": before.then(decision),
            "camera_retake": None,
            "camera": None,
            "lights": (),
        }
    )


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


def shots_named(graph: ContinuityMemoryGraph, names: Sequence[str]) -> list[ShotContext]:
    """Return the shots with these names, in that order; all shots if no name is given.

    Args:
        graph: The story.
        names: Such as ``SC010_SH020``, in any case.

    Raises:
        InputError: There is no shot of that name.
    """
    known = {shot_name(shot.scene_id, shot.shot_id): shot for shot in graph.shots}
    wanted = [name.upper() for name in names]
    for name, written in zip(wanted, names, strict=True):
        if name not in known:
            near = get_close_matches(name, known, n=1, cutoff=0.8)
            mend = (
                f"did you mean {near[0]}?" if near else f"they go from {next(iter(known))} to {next(reversed(known))}"
            )
            raise InputError(f"there is no shot {written!r}", mend=mend)
    return [known[name] for name in wanted] if names else list(graph.shots)
