"""Clauses of a regular sentence: its phrases put together in one pass from left to right, without a parser.

Clauses follow from the order of phrases. Anything that produces ``Clause`` could stand in place of this.
"""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clause import Clause, ClauseBuilder
from storyblender.agents.director.reader.language.clause_nouns import is_other_side, take_noun
from storyblender.agents.director.reader.language.clause_order import is_absolute, is_fronted, is_inverted, verb_follows
from storyblender.agents.director.reader.language.clause_repairs import repair_clauses
from storyblender.agents.director.reader.language.clause_verbs import take_verb
from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase
from storyblender.agents.director.reader.language.words import Word

_NEAR = 4
"""Phrases back to whom ``who`` means."""
_HYPOTHETICAL = frozenset({"if", "unless"})
_WONDERING = frozenset({"how", "why", "whether"})
_POSED = lexicon.words("stative")
_HOW = lexicon.ADJECTIVES | lexicon.words("manner")
_ADVERBIAL = frozenset({"outside", "inside", "without", "within", "above", "below"})
"""``Outside a blizzard was raging``: no preposition where subject and verb follow."""


def find_clauses(words: list[Word], phrases: list[Phrase]) -> list[Clause]:
    """Return the clauses of a sentence.

    Args:
        words: A regular sentence.
        phrases: Its phrases, in order.
    """
    builder = ClauseBuilder(phrases, words)
    for index, phrase in enumerate(phrases):
        if phrase.text in (";", "and", ",") and builder.clauses and is_fronted(phrases, index + 1):
            builder.close_fronted()
            builder.fronted = []
        if phrase.kind == "negation":
            builder.negated = builder.negated or phrase.text != "modal"
            builder.unreal = builder.unreal or phrase.text == "modal"
        elif phrase.kind == "verb":
            take_verb(builder, index, phrase)
        elif phrase.kind == "preposition":
            _take_preposition(builder, index, phrase)
        elif phrase.kind == "noun" and phrase.noun:
            if (builder.fronted or not builder.clauses) and is_other_side(builder, index):
                (builder.fronted or builder.leading)[-1][1].append(phrase.noun)
            else:
                take_noun(builder, index, phrase.noun)
            if phrase.noun.head == "what" and _verb_touches(builder, index):
                builder.relative = [phrase.noun]  # lays what is in it on the lid
        elif phrase.text in ("and", "but", "then") or phrase.text in ".;:,":
            builder.preposition, builder.aside = "", False
            builder.closed = builder.closed or phrase.text == ","
        elif phrase.text in ("who", "that", "which"):
            _take_relative(builder, index, phrase.text)
        elif phrase.text in _HYPOTHETICAL or (phrase.text == "though" and phrases[index - 1].text == "as"):
            builder.unreal = True
            _compare(builder, index)
    _finish(builder)
    for clause in builder.clauses:
        _set_extent(clause, words)
    return builder.clauses


def _set_extent(clause: Clause, words: list[Word]) -> None:
    """Set the offsets of the first and last word of a clause."""
    nouns = [*clause.subject, *clause.object, *clause.recipient, *clause.complement]
    nouns += [noun for _, place in clause.places for noun in place]
    written = [words[at] for at in (clause.index, *(noun.index for noun in nouns)) if at < len(words)]
    clause.start = min((word.start for word in written if not word.inserted), default=clause.at)
    clause.end = max((word.end for word in written if not word.inserted), default=clause.at)


def _take_relative(builder: ClauseBuilder, index: int, pronoun: str) -> None:
    """Give the verbs that follow a relative pronoun to its noun: ``a man, who``."""
    if pronoun == "who":
        nouns = [p.noun for p in builder.phrases[max(0, index - _NEAR) : index] if p.noun]
        builder.relative = [noun for noun in nouns if noun.kind == "person"][-1:]
        if builder.current and _is_object(builder.current, builder.relative):
            builder.subject = builder.relative
    elif _verb_touches(builder, index):
        builder.relative = [p.noun for p in builder.phrases[max(0, index - 2) : index] if p.noun][-1:]


def _compare(builder: ClauseBuilder, index: int) -> None:
    """Begin a comparison, which tells nothing that happens: ``looks as if she had swallowed a wasp``."""
    clause = builder.current
    compares = clause is not None and clause.verb == "look" and builder.phrases[index - 1].text == "as"
    if clause and compares and not (clause.object or clause.places):
        clause.verb = "seem"


def _finish(builder: ClauseBuilder) -> None:
    """Place what is left when the sentence ends: a last place, places before the first verb, delayed subjects."""
    builder.close_fronted()
    if builder.clauses:
        builder.clauses[0].places += builder.leading
        builder.clauses[0].opening = len(builder.leading)
    if builder.clauses and builder.words[0].low in _WONDERING:
        builder.clauses[0].unreal = True
    repair_clauses(builder.clauses, builder.words)
    for clause in builder.clauses:
        if any(noun.determiner == "no" or noun.head == "nothing" for noun in clause.object[:1]):
            clause.negated = True  # offers no opinion
        if clause.verb == "be" or _is_posed(clause):
            clause.complement, clause.object = clause.object, []


def _is_posed(clause: Clause) -> bool:
    """Whether an adjective tells how a thing stands and is no object: ``A glass stands empty``."""
    how = clause.object[:1]
    return clause.verb in _POSED and any(n.head in _HOW and not n.determiner for n in how)


def _is_object(clause: Clause, nouns: list[NounPhrase]) -> bool:
    """Whether nouns before a relative clause are the object: ``thrusts it at Percy, who sits up``."""
    after = [*clause.object, *clause.recipient, *(noun for _, place in clause.places for noun in place)]
    return bool(nouns) and all(any(noun is other for other in after) for noun in nouns)


def _verb_touches(builder: ClauseBuilder, index: int) -> bool:
    """Whether a verb follows a relative ``that``: ``the letter that lies there``, but not ``that man``."""
    following = builder.phrases[index + 1] if index + 1 < len(builder.phrases) else None
    return following is not None and following.kind == "verb"


def _take_preposition(builder: ClauseBuilder, index: int, phrase: Phrase) -> None:
    """Add a particle of the verb (``picks up``) or a preposition with a noun to come."""
    clause = builder.current
    if (
        index == 0
        and phrase.text in _ADVERBIAL
        and verb_follows(builder.phrases, 1)
        and not is_inverted(builder.phrases)
    ):
        return
    following = builder.phrases[index + 1] if index + 1 < len(builder.phrases) else None
    if clause and phrase.text in lexicon.PARTICLES and not clause.particle and not builder.closed:
        noun_follows = following is not None and following.kind == "noun"
        pair = f"{clause.verb} {phrase.text}"
        known = (pair in lexicon.MOTION_OF_VERB or pair in lexicon.OVERRIDDEN_PARTICLES) and not clause.object
        known = known and builder.phrases[index - 1].kind != "preposition"  # turns round on the stool
        if not noun_follows or (known and phrase.text != "through"):
            clause.particle, builder.preposition = phrase.text, ""
            return
    absolute = phrase.text == "with" and clause is not None and is_absolute(builder.phrases, index + 1)
    builder.preposition = "" if absolute else phrase.text
