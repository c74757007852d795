"""Chooses the motion of a clause: its verb, corrected by its particle, object and prepositions (notes, 4.1)."""

from __future__ import annotations

from dataclasses import dataclass

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.phrases import NounPhrase

_GARMENTS = lexicon.WORN | {"ring"}
_LIGHT = lexicon.words("light_verbs")
"""``gives a shrug``, ``casts a glance``: the noun tells the motion."""
_NOT_GOING = frozenset(verb.split(" ")[0] for verb in lexicon.MOTION_OF_VERB) | lexicon.words("not_going")
_COPULAS = lexicon.words("copulas")
_AWAY = frozenset({"in", "out", "past", "away", "off", "by", "along"})
_ALONG = frozenset({"into", "out_of", "past", "across", "along", "toward", "towards"})
_SUPINE = frozenset({"sit", "lie", "kneel", "crouch", "crawl"})
"""Postures from which ``She stands.`` is getting up."""


@dataclass(frozen=True)
class Doing:
    """What decides the motion of a clause."""

    particle: str
    object: str
    """Head noun of the object, ``person``, or empty."""
    prepositions: frozenset[str]
    nouns: frozenset[str]
    """Head nouns after prepositions."""


def motion_of(clause: Clause, object_head: str, posture: str) -> str | None:
    """Return the motion that a clause tells of its subject, or None where the body does nothing.

    Args:
        clause: An active clause with a person as its subject.
        object_head: Head noun of what it is done to, ``person``, ``self``, or empty.
        posture: Posture of the subject before.
    """
    prepositions = frozenset(preposition.replace(" ", "_") for preposition, _ in clause.places)
    if clause.recipient:
        prepositions |= {"to"}
    nouns = frozenset(noun.head for _, nouns in clause.places for noun in nouns)
    if any(noun.kind != "thing" and noun.head != "it" for _, nouns in clause.places for noun in nouns):
        nouns |= {"person"}
    doing = Doing(clause.particle, object_head, prepositions, nouns)
    if clause.verb == "leave" and not clause.places and object_head in lexicon.PROPS:
        return None  # leaves the pen where it is
    for rule in lexicon.OVERRIDES.get(clause.verb, ()):
        if _applies(rule, doing):
            return None if rule.motion == "none" else rule.motion
    if clause.verb in lexicon.SILENT_VERBS:
        return None
    noun = lexicon.MOTION_OF_VERB.get(object_head)
    taken = clause.verb == "take" and "from" in prepositions  # a coil of rope from a nail
    if (
        noun
        and clause.verb in _LIGHT
        and not taken
        and _is_deed(clause.object[-1])
        and clause.object[-1].head == object_head
    ):
        return noun
    if clause.verb in _COPULAS - {"stand"} and clause.object and _is_quality(clause.object[0]):
        return None
    if clause.verb == "stand":
        rises = clause.particle == "up" or (posture in _SUPINE and not clause.places and not clause.participle)
        return "stand_up" if rises else "stand"
    known = lexicon.MOTION_OF_VERB.get(f"{clause.verb} {clause.particle}") if clause.particle else None
    return known or lexicon.MOTION_OF_VERB.get(clause.verb) or _going(clause, doing)


def _is_deed(noun: NounPhrase) -> bool:
    """Whether a noun is an action and no thing: ``a swig``, ``chase``."""
    single = not noun.plural and noun.determiner in ("", "a", "an", "one", "another")
    return single and noun.possessor is None and lexicon.noun_class(noun.head) in ("abstract", "unknown")


def _is_quality(noun: NounPhrase) -> bool:
    """Whether a noun is a quality: ``goes quiet``, ``falls silent``."""
    return not noun.determiner and noun.head in lexicon.ADJECTIVES


def _going(clause: Clause, doing: Doing) -> str | None:
    """Return the motion of a verb without its own and with a direction: ``fishtails past``, ``breezes in``."""
    if doing.object or clause.verb in _NOT_GOING:
        return None
    return "walk" if clause.particle in _AWAY or doing.prepositions & _ALONG else None


def _applies(rule: lexicon.Override, doing: Doing) -> bool:
    """Whether a row of ``overrides.tsv`` fits a clause."""
    return (
        _matches(rule.particles, doing.particle)
        and _matches(rule.objects, doing.object)
        and any(_matches(rule.prepositions, preposition) for preposition in doing.prepositions or ("",))
        and any(_matches(rule.nouns, noun) for noun in doing.nouns or ("",))
    )


def _matches(wanted: tuple[str, ...], word: str) -> bool:
    """Whether a word is among those of a rule; ``*``, ``-``, ``+`` and classes in capitals as in the lexicon."""
    for want in wanted:
        if (
            want in ("*", word)
            or (want == "-" and not word)
            or (want == "+" and word != "")
            or (want == "THING" and word not in ("", "person", "self"))
            or (want == "BODY" and word in lexicon.BODY)
            or (want == "GARMENT" and word in _GARMENTS)
            or (want == "VEHICLE" and word in lexicon.VEHICLES)
            or (want == "SEAT" and word in lexicon.SEATS)
        ):
            return True
    return False
