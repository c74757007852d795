"""Where the words of a text stand: looking a name up does not read the whole text again."""

from __future__ import annotations

import re
from collections.abc import Iterator

_WORD = re.compile(r"\w+")


class TextIndex:
    """The places of all words of a text.

    Args:
        text: Any text.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self._starts: dict[str, list[int]] = {}
        for word in _WORD.finditer(text):
            self._starts.setdefault(word[0].lower(), []).append(word.start())

    def places(self, phrase: str) -> Iterator[int]:
        """The offsets at which a phrase stands as it is written, no part of a longer word.

        Args:
            phrase: Starts and ends with a letter, a digit or ``_``.
        """
        first = _WORD.match(phrase)
        for at in self._starts.get(first[0].lower(), ()) if first else ():
            end = at + len(phrase)
            if self.text.startswith(phrase, at) and not _WORD.match(self.text, end):
                yield at
