"""Fountain: every piece of syntax, and the promise that every element's span is the user's own words."""

from __future__ import annotations

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from storyblender.errors import InputError
from storyblender.screenplay.cues import split_cue, strip_emphasis
from storyblender.screenplay.fountain import parse
from storyblender.screenplay.model import Element, Screenplay
from storyblender.screenplay.source import read

SAMPLE = """Title:
    _**THE LONG WAY DOWN**_
    A fable
Credit: written by
Author: Una Field
Draft date: 1/2/2031

/* an old opening
that went */
# Act One

= Two thieves wait.

INT. LIFT SHAFT - NIGHT #1A#

Water drips. [[SHOT: low angle on the cable]] ÉLODIE (30s) *clings* to a ladder.
A second line.

ÉLODIE (V.O.)
(under her breath)
Don't look down.
{two_spaces}
Never look down.

@McTEER (O.S.) (CONT'D)
~La la la

ŁUCJA
Left?

李 ^
Right.

!BANG BANG
BANG

.ON THE ROOF

> THE END OF IT <

===

EXT. ROOF/TERRACE - DAWN

CUT TO:

> Smash to white
""".replace("{two_spaces}", "  ")


def kinds(screenplay: Screenplay) -> list[str]:
    return [element.kind for element in screenplay.elements]


def of_kind(screenplay: Screenplay, kind: str) -> list[Element]:
    return [element for element in screenplay.elements if element.kind == kind]


def test_reads_every_element_in_order() -> None:
    assert kinds(parse(SAMPLE)) == [
        "boneyard", "section", "synopsis", "heading", "action", "note", "action", "cue", "parenthetical", "dialogue",
        "cue", "lyric", "cue", "dialogue", "cue", "dialogue", "action", "heading", "centered", "page_break", "heading",
        "transition", "transition",
    ]  # fmt: skip


def test_title_page_has_multi_line_values_without_markup() -> None:
    screenplay = parse(SAMPLE)
    assert screenplay.title == "THE LONG WAY DOWN\nA fable"
    assert dict(screenplay.title_page)["Author"] == "Una Field"


@pytest.mark.parametrize(
    ("page", "edition"),
    [
        ("Title: A\nDraft date: 1/2/2031", "1/2/2031"),
        ("Title: A\nDate: May 2031\nRevision:\n    Blue\n    revisions", "Blue revisions, May 2031"),
        ("Title: A\nVersion: 3", "3"),
        ("Title: A\nContact: 12 Draft Street, 1931", ""),
    ],
)
def test_an_edition_is_the_version_and_date_of_the_title_page(page: str, edition: str) -> None:
    assert parse(f"{page}\n\nINT. ROOM - DAY\n\nAda sits.\n").edition == edition


def test_headings_carry_their_scene_number_and_lose_their_marks() -> None:
    first, forced, last = of_kind(parse(SAMPLE), "heading")
    assert (first.text, first.scene_number) == ("INT. LIFT SHAFT - NIGHT", "1A")
    assert forced.text == "ON THE ROOF"
    assert last.text == "EXT. ROOF/TERRACE - DAWN"


def test_cues_know_name_extension_and_column() -> None:
    elodie, mcteer, lucja, li = of_kind(parse(SAMPLE), "cue")
    assert (elodie.name, elodie.extension) == ("ÉLODIE", "V.O.")
    assert (mcteer.name, mcteer.extension) == ("McTEER", "O.S.")
    assert (lucja.name, lucja.dual) == ("ŁUCJA", False)
    assert (li.name, li.dual) == ("李", True)
    assert of_kind(parse(SAMPLE), "dialogue")[-1].dual


def test_two_spaces_keep_a_speech_open() -> None:
    assert of_kind(parse(SAMPLE), "dialogue")[0].text == "Don't look down.\n  \nNever look down."


def test_an_indented_blank_line_before_a_cue_ends_the_speech() -> None:
    screenplay = parse("INT. A\n\nBOB\nYes.\n    \nANN\nNo.\n")
    assert [cue.name for cue in of_kind(screenplay, "cue")] == ["BOB", "ANN"]


