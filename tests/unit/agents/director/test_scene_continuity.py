"""Things that arrive later are hidden before; broken, open and dark things stay so; screens show what is written."""

from __future__ import annotations

from storyblender.agents.director.reading import Deed, Reading, SceneReading, StateChange, Thing, Unit
from storyblender.agents.director.scene_continuity import absent_until_brought, inherited_states
from storyblender.agents.director.writing import add_writing_changes
from storyblender.memory.thing_states import THING_STATES, Condition
from storyblender.screenplay.model import Screenplay

_IS = {state: Condition(states=(state,)) for state in THING_STATES}


def _unit(number: int, scene: int = 0, text: str = "words", **fields: object) -> Unit:
    return Unit("action", scene, number, 10 * number, 10 * number + 9, text, **fields)  # pyright: ignore[reportArgumentType]


def test_what_somebody_brings_is_not_there_before_they_bring_it() -> None:
    brings = Deed("tom", "carry", target="cake", prop="cake", verb="bring")
    units = [_unit(0), _unit(1, things=["table"]), _unit(2, deeds=[brings], things=["cake"]), _unit(3, things=["cake"])]
    missing = absent_until_brought(units, {"cake", "table"})
    assert missing == {0: {"cake"}, 10: {"cake"}}


def test_what_was_named_before_or_is_said_to_be_absent_is_left_alone() -> None:
    brings = Deed("tom", "carry", prop="cake", verb="bring")
    seen = [_unit(0, things=["cake"]), _unit(1, deeds=[brings])]
    assert absent_until_brought(seen, {"cake"}) == {}
    said = [_unit(0), _unit(1, absent=["cake"]), _unit(2, deeds=[brings])]
    assert absent_until_brought(said, {"cake"}) == {}


def test_a_car_that_drives_up_was_not_there() -> None:
    arrives = _unit(1, things=["car"], changes=[StateChange("car", "there")])
    assert absent_until_brought([_unit(0), arrives], {"car"}) == {0: {"car"}}


def _reading(*times: str, places: tuple[int | None, ...] = (), **changes: list[tuple[str, str]]) -> Reading:
    scenes = [
        SceneReading(index + 1, f"INT. ROOM - {time}", "room", time=time, reference=place)  # pyright: ignore[reportArgumentType]
        for index, (time, place) in enumerate(zip(times, places or (None,) * len(times), strict=True))
    ]
    units = [
        _unit(index, index, changes=[StateChange(*each) for each in changes.get(f"in_{index + 1}", [])])
        for index in range(len(scenes))
    ]
    things = [Thing("vase", "vase"), Thing("door", "door", "set_piece"), Thing("lamp", "lamp")]
    return Reading(Screenplay.model_construct(text=""), things=things, scenes=scenes, units=units)


def test_the_broken_stays_broken_and_a_door_is_as_it_was_left_until_the_hour_changes() -> None:
    left = [("vase", "broken"), ("door", "open"), ("lamp", "off")]
    found = inherited_states(_reading("night", "night", "day", places=(None, 1, 1), in_1=left))
    assert found[1] == {}
    assert found[2] == {
        "vase": _IS["broken"],
        "door": _IS["open"],
        "lamp": _IS["off"],
    }
    assert found[3] == {"vase": _IS["broken"]}


def test_a_door_of_another_place_is_another_door_and_a_mended_vase_is_whole() -> None:
    left = [("vase", "broken"), ("door", "open")]
    reading = _reading("night", "night", "night", places=(None, None, 1), in_1=left, in_2=[("vase", "mended")])
    found = inherited_states(reading)
    assert found[2] == {"vase": _IS["broken"]}
    assert found[3] == {"vase": _IS["mended"], "door": _IS["open"]}


def test_what_was_taken_away_stays_away_from_that_place() -> None:
    found = inherited_states(_reading("night", "night", "day", places=(None, None, 1), in_1=[("vase", "gone")]))
    assert "vase" not in found[2] and found[3] == {"vase": _IS["gone"]}


def test_another_message_on_a_screen_is_a_change_and_the_same_one_is_none() -> None:
    lines = [
        'The phone reads "COME HOME". ',
        "She waits. ",
        'The phone reads "COME HOME". ',
        'The phone says "TOO LATE".',
    ]
    text, units = "", list[Unit]()
    for index, line in enumerate(lines):
        things = ["phone"] if "phone" in line else []
        units.append(Unit("action", 0, index, len(text), len(text) + len(line), line, things=things))
        text += line
    reading = Reading(Screenplay.model_construct(text=text), things=[Thing("phone", "phone", first=4)], units=units)
    changes = [[(each.subject, each.state) for each in unit.changes] for unit in add_writing_changes(reading).units]
    assert changes == [[], [], [], [("phone", "reads TOO LATE")]]
