"""Files in, screenplays out: encodings, formats, and one clear sentence for everything that is no script."""

from __future__ import annotations

import zlib
from pathlib import Path

import pytest

from storyblender.errors import InputError
from storyblender.screenplay import source
from storyblender.screenplay.source import load, read

SCRIPT = "Title: Élan\n\nINT. CAFÉ - NIGHT\n\nÉLODIE waits.\n\nÉLODIE\nOù est-il ?\n"


@pytest.mark.parametrize(
    "data",
    [
        SCRIPT.encode(),
        SCRIPT.encode("utf-8-sig"),
        SCRIPT.encode("utf-16"),
        b"\xfe\xff" + SCRIPT.encode("utf-16-be"),
        SCRIPT.encode("utf-16-le"),
        SCRIPT.encode("utf-16-be"),
        SCRIPT.encode("utf-32"),
        SCRIPT.encode("cp1252"),
        SCRIPT.replace("\n", "\r\n").encode(),
        SCRIPT.replace("\n", "\r").encode(),
        SCRIPT.replace("\n", "\u2028").encode(),
        (SCRIPT + "\x1a").encode(),
    ],
    ids=["utf8", "bom", "utf16", "be-bom", "le", "be", "utf32", "cp1252", "crlf", "cr", "u2028", "dos-eof"],
)
def test_every_encoding_gives_the_same_screenplay(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "a.fountain"
    path.write_bytes(data)
    assert load(path) == read(SCRIPT, "fountain", path.name)
    assert load(path).title == "Élan"


@pytest.mark.parametrize(
    ("text", "form"),
    [
        ("INT. A - DAY\n\nHe runs.", "fountain"),
        ("Title: A\nAuthor: B\n\nHe runs.", "fountain"),
        (".SOMEWHERE\n\n@bob\nHi.", "fountain"),
        ("Once upon a time there was a king.\n\nHe ran.", "prose"),
        ("<FinalDraft><Content><Paragraph><Text>He runs.</Text></Paragraph></Content></FinalDraft>", "fdx"),
    ],
)
def test_the_format_is_told_from_the_text(text: str, form: str) -> None:
    assert read(text).format == form


XML = '<?xml version="1.0" encoding="UTF-8"?>\n'
BAD: list[tuple[str, str, bytes, str]] = [
    ("empty", "a.fountain", b"", "nothing to read"),
    ("whitespace", "a.fountain", b" \n\t\r\n ", "nothing to read"),
    ("only a BOM", "a.txt", b"\xef\xbb\xbf", "nothing to read"),
    ("pdf", "a.pdf", b"%PDF-1.7\n...", "PDF"),
    ("pdf named fountain", "a.fountain", b"%PDF-1.7\n...", "export the script as Fountain"),
    ("docx", "a.docx", b"PK\x03\x04rest", "Word document"),
    ("doc", "a.doc", b"\xd0\xcf\x11\xe0\xa1\xb1", "Word document"),
    ("rtf", "a.rtf", rb"{\rtf1\ansi Hello}", "rich-text"),
    ("odt", "a.odt", b"PK\x03\x04rest", "OpenDocument"),
    ("zip", "a.zip", b"PK\x03\x04rest", "zip archive"),
    ("fade in", "a.fadein", b"PK\x03\x04rest", "Fade In"),
    ("gzip", "a.gz", b"\x1f\x8b\x08", "gzip"),
    ("png", "a.png", b"\x89PNG\r\n\x1a\n", "picture"),
    ("jpeg", "a.jpg", b"\xff\xd8\xff\xe0", "picture"),
    ("blend", "a.blend", b"BLENDER-v405", ".blend"),
    ("binary", "a.txt", bytes([0xE9, 1, 2, 3, 4, 5, 6, 7, 14, 15, 16] * 50), "binary data"),
    ("compressed", "a.txt", zlib.compress(b"abc" * 999), ""),
    ("NULs", "a.txt", b"INT. A - DAY\n\nHe \0 runs.", "NUL"),
    ("odd utf-16", "a.txt", b"\xff\xfeI\0N\0T", "not valid UTF-16"),
    ("bad utf-8 with BOM", "a.txt", b"\xef\xbb\xbfINT. \xff\xfe", "not valid UTF-8"),
    ("undefined in cp1252", "a.txt", b"caf\xe9 \x81\x8d", "save it as UTF-8"),
    ("broken XML", "a.fdx", (XML + "<FinalDraft>\n<Content>\n</FinalDraft>").encode(), "a.fdx:4: the XML is damaged"),
    ("cut XML", "a.fdx", (XML + "<FinalDraft><Content>").encode(), "damaged"),
    ("other XML", "a.xml", (XML + "<score/>").encode(), "not a Final Draft document"),
    ("plain text as FDX", "a.fdx", b"INT. A - DAY", "damaged"),
    ("html", "a.txt", b"<!DOCTYPE html><html><body>hi", "web page"),
    ("doctype", "a.fdx", (XML + '<!DOCTYPE FinalDraft SYSTEM "x.dtd">\n<FinalDraft/>').encode(), "a.fdx:2: "),
    (
        "bomb",
        "a.fdx",
        (XML + '<!DOCTYPE l [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;">]><FinalDraft>&b;</FinalDraft>').encode(),
        "refused for safety",
    ),
    (
        "external entity",
        "a.fdx",
        (XML + '<!DOCTYPE l [<!ENTITY a SYSTEM "file:///etc/hostname">]><FinalDraft>&a;</FinalDraft>').encode(),
        "refused for safety",
    ),
    ("no content", "a.fdx", (XML + "<FinalDraft/>").encode(), "no script in it"),
    (
        "blank content",
        "a.fdx",
        (XML + "<FinalDraft><Content><Paragraph><Text> </Text></Paragraph></Content></FinalDraft>").encode(),
        "no script in it",
    ),
    ("json", "a.txt", b'{"scenes": []}', "JSON"),
    ("open boneyard", "a.fountain", b"INT. A - DAY\n\nHe runs. /* cut", "a.fountain:3: a boneyard is opened"),
    ("open note", "a.fountain", b"INT. A - DAY\n\n\nHe runs. [[why", "a.fountain:4: a note is opened"),
    ("note in a note", "a.fountain", b"INT. A\n\n[[one [[two]]", "a.fountain:3: a note is opened"),
    ("title page only", "a.fountain", b"Title: A\nAuthor: B\n", "title page but no scene"),
    ("notes only", "a.fountain", b"[[think]]\n\n/* cut */", "only notes"),
    ("outline only", "a.fountain", b"# Act One\n\n= They meet.", "no scene and no story"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "data", "fragment"), [row[1:] for row in BAD], ids=[row[0] for row in BAD])
def test_bad_input_is_one_clear_sentence(tmp_path: Path, name: str, data: bytes, fragment: str) -> None:
    path = tmp_path / name
    path.write_bytes(data)
    with pytest.raises(InputError) as caught:
        load(path)
    message = str(caught.value)
    assert fragment in message
    assert message.startswith(str(path)) and "; " in message and "\n" not in message
    assert caught.value.mend


def test_a_missing_file(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        load(tmp_path / "gone.fountain")


def test_a_folder(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="folder"):
        load(tmp_path)


def test_an_impossible_name(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"no such file|cannot be read"):
        load(tmp_path / ("x" * 300))


def test_an_unreadable_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.fountain"
    path.write_text(SCRIPT)

    def denied(_: Path) -> bytes:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "read_bytes", denied)
    with pytest.raises(InputError, match="Permission denied"):
        load(path)


def test_an_over_large_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.txt"
    path.write_text(SCRIPT)
    monkeypatch.setattr(source, "MAX_BYTES", 10)
    with pytest.raises(InputError, match="far more than a script"):
        load(path)


def test_cues_without_a_heading_are_a_screenplay() -> None:
    play = read("JOHN\nHello.\n\nMARY\nGoodbye.\n")
    assert [element.kind for element in play.elements] == ["cue", "dialogue", "cue", "dialogue"]
    assert read("STOP\n\nHe read the sign. A story about A\nB.\n").format == "prose"


def test_control_characters_become_spaces_and_offsets_stay() -> None:
    screenplay = read("INT. ROOM - DAY\n\nAnna\x07 sits\x1b[31m down.\x85Slowly.\n", "fountain")
    action = screenplay.elements[1]
    assert screenplay.text[action.start : action.end] == "Anna  sits [31m down.\nSlowly."
