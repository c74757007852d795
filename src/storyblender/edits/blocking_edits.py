"""Edits of people in a shot: where they start, go and end it, how they stand or sit, what they look at and hold."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from storyblender.agents.visual_effects_artist.animator_critic import LEAST_DISTANCE, LEAST_FREE_SHARE
from storyblender.agents.visual_effects_artist.floor import BODY, Floor
from storyblender.agents.visual_effects_artist.marks_by_hand import ON_FLOOR
from storyblender.catalog.sets import plan_of
from storyblender.edits.effect import Effect, name_of, refuse_far, refuse_locked, shot_names
from storyblender.edits.moving import as_moved, merged_motions
from storyblender.edits.posing import as_posed
from storyblender.edits.targets import person_or_thing, shots_named
from storyblender.errors import InputError
from storyblender.memory.base import Vec2, shot_name, staged_id
from storyblender.memory.edits import BlockingEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.scene_decision import BlockingDecision, DecidedLine, PersonMarks, PersonPlace
from storyblender.memory.shot_context import Blocking, Mark, ShotContext

_JUMP = 0.3
"""Metres from the end of one shot to the start of the next that are told."""
_STEP = 0.05
"""Metres from start to end of a shot that are no walk."""
_CARRIED = ("sit", "lean")
"""Postures whose place is that of what carries the person."""


def blocking_effects(graph: ContinuityMemoryGraph, edit: BlockingEdit) -> list[Effect]:
    """Return what setting the marks of a person in a shot does: the scene is acted again from there.

    Args:
        graph: The story.
        edit: The person by their id or name.

    Raises:
        InputError: They are not on stage, or sit or lie; a place cannot be; or something is locked.
    """
    [shot] = shots_named(graph, [edit.shot])
    scene, name = graph.scene(shot.scene_id), name_of(shot)
    person = person_or_thing(graph, edit.person)
    refuse_locked(shot, "blocking")
    if shot.covers is not None:
        staged = shot_name(shot.scene_id, staged_id(shot.shot_id))
        raise InputError(f"{name} shows what is staged for {staged}", mend="set the marks there")
    own = next((each for each in shot.blocking if each.start.asset_id == person), None)
    if own is None:
        there = ", ".join(each.start.asset_id for each in shot.blocking)
        mend = f"there are: {there}" if there else "run `storyblender render` first" if shot.on_stage else "nobody is"
        raise InputError(f"{person} is not on stage in {name}", mend=mend)
    start, end = (
        None if place is None else as_posed(graph, scene, person, _on_floor(place, scene))
        for place in (edit.marks.start, edit.marks.end)
    )
    moved = as_moved(graph, shot, person, edit.marks.motions)
    _refuse_no_line(graph, shot, person, edit.marks.lines)
    via = _way_points(edit.marks.via, scene)
    marks = PersonMarks(start=start, end=end, via=via, motions=moved, lines=edit.marks.lines)
    decided = shot.blocking_decision or BlockingDecision()
    before = decided.people.get(person, PersonMarks())
    whole = PersonMarks(
        start=_over(before.start, marks.start),
        end=_over(before.end, marks.end),
        via=before.via if marks.via is None else marks.via or None,
        motions=merged_motions(before.motions, marks.motions),
        lines=_merged_lines(before.lines, marks.lines),
    )
    _refuse_no_walk(name, own, whole)
    _refuse_seated(name, own.start, whole.start, marks.start)
    _refuse_given_twice(decided, person, whole)
    decided = decided.then(BlockingDecision(people={person: whole}))
    item = shot.model_copy(update={"blocking_decision": decided, "stale": ("motion",)})
    said = BlockingDecision(people={person: marks}).words
    effect = Effect(item, name, said, frozenset({"blocking"}), shot_names(graph, shot.scene_id))
    return [effect.warned(tuple(_in_the_way(graph, shot, person, marks)))]


def _over(before: PersonPlace | None, now: PersonPlace | None) -> PersonPlace | None:
    """Return a place with what was decided before where it says nothing; another posture is on something else."""
    if before is None or now is None:
        return now or before
    gone = {"on", *(("location", "rotation") if now.posture in _CARRIED else ())} if now.posture is not None else set()
    return PersonPlace(**{**before.model_dump(exclude=gone), **now.model_dump(exclude_none=True)})


def _on_floor(place: PersonPlace, scene: SceneContext) -> PersonPlace:
    """Return a place as marks have it: to the millimetre and the tenth of a degree. Raises InputError."""
    location = None if place.location is None else (round(place.location[0], 3), round(place.location[1], 3))
    if location is not None:
        refuse_far((*location, 0.0), scene)
    rotation = None if place.rotation is None else round(place.rotation % 360.0, 1)
    return place.model_copy(update={"location": location, "rotation": rotation})


Lines = Mapping[int, DecidedLine | None]


def _merged_lines(before: Lines, now: Lines) -> dict[int, DecidedLine | None]:
    """Return when lines are said, with later decisions on top; what the crew has back is no more decided."""
    both = {
        number: was.then(line)
        for number, line in now.items()
        if line is not None and (was := before.get(number)) is not None
    }
    return {number: line for number, line in {**before, **now, **both}.items() if line is not None}


def _refuse_no_line(graph: ContinuityMemoryGraph, shot: ShotContext, person: str, lines: Lines) -> None:
    """Refuse lines that the person does not say in the shot."""
    outline = graph.outline_of(shot.scene_id)
    said = next((each.lines for each in outline.shots if each.shot_id == shot.shot_id), ()) if outline else ()
    own = [number for number, line in enumerate(said, 1) if line.kind == "dialogue" and line.speaker == person]
    for number in lines:
        if number not in own:
            mend = f"theirs: {', '.join(map(str, own))}" if own else "they say nothing in it"
            raise InputError(f"line {number} of {name_of(shot)} is not said by {person}", mend=mend)


def _way_points(via: tuple[Vec2, ...] | None, scene: SceneContext) -> tuple[Vec2, ...] | None:
    """Return way points to the millimetre. Raises InputError for one far off the set."""
    for x, y in via or ():
        refuse_far((x, y, 0.0), scene)
    return via and tuple((round(x, 3), round(y, 3)) for x, y in via)


def _refuse_no_walk(name: str, own: Blocking, whole: PersonMarks) -> None:
    """Refuse way points for a person who goes nowhere."""
    goes = whole.end is not None and whole.end.location is not None
    if whole.via and not goes and math.dist(own.start.location, own.end.location) < _STEP:
        mend = "set where they end the shot"
        raise InputError(f"{own.start.asset_id} does not walk anywhere in {name}", mend=mend)


def _refuse_seated(name: str, start: Mark, whole: PersonPlace | None, now: PersonPlace | None) -> None:
    """Refuse a place on the floor for a person who is on something as the shot begins."""
    if now is None or whole is None or (now.location is None and now.rotation is None):
        return
    posture, on = (start.posture, start.support_id) if whole.posture is None else (whole.posture, whole.on)
    if posture == "stand" or (whole.posture in ON_FLOOR and on is None):
        return
    mend = f"move {on}, let them stand, or set where they end" if on else "let them stand, or set where they end"
    raise InputError(f"{start.asset_id} does not stand as {name} begins ({posture})", mend=mend)


def _refuse_given_twice(decided: BlockingDecision, person: str, whole: PersonMarks) -> None:
    """Refuse to put a thing into the hands of two people."""
    for other, marks in decided.people.items():
        for mine, theirs in ((whole.start, marks.start), (whole.end, marks.end)):
            both = {*((mine and mine.holding) or ())} & {*((theirs and theirs.holding) or ())}
            if other != person and both:
                raise InputError(f"{other} holds {', '.join(sorted(both))}", mend="empty their hands first")


def _in_the_way(graph: ContinuityMemoryGraph, shot: ShotContext, person: str, marks: PersonMarks) -> Iterator[str]:
    """Yield a sentence for each mark of a person that is in furniture, in another person, or outside of the set."""
    scene = graph.scene(shot.scene_id)
    if scene.layout is None or scene.environment is None:
        return
    floor = Floor(scene.layout, graph.assets_of(scene.scene_id), plan_of(scene.environment))
    for x, y in marks.via or ():
        if floor.room_at((x, y)) < LEAST_FREE_SHARE * BODY:
            yield f"{person} cannot walk through {x:g}, {y:g} in {name_of(shot)}: something is there"
    for when, place in (("start", marks.start), ("end", marks.end)):
        if place is None or place.location is None:
            continue
        there = f"{person} at the {when} of {name_of(shot)}"
        if floor.room_at(place.location) < LEAST_FREE_SHARE * BODY:
            yield f"{there} stands in furniture or in a wall"
        elif not floor.inside(place.location, -floor.walk_on_distance):
            yield f"{there} stands outside of the set"
        if when == "start" and (cut := _cut_from(graph, shot, person, place.location)):
            yield f"{there} is {cut}"
        others = {each.start.asset_id: getattr(each, when).location[:2] for each in shot.blocking}
        others.pop(person, None)
        near = [other for other, spot in others.items() if math.dist(spot, place.location) < LEAST_DISTANCE]
        if near:
            yield f"{there} stands in {', '.join(near)}"


def _cut_from(graph: ContinuityMemoryGraph, shot: ShotContext, person: str, place: Vec2) -> str:
    """Return how far a mark is from where the shot before leaves a person; empty where that is near, or nowhere."""
    before = [each for each in graph.shots_of(shot.scene_id) if each.shot_id < shot.shot_id][-1:]
    ends = [mark.end.location[:2] for each in before for mark in each.blocking if mark.end.asset_id == person]
    away = math.dist(ends[0], place) if ends else 0.0
    return f"{away:.1f} m from where {name_of(before[0])} leaves them" if away > _JUMP else ""
