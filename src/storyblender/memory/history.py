"""Commits to the graph: item-sized changes with author and reason, applied forwards and backwards.

A commit holds only what changed, so its cost does not grow with the story; the history is the write-ahead log
from which a killed run resumes. Each commit carries its digest and that of the commit before it.
"""

from __future__ import annotations

from typing import Any, Final, Literal

from pydantic import Field

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Frozen, content_hash, shot_number
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext

Layer = Literal["outline", "assets", "scenes", "shots", "head", "order"]
Item = SceneOutline | Asset | SceneContext | ShotContext
_ByKey = dict[tuple[int | str, ...], Item]

HEAD_FIELDS = (
    "title", "script_name", "edition", "plan_digest", "settings_digest", "format", "story_summary", "age", "panorama",
    "scene_order", "paints", "format_decision",
)  # fmt: skip
"""The graph's own fields, kept as the single item of the layer ``head``."""

TRIAL: Final = "trial"
"""Author of edits that are tried on a person's behalf and then dropped: they end nothing that can be redone."""
PEOPLE: Final = ("user", "sync", TRIAL)
"""Authors of edits that a person made: here, or in Blender."""
CAUSED_BY_PERSON: Final = (*PEOPLE, "director")
"""Authors of commits that a person caused: an edit, or a script that was read. The crew's follow from them."""


class Change(Frozen):
    """One item replaced, added (no ``before``) or removed (no ``after``).

    The layer ``order`` is the order of the asset sheet, written where it does not follow from the other changes.
    """

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
    parent: str = ""
    """Digest of the commit before this one; empty for the first one and in projects of schema 1."""
    digest: str = ""
    """Hash of all of the above; empty in projects of schema 1."""

    def sealed(self) -> Commit:
        """Return the commit with its digest."""
        return self.model_copy(update={"digest": self._hash()})

    @property
    def intact(self) -> bool:
        """Whether the content is as it was when the digest was written."""
        return self.digest in ("", self._hash())

    def _hash(self) -> str:
        return content_hash(self.model_dump(mode="json", exclude={"digest"}))


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
    for layer in _MODELS:
        olds, news = _apart(getattr(old, layer), getattr(new, layer))
        for key in [*olds, *(key for key in news if key not in olds)]:
            past, present = olds.get(key), news.get(key)
            if past is not present and past != present:
                changes.append(Change(layer=layer, key=key, before=_dump(past), after=_dump(present)))
    return (*changes, *_reordering(old, new))


def _apart(old: tuple[Item, ...], new: tuple[Item, ...]) -> tuple[_ByKey, _ByKey]:
    """Return the items by key without those that are one object in both: nearly all, in a long story."""
    if old is new:
        return {}, {}
    same = set(map(id, old)).intersection(map(id, new))
    olds, news = ({key_of(item): item for item in items if id(item) not in same} for items in (old, new))
    return olds, news


def _reordering(old: ContinuityMemoryGraph, new: ContinuityMemoryGraph) -> tuple[Change, ...]:
    """Return the change of the order of assets, if it is not that the new ones come last."""
    olds, news = ([asset.asset_id for asset in graph.assets] for graph in (old, new))
    follows = news[: len(olds)] == olds
    return () if follows else (Change(layer="order", key=(), before={"assets": olds}, after={"assets": news}),)


def apply(graph: ContinuityMemoryGraph, commit: Commit, *, backwards: bool = False) -> ContinuityMemoryGraph:
    """Return the graph after the commit, or before it.

    Args:
        graph: The graph that the commit was made on; backwards, the one that it led to.
        commit: What changed.
        backwards: Whether to take the commit back.

    Raises:
        ValueError: The content of the commit is no item of the graph.
    """
    updates: dict[str, Any] = {}
    order = [asset.asset_id for asset in graph.assets]
    for change in commit.changes:
        value = change.before if backwards else change.after
        if change.layer == "head":
            loaded = ContinuityMemoryGraph.model_validate(value or {})
            updates |= {field: getattr(loaded, field) for field in HEAD_FIELDS}
        elif change.layer == "order":
            order = _names(value)
    for layer in _MODELS:
        changes = {c.key: _item(c, c.before if backwards else c.after) for c in commit.changes if c.layer == layer}
        items = [item for item in getattr(graph, layer) if key_of(item) not in changes]
        items += [item for item in changes.values() if item is not None]
        if changes or layer == "assets":
            updates[layer] = _ordered(layer, items, order)
    return graph.model_copy(update=updates)


