"""Writing and drawing: the tip of what is held meets the page, whether it lies, hangs or is held in the other hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats
from storyblender.blender.motion.clips.gaze import look_at
from storyblender.blender.motion.clips.handling import release_prop, take_in_hand
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.clips.using import return_hands, table_height, upright_sheet
from storyblender.blender.motion.hands import hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import StageFurniture
from storyblender.blender.motion.skeleton import SIDES, frame, other, rigid_matrix, sign
from storyblender.blender.motion.staged_props import StagedProp

PAGE_THICKNESS, PAGE_WIDTH = 0.07, 0.07
"""Metres: what is thinner and wider than this is written on."""
TOOL_THICKNESS, TOOL_LENGTH = 0.05, 0.5
"""Metres: what is thinner and shorter than this is written with."""
WITHIN = 1.15
"""Arm lengths on the floor to a page or a surface that is written on where it is."""
FINGERTIPS = 0.1
"""Metres from the palm to the fingertips of an empty hand, times the scale."""
STROKES = 17.0
"""Radians a second of the strokes of letters."""
_DOWN = Vector((0.35, -0.5, -0.8)), Vector((0.8, 0.5, 0.0))
"""Fingers and palm of a writing right hand over a page, in the person's frame."""
_AHEAD = Vector((0.25, -0.95, -0.15)), Vector((0.85, 0.25, -0.4))
"""Fingers and palm of a writing right hand at an upright surface, in the person's frame."""

PointOf = Callable[[float], Vector]


@dataclass(frozen=True)
class _Surface:
    """What is written on.

    Attributes:
        point: Where the tip is at a second, without the strokes: world metres.
        across: Direction of a line.
        upright: Whether it is a wall or a board.
    """

    point: PointOf
    across: Callable[[float], Vector]
    upright: bool = False


@dataclass(frozen=True)
class _Line:
    """How a tip moves over a page.

    Attributes:
        length: Metres of a line.
        a_second: Lines a second.
        stroke: Height in metres of the strokes of letters.
    """

    length: float = 0.06
    a_second: float = 0.35
    stroke: float = 0.004


