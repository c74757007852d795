"""The Set Dresser: the furnishings of a set become assets and placed objects, giving way to what the script names.

Hand-over to the Spatial Planner
    ``Dressing.objects`` stand already: the kit's furniture (``fixed``, one asset per prop and shared by all scenes) and
    those things of the script that took over a furnishing's place, such as the script's own piano in a cafe (also
    ``fixed``; their ``node_id`` is their asset id). ``Dressing.pending`` are the script's objects that still need a
    place; the planner puts them around, on or in what stands. ``Dressing.assets`` join the asset sheet.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from storyblender.catalog.props import PROPS
from storyblender.catalog.set_plan import Furnishing, SetPlan
from storyblender.catalog.sets import SETS
from storyblender.geometry.boxes import Box, penetration
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.base import Frozen, Identifier, Vec2, Vec3, content_hash
from storyblender.memory.scene_context import LayoutObject, SceneSetup
from storyblender.reflection import Critique, Fault

_TOUCH = 0.03
"""Metres that two props may share before one of them has to go."""
_TUCKED = 0.3
"""The same for a seat, which goes under its table."""
_STAGE: Vec2 = (0.0, 0.8)
"""Where the script's things want to be: the middle, a little away from the audience."""
_CLEAR = 1.25
"""Half the side of the square in the middle that dressing leaves to people."""
_CLEAR_PER_PERSON = 0.15

_FAMILIES: tuple[frozenset[str], ...] = tuple(
    frozenset(line.split())
    for line in (
        "round_table dining_table side_table coffee_table",
        "desk workbench school_desk",
        "chair office_chair stool rocking_chair deck_chair",
        "armchair rocking_chair",
        "sofa booth",
        "bench pew",
        "bed hospital_bed bunk_bed",
        "nightstand side_table",
        "wardrobe cabinet dresser locker bookshelf",
        "bar_counter counter",
        "piano grand_piano",
        "stove wood_stove",
        "table_lamp bankers_lamp candle_holder lantern candelabra",
        "floor_lamp candelabra",
        "pendant_lamp chandelier",
        "wall_clock",
        "picture wall_map notice_board",
        "television",
        "fireplace",
        "car van taxi truck police_car",
        "cart wagon carriage",
        "crate barrel chest cardboard_box",
        "market_stall",
        "log",
        "throne",
    )
)
"""Props that stand for each other: the script's table takes the place of whatever table the kit has."""


@dataclass(frozen=True)
class DressingView:
    """What the Set Dresser sees.

    Attributes:
        setup: With the script's relations.
        plan: Of the scene's environment.
        objects: The script's own objects in this scene, with what they became (``canonical``) where known.
        people: How many are on stage at once.
    """

    setup: SceneSetup
    plan: SetPlan
    objects: tuple[Asset, ...] = ()
    people: int = 2


class Dressing(Frozen):
    """A dressed set."""

    assets: tuple[Asset, ...] = ()
    """Dressing of this scene (``origin = "dressing"``): the same prop is the same asset in every scene."""
    objects: tuple[LayoutObject, ...] = ()
    """What stands already, in world coordinates."""
    pending: tuple[Identifier, ...] = ()
    """Asset ids of the script's objects that the Spatial Planner has to place."""
    dropped: tuple[str, ...] = ()
    """node_ids of furnishings that were left out."""


