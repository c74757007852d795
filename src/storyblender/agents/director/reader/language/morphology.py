"""Verb forms: which verb a written form belongs to; and which nouns name people."""

from __future__ import annotations

import re
from functools import cache
from typing import Literal, NamedTuple

from storyblender.agents.director import lexicon

FormKind = Literal["base", "3sg", "past", "ing", "pp", "aux", "inf"]


class VerbForm(NamedTuple):
    """A verb as it stands in the text."""

    lemma: str
    kind: FormKind


_SHORT = re.compile(r"[^aeiouy]+[aeiou][bdgmnprt]$")
"""One short vowel, one consonant: the consonant is doubled."""


def third_person(verb: str) -> str:
    """Return the third person of a verb: ``watch`` -> ``watches``, ``carry`` -> ``carries``."""
    if re.search(r"(s|x|z|ch|sh|o)$", verb):
        return verb + "es"
    return verb[:-1] + "ies" if re.search(r"[^aeiou]y$", verb) else verb + "s"


def past_tense(verb: str) -> str:
    """Return the past tense of a verb: ``take`` -> ``took``, ``stop`` -> ``stopped``."""
    if verb in lexicon.IRREGULAR_PAST:
        return lexicon.IRREGULAR_PAST[verb]
    if verb in lexicon.DOUBLING or _SHORT.match(verb):
        return verb + verb[-1] + "ed"
    if verb.endswith("e"):
        return verb + "d"
    return verb[:-1] + "ied" if re.search(r"[^aeiou]y$", verb) else verb + "ed"


def present_participle(verb: str) -> str:
    """Return the present participle of a verb: ``lie`` -> ``lying``, ``sit`` -> ``sitting``."""
    if verb in ("lie", "die"):
        return verb[:-2] + "ying"
    if verb in lexicon.DOUBLING_ING or _SHORT.match(verb):
        return verb + verb[-1] + "ing"
    return verb + "ing" if verb.endswith("ee") or not verb.endswith("e") else verb[:-1] + "ing"


def _all_forms() -> dict[str, VerbForm]:
    forms: dict[str, VerbForm] = {}
    for verb in lexicon.VERBS:
        forms.setdefault(present_participle(verb), VerbForm(verb, "ing"))
        forms.setdefault(verb, VerbForm(verb, "base"))
        forms[third_person(verb)] = VerbForm(verb, "3sg")
    for verb in lexicon.VERBS:
        past = past_tense(verb)
        if past not in forms or forms[past].lemma == verb:
            forms[past] = VerbForm(verb, "past")
    for form, (lemma, kind) in lexicon.ODD_FORMS.items():
        forms[form] = VerbForm(lemma, kind)  # type: ignore[arg-type]
    return forms


FORMS: dict[str, VerbForm] = _all_forms()
"""Every written form of every known verb."""


def _rare_forms() -> dict[str, VerbForm]:
    """Forms of the verbs of the large list, with and without a doubled consonant."""
    forms: dict[str, VerbForm] = {}
    for verb in sorted(lexicon.OTHER_VERBS):
        stems = [verb, verb + verb[-1]] if re.search(r"[^aeiou][aeiou][bdgklmnprt]$", verb) else [verb]
        forms.setdefault(verb, VerbForm(verb, "base"))
        forms.setdefault(third_person(verb), VerbForm(verb, "3sg"))
        for stem in stems:
            forms.setdefault(present_participle(stem), VerbForm(verb, "ing"))
            forms.setdefault(past_tense(stem), VerbForm(verb, "past"))
    return {word: form for word, form in forms.items() if word not in FORMS}


RARE_FORMS: dict[str, VerbForm] = _rare_forms()
"""Forms of verbs whose motion nobody knows; many are nouns or adjectives too."""


def form_kind(word: str) -> str:
    """Kind of the verb form a lower-case word can be, or an empty string."""
    form = FORMS.get(word)
    return form.kind if form else ""


def guess_lemma(form: str) -> str:
    """The verb of an unknown third-person form: ``glides`` -> ``glide``, ``barrels`` -> ``barrel``."""
    if re.search(r"(sh|ch|x|ss|zz)es$", form):
        return form[:-2]
    return form[:-3] + "y" if form.endswith("ies") else form[:-1]


_NOT_PERSON = frozenset({"human", "german", "roman", "talisman"})


@cache
def is_person_noun(noun: str) -> bool:
    """Whether a singular noun names a person or an animal: ``waiter``, ``fox``, anything in -man, -woman or -master."""
    if noun in lexicon.PERSON_NOUNS:
        return True
    return (
        noun not in _NOT_PERSON and re.search(r"..(woman|man|boy|girl|lady)$|.{3}(master|mistress)$", noun) is not None
    )
