"""Reads a script file of any kind: decoded text, then a Screenplay, or one clear sentence of refusal."""

from __future__ import annotations

import codecs
import json
import re
from pathlib import Path
from typing import Final

from storyblender.errors import InputError
from storyblender.screenplay import fdx, fountain, prose
from storyblender.screenplay.headings import is_heading
from storyblender.screenplay.layout import chat, columns, comic, picture_book, play
from storyblender.screenplay.layout.front import list_featured
from storyblender.screenplay.model import Screenplay, ScriptFormat

MAX_BYTES: Final = 20_000_000
"""A feature script is about 0.3 MB; anything beyond this is not a script."""

_ENOUGH_CUES: Final = 3
"""Number of names on lines of their own from which a name before a colon is no cue."""
_EXPORT: Final = "export the script as Fountain (.fountain) or Final Draft (.fdx)"
_MAGIC: Final[tuple[tuple[bytes, str], ...]] = (
    (b"%PDF", "this is a PDF, which keeps pages but loses the script's structure"),
    (b"\xd0\xcf\x11\xe0", "this is a Word document (.doc)"),
    (b"{\\rtf", "this is a rich-text document (RTF)"),
    (b"\x1f\x8b", "this is a gzip archive"),
    (b"\x89PNG", "this is a picture"),
    (b"\xff\xd8\xff", "this is a picture"),
    (b"GIF8", "this is a picture"),
    (b"BLENDER", "this is a .blend file"),
)
_ZIPPED: Final = {
    ".docx": "this is a Word document (.docx)",
    ".odt": "this is an OpenDocument text (.odt)",
    ".pages": "this is a Pages document",
    ".highland": "this is a Highland document",
    ".fadein": "this is a Fade In document",
}
_FORMAT_OF_SUFFIX: Final[dict[str, ScriptFormat]] = {".fountain": "fountain", ".spmd": "fountain", ".fdx": "fdx"}
_BOMS: Final = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
_CONTROLS: Final = re.compile("[\x01-\x08\x0e-\x1f\x7f\x80-\x84\x86-\x9f\ufffe\uffff]")
"""No words, and no XML may hold them; each becomes a space, so that offsets stay true."""
_NEWLINES: Final = re.compile("\r\n|[\r\v\f\x85\u2028\u2029]")


def load(path: Path) -> Screenplay:
    """Read a script from a file: Fountain, Final Draft or prose, in any common encoding.

    Args:
        path: The file; its suffix decides the format where it is ``.fountain``, ``.spmd`` or ``.fdx``.

    Raises:
        InputError: The file cannot be used; the message says why and what to do.
    """
    text, format = decode(_bytes(path), path), _FORMAT_OF_SUFFIX.get(path.suffix.lower())
    return read(text, format, str(path)).model_copy(update={"path": path.name})


def read(text: str, format: ScriptFormat | None = None, path: str = "") -> Screenplay:
    """Read a script from text.

    Args:
        text: The script.
        format: Its format; None finds out.
        path: Named in errors and kept for display.

    Raises:
        InputError: There is no script in the text.
    """
    text = _NEWLINES.sub("\n", text.encode("utf-8", "replace").decode("utf-8").removeprefix("\ufeff").rstrip("\x1a"))
    if not _CONTROLS.sub(" ", text).strip():
        raise InputError("there is nothing to read", mend="write at least one scene", path=path or None)
    if "\0" in text:
        raise InputError(
            "the text holds NUL characters, so its encoding is damaged", mend="save it as UTF-8", path=path or None
        )
    text = _CONTROLS.sub(" ", text)
    if format is None or _is_xml(text):
        format = _sniff(text, path)
    screenplay = fdx.parse(text, path) if format == "fdx" else _parse(text, format, path)
    _refuse_empty(screenplay)
    return screenplay.model_copy(update={"elements": list_featured(screenplay.text, screenplay.elements)})


def _parse(text: str, format: ScriptFormat, path: str) -> Screenplay:
    """Read a page in its own layout; a file called Fountain is Fountain unless it clearly has another layout."""
    for recognised, parse in (
        (columns.is_columns, columns.parse),
        (comic.is_comic, comic.parse),
        (chat.is_chat, chat.parse),
        (picture_book.is_picture_book, picture_book.parse),
    ):
        if recognised(text):
            return parse(text, path)
    lines = [line.strip() for line in text.split("\n")]
    if (play.names_speakers(text) and _cues(lines) < _ENOUGH_CUES) or play.has_own_layout(text):
        return play.parse(text, path)
    return fountain.parse(text, path) if format == "fountain" else prose.parse(text, path)


def decode(data: bytes, path: Path | str = "") -> str:
    """Return the text of a file's bytes: by byte-order mark, as UTF-16 without one, UTF-8, else Windows-1252.

    Args:
        data: The bytes.
        path: Path of the file, for messages.

    Raises:
        InputError: The bytes are a known binary format, or text in no encoding that can be told.
    """
    _refuse_binary(data, path)
    for mark, encoding in _BOMS:
        if data.startswith(mark):
            return _decode_strictly(data[len(mark) :], encoding, path)
    if (encoding := _utf16_without_mark(data)) is not None:
        return _decode_strictly(data, encoding, path)
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        text = _decode_strictly(data, "cp1252", path)
    if sum(letter < " " and letter not in "\t\n\r\v\f\x1a" for letter in text) > len(text) / 200:
        raise InputError("this is binary data, not text", mend=_EXPORT, path=path or None)
    return text


