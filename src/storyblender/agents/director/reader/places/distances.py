"""People side by side: ``shoulder to shoulder``."""

from __future__ import annotations

from itertools import pairwise

from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_SIDES = frozenset({"side", "shoulder", "elbow", "hip", "cheek", "knee"})


@rule("relations.side_by_side")
def relate_side_by_side(stage: Stage, words: list[Word], subjects: list[Person]) -> None:
    """``They sit side by side``, ``stand shoulder to shoulder``: each next to the one named before.

    Args:
        stage: The state after the clauses.
        words: The sentence as it is written.
        subjects: Of the sentence.
    """
    low = [word.low for word in words]
    if any(low[i] == low[i + 2] in _SIDES and low[i + 1] in ("by", "to") for i in range(len(low) - 2)):
        for before, person in pairwise(subjects):
            stage.relate(before.id, "next_to", person.id)
