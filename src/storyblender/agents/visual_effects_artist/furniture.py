"""Furnishings on their way into a dressed set: their assets, sizes and places, and what is left out."""

from __future__ import annotations

import math
from dataclasses import dataclass

from storyblender.catalog.footprints import stage_box
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import prop_of
from storyblender.catalog.set_plan import Furnishing, SetPlan
from storyblender.geometry.boxes import Box, penetration
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.base import Vec2, Vec3, content_hash
from storyblender.memory.scene_context import LayoutObject

_MAX_OVERLAP = 0.03
"""Metres that two props may overlap before one of them is left out."""
TUCKED_OVERLAP = 0.3
"""The same for a seat, which goes under its table."""
_FREE_WIDTH_PER_PERSON = 0.15
"""Metres by which each further person widens the square in the middle that is free of dressing."""


def dressing_asset(prop: str, params: dict[str, float | str | bool]) -> Asset:
    """Return the asset of a prop of the kit; the same prop and parameters are the same asset in all scenes.

    Args:
        prop: Catalog key.
        params: Parameters of the prop; empty for its usual ones.
    """
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
        kind=prop,
        origin="dressing",
        canonical=canonical,
    )


def prop_size(prop: str, params: dict[str, float | str | bool]) -> Vec3:
    """Return the width, depth and height of a prop in metres.

    Args:
        prop: Catalog key; a prop that the catalog lacks is 0.6 x 0.6 x 0.8 m.
        params: Parameters of the prop; its ``width``, ``depth`` and ``height`` go before the usual ones.
    """
    entry = PROPS.get(prop)
    usual = entry.size if entry is not None else (0.6, 0.6, 0.8)
    width, depth, height = (
        float(params.get(name, size)) for name, size in zip(("width", "depth", "height"), usual, strict=True)
    )
    return (width, depth, height)


@dataclass
class PlacedFurnishing:
    """A furnishing of the plan and the asset in its place.

    Attributes:
        item: The furnishing.
        asset: The kit's prop, or a thing of the script that replaces it.
        size: Width, depth and height in metres.
        location: Bottom centre, world metres.
    """

    item: Furnishing
    asset: Asset
    size: Vec3
    location: Vec3

    @classmethod
    def of(cls, item: Furnishing, taken_by: Asset | None) -> PlacedFurnishing:
        """Return a furnishing as planned, or ``taken_by``, a thing of the script, in its place if it is not None."""
        if taken_by is None:
            asset = dressing_asset(item.prop, item.params)
            return cls(item, asset, prop_size(item.prop, item.params), item.location)
        planned, size = prop_size(item.prop, item.params), size_of_asset(taken_by)
        turn, deeper = math.radians(item.yaw), (size[1] - planned[1]) / 2
        hung = PROPS[item.prop].placement == "ceiling" if item.prop in PROPS else False
        rise = planned[2] - size[2] if hung else 0.0
        x, y, z = item.location
        # moved along its depth, so that its back stays at the wall
        return cls(item, taken_by, size, (x + deeper * math.sin(turn), y - deeper * math.cos(turn), z + rise))

    @property
    def scripted(self) -> bool:
        """Whether it is a thing of the script."""
        return self.asset.origin != "dressing"

    @property
    def box(self) -> Box:
        """Its box in the set."""
        return box_at(self.location, self.item.yaw, self.size)

    @property
    def tolerance(self) -> float:
        """Metres it may overlap another footprint; more for a seat, which goes under its table."""
        return TUCKED_OVERLAP if _is_seat(self.item.prop) else _MAX_OVERLAP

    @property
    def takes_floor(self) -> bool:
        """Whether it takes room on the floor: not a rug, not a thing that hangs."""
        return self.location[2] < 1.6 and self.size[2] > 0.05

    def layout_object(self) -> LayoutObject:
        """Return it as the graph stores it."""
        x, y, z = (round(value, 3) for value in self.location)
        return LayoutObject(
            node_id=self.asset.asset_id if self.scripted else self.item.node_id,
            asset_id=self.asset.asset_id,
            location=(x, y, z),
            rotation=(0.0, 0.0, round(self.item.yaw, 2)),
            fixed=True,
        )


