"""Telling verbs from nouns in a screenplay's present tense, from what stands to the left and to the right.

``Kira sprints down``, ``The phone rings.``, ``grabs his boots, hands her the key``: a word that can be both is tagged
where a verb fits; the words to its left are already tagged.
"""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import FORMS, RARE_FORMS, VerbForm, form_kind
from storyblender.agents.director.reader.language.rare_verbs import (
    AFTER_VERB,
    BEFORE_NOUN,
    DIRECTIONS,
    OBJECTS,
    OPENERS,
    SELDOM_VERBS,
    is_listed_part,
    may_follow_verb,
    rare_verb,
)
from storyblender.agents.director.reader.language.words import TaggedRow, Word, is_adverb
from storyblender.catalog.inflection import singular

_LINKS = lexicon.CONJUNCTIONS | {",", ";", "-", "--", "—", "–"}
_CLAUSE_LINKS = frozenset({"and", "but", "as", "while", "when", "then", ";", ":", "—", "–", "--"})
_SUBORDINATORS = frozenset({"when", "as", "while", "after", "before", "once", "until", "if", "since", "because"})
SINGULAR_PRONOUNS = frozenset({"he", "she", "it", "who", "which", "that"})
PLURAL_PRONOUNS = frozenset({"they", "we", "you", "i", "who", "both", "each", "all"})
_ENTERING = frozenset({"last", "next", "first", "here", "in", "out", "up", "down", "there", "along", "off", "then"})
_LIMBS = frozenset({"hands", "arms", "fingers", "thumbs", "eyes", "knees", "elbows"})
_FRAGMENT_NOUNS = frozenset({"hands", "arms", "guns", "lights", "steps", "sparks", "shots", "fires", "flames", "waves"})
_STAGE_ORDERS = frozenset({"enter", "exit", "re-enter"})
"""``Enter HAMLET.``"""
_HANDING = frozenset({"over", "out", "back", "round"})
_THINGS = lexicon.PROPS | lexicon.SET_PIECES | lexicon.BODY
_NOUNS = _THINGS | lexicon.WORN
PERCEIVING = lexicon.words("perceiving")
"""``sees Tom go``, ``lets her in``: what follows the object is what that does."""
_COMPOUNDS = lexicon.words("gerund_compounds")
_SPORTS = frozenset({"hike", "walk", "run", "ride", "climb", "swim", "dance", "work", "drive", "sail", "fish", "hunt"})
"""``hiking boots``, ``driving gloves``: what they are for."""
_RESTING = lexicon.words("stative")
_CONTRACTING = frozenset({"he", "she", "it", "they", "we", "i", "you", "who", "there", "that", "here"})
_GRAMMAR = lexicon.PREPOSITIONS | lexicon.PARTICLES | lexicon.CONJUNCTIONS | OBJECTS
_BARE_PLACES = frozenset({"inside", "underneath", "beneath", "below", "above", "outside", "opposite", "behind"})
"""``Inside lie two letters``: a place without a noun."""
_POSED = frozenset({"lie", "stand", "sit", "hang"})
_HOW = lexicon.ADJECTIVES | lexicon.words("manner")
"""``A boat lies upside down``, ``A glass stands empty``."""
_INVERTING = lexicon.INVERTING
"""Verbs whose subject may follow: ``In the booth sit two thugs``."""


