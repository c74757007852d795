"""The picture: projection, how large a head is in each shot size, where it goes, and cameras that start there.

Screen coordinates run 0..1 from the top left, x right and y down. All cameras here are analytic: the servo of the
Camera Operator only has to mend what other things in the room spoil.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from storyblender.geometry.orbit import Orbit, camera_around, camera_looking_at, pan
from storyblender.memory.shot_sizes import SIZES, WHOLE, ShotSize

Floats = NDArray[np.float64]


ELEVATION: dict[str, float] = {
    "eye-level": 2.0,
    "high angle": 26.0,
    "low angle": -16.0,
    "bird's-eye": 65.0,
    "worm's-eye": -32.0,
    "dutch": 2.0,
}
"""Degrees of the camera above the subject's eyes, by camera angle; see ``elevation_of``."""
ELEVATION_BAND: dict[str, tuple[float, float]] = {
    "eye-level": (-9.0, 14.0),
    "high angle": (16.0, 55.0),
    "low angle": (-38.0, -6.0),
    "bird's-eye": (48.0, 88.0),
    "worm's-eye": (-60.0, -18.0),
    "dutch": (-9.0, 14.0),
}
FACE_ANGLE: dict[str, float] = {"single": 70.0, "reaction": 70.0, "ots": 75.0, "two_shot": 112.0, "group": 125.0}
"""Degrees a focus face may be turned from the camera, by kind of shot."""
DUTCH_ROLL = 12.0
"""Degrees."""
THIRD_FROM_CENTRE = 1 / 6
"""Distance of a third line from the middle of the picture, as a share of the picture."""
_MIN_FACE_DEPTH = 0.8
"""Least metres along the view from the camera to a face of a group."""
_MIN_CROWN_Y = 0.12
"""Least screen y of the crowns of a group: leaves room for hats."""
_MAX_BODY_DROP = 0.1
"""Largest screen shift down of a whole body that is lower than a standing one."""
_BODY_SHARE = 0.83
"""Largest share of the picture's height for whole bodies in a group."""
_HEADS, _CROWN_TO_CHIN = 0.62, 0.82
"""Largest share of the picture height between the faces of a group, and from its top crown to its lowest chin."""
_WHOLE_BODY_LOW_ANGLE = 0.5
"""Factor on the elevation of a low angle for whole bodies: from nearer the floor legs grow and heads shrink."""
_CROWN_ABOVE_FACE = 0.55
"""Crown above the face's centre, in head heights."""


@dataclass(frozen=True)
class Figure:
    """A person as the camera sees them at one frame.

    Attributes:
        node_id: Id of the person.
        face: Centre of the face between crown and chin, world metres.
        forward: World unit vector the face looks along.
        head: Crown to chin, metres.
        base: Floor point below the face, world metres.
        hands: Middles of the left and the right hand, world metres; empty if there are none.
    """

    node_id: str
    face: tuple[float, float, float]
    forward: tuple[float, float, float]
    head: float
    base: tuple[float, float, float]
    hands: tuple[tuple[float, float, float], ...] = ()

    @property
    def yaw(self) -> float:
        """Degrees the face is turned to, counter-clockwise from above; 0 is -Y, 90 is +X."""
        return math.degrees(math.atan2(self.forward[0], -self.forward[1]))

    @property
    def crown(self) -> tuple[float, float, float]:
        """Top of the head, world metres."""
        x, y, z = self.face
        return x, y, z + _CROWN_ABOVE_FACE * self.head

    def turned_from(self, eye: ArrayLike) -> float:
        """Return the degrees between the look of the face and the direction to a world point; 0 is full face."""
        way = np.asarray(eye, float) - np.asarray(self.face)
        cosine = float(np.dot(self.forward, way) / max(float(np.linalg.norm(way)), 1e-9))
        return math.degrees(math.acos(min(1.0, max(-1.0, cosine))))


