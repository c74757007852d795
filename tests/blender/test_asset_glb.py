"""One asset as glTF and as a picture: its size in metres, on the ground, and the coat that a person put on it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from tests.blender.test_moment_glb import content

from storyblender.blender.session import BlenderSession
from storyblender.catalog.recipe import Recipe
from storyblender.memory.asset_sheet import Asset, CanonicalAsset, CharacterLook, Garment, LookDecision
from storyblender.memory.jobs import AssetJob

pytestmark = pytest.mark.blender

TABLE = Asset(
    asset_id="table",
    asset_type="object",
    description="A table.",
    canonical=Recipe(source="catalog", key="dining_table", score=10.0).canonical(),
)
TOM = Asset(
    asset_id="tom",
    asset_type="character",
    description="A man.",
    look=CharacterLook(gender="male", age=40),
    canonical=CanonicalAsset(source="person", key="person", dimensions=(0.5, 0.4, 1.7), digest=""),
)
RED = LookDecision(garments=(Garment(key="shoes"), Garment(key="shirt"), Garment(key="coat", color=(0.7, 0.0, 0.0))))


def extent(path: Path) -> np.ndarray:
    """Return the low and the high corner of all that is in a .glb, metres, Y up."""
    told = content(path)
    nodes = [node for node in told["nodes"] if "mesh" in node]
    corners = []
    for node in nodes:
        for part in told["meshes"][node["mesh"]]["primitives"]:
            ends = told["accessors"][part["attributes"]["POSITION"]]
            corners += [np.add(ends[end], node.get("translation", [0, 0, 0])) for end in ("min", "max")]
    return np.array([np.min(corners, axis=0), np.max(corners, axis=0)])


def test_a_thing_has_its_size_and_stands_on_the_ground(tmp_path: Path) -> None:
    session = BlenderSession(tmp_path)
    measure = session.build_asset(AssetJob(asset=TABLE))
    session.write_asset(AssetJob(asset=TABLE), "build/cast/table.glb")
    low, high = extent(tmp_path / "build/cast/table.glb")
    assert low[1] == pytest.approx(0, abs=1e-3)
    assert (high - low)[[0, 2, 1]] == pytest.approx(measure.dimensions, abs=2e-3)


def test_a_coat_that_was_put_on_is_seen_and_the_person_is_as_tall(tmp_path: Path) -> None:
    session = BlenderSession(tmp_path)
    seen = {}
    for name, asset in (("plain", TOM), ("red", TOM.model_copy(update={"look_decision": RED}))):
        job = AssetJob(asset=asset)
        session.portrait(job, f"build/cast/{name}.png")
        session.write_asset(job, f"build/cast/{name}.glb")
        picture = np.asarray(Image.open(tmp_path / f"build/cast/{name}.png").convert("RGB"), float)
        seen[name] = int(((picture[..., 0] - picture[..., 2]) > 60).sum())
        low, high = extent(tmp_path / f"build/cast/{name}.glb")
        height = session.build_asset(job).dimensions[2]
        assert high[1] - low[1] == pytest.approx(height, abs=0.12), "hair and soles add a little"
        assert high[0] - low[0] < 0.9, "their arms hang"
    assert seen["red"] > seen["plain"] + 2000
