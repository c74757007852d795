"""Another picture of the film: what it sets anew, what stays, and that a person's choice outlives the settings."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from tests.home import SCRIPT, SETTINGS

from storyblender.edits.dispatcher import Applied
from storyblender.edits.words import edits_of, format_edit
from storyblender.errors import InputError, StaleEdit
from storyblender.memory.edits import EDITS
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.picture_format import ASPECTS, SENSORS, FormatDecision
from storyblender.memory.shot_context import ShotContext
from storyblender.session import Session
from storyblender.settings import Settings
from storyblender.studio import Studio

SHOT = "SC010_SH010"
WIDE = {"kind": "format", "decision": {"aspect": 2.39, "sensor_width": 24.89}}
PLACED = {"start": {"location": [0, -3, 1.6], "target": [0, 0, 1.4]}}


def apply(session: Session, *edits: dict[str, Any], revision: str | None = None) -> Applied:
    return session.apply(edits_of(list(edits)), revision)


def poses(graph: ContinuityMemoryGraph) -> list[object]:
    return [shot.camera and (shot.camera.poses, shot.camera.sensor_width) for shot in graph.shots]


def first(graph: ContinuityMemoryGraph) -> ShotContext:
    return graph.shot(1, 1)


def test_it_is_data_and_one_undo_to_the_byte(session: Session) -> None:
    [typed] = edits_of([WIDE])
    assert EDITS.validate_json(EDITS.dump_json((typed,))) == (typed,)
    before = session.graph.model_dump_json()
    assert "format_decision" not in before, "a project in which nobody decided it is written as ever"
    applied = apply(session, WIDE)
    assert applied.words == "film: aspect 2.39:1, sensor Super 35 (24.89 mm)"
    assert len(applied.stale) == len(session.graph.cut), "every frame shows something else"
    session.undo()
    assert session.graph.model_dump_json() == before
    session.redo()
    assert session.graph.format.aspect == 2.39


def test_cameras_are_set_as_if_the_film_had_been_made_so(session: Session, tmp_path: Path) -> None:
    before = poses(session.graph)
    session.draw(apply(session, WIDE))
    (tmp_path / "new.fountain").write_text(SCRIPT)
    asked = SETTINGS.model_copy(update={"aspect": 2.39, "sensor_width": 24.89})
    new = Studio(asked).make(tmp_path / "new.fountain", tmp_path / "new").graph
    assert session.graph.format == new.format
    assert poses(session.graph) == poses(new) != before


def test_the_same_picture_again_draws_nothing(session: Session) -> None:
    now = session.graph.format
    same = {"kind": "format", "decision": {"aspect": now.aspect, "sensor_width": now.sensor_width}}
    before = session.graph.shots
    assert apply(session, same).stale == () and session.graph.shots == before


def test_a_locked_camera_stays_to_the_byte_and_a_person_is_told(session: Session) -> None:
    apply(session, {"kind": "lock", "target": SHOT, "parts": ["camera"]})
    before = first(session.graph)
    applied = apply(session, WIDE)
    assert [warning for warning in applied.warnings if SHOT in warning and "locked" in warning]
    session.draw(applied)
    assert first(session.graph).camera == before.camera and first(session.graph).lights == before.lights
    assert {shot.camera.sensor_width for shot in session.graph.shots[1:] if shot.camera} == {24.89}


def test_an_approved_shot_keeps_its_camera_and_is_told_once(session: Session) -> None:
    session.render([SHOT])
    apply(session, {"kind": "approve", "shot": SHOT})
    before = first(session.graph)
    applied = apply(session, WIDE)
    assert [warning for warning in applied.warnings if SHOT in warning] == [
        f"{SHOT} was approved and may look otherwise now"
    ]
    assert first(session.graph) == before


def test_a_camera_placed_by_hand_stands_where_it_was_placed(session: Session) -> None:
    session.draw(apply(session, {"kind": "camera", "shot": SHOT, "decision": {"placed": PLACED, "lens": 40}}))
    before = first(session.graph).camera
    session.draw(apply(session, WIDE))
    after = first(session.graph).camera
    assert before is not None and after is not None
    assert before.poses == after.poses and after.sensor_width == 24.89


def test_other_takes_are_set_for_the_new_picture_when_they_are_chosen(session: Session) -> None:
    session.draw(apply(session, {"kind": "take", "shot": SHOT}))
    session.draw(apply(session, WIDE))
    assert [take.camera for take in first(session.graph).takes] == [None]
    session.draw(apply(session, {"kind": "take", "shot": SHOT, "action": "choose", "number": 1}))
    camera = first(session.graph).camera
    assert camera is not None and camera.sensor_width == 24.89


@pytest.mark.parametrize("words", [SCRIPT, SCRIPT + "\nTOM enters.\n"], ids=["the same script", "a changed script"])
def test_it_outlives_another_reading_of_the_script(words: str, folder: Path) -> None:
    script = folder.parent / "home.fountain"
    with Studio(SETTINGS).open(folder) as session:
        session.draw(apply(session, WIDE))
        before = poses(session.graph)
    script.write_text(words)
    graph = Studio(SETTINGS).make(script, folder).graph
    assert (graph.format.aspect, graph.format.sensor_width) == (2.39, 24.89)
    assert words != SCRIPT or poses(graph) == before
    assert graph.format_decision == FormatDecision(aspect=2.39, sensor_width=24.89)


@pytest.mark.parametrize("words", [SCRIPT, SCRIPT + "\nTOM enters.\n"], ids=["the same script", "a changed script"])
def test_a_later_word_on_the_command_line_wins(words: str, folder: Path) -> None:
    script = folder.parent / "home.fountain"
    with Studio(SETTINGS).open(folder) as session:
        session.draw(apply(session, WIDE))
    script.write_text(words)
    said = SETTINGS.model_dump(include={"width", "look", "animatic", "jobs"})
    graph = Studio(Settings.load(script, folder, **said, aspect="16:9")).make(script, folder).graph
    assert graph.format.aspect == pytest.approx(16 / 9), "the very one that it was made with, said again"
    assert graph.format_decision == FormatDecision(sensor_width=24.89), "of the sensor nothing was said"
    assert {shot.camera.sensor_width for shot in graph.shots if shot.camera} == {24.89}
    unedited = Studio(SETTINGS.model_copy(update={"sensor_width": 24.89})).make(script, folder.parent / "other").graph
    assert poses(graph) == poses(unedited)


def test_a_decision_goes_on_from_the_one_before(session: Session) -> None:
    apply(session, {"kind": "format", "decision": {"aspect": "4:3"}})
    apply(session, {"kind": "format", "decision": {"sensor_width": "Super 16"}})
    assert session.graph.format_decision == FormatDecision(aspect=4 / 3, sensor_width=SENSORS["Super 16"])


@pytest.mark.parametrize(
    ("decision", "said"),
    [
        ({}, "nothing is decided about the picture"),
        ({"aspect": 0.1}, "greater than or equal to 0.4"),
        ({"aspect": "wide"}, "valid number"),
        ({"sensor_width": 100}, "less than or equal to 70"),
        ({"sensor_width": "IMAX"}, "valid number"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(decision: dict[str, Any], said: str, session: Session) -> None:
    before = session.graph
    with pytest.raises(InputError, match=said):
        apply(session, {"kind": "format", "decision": decision})
    assert session.graph == before


def test_a_picture_that_would_be_far_too_high_is_refused_whichever_comes_last(folder: Path) -> None:
    script, huge = folder.parent / "home.fountain", SETTINGS.model_copy(update={"width": 7680})
    with Studio(SETTINGS).open(folder) as session:
        apply(session, {"kind": "format", "decision": {"aspect": "9:16"}})
        before = session.graph
    with pytest.raises(InputError, match="7680 wide would be 13652 high"):
        Studio(huge).plan(script, folder)
    with Studio(SETTINGS).open(folder) as session:
        assert session.graph == before


def test_two_people_who_change_the_picture_are_told(session: Session) -> None:
    revision = session.revision
    apply(session, WIDE)
    with pytest.raises(StaleEdit):
        apply(session, {"kind": "format", "decision": {"aspect": 1.85}}, revision=revision)


def test_a_shot_is_not_approved_in_the_step_that_draws_it_anew(session: Session) -> None:
    session.draw(apply(session, {"kind": "camera", "shot": SHOT, "decision": {"size": "CU"}}))
    with pytest.raises(InputError, match="the same step changes it"):
        apply(session, {"kind": "approve", "shot": SHOT}, WIDE)


def test_people_may_call_it_by_name() -> None:
    for name, aspect in ASPECTS.items():
        assert format_edit(name, None) == edits_of([{"kind": "format", "decision": {"aspect": aspect}}])[0]
        assert FormatDecision(aspect=aspect).words == f"aspect {name}"
    for name, width in SENSORS.items():
        assert format_edit(None, name.lower()) == edits_of([{"kind": "format", "decision": {"sensor_width": width}}])[0]
        assert FormatDecision(sensor_width=width).words.startswith(f"sensor {name}")
