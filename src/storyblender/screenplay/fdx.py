"""Final Draft (FDX): paragraphs laid into plain text, one element each. A DOCTYPE or an entity is refused."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.sax import SAXParseException
from xml.sax.handler import ContentHandler
from xml.sax.xmlreader import AttributesImpl

from defusedxml import DefusedXmlException
from defusedxml.sax import parseString

from storyblender.errors import InputError
from storyblender.screenplay.cues import split_cue
from storyblender.screenplay.line_kinds import kind_of_words
from storyblender.screenplay.model import Element, ElementKind, Screenplay

_KIND: dict[str, ElementKind] = {
    "Scene Heading": "heading",
    "Action": "action",
    "General": "action",
    "Cast List": "action",
    "Character": "cue",
    "Parenthetical": "parenthetical",
    "Dialogue": "dialogue",
    "Lyrics": "lyric",
    "Transition": "transition",
    "Shot": "shot",
    "Outline 1": "section",
    "Outline 2": "section",
    "Outline 3": "section",
    "New Act": "section",
    "End of Act": "section",
    "Script Note": "note",
}
"""Final Draft's paragraph types; an unknown type is read as action."""
_SPEECH: tuple[ElementKind, ...] = ("dialogue", "parenthetical", "lyric")
_EXPORT = "save it again from Final Draft, or export it as Fountain"


@dataclass
class _Paragraph:
    """A paragraph of a Final Draft document."""

    type: str
    line: int
    number: str = ""
    dual: bool = False
    title_page: bool = False
    pieces: list[str] = field(default_factory=list)

    @property
    def text(self) -> str:
        """The words of the paragraph."""
        return "".join(self.pieces).strip()


def parse(text: str, path: str = "") -> Screenplay:
    """Read a Final Draft document.

    Args:
        text: The XML, newlines as ``\\n``.
        path: Named in errors.

    Raises:
        InputError: Malformed XML, a DOCTYPE or an entity, XML that is not Final Draft, or no script in it.
    """
    handler = _Handler()
    try:
        # The text is decoded already: a declared encoding would contradict the bytes handed to the parser.
        parseString(_without_declaration(text).encode("utf-8"), handler, forbid_dtd=True)
    except DefusedXmlException:
        offset = max(0, *(text.find(mark) for mark in ("<!DOCTYPE", "<!ENTITY")))
        raise InputError(
            "this XML declares a document type or entities, which are refused for safety",
            mend=_EXPORT,
            path=path or None,
            line=text.count("\n", 0, offset) + 1,
        ) from None
    except SAXParseException as error:
        raise InputError(
            f"the XML is damaged ({error.getMessage()})",
            mend=_EXPORT,
            path=path or None,
            line=error.getLineNumber() or 1,
        ) from None
    if handler.root != "FinalDraft":
        raise InputError(
            f"this is XML but not a Final Draft document (its root is <{handler.root}>)",
            mend="export the script as FDX or Fountain",
            path=path or None,
        )
    title_page = _title_page([paragraph for paragraph in handler.paragraphs if paragraph.title_page])
    body = [paragraph for paragraph in handler.paragraphs if not paragraph.title_page and paragraph.text]
    if not body:
        raise InputError(
            "this Final Draft document has no script in it", mend="write at least one scene", path=path or None
        )
    laid, elements = _lay(body)
    return Screenplay(path=path, format="fdx", text=laid, title_page=title_page, elements=elements)


def _without_declaration(text: str) -> str:
    """Return a document without its XML declaration, line numbers unchanged."""
    return re.sub(r"\A\s*<\?xml[^>]*\?>", lambda match: "\n" * match[0].count("\n"), text)


