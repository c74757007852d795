"""Comic scripts: pages and panels; each panel is one picture with its balloons, captions and sound effects."""

from __future__ import annotations

import re

from storyblender.screenplay.headings import is_heading, split_number
from storyblender.screenplay.layout.labels import element_of_label, key_of_name, plain_name
from storyblender.screenplay.layout.lines import Line, Page, lines_of
from storyblender.screenplay.layout.speech import add_cue, add_speech
from storyblender.screenplay.model import Screenplay

_PAGE = re.compile(
    r"[*_#\s]*(?:(?:PAGES?|P[ÁA]GINA|SEITE|PLANCHE|SPREAD|TAVOLA)\s+(?:[\w-]+)|P\.?\s?\d+)(?:\s*(?:[-–&]|AND)\s*\w+)?[*_]*"
    r"(?P<rest>\s*(?:[(\[,:–—-].*)?)",
    re.IGNORECASE,
)
_PANEL = re.compile(
    r"[*_#\s]*(?:PANEL|PNL|VI[ÑN]ETA|CASE|BILD|VIGNETTA|FRAME)\s*#?\s*(?:\d{1,2}[A-Z]?|ONE|TWO|THREE|FOUR|FIVE|SIX|SEVEN|EIGHT|NINE|TEN)"
    r"[*_]*(?P<shape>\s*\([^)\n]{1,60}\))?\s*[.:)–—-]*[*_]*(?=\s|$)|\[\d{1,2}\](?=\s|$)",
    re.IGNORECASE,
)
_NUMBER = re.compile(r"(?:\d{1,2}[.)]|\d{1,2}\s*[-–—:])(?=\s)")
_BALLOON = re.compile(
    r"(?:\d{1,2}[.)]?\s+)?[*_]{0,3}(?P<name>[A-ZÀ-Þ][\w'’.&# -]{0,28}?)[*_]{0,3}\s*"
    r"(?P<bracket>[(\[][^)\]\n]{1,60}[)\]])?[*_]{0,3}\s?(?::|(?=\s*$))[*_]{0,3}\s*"
)
_CAPTION = re.compile(
    r"(?:\d{1,2}[.)]?\s+)?[*_]*(?:CAPTIONS?|CAP|NARR(?:ATION|ATIVE)?|BOX|LOCATION CAP(?:TION)?|TITLES?|CREDITS?|SUPER"
    r"|EDITOR['’]?S? NOTE|TEXTO|CARTUCHO|BLOCKTEXT)\b"
    r"\s*(?:\d+\s*)?(?:[(\[][^)\]\n]{1,60}[)\]])?\s*(?::|(?=$))\s*[*_]*",
    re.IGNORECASE,
)
_NOISE = re.compile(
    r"(?:\d{1,2}[.)]?\s+)?[*_]*(?:SFX|SOUND(?: EFFECTS?| FX)?|FX|EFECTO|NOISE)\b[^:\n]{0,30}:", re.IGNORECASE
)
_SILENT = re.compile(
    r"[(\[]?(?:no (?:dialogue|copy|text|words)|silent(?: panel)?|nc|sin texto)[)\]]?\.?", re.IGNORECASE
)


def is_comic(text: str) -> bool:
    """Return whether a page is divided into numbered panels."""
    lines = [line.words for line in lines_of(text) if line.words]
    panels = sum(_PANEL.match(line) is not None for line in lines)
    pages = sum(_PAGE.fullmatch(line) is not None for line in lines)
    if panels >= 2:
        return True
    numbered = sum(_NUMBER.match(line) is not None for line in lines)
    named = sum(_BALLOON.match(line) is not None or _NOISE.match(line) is not None for line in lines)
    loud = any(re.match(r"[*_#\s]*PAGES?\s", line) for line in lines)
    return pages >= 1 and loud and numbered >= 3 and named >= 2


def parse(text: str, path: str = "") -> Screenplay:
    """Read a comic script.

    Args:
        text: The script, newlines as ``\\n``.
        path: File path, for display only.
    """
    reader = _ComicReader(text)
    reader.read()
    page = reader.page
    return Screenplay(
        path=path,
        format="script",
        text=text,
        title_page=tuple(page.title_page),
        elements=tuple(page.elements),
        page="comic",
    )


