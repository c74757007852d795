"""The Spatial Planner played by a language model: it says what everything is placed by; the solver finds the metres.

The model names relations (paper, section 3.4: anchor, relationship, direction, contact). They become spots in the view
of the rules, so whatever it leaves out is placed as usual, and the critic's exact moves are applied by code.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

from pydantic import Field

from storyblender.agents.asking import Asker, LanguagePolicy, Notes
from storyblender.agents.layout_artist.free_room import room_told
from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.layout_things import anchors_of
from storyblender.agents.layout_artist.plan_picture import plan_picture
from storyblender.agents.layout_artist.spatial_planner import RulesSpatialPlanner
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.agents.story_lines import story_lines
from storyblender.catalog.fixtures import Fixture, fixtures_called, fixtures_of
from storyblender.geometry.boxes import Box, distance_to_point, footprint_gap, yaw_along
from storyblender.memory.base import Identifier, scene_name
from storyblender.memory.scene_context import Layout, LayoutObject, Relation, Spot
from storyblender.memory.shot_context import BodyState
from storyblender.memory.vocabulary import RelationKind, Side
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import SEEN, Critique, Policy, view_digest

_NEAR = 2.5
"""Metres from the playing area within which a part of the set is offered."""
_REACH = 1.0
"""Metres from its anchor, beyond the wished distance, at which something is not in its place."""
_PARTS = 32
"""Most parts of the set in one request."""


class Placement(Notes):
    """Where one thing or person is as the scene begins."""

    id: Identifier
    """From ``things`` or ``people``."""
    relation: RelationKind
    anchor: Identifier
    """What it is placed by: an id of ``furniture``, ``things``, ``people`` or ``parts_of_set``."""
    second_anchor: Identifier | None = None
    """The other of two, for ``between``."""
    side: Side | None = None
    """Side of the anchor, from the anchor's own point of view."""
    distance: float | None = Field(default=None, ge=0, le=30)
    """Metres from the anchor's edge."""
    facing: Identifier | None = None
    """An id to face, ``away`` from the anchor, or ``camera``."""


class LayoutNotes(Notes):
    """The layout of a scene as relations; whatever is left out is placed by rules."""

    places: tuple[Placement, ...] = ()


def language_spatial_planner(
    answerer: Answerer, embedder: Callable[[], Embedder]
) -> Policy[SpatialPlannerView, Layout]:
    """Return the Spatial Planner played by a model; rules solve what it says, and apply the critic's numbers.

    Args:
        answerer: The model, or a person in its place.
        embedder: Not used: there is no long vocabulary to choose from.
    """
    rules = RulesSpatialPlanner()
    told = set[str]()

    def mend(draft: Layout, critique: Critique, view: SpatialPlannerView) -> Layout:
        computed = any(fault.fix for fault in critique.faults if fault.kind != SEEN)
        return rules.refine(draft, critique, view) if computed else draft

    def check(answer: LayoutNotes, view: SpatialPlannerView) -> Iterator[str]:
        """Yield what cannot be, and once for a view what the solver found no room for."""
        wrong = [*_wrong(answer, view)]
        yield from wrong
        if not wrong and (seen := view_digest(view)) not in told:
            told.add(seen)
            yield from _unmet(answer, _laid_out(answer, view, rules), view)

    return LanguagePolicy(
        Asker(answerer, "spatial_planner", LayoutNotes),
        show=shown_scene,
        draft_of=lambda answer, view: _laid_out(answer, view, rules),
        check=check,
        subject=lambda view: scene_name(view.scene_id),
        mend=mend,
        draft_pictures=lambda draft, view: (plan_picture(draft, view),),
        settled=lambda view: None if view.states or view.found_later or view.pending else rules.propose(view),
    )


def shown_scene(view: SpatialPlannerView) -> dict[str, Any]:
    """Return what a model is shown of a scene.

    Args:
        view: The scene.

    Returns:
        JSON values: metres, degrees, x to the right and y away from the audience.
    """
    stage, size = LayoutStage(view), view.plan.size
    return {
        "place": view.setup.place,
        "story": story_lines(view.outline),
        "room": {"x": [size.x_negative, size.x], "y": [size.y_negative, size.y]},
        "things": [_shown_thing(each, view) for each in _waiting(view, stage)],
        "people": [_shown_person(each, view) for each in (*view.states, *view.found_later)],
        "in_conversation": view.groups,
        "furniture": [_shown_furniture(name, stage) for name in stage.things],
        "parts_of_set": [
            {"id": part.name, "kind": part.kind, "at": _rounded(part.box.x, part.box.y)} for part in _parts(view)
        ],
    }


