"""Edits of the picture of the whole film: its shape, and the sensor that every lens sees with."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from storyblender.edits.conflicts import FILM
from storyblender.edits.effect import Effect, name_of, shot_names
from storyblender.errors import InputError
from storyblender.memory.edits import FormatEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.picture_format import FormatDecision
from storyblender.pipeline.reframing import reframed, with_decision


def format_effects(graph: ContinuityMemoryGraph, edit: FormatEdit) -> list[Effect]:
    """Return what another picture does to the film: cameras are set for it anew, and every frame is drawn.

    Args:
        graph: The story.
        edit: The aspect ratio, the width of the sensor, or both.

    Raises:
        InputError: It says nothing, or the picture would be far too high.
    """
    if not edit.decision.told:
        raise InputError("nothing is decided about the picture", mend="give an aspect ratio, the width of a sensor ...")
    picture = with_decision(graph.format, edit.decision)
    decision = (graph.format_decision or FormatDecision()).then(edit.decision)
    changed = graph.model_copy(update={"format": picture, "format_decision": decision})
    head = {"format": picture, "format_decision": decision, "shots": reframed(changed, graph.format).shots}
    effect = Effect(None, FILM, edit.decision.words, frozenset({"format"}), head=head)
    if picture == graph.format:
        return [effect]
    stale = tuple(name for scene in graph.scenes for name in shot_names(graph, scene.scene_id))
    return [replace(effect, stale=stale, warnings=tuple(_kept(graph)))]


def _kept(graph: ContinuityMemoryGraph) -> Iterator[str]:
    """Yield which locked cameras are not set anew; shots that are approved are told with every edit."""
    for shot in graph.shots:
        if "camera" in shot.locked and shot.approved is None and shot.camera is not None and not shot.joined:
            yield f"the camera of {name_of(shot)} is locked and stays as it is; look at its frame in the new picture"
