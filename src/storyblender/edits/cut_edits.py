"""Edits of the cut: which shots and scenes are in the film, and in which order. No frame is drawn for them."""

from __future__ import annotations

from typing import Any

from storyblender.edits.conflicts import FILM
from storyblender.edits.effect import Effect, name_of, shot_names
from storyblender.edits.targets import target_named
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import scene_name
from storyblender.memory.edits import OmitEdit, ReorderEdit, RestoreEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext

_CUT = frozenset({"cut"})


def omit_effects(graph: ContinuityMemoryGraph, edit: OmitEdit) -> list[Effect]:
    """Return what omitting a shot or a scene does to it. Raises InputError."""
    item = _part(graph, edit.target)
    name = name_of(item)
    if item.omitted:
        raise InputError(f"{name} is omitted already", mend="`restore` brings it back")
    if isinstance(item, ShotContext) and item.approved is not None:
        raise InputError(f"{name} is approved", mend="withdraw the approval first")
    gone = item.model_copy(update={"omitted": True})
    left = replace(graph, gone)
    if not left.cut:
        raise InputError(f"without {name} the film has no shots left", mend="restore others first")
    if isinstance(item, ShotContext) and not _shots_left(left, item.scene_id):
        scene = scene_name(item.scene_id)
        raise InputError(f"without {name} the scene {scene} has no shots left", mend=f"omit {scene}")
    return [Effect(gone, name, "OMITTED", _CUT)]


def restore_effects(graph: ContinuityMemoryGraph, edit: RestoreEdit) -> list[Effect]:
    """Return what bringing back a shot or a scene does to it. Raises InputError."""
    item = _part(graph, edit.target)
    name = name_of(item)
    scene = graph.scene(item.scene_id)
    if not item.omitted:
        mend = f"its scene {name_of(scene)} is; restore that" if scene.omitted else ""
        raise InputError(f"{name} is not omitted", mend=mend)
    back = item.model_copy(update={"omitted": False})
    stale = (name,) if isinstance(item, ShotContext) else shot_names(replace(graph, back), item.scene_id)
    return [Effect(back, name, "restored", _CUT, stale)]


def reorder_effects(graph: ContinuityMemoryGraph, edit: ReorderEdit) -> list[Effect]:
    """Return what moving a shot in its scene, or a scene in the film, does. Raises InputError."""
    item, other = _part(graph, edit.target), _part(graph, edit.before or edit.after or "")
    name, near = name_of(item), name_of(other)
    where = "before" if edit.before is not None else "after"
    if name == near:
        raise InputError(f"{name} cannot be {where} itself")
    if isinstance(item, SceneContext) and isinstance(other, SceneContext):
        natural = [scene.scene_id for scene in graph.scenes]
        now = [scene.scene_id for scene in graph.scenes_in_order]
        order = _moved(now, item.scene_id, other.scene_id, where, name, near)
        order = () if list(order) == natural else order
        return [Effect(None, FILM, f"{name} {where} {near}", _CUT, head={"scene_order": order})]
    if not isinstance(item, ShotContext) or not isinstance(other, ShotContext):
        raise InputError(
            f"{name} cannot be {where} {near}", mend="a shot has its place among shots, a scene among scenes"
        )
    if item.scene_id != other.scene_id:
        raise InputError(f"{near} is in another scene than {name}", mend="shots are reordered within their scene")
    scene = graph.scene(item.scene_id)
    natural = [shot.shot_id for shot in graph.shots_of(item.scene_id) if not shot.joined]
    now = [shot.shot_id for shot in graph.shots_in_order(item.scene_id)]
    order = _moved(now, item.shot_id, other.shot_id, where, name, near)
    update: dict[str, Any] = {"shot_order": () if list(order) == natural else order}
    return [Effect(scene.model_copy(update=update), name_of(scene), f"{name} {where} {near}", _CUT)]


def _moved(now: list[int], key: int, near: int, where: str, name: str, other: str) -> tuple[int, ...]:
    """Return an order in which one id stands before or after another one. Raises InputError where it does already."""
    order = [each for each in now if each != key]
    order.insert(order.index(near) + (where == "after"), key)
    if order == now:
        raise InputError(f"{name} is {where} {other} already")
    return tuple(order)


def _part(graph: ContinuityMemoryGraph, name: str) -> ShotContext | SceneContext:
    """Return the shot or scene with a name. Raises InputError."""
    item = target_named(graph, name)
    if isinstance(item, Asset):
        raise InputError(
            f"{name} is neither a shot nor a scene", mend="shots are named as SC010_SH020, scenes as SC010"
        )
    return item


def _shots_left(graph: ContinuityMemoryGraph, scene_id: int) -> bool:
    return any(not shot.omitted and not shot.joined for shot in graph.shots_of(scene_id))