def _bytes(path: Path) -> bytes:
    """Return the bytes of a file, or raise an InputError that says why it cannot be read."""
    shown = str(path).encode("utf-8", "backslashreplace").decode()
    if shown != str(path):  # it goes into the graph, the page and the commands told, which are UTF-8
        raise InputError("the name of the file is not text in UTF-8", mend="rename it", path=shown)
    try:
        if path.is_dir():
            raise InputError("this is a folder, not a script", mend="name a file in it", path=path)
        if not path.exists():
            raise InputError("there is no such file", mend="check the name", path=path)
        if not path.is_file():
            raise InputError("this is not a regular file", mend="name a script file", path=path)
        size = path.stat().st_size
        if size > MAX_BYTES:
            raise InputError(
                f"this file has {size / 1e6:.0f} MB, far more than a script",
                mend=f"give a text of at most {MAX_BYTES / 1e6:.0f} MB",
                path=path,
            )
        return path.read_bytes()
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(
            f"the file cannot be read ({reason})", mend="check its name and permissions", path=path
        ) from error


def _refuse_binary(data: bytes, path: Path | str) -> None:
    """Raise an InputError for a known binary format."""
    head = data.lstrip()[:16]
    for magic, problem in _MAGIC:
        if head.startswith(magic):
            raise InputError(problem, mend=_EXPORT, path=path or None)
    if head.startswith(b"PK\x03\x04"):
        problem = _ZIPPED.get(Path(path).suffix.lower(), "this is a zip archive")
        raise InputError(problem, mend=_EXPORT, path=path or None)


def _utf16_without_mark(data: bytes) -> str | None:
    """Tell UTF-16 by its zero bytes: Latin letters have one in every pair, always on the same side."""
    sample = data[:4096]
    if len(sample) < 4 or len(data) % 2:
        return None
    low, high = sample[0::2].count(0) / (len(sample) / 2), sample[1::2].count(0) / (len(sample) / 2)
    if high > 0.4 and low < 0.05:
        return "utf-16-le"
    return "utf-16-be" if low > 0.4 and high < 0.05 else None


def _decode_strictly(data: bytes, encoding: str, path: Path | str) -> str:
    """Decode bytes, or raise an InputError that names the first wrong byte."""
    try:
        return data.decode(encoding)
    except UnicodeDecodeError as error:
        raise InputError(
            f"the text is not valid {encoding.upper()} (byte {error.start})", mend="save it as UTF-8", path=path or None
        ) from None


def _is_xml(text: str) -> bool:
    """Return whether a text is an XML document."""
    return text.lstrip().startswith(("<?xml", "<FinalDraft", "<!DOCTYPE"))


def _sniff(text: str, path: str) -> ScriptFormat:
    """Return the format of a text by its content."""
    head = text.lstrip()[:500]
    if re.match(r"(?:<!DOCTYPE )?\s*<?html\b", head, re.IGNORECASE):
        raise InputError("this is a web page (HTML)", mend="save the script itself as text", path=path or None)
    if _is_xml(text):
        return "fdx"
    if head[0] in "{[":
        try:
            json.loads(text)
        except (ValueError, RecursionError):
            pass
        else:
            raise InputError("this is JSON data, not a script", mend=_EXPORT, path=path or None)
    return "fountain" if _is_fountain(text) else "prose"


def _is_fountain(text: str) -> bool:
    """Return whether a text has headings or cues of Fountain."""
    lines = [line.strip() for line in text.split("\n")]
    if any(is_heading(line) and (line == line.upper() or line[:3] in ("INT", "EXT")) for line in lines):
        return True
    forced = sum(bool(re.match(r"\.[A-Z]|@\w|>.*TO:$", line)) for line in lines)
    title = bool(re.match(r"(?:title|credit|authors?):", lines[0], re.IGNORECASE))
    return forced >= 2 or (title and len(lines) > 2) or _cues(lines) >= 2


def _cues(lines: list[str]) -> int:
    """Names in capitals over a line of small letters, as in a scene without a heading."""
    rows = zip(["", *lines], lines, lines[1:], strict=False)
    return sum(
        not before and re.fullmatch(r"[^\W\d_][^a-z.!?:]{1,30}", line) is not None and after != after.upper()
        for before, line, after in rows
    )


def _refuse_empty(screenplay: Screenplay) -> None:
    """Raise an InputError for a screenplay without action or speech."""
    told = {"heading", "action", "dialogue", "lyric", "shot", "centered"}
    if any(element.kind in told for element in screenplay.elements):
        return
    if screenplay.title_page and not screenplay.elements:
        problem = "there is a title page but no scene"
    elif screenplay.elements and all(element.kind in ("note", "boneyard") for element in screenplay.elements):
        problem = "there are only notes and cut text"
    else:
        problem = "there is no scene and no story in it"
    raise InputError(problem, mend="write at least one scene", path=screenplay.path or None)
