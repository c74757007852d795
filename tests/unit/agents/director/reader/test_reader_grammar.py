"""Who does what in sentences of many shapes: relative clauses, orders, wishes, outcomes, delayed subjects."""

import pytest

from conftest import Read

TOLD = [
    ("Anna hands the box to Bob, who opens it and reads.", {("anna", "give"), ("bob", "open"), ("bob", "read")}),
    ("Anna tells Bob to sit.", {("anna", "talk")}),
    ("Bob is about to speak.", set()),
    ("Bob would like to dance.", set()),
    ("Bob tries to lift the crate.", {("bob", "pick_up")}),
    ("Anna kicks the door shut.", {("anna", "close")}),
    ("Anna pulls the curtains closed.", {("anna", "close")}),
    ("Bob stops, gasping, and hands over the keys.", {("bob", "give")}),
    ("After washing the cup, Anna sits.", {("anna", "clean"), ("anna", "sit")}),
    ("They all leave.", {("anna", "walk"), ("bob", "walk")}),
    ("Anna sits, and behind her stands a WAITER.", {("anna", "sit"), ("waiter", "stand")}),
    ("Bob dodges, swoons and grieves.", {("bob", "jump"), ("bob", "fall"), ("bob", "cry")}),
    ("Seated at the table, Bob reads.", {("bob", "sit"), ("bob", "read")}),
    ("Anna and Bob sweep in arm in arm.", {("anna", "walk"), ("bob", "walk")}),
    ("Round the corner sweeps BOB.", {("bob", "walk")}),
    ("Both of them nod.", {("anna", "nod"), ("bob", "nod")}),
    ("Anna helps Bob put on his coat.", {("bob", "wear")}),
]


@pytest.mark.parametrize(("action", "deeds"), TOLD)
def test_who_does_what(read_scene: Read, action: str, deeds: set[tuple[str, str]]) -> None:
    reading = read_scene(f"ANNA (30) and BOB (40) are here.\n\n{action}")
    assert {(deed.actor, deed.motion) for unit in reading.units for deed in unit.deeds} == deeds


@pytest.mark.parametrize(
    ("action", "deeds"),
    [
        ("Bob comes running.", {("bob", "run")}),
        ("Bob stops writing.", set()),
        ("Bob lets the crowbar fall.", {("bob", "drop")}),
        ("Anna catches Bob staring at the clock.", {("bob", "look")}),
    ],
)
def test_two_verbs_may_be_one_deed(read_scene: Read, action: str, deeds: set[tuple[str, str]]) -> None:
    reading = read_scene(f"ANNA (30) and BOB (40) are here.\n\n{action}")
    assert {(deed.actor, deed.motion) for unit in reading.units for deed in unit.deeds} == deeds


@pytest.mark.parametrize(
    ("action", "deeds"),
    [
        ("Anna helps Bob up.", {("bob", "stand_up")}),
        ("Anna helps Bob into his coat.", {("bob", "wear")}),
        ("Anna ushers Bob out.", {("anna", "walk"), ("bob", "walk")}),
        ("Anna, still laughing, pours the wine.", {("anna", "laugh"), ("anna", "pour")}),
        ("Bob is already through the door.", {("bob", "walk")}),
    ],
)
def test_who_is_made_to_do_it_does_it(read_scene: Read, action: str, deeds: set[tuple[str, str]]) -> None:
    reading = read_scene(f"ANNA (30) and BOB (40) are here.\n\n{action}")
    assert {(deed.actor, deed.motion) for unit in reading.units for deed in unit.deeds} == deeds
