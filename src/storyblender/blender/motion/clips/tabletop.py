"""Hands of a seated person: on the table before them if there is one and the place is free, else on the lap."""

from __future__ import annotations

import math
from dataclasses import dataclass

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats, TargetOf
from storyblender.blender.motion.hands import hand, on_thigh
from storyblender.blender.motion.motion_stage import MotionStage
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import StageFurniture
from storyblender.blender.motion.skeleton import sign
from storyblender.memory.asset_sheet import Anchor

NEAREST_EDGE, FARTHEST_EDGE = 0.10, 0.52
"""Metres, times the scale: least and largest distance from the hips to the edge of a table."""
OVER_LAP, UNDER_SHOULDERS = 0.17, 0.16
"""Metres, times the scale: least height of a table above the seat, and below the shoulders."""
OUT = {"L": (0.13, 0.07), "R": (0.10, 0.11)}
"""Metres, times the scale, from the middle of the body and from the table's edge to each palm."""
UPRIGHT = 6.0
"""Least bend of a seated back, degrees."""
APART = 0.13
"""Metres between a palm and the middle of what stands on the table."""


@dataclass(frozen=True)
class Table:
    """A table that a person sits at.

    Attributes:
        edge: Metres from the hips to its edge.
        height: Of its top, metres.
    """

    edge: float
    height: float


def seated_bend(who: Performer, table: Table | None) -> float:
    """Return the degrees by which a seated back is bent: least without a ``table``, more the farther away it is."""
    return UPRIGHT if table is None else UPRIGHT + 45 * max(0.0, table.edge / who.scale - 0.30)


def hand_places_on(who: Performer, hips: Vector, table: Table | None) -> dict[str, Vector]:
    """Return where each palm of a sitter can lie on a table, a world point by side; empty without a table.

    Args:
        who: The person.
        hips: World x and y of their hips, metres.
        table: The table, or None.
    """
    if table is None:
        return {}
    left = who.left
    return {
        side: Vector(
            (
                *(hips + who.forward * (table.edge + beyond * who.scale) + left * (sign(side) * aside * who.scale)),
                table.height,
            )
        )
        for side, (aside, beyond) in OUT.items()
    }


def seated_hand(stage: MotionStage, who: Performer, side: str) -> TargetOf:
    """Return the target of a seated person's free hand: on their table if its place is free, else on the lap.

    Args:
        stage: The stage of the shot.
        who: The person.
        side: ``L`` or ``R``.
    """
    spot = who.table.get(side)
    if spot is None or not _is_free(stage, spot):
        return on_thigh(who, side)
    forward, left = who.forward, who.left
    palm = spot + Vector((0, 0, 0.024 * who.scale))
    fingers = Vector((*(forward - left * (0.5 * sign(side))), 0))
    pole = Vector((*(left * sign(side) - forward * 0.3), -0.3))

    def target(t: float) -> Floats:
        return hand(palm, fingers, Vector((0, 0, -1)), pole, (16, 22, 0))

    return target


def find_table_before(stage: MotionStage, who: Performer, hips: Vector, seat_height: float) -> Table | None:
    """Return the table before a sitter, near enough and neither too low nor too high for their hands, or None.

    Args:
        stage: The stage of the shot.
        who: The person.
        hips: World x and y of their hips, metres.
        seat_height: Of the sitting surface, world metres.
    """
    k = who.scale
    low = seat_height + OVER_LAP * k
    high = seat_height + who.measures.shoulder_height - who.measures.hip_height - UNDER_SHOULDERS * k
    found: list[tuple[float, float]] = []
    for piece in stage.plan.furniture.values():
        for top in piece.anchors:
            height = (Matrix(piece.world.tolist()) @ Vector(top.location)).z
            edge = _edge(piece, top, hips, who.forward) if top.kind == "top" and low < height < high else None
            if edge is not None and NEAREST_EDGE * k < edge < FARTHEST_EDGE * k:
                found.append((edge, height))
    return Table(*min(found)) if found else None


def _edge(piece: StageFurniture, top: Anchor, spot: Vector, forward: Vector) -> float | None:
    """Return the metres from ``spot`` along ``forward`` to the edge of a top; None if it does not lie ahead."""
    back = Matrix(piece.world.tolist()).inverted()
    origin, way = back @ Vector((*spot, 0)), back.to_3x3() @ Vector((*forward, 0))
    near, far = 0.0, math.inf
    for axis in (0, 1):
        half, offset = top.size[axis] / 2, origin[axis] - top.location[axis]
        if abs(way[axis]) < 1e-6:
            if abs(offset) > half:
                return None
            continue
        first, last = sorted((side - offset) / way[axis] for side in (-half, half))
        near, far = max(near, first), min(far, last)
    return near if 0 < near < far else None


def _is_free(stage: MotionStage, spot: Vector) -> bool:
    """Return whether nothing stands on a table at a palm's place."""
    things = [(Vector(each.world[:3, 3].tolist()), each.dimensions) for each in stage.plan.furniture.values()]
    loose = [prop for prop in stage.props.values() if prop.holder is None]
    things += [(each.matrix.translation, tuple(each.size)) for each in loose]
    for place, size in things:
        if abs(place.z - spot.z) < 0.05 and (place.xy - spot.xy).length < APART + 0.35 * max(size[:2]):
            return False
    return True
