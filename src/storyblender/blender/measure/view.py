"""The viewfinder: draws an ID mask from a camera pose and measures what it shows (notes: engine, section 3).

A look costs one flat Workbench picture, 320 pixels wide. Colours are node numbers; the depth pass gives the rest. A
scene with the custom property ``open_sky`` shows sky above the horizon where nothing is drawn.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass

import bpy
import numpy as np
from mathutils import Matrix, Vector
from numpy.typing import NDArray

from storyblender.blender.hiding import out_of_picture
from storyblender.blender.measure.figures import figures
from storyblender.blender.render.passes import flat_workbench
from storyblender.blender.render.session import RenderSession, changed, temporary_camera
from storyblender.blender.sections import is_hidden_by
from storyblender.blender.still import held_still
from storyblender.geometry.framing import Figure, project
from storyblender.geometry.orbit import Orbit
from storyblender.geometry.solids import Floats
from storyblender.look.gbuffer import View
from storyblender.look.surface import Surface
from storyblender.memory.measure import CameraView, SubjectView
from storyblender.memory.shot_context import CameraPose

WIDTH = 320
"""Pixels across the viewfinder's ID mask."""
_SAMPLES = 400
"""Sample vertices of one object."""
_NEAR_PROP, _NEAR_WALL = 0.25, 0.12
"""Least metres between the camera and props, and walls."""
_FLOOR = 0.08
"""Least height of a camera above the floor, metres."""
_CROWN = 0.58
"""Head heights from the face's centre to the crown."""

Ints = NDArray[np.int32]


@dataclass(frozen=True)
class ViewfinderPose:
    """One camera pose to measure.

    Attributes:
        pose: Camera.
        frame: Timeline frame; None for the current one.
        sensor_width: Millimetres.
        focus_ids: node_ids of the shot's subjects.
        hidden: node_ids and sections of things left out of the picture.
        other_ids: node_ids that are also measured but are not subjects of the shot.
    """

    pose: CameraPose
    frame: int | None = None
    sensor_width: float = 36.0
    focus_ids: tuple[str, ...] = ()
    hidden: tuple[str, ...] = ()
    other_ids: tuple[str, ...] = ()


@contextmanager
def viewfinder(
    scene: bpy.types.Scene, frame: int | None = None, width: int = WIDTH, height: int = WIDTH * 9 // 16
) -> Iterator[OpenViewfinder]:
    """Yield a viewfinder that measures camera poses at one frame; opening it costs more than two looks.

    Args:
        scene: It stays at the frame.
        frame: Timeline frame; None for the current one. The frames of poses are ignored.
        width: Pixels.
        height: Pixels.
    """
    with (
        held_still(scene, frame) as still,
        temporary_camera(still, np.eye(4), sensor_fit="HORIZONTAL", clip_start=0.02, clip_end=2000.0) as camera,
        flat_workbench(still),
        changed(still.display.shading, {"light": "FLAT", "color_type": "OBJECT"}),
    ):
        people = figures(scene)
        with RenderSession(still, camera, smoke=True) as session:
            finder = OpenViewfinder(session, people, width, height)
            with _numbered(finder.objects, finder.numbers):
                yield finder


