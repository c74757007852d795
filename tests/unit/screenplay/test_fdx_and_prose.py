"""Final Draft and prose become the same model."""

from __future__ import annotations

from storyblender.screenplay.fdx import parse as parse_fdx
from storyblender.screenplay.prose import parse as parse_prose

FDX = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FinalDraft DocumentType="Script" Version="5">
  <Content>
    <Paragraph Number="7" Type="Scene Heading">
      <SceneProperties><Summary><Paragraph><Text>Not the script.</Text></Paragraph></Summary></SceneProperties>
      <Text>INT. ATTIC - </Text><Text Style="Bold">NIGHT</Text>
    </Paragraph>
    <Paragraph Type="Action"><Text>Dust &amp; moonlight.</Text></Paragraph>
    <Paragraph><DualDialogue>
      <Paragraph Type="Character"><Text>ANN (O.S.)</Text></Paragraph>
      <Paragraph Type="Dialogue"><Text>Up here!</Text></Paragraph>
      <Paragraph Type="Character"><Text>ŁUCJA</Text></Paragraph>
      <Paragraph Type="Parenthetical"><Text>(whispers)</Text></Paragraph>
      <Paragraph Type="Dialogue"><Text>Down here!</Text></Paragraph>
    </DualDialogue></Paragraph>
    <Paragraph Type="Shot"><Text>CLOSE ON THE TRAPDOOR</Text></Paragraph>
    <Paragraph Type="Transition"><Text>CUT TO:</Text></Paragraph>
  </Content>
  <TitlePage><Content>
    <Paragraph Alignment="Center"><Text>The Attic</Text></Paragraph>
    <Paragraph Alignment="Center"><Text>written by</Text></Paragraph>
    <Paragraph Alignment="Center"><Text>Una Field</Text></Paragraph>
    <Paragraph><Text>una@example.org</Text></Paragraph>
  </Content></TitlePage>
</FinalDraft>
"""


def test_fdx_is_laid_into_text_with_verbatim_spans() -> None:
    screenplay = parse_fdx(FDX)
    assert [element.kind for element in screenplay.elements] == [
        "heading", "action", "cue", "dialogue", "cue", "parenthetical", "dialogue", "shot", "transition",
    ]  # fmt: skip
    assert [screenplay.text[e.start : e.end] for e in screenplay.elements][:2] == [
        "INT. ATTIC - NIGHT",
        "Dust & moonlight.",
    ]
    assert "Not the script" not in screenplay.text


def test_fdx_keeps_numbers_lines_columns_and_title_page() -> None:
    screenplay = parse_fdx(FDX)
    heading, _, ann, _, lucja, aside, speech, *_ = screenplay.elements
    assert (heading.scene_number, heading.line) == ("7", 4)
    assert (ann.name, ann.extension, ann.dual) == ("ANN", "O.S.", False)
    assert (lucja.name, lucja.dual, aside.text, speech.dual) == ("ŁUCJA", True, "whispers", True)
    assert screenplay.title == "The Attic"
    assert dict(screenplay.title_page)["Author"] == "Una Field"


STORY = """# The Lamp

By Una Field

Maren climbed the stairs.
The wind had risen.

"Who is there?" she said.

***

Chapter Two

    Nobody answered.
    She lit the lamp.
"""


def test_prose_becomes_paragraphs_and_sections() -> None:
    screenplay = parse_prose(STORY)
    assert [(e.kind, e.text, e.line) for e in screenplay.elements] == [
        ("action", "Maren climbed the stairs.\nThe wind had risen.", 5),
        ("action", '"Who is there?" she said.', 8),
        ("section", "***", 10),
        ("section", "Chapter Two", 12),
        ("action", "Nobody answered.", 14),
        ("action", "She lit the lamp.", 15),
    ]
    assert (screenplay.title, dict(screenplay.title_page)["Author"]) == ("The Lamp", "Una Field")
    assert all(screenplay.text[e.start : e.end] == e.text for e in screenplay.elements)


def test_long_lines_are_paragraphs_of_their_own() -> None:
    lines = [
        f"{name} walked a very long way along the shore " + "and along the shore again " * 4 for name in ("Ann", "Bo")
    ]
    assert [e.text for e in parse_prose("\n".join(lines)).elements] == [line.strip() for line in lines]


def test_an_author_may_have_initials() -> None:
    screenplay = parse_prose("The Lamp\n\nby U. N. Field\n\nMaren climbed the stairs.")
    assert dict(screenplay.title_page)["Author"] == "U. N. Field"
    assert [element.text for element in screenplay.elements] == ["Maren climbed the stairs."]


def test_fdx_paragraphs_typed_as_action_are_what_they_say() -> None:
    lines = ["FADE IN:", "INT. HALL - DAY", "She runs.", "END OF TEASER", "SMASH CUT TO:"]
    body = "".join(f'<Paragraph Type="Action"><Text>{line}</Text></Paragraph>' for line in lines)
    kinds = [element.kind for element in parse_fdx(f"<FinalDraft><Content>{body}</Content></FinalDraft>").elements]
    assert kinds == ["transition", "heading", "action", "section", "transition"]
