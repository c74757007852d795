"""What a revised script would change, shot by shot, before anything is changed."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import SequenceMatcher
from pathlib import Path
from typing import Literal

from storyblender.memory.base import Frozen, scene_name, shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import ShotOutline
from storyblender.pipeline.grounding import planned_revision
from storyblender.pipeline.kept_cut import ShotKey
from storyblender.pipeline.revision import matched_shots
from storyblender.pipeline.run import Run

_ALIKE = 0.5
"""Share of its words that a changed shot has in common with what it was."""


class ShotChange(Frozen):
    """One shot that a revised script changes."""

    kind: Literal["new", "changed", "moved", "omitted"]
    shot: str
    """Its name in the revised story; of one that is omitted, in the story as it is."""
    former: str = ""
    """Its name in the story as it is; empty for a new one."""
    words: str
    """What the script says of it now; of one that is omitted, what it said."""
    former_words: str = ""
    """What the script said, where that has changed."""


class ScriptChanges(Frozen):
    """What a revised script would change."""

    shots: tuple[ShotChange, ...]
    """In the order of the revised story, those that are omitted last."""
    renamed: dict[str, str]
    """Former names of shots that only get another number, by the new ones."""
    lost: tuple[tuple[str, str], ...]
    """Shot or scene, and what a person decided of it that cannot be kept, because its words are gone."""
    kept_scenes: tuple[str, ...]
    """Scenes of the revised story that stay as they are staged."""
    scenes: int
    """How many scenes the revised story has."""


def script_changes(run: Run, script: Path, reading: Path | None = None) -> ScriptChanges:
    """Return what a revised script would change; nothing is committed.

    Args:
        run: On the project of the script.
        script: As it is revised.
        reading: A corrected reading of it.

    Raises:
        InputError: The script, or the reading, cannot be read.
    """
    revision = planned_revision(run, script, reading)
    old, new = run.graph, revision.graph
    matched = matched_shots(old.outline, new.outline)
    changed = _changed(old, new, matched)
    moved = _moved(matched)
    former, present = _shots(old), _shots(new)
    shots: list[ShotChange] = []
    for key, shot in present.items():
        name, words = shot_name(*key), _words(shot)
        if key in changed:
            past = changed[key]
            was = {"former": shot_name(*past), "former_words": _words(former[past])}
            shots.append(ShotChange(kind="changed", shot=name, words=words, **was))
        elif key not in matched:
            shots.append(ShotChange(kind="new", shot=name, words=words))
        elif key in moved:
            shots.append(ShotChange(kind="moved", shot=name, former=shot_name(*matched[key]), words=words))
    there = {*matched.values(), *changed.values()}
    gone = ((shot_name(*key), _words(shot)) for key, shot in former.items() if key not in there)
    shots += (ShotChange(kind="omitted", shot=name, former=name, words=words) for name, words in gone)
    renamed = {shot_name(*key): shot_name(*past) for key, past in matched.items() if key != past and key not in moved}
    kept = tuple(scene_name(scene_id) for scene_id in revision.kept_scenes)
    return ScriptChanges(
        shots=tuple(shots), renamed=renamed, lost=revision.lost, kept_scenes=kept, scenes=len(new.scenes)
    )


def _shots(graph: ContinuityMemoryGraph) -> dict[ShotKey, ShotOutline]:
    return {(scene.scene_id, shot.shot_id): shot for scene in graph.outline for shot in scene.shots}


def _words(shot: ShotOutline) -> str:
    return " ".join(" ".join(line.text.split()) for line in shot.lines)


def _changed(
    old: ContinuityMemoryGraph, new: ContinuityMemoryGraph, matched: Mapping[ShotKey, ShotKey]
) -> dict[ShotKey, ShotKey]:
    """Return what unmatched new shots were before, where their words are much alike: old keys by new keys."""
    there = {*matched.values()}
    left = {key: _words(shot).split() for key, shot in _shots(old).items() if key not in there}
    found: dict[ShotKey, ShotKey] = {}
    for key, shot in _shots(new).items():
        if key in matched:
            continue
        words = _words(shot).split()
        alike = {past: SequenceMatcher(None, words, were, autojunk=False).ratio() for past, were in left.items()}
        best = max(alike, key=lambda past: alike[past], default=None)
        if best is not None and alike[best] >= _ALIKE:
            found[key] = best
            del left[best]
    return found


def _moved(matched: Mapping[ShotKey, ShotKey]) -> set[ShotKey]:
    """Return the new shots that stand elsewhere among the others than they did."""
    present = sorted(matched)
    was = [matched[key] for key in present]
    blocks = SequenceMatcher(None, was, sorted(was), autojunk=False).get_matching_blocks()
    stay = {start + step for start, _, length in blocks for step in range(length)}
    return {key for place, key in enumerate(present) if place not in stay}