def follows(graph: ContinuityMemoryGraph, commit: Commit, *, backwards: bool = False) -> bool:
    """Tell whether a commit was made on this very graph, or backwards, whether it led to it.

    Args:
        graph: The graph; only what the commit changes is compared.
        commit: What changed.
        backwards: Whether to ask for the state after it.

    Raises:
        ValueError: The content of the commit is no item of the graph.
    """
    present = {layer: {key_of(item): item for item in getattr(graph, layer)} for layer in _MODELS}
    for change in commit.changes:
        value = change.after if backwards else change.before
        if change.layer == "head":
            expected, found = _head(ContinuityMemoryGraph.model_validate(value or {})), _head(graph)
        elif change.layer == "order":
            expected, found = _names(value), [asset.asset_id for asset in graph.assets]
        else:
            expected, found = _item(change, value), present[change.layer].get(change.key)
        if expected != found:
            return False
    return True


def replace(graph: ContinuityMemoryGraph, *items: Item) -> ContinuityMemoryGraph:
    """Return the graph with the items put in place of those with the same key, or added."""
    updates: dict[str, Any] = {}
    for layer in _MODELS:
        fresh = {key_of(item): item for item in items if layer_of(item) == layer}
        if not fresh:
            continue
        kept = [fresh.pop(key_of(item), item) for item in getattr(graph, layer)]
        updates[layer] = _ordered(layer, [*kept, *fresh.values()], [asset.asset_id for asset in graph.assets])
    return graph.model_copy(update=updates)


def without(graph: ContinuityMemoryGraph, *items: Item) -> ContinuityMemoryGraph:
    """Return the graph without the items that have these keys."""
    gone = {(layer_of(item), key_of(item)) for item in items}
    layers = {layer for layer, _ in gone}
    kept = {
        layer: tuple(item for item in getattr(graph, layer) if (layer, key_of(item)) not in gone) for layer in layers
    }
    return graph.model_copy(update=kept)


_MODELS: dict[Layer, type[Item]] = {
    "outline": SceneOutline,
    "assets": Asset,
    "scenes": SceneContext,
    "shots": ShotContext,
}


def _names(value: dict[str, Any] | None) -> list[str]:
    names = (value or {}).get("assets")
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise ValueError("the order of the asset sheet is a list of names")
    return names


def _item(change: Change, value: dict[str, Any] | None) -> Item | None:
    if value is None:
        return None
    item = _MODELS[change.layer].model_validate(value)
    if key_of(item) != change.key:
        raise ValueError(f"the key of a change is {change.key}, its item is {key_of(item)}")
    return item


def _place(item: Item) -> tuple[int | str, ...]:
    """Return what an item is sorted by: a shot that a person added, by the number in its name."""
    return (item.scene_id, shot_number(item.shot_id)) if isinstance(item, ShotContext) else key_of(item)


def _ordered(layer: Layer, items: list[Any], assets: list[str]) -> tuple[Any, ...]:
    """Story order for scenes and shots; assets keep the order in which they joined."""
    if layer != "assets":
        return tuple(sorted(items, key=_place))
    rank = {asset_id: index for index, asset_id in enumerate(assets)}
    return tuple(sorted(items, key=lambda asset: rank.get(asset.asset_id, len(rank))))


def _head(graph: ContinuityMemoryGraph) -> dict[str, Any]:
    return graph.model_dump(mode="json", include=set(HEAD_FIELDS))


def _dump(item: Item | None) -> dict[str, Any] | None:
    return None if item is None else item.model_dump(mode="json")
