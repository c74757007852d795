"""Make a screenplay sentence regular, so that its clauses can be read from left to right (notes, 1b).

Verbs are told from nouns (``Kira sprints down``, ``They dance``) and tagged; what screenplays leave out is put in:
the subject of ``Grabs a shovel.``, the ``inserted_was`` of ``MAN #2 on the bed``; appositions are taken out.
"""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import VerbForm, form_kind
from storyblender.agents.director.reader.language.tagging import (
    OPENERS,
    is_contracted,
    may_be_verb,
    retag_participles,
    tag_verb,
)
from storyblender.agents.director.reader.language.words import Mention, TaggedRow, Word, inserted_was
from storyblender.agents.director.reader.language.written_verbs import is_outcome, written_verb
from storyblender.catalog.inflection import singular

_PREDICATES = frozenset({"asleep", "awake", "alone", "unconscious", "dead", "naked", "up", "seated", "ready"})
_NO_FRAGMENT = frozenset({"of", "with", "to", "as"})
_TO_AND_FRO = frozenset(
    {
        ("up", "down"),
        ("back", "forth"),
        ("to", "fro"),
        ("in", "out"),
        ("round", "round"),
        ("over", "over"),
        ("on", "on"),
    }
)
_SIDE_BY_SIDE = ("shoulder", "side", "back", "elbow", "knee", "hip", "arm")
_RELATED = lexicon.KIN | lexicon.COMPANY
_BORNE = lexicon.BODY | lexicon.WORN | lexicon.PROPS
"""``skirts bunched in one fist``, ``boots on``: what a person has about them, no verb."""
_OUTCOMES = {"shut": "shut", "closed": "shut", "open": "open"}
"""What a door is after it was kicked or pulled."""
_POSTURES = lexicon.words("postures")
"""``Olsen, seated by the fire, whittles``: a deed of its own."""
_BESIDE = frozenset({"at", "by", "beside", "behind", "near", "under", "beneath", "next", "opposite", "atop", "across"})
"""``Magda, by the loft, lights a match``: where she is, not who."""
_LOOK_AHEAD = 16
"""Words an apposition may take."""


def regularise(words: list[Word]) -> list[Word]:
    """Return the words with verbs tagged and elided subjects and verbs inserted.

    Args:
        words: A sentence with its mentions marked.

    Returns:
        The words in the order they are to be read; only inserted words are new.
    """
    words = _named_kin(_without_all(_on_their_knees(_without_pairs(words))))
    row = TaggedRow()
    at = 0
    while at < len(words):
        word = words[at]
        if word.text == "," and row.words and row.words[-1].named and not any(w.inserted and w.verb for w in row.words):
            end = _apposition_end(words, at)
            if end:
                row.tail += _with_something(words[at + 1 : end - 1])
                if words[at + 1].low in _BESIDE:
                    start = len(row.words) - (2 if len(row.words) > 1 and row.words[-2].low in OPENERS else 1)
                    row.words[start:start] = words[at + 1 : end - 1]
                at, word = end, words[end]
        if _renames(row.words, words, at):
            at += 1 if word.mention else 2
            continue
        if word.text.isalpha() and word.mention is None and word.verb is None:
            tag_verb(words, at, row)
        elif is_contracted(words, at):
            word.verb, row.verb_seen = VerbForm("be", "aux"), True
        row.words.append(word)
        at += 1
    regular = row.words if row.verb_seen else _complete_fragment(row.words)
    if row.tail:
        stop = 1 if regular[-1].text in ".!?" else 0
        regular = [*regular[: len(regular) - stop], *row.tail, *regular[len(regular) - stop :]]
    for index, word in enumerate(regular):
        if word.low in _OUTCOMES and is_outcome(regular, index):
            word.low, word.verb = _OUTCOMES[word.low], None
        elif word.verb is None and word.mention is None and not word.inserted:
            word.verb = written_verb(regular, index)
    if row.last_kind == "3sg":
        retag_participles(regular)
    return regular