@contextmanager
def _numbered(objects: Sequence[bpy.types.Object], numbers: dict[str, int]) -> Iterator[None]:
    """Write every object's node number into its viewport colour."""
    with ExitStack() as stack:
        for obj in objects:
            number = numbers[_node_id(obj)]
            card = float(obj.get("surface") == int(Surface.CARD))
            stack.enter_context(changed(obj, {"color": (number % 256 / 255, number // 256 / 255, card, 1.0)}))
        yield


def _node_id(obj: bpy.types.Object) -> str:
    """Return the node id of an object."""
    return str(obj.get("node_id", obj.name))


class OpenViewfinder:
    """The visible objects of one frame, their sample points and faces, shared by all looks.

    Args:
        session: Of the frame, with the looks' camera.
        people: Everybody with a face.
        width: Of the ID mask, pixels.
        height: Of the ID mask, pixels.
    """

    def __init__(self, session: RenderSession, people: Sequence[Figure], width: int, height: int) -> None:
        self.session, self._width, self._height = session, width, height
        self.objects = session.visible_objects()
        nodes = dict.fromkeys(_node_id(obj) for obj in self.objects)
        self.numbers = {node: number for number, node in enumerate(nodes, 1)}
        self.depsgraph = session.scene.view_layers[0].depsgraph
        self.faces = {figure.node_id: figure for figure in people if figure.node_id in nodes}
        self._points: dict[str, Floats] = {}
        self._corners = np.array([_corners(obj) for obj in self.objects]).reshape(-1, 8, 3)

    def points(self, node_id: str) -> Floats:
        """Return sample points of a node (N, 3), world metres; cached."""
        if node_id not in self._points:
            clouds = [self._vertices(obj) for obj in self.objects if _node_id(obj) == node_id]
            self._points[node_id] = np.concatenate(clouds) if clouds else np.zeros((0, 3))
        return self._points[node_id]

    def _vertices(self, obj: bpy.types.Object) -> Floats:
        """Return sample vertices of an object (N, 3), world metres."""
        evaluated = obj.evaluated_get(self.depsgraph)
        mesh = evaluated.to_mesh()
        local = np.empty(len(mesh.vertices) * 3, np.float32)
        mesh.vertices.foreach_get("co", local)
        evaluated.to_mesh_clear()
        points = local.reshape(-1, 3).astype(np.float64)
        points = points[:: max(1, len(points) // _SAMPLES)]
        world = np.array(evaluated.matrix_world)
        return points @ world[:3, :3].T + world[:3, 3]

    def __call__(self, view: ViewfinderPose) -> CameraView:
        """Return what is measured at one camera pose."""
        with self.aimed(view, self._width, self._height) as orbit:
            ids, sky, depth = self.mask(orbit, self._width, self._height)
        wanted = dict.fromkeys((*self.faces, *view.focus_ids, *view.other_ids))
        shown = [node for node in wanted if node in self.numbers and node not in view.hidden]
        subjects = tuple(self._subject(node, orbit, ids) for node in shown)
        return CameraView(
            subjects=subjects,
            void=float(((ids == 0) & ~sky).mean()),
            sky=float(sky.mean()),
            foreground=self._foreground(view, orbit, ids, depth),
            inside=self._inside(orbit.position, view.hidden),
            below_floor=float(orbit.position[2]) < _FLOOR,
        )

    @contextmanager
    def aimed(self, view: ViewfinderPose, width: int, height: int, margin: float = 1.0) -> Iterator[Orbit]:
        """Aim the camera at a pose, with what it cannot see left out of pictures, and yield it.

        Args:
            view: The pose.
            width: Of the pictures to be drawn, pixels.
            height: Of the pictures to be drawn, pixels.
            margin: How many times as wide as the frame they are.
        """
        pose, camera = view.pose, self.session.camera
        sensor = view.sensor_width * margin
        orbit = Orbit(pose.pivot, pose.rotation, pose.distance, pose.lens, sensor, width / height)
        camera.data.lens, camera.data.sensor_width = pose.lens, sensor
        camera.matrix_world = Matrix(orbit.world.tolist())
        with out_of_picture(self._unseen(orbit, view.hidden)):
            yield orbit

    def mask(self, orbit: Orbit, width: int, height: int) -> tuple[Ints, NDArray[np.bool_], NDArray[np.float32]]:
        """Return node numbers, which pixels are sky, and depth in metres, (h, w) each; the camera is ``aimed``."""
        channels = self.session.exr(width, height, depth=True)
        red, green, blue = (np.rint(channels[f"Combined.{name}"] * 255).astype(np.int32) for name in "RGB")
        ids = red + 256 * green
        return ids, self._sky(ids, blue, orbit), channels["Depth.Z"]

    def _unseen(self, orbit: Orbit, hidden: Sequence[str]) -> list[bpy.types.Object]:
        """Return the objects that need not be drawn: hidden, or outside the picture by their boxes."""
        frustum = View(orbit.position, orbit.axes, 1, 1, orbit.tangent * orbit.aspect, orbit.tangent)
        gone = frustum.misses(self._corners)
        return [obj for obj, out in zip(self.objects, gone, strict=True) if out or is_hidden_by(obj, hidden)]

    def _sky(self, ids: Ints, blue: Ints, orbit: Orbit) -> NDArray[np.bool_]:
        """Return the pixels that show sky: cards, and empty pixels above the horizon of an open scene."""
        sky = (blue > 0) & (ids > 0)
        if self.session.scene.get("open_sky"):
            height, width = ids.shape
            y = (0.5 - (np.arange(height) + 0.5) / height)[:, None] * 2 * orbit.tangent
            x = ((np.arange(width) + 0.5) / width - 0.5)[None, :] * 2 * orbit.tangent * orbit.aspect
            right, up, back = orbit.axes[2]
            sky |= (ids == 0) & (x * right + y * up - back > -0.02)
        return sky

    def _foreground(self, view: ViewfinderPose, orbit: Orbit, ids: Ints, depth: NDArray[np.float32]) -> float:
        """Return the share of pixels nearer than half the subjects' distance."""
        clouds = [cloud for node in view.focus_ids if len(cloud := self.points(node))]
        away = orbit.distance
        if clouds:
            away = min(float(np.median(project(orbit, cloud)[1])) for cloud in clouds)
        own = [self.numbers[node] for node in view.focus_ids if node in self.numbers]
        return float(((ids > 0) & (depth < away / 2) & ~np.isin(ids, own)).mean())

    def _subject(self, node_id: str, orbit: Orbit, ids: Ints) -> SubjectView:
        """Return how one node is seen."""
        mine = ids == self.numbers[node_id]
        rows, columns = np.nonzero(mine)
        height, width = ids.shape
        box = None
        if len(rows):
            box = (
                float(columns.min() / width),
                float(rows.min() / height),
                float((columns.max() + 1) / width),
                float((rows.max() + 1) / height),
            )
        screen, depth = project(orbit, self.points(node_id))
        inside = ((screen > 0) & (screen < 1)).all(1) & (depth > 0)
        seen = inside & _hit(screen, mine)
        count = max(len(screen), 1)
        subject = SubjectView(
            node_id=node_id,
            visible_fraction=float(seen.sum() / count),
            in_frame_fraction=float(inside.sum() / count),
            box=box,
            pixels=float(mine.mean()),
        )
        return _with_face(subject, self.faces[node_id], orbit, mine) if node_id in self.faces else subject

    def _inside(self, position: Floats, hidden: Sequence[str]) -> tuple[str, ...]:
        """Return the node ids of solids that the camera is in, or too close to."""
        point = Vector(position.tolist())
        found: dict[str, None] = {}
        for obj in self.objects:
            if obj.get("surface") == int(Surface.CARD) or obj.type != "MESH" or is_hidden_by(obj, hidden):
                continue
            evaluated = obj.evaluated_get(self.depsgraph)
            local = evaluated.matrix_world.inverted_safe() @ point
            margin = _NEAR_WALL if obj.get("kind") == "set" else _NEAR_PROP
            low, high = evaluated.bound_box[0], evaluated.bound_box[6]
            if any(not low[k] - margin < local[k] < high[k] + margin for k in range(3)):
                continue
            hit, nearest, normal, _ = evaluated.closest_point_on_mesh(local, distance=0.8)
            away = (local - nearest).length if hit else math.inf
            if away < margin or (hit and (local - nearest).dot(normal) < 0):
                found[_node_id(obj)] = None
        return tuple(found)


def _corners(obj: bpy.types.Object) -> list[Vector]:
    """Return the world corners of an object's bounding box."""
    return [obj.matrix_world @ Vector(corner) for corner in obj.bound_box]


def _hit(screen: Floats, mine: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return which screen points (N, 2) fall on a node's pixels or beside them."""
    height, width = mine.shape
    wide = np.pad(mine, 1)
    wide = wide[1:-1, 1:-1] | wide[:-2, 1:-1] | wide[2:, 1:-1] | wide[1:-1, :-2] | wide[1:-1, 2:]
    columns = np.clip((screen[:, 0] * width).astype(int), 0, width - 1)
    rows = np.clip((screen[:, 1] * height).astype(int), 0, height - 1)
    return wide[rows, columns]


def _with_face(subject: SubjectView, figure: Figure, orbit: Orbit, mine: NDArray[np.bool_]) -> SubjectView:
    """Return a subject view with its face: position, size, angle to the camera and visible share."""
    centre, up = np.asarray(figure.face), orbit.axes[:, 1]
    crown, chin = centre + up * _CROWN * figure.head, centre - up * 0.5 * figure.head
    screen, depth = project(orbit, [centre, crown, chin])
    to_camera = orbit.position - centre
    turned = float(np.dot(figure.forward, to_camera) / max(float(np.linalg.norm(to_camera)), 1e-9))
    angle = math.degrees(math.acos(min(1.0, max(-1.0, turned))))
    if depth.min() <= 0.05:
        return subject.model_copy(update={"face_angle": angle})
    oval = [
        centre + figure.head * ring * (0.36 * math.cos(a) * orbit.axes[:, 0] + 0.46 * math.sin(a) * up)
        for ring in (0.0, 0.45, 0.9)
        for a in np.linspace(0, 2 * math.pi, 12, endpoint=False)
    ]
    spots, _ = project(orbit, oval)
    shown = ((spots > 0) & (spots < 1)).all(1) & _hit(spots, mine)
    return subject.model_copy(
        update={
            "face": (float(screen[0, 0]), float(screen[0, 1])),
            "face_visible": float(shown.mean()),
            "head_height": float(screen[2, 1] - screen[1, 1]),
            "head_top": float(screen[1, 1]),
            "face_angle": angle,
        }
    )
