"""The Set Dresser: furnishings of a set become assets and placed objects, and give way to things of the script.

Hand-over to the Spatial Planner
    ``SetDresserDraft.objects`` have their places: the kit's furniture (``fixed``, one asset per prop and shared by all
    scenes) and those things of the script that took a furnishing's place, such as the script's own piano in a
    cafe (also ``fixed``; their ``node_id`` is their asset id). ``SetDresserDraft.pending`` are the script's objects
    that still need a place; the planner puts them around, on or in the others. ``SetDresserDraft.assets`` join the
    asset sheet.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from storyblender.agents.layout_artist.scripted_spots import scripted_relations
from storyblender.agents.visual_effects_artist.furniture import (
    TUCKED_OVERLAP,
    PlacedFurnishing,
    box_at,
    draw_up_seats,
    drop_clutter,
    prop_size,
    raise_to_new_tops,
    size_of_asset,
)
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_families import family_of
from storyblender.catalog.props.prop_names import kind_named, prop_of
from storyblender.catalog.set_plan import Furnishing, SetPlan
from storyblender.catalog.sets import furnished_in, plan_of
from storyblender.catalog.sets.drawing import Period
from storyblender.geometry.boxes import Box, footprint_gap, penetration
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Frozen, Identifier, Vec2
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline
from storyblender.memory.scene_context import LayoutObject, SceneSetup
from storyblender.reflection import Critique, Fault

_STAGE: Vec2 = (0.0, 0.8)
"""Floor point where things of the script are wanted: the middle, a little away from the audience."""

_TOGETHER = 1.8
"""Most metres from a thing of the script to a furnishing that is replaced by the thing beside it."""
_LARGEST_SHARE_OF_FLOOR = 0.25
"""Share of a room's floor above which an object is too large for the room."""
_BESIDE_STAGE = 0.5
"""Metres outside the playing area at which people still get to a thing."""
_LARGEST_LENGTH = 0.6
"""Share of the longer side of the playing area above which an object is left where the set has its like."""
_VEHICLES = family_of("car")
"""Vehicles: those in the script replace all vehicles of the kit."""
_COUNTERS = frozenset({"bar_counter", "counter"})
"""A place has only one of these: in a bar, "the bar" and "the counter" are the same thing."""


@dataclass(frozen=True)
class SetDresserView:
    """What the Set Dresser sees of a scene.

    Attributes:
        setup: The setup with the script's relations.
        plan: The set.
        objects: The script's own objects in this scene, with their geometry (``canonical``) if known.
        people: Number of people on stage at once.
        period: When the place was furnished.
        before: The dressing of the earlier scene in the same place; empty if there is none.
        outline: The words of the scene, which only a language model reads.
    """

    setup: SceneSetup
    plan: SetPlan
    objects: tuple[Asset, ...] = ()
    people: int = 2
    period: Period = "classic"
    before: tuple[LayoutObject, ...] = ()
    outline: SceneOutline | None = None


class SetDresserDraft(Frozen):
    """A dressed set."""

    assets: tuple[Asset, ...] = ()
    """Dressing of this scene (``origin = "dressing"``): the same prop is the same asset in every scene."""
    objects: tuple[LayoutObject, ...] = ()
    """Placed objects, in world coordinates."""
    pending: tuple[Identifier, ...] = ()
    """Asset ids of the script's objects that the Spatial Planner has to place."""
    dropped: tuple[str, ...] = ()
    """node_ids of furnishings that were left out."""


def set_dresser_view(graph: ContinuityMemoryGraph, scene_id: int) -> SetDresserView:
    """Return the Set Dresser's projection of the graph.

    Args:
        graph: The graph, with the scene's environment.
        scene_id: Number of the scene.
    """
    scene = graph.scene(scene_id)
    assert scene.environment is not None, "the set comes before its dressing"
    told, reference = scripted_relations(scene.setup, graph.shots_of(scene_id)), scene.setup.reference_scene_id
    layout = graph.scene(reference).layout if reference is not None else None
    return SetDresserView(
        setup=scene.decided_setup.model_copy(update={"relations": told}),
        plan=plan_of(scene.environment),
        objects=graph.own_objects_of(scene_id),
        people=graph.people_in(scene_id),
        period=furnished_in(scene.environment),
        before=tuple(item for item in layout.objects if item.node_id.startswith("set_")) if layout is not None else (),
        outline=graph.outline_of(scene_id),
    )


