"""Places the parts of vehicles: each is on its vehicle, wherever that was placed."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence

from storyblender.catalog.parts import part_box
from storyblender.catalog.props.prop_families import family_of
from storyblender.catalog.props.prop_names import prop_of
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.scene_context import Layout, LayoutObject

_CARS = family_of("car")


def with_fitted_parts(layout: Layout, assets: Sequence[Asset], present: Collection[str]) -> Layout:
    """Return a layout with the parts of vehicles on them; a part without a vehicle in the scene is left out.

    Args:
        layout: With everything else.
        assets: Of the story, built.
        present: Asset ids of the scene.
    """
    by_id = {asset.asset_id: asset for asset in assets}
    parts = [asset for asset in assets if asset.fitted_part and asset.asset_id in present]
    cars = [item for item in layout.objects if item.asset_id in by_id and prop_of(by_id[item.asset_id]) in _CARS]
    kept = [item for item in layout.objects if item.asset_id not in {asset.asset_id for asset in parts}]
    for asset in parts:
        there = (item for item in layout.objects if item.asset_id == asset.part_of)
        item = next(there, cars[0] if cars and asset.part_of is None else None)
        if item is not None and by_id[item.asset_id].canonical is not None:
            kept.append(_placed(asset, item, by_id[item.asset_id]))
    return layout.model_copy(update={"objects": tuple(kept)})


def _placed(part: Asset, item: LayoutObject, vehicle: Asset) -> LayoutObject:
    """Return a part where it is on a placed vehicle."""
    made = vehicle.canonical
    assert made is not None
    box = part_box(part.fitted_part, made.dimensions, made.anchors)
    cos, sin = math.cos(math.radians(item.rotation[2])), math.sin(math.radians(item.rotation[2]))
    x, y, z = item.location
    at = (round(x + cos * box.x - sin * box.y, 4), round(y + sin * box.x + cos * box.y, 4), round(z + box.z, 4))
    return LayoutObject(
        node_id=part.asset_id, asset_id=part.asset_id, location=at, rotation=item.rotation,
        anchor_asset_id=item.node_id, fixed=True,
    )  # fmt: skip
