"""Animal heads on people's bodies, with moving eyes, jaw and facial expressions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from storyblender.blender.people import animal_eyes
from storyblender.blender.people.animal_skull import HINGE, Skull
from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.pack import PARTS
from storyblender.blender.people.sheet import Sheet, join, normals, rigid_sheet
from storyblender.blender.people.solids import ball, bar, skinned
from storyblender.catalog.expressions import FACE
from storyblender.catalog.materials import hex_color
from storyblender.catalog.species import Species
from storyblender.geometry.implicit import Field, surface
from storyblender.geometry.solids import Floats
from storyblender.memory.base import Color

Point = tuple[float, float, float]
SKULL = 0.155
"""Radius of the head in metres, on an adult of 1.70 m with head size 1."""
STEP = 0.055
"""Edge length of the mesh faces of the head, in head radii."""
_OPEN = 20.0
"""Largest opening of the jaw in degrees."""
_HEAD_LINE, _NECK_LINE = 6.75, 6.2
"""Heights on the base mesh in decimetres: above the first the person's head becomes the animal's skull; below the
second it is unchanged."""


@dataclass
class AnimalHead:
    """The head of an animal while it is built; lengths are in head radii: x to the animal's left, y back, z up.

    Attributes:
        species: Species of the animal.
        skull: Shape and colours of the skull.
        center: Centre of the skull, metres.
        radius: Radius of the skull, metres.
        sheets: Sheets built so far.
        colors: Vertex colours (V, 3) of each sheet.
        keys: Offsets (V, 3) of the shape keys of each sheet.
    """

    species: Species
    skull: Skull
    center: Floats
    radius: float
    sheets: list[Sheet] = field(default_factory=list)
    colors: list[Floats] = field(default_factory=list)
    keys: list[Mapping[str, Floats]] = field(default_factory=list)

    def to_metres(self, points: ArrayLike) -> Floats:
        """Convert points (N, 3) from head radii to metres."""
        return self.center + np.asarray(points, float) * self.radius

    def add(self, sheet: Sheet, color: str | Floats, keys: Mapping[str, Floats] | None = None) -> None:
        """Add a sheet.

        Args:
            sheet: The sheet, in metres.
            color: ``main`` for the coat, ``pale``, ``dark``, a hex code, or the colour of each vertex.
            keys: Offsets (V, 3) of its shape keys, metres.
        """
        if isinstance(color, str):
            named = {"main": self.skull.coat, "pale": self.skull.pale, "dark": self.skull.coat * 0.42}
            color = np.tile(named[color] if color in named else np.array(hex_color(color)), (len(sheet.points), 1))
        self.sheets.append(sheet)
        self.colors.append(np.clip(color, 0, 1))
        self.keys.append(keys or {})

    def add_ball(self, color: str, at: Point, half: Point, turn: Point = (0, 0, 0)) -> None:
        """Add an ellipsoid.

        Args:
            color: As in ``add``.
            at: Its middle, head radii.
            half: Semi-axes, head radii.
            turn: Degrees about X, then Y, then Z.
        """
        self.add(ball(self.to_metres(at), np.array(half) * self.radius, bone_weights("head"), rotation=turn), color)

    def add_bar(self, color: str, points: Sequence[Point], radii: Sequence[float]) -> None:
        """Add a round bar.

        Args:
            color: As in ``add``.
            points: Its path, head radii.
            radii: Its radius at each point, head radii.
        """
        self.add(bar(self.to_metres(points), [each * self.radius for each in radii], bone_weights("head")), color)

    def mesh_of(self, form: Field) -> tuple[Sheet, Floats]:
        """Return the mesh of a distance field, and its vertices (V, 3) in head radii."""
        points, faces = surface(form, *self.skull.bounds(form), STEP)
        return rigid_sheet(self.to_metres(points), faces.tolist(), bone_weights("head")), points

    def joined(self) -> tuple[Sheet, Floats, dict[str, Floats]]:
        """Return the whole head as one sheet, its vertex colours and the offsets of its shape keys."""
        whole = join(self.sheets)
        keys = {
            key: np.concatenate(
                [keys.get(key, np.zeros_like(sheet.points)) for sheet, keys in zip(self.sheets, self.keys, strict=True)]
            )
            for key in FACE
        }
        return whole, np.concatenate(self.colors), keys


def place_skull(points: Floats, joints: Mapping[str, Floats], species: Species, scale: float) -> tuple[Floats, float]:
    """Return the centre and the radius of an animal's skull, metres.

    Args:
        points: (V, 3) vertices of the person's body, metres.
        joints: Positions of the joints ``neck`` and ``l-eye``.
        species: Species of the animal.
        scale: Size of the person's head relative to an adult's.
    """
    radius = SKULL * scale * species.head
    crown = float(points[PARTS["skin"], 2].max())
    front = float(joints["l-eye"][1])
    return np.array((0.0, front + 0.55 * radius, max(crown - 0.75 * radius, joints["neck"][2] + 0.8 * radius))), radius


def replace_head(base: Floats, points: Floats, center: Floats, radius: float) -> Floats:
    """Return the body with its head replaced by the animal's round skull, for hats and the camera.

    Args:
        base: (V, 3) vertices of the base mesh, decimetres.
        points: (V, 3) vertices of the body, metres.
        center: Centre of the skull, metres.
        radius: Radius of the skull, metres.
    """
    skin = PARTS["skin"]
    share = np.clip((base[skin, 1] - _NECK_LINE) / (_HEAD_LINE - _NECK_LINE), 0, 1)[:, None]
    share = share * (np.abs(base[skin, 0]) < 1.3)[:, None]
    away = points[skin] - center
    round_ = center + 0.95 * radius * away / np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-6)
    moved = points.copy()
    moved[skin] = points[skin] * (1 - share) + round_ * share
    return moved


def build_head(figure: BodyFigure, species: Species, coat: Color, center: Floats, radius: float) -> AnimalHead:
    """Return the head of an animal without its eyeballs, with a neck down into the collar.

    Args:
        figure: Body that carries the head.
        species: Species of the animal.
        coat: Colour of its coat.
        center: Centre of its skull, metres.
        radius: Radius of its skull, metres.
    """
    head = AnimalHead(species, Skull(species, coat), center, radius)
    _skull(head)
    _neck(head, figure)
    _eyelids(head)
    _lips(head)
    return head


def eye_centers(head: AnimalHead) -> dict[str, Floats]:
    """Return the centre of each eyeball by side, metres."""
    return {side: head.to_metres(head.skull.eyes * (sign, 1, 1)) for side, sign in (("L", 1), ("R", -1))}


def _skull(head: AnimalHead) -> None:
    """Add skull, beak and jaw."""
    skull = head.skull
    sheet, points = head.mesh_of(skull.form)
    colors = skull.paint(points)
    mouth = np.array(hex_color("#3a1416"))
    if skull.jaw is not None:  # inside of the mouth, visible when the jaw opens
        colors[(skull.jaw(points) < 0.0) & (points[:, 1] < -0.6)] = mouth
    head.add(sheet, colors)
    if skull.beak is not None:
        sheet, points = head.mesh_of(skull.beak)
        head.add(sheet, np.tile(skull.pale, (len(points), 1)) * np.interp(points[:, 2:], (-0.4, 0.1), (0.75, 1.0)))
    if skull.jaw is None:
        return
    sheet, points = head.mesh_of(skull.jaw)
    colors = np.tile(skull.pale * 0.8, (len(points), 1)) if skull.beak is not None else skull.paint(points)
    hidden = (skull.form if skull.beak is None else skull.beak)(points) < -0.01
    colors[hidden] = mouth
    tongue = (
        hidden
        & (normals(sheet)[:, 2] > 0.6)
        & (np.abs(points[:, 0]) < 0.5 * skull.thick)
        & (points[:, 1] > skull.tip[1] + 0.3)
    )
    colors[tongue] = hex_color("#a8484e")
    head.add(sheet, colors, {key: _opened(points, share) * head.radius for key, share in _JAW_KEYS.items()})


_JAW_KEYS = {"mouth_open": 1.0, "wail": 0.7, "snarl": 0.4, "grin": 0.25}


def _opened(points: Floats, share: float) -> Floats:
    """Return the offsets of jaw points when the jaw opens by ``share`` (0 to 1) of its range."""
    turn = np.radians(_OPEN * share)
    away = points - HINGE
    y = away[:, 1] * np.cos(turn) - away[:, 2] * np.sin(turn)
    z = away[:, 1] * np.sin(turn) + away[:, 2] * np.cos(turn)
    return np.stack([away[:, 0], y, z], 1) - away


def _neck(head: AnimalHead, figure: BodyFigure) -> None:
    """Add a neck from inside the skull to below the collar; it bends with the person's neck."""
    base, top = figure.joint("neck"), head.center
    thick = min(0.6, 0.5 / head.species.head + 0.06) * head.radius
    path = [base - (0, 0, 0.03 * figure.scale), base + 0.3 * (top - base), base + 0.65 * (top - base), top]
    sheet = bar(path, [thick * 1.1, thick, thick, thick], bone_weights("head"))
    share = np.clip((sheet.points[:, 2] - base[2]) / max(float(top[2] - base[2]) * 0.6, 1e-6), 0, 1)[:, None]
    sheet.weights[:] = share * bone_weights("head") + (1 - share) * bone_weights("neck")
    local = (sheet.points - head.center) / head.radius
    head.add(sheet, head.skull.paint(local + np.array((0, 0, 0.2))))


