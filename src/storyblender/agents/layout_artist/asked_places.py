"""Whether what a person added stands where they wanted it; a crowded set may have no room there."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping

from storyblender.catalog.fixtures import fixtures_called
from storyblender.catalog.props.prop_families import props_named
from storyblender.catalog.props.prop_names import prop_of
from storyblender.catalog.set_plan import SetPlan
from storyblender.geometry.boxes import Box, footprint_gap
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.scene_context import Layout, LayoutObject, SceneSetup

_NEAR = 1.2
"""Metres between two footprints up to which one thing is at the other."""


def places_not_kept(
    setup: SceneSetup, layout: Layout, plan: SetPlan, assets: Mapping[str, Asset], added: Collection[str]
) -> Iterator[str]:
    """Yield a sentence for each thing that was added at a place and stands elsewhere.

    Args:
        setup: Has the places, as relations.
        layout: As it was solved.
        plan: Of the set.
        assets: Assets of the story by id.
        added: Ids of the things that a person added.
    """
    boxes = {item.node_id: _box(item, assets[item.asset_id]) for item in layout.objects if item.asset_id in assets}
    for relation in setup.relations:
        own = [boxes[item.node_id] for item in layout.objects if item.asset_id == relation.asset_id]
        if relation.asset_id not in added or not own:
            continue
        anchor = relation.anchor_asset_id
        kin = {anchor, *props_named(anchor)}
        there = [
            item for item in layout.objects if {item.node_id, item.asset_id} & {anchor} or _prop(item, assets) in kin
        ]
        at = [boxes[item.node_id] for item in there] or [each.box for each in fixtures_called(plan, anchor)]
        if at and min(footprint_gap(box, each)[0] for box in own for each in at) > _NEAR:
            thing, place = relation.asset_id.replace("_", " "), f"{relation.kind} {anchor}".replace("_", " ")
            yield f"there is no room for {thing} {place}: it stands elsewhere"


def _prop(item: LayoutObject, assets: Mapping[str, Asset]) -> str:
    return prop_of(assets[item.asset_id]) if item.asset_id in assets else ""


def _box(item: LayoutObject, asset: Asset) -> Box:
    """Return the extent of a thing in the set."""
    size = asset.canonical.dimensions if asset.canonical is not None else (1.0, 1.0, 1.0)
    return Box(*item.location, *size, math.radians(item.rotation[2]))
