"""What a person decided or locked stays so: the Gatekeeper's rules against the crew, and against hasty edits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.history import PEOPLE, Item
from storyblender.memory.locks import SCENE_LOCKS, SHOT_LOCKS
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext


def lock_violations(old: Item, new: Item, author: str) -> Iterator[str]:
    """Yield a sentence for everything locked or decided by a person that a change of one item would not keep.

    What is locked and not there yet may still be made. A person's edit may change what a person decided, and may lift
    a lock, but not change what is locked.

    Args:
        old: The item as it is committed.
        new: The item with the same key as it is proposed.
        author: Of the change.
    """
    match old, new:
        case ShotContext(), ShotContext():
            name = shot_name(old.scene_id, old.shot_id)
            yield from _changed(name, old, new, {lock: SHOT_LOCKS[lock] for lock in old.locked}, author)
            if author not in PEOPLE:
                yield from _overruled(name, old, new)
        case SceneContext(), SceneContext():
            name = scene_name(old.scene_id)
            yield from _changed(name, old, new, {lock: SCENE_LOCKS[lock] for lock in old.locked}, author)
            if author not in PEOPLE:
                if (new.omitted, new.shot_order) != (old.omitted, old.shot_order):
                    yield f"people decide what of {name} is in the film, in which order"
                for part in ("light", "set", "layout"):
                    decision = getattr(old, f"{part}_decision")
                    if decision is not None and getattr(new, f"{part}_decision") != decision:
                        yield f"a person decided about the {part} of {name}: {decision.words}"
                yield from _misplaced(name, old, new)
        case Asset(), Asset():
            if old.locked and _model(new) != _model(old) and (new.locked or author not in PEOPLE):
                yield f"{old.asset_id} is locked"
            if author not in PEOPLE and new.look_decision != old.look_decision:
                yield f"a person decided how {old.asset_id} looks"
            was = old.decision
            if author not in PEOPLE and was is not None and (new.decision != was or not was.is_kept_by(new.canonical)):
                yield f"a person had {old.asset_id} made from {was.words}"
        case _:
            return


def _changed(
    name: str,
    old: ShotContext | SceneContext,
    new: ShotContext | SceneContext,
    locks: Mapping[Any, tuple[str, ...]],
    author: str,
) -> Iterator[str]:
    for lock, fields in locks.items():
        if lock not in new.locked and author not in PEOPLE:
            yield f"only a person unlocks the {lock} of {name}"
        elif lock in new.locked and any(_differs(getattr(old, field), getattr(new, field)) for field in fields):
            yield f"the {lock} of {name} is locked"


def _differs(old: object, new: object) -> bool:
    """Return whether a value that was there is another now."""
    return old not in (None, (), {}) and old != new


def _overruled(name: str, old: ShotContext, new: ShotContext) -> Iterator[str]:
    """Yield what the crew would change of a person's decisions."""
    if (new.take, [take.number for take in new.takes]) != (old.take, [take.number for take in old.takes]):
        yield f"a person keeps the takes of {name}"
    if (new.notes, new.approved) != (old.notes, old.approved):
        yield f"people write the notes on {name}, and approve it"
    if (new.omitted, new.joined, new.covers) != (old.omitted, old.joined, old.covers):
        yield f"people decide whether {name} is in the film"
    decision = old.camera_decision
    if decision is not None and (new.camera_decision != decision or not decision.holds(new.camera_instruction)):
        yield f"a person decided about the camera of {name}: {decision.words}"
    if (new.blocking_decision, new.blocking_takes) != (old.blocking_decision, old.blocking_takes):
        yield f"people decide about the marks of {name}"
    if new.motion_by_hand != old.motion_by_hand:
        yield f"people decide who is animated by hand in {name}"
    length = old.decided_duration
    if length is not None and (new.decided_duration, new.duration) != (length, length):
        yield f"a person decided that {name} has {length} frames"


def _misplaced(name: str, old: SceneContext, new: SceneContext) -> Iterator[str]:
    """Yield what the crew would place elsewhere than a person did."""
    things = old.layout_decision.things if old.layout_decision is not None else {}
    for item in new.layout.objects if new.layout is not None and things else ():
        place = things.get(item.node_id)
        if place is not None and place.location not in (None, item.location[:2]):
            yield f"a person placed {item.node_id} of {name}: {place.words}"


def _model(asset: Asset) -> tuple[object, ...]:
    """Return what a locked asset keeps: its look, its size, and the model that it became."""
    made = asset.canonical
    recipe = (made.source, made.key, tuple(sorted(made.params.items()))) if made is not None else None
    return asset.decided_look, asset.dimension, recipe
