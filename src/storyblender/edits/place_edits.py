"""Edits of places by hand: a thing of a scene is moved and turned."""

from __future__ import annotations

from difflib import get_close_matches

from storyblender.agents.layout_artist.placed_by_hand import (
    Stand,
    carried,
    obstructions,
    place_by_hand,
    riders_of,
    stand_of,
)
from storyblender.edits.effect import (
    Effect,
    name_of,
    refuse_far,
    scene_effect,
)
from storyblender.edits.locked_shots import refuse_shown_in_locked
from storyblender.edits.scale_edits import scale_effects
from storyblender.edits.targets import as_id, scene_named
from storyblender.errors import InputError
from storyblender.memory.edits import PlaceEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.scene_context import Layout, LayoutObject, SceneContext
from storyblender.memory.scene_decision import LayoutDecision, ThingPlace


def place_effects(graph: ContinuityMemoryGraph, edit: PlaceEdit) -> list[Effect]:
    """Return what moving or turning a thing by hand does to its scene: it is there, with what stands on it.

    Args:
        graph: The story.
        edit: The thing by its node id, or by its id or name where the scene has it once.

    Raises:
        InputError: There is no such thing, the place cannot be, or something is locked.
    """
    scene = scene_named(graph, edit.scene)
    layout, environment = scene.layout, scene.environment
    if layout is None or environment is None:
        raise InputError(f"{name_of(scene)} is not staged yet", mend="run `storyblender render` first")
    item = _item_named(graph, scene, layout, edit.thing)
    scaled = scale_effects(graph, scene, item, edit.scale) if edit.scale is not None else []
    if edit.place == ThingPlace():
        return scaled
    graph = replace(graph, *(each.item for each in scaled if each.item is not None))
    scene = graph.scene(scene.scene_id)
    layout, stand = scene.layout or layout, stand_of(graph.assets, environment)
    item = next(each for each in layout.objects if each.node_id == item.node_id)
    if edit.place.location is not None:
        refuse_far((*edit.place.location, edit.place.height or 0.0), scene)
    decision = scene.layout_decision or LayoutDecision()
    place = _whole(item, edit.place, decision.things.get(item.node_id), stand)
    moved = place_by_hand(layout, {item.node_id: place}, stand)
    riders = riders_of(layout, item.node_id, stand)
    refuse_shown_in_locked(graph, scene, stand, (item.node_id, *riders), layout, moved)
    taken = carried(decision.things, riders, moved)
    decided = decision.then(LayoutDecision(things={**taken, item.node_id: place}))
    flaws = tuple(flaw.message for flaw in obstructions(moved, [item.node_id], stand))
    words = f"{item.node_id} placed {place.words}"
    effect = scene_effect(graph, scene, words, "layout", ("motion",), layout=moved, layout_decision=decided)
    return [*scaled, effect.warned(flaws)]


def _item_named(graph: ContinuityMemoryGraph, scene: SceneContext, layout: Layout, name: str) -> LayoutObject:
    """Return the object of a layout with a name; people and parts of vehicles are refused."""
    wanted = {name, as_id(name)}
    called = {asset.asset_id: as_id(asset.name) for asset in graph.assets}
    found = [item for item in layout.objects if item.node_id in wanted]
    found = found or [item for item in layout.objects if wanted & {item.asset_id, called.get(item.asset_id, "")}]
    if not found:
        names = [item.node_id for item in layout.objects]
        near = get_close_matches(as_id(name), names, n=3, cutoff=0.6)
        mend = f"did you mean {', '.join(near)}?" if near else f"there are: {', '.join(names[:12])} ..."
        raise InputError(f"there is no {name!r} in {name_of(scene)}", mend=mend)
    if len(found) > 1:
        several = ", ".join(item.node_id for item in found[:6])
        raise InputError(f"{name_of(scene)} has {len(found)} of {name!r}", mend=f"name one: {several}")
    asset = graph.asset(found[0].asset_id)
    if asset.asset_type == "character":
        raise InputError(f"{asset.asset_id} is a person", mend="set a mark in a shot instead")
    if asset.fitted_part:
        raise InputError(f"{asset.asset_id} is a part of {found[0].anchor_asset_id}", mend="move that instead")
    return found[0]


def _whole(item: LayoutObject, place: ThingPlace, before: ThingPlace | None, stand: Stand) -> ThingPlace:
    """Return a place with what was decided before; what hangs, or was given a height, keeps it where it is moved."""
    kept = (
        before.model_dump(exclude_none=True, exclude={"height"} if place.location is not None else None)
        if before
        else {}
    )
    whole = ThingPlace(**{**kept, **place.model_dump(exclude_none=True)})
    thing = stand.thing(item)
    hangs = stand.placements.get(item.asset_id) in ("wall", "ceiling") or (
        thing is not None and thing.floats and not item.fixed
    )
    if whole.location is not None and whole.height is None and hangs:
        return whole.model_copy(update={"height": item.location[2]})
    return whole
