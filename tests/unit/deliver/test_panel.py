"""What a panel says about its shot follows from the script and the graph as it is."""

from __future__ import annotations

from storyblender.deliver.panel import panels
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.outline import ScriptLine, ShotOutline, SourceSpan
from storyblender.memory.shot_context import CharacterAction

_CAST = tuple(Asset(asset_id=name.lower(), asset_type="character", description="", name=name) for name in ("Ann", "Bo"))


def _description(graph: ContinuityMemoryGraph, *lines: ScriptLine, **fields: object) -> str:
    """Return the description of the first shot with these lines; ``fields`` are of its context."""
    (scene,) = graph.outline
    outline = scene.model_copy(update={"shots": (ShotOutline(shot_id=1, lines=lines), *scene.shots[1:])})
    shot = graph.shots[0].model_copy(update=fields)
    return panels(replace(graph, outline, shot, *_CAST))[0].description


def _line(text: str, kind: str = "action", **fields: object) -> ScriptLine:
    return ScriptLine(kind=kind, text=text, span=SourceSpan(start=0, end=1), **fields)  # type: ignore[arg-type]


def test_a_description_has_the_lines_in_order_without_marks_and_notes(graph: ContinuityMemoryGraph) -> None:
    speech = _line("I said \\*no\\*. [[loud]]\nAnd I mean it.", "dialogue", speaker="ann", speaker_name="ANN")
    told = _description(graph, _line("she takes *the* cup /* slowly */"), speech, _line("“Oh.”", "dialogue"))
    assert told == "She takes the cup. Ann: “I said *no*. And I mean it.” “Oh.”"


def test_a_speech_is_to_the_person_it_is_addressed_to(graph: ContinuityMemoryGraph) -> None:
    says = CharacterAction(asset_id="ann", action_description="", motion="talk", target_id="bo", line_index=0)
    told = _description(graph, _line("No.", "dialogue", speaker="ann"), character_actions=(says,))
    assert told == "Ann to Bo: “No.”"


def test_a_shot_without_lines_says_whom_its_camera_shows(graph: ContinuityMemoryGraph) -> None:
    camera = graph.shots[0].camera_instruction
    both = camera.model_copy(update={"focus_on_ids": ("ann", "bo")})
    assert _description(graph) == "On Bar."
    assert _description(graph, camera_instruction=both) == "On Ann and Bo."
    insert = both.model_copy(update={"kind": "insert", "focus_on_ids": ("bo",)})
    assert _description(graph, camera_instruction=insert) == "We see Bo."
    wide = both.model_copy(update={"kind": "establishing"})
    assert _description(graph, camera_instruction=wide) == "Bar, before the first line is spoken."


def test_words_under_a_picture_are_in_the_order_of_the_script(graph: ContinuityMemoryGraph) -> None:
    speech = _line("You *came*.", "dialogue", speaker="ann", speaker_name="ANN")
    lines = (speech, _line("She sits."), _line("He waits."), speech)
    (scene,) = graph.outline
    outline = scene.model_copy(update={"shots": (ShotOutline(shot_id=1, lines=lines), *scene.shots[1:])})
    told = panels(replace(graph, outline, graph.shots[0], *_CAST))[0]
    assert told.script == (("ANN", "You came."), ("", "She sits. He waits."), ("ANN", "You came."))
