"""Where the shots of a film lie on the staged time of their scene, and what of it each shows.

The crew stages the shots that the Director planned, one after another: the time of the scene. A person may split a
shot, join it to the one before it, or add another camera: then a shot of the film shows a part of a staged shot, or
several of them. Nothing is staged again for that.

What a film shot shows is derived here and stored nowhere: the graph keeps shots as they are staged.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import accumulate, pairwise
from typing import Any, TypeVar

from storyblender.memory.base import staged_id
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline, ScriptLine, ShotOutline
from storyblender.memory.shot_context import Blocking, BodyState, CharacterAction, Cue, PropState, ShotContext

Span = tuple[int, int]
"""The first, and the one after the last: frames on the time of a scene, or indices of its lines."""
_Own = TypeVar("_Own", Blocking, BodyState, PropState)


def is_cut_anew(shots: Sequence[ShotContext]) -> bool:
    """Return whether a person split, joined or added any of these shots."""
    return any(shot.covers is not None or shot.joined for shot in shots)


def is_beside(shot: ShotContext) -> bool:
    """Return whether a shot is another camera on the time of other shots, with no time and no lines of its own."""
    return shot.covers is not None and shot.covers.first_line is None


def room_for(graph: ContinuityMemoryGraph, shot: ShotContext) -> int:
    """Return the frames from the start of a shot to the end of its scene."""
    shots = graph.shots_of(shot.scene_id)
    return max(end for _, end in staged_spans(shots).values()) - spans_of(shots)[shot.shot_id][0]


def staged_spans(shots: Sequence[ShotContext]) -> dict[int, Span]:
    """Return the frames of the staged shots of a scene, by id.

    Args:
        shots: All shots of the scene, in story order.
    """
    staged = [shot for shot in shots if shot.covers is None]
    ends = accumulate((shot.duration for shot in staged), initial=0)
    return {shot.shot_id: span for shot, span in zip(staged, pairwise(ends), strict=True)}


def spans_of(shots: Sequence[ShotContext]) -> dict[int, Span]:
    """Return the frames of the film's shots on the time of their scene, by id; together they leave none of it out.

    Args:
        shots: All shots of the scene, in story order.
    """
    staged = staged_spans(shots)
    total = max((end for _, end in staged.values()), default=0)
    starts: dict[int, int] = {}
    spans: dict[int, Span] = {}
    for shot in shots:
        begin, end = staged[staged_id(shot.shot_id)]
        if shot.joined:
            continue
        if shot.covers is None:
            starts[shot.shot_id] = begin
        elif shot.covers.first_line is not None:
            starts[shot.shot_id] = min(begin + shot.covers.start, end - 1)
        else:
            first = min(begin + shot.covers.start, total - 1)
            spans[shot.shot_id] = (first, min(first + shot.duration, total))
    ordered = sorted(starts, key=lambda shot_id: starts[shot_id])
    for shot_id, end in zip(ordered, [*(starts[shot_id] for shot_id in ordered[1:]), total], strict=True):
        spans[shot_id] = (starts[shot_id], max(end, starts[shot_id] + 1))
    return spans


def parts_of(shots: Sequence[ShotContext], shot: ShotContext) -> tuple[ShotContext, ...]:
    """Return the staged shots of which a shot of the film shows anything, in order.

    Args:
        shots: All shots of its scene, in story order.
        shot: One of them that is not joined to another.
    """
    first, end = spans_of(shots)[shot.shot_id]
    staged = staged_spans(shots)
    there = (each for each in shots if each.covers is None)
    return tuple(each for each in there if staged[each.shot_id][0] < end and first < staged[each.shot_id][1])


def lines_of(graph: ContinuityMemoryGraph, scene_id: int) -> dict[int, Span]:
    """Return which lines of their scene the shots of the film have, by id; together they have every line once.

    Args:
        graph: The story.
        scene_id: The scene.
    """
    starts, total = _line_starts(graph.outline_of(scene_id))
    own: dict[int, int] = {}
    found: dict[int, Span] = {}
    for shot in graph.shots_of(scene_id):
        first = starts.get(staged_id(shot.shot_id), total)
        if shot.joined:
            continue
        if is_beside(shot):
            found[shot.shot_id] = (first, first)
        else:
            own[shot.shot_id] = first + (0 if shot.covers is None else shot.covers.first_line or 0)
    spans = spans_of(graph.shots_of(scene_id))
    ordered = sorted(own, key=lambda shot_id: spans[shot_id])
    for shot_id, end in zip(ordered, [*(own[shot_id] for shot_id in ordered[1:]), total], strict=True):
        found[shot_id] = (own[shot_id], max(end, own[shot_id]))
    return found


def as_filmed(graph: ContinuityMemoryGraph) -> ContinuityMemoryGraph:
    """Return the graph with its shots and their lines as the film shows them, without those joined to others.

    Args:
        graph: The story; one of which no shot is split, joined or added is returned as it is.
    """
    if not is_cut_anew(graph.shots):
        return graph
    shots = tuple(filmed(graph, shot) for shot in graph.shots if not shot.joined)
    return graph.model_copy(update={"shots": shots, "outline": tuple(_outline(graph, each) for each in graph.outline)})


def filmed(graph: ContinuityMemoryGraph, shot: ShotContext) -> ShotContext:
    """Return a shot as the film shows it: its length there, and what people do in that time.

    Args:
        graph: The story.
        shot: Of the graph, perhaps with another camera; one that shows just what is staged for it is returned as it is.
    """
    shots = graph.shots_of(shot.scene_id)
    if shot.joined or not is_cut_anew(shots):
        return shot
    (first, end), staged = spans_of(shots)[shot.shot_id], staged_spans(shots)
    if shot.covers is None and (first, end) == staged[shot.shot_id]:
        return shot
    parts, lines = parts_of(shots, shot), lines_of(graph, shot.scene_id)[shot.shot_id]
    starts, _ = _line_starts(graph.outline_of(shot.scene_id))
    modifications = tuple(each for part in parts for each in part.asset_modifications)
    ends = {each.start.asset_id: each for part in parts for each in part.blocking}
    update: dict[str, Any] = {
        "duration": end - first,
        "covers": None,
        "on_stage": tuple(dict.fromkeys(each for part in parts for each in part.on_stage)),
        "states": _first_of(each for part in parts for each in part.states),
        "end_states": tuple({each.asset_id: each for part in parts for each in part.end_states}.values()),
        "thing_spots": {thing: spot for part in parts for thing, spot in part.thing_spots.items()},
        "absent": tuple(each for each in parts[0].absent if all(each in part.absent for part in parts)),
        "tethers": tuple(dict.fromkeys(each for part in parts for each in part.tethers)),
        "asset_modifications": modifications,
        "character_actions": tuple(each for part in parts for each in _actions(part, starts, lines)),
        "sound_effect": next((part.sound_effect for part in parts if part.sound_effect), None),
        "blocking": tuple(
            each.model_copy(update={"end": ends[each.start.asset_id].end})
            for each in _first_of(each for part in parts for each in part.blocking)
        ),
        "cues": tuple(cue for part in parts for cue in _cues(part, staged[part.shot_id][0] - first, end - first)),
        "prop_states": _first_of(each for part in parts for each in part.prop_states),
        "flaws": (*shot.flaws, *(flaw for part in parts if part.joined for flaw in part.flaws)),
    }
    if shot.moment_line is not None and shot.moment_line >= lines[1] - lines[0]:
        update |= {"moment": None, "moment_line": None}
    if shot.frame is not None and shot.frame >= end - first:
        update["frame"] = None
    return shot.model_copy(update=update)


def _first_of(items: Iterator[_Own]) -> tuple[_Own, ...]:
    """Return the first item of each person or thing."""
    found: dict[str, _Own] = {}
    for item in items:
        found.setdefault(item.start.asset_id if isinstance(item, Blocking) else item.asset_id, item)
    return tuple(found.values())


def _line_starts(outline: SceneOutline | None) -> tuple[dict[int, int], int]:
    """Return the index in the scene of the first line of each planned shot, by id, and the number of all lines."""
    counts = [len(shot.lines) for shot in outline.shots] if outline is not None else []
    starts = [*accumulate(counts, initial=0)]
    return dict(zip((shot.shot_id for shot in outline.shots) if outline else (), starts, strict=False)), starts[-1]


def _outline(graph: ContinuityMemoryGraph, outline: SceneOutline) -> SceneOutline:
    """Return the words of a scene, parted among its shots as the film has them; notes of the script stay first."""
    shots = graph.shots_of(outline.scene_id)
    if not is_cut_anew(shots):
        return outline
    lines: list[ScriptLine] = [line for shot in outline.shots for line in shot.lines]
    planned = {shot.shot_id: shot for shot in outline.shots}
    own, spans, staged = lines_of(graph, outline.scene_id), spans_of(shots), staged_spans(shots)
    found: list[ShotOutline] = []
    for shot in shots:
        if shot.joined:
            continue
        begun = [part for part in parts_of(shots, shot) if staged[part.shot_id][0] >= spans[shot.shot_id][0]]
        notes = tuple(note for part in begun if not is_beside(shot) for note in planned[part.shot_id].notes)
        first, end = own[shot.shot_id]
        found.append(ShotOutline(shot_id=shot.shot_id, lines=tuple(lines[first:end]), notes=notes))
    return outline.model_copy(update={"shots": tuple(found)})


def _actions(part: ShotContext, starts: dict[int, int], lines: Span) -> Iterator[CharacterAction]:
    """Yield the actions of a staged shot that are of some lines of its scene, or of none."""
    offset = starts.get(part.shot_id, 0) - lines[0]
    for action in part.character_actions:
        if action.line_index is None:
            yield action
        elif 0 <= action.line_index + offset < lines[1] - lines[0]:
            yield action.model_copy(update={"line_index": action.line_index + offset})


def _cues(part: ShotContext, offset: int, length: int) -> Iterator[Cue]:
    """Yield the cues of a staged shot that are played in a shot of the film, counted from its start.

    A cue without a length that begins before is played on in it, unless the same person has begun another one by then.
    """
    for cue in part.cues:
        start = cue.start + offset
        later = (each.start + offset for each in part.cues if each.asset_id == cue.asset_id and each.start > cue.start)
        over = start + cue.duration if cue.duration is not None else min(later, default=length)
        if start >= length or (start < 0 and over <= 0):
            continue
        duration = cue.duration if cue.duration is None or start >= 0 else over
        yield cue.model_copy(update={"start": max(start, 0), "duration": duration})
