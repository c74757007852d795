"""Camera directions as writers spell them, and the many phrases that only look like one."""

from __future__ import annotations

import pytest

from storyblender.agents.director.camera_phrases import parse_direction, parse_note


def said(note: object) -> dict[str, object]:
    return {key: value for key, value in vars(note).items() if value and key != "phrase"}


FOUND = [
    ("CLOSE ON NORA.", {"size": "CU", "subject": "NORA"}, ""),
    ("CLOSE ON NORA, crying.", {"size": "CU", "subject": "NORA"}, "NORA, crying."),
    ("CLOSE ON NORA as she opens the letter.", {"size": "CU", "subject": "NORA"}, "she opens the letter."),
    ("CLOSE ON NORA opening the letter.", {"size": "CU", "subject": "NORA"}, "NORA opening the letter."),
    ("CLOSE ON: Nora opens the letter.", {"size": "CU", "subject": "Nora"}, "Nora opens the letter."),
    ("CLOSE-UP - the brass key.", {"size": "CU", "subject": "brass key"}, ""),
    ("EXTREME CLOSE UP of her eye.", {"size": "ECU", "subject": "eye"}, ""),
    ("TIGHT ON Ben's hand.", {"size": "CU", "subject": "Ben's hand"}, ""),
    ("MEDIUM SHOT: Ben sits.", {"size": "MS", "subject": "Ben"}, "Ben sits."),
    ("MEDIUM CLOSE ON BEN", {"size": "MCU", "subject": "BEN"}, ""),
    ("TWO-SHOT of Ben and Nora.", {"kind": "two_shot", "subject": "Ben and Nora"}, ""),
    ("WIDE. The desert.", {"size": "WS"}, "The desert."),
    ("MASTER SHOT. The room.", {"size": "WS"}, "The room."),
    ("FULL SHOT of the guard", {"size": "FS", "subject": "guard"}, ""),
    ("AERIAL VIEW of the city.", {"size": "EWS", "angle": "bird's-eye", "subject": "city"}, ""),
    ("ESTABLISHING SHOT. The castle.", {"size": "EWS", "kind": "establishing"}, "The castle."),
    ("INSERT - THE LETTER", {"kind": "insert", "subject": "LETTER"}, ""),
    ("NORA'S POV - the street below.", {"kind": "pov", "who": "NORA", "subject": "street below"}, ""),
    ("OVER NORA'S SHOULDER: Ben reads.", {"kind": "ots", "who": "NORA", "subject": "Ben"}, "Ben reads."),
    ("OTS NORA ON BEN", {"kind": "ots", "who": "NORA", "subject": "BEN"}, ""),
    ("LOW ANGLE on the sheriff.", {"angle": "low angle", "subject": "sheriff"}, ""),
    ("DUTCH ANGLE. Tomas runs.", {"angle": "dutch", "roll": 12.0}, "Tomas runs."),
    ("OVERHEAD SHOT of the table.", {"angle": "high angle", "subject": "table"}, ""),
    ("We push in on Nora as she reads.", {"movement": "push in", "subject": "Nora"}, "she reads."),
    ("Nora reads, and we slowly push in.", {"movement": "push in"}, "Nora reads"),
    ("The camera pulls back to reveal the room.", {"movement": "pull out", "subject": "room"}, ""),
    ("PAN LEFT with Nora.", {"movement": "pan", "direction": "left", "subject": "Nora"}, ""),
    ("CRANE UP over the roofs.", {"movement": "pedestal", "direction": "up", "subject": "roofs"}, ""),
    ("TRACKING SHOT: Kira sprints.", {"movement": "track", "subject": "Kira"}, "Kira sprints."),
    ("The camera circles around Nora.", {"movement": "orbit", "subject": "Nora"}, ""),
    ("SHALLOW FOCUS ON NORA.", {"focus": "shallow", "subject": "NORA"}, ""),
    ("Close on Nora in shallow focus.", {"size": "CU", "focus": "shallow", "subject": "Nora"}, ""),
    ("CLOSE ON NORA, soft focus, as she reads.", {"size": "CU", "focus": "soft", "subject": "NORA"}, "she reads."),
    ("WIDE SHOT, DEEP FOCUS. Ben sits.", {"size": "WS", "focus": "deep"}, "Ben sits."),
    ("Rack focus from Nora to Ben.", {"focus": "rack", "rack": "Nora to Ben", "subject": "Nora to Ben"}, ""),
    ("The camera racks focus to the letter.", {"focus": "rack", "rack": "letter", "subject": "letter"}, ""),
    ("FAIBLE PROFONDEUR DE CHAMP. Nora lit.", {"focus": "shallow"}, "Nora lit."),
    ("HOLD ON the empty chair.", {"movement": "static", "subject": "empty chair"}, ""),
    ("REVERSE ANGLE: Ben smiles.", {"kind": "reverse", "subject": "Ben"}, "Ben smiles."),
    ("ANGLE ON the door.", {"subject": "door"}, ""),
    ("MATCH CUT TO: a wheel.", {"kind": "match_cut", "subject": "wheel"}, ""),
    ("INTERCUT WITH NORA'S ROOM.", {"kind": "intercut", "subject": "NORA'S ROOM"}, ""),
    ("LOW ANGLE TRACKING SHOT: boots.", {"angle": "low angle", "movement": "track", "subject": "boots"}, ""),
    ("ON NORA as she turns.", {"subject": "NORA"}, "she turns."),
    ("Nora waits, the camera TRACKING with her.", {"movement": "track", "subject": "her"}, "Nora waits"),
]


@pytest.mark.parametrize(("sentence", "fields", "left"), FOUND, ids=[row[0] for row in FOUND])
def test_reads_a_direction_and_leaves_the_action(sentence: str, fields: dict[str, object], left: str) -> None:
    note, (start, end) = parse_direction(sentence)
    assert note is not None
    assert said(note) == fields
    assert sentence[start:end] == left


@pytest.mark.parametrize(
    "sentence",
    [
        "Nora pulls back.", "Ben pans for gold.", "They close in on the house.", "MASTER YODA walks in.",
        "The wide road is long.", "Nora holds on to the rope.", "CLOSE by, a dog barks.", "LONG JOHN sits.",
        "He stands CLOSE TO HER.", "Ben follows Nora.", "The truck tilts.", "POVERTY everywhere.", "HOLD the door!",
        "LEFT HAND on the wheel.", "",
    ],
)  # fmt: skip
def test_leaves_plain_action_alone(sentence: str) -> None:
    assert parse_direction(sentence) == (None, (0, len(sentence)))


@pytest.mark.parametrize(
    ("text", "fields"),
    [
        ("SHOT: low angle on the door, slow push in", {"angle": "low angle", "movement": "push in", "subject": "door"}),
        ("SHOT: over Rick's shoulder on Ilsa", {"kind": "ots", "who": "RICK", "subject": "Ilsa"}),
        ("shot: two-shot", {"kind": "two_shot"}),
        ("Camera: high angle, wide", {"size": "WS", "angle": "high angle"}),
        ("SHOT: the two of them", {"subject": "the two of them"}),
    ],
)
def test_notes_speak_to_the_camera(text: str, fields: dict[str, object]) -> None:
    note = parse_note(text)
    assert note is not None and said(note) == fields


def test_other_notes_do_not() -> None:
    assert parse_note("remember to fix the close-up") is None