def _lay(paragraphs: list[_Paragraph]) -> tuple[str, tuple[Element, ...]]:
    """Lay the paragraphs into one text, speeches under their cue, and tie an element to each."""
    pieces: list[str] = []
    elements: list[Element] = []
    position = 0
    for paragraph, kind in _in_order(paragraphs):
        words = f"[[{paragraph.text}]]" if kind == "note" else paragraph.text
        if pieces:
            gap = "\n" if kind in (*_SPEECH, "note") else "\n\n"
            pieces.append(gap)
            position += len(gap)
        name, extension, _ = split_cue(words) if kind == "cue" else ("", "", False)
        elements.append(
            Element(
                kind=kind,
                text=words.strip("()").strip() if kind == "parenthetical" else paragraph.text,
                start=position,
                end=position + len(words),
                line=paragraph.line,
                name=name,
                extension=extension,
                scene_number=paragraph.number if kind == "heading" else "",
                dual=paragraph.dual,
            )
        )
        pieces.append(words)
        position += len(words)
    return "".join(pieces), tuple(elements)


def _in_order(paragraphs: list[_Paragraph]) -> Iterator[tuple[_Paragraph, ElementKind]]:
    """Yield each paragraph with what it is; notes come after the speech in which they stand."""
    notes: list[tuple[_Paragraph, ElementKind]] = []
    for paragraph in paragraphs:
        kind = _KIND.get(paragraph.type, "action")
        if kind == "note":
            notes.append((paragraph, kind))
            continue
        if kind == "action":  # writers type a heading or FADE IN: without giving it its type
            kind = kind_of_words(paragraph.text) or kind
        if kind not in _SPEECH:
            yield from notes
            notes.clear()
        yield paragraph, kind
    yield from notes


def _title_page(paragraphs: list[_Paragraph]) -> tuple[tuple[str, str], ...]:
    """Name the lines of a title page: title, credit, author; what follows is the contact."""
    lines = [paragraph.text for paragraph in paragraphs if paragraph.text]
    if not lines:
        return ()
    entries = [("Title", lines[0])]
    rest = lines[1:]
    if rest and rest[0].lower().endswith("by"):
        entries.append(("Credit", rest[0]))
        if rest[1:]:
            entries.append(("Author", rest[1]))
        rest = rest[2:]
    if rest:
        entries.append(("Contact", "\n".join(rest)))
    return tuple(entries)


class _Handler(ContentHandler):
    """Collects the paragraphs of script, script notes and title page; summaries and headers are passed over."""

    def __init__(self) -> None:
        super().__init__()
        self.root = ""
        self.paragraphs: list[_Paragraph] = []
        self._path: list[str] = []
        self._open: list[_Paragraph] = []
        self._dual_cues = 0

    def startElement(self, name: str, attrs: AttributesImpl) -> None:
        """Open a paragraph where its parents say that it is part of the script."""
        self.root = self.root or name
        if name == "DualDialogue":
            self._dual_cues = 0
        if name == "Paragraph":
            parents = tuple(self._path)
            noted = _in_note(parents)
            type_ = "Script Note" if noted else attrs.get("Type", "General")
            in_dual = "DualDialogue" in parents
            self._dual_cues += in_dual and type_ == "Character"
            paragraph = _Paragraph(
                type=type_,
                line=self._locator.getLineNumber() if self._locator else 1,  # type: ignore[attr-defined]
                number=attrs.get("Number", ""),
                dual=in_dual and self._dual_cues > 1,
                title_page=parents == ("FinalDraft", "TitlePage", "Content"),
            )
            self._open.append(paragraph)
            if paragraph.title_page or noted or _in_script(parents):
                self.paragraphs.append(paragraph)
        self._path.append(name)

    def endElement(self, name: str) -> None:
        """Close it."""
        self._path.pop()
        if name == "Paragraph":
            self._open.pop()

    def characters(self, content: str) -> None:
        """Add the words of a ``Text`` to its paragraph."""
        if self._open and self._path[-2:] == ["Paragraph", "Text"]:
            self._open[-1].pieces.append(content)


def _in_script(parents: tuple[str, ...]) -> bool:
    """Return whether a paragraph belongs to the script itself."""
    return parents[:2] == ("FinalDraft", "Content") and set(parents[2:]) <= {"Paragraph", "DualDialogue"}


def _in_note(parents: tuple[str, ...]) -> bool:
    """Return whether a paragraph belongs to a script note."""
    return parents[:2] == ("FinalDraft", "Content") and "ScriptNote" in parents
