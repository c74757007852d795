"""Where pages play: headings in any shape, places set down in the text, two places cut together, asides."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.places_by_meaning import choose_kits_by_meaning
from storyblender.agents.director.reader.page.named_places import place_without_verb
from storyblender.agents.director.reader.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read


def page(text: str) -> Reading:
    return read_script(read(text))


def places(reading: Reading) -> list[tuple[str, str]]:
    return [(scene.place, scene.scene_type) for scene in reading.scenes]


@pytest.mark.parametrize(
    ("heading", "place", "side", "time"),
    [
        ("INT. MILL - NIGHT", "mill", "indoor", "night"),
        ("INNEN – KÜCHE ROSA – FRÜHER MORGEN", "küche rosa", "indoor", "morning"),
        ("AUSSEN – HOF – ABEND", "hof", "outdoor", "evening"),
        ("INTERIOR. COCINA. NOCHE", "cocina", "indoor", "night"),
        ("EXT. PUERTO - MADRUGADA", "puerto", "outdoor", "dawn"),
        ("INT. CUISINE - NUIT", "cuisine", "indoor", "night"),
        ("EXT. FIELD - EVENING - HEAVY FOG", "field", "outdoor", "evening"),
        ("EXT. FIELD. EVENING. WINTER", "field", "outdoor", "evening"),
        ("INT. BARN.NIGHT", "barn", "indoor", "night"),
        ("INT. MILL - GOLDEN HOUR", "mill", "indoor", "sunset"),
        ("INT. MILL - 9:45 PM", "mill", "indoor", "night"),
        ("INT. LIFT - MOVING - CONTINUOUS", "lift", "indoor", "day"),
    ],
)
def test_a_heading_tells_place_side_and_hour(heading: str, place: str, side: str, time: str) -> None:
    scene = page(f"{heading}\n\nROOK (40) sits.\n\nROOK\nWell.\n").scenes[0]
    assert (scene.place, scene.scene_type, scene.time) == (place, side, time)


def test_a_heading_that_goes_on_in_a_place_finds_it_again() -> None:
    reading = page(
        "EXT. GULL BAY POOL - DAY\n\nROOK swims.\n\nEXT. POOL - LADDER - CONTINUOUS\n\nRook climbs.\n\n"
        "INT. MILL - ATTIC - NIGHT\n\nRook sleeps.\n\nINT. MILL - KITCHEN - NIGHT\n\nRook eats.\n\n"
        "EXT. POOL - DAWN\n\nEmpty.\n"
    )
    assert [scene.reference for scene in reading.scenes] == [None, 1, None, None, 1]


def test_words_before_the_first_heading_belong_to_its_scene() -> None:
    reading = page('FADE IN:\n\nBlack. A drip.\n\nSUPER: "May"\n\nEXT. MILL - DAY\n\nROOK walks in.\n')
    assert places(reading) == [("mill", "outdoor")]
    assert [unit.kind for unit in reading.units].count("title") == 1


@pytest.mark.parametrize(
    ("text", "place", "side"),
    [
        ("Inside, the lamp room. Rook polishes.", "lamp room", "indoor"),
        ("Kitchen, dark. Rook at the stove.", "kitchen", "indoor"),
        ("A beach, low tide.", "beach", "outdoor"),
        ("Rook's garden. Wren digs.", "rook's garden", "outdoor"),
        ("Wide shot of the corridor.", "corridor", "indoor"),
        ("Bottom of the hill. A sheep.", "hill", "outdoor"),
    ],
)
def test_a_fragment_sets_down_a_place(text: str, place: str, side: str) -> None:
    told = place_without_verb(text)
    assert told is not None
    assert (told.place, told.scene_type) == (place, side)


@pytest.mark.parametrize(
    "text", ["Rook opens the kitchen door.", "The stage is set.", "A red lamp on the wall.", "Rook, tired."]
)
def test_a_sentence_about_something_else_sets_down_none(text: str) -> None:
    assert place_without_verb(text) is None


def test_a_picture_of_somebody_goes_back_to_where_they_were() -> None:
    reading = page(
        "PAGE ONE\n\nPanel 1. Kitchen. ROOK cooks.\n\nROOK: Soup.\n\nPanel 2. A beach. WREN digs.\n\nWREN: Sand.\n\n"
        "Panel 3. ROOK tastes it.\n\nROOK: Salt.\n"
    )
    assert places(reading) == [("kitchen", "indoor"), ("beach", "outdoor"), ("kitchen", "indoor")]
    assert reading.scenes[2].reference == 1


def test_each_panel_is_one_shot() -> None:
    reading = page(
        "PAGE ONE\n\nPanel 1. Kitchen. ROOK cooks. He tastes the soup. WREN runs in.\n\nROOK: Soup.\n\nWREN: Again?\n\n"
        "Panel 2. ROOK drops the spoon.\n\nSFX: CLANG\n"
    )
    assert sum(len(scene.shots) for scene in storyboard(reading).storyboard_outline) == 2


def test_an_intercut_puts_each_end_in_its_own_place() -> None:
    reading = page(
        "INT. OFFICE - DAY\n\nROOK (40) types. WREN (30) waits.\n\nROOK\nHello?\n\nINTERCUT - OFFICE / STABLE\n\n"
        "IN THE STABLE: FINCH (50) holds a telephone.\n\nFINCH\nYes?\n\nROOK\nNo.\n"
    )
    spoken = {unit.text: reading.scenes[unit.scene].place for unit in reading.units if unit.kind == "dialogue"}
    assert spoken == {"Hello?": "office", "Yes?": "stable", "No.": "office"}
    assert reading.scenes[-1].reference == 1


def test_what_is_said_to_the_reader_gets_no_shot_of_its_own() -> None:
    reading = page("INT. MILL - DAY\n\nROOK lifts a sack. Oof. Wrong answer. He drops it.\n")
    assert [unit.kind for unit in reading.units] == ["action", "aside", "aside", "action"]
    shots = storyboard(reading).storyboard_outline[0].shots
    assert all(any(line.text.strip(" .") not in ("Oof", "Wrong answer") for line in shot.lines) for shot in shots)


class _Likes:
    """An embedder for which some words mean the same."""

    def __init__(self, *same: str) -> None:
        self.same = same
        self.asked = 0

    def embed(self, texts: list[str]) -> np.ndarray:
        self.asked += 1
        rows = [[1.0, 0.0] if any(word in text.lower() for word in self.same) else [0.0, 1.0] for text in texts]
        return np.array(rows, np.float32)


def test_a_place_that_no_list_knows_gets_the_set_it_is_like_and_a_flag() -> None:
    reading = page("INT. ZORBARIUM - DAY\n\nROOK waits.\n")
    embedder = _Likes("zorbarium", "greenhouse")
    choose_kits_by_meaning(reading, lambda: embedder)
    assert reading.scenes[0].place_kind == "greenhouse"
    assert [flag.choice for flag in reading.flags if flag.topic == "place"] == ["greenhouse"]


def test_a_known_place_asks_nobody() -> None:
    embedder = _Likes("kitchen")
    choose_kits_by_meaning(page("INT. KITCHEN - DAY\n\nROOK waits.\n"), lambda: embedder)
    assert embedder.asked == 0
