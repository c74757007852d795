"""Ten motions on humanoid models of many kinds: how far skin stretches, what goes through what, what is not touched.

``python -m benchmarks bound_cast [--sheets FOLDER] [NAME ...]`` prints a table beside the built-in body, and draws a
contact sheet for each figure.
"""

from __future__ import annotations

import argparse
import math
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import bpy
import numpy as np
from benchmarks.humanoids import HUMANOIDS, write_humanoid
from mathutils import Matrix
from numpy.typing import NDArray
from PIL import Image

from storyblender.blender.cast.character import character_from_file
from storyblender.blender.motion.bake import bake, remove
from storyblender.blender.motion.plan import StageFurniture, StagePerson, StagePlan, StageProp
from storyblender.blender.motion.solve import solve_shot
from storyblender.blender.people.person import PersonBuild, build_person
from storyblender.blender.props.portrait import render_portrait
from storyblender.memory.asset_sheet import Anchor, AssetDimension, CharacterLook, ModelPose
from storyblender.memory.shot_context import Blocking, Cue, Mark
from storyblender.memory.vocabulary import Posture

FPS, SHOT, WHO, SIZE = 24, "SC010_SH010", "x", 240
SEAT = 0.45
"""Height of the seat, metres."""
Points = NDArray[np.float64]


def _mark(x: float, y: float, yaw: float = 0.0, posture: Posture = "stand", **fields: object) -> Mark:
    return Mark.model_validate({"asset_id": WHO, "location": (x, y, 0.0), "yaw": yaw, "posture": posture, **fields})


def _cue(clip: str, start: int = 2, **fields: object) -> Cue:
    return Cue.model_validate({"asset_id": WHO, "clip": clip, "start": start, **fields})


@dataclass(frozen=True)
class Act:
    """What is performed, and the frame that is measured."""

    name: str
    start: Mark
    cues: tuple[Cue, ...] = ()
    end: Mark | None = None
    frame: int = 30
    furniture: dict[str, StageFurniture] = field(default_factory=dict)
    props: dict[str, StageProp] = field(default_factory=dict)


_CHAIR = StageFurniture(
    np.eye(4), (0.46, 0.48, 0.9), (Anchor(kind="seat", name="seat", location=(0, -0.24, SEAT), size=(0.46, 0.42)),)
)
_BED_TOP = Anchor(kind="bed", name="bed", location=(0, 0, 0.5), size=(0.9, 1.9))
_BED = StageFurniture(np.eye(4), (1.0, 2.0, 0.5), (_BED_TOP,))
_CUP = StageProp(np.array(Matrix.Translation((0, 0, -5))), (0.08, 0.08, 0.1))
_AHEAD = _mark(1.5, 0, 90)
ACTS = (
    Act("walk", _mark(-1, 0, 90), (_cue("walk", mark=_AHEAD),), _AHEAD),
    Act("run", _mark(-2, 0, 90), (_cue("run", mark=_mark(3, 0, 90)),), _mark(3, 0, 90), 26),
    Act("sit", _mark(0, -0.24, 0, "sit", support_id="chair", anchor_name="seat"), furniture={"chair": _CHAIR}),
    Act("hold", _mark(0, 0, held=(("R", "cup"),)), props={"cup": _CUP}),
    Act("wave", _mark(0, 0), (_cue("wave"),)),
    Act("point", _mark(0, 0), (_cue("point"),)),
    Act("talk", _mark(0, 0), (_cue("talk", 0, duration=72),), frame=40),
    Act("kneel", _mark(0, 0, 0, "kneel")),
    Act("lie", _mark(0, 0, 0, "lie", support_id="bed", anchor_name="bed"), furniture={"bed": _BED}),
    Act("crawl", _mark(-1, 0, 90), (_cue("crawl", mark=_AHEAD),), _AHEAD, 70),
)
"""The ten motions."""