def _waiting(view: SpatialPlannerView, stage: LayoutStage) -> list[str]:
    """Return the asset ids of the things that have no place yet."""
    return [asset_id for asset_id in view.pending if stage.find(asset_id) is None]


def _shown_thing(asset_id: str, view: SpatialPlannerView) -> dict[str, Any]:
    told = {
        "id": asset_id,
        "is": view.props.get(asset_id),
        "size": _size(*view.measures[asset_id].dimensions) if asset_id in view.measures else None,
        "goes_on": view.placements.get(asset_id),
        "taken_by": [*dict.fromkeys(view.handlers.get(asset_id, ()))],
        "script_says": _shown_spot(view.scripted_spots.get(asset_id)),
    }
    return {name: value for name, value in told.items() if value}


def _shown_person(state: BodyState, view: SpatialPlannerView) -> dict[str, Any]:
    told = {
        "id": state.asset_id,
        "posture": state.posture,
        "on": state.support_id,
        "holds": state.held,
        "looks_at": state.looking_at,
        "first_does": [motion for motion, _ in view.first_actions.get(state.asset_id, ())],
        "beside": view.companions.get(state.asset_id),
        "script_says": _shown_spot(state.spot),
        "first_seen_later": state in view.found_later,
    }
    return {name: value for name, value in told.items() if value}


def _shown_spot(spot: Spot | None) -> dict[str, Any]:
    return spot.model_dump(exclude_none=True) if spot is not None else {}


def _shown_furniture(name: str, stage: LayoutStage) -> dict[str, Any]:
    """Return a thing that stands already."""
    box, asset_id = stage.things[name].box, stage.assets[name]
    told = {
        "id": name,
        "is": stage.view.props.get(asset_id, asset_id),
        "at": _rounded(box.x, box.y),
        "size": _size(box.width, box.depth, box.height),
        "faces_degrees": round(math.degrees(box.yaw)),
        "seats": len(anchors_of(stage.measure(asset_id), "seat")),
        "on": stage.things[name].anchor if stage.things[name].relationship == "on_top_of" else None,
    }
    return {key: value for key, value in told.items() if value is not None}


def _rounded(*metres: float) -> list[float]:
    return [round(each, 1) for each in metres]


def _size(*metres: float) -> list[float]:
    return [round(each, 2) for each in metres]


def _parts(view: SpatialPlannerView) -> list[Fixture]:
    """Return the parts of the set that a name means exactly, those in or next to the playing area."""
    size = view.plan.size
    area = Box((size.x + size.x_negative) / 2, (size.y + size.y_negative) / 2, 0.0, 0.0, 0.0, 0.0)
    area.width, area.depth = size.x - size.x_negative, size.y - size.y_negative
    near = [each for each in fixtures_of(view.plan) if distance_to_point(area, each.box.x, each.box.y) < _NEAR]
    return [each for each in near if fixtures_called(view.plan, each.name)[:1] == [each]][:_PARTS]


def _wrong(answer: LayoutNotes, view: SpatialPlannerView) -> Iterator[str]:
    """Yield ids that do not exist, and places that depend on themselves."""
    stage = LayoutStage(view)
    ours = {*_waiting(view, stage), *(state.asset_id for state in (*view.states, *view.found_later))}
    known = {*ours, *stage.things, *stage.assets.values(), *(part.name for part in _parts(view))}
    placed = [each.id for each in answer.places]
    for name in dict.fromkeys(name for name in placed if placed.count(name) > 1):
        yield f"{name} has {placed.count(name)} places; give one"
    for each in answer.places:
        if each.id not in ours:
            yield f"{each.id!r} is neither in `things` nor in `people`; only those are placed"
        for name in (each.anchor, each.second_anchor):
            if name is not None and name not in known:
                yield f"{each.id} is placed by {name!r}, which does not exist; take an id of the lists"
        if each.facing is not None and each.facing not in {*known, "away", "camera"}:
            yield f"{each.id} faces {each.facing!r}, which does not exist; take an id, `away` or `camera`"
        if each.relation == "between" and each.second_anchor is None:
            yield f"{each.id} is between {each.anchor} and nothing; give `second_anchor`"
    yield from _circles(answer.places)


