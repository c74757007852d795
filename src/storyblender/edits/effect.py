"""What one edit comes to, and the refusal of what is locked or far away."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from storyblender.errors import InputError
from storyblender.memory.base import Vec2, Vec3, scene_name, shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import Item, without
from storyblender.memory.history import replace as replaced
from storyblender.memory.locks import SceneLock, ShotLock, StaleWork
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext

FARTHEST, DEEPEST, HIGHEST = 500.0, -50.0, 300.0
"""Metres from the middle of the set, and below and above its floor, beyond which nothing is placed."""


@dataclass(frozen=True)
class Effect:
    """What one edit comes to for one item of the graph.

    Attributes:
        item: The item of the graph as it is then; None where it is the graph itself.
        name: Of the item, for people.
        words: What was done to it.
        aspects: What of it was touched, such as ``camera``: two edits of one item may touch different things.
        stale: Shots whose frames show something else now.
        head: Fields of the graph itself as they are then, such as the order of the scenes.
        warnings: What a person should know of it, one sentence each.
        removed: Whether the item leaves the graph.
    """

    item: Item | None
    name: str
    words: str
    aspects: frozenset[str]
    stale: tuple[str, ...] = ()
    head: Mapping[str, Any] | None = None
    warnings: tuple[str, ...] = ()
    removed: bool = False

    def warned(self, warnings: tuple[str, ...]) -> Effect:
        """Return the effect with what a person should know of it."""
        return replace(self, warnings=warnings)


def with_effects(graph: ContinuityMemoryGraph, effects: Sequence[Effect]) -> ContinuityMemoryGraph:
    """Return the graph as edits leave it.

    Args:
        graph: As it was.
        effects: Of the edits, in order.
    """
    graph = replaced(graph, *(each.item for each in effects if each.item is not None and not each.removed))
    graph = without(graph, *(each.item for each in effects if each.item is not None and each.removed))
    for head in (each.head for each in effects if each.head is not None):
        graph = graph.model_copy(update=head)
    return graph


def refuse_locked(item: ShotContext | SceneContext, part: ShotLock | SceneLock) -> None:
    """Refuse an edit of a part of a shot or a scene that is locked. Raises InputError."""
    if isinstance(item, ShotContext) and item.approved is not None:
        raise InputError(f"{name_of(item)} is approved", mend="withdraw the approval first")
    if part in item.locked:
        raise InputError(f"the {part} of {name_of(item)} is locked", mend="unlock it first")


def refuse_locked_staging(graph: ContinuityMemoryGraph, scene: SceneContext, *parts: SceneLock) -> None:
    """Refuse to stage a scene again that a person locked, or in which they locked where people stand.

    Args:
        graph: The story.
        scene: To be staged again.
        parts: Of the scene that are made anew besides its layout.

    Raises:
        InputError: With what is locked.
    """
    for part in ("layout", *parts):
        refuse_locked(scene, part)
    for shot in graph.shots_of(scene.scene_id):
        refuse_locked(shot, "blocking")


def refuse_far(point: Vec3, scene: SceneContext) -> None:
    """Refuse a place far outside of a set.

    Args:
        point: Metres.
        scene: With its layout, if it is staged.

    Raises:
        InputError: With how far it may be.
    """
    size = scene.layout.scene_size if scene.layout is not None else None
    middle: Vec2 = (0.0, 0.0) if size is None else ((size.x + size.x_negative) / 2, (size.y + size.y_negative) / 2)
    if math.dist(point[:2], middle) > FARTHEST or not DEEPEST <= point[2] <= HIGHEST:
        x, y, z = point
        far = f"{x:g}, {y:g}, {z:g} is too far from the set of {name_of(scene)}"
        raise InputError(far, mend=f"stay within {FARTHEST:g} m of its middle, {DEEPEST:g} to {HIGHEST:g} m high")


def name_of(item: ShotContext | SceneContext) -> str:
    """Return the name of a shot or a scene."""
    return shot_name(item.scene_id, item.shot_id) if isinstance(item, ShotContext) else scene_name(item.scene_id)


def shot_names(graph: ContinuityMemoryGraph, scene_id: int) -> tuple[str, ...]:
    """Return the names of the shots of a scene that are in the film."""
    shots = () if graph.scene(scene_id).omitted else graph.shots_of(scene_id)
    return tuple(shot_name(scene_id, shot.shot_id) for shot in shots if not shot.omitted and not shot.joined)


def scene_effect(
    graph: ContinuityMemoryGraph,
    scene: SceneContext,
    words: str,
    aspect: SceneLock,
    stale: Iterable[StaleWork],
    **update: Any,
) -> Effect:
    """Return what an edit does to a scene; of one that is not staged yet nothing is stale.

    Args:
        graph: The story.
        scene: As it is.
        words: What is done.
        aspect: What is touched.
        stale: What the crew has to make anew.
        **update: Fields of the scene.
    """
    if scene.lighting is not None:
        update["stale"] = tuple(dict.fromkeys((*scene.stale, *stale)))
    item = scene.model_copy(update=update)
    return Effect(item, name_of(scene), words, frozenset({aspect}), shot_names(graph, scene.scene_id))


def scenes_of_place(graph: ContinuityMemoryGraph, scene: SceneContext) -> tuple[SceneContext, ...]:
    """Return the scenes that play in the same place as one, in story order."""

    def first(each: SceneContext) -> int:
        while each.setup.reference_scene_id is not None:
            each = graph.scene(each.setup.reference_scene_id)
        return each.scene_id

    return tuple(each for each in graph.scenes if first(each) == first(scene))
