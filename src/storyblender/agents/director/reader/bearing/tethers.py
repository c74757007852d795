"""Tethers: a dog on a leash, a child by the hand, a person bound to a chair."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.words import Word, joined
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.shot_context import Tether
from storyblender.memory.vocabulary import TetherKind

_LEADS: tuple[TetherKind, ...] = ("leash", "rope", "chain")
_HAND, _BOUND = lexicon.BEARING["hand_in_hand"], lexicon.BEARING["bound"]


@rule("bearing.tether")
def note_tethers(stage: Stage, words: Sequence[Word], people: Sequence[Person]) -> None:
    """Note who leads whom in a sentence, and what a person is tied to.

    Args:
        stage: Its unit takes the tethers.
        words: The sentence.
        people: The people of the sentence.
    """
    text = joined(list(words))
    named = [person for word in words if word.mention for person in word.mention.people]
    others = [person for person in dict.fromkeys([p.id for p in named]) if people and person != people[0].id]
    animals = [person for person in named if person.kind == "animal"]
    for kind in _LEADS:
        holder = next((person for person in [*people, *named] if person.kind == "human"), None)
        if animals and holder and lexicon.BEARING[kind].search(text):
            _add(stage, holder.id, animals[-1].id, kind)
            return
    if _HAND.search(text) and people:
        together = [person.id for person in people[1:2]] or others
        if together:
            _add(stage, people[0].id, together[0], "hand")
    bound = _BOUND.search(text)
    if bound and people:
        anchor = next(
            (thing for at, thing in stage.sentence.things if words[at].start >= _offset(words, text, bound)), None
        )
        if anchor:
            _add(
                stage, anchor, people[0].id, "chain" if "cuff" in bound.group() or "chain" in bound.group() else "rope"
            )


def _offset(words: Sequence[Word], text: str, match: re.Match[str]) -> int:
    """Return the script offset of the first word after a match in the joined words."""
    count = text[: match.end()].count(" ")
    written = [word for word in words if not word.inserted]
    return written[min(count, len(written) - 1)].start


def _add(stage: Stage, holder: str, held: str, kind: TetherKind) -> None:
    tether = Tether(holder=holder, held=held, kind=kind)
    if holder != held and tether not in stage.unit.tethers:
        stage.unit.tethers.append(tether)
