"""The checklist: a director's words, shot by shot, each with its mend, and nothing that only a critic minds."""

from __future__ import annotations

import re

from storyblender.deliver.checklist import Check, checklist
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline, ShotOutline
from storyblender.memory.plain_words import names_of, plain
from storyblender.memory.scene_context import Layout, LayoutObject, SceneContext, SceneSetup, SceneSize
from storyblender.memory.shot_context import CameraInstruction, CameraPose, CameraState, Flag, Flaw, ShotContext

POSE = CameraPose(pivot=(0, 0, 0), rotation=(1, 0, 0, 0), distance=2, lens=35)


def story(*shots: ShotContext) -> ContinuityMemoryGraph:
    return ContinuityMemoryGraph(
        script_name="my film.fountain",
        outline=(
            SceneOutline(
                scene_id=1,
                scene_description="A bar",
                shots=tuple(ShotOutline(shot_id=shot.shot_id) for shot in shots),
            ),
        ),
        assets=(
            Asset(asset_id="agnes", asset_type="character", description="a woman", name="Agnes"),
            Asset(asset_id="set_chair", asset_type="object", description="a chair", name="chair"),
        ),
        scenes=(
            SceneContext(
                scene_id=1,
                setup=SceneSetup(),
                layout=Layout(
                    scene_size=SceneSize(x=3, x_negative=-3, y=3, y_negative=-3),
                    objects=(LayoutObject(node_id="set_chair_2", asset_id="set_chair", location=(0, 0, 0)),),
                ),
            ),
        ),
        shots=shots,
    )


def shot(number: int, *flaws: Flaw, size: str = "MS", flags: tuple[Flag, ...] = ()) -> ShotContext:
    instruction = CameraInstruction.model_validate({"size": size, "kind": "single"})
    camera = CameraState(poses=(POSE,), residual=flaws)
    return ShotContext(scene_id=1, shot_id=number, camera_instruction=instruction, camera=camera, flags=flags)


def flaw(kind: str, weight: float, subject: str = "agnes") -> Flaw:
    return Flaw(kind=kind, subject=subject, weight=weight, message=f"{subject} is {kind}")


def test_what_only_a_critic_minds_is_not_told() -> None:
    small = (flaw("headroom", 2), flaw("placement", 2), flaw("cleared", 1), flaw("face_away", 1.2), flaw("void", 1.6))
    assert (
        checklist(story(shot(1, *small)), [Flaw(kind="unreachable", weight=0.06, message="", shot="x")], [], "f") == []
    )


def test_a_picture_flaw_has_a_name_and_a_command_that_reframes() -> None:
    hidden, away = flaw("hidden", 2.1), flaw("face_away", 2.5)
    told = checklist(
        story(shot(1, flaw("out_of_frame", 5.0)), shot(2, hidden, size="EWS")), [], [], "my film.storyboard"
    )
    command = "storyblender edit 'my film.storyboard' SC010_SH0"
    assert told == [
        Check("SC010_SH010", "Agnes is not in the picture", f"{command}10 --size MWS"),
        Check("SC010_SH020", "Agnes is mostly hidden", f'{command}20 --angle "high angle"'),
    ]
    both = checklist(story(shot(1, hidden, away)), [], [], "f")
    assert [check.says for check in both] == ["Agnes is seen from behind"], "of one person only the worst"
    assert not checklist(story(shot(1, away, size="WS")), [], [], "f"), "in a wide picture a back is no fault"


def test_staging_and_readings_are_told_shot_by_shot_in_order() -> None:
    flag = Flag(topic="pronoun", choice="agnes", reason="“she” may also be Vera")
    late = Flaw(kind="late", subject="agnes", weight=1.0, message="", shot="SC010_SH010")
    lost = Flaw(
        kind="missing", subject="agnes", message="agnes cannot open: set_chair_2 is not on stage", shot=late.shot
    )
    told = checklist(story(shot(1, flaw("inside", 5, "set_chair_2")), shot(2, flags=(flag,))), [lost, late], [], "f")
    assert [(check.shot, check.says) for check in told] == [
        ("SC010_SH010", "Agnes cannot open: the chair is not on stage"),
        ("SC010_SH010", "Agnes does not get there before the cut"),
        ("SC010_SH010", "The camera stands inside the chair"),
        ("SC010_SH020", "Agnes is meant? “she” may also be Vera"),
    ]
    assert all("storyblender " in check.mend for check in told)
    assert not [check for check in told if re.search(r"[a-z]_[a-z0-9]", check.says)], "no codes"


def test_a_word_that_nobody_knew_is_no_matter_once_it_has_a_model() -> None:
    flag = Flag(topic="prop", choice="set_chair", reason="“chair” is not a word the reader knows")
    graph = story(shot(1, flags=(flag,)))
    (told,) = checklist(graph, [], [], "f")
    assert "stand-in" in told.says
    made = CanonicalAsset(source="file", key="meshy/chair/model.glb", dimensions=(1, 1, 1), digest="d")
    agnes, chair = graph.assets
    graph = graph.model_copy(update={"assets": (agnes, chair.model_copy(update={"canonical": made}))})
    assert not checklist(graph, [], [], "f")


def test_the_flaws_of_older_projects_are_sentences_and_still_open() -> None:
    state = CameraState.model_validate({"poses": [POSE.model_dump()], "residual": ["agnes is cut off"]})
    assert state.residual == (Flaw(message="agnes is cut off"),)
    assert plain("agnes stands in set_chair_2, aged 4", names_of(story())) == "Agnes stands in the chair, aged 4"


def test_what_a_frame_does_not_show_of_its_lines_is_told_once() -> None:
    unseen = Flaw(kind="thing_missing", subject="cup", weight=2.0, message="cup is not seen", shot="SC010_SH010")
    [check] = checklist(story(shot(1)), [], [unseen], "f")
    assert check.shot == "SC010_SH010" and "is not seen" in check.says and "--size" in check.mend
