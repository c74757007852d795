"""What is written on a thing is read from the words after its name, and nothing else is taken for it."""

from __future__ import annotations

import pytest

from storyblender.agents.director.writing import writing_on


@pytest.mark.parametrize(
    ("text", "name", "words"),
    [
        ('A hand-painted sign reads "NO FISHING".', "sign", "NO FISHING"),
        ("A cardboard box marked FRAGILE stands by the door.", "box", "FRAGILE"),
        ("A neon sign: MOTEL. It flickers.", "sign", "MOTEL"),
        ("She opens the letter. It is long.", "letter", ""),
        ("He puts the book on the table. NORA comes in.", "book", ""),
        ("The note says “Gone to the shops”, no more.", "note", "Gone to the shops"),
        ("He reads the paper. The dog barks.", "paper", ""),
    ],
)
def test_the_words_on_a_thing(text: str, name: str, words: str) -> None:
    assert writing_on(name, text.find(name), text) == words