def _circles(places: Sequence[Placement]) -> Iterator[str]:
    """Yield each place that depends on itself."""
    by = {each.id: each.anchor for each in places}
    for start in by:
        chain = [start]
        while (following := by.get(chain[-1])) is not None and following not in chain:
            chain.append(following)
        if following == start and start == min(chain):
            yield f"{' is placed by '.join([*chain, start])}; give one of them a place by something else"


def _unmet(answer: LayoutNotes, layout: Layout, view: SpatialPlannerView) -> Iterator[str]:
    """Yield each placement that the solved layout does not have."""
    stage = LayoutStage(view)
    for item in layout.objects:
        if item.node_id not in stage.things:
            stage.add_object(item, fixed=True)
    for each in answer.places:
        thing, anchor = stage.find(each.id), stage.find_anchor(each.anchor)
        said = f"there is no room for {each.id} {each.relation} {each.anchor}"
        if anchor is None:
            yield f"{said}; give it another place"
            continue
        where = ""
        if thing is not None:
            gap = footprint_gap(thing.box, anchor.box)[0] - (each.distance or 0.0)
            if gap <= _REACH and not (each.relation == "on" and anchor.name in stage.things and gap > 0):
                continue
            where = f", it came {max(gap, 0.1):.1f} m from there"
        yield f"{said}{where}; {room_told(stage, each.id, anchor, each.relation)}; give it another place"


def _laid_out(answer: LayoutNotes, view: SpatialPlannerView, rules: RulesSpatialPlanner) -> Layout:
    """Return the solved layout in which things and people are where the model wants them."""
    spots = {each.id: _spot(each, view.scripted_spots.get(each.id)) for each in answer.places}
    between = tuple(
        Relation(
            asset_id=each.id, kind="between", anchor_asset_id=each.anchor, second_anchor_asset_id=each.second_anchor
        )
        for each in answer.places
        if each.relation == "between"
    )  # fmt: skip
    wished = replace(
        view,
        setup=view.setup.model_copy(update={"relations": (*between, *view.setup.relations)}),
        scripted_spots={**view.scripted_spots, **{name: spot for name, spot in spots.items() if name in view.pending}},
        states=_with_spots(view.states, spots),
        found_later=_with_spots(view.found_later, spots),
    )
    layout = rules.propose(wished)
    turned = tuple(_turned(item, spots.get(item.asset_id), layout.objects, view) for item in layout.objects)
    if turned == layout.objects:
        return layout
    return rules.refine(layout.model_copy(update={"objects": turned}), Critique(score=10.0), view)


def _spot(place: Placement, told: Spot | None) -> Spot:
    """Return the spot of a placement; the height is the script's, if that has the same anchor."""
    height = told.height if told is not None and told.anchor_id == place.anchor else None
    return Spot(
        relation=place.relation, anchor_id=place.anchor, side=place.side, distance=place.distance, height=height,
        facing=place.facing,
    )  # fmt: skip


def _with_spots(states: Iterable[BodyState], spots: dict[str, Spot]) -> tuple[BodyState, ...]:
    """Return the states with the spots of the people who have one."""
    return tuple(state.model_copy(update={"spot": spots.get(state.asset_id, state.spot)}) for state in states)


def _turned(
    item: LayoutObject, spot: Spot | None, placed: Sequence[LayoutObject], view: SpatialPlannerView
) -> LayoutObject:
    """Return a free thing of the script turned to what it is to face; people are turned by the rules."""
    if spot is None or spot.facing is None or item.asset_id not in view.pending or item.fixed:
        return item
    x, y, _ = item.location
    target = next((each.location[:2] for each in placed if spot.facing in (each.node_id, each.asset_id)), None)
    part = next((each.box for each in fixtures_called(view.plan, spot.facing)), None)
    if target is None and part is not None:
        target = (part.x, part.y)
    anchor = next((each.location[:2] for each in placed if each.node_id == item.anchor_asset_id), None)
    if spot.facing == "camera":
        target = (x, y - 1.0)
    elif spot.facing == "away" and anchor is not None:
        target = (2 * x - anchor[0], 2 * y - anchor[1])
    if target is None:
        return item
    degrees = round(math.degrees(yaw_along(target[0] - x, target[1] - y)), 1)
    direction = "facing" if target == anchor else "facing_away" if spot.facing == "away" else None
    return item.model_copy(update={"rotation": (*item.rotation[:2], degrees), "direction": direction})
