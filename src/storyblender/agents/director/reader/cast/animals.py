"""Which animals of a story are cast: those that act, not the horse that is watered."""

from __future__ import annotations

import re
from functools import lru_cache

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import FORMS
from storyblender.agents.director.reader.language.person_nouns import PersonNoun, find_person_nouns
from storyblender.agents.director.reader.manuscript import Manuscript
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.rules import rule
from storyblender.catalog.inflection import singular

_CLAUSE = r"(?:,? (?:who|which|that) [^.;,]*,?|, [^.;,]*,| (?:in|on|with|of|at) [^.;,]*?)?"
_ANY = frozenset({"animal", "creature", "beast"})
_DOING = lexicon.words("doing")
_BEING = frozenset({"sit", "stand", "lie", "come", "run", "go", "live", "trot", "hop", "sleep", "appear", "wait"})
"""Verbs an animal may follow: ``on the step sat a cat``."""
_TOY_ANIMALS = re.compile(rf"\b(?:{'|'.join(sorted(lexicon.words('toys')))})\s+(?=(\w+))", re.IGNORECASE)
"""``a teddy bear``: words that make an animal a thing."""
_MOVES = frozenset({"walk", "run", "sneak", "lie_down", "sit", "sleep", "stagger", "eat"})
_TINY = frozenset({"ant", "bee", "beetle", "butterfly", "fly", "moth", "spider", "wasp", "mosquito", "bird", "gull"})


@lru_cache(maxsize=256)
def animal_acts(animal: str, told: str) -> bool:
    """Whether an animal is at least once the subject of an action, also as ``the bird`` or ``the animal``.

    Args:
        animal: Its noun.
        told: The story without speeches.
    """
    called = {animal} | _ANY | {kind for kind, animals in lexicon.KINDS.items() if animal in animals}
    nouns = "|".join(sorted(called))
    acting = re.compile(rf"\b\w+ (?:[\w-]+ ){{0,2}}((?:{nouns})\w*){_CLAUSE} (?:\w+ly )?([a-z]+)\b", re.IGNORECASE)
    if any(singular(match.group(1)) in called and _is_action_word(match.group(2)) for match in acting.finditer(told)):
        return True
    appearing = re.compile(rf"\b([a-z]+) (?:an?|the|his|her|their) (?:[\w-]+ ){{0,2}}(?:{animal})\b")
    return any(_appears(match.group(1)) for match in appearing.finditer(told))


@rule("people.animal_that_acts")
def add_animals(roster: Roster, script: Manuscript) -> None:
    """Cast the animals of a screenplay that are written in small letters.

    Args:
        roster: The cast; changed in place.
        script: The script.
    """
    first: dict[str, int] = {}
    toys = {toy.lower() for toy in _TOY_ANIMALS.findall(script.text)}
    roles = {person.role for person in roster.people}
    for paragraph in script.paragraphs:
        for phrase in find_person_nouns(paragraph.raw) if paragraph.kind == "action" else ():
            known = phrase.noun in roles or bool(roster.find(phrase.noun))
            alive = phrase.noun in lexicon.ANIMALS and phrase.noun not in lexicon.PROPS and phrase.noun not in toys
            if alive and not phrase.plural and not known:
                if phrase.noun in first or _moves_about(phrase, paragraph.raw):
                    roster.add(phrase.noun, first.get(phrase.noun, paragraph.start + phrase.start))
                first.setdefault(phrase.noun, paragraph.start + phrase.start)
    roster.sort()


def _moves_about(animal: PersonNoun, text: str) -> bool:
    """Whether an animal moves through the scene, as in ``A lame dog limps out of the arcade``."""
    verb = re.match(r"\s+([a-z]+)", text[animal.end :])
    form = FORMS.get(verb.group(1)) if verb else None
    moves = form is not None and form.kind in ("3sg", "past") and lexicon.MOTION_OF_VERB.get(form.lemma) in _MOVES
    return moves and animal.determiner in ("a", "an") and animal.noun not in _TINY


def _is_action_word(word: str) -> bool:
    """Whether a word is a verb of action."""
    form = FORMS.get(word)
    if form is None or form.kind not in ("past", "3sg", "aux"):
        return False
    done = word.endswith("ed") and form.lemma not in _DOING and form.lemma not in lexicon.MOTION_OF_VERB
    return form.kind != "past" or not done


def _appears(word: str) -> bool:
    """Whether a word is a verb of appearing."""
    form = FORMS.get(word)
    return form is not None and form.kind in ("past", "3sg") and form.lemma in _BEING
