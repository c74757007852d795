"""Notes of the script are kept with the shot or the scene they stand in."""

from __future__ import annotations

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader import read_script
from storyblender.memory.graph import Storyboard
from storyblender.screenplay.source import read

_SCRIPT = """[[ask the writer]]

INT. KITCHEN - DAY [[a real location]]

[[rain on the roof all through]]

Tom walks to the table. [[slowly]] He takes a cup.

[[close on the cup?]]
Anna runs to the door and falls to the floor.

TOM [[hoarse]]
Who is there?

[[check the door]]

/* [[cut]] */

EXT. GARDEN - NIGHT

Anna runs.
[[mud]]
"""


def _plan(text: str) -> Storyboard:
    return storyboard(read_script(read(text)))


def test_a_note_is_kept_with_the_shot_or_scene_it_stands_in() -> None:
    kitchen, garden = _plan(_SCRIPT).storyboard_outline
    assert kitchen.notes == ("ask the writer", "a real location", "rain on the roof all through")
    noted = {line.text: shot.notes for shot in kitchen.shots for line in shot.lines}
    assert "slowly" in next(notes for text, notes in noted.items() if "Tom walks" in text)
    assert "close on the cup?" in next(notes for text, notes in noted.items() if text.startswith("Anna runs"))
    assert {"hoarse", "check the door"} <= {
        *(note for text, notes in noted.items() if not text.startswith("Tom walks") for note in notes)
    }
    assert garden.notes == ()
    assert garden.shots[-1].notes == ("mud",)


def test_every_note_is_kept_once_and_what_is_cut_is_no_note() -> None:
    kept = [
        note
        for scene in _plan(_SCRIPT).storyboard_outline
        for note in (*scene.notes, *(note for shot in scene.shots for note in shot.notes))
    ]
    assert sorted(kept) == sorted(
        ["ask the writer", "a real location", "rain on the roof all through", "slowly", "close on the cup?", "hoarse",
         "check the door", "mud"]
    )  # fmt: skip


def test_brackets_in_prose_are_no_notes() -> None:
    outline = _plan("Tom sat in the kitchen [[twice]] and drank his tea.\n\nHe left.\n").storyboard_outline
    assert not any(shot.notes for scene in outline for shot in scene.shots)


def test_the_notes_of_final_draft_come_after_the_line_or_speech_they_stand_in() -> None:
    note = '<ScriptNote ID="1"><Paragraph><Text>{}</Text></Paragraph></ScriptNote>'
    body = [
        '<Paragraph Type="Scene Heading"><Text>INT. KITCHEN - DAY</Text></Paragraph>',
        f'<Paragraph Type="Action">{note.format("check the cup")}<Text>Ada sits at the table.</Text></Paragraph>',
        '<Paragraph Type="Character"><Text>ADA</Text></Paragraph>',
        f'<Paragraph Type="Dialogue">{note.format("too long?")}<Text>You came back.</Text></Paragraph>',
        '<Paragraph Type="Parenthetical"><Text>(quietly)</Text></Paragraph>',
        '<Paragraph Type="Dialogue"><Text>I knew it.</Text></Paragraph>',
        '<Paragraph Type="Action"><Text>Tom runs to the door.</Text></Paragraph>',
    ]
    text = f'<FinalDraft DocumentType="Script"><Content>{"".join(body)}</Content></FinalDraft>'
    (kitchen,) = _plan(text).storyboard_outline
    told = {shot.lines[0].text: shot.notes for shot in kitchen.shots}
    assert told["Ada sits at the table."] == ("check the cup",)
    assert told["You came back."] == ("too long?",) and not told["Tom runs to the door."]
    speech = next(shot for shot in kitchen.shots if shot.notes == ("too long?",))
    assert [line.text for line in speech.lines] == ["You came back.", "I knew it."]