def elevation_of(angle: str, size: ShotSize) -> float:
    """Return the degrees that the camera is above the subject's eyes, for an angle of ``ELEVATION`` and a shot size."""
    return ELEVATION[angle] * (_WHOLE_BODY_LOW_ANGLE if angle == "low angle" and size in WHOLE else 1.0)


def project(camera: Orbit, points: ArrayLike) -> tuple[Floats, Floats]:
    """Return screen positions (n, 2) and depths (n,; metres, not positive behind the camera) of (n, 3) world points."""
    world = np.atleast_2d(np.asarray(points, float))
    axes = camera.axes
    seen = (world - camera.pivot) @ axes - (0.0, 0.0, camera.distance)
    depth = -seen[:, 2]
    safe = np.maximum(depth, 1e-3)
    x = 0.5 + seen[:, 0] / safe / (2 * camera.tangent * camera.aspect)
    y = 0.5 - seen[:, 1] / safe / (2 * camera.tangent)
    return np.stack([x, y], 1), depth


def head_share(camera: Orbit, figure: Figure) -> float:
    """Return the height of a figure's head (crown to chin) as a share of the picture's height."""
    away = max(float(project(camera, [figure.face])[1][0]), 0.1)
    return max(figure.head / away / (2 * camera.tangent), 1e-3)


def distance_for(height: float, share: float, camera_tangent: float) -> float:
    """Return the metres at which ``height`` metres fill ``share`` of the picture's height; see ``Orbit.tangent``."""
    return height / share / (2 * camera_tangent)


def place_on_screen(camera: Orbit, point: ArrayLike, x: float, y: float) -> Orbit:
    """Return the camera panned until a world point (metres) is seen at screen position (x, y)."""
    for _ in range(2):
        screen, depth = project(camera, point)
        ratio = float(depth[0]) / camera.distance
        dx, dy = screen[0, 0] - x, screen[0, 1] - y
        camera = pan(camera, float(dx) * camera.aspect * ratio, -float(dy) * ratio)
    return camera


def lead_room_x(camera: Orbit, figure: Figure) -> float:
    """Return the screen x for a lone figure: looking across the picture, it gets room before its face.

    A large head takes that room itself: behind its face are hair and neck, and they stay in the picture.
    """
    across = float(np.dot(figure.forward, camera.axes[:, 0]))
    room = THIRD_FROM_CENTRE * 0.85 * (1 - 1.5 * max(0.0, head_share(camera, figure) - 0.25))
    return 0.5 - max(room, 0.0) * max(-1.0, min(1.0, 1.4 * across)) if abs(across) > 0.2 else 0.5


def face_screen_y(size: ShotSize) -> float:
    """Return the screen y of the face's centre for a shot size."""
    scale = SIZES[size]
    return scale.crown + _CROWN_ABOVE_FACE * scale.head


def crown_screen_y(head: float) -> float:
    """Return the screen y of the crown for a head of that share of the picture's height."""
    heads, crowns = zip(*((scale.head, scale.crown) for scale in SIZES.values()), strict=True)
    return float(np.interp(head, heads, crowns))


@dataclass(frozen=True)
class Film:
    """Sensor width (mm) and aspect (width / height): the same for every shot of a project."""

    sensor_width: float = 36.0
    aspect: float = 16 / 9

    def tangent(self, lens: float) -> float:
        """Return half the picture's height at one metre through a lens of ``lens`` mm."""
        return self.sensor_width / self.aspect / (2 * lens)

    def look(self, pivot: ArrayLike, azimuth: float, elevation: float, distance: float, lens: float) -> Orbit:
        """Return a camera around a world pivot: degrees (azimuth 0 at -Y, 90 at +X), metres, lens in mm."""
        return camera_around(
            pivot, azimuth, elevation, distance, lens, sensor_width=self.sensor_width, aspect=self.aspect
        )  # fmt: skip


