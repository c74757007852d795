"""Things that a person placed: put there in any layout, with what stands on them; and what they are in the way of."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from storyblender.agents.layout_artist.layout_things import anchors_of, room_of, size_of, thing_of, tops_of, walls_of
from storyblender.agents.layout_artist.spatial_planner_view import measures_of
from storyblender.catalog.footprints import piece_boxes
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import props_of
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import plan_of
from storyblender.geometry.boxes import Box, penetration
from storyblender.geometry.relations import CONTACT_DISTANCE, LayoutThing, StandingSurface, distance_outside
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Vec2, Vec3
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Environment, Layout, LayoutObject, SceneContext
from storyblender.memory.scene_decision import ThingPlace
from storyblender.memory.shot_context import Flaw

BY_HAND = "by_hand"
"""Kind of the flaws of things that a person placed."""
_FLAT = 0.05
"""Metres of height up to which nothing stands on a thing, and nobody walks into it: a rug."""
_SMALL = 0.6
"""Metres across up to which a thing that the catalogue does not know is put on surfaces."""
_STEP = 1.3
"""Metres of height up to which things are put on a solid part of the set."""
_TOUCHES, _TUCKED = 0.02, 0.3
"""Metres that a thing may be in another one; a seat goes under its table."""


@dataclass(frozen=True)
class Stand:
    """What is needed to place things in a scene.

    Attributes:
        measures: Measures by asset id.
        plan: The set.
        placements: ``floor``, ``surface``, ``wall`` or ``ceiling`` by asset id, where it is known.
    """

    measures: Mapping[str, AssetMeasure]
    plan: SetPlan
    placements: Mapping[str, str] = field(default_factory=dict[str, str])

    def thing(self, item: LayoutObject) -> LayoutThing | None:
        """Return an object of the layout with its box; None if its asset has no measure."""
        return thing_of(item, self.measures, self.plan, self.placements)

    def is_person(self, item: LayoutObject) -> bool:
        """Return whether an object of the layout is one of the cast."""
        measure = self.measures.get(item.asset_id)
        return measure is not None and measure.asset_type == "character"


def placements_of(assets: Sequence[Asset]) -> dict[str, str]:
    """Return where each asset that the catalogue knows belongs, by asset id: ``floor``, ``surface``, ``wall`` ..."""
    return {asset_id: PROPS[prop].placement for asset_id, prop in props_of(assets).items()}


def stand_of(assets: Sequence[Asset], environment: Environment) -> Stand:
    """Return what is needed to place things in a scene.

    Args:
        assets: Of the story, built.
        environment: The set.
    """
    return Stand(measures_of(assets), plan_of(environment), placements_of(assets))


def bare_object(node_id: str, place: ThingPlace) -> LayoutObject | None:
    """Return a thing of the script where a person placed it, before the crew places the others; None if they only
    turned it.
    """
    if place.location is None:
        return None
    rotation = (0.0, 0.0, place.rotation or 0.0)
    return LayoutObject(node_id=node_id, asset_id=node_id, location=(*place.location, 0.0), rotation=rotation)


def placed_flaws(graph: ContinuityMemoryGraph, scene: SceneContext) -> tuple[Flaw, ...]:
    """Return the flaws of everything that a person placed in a scene.

    Args:
        graph: For the assets.
        scene: With its layout.
    """
    decision, layout, environment = scene.layout_decision, scene.layout, scene.environment
    if decision is None or layout is None or environment is None or not decision.things:
        return ()
    return tuple(obstructions(layout, decision.things, stand_of(graph.assets, environment)))


def carried(things: Mapping[str, ThingPlace], riders: Collection[str], layout: Layout) -> dict[str, ThingPlace]:
    """Return where things that a person placed are, after what they are on was moved or scaled.

    Args:
        things: Where they were placed, by node id.
        riders: Node ids of all that was carried along.
        layout: As it is then.
    """
    found: dict[str, ThingPlace] = {}
    for item in layout.objects:
        if item.node_id in riders and (place := things.get(item.node_id)) is not None:
            now = {"location": item.location[:2], "height": item.location[2], "rotation": item.rotation[2]}
            found[item.node_id] = place.model_copy(
                update={name: value for name, value in now.items() if getattr(place, name) is not None}
            )
    return found


def scale_on_it(layout: Layout, node_id: str, factor: float, stand: Stand) -> Layout:
    """Return a layout in which all that is on a thing is where it is when the thing has another size.

    Args:
        layout: The layout.
        node_id: Of the thing.
        factor: Of its size.
        stand: The scene, with the thing as it was.
    """
    base = next(item for item in layout.objects if item.node_id == node_id).location
    riders = {*riders_of(layout, node_id, stand)}

    def moved(item: LayoutObject) -> LayoutObject:
        x, y, z = (_tidy(here + factor * (there - here)) for there, here in zip(item.location, base, strict=True))
        return item.model_copy(update={"location": (x, y, z)})

    objects = tuple(moved(item) if item.node_id in riders else item for item in layout.objects)
    return layout.model_copy(update={"objects": objects})


def without_placed(graph: ContinuityMemoryGraph, scene: SceneContext, layout: Layout) -> Layout:
    """Return a layout without what a person placed and what is on it: its faults are told apart, as theirs.

    Args:
        graph: For the assets.
        scene: The scene.
        layout: Its layout.
    """
    decision, environment = scene.layout_decision, scene.environment
    if decision is None or environment is None or not decision.things:
        return layout
    stand, there = stand_of(graph.assets, environment), {item.node_id for item in layout.objects}
    placed = [each for each in decision.things if each in there]
    left = {*placed, *(rider for each in placed for rider in riders_of(layout, each, stand))}
    return layout.model_copy(update={"objects": tuple(each for each in layout.objects if each.node_id not in left)})


def place_by_hand(layout: Layout, things: Mapping[str, ThingPlace], stand: Stand) -> Layout:
    """Return a layout with things where a person placed them, and with what stands on each carried along.

    A thing that is already there stays as it is, with what is on it. One without a place in the layout is left out.

    Args:
        layout: Of any staging.
        things: Where things were placed, by node id.
        stand: The scene.
    """
    for _ in range(len(things) + 1):  # what is placed on a thing that is placed itself finds it there in the next round
        before = layout
        for node_id, place in things.items():
            item = next((each for each in layout.objects if each.node_id == node_id), None)
            if item is not None:
                layout = _moved(layout, item, place, stand)
        if layout == before:
            break
    return layout


def riders_of(layout: Layout, node_id: str, stand: Stand) -> list[str]:
    """Return the node ids of all that stands, lies or sits on a thing, or is a part of it, on what is on it as well.

    Args:
        layout: The layout.
        node_id: Of the thing.
        stand: The scene.
    """
    found, waiting = list[str](), [node_id]
    items = {item.node_id: item for item in layout.objects}
    while waiting:
        carrier = items[waiting.pop(0)]
        for item in layout.objects:
            if item.node_id not in (node_id, *found) and _rides(item, carrier, stand):
                found.append(item.node_id)
                waiting.append(item.node_id)
    return found


def obstructions(layout: Layout, node_ids: Collection[str], stand: Stand) -> Iterator[Flaw]:
    """Yield a flaw for everything that things which a person placed stand in, and for each outside of its room.

    Args:
        layout: With the things where they are.
        node_ids: Of the things.
        stand: The scene.
    """
    everything = {item.node_id: item for item in layout.objects}
    standing = {name: thing for name, item in everything.items() if (thing := stand.thing(item)) is not None}
    walls = {wall.name: wall for wall in walls_of(stand.plan)}
    for node_id in node_ids:
        if node_id not in standing:
            continue
        thing, told = standing[node_id], dict[str, float]()
        group = {node_id, *riders_of(layout, node_id, stand)}
        for name, other in {**standing, **walls}.items():
            if name in group or _belong_together(node_id, name, everything, stand):
                continue
            depth = 0.0 if min(thing.box.height, other.box.height) < _FLAT else penetration(thing.box, other.box)[0]
            if depth > (_TUCKED if _tucks(everything[node_id], everything.get(name), stand) else _TOUCHES):
                what = name.rpartition("_")[0] if name in walls else name
                told[what] = max(depth, told.get(what, 0.0))
        for what, depth in told.items():
            message = f"{node_id}, which a person placed, stands {depth:.2f} m deep in {what}"
            yield Flaw(kind=BY_HAND, subject=node_id, weight=round(depth, 3), message=message)
        beyond = distance_outside(thing.box, room_of(layout.scene_size))
        if stand.plan.indoor and beyond > CONTACT_DISTANCE:
            message = f"{node_id}, which a person placed, is {beyond:.2f} m outside the room"
            yield Flaw(kind=BY_HAND, subject=node_id, weight=round(beyond, 3), message=message)


def _moved(layout: Layout, item: LayoutObject, place: ThingPlace, stand: Stand) -> Layout:
    """Return a layout with one thing where a person placed it, and with its riders."""
    x, y = place.location or item.location[:2]
    yaw = item.rotation[2] if place.rotation is None else place.rotation
    riders = {*riders_of(layout, item.node_id, stand)}
    put = item.model_copy(update={"location": (x, y, item.location[2]), "rotation": (*item.rotation[:2], yaw)})
    if place.height is not None:
        put = _resting_on(None, put, lifted=place.height > _FLAT)
        put = put.model_copy(update={"location": (x, y, place.height)})
    elif place.location is not None:
        others = [each for each in layout.objects if each.node_id not in {item.node_id, *riders}]
        below, z = _dropped(put, others, stand)
        put = _resting_on(below, put).model_copy(update={"location": (x, y, z)})
    objects = tuple(
        put if each is item else _carried(each, item, put) if each.node_id in riders else each
        for each in layout.objects
    )
    return layout.model_copy(update={"objects": objects})


def _resting_on(below: str | None, item: LayoutObject, *, lifted: bool = False) -> LayoutObject:
    """Return a placed thing related to what it is on now; that it is beside something stays as the script says it.

    Args:
        below: Node id of what it stands on; None for the floor.
        item: Where it is now.
        lifted: Whether a person gave it a height, in the air or on a surface.
    """
    free = {"anchor_asset_id": None, "relationship": None, "contact": None, "direction": None}
    if below is not None and not item.node_id.startswith("set_"):
        return item.model_copy(update={**free, "anchor_asset_id": below, "relationship": "on_top_of", "contact": True})
    on_or_in = item.anchor_asset_id is not None and item.relationship in ("on_top_of", None) and item.direction is None
    return item.model_copy(update={**(free if on_or_in or lifted else {}), "fixed": item.fixed or lifted})


def _carried(rider: LayoutObject, before: LayoutObject, after: LayoutObject) -> LayoutObject:
    """Return what is on a thing, moved and turned with it."""
    if before.location == after.location and before.rotation == after.rotation:
        return rider
    turn = after.rotation[2] - before.rotation[2]
    cos, sin = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    dx, dy, dz = (there - here for there, here in zip(rider.location, before.location, strict=True))
    x, y, z = after.location
    location = (_tidy(x + cos * dx - sin * dy), _tidy(y + sin * dx + cos * dy), _tidy(z + dz))
    rotation = (*rider.rotation[:2], _tidy(rider.rotation[2] + turn))
    return rider.model_copy(update={"location": location, "rotation": rotation})


def _tidy(value: float) -> float:
    """Return a length or an angle without the noise of a turn there and back: to a tenth of a unit in the third place.

    The crew's own places are multiples of it, so what is moved and moved back is exactly where it was.
    """
    near = round(value, 4)
    return near if abs(value - near) < 1e-6 else round(value, 9)


def _rides(item: LayoutObject, carrier: LayoutObject, stand: Stand) -> bool:
    """Return whether an object of the layout is on another one, in it, seated on it, or a part of it."""
    if item.anchor_asset_id == carrier.node_id:
        return item.relationship == "on_top_of" or (item.relationship is None and item.direction is None)
    carried = item.anchor_asset_id is not None and item.relationship in ("on_top_of", None) and item.direction is None
    measure = stand.measures.get(carrier.asset_id)
    if carried or measure is None or stand.is_person(carrier) or stand.is_person(item):
        return False
    lift = item.location[2] - carrier.location[2]
    if lift < _FLAT:
        return False
    return any(
        abs(top.surface.z - lift) < CONTACT_DISTANCE and _is_over(item.location[:2], carrier, top.surface)
        for top in tops_of(measure)
    )


def _is_over(point: Vec2, carrier: LayoutObject, surface: StandingSurface) -> bool:
    """Return whether a floor point is under a surface of a placed thing."""
    x, y, z = carrier.location
    u, v = Box(x, y, z, 0.0, 0.0, 0.0, math.radians(carrier.rotation[2])).to_local(*point)
    return abs(u - surface.x) <= surface.width / 2 and abs(v - surface.y) <= surface.depth / 2


def _dropped(item: LayoutObject, others: Sequence[LayoutObject], stand: Stand) -> tuple[str | None, float]:
    """Return what a thing comes to stand on when it is dropped, None for the floor or the set, and the height of that.

    Furniture stands on the floor; what belongs on surfaces is put on the highest one below that has room for it.
    """
    measure = stand.measures.get(item.asset_id)
    size: Vec3 = size_of(measure) if measure is not None else (0.4, 0.4, 0.4)
    point = item.location[:2]
    parts = [box for piece in stand.plan.pieces for box in piece_boxes(piece) if box.top < _STEP]
    found: list[tuple[float, str | None]] = [(0.0, None)]
    for box in parts:
        u, v = box.to_local(*point)
        if abs(u) < box.width / 2 and abs(v) < box.depth / 2 and _fits(size, box.width, box.depth):
            found.append((box.top, None))
    if stand.placements.get(item.asset_id, "surface" if max(size) < _SMALL else "floor") == "floor":
        others = ()
    for other in others:
        made = stand.measures.get(other.asset_id)
        if made is None or not anchors_of(made, "top") or stand.is_person(other):
            continue
        for top in tops_of(made):
            roomy = top.clearance is None or top.clearance >= size[2]
            if roomy and _is_over(point, other, top.surface) and _fits(size, top.surface.width, top.surface.depth):
                found.append((other.location[2] + top.surface.z, other.node_id))
    height, node_id = max(found, key=lambda each: each[0])
    return node_id, _tidy(height)


def _fits(size: Vec3, width: float, depth: float) -> bool:
    """Return whether a thing fits on a surface, straight or turned by a quarter."""
    return min(size[:2]) <= min(width, depth) and max(size[:2]) <= max(width, depth)


def _belong_together(first: str, second: str, items: Mapping[str, LayoutObject], stand: Stand) -> bool:
    """Return whether one of two things is on, in or a part of the other."""
    one, other = items[first], items.get(second)
    return other is not None and (_rides(one, other, stand) or _rides(other, one, stand))


def _tucks(one: LayoutObject, other: LayoutObject | None, stand: Stand) -> bool:
    """Return whether one of two things is a seat and the other a table."""
    kinds = [
        {anchor.kind for anchor in stand.measures[each.asset_id].anchors} for each in (one, other) if each is not None
    ]
    return len(kinds) == 2 and any("seat" in a and "top" in b and "seat" not in b for a, b in (kinds, kinds[::-1]))
