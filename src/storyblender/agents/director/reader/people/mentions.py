"""Finds mentions of people in a sentence: the longest known name wins, then nouns for people with a determiner."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import FORMS, form_kind, is_person_noun
from storyblender.agents.director.reader.language.words import EVERYBODY, Mention, Word
from storyblender.agents.director.reader.people.look import approximate_age
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.reading import Person
from storyblender.catalog.inflection import singular

_OLD = 50
"""Years from which a person may be ``the old man``."""
_COUNTS = frozenset(lexicon.NUMBERS) - {"a", "an", "one"}
_OF_THEM = 3
_NOT_ALONE = frozenset({"cook", "guide"})
_OPENERS = lexicon.DETERMINERS | lexicon.POSSESSIVES
_THINGS = lexicon.PROPS | lexicon.SET_PIECES | lexicon.WORN | lexicon.SCENERY
_SMALL = lexicon.PREPOSITIONS | lexicon.PARTICLES | lexicon.ADVERBS | lexicon.CONJUNCTIONS
_LOOKS = lexicon.ADJECTIVES | lexicon.BUILD | lexicon.HAIR | lexicon.FACE | lexicon.VARIANT_WORDS
_NO_ADJECTIVES = _OPENERS | lexicon.PREPOSITIONS


def mark_mentions(words: list[Word], roster: Roster) -> list[Word]:
    """Return the words with the words of each name joined into one that carries its mention.

    Args:
        words: A paragraph.
        roster: The cast, indexed.
    """
    marked: list[Word] = []
    at = 0
    while at < len(words):
        several = _so_many_of_them(words, at)
        if several:
            marked.append(several)
            at += _OF_THEM
            continue
        alone = _all_alone(words, at)
        if alone:
            marked.append(alone)
            at += alone.text.count(" ") + 1
            continue
        length, people = _longest_name(words, at, roster)
        if length:
            run = words[at : at + length]
            role = people[0].role if people[0].role == run[-1].low else ""
            if run[0].text[0].isupper() or _after_determiner(marked) or _is_named_ones(marked, words, at + length):
                start = _phrase_start(marked, run[0].start) if role else run[0].start
                mention = Mention("role" if role else "name", people, run[-1].low, start=start)
                name = " ".join(word.text for word in run)
                marked.append(Word(name, run[0].start, run[-1].end, mention))
                at += length
                continue
        word = words[at]
        word.mention = _noun_phrase(words, at, roster)
        marked.append(word)
        at += 1
    return marked


def _so_many_of_them(words: list[Word], at: int) -> Word | None:
    """Return a group mention: ``the two of them``, ``all three of them``."""
    run = words[at : at + _OF_THEM]
    low = [word.low for word in run]
    whole = low[:1] in (["all"], ["both"]) or (at > 0 and words[at - 1].low in ("the", "all"))
    if not whole or low[1:] != ["of", "them"] or low[0] not in _COUNTS | {"all"}:
        return None
    start = words[at - 1].start if low[0] not in ("all", "both") else run[0].start
    mention = Mention("group", [], "them", "the", number=lexicon.NUMBERS.get(low[0], EVERYBODY), start=start)
    return Word("them", run[0].start, run[-1].end, mention)


def _all_alone(words: list[Word], at: int) -> Word | None:
    """Return a group mention for a pronoun as subject: ``Everybody turns``, ``All three listen``."""
    low = [word.low for word in words[at : at + 2]]
    opens = at == 0 or not words[at - 1].solid or words[at - 1].low in lexicon.CONJUNCTIONS
    count = 2 if low[0] == "all" and low[1:] and low[1] in _COUNTS else 1
    if not opens or (low[0] not in ("everyone", "everybody", "both") and count == 1):
        return None
    verb, after = words[at + count : at + count + 1], words[at + count + 1 : at + count + 2]
    kind = form_kind(verb[0].low) if verb else ""
    singly = low[0] in ("everyone", "everybody")
    goes_on = not after or after[0].low in _SMALL or not after[0].solid or after[0].low.endswith("ly")
    if kind not in (("3sg", "past") if singly else ("base", "past")) or not goes_on:
        return None
    number = EVERYBODY if singly else lexicon.NUMBERS[low[count - 1]]
    run = words[at : at + count]
    mention = Mention("group", [], "them", "the", number=number, start=run[0].start)
    return Word(" ".join(word.text for word in run), run[0].start, run[-1].end, mention)


def _longest_name(words: list[Word], at: int, roster: Roster) -> tuple[int, list[Person]]:
    """Return the index after the longest known name at an index, and the people who have it."""
    named = words[at].text[0].isupper()
    for length in range(min(roster.longest.get(words[at].low, 0), len(words) - at), 0, -1):
        key = tuple(word.low for word in words[at : at + length])
        people = roster.by_name.get(key)
        if not people or key == ("the",):
            continue
        role = people[0].role
        if (
            at
            and words[at - 1].low in lexicon.AGED
            and key == (role,)
            and not any(approximate_age(person) > _OLD for person in people)
        ):
            continue
        if named or (role and (singular(key[-1]) == role or key[-1].strip("#").isdigit())):
            return length, people
    return 0, []


def _phrase_start(before: list[Word], start: int) -> int:
    """Return the offset of the determiner at most three words back, else ``start``."""
    for word in reversed(before[-4:]):
        if word.low in _OPENERS:
            return word.start
        if not word.text.islower() or word.low in lexicon.PREPOSITIONS or word.low in FORMS:
            break
    return start


def _after_determiner(words: list[Word]) -> bool:
    """Whether the words so far end in a determiner and at most three adjectives."""
    at = len(words) - 1
    while (
        at > len(words) - 4
        and at >= 0
        and words[at].text.islower()
        and words[at].low not in _NO_ADJECTIVES
        and words[at].low not in FORMS
    ):
        at -= 1
    return at >= 0 and words[at].low in _OPENERS


def _is_named_ones(marked: list[Word], words: list[Word], end: int) -> bool:
    """Whether kin has an owner by name and no name of its own: ``Emil's mother``."""
    named = len(marked) > 1 and marked[-1].low == "'s" and marked[-2].named
    return named and not (end < len(words) and words[end].text == ",")