class RulesSetDresser:
    """Places what the kit planned; the script's things come first, optional dressing gives way."""

    def propose(self, view: DressingView) -> Dressing:
        """Return the dressed set."""
        taken = _take_over(view)
        standing = [_Standing.of(item, taken.get(item.node_id)) for item in view.plan.furnishings]
        _settle_on_new_tops(standing)
        _draw_up_seats(standing)
        kept, dropped = _without_clutter(standing, view.people)
        assets = {item.asset.asset_id: item.asset for item in kept if item.asset.origin == "dressing"}
        placed = {asset.asset_id for asset in taken.values()}
        return Dressing(
            assets=tuple(assets.values()),
            objects=tuple(item.placed() for item in kept),
            pending=tuple(
                asset.asset_id
                for asset in view.objects
                if asset.asset_id not in placed and not _is_the_place(asset, view)
            ),
            dropped=tuple(dropped),
        )

    def refine(self, draft: Dressing, critique: Critique, view: DressingView) -> Dressing:
        """Leave out what the critic names."""
        gone = {fault.subject for fault in critique.faults}
        kept = tuple(item for item in draft.objects if item.node_id not in gone)
        used = {item.asset_id for item in kept}
        return Dressing(
            assets=tuple(asset for asset in draft.assets if asset.asset_id in used),
            objects=kept,
            pending=draft.pending,
            dropped=(*draft.dropped, *sorted(gone)),
        )


class DressingCritic:
    """Looks for dressing that stands in other dressing or outside the set."""

    def judge(self, draft: Dressing, view: DressingView) -> Critique:
        """Score ten less one for each; a fault's subject is the object to leave out."""
        required = {item.node_id for item in view.plan.furnishings if item.required}
        sizes = {asset.asset_id: _size_of_asset(asset) for asset in (*draft.assets, *view.objects)}
        boxes = [(item, _box(item.location, item.rotation[2], sizes[item.asset_id])) for item in draft.objects]
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
            elif any(penetration(box, other, 0.02)[0] > _TUCKED for _, other in boxes[:index]):
                faults.append(
                    Fault(kind="collision", subject=item.node_id, message=f"{item.node_id} stands in another")
                )
        return Critique.of(tuple(faults))


def dressing_asset(prop: str, params: dict[str, float | str | bool]) -> Asset:
    """Return the asset of a prop that the kit brings: one per prop and parameters, shared by all scenes."""
    suffix = f"_{content_hash(dict(params))[:4]}" if params else ""
    asset_id = f"set_{prop}{suffix}"
    entry = PROPS.get(prop)
    canonical = None
    if entry is not None:
        canonical = CanonicalAsset(
            source="catalog",
            key=prop,
            params=dict(params),
            dimensions=prop_size(prop, params),
            digest=content_hash("catalog", prop, dict(params)),
        )
    return Asset(
        asset_id=asset_id,
        asset_type="object",
        name=prop.replace("_", " "),
        description=(entry.description or entry.name) if entry is not None else prop.replace("_", " "),
        tags=entry.tags if entry is not None else (),
        origin="dressing",
        canonical=canonical,
    )


def prop_size(prop: str, params: dict[str, float | str | bool]) -> Vec3:
    """Return width, depth and height of a prop as the kit wants it."""
    entry = PROPS.get(prop)
    usual = entry.size if entry is not None else (0.6, 0.6, 0.8)
    width, depth, height = (
        float(params.get(name, size)) for name, size in zip(("width", "depth", "height"), usual, strict=True)
    )
    return (width, depth, height)


# ---------------------------------------------------------------------- the script's things first


def _take_over(view: DressingView) -> dict[str, Asset]:
    """Return which furnishing's place each of the script's objects takes, by the furnishing's node_id."""
    taken: dict[str, Asset] = {}
    where: dict[str, Vec2] = {}
    anchors = {relation.asset_id: relation.anchor_asset_id for relation in view.setup.relations}
    floating = {
        relation.asset_id
        for relation in view.setup.relations
        if relation.kind in ("on", "in", "inside", "under", "over")
    }
    ids = {asset.asset_id for asset in view.objects}
    waiting = [asset for asset in view.objects if asset.asset_id not in floating]
    waiting.sort(key=lambda asset: anchors.get(asset.asset_id) in ids)  # stable: what others stand next to goes first
    for asset in waiting:
        anchor = anchors.get(asset.asset_id)
        if anchor in ids and anchor not in where:
            continue
        near = where.get(anchor, _STAGE) if anchor else _STAGE
        found = _best_place(view.plan, prop_of(asset), near, taken)
        if found is not None:
            taken[found.node_id] = asset
            where[asset.asset_id] = found.location[:2]
    return taken


