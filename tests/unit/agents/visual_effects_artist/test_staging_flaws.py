"""What is not staged as it was read is a flaw on its shot."""

from __future__ import annotations

from storyblender.agents.visual_effects_artist.staging_flaws import staging_flaws
from storyblender.deliver.checklist import checklist
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline, ShotOutline
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.memory.shot_context import (
    Blocking,
    CameraInstruction,
    CharacterAction,
    Cue,
    Flaw,
    Mark,
    PropState,
    ShotContext,
)

KNOCK = CharacterAction(asset_id="ann", action_description="Ann throws the vase.", motion="throw", prop_id="vase")
THROWN = Cue(asset_id="ann", clip="throw", start=4, prop_id="vase")
SHOT = ShotContext(
    scene_id=1, shot_id=1, on_stage=("ann",), character_actions=(KNOCK,), camera_instruction=CameraInstruction()
)


def vase(score: float | None) -> dict[str, Asset]:
    canonical = CanonicalAsset(source="catalog", key="jug", dimensions=(1, 1, 1), digest="", match_score=score)
    return {"vase": Asset(asset_id="vase", asset_type="object", description="a vase", name="vase", canonical=canonical)}


def kinds(shot: ShotContext, score: float | None = 10.0, left_out: tuple[str, ...] = ()) -> list[str]:
    return [flaw.kind for flaw in staging_flaws(shot, vase(score), left_out)]


def test_a_deed_that_nobody_does_is_told_until_somebody_does_it() -> None:
    assert kinds(SHOT) == ["undone"]
    assert kinds(SHOT.model_copy(update={"cues": (THROWN,)})) == []


def test_a_posture_that_is_taken_already_and_a_way_that_is_walked_are_done() -> None:
    sits = CharacterAction(asset_id="ann", action_description="Ann sits at the table.", motion="sit")
    shot = SHOT.model_copy(update={"character_actions": (sits,)})
    assert kinds(shot) == ["undone"]
    seated = Mark(asset_id="ann", location=(0, 0, 0), yaw=0, posture="sit")
    assert kinds(shot.model_copy(update={"blocking": (Blocking(start=seated, end=seated),)})) == []
    walks = CharacterAction(asset_id="ann", action_description="Ann walks to the door.", motion="walk")
    shot = SHOT.model_copy(update={"character_actions": (walks,)})
    assert kinds(shot) == ["undone"]
    assert kinds(shot.model_copy(update={"cues": (Cue(asset_id="ann", clip="run", start=0),)})) == []


def test_a_thing_without_a_place_is_told_unless_it_is_in_a_hand() -> None:
    done = SHOT.model_copy(update={"cues": (THROWN,)})
    assert kinds(done, left_out=("vase",)) == ["left_out"]
    held = done.model_copy(update={"prop_states": (PropState(asset_id="vase", held_by="ann", hand="R"),)})
    assert kinds(held, left_out=("vase",)) == []
    assert kinds(done, left_out=("lamp",)) == [], "the shot is not about it"


def test_a_stand_in_is_told() -> None:
    assert kinds(SHOT.model_copy(update={"cues": (THROWN,)}), score=3.0) == ["stand_in"]


def test_a_cheat_of_the_animator_stays() -> None:
    cheat = Flaw(kind="cheat", subject="ann", message="ann starts 2.0 m nearer")
    assert kinds(SHOT.model_copy(update={"cues": (THROWN,), "flaws": (cheat,)})) == ["cheat"]


def test_every_flaw_of_a_shot_is_on_the_checklist_in_plain_words() -> None:
    flaws = staging_flaws(SHOT, vase(3.0), ("vase",))
    outline = SceneOutline(scene_id=1, scene_description="", shots=(ShotOutline(shot_id=1),))
    shot = SHOT.model_copy(update={"flaws": flaws})
    scene = SceneContext(scene_id=1, setup=SceneSetup())
    graph = ContinuityMemoryGraph(assets=tuple(vase(3.0).values()), outline=(outline,), scenes=(scene,), shots=(shot,))
    told = [check.says for check in checklist(graph, [], [], "p")]
    assert len(told) == len(flaws) == 3
    assert any("No place was found for the vase" in says for says in told)
    assert any("“Ann throws the vase.”" in says for says in told), "the script's words stay as they are"
