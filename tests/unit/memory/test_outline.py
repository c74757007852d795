"""Words of a script line are counted in one way, in every script of the world."""

from __future__ import annotations

import pytest

from storyblender.memory.outline import ScriptLine, SourceSpan


@pytest.mark.parametrize(
    ("text", "words"),
    [("Don't go there, man-child.", 4), ("", 0), ("李走进房间。", 3), ("a b c", 3), ("No -- wait…", 2)],
)
def test_word_count(text: str, words: int) -> None:
    assert ScriptLine(kind="dialogue", text=text, span=SourceSpan(start=0, end=0)).word_count == words
