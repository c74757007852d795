"""Things and people placed by hand: they are just there, what rests on them follows, and nothing else changes."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.every import every
from tests.home import SCRIPT, SETTINGS

from storyblender.deliver.panel import panels
from storyblender.edits.effect import name_of
from storyblender.edits.words import edits_of, place_edit
from storyblender.errors import InputError, Rejected, StaleEdit
from storyblender.geometry.camera_path import orbit_of
from storyblender.geometry.framing import Film
from storyblender.geometry.orbit import Orbit, camera_around
from storyblender.memory.edits import EDITS
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.scene_context import Layout, LayoutObject
from storyblender.memory.shot_context import Mark
from storyblender.project import Project
from storyblender.session import Session
from storyblender.studio import Studio
from storyblender.workplace.values import details_of

ROOM, LATER, SHOT, NEXT = "SC010", "SC030", "SC010_SH020", "SC010_SH030"
TOM = {
    "kind": "blocking",
    "shot": SHOT,
    "person": "Tom",
    "marks": {"start": {"location": [1.5, -1.0], "rotation": 200}},
}


def move(thing: str, at: Any = None, turn: float | None = None, scene: str = ROOM, **more: float) -> dict[str, Any]:
    place = {"location": at, "rotation": turn, **more}
    return {"kind": "place", "scene": scene, "thing": thing, "place": {k: v for k, v in place.items() if v is not None}}


def apply(session: Session, *edits: dict[str, Any]) -> tuple[str, ...]:
    applied = session.apply(edits_of(list(edits)))
    session.draw(applied)
    return applied.stale


def layout(graph: ContinuityMemoryGraph, scene: str = ROOM) -> Layout:
    found = graph.scene(int(scene[2:]) // 10).layout
    assert found is not None
    return found


def item(graph: ContinuityMemoryGraph, node_id: str, scene: str = ROOM) -> LayoutObject:
    return next(each for each in layout(graph, scene).objects if each.node_id == node_id)


def mark(graph: ContinuityMemoryGraph, person: str, shot: str, when: str = "start") -> Mark:
    found = graph.shot(int(shot[2:5]) // 10, int(shot[8:]) // 10)
    [own] = [each for each in found.blocking if each.start.asset_id == person]
    return getattr(own, when)


def test_a_thing_is_just_there_with_who_sits_on_it_and_nothing_else_moves(session: Session) -> None:
    before = session.graph
    stale = apply(session, move("sofa", [0.123456789, 1.3], 37.25))
    after, sofa = session.graph, item(session.graph, "sofa")
    assert sofa.location == (0.123456789, 1.3, 0.0) and sofa.rotation == (0.0, 0.0, 37.25)
    assert stale == tuple(f"SC010_SH{10 * shot.shot_id:03d}" for shot in before.shots_of(1))
    moved = {new.node_id for old, new in zip(layout(before).objects, layout(after).objects, strict=True) if old != new}
    assert moved == {"sofa", "anna"}
    assert mark(after, "anna", SHOT).support_id == "sofa" and mark(after, "anna", SHOT).yaw == pytest.approx(
        37.2, abs=0.1
    )
    assert before.scenes[1:] == after.scenes[1:] and before.shots[3:] == after.shots[3:]
    assert not any(each.stale for each in (*after.scenes, *after.shots))
    assert before.scenes[0].environment == after.scenes[0].environment


def test_moved_and_moved_back_the_layout_is_as_it_was(session: Session) -> None:
    before, chance = session.graph, random.Random(15)
    for thing in ("sofa", "table", "set_armchair_1", "set_kept_side_table_4", "letter"):
        was = item(before, thing)
        for _ in range(3):
            there = [round(chance.uniform(-2, 2), 4), round(chance.uniform(-2, 2), 4)]
            session.apply(edits_of([move(thing, there, round(chance.uniform(-180, 180), 2), height=was.location[2])]))
        session.apply(edits_of([move(thing, list(was.location[:2]), was.rotation[2], height=was.location[2])]))
        poses = [
            [(each.node_id, each.location, each.rotation) for each in layout(graph).objects]
            for graph in (before, session.graph)
        ]
        assert poses[0] == poses[1], thing
        for _ in range(4):
            session.undo()
        assert session.graph == before


@every(
    "edit", [move("sofa", [0.5, 1.0]), move("rug", turn=30.0), TOM, {**TOM, "marks": {"end": {"location": [0, -1]}}}]
)
def test_it_is_data_one_step_of_a_batch_and_undone_byte_for_byte(edit: dict[str, Any], made_copy: Session) -> None:
    session = made_copy
    [typed] = edits_of([edit])
    assert EDITS.validate_json(EDITS.dump_json((typed,))) == (typed,)
    before = (session.folder / "graph.json").read_bytes()
    apply(session, edit, {"kind": "note", "shot": SHOT, "text": "here"})
    after = session.graph
    session.undo()
    assert (session.folder / "graph.json").read_bytes() == before
    session.redo()
    assert session.graph == after
    session.undo()


@pytest.fixture
def made_copy(session: Session) -> Session:
    return session


def test_it_stays_in_another_staging_another_set_and_another_script(folder: Path) -> None:
    with Studio(SETTINGS).open(folder) as session:
        apply(session, move("sofa", [0.9, 1.4], 20.0), move("set_armchair_1", [-1.9, 0.2]), TOM)
        decided = session.graph.scene(1).layout_decision
        assert decided is not None and {*decided.things} == {"sofa", "set_armchair_1"}
        for edit in ({"kind": "layout", "scene": ROOM}, {"kind": "set", "scene": ROOM, "decision": {"width": 8}}):
            apply(session, edit)
            assert item(session.graph, "sofa").location == (0.9, 1.4, 0.0), edit
            assert item(session.graph, "set_armchair_1").location[:2] == (-1.9, 0.2), edit
            assert mark(session.graph, "tom", SHOT).location[:2] == (1.5, -1.0), edit
    script = folder.parent / "home.fountain"
    script.write_text(
        SCRIPT.replace("INT. LIVING ROOM - DAY", "EXT. STREET - DAY\n\nA cat sits.\n\nINT. LIVING ROOM - DAY")
    )
    graph = Studio(SETTINGS).make(script, folder).graph
    assert item(graph, "sofa", "SC020").location == (0.9, 1.4, 0.0)
    assert mark(graph, "tom", "SC020_SH020").location[:2] == (1.5, -1.0)


def gesture(graph: ContinuityMemoryGraph, chance: random.Random) -> dict[str, Any]:
    """Return what a hand might do on a stage."""
    scene = chance.choice([ROOM, LATER])
    at, turn = [chance.uniform(-3, 3), chance.uniform(-3, 3)], chance.choice([None, chance.uniform(-200, 200)])
    thing = chance.choice(layout(graph, scene).objects).node_id
    match chance.randrange(4):
        case 0:
            shot = chance.choice(graph.shots_of(int(scene[2:]) // 10))
            marks = {chance.choice(["start", "end"]): {"location": at}}
            return {"kind": "blocking", "shot": f"{scene}_SH{10 * shot.shot_id:03d}", "person": "anna", "marks": marks}
        case 1:
            return {"kind": "place", "scene": scene, "thing": thing, "scale": chance.choice([0.5, 0.8, 1.25, 2])}
        case _:
            return move(thing, at, turn, scene)


def test_whatever_a_hand_does_is_kept_and_undone_byte_for_byte(session: Session) -> None:
    before, chance, done = (session.folder / "graph.json").read_bytes(), random.Random(8), 0
    for _ in range(40):
        try:
            session.apply(edits_of([gesture(session.graph, chance)]))
            done += 1
        except InputError:
            continue  # people are no things, who sits has no mark
        if done in (10, 20):
            session.render()
    session.render()
    for scene in session.graph.scenes:
        for node_id, place in (scene.layout_decision.things if scene.layout_decision else {}).items():
            assert place.location in (None, item(session.graph, node_id, f"SC{10 * scene.scene_id:03d}").location[:2])
    for _ in range(done):
        session.undo()
    assert done > 20 and (session.folder / "graph.json").read_bytes() == before


def test_the_crew_cannot_place_it_elsewhere(session: Session) -> None:
    apply(session, move("sofa", [0.9, 1.4]), TOM)
    scene, shot = session.graph.scene(1), session.graph.shot(1, 2)
    objects = tuple(
        each.model_copy(update={"location": (0, 0, 0)}) if each.node_id == "sofa" else each
        for each in layout(session.graph).objects
    )
    other = scene.model_copy(update={"layout": layout(session.graph).model_copy(update={"objects": objects})})
    folder = session.folder
    session.close()
    with Project(folder) as project:
        for change in (other, shot.model_copy(update={"blocking_decision": None})):
            with pytest.raises(Rejected):
                project.commit(replace(project.graph, change), "spatial_planner", "elsewhere")


def test_cameras_follow_but_for_the_one_that_a_person_placed(session: Session) -> None:
    stands = {"start": {"location": [0.0, -2.3, 1.5], "target": [0.0, 1.5, 1.0]}}
    apply(session, {"kind": "camera", "shot": "SC010_SH010", "decision": {"placed": stands}})
    before = [shot.camera for shot in session.graph.shots_of(1)]
    apply(session, move("sofa", [0.9, 1.2], 40.0))
    after = [shot.camera for shot in session.graph.shots_of(1)]
    assert after[0] == before[0] and after[1:] != before[1:] and None not in after


def test_cameras_stay_where_they_still_work_and_what_changed_is_told(session: Session) -> None:
    before = session.graph
    applied = session.apply(edits_of([move("sofa", [2.4, -1.6], 200.0)]))
    delivery = session.draw(applied)
    assert delivery is not None
    changed = {
        name_of(new)
        for old, new in zip(before.shots, session.graph.shots, strict=True)
        if old.camera is not None and new.camera is not None and old.camera.poses != new.camera.poses
    }
    told = [each for each in delivery.followed if "has another camera" in each]
    assert changed and {each.split()[0] for each in told} == changed
    assert not any(shot.former_camera for shot in session.graph.shots)
    kept = session.graph
    session.draw(session.apply(edits_of([move("sofa", [2.41, -1.6], 200.0)])))
    assert [shot.camera and shot.camera.poses for shot in session.graph.shots] == [
        shot.camera and shot.camera.poses for shot in kept.shots
    ], "a centimetre moves no camera"


def test_people_go_on_from_where_a_mark_was_set(session: Session) -> None:
    before = session.graph
    apply(session, TOM)
    at = {shot: mark(session.graph, "tom", shot) for shot in ("SC010_SH010", SHOT, NEXT)}
    assert at["SC010_SH010"] == mark(before, "tom", "SC010_SH010")
    assert at[SHOT].location == (1.5, -1.0, 0.0) and at[SHOT].yaw == 200.0
    assert at[NEXT].location == (1.5, -1.0, 0.0)
    apply(session, {**TOM, "marks": {"end": {"location": [-1.0, -1.0], "rotation": 10}}})
    assert mark(session.graph, "tom", SHOT) == at[SHOT], "the start is kept"
    assert mark(session.graph, "tom", SHOT, "end").location == (-1.0, -1.0, 0.0)
    assert mark(session.graph, "tom", NEXT).location == (-1.0, -1.0, 0.0)
    assert "walk" in {cue.clip for cue in session.graph.shot(1, 2).cues if cue.asset_id == "tom"}
    apply(session, {"kind": "unlock", "target": SHOT, "parts": ["blocking"]})
    assert mark(session.graph, "tom", SHOT) == mark(before, "tom", SHOT), "the crew has it back"


def test_who_sits_rises_and_goes_to_their_mark(session: Session) -> None:
    apply(session, {"kind": "blocking", "shot": NEXT, "person": "anna", "marks": {"end": {"location": [0.5, -0.5]}}})
    end = mark(session.graph, "anna", NEXT, "end")
    assert end.posture == "stand" and end.location == (0.5, -0.5, 0.0)
    assert {"rise", "walk"} <= {cue.clip for cue in session.graph.shot(1, 3).cues if cue.asset_id == "anna"}


def test_what_it_stands_in_is_told_and_on_the_checklist_and_no_layout_fault(session: Session) -> None:
    at = item(session.graph, "table").location[:2]
    applied = session.apply(edits_of([move("sofa", list(at))]))
    assert any("deep in the table" in said for said in applied.warnings)
    session.draw(applied)
    report = session.check()
    assert any("which a person placed, stands" in finding for finding in report.findings)
    assert not any(row.name == "layout violations" and not row.ok for row in report.rows)
    page = (session.folder / "index.html").read_text(encoding="utf-8")
    assert "SC010 sofa --at X,Y" in page, "the checklist says how to move it"
    near = mark(session.graph, "anna", SHOT).location[:2]
    told = session.apply(edits_of([{**TOM, "marks": {"start": {"location": near}}}])).warnings
    assert any("stands in Anna" in said for said in told)


def test_a_description_of_the_shot_says_what_was_placed(session: Session) -> None:
    session.apply(edits_of([move("sofa", [0.5, 1.25], 30.0), TOM]))
    told = details_of(next(panel for panel in panels(session.graph) if panel.name == SHOT), session.graph)
    assert "marks: Tom starts at 1.5, -1, turned to 200 degrees" in told.decided
    assert "layout: things sofa at 0.5, 1.25, turned to 30 degrees" in told.scene_decided


@every(
    "edit said",
    [
        (move("sofa", [900.0, 0.0]), "too far"),
        (move("sofa", [0.0, 0.0], height=900.0), "too far"),
        (move("sofas", [0.0, 0.0]), "no 'sofas'"),
        (move("picture", [0.0, 0.0]), "of 'picture'"),
        (move("anna", [0.0, 0.0]), "a person"),
        ({**TOM, "person": "anna"}, "does not stand"),
        ({**TOM, "person": "letter"}, "not on stage"),
        ({**TOM, "marks": {"end": {"location": [9e5, 0]}}}, "too far"),
        ({**TOM, "marks": {}}, "mark"),
        (move("sofa"), "place"),
        ({**move("table"), "scale": 45}, "cannot be"),
        ({**move("table"), "scale": 0}, "scale"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(edit: dict[str, Any], said: str, session: Session) -> None:
    before = session.graph
    with pytest.raises(InputError, match=said):
        apply(session, edit)
    assert session.graph == before


def test_what_is_locked_is_refused_and_what_changed_meanwhile(session: Session) -> None:
    seen = session.revision
    apply(session, move("table", [-0.8, 0.9]))
    with pytest.raises(StaleEdit):
        session.apply(edits_of([move("sofa", [0.0, 1.0])]), seen)
    session.apply(edits_of([move("sofa", [0.0, 2.0], scene=LATER)]), seen)
    for lock, edit in (([ROOM, "layout"], move("sofa", [0.0, 1.0])), ([SHOT, "blocking"], TOM)):
        apply(session, {"kind": "lock", "target": lock[0], "parts": [lock[1]]})
        with pytest.raises(InputError, match="locked"):
            apply(session, edit)
        apply(session, {"kind": "unlock", "target": lock[0], "parts": [lock[1]]})


def test_a_locked_shot_refuses_only_what_it_shows_or_uses(session: Session) -> None:
    apply(session, {"kind": "lock", "target": "SC010_SH010", "parts": ["blocking", "camera"]})
    before = session.graph.shot(1, 1)
    with pytest.raises(InputError, match=r"sofa is used in SC010_SH010.*unlock SC010_SH010 first"):
        apply(session, move("sofa", [0.0, 1.0]))
    state = before.camera
    assert state is not None
    eye, pivot = orbit_of(state.poses[0], Film(36.0, 16 / 9)).position, state.poses[0].pivot
    behind, ahead = ([float(eye[i] + way * (pivot[i] - eye[i])) for i in (0, 1)] for way in (-0.5, 0.8))
    with pytest.raises(InputError, match="table is seen in SC010_SH010, or would be there"):
        apply(session, move("table", ahead))
    things = [each.node_id for each in layout(session.graph).objects]
    free = next(name for name in things if _moves(session, name, behind))
    assert free and session.graph.shot(1, 1).camera == state
    apply(session, {"kind": "approve", "shot": "SC010_SH010"})
    with pytest.raises(InputError, match="withdraw the approval of SC010_SH010 first"):
        apply(session, move("sofa", [0.0, 1.0]))


def _moves(session: Session, thing: str, at: list[float]) -> bool:
    """Return whether a thing can be moved there; the locked shot is acted as before then."""
    before = session.graph.shot(1, 1)
    try:
        apply(session, move(thing, at))
    except InputError:
        return False
    after = session.graph.shot(1, 1)
    return (after.blocking, after.cues, after.duration) == (before.blocking, before.cues, before.duration)


def test_a_scaled_thing_keeps_what_is_on_it_and_its_size_in_every_scene_and_staging(session: Session) -> None:
    apply(session, move("letter", [-0.9, 1.2], height=0.75))
    before = session.graph
    apply(session, {"kind": "place", "scene": ROOM, "thing": "table", "scale": 1.25})
    after = session.graph
    for old, new in ((before, after), (after, before)):
        sizes = [graph.asset("table").canonical.dimensions for graph in (old, new)]  # type: ignore[union-attr]
        assert np.allclose(sizes[1], np.multiply(sizes[0], 1.25 if new is after else 0.8))
    for name in (ROOM, LATER):
        assert item(after, "table", name) == item(before, "table", name)
        assert item(after, "letter", name).location[2] == pytest.approx(1.25 * item(before, "letter", name).location[2])
    assert before.scenes[1] == after.scenes[1], "the park has no table"
    apply(session, {"kind": "layout", "scene": ROOM})
    assert session.graph.asset("table") == after.asset("table")


def test_scaled_furniture_is_so_in_its_place_and_no_other_of_its_kind(session: Session) -> None:
    node, other = "set_armchair_1", "set_armchair_2"
    before = session.graph
    apply(session, {**move(node, [-1.8, 0.9]), "scale": 0.5})
    after = session.graph
    for name in (ROOM, LATER):
        small, usual = (after.asset(item(after, each, name).asset_id).canonical for each in (node, other))
        assert small is not None and usual is not None and small.geometry_hash
        assert np.allclose(small.dimensions, np.multiply(usual.dimensions, 0.5), atol=1e-5)
        assert item(after, other, name) == item(before, other, name)
    assert item(after, node).location[:2] == (-1.8, 0.9)
    apply(session, {"kind": "layout", "scene": ROOM})
    assert item(session.graph, node).asset_id == item(after, node).asset_id
    assert item(session.graph, node).location[:2] == (-1.8, 0.9)


def test_furniture_that_is_taken_away_takes_its_place_with_it(session: Session) -> None:
    apply(session, move("set_armchair_1", [-1.9, 0.2]))
    apply(session, {"kind": "asset", "action": "remove", "scene": ROOM, "thing": "set_armchair_1"})
    assert "set_armchair_1" not in {each.node_id for each in layout(session.graph).objects}
    with pytest.raises(InputError, match="no 'set_armchair_1'"):
        apply(session, move("set_armchair_1", [0.0, 0.0]))


def test_the_command_line_says_the_same() -> None:
    assert [place_edit(ROOM, "sofa", ("0.5,1", 30), height=0.2)] == [
        *edits_of([move("sofa", [0.5, 1], 30, height=0.2)])
    ]
    assert place_edit(ROOM, "sofa", (None, None), scale=2) == edits_of([{**move("sofa"), "scale": 2}])[0]
    marks = {"start": {"location": [1, 2], "rotation": 45}, "end": {"location": [-1, 0.5]}}
    [wanted] = edits_of([{"kind": "blocking", "shot": SHOT, "person": "tom", "marks": marks}])
    assert place_edit(SHOT, "tom", ("1,2", 45), ("-1,0.5", None)) == wanted
    for wrong in (
        (SHOT, "tom", ("1,2", None), (None, None), 1.0),
        (ROOM, "sofa", ("1", None)),
        (ROOM, "sofa", (None, None), ("1,1", None)),
    ):
        with pytest.raises(InputError):
            place_edit(*wrong)


@every(
    "place",
    [
        {"location": [0.3, -1.2345678901, 1.5], "target": [0.0, 1.0, 1.25]},
        {"location": [0.3, -1.2, 1.5], "target": [0.3, -1.2, 0.0], "roll": 12.5},
        {
            "location": [0.3, -1.2, 1.5],
            "rotation": camera_around((0, 0, 0), 123.4, 56.7, 1.0, 50.0, roll=-8.9).rotation,
        },
        {"location": [0.3, -1.2, 1.5], "rotation": [1.0, 0.0, 0.0, 0.0]},
    ],
)
def test_a_placed_camera_is_just_there_through_json_and_stagings(place: dict[str, Any], made_copy: Session) -> None:
    session = made_copy
    edit = {"kind": "camera", "shot": SHOT, "decision": {"placed": {"start": place}, "lens": 35}}
    assert EDITS.validate_json(EDITS.dump_json(edits_of([edit]))) == edits_of([edit])
    apply(session, edit)
    apply(session, {"kind": "layout", "scene": ROOM})
    camera = session.graph.shot(1, 2).camera
    assert camera is not None and len(camera.poses) == 1
    [pose] = camera.poses
    there = Orbit(pose.pivot, pose.rotation, pose.distance, pose.lens)
    assert np.allclose(there.position, place["location"], atol=1e-12) and pose.lens == 35
    if "rotation" in place:
        assert np.allclose(pose.rotation, place["rotation"], atol=1e-12)
    else:
        assert pose.pivot == tuple(place["target"])
    session.undo()
    session.undo()


@every(
    "start",
    [
        {"location": [0, 0, 1]},
        {"location": [0, 0, 1], "target": [0, 1, 1], "rotation": [1, 0, 0, 0]},
        {"location": [0, 0, 1], "rotation": [1, 1, 0, 0]},
        {"location": [0, 0, 1], "rotation": [1, 0, 0, 0], "roll": 5},
        {"location": [501, 0, 1], "target": [0, 1, 1]},
        {"location": [0, 0, -51], "target": [0, 1, 1]},
        {"location": [0, 0, 1], "target": [0, 0, 1.01]},
    ],
)
def test_a_camera_that_cannot_be_is_refused(start: dict[str, Any], session: Session) -> None:
    with pytest.raises(InputError):
        session.apply(edits_of([{"kind": "camera", "shot": SHOT, "decision": {"placed": {"start": start}}}]))
