"""Verbs known by their form alone: past tenses, participles, auxiliaries, infinitives after ``to``."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import FORMS, RARE_FORMS, VerbForm
from storyblender.agents.director.reader.language.rare_verbs import OBJECTS, OPENERS
from storyblender.agents.director.reader.language.tagging import (
    PLURAL_PRONOUNS,
    SINGULAR_PRONOUNS,
    names_a_kind,
)
from storyblender.agents.director.reader.language.words import Word
from storyblender.catalog.inflection import singular

_RISING = frozenset({"as", "and", "from", "to", "when", "with", ".", ",", "up"})
_ATTIRING = frozenset({"dress", "wrap", "swathe", "veil", "bundle", "cloak", "robe", "shroud"})
"""``a lady dressed in black``: she does nothing."""
_SHAPING = frozenset({"build", "shape", "make", "dress", "cut", "carve", "draw", "paint"})
"""``built like a barn``: verbs that describe a build here, not an action."""
_NOUNS_OF = lexicon.words("nouns_of")
_RANKING = lexicon.words("ranking")
"""``the second landing``."""
_BEFORE_INFINITIVE = lexicon.words("before_infinitive")
_FORCING = lexicon.words("forcing")
_SOLID = lexicon.SET_PIECES | lexicon.PROPS | lexicon.WORN
_THINGS = _SOLID | lexicon.BODY


def written_verb(words: list[Word], at: int) -> VerbForm | None:
    """Return the verb form of a word by its form alone, or None.

    Args:
        words: Words of the sentence.
        at: Index of the word.
    """
    word = words[at]
    before = words[at - 1].low if at else ""
    after_word = words[at + 1].low if at + 1 < len(words) else ""
    form = FORMS.get(word.low) or _rare_participle(words, at)
    if form is None or form.kind == "3sg" or names_a_kind(word, words[at + 1] if at + 1 < len(words) else None):
        return None
    owned = before == "'s" and words[at - 1].verb is None
    if (
        (before in OPENERS and form.kind != "aux")
        or owned
        or (form.kind == "base" and before not in _BEFORE_INFINITIVE)
    ):
        return None
    if word.low in _NOUNS_OF and after_word == "of" and before not in SINGULAR_PRONOUNS | PLURAL_PRONOUNS:
        return None  # a fair bit of language
    if form.kind == "past" and after_word == "like" and form.lemma in _SHAPING:
        return VerbForm(form.lemma, "pp")
    if word.low == "left" and before in ("from", "to", "on", "at"):
        return None
    if form.kind == "ing" and at > 1 and before in _RANKING and words[at - 2].low in OPENERS:
        return None
    if form.kind == "past" and _with_something(words, at):
        return VerbForm(form.lemma, "pp")
    if form.kind == "past" and form.lemma in _ATTIRING and after_word in ("in", "as"):
        return VerbForm(form.lemma, "pp")
    if form.kind == "past" and word.low in _THINGS and not _does_something(words, at):
        return None
    modifies = form.kind in ("ing", "pp") and after_word in _SOLID and at > 0
    return None if modifies and before in lexicon.PREPOSITIONS else form


def _with_something(words: list[Word], at: int) -> bool:
    """Whether a participle only tells how a thing is: ``with his wrists tied``, ``with the door closed``."""
    back = words[max(0, at - 4) : at]
    noun = words[at - 1] if at else None
    alone = noun is not None and noun.mention is None and noun.verb is None and noun.text.isalpha()
    low = [word.low for word in back]
    plain = not any(word.verb or word.text == "," or word.low in lexicon.CONJUNCTIONS for word in back)
    return alone and plain and any(low[i] == "with" and low[i + 1] in OPENERS for i in range(len(low) - 2))


def is_outcome(words: list[Word], at: int) -> bool:
    """Whether a word is the outcome of the verb before: ``kicks the door shut``.

    Args:
        words: Words of the sentence.
        at: Index of the word.
    """
    for word in reversed(words[max(0, at - 6) : at]):
        if word.verb is not None:
            return word.verb.lemma in _FORCING and word is not words[at - 1]
        if not (word.mention or word.text.isalpha() or word.text.startswith("'")) or word.low in lexicon.CONJUNCTIONS:
            return False
    return False


def _rare_participle(words: list[Word], at: int) -> VerbForm | None:
    """Return the form of a rare participle that is not before a noun: ``kneading the dough``."""
    form = RARE_FORMS.get(words[at].low)
    after = words[at + 1].low if at + 1 < len(words) else "."
    if form is None or not words[at].text.islower():
        return None
    if form.kind == "base":
        return form if words[at - 1].low == "to" and at > 1 and after in OBJECTS else None
    opens = after in OBJECTS | lexicon.PREPOSITIONS or not after[:1].isalpha()
    if form.kind == "ing":
        return form if opens else None
    help_verb = words[at - 1].verb if at else None
    helped = help_verb is not None and help_verb.kind == "aux"
    return VerbForm(form.lemma, "pp") if form.kind == "past" and helped and opens else None


def _does_something(words: list[Word], at: int) -> bool:
    """Whether a past tense that is also a noun is a verb: ``he saw``, ``the wind rose``."""
    left = words[at - 1] if at else None
    if left is None:
        return False
    if left.low == "and" and any(word.verb and word.verb.kind == "past" for word in words[:at]):
        return not words[at - 2].mention and lexicon.noun_class(singular(words[at - 2].low)) in ("unknown", "abstract")
    if left.mention or left.low in SINGULAR_PRONOUNS | PLURAL_PRONOUNS:
        return True
    right = words[at + 1].low if at + 1 < len(words) else "."
    if words[at].low == "rose" and left.text == "," and right in _RISING:
        return any(word.mention for word in words[:at])
    noun = lexicon.noun_class(singular(left.low)) not in ("unknown", "abstract")
    return noun and any(word.low in OPENERS for word in words[max(0, at - 4) : at - 1])
