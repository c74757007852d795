"""Pages in their writer's own layout become the same elements: headings, cues, speeches, action, titles, sounds."""

from __future__ import annotations

import pytest

from storyblender.screenplay.cues import closes_series, item_mark, opens_series
from storyblender.screenplay.headings import heading_words, is_heading
from storyblender.screenplay.model import Screenplay
from storyblender.screenplay.source import read

_LINES = [
    ("Rook", "Where is the lantern?"),
    ("Wren", "Under the stairs."),
    ("Rook", "Fetch it."),
    ("Wren", "Fetch it you."),
]


def _told(screenplay: Screenplay, *kinds: str) -> list[str]:
    return [" ".join(element.text.split()) for element in screenplay.elements if element.kind in kinds]


def _speeches(screenplay: Screenplay) -> list[tuple[str, str]]:
    found: list[tuple[str, str]] = []
    name = ""
    for element in screenplay.elements:
        name = element.name if element.kind == "cue" else name
        found += [(name, element.text)] if element.kind == "dialogue" else []
    return found


@pytest.mark.parametrize(
    "form",
    [
        "{0}: {1}",
        "{2}: {1}",
        "{2}. {1}",
        "**{0}**: {1}",
        "_{0}_. {1}",
        "{2}:\n{1}",
        "{2}\n{1}",
        "{2}\n\n{1}",
        "- {2}: {1}",
    ],
)
def test_however_a_page_marks_who_speaks_the_same_people_say_the_same(form: str) -> None:
    heading = "" if form.startswith(("{0}", "_")) else "INT. MILL - NIGHT\n\n"
    page = heading + "\n\n".join(form.format(name, words, name.upper()) for name, words in _LINES)
    assert _speeches(read(page)) == [(name.upper(), words) for name, words in _LINES]


def test_speeches_without_blank_lines_between_them_are_told_apart_and_what_is_done_is_not_said() -> None:
    page = (
        "INT. MILL - NIGHT\nRook (40) lifts a sack.\nROOK\nWhere is it?\nWREN\nGone.\nRook drops the sack.\n"
        "ROOK\nGone?\nWREN\nGone."
    )
    screenplay = read(page)
    assert _speeches(screenplay) == [("ROOK", "Where is it?"), ("WREN", "Gone."), ("ROOK", "Gone?"), ("WREN", "Gone.")]
    assert "Rook drops the sack." in _told(screenplay, "action")


PLAY = """THE LANTERN
A play in one act

CHARACTERS

ROOK, a miller, sixty
WREN, his daughter, twenty

SETTING: A mill, late evening. Sacks along the wall.

At rise, ROOK counts sacks.

ROOK. One is missing.

WREN. (not looking up) Count again.

        (She rises and bars the door. Wind.)

ROOK. I have counted. (To the cat.) You saw it.

WREN. The cat saw nothing.

                    CURTAIN
"""


def test_a_stage_play_has_its_people_its_place_and_its_directions() -> None:
    play = read(PLAY)
    assert play.title == "THE LANTERN"
    assert _told(play, "cast") == ["ROOK, a miller, sixty", "WREN, his daughter, twenty"]
    assert _told(play, "heading") == ["SETTING: A mill, late evening."]
    assert _told(play, "action") == [
        "Sacks along the wall.", "At rise, ROOK counts sacks.", "She rises and bars the door. Wind."
    ]  # fmt: skip
    assert _told(play, "parenthetical") == ["not looking up", "To the cat."]
    assert "CURTAIN" in _told(play, "section")


def test_what_an_element_says_stands_where_it_points() -> None:
    for element in (play := read(PLAY)).elements:
        assert play.text[element.start : element.end].strip("()").strip() == element.text.strip()


COMIC = """MOTHS

PAGE ONE (2 panels)

1. Wide. A lamp room. ROOK polishes the glass.

ROOK: Clean.

SFX: TINK

2. Close on a moth.

CAP: Later.
ROOK (off): Shoo.

PAGE TWO (1 panel)

1. The moth leaves.

ROOK: Well then.
"""


def test_each_panel_of_a_comic_is_one_picture_with_its_balloons() -> None:
    comic = read(COMIC)
    assert comic.page == "comic"
    pictures = [(e.picture, e.kind) for e in comic.elements if e.kind in ("action", "dialogue", "title", "sound")]
    assert pictures == [
        (1, "action"), (1, "dialogue"), (1, "sound"), (2, "action"), (2, "title"), (2, "dialogue"), (3, "action"),
        (3, "dialogue"),
    ]  # fmt: skip
    assert [element.extension for element in comic.elements if element.kind == "cue"] == ["", "OFF", ""]


