"""Way points that a person set: the first walk of a shot goes through them, around what is in the way between them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.geometry.paths import Vec2, walk_through
from storyblender.memory.scene_decision import PersonMarks
from storyblender.memory.shot_context import Flaw

_ON_IT = 1e-6
"""Metres."""


def take_way_points(stage: StageState, marks: Mapping[str, PersonMarks]) -> None:
    """Let people know the way points of their next walk.

    Args:
        stage: As a shot begins; changed.
        marks: That a person set, by asset id.
    """
    for person in stage.people.values():
        person.via = marks.get(person.asset_id, PersonMarks()).via or ()


def find_way(floor: Floor, person: StagedPerson, goal: Vec2, others: Sequence[Vec2]) -> list[Vec2] | None:
    """Return the way of a walk as floor points, past furniture and, if there is room, past people; None without one.

    Args:
        floor: Of the scene.
        person: Who walks; through their way points, if all of them can be reached.
        goal: Last floor point.
        others: Floor points of people in the way.
    """

    def leg(start: Vec2, end: Vec2) -> list[Vec2] | None:
        return floor.path(start, end, person.scale, others) or floor.path(start, end, person.scale)

    return walk_through(leg, (person.place, *person.via, goal)) or leg(person.place, goal)


def passed_on(person: StagedPerson, way: Sequence[Vec2]) -> tuple[Vec2, ...]:
    """Return the way points of a person that a walk goes through; they have no others until the next shot.

    Args:
        person: Who walks; changed.
        way: Floor points.
    """
    passed = tuple(point for point in person.via if any(math.dist(point, each) < _ON_IT for each in way))
    person.via = tuple(point for point in person.via if point not in passed)
    return passed


def missed_way_points(stage: StageState) -> Iterator[Flaw]:
    """Yield a flaw for each person who has not come through all of their way points.

    Args:
        stage: After a shot.
    """
    for person in stage.people.values():
        if person.via and person.present:
            spots = "; ".join(f"{x:g}, {y:g}" for x, y in person.via)
            message = f"{person.asset_id} does not walk through {spots}, which a person set"
            yield Flaw(kind="mark", subject=person.asset_id, weight=0.1, message=message)
