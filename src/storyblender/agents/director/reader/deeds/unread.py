"""Actions without a motion in the vocabulary: their words are kept and flagged, and the nearest motion is shown."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.state import ReaderState, UnreadAct
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.catalog.motions import MOTION_KEYS, MOTIONS

_INWARD = (
    lexicon.SILENT_VERBS
    | lexicon.FACE_VERBS
    | lexicon.words("copulas")
    | frozenset(
        {"be", "have", "do", "can", "own", "cost", "contain", "deserve", "suit", "fit", "matter", "happen", "seem"}
    )
    | frozenset(
        {"find", "feel", "guess", "hope", "expect", "realise", "recall", "miss", "prefer", "trust", "fail", "manage"}
    )
    | frozenset(
        {
            "live",
            "wear",
            "exist",
            "resemble",
            "represent",
            "signify",
            "dread",
            "fear",
            "envy",
            "owe",
            "wonder",
            "intend",
        }
    )
)
"""Verbs of acts that cannot be seen."""
_VOICES = frozenset({"talk", "whisper", "shout", "think"})
_WORDS = 9
"""Most words of an act repeated in a flag."""


@rule("deeds.nearest_motion")
def nearest_motion(clause: Clause, roles: Roles) -> str | None:
    """Return the motion that looks most like a verb without its own, or None if no motion is near.

    Args:
        clause: A clause with a person as subject.
        roles: The people and things of the clause.
    """
    if not roles.subjects or clause.verb in _INWARD or clause.passive or clause.infinitive:
        return None
    if clause.verb in lexicon.MOTION_OF_VERB:
        return None  # it has a motion, which does not fit here: lowers his voice
    pair = lexicon.NEAR_MOTIONS.get(f"{clause.verb} {clause.particle}") if clause.particle else None
    return pair or lexicon.NEAR_MOTIONS.get(clause.verb)


def note_unread(state: ReaderState, clause: Clause, roles: Roles, shown: str | None) -> None:
    """Flag an action that has no motion of its own, unless it cannot be seen.

    Args:
        state: Its unit takes the flag.
        clause: A clause that is neither negated nor hypothetical, with a person as subject.
        roles: The people and things of the clause.
        shown: The motion played instead, if one is near.
    """
    spoken = clause.verb in lexicon.SPEECH_VERBS or lexicon.MOTION_OF_VERB.get(clause.verb) in _VOICES
    unseen = clause.verb in _INWARD or clause.passive or clause.earlier or spoken
    if not roles.subjects or unseen or state.sentence.pictured:
        return
    end = min(clause.index + _WORDS, len(state.sentence.words))
    following = state.sentence.words[clause.index : end]
    stop_at = next((at for at, word in enumerate(following) if at and word.text in ",;:"), len(following))
    written = [word for word in following[:stop_at] if not word.inserted]
    if not written:
        return
    start, stop = written[0].start, max(word.end for word in written)
    words = " ".join(state.reading.screenplay.text[start:stop].split()).rstrip(" .,;")
    who = _names(roles.subjects)
    reason = f"the library has no motion for “{words}” ({who}): "
    reason += f"shown as “{MOTIONS[MOTION_KEYS[shown]].name}”" if shown else "not shown"
    state.unread.append(UnreadAct(roles.subjects[0].id, shown or "", reason, start, stop))


def flag_unread(state: ReaderState) -> None:
    """Write the flags of the last sentence's unread actions, for people with no other deed or a nearest motion."""
    for act in state.unread:
        if act.shown or not any(deed.actor == act.person for deed in state.unit.deeds):
            state.flag("act", act.shown or "none", act.reason, act.start, act.end)
    state.unread.clear()


def _names(people: list[Person]) -> str:
    """Return the names of people, for a flag."""
    return " and ".join(person.name for person in people[:2])