def _is_the_place(asset: Asset, view: DressingView) -> bool:
    """Return whether a thing nobody can build as a prop is the set itself, or stands in it as a part of the set.

    A pier in a harbour and a lighthouse above a beach are there already; a box with their name on it is not wanted.
    """
    if prop_of(asset) is not None:
        return False
    name = asset.name.lower()
    kit = SETS[view.plan.kit]
    parts = {piece.part.replace("_", " ") for piece in view.plan.pieces}
    return name in {kit.key.replace("_", " "), view.setup.place.lower(), *kit.tags, *parts}


def _best_place(plan: SetPlan, prop: str | None, near: Vec2, taken: dict[str, Asset]) -> Furnishing | None:
    """Return the free furnishing of the same sort that is nearest; the very same prop wins over its family."""
    if prop is None:
        return None
    kin = frozenset({prop}).union(*(family for family in _FAMILIES if prop in family))
    choices = [item for item in plan.furnishings if item.prop in kin and item.node_id not in taken]
    return min(
        choices,
        key=lambda item: (item.prop != prop, not item.required, round(math.dist(item.location[:2], near), 3)),
        default=None,
    )


def prop_of(asset: Asset) -> str | None:
    """Return the key of the prop that an object is: what it became, else what it is called."""
    if asset.canonical is not None and asset.canonical.source == "catalog":
        return asset.canonical.key
    name = _words(asset.name or asset.asset_id)
    best: tuple[int, str] | None = None
    for entry in PROPS.values():
        for term in (entry.key.replace("_", " "), *entry.tags):
            phrase = _words(term)
            if phrase and name[-len(phrase) :] == phrase and (best is None or len(phrase) > best[0]):
                best = (len(phrase), entry.key)
    return None if best is None else best[1]


def _words(text: str) -> list[str]:
    return re.findall(r"[a-z']+", text.lower().replace("_", " "))


# ---------------------------------------------------------------------- what stands


@dataclass
class _Standing:
    item: Furnishing
    asset: Asset
    size: Vec3
    location: Vec3

    @classmethod
    def of(cls, item: Furnishing, taken_by: Asset | None) -> _Standing:
        if taken_by is None:
            asset = dressing_asset(item.prop, item.params)
            return cls(item, asset, prop_size(item.prop, item.params), item.location)
        planned, size = prop_size(item.prop, item.params), _size_of_asset(taken_by)
        turn, deeper = math.radians(item.yaw), (size[1] - planned[1]) / 2
        hung = PROPS[item.prop].placement == "ceiling" if item.prop in PROPS else False
        rise = planned[2] - size[2] if hung else 0.0
        x, y, z = item.location
        # a deeper thing steps out of the wall behind it, a shallower one back to it
        return cls(item, taken_by, size, (x + deeper * math.sin(turn), y - deeper * math.cos(turn), z + rise))

    @property
    def scripted(self) -> bool:
        return self.asset.origin != "dressing"

    @property
    def box(self) -> Box:
        return _box(self.location, self.item.yaw, self.size)

    @property
    def tolerance(self) -> float:
        """Metres it may reach into another footprint: a chair goes under its table."""
        return _TUCKED if _is_seat(self.item.prop) else _TOUCH

    @property
    def in_the_way(self) -> bool:
        """Whether it takes room on the floor: not a rug, not what hangs."""
        return self.location[2] < 1.6 and self.size[2] > 0.05

    def placed(self) -> LayoutObject:
        x, y, z = (round(value, 3) for value in self.location)
        return LayoutObject(
            node_id=self.asset.asset_id if self.scripted else self.item.node_id,
            asset_id=self.asset.asset_id,
            location=(x, y, z),
            rotation=(0.0, 0.0, round(self.item.yaw, 2)),
            fixed=True,
        )


