"""Notes of a Fountain or Final Draft script, assigned to scenes and shots."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from storyblender.agents.director.reading import SceneReading
from storyblender.memory.outline import SourceSpan
from storyblender.screenplay.comments import find_comments
from storyblender.screenplay.model import Screenplay

_BLANK_LINE = re.compile(r"\n[^\S\n]*\n")


class ScriptNote(NamedTuple):
    """A note; ``start`` and ``end`` are the characters of the script that it fills, marks included."""

    start: int
    end: int
    text: str


def notes_by_scene(screenplay: Screenplay, scenes: Sequence[SceneReading]) -> dict[int, list[ScriptNote]]:
    """Return the notes of each scene by its id; a note above the first scene belongs to the first.

    Args:
        screenplay: The script; prose has no notes.
        scenes: In the order of the script.
    """
    found: dict[int, list[ScriptNote]] = {}
    starts = [scene.start for scene in scenes]
    for note in _notes(screenplay) if scenes else ():
        scene = scenes[max(0, bisect_right(starts, note.start) - 1)]
        found.setdefault(scene.id, []).append(note)
    return found


def _notes(screenplay: Screenplay) -> Iterator[ScriptNote]:
    """Yield the notes of a script, in order."""
    text = screenplay.text
    if screenplay.format == "fdx":
        spans = [(element.start, element.end) for element in screenplay.elements if element.kind == "note"]
    elif screenplay.format == "fountain":
        spans = [(comment.start, comment.end) for comment in find_comments(text) if comment.kind == "note"]
    else:
        return
    for start, end in spans:
        words = text[start + 2 : end - 2].strip()
        if words:
            yield ScriptNote(start, end, words)


def notes_by_shot(
    notes: Sequence[ScriptNote], shots: Sequence[Sequence[SourceSpan]], text: str
) -> dict[int | None, list[str]]:
    """Return the notes of one scene by the index of their shot; those of the scene itself under None.

    A note belongs to the line it stands in or after. One that stands directly above a line, after a blank line, belongs
    to that line; one before the first line of the scene belongs to the scene.

    Args:
        notes: The notes of the scene.
        shots: The script spans of each shot, in order.
        text: The script.
    """
    lines = sorted((span.start, index) for index, spans in enumerate(shots) for span in spans)
    ends = {span.start: span.end for spans in shots for span in spans}
    starts = [start for start, _ in lines]
    found: dict[int | None, list[str]] = {}
    for note in notes:
        after = bisect_right(starts, note.start)
        shot = lines[after - 1][1] if after else None
        stands_apart = not after or _BLANK_LINE.search(text, ends[starts[after - 1]], note.start)
        if stands_apart and after < len(lines) and not _BLANK_LINE.search(text, note.end, starts[after]):
            shot = lines[after][1]
        found.setdefault(shot, []).append(note.text)
    return found