class RulesSetDresser:
    """Dresses the set as its kit plans; things of the script come first, optional dressing gives way."""

    def propose(self, view: SetDresserView) -> SetDresserDraft:
        """Return the dressed set."""
        taken = _assign_furnishing_places(view)
        drives = any(prop_of(asset) in _VEHICLES for asset in view.objects)
        vehicles = [item for item in view.plan.furnishings if drives and item.prop in _VEHICLES]
        parked = {item.node_id for item in vehicles if _is_within_reach(item, None, view.plan)} - taken.keys()
        kept_items = [item for item in view.plan.furnishings if item.node_id not in parked]
        standing = [PlacedFurnishing.of(item, taken.get(item.node_id)) for item in kept_items]
        raise_to_new_tops(standing)
        draw_up_seats(standing)
        kept, dropped = drop_clutter(standing, view.plan, view.people)
        assets = {item.asset.asset_id: item.asset for item in kept if item.asset.origin == "dressing"}
        shown = {asset.asset_id for asset in taken.values()} | {*view.setup.scenery} | _shown_by_set(view)
        served = _has_counter(taken)
        return SetDresserDraft(
            assets=tuple(assets.values()),
            objects=tuple(item.layout_object() for item in kept),
            pending=tuple(
                asset.asset_id
                for asset in view.objects
                if asset.asset_id not in shown
                and not asset.fitted_part
                and not _is_too_large_for_room(asset, view.plan)
                and not (served and prop_of(asset) in _COUNTERS)
            ),
            dropped=(*dropped, *sorted(parked)),
        )

    def refine(self, draft: SetDresserDraft, critique: Critique, view: SetDresserView) -> SetDresserDraft:
        """Leave out the objects that the critic's faults name.

        Args:
            draft: The dressed set.
            critique: Its faults.
            view: The scene.
        """
        gone = {fault.subject for fault in critique.faults}
        kept = tuple(item for item in draft.objects if item.node_id not in gone)
        used = {item.asset_id for item in kept}
        return SetDresserDraft(
            assets=tuple(asset for asset in draft.assets if asset.asset_id in used),
            objects=kept,
            pending=draft.pending,
            dropped=(*draft.dropped, *sorted(gone)),
        )


class SetDresserCritic:
    """Finds dressing that stands in other dressing or outside the set."""

    def judge(self, draft: SetDresserDraft, view: SetDresserView) -> Critique:
        """Return the critique of a dressed set; a fault's subject is the object to leave out.

        Args:
            draft: The dressed set.
            view: The scene.
        """
        required = {item.node_id for item in view.plan.furnishings if item.required}
        sizes = {asset.asset_id: size_of_asset(asset) for asset in (*draft.assets, *view.objects)}
        boxes = [(item, box_at(item.location, item.rotation[2], sizes[item.asset_id])) for item in draft.objects]
        faults, size = [], view.plan.size
        for index, (item, box) in enumerate(boxes):
            if not item.node_id.startswith("set_") or item.node_id in required:
                continue
            if view.plan.indoor and not (
                size.x_negative - 0.1 < box.x < size.x + 0.1 and size.y_negative - 0.1 < box.y < size.y + 0.1
            ):
                faults.append(
                    Fault(kind="outside", subject=item.node_id, message=f"{item.node_id} is outside the walls")
                )
            elif any(penetration(box, other, 0.02)[0] > TUCKED_OVERLAP for _, other in boxes[:index]):
                faults.append(
                    Fault(kind="collision", subject=item.node_id, message=f"{item.node_id} stands in another")
                )
        return Critique.of(tuple(faults))


