"""Edits of light, set, staging, things and takes: what they make anew, what they leave, and who may change them."""

from __future__ import annotations

from math import dist
from pathlib import Path
from typing import Any

import pytest
from tests.home import SCRIPT, SETTINGS

from storyblender.catalog.fixtures import fixtures_called
from storyblender.catalog.sets import plan_of
from storyblender.edits.words import edits_of, lamp_edit
from storyblender.errors import InputError, Rejected, StaleEdit
from storyblender.memory.edits import EDITS
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.scene_context import Light, SceneContext
from storyblender.memory.shot_context import ShotContext
from storyblender.project import Project
from storyblender.session import Session
from storyblender.studio import Studio

ROOM, PARK, LATER = "SC010", "SC020", "SC030"
SHOT = "SC010_SH010"
LIGHT = {"kind": "light", "scene": ROOM, "decision": {"time_of_day": "dusk", "warmth": 1}}
BRICK = {"kind": "set", "scene": ROOM, "decision": {"walls": "brick"}}
KIT = {"kind": "set", "scene": PARK, "decision": {"kit": "forest", "options": {"pines": True}}}
LAYOUT = {"kind": "layout", "scene": ROOM}
BENCH = {"kind": "asset", "thing": "sofa", "model": "red bench"}
PIANO = {"kind": "asset", "action": "add", "scene": ROOM, "model": "piano"}
CHAIR = {"kind": "asset", "action": "remove", "scene": ROOM, "thing": "rug"}
TAKE = {"kind": "take", "shot": SHOT}
SPOT = {"kind": "SPOT", "location": [2, 2, 2.4], "target": [0, 0, 1.2], "power": 300, "color": [1, 0.5, 0.2]}
LAMP = {"kind": "light", "scene": ROOM, "decision": {"lamps": {"backlight": SPOT}}}
EVERY = [LIGHT, LAMP, BRICK, KIT, LAYOUT, BENCH, PIANO, CHAIR, TAKE]


def apply(session: Session, *edits: dict[str, Any], draw: bool = True) -> tuple[str, ...]:
    applied = session.apply(edits_of(list(edits)))
    if draw:
        session.draw(applied)
    return applied.stale