def _eyelids(head: AnimalHead) -> None:
    """Add eyelids and brows."""
    skull, radius = head.skull, head.skull.eye * head.radius
    for sign, center in zip((1, -1), eye_centers(head).values(), strict=True):
        sheet, keys = animal_eyes.eyelids(center, radius)
        at = skull.eyes * (sign, 1, 1)
        around = at + np.array([(0, -0.1, 0.2), (0, -0.1, -0.24)])
        upper, lower = skull.paint(around) * 0.82
        half = len(sheet.points) // 2
        head.add(sheet, np.concatenate([np.tile(upper, (half, 1)), np.tile(lower, (half, 1))]), keys)
        if not skull.goggling:
            _brow(head, sign)


def _brow(head: AnimalHead, sign: int) -> None:
    """Add an eyebrow on the side of ``sign`` (1 left, -1 right): darker than the coat, or lighter on a dark one."""
    skull = head.skull
    eye, x = skull.eyes, np.linspace(-0.85, 0.95, 7)
    line = []
    for at in x:
        side = sign * (eye[0] + at * skull.eye * 1.05)
        height = eye[2] + skull.eye * (1.66 - 0.16 * at - 0.3 * at * at)
        line.append((side, skull.front_y(side, height) - 0.005, height))
    under = skull.paint(np.array(line)).mean(0)
    color = under * 0.35 if under.mean() > 0.07 else under + 0.16
    radii = np.interp(x, (-0.85, -0.2, 0.95), (0.03, 0.036, 0.014)) * head.radius
    sheet = bar(head.to_metres(line), list(radii), bone_weights("head"))
    inner = np.interp(np.abs((sheet.points[:, 0] - head.center[0]) / head.radius) - eye[0], (-0.2, 0.2), (1, 0))
    moves = {"brow_up": (0.14, 0.14), "brow_down": (-0.13, 0.02), "worry": (0.15, -0.07), "snarl": (-0.06, 0.04)}
    keys = {}
    for key, (near, far) in moves.items():
        keys[key] = np.zeros_like(sheet.points)
        keys[key][:, 2] = (far + (near - far) * inner) * head.radius
    head.add(sheet, np.tile(color, (len(sheet.points), 1)), keys)


