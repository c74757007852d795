"""How things are carried (under an arm, in both hands), and tethers: a dog on a leash, a child by the hand."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.deeds.outcomes import hold
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.words import Word, joined
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.shot_context import Tether
from storyblender.memory.vocabulary import Grip, TetherKind

_GRIPS: tuple[tuple[Grip, re.Pattern[str]], ...] = (
    ("under_arm", lexicon.BEARING["grip_under_arm"]),
    ("both", lexicon.BEARING["grip_both"]),
    ("left", lexicon.BEARING["grip_left"]),
    ("right", lexicon.BEARING["grip_right"]),
    ("lap", lexicon.BEARING["grip_lap"]),
    ("shoulder", lexicon.BEARING["grip_shoulder"]),
    ("mouth", lexicon.BEARING["grip_mouth"]),
    ("right", lexicon.BEARING["grip_hand"]),
)
_NOT_IN_HAND = lexicon.words("food") | lexicon.PARTS | lexicon.VEHICLES | lexicon.LIQUIDS
_REACH = 7
"""Words after a thing within which its place on the body is looked for."""
_HAVING = lexicon.words("having")


@rule("bearing.grip")
def note_grips(state: ReaderState, words: Sequence[Word], people: Sequence[Person]) -> None:
    """Note how the things of a sentence are carried, and that they are in hand.

    Args:
        state: Its unit takes the grips.
        words: The sentence.
        people: The people of the sentence.
    """
    if not people or state.sentence.pictured:
        return
    for index, thing in state.sentence.things:
        if state.inventory.class_of(thing) not in ("prop", "unknown", "worn") or index >= len(words):
            continue
        told = " ".join(word.low for word in words[index + 1 : index + 1 + _REACH] if not word.inserted)
        after: Grip | None = next((grip for grip, pattern in _GRIPS if pattern.match(told)), None)
        grip: Grip | None = after or _grip_before(words, index)
        if grip is None or state.inventory.class_of(thing) == "worn":
            continue
        bearer = _bearer(state, words, index, people)
        state.inventory.note(thing, "handled", determined=True)
        hold(state, bearer.id, thing)
        if grip != "right" or "right" in told:
            state.unit.grips.setdefault(bearer.id, {})[thing] = grip


@rule("things.had")
def note_possession(state: ReaderState, clause: Clause, roles: Roles) -> None:
    """Put a prop that a person has into their hand: ``The kid has a pistol``.

    Args:
        state: The state before the clause.
        clause: A clause that is neither negated nor hypothetical.
        roles: The people and things of the clause.
    """
    if clause.verb != "have" or len(roles.subjects) != 1 or clause.earlier:
        return
    apart = any(place.preposition not in ("in", "with") or place.things for place in roles.places)
    if apart or state.sentence.pictured or roles.subjects[0].kind == "animal":
        return
    for thing in roles.things:
        if state.inventory.class_of(thing) == "prop" and state.inventory.head(thing) not in _NOT_IN_HAND:
            state.inventory.note(thing, "handled", determined=True)
            hold(state, roles.subjects[0].id, thing)


def _grip_before(words: Sequence[Word], index: int) -> Grip | None:
    """Return the grip told before a thing: ``holds in his lap a birdcage``, ``in each hand a bucket``."""
    told = " ".join(word.low for word in words[max(0, index - _REACH) : index] if not word.inserted)
    for grip, pattern in _GRIPS:
        place = re.search(
            pattern.pattern.replace("^", r"(?:^|\s)", 1) + r"(?: [a-z]+)* (?:an?|the|his|her) (?:[a-z-]+ )?$", told
        )
        if place and ("in " in place.group() or "under" in place.group() or "on " in place.group()):
            return grip if any(word.low in _HAVING for word in words[:index]) else None
    return None


def _bearer(state: ReaderState, words: Sequence[Word], index: int, people: Sequence[Person]) -> Person:
    """Return the last person named before a thing, else the first person of the sentence."""
    for word in reversed(words[:index]):
        named = [person for person in (word.mention.people if word.mention else []) if person.id in state.scene.on]
        if named:
            return named[0]
    return people[0]


_LEADS: tuple[TetherKind, ...] = ("leash", "rope", "chain")
_HAND, _BOUND = lexicon.BEARING["hand_in_hand"], lexicon.BEARING["bound"]


@rule("bearing.tether")
def note_tethers(state: ReaderState, words: Sequence[Word], people: Sequence[Person]) -> None:
    """Note who leads whom in a sentence, and what a person is tied to.

    Args:
        state: Its unit takes the tethers.
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
            _add_tether(state, holder.id, animals[-1].id, kind)
            return
    if _HAND.search(text) and people:
        together = [person.id for person in people[1:2]] or others
        if together:
            _add_tether(state, people[0].id, together[0], "hand")
    bound = _BOUND.search(text)
    if bound and people:
        anchor = next(
            (thing for at, thing in state.sentence.things if words[at].start >= _offset(words, text, bound)), None
        )
        if anchor:
            _add_tether(
                state, anchor, people[0].id, "chain" if "cuff" in bound.group() or "chain" in bound.group() else "rope"
            )


def _offset(words: Sequence[Word], text: str, match: re.Match[str]) -> int:
    """Return the script offset of the first word after a match in the joined words."""
    count = text[: match.end()].count(" ")
    written = [word for word in words if not word.inserted]
    return written[min(count, len(written) - 1)].start


def _add_tether(state: ReaderState, holder: str, held: str, kind: TetherKind) -> None:
    """Add a tether to the unit once."""
    tether = Tether(holder=holder, held=held, kind=kind)
    if holder != held and tether not in state.unit.tethers:
        state.unit.tethers.append(tether)
