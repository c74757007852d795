"""Plays, sitcoms and short films with speeches after a name: ``BAKER. Not today.``, ``Baker: ..``."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Sequence

from storyblender.screenplay.cues import looks_like_cue, split_cue
from storyblender.screenplay.headings import (
    heading_words,
    is_heading,
    is_side_alone,
    place_label,
    scene_label,
    split_number,
)
from storyblender.screenplay.layout.front import cast_list, ends_cast, read_front
from storyblender.screenplay.layout.labels import Label, element_of_label, find_convention, spoken_line
from storyblender.screenplay.layout.lines import Line, Page, lines_of, plain
from storyblender.screenplay.layout.speech import (
    add_cue,
    add_speech,
    goes_on_as_action,
    is_out_of_place,
    standing_name,
    standing_names,
)
from storyblender.screenplay.line_kinds import kind_of_words
from storyblender.screenplay.model import ElementKind, Screenplay

_ACT = re.compile(
    r"[*_]*(?:(?:THE )?(?:ACT|AKT|ACTO|ACTE|ATTO|PART|CHAPTER|EPISODE|SEGMENT|TEASER|PROLOGUE|EPILOGUE|TAG|COLD OPEN"
    r"|INTERMISSION)"
    r"\b[\s.:-]*(?:[IVX]+|\d+|ONE|TWO|THREE|FOUR|FIVE|FIRST|SECOND|THIRD)?|(?:FIRST|SECOND|THIRD"
    r"|FOURTH) ACT)[.:]?[*_]*",
    re.IGNORECASE,
)
_CLOSE = re.compile(
    r"(?:THE )?(?:END(?: OF (?:THE )?(?:PLAY|SCENE|ACT|SCRIPT)[\w ]*)?|CURTAIN|BLACK ?OUT|FIN|FINIS|ENDE|FINE|TELON"
    r"|RIDEAU|VORHANG)[.!]?",
    re.IGNORECASE,
)
_TRANSITION = re.compile(
    r"(?:(?:SMASH |MATCH |JUMP |HARD |QUICK )?CUT(?:S)? (?:TO|BACK TO)|FADE (?:IN|OUT|TO BLACK|UP)|DISSOLVE(?:S)? TO"
    r"|WIPE TO)"
    r"(?: BLACK)?\s*[:.]*",
    re.IGNORECASE,
)
_RISE = re.compile(
    r"(?:AT (?:THE )?(?:RISE|CURTAIN)(?: OF (?:THE )?CURTAIN)?|(?:AS )?(?:THE )?(?:LIGHTS?|CURTAIN)(?: COMES?)?(?: UP"
    r"| RISES?)\b|ENTER\b|EXIT\b|EXEUNT\b)",
    re.IGNORECASE,
)
_SENTENCE = re.compile(r"(?<=[.!?])(?<!\b[A-Z]\.)(?<!St\.)(?<!Mr\.)(?<!Dr\.)(?<!Mrs\.)[_*)\]]*\s+")
_REST = re.compile(r"(?:a )?(?:long |short |slight )?(?:pause|beat|silence|no dialogue|silent)\.?", re.IGNORECASE)
_MANNER = re.compile(r"\\?[(\[][^()\[\]]{1,120}[)\]]")
_INTRODUCED = re.compile(r"\b([^\W\d_a-z][\w'’-]+(?: [^\W\d_a-z][\w'’-]+)?)\s*,?\s*\(\d{1,2}\b")
_TITLE_LINES = 12
"""Lines before the first heading that may be a title and a byline, if none of them is a sentence."""
_DEEP = 40
"""Most lines that one bracket may span."""


def parse(text: str, path: str = "") -> Screenplay:
    """Read a script whose speeches are marked by names, in whatever form this page uses.

    Args:
        text: The script, newlines as ``\\n``.
        path: File path, for display only.
    """
    return _PlayReader(text).read(path)


def names_speakers(text: str) -> bool:
    """Return whether the speeches of a page follow names on the same line."""
    lines = lines_of(text)
    return find_convention(lines, _listed(lines)) is not None


def has_own_layout(text: str) -> bool:
    """Return whether the cues of a page are placed where Fountain would not recognise them."""
    return is_out_of_place(lines_of(text))


def _listed(lines: Sequence[Line]) -> frozenset[str]:
    """Return the names of the cast list, in capitals."""
    head = cast_list(lines)
    if head is None:
        return frozenset()
    end = next((i for i in range(head + 1, len(lines)) if lines[i].words and ends_cast(lines[i])), head + 1)
    return read_front(Page(""), lines[head:end])


class _PlayReader:
    """Reads the lines of a play into elements, from top to bottom."""

    def __init__(self, text: str) -> None:
        self.page = Page(text)
        self.lines = lines_of(text)
        self.empty = [index for index, line in enumerate(self.lines) if not line.words]
        self.convention = find_convention(self.lines, _listed(self.lines))
        self.names = standing_names(self.lines)
        self.known = self.names | {match[1].upper() for match in _INTRODUCED.finditer(text)}
        self.at = 0
        self.speaking = False
        self.bracketed = sum(line.words[:1] in ("(", "[") for line in self.lines) >= 3
        """Whether this page puts action in brackets, so that a plain paragraph continues a speech."""
        self.headed = False

    def read(self, path: str) -> Screenplay:
        """Return the screenplay."""
        start = self._body()
        read_front(self.page, self.lines[:start])
        self.at = start
        while self.at < len(self.lines):
            self._line()
        return Screenplay(
            path=path,
            format="script",
            text=self.page.text,
            title_page=tuple(self.page.title_page),
            elements=tuple(self.page.elements),
            page="screenplay" if self.headed else "play",
        )

    def _body(self) -> int:
        """Return the index of the line at which the story begins."""
        first = next((i for i, line in enumerate(self.lines[:_TITLE_LINES]) if is_heading(line.words)), None)
        if first is not None and not any(line.words.endswith((".", "!")) for line in self.lines[:first]):
            return first
        head = cast_list(self.lines)
        start = 0
        if head is not None:
            rest = range(head + 1, len(self.lines))
            start = next((i for i in rest if self.lines[i].words and self._begins(i, listing=True)), head + 1)
        return next((i for i in range(start, len(self.lines)) if self.lines[i].words and self._begins(i)), start)

    def _begins(self, index: int, *, listing: bool = False) -> bool:
        """Return whether the story begins at a line; ``listing`` inside a cast list."""
        line = self.lines[index]
        if listing and not ends_cast(line):
            label = self._label(line)
            listed = (
                not any(each.words for each in self.lines[max(0, index - 1) : index]) and self._following(index).words
            )
            return label is not None and label.speech < line.end and not listed and not self.lines[index - 1].words
        marked = is_heading(line.words) or place_label(line.words) or scene_label(line.words) or _RISE.match(line.words)
        if marked or _ACT.fullmatch(line.words) or _TRANSITION.fullmatch(line.words) or self._label(line):
            return True
        if line.words[0] in "([":
            return index > 3
        end = self._end_of_block(index)
        ends = self.lines[end - 1].words.rstrip("_*)").endswith((".", "!", "?"))
        told = " ".join(each.words for each in self.lines[index : min(end, index + 60)])
        return ends and len(told) > 60 and not element_of_label(line.words)

    def _label(self, line: Line) -> Label | None:
        """Return the speaker's label of a line, or None."""
        return spoken_line(line, self.convention) if self.convention else None

    def _end_of_block(self, index: int) -> int:
        """Return the index of the first empty line from a line on."""
        at = bisect_left(self.empty, index)
        return self.empty[at] if at < len(self.empty) else len(self.lines)

    def _line(self) -> None:
        """Read the current line and what belongs to it."""
        line = self.lines[self.at]
        if not line.words:
            self.at += 1
            return
        spoken = self._label(line)
        if not any(letter.isalnum() for letter in line.words):
            self._single("section", line)
        elif spoken is None and not self._is_cue(self.at) and self._structure(line):
            self.speaking = False
        elif spoken:
            self.at += 1
            add_cue(self.page, spoken.start, spoken.end, spoken.name, spoken.bracket)
            self._speech(spoken.speech, spoken.speech < line.end)
        elif line.words[0] in "([" or line.words[:2] in ("_(", "_["):
            self._bracket(line)
        elif self._is_cue(self.at):
            self.at += 1
            name, extension, _ = split_cue(line.words)
            self.page.add("cue", line.start, line.end, name=plain(name), extension=extension)
            self._speech(line.end, begun=False)
        elif self.speaking and self.bracketed and not self.headed:
            self._speech(line.start, begun=True)
        else:
            self.speaking = False
            self.page.add("action", line.start, self._run(self.at))

    def _structure(self, line: Line) -> bool:
        """Read a structural line, on-screen text or a sound; False if it is action or speech."""
        words = line.words
        if is_heading(words) or is_side_alone(words):
            self._heading(line)
        elif _ACT.fullmatch(words) or _CLOSE.fullmatch(words):
            self._single("section", line)
        elif _TRANSITION.fullmatch(words):
            self._single("transition", line)
        elif (act := _ACT.match(words)) and (
            scene_label(rest := words[act.end() :].lstrip(" .,:-–—_*")) or place_label(rest)
        ):
            self._place(line.start + words.index(rest, act.end()))
        elif scene_label(words) or place_label(words):
            self._place(line.start)
        elif (known := kind_of_words(words)) in ("transition", "section", "page_break"):
            self._single(known, line)
        elif told := element_of_label(words):
            self.page.add(told[0], line.start + told[1], self._run(self.at))
        else:
            return False
        return True

    def _single(self, kind: ElementKind, line: Line) -> None:
        """Add an element of one line, and move past it."""
        self.page.add(kind, line.start, line.end)
        self.at += 1

    def _heading(self, line: Line) -> None:
        """Read a heading on one line, or ``INT.`` on one and the place on the next."""
        self.at += 1
        last = line
        if is_side_alone(line.words) and self.at < len(self.lines) and self.lines[self.at].words:
            last = self.lines[self.at]
            self.at += 1
        self.headed = True
        words = self.page.text[line.start : last.end]
        number, start = split_number(words)
        self.page.add("heading", line.start + start, last.end, number=number)

    def _place(self, start: int) -> None:
        """Add a labelled place: of ``SETTING: A mill at night. A wheel turns.`` one sentence is the heading."""
        end = self._run(self.at)
        words = self.page.text[start:end]
        labels = [match for match in (scene_label(words), place_label(words)) if match]
        begun = max((match.end() for match in labels), default=0)
        again = place_label(words[begun:])
        begun += again.end() if again else 0
        if not words[begun:].strip() and place_label(words):
            while self.at < len(self.lines) and not self.lines[self.at].words:
                self.at += 1
            end = self._run(self.at) if self.at < len(self.lines) else end
            words = self.page.text[start:end]
        stop = _SENTENCE.search(words, begun)
        line_end = words.find("\n", begun)
        head = stop.start() if stop else len(words)
        if 0 <= line_end < head and scene_label(words) and not words[begun:line_end].strip():
            head = line_end
        self.page.add("heading", start, start + head, number=heading_words(words[:head]).number)
        self.page.add("action", start + head, end)

    def _bracket(self, line: Line) -> None:
        """Read a stage direction in brackets, on one or more lines; text after it on its line continues as before."""
        text = self.page.text
        last = min(self.at + _DEEP, len(self.lines) - 1)
        opening = line.start + line.words.index("(" if "(" in line.words[:2] else "[")
        close = _closing(text, opening, self.lines[last].end)
        if close < 0:
            self.page.add("action", line.start, self._run(self.at))
            return
        inner = text[opening + 1 : close]
        label = place_label(inner)
        if label:
            stop = _SENTENCE.search(inner, label.end())
            head = opening + 1 + (stop.start() if stop else len(inner))
            self.page.add("heading", opening + 1, head)
            opening, inner = head - 1, text[head:close]
        self.page.add("section" if _REST.fullmatch(inner.strip("_* ")) else "action", opening + 1, close)
        while self.at < len(self.lines) and self.lines[self.at].end <= close + 2:
            self.at += 1
        if self.at < len(self.lines) and self.lines[self.at].start <= close:
            rest = self._run(self.at)
            if re.search(r"\w", text[close + 1 : rest]):
                self._told(close + 1, rest)

    def _told(self, start: int, end: int) -> None:
        """Add a span as speech while a character speaks, else as action."""
        if self.speaking:
            add_speech(self.page, start, end)
        else:
            self.page.add("action", start, end)

    def _is_cue(self, index: int) -> bool:
        """Return whether a line is a cue: capitals above a line of other words, or a recurring name anywhere."""
        line = self.lines[index]
        if (name := standing_name(line)) and name in self.names:
            return True
        if index and self.lines[index - 1].words:
            return False
        following = self.lines[index + 1].words if index + 1 < len(self.lines) else ""
        return bool(following) and following != following.upper() and looks_like_cue(line.words)

    def _speech(self, start: int, begun: bool) -> None:
        """Read a speech from an offset; if not ``begun``, its words are on the lines below."""
        if not begun:
            ahead = self.at
            while ahead < len(self.lines) and not self.lines[ahead].words:
                ahead += 1
            if ahead >= len(self.lines) or self._divides(self.lines[ahead]) or self._is_cue(ahead):
                return
            self.at, start = ahead, self.lines[ahead].start
            if _MANNER.fullmatch(self.lines[ahead].words) and not self._following(ahead).words:
                self.page.add("parenthetical", start, self.lines[ahead].end)
                self.at += 1
                self._speech(start, begun=False)
                return
        end = max(start, self._run(self.at, inside=begun))
        add_speech(self.page, start, end)
        self.speaking = True

    def _following(self, index: int) -> Line:
        """Return the next line; an empty one at the end."""
        return self.lines[index + 1] if index + 1 < len(self.lines) else Line(0, 0, "", 0)

    def _run(self, index: int, *, inside: bool = False) -> int:
        """Return the offset at which the paragraph at a line ends, and move past it.

        Args:
            index: Index of its first line.
            inside: The line belongs to the text begun on the line before.
        """
        first = index
        while index < len(self.lines) and self.lines[index].words:
            line = self.lines[index]
            if (index > first or inside) and (self._divides(line) or self._is_cue(index)):
                break
            if index > first and goes_on_as_action(line, self.lines[index - 1], self.known):
                break
            index += 1
        self.at = index
        return self.lines[index - 1].end if index else 0

    def _divides(self, line: Line) -> bool:
        """Return whether a line ends the paragraph above it."""
        words = line.words
        marked = is_heading(words) or scene_label(words) or place_label(words) or element_of_label(words)
        marked = marked or re.fullmatch(r"\d{1,3}\.|\(?(?:CONTINUED|MORE)\)?:?", words)
        return bool(marked or self._label(line) or _TRANSITION.fullmatch(words) or _ACT.fullmatch(words))


def _closing(text: str, opening: int, end: int) -> int:
    """Return the offset of the bracket that closes the one at an offset, or -1."""
    depth = 0
    for at in range(opening, end):
        depth += (text[at] in "([") - (text[at] in ")]")
        if depth == 0:
            return at
    return -1