@dataclass(frozen=True)
class Row:
    """One motion of one figure; lengths in millimetres.

    Attributes:
        stretch: 99th percentile of how many times as long edges are as at rest.
        torn: 99.9th percentile.
        floor: How far the lowest point is above the floor; negative is in it.
        seat: How far the seat is from the body that sits on it; negative is in it.
        inside: How deep the hands are in the body, 95th percentile.
        grip: How far the hand's skin is from the cup; negative is in it.
    """

    act: str
    stretch: float
    torn: float
    floor: float
    seat: float
    inside: float
    grip: float


class Figure:
    """A figure in the open file, as it is posed."""

    def __init__(self, person: PersonBuild) -> None:
        self.person = person
        self.rest = [_points(mesh.data) for mesh in person.meshes]
        edges = [np.array([tuple(edge.vertices) for edge in mesh.data.edges]) for mesh in person.meshes]
        starts = np.cumsum([0, *(len(points) for points in self.rest[:-1])])
        self.edges = np.concatenate([each + start for each, start in zip(edges, starts, strict=True)])
        self.lengths = _lengths(np.concatenate(self.rest), self.edges)

    def perform(self, act: Act) -> Row:
        """Pose the figure and measure it; it stays posed until ``remove(SHOT)``."""
        plan = StagePlan(
            people={WHO: StagePerson(self.person.body, Blocking(start=act.start, end=act.end or act.start))},
            frames=max(72, act.frame + 12), cues=act.cues, props=act.props, furniture=act.furniture, seed=3,
        )  # fmt: skip
        shot = solve_shot(plan, FPS)
        bake(shot, {WHO: self.person.armature}, {}, SHOT, 1)
        bpy.context.scene.frame_set(1 + act.frame)
        points = self.posed()
        long = self.lengths > 0.002
        ratios = _lengths(points, self.edges)[long] / self.lengths[long]
        skin, hands = self._skin()
        cup = shot.props["cup"][act.frame][:3, 3] + (0, 0, 0.05) if act.props else None
        return Row(
            act.name,
            float(np.percentile(ratios, 99)),
            float(np.percentile(ratios, 99.9)),
            1000 * float(points[:, 2].min()),
            1000 * (_lowest_on_seat(skin) - SEAT) if act.name == "sit" else 0.0,
            1000 * self._inside(skin, hands),
            1000 * (float(np.linalg.norm(skin[hands] - cup, axis=1).min()) - 0.04) if cup is not None else 0.0,
        )

    def posed(self) -> Points:
        """Return all vertices where they are drawn, world."""
        graph = bpy.context.evaluated_depsgraph_get()
        drawn = [mesh.evaluated_get(graph) for mesh in self.person.meshes]
        return np.concatenate([_points(each.data) @ np.array(each.matrix_world)[:3, :3].T
                               + np.array(each.matrix_world)[:3, 3] for each in drawn])  # fmt: skip

    def draw(self, path: Path) -> None:
        """Draw the figure as it is posed."""
        graph, middle = bpy.context.evaluated_depsgraph_get(), self.posed().mean(0)
        parts = []
        for mesh in self.person.meshes:
            drawn = mesh.evaluated_get(graph)
            frozen = bpy.data.meshes.new_from_object(drawn, depsgraph=graph)
            frozen.transform(Matrix.Translation(-middle) @ drawn.matrix_world)
            parts.append(bpy.data.objects.new(mesh.name, frozen))
        render_portrait(parts, path, (SIZE, SIZE))

    def _skin(self) -> tuple[Points, NDArray[np.bool_]]:
        """Return the body's skin as it is posed, world, and which of it is hands."""
        body, rig = self.person.body, self.person.armature
        poses = np.array([rig.pose.bones[name].matrix for name in body.bone_names])
        moves = np.array(rig.matrix_world) @ poses @ np.linalg.inv(body.rest)
        blended = np.einsum("vb,bij->vij", body.weights, moves)
        skin = np.einsum("vij,vj->vi", blended, np.c_[body.vertices, np.ones(len(body.vertices))])[:, :3]
        ends = [name.startswith(("hand", "thumb", "index", "fingers")) for name in body.bone_names]
        return skin, body.weights[:, np.array(ends)].sum(1) > 0.9

    def _inside(self, skin: Points, hands: NDArray[np.bool_]) -> float:
        """Return how deep hands are in what is not an arm, by the bones' capsules, metres."""
        if not hands.any():
            return 0.0
        body, rig = self.person.body, self.person.armature
        bones = [name for name in body.bone_names if name.startswith(("thigh", "shin", "hips", "chest"))]
        depth = np.zeros(int(hands.sum()))
        for name in bones:
            own = body.weights[:, body.bone_names.index(name)] > 0.8
            if own.sum() < 4:
                continue
            bone = rig.pose.bones[name]
            start, end = (np.array(rig.matrix_world @ point) for point in (bone.head, bone.tail))
            radius = float(np.percentile(_from_axis(skin[own], start, end)[0], 40))
            away, along = _from_axis(skin[hands], start, end)
            depth = np.maximum(depth, np.where((along > 0.1) & (along < 0.9), radius - away, 0))
        return float(np.percentile(depth, 95))


