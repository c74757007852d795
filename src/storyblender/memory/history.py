"""Commits to the graph: item-sized changes with author and reason, applied forwards and backwards.

A commit holds only what changed, so its cost does not grow with the story; the history is the write-ahead log
from which a killed run resumes.
"""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Frozen
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext

Layer = Literal["outline", "assets", "scenes", "shots", "head"]
Item = SceneOutline | Asset | SceneContext | ShotContext

HEAD_FIELDS = ("title", "script_name", "plan_digest", "format", "story_summary")
"""The graph's own fields, kept as the single item of the layer ``head``."""


class Change(Frozen):
    """One item replaced, added (no ``before``) or removed (no ``after``)."""

    layer: Layer
    key: tuple[int | str, ...]
    before: dict[str, Any] | None = None
    after: dict[str, Any] | None = None


class Commit(Frozen):
    """One accepted write."""

    revision: int = Field(ge=1)
    author: str
    """Role, ``user`` or ``sync``."""
    reason: str
    changes: tuple[Change, ...]


def layer_of(item: Item) -> Layer:
    """Return the layer an item belongs to."""
    match item:
        case SceneOutline():
            return "outline"
        case Asset():
            return "assets"
        case SceneContext():
            return "scenes"
        case ShotContext():
            return "shots"


def key_of(item: Item) -> tuple[int | str, ...]:
    """Return the item's key within its layer."""
    match item:
        case SceneOutline() | SceneContext():
            return (item.scene_id,)
        case Asset():
            return (item.asset_id,)
        case ShotContext():
            return (item.scene_id, item.shot_id)


def changes_between(old: ContinuityMemoryGraph, new: ContinuityMemoryGraph) -> tuple[Change, ...]:
    """Return what turns ``old`` into ``new``; equal items are the same object or compare equal."""
    changes: list[Change] = []
    before, after = _head(old), _head(new)
    if before != after:
        changes.append(Change(layer="head", key=(), before=before, after=after))
    for layer in ("outline", "assets", "scenes", "shots"):
        olds = {key_of(item): item for item in getattr(old, layer)}
        news = {key_of(item): item for item in getattr(new, layer)}
        for key in [*olds, *(key for key in news if key not in olds)]:
            past, present = olds.get(key), news.get(key)
            if past is not present and past != present:
                changes.append(Change(layer=layer, key=key, before=_dump(past), after=_dump(present)))
    return tuple(changes)


def apply(graph: ContinuityMemoryGraph, commit: Commit, *, backwards: bool = False) -> ContinuityMemoryGraph:
    """Return the graph after the commit, or before it."""
    updates: dict[str, Any] = {}
    for layer, model in _MODELS.items():
        changes = {c.key: (c.before if backwards else c.after) for c in commit.changes if c.layer == layer}
        if not changes:
            continue
        items = [item for item in getattr(graph, layer) if key_of(item) not in changes]
        items += [model.model_validate(value) for value in changes.values() if value is not None]
        updates[layer] = _ordered(layer, items, graph)
    for change in commit.changes:
        if change.layer == "head":
            value = change.before if backwards else change.after
            loaded = ContinuityMemoryGraph.model_validate(value or {})
            updates |= {field: getattr(loaded, field) for field in HEAD_FIELDS}
    return graph.model_copy(update=updates)


def replace(graph: ContinuityMemoryGraph, *items: Item) -> ContinuityMemoryGraph:
    """Return the graph with the items put in place of those with the same key, or added."""
    updates: dict[str, Any] = {}
    for layer in _MODELS:
        fresh = {key_of(item): item for item in items if layer_of(item) == layer}
        if not fresh:
            continue
        kept = [fresh.pop(key_of(item), item) for item in getattr(graph, layer)]
        updates[layer] = _ordered(layer, [*kept, *fresh.values()], graph)
    return graph.model_copy(update=updates)


_MODELS: dict[str, type[Item]] = {
    "outline": SceneOutline,
    "assets": Asset,
    "scenes": SceneContext,
    "shots": ShotContext,
}


def _ordered(layer: str, items: list[Any], graph: ContinuityMemoryGraph) -> tuple[Any, ...]:
    """Story order for scenes and shots; assets keep the order in which they joined."""
    if layer != "assets":
        return tuple(sorted(items, key=key_of))
    rank = {asset.asset_id: index for index, asset in enumerate(graph.assets)}
    return tuple(sorted(items, key=lambda asset: rank.get(asset.asset_id, len(rank))))


def _head(graph: ContinuityMemoryGraph) -> dict[str, Any]:
    return graph.model_dump(mode="json", include=set(HEAD_FIELDS))


def _dump(item: Item | None) -> dict[str, Any] | None:
    return None if item is None else item.model_dump(mode="json")
