"""Make a screenplay sentence regular, so that its clauses can be read from left to right (notes, 1b).

Verbs are told from nouns (``Kira sprints down``, ``They dance``) and tagged; what screenplays leave out is put in:
the subject of ``Grabs a shovel.``, the ``was`` of ``MAN #2 on the bed``; appositions are taken out.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.morphology import FORMS, VerbForm, form_kind, guess_lemma, singular
from storyblender.agents.director.reader.words import Word

_OPENERS = lexicon.DETERMINERS | lexicon.POSSESSIVES
_BEFORE_NOUN = _OPENERS | lexicon.PREPOSITIONS | {"'s"}
_LINKS = lexicon.CONJUNCTIONS | {",", ";", "-", "--", "—", "–"}
_CLAUSE_LINKS = frozenset({"and", "but", "as", "while", "when", "then", ";", ":", "—", "–", "--"})
_PASSED_OVER = lexicon.ADVERBS - {"there", "here"}
_OBJECT_OPENERS = _OPENERS | {
    "him",
    "her",
    "it",
    "them",
    "up",
    "to",
    "twice",
    "once",
    "again",
    "at",
    "back",
    "away",
    "forward",
    "aside",
    "into",
    "toward",
    "towards",
    "out",
    "through",
    "past",
    "from",
    "onto",
    "across",
}
_AFTER_VERB = _OPENERS | lexicon.PREPOSITIONS | {".", ",", "open", "shut", "and", "slowly", "away", "back"}
_SINGULAR_PRONOUNS = frozenset({"he", "she", "it", "who", "which", "that"})
_PLURAL_PRONOUNS = frozenset({"they", "we", "you", "i"})
_ENTERING = frozenset({"in", "out", "up", "down", "there", "along", "off"})
_FRAGMENT_NOUNS = frozenset({"hands", "arms", "guns", "lights", "steps", "sparks", "shots", "fires", "flames", "waves"})
_THINGS = lexicon.PROPS | lexicon.SET_PIECES | lexicon.BODY
_NOUNS = lexicon.WORN | lexicon.PROPS | lexicon.BODY | lexicon.SET_PIECES
_PREDICATES = frozenset({"asleep", "awake", "alone", "unconscious", "dead", "naked", "up", "seated", "ready"})
_BEFORE_INFINITIVE = frozenset(
    {"to", "n't", "not", "never", "would", "will", "should", "might", "may", "must", "can", "could", "let"}
)
_NO_FRAGMENT = frozenset({"of", "with", "to", "as"})
_LOOK_AHEAD = 16
"""Words an apposition may take."""


@dataclass
class _Row:
    """The words so far."""

    words: list[Word] = field(default_factory=list)
    verb_seen: bool = False
    tail: list[Word] = field(default_factory=list)
    """``with a canister on his back`` out of an apposition: it is told at the end."""
    last_kind: str = ""
    """``3sg`` or ``base``: the form of the last finite verb."""

    def insert_subject(self, at: int) -> None:
        """Put in the elided subject."""
        self.words.append(Word("", at, at, inserted=True))

    def insert_was(self, at: int) -> None:
        """Put in the missing verb."""
        self.words.append(_was(at))
        self.verb_seen = True

    def neighbour(self) -> Word | None:
        """The last word that is no adverb."""
        return next((word for word in reversed(self.words) if not _is_adverb(word)), None)


def _was(at: int) -> Word:
    return Word("", at, at, verb=VerbForm("be", "aux"), inserted=True)


def _is_adverb(word: Word) -> bool:
    adverb = (word.low.endswith("ly") and len(word.low) > 4) or word.low in _PASSED_OVER
    return adverb and word.mention is None


def regularise(words: list[Word]) -> list[Word]:
    """Tag the verbs of a sentence and put in what it leaves out.

    Args:
        words: A sentence with its mentions marked.

    Returns:
        The words in the order they are to be read; only inserted words are new.
    """
    row = _Row()
    at = 0
    while at < len(words):
        word = words[at]
        if word.text == "," and row.words and row.words[-1].named and not any(w.inserted and w.verb for w in row.words):
            end = _apposition_end(words, at)
            if end:
                row.tail += _with_something(words[at + 1 : end - 1])
                at, word = end, words[end]
        if _renames(row.words, words, at):
            at += 1 if word.mention else 2
            continue
        if word.text.isalpha() and word.mention is None:
            _read_verb(words, at, row)
        row.words.append(word)
        at += 1
    regular = row.words if row.verb_seen else _complete_fragment(row.words)
    if row.tail:
        stop = 1 if regular[-1].text in ".!?" else 0
        regular = [*regular[: len(regular) - stop], *row.tail, *regular[len(regular) - stop :]]
    for index, word in enumerate(regular):
        if word.verb is None and word.mention is None and not word.inserted:
            word.verb = _written_verb(regular, index)
    return regular


def _renames(before: list[Word], words: list[Word], at: int) -> bool:
    """``a girl named Elin``, ``his niece Clara``: the name is told by the noun before it."""
    left = before[-1].mention if before else None
    named = words[at].low in ("named", "called") and at + 1 < len(words)
    mention = words[at + 1].mention if named else words[at].mention
    if not (left and mention and mention.kind == "name" and left.kind in ("role", "generic")):
        return False
    if named or mention.candidates[0] in left.candidates:
        left.candidates = mention.candidates
        return True
    return False


def _apposition_end(words: list[Word], comma: int) -> int | None:
    """``ROOK, a broad man in a dark uniform, pushes``: index of the verb after the second comma."""
    for at in range(comma + 2, min(len(words), comma + _LOOK_AHEAD)):
        word = words[at]
        if word.mention or words[at - 1].text != "," or form_kind(word.low) not in ("3sg", "past", "aux"):
            continue
        inside = words[comma + 1 : at]
        somebody = any(w.mention and w.text[0].isupper() for w in inside)
        verb = any(form_kind(w.low) in ("3sg", "aux") for w in inside if not w.mention)
        return None if somebody or verb or any(w.low == "and" for w in inside) else at
    return None


def _with_something(apposition: list[Word]) -> list[Word]:
    """The part of an apposition that tells what somebody has with them."""
    at = next((index for index, word in enumerate(apposition) if word.low == "with"), len(apposition))
    belongs = any(word.low in lexicon.PREPOSITIONS for word in apposition[at + 1 :])
    return apposition[at:] if belongs else []


def _read_verb(words: list[Word], at: int, row: _Row) -> None:
    """Decide whether the word at ``at`` is a verb of this sentence; tag it, put in its subject."""
    word = words[at]
    following = words[at + 1] if at + 1 < len(words) else None
    form = FORMS.get(word.low) or _unknown_verb(word, following, row)
    if form is None:
        return
    left = row.neighbour()
    if word.low in _FRAGMENT_NOUNS and following and following.low in ("up", "raised", "drawn"):
        return
    if form.kind in ("past", "aux"):
        if left is None or left.low not in _OPENERS:
            row.verb_seen = True
            if word.low not in FORMS:
                word.verb = form
    elif form.kind in ("3sg", "base"):
        opens = left is None or not any(w.solid for w in row.words)
        if _opens_sentence(form, word, following) if opens else _is_finite(form, word, following, left, row):
            if opens:
                row.insert_subject(word.start)
            word.verb = VerbForm(form.lemma, "past")
            row.verb_seen, row.last_kind = True, form.kind
    elif form.kind == "ing" and not row.verb_seen:
        _read_participle(words, at, row)


def _unknown_verb(word: Word, following: Word | None, row: _Row) -> VerbForm | None:
    """An unknown word in -s or -ed right after a person: ``the train barrels``, ``she vaulted``."""
    left = row.neighbour()
    if left is None or not word.text.islower() or len(word.low) < 4 or not re.search(r"[^s]s$|ed$", word.low):
        return None
    after_person = left.mention is not None and left.mention.kind != "group"
    listed = left.low in ("and", ",") and row.verb_seen and any(w.mention for w in row.words)
    if not (after_person or left.low in ("he", "she", "it") or listed):
        return None
    right = following.low if following else "."
    if right not in _AFTER_VERB | {"his", "her", "him", "it"} and not right.endswith("ly"):
        return None
    if word.low.endswith("ed"):
        return VerbForm(word.low[:-2], "past") if not listed else None
    known_noun = singular(word.low) in _NOUNS | lexicon.ABSTRACT | lexicon.SCENERY
    return None if known_noun else VerbForm(guess_lemma(word.low), "3sg")


def _opens_sentence(form: VerbForm, word: Word, following: Word | None) -> bool:
    """``Grabs a shovel.`` is a verb, ``Hands up.`` and ``Sparks.`` are not."""
    right = following.low if following else "."
    if form.kind != "3sg" or (right == "." and form.lemma not in lexicon.MOTION_OF_VERB):
        return False
    return word.low not in _FRAGMENT_NOUNS or not (right in ("up", "raised", "drawn", ".", ",") or right in FORMS)


def _is_finite(form: VerbForm, word: Word, following: Word | None, left: Word | None, row: _Row) -> bool:
    """Whether a word that can be a verb in the present is one here, from what stands to its left and right."""
    if left is None or left.inserted:
        return False
    third, right = form.kind == "3sg", following.low if following else "."
    if third and left.low in _ENTERING and following and following.mention and _opens_clause(row):
        return True
    if left.mention is None and (left.low in _BEFORE_NOUN or left.text[0].isdigit()):
        return False
    if left.mention:
        return form_kind(right) != "past" if third else _is_plural(left, row)
    if left.low in _SINGULAR_PRONOUNS:
        return third
    if left.low in _PLURAL_PRONOUNS:
        return True
    if left.low in (")", '"'):
        return third
    if left.low in _LINKS:
        listed = third and left.low in (",", "and") and _reads_as_noun(word, right)
        return _continues(form, left, right, row) and not listed
    return left.text.isalpha() and (not row.verb_seen or _new_clause(row)) and _after_noun(form, left, right)


def _new_clause(row: _Row) -> bool:
    """Whether the noun before opens a clause of its own: ``Doyle falls and the lantern rolls off``."""
    for index in range(len(row.words) - 2, max(len(row.words) - 5, -1), -1):
        if row.words[index].low in _OPENERS:
            return index > 0 and row.words[index - 1].low in _CLAUSE_LINKS
    return False


def _reads_as_noun(word: Word, right: str) -> bool:
    """Whether a word in a list is rather a noun: ``boots on, drills, hands`` but ``drills a hole``, ``steps back``."""
    if not {word.low, singular(word.low)} & _NOUNS or (word.low == "steps" and right != "."):
        return False
    return right not in _OBJECT_OPENERS and not right.endswith("ly")


def _opens_clause(row: _Row) -> bool:
    """Whether only one word stands since the start of the clause: ``In`` of ``In walks BOB``."""
    return len(row.words) < 2 or row.words[-2].low in ("and", ",", "then", ".")


def _is_plural(left: Word, row: _Row) -> bool:
    """Two guards / Kira and Tomas / the officers, before a base form."""
    if left.mention and left.mention.kind == "group":
        return True
    coordinated = any(w.low == "and" and i and row.words[i - 1].mention for i, w in enumerate(row.words))
    return coordinated or left.low.endswith("s")


def _continues(form: VerbForm, left: Word, right: str, row: _Row) -> bool:
    """A verb after a comma or conjunction goes on with the verb form before it."""
    if form.kind == "base":
        return row.last_kind == "base"
    if left.low in lexicon.CONJUNCTIONS:
        return left.low in ("and", "then", "but", "or") and (row.verb_seen or any(w.inserted for w in row.words))
    somebody = any(w.mention for w in row.words)
    return (row.verb_seen and right != "of") or (somebody and right in _OPENERS | lexicon.PREPOSITIONS)


def _after_noun(form: VerbForm, left: Word, right: str) -> bool:
    """``The phone rings.``, ``The doors slam shut.``"""
    if form.kind == "3sg":
        return form_kind(left.low) not in ("past", "aux") and (right in _AFTER_VERB or right.endswith("ly"))
    plural = singular(left.low) != left.low or left.low.endswith("s")
    return plural and right in _AFTER_VERB - {",", "slowly"}


def _read_participle(words: list[Word], at: int, row: _Row) -> None:
    """``Watching.`` -> He was watching; ``Jo holding a doll`` -> Jo was holding a doll."""
    start = words[at].start
    if not row.words:
        row.insert_subject(start)
        row.insert_was(start)
    elif row.words[-1].mention and not any(
        form_kind(word.low) in ("3sg", "past", "aux") for word in words[at:] if not word.mention
    ):
        row.insert_was(start)


def _complete_fragment(words: list[Word]) -> list[Word]:
    """Put ``was`` into a sentence without a verb: ``MAN #2 on the bed``, ``Behind her, JO``."""
    if not words:
        return words
    if words[0].low in lexicon.PREPOSITIONS and words[0].mention is None:
        return _turn_around(words)
    at = next((index for index, word in enumerate(words) if index and _starts_predicate(word)), None)
    if at is None or not (words[at - 1].solid or words[at - 1].text == ","):
        return words
    if words[at - 1].text == "," and words[0].mention:
        comma = next(index for index, word in enumerate(words) if word.text == ",")
        words, at = words[:comma] + words[at:], comma
    return [*words[:at], _was(words[at].start), *words[at:]]


