"""Which people a noun phrase refers to: names, ``the old woman``, ``her uncle``, ``the visitor`` (notes, 1d)."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.words import EVERYBODY, Mention
from storyblender.agents.director.reader.people.look import approximate_age
from storyblender.agents.director.reader.people.narrator import TOGETHER, narrator_group
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.memory.vocabulary import Gender

_GENDERED = frozenset({"man", "woman", "boy", "girl", "lady", "guy", "gentleman"})
_ELDERS = lexicon.KIN - lexicon.YOUNGER_KIN - {"brother", "sister", "husband", "wife"}
_SIBLINGS = frozenset({"brother", "sister"})
_PAIRS = lexicon.words("pairs")
_YOUTH = 17
_SMALL = frozenset({"small", "little", "tiny", "petite", "short", "slight", "thin", "slim", "skinny", "frail"})
_LARGE = frozenset({"big", "large", "huge", "tall", "heavy", "fat", "stout", "burly", "broad", "massive", "towering"})


def gender_fits(person: Person, gender: Gender) -> bool:
    """Whether a person may have a gender: theirs is the same or unknown, or the gender is unknown.

    Args:
        person: The person.
        gender: The gender of a noun or pronoun.
    """
    return "unknown" in (person.gender, gender) or person.gender == gender


def may_be_it(person: Person) -> bool:
    """Whether a person may be called ``it``: animals and robots."""
    return person.kind == "animal" or person.role in lexicon.NEUTER_ROLES


def resolve_mention(state: ReaderState, mention: Mention) -> list[Person]:
    """Return the people whom a mention means, and keep the answer in the mention.

    Args:
        state: The reader's state.
        mention: The mention.
    """
    if not mention.people:
        if mention.kind == "group":
            mention.people = _group(state, mention)
        elif mention.kind == "generic":
            mention.people = _by_gender_and_age(state, mention)
        else:
            mention.people = [max(_without_title(mention.candidates), key=state.prominence)]
    return mention.people


def _without_title(people: list[Person]) -> list[Person]:
    """Prefer the person without a title: ``Reyes`` is Daniel Reyes and not his mother, Mrs. Reyes."""
    plain = [person for person in people if person.name.lower().split()[0].strip(".") not in lexicon.TITLES]
    return plain if len(people) > 1 and plain else people


def _by_gender_and_age(state: ReaderState, mention: Mention) -> list[Person]:
    """Return the person on stage whom ``the old woman`` or ``the girl`` means by gender and age."""
    candidates = mention.candidates
    if candidates and mention.determiner in ("a", "an"):
        exact = [person for person in candidates if person.first == mention.start]
        if exact or mention.head in _GENDERED:
            return (exact or candidates)[:1]
    if mention.head in _GENDERED and lexicon.AGED & set(mention.adjectives):
        return _oldest(state, mention)
    here = _without_owner(state, mention, [person for person in candidates if person.id in state.scene.on])
    if not here and is_epithet(mention.head) and mention.determiner not in ("a", "an"):
        return people_for_epithet(state, mention) or candidates[:1]
    if here or (candidates and mention.head not in _GENDERED):
        return [max(here or candidates, key=state.prominence)]
    if mention.head == "couple":
        return [person for person in state.referable_people() if {"husband", "wife"} & set(person.aliases)]
    if mention.determiner in lexicon.POSSESSIVES:
        return _kin(state, mention)
    if mention.determiner not in ("the", "that", "this"):
        return []
    if mention.head in ("animal", "beast", "creature"):
        return sorted((p for p in state.referable_people() if may_be_it(p)), key=state.prominence)[-1:]
    if mention.head in lexicon.ANIMALS:
        return []
    gender = lexicon.gender_of_word(mention.head)
    young = mention.head in lexicon.YOUNG_NOUNS
    pool = [
        person
        for person in state.referable_people()
        if gender_fits(person, gender)
        and person.kind == "human"
        and (not person.role or young or mention.head in _GENDERED | lexicon.KIN)
    ]
    if not pool:
        pool = [person for person in state.referable_people() if gender_fits(person, gender) and person.kind == "human"]
    small, large = set(mention.adjectives) & _SMALL, set(mention.adjectives) & _LARGE
    if small or large:
        pool.sort(
            key=lambda person: (_was_introduced_with(person, _LARGE if small else _SMALL), -state.prominence(person)[1])
        )
    elif young:
        pool = [person for person in pool if approximate_age(person) < 31 and not _ELDERS & set(person.aliases)]
        pool = [person for person in pool if person.gender == gender] or pool
        pool.sort(key=lambda p: (approximate_age(p) > _YOUTH, not p.age, -state.discourse.salience.get(p.id, 0.0)))
    else:
        nameless = mention.head in lexicon.KIN
        pool.sort(key=lambda p: (nameless and p.role not in _GENDERED, -state.discourse.salience.get(p.id, 0.0)))
    return pool[:1]


def _without_owner(state: ReaderState, mention: Mention, people: list[Person]) -> list[Person]:
    """Leave out the owner of a possessive: ``her sister`` is not she herself, though she is a sister too."""
    if mention.determiner not in lexicon.POSSESSIVES or mention.head not in _SIBLINGS:
        return people
    acting = state.sentence.subjects or state.discourse.subjects
    return [person for person in people if person not in acting] or people


def _oldest(state: ReaderState, mention: Mention) -> list[Person]:
    """Return whom ``the old man`` means: who was called so, else the oldest of that gender."""
    gender, name = lexicon.gender_of_word(mention.head), f"old {mention.head}"
    pool = [person for person in state.referable_people() if gender_fits(person, gender) and person.kind == "human"]
    pool = pool or nearest_mentioned(state, mention.start, gender)
    called = state.discourse.epithets.get(name)
    if called in pool:
        return [called]
    pool.sort(
        key=lambda p: (-approximate_age(p), mention.head not in (p.role, *p.aliases), not _ELDERS & set(p.aliases))
    )
    if pool:
        state.discourse.epithets[name] = pool[0]
    return pool[:1]


def _was_introduced_with(person: Person, sizes: frozenset[str]) -> bool:
    """Whether a person was introduced with a word of size such as ``small``."""
    return any(word in sizes for build in person.build for word in build.lower().split())


def _kin(state: ReaderState, mention: Mention) -> list[Person]:
    """Return whom ``her uncle`` means where she was introduced as a niece: another person of that gender."""
    converse = lexicon.CONVERSE_KIN.get(mention.head, ())
    if not any(person.role in converse for person in state.roster.people):
        return _relative(state, mention) if converse else []
    gender = lexicon.gender_of_word(mention.head)
    pool = [
        person
        for person in state.referable_people()
        if person.kind == "human" and person.gender == gender and person.role not in converse and not person.age
    ]
    return [max(pool, key=state.prominence)] if pool else []


def _relative(state: ReaderState, mention: Mention) -> list[Person]:
    """Return whom ``her father`` means without a known kinship: the oldest man, for a daughter the youngest woman."""
    gender = lexicon.gender_of_word(mention.head)
    pool = [p for p in state.referable_people() if p.kind == "human" and p.count == 1 and p.gender == gender]
    young = mention.head in lexicon.YOUNGER_KIN
    if young:
        pool = [person for person in pool if not _ELDERS & set(person.aliases)] or pool
    pool.sort(key=lambda person: (approximate_age(person) * (1 if young else -1), -state.prominence(person)[1]))
    return pool[:1]


def _group(state: ReaderState, mention: Mention) -> list[Person]:
    """Return whom ``the guards`` or ``two men`` means: numbered cast, fitting people on stage, or the last group."""
    if mention.head == "listener":
        return listeners(state)
    if mention.head == "them":
        return _last_mentioned(state, mention.number)
    if mention.head in TOGETHER:
        return narrator_group(state, mention.head)
    exact = [person for person in mention.candidates if person.first == mention.start and person.kind == "group"]
    if exact:
        return exact
    numbered = [p for p in state.roster.people if p.role == mention.head and re.search(r"\d$", p.id)]
    absent = not any(person.id in state.scene.on for person in numbered)
    if mention.number > 1 and len(numbered) == mention.number and not (mention.determiner == "the" and absent):
        return numbered
    gender = lexicon.gender_of_word(mention.head)
    pool = [
        person
        for person in state.referable_people()
        if person.role == mention.head
        or (
            mention.head in _GENDERED and gender != "unknown" and gender_fits(person, gender) and person.kind == "human"
        )
    ]
    pool = [person for person in pool if person.gender == gender or person.role == mention.head] or pool
    if mention.determiner in lexicon.POSSESSIVES and mention.head == "man":
        pool = [person for person in state.referable_people() if person.count > 1]
    pool = pool or [person for person in state.roster.people if person.role == mention.head]
    if not pool and (mention.head in _PAIRS or mention.number == 2):
        pool = _pair(state, mention, gender)
    if len(pool) > mention.number > 1:
        exact = [person for person in pool if person.role == mention.head]
        ranked = sorted(pool, key=lambda person: -state.discourse.salience.get(person.id, 0.0))
        pool = exact if len(exact) >= mention.number else ranked[: mention.number]
    return pool


def _pair(state: ReaderState, mention: Mention, gender: Gender) -> list[Person]:
    """Return whom ``the two`` or ``the children`` means: the last group, or those mentioned last."""
    young = mention.head in lexicon.YOUNG_NOUNS
    if not young:
        for _, group, _ in reversed(state.discourse.groups):
            if all(gender_fits(person, gender) for person in group):
                return group
    here = [
        person
        for person in state.referable_people()
        if gender_fits(person, gender)
        and person.kind == "human"
        and not (
            young and (re.search(r"[2-9]0s|old", person.age) or approximate_age(person) > 30 or _has_title(person))
        )
    ]
    here.sort(key=lambda person: -state.discourse.last_named.get(person.id, 0))
    return here[: max(mention.number, 2)]


def _last_mentioned(state: ReaderState, number: int) -> list[Person]:
    """Return this number of people on stage, those mentioned last."""
    here = [person for person in state.referable_people() if person.kind == "human" and person.count == 1]
    number = len(here) if number == EVERYBODY else number
    others = [person for person in here if person not in state.sentence.subjects]
    here = others if len(others) >= number > 2 else here
    here.sort(key=lambda person: -state.discourse.last_named.get(person.id, 0))
    return here[:number] if len(here) >= number else []


def _has_title(person: Person) -> bool:
    """Whether a person is called Mr. or Mrs., and so is no child."""
    return person.name.lower().split()[0].strip(".") in lexicon.TITLES


def is_epithet(noun: str) -> bool:
    """Whether a definite noun rather means a known person than a new one: ``the visitor``."""
    return noun in lexicon.ARRIVALS | lexicon.HOSTS | lexicon.COMPANY | lexicon.CALLINGS


def people_for_epithet(state: ReaderState, mention: Mention) -> list[Person]:
    """Return the people on stage whom an epithet means: ``the visitor``, ``his host``, ``the other``.

    Args:
        state: The reader's state.
        mention: The mention of the epithet.
    """
    told = {person.id: person for person in state.referable_people()}
    here = [told[id] for id in state.scene.on if id in told and told[id].kind == "human" and told[id].count == 1]
    gender = lexicon.gender_of_word(mention.head)
    here = [person for person in here if gender in (person.gender, "unknown") or person.gender == "unknown"]
    called = state.discourse.epithets.get(mention.head)
    if called in here and "new" not in mention.adjectives:
        return [called]
    by_recency = sorted(here, key=lambda person: -state.discourse.last_named.get(person.id, 0))
    if mention.head in lexicon.ARRIVALS:
        found = here[::-1]
    elif mention.head in lexicon.HOSTS:
        found = here
    elif mention.head in ("latter", "former"):
        return by_recency[:1] if mention.head == "latter" else by_recency[1:2]
    elif mention.head in lexicon.COMPANY:
        others = [person for person in by_recency if person not in state.discourse.subjects]
        newest = [state.discourse.epithets.get(noun) for noun in sorted(lexicon.ARRIVALS)]
        old_friends = [person for person in others if person not in newest]
        return (others if mention.head == "other" else old_friends or others)[:1]
    else:
        found = by_recency or nearest_mentioned(state, mention.start, gender)
    if found:
        state.discourse.epithets[mention.head] = found[0]
    return found[:1]


def listeners(state: ReaderState) -> list[Person]:
    """Return everybody on stage but the last speaker: ``His three listeners``."""
    return [person for person in state.on_stage() if person not in state.discourse.subjects]


def nearest_mentioned(state: ReaderState, at: int, gender: Gender) -> list[Person]:
    """Return people of a gender by how near their first mention is to an offset; for a name told later.

    Args:
        state: The state before the mention.
        at: Offset of the mention.
        gender: What the noun tells; unknown fits everybody.
    """
    if state.reading.screenplay.format != "prose":
        return []
    cast = [person for person in state.roster.people if person.kind == "human" and person.count == 1]
    cast = [person for person in cast if gender == "unknown" or person.gender == gender]
    return sorted(cast, key=lambda person: (person.id not in state.scene.named, abs(person.first - at)))
