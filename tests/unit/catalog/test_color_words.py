"""Words for colours."""

from __future__ import annotations

import pytest

from storyblender.catalog.color_words import color_word
from storyblender.catalog.materials import hex_color


@pytest.mark.parametrize(
    ("code", "word"),
    [
        ("#000000", "black"), ("#ffffff", "white"), ("#5c1626", "dark red"), ("#1d2a47", "navy"), ("#2d5183", "blue"),
        ("#3f6b48", "green"), ("#5a402c", "brown"), ("#d4ac38", "yellow"), ("#7c7f84", "grey"), ("#c2b08f", "beige"),
    ],
)  # fmt: skip
def test_a_colour_is_called_what_people_call_it(code: str, word: str):
    assert color_word(hex_color(code)) == word