_CORNERS = {"smile": 0.17, "grin": 0.15, "frown": -0.15, "wail": -0.16, "wrinkle": -0.05, "purse": 0.0}
"""How far each shape key lifts the corners of the mouth."""


def _lips(head: AnimalHead) -> None:
    """Add the mouth line around the snout, with shape keys for smiling and frowning."""
    skull = head.skull
    if head.species.mouth not in ("snout", "wide"):
        return
    if head.species.mouth == "wide":
        middle, wide, height = np.array((0.0, -0.15, -0.2)), 80.0, -0.24
    else:
        middle, wide = np.array((0.0, skull.tip[1] + 0.3 + 0.3 * skull.long, 0.0)), 104.0
        height = skull.tip[2] - 0.42 * skull.thick
    turns = np.radians(np.linspace(-wide, wide, 25))
    bend = np.abs(np.linspace(-1, 1, 25))

    def line(lift: float) -> Floats:
        rise = height + (0.12 + lift) * bend**2
        ways = np.stack([np.sin(turns), -np.cos(turns), 0 * turns], 1)
        starts = np.stack([0 * rise, middle[1] + 0 * rise, rise], 1) + 2.5 * ways
        return np.array([skull.cast_ray(start, -way) for start, way in zip(starts, ways, strict=True)])

    radii = [0.019 * head.radius * (1 - 0.5 * share**3) for share in bend]
    sheet = bar(head.to_metres(line(0.0)), radii, bone_weights("head"))
    keys = {}
    for key, lift in _CORNERS.items():
        moved = bar(head.to_metres(line(lift)), radii, bone_weights("head"))
        keys[key] = moved.points - sheet.points
    head.add(sheet, "#201412", keys)