def test_a_note_divides_a_paragraph_and_emphasis_stays_in_the_source() -> None:
    screenplay = parse(SAMPLE)
    before, after = of_kind(screenplay, "action")[:2]
    assert before.text == "Water drips."
    assert after.text == "ÉLODIE (30s) clings to a ladder.\nA second line."
    assert screenplay.text[after.start : after.end].startswith("ÉLODIE (30s) *clings*")
    assert of_kind(screenplay, "note")[0].text == "SHOT: low angle on the cable"


def test_a_note_inside_a_heading_is_left_out_of_it() -> None:
    heading, *_ = parse("INT. HALL [[check]] - DAY\n\nQuiet.").elements
    assert (heading.kind, " ".join(heading.text.split())) == ("heading", "INT. HALL - DAY")


@pytest.mark.parametrize(
    "line",
    ["INT. BAR - DAY", "INT BAR", "ext. beach", "EST. CITY", "INT./EXT. CAR", "INT/EXT CAR", "I/E CAR - NIGHT", ".BAR"],
)
def test_headings(line: str) -> None:
    assert kinds(parse(f"{line}\n\nSomething happens.")) == ["heading", "action"]


@pytest.mark.parametrize("line", ["Interior bar", "Internal affairs call.", "int bar", "...and then", "Ext bar"])
def test_not_headings(line: str) -> None:
    assert kinds(parse(f"{line}\n\nSomething happens.")) == ["action", "action"]


@pytest.mark.parametrize("line", ["CUT TO:", "SMASH CUT TO:", "FADE OUT.", "FADE IN:", "> anything at all"])
def test_transitions(line: str) -> None:
    assert kinds(parse(f"INT. A - DAY\n\n{line}\n\nHe runs.")) == ["heading", "transition", "action"]


@pytest.mark.parametrize(
    "cue",
    ["BOB", "MRS. PELL", "MAN #2", "O'NEIL-SMITH", "BOB (V.O.)", "BOB (cont'd)", "SAM JR.", "@bob", "R2D2", "SØREN ^"],
)
def test_cues(cue: str) -> None:
    assert kinds(parse(f"INT. A - DAY\n\n{cue}\nHello.")) == ["heading", "cue", "dialogue"]


@pytest.mark.parametrize(
    "line",
    ["BANG!", "CLOSE ON THE LETTER", "1987", "WHO KNOWS?", "!SCANNING", "THE DOOR SLAMS SHUT.", "他坐下，看着门。"],
)
def test_not_cues(line: str) -> None:
    assert kinds(parse(f"INT. A - DAY\n\n{line}\nHello.")) == ["heading", "action"]


def test_a_parenthetical_may_run_over_two_lines() -> None:
    _, _, aside, speech = parse("INT. A\n\nBOB\n(very, very\nquietly)\nHello.").elements
    assert (aside.kind, aside.text, speech.text) == ("parenthetical", "very, very\nquietly", "Hello.")


@pytest.mark.parametrize(
    ("written", "shown"),
    [
        ("*a*", "a"),
        ("**b** and ***c***", "b and c"),
        ("_d *e*_", "d e"),
        (r"\*f\*", "*f*"),
        ("2 * 3 * 4", "2 * 3 * 4"),
        ("snake_case_name", "snake_case_name"),
    ],
)
def test_emphasis(written: str, shown: str) -> None:
    assert strip_emphasis(written) == shown


@pytest.mark.parametrize(
    ("cue", "parts"),
    [
        ("ANN", ("ANN", "", False)),
        ("ANN (O.S.) (CONT’D) ^", ("ANN", "O.S.", True)),
        ("ANN (v.o.)", ("ANN", "V.O.", False)),
        ("ANN (V.O. CONT'D)", ("ANN", "V.O.", False)),
    ],
)
def test_split_cue(cue: str, parts: tuple[str, str, bool]) -> None:
    assert split_cue(cue) == parts


