"""What a person decides of a look is so in all scenes that show them, and nowhere else; it goes back byte for byte."""

from __future__ import annotations

from typing import Any

import pytest
from tests.every import every

from storyblender.catalog.garments import GARMENTS
from storyblender.catalog.wardrobe import garment_named, put_on, worn_by
from storyblender.edits.look_words import look_edit
from storyblender.edits.words import edits_of
from storyblender.errors import InputError, Rejected, StaleEdit
from storyblender.memory.asset_sheet import Asset, Garment
from storyblender.memory.base import shot_name
from storyblender.memory.edits import EDITS
from storyblender.session import Session


def apply(session: Session, *edits: dict[str, Any]) -> tuple[str, ...]:
    applied = session.apply(edits_of(list(edits)))
    session.draw(applied)
    return applied.stale


def look(person: str = "tom", **said: Any) -> dict[str, Any]:
    outer = {name: said.pop(name) for name in ("wear", "take_off") if name in said}
    return {"kind": "look", "person": person, "decision": said, **outer}


def tom(session: Session) -> Asset:
    return session.graph.asset("tom")


def keys(asset: Asset) -> list[str]:
    return [each.key for each in worn_by(asset)]


def test_other_clothes_are_worn_wherever_the_person_is_and_no_camera_or_mark_changes(session: Session) -> None:
    before = session.graph
    stale = apply(session, look(wear=[{"key": "coat", "color": [0.6, 0.0, 0.0]}]))
    after = session.graph
    scenes = {scene.scene_id for scene in after.scenes if "tom" in scene.setup.asset_ids}
    assert stale == tuple(shot_name(shot.scene_id, shot.shot_id) for shot in after.shots if shot.scene_id in scenes)
    assert Garment(key="coat", color=(0.6, 0.0, 0.0)) in worn_by(tom(session))
    assert tom(session).canonical != before.asset("tom").canonical, "he is built anew"
    assert (after.scenes, after.shots) == (before.scenes, before.shots)
    assert [each for each in after.assets if each.asset_id != "tom"] == [
        each for each in before.assets if each.asset_id != "tom"
    ]


def test_another_height_stages_the_scenes_anew(session: Session) -> None:
    stale = apply(session, look(stature=1.95))
    asset = tom(session)
    assert asset.dimension is not None and asset.dimension.height == 1.95 and stale
    assert asset.look == session.graph.asset("tom").look and asset.decided_look != asset.look
    assert not any(scene.stale for scene in session.graph.scenes)


def test_what_is_decided_later_lies_over_what_was_decided(session: Session) -> None:
    apply(session, look(hair="bald", age=60.0))
    apply(session, look(hair="bob"))
    decided = tom(session).decided_look
    assert decided is not None and (decided.hair, decided.age) == ("bob", 60.0)


def test_an_edit_made_while_the_person_is_still_being_built_is_no_conflict(session: Session) -> None:
    seen = session.apply(edits_of([look(wear=[{"key": "coat"}])])).version
    session.render()
    session.apply(edits_of([look(wear=[{"key": "coat", "color": [0.6, 0, 0]}])]), seen)
    assert Garment(key="coat", color=(0.6, 0.0, 0.0)) in worn_by(tom(session))
    with pytest.raises(StaleEdit):
        session.apply(edits_of([look(hair="bob")]), seen)


def test_it_goes_back_byte_for_byte_and_is_made_again(session: Session) -> None:
    before = session.graph
    apply(session, look(hair="bob", wear=[{"key": "coat"}]))
    after = session.graph
    session.undo()
    assert session.graph.model_dump_json() == before.model_dump_json()
    session.redo()
    session.render()
    assert session.graph.model_dump_json() == after.model_dump_json()


def test_unlock_gives_the_person_back_to_the_crew(session: Session) -> None:
    before = tom(session)
    apply(session, look(hair="bob", stature=1.9))
    apply(session, {"kind": "unlock", "target": "tom"})
    assert tom(session) == before


def test_a_lock_keeps_a_look(session: Session) -> None:
    apply(session, {"kind": "lock", "target": "tom"})
    with pytest.raises(InputError, match="locked"):
        apply(session, look(hair="bob"))


def test_the_crew_cannot_change_a_look_that_a_person_decided(session: Session) -> None:
    apply(session, look(hair="bob"))
    other = tom(session).model_copy(update={"look_decision": None})
    with session._call() as run, pytest.raises(Rejected, match="decided how tom looks"):
        run.commit("asset_formatter", "tom", other)


@every(
    "wrong",
    [
        (look("nobody", hair="bob"), "no person .nobody"),
        (look(hair="plume"), "no hair"),
        (look(wear=[{"key": "toga_of_gold"}]), "no garment"),
        (look(take_off=["crown"]), "no garment on tom"),
        (look(), "nothing is decided"),
        (look("sofa", hair="bob"), "no person|is a thing"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_in_a_sentence(wrong: tuple[dict[str, Any], str], session: Session) -> None:
    before = session.graph
    with pytest.raises(InputError, match=wrong[1]):
        apply(session, wrong[0])
    assert session.graph == before


@every("key", list(GARMENTS))
def test_of_what_is_worn_at_one_place_only_the_new_is_kept(key: str) -> None:
    outfit = tuple(Garment(key=each) for each in ("socks", "shoes", "shirt", "trousers", "jacket", "coat", "hat"))
    worn = [each.key for each in put_on(outfit, Garment(key=key))]
    assert worn.count(key) == 1 and [GARMENTS[each].layer for each in worn] == sorted(
        GARMENTS[each].layer for each in worn
    )
    assert all(sum(area in GARMENTS[each].covers for each in worn) == 1 for area in ("feet", "head"))


@every("key", list(GARMENTS))
def test_every_garment_is_called_by_its_name_with_a_colour(key: str) -> None:
    plain, red = garment_named(GARMENTS[key].name), garment_named(f"a red {GARMENTS[key].name}")
    assert plain is not None and red is not None
    assert plain.color is None and red.color is not None and plain.key == red.key


def test_words_of_the_command_line_become_the_edit() -> None:
    edit = look_edit("tom", {"hair": "bowl cut", "hair_color": "black", "age": None}, ["red coat"], ["tie"])
    assert EDITS.validate_python([edit.model_dump()]) == (edit,)
    assert edit.model_dump()["decision"]["hair"] == "bowl_cut"
    with pytest.raises(InputError, match="garment"):
        look_edit("tom", {}, ["flying carpet"])
    with pytest.raises(InputError, match="colour"):
        look_edit("tom", {"hair_color": "loud"})
