"""The scene of a story's file with its canonical assets, marked for the Asset Browser."""

from __future__ import annotations

import math
from collections.abc import Sequence

import bpy

from storyblender.blender.asset_store import AssetStore
from storyblender.blender.merge import merge_duplicates
from storyblender.blender.painting import paint_objects
from storyblender.blender.tags import tag
from storyblender.blender.tidying import tidy
from storyblender.memory.asset_sheet import Asset, Provenance
from storyblender.memory.paint import Paint

LIBRARY = "00_ASSET_LIBRARY"


def new_file() -> None:
    """Begin an empty file with an empty scene for the assets."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.name = LIBRARY


def add_assets(assets: Sequence[Asset], store: AssetStore, paints: Sequence[Paint] = ()) -> None:
    """Add every canonical asset once, on a grid, each in a collection marked for the Asset Browser.

    Args:
        assets: Of the story; those without a canonical are left out.
        store: Builds or reads their meshes.
        paints: What a person decided about their materials.
    """
    library = bpy.data.scenes[LIBRARY]
    bpy.context.window.scene = library
    columns = max(1, math.ceil(math.sqrt(len(assets))))
    for index, asset in enumerate(assets):
        if asset.canonical is None:
            continue
        collection = bpy.data.collections.new(f"AST_{asset.asset_id}")
        library.collection.children.link(collection)
        place = (2.5 * (index % columns), 2.5 * (index // columns), 0.0)
        for obj in _canonical_objects(asset, store):
            collection.objects.link(obj)
            if obj.parent is None:
                obj.location = place
        collection.asset_mark()
        collection.asset_data.description = asset.description
        _credit(collection.asset_data, asset.canonical.provenance)
        for word in asset.tags:
            collection.asset_data.tags.new(word, skip_if_exists=True)
    paint_objects(library.objects, paints)
    merge_duplicates()
    tidy(library.objects)


def _credit(data: bpy.types.AssetMetaData, provenance: Provenance | None) -> None:
    """Write author, licence and source of an asset into its metadata."""
    if provenance is None:
        data.author = "StoryBlender"
        return
    data.author, data.license, data.copyright = provenance.author, provenance.license, provenance.copyright
    origin = " ".join(part for part in (provenance.file, provenance.url) if part)
    data.description = " - ".join(part for part in (data.description, origin) if part)


def _canonical_objects(asset: Asset, store: AssetStore) -> list[bpy.types.Object]:
    """Return new objects that show an asset."""
    if asset.asset_type == "character":
        member = store.append_person(asset)
        return [member.armature, *member.meshes]
    obj = bpy.data.objects.new(asset.asset_id, store.append_mesh(asset))
    return [tag(obj, kind="prop", node_id=asset.asset_id, asset_id=asset.asset_id)]
