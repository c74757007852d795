"""What moves in a shot, and where in the picture: all else is drawn once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import bpy
import numpy as np
from mathutils import Vector
from numpy.typing import NDArray

from storyblender.blender.measure.figures import figures
from storyblender.blender.render.holds import drawn_anew, pose_now
from storyblender.blender.render.session import DRAWN, RenderSession
from storyblender.geometry.framing import Figure
from storyblender.look.gbuffer import View, same_view
from storyblender.look.optics import Lens
from storyblender.look.raster import Window

_ROOM = 6
"""Pixels round what moves: its lines, and the rounding of its light."""
_NEAR = 0.05
"""Metres before the eye, nearer than which the place of a thing in the picture is not asked."""
_STILL = 1e-5


@dataclass(frozen=True)
class Movement:
    """A shot, looked over before it is drawn.

    Attributes:
        views: The camera at each frame.
        lenses: Its lens at each frame, None where everything is sharp.
        people: Everybody's face at each frame.
        movers: Objects that move, bend, come or go while they are in the picture.
        unseen: Objects outside the picture all the time.
        window: The part of the picture that the movers reach; the whole if the camera moves.
        anew: Whether each frame differs, to the eye, from the last one drawn; if not, that one is held.
    """

    views: tuple[View, ...]
    lenses: tuple[Lens | None, ...]
    people: tuple[tuple[Figure, ...], ...]
    movers: tuple[bpy.types.Object, ...]
    unseen: tuple[bpy.types.Object, ...]
    window: Window
    anew: tuple[bool, ...]

    @property
    def is_locked_off(self) -> bool:
        """Whether the camera stands still."""
        return all(same_view(self.views[0], view) for view in self.views[1:])


def watch(session: RenderSession, frames: Sequence[int], width: int, height: int) -> Movement:
    """Go through a shot and see what moves.

    Args:
        session: The shot; it stands at the last frame after.
        frames: Timeline frames, at least one.
        width: Pixels.
        height: Pixels.
    """
    hidden = set(session.hidden_objects)
    objects = [obj for obj in session.scene.objects if obj.type in DRAWN and obj not in hidden]
    free = [obj for obj in objects if _may_move(obj)]
    views, lenses, people, poses, shown, corners = [], [], [], [], [], []
    for number in frames:
        session.go_to(number)
        depsgraph = session.scene.view_layers[0].depsgraph
        views.append(session.view(width, height))
        lenses.append(session.lens())
        people.append(figures(session.scene))
        poses.append(pose_now(session.scene))
        shown.append([not obj.hide_render for obj in free])
        corners.append(_corners([obj.evaluated_get(depsgraph) for obj in free]))
    boxes, drawn = np.array(corners).reshape(len(views), -1, 8, 3), np.array(shown, bool).reshape(len(views), -1)
    moves = (np.abs(boxes - boxes[:1]).max(axis=(0, 2, 3)) > _STILL) | (drawn != drawn[:1]).any(axis=0)
    moves |= np.array([bool(obj.modifiers) for obj in free], bool)
    misses = np.array([view.misses(box) for view, box in zip(views, boxes, strict=True)]).reshape(drawn.shape)
    seen = drawn & ~misses
    movers = tuple(obj for obj, does, here in zip(free, moves, seen.any(axis=0), strict=True) if does and here)
    fixed = [obj for obj in objects if not _may_move(obj) and not obj.hide_render]
    lost = np.logical_and.reduce([view.misses(_corners(fixed)) for view in views])
    unseen = [obj for obj, out in zip(fixed, lost, strict=True) if out]
    unseen += [obj for obj, here in zip(free, seen.any(axis=0), strict=True) if not here]
    always = tuple(True for _ in views)
    movement = Movement(tuple(views), tuple(lenses), tuple(people), movers, tuple(unseen), views[0].whole, always)
    if not movement.is_locked_off:
        return movement
    reached = [_reached(views[0], box[here & moves]) for box, here in zip(boxes, seen, strict=True)]
    anew = drawn_anew(poses, boxes, drawn, people, views[0])
    return replace(movement, window=_union(reached, views[0]), anew=anew)


def _may_move(obj: bpy.types.Object) -> bool:
    return bool(obj.animation_data or obj.parent or obj.constraints or obj.modifiers)


def _corners(objects: Sequence[bpy.types.Object]) -> NDArray[np.float64]:
    """Return (n, 8, 3) boxes in the world."""
    points = [[obj.matrix_world @ Vector(corner) for corner in obj.bound_box] for obj in objects]
    return np.array(points, np.float64).reshape(-1, 8, 3)


def _reached(view: View, boxes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (4,) top, left, bottom, right of what the boxes cover; more than the picture where one is at the eye."""
    if not len(boxes):
        return np.array([np.inf, np.inf, -np.inf, -np.inf])
    column, row, depth = view.project(boxes)
    if depth.min() < _NEAR:
        return np.array([-np.inf, -np.inf, np.inf, np.inf])
    return np.array([row.min(), column.min(), row.max(), column.max()])


def _union(reached: Sequence[NDArray[np.float64]], view: View) -> Window:
    """Return the even rectangle round all; at least four pixels, so that there is something to draw."""
    low = np.min([rectangle[:2] for rectangle in reached], axis=0) - _ROOM
    high = np.max([rectangle[2:] for rectangle in reached], axis=0) + _ROOM
    size = np.array([view.height, view.width], float)
    first = np.minimum(np.clip(low, 0, size) // 2 * 2, size - 4)
    last = np.maximum(np.minimum(-(-np.clip(high, 0, size) // 2) * 2, size), first + 4)
    return Window(int(first[0]), int(first[1]), int(last[0]), int(last[1]))