def _without_pairs(words: list[Word]) -> list[Word]:
    """Drop pairs that are adverbs and no directions: ``up and down``, ``, side by side,``."""
    low = [word.low for word in words]
    dropped: set[int] = set()
    dropped |= {i + at for i in range(len(low) - 1) if low[i : i + 2] == ["upside", "down"] for at in (0, 1)}
    for i in range(len(low) - 2):
        if low[i : i + 3] == ["hands", "and", "knees"] and {"down", "to"} & set(low[max(0, i - 3) : i]):
            dropped |= {i, i + 1}
        to_and_fro = low[i + 1] == "and" and (low[i], low[i + 2]) in _TO_AND_FRO
        if to_and_fro or (low[i] == low[i + 2] in _SIDE_BY_SIDE and low[i + 1] in ("to", "by", "in")):
            between = low[i - 1 : i] == low[i + 3 : i + 4] == [","]
            dropped |= set(range(i - between, i + 3 + between))
    return [word for i, word in enumerate(words) if i not in dropped]


def _on_their_knees(words: list[Word]) -> list[Word]:
    """Make ``Ruiz, on his knees, pumps the jack`` a kneeling."""
    low = [word.low for word in words]
    for i in range(len(low) - 3):
        apart = (i == 0 or low[i - 1] == ",") and low[i + 3] in lexicon.PREPOSITIONS | {","}
        if apart and low[i] == "on" and low[i + 1] in lexicon.POSSESSIVES and low[i + 2] == "knees":
            words[i + 2].verb = VerbForm("kneel", "ing")
            return [*words[:i], *words[i + 2 :]]
    return words


def _without_all(words: list[Word]) -> list[Word]:
    """Drop ``all`` and ``both`` after a subject: ``They all leave``, ``the men both nod``."""
    return [
        word
        for index, word in enumerate(words)
        if not (word.low in ("all", "both", "each") and index and _is_several(words[index - 1]))
        or [following.low for following in words[index + 1 : index + 2]] == ["of"]
    ]


def _is_several(word: Word) -> bool:
    """Whether a word means several people."""
    return word.low in ("they", "we") or (word.mention is not None and word.mention.kind == "group")


def _renames(before: list[Word], words: list[Word], at: int) -> bool:
    """Whether a name only names the noun before it: ``a girl named Elin``, ``his niece Clara``."""
    left = before[-1].mention if before else None
    named = words[at].low in ("named", "called") and at + 1 < len(words)
    mention = words[at + 1].mention if named else words[at].mention
    if not (left and mention and mention.kind == "name" and left.kind in ("role", "generic")):
        return False
    if named or mention.candidates[0] in left.candidates:
        left.candidates = mention.candidates
        return True
    return False


def _named_kin(words: list[Word]) -> list[Word]:
    """Drop a name between commas that the noun before it tells: ``his companion, Dr. Fell, read``."""
    kept: list[Word] = []
    at = 0
    while at < len(words):
        right = words[at + 1 : at + 3]
        name = right[0].mention if len(right) > 1 and words[at].text == right[1].text == "," else None
        person = _told_before(kept, name, words[at + 3 : at + 4]) if name and name.kind == "name" else None
        if person is None:
            kept.append(words[at])
            at += 1
        else:
            person.mention = name
            at += 3
    return kept


def _told_before(kept: list[Word], name: Mention, following: list[Word]) -> Word | None:
    """Return the noun right before a name between commas, if both are one person; else None."""
    last = kept[-1].mention if kept else None
    if last and last.kind != "name" and (last.head in _RELATED or name.candidates[0] in last.candidates):
        return kept[-1]
    at = next((at for at in range(len(kept) - 1, -1, -1) if kept[at].mention or kept[at].text in ",;"), -1)
    told = kept[at].mention if at >= 0 else None
    worn = kept[at + 1 : at + 2]
    if told is None or told.kind != "generic" or told.determiner not in ("a", "an"):
        return None
    listed = [word.low for word in following] == ["and"]
    dressed = not worn or worn[0].low in ("in", "with")
    genders = {lexicon.gender_of_word(told.head), name.candidates[0].gender} - {"unknown"}
    return kept[at] if dressed and not listed and len(genders) < 2 else None