def frame_single(film: Film, figure: Figure, size: ShotSize, azimuth: float, elevation: float, lens: float) -> Orbit:
    """Return the camera for one person, face at its height, with lead room.

    Azimuth (0 at -Y) and elevation are degrees around the face, the lens is in mm. In an FS a person who sits low or is
    bent is placed lower in the picture.
    """
    distance = distance_for(figure.head, SIZES[size].head, film.tangent(lens))
    camera = film.look(figure.face, azimuth, elevation, distance, lens)
    camera = place_on_screen(camera, figure.face, lead_room_x(camera, figure), face_screen_y(size))
    if size != "FS":
        return camera
    screen, _ = project(camera, [figure.crown, figure.base])
    return pan(camera, 0.0, min(max(0.5 - float(screen[:, 1].mean()), 0.0), _MAX_BODY_DROP))


def frame_group(
    film: Film,
    figures: Sequence[Figure],
    size: ShotSize,
    azimuth: float,
    elevation: float,
    lens: float,
    span: float = 0.62,
) -> Orbit:
    """Return the camera that holds all heads of a group within ``span`` of the picture's width: degrees, lens in mm.

    Azimuth is 0 at -Y. No head is larger than the size asks for; a person lying at another's feet makes both smaller.
    """
    faces = np.array([figure.face for figure in figures])
    middle = (faces.min(0) + faces.max(0)) / 2
    head = max(figure.head for figure in figures)
    tangent = film.tangent(lens)
    camera = film.look(middle, azimuth, elevation, distance_for(head, SIZES[size].head, tangent), lens)
    for _ in range(3):
        _, depth = project(camera, faces)
        camera = replace(camera, distance=camera.distance + max(0.0, _MIN_FACE_DEPTH - float(depth.min())))
        screen, depth = project(camera, faces)
        aside = np.abs(screen[:, 0] - 0.5) * 2 * depth
        needed = aside / span - depth + camera.distance
        camera = replace(camera, distance=max(camera.distance, float(needed.max())))
    chins = [(*each.face[:2], each.face[2] - (1 - _CROWN_ABOVE_FACE) * each.head) for each in figures]
    ends = project(camera, [*(each.crown for each in figures), *chins])[0][:, 1]
    taken = max(float(np.ptp(project(camera, faces)[0][:, 1])) / _HEADS, float(np.ptp(ends)) / _CROWN_TO_CHIN)
    camera = replace(camera, distance=camera.distance * max(taken, 1.0))
    if size in WHOLE:
        tops, bottoms = (project(camera, [getattr(each, end) for each in figures])[0] for end in ("crown", "base"))
        tall = float(bottoms[:, 1].max() - tops[:, 1].min())
        camera = replace(camera, distance=camera.distance * max(tall / _BODY_SHARE, 1.0))
    tallest = max(figures, key=lambda figure: figure.face[2])
    share = tallest.head / camera.frame_height
    camera = place_on_screen(
        camera, tallest.face, 0.5, max(crown_screen_y(share), _MIN_CROWN_Y) + (_CROWN_ABOVE_FACE + 0.1) * share
    )
    screen, _ = project(camera, faces)
    return pan(camera, float(screen[:, 0].min() + screen[:, 0].max() - 1) / 2 * film.aspect, 0.0)