def tag_verb(words: list[Word], at: int, row: TaggedRow) -> None:
    """Tag the word at an index if it is a verb of this sentence, and insert its subject.

    Args:
        words: Words of the sentence.
        at: Index of the word.
        row: The words before it, tagged; extended in place.
    """
    word = words[at]
    following = words[at + 1] if at + 1 < len(words) else None
    form = FORMS.get(word.low) or rare_verb(word, following, row)
    left = row.neighbour()
    named = names_a_kind(word, following) or _ends_a_kind(word, row)
    if form is None or named or is_listed_part(word, left, _object_handed(words, at) or following):
        return
    following = _object_handed(words, at) or following
    if word.low in _FRAGMENT_NOUNS and not row.words and following and following.low in ("up", "raised", "drawn"):
        return
    if form.kind == "base" and word.low in lexicon.PARTICLES:
        return
    if form.kind == "past" and left is None and following and following.low in lexicon.PREPOSITIONS | {".", "!"}:
        word.verb = VerbForm(form.lemma, "pp")
    elif form.kind in ("base", "past") and word.low == form.lemma and _is_bare_infinitive(word, following, row):
        word.verb, row.last_kind = VerbForm(form.lemma, "inf"), "inf"
    elif form.kind in ("past", "aux", "pp"):
        if left is None or left.low not in OPENERS:
            row.verb_seen = True
            if word.low == form.lemma and left is not None and left.mention and _is_plural(left, row):
                row.last_kind = "base"  # They put it down and push
            if word.low not in FORMS:
                word.verb = form
    elif form.kind in ("3sg", "base"):
        opens = left is None or not any(w.solid for w in row.words)
        if _opens_sentence(form, word, following) if opens else _is_finite(form, word, following, left, row):
            if opens and form.kind == "3sg":
                row.insert_subject(word.start)
            word.verb = VerbForm(form.lemma, "past")
            row.verb_seen, row.last_kind = True, form.kind
    elif form.kind == "ing" and not row.verb_seen:
        _tag_participle(words, at, row)


def _object_handed(words: list[Word], at: int) -> Word | None:
    """Return the word after the particle of a handing: ``hands over the keys``."""
    handing = words[at].low == "hands" and at + 2 < len(words) and words[at + 1].low in _HANDING
    return words[at + 2] if handing else None


def is_contracted(words: list[Word], at: int) -> bool:
    """Whether ``'s`` or ``'re`` is a short ``is`` or ``are`` and no possessive: ``He's in the booth``.

    Args:
        words: Words of the sentence.
        at: Index of the clitic.
    """
    word, left = words[at], words[at - 1] if at else None
    right = words[at + 1] if at + 1 < len(words) else None
    if left is None or right is None or word.low not in ("'s", "'re", "'m") or right.low in ("got", "been"):
        return False
    if left.low in _CONTRACTING:
        return True
    named = left.mention is not None and left.mention.kind == "name"
    return named and (right.low in lexicon.PREPOSITIONS or right.low in ("a", "an", "the", "already", "still", "not"))


def names_a_kind(word: Word, following: Word | None) -> bool:
    """Whether a word names the kind of the next noun: ``reading glasses``, ``a vending machine``.

    Args:
        word: The word.
        following: The next word, or None.
    """
    noun = singular(following.low) if following else ""
    if word.low.endswith("ing") and noun in lexicon.WORN and form_kind(word.low) == "ing":
        return FORMS[word.low].lemma in _SPORTS
    return f"{word.low}_{noun}" in _COMPOUNDS or f"{word.low}-{noun}" in lexicon.COMPOUNDS


def _ends_a_kind(word: Word, row: TaggedRow) -> bool:
    """Whether a word ends a compound noun: ``juggling clubs``, ``hiking boots``, ``both hands``."""
    before = row.words[-1] if row.words else None
    if before is not None and before.low == "both" and FORMS.get(word.low, ("", ""))[1] == "3sg":
        return True
    return before is not None and (
        f"{before.low}-{singular(word.low)}" in lexicon.COMPOUNDS
        or (before.verb is None and names_a_kind(before, word))
    )


def may_be_verb(word: Word, following: Word | None) -> bool:
    """Whether a word after an apposition can be the verb it interrupts: known, or shaped like one before an object.

    Args:
        word: The word after the apposition.
        following: The next word, or None.
    """
    if form_kind(word.low) in ("3sg", "past", "aux"):
        return True
    right = following.low if following else "."
    return word.low in RARE_FORMS and RARE_FORMS[word.low].kind in ("3sg", "past") and right in AFTER_VERB


