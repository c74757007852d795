"""Dawn and dusk are over at the next place, if it tells no hour; any other hour stays."""

import pytest

from storyblender.agents.director.reader import read_script
from storyblender.screenplay.source import read


@pytest.mark.parametrize(
    ("first", "second", "hour"),
    [
        ("EXT. HILL - DAWN", "INT. KITCHEN", "morning"),
        ("EXT. STREET - DUSK", "INT. KITCHEN", "evening"),
        ("EXT. STREET - DUSK", "EXT. STREET", "dusk"),
        ("EXT. STREET - DUSK", "INT. KITCHEN - CONTINUOUS", "dusk"),
        ("EXT. STREET - NIGHT", "INT. KITCHEN", "night"),
        ("EXT. HILL - DAWN", "INT. KITCHEN - DUSK", "dusk"),
    ],
)
def test_an_untold_hour_follows_the_one_before(first: str, second: str, hour: str) -> None:
    reading = read_script(read(f"{first}\n\nADA waits.\n\n{second}\n\nADA waits.\n"))
    assert [scene.time for scene in reading.scenes][-1] == hour