def _box(location: Vec3, yaw: float, size: Vec3) -> Box:
    return Box(*location, *size, math.radians(yaw))


def _size_of_asset(asset: Asset) -> Vec3:
    if asset.canonical is not None:
        return asset.canonical.dimensions
    prop = prop_of(asset)
    return prop_size(prop, {}) if prop is not None else (0.6, 0.6, 0.8)


def _settle_on_new_tops(standing: list[_Standing]) -> None:
    """Move what stands on a table or a counter to the height of the thing that took its place."""
    for base in standing:
        if not base.scripted:
            continue
        old = prop_size(base.item.prop, base.item.params)
        top = base.item.location[2] + old[2]
        for item in standing:
            x, y, z = item.location
            if item is not base and abs(z - top) < 0.12 and _over(base, (x, y), old):
                item.location = (x, y, base.location[2] + base.size[2])


def _draw_up_seats(standing: list[_Standing]) -> None:
    """Keep the seats around a table at its edge when a larger or smaller one took its place."""
    for base in standing:
        if not base.scripted:
            continue
        old = _box(base.item.location, base.item.yaw, prop_size(base.item.prop, base.item.params))
        for seat in standing:
            x, y, z = seat.item.location
            away = math.hypot(x - old.x, y - old.y)
            if seat is base or seat.scripted or not _is_seat(seat.item.prop) or not 0.1 < away < old.radius + 0.6:
                continue
            axis = ((x - old.x) / away, (y - old.y) / away)
            step = base.box.reach(axis) - old.reach(axis)
            seat.location = (x + axis[0] * step, y + axis[1] * step, z)


def _is_seat(prop: str) -> bool:
    return prop in PROPS and PROPS[prop].seats > 0


def _over(base: _Standing, point: Vec2, size: Vec3) -> bool:
    box = _box(base.item.location, base.item.yaw, size)
    across, along = box.to_local(*point)
    return abs(across) < size[0] / 2 and abs(along) < size[1] / 2


def _without_clutter(standing: list[_Standing], people: int) -> tuple[list[_Standing], list[str]]:
    """Keep the script's things and the required furniture; keep dressing only where it stands free of them."""
    ranked = sorted(standing, key=lambda item: (not item.scripted, not item.item.required))
    clear = _CLEAR + _CLEAR_PER_PERSON * max(0, people - 4)
    stage = Box(0.0, 0.0, 0.0, 2 * clear, 2 * clear, 2.0)
    kept: list[_Standing] = []
    gone: set[str] = set()
    for item in ranked:
        optional = not item.scripted and not item.item.required
        if optional and item.in_the_way:
            others = [other.box for other in kept if other.in_the_way and other.scripted]
            crowds = any(penetration(item.box, other, 0.02)[0] > item.tolerance for other in others)
            if crowds or (item.location[2] < 0.05 and penetration(item.box, stage)[0] > _TOUCH):
                gone.add(item.item.node_id)
                continue
        kept.append(item)
    floating = [item for item in kept if _lost_its_support(item, standing, gone)]
    gone |= {item.item.node_id for item in floating}
    order = {item.item.node_id: index for index, item in enumerate(standing)}
    kept = sorted((item for item in kept if item.item.node_id not in gone), key=lambda item: order[item.item.node_id])
    return kept, sorted(gone, key=lambda node_id: order[node_id])


def _lost_its_support(item: _Standing, standing: list[_Standing], gone: set[str]) -> bool:
    """Return whether a small thing stood on something that was left out."""
    x, y, z = item.item.location
    return any(
        base.item.node_id in gone
        and abs(z - base.item.location[2] - prop_size(base.item.prop, base.item.params)[2]) < 0.12
        and _over(base, (x, y), prop_size(base.item.prop, base.item.params))
        for base in standing
        if base is not item
    )