def _is_bare_infinitive(word: Word, following: Word | None, row: TaggedRow) -> bool:
    """Whether a base form follows a perceived object: ``watches her go to the window, part the blinds``."""
    right = following.low if following else "."
    left = row.neighbour()
    if (
        left is None
        or not may_follow_verb(right)
        or (singular(word.low) in _NOUNS and right not in OBJECTS | DIRECTIONS)
    ):
        return False
    if row.last_kind == "inf" and left.low in ("and", ","):
        return True
    verbs = [i for i, word in enumerate(row.words) if word.verb or form_kind(word.low) == "past"]
    at = verbs[-1] if verbs else None
    if at is None or (row.words[at].verb or FORMS[row.words[at].low]).lemma not in PERCEIVING:
        return False
    between = row.words[at + 1 :]
    return (
        0 < len(between) <= 4
        and not any(w.low in lexicon.PREPOSITIONS | _LINKS for w in between)
        and (between[-1].mention is not None or between[-1].low in ("him", "her", "it", "them") or len(between) > 1)
    )


def _opens_sentence(form: VerbForm, word: Word, following: Word | None) -> bool:
    """Whether a form at the start is a verb: ``Grabs a shovel.``, but not ``Hands up.`` or ``Sparks.``"""
    right = following.low if following else "."
    if word.low in _STAGE_ORDERS and following and following.mention:
        return True
    posed = FORMS.get(right)
    if posed and posed.kind == "base" and posed.lemma in _POSED and singular(word.low) in _NOUNS:
        return False  # Chisels hang from a board
    if form.kind == "3sg" and _is_rather_a_noun(word, right):
        return False  # Fingers through the wire. Locks jump out.
    if form.kind != "3sg" or (right == "." and form.lemma not in lexicon.MOTION_OF_VERB) or right == "of":
        return False
    return word.low not in _FRAGMENT_NOUNS or not (right in ("up", "raised", "drawn", ".", ",") or right in FORMS)


def _is_rather_a_noun(word: Word, right: str) -> bool:
    """Whether a plural of a body part, garment or thing has no object, or a verb of its own right after it."""
    noun = singular(word.low)
    if noun in SELDOM_VERBS:
        return right not in OBJECTS
    own_verb = FORMS.get(right)
    return (
        noun in _THINGS and own_verb is not None and own_verb.kind in ("base", "past", "ing") and right not in _GRAMMAR
    )


def _is_finite(form: VerbForm, word: Word, following: Word | None, left: Word | None, row: TaggedRow) -> bool:
    """Whether a word that can be a verb in the present is one here, from what stands to its left and right."""
    if left is None or left.inserted:
        return False
    third, right = form.kind == "3sg", following.low if following else "."
    brings = following is not None and (following.mention is not None or right in OPENERS)
    if left.low in _ENTERING and brings and _opens_clause(row) and (third or form.lemma in _INVERTING):
        return True
    if third and (_is_relative(left, right, row) or (brings and _is_behind_her(form, left, row))):
        return True
    inverted, bare = _is_inverted(form, following, row), left.low in _BARE_PLACES and len(row.words) == 1
    if left.mention is None and not (bare and inverted) and (left.low in BEFORE_NOUN or left.text[0].isdigit()):
        return False
    if inverted:
        return True
    if left.mention and left.low not in PLURAL_PRONOUNS:
        return (form_kind(right) != "past" or form.lemma in _INVERTING) if third else _is_plural(left, row)
    if left.low in ("who", "which", "that") and not third:
        return may_follow_verb(right) and left.low != "that"
    if left.low in SINGULAR_PRONOUNS or (left.low == "other" and third):
        return third
    if left.low in PLURAL_PRONOUNS:
        return True
    if left.low in (")", '"'):
        return third
    if left.low in _LINKS:
        told_in_past = not row.last_kind and any(
            form_kind(w.low) == "past" or w.low in ("was", "were", "had") for w in row.words
        )
        if third and told_in_past and singular(word.low) in _NOUNS:
            return False
        listed = third and left.low in (",", "and") and _reads_as_noun(word, right, row)
        return _continues_verb(form, left, right, row) and not listed
    if not third and form.lemma in lexicon.MOTION_OF_VERB and _several_described(row):
        return singular(word.low) not in _NOUNS
    new = not row.verb_seen or _new_clause(row) or (form.lemma in _POSED | {"lean"} and _after_comma(row))
    return left.text.isalpha() and new and _after_noun(word, form, left, right)


