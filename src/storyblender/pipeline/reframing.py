"""Another shape of the picture, or another sensor: cameras that were set for the one before are set anew."""

from __future__ import annotations

from storyblender.errors import InputError
from storyblender.memory.graph import ContinuityMemoryGraph, ProjectFormat
from storyblender.memory.history import replace
from storyblender.memory.picture_format import LARGEST, FormatDecision
from storyblender.memory.shot_context import ShotContext


def with_decision(picture: ProjectFormat, decision: FormatDecision) -> ProjectFormat:
    """Return a format with what a person decided of it.

    Args:
        picture: As the settings have it, or as it is.
        decision: Any of its fields.

    Raises:
        InputError: The picture would be far too high.
    """
    decided = picture.model_copy(update=decision.told)
    if decided.height > LARGEST:
        mend = f"{LARGEST} is the most; give a smaller --width to `storyblender make`, or a wider aspect"
        raise InputError(f"a picture {decided.width} wide would be {decided.height} high", mend=mend)
    return decided


def reframed(graph: ContinuityMemoryGraph, former: ProjectFormat) -> ContinuityMemoryGraph:
    """Return the graph without the cameras that were set for another picture; those that a person locked stay.

    The Camera Operator sets one that a person placed just where they placed it.

    Args:
        graph: With its format as it is now.
        former: The format that its cameras were set for.
    """
    now = graph.format
    if (now.aspect, now.sensor_width) == (former.aspect, former.sensor_width):
        return graph
    return replace(graph, *map(_with_cameras_to_set, graph.shots))


def _with_cameras_to_set(shot: ShotContext) -> ShotContext:
    takes = tuple(take.model_copy(update={"camera": None, "lights": ()}) for take in shot.takes)
    if "camera" in shot.locked:
        return shot.model_copy(update={"takes": takes})
    fresh = {"camera": None, "former_camera": None, "camera_retake": None, "lights": ()}
    return shot.model_copy(update={"takes": takes, **fresh})
