"""The roster: the people of the script, and all names they answer to."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable
from functools import lru_cache

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import asset_id
from storyblender.agents.director.reader.language.morphology import is_person_noun
from storyblender.agents.director.reader.language.words import key_of
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import record_fact
from storyblender.catalog.inflection import singular

_WORN = re.compile(r" (?:in|with) (?=(?P<article>(?:an?|the) )?)")
_ARTICLE = re.compile(r"^(the|a|an) ")


@lru_cache(maxsize=16384)
def bare(name: str) -> str:
    """Return a name in lower case, with single spaces and without its article."""
    return _ARTICLE.sub("", " ".join(name.lower().split()))


def _title_and_surname(name: str) -> tuple[str, str] | None:
    """Return the first and the last word of a name of several words, or None."""
    words = name.lower().replace(".", "").split()
    return (words[0], words[-1]) if len(words) > 1 else None


def _is_full_name(first: str, last: str) -> bool:
    """Whether two words are a first name and a surname: in ``Tom Baker`` the trade is a surname."""
    gendered = lexicon.MALE_NOUNS | lexicon.FEMALE_NOUNS | lexicon.YOUNG_NOUNS | lexicon.ANIMALS
    return first in lexicon.FIRST_NAMES and not is_person_noun(first) and last not in gendered


class Roster:
    """All people found so far, in the order in which they were found.

    Attributes:
        people: The cast.
        ids: Asset ids in use, for people and things together.
        by_name: Name, as words -> the people it can mean; filled by ``index``.
        longest: First word of a name -> words in the longest name that starts so.
        narrator: Who tells a story as ``I``.
    """

    def __init__(self) -> None:
        self.people: list[Person] = []
        self._by_id: dict[str, Person] = {}
        self._places: dict[str, int] = {}
        self._answering: dict[str, dict[str, Person]] = {}
        self._wearing: dict[str, dict[str, Person]] = {}
        self._meant: dict[str, dict[str, Person]] = {}
        self._introduced: dict[int, dict[str, Person]] = {}
        self._titled: dict[tuple[str, str], list[Person]] = {}
        self.narrator: Person | None = None
        self.ids: set[str] = set()
        self.by_name: dict[tuple[str, ...], list[Person]] = {}
        self.longest: dict[str, int] = {}

    def find(self, name: str) -> list[Person]:
        """Return the people who answer to a name."""
        return self.in_order(self._answering.get(bare(name), {}).values())

    def person(self, id: str) -> Person | None:
        """Return the person of an id, or None."""
        return self._by_id.get(id)

    def wearing(self, words: str) -> list[Person]:
        """Return the people named by clothes or things: ``grey suit`` finds the MAN IN A GREY SUIT."""
        return self.in_order(self._wearing.get(words, {}).values())

    def with_noun(self, noun: str, start: int | None = None) -> list[Person]:
        """Return the people with a noun as role or name, or first mentioned at an offset; call ``index`` before.

        Args:
            noun: A noun such as ``guard``.
            start: Offset of a first mention, or None.
        """
        introduced = self._introduced.get(start, {}) if start is not None else {}
        return self.in_order((self._meant.get(noun, {}) | introduced).values())

    def in_order(self, people: Iterable[Person]) -> list[Person]:
        """Return people in the order of the cast."""
        return sorted(people, key=lambda person: self._places[person.id])

    def add(self, name: str, first: int = 0) -> Person:
        """Return the person of a name, new if unknown.

        Args:
            name: As written: ``OFFICER HALE``, ``Man in a hat``, ``the old woman``.
            first: Offset of the mention in the script.
        """
        known = self._same_title(name) or self._known(name)
        if known:
            return known
        key = bare(name)
        person = Person(asset_id(key, self.ids), " ".join(name.split()), (key,), first=first)
        self.ids.add(person.id)
        record_fact("person", person.id, first, first + len(person.name))
        self._places[person.id] = len(self._places)
        self.people.append(person)
        self._by_id[person.id] = person
        self._answering.setdefault(key, {})[person.id] = person
        self._note_title(person)
        for worn in _WORN.finditer(key):
            for start in {worn.end(), worn.end("article")} if worn["article"] else {worn.end()}:
                self._wearing.setdefault(key[start:], {})[person.id] = person
        self._names_within(person, key)
        words = [word.strip(".,") for word in key.split()]
        for word in words:
            if person.gender == "unknown":
                person.gender = lexicon.gender_of_word(word)
            person.age = person.age or lexicon.AGE_WORDS.get(word, "")
        person.age = person.age or lexicon.AGE_NOUNS.get(person.role, "")
        if any(word in lexicon.CROWDS for word in words):
            pair = "couple" in words
            person.kind, person.count = "group", max(person.count, 2 if pair else 6)
        return person

    def _same_title(self, name: str) -> Person | None:
        """Return the person with the same title and last name: DR. BENNETT is DR. JULIUS BENNETT."""
        title = _title_and_surname(name)
        known = self.in_order(self._titled.get(title, ())) if title and title[0] in lexicon.TITLES else []
        if known:
            self.add_alias(known[0], bare(name))
        return known[0] if known else None

    def _note_title(self, person: Person) -> None:
        """Note a person's title and surname."""
        title = _title_and_surname(person.name)
        if title:
            self._titled.setdefault(title, []).append(person)

    def _forget_title(self, person: Person) -> None:
        """Forget a person's title and surname."""
        title = _title_and_surname(person.name)
        if title:
            self._titled[title].remove(person)

    def _known(self, name: str) -> Person | None:
        """Return the person who is called by exactly this name or role, or None."""
        written, key = " ".join(name.lower().split()), bare(name)
        answering = self._answering.get(written, {}) | self._answering.get(key, {})
        for person in self.in_order(answering.values()):
            if written in person.aliases or person.role or written == key:
                return person
        return None

    def _names_within(self, person: Person, key: str) -> None:
        """Add short forms: the role of MAN IN A HAT, the last name after a title, the first and last name."""
        core = re.split(r" (?:in|with|of) ", key)[0]
        words = core.split()
        numbered = len(words) > 1 and re.match(r"#?\d", words[-1]) is not None
        head = singular(words[-2] if numbered else words[-1])
        title = words[0].strip(".")
        surname = title in lexicon.TITLES and len(words) > 1 and head in lexicon.RARE_PERSON_NOUNS
        surname = surname or (len(words) > 1 and _is_full_name(words[0], head))
        if is_person_noun(head) and head not in lexicon.FIRST_NAMES and not surname:
            person.role, person.gender = head, lexicon.gender_of_word(head)
            person.kind = "animal" if head in lexicon.ANIMALS else "human"
            self.add_alias(person, core)
        elif title in lexicon.TITLES and len(words) > 1:
            person.gender = lexicon.TITLE_GENDER.get(title) or lexicon.gender_of_word(title)
            person.role = title if is_person_noun(title) else ""
            self.add_alias(person, " ".join(words[1:]))
            for word in words[1:]:
                self.add_alias(person, word)
        elif len(words) > 1:
            for word in (words[0], words[-1]):
                if word not in lexicon.VARIANT_WORDS:
                    self.add_alias(person, word)

    def add_alias(self, person: Person, alias: str) -> None:
        """Let a person answer to one more name.

        Args:
            person: The person.
            alias: The name.
        """
        if alias not in person.aliases:
            person.aliases = (*person.aliases, alias)
            self._answering.setdefault(alias, {})[person.id] = person

    def remove_aliases(self, person: Person, *names: str) -> None:
        """Let a person no longer answer to some names."""
        person.aliases = tuple(alias for alias in person.aliases if alias not in names)
        for name in names:
            self._answering.get(name, {}).pop(person.id, None)

    def rename(self, person: Person, name: str) -> None:
        """Give a person the display name ``name``; they still answer to the old one."""
        self._forget_title(person)
        person.name = name
        self._note_title(person)

    def remove(self, person: Person) -> None:
        """Remove a person from the cast."""
        for worn in self._wearing.values():
            worn.pop(person.id, None)
        for name in person.aliases:
            self._answering.get(name, {}).pop(person.id, None)
        self._forget_title(person)
        self.people.remove(person)
        del self._by_id[person.id]

    def sort(self) -> None:
        """Put the cast in the order of first mentions."""
        self.people.sort(key=lambda person: person.first)
        self._places = {person.id: place for place, person in enumerate(self.people)}

    def link_variants(self) -> None:
        """Link YOUNG EDWARD and ADULT EDWARD to EDWARD as the same person at another age."""
        first_of: dict[str, Person] = {}
        for person in self.people:
            words = bare(person.name).split()
            if not person.role and words[0] not in lexicon.VARIANT_WORDS:
                for alias in person.aliases:
                    first_of.setdefault(alias, person)
        for person in self.people:
            words = bare(person.name).split()
            if not person.role and len(words) > 1 and words[0] in lexicon.VARIANT_WORDS:
                base = first_of.setdefault(" ".join(words[1:]), person)
                if base is not person:
                    person.variant_of = base.id
                    if bare(base.name).split()[0] not in lexicon.VARIANT_WORDS:
                        self.remove_aliases(person, *base.aliases)
                    if person.gender == "unknown":
                        person.gender = base.gender

    def index(self) -> None:
        """Build ``by_name``, by which mentions are found."""
        names: dict[tuple[str, ...], list[Person]] = defaultdict(list)
        for person in self.people:
            for alias in person.aliases:
                names[key_of(alias)].append(person)
        self.by_name = dict(names)
        self._meant, self._introduced = defaultdict(dict), defaultdict(dict)
        for person in self.people:
            self._introduced[person.first][person.id] = person
            for noun in (person.role, *person.aliases):
                self._meant[noun][person.id] = person
        self.longest = {}
        for key in filter(None, names):
            self.longest[key[0]] = max(self.longest.get(key[0], 0), len(key))