def _is_compound(words: list[Word], at: int) -> bool:
    """Whether a person noun is only a part of a thing's name: ``the witness stand``, ``a cowboy hat``."""
    following = words[at + 1] if at + 1 < len(words) else None
    if following is None or not following.text.islower() or form_kind(following.low) not in ("", "base"):
        return False
    return following.low in _THINGS or (form_kind(following.low) == "base" and following.low not in _SMALL)


def _acts(words: list[Word], at: int, noun: str) -> bool:
    """Whether a person noun is a verb here: ``and rams the hose back``, ``guards the door``."""
    following = words[at + 1].low if at + 1 < len(words) else ""
    alone = at > 0 and words[at - 1].low in ("and", ",", "then", "but")
    return noun != words[at].low and alone and following in _OPENERS | {"him", "her", "it", "them"}


def _shared_determiner(words: list[Word], at: int) -> str:
    """Return the determiner that two kin share: ``his wife and son``."""
    if words[at].low not in lexicon.KIN:
        return ""
    before = words[at - 1].low if at else ""
    return before if before in _OPENERS else "the"


def _noun_phrase(words: list[Word], at: int, roster: Roster) -> Mention | None:
    """Return the mention of a noun for people with its determiner: ``the old woman``, ``two guards``."""
    word = words[at]
    noun = singular(word.low)
    if at and f"{words[at - 1].low}-{noun}" in lexicon.COMPOUNDS:
        return None  # a hot dog, a combine harvester
    if not word.text.replace("-", "").isalpha() or not is_person_noun(noun) or noun in _NOT_ALONE:
        return None
    if not (word.text[0].islower() or word.text.isupper() or (at and words[at - 1].low in lexicon.DETERMINERS)):
        return None
    adjectives: list[str] = []
    number, determiner, start, back = 0, "", word.start, at - 1
    while back >= 0 and at - back < 5:
        low = words[back].low
        if low in _COUNTS:
            number, determiner, start = lexicon.NUMBERS[low], determiner or "number", words[back].start
        elif low in _OPENERS:
            determiner, start = low, words[back].start
            break
        elif low == "," and adjectives and back and words[back - 1].low in _LOOKS:
            pass  # a tall, burly man
        elif (
            low in lexicon.PREPOSITIONS
            or not low.replace("-", "").isalpha()
            or (low in FORMS and low not in ("young", "old"))
        ):
            break
        else:
            adjectives.append(low)
        back -= 1
    if not determiner and noun in lexicon.KIN and at > 1 and words[at - 1].low == "and":
        determiner = _shared_determiner(words, at - 2)
    if not determiner and not word.text.isupper():
        return None
    if _acts(words, at, noun) or (noun == word.low and _is_compound(words, at)):
        return None
    several = noun != word.low or number > 1
    introduced = determiner in ("a", "an")
    candidates = roster.with_noun(noun, start if introduced else None)
    return Mention(
        "group" if several else "generic",
        candidates,
        noun,
        determiner,
        adjectives,
        number or (2 if several else 1),
        start,
    )
