"""A thing that changes in a scene is seen in each state from the deed on that brings it there, and never in two."""

from __future__ import annotations

from collections.abc import Mapping

import bpy
import pytest

from storyblender.blender.asset_store import AssetStore
from storyblender.blender.props.build import build_prop
from storyblender.blender.state_parts import StateParts
from storyblender.blender.tags import Surface, tag
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.jobs import AssetInState, PlayedCue, SceneJob
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.memory.shot_context import AssetModification, CameraInstruction, Cue, ShotContext


class Meshes(AssetStore):
    """Builds what it is asked for, without files."""

    def __init__(self) -> None:
        pass

    def append_mesh(self, asset: Asset) -> bpy.types.Mesh:
        assert asset.canonical is not None
        return build_prop(asset.canonical.key, asset.canonical.params).mesh


def _chest(**params: bool) -> Asset:
    canonical = CanonicalAsset(source="catalog", key="chest", params=params, dimensions=(1, 0.5, 0.5), digest="d")
    return Asset(asset_id="chest", asset_type="object", description="chest", canonical=canonical)


def _shot(number: int, state: str = "", cues: tuple[Cue, ...] = ()) -> ShotContext:
    changes = (AssetModification(asset_id="chest", modification_type="transform", state=state),) if state else ()
    return ShotContext(
        scene_id=1, shot_id=number, duration=48, camera_instruction=CameraInstruction(), cues=cues,
        asset_modifications=changes,
    )  # fmt: skip


@pytest.fixture
def thing() -> bpy.types.Object:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    obj = bpy.data.objects.new("SC010.chest", build_prop("chest").mesh)
    bpy.context.scene.collection.objects.link(obj)
    return tag(obj, kind="prop", node_id="chest", asset_id="chest", surface=Surface.PROP)


def _seen(shown: list[tuple[int, bool]], frame: int) -> bool:
    return [seen for start, seen in shown if start <= frame][-1]


@pytest.mark.parametrize("added", [False, True])
def test_it_changes_in_the_middle_of_the_deed_and_back(thing: bpy.types.Object, added: bool) -> None:
    opens = _shot(2, "open", (Cue(asset_id="ann", clip="open", start=4, prop_id="chest"),))
    states = (AssetInState(condition=("open",), asset=_chest(open=True), added=added),)
    job = SceneJob(
        scene=SceneContext(scene_id=1, setup=SceneSetup()), shots=(_shot(1), opens, _shot(3), _shot(4, "closed")),
        assets=(_chest(),), in_states=states,
    )  # fmt: skip
    parts = StateParts(job, Meshes(), {"chest": [thing]})
    timing = [PlayedCue(shot_id=2, asset_id="ann", clip="open", start=4, began=10, over=30)]
    starts: Mapping[int, bool] = {1: True, 49: True, 97: True, 145: True}
    (main, shut), (part, opened) = parts.visibility("chest", starts, timing)
    assert main is thing and part.parent is thing and part["node_id"] == "chest"
    for frame in range(1, 192, 6):
        is_open = 49 + 20 <= frame < 145
        assert _seen(opened, frame) == is_open
        assert _seen(shut, frame) == (added or not is_open)


def test_what_is_gone_is_seen_no_more_and_what_an_earlier_scene_left_open_is_open_from_the_first_frame(
    thing: bpy.types.Object,
) -> None:
    setup = SceneSetup(found={"chest": ("open",)})
    states = (AssetInState(condition=("open",), asset=_chest(open=True)),)
    job = SceneJob(
        scene=SceneContext(scene_id=1, setup=setup), shots=(_shot(1), _shot(2, "gone")), assets=(_chest(),),
        in_states=states,
    )  # fmt: skip
    parts = StateParts(job, Meshes(), {"chest": [thing]})
    (_, shut), (_, opened) = parts.visibility("chest", {1: True, 49: True}, [])
    assert _seen(opened, 1) and not _seen(shut, 1)
    assert not _seen(opened, 60) and not _seen(shut, 60)
