"""Edits of coverage: shots are split, joined and added on the staged time of their scene; nothing is staged again."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any, Final

from storyblender.agents.director.directions import SIZE_OF_KIND
from storyblender.agents.layout_artist.camera_operator_view import pose_of
from storyblender.edits.camera_edits import with_decided_camera
from storyblender.edits.effect import Effect, name_of, refuse_locked
from storyblender.edits.line_frames import line_frames
from storyblender.edits.targets import shots_named
from storyblender.errors import InputError
from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import Film
from storyblender.memory.base import ADDED_FROM, SHOT_STEP, scene_name, shot_number, staged_id
from storyblender.memory.camera_decision import CameraInstruction, CameraRetake
from storyblender.memory.coverage import (
    as_filmed,
    filmed,
    is_beside,
    lines_of,
    parts_of,
    room_for,
    spans_of,
    staged_spans,
)
from storyblender.memory.covers import Covers
from storyblender.memory.edits import AddShotEdit, JoinEdit, SplitEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.shot_context import CameraState, FocusKey, ShotContext
from storyblender.memory.shot_sizes import ShotSize

_CUT = frozenset({"cut"})
_SECONDS = 2.0
"""Length of an added shot, where a person gives none."""
_LIKE_BEFORE: Final = ("kind", "focus_on_ids", "size", "angle", "over_id", "pov_id", "axis")
"""Of its camera, what is as in the shot before it, where a person says nothing of it."""
_SIZES: Final[dict[str, ShotSize]] = {"single": "MCU", "reaction": "MCU", **SIZE_OF_KIND}
"""Its size by the kind of its picture, where a person gives none."""


def split_effects(graph: ContinuityMemoryGraph, edit: SplitEdit) -> list[Effect]:
    """Return the shot that goes on where another one is split: a new one, or that which was joined there.

    Args:
        graph: The story.
        edit: The shot, and where it is split.

    Raises:
        InputError: It cannot be split there.
    """
    [shot] = shots_named(graph, [edit.shot])
    name, fps, whole = name_of(shot), graph.format.fps, filmed(graph, shot)
    _refuse_unfilmed(graph, shot)
    refuse_locked(shot, "duration")
    if is_beside(shot):
        raise InputError(f"{name} is another camera on the same moment", mend="add one more, or change its length")
    frame = edit.frames or (round(edit.seconds * fps) if edit.seconds else _frame_of_line(graph, shot, edit.line or 0))
    if not 0 < frame < whole.duration:
        length = f"{whole.duration} frames ({whole.duration / fps:.3g} s)"
        raise InputError(f"{name} has {length}", mend="split it at a time in between")
    shots = graph.shots_of(shot.scene_id)
    first, staged = spans_of(shots)[shot.shot_id][0] + frame, staged_spans(shots)
    joined = next((each for each in shots if each.joined and staged[each.shot_id][0] == first), None)
    if joined is not None:
        second = joined.model_copy(update={"joined": False})
    else:
        second = _second_part(graph, shot, frame)
    stale = (name,) if whole.frame is None or whole.frame >= frame else ()
    words = f"split at frame {frame} ({frame / fps:.3g} s), goes on as {name_of(second)}"
    return [Effect(second, name, words, _CUT, (*stale, name_of(second)))]


def _frame_of_line(graph: ContinuityMemoryGraph, shot: ShotContext, line: int) -> int:
    """Return the frame of a shot at which its line of a number begins. Raises InputError."""
    frames = line_frames(as_filmed(graph), shot)
    if len(frames) < 2 or line > len(frames):
        said = "one line" if len(frames) == 1 else f"{len(frames) or 'no'} lines"
        mend = "split it at a time" if len(frames) < 2 else f"its lines have the numbers 1 to {len(frames)}"
        raise InputError(f"{name_of(shot)} has {said}", mend=mend)
    return frames[line - 1]


def _second_part(graph: ContinuityMemoryGraph, shot: ShotContext, frame: int) -> ShotContext:
    """Return the shot that begins where another one is split, with the same camera."""
    shots, whole = graph.shots_of(shot.scene_id), filmed(graph, shot)
    first = spans_of(shots)[shot.shot_id][0] + frame
    part, start = _staged_at(shots, shot, first)
    before = sum(begins < frame for begins in line_frames(as_filmed(graph), shot))
    moved = shot.moment_line is not None and shot.moment_line >= before
    outline = graph.outline_of(shot.scene_id)
    planned = [each for each in outline.shots if each.shot_id < part.shot_id] if outline is not None else []
    first_line = lines_of(graph, shot.scene_id)[shot.shot_id][0] + before - sum(len(each.lines) for each in planned)
    return ShotContext(
        scene_id=shot.scene_id,
        shot_id=_free_id(graph, shot, part, first),
        covers=Covers(start=start, first_line=max(first_line, 0)),
        duration=whole.duration - frame,
        in_frame=shot.in_frame,
        moment=shot.moment if moved else None,
        moment_line=shot.moment_line - before if moved and shot.moment_line is not None else None,
        frame=whole.frame - frame if whole.frame is not None and whole.frame >= frame else None,
        camera_instruction=shot.camera_instruction,
        camera_retake=shot.camera_retake or CameraRetake(),
        camera_decision=shot.camera_decision,
        camera=shot.camera and _from_frame(shot.camera, frame, Film(shot.camera.sensor_width, graph.format.aspect)),
        lights=shot.lights,
        locked=tuple(lock for lock in shot.locked if lock == "camera"),
    )


def _from_frame(camera: CameraState, frame: int, film: Film) -> CameraState:
    """Return a camera that goes on from a frame, which is its first then."""
    poses = tuple(each.model_copy(update={"frame": each.frame - frame}) for each in camera.poses if each.frame > frame)
    poses = (pose_of(camera_at(camera, frame, film), 0), *poses) if len(camera.poses) > 1 else camera.poses
    focus = tuple(each.model_copy(update={"frame": each.frame - frame}) for each in camera.focus if each.frame > frame)
    if camera.focus:
        focus = (_focus_key(camera, frame), *focus)
    return camera.model_copy(update={"poses": poses, "focus": focus})


def _focus_key(camera: CameraState, frame: int) -> FocusKey:
    """Return what a camera is focused on at a frame: of one subject, where it is then."""
    before = [key for key in camera.focus if key.frame <= frame] or [camera.focus[0]]
    start = before[-1]
    for key, after in pairwise(camera.focus):
        if key is start and key.node_id == after.node_id and key.frame <= frame < after.frame:
            share = (frame - key.frame) / (after.frame - key.frame)
            x, y, z = (a + (b - a) * share for a, b in zip(key.point, after.point, strict=True))
            return key.model_copy(update={"frame": 0, "point": (x, y, z)})
    return start.model_copy(update={"frame": 0})


def join_effects(graph: ContinuityMemoryGraph, edit: JoinEdit) -> list[Effect]:
    """Return what joining two neighbours does to both. Raises InputError."""
    first, second = shots_named(graph, [edit.shot, edit.other])
    if first.scene_id != second.scene_id:
        mend = "shots are joined within their scene"
        raise InputError(f"{name_of(second)} is in another scene than {name_of(first)}", mend=mend)
    for shot in (first, second):
        _refuse_unfilmed(graph, shot)
        if is_beside(shot):
            raise InputError(f"{name_of(shot)} is another camera on the same moment", mend="omit it instead")
    shots, order = graph.shots_of(first.scene_id), [s for s in graph.shots_in_order(first.scene_id) if not s.omitted]
    spans = spans_of(shots)
    first, second = sorted((first, second), key=lambda shot: spans[shot.shot_id])
    name, gone = name_of(first), name_of(second)
    neighbours = spans[first.shot_id][1] == spans[second.shot_id][0] and order.index(second) == order.index(first) + 1
    if first is second or not neighbours:
        mend = "join shots that follow each other in the script and in the film"
        raise InputError(f"{name} and {gone} are no neighbours", mend=mend)
    refuse_locked(first, "duration")
    for lock in ("duration", "camera"):
        refuse_locked(second, lock)
    if any(not note.resolved for note in second.notes):
        raise InputError(f"{gone} has open notes", mend="resolve or remove them first")
    if second.covers is None and second.lighting is not None:
        raise InputError(f"the light changes in {gone}", mend="its picture begins there")
    if second.covers is not None:
        return [Effect(None, name, "joined", _CUT, (name,)), Effect(second, gone, "joined", _CUT, removed=True)]
    kept = "camera" in first.locked or (first.camera_decision is not None and first.camera_decision.placed is not None)
    update: dict[str, Any] = {} if kept else {"camera": None, "former_camera": None, "lights": ()}
    return [
        Effect(first.model_copy(update=update), name, "joined", _CUT, (name,)),
        Effect(second.model_copy(update={"joined": True}), gone, "joined", _CUT),
    ]


def add_effects(graph: ContinuityMemoryGraph, edit: AddShotEdit) -> list[Effect]:
    """Return the shot that is added after another one. Raises InputError."""
    [shot] = shots_named(graph, [edit.shot])
    name, fps, whole = name_of(shot), graph.format.fps, filmed(graph, shot)
    _refuse_unfilmed(graph, shot)
    if edit.at is not None and round(edit.at * fps) >= whole.duration:
        raise InputError(f"{name} has {whole.duration / fps:.3g} s", mend="begin within them")
    length = max(1, round((edit.seconds or min(_SECONDS, whole.duration / fps)) * fps))
    middle = whole.frame if whole.frame is not None else whole.duration // 2
    begins = round(edit.at * fps) if edit.at is not None else min(max(middle - length // 2, 0), whole.duration - 1)
    shots = graph.shots_of(shot.scene_id)
    first = spans_of(shots)[shot.shot_id][0] + begins
    part, start = _staged_at(shots, shot, first)
    new = ShotContext(
        scene_id=shot.scene_id,
        shot_id=_free_id(graph, shot, part, first),
        covers=Covers(start=start),
        duration=length,
        decided_duration=None if edit.seconds is None else length,
        in_frame=() if edit.decision.focus_on_ids else shot.in_frame,
        camera_instruction=CameraInstruction(**{name: getattr(shot.camera_instruction, name) for name in _LIKE_BEFORE}),
    )
    room = room_for(replace(graph, new), new)
    if edit.seconds is not None and length > room:
        left = f"{room / fps:.3g} s"
        raise InputError(f"{scene_name(shot.scene_id)} ends {left} after that moment", mend=f"give it {left} or less")
    new, words = with_decided_camera(graph, new.model_copy(update={"duration": min(length, room)}), edit.decision)
    camera = new.camera_instruction
    if edit.decision.size is None and (edit.decision.kind or edit.decision.focus_on_ids):
        size = _SIZES.get(camera.kind, camera.size)
        new = new.model_copy(update={"camera_instruction": camera.model_copy(update={"size": size})})
    return [Effect(new, name_of(new), f"added after {name}: {words}", _CUT, (name_of(new),))]


def _staged_at(shots: Sequence[ShotContext], shot: ShotContext, first: int) -> tuple[ShotContext, int]:
    """Return the staged shot in which a frame of the scene lies, of those that a shot shows, and the frame in it."""
    staged = staged_spans(shots)
    part = next(each for each in reversed(parts_of(shots, shot)) if staged[each.shot_id][0] <= first)
    return part, first - staged[part.shot_id][0]


def _refuse_unfilmed(graph: ContinuityMemoryGraph, shot: ShotContext) -> None:
    scene = graph.scene(shot.scene_id)
    if scene.lighting is None:
        raise InputError(f"{name_of(scene)} is not staged yet", mend="run `storyblender render` first")
    for item in (shot, scene):
        if item.omitted:
            raise InputError(f"{name_of(item)} is omitted", mend="restore it first")


def _free_id(graph: ContinuityMemoryGraph, shot: ShotContext, part: ShotContext, first: int) -> int:
    """Return the id of a new shot, whose number is between those of its neighbours in time.

    Args:
        graph: The story.
        shot: The one that it follows in the film.
        part: The staged shot in which it begins.
        first: Its first frame on the time of the scene.

    Raises:
        InputError: No number is free.
    """
    shots = graph.shots_of(shot.scene_id)
    spans = {**staged_spans(shots), **spans_of(shots)}
    here = [each for each in shots if staged_id(each.shot_id) == part.shot_id]
    low = max(shot_number(each.shot_id) for each in here if spans[each.shot_id][0] <= first)
    used = [number for each in here if (number := shot_number(each.shot_id)) > low]
    high = min(used, default=SHOT_STEP * (part.shot_id + 1))
    if high - low < 2 or high >= ADDED_FROM:
        raise InputError(f"no number is free after {name_of(shot)}", mend="join or omit what was split or added there")
    half = low + SHOT_STEP // 2
    return ADDED_FROM + (half if half < high else (low + high) // 2)
