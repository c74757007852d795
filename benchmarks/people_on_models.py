"""Rests a person on every seat and bed of a thing, measures how well, and draws both for people to look at."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from PIL import Image, ImageDraw
from tests.blender.motion_stage import Playback, build_bodies, mark_at, perform, world_at

from storyblender.blender.motion.plan import StageFurniture
from storyblender.blender.props.build import PropBuild
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.vocabulary import Posture

SUNK, ABOVE = 0.05, 0.04
"""Metres that flesh may lie below the surface it rests on, and above it, where it is lowest."""
BEHIND = 0.08
"""Metres that the back may be behind the backrest."""
_HEIGHTS = {"seat": (0.3, 0.9), "bed": (0.15, 1.1)}
_TILE = 260


@dataclass(frozen=True)
class Rested:
    """A person on one anchor: metres of the lowest flesh over what is under it, and of the back behind a backrest."""

    kind: str
    height: float
    gap: float
    behind: float
    problems: tuple[str, ...] = ()
    skin: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)), compare=False)

    @property
    def is_good(self) -> bool:
        """Whether the person touches it, does not sink in, and the solver had nothing to say."""
        low, high = _HEIGHTS[self.kind]
        touches = -SUNK <= self.gap <= ABOVE and self.behind <= BEHIND
        return touches and low <= self.height <= high and not self.problems

    def __str__(self) -> str:
        said = f"{self.kind} {self.height:.2f} m {self.gap * 100:+.0f} cm"
        said += f" back {self.behind * 100:.0f} cm" if self.behind > BEHIND else ""
        return said + ("" if self.is_good else f" BAD {' '.join(self.problems)}".rstrip())


def rest_on(build: PropBuild) -> Iterator[Rested]:
    """Let a man sit on every seat of a thing and lie on every bed."""
    places = [anchor for anchor in build.anchors if anchor.kind in ("seat", "bed")]
    if not places:
        return
    points = [vertex.co.copy() for vertex in build.mesh.vertices]
    tree = BVHTree.FromPolygons(points, [tuple(face.vertices) for face in build.mesh.polygons])
    furniture = StageFurniture(world_at(0, 0), build.dimensions, build.anchors, "thing")
    body = build_bodies("man")["man"]
    for anchor in places:
        posture: Posture = "lie" if anchor.kind == "bed" else "sit"
        x, y, z = anchor.location
        yaw = math.degrees(math.atan2(anchor.direction[0], -anchor.direction[1]))
        mark = mark_at("man", x, y, yaw, posture, support_id="thing", anchor_name=anchor.name)
        shot = perform({"man": body}, (mark,), (), 0.5, furniture={"thing": furniture})
        play = Playback(body, shot, "man")
        skin = play.skin(len(shot.frames) - 1)
        part = _resting(play, anchor.kind)
        behind = _behind(tree, skin[_named(play, ("spine", "chest"))], anchor) if anchor.kind == "seat" else 0.0
        problems = tuple(problem.kind for problem in shot.problems)
        yield Rested(anchor.kind, z, _gap(tree, skin[part], anchor), behind, problems, skin)


def _named(play: Playback, names: Sequence[str]) -> np.ndarray:
    """Return which skin points hang on bones of these names."""
    bones = [number for name, number in play.index.items() if name.startswith(tuple(names))]
    return play.body.weights[:, bones].sum(axis=1) > 0.5


def _resting(play: Playback, kind: str) -> np.ndarray:
    return _named(
        play, ("hips", "thigh", "upleg", "leg_upper", "spine") if kind == "bed" else ("hips", "thigh", "upleg")
    )


def _gap(tree: BVHTree, skin: np.ndarray, anchor: Anchor) -> float:
    """Return how far the lowest flesh is above the surface under it, metres; 9 if nothing is under it."""
    start = anchor.location[2] + 0.25
    gaps = []
    for x, y, z in skin[::6]:
        place, *_ = tree.ray_cast(Vector((x, y, start)), Vector((0, 0, -1)), 0.6)
        if place is not None and z < start:
            gaps.append(z - place.z)
    return float(np.percentile(gaps, 3)) if len(gaps) > 5 else 9.0


def _behind(tree: BVHTree, skin: np.ndarray, anchor: Anchor) -> float:
    """Return how far the back is behind what rises behind the seat, metres."""
    ahead = Vector(anchor.direction)
    depths = [0.0]
    for point in skin[::6]:
        reach = (Vector(point) - Vector(anchor.location)).dot(ahead)
        front = Vector(point) - ahead * (reach + 0.15)
        place, *_ = tree.ray_cast(front, -ahead, 1.0)
        if place is not None:
            depths.append((place - Vector(point)).dot(ahead))
    return float(np.percentile(depths, 97))


def stand_beside(build: PropBuild, rests: Sequence[Rested], path: Path) -> Path:
    """Draw a thing with a man beside it and those who rest on it, seen from before it and a little from its left."""
    scene = bpy.context.scene
    thing = bpy.data.objects.new("thing", build.mesh)
    scene.collection.objects.link(thing)
    body = build_bodies("man")["man"]
    width, depth, height = build.dimensions
    people = [body.vertices + np.array((-(width / 2 + 0.5), -depth / 2, 0)), *(rest.skin for rest in rests[:3])]
    for points in people:
        cloud = bpy.data.meshes.new("person")
        cloud.from_pydata(*_cubes(points[::5]))
        block = bpy.data.materials.new("person")
        block.diffuse_color = (0.9, 0.35, 0.1, 1)
        cloud.materials.append(block)
        scene.collection.objects.link(bpy.data.objects.new("person", cloud))
    far = max(width + 1.2, depth, height, 1.9)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale, camera.data.clip_end = "ORTHO", 1.35 * far, 500
    way = Vector((0.55, -1.0, 0.45)).normalized()
    middle = Vector((-0.4, 0, max(height, 1.8) / 2))
    camera.location, camera.rotation_euler = middle + way * (2 * far + 5), way.to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera, scene.render.engine = camera, "BLENDER_WORKBENCH"
    scene.display.shading.color_type, scene.display.shading.light = "TEXTURE", "STUDIO"
    scene.display.shading.show_cavity = True
    scene.render.resolution_x = scene.render.resolution_y = _TILE
    scene.render.filepath = str(path)
    with quiet_output():
        bpy.ops.render.render(write_still=True)
    return path


@contextmanager
def quiet_output() -> Iterator[None]:
    """Let Blender say nothing about the pictures that it saves."""
    kept, nothing = os.dup(1), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 1)
    try:
        yield
    finally:
        os.dup2(kept, 1)
        os.close(kept)
        os.close(nothing)


def _cubes(points: np.ndarray) -> tuple[list[tuple[float, ...]], list[object], list[tuple[int, ...]]]:
    """Return small tetrahedra in place of points, which Workbench does not draw."""
    corners = 0.012 * np.array([(1, 1, 1), (-1, -1, 1), (-1, 1, -1), (1, -1, -1)])
    vertices = (points[:, None] + corners).reshape(-1, 3)
    sides = ((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2))
    faces = [(4 * n + a, 4 * n + b, 4 * n + c) for n in range(len(points)) for a, b, c in sides]
    return [tuple(each) for each in vertices.tolist()], [], faces


def tile_sheet(pictures: Sequence[Path], names: Sequence[str], out: Path) -> None:
    """Write the pictures on one sheet, eight in a row."""
    rows = -(-len(pictures) // 8)
    sheet = Image.new("RGB", (8 * _TILE, rows * (_TILE + 16)), "white")
    draw = ImageDraw.Draw(sheet)
    for number, (path, name) in enumerate(zip(pictures, names, strict=True)):
        x, y = number % 8 * _TILE, number // 8 * (_TILE + 16)
        with Image.open(path) as picture:
            sheet.paste(picture.convert("RGB"), (x, y + 16))
        draw.text((x + 2, y + 2), name, fill="black")
    sheet.save(out)