def _from_axis(points: Points, start: Points, end: Points) -> tuple[Points, Points]:
    """Return the distance of points from a line, and where along it they are, 0 to 1."""
    line = end - start
    along = (points - start) @ line / (line @ line)
    return np.linalg.norm(points - start - along[:, None] * line, axis=1), along


def _lowest_on_seat(skin: Points) -> float:
    over = (np.abs(skin[:, 0]) < 0.23) & (skin[:, 1] > -0.2) & (skin[:, 1] < 0.18)
    return float(np.percentile(skin[over, 2], 1)) if over.any() else math.inf


def _points(mesh: bpy.types.Mesh) -> Points:
    flat = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", flat)
    return flat.reshape(-1, 3).astype(float)


def _lengths(points: Points, edges: NDArray[np.int64]) -> Points:
    return np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)


def built(name: str, folder: Path) -> PersonBuild:
    """Return a figure in an empty file: one of ``HUMANOIDS``, or the built-in man."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    if name == "built-in":
        return build_person(WHO, CharacterLook(gender="male", age=40.0), 1)
    path = write_humanoid(name, folder)
    height = AssetDimension(height=1.2 if name == "child" else 1.7)
    return character_from_file(WHO, path, folder, height, certainty="usual", pose=ModelPose()).person


def measured(person: PersonBuild, tiles: list[Path] | None = None, folder: Path = Path()) -> Iterator[Row]:
    """Yield a row for each motion, and draw each into a tile of ``folder`` if there is a list for them."""
    figure = Figure(person)
    for act in ACTS:
        yield figure.perform(act)
        if tiles is not None:
            tiles.append(folder / f"{act.name}.png")
            figure.draw(tiles[-1])
        remove(SHOT)


def main() -> None:
    """Print the table, and draw the sheets."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks bound_cast")
    parser.add_argument("names", nargs="*")
    parser.add_argument("--sheets", type=Path)
    asked = parser.parse_args()
    print(f"{'figure':<14} {'motion':<6} {'stretch':>7} {'torn':>6} {'floor':>6} {'seat':>6} {'inside':>6} {'grip':>6}")
    with tempfile.TemporaryDirectory() as scratch:
        for name in asked.names or ["built-in", *HUMANOIDS]:
            tiles: list[Path] = []
            for row in measured(built(name, Path(scratch)), tiles if asked.sheets else None, Path(scratch)):
                numbers = (row.floor, row.seat, row.inside, row.grip)
                lengths = " ".join(f"{number:6.0f}" for number in numbers)
                print(f"{name:<14} {row.act:<6} {row.stretch:7.2f} {row.torn:6.2f} {lengths}", flush=True)
            if asked.sheets:
                _sheet(tiles, asked.sheets / f"{name}.png")


def _sheet(tiles: list[Path], path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    sheet = Image.new("RGB", (5 * SIZE, SIZE * math.ceil(len(tiles) / 5)))
    for index, tile in enumerate(tiles):
        sheet.paste(Image.open(tile).convert("RGB"), (index % 5 * SIZE, index // 5 * SIZE))
    sheet.save(path)


if __name__ == "__main__":
    main()
