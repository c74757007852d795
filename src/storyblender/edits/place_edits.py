"""Edits of places by hand: a thing of a scene is moved and turned, a person's marks in a shot are set."""

from __future__ import annotations

import math
from collections.abc import Iterator
from difflib import get_close_matches

from storyblender.agents.layout_artist.placed_by_hand import (
    Stand,
    carried,
    obstructions,
    place_by_hand,
    riders_of,
    stand_of,
)
from storyblender.agents.visual_effects_artist.animator_critic import LEAST_DISTANCE, LEAST_FREE_SHARE
from storyblender.agents.visual_effects_artist.floor import BODY, Floor
from storyblender.catalog.sets import plan_of
from storyblender.edits.effect import (
    Effect,
    name_of,
    refuse_far,
    refuse_locked,
    refuse_locked_staging,
    scene_effect,
    shot_names,
)
from storyblender.edits.scale_edits import scale_effects
from storyblender.edits.targets import as_id, person_or_thing, scene_named, shots_named
from storyblender.errors import InputError
from storyblender.memory.base import Vec2, shot_name, staged_id
from storyblender.memory.edits import BlockingEdit, PlaceEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.scene_context import Layout, LayoutObject, SceneContext
from storyblender.memory.scene_decision import BlockingDecision, FloorPlace, LayoutDecision, PersonMarks, ThingPlace
from storyblender.memory.shot_context import ShotContext

_JUMP = 0.3
"""Metres from the end of one shot to the start of the next that are told."""


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
    refuse_locked_staging(graph, scene)
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
    taken = carried(decision.things, riders_of(layout, item.node_id, stand), moved)
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


def blocking_effects(graph: ContinuityMemoryGraph, edit: BlockingEdit) -> list[Effect]:
    """Return what setting the marks of a person in a shot does: the scene is acted again from there.

    Args:
        graph: The story.
        edit: The person by their id or name.

    Raises:
        InputError: They are not on stage, or sit or lie; a place cannot be; or something is locked.
    """
    [shot] = shots_named(graph, [edit.shot])
    scene, name = graph.scene(shot.scene_id), name_of(shot)
    person = person_or_thing(graph, edit.person)
    refuse_locked(shot, "blocking")
    if shot.covers is not None:
        staged = shot_name(shot.scene_id, staged_id(shot.shot_id))
        raise InputError(f"{name} shows what is staged for {staged}", mend="set the marks there")
    own = next((each for each in shot.blocking if each.start.asset_id == person), None)
    if own is None:
        there = ", ".join(each.start.asset_id for each in shot.blocking)
        mend = f"there are: {there}" if there else "run `storyblender render` first" if shot.on_stage else "nobody is"
        raise InputError(f"{person} is not on stage in {name}", mend=mend)
    if edit.marks.start is not None and own.start.posture != "stand":
        on = own.start.support_id
        mend = f"move {on}, or set where they end" if on else "set where they end"
        raise InputError(f"{person} does not stand as {name} begins ({own.start.posture})", mend=mend)
    marks = PersonMarks(**{when: _on_floor(place, scene) for when, place in edit.marks if place is not None})
    decided = shot.blocking_decision or BlockingDecision()
    before = decided.people.get(person, PersonMarks())
    whole = PersonMarks(start=_over(before.start, marks.start), end=_over(before.end, marks.end))
    decided = decided.then(BlockingDecision(people={person: whole}))
    item = shot.model_copy(update={"blocking_decision": decided, "stale": ("motion",)})
    said = BlockingDecision(people={person: marks}).words
    effect = Effect(item, name, said, frozenset({"blocking"}), shot_names(graph, shot.scene_id))
    return [effect.warned(tuple(_in_the_way(graph, shot, person, marks)))]


def _over(before: FloorPlace | None, now: FloorPlace | None) -> FloorPlace | None:
    """Return a place with what was decided before where it says nothing."""
    if before is None or now is None:
        return now or before
    return FloorPlace(**{**before.model_dump(), **now.model_dump(exclude_none=True)})


def _on_floor(place: FloorPlace, scene: SceneContext) -> FloorPlace:
    """Return a place as marks have it: to the millimetre and the tenth of a degree. Raises InputError."""
    location = None if place.location is None else (round(place.location[0], 3), round(place.location[1], 3))
    if location is not None:
        refuse_far((*location, 0.0), scene)
    return FloorPlace(location=location, rotation=None if place.rotation is None else round(place.rotation % 360.0, 1))


def _in_the_way(graph: ContinuityMemoryGraph, shot: ShotContext, person: str, marks: PersonMarks) -> Iterator[str]:
    """Yield a sentence for each mark of a person that is in furniture, in another person, or outside of the set."""
    scene = graph.scene(shot.scene_id)
    if scene.layout is None or scene.environment is None:
        return
    floor = Floor(scene.layout, graph.assets_of(scene.scene_id), plan_of(scene.environment))
    for when, place in (("start", marks.start), ("end", marks.end)):
        if place is None or place.location is None:
            continue
        there = f"{person} at the {when} of {name_of(shot)}"
        if floor.room_at(place.location) < LEAST_FREE_SHARE * BODY:
            yield f"{there} stands in furniture or in a wall"
        elif not floor.inside(place.location, -floor.walk_on_distance):
            yield f"{there} stands outside of the set"
        if when == "start" and (cut := _cut_from(graph, shot, person, place.location)):
            yield f"{there} is {cut}"
        others = {each.start.asset_id: getattr(each, when).location[:2] for each in shot.blocking}
        others.pop(person, None)
        near = [other for other, spot in others.items() if math.dist(spot, place.location) < LEAST_DISTANCE]
        if near:
            yield f"{there} stands in {', '.join(near)}"


def _cut_from(graph: ContinuityMemoryGraph, shot: ShotContext, person: str, place: Vec2) -> str:
    """Return how far a mark is from where the shot before leaves a person; empty where that is near, or nowhere."""
    before = [each for each in graph.shots_of(shot.scene_id) if each.shot_id < shot.shot_id][-1:]
    ends = [mark.end.location[:2] for each in before for mark in each.blocking if mark.end.asset_id == person]
    away = math.dist(ends[0], place) if ends else 0.0
    return f"{away:.1f} m from where {name_of(before[0])} leaves them" if away > _JUMP else ""
