"""Clauses of a regular sentence, found in one pass from left to right without a parser.

``rewrite`` has already told verbs from nouns, and names are single words, so phrases follow from closed word classes
and clauses from the order of phrases. Anything that produces ``Clause`` could stand in its place.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import Literal

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.morphology import VerbForm, singular
from storyblender.agents.director.reader.words import Mention, Word

_SMALL = (
    frozenset({"open", "shut"})
    | lexicon.PREPOSITIONS
    | lexicon.CONJUNCTIONS
    | lexicon.DETERMINERS
    | lexicon.POSSESSIVES
)
_MODALS = frozenset({"would", "will", "should", "might", "may", "must", "wo", "'ll", "'d"})
_NEGATIONS = frozenset({"not", "n't", "never", "nobody", "neither"})
_LINKS = lexicon.CONJUNCTIONS | {"until", "if", "unless"}
_THING_NOUNS = lexicon.SET_PIECES | lexicon.PROPS
_PLAIN = re.compile(r"(?:[^\W_]|#)(?:[^\W_]|[#'’-])*$")
_SUBORDINATING = frozenset({"as", "before", "after", "until", "till"})
_SUBJECT_PRONOUNS = frozenset({"he", "she", "they", "it", "i", "you", "we"})
_HYPOTHETICAL = frozenset({"if", "unless"})


@dataclass
class NounPhrase:
    """One thing or person in a clause."""

    kind: Literal["person", "pronoun", "thing"]
    index: int
    """Position of its head among the words."""
    head: str = ""
    """Singular head noun."""
    key: str = ""
    """Thing: head with the words that make it a kind of its own, ``coffee cup``."""
    mention: Mention | None = None
    possessor: int | None = None
    """Position of ``her`` or ``Nora('s)``."""
    owner: str | None = None
    """Id of the possessor, once resolved."""
    plural: bool = False
    determiner: str = ""


@dataclass
class Phrase:
    """A verb, a noun phrase, a preposition or a link, with the words it covers."""

    kind: Literal["noun", "verb", "preposition", "link", "negation", "mark"]
    first: int
    last: int
    text: str = ""
    noun: NounPhrase | None = None
    verb: VerbForm | None = None


@dataclass
class Clause:
    """A verb with everything that belongs to it."""

    index: int
    """Position of the verb among the words."""
    at: int
    """Offset of the verb in the script."""
    verb: str
    particle: str = ""
    subject: list[NounPhrase] = field(default_factory=list)
    object: list[NounPhrase] = field(default_factory=list)
    recipient: list[NounPhrase] = field(default_factory=list)
    complement: list[NounPhrase] = field(default_factory=list)
    """What somebody or something is said to be: ``The shop is a ruin``, ``Hale is asleep``."""
    places: list[tuple[str, list[NounPhrase]]] = field(default_factory=list)
    """Prepositions with their nouns."""
    opening: int = 0
    """How many of the last places open the sentence: ``Behind the curtain Lena tunes her violin``."""
    participle: bool = False
    """An -ing form."""
    passive: bool = False
    """A past participle: somebody else does it."""
    negated: bool = False
    unreal: bool = False
    """It does not happen: would, if, without, wants to."""
    elided: bool = False
    """No subject is written."""
    main: bool = True


def find_phrases(words: list[Word]) -> list[Phrase]:
    """Group the words of a regular sentence."""
    phrases: list[Phrase] = []
    at = 0
    while at < len(words):
        phrase = _mention_or_verb(words, at) or _pronoun(words, at) or _small_word(words, at)
        if phrase is None and not _skipped(words, at):
            phrase = _noun_phrase(words, at)
        if phrase:
            if phrase.noun and phrase.noun.possessor is not None and phrase.noun.possessor < phrase.first:
                del phrases[-2:]  # the owner and its 's now belong to what is owned
            phrases.append(phrase)
        at = phrase.last + 1 if phrase else at + 1
    return phrases


def _mention_or_verb(words: list[Word], at: int) -> Phrase | None:
    word = words[at]
    if word.mention:
        noun = NounPhrase("person", at, word.mention.head, mention=word.mention, possessor=_genitive(words, at))
        return Phrase("noun", at, at, noun=noun)
    return Phrase("verb", at, at, word.low, verb=word.verb) if word.verb else None


def _pronoun(words: list[Word], at: int) -> Phrase | None:
    word = words[at]
    if word.inserted:
        return Phrase("noun", at, at, noun=NounPhrase("pronoun", at, ""))
    if word.low not in lexicon.PRONOUNS or word.low in ("his", "its", "their"):
        return None
    if word.low == "her" and at + 1 < len(words):
        right = words[at + 1]
        possessive = right.mention or (
            right.text.isalpha() and right.low not in _SMALL and not right.low.endswith("ly") and not right.verb
        )
        if possessive:
            return None
    return Phrase("noun", at, at, noun=NounPhrase("pronoun", at, word.low))


def _small_word(words: list[Word], at: int) -> Phrase | None:
    word = words[at]
    if word.low in _SUBORDINATING and _subject_follows(words, at):
        return Phrase("link", at, at, word.low)
    for compound in lexicon.COMPOUND_PREPOSITIONS.get(word.low, ()):
        if tuple(w.low for w in words[at : at + len(compound)]) == compound:
            return Phrase("preposition", at, at + len(compound) - 1, " ".join(compound))
    if word.low in lexicon.PREPOSITIONS or word.low in lexicon.PARTICLES:
        return Phrase("preposition", at, at, word.low)
    if word.low in _LINKS:
        return Phrase("link", at, at, word.low)
    if word.low in _NEGATIONS:
        return Phrase("negation", at, at, word.low)
    if word.low in _MODALS or word.low in ("nearly", "almost"):
        return Phrase("negation", at, at, "modal")
    return Phrase("mark", at, at, word.text) if not word.text[0].isalnum() else None


def _subject_follows(words: list[Word], at: int) -> bool:
    """``as she reads``, ``before you shoot``: the word links a clause."""
    right = words[at + 1 : at + 3]
    return bool(right) and (
        right[0].low in _SUBJECT_PRONOUNS
        or (len(right) > 1 and right[0].mention is not None and right[1].verb is not None)
    )


def _skipped(words: list[Word], at: int) -> bool:
    """Adverbs, and ``each other``."""
    word = words[at]
    right = words[at + 1].low if at + 1 < len(words) else ""
    if word.low in ("each", "one") and right in ("other", "another"):
        return True
    if word.low in ("other", "another") and at and words[at - 1].low in ("each", "one"):
        return True
    return word.low.endswith("ly") or word.low in lexicon.ADVERBS


def _genitive(words: list[Word], at: int) -> int | None:
    """Position of the owner where ``'s`` stands before ``at``."""
    return at - 2 if at > 1 and words[at - 1].low == "'s" and words[at - 2].mention else None


def _noun_phrase(words: list[Word], at: int) -> Phrase | None:
    """Determiner, adjectives and head; the last word is the head."""
    determiner, possessor, first = "", _genitive(words, at), at
    if words[at].low in lexicon.DETERMINERS:
        determiner, first = words[at].low, at + 1
    elif words[at].low in lexicon.POSSESSIVES:
        possessor, first = at, at + 1
    end = first
    while (
        end < len(words) and _in_noun_phrase(words[end]) and not (end > first and words[end].low in lexicon.PARTICLES)
    ):
        end += 1
    if end < len(words) and words[end].mention and end - first <= 3 and (determiner or possessor == at):
        noun = NounPhrase("person", end, words[end].mention.head, mention=words[end].mention, possessor=possessor)  # type: ignore[union-attr]
        noun.determiner = determiner
        return Phrase("noun", at, end, noun=noun)
    if end == first:
        return None
    head = end - 1
    noun = singular(words[head].low)
    if noun in lexicon.MEASURES and end + 1 < len(words) and words[end].low == "of":
        inner = _noun_phrase(words, end + 1)
        if inner and inner.noun and inner.noun.kind == "thing":
            return replace(inner, first=at)
    key = _compound(words, first, head, noun)
    thing = NounPhrase(
        "thing", head, noun, key, possessor=possessor, plural=noun != words[head].low, determiner=determiner
    )
    return Phrase("noun", at, head, noun=thing)


def _in_noun_phrase(word: Word) -> bool:
    return (
        _PLAIN.match(word.text) is not None
        and word.mention is None
        and word.verb is None
        and word.low not in _SMALL
        and word.low not in lexicon.ADVERBS
        and word.low not in lexicon.PRONOUNS
        and not word.low.endswith("ly")
    )


def _compound(words: list[Word], first: int, head: int, noun: str) -> str:
    """``coffee cup``, ``rocking chair``, ``BIRTHDAY CARD``: the word before the head, where it names a kind."""
    if head == first:
        return noun
    left = words[head - 1].low
    if (
        left in lexicon.CARRIERS
        or left.endswith("ing")
        or (left in _THING_NOUNS | lexicon.SCENERY and noun in _THING_NOUNS)
    ):
        return f"{left} {noun}"
    return noun


@dataclass
class _Builder:
    """What has been read of the sentence so far."""

    phrases: list[Phrase]
    words: list[Word]
    clauses: list[Clause] = field(default_factory=list)
    subject: list[NounPhrase] = field(default_factory=list)
    """Subject of the clauses so far; a verb without one inherits it."""
    pending: list[NounPhrase] = field(default_factory=list)
    """A noun read before its verb."""
    preposition: str = ""
    aside: bool = False
    """Within ``, a book in her lap``: its places are the book's, not the clause's."""
    leading: list[tuple[str, list[NounPhrase]]] = field(default_factory=list)
    """Places told before the first clause: ``On top of the stone sat a fox``."""
    negated: bool = False
    unreal: bool = False
    passive: bool = False

    @property
    def current(self) -> Clause | None:
        return self.clauses[-1] if self.clauses else None


def find_clauses(words: list[Word], phrases: list[Phrase]) -> list[Clause]:
    """Put phrases together to clauses.

    Args:
        words: A regular sentence.
        phrases: Its phrases, in order.
    """
    builder = _Builder(phrases, words)
    for index, phrase in enumerate(phrases):
        if phrase.kind == "negation":
            builder.negated = builder.negated or phrase.text != "modal"
            builder.unreal = builder.unreal or phrase.text == "modal"
        elif phrase.kind == "verb":
            _take_verb(builder, index, phrase)
        elif phrase.kind == "preposition":
            _take_preposition(builder, index, phrase)
        elif phrase.kind == "noun" and phrase.noun:
            _take_noun(builder, index, phrase.noun)
        elif phrase.text in ("and", "but", "then") or phrase.text in ".;:,":
            builder.preposition, builder.aside = "", False
        elif phrase.text in _HYPOTHETICAL:
            builder.unreal = True
    if builder.clauses:
        builder.clauses[0].places += builder.leading
        builder.clauses[0].opening = len(builder.leading)
    for clause in builder.clauses:
        if clause.verb == "be":
            clause.complement, clause.object = clause.object, []
    return builder.clauses


def _take_verb(builder: _Builder, index: int, phrase: Phrase) -> None:
    verb = phrase.verb or VerbForm(phrase.text, "past")
    following = builder.phrases[index + 1] if index + 1 < len(builder.phrases) else None
    if verb.kind == "aux" and following and following.kind in ("verb", "negation"):
        past = following.verb is not None and following.verb.kind in ("past", "pp")
        builder.passive = past and verb.lemma == "be"
        return
    participle = verb.kind == "ing"
    clause = Clause(
        phrase.first,
        builder.words[phrase.first].start,
        verb.lemma,
        subject=list(builder.pending or builder.subject),
        participle=participle,
        passive=verb.kind == "pp" or builder.passive,
        negated=builder.negated,
        unreal=builder.unreal or _is_unreal(builder, index),
        main=not builder.clauses or not participle,
    )
    builder.negated = builder.unreal = builder.passive = False
    clause.elided = not clause.subject
    if builder.pending:
        builder.subject = builder.pending
    elif builder.current and not clause.subject:
        clause.subject = builder.current.subject
    builder.pending, builder.preposition, builder.aside = [], "", False
    builder.clauses.append(clause)


def _is_unreal(builder: _Builder, index: int) -> bool:
    """``without looking``, ``wants to leave``, ``stops mopping``."""
    left = builder.phrases[index - 1] if index else None
    if left is None:
        return False
    before = builder.current
    if before is not None and left.kind == "verb" and before.verb in _ENDINGS and before.index == left.first:
        return True
    if left.kind != "preposition":
        return False
    if left.text == "without" or (left.text == "to" and before and before.verb in _WISHES):
        return True
    return left.text == "to" and builder.words[builder.phrases[index].first].low in _PURPOSES


_ENDINGS = frozenset({"stop", "quit", "avoid", "consider", "finish", "suggest", "imagine"})
_PURPOSES = frozenset({"see", "look", "find", "get", "hear"})
_WISHES = frozenset({"want", "need", "refuse", "hope", "decide", "have", "try", "wait", "hesitate", "fail"})


def _take_preposition(builder: _Builder, index: int, phrase: Phrase) -> None:
    """A particle of the verb (``picks up``) or a preposition with a noun to come."""
    clause = builder.current
    following = builder.phrases[index + 1] if index + 1 < len(builder.phrases) else None
    if clause and phrase.text in lexicon.PARTICLES and not clause.particle:
        noun_follows = following is not None and following.kind == "noun"
        pair = f"{clause.verb} {phrase.text}"
        known = (pair in lexicon.MOTION_OF_VERB or pair in lexicon.OVERRIDDEN_PARTICLES) and not clause.object
        if not noun_follows or known:
            clause.particle, builder.preposition = phrase.text, ""
            return
    builder.preposition = phrase.text


def _take_noun(builder: _Builder, index: int, noun: NounPhrase) -> None:
    """A subject to come, the noun of a preposition, an object, a recipient, or one more of a list."""
    clause, left = builder.current, builder.phrases[index - 1] if index else None
    listed = left is not None and (left.kind == "mark" or (left.kind == "link" and left.text == "and"))
    linked = left is not None and left.kind in ("link", "mark")
    starts_clause = not builder.preposition and (clause is None or (linked and _verb_follows(builder.phrases, index)))
    if starts_clause:
        builder.pending = [*builder.pending, noun] if listed and builder.pending else [noun]
        return
    if builder.preposition:
        if not builder.aside:
            places = clause.places if clause else builder.leading
            places.append((builder.preposition, [noun]))
        builder.preposition = ""
        return
    if clause is None:
        return
    builder.aside = noun.kind == "thing" and left is not None and left.text == ","
    if left and left.kind == "link" and left.text == "and" and clause.places and not clause.object:
        clause.places[-1][1].append(noun)
    elif linked and clause.object and noun.kind == "person":
        clause.object.append(noun)
    elif clause.object and left and left.kind == "noun" and _receives(clause.object[0]) and noun.kind == "thing":
        clause.recipient, clause.object = clause.object, [noun]
    elif not clause.object and not clause.places:
        clause.object = [noun]


def _receives(noun: NounPhrase) -> bool:
    """Whether a noun before another noun can be who gets it: ``hands Mia the key``."""
    return noun.kind == "person" or (noun.kind == "pronoun" and noun.head != "it")


def _verb_follows(phrases: list[Phrase], index: int) -> bool:
    """Whether a list of nouns that starts here ends at a finite verb."""
    while index < len(phrases):
        phrase = phrases[index]
        joins = phrase.text in (",", "and") and index + 1 < len(phrases) and phrases[index + 1].kind == "noun"
        if phrase.kind != "noun" and not joins:
            return phrase.kind == "verb" and (phrase.verb is None or phrase.verb.kind != "ing")
        index += 1
    return False