def _assign_furnishing_places(view: SetDresserView) -> dict[str, Asset]:
    """Return the script's object that takes the place of each furnishing of the kit, by the furnishing's node id."""
    taken: dict[str, Asset] = {}
    where: dict[str, Vec2] = {}
    anchors = {relation.asset_id: relation.anchor_asset_id for relation in view.setup.relations}
    places = _shown_by_set(view)
    floating = {
        relation.asset_id
        for relation in view.setup.relations
        if relation.kind in ("on", "in", "inside", "under", "over") and relation.anchor_asset_id not in places
    }
    floating |= _drawn_up_seats(view)
    ids = {asset.asset_id for asset in view.objects if not asset.fitted_part} - places
    waiting = [asset for asset in view.objects if asset.asset_id in ids - floating]
    waiting.sort(key=lambda asset: anchors.get(asset.asset_id) in ids)  # stable: anchors of others go first
    for asset in waiting:
        anchor = anchors.get(asset.asset_id)
        if (anchor in ids and anchor not in where) or (prop_of(asset) in _COUNTERS and _has_counter(taken)):
            continue
        near = where.get(anchor, _STAGE) if anchor else _STAGE
        found = _best_place(view.plan, asset, near, taken)
        if found is not None and (anchor not in where or math.dist(found.location[:2], near) < _TOGETHER):
            taken[found.node_id] = asset
            where[asset.asset_id] = found.location[:2]
    return taken


def _drawn_up_seats(view: SetDresserView) -> set[str]:
    """Return the ids of single seats beside a thing that a character is at: they face it, near enough to sit down."""
    used = {each.anchor_asset_id for each in view.setup.relations if each.kind == "at"}
    beside = {each.asset_id for each in view.setup.relations if each.kind == "next_to" and each.anchor_asset_id in used}
    seats = {asset.asset_id for asset in view.objects if (key := prop_of(asset)) in PROPS and PROPS[key].seats == 1}
    return beside & seats


def _written_prop(asset: Asset) -> str:
    """Return the prop that the script's words mean; what a person has it made from takes the place of that one."""
    return (asset.decision and kind_named(asset.name or asset.asset_id)) or prop_of(asset)


def _has_counter(taken: dict[str, Asset]) -> bool:
    """Tell whether one of the script's objects is the counter; ``taken`` has the objects by furnishing node id."""
    return any(prop_of(asset) in _COUNTERS for asset in taken.values())


def _shown_by_set(view: SetDresserView) -> set[str]:
    """Return the ids of the objects that the set shows by itself; what it is furnished with is still replaced."""
    parts, furnished = ({piece.part for piece in view.plan.pieces}, {item.prop for item in view.plan.furnishings})
    return {
        asset.asset_id
        for asset in view.objects
        if asset.asset_id in view.setup.scenery or (asset.kind == "" and asset.asset_id in parts)
        if prop_of(asset) not in furnished
    }


def _is_too_large_for_room(asset: Asset, plan: SetPlan) -> bool:
    """Tell whether an object is higher than the ceiling and covers much of the floor, so that it must be outside."""
    size, (width, depth, height) = plan.size, size_of_asset(asset)
    ceiling = max((wall.base + wall.height for wall in plan.walls), default=math.inf)
    floor = (size.x - size.x_negative) * (size.y - size.y_negative)
    return plan.indoor and height > ceiling and width * depth > _LARGEST_SHARE_OF_FLOOR * floor


def _best_place(plan: SetPlan, asset: Asset, near: Vec2, taken: dict[str, Asset]) -> Furnishing | None:
    """Return the free furnishing nearest to a floor point that an object can replace.

    Args:
        plan: The set.
        asset: The object.
        near: Floor point, metres in the set.
        taken: Objects that have a place already, by the node id of the furnishing they replace.

    Returns:
        A furnishing with the same prop, else with one of its family; None if there is none, or only where nobody
        gets to the object although the playing area has room for it.
    """
    prop = _written_prop(asset)
    choices = [
        item
        for item in plan.furnishings
        if item.prop in family_of(prop) and item.node_id not in taken and not item.loose
        if _is_within_reach(item, asset, plan)
    ]
    return min(
        choices,
        key=lambda item: (item.prop != prop, not item.required, round(math.dist(item.location[:2], near), 3)),
        default=None,
    )


def _is_within_reach(item: Furnishing, asset: Asset | None, plan: SetPlan) -> bool:
    """Return whether people get to a furnishing, or to an object in its place, or it is too large for the stage."""
    area, size = plan.size, size_of_asset(asset) if asset is not None else prop_size(item.prop, item.params)
    across, along = area.x - area.x_negative, area.y - area.y_negative
    if plan.indoor or max(size[:2]) > _LARGEST_LENGTH * max(across, along):
        return True
    box = box_at(item.location, item.yaw, size)
    middle = Box((area.x + area.x_negative) / 2, (area.y + area.y_negative) / 2, 0.0, across, along, 1.0, 0.0)
    return footprint_gap(box, middle)[0] < _BESIDE_STAGE
