"""Only the story's own words tell when it plays."""

from __future__ import annotations

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reader.era import age_in_words
from storyblender.screenplay.source import read

_TODAY = "INT. KITCHEN - DAY\n\nANNA (30) makes coffee.\n\nANNA\nMorning.\n"
_TITLE_PAGE = """Title: The Visit
Credit: Written by
Author: Ann Knight
Draft date: 12/3/1512
Copyright: 1066 King & Castle Ltd
Contact:
    1408 Queen Street
    Throne Hall 1234, Peasants' Corner

"""
_FDX_TITLE_PAGE = """<TitlePage><Content><Paragraph><Text>The Visit</Text></Paragraph>
<Paragraph><Text>by</Text></Paragraph>
<Paragraph><Text>Ann</Text></Paragraph><Paragraph><Text>1234 Castle Street</Text></Paragraph></Content></TitlePage>"""


def _clothes(text: str) -> set[str]:
    assets = storyboard(read_script(read(text))).asset_sheet
    return {garment.key for asset in assets if asset.look for garment in asset.look.garments}


@pytest.mark.parametrize(
    "script",
    [
        _TITLE_PAGE + _TODAY,
        '<?xml version="1.0"?><FinalDraft><Content><Paragraph Type="Scene Heading"><Text>INT. KITCHEN - DAY</Text>'
        '</Paragraph><Paragraph Type="Action"><Text>ANNA (30) makes coffee.</Text></Paragraph></Content>'
        f"{_FDX_TITLE_PAGE}</FinalDraft>",
        f"[[reshoot 1512, page 1234]]\n\n{_TODAY}",
        _TODAY.replace("KITCHEN", "HOTEL ROOM 1408"),
        _TODAY.replace("makes coffee.", "counts 1500 dollars."),
        _TODAY.replace("Morning.", "Nobody wrote like that since 1492."),
    ],
)
def test_numbers_around_a_story_dress_nobody(script: str) -> None:
    assert _clothes(script) == _clothes(_TODAY)


@pytest.mark.parametrize(
    "script",
    [
        _TODAY.replace("KITCHEN - DAY", "KITCHEN - DAY - 1415"),
        _TODAY.replace("ANNA (30)", 'SUPER: "AGINCOURT, 1415"\n\nANNA (30)'),
        _TODAY.replace("ANNA (30)", "It is the summer of 1415. ANNA (30)"),
        _TODAY.replace("Morning.", "Wake up, it's 1415!"),
    ],
)
def test_the_year_that_the_story_tells_dresses_its_people(script: str) -> None:
    assert "gown" in _clothes(script)


@pytest.mark.parametrize(
    ("story", "age"),
    [
        ("A western saloon, 1880. The sheriff walks in.", "west"),
        ("INT. CASTLE HALL. The king sits on his throne. A knight kneels.", "medieval"),
        ("The bridge of a spaceship.", "space"),
        ("London, 1941.", "classic"),
        ("Lisbon, 2019.", "today"),
        ("She opens her laptop.", "today"),
        ("A drone flies over the roof. He pulls up his hoodie.", "today"),
        ("The app was an apple.", None),
        ("A video of a king.", None),
        ("A governess opens the parlour door; the carriage waits.", "victorian"),
        ("The Sheriff parks his car. Burger King is closed.", None),
        ("He pours a whiskey at the bar. A picture of a castle hangs over the counter.", None),
    ],
)
def test_the_words_of_a_story_tell_its_age(story: str, age: str | None) -> None:
    assert age_in_words(story) == age
