"""Geometry from the user's library is what Blender would have built: same hash, same record, no second build."""

from __future__ import annotations

from pathlib import Path

import bpy
import pytest

from storyblender.blender.asset_store import AssetStore
from storyblender.folder import Folder
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.jobs import AssetJob

pytestmark = pytest.mark.blender


def chair(asset_id: str) -> Asset:
    made = CanonicalAsset(source="catalog", key="chair", dimensions=(1, 1, 1), digest="")
    return Asset(asset_id=asset_id, asset_type="object", description="", canonical=made)


def test_a_thing_of_another_story_is_taken_and_not_built(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    library, first, second = SharedLibrary.open(), Folder(tmp_path / "first"), Folder(tmp_path / "second")
    built = AssetStore(first).measure(AssetJob(asset=chair("chair")))
    library.geometry.give([AssetJob(asset=chair("chair"))], first)
    job = AssetJob(asset=chair("seat"))
    taken = library.geometry.take([job], second)
    assert taken[job.digest] == built.model_copy(update={"asset_id": "seat"})
    store = AssetStore(second)
    monkeypatch.setattr(AssetStore, "_build", None)
    assert store.measure(job) == taken[job.digest], "the worker finds the files whole"
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    assert job.asset.canonical is not None
    placed = job.asset.canonical.model_copy(update={"digest": job.digest})
    mesh = store.append_mesh(job.asset.model_copy(update={"canonical": placed}))
    assert (mesh.name, len(mesh.polygons)) == ("seat", built.faces)
