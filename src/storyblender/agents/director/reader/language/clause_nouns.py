"""Puts the nouns of a sentence into its clauses: subjects to come, objects, recipients, places, lists."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clause import Clause, ClauseBuilder
from storyblender.agents.director.reader.language.clause_order import (
    is_absolute,
    is_verbless_placement,
    list_ends,
    verb_follows,
)
from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase

_SUBJECT_ONLY = frozenset({"he", "she", "they", "i", "we"})
"""``At noon he folds the map``: no object of the preposition before."""
_INSERTING = frozenset({"where", "when", "until", "because", "since", "if", "though", "although", "that"})
_OPENING = frozenset({"when", "as", "by", "while", "after", "before", "once", "until", "since", "because"})
"""``By the time I got down to the lobby a policeman was kneeling``: after it another clause comes."""


def take_noun(builder: ClauseBuilder, index: int, noun: NounPhrase) -> None:
    """Add a noun to the clauses: as a subject to come, of a preposition, object, recipient, or next in a list.

    Args:
        builder: The clauses so far; changed in place.
        index: Index of the noun's phrase.
        noun: The noun phrase.
    """
    clause, left = builder.current, builder.phrases[index - 1] if index else None
    listed = left is not None and (left.kind == "mark" or (left.kind == "link" and left.text == "and"))
    linked = left is not None and (left.kind in ("link", "mark") or left.text == "with")
    if noun.head in _SUBJECT_ONLY:
        builder.preposition = ""
    starts_clause = not builder.preposition and (
        clause is None
        or noun.head in _SUBJECT_ONLY
        or builder.fronted is not None
        or (linked and (verb_follows(builder.phrases, index) or is_absolute(builder.phrases, index)))
        or (clause is not None and clause.absolute and linked and _participle_follows(builder, index))
        or (_is_main(builder, left) and verb_follows(builder.phrases, index))
    )
    if starts_clause:
        _start_clause(builder, left.text if left is not None else "", noun, listed)
        return
    if builder.preposition:
        if builder.fronted is not None:
            builder.fronted.append((builder.preposition, [noun]))
        elif not builder.aside and not (clause and builder.pending):
            places = clause.places if clause else builder.leading
            places.append((builder.preposition, [noun]))
        builder.preposition = ""
        return
    if clause is None:
        return
    opens = index - 2 if index > 2 and left and left.text == "and" and builder.phrases[index - 2].noun else index
    if (
        noun.kind == "person"
        and builder.phrases[opens - 1].text == ","
        and is_verbless_placement(builder.phrases, index)
    ):
        builder.aside = True
        return
    told = [preposition for preposition, _ in clause.places if preposition != "of"]
    goes_on = listed and bool(clause.object) and not told and list_ends(builder.phrases, index)
    apart = (left is not None and left.text == ",") or bool(listed and clause.object and told)
    builder.aside = noun.kind == "thing" and apart and not goes_on
    if builder.aside and not clause.object:
        clause.asides.append(noun)
        return
    place = _open_place(clause, noun) if left and left.kind == "link" and left.text == "and" else None
    if place is not None:
        place.append(noun)
    elif linked and clause.object and (noun.kind == "person" or (goes_on and clause.object[0].kind == "thing")):
        clause.object.append(noun)
    elif clause.object and left and left.kind == "noun" and noun.kind == "thing" and _gets_it(clause):
        clause.recipient, clause.object = clause.object, [noun]
    elif not clause.object and len(clause.places) == clause.opening:
        clause.object = [noun]


def _participle_follows(builder: ClauseBuilder, index: int) -> bool:
    """Whether a participle of its own follows a noun: ``and a book lying on the seat``."""
    after = builder.phrases[index + 1] if index + 1 < len(builder.phrases) else None
    return after is not None and after.verb is not None and after.verb.kind in ("ing", "pp")


def _open_place(clause: Clause, noun: NounPhrase) -> list[NounPhrase] | None:
    """Return the nouns of a place that continues after ``and``: ``between a jar of pickles and a clock``."""
    if not clause.places:
        return None
    if clause.asides and clause.asides[-1].index > clause.places[-1][1][-1].index:
        return None  # crouches on the deck, a tin in one hand and a fork in the other
    (before, one), (preposition, nouns) = clause.places[-2:] if len(clause.places) > 1 else [("", []), *clause.places]
    same = nouns[-1].kind == noun.kind and noun.determiner not in ("a", "an")  # a jar of brushes and a lamp
    if nouns[-1].head in lexicon.BODY | {"left", "right"} and (noun.kind == "person" or noun.determiner in ("a", "an")):
        return None  # with Luc on her left and Elise on her right
    of_both = preposition == "between" or (preposition == "of" and same)
    if preposition == "of" and before == "between" and len(one) == 1:
        return one
    return nouns if of_both or not clause.object else None


def _is_main(builder: ClauseBuilder, left: Phrase | None) -> bool:
    """Whether an opening clause may end before a noun: ``When it is over the barber sighs``."""
    opened = builder.words[0].low in _OPENING and len(builder.clauses) == 1 and not builder.closed
    return opened and left is not None and (left.kind == "noun" or left.text in lexicon.PARTICLES)


def _start_clause(builder: ClauseBuilder, left: str, noun: NounPhrase, listed: bool) -> None:
    """Keep a noun as the subject of a clause to come, alone or as one of a list."""
    if left == "with":
        builder.close_fronted()
    builder.inserted = left in _INSERTING
    if left in _INSERTING | {"as", "while"} and not listed and not builder.clauses:
        builder.outer = builder.pending
    builder.pending = [*builder.pending, noun] if listed and builder.pending else [noun]


def is_other_side(builder: ClauseBuilder, index: int) -> bool:
    """Whether a noun after ``and`` is the other side of ``between a radio and a lamp``.

    Args:
        builder: What has been read.
        index: Position of the noun among the phrases.
    """
    places = builder.leading if builder.fronted is None else builder.fronted
    place = places[-1] if places else ("", [])
    return place[0] == "between" and len(place[1]) == 1 and builder.phrases[index - 1].text == "and"


def _gets_it(clause: Clause) -> bool:
    """Whether the verb of a clause has a recipient: ``hands Mia the key``, ``gives the box a shove``."""
    return _receives(clause.object[0]) or (clause.verb == "give" and clause.object[0].determiner != "")


def _receives(noun: NounPhrase) -> bool:
    """Whether a noun before another noun can be the recipient: ``hands Mia the key``."""
    return noun.kind == "person" or (noun.kind == "pronoun" and noun.head != "it")
