"""Which animals of a story are cast: those that do something, not the horse somebody waters."""

from __future__ import annotations

import re
from functools import lru_cache

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import FORMS, singular

_CLAUSE = r"(?:,? (?:who|which|that) [^.;,]*,?|, [^.;,]*,| (?:in|on|with|of|at) [^.;,]*?)?"
_ANY = frozenset({"animal", "creature", "beast"})
_DOING = frozenset(
    {
        "begin",
        "start",
        "stop",
        "bark",
        "growl",
        "howl",
        "purr",
        "bite",
        "lick",
        "sniff",
        "wag",
        "sneeze",
        "yawn",
        "blink",
    }
)
_BEING = frozenset({"sit", "stand", "lie", "come", "run", "go", "live", "trot", "hop", "sleep", "appear", "wait"})
"""Verbs an animal may follow: ``on the step sat a cat``."""


@lru_cache(maxsize=256)
def does_something(animal: str, told: str) -> bool:
    """Whether an animal is once the subject of something it does, also as ``the bird`` or ``the animal``.

    Args:
        animal: The noun, singular.
        told: The script without what is said.
    """
    called = {animal} | _ANY | {kind for kind, animals in lexicon.KINDS.items() if animal in animals}
    nouns = "|".join(sorted(called))
    acting = re.compile(rf"\b\w+ (?:[\w-]+ ){{0,2}}((?:{nouns})\w*){_CLAUSE} (?:\w+ly )?([a-z]+)\b", re.IGNORECASE)
    if any(singular(match.group(1)) in called and _acts(match.group(2)) for match in acting.finditer(told)):
        return True
    appearing = re.compile(rf"\b([a-z]+) (?:an?|the|his|her|their) (?:[\w-]+ ){{0,2}}(?:{animal})\b")
    return any(_appears(match.group(1)) for match in appearing.finditer(told))


def _acts(word: str) -> bool:
    form = FORMS.get(word)
    if form is None or form.kind not in ("past", "3sg", "aux"):
        return False
    done = word.endswith("ed") and form.lemma not in _DOING and form.lemma not in lexicon.MOTION_OF_VERB
    return form.kind != "past" or not done


def _appears(word: str) -> bool:
    form = FORMS.get(word)
    return form is not None and form.kind in ("past", "3sg") and form.lemma in _BEING