def _is_relative(left: Word, right: str, row: TaggedRow) -> bool:
    """Whether ``that`` opens a relative clause: ``the letter that lies on the mat``."""
    before = row.words[-2] if len(row.words) > 1 else None
    if left.low != "that" or before is None or not may_follow_verb(right):
        return False
    small = before.low in BEFORE_NOUN | _LINKS or is_adverb(before)
    return before.solid and before.verb is None and not small


def _is_behind_her(form: VerbForm, left: Word, row: TaggedRow) -> bool:
    """Whether the form after ``her`` is a verb: ``behind her stands a waiter``."""
    before = row.words[-2].low if len(row.words) > 1 else ""
    return left.low == "her" and form.lemma in _INVERTING and before in lexicon.PREPOSITIONS


def _several_described(row: TaggedRow) -> bool:
    """Whether several people with a description precede without a verb: ``SOLDIERS in white smocks``."""
    first, *rest = row.words
    several = first.mention is not None and any(person.count > 1 for person in first.mention.candidates)
    return several and not row.verb_seen and bool(rest) and rest[0].low in ("in", "with", "of", "from")


def _is_inverted(form: VerbForm, following: Word | None, row: TaggedRow) -> bool:
    """Whether a verb of being follows a fronted place: ``In the far booth, hats low, sit two THUGS``."""
    if following is None or form.lemma not in _INVERTING:
        return False
    start = max((at for at, w in enumerate(row.words) if w.low in (";", "and")), default=-1) + 1
    if row.verb_seen and (not start or any(w.verb for w in row.words[start:])):
        return False  # and on top of the letters lies a ring
    first = next((w for w in row.words[start if row.verb_seen else 0 :] if w.solid), None)
    leads = first is not None and (first.low in lexicon.PREPOSITIONS | {"there", "here"} or first.verb is not None)
    return leads and (following.mention is not None or following.low in OPENERS | frozenset(lexicon.NUMBERS))


def _new_clause(row: TaggedRow) -> bool:
    """Whether the noun before opens its own clause: ``Iris slips and the bucket tips over``."""
    measured = any(word.low == "of" for word in row.words[-5:])
    for index in range(len(row.words) - 2, max(len(row.words) - (8 if measured else 5), -1), -1):
        if row.words[index].low in OPENERS:
            before = row.words[index - 1].low if index else ""
            if index > 1 and before in lexicon.PRONOUNS and row.words[index - 2].low in lexicon.PREPOSITIONS:
                return True  # and behind it a map hangs
            return before in _CLAUSE_LINKS or (before == "," and row.words[0].low in _SUBORDINATORS)
    return False


def _after_comma(row: TaggedRow) -> bool:
    """Whether the noun before opens a clause after a comma: ``, the umbrella leans in the corner``."""
    start = max((at for at, word in enumerate(row.words) if word.text == ","), default=len(row.words))
    inside = row.words[start + 1 :]
    return bool(inside) and inside[0].low in OPENERS and not any(w.low in lexicon.PREPOSITIONS for w in inside)


def _reads_as_noun(word: Word, right: str, row: TaggedRow) -> bool:
    """Whether a word in a list is rather a noun: ``boots on, drills, hands``, but not ``drills a hole``."""
    if not {word.low, singular(word.low)} & _NOUNS or (word.low == "steps" and right != "."):
        return False
    if right in OBJECTS | DIRECTIONS or right.endswith("ly"):
        return False
    if (word.low in _LIMBS and right in lexicon.PREPOSITIONS) or form_kind(right) in ("past", "pp"):
        return True
    before = [w for w in row.words if w.solid]
    return not row.verb_seen or _is_bare_plural(before)