@pytest.mark.parametrize(
    "page",
    [
        "CLIENT: Moth Soap\n\nVIDEO                         AUDIO\n\nInt. mill. Rook scrubs          SFX: Splash.\n"
        "a sack.                       ROOK: Out!\n\nSUPER: Moth. Clean.           MVO: Moth.\n",
        "VIDEO: Int. mill. Rook scrubs a sack.\nAUDIO: SFX: Splash.\nROOK: Out!\n\n"
        "VIDEO: SUPER: Moth. Clean.\nAUDIO: MVO: Moth.\n",
    ],
)
def test_picture_and_sound_of_a_row_belong_together(page: str) -> None:
    spot = read(page)
    assert spot.page == "columns"
    assert _told(spot, "heading") == ["Int. mill"]
    assert _speeches(spot) == [("ROOK", "Out!"), ("MVO", "Moth.")]
    assert _told(spot, "title") == ["Moth. Clean."]
    assert {e.picture for e in spot.elements if e.kind in ("action", "dialogue")} == {1, 2}


def test_a_chat_keeps_who_wrote_what_and_leaves_out_the_hours() -> None:
    page = "\n".join(f"12/04, 7:0{n} am - {name} 30{n}: {words}" for n, (name, words) in enumerate(_LINES))
    chat = read(page)
    assert chat.page == "chat"
    assert [e.name for e in chat.elements if e.kind == "cue"] == [name.upper() for name, _ in _LINES]
    assert _told(chat, "action") == [words for _, words in _LINES]


def test_numbered_cards_and_pages_of_a_picture_book_are_no_sentences() -> None:
    cards = read("THE LID\n\nSc. 1 (10 sec)\nA mill. Dawn.\n\nSc. 2 (5 sec)\nInside. A cat sleeps.\n")
    assert [e.scene_number for e in cards.elements if e.kind == "heading"] == ["1", "2"]
    book = read("ROOK\n\n" + "\n\n".join(f"p. {n}\nRook saw {n} moths." for n in range(2, 8)))
    assert [e.picture for e in book.elements if e.kind == "action"] == [1, 2, 3, 4, 5, 6]


def test_dates_greetings_and_names_under_letters_are_no_units() -> None:
    letters = read(
        "3rd May\n\nDear Wren,\n\nThe mill is cold. I have sold the cat.\n\nYour Rook\n\n"
        "4th May\n\nDear Rook,\n\nBuy it back.\n"
    )
    assert _told(letters, "action") == ["The mill is cold. I have sold the cat.", "Buy it back."]


@pytest.mark.parametrize(
    ("line", "side", "place"),
    [
        ("int. mill, evening", "inside", "mill, evening"),
        ("INNEN – MÜHLE – NACHT", "inside", "MÜHLE – NACHT"),
        ("AUSSEN. HOF. TAG", "outside", "HOF. TAG"),
        ("INTERIOR. MOLINO. NOCHE", "inside", "MOLINO. NOCHE"),
        ("EXTÉRIEUR - MOULIN - NUIT", "outside", "MOULIN - NUIT"),
        ("INT/EXT. CART - DAY", "inside, outside", "CART - DAY"),
        ("7/2 INT. MILL - DAY", "inside", "MILL - DAY"),
        ("SCENE 4: INT. MILL - DAY", "inside", "MILL - DAY"),
    ],
)
def test_a_heading_is_known_in_many_shapes(line: str, side: str, place: str) -> None:
    assert is_heading(line)
    words = heading_words(line)
    assert (words.side, words.place) == (side, place)


@pytest.mark.parametrize(
    "line", ["Innen ist es warm.", "Interior walls crumble", "Extra sacks arrive.", "Est-ce que tu viens ?"]
)
def test_a_sentence_that_begins_like_a_heading_is_none(line: str) -> None:
    assert not is_heading(line)


SERIES = """INT. MILL - DAY

BEGIN MONTAGE -- "SPRING" (slow)

-- Rook paints the door.

-- SUPER: "May"

-- Wren digs.

END MONTAGE

INT. MILL - NIGHT

Rook sleeps.
"""


def test_each_item_of_a_series_is_a_picture_and_words_on_the_screen_are_none() -> None:
    series = read(SERIES, "fountain")
    assert [(e.kind, e.text, e.picture) for e in series.elements if e.kind in ("action", "title")] == [
        ("action", "Rook paints the door.", 1),
        ("title", '"May"', None),
        ("action", "Wren digs.", 2),
        ("action", "Rook sleeps.", None),
    ]


def test_a_series_opens_and_closes_in_other_languages() -> None:
    assert opens_series("SERIE DE PLANOS:") and not opens_series("Rook mounts a montage of moths.")
    assert closes_series("FIN DE MONTAJE") and not closes_series("END OF THE PIER")
    assert item_mark("A) Rook") and item_mark("-- Rook") and not item_mark("Rook -- and Wren")
