"""Things in hands: followed through the units of a Director, and what of them cannot be."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from storyblender.agents.director.custody import Custody, things_in_hands, with_things_in_hands
from storyblender.agents.director.reading import Deed, Thing, Unit
from storyblender.memory.scene_context import Spot

THINGS = [Thing(each, each, handled=True) for each in ("cup", "pen", "ladder")]
Deeds = Sequence[tuple[str, str, str | None]]
"""Actor, motion and target; the thing is the cup."""


def unit(number: int, deeds: Deeds = (), held: dict[str, list[str]] | None = None, absent: Sequence[str] = ()) -> Unit:
    return Unit(
        kind="action", scene=0, element=0, start=10 * number, end=10 * number + 9, text="words",
        deeds=[Deed(actor, motion, target, "cup") for actor, motion, target in deeds],
        on_stage=["ada", "ben"], held=held or {}, absent=[*absent],
    )  # fmt: skip


def hands(*units: Unit) -> list[dict[str, list[str]]]:
    return [each.held for each in with_things_in_hands(units, THINGS)]


def test_what_is_held_stays_in_hand_until_a_deed_or_a_word_takes_it() -> None:
    told = hands(unit(1, held={"ada": ["cup", "pen"]}), unit(2), unit(3, [("ada", "give", "ben")]), unit(4))
    assert told == [{"ada": ["cup", "pen"], "ben": []}] * 2 + [{"ada": ["pen"], "ben": ["cup"]}] * 2


@pytest.mark.parametrize("motion", ["put_down", "drop", "throw", "pocket"])
def test_what_is_let_go_is_in_no_hand(motion: str) -> None:
    assert hands(unit(1, held={"ada": ["cup"]}), unit(2, [("ada", motion, None)]))[1] == {"ada": [], "ben": []}


def test_what_has_a_spot_is_in_no_hand() -> None:
    slid = unit(2, [("ada", "give", "ben")])
    slid.spots["cup"] = Spot(relation="on", anchor_id="pen")
    assert hands(unit(1, held={"ada": ["cup"]}), slid)[1] == {"ada": [], "ben": []}


def test_what_is_handed_over_later_is_in_hand_from_the_start() -> None:
    assert hands(unit(1), unit(2, [("ada", "give", "ben")]))[0] == {"ada": ["cup"], "ben": []}


def test_but_not_where_it_is_absent_or_the_hands_are_empty() -> None:
    given = unit(2, [("ada", "give", "ben")])
    assert hands(unit(1, absent=["cup"]), given) == [{"ada": [], "ben": []}, {"ada": [], "ben": ["cup"]}]
    assert hands(unit(1, held={"ada": []}), given)[0] == {"ada": [], "ben": []}


def test_what_is_absent_is_in_no_hand() -> None:
    assert hands(unit(1, held={"ada": ["cup"]}), unit(2, absent=["cup"]))[1] == {"ada": [], "ben": []}


@pytest.mark.parametrize(
    ("wrong", "why"),
    [
        (unit(2, held={"ada": ["cup"]}, absent=["cup"]), "is `absent`"),
        (unit(2, held={"ada": ["cup"], "ben": ["cup"]}), "both hold"),
        (unit(2, [("ada", "take", None)]), "in hand already since unit 1"),
        (unit(2, [("ben", "give", "ada")]), "which ada has"),
        (unit(2, [("ben", "put_down", None)]), "which ada has"),
    ],
)
def test_what_cannot_be_is_said_in_one_sentence(wrong: Unit, why: str) -> None:
    custody = Custody(*things_in_hands(THINGS))
    assert not custody.play(unit(1, held={"ada": ["cup"]}), 1)
    faults = custody.play(wrong, 2)
    assert len(faults) == 1 and faults[0].startswith("unit 2: ") and why in faults[0]


def test_what_is_right_is_not_refused() -> None:
    custody = Custody(*things_in_hands(THINGS))
    assert not custody.play(unit(1, held={"ada": ["ladder"], "ben": ["ladder"]}), 1), "two carry what is long"
    assert not custody.play(unit(2, [("ada", "give", "ben"), ("ben", "take", "ada")]), 2), "handed over and received"
