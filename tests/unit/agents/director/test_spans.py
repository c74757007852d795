"""Every line of a shot is what the user wrote, character for character, and where they wrote it."""

from __future__ import annotations

from pathlib import Path

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader import read_script
from storyblender.memory.outline import ScriptLine
from storyblender.screenplay.source import load

_SCRIPT = """INT. KITCHEN - DAY #12A#

TOM (30) takes *the* cup [[the red one]] from the table.
He /* slowly */ looks at it.

TOM ^
I said \\*no\\*. [[loud]] And I
meant it — “all” of it…

> A card <
"""


def _lines(path: Path) -> list[ScriptLine]:
    outline = storyboard(read_script(load(path))).storyboard_outline
    return [line for scene in outline for shot in scene.shots for line in shot.lines]


@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"], ids=["plain", "BOM"])
@pytest.mark.parametrize("ends", ["\n", "\r\n", "\r"])
def test_lines_are_the_characters_of_the_file(tmp_path: Path, mark: bytes, ends: str) -> None:
    path = tmp_path / "a.fountain"
    path.write_bytes(mark + _SCRIPT.replace("\n", ends).encode())
    lines = _lines(path)
    assert any(line.kind == "dialogue" for line in lines) and any(line.kind == "action" for line in lines)
    for line in lines:
        assert line.text == _SCRIPT[line.span.start : line.span.end]


def test_lines_of_final_draft_are_its_words(tmp_path: Path) -> None:
    path = tmp_path / "a.fdx"
    told = ["INT. KITCHEN - DAY", "TOM (30) takes   the cup &amp; looks.", "TOM", "I said “no”."]
    types = ["Scene Heading", "Action", "Character", "Dialogue"]
    paragraphs = "".join(
        f'<Paragraph Type="{kind}" Number="12A"><Text>{words[:5]}</Text><Text>{words[5:]}</Text></Paragraph>'
        for kind, words in zip(types, told, strict=True)
    )
    path.write_text(f"<FinalDraft><Content>{paragraphs}</Content></FinalDraft>", encoding="utf-8")
    written = {words.replace("&amp;", "&") for words in told}
    assert {line.text.rstrip(".") for line in _lines(path)} <= {words.rstrip(".") for words in written}
    (scene,) = storyboard(read_script(load(path))).storyboard_outline
    assert scene.script_number == "12A"
