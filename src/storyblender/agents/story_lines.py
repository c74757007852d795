"""The lines of a scene as roles show them to a language model."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from storyblender.memory.outline import SceneOutline, ShotOutline


def story_lines(outline: SceneOutline | None) -> list[dict[str, Any]]:
    """Return what happens and is said in each shot of a scene, in order.

    Args:
        outline: The scene; None where the graph has no words for it.
    """
    shots = outline.shots if outline is not None else ()
    return [{"shot": shot.shot_id, "lines": [*_as_shown(shot)]} for shot in shots]


def lines_of_shot(outline: SceneOutline | None, shot_id: int) -> tuple[str, ...]:
    """Return what happens and is said in one shot of a scene.

    Args:
        outline: The scene; None where the graph has no words for it.
        shot_id: The shot.
    """
    shots = outline.shots if outline is not None else ()
    return next((tuple(_as_shown(shot)) for shot in shots if shot.shot_id == shot_id), ())


def _as_shown(shot: ShotOutline) -> Iterator[str]:
    """Yield the lines of a shot, speeches with the name of their speaker."""
    for line in shot.lines:
        said = " ".join(line.text.split())
        yield f"{line.speaker_name or line.speaker}: {said}" if line.kind == "dialogue" else said