def box_at(location: Vec3, yaw: float, size: Vec3) -> Box:
    """Return the box of a thing in the set.

    Args:
        location: Bottom centre, metres in the set.
        yaw: Degrees, counter-clockwise; 0 faces -Y.
        size: Width, depth and height in metres.
    """
    return Box(*location, *size, math.radians(yaw))


def size_of_asset(asset: Asset) -> Vec3:
    """Return the width, depth and height of an asset in metres, or what it probably will have."""
    return asset.canonical.dimensions if asset.canonical is not None else prop_size(prop_of(asset), {})


def raise_to_new_tops(standing: list[PlacedFurnishing]) -> None:
    """Move things on a table or a counter to the height of the thing that replaced it."""
    for base in standing:
        if not base.scripted:
            continue
        old = prop_size(base.item.prop, base.item.params)
        top = base.item.location[2] + old[2]
        for item in standing:
            x, y, z = item.location
            if item is not base and abs(z - top) < 0.12 and _is_above(base, (x, y), old):
                item.location = (x, y, base.location[2] + base.size[2])


def draw_up_seats(standing: list[PlacedFurnishing]) -> None:
    """Keep the seats around a table at its edge if a larger or smaller one replaced it."""
    for base in standing:
        if not base.scripted:
            continue
        old = box_at(base.item.location, base.item.yaw, prop_size(base.item.prop, base.item.params))
        for seat in standing:
            x, y, z = seat.item.location
            away = math.hypot(x - old.x, y - old.y)
            if seat is base or seat.scripted or not _is_seat(seat.item.prop) or not 0.1 < away < old.radius + 0.6:
                continue
            axis = ((x - old.x) / away, (y - old.y) / away)
            step = base.box.reach(axis) - old.reach(axis)
            seat.location = (x + axis[0] * step, y + axis[1] * step, z)


def _is_seat(prop: str) -> bool:
    """Return whether a prop (catalog key) has seats."""
    return prop in PROPS and PROPS[prop].seats > 0


def _is_above(base: PlacedFurnishing, point: Vec2, size: Vec3) -> bool:
    """Return whether a floor point is above the planned footprint of a furnishing."""
    box = box_at(base.item.location, base.item.yaw, size)
    across, along = box.to_local(*point)
    return abs(across) < size[0] / 2 and abs(along) < size[1] / 2


def drop_clutter(
    standing: list[PlacedFurnishing], plan: SetPlan, people: int
) -> tuple[list[PlacedFurnishing], list[str]]:
    """Return the furnishings without the optional ones that stand in the script's things or in people's way.

    Args:
        standing: All furnishings of the set.
        plan: The set.
        people: Number of people on stage at once.

    Returns:
        The furnishings that stay, and the node_ids of those left out.
    """
    ranked = sorted(standing, key=lambda item: (not item.scripted, not item.item.required))
    stage = stage_box(plan, _FREE_WIDTH_PER_PERSON * max(0, people - 4))
    kept: list[PlacedFurnishing] = []
    gone: set[str] = set()
    for item in ranked:
        optional = not item.scripted and not item.item.required
        if optional and item.takes_floor:
            others = [other.box for other in kept if other.takes_floor and other.scripted]
            crowds = any(penetration(item.box, other, 0.02)[0] > item.tolerance for other in others)
            if crowds or (item.location[2] < 0.05 and penetration(item.box, stage)[0] > _MAX_OVERLAP):
                gone.add(item.item.node_id)
                continue
        kept.append(item)
    floating = [item for item in kept if has_lost_support(item, standing, gone)]
    gone |= {item.item.node_id for item in floating}
    order = {item.item.node_id: index for index, item in enumerate(standing)}
    kept = sorted((item for item in kept if item.item.node_id not in gone), key=lambda item: order[item.item.node_id])
    return kept, sorted(gone, key=lambda node_id: order[node_id])


def has_lost_support(item: PlacedFurnishing, standing: list[PlacedFurnishing], gone: set[str]) -> bool:
    """Return whether a small thing stood, as planned, on something that was left out.

    Args:
        item: The small thing.
        standing: All furnishings of the set.
        gone: Node ids of the furnishings left out.
    """
    x, y, z = item.item.location
    return any(
        base.item.node_id in gone
        and abs(z - base.item.location[2] - prop_size(base.item.prop, base.item.params)[2]) < 0.12
        and _is_above(base, (x, y), prop_size(base.item.prop, base.item.params))
        for base in standing
        if base is not item
    )
