"""V(o_new, S_exist): what may not enter the graph."""

from __future__ import annotations

import pytest

from storyblender.errors import Rejected
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.covers import Covers
from storyblender.memory.gatekeeper import Gatekeeper
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import Item, changes_between, replace
from storyblender.memory.scene_context import Layout, LayoutObject, SceneContext, SceneSetup, SceneSize
from storyblender.memory.shot_context import BodyState, CameraInstruction, CharacterAction, Cue, ShotContext

RICK = Asset(asset_id="rick", asset_type="character", description="")
SCENE = SceneContext(scene_id=1, setup=SceneSetup(asset_ids=("rick",)))
SHOT = ShotContext(scene_id=1, shot_id=1, on_stage=("rick",), camera_instruction=CameraInstruction())
GOOD = ContinuityMemoryGraph(assets=(RICK,), scenes=(SCENE,), shots=(SHOT,))


def admit(*items: Item, existing: ContinuityMemoryGraph = GOOD) -> None:
    graph = replace(existing, *items)
    Gatekeeper(existing).admit(graph, changes_between(existing, graph))


@pytest.mark.parametrize(
    "told",
    [
        {"character_actions": (CharacterAction(asset_id="rick", action_description="", motion="strolls"),)},
        {"states": (BodyState(asset_id="rick", activity="strolls"),)},
        {"cues": (Cue(asset_id="rick", clip="strolls", start=0),)},
    ],
)
def test_a_motion_that_does_not_exist_is_refused(told: dict[str, object]) -> None:
    graph = replace(GOOD, SHOT.model_copy(update=told))
    Gatekeeper(GOOD, ("walk", "strolls")).admit(graph, changes_between(GOOD, graph))
    with pytest.raises(Rejected, match="strolls"):
        Gatekeeper(GOOD, ("walk",)).admit(graph, changes_between(GOOD, graph))


def layout(*objects: LayoutObject) -> SceneContext:
    size = SceneSize(x=3, x_negative=-3, y=3, y_negative=-3)
    return SCENE.model_copy(update={"layout": Layout(scene_size=size, objects=objects)})


def test_a_whole_story_enters() -> None:
    Gatekeeper(ContinuityMemoryGraph()).admit(GOOD, changes_between(ContinuityMemoryGraph(), GOOD))


@pytest.mark.parametrize(
    ("item", "words"),
    [
        (SHOT.model_copy(update={"on_stage": ("ghost",)}), "'ghost'"),
        (SHOT.model_copy(update={"joined": True}), "joined to no shot before it"),
        (SHOT.model_copy(update={"shot_id": 50_015}), "number of a shot of another kind"),
        (
            SHOT.model_copy(update={"shot_id": 50_025, "covers": Covers(start=1)}),
            "a part of a shot that does not exist",
        ),
        (SHOT.model_copy(update={"scene_id": 9}), "does not exist"),
        (SHOT.model_copy(update={"states": (BodyState(asset_id="ghost"),)}), "'ghost'"),
        (SHOT.model_copy(update={"cues": (Cue(asset_id="ghost", clip="walk", start=0),)}), "a cue for 'ghost'"),
        (
            SHOT.model_copy(update={"camera_instruction": CameraInstruction(focus="rick", focus_to="ghost")}),
            "focused on 'ghost'",
        ),
        (SCENE.model_copy(update={"setup": SceneSetup(asset_ids=("ghost",))}), "not on the asset sheet"),
        (SCENE.model_copy(update={"setup": SceneSetup(scenery=("ghost",))}), "not on the asset sheet"),
        (SCENE.model_copy(update={"setup": SceneSetup(reference_scene_id=1)}), "not an earlier one"),
        (layout(LayoutObject(node_id="a", asset_id="ghost", location=(0, 0, 0))), "not on the asset sheet"),
        (
            layout(LayoutObject(node_id="a", asset_id="rick", location=(0, 0, 0), anchor_asset_id="b")),
            "anchored to 'b'",
        ),
        (
            layout(
                LayoutObject(node_id="a", asset_id="rick", location=(0, 0, 0)),
                LayoutObject(node_id="a", asset_id="rick", location=(1, 0, 0)),
            ),
            "exists twice",
        ),
    ],
)
def test_broken_references_are_rejected(item: Item, words: str) -> None:
    with pytest.raises(Rejected, match=words):
        admit(item)


def test_removing_an_asset_that_is_still_used_is_rejected() -> None:
    graph = GOOD.model_copy(update={"assets": ()})
    with pytest.raises(Rejected, match="rick"):
        Gatekeeper(GOOD).admit(graph, changes_between(GOOD, graph))


def test_what_a_person_locked_stays_until_unlocked() -> None:
    locked = replace(GOOD, SHOT.model_copy(update={"locked": ("duration",), "duration": 50}))
    with pytest.raises(Rejected, match="locked"):
        admit(SHOT.model_copy(update={"locked": ("duration",), "duration": 60}), existing=locked)
    admit(SHOT.model_copy(update={"locked": (), "duration": 60}), existing=locked)
