"""Small subjects of a shot at its story moment: things in hands, and parts of people in inserts."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView, Moment
from storyblender.geometry.boxes import Box, distance_to_point
from storyblender.geometry.framing import Figure
from storyblender.memory.base import Vec3
from storyblender.memory.shot_context import ShotContext
from storyblender.memory.vocabulary import Hand

_HAND = 0.2
"""Metres of a hand with what it holds."""
_SMALL, _AT_HAND = 1.0, 0.9
"""Metres of the largest thing that is framed with its person, and its farthest distance from them."""
_AHEAD = 0.25
"""Metres by which a hand counts as further ahead of the hips when its front is computed."""
_FEET = (0.5, 0.3)
"""Metres: width and height of two feet."""
_EYES, _MOUTH = (0.08, 0.3), (-0.28, 0.25)
"""Height above the middle of the face and height of the part, in head heights."""


def story_moment_of(moments: Sequence[Moment]) -> Moment:
    """Return the story moment of a shot's moments (start, story moment, end)."""
    return moments[len(moments) // 2]


def held_box(figure: Figure, hand: Hand | None, size: Vec3) -> Box:
    """Return the approximate box of a thing in a person's hands: at the hand, or half an arm in front of the chest.

    Args:
        figure: The person.
        hand: The hand; None for both.
        size: Width, depth and height of the thing in metres.
    """
    yaw = math.radians(figure.yaw)
    if figure.hands and hand is not None:
        x, y, z = figure.hands[hand == "R"]
        return Box(x, y, z - size[2] / 2, *size, yaw)
    x, y, z = figure.face
    ahead, below = 1.4 * figure.head, 2.0 * figure.head
    return Box(x + ahead * math.sin(yaw), y - ahead * math.cos(yaw), z - below, *size, yaw)


def held_things(view: CameraOperatorView) -> tuple[Box, ...]:
    """Return the boxes of small focus things near the first person, so that one picture holds both."""
    if not view.people or view.detail is not None or (view.asked.focus_on_ids and not view.things):
        return ()
    x, y, _ = view.people[0].base
    small = (box for box in view.things if max(box.width, box.depth, box.height) < _SMALL)
    return tuple(box for box in small if distance_to_point(box, x, y) < _AT_HAND)


def detail_box(shot: ShotContext, moments: Sequence[Moment]) -> Box | None:
    """Return the box of the part of a person that an insert shows; None if the shot shows no such part.

    Args:
        shot: The shot with its instruction and cues.
        moments: Its moments; may be empty.
    """
    instruction = shot.camera_instruction
    who = instruction.focus_on_ids[0] if instruction.focus_on_ids else None
    figure = story_moment_of(moments).figure(who) if moments else None
    if instruction.detail is None or figure is None:
        return None
    yaw, (x, y, z) = math.radians(figure.yaw), figure.face
    if instruction.detail == "hand":
        x, y, z = _acting_hand(shot, figure, story_moment_of(moments).frame)
        # A hand's front is away from the body: in front of the chest ahead, beside the hip to the left or right.
        out_x, out_y = x - figure.base[0] + _AHEAD * figure.forward[0], y - figure.base[1] + _AHEAD * figure.forward[1]
        return Box(x, y, z - _HAND / 2, _HAND, _HAND, _HAND, math.atan2(out_x, -out_y))
    if instruction.detail == "feet":
        width, height = _FEET
        return Box(*figure.base, width, width, height, yaw)
    up, share = _EYES if instruction.detail == "eyes" else _MOUTH
    height = share * figure.head
    width = 2 * height
    return Box(x, y, z + up * figure.head - height / 2, width, height, height, yaw)


def _acting_hand(shot: ShotContext, figure: Figure, frame: int) -> Vec3:
    """Return the world point of the hand that acts at a frame, else holds something, else is furthest ahead."""
    if not figure.hands:
        box = held_box(figure, None, (_HAND, _HAND, _HAND))
        return box.x, box.y, box.z + _HAND / 2
    acting = [cue.hand for cue in shot.cues if cue.asset_id == figure.node_id and cue.hand and cue.start <= frame]
    holding = [state.hand for state in shot.prop_states if state.held_by == figure.node_id and state.hand]
    if hand := next(iter([*reversed(acting), *holding]), None):
        return figure.hands[hand == "R"]
    way = figure.forward
    return max(figure.hands, key=lambda point: sum(a * b for a, b in zip(point, way, strict=True)))