def test_lines_are_numbered_as_the_user_sees_them() -> None:
    heading = of_kind(parse(SAMPLE), "heading")[0]
    assert SAMPLE.split("\n")[heading.line - 1].startswith("INT. LIFT")


_PIECES = st.sampled_from(
    ["INT. A - DAY\n\n", "BOB\n", "(softly)\n", "Hi *there*.\n", "\n", "  \n", "[[n]]", "/* b */", "!x\n", "@y\n",
     ">z<\n", "===\n", "~la\n", "# s\n", "= p\n", ".H #1#\n", "> T\n", "^", "*", "_", "\\", "É", "李\n", "[[", "]]",
     "/*", "*/", "Title: x\n"]
)  # fmt: skip


@example("@/*\r  \rINT.*/", None)
@example("\x1b", None)
@given(st.one_of(st.text(), st.lists(_PIECES).map("".join)), st.sampled_from([None, "fountain", "prose"]))
def test_any_text_is_read_or_refused_and_spans_are_verbatim(text: str, form: str | None) -> None:
    try:
        screenplay = read(text, form)  # type: ignore[arg-type]
    except InputError:
        return
    end = 0
    for element in screenplay.elements:
        words = screenplay.text[element.start : element.end]
        assert end <= element.start < element.end
        assert words == words.strip()
        assert screenplay.text.count("\n", 0, element.start) + 1 == element.line
        if element.kind in ("action", "dialogue") and not set(words) & set("*_\\"):
            assert element.text == words
        end = element.end


def test_the_numbers_of_a_shooting_script_lead_its_headings() -> None:
    play = read("1 INT. HOUSE - DAY 1\n\nTom waits.\n\n12A. EXT. ROAD - DAY 2\n\nTom walks.\n\nCONTINUED: (2)\n\n7.\n")
    assert play.format == "fountain"
    headings = [element for element in play.elements if element.kind == "heading"]
    assert [(heading.text, heading.scene_number) for heading in headings] == [
        ("INT. HOUSE - DAY", "1"), ("EXT. ROAD - DAY 2", "12A"),
    ]  # fmt: skip
    assert all(play.text[heading.start : heading.end] == heading.text for heading in headings)
    assert [element.kind for element in play.elements][-2:] == ["page_break", "page_break"]


def test_a_number_before_prose_is_no_heading() -> None:
    assert read("12 exterior walls stood.\n\n3 interested men came.").format == "prose"


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        ("FLASHBACK - INT. LIVING ROOM - NIGHT (TEN YEARS EARLIER)", "heading"),
        ("INTERCUT: EXT. ROOF - DAY", "heading"),
        ("MONTAGE - ROCCO TRAINS", "section"),
        ("BEGIN TRAINING MONTAGE:", "section"),
        ("END MONTAGE", "section"),
        ("SERIES OF SHOTS", "section"),
        ("END FLASHBACK.", "section"),
        ("BACK TO PRESENT", "section"),
        ("END OF ACT ONE", "section"),
        ("TEASER", "section"),
        ("A FLASHBACK hits her.", "action"),
        ("The montage ends.", "action"),
    ],
)
def test_lines_that_divide_a_script(line: str, kind: str) -> None:
    screenplay = parse(f"INT. GYM - DAY\n\nRocco waits.\n\n{line}\n\nRocco runs.\n")
    element = next(element for element in screenplay.elements if element.text == line)
    assert element.kind == kind


def test_a_montage_may_list_its_shots_right_below() -> None:
    screenplay = parse("MONTAGE - ROCCO TRAINS\n-- Rocco runs.\n-- Rocco boxes.\n")
    assert [(element.kind, element.text) for element in screenplay.elements] == [
        ("section", "MONTAGE - ROCCO TRAINS"), ("action", "Rocco runs."), ("action", "Rocco boxes."),
    ]  # fmt: skip
    assert [element.kind for element in parse("INT. BED - DAY\n\nDREAM\nCome.\n").elements][1:] == ["cue", "dialogue"]
