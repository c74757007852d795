"""Which verbs of a sentence are deeds, and whose."""

import pytest

from conftest import Read

PEOPLE = "ANNA (30, a nurse), BOB (40) and CARL (50) are here.\n\n"


def told(read_scene: Read, action: str) -> set[tuple[str, str]]:
    return {(deed.actor, deed.motion) for unit in read_scene(PEOPLE + action).units for deed in unit.deeds}


@pytest.mark.parametrize(
    ("action", "deeds"),
    [
        ("Bob offers no opinion.", set()),
        ("Bob says nothing.", set()),
        ("Bob looks at the dust rising far behind them.", {("bob", "look")}),
        ("Bob leaves the pen where it is.", set()),
        ("Anna, in rubber boots, sits on a bench.", {("anna", "sit")}),
        ("Anna shakes her head at Bob.", {("anna", "shake_head")}),
        ("Bob looks as if he had swallowed a wasp.", set()),
        ("Bob had locked the gate.", set()),
        ("Bob puts down the lamp he has been holding.", {("bob", "put_down")}),
        ("Bob tries the handle. Locked.", {("bob", "touch")}),
        ("Bob sits down, both hands around a mug.", {("bob", "sit")}),
        ("BOB, in a suit and hiking boots, sits.", {("bob", "sit")}),
        ("Bob takes a coil of rope from a nail.", {("bob", "take")}),
        ("Bob lays what is in it on the lid of a crate.", {("bob", "put_down")}),
        ("Bob bursts out laughing.", {("bob", "laugh")}),
        ("Bob goes back to stirring the soup.", {("bob", "stir")}),
        ("Bob goes back to sleep.", {("bob", "sleep")}),
        ("Bob walks with Anna on his shoulders.", {("bob", "walk")}),
        ("Bob lays the book face down on the desk.", {("bob", "put_down")}),
        ("Bob is behind the bar.", set()),
        ("He has a mug in one hand.", set()),
    ],
)
def test_what_only_looks_like_a_deed_is_none(read_scene: Read, action: str, deeds: set[tuple[str, str]]) -> None:
    assert told(read_scene, action) == deeds


@pytest.mark.parametrize(
    ("action", "deeds"),
    [
        ("Bob leans on the wall with a clipboard clasped to his chest.", {("bob", "lean"), ("bob", "hold")}),
        ("Bob, on his knees, pumps the jack.", {("bob", "kneel"), ("bob", "work")}),
        ("Bob, seated by the fire, whittles a spoon.", {("bob", "sit"), ("bob", "cut")}),
        ("Bob and Carl, shoulder to shoulder, push the bus.", {("bob", "push"), ("carl", "push")}),
        ("Bob pulls Anna to her feet and sits.", {("bob", "pull"), ("anna", "stand_up"), ("bob", "sit")}),
        ("By the time Bob gets to the door Anna is kneeling.", {("bob", "walk"), ("anna", "kneel")}),
        ("Bob lifts the vase as if it were asleep, carries it to the door.", {("bob", "pick_up"), ("bob", "carry")}),
        ("A map hangs there, and between the map and the stove Bob sleeps.", {("bob", "sleep")}),
        ("Bob straightens his tie.", {("bob", "touch")}),
        ("The tray slips out of Bob's hands.", {("bob", "drop")}),
        ("Bob, on his knees beside the locker, waves.", {("bob", "kneel"), ("bob", "wave")}),
        ("Bob and Carl put their shoulders to it and push.", {("bob", "push"), ("carl", "push")}),
        ("Bob walks in with a lantern.", {("bob", "walk"), ("bob", "carry")}),
        ("Bob stands there with a cup in his hand.", {("bob", "stand"), ("bob", "hold")}),
        ("Bob climbs down, a bag slung across his back.", {("bob", "climb"), ("bob", "carry")}),
        ("Bob gets down on his hands and knees.", {("bob", "kneel")}),
        ("Bob runs after it, gives up and turns.", {("bob", "run"), ("bob", "turn")}),
        ("BOB in the doorway.", {("bob", "stand")}),
        ("Both turn to the door.", {("bob", "turn"), ("carl", "turn")}),
        ("Everybody turns to Anna.", {("bob", "turn"), ("carl", "turn")}),
        ("ANNA\n(quietly, taking off her cap)\nNo.", {("anna", "talk"), ("anna", "take_off")}),
        ("ANNA\n(whispering)\nNo.", {("anna", "whisper")}),
    ],
)
def test_every_verb_has_its_doer(read_scene: Read, action: str, deeds: set[tuple[str, str]]) -> None:
    assert told(read_scene, action) == deeds
