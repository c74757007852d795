"""The Animator's critic: finds marks where nobody can stand, sit or walk, from the plan of the floor."""

from __future__ import annotations

import itertools
import math

from storyblender.agents.visual_effects_artist.animator import AnimatorDraft, AnimatorView, ShotStaging
from storyblender.agents.visual_effects_artist.crossings import vessel_at
from storyblender.agents.visual_effects_artist.floor import BODY, Floor
from storyblender.catalog.motions import AIMED, MOTIONS
from storyblender.geometry.paths import Vec2
from storyblender.memory.base import shot_name
from storyblender.memory.shot_context import Blocking, Mark
from storyblender.reflection import UNUSABLE, Critique, Fault

LEAST_FREE_SHARE = 0.6
"""Share of a body's radius that must be clear of furniture."""
LEAST_DISTANCE = 0.40
"""Metres between two people below which they overlap, unless they embrace."""
CLOSE_CLIPS = frozenset({"hug", "kiss", "lift", "dance"})
LEAPS = frozenset({"jump", "climb"})
SUPPORTED = frozenset({"sit", "lie", "asleep", "lean"})


class AnimatorCritic:
    """Finds marks inside furniture, outside the set or on one spot, walks without a way, seats in the air."""

    def judge(self, draft: AnimatorDraft, view: AnimatorView) -> Critique:
        """Return the critique of a staging; its fixes are the moves of marks that mend it; unknown motions refuse it.

        Args:
            draft: The staging of all shots of the scene.
            view: The scene.
        """
        floor = Floor(view.layout, view.assets, view.plan)
        scales = {
            asset.asset_id: (asset.canonical.dimensions[2] if asset.canonical else 1.7) / 1.7
            for asset in view.assets
            if asset.asset_type == "character"
        }
        faults: dict[tuple[str, str, Vec2], Fault] = {}
        for shot in draft.shots:
            name = shot_name(view.scene_id, shot.shot_id)
            found = [
                *(fault for each in shot.blocking for fault in _find_bad_places(floor, scales, each, name)),
                *_find_overlaps(floor, scales, shot, name),
                *_find_blocked_walks(floor, scales, shot, name),
            ]
            for key in sorted({cue.clip for cue in shot.cues}.difference(MOTIONS)):
                message = f"{name} has the motion {key!r}, which does not exist"
                found.append(Fault(kind="vocabulary", subject=key, message=message, severity=UNUSABLE))
            for fault in found:
                place = (float(fault.fix.get("x", 0.0)), float(fault.fix.get("y", 0.0)))
                faults.setdefault((fault.kind, fault.subject, place), fault)
        return Critique.of(tuple(faults.values()))


def _find_bad_places(floor: Floor, scales: dict[str, float], blocking: Blocking, name: str) -> list[Fault]:
    """Return the faults of a person's start and end mark in the shot ``name``; ``scales`` are statures over 1.7 m."""
    faults = []
    for mark in (blocking.start, blocking.end):
        scale, place = scales.get(mark.asset_id, 1.0), mark.location[:2]
        if mark.posture in SUPPORTED:
            if mark.support_id is not None and floor.thing(mark.support_id) is None:
                faults.append(_fault("support", mark, f"{name}: {mark.asset_id} rests on {mark.support_id}, not there"))
            elif mark.posture == "sit" and mark.support_id is None:
                faults.append(_fault("support", mark, f"{name}: {mark.asset_id} sits on the ground", severity=0.2))
            continue
        if vessel_at(floor, place) is not None:
            continue
        if floor.room_at(place) < LEAST_FREE_SHARE * BODY * scale and not _is_at_seat(floor, place):
            goal = floor.free_spot(place, scale)
            faults.append(_fault("inside", mark, f"{name}: {mark.asset_id} stands inside furniture", goal))
        elif not floor.inside(place, -floor.walk_on_distance) and not _is_at_set_mark(floor, place):
            goal = floor.free_spot(place, scale)
            faults.append(_fault("off_set", mark, f"{name}: {mark.asset_id} stands outside the set", goal))
    return faults


def _is_at_seat(floor: Floor, place: Vec2) -> bool:
    """Tell whether a floor point is close to a seat that the person has just left or is about to take."""
    seats = (seat for node in floor.things for seat in floor.seats(node))
    return any(math.dist(seat.edge, place) < 0.3 for seat in seats)


def _is_at_set_mark(floor: Floor, place: Vec2) -> bool:
    """Tell whether a floor point is at a mark of the set."""
    return any(math.dist(mark.location[:2], place) < 0.3 for mark in floor.marks)


def _find_overlaps(floor: Floor, scales: dict[str, float], shot: ShotStaging, name: str) -> list[Fault]:
    """Return the faults of people who stand on one spot at the start or the end of a shot."""
    embraced = {frozenset((cue.asset_id, cue.target_id)) for cue in shot.cues if cue.clip in CLOSE_CLIPS}
    faults = []
    for which in ("start", "end"):
        marks: list[Mark] = [getattr(each, which) for each in shot.blocking]
        for one, two in itertools.combinations(marks, 2):
            apart = math.dist(one.location[:2], two.location[:2])
            if apart >= LEAST_DISTANCE or frozenset((one.asset_id, two.asset_id)) in embraced:
                continue
            mover = two if two.posture == "stand" else one
            others = [m.location[:2] for m in marks if m is not mover]
            goal = floor.free_spot(mover.location[:2], scales.get(mover.asset_id, 1.0), others)
            message = f"{name}: {one.asset_id} and {two.asset_id} are on one spot ({apart:.2f} m)"
            faults.append(_fault("overlap", mover, message, goal if mover.posture == "stand" else None))
    return faults


def _find_blocked_walks(floor: Floor, scales: dict[str, float], shot: ShotStaging, name: str) -> list[Fault]:
    """Return the faults of walks without a way, from mark to mark in the order of the cues."""
    place = {each.start.asset_id: each.start for each in shot.blocking}
    faults = []
    for cue in shot.cues:
        here = place.get(cue.asset_id)
        if cue.mark is None or here is None or cue.clip in AIMED:
            continue
        start, goal = here.location[:2], cue.mark.location[:2]
        walks = cue.clip not in LEAPS and cue.mark.posture == "stand" and here.posture == "stand"
        moves = walks and math.dist(start, goal) > 0.1
        if moves and floor.path(start, goal, scales.get(cue.asset_id, 1.0)) is None:
            faults.append(_fault("no_way", cue.mark, f"{name}: {cue.asset_id} cannot walk to its mark"))
        place[cue.asset_id] = cue.mark
    return faults


def _fault(kind: str, mark: Mark, message: str, goal: Vec2 | None = None, severity: float = 1.5) -> Fault:
    """Return a fault at a mark; ``goal`` is the floor point to which the mark should move."""
    x, y, _ = mark.location
    fix: dict[str, float | str] = {"x": x, "y": y}
    if goal is not None:
        fix |= {"to_x": round(goal[0], 3), "to_y": round(goal[1], 3)}
    return Fault(kind=kind, message=message, subject=mark.asset_id, severity=severity, fix=fix)