def scene(graph: ContinuityMemoryGraph, name: str) -> SceneContext:
    return graph.scene(int(name[2:]) // 10)


def shots(graph: ContinuityMemoryGraph, name: str) -> tuple[ShotContext, ...]:
    return graph.shots_of(int(name[2:]) // 10)


@pytest.mark.parametrize("edit", EVERY, ids=lambda edit: str(edit)[:60])
def test_every_edit_is_data_and_one_undo(edit: dict[str, Any], session: Session) -> None:
    [typed] = edits_of([edit])
    assert EDITS.validate_json(EDITS.dump_json((typed,))) == (typed,)
    before = session.graph
    apply(session, edit, draw=False)
    assert session.graph != before
    session.undo()
    assert session.graph == before


def test_a_batch_of_all_is_made_to_the_end_and_is_one_undo(session: Session) -> None:
    before = session.graph
    apply(session, *EVERY)
    assert not any(item.stale for item in (*session.graph.scenes, *session.graph.shots))
    assert all(shot.camera is not None for shot in session.graph.shots)
    assert session.check() is not None, "the project is up to date"
    session.undo()
    assert session.graph == before


def test_light_leaves_set_staging_and_cameras_as_they_are(session: Session) -> None:
    before = session.graph
    stale = apply(session, LIGHT)
    after = session.graph
    assert stale == tuple(f"SC010_SH{10 * shot.shot_id:03d}" for shot in shots(after, ROOM))
    assert scene(after, ROOM).lighting != scene(before, ROOM).lighting
    for field in ("environment", "layout"):
        assert getattr(scene(after, ROOM), field) == getattr(scene(before, ROOM), field)
    for old, new in zip(before.shots, after.shots, strict=True):
        assert (old.camera, old.blocking, old.cues) == (new.camera, new.blocking, new.cues)
    assert scene(after, PARK) == scene(before, PARK) and scene(after, LATER) == scene(before, LATER)
    warm, plain = scene(after, ROOM).lighting, scene(before, ROOM).lighting
    assert warm is not None and plain is not None
    assert warm.key_color[0] / warm.key_color[2] > plain.key_color[0] / plain.key_color[2]


def test_materials_reach_every_scene_of_the_place_and_nothing_is_staged_again(session: Session) -> None:
    before = session.graph
    apply(session, BRICK)
    after = session.graph
    for name in (ROOM, LATER):
        made = scene(after, name).environment
        assert made is not None and {wall.material for wall in plan_of(made).walls} == {"brick"}
        assert scene(after, name).layout == scene(before, name).layout
    assert scene(after, PARK) == scene(before, PARK)
    assert [shot.camera for shot in after.shots] == [shot.camera for shot in before.shots]


def test_another_kit_is_staged_again_with_new_cameras(session: Session) -> None:
    before = session.graph
    apply(session, KIT)
    made = scene(session.graph, PARK).environment
    assert made is not None and made.kit == "forest" and made.params["pines"] is True
    assert scene(session.graph, ROOM) == scene(before, ROOM)
    apply(session, {"kind": "unlock", "target": PARK, "parts": ["set"]})
    assert scene(session.graph, PARK).environment == scene(before, PARK).environment, "the crew has it back"


def test_another_staging_moves_people_and_the_first_one_comes_back(session: Session) -> None:
    before = session.graph
    apply(session, LAYOUT)
    there = [each.start.location for shot in shots(session.graph, ROOM) for each in shot.blocking]
    assert there != [each.start.location for shot in shots(before, ROOM) for each in shot.blocking]
    assert scene(session.graph, ROOM).environment == scene(before, ROOM).environment
    apply(session, {**LAYOUT, "staging": 0})
    assert scene(session.graph, ROOM).layout == scene(before, ROOM).layout
    assert [shot.blocking for shot in session.graph.shots] == [shot.blocking for shot in before.shots]


def test_a_thing_is_replaced_in_its_place_wherever_it_is_shown(session: Session) -> None:
    where = {name: placed(session.graph, name, "sofa") for name in (ROOM, LATER)}
    apply(session, BENCH)
    bench = session.graph.asset("sofa")
    assert bench.canonical is not None and bench.canonical.key == "bench" and bench.canonical.params["color"]
    for name, (x, y) in where.items():
        found = placed(session.graph, name, "sofa")
        assert abs(found[0] - x) < 0.5 and abs(found[1] - y) < 0.5, "it stands where the sofa was"
        kinds = {session.graph.asset(item.asset_id).kind for item in scene(session.graph, name).layout.objects}  # type: ignore[union-attr]
        assert "sofa" not in kinds, "the set brings no other one"


def placed(graph: ContinuityMemoryGraph, name: str, asset_id: str) -> tuple[float, float]:
    layout = scene(graph, name).layout
    assert layout is not None
    [item] = [item for item in layout.objects if item.asset_id == asset_id]
    return item.location[:2]


def test_what_is_added_stands_in_the_scene_until_it_is_taken_away(session: Session) -> None:
    apply(session, PIANO)
    assert placed(session.graph, ROOM, "piano")
    apply(session, {"kind": "asset", "action": "remove", "scene": ROOM, "thing": "piano"})
    assert "piano" not in {item.asset_id for item in scene(session.graph, ROOM).layout.objects}  # type: ignore[union-attr]


@pytest.mark.parametrize(("relation", "anchor"), [("next_to", "window"), ("next_to", "sofa"), ("behind", "sofa")])
def test_what_is_added_at_a_place_is_near_it_and_stays_so_in_another_script(
    relation: str, anchor: str, session: Session
) -> None:
    apply(session, {**PIANO, "relation": relation, "anchor": anchor})
    room = scene(session.graph, ROOM)
    assert room.environment is not None and room.layout is not None
    fixtures = fixtures_called(plan_of(room.environment), anchor)
    boxes = [(each.box.x, each.box.y) for each in fixtures]
    boxes += [item.location[:2] for item in room.layout.objects if item.asset_id == anchor]
    assert min(dist(placed(session.graph, ROOM, "piano"), each) for each in boxes) < 2.5
    script = session.folder.parent / "home.fountain"
    script.write_text(SCRIPT.replace("You said you would write.", "You never wrote."))
    session.make(script)
    [kept] = [each for each in scene(session.graph, ROOM).setup.relations if each.asset_id == "piano"]
    assert (kept.kind, kept.anchor_asset_id) == (relation, anchor)
    apply(session, {"kind": "asset", "action": "remove", "scene": ROOM, "thing": "piano"}, draw=False)
    assert not [each for each in scene(session.graph, ROOM).setup.relations if each.asset_id == "piano"]


def test_a_place_without_room_is_told(folder: Path) -> None:
    warnings: list[str] = []
    with Studio(SETTINGS, listener=lambda event: warnings.append(event.message)).open(folder) as session:
        apply(session, {**PIANO, "relation": "next_to", "anchor": "window"})
        assert not [each for each in warnings if "no room" in each]
        session.undo()
        apply(session, {**PIANO, "relation": "in", "anchor": "left_corner"})
    assert "there is no room for the piano in left corner: it stands elsewhere" in warnings


def test_takes_are_kept_chosen_and_dropped(session: Session) -> None:
    first = session.graph.shots[0]
    apply(session, TAKE, {"kind": "camera", "shot": SHOT, "decision": {"size": "ECU"}})
    second = session.graph.shots[0]
    assert (second.take, [take.number for take in second.takes]) == (2, [1]) and second.camera != first.camera
    drawn = (session.folder / "frames" / f"{SHOT}.png").read_bytes()
    session.render()
    assert session.takes(SHOT)[1].is_file(), "the picture of a take that is not chosen is kept"
    apply(session, {"kind": "take", "shot": SHOT, "action": "choose", "number": 1})
    back = session.graph.shots[0]
    assert back.model_copy(update={"takes": (), "take": 1}) == first
    assert (session.folder / "frames" / f"{SHOT}.png").read_bytes() != drawn
    apply(session, {"kind": "take", "shot": SHOT, "action": "drop", "number": 2})
    assert session.graph.shots[0] == first


REFUSED = [
    ({"kind": "light", "scene": "SC990", "decision": {"warmth": 1}}, "no scene"),
    ({"kind": "light", "scene": ROOM, "decision": {}}, "nothing is decided about the light"),
    ({"kind": "set", "scene": ROOM, "decision": {"walls": "briks"}}, "did you mean brick"),
    ({"kind": "set", "scene": PARK, "decision": {"walls": "brick"}}, "has no walls"),
    ({"kind": "set", "scene": ROOM, "decision": {"kit": "beach"}}, "is outdoors"),
    ({"kind": "set", "scene": ROOM, "decision": {"options": {"palms": True}}}, "no option"),
    ({"kind": "layout", "scene": ROOM, "staging": 0}, "staging 0 already"),
    ({"kind": "asset", "thing": "unicorn", "model": "bench"}, "no thing"),
    ({"kind": "asset", "thing": "unicorn", "scene": ROOM, "model": "bench"}, "its furniture"),
    ({"kind": "asset", "thing": "sofa", "model": "unobtainium"}, "the library has no"),
    ({"kind": "asset", "thing": "anna", "model": "bench"}, "is a person"),
    ({"kind": "asset", "action": "remove", "scene": ROOM, "thing": "sofa"}, "is used in SC010_SH010"),
    ({**PIANO, "relation": "next_to", "anchor": "throne"}, "no 'throne' in SC010; parts of its set: .*window"),
    ({"kind": "take", "shot": SHOT, "action": "choose", "number": 1}, "the film shows"),
    ({"kind": "take", "shot": SHOT, "action": "drop", "number": 7}, "has no take 7"),
]


@pytest.mark.parametrize(("edit", "said"), REFUSED, ids=lambda value: str(value)[:50])
def test_what_cannot_be_is_refused_in_one_sentence(edit: dict[str, Any], said: str, session: Session) -> None:
    before = session.graph
    with pytest.raises(InputError, match=said):
        apply(session, edit)
    assert session.graph == before


@pytest.mark.parametrize(
    "values",
    [
        {"kind": "asset", "thing": "sofa"},
        {"kind": "take", "shot": SHOT, "number": 2},
        {"kind": "asset", "action": "add"},
        {**PIANO, "relation": "next_to"},
        {**BENCH, "relation": "next_to", "anchor": "window"},
    ],
)
def test_half_an_edit_is_none(values: dict[str, Any]) -> None:
    with pytest.raises(InputError):
        edits_of([values])


@pytest.mark.parametrize(
    ("edit", "target", "part"),
    [
        (LIGHT, ROOM, "light"),
        (BRICK, ROOM, "set"),
        (BRICK, LATER, "set"),
        (LAYOUT, ROOM, "layout"),
        (LAYOUT, SHOT, "blocking"),
        (KIT, PARK, "layout"),
        (PIANO, ROOM, "layout"),
        (BENCH, "sofa", "asset"),
        (BENCH, LATER, "layout"),
    ],
    ids=str,
)
def test_what_is_locked_is_refused_until_it_is_unlocked(
    edit: dict[str, Any], target: str, part: str, session: Session
) -> None:
    apply(session, {"kind": "lock", "target": target, "parts": [part]}, draw=False)
    with pytest.raises(InputError, match=r"locked.*unlock it first"):
        apply(session, edit)
    apply(session, {"kind": "unlock", "target": target, "parts": [part]}, draw=False)
    apply(session, edit, draw=False)


@pytest.mark.parametrize("edit", [LIGHT, BRICK, LAYOUT, BENCH, TAKE], ids=lambda edit: str(edit["kind"]))
def test_the_crew_does_not_overrule_a_person(edit: dict[str, Any], folder: Path) -> None:
    with Studio(SETTINGS).open(folder) as session:
        apply(session, edit, draw=False)
    with Project(folder) as project:
        room, shot, sofa = scene(project.graph, ROOM), project.graph.shots[0], project.graph.asset("sofa")
        part = {"asset": sofa, "take": shot}.get(edit["kind"], room)
        gone: dict[str, Any] = {"asset": {"decision": None}, "take": {"takes": (), "take": 1}}.get(
            edit["kind"], {f"{edit['kind']}_decision": None}
        )
        with pytest.raises(Rejected):
            project.commit(replace(project.graph, part.model_copy(update=gone)), "set_dresser", "tidied")


def test_edits_of_light_and_set_do_not_get_in_each_others_way(session: Session) -> None:
    seen = session.revision
    apply(session, LIGHT)
    session.apply(edits_of([BRICK]), seen)
    with pytest.raises(StaleEdit):
        session.apply(edits_of([LIGHT]), seen)


def test_what_was_decided_is_found_again_when_the_script_changes(folder: Path) -> None:
    with Studio(SETTINGS).open(folder) as session:
        apply(session, LIGHT, BRICK, PIANO, BENCH, TAKE, {"kind": "camera", "shot": SHOT, "decision": {"size": "ECU"}})
        before = session.graph
    script = folder.parent / "home.fountain"
    script.write_text(f"EXT. STREET - DAY\n\nA cat runs.\n\n{SCRIPT.replace('alone', 'quietly')}")
    Studio(SETTINGS).make(script, folder)
    with Project(folder) as project:
        after = project.graph
    old, new = scene(before, ROOM), scene(after, PARK)
    for field in ("light_decision", "set_decision", "layout_decision"):
        assert getattr(new, field) == getattr(old, field)
    assert scene(after, "SC040").set_decision == old.set_decision
    assert new.environment is not None and new.environment.walls == "brick" and not new.stale
    assert placed(after, PARK, "piano") and after.asset("sofa").canonical.key == "bench"  # type: ignore[union-attr]
    first = shots(after, PARK)[0]
    assert (first.take, [take.number for take in first.takes]) == (2, [1])


def lamps(graph: ContinuityMemoryGraph, name: str = ROOM) -> dict[str, Light]:
    lighting = scene(graph, name).lighting
    assert lighting is not None
    return {light.name: light for light in lighting.lights}


def lamp(name: str, said: dict[str, Any] | None) -> dict[str, Any]:
    return {"kind": "light", "scene": ROOM, "decision": {"lamps": {name: said}}}


def test_a_lamp_is_added_changed_and_taken_away_and_no_other(session: Session) -> None:
    before = session.graph
    stale = apply(session, LAMP)
    added = lamps(session.graph)["backlight"]
    assert stale == tuple(f"SC010_SH{10 * shot.shot_id:03d}" for shot in shots(before, ROOM))
    assert (added.kind, added.location, added.power, added.color) == ("SPOT", (2, 2, 2.4), 300, (1, 0.5, 0.2))
    first = next(iter(lamps(before)))
    apply(session, lamp(first, {"power": 7.5}), lamp("backlight", {"power": 150}))
    now = lamps(session.graph)
    assert now[first] == lamps(before)[first].model_copy(update={"power": 7.5})
    assert now["backlight"] == added.model_copy(update={"power": 150}), "the rest of it is as it was decided"
    apply(session, lamp("backlight", None), lamp(first, None))
    assert {*lamps(session.graph)} == {*lamps(before)} - {first}
    apply(session, {"kind": "light", "scene": ROOM, "decision": {"warmth": 1}})
    assert {*lamps(session.graph)} == {*lamps(before)} - {first}, "it stays away in another light"
    assert scene(session.graph, ROOM).layout == scene(before, ROOM).layout
    assert lamps(session.graph, PARK) == lamps(before, PARK)
    apply(session, {"kind": "unlock", "target": ROOM, "parts": ["light"]})
    assert lamps(session.graph) == lamps(before), "the crew has it back"


@pytest.mark.parametrize(
    "edit",
    [
        lamp("backlight", {"power": 10}),
        lamp("backlight", None),
        lamp("backlight", {"kind": "SPOT", "location": [900, 0, 2]}),
        lamp("backlight", {"kind": "SPOT", "power": -1}),
        lamp("backlight", {"kind": "TORCH"}),
        {
            "kind": "light",
            "scene": ROOM,
            "decision": {"lamps": {f"lamp_{number}": {"kind": "POINT"} for number in range(30)}},
        },
    ],
    ids=str,
)
def test_a_lamp_that_cannot_be_is_refused(edit: dict[str, Any], session: Session) -> None:
    before = session.graph
    with pytest.raises(InputError):
        apply(session, edit)
    assert session.graph == before


def test_lamps_are_said_on_the_command_line() -> None:
    words = {"kind": "spot", "location": "2,2,2.4", "target": "0,0,1.2", "power": 300, "color": "1,0.5,0.2"}
    assert [lamp_edit(ROOM, "backlight", words)] == list(edits_of([LAMP]))
    assert [lamp_edit(ROOM, "Backlight", {}, remove=True)] == list(edits_of([lamp("backlight", None)]))
    for wrong in (({}, False), ({"power": 1.0}, True), ({"location": "1,2"}, False)):
        with pytest.raises(InputError):
            lamp_edit(ROOM, "backlight", wrong[0], remove=wrong[1])
