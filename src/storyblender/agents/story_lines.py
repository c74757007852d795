"""The lines of a scene as roles show them to a language model."""

from __future__ import annotations

from typing import Any

from storyblender.memory.outline import SceneOutline, ScriptLine


def story_lines(outline: SceneOutline | None) -> list[dict[str, Any]]:
    """Return what happens and is said in each shot of a scene, in order.

    Args:
        outline: The scene; None where the graph has no words for it.
    """
    shots = outline.shots if outline is not None else ()
    return [{"shot": shot.shot_id, "lines": [_as_shown(line) for line in shot.lines]} for shot in shots]


def _as_shown(line: ScriptLine) -> str:
    """Return a line with the name of its speaker."""
    said = " ".join(line.text.split())
    return f"{line.speaker_name or line.speaker}: {said}" if line.kind == "dialogue" else said