class _ComicReader:
    """Reads the lines of a comic script into elements, panel by panel."""

    def __init__(self, text: str) -> None:
        self.page = Page(text)
        self.lines = lines_of(text)
        self.labelled = sum(_PANEL.match(line.words) is not None for line in self.lines) >= 2
        self.at = 0
        self.speakers = self._speakers()

    def _speakers(self) -> frozenset[str]:
        """Return the speakers of balloons: names in capitals before a colon, or alone on a line above their words."""
        found: set[str] = set()
        for line, following in zip(self.lines, [*self.lines[1:], Line(0, 0, "", 0)], strict=True):
            match = _BALLOON.match(line.words)
            if match is None or self._marked(line):
                continue
            name = plain_name(match["name"])
            said = line.words[match.end() :] or following.words
            spoken = name == name.upper() and re.search(r"[A-ZÀ-Þ]{2}|#\\d", name)
            called = len(name.split()) <= 2 and name.istitle() and match[0].rstrip().endswith(":")
            if said and (spoken or called):
                found.add(key_of_name(name))
        return frozenset(found)

    def read(self) -> None:
        """Read the whole script."""
        start = next((i for i, line in enumerate(self.lines) if self._opens(line)), len(self.lines))
        self._front(self.lines[:start])
        self.at = start
        while self.at < len(self.lines):
            self._line(self.lines[self.at])

    def _opens(self, line: Line) -> bool:
        """Return whether a line opens a page or a panel."""
        return bool(line.words and (_PAGE.fullmatch(line.words) or _PANEL.match(line.words)))

    def _front(self, lines: list[Line]) -> None:
        """Read a title and notes to the artist, which may describe characters."""
        for line in lines:
            if not line.words:
                continue
            if len(line.words) > 60:
                self.page.add("cast", line.start, line.end)
                continue
            if not self.page.title_page:
                self.page.title_page.append(("Title", line.words.strip('"“”*_ ')))
            self.page.add("section", line.start, line.end)

    def _line(self, line: Line) -> None:
        """Read the current line and what belongs to it."""
        words = line.words
        self.at += 1
        if not words:
            return
        panel = self._panel(words)
        if _PAGE.fullmatch(words):
            self.page.picture = None
            self.page.add("section", line.start, line.end)
        elif panel:
            self.page.open_picture()
            self._told(line.start + panel.end())
        elif _SILENT.fullmatch(words) or re.fullmatch(r"(?:THE )?END\.?|FIN\.?", words):
            self.page.add("section", line.start, line.end)
        elif caption := _CAPTION.match(words):
            self.page.add("title", line.start + caption.end(), self._run())
        elif _NOISE.match(words):
            self.page.add("sound", line.start, self._run())
        elif is_heading(words):
            number, start = split_number(words)
            self.page.add("heading", line.start + start, line.end, number=number)
        elif balloon := self._balloon(line):
            name_end = line.start + (balloon.end("bracket") if balloon["bracket"] else balloon.end("name"))
            bracket = (balloon["bracket"] or "").strip("()[]")
            add_cue(self.page, line.start + balloon.start("name"), name_end, plain_name(balloon["name"]), bracket)
            add_speech(self.page, line.start + balloon.end(), self._run())
        elif told := element_of_label(words):
            self.page.add(told[0], line.start + told[1], self._run())
        else:
            self._told(line.start)

    def _panel(self, words: str) -> re.Match[str] | None:
        """Match the heading of a panel."""
        return _PANEL.match(words) if self.labelled else _NUMBER.match(words)

    def _balloon(self, line: Line) -> re.Match[str] | None:
        """Match a balloon of a known speaker."""
        match = _BALLOON.match(line.words)
        return match if match and key_of_name(match["name"]) in self.speakers else None

    def _marked(self, line: Line) -> bool:
        """Return whether a line ends the text above it: blank, a heading or a label."""
        words = line.words
        return bool(
            not words or (self._panel(words) and not _BALLOON.match(words))
            or _PAGE.fullmatch(words) or _PANEL.match(words) or _CAPTION.match(words) or _NOISE.match(words)
            or is_heading(words) or element_of_label(words)
        )  # fmt: skip

    def _told(self, start: int) -> None:
        """Add action from an offset to the next marked line."""
        self.page.add("action", start, self._run())

    def _run(self) -> int:
        """Return the end offset of the text that began on the line before, and move past it."""
        while self.at < len(self.lines):
            line = self.lines[self.at]
            divides = self._marked(line) or self._panel(line.words) or self._balloon(line)
            if divides or _SILENT.fullmatch(line.words):
                break
            self.at += 1
        return self.lines[self.at - 1].end
