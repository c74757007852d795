"""Materials painted by hand: where they are kept, what they reach, what is refused."""

from __future__ import annotations

from typing import Any

import pytest

from storyblender.edits.words import edits_of, paint_edit
from storyblender.errors import InputError, StaleEdit
from storyblender.memory.base import shot_name
from storyblender.memory.edits import EDITS
from storyblender.memory.paint import Paint, PaintDecision, PaintTarget, paints_in
from storyblender.pipeline.packing import scene_job
from storyblender.session import Session

RED = {"color": [0.5, 0.02, 0.02]}


def apply(session: Session, *edits: dict[str, Any], revision: str | None = None) -> tuple[str, ...]:
    return session.apply(edits_of([{"kind": "paint", **each} for each in edits]), revision).stale


@pytest.mark.parametrize(
    "edit",
    [
        {"thing": "sofa", "look": RED},
        {"material": "wood", "look": RED},
        {"material": "wood", "scene": "SC010", "look": RED},
        {"thing": "sofa", "material": "wood", "look": {"roughness": 0.1, "metallic": 1, "plain": True}},
    ],
)
def test_paint_is_data_and_one_undo(edit: dict[str, Any], session: Session) -> None:
    [typed] = edits_of([{"kind": "paint", **edit}])
    assert EDITS.validate_json(EDITS.dump_json((typed,))) == (typed,)
    before = session.graph
    apply(session, edit)
    assert len(session.graph.paints) == 1
    session.undo()
    assert session.graph == before
    session.redo()
    assert len(session.graph.paints) == 1


def test_only_scenes_that_may_show_it_are_packed_anew(session: Session) -> None:
    before = {scene.scene_id: scene_job(session.graph, scene.scene_id).digest for scene in session.graph.scenes}
    stale = apply(session, {"thing": "sofa", "look": RED})
    shown = {
        each.scene_id
        for each in session.graph.scenes
        if "sofa" in {asset.asset_id for asset in session.graph.assets_of(each.scene_id)}
    }
    now = {scene.scene_id: scene_job(session.graph, scene.scene_id).digest for scene in session.graph.scenes}
    assert shown and {key for key, digest in now.items() if before[key] != digest} == shown
    assert {name.partition("_")[0] for name in stale} == {shot_name(key, 1).partition("_")[0] for key in shown}


def test_a_later_look_lies_over_an_earlier_one_and_comes_off(session: Session) -> None:
    apply(session, {"thing": "sofa", "look": RED}, {"thing": "sofa", "look": {"roughness": 0.2}})
    [paint] = session.graph.paints
    assert paint.look.color == (0.5, 0.02, 0.02) and paint.look.roughness == 0.2
    apply(session, {"thing": "sofa", "look": {"finish": "brass"}})
    assert session.graph.paints[0].look == PaintDecision(finish="brass"), "another finish has a look of its own"
    apply(session, {"thing": "sofa"})
    assert not session.graph.paints


@pytest.mark.parametrize(
    ("edit", "said"),
    [
        ({"thing": "nothing_here", "look": RED}, "there is no person or thing"),
        ({"thing": "sofa"}, "is not painted"),
        ({"thing": "sofa", "look": {"finish": "woood"}}, "did you mean wood"),
        ({"thing": "wall_bakc", "scene": "SC010", "look": RED}, "there is no 'wall_bakc' in SC010"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(edit: dict[str, Any], said: str, session: Session) -> None:
    with pytest.raises(InputError, match=said):
        apply(session, edit)


def test_a_locked_set_keeps_its_materials(session: Session) -> None:
    session.apply(edits_of([{"kind": "lock", "target": "SC010", "parts": ["set"]}]))
    with pytest.raises(InputError, match="the set of SC010 is locked"):
        apply(session, {"material": "wood", "look": RED})
    apply(session, {"thing": "sofa", "look": RED})


def test_two_people_who_paint_the_same_are_told_and_others_are_not(session: Session) -> None:
    revision = session.revision
    apply(session, {"thing": "sofa", "material": "wood", "look": RED})
    apply(session, {"thing": "sofa", "material": "fabric", "look": RED}, revision=revision)
    with pytest.raises(StaleEdit):
        apply(session, {"thing": "sofa", "material": "wood", "look": {"roughness": 0.5}}, revision=revision)


def test_the_narrowest_paint_counts() -> None:
    wide, scene = PaintTarget(material="wood"), PaintTarget(material="wood", scene_id=1)
    asset, node = PaintTarget(asset_id="sofa"), PaintTarget(scene_id=1, node_id="sofa_1")
    assert wide.narrowness < scene.narrowness < asset.narrowness < node.narrowness
    paints = tuple(Paint(target=each, look=PaintDecision(plain=True)) for each in (wide, scene, asset, node))
    assert paints_in(paints, 2, ["chair"]) == paints[:1]


def test_the_command_line_says_colours_as_people_do() -> None:
    edit = paint_edit("sofa", None, None, {"color": "#ff0000"})
    assert edit == edits_of([{"kind": "paint", "thing": "sofa", "look": {"color": [1, 0, 0]}}])[0]
    with pytest.raises(InputError, match="R,G,B"):
        paint_edit("sofa", None, None, {"color": "reddish"})
    with pytest.raises(InputError, match="nothing is decided"):
        paint_edit("sofa", None, None, {})