def _starts_predicate(word: Word) -> bool:
    if word.mention:
        return False
    return word.low in _PREDICATES or (word.low in lexicon.PREPOSITIONS and word.low not in _NO_FRAGMENT)


def _turn_around(words: list[Word]) -> list[Word]:
    """``Behind her, JO holding a doll`` -> JO was behind her, holding a doll; ``On it JO`` -> JO was on it."""
    comma = next((index for index, word in enumerate(words) if word.text == ","), None)
    while words and words[-1].text in ".!?":
        words = words[:-1]
    if len(words) > 2 and words[1].low in lexicon.PRONOUNS and words[2].named:
        place, rest = words[:2], words[2:]
    elif comma is None or comma >= 6 or comma + 1 >= len(words):
        return words
    else:
        place, rest = words[:comma], words[comma + 1 :]
    prepositions = [i for i, word in enumerate(rest) if word.low in lexicon.PREPOSITIONS and not word.mention]
    first = prepositions[0] if prepositions else len(rest)
    cut = next((index for index, word in enumerate(rest) if word.text == ","), first)
    return [*rest[:cut], _was(words[0].start), *place, *rest[cut:]]


def _written_verb(words: list[Word], at: int) -> VerbForm | None:
    """A verb by its form alone: past tenses, participles, auxiliaries, infinitives after ``to``."""
    word = words[at]
    form = FORMS.get(word.low)
    if form is None or form.kind == "3sg":
        return None
    before = words[at - 1].low if at else ""
    if before in _OPENERS or before == "'s" or (form.kind == "base" and before not in _BEFORE_INFINITIVE):
        return None
    if form.kind == "past" and word.low in _THINGS and not _does_something(words, at):
        return None
    after = words[at + 1].low if at + 1 < len(words) else ""
    modifies = form.kind == "ing" and after in lexicon.SET_PIECES | lexicon.PROPS and at > 0
    return None if modifies and before in lexicon.PREPOSITIONS else form


def _does_something(words: list[Word], at: int) -> bool:
    """Whether the word before a past tense that is also a noun is its subject: ``he saw``, ``the wind rose``."""
    left = words[at - 1] if at else None
    if left is None:
        return False
    if left.mention or left.low in _SINGULAR_PRONOUNS | _PLURAL_PRONOUNS:
        return True
    noun = lexicon.noun_class(singular(left.low)) not in ("unknown", "abstract")
    return noun and any(word.low in _OPENERS for word in words[max(0, at - 4) : at - 1])