def _apposition_end(words: list[Word], comma: int) -> int | None:
    """Return the index of the verb after an apposition: ``ROOK, a broad man in a uniform, pushes``."""
    for at in range(comma + 2, min(len(words), comma + _LOOK_AHEAD)):
        word = words[at]
        following = words[at + 1] if at + 1 < len(words) else None
        if word.mention or words[at - 1].text != "," or not may_be_verb(word, following):
            continue
        inside = words[comma + 1 : at]
        first = next((w for w in inside if w.low not in lexicon.ADVERBS), inside[0])
        if form_kind(first.low) == "ing" or first.verb or first.low in _POSTURES:
            return None
        named = any(w.mention and w.text[0].isupper() for w in inside)
        verb = any(
            form_kind(w.low) in ("3sg", "aux") and inside[i - 1].low not in lexicon.NUMBERS
            for i, w in enumerate(inside)
            if not w.mention and not (i == 0 and singular(w.low) in _BORNE)
        )
        several = any(w.low == "and" for w in inside) and inside[0].low not in ("in", "with")
        return None if named or verb or several else at
    return None


def _with_something(apposition: list[Word]) -> list[Word]:
    """Return the part of an apposition that tells what a person has with them."""
    at = next((index for index, word in enumerate(apposition) if word.low == "with"), len(apposition))
    belongs = any(word.low in lexicon.PREPOSITIONS for word in apposition[at + 1 :])
    return apposition[at:] if belongs else []


def _complete_fragment(words: list[Word]) -> list[Word]:
    """Insert ``was`` into a sentence without a verb: ``MAN #2 on the bed``, ``Behind her, JO``."""
    if not words:
        return words
    compound = any(_starts_with(words, each) for each in lexicon.COMPOUND_PREPOSITIONS.get(words[0].low, ()))
    if (words[0].low in lexicon.PREPOSITIONS or compound) and words[0].mention is None:
        return _turn_around(words)
    at = next((index for index, word in enumerate(words) if index and _starts_predicate(word)), None)
    if at is None or not (words[at - 1].solid or words[at - 1].text == ","):
        return words
    if any(word.low == "with" for word in words[:at]) and [w.low for w in words[at + 1 : at + 2]] in (["it"], ["them"]):
        return words  # a table with a jug on it
    if words[at - 1].text == "," and words[0].mention:
        comma = next(index for index, word in enumerate(words) if word.text == ",")
        words, at = words[:comma] + words[at:], comma
    return [*words[:at], inserted_was(words[at].start), *words[at:]]


def _starts_with(words: list[Word], phrase: tuple[str, ...]) -> bool:
    """Whether the words start with a phrase."""
    return tuple(word.low for word in words[: len(phrase)]) == phrase


def _starts_predicate(word: Word) -> bool:
    """Whether a word can start a predicate."""
    if word.mention:
        return False
    return word.low in _PREDICATES or (word.low in lexicon.PREPOSITIONS and word.low not in _NO_FRAGMENT)


def _is_list(words: list[Word]) -> bool:
    """Whether a sentence is a list of things: ``On the table, a lamp, two glasses and a gun``."""
    commas = [index for index, word in enumerate(words) if word.text == ","]
    heads = [words[index + 1].low for index in commas if index + 1 < len(words)]
    several = bool(commas) or any(word.low == "and" for word in words)
    nobody = not any(word.named for word in words)
    return several and nobody and not any(low.endswith("ing") or low in lexicon.ADJECTIVES for low in heads)


def _turn_around(words: list[Word]) -> list[Word]:
    """Move a fronted place behind its subject: ``Behind her, JO holding a doll`` -> JO was behind her."""
    comma = next((index for index, word in enumerate(words) if word.text == ","), None)
    while words and words[-1].text in ".!?":
        words = words[:-1]
    if len(words) > 2 and words[1].low in lexicon.PRONOUNS and words[2].named:
        place, rest = words[:2], words[2:]
    elif comma is None or comma >= 6 or comma + 1 >= len(words):
        return words
    else:
        place, rest = words[:comma], words[comma + 1 :]
    placing = lexicon.PREPOSITIONS - {"of"}
    prepositions = [i for i, word in enumerate(rest) if word.low in placing and not word.mention]
    first = prepositions[0] if prepositions else len(rest)
    cut = next((index for index, word in enumerate(rest) if word.text == ","), first)
    if _is_list(rest[:first]):
        cut = first
    return [*rest[:cut], inserted_was(words[0].start), *place, *rest[cut:]]