@clip("write", "hands", "head")
def write(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Write on the page, on the surface ahead, or on the table or the lap. Return the end in seconds."""
    return _move_tip(stage, who, cue, _Line())


@clip("draw", "hands", "head")
def draw(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Draw, as one writes. Return the end in seconds."""
    return _move_tip(stage, who, cue, _Line())


@clip("cross_out", "hands", "head")
def cross_out(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Draw straight lines through words, as on a paper that one writes on. Return the end in seconds."""
    return _move_tip(stage, who, cue, _Line(0.14, 0.9, 0.0))


def _move_tip(stage: MotionStage, who: Performer, cue: StagedCue, line: _Line) -> float:
    """Move the tip of a tool over what is written on; return the end in seconds."""
    t, end = cue.start, cue.start + (cue.duration or 3.0)
    tool, page = _tool_of(stage, who, cue), _page_of(stage, who, cue)
    side = _writing_side(who, cue, tool, page)
    if tool is not None and tool.holder is not who and side not in who.held:
        take_in_hand(stage, who, side, tool, t)
    surface = _surface(stage, who, cue, page, side, t)
    who.lean_after.set(t, 0, 0.0)
    who.hands[side].set(t, 0.7, _hand_at(who, side, tool, surface, line, t))
    if other(side) not in who.held and not surface.upright:
        who.hands[other(side)].set(t, 0.7, _flat_hand(who, other(side), surface))
    who.accent.set(t, 0.6, (0 if surface.upright else 10, 0, 0))
    look_at(who, t, lambda now: tuple(surface.point(now)))
    return return_hands(stage, who, end)


def is_page(size: Vector) -> bool:
    """Return whether a thing of this size (metres) is written on: a sheet, a stack of forms, a notebook."""
    thin, wide, _ = sorted(size)
    return thin < PAGE_THICKNESS and wide > PAGE_WIDTH


def is_tool(size: Vector) -> bool:
    """Return whether a thing of this size (metres) is written with: a pen, a brush, a piece of chalk."""
    _, thick, long = sorted(size)
    return thick < TOOL_THICKNESS and long < TOOL_LENGTH


def tip_of(tool: StagedProp) -> Vector:
    """Return the tip of a tool in its own frame: its end at the front, or at the bottom if it was made upright."""
    if tool.size.z >= max(tool.size.x, tool.size.y):
        return Vector((0, 0, 0))
    if tool.size.x > tool.size.y:
        return Vector((-tool.size.x / 2, 0, tool.size.z / 2))
    return Vector((0, -tool.size.y / 2, tool.size.z / 2))


def _in_hand(stage: MotionStage, who: Performer) -> list[StagedProp]:
    """Return the props in a person's hands."""
    return [stage.props[name] for name in dict.fromkeys(who.held.values()) if name in stage.props]


def _tool_of(stage: MotionStage, who: Performer, cue: StagedCue) -> StagedProp | None:
    """Return what a person writes with, or None."""
    return next((each for each in (cue.prop, *_in_hand(stage, who)) if each is not None and is_tool(each.size)), None)


def _page_of(stage: MotionStage, who: Performer, cue: StagedCue) -> StagedProp | None:
    """Return the page that a person writes on: the one they are told to, in their hands, or the nearest; or None."""
    told = [each for each in (cue.target, cue.prop) if isinstance(each, StagedProp) and is_page(each.size)]
    held = [each for each in _in_hand(stage, who) if is_page(each.size)]
    near = [each for each in (*told, *held) if each.holder is who or _is_near(who, each.matrix.translation)]
    return next(iter(near), None)


def _is_near(who: Performer, place: Vector) -> bool:
    """Return whether a person's hands reach a world point without a step."""
    return (place.xy - who.position).length < WITHIN * who.measures.arm


def _writing_side(who: Performer, cue: StagedCue, tool: StagedProp | None, page: StagedProp | None) -> str:
    """Return the hand that writes: the one with the tool, else the one without the page."""
    for side in SIDES:
        if tool is not None and who.held.get(side) == tool.asset_id:
            return side
    if page is not None and who.held.get(cue.side) == page.asset_id:
        return other(cue.side)
    return cue.side


def _surface(
    stage: MotionStage, who: Performer, cue: StagedCue, page: StagedProp | None, side: str, t: float
) -> _Surface:
    """Return what a person writes on; a page in their hands is brought before them, or laid on the table."""
    if page is not None and page.holder is who:
        return _held_page(stage, who, page, side, t)
    if page is not None:
        top = _top_of(page)
        return _Surface(lambda now: page.matrix @ top, lambda now: _across(who))
    if isinstance(cue.target, StageFurniture) and (at := _on_front(who, cue.target)) is not None:
        return _Surface(lambda now: at, lambda now: _across(who), upright=True)
    k, height = who.scale, table_height(stage, who)
    ahead = (0.36 if who.posture == "sit" else 0.34) * k + 0.04

    def on_table(now: float) -> Vector:
        spot = who.point("hips") + who.facing @ Vector((0, -ahead, 0))
        return Vector((spot.x, spot.y, height + 0.002))

    return _Surface(on_table, lambda now: _across(who))


def _held_page(stage: MotionStage, who: Performer, page: StagedProp, side: str, t: float) -> _Surface:
    """Hold a page in the other hand before the chest, its face up and to the eyes."""
    k, far = who.scale, other(side)
    width, thick = sorted(page.size)[1], min(page.size)
    flat = page.size.z <= 0.5 * min(page.size.x, page.size.y)

    def sheet(now: float) -> Matrix:
        place = who.point("upper_chest", (sign(far) * 0.04 * k, -0.3 * k, -0.17 * k))
        normal = ((who.eyes_point() - place).normalized() + Vector((0, 0, 0.9))).normalized()
        across = who.direction("upper_chest", Vector((1, 0, 0)))
        across = (across - normal * across.dot(normal)).normalized()
        return rigid_matrix(Matrix((across, normal.cross(across), normal)).transposed(), place)

    def under(now: float) -> Floats:
        matrix, s = sheet(now), sign(far)
        turn = matrix.to_3x3()
        return hand(
            matrix @ Vector((s * (0.5 * width - 0.03), -0.05, -0.03)), turn @ Vector((-s * 0.6, 0.75, 0)),
            turn @ Vector((0, 0, 1)), who.direction("upper_chest", Vector((s * 0.8, 0, -0.7))), (0, 0, -15),
        )  # fmt: skip

    release_prop(stage, page)
    who.held[far] = page.asset_id
    page.holder = who
    who.hands[far].set(t, 0.7, under)
    page.follow(t + 0.2, lambda now: sheet(now) if flat else sheet(now) @ upright_sheet(page), 0.5)
    return _Surface(
        lambda now: sheet(now) @ Vector((0, 0.02, thick + 0.002)), lambda now: sheet(now).to_3x3() @ Vector((1, 0, 0))
    )


def _top_of(page: StagedProp) -> Vector:
    """Return the middle of a lying or leaning page's face in its own frame."""
    if page.size.z <= 0.5 * min(page.size.x, page.size.y):
        return Vector((0, 0, page.size.z + 0.002))
    return Vector((0, -page.size.y / 2 - 0.002, page.size.z / 2))


def _on_front(who: Performer, thing: StageFurniture) -> Vector | None:
    """Return the world point of a thing's box that is nearest to a person's writing hand; None if it is too far."""
    world = Matrix(thing.world.tolist())
    ahead = who.to_world(Vector((0, 0, 0)))
    hand_height = ahead.z + 0.85 * who.measures.shoulder_height if who.posture == "stand" else ahead.z + 0.5 * who.scale
    local = world.inverted() @ Vector((*who.position, hand_height))
    half = (thing.dimensions[0] / 2, thing.dimensions[1] / 2)
    near = Vector(
        (
            max(-half[0], min(half[0], local.x)),
            max(-half[1], min(half[1], local.y)),
            max(0.0, min(thing.dimensions[2], local.z)),
        )
    )
    place = world @ near
    return place if _is_near(who, place) else None


def _across(who: Performer) -> Vector:
    """Return the direction of a line on a page before a person: from their left to their right."""
    return who.facing @ Vector((1, 0, 0))


def _hand_at(
    who: Performer, side: str, tool: StagedProp | None, surface: _Surface, line: _Line, t: float
) -> Callable[[float], Floats]:
    """Return the target of a hand whose tool, or whose fingertips, write on a surface."""
    flip = Vector((-sign(side), 1, 1))
    fingers, normal = (each * flip for each in (_AHEAD if surface.upright else _DOWN))
    grip = tool.grip(side) if tool is not None else None
    reach = Vector(fingers) * (FINGERTIPS * who.scale)
    if tool is not None and grip is not None:
        turn = frame(fingers, normal) @ frame(grip.fingers, grip.normal).transposed()
        reach = turn @ (tip_of(tool) - grip.palm)
    pole = Vector((sign(side) * 0.8, 0.4, -0.6))
    curl = grip.curl if grip is not None else (50, 60, 15)

    def target(now: float) -> Floats:
        since = now - t
        along = line.length * ((since * line.a_second) % 1.0 - 0.5)
        stroke = Vector((0, 0, line.stroke * math.sin(STROKES * since)))
        tip = surface.point(now) + surface.across(now) * along + stroke
        facing = who.facing
        return hand(tip - facing @ reach, facing @ fingers, facing @ normal, facing @ pole, curl)

    return target


def _flat_hand(who: Performer, side: str, surface: _Surface) -> Callable[[float], Floats]:
    """Return the target of an empty hand that lies beside what is written."""
    s = sign(side)

    def target(now: float) -> Floats:
        spot = surface.point(now) + who.facing @ Vector((s * 0.13, 0.02, 0.02))
        fingers = who.facing @ Vector((-s * 0.6, -0.8, 0))
        return hand(spot, fingers, Vector((0, 0, -1)), who.facing @ Vector((s * 0.8, 0.4, -0.6)), (10, 12, 0))

    return target