def _is_bare_plural(before: list[Word]) -> bool:
    """Whether the words before a link end in a plural without a determiner: the start of a list of nouns."""
    before = before[:-1] if before and before[-1].low == "and" else before
    if not before or before[-1].mention or before[-1].verb or singular(before[-1].low) == before[-1].low:
        return False
    return len(before) < 2 or before[-2].low not in OPENERS


def _opens_clause(row: TaggedRow) -> bool:
    """Whether only one word stands since the start of the clause: ``In`` of ``In walks BOB``."""
    return len(row.words) < 2 or row.words[-2].low in ("and", ",", "then", ".")


def _is_plural(left: Word, row: TaggedRow) -> bool:
    """Whether the subject before a base form is plural: ``Two guards``, ``Kira and Tomas``, ``the CHILDREN``."""
    if left.mention and left.mention.kind == "group":
        return True
    coordinated = any(w.low == "and" and i and row.words[i - 1].mention for i, w in enumerate(row.words))
    return coordinated or left.low.endswith("s") or singular(left.low) != left.low


def _continues_verb(form: VerbForm, left: Word, right: str, row: TaggedRow) -> bool:
    """Whether a verb after a comma or conjunction has the form of the verb before it."""
    if form.kind == "base":
        several = any(w.mention and w.mention.kind == "group" for w in row.words)
        return row.last_kind == "base" or (several and not row.verb_seen and left.low == "," and right in OBJECTS)
    if left.low in lexicon.CONJUNCTIONS:
        return left.low in ("and", "then", "but", "or") and (row.verb_seen or any(w.inserted for w in row.words))
    person = any(w.mention for w in row.words)
    if right == "." and left.low == "," and row.words[0].named and form.lemma in lexicon.MOTION_OF_VERB:
        return True  # BOB, in a suit, sits.
    return (row.verb_seen and right != "of") or (person and right in OPENERS | lexicon.PREPOSITIONS)


def _after_noun(word: Word, form: VerbForm, left: Word, right: str) -> bool:
    """Whether a form after a noun is its verb: ``The phone rings.``, but not ``Two yellow eyes,``."""
    if form.kind == "3sg" and left.low in lexicon.ADJECTIVES and singular(word.low) in _NOUNS and right not in OBJECTS:
        return False
    if form.kind == "3sg" and form.lemma in _POSED and (form_kind(right) in ("past", "pp") or right in _HOW):
        return True
    if form.kind == "3sg":
        if singular(word.low) in lexicon.WORN and (right in (",", ".") or "-" in left.low):
            return False  # in rubber boots, she cuts; steel-capped boots arrive
        going = form.lemma in ("go", "come") and form_kind(right) == "ing"
        return form_kind(left.low) not in ("past", "aux") and (right in AFTER_VERB or right.endswith("ly") or going)
    plural = singular(left.low) != left.low or left.low.endswith("s")
    return plural and right in AFTER_VERB - {",", "slowly"}


def _tag_participle(words: list[Word], at: int, row: TaggedRow) -> None:
    """Tag a participle and insert ``was``: ``Watching.`` -> He was watching."""
    start = words[at].start
    if not row.words:
        row.insert_subject(start)
        row.insert_was(start)
    elif row.words[-1].mention and not any(
        form_kind(word.low) in ("3sg", "past", "aux") for word in words[at:] if not word.mention
    ):
        row.insert_was(start)


def retag_participles(words: list[Word]) -> None:
    """Make participles in the present tense passive: ``handcuffed``, ``wrapped in feathers``."""
    for index, word in enumerate(words):
        form = FORMS.get(word.low)
        left = words[index - 1] if index else None
        acts = left is not None and (
            (left.verb is not None and left.verb.lemma not in _RESTING) or left.mention is not None
        )
        done = left is None or not (acts or left.low in SINGULAR_PRONOUNS | PLURAL_PRONOUNS)
        if word.verb and form and form.kind == "past" and word.low != form.lemma and done:
            word.verb = VerbForm(form.lemma, "pp")
