"""Puts the verbs of a sentence into clauses: whose they are, and whether what they tell happens."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clause import Clause, ClauseBuilder
from storyblender.agents.director.reader.language.morphology import VerbForm
from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase
from storyblender.agents.director.reader.language.tagging import PERCEIVING

_RESTING = lexicon.words("stative") - {"be"}
_ARRIVED = lexicon.words("arrived")
"""``has fallen asleep``, ``had come in``: what a person has done shows still."""
_ENDINGS = frozenset({"stop", "quit", "avoid", "consider", "finish", "suggest", "imagine"})
_GAZING = frozenset({"look", "stare", "gaze", "glance", "peer"})
"""``looks at the dust rising``: it is the dust that rises."""
_PURPOSES = frozenset({"see", "find", "get", "hear"})
_DISCOVERING = frozenset({"open", "turn", "look", "wake", "return", "enter"})
"""``opens the door to find Otto``: he is there."""
_WISHES = frozenset(
    {"want", "need", "refuse", "hope", "decide", "wait", "hesitate", "fail", "intend", "plan", "long", "threaten"}
    | {"promise", "offer", "agree", "expect", "mean", "forget", "prepare", "wish", "dare", "choose"}
)
_ORDERS = lexicon.words("ordering")


def take_verb(builder: ClauseBuilder, index: int, phrase: Phrase) -> None:
    """Open a clause with a verb, unless it only helps the next verb or tells how a person rests.

    Args:
        builder: The clauses so far; changed in place.
        index: Index of the verb's phrase.
        phrase: The verb's phrase.
    """
    verb = phrase.verb or VerbForm(phrase.text, "past")
    following = builder.phrases[index + 1] if index + 1 < len(builder.phrases) else None
    if verb.kind == "aux" and following and following.kind in ("verb", "negation"):
        past = following.verb if following.verb and following.verb.kind in ("past", "pp") else None
        builder.passive = past is not None and verb.lemma == "be"
        has = verb.lemma == "have" and following.verb is not None
        builder.perfect = has and past is not None and past.lemma in _ARRIVED
        builder.earlier = builder.earlier or (has and not builder.perfect)
        return
    left = builder.phrases[index - 1] if index else None
    rested = builder.current is not None and builder.current.verb in _RESTING
    if rested and left and left.kind == "verb" and (verb.kind == "pp" or (verb.kind == "past" and not builder.pending)):
        return  # sits hunched, sat propped against the wall
    if builder.outer and not builder.pending and left and left.text == ",":
        builder.subject, builder.outer = builder.outer, []
    if builder.pending and builder.clauses and builder.inserted:
        builder.outer = builder.subject
    participle = verb.kind in ("ing", "inf")
    clause = Clause(
        phrase.first,
        builder.words[phrase.first].start,
        verb.lemma,
        subject=_subject(builder, index, verb),
        participle=participle,
        infinitive=verb.kind == "inf",
        passive=(verb.kind == "pp" and not builder.perfect) or builder.passive,
        negated=builder.negated,
        earlier=builder.earlier,
        unreal=builder.unreal or _is_unreal(builder, index),
        main=not builder.clauses or not participle,
    )
    builder.negated = builder.unreal = builder.passive = builder.perfect = builder.earlier = False
    if builder.relative and not builder.pending:
        clause.subject = builder.relative
        clause.main = not builder.clauses
        builder.relative = builder.relative if participle else []
        builder.preposition, builder.aside, builder.closed = "", False, False
        builder.clauses.append(clause)
        return
    if builder.fronted is not None:
        clause.subject, clause.places = builder.pending, builder.fronted
        clause.opening, builder.fronted = len(builder.fronted), None
    clause.elided = not clause.subject
    clause.absolute = bool(builder.pending) and (participle or verb.kind == "pp") and len(builder.clauses) > 0
    if builder.pending and verb.kind not in ("ing", "inf") and not clause.absolute:
        builder.subject = builder.pending
    elif builder.current and not clause.opening and not clause.subject and not builder.current.absolute:
        clause.subject = builder.current.subject
    builder.pending, builder.preposition, builder.aside, builder.closed = [], "", False, False
    builder.clauses.append(clause)


def _subject(builder: ClauseBuilder, index: int, verb: VerbForm) -> list[NounPhrase]:
    """Return the subjects of a verb: the noun before it, who is seen doing it, or those of the clauses before."""
    before = builder.current
    if before and verb.kind == "inf":
        if before.infinitive:
            return before.subject
        return list(before.object) or list(builder.subject)
    left = builder.phrases[index - 1] if index else None
    touches = left is not None and left.kind == "noun" and left.noun is not None
    if before and verb.kind == "ing" and touches and before.verb in PERCEIVING and before.object and not before.places:
        return list(before.object)
    seen = before is not None and before.verb in _GAZING and bool(before.places) and left is not None
    if before and seen and left and left.noun and verb.kind == "ing" and left.noun in before.places[-1][1]:
        return [left.noun]
    if before and left and left.noun and not builder.pending and _describes(left.noun, verb):
        return [left.noun]
    return list(builder.pending or builder.subject)


def _describes(noun: NounPhrase, verb: VerbForm) -> bool:
    """Whether a verb describes the noun before it: ``grabs the gun lying there``."""
    resting = verb.kind == "ing" and verb.lemma in _RESTING
    return noun.kind != "pronoun" and (resting or (verb.kind == "pp" and noun.kind == "thing"))


def _is_unreal(builder: ClauseBuilder, index: int) -> bool:
    """Whether a verb does not happen: ``without looking``, ``wants to leave``, ``stops mopping``."""
    left = builder.phrases[index - 1] if index else None
    if left is None:
        return False
    before = builder.current
    if before is not None and left.kind == "verb" and before.verb in _ENDINGS and before.index == left.first:
        return True
    if before is not None and left.kind == "verb" and before.index == left.first and (before.negated or before.unreal):
        return True
    if left.kind != "preposition":
        return False
    if left.text == "without" or (left.text == "to" and before and _is_wished(before)):
        return True
    if left.text == "to" and index > 1 and builder.phrases[index - 2].text == "about":
        return True
    seeing = before is not None and before.verb in _DISCOVERING and bool(before.object or before.particle)
    return left.text == "to" and not seeing and builder.words[builder.phrases[index].first].low in _PURPOSES


def _is_wished(before: Clause) -> bool:
    """Whether a clause only wishes the next verb: ``wants to leave``, ``tells Ben to sit``."""
    return before.verb in _WISHES or before.verb in _ORDERS or before.negated or before.unreal