def frame_group_from(
    film: Film,
    figures: Sequence[Figure],
    size: ShotSize,
    place: ArrayLike,
    lens: float,
    widest: float,
    span: float = 0.72,
) -> Orbit:
    """Return the camera at a given place, turned and zoomed to hold a group; its lens is never wider than ``widest``.

    Args:
        film: Sensor and aspect.
        figures: People whose heads are held.
        size: Shot size of the nearest head.
        place: Optical centre, world metres.
        lens: Longest focal length, mm.
        widest: Shortest focal length, mm.
        span: Share of the picture's width for the heads.
    """
    eye, faces = np.asarray(place, float), np.array([figure.face for figure in figures])
    ways = faces - eye
    apart = np.hypot(ways[:, 0], ways[:, 1])
    middle = ways[:, :2] / np.maximum(apart, 1e-6)[:, None]
    ahead = float(np.arctan2(*middle.sum(0)))
    aside = np.array([math.remainder(float(np.arctan2(x, y)) - ahead, math.tau) for x, y in ways[:, :2]])
    ahead += (aside.min() + aside.max()) / 2
    half = min(max((aside.max() - aside.min()) / 2, 1e-3), 1.5)
    holds = film.sensor_width * span / (2 * math.tan(half))
    heads = np.array([figure.head for figure in figures]) / np.maximum(apart * np.cos(aside - aside.mean()), 0.3)
    sized = SIZES[size].band[1] / float(heads.max()) * film.sensor_width / film.aspect
    crowns = np.arctan2([figure.crown[2] - eye[2] for figure in figures], apart)
    if size in WHOLE:
        feet = np.arctan2([figure.base[2] - eye[2] for figure in figures], apart)
        tall = 2 * math.tan(float(crowns.max() - feet.min()) / 2)
        sized = min(sized, _BODY_SHARE / tall * film.sensor_width / film.aspect)
    low = np.arctan2([figure.face[2] - eye[2] for figure in figures], apart).min()
    sized = min(
        sized, _HEADS / (2 * math.tan(max(float(crowns.max() - low), 1e-3) / 2)) * film.sensor_width / film.aspect
    )
    lens = min(lens, max(min(holds, sized), widest))
    high = int(crowns.argmax())
    crown = max(crown_screen_y(float(heads[high]) / (2 * film.tangent(lens))), _MIN_CROWN_Y)
    pitch = float(crowns[high]) - math.atan((1 - 2 * crown) * film.tangent(lens))
    way = np.array([math.sin(ahead), math.cos(ahead), math.tan(pitch)])
    distance = max(float((ways[:, :2] @ way[:2]).mean()), 0.6)
    return camera_looking_at(eye, eye + way * distance, lens, sensor_width=film.sensor_width, aspect=film.aspect)


def frame_point_of_view(film: Film, eyes: Figure, target: ArrayLike, lens: float) -> Orbit:
    """Return the camera at a person's eyes that looks at ``target`` (world metres); lens in mm."""
    position = np.asarray(eyes.face) + 0.12 * np.asarray(eyes.forward)
    return camera_looking_at(position, target, lens, sensor_width=film.sensor_width, aspect=film.aspect)


def frame_insert(
    film: Film, points: ArrayLike, azimuth: float, elevation: float, lens: float, fill: float = 0.5, reach: float = 0.45
) -> Orbit:
    """Return the camera for a thing, given its corners: it fills ``fill`` of the height or of the width.

    Args:
        film: Sensor and aspect.
        points: (n, 3) corners of the thing.
        azimuth: Degrees, 0 at -Y.
        elevation: Degrees.
        lens: mm.
        fill: Share of the picture.
        reach: Metres from which a hand-held thing is seen at the nearest.
    """
    corners = np.asarray(points, float)
    middle = (corners.min(0) + corners.max(0)) / 2
    camera = film.look(middle, azimuth, elevation, 10.0, lens)
    screen, _ = project(camera, corners)
    extent = (screen.max(0) - screen.min(0)) / fill
    return replace(camera, distance=max(10.0 * float(extent.max()), reach))


def frame_master(
    film: Film, points: ArrayLike, azimuth: float, elevation: float, lens: float, fill: float = 0.86
) -> Orbit:
    """Return the camera that holds (n, 3) world points within ``fill`` of the picture: degrees, metres, lens in mm."""
    corners = np.asarray(points, float)
    middle = (corners.min(0) + corners.max(0)) / 2
    camera = film.look(middle, azimuth, elevation, 30.0, lens)
    for _ in range(8):
        screen, depth = project(camera, corners)
        if (depth < 0.5).any():
            camera = replace(camera, distance=camera.distance * 1.5)
            continue
        off = np.abs(screen - 0.5) * 2 / fill
        camera = replace(camera, distance=max(float((off.max(1) * depth - depth).max()) + camera.distance, 1.0))
    screen, _ = project(camera, corners)
    box = (screen.min(0) + screen.max(0)) / 2
    return place_on_screen(camera, middle, 0.5, 0.5 + float(project(camera, middle)[0][0, 1] - box[1]))