def add_ear(
    head: AnimalHead,
    path: Sequence[Point],
    widths: Sequence[float],
    facing: Point,
    colors: tuple[str, str],
    thin: float = 0.2,
) -> None:
    """Add an ear: a hollow leaf shape along a path.

    Args:
        head: Head that receives the ear.
        path: From its root to its tip, head radii.
        widths: Half its width along the path, head radii.
        facing: Direction that its hollow faces.
        colors: Colours of its back and its hollow.
        thin: Ratio of thickness to width.
    """
    spine = np.array(
        [np.interp(np.linspace(0, 1, 11), np.linspace(0, 1, len(path)), axis) for axis in np.array(path).T]
    ).T
    for _ in range(2):
        spine[1:-1] = 0.5 * spine[1:-1] + 0.25 * (spine[:-2] + spine[2:])
    half = np.interp(np.linspace(0, 1, 11), np.linspace(0, 1, len(widths)), widths)
    along = np.gradient(spine, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    front = np.asarray(facing, float) - along * (along @ np.asarray(facing, float))[:, None]
    front /= np.linalg.norm(front, axis=1, keepdims=True)
    side = np.cross(along, front)
    turns = np.linspace(0, 2 * np.pi, 19)[:-1]
    hollow = np.where(np.sin(turns) > 0, -0.35 * np.sin(turns) ** 1, np.sin(turns))  # the front is pressed in
    rings = [
        spine[row] + half[row] * (np.cos(turns)[:, None] * side[row] + thin * 2 * hollow[:, None] * front[row])
        for row in range(11)
    ]
    sheet = skinned([head.to_metres(ring) for ring in rings], bone_weights("head"))
    inner = np.tile((np.sin(turns) > 0.35), 11)
    named = {"main": head.skull.coat, "pale": head.skull.pale, "dark": head.skull.coat * 0.42}
    back, lining = (named[color] if color in named else np.array(hex_color(color)) for color in colors)
    head.add(sheet, np.where(inner[:, None], lining, back))
