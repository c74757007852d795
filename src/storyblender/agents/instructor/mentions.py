"""Words of a person that mean people and things of the story: a name, a part of one, ``her``, ``both of them``."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

MARK: Final = "@"
"""Stands for a mention in the words that phrases are compared with."""
WHO: Final = rf"{MARK}(?:(?: ?, ?and | ?, ?| and | & ){MARK})*"
"""One mention or several."""
_PAIR: Final = r"(?:the )?two of them|(?:them )?both(?: (?:of them|people|characters))?"
_ALL: Final = (
    r"everybody|everyone|(?:them )?all(?: (?:of (?:them|us)|people|characters))?|the (?:whole )?group"
    r"|(?:all (?:the )?|the )(?:three|four|five)(?: of them| people)?"
)
_NO_NAME: Final = frozenset(("the", "and", "for", "with", "from", "off"))
_PRONOUNS: Final = {"him": "male", "he": "male", "his": "male", "her": "female", "she": "female"}


@dataclass(frozen=True)
class Present:
    """Who is there in a shot.

    Attributes:
        people: Ids of the people on stage, in order.
        genders: Gender of each, by id.
    """

    people: Sequence[str] = ()
    genders: Mapping[str, str] | None = None


class Mentions:
    """Finds who and what words mean.

    Args:
        names: Name of every character and object by id.
    """

    def __init__(self, names: Mapping[str, str]) -> None:
        self._forms = _forms(names)
        alternatives = [re.escape(form) for form in sorted(self._forms, key=len, reverse=True)]
        pattern = "|".join((_PAIR, _ALL, *_PRONOUNS, *alternatives))
        self._pattern = re.compile(rf"(?<![\w@])(?:(?:the|a|an) )?(?P<who>{pattern})(?!\w)", re.IGNORECASE)

    def marked(self, words: str) -> tuple[str, list[str]]:
        """Return words with a mark in place of each mention, and the mentions in order.

        Args:
            words: Of a person, in lower case.
        """
        found = [match["who"] for match in self._pattern.finditer(words)]
        return self._pattern.sub(MARK, words), found

    def ids(self, mention: str, present: Present) -> list[str]:
        """Return the ids that a mention means in a shot; empty if it is not clear whom it means.

        Args:
            mention: One that was found.
            present: Who is there.
        """
        if re.fullmatch(_PAIR, mention):
            return list(present.people) if len(present.people) == 2 else []
        if re.fullmatch(_ALL, mention):
            return list(present.people)
        if mention in _PRONOUNS:
            gender, known = _PRONOUNS[mention], present.genders or {}
            meant = [each for each in present.people if known.get(each) == gender]
            return meant if len(meant) == 1 else []
        return [self._forms[mention]]

    def named(self, words: str) -> list[str]:
        """Return the ids of the people and things that words name, in order."""
        marks = (each for each in self.marked(words.lower())[1] if each in self._forms)
        return list(dict.fromkeys(self._forms[each] for each in marks))


def is_group(mention: str) -> bool:
    """Return whether a mention means people by their number: ``both of them``, ``everyone``."""
    return re.fullmatch(f"{_PAIR}|{_ALL}", mention) is not None


def _forms(names: Mapping[str, str]) -> dict[str, str]:
    """Return the id for each way to name a person or a thing; a word that several names have means none of them."""
    whole = {form: asset_id for asset_id, name in names.items() for form in (asset_id.replace("_", " "), name.lower())}
    owners: dict[str, set[str]] = {}
    for asset_id, name in names.items():
        for word in name.lower().split():
            if len(word) > 2 and word not in _NO_NAME:
                owners.setdefault(word, set()).add(asset_id)
    parts = {word: next(iter(ids)) for word, ids in owners.items() if len(ids) == 1}
    return {**parts, **whole}
