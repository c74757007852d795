"""Writes action in capitals, as in sitcoms, in the usual case, so that capitals name people again.

One letter becomes one letter, so that all offsets stay.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from storyblender.agents.director import camera_phrases, lexicon
from storyblender.agents.director.naming import LOWER, UPPER
from storyblender.agents.director.reader.language.morphology import form_kind
from storyblender.screenplay.model import Element, ElementKind, Screenplay

_TOLD: frozenset[ElementKind] = frozenset({"action", "shot"})
_MOSTLY = 0.8
"""Share of capitals among the letters of its action from which a page is written in capitals."""
_SENTENCE_WORDS = 5
"""Fewest words of a sentence in capitals on an ordinary page: fewer are a noise, a place, a title or a name."""
_WORD = re.compile(r"[^\W\d_]+(?:['’][^\W\d_]+)*")
_SENTENCE = re.compile(r"(?:\b(?:MR|MRS|MS|DR|ST|[A-Z])\.\s|\d\.\d|[^.!?])+[.!?]*[\s\"”’')\]]*")
_QUOTED = re.compile(r"\"[^\"]*\"|“[^”]*”")
_OPENING = re.compile(r"\W*")
_MARKED = re.compile(
    rf"(?<!\w)[_*]+((?:(?:MR|MRS|MS|DR)\. )?[{UPPER}'’]{{2,}}(?: [{UPPER}'’]{{2,}}){{0,2}})[_*]+(?!\w)"
)
"""An underlined or bold name: a person at their first appearance."""
_AGE = (
    r"(?:AGED?|EARLY|MID|LATE|IN (?:HIS|HER|THEIR)(?: EARLY| MID| LATE)?)?[ -]*"
    r"(?:\d\d?\b|\d0['’]?S|(?:TWEN|THIR|FOR|FIF|SIX|SEVEN|EIGH|NINE)(?:TY|TIES|TEEN)\b|TEENS\b)"
)
_AGED = re.compile(rf"(?P<name>[{UPPER}'’.]+(?: [{UPPER}'’.]+){{0,2}})(?:\s*\(|,\s+){_AGE}")
_TITLED = re.compile(rf"\b(?:MRS?|MS|DR|MISS|PROFESSOR|CAPTAIN|OFFICER|UNCLE|AUNT)\.? [{UPPER}]{{2,}}")
_WRITTEN = re.compile(rf"(?<=[{LOWER},] )[{UPPER}][{LOWER}]+")
"""A name inside a sentence in small letters."""
_SMALL = (
    lexicon.PREPOSITIONS | lexicon.DETERMINERS | lexicon.POSSESSIVES | lexicon.CONJUNCTIONS | lexicon.PRONOUNS.keys()
)
_COMMON = lexicon.PROPS | lexicon.SET_PIECES | lexicon.SCENERY | lexicon.BODY | lexicon.ANIMALS | lexicon.WORN


def in_sentence_case(screenplay: Screenplay) -> str:
    """Return the text of a script with action in capitals written in sentence case, with names."""
    text = screenplay.text
    told = [element for element in screenplay.elements if element.kind in _TOLD]
    sample = "".join(element.text for element in told if " " in element.text.strip())
    large = sum(letter.isupper() for letter in sample)
    small = sum(letter.islower() for letter in sample)
    if not large + small:
        return text
    names = _NameWords.of(screenplay, told)
    pieces, done = [], 0
    for element in told:
        written = text[element.start : element.end]
        read = (
            _capitalised(written, names) if not large else _lowered(written, names, large > _MOSTLY * (large + small))
        )
        if read != written:
            pieces += [text[done : element.start], read]
            done = element.end
    return "".join([*pieces, text[done:]])


@dataclass(frozen=True)
class _NameWords:
    """Words of a script that are names, where capitals do not tell."""

    spoken: frozenset[str]
    """In capitals: of cues and introductions."""
    whole: frozenset[str]
    """Those of several words."""
    given: frozenset[str]
    """In small letters: written as a name elsewhere."""

    @classmethod
    def of(cls, screenplay: Screenplay, told: list[Element]) -> _NameWords:
        """Collect the names of a script."""
        named = {element.name.upper() for element in screenplay.elements if element.kind == "cue"}
        named |= {element.text.upper() for element in screenplay.elements if element.kind == "cast"}
        given: set[str] = set()
        for element in told:
            written = screenplay.text[element.start : element.end]
            given |= {match.group().lower() for match in _WRITTEN.finditer(written)}
            given |= {word.lower() for match in _TITLED.finditer(written) for word in _WORD.findall(match.group())}
            marked = (match.group(1) for match in _MARKED.finditer(written))
            aged = (_last_name(match["name"]) for match in _AGED.finditer(written))
            named |= {name for name in (*marked, *aged) if name and not _is_action(name)}
        words = {word for name in named for word in _WORD.findall(name)}
        kept = {word for word in words if word.lower() not in _SMALL and len(word) > 1}
        return cls(frozenset(kept), frozenset(name for name in named if " " in name), frozenset(given))

    def write(self, word: str) -> str:
        """Return a word in capitals as it is written inside a sentence."""
        low = word.lower()
        stem = re.sub(r"['’]s$", "", low)
        if len(low) != len(word):
            return word
        if stem.upper() in self.spoken:
            return stem.upper() + low[len(stem) :]
        first = stem in lexicon.FIRST_NAMES and not form_kind(stem) and stem not in _COMMON
        return low.capitalize() if first or stem in self.given or low in ("i", "i'm", "i’m") else low


def _last_name(words: str) -> str:
    """Return the name before an age: ``STANDS MAY BELL``; empty after an article."""
    name: list[str] = []
    for word in reversed(words.split()):
        low = word.lower().strip(".")
        if low in lexicon.DETERMINERS | lexicon.POSSESSIVES or low in lexicon.NUMBERS:
            return ""
        if low in _SMALL or form_kind(low) in ("3sg", "aux", "ing"):
            break
        name.insert(0, word)
    return " ".join(name)


def _is_action(name: str) -> bool:
    """Whether marked words tell an action: ``_EXITS_``, ``_CROSSES TO THE DOOR_``."""
    return any(form_kind(word.lower()) in ("3sg", "ing") or word.lower() in _SMALL for word in name.split())


def _lowered(text: str, names: _NameWords, page: bool) -> str:
    """Return action with its capitals in the usual case.

    Args:
        text: A paragraph.
        names: The names of the script.
        page: Whether the whole page is written in capitals.
    """
    kept = [match.span() for match in _QUOTED.finditer(text)]
    out = list(text)
    for start, end in _sentences(text):
        words = text[start:end]
        if any(letter.islower() for letter in _QUOTED.sub("", words)) or not (page or _is_sentence(words)):
            continue
        camera = camera_phrases.parse_direction(words)[0]
        begins = _OPENING.match(words).end()  # pyright: ignore[reportOptionalMemberAccess]
        filmed = camera is not None and words.startswith(camera.phrase, begins)
        if filmed and not page:
            continue
        first = begins + len(camera.phrase) if camera and filmed else begins
        said = [*_whole_names(words, names), *((a - start, b - start) for a, b in kept)]
        for match in _WORD.finditer(words, first):
            if any(a <= match.start() < b for a, b in said):
                continue
            read = names.write(match.group())
            read = read[0].upper() + read[1:] if match.start() == begins else read
            out[start + match.start() : start + match.end()] = read
    return "".join(out)


def _is_sentence(words: str) -> bool:
    """Whether words in capitals on an ordinary page are a sentence: a verb, and an article or a pronoun."""
    low = [word.lower() for word in _WORD.findall(words)]
    if len(low) < _SENTENCE_WORDS or not words.rstrip(' \n"”)').endswith((".", "!", "?")):
        return False
    return any(form_kind(word) == "3sg" for word in low[1:]) and any(word in _SMALL for word in low)


def _sentences(text: str) -> Iterator[tuple[int, int]]:
    """Yield start and end of each sentence."""
    return (match.span() for match in _SENTENCE.finditer(text))


def _whole_names(words: str, names: _NameWords) -> Iterator[tuple[int, int]]:
    """Yield start and end of the names of several words, ``MAN ON THE STAIRS``, which stay in capitals."""
    for name in names.whole:
        yield from (match.span() for match in re.finditer(rf"(?<!\w){re.escape(name)}(?!\w)", words))


def _capitalised(text: str, names: _NameWords) -> str:
    """Return text with capitals at the start of sentences and of speakers' names."""
    opens = {start + match.end() for start, end in _sentences(text) if (match := _OPENING.match(text[start:end]))}

    def write(match: re.Match[str]) -> str:
        word = match.group()
        raised = word.capitalize()
        return raised if len(raised) == len(word) and (match.start() in opens or word.upper() in names.spoken) else word

    return _WORD.sub(write, text)
