"""Letters of any script on the board: none is left out, lines hold, and what is read from the right begins there."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.deliver.fonts import font_file, in_regular
from storyblender.deliver.lettering import Lettering, draw_lines, font_of, lines_of, words_of

INK = "#1b1b1f"


@pytest.mark.parametrize(
    ("letter", "font"),
    [("A", "NotoSans["), ("Ж", "NotoSans["), ("雨", "CJK"), ("の", "CJK"), ("한", "CJK"), ("ل", "Arabic"),
     ("ש", "Hebrew"), ("ก", "Thai"), ("த", "Tamil"), ("ა", "Georgian"), ("😀", "Emoji"), ("∞", "Math")],
)  # fmt: skip
def test_every_script_has_its_font(letter: str, font: str) -> None:
    assert font in font_of(letter).name
    assert in_regular(letter) == (font == "NotoSans[")
    missing = draw_lines([[*words_of("\ue0ff", INK)]], 2)
    assert font_of("\ue0ff") == font_file() and draw_lines([[*words_of(letter, INK)]], 2).tobytes() != missing.tobytes()


def test_lines_hold_no_more_than_their_width() -> None:
    words = list(words_of("雨の夜、電車が遅れた。 BAR だ", INK))
    lines = lines_of(words, 4)
    assert [word for line in lines for word in line] == words and len(lines) > 2
    assert all(sum(word.width for word in line) <= 4 for line in lines)
    assert not any(line[0].text[0] in "、。" for line in lines)
    assert lines_of([], 4) == []


def test_a_full_stop_stays_with_its_word_and_letters_without_spaces_stand_close() -> None:
    assert [word.text for word in words_of("العمل. OK!", INK)] == ["العمل.", "OK!"]
    close, apart = (draw_lines([[*words_of(text, INK)]], 6).convert("L") for text in ("花子", "花 子"))
    assert np.flatnonzero((np.asarray(close) < 128).any(axis=0)).max() <= 2 * 48
    assert np.flatnonzero((np.asarray(apart) < 128).any(axis=0)).max() > 2 * 48


def test_what_is_read_from_the_right_begins_there() -> None:
    ink = {text: np.asarray(draw_lines([[*words_of(text, INK)]], 12).convert("L")) < 128 for text in ("ليلى أين", "雨")}
    right = np.flatnonzero(ink["ليلى أين"].any(axis=0))
    assert right.max() > 11 * 48 and right.min() > 6 * 48
    assert np.flatnonzero(ink["雨"].any(axis=0)).max() < 2 * 48


def test_a_paragraph_is_cut_to_the_room_there_is() -> None:
    paragraph = Lettering([("花子", "#6d6d76"), ("遅かったね。" * 20, INK)], size=10, indent=5)
    _, height = paragraph.wrap(100, 400)
    assert height > 60 and paragraph.split(100, 30) == [paragraph]
    assert paragraph.wrap(100, 30)[1] <= 30 and not paragraph.split(100, 5)
