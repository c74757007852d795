"""The asset list as CSV, one row for each person and thing of the script: what it is made from, where it is seen."""

from __future__ import annotations

import csv
from pathlib import Path

from storyblender.deliver.shot_list import inert
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import scene_name
from storyblender.memory.graph import ContinuityMemoryGraph

ASSETS_FILE = "assets.csv"
COLUMNS: tuple[str, ...] = (
    "asset", "name", "type", "kind", "description", "made_from", "stands_in", "width", "depth", "height", "scenes",
    "image_prompt",
)  # fmt: skip


def listed_assets(graph: ContinuityMemoryGraph) -> list[Asset]:
    """Return the people and things of the script, without what dresses the sets."""
    return [asset for asset in graph.assets if asset.origin != "dressing"]


def write_asset_list(graph: ContinuityMemoryGraph, part: Path) -> None:
    """Write the list. UTF-8 with a byte order mark, so that spreadsheets read names rightly.

    Args:
        graph: The story.
        part: The CSV file.
    """
    with part.open("w", encoding="utf-8-sig", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        for asset in listed_assets(graph):
            made = asset.canonical
            size = made.dimensions if made is not None else ("", "", "")
            scenes = (scene.scene_id for scene in graph.scenes if asset.asset_id in scene.setup.asset_ids)
            row = {
                "asset": asset.asset_id,
                "name": asset.name,
                "type": asset.asset_type,
                "kind": next(iter(asset.tags), ""),
                "description": asset.description,
                "made_from": made.key if made is not None else "",
                "stands_in": "yes" if asset.image_prompt else "",
                **{side: each and f"{each:.2f}" for side, each in zip(("width", "depth", "height"), size, strict=True)},
                "scenes": ", ".join(map(scene_name, scenes)),
                "image_prompt": asset.image_prompt,
            }
            writer.writerow({key: inert(value) for key, value in row.items()})
