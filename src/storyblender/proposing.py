"""Several stagings of a scene to choose among: each is tried, looked at, and taken back."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import islice
from pathlib import Path
from typing import Literal

from storyblender.agents.layout_artist.layout_things import layout_violations
from storyblender.agents.layout_artist.placed_by_hand import without_placed
from storyblender.agents.layout_artist.spatial_planner_view import measures_of
from storyblender.catalog.sets import plan_of
from storyblender.edits.effect import name_of, shot_names
from storyblender.edits.targets import scene_named, shots_named
from storyblender.errors import InputError
from storyblender.memory.base import Frozen, scene_name
from storyblender.memory.edits import LayoutEdit, TakeEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import SceneContext
from storyblender.session import Session

MOST_PROPOSED = 6
"""Stagings that are proposed at once, at most."""
_TRIES = 2
"""Stagings that are tried for each that is wanted: one with a fault, or like another one, is passed over."""
_ALIKE = 0.25
"""Metres: a staging in which no person and no thing of the story is farther from where it was is no other one."""


class ProposedStaging(Frozen):
    """A staging of a scene that stands to choose."""

    number: int
    """What a layout edit calls it."""
    pictures: dict[str, Path]
    """Preview of each shot that is shown, by name."""
    moved: dict[str, float]
    """Metres between where a person or a thing of the story is now and where it would be, by node id; the far ones."""

    @property
    def words(self) -> str:
        """What is elsewhere, as a person reads it: ``rick 2.1 m, sofa 0.8 m``."""
        return ", ".join(f"{name} {away:.1f} m" for name, away in self.moved.items())


def propose_stagings(session: Session, name: str, wanted: int) -> list[ProposedStaging]:
    """Return other stagings of a scene that have no fault; the scene stays as it is.

    Args:
        session: Of a finished project; while it runs nothing else is to be done with it.
        name: A scene, all of whose shots are then shown, or a shot.
        wanted: How many; fewer are returned where no more are found.

    Raises:
        InputError: There is no such scene or shot, it is locked, or the number cannot be.
        Cancelled: ``cancel`` was called; the scene is as it was.
    """
    if not 1 <= wanted <= MOST_PROPOSED:
        raise InputError(f"{wanted} stagings cannot be proposed", mend=f"ask for 1 to {MOST_PROPOSED}")
    scene = scene_named(session.graph, name)
    if scene.layout is None:
        raise InputError(f"{scene_name(scene.scene_id)} is not staged yet", mend="run `storyblender render` first")
    shown = shot_names(session.graph, scene.scene_id)
    if "_" in name:
        [shot] = shots_named(session.graph, [name])
        shown = (name_of(shot),)
    present = scene.layout_decision.staging or 0 if scene.layout_decision is not None else 0
    others = (number for number in range(0, present + _TRIES * wanted + 1) if number != present)
    seen, found = [scene], list[ProposedStaging]()
    for number in islice(others, _TRIES * wanted):
        tried, pictures = _tried(session, scene, number, shown)
        if all(_moved(tried, each) for each in seen) and not _faulty(session.graph, tried):
            seen.append(tried)
            found.append(ProposedStaging(number=number, pictures=pictures, moved=_moved(tried, scene)))
        if len(found) == wanted:
            break
    return found


def pictures_of_other_takes(session: Session, shot: str, of: Literal["blocking", "layout"]) -> dict[int, Path]:
    """Return pictures of a shot in the other takes of its blocking, or of its scene's layout, by number.

    Args:
        session: Of a finished project; the story stays as it is.
        shot: Its name.
        of: What the takes are of.

    Raises:
        InputError: There is no such shot, or a take of it cannot be at the moment.
        Cancelled: ``cancel`` was called.
    """
    [found] = shots_named(session.graph, [shot])
    kept = found.blocking_takes if of == "blocking" else session.graph.scene(found.scene_id).layout_takes
    others = kept.others if kept is not None else ()
    return {take.number: picture_of_take(session, name_of(found), of, take.number) for take in others}


def picture_of_take(
    session: Session, shot: str, of: Literal["camera", "blocking", "layout"], number: int | None
) -> Path:
    """Return a small picture of a shot in another take of its camera, its blocking or its scene's layout.

    Args:
        session: Of a finished project; the story stays as it is.
        shot: Its name.
        of: What the take is of.
        number: Of the take.

    Raises:
        InputError: There is no such shot or take, or the take cannot be at the moment.
        Cancelled: ``cancel`` was called.
    """
    if number is None:
        raise InputError("no take is named", mend="give its number")
    with session.trying([TakeEdit(shot=shot, of=of, action="choose", number=number)]):
        return session.preview([shot])[shot]


def _tried(
    session: Session, scene: SceneContext, number: int, shown: Sequence[str]
) -> tuple[SceneContext, dict[str, Path]]:
    """Return a scene in another staging, with pictures of its shots; it is taken back, whatever happens."""
    with session.trying([LayoutEdit(scene=scene_name(scene.scene_id), staging=number)]):
        pictures = session.preview(shown)
        return session.graph.scene(scene.scene_id), pictures


def _faulty(graph: ContinuityMemoryGraph, scene: SceneContext) -> bool:
    """Return whether a layout breaks a rule of physics: things in each other, in the air, outside of the room."""
    if scene.layout is None or scene.environment is None:
        return True
    layout = without_placed(graph, scene, scene.layout)
    return bool(layout_violations(layout, measures_of(graph.assets), plan_of(scene.environment)))


def _moved(scene: SceneContext, other: SceneContext) -> dict[str, float]:
    """Return how far each person and thing of the story is from where it is in another staging; the far ones first."""
    there = {item.node_id: item.location for item in (other.layout.objects if other.layout is not None else ())}
    away = {
        item.node_id: round(math.dist(item.location, there[item.node_id]), 2)
        for item in (scene.layout.objects if scene.layout is not None else ())
        if item.node_id in there and not item.node_id.startswith("set_")
    }
    return dict(sorted(((name, far) for name, far in away.items() if far > _ALIKE), key=lambda each: -each[1]))
