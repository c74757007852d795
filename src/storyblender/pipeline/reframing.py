"""Another shape of the picture, or another sensor: cameras that were set for the one before are set anew."""

from __future__ import annotations

from storyblender.memory.graph import ContinuityMemoryGraph, ProjectFormat
from storyblender.memory.history import replace
from storyblender.memory.shot_context import ShotContext


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
