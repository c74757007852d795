"""The motion of a verb with an object, particle and place."""

import pytest

from conftest import Read


def told(read_scene: Read, action: str) -> set[tuple[str, str]]:
    reading = read_scene(f"ANNA (30, a nurse) and BOB (40) are here.\n\n{action}")
    return {(deed.actor, deed.motion) for unit in reading.units for deed in unit.deeds}


@pytest.mark.parametrize(
    ("action", "motion"),
    [
        ("Bob hauls up the shutter.", "open"),
        ("Bob pushes up the window.", "open"),
        ("Bob shoulders the door open.", "open"),
        ("Bob sweeps the papers off the table.", "push"),
        ("Bob lets himself in with a key.", "walk"),
        ("Bob catches Anna in the stomach.", "hit"),
        ("Bob steers Anna to the door.", "push"),
        ("Bob lays Anna down on the furs.", "put_down"),
        ("Bob slips in the mud.", "fall"),
        ("Bob holds out a biscuit.", "give"),
        ("Bob lifts the key from the board.", "take"),
        ("Bob picks the mug up off the floor.", "pick_up"),
        ("Bob stands the candle up again.", "put_down"),
        ("Bob presses the drill against the lock.", "press"),
        ("Bob knocks the vase off the desk.", "push"),
        ("Bob goes down.", "fall"),
        ("Bob ducks behind Anna.", "hide"),
        ("Bob runs down the path.", "run"),
        ("Bob shuts off the radio.", "press"),
        ("Bob hangs up.", "put_down"),
        ("Bob waits at the wheel.", "sit"),
        ("Bob grabs Anna by the sleeve.", "hold"),
        ("Bob grabs the rail.", "hold"),
        ("Bob stamps on the brake.", "press"),
        ("Bob throws back the lid.", "open"),
        ("Bob passes the bottle on to Anna.", "give"),
        ("Bob turns on his heel.", "turn"),
        ("Bob puts an eye to the keyhole.", "look"),
        ("Bob jerks a thumb at the door.", "point"),
        ("Bob stoops for the coin.", "pick_up"),
        ("Bob bends over the map.", "lean"),
        ("Bob points the flashlight, waiting.", "aim"),
        ("Bob puts a coin in Anna's palm.", "give"),
        ("Bob passes the bottle on.", "give"),
        ("Bob brings the ledger to Anna.", "give"),
        ("Bob stuffs the letter into his pocket.", "put_down"),
        ("Bob feeds a coin into the machine.", "put_down"),
        ("Bob tears a page out of the book.", "take"),
        ("Bob scratches a number on the wall.", "write"),
        ("Bob hangs up his coat.", "put_down"),
        ("Bob mutters under his breath.", "whisper"),
        ("Bob turns the lantern down.", "press"),
        ("Bob produces a flask.", "take"),
        ("Bob squeezes Anna's hand.", "hold"),
    ],
)
def test_the_words_around_a_verb_choose_its_motion(read_scene: Read, action: str, motion: str) -> None:
    assert told(read_scene, action) == {("bob", motion)}


@pytest.mark.parametrize(
    "action",
    [
        "Bob freezes.",
        "Bob stops dead.",
        "Bob gives up.",
        "Bob goes white.",
        "Bob bites his nails.",
        "Bob thinks about it.",
        "Bob wears enormous dark glasses.",
        "Bob clears his throat.",
        "Bob moves his lips.",
        "Bob leaves the door open.",
        "Bob knocks over a candlestick.",
    ],
)
def test_states_and_accidents_are_no_deeds(read_scene: Read, action: str) -> None:
    assert told(read_scene, action) == set()
