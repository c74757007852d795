"""Prop builders: background people, dressed and posed once as plain meshes that stand in many places."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import bpy
import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.motion.bake import bake, remove
from storyblender.blender.motion.plan import StageFurniture, StagePerson, StagePlan
from storyblender.blender.motion.solve import solve_shot
from storyblender.blender.people.drape import drape_seated
from storyblender.blender.people.parts import Paint, material
from storyblender.blender.people.person import PersonBuild, build_person
from storyblender.blender.props.anchors import Anchors
from storyblender.blender.props.registry import PropSpec, prop
from storyblender.catalog.bystanders import SEAT_HEIGHT, look_of
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.shot_context import Blocking, Cue, Mark

_ID = "bystander"
_FACES = 0.1
"""Share of a figure's faces that is kept: it is never seen near."""
_FRAME = 20
"""Frame of the act that the figure is held in."""
_ACTS = {"stand": ("talk", "listen", "idle"), "sit": ("talk", "listen", "idle")}


@prop("background_figure")
def background_figure(builder: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a person in a held pose: ``posture`` stand or sit, ``variant`` who it is, ``age`` of the story."""
    variant, posture = int(spec.number("variant")), spec.word("posture")
    build = build_person(_ID, look_of(variant, spec.word("age")), seed=variant + 1)
    drape_seated(build)
    with _posed(build, posture, _ACTS[posture][variant % 3]) as depsgraph:
        for obj in build.meshes:
            _take(builder, obj, depsgraph)
    return (Anchor(kind="handle", name="seat", location=(0.0, 0.0, SEAT_HEIGHT)),)


@contextmanager
def _posed(build: PersonBuild, posture: str, act: str) -> Iterator[bpy.types.Depsgraph]:
    """Hold a person in a moment of an act; takes it out of the open file in the end."""
    scene = bpy.context.scene
    for obj in (build.armature, *build.meshes):
        if obj.name not in scene.collection.objects:
            scene.collection.objects.link(obj)
    sits = posture == "sit"
    mark = Mark(asset_id=_ID, location=(0, 0, 0), yaw=0, posture="sit" if sits else "stand",
                support_id="seat" if sits else None)  # fmt: skip
    seat = Anchor(kind="seat", location=(0.0, 0.0, SEAT_HEIGHT), size=(0.44, 0.44))
    plan = StagePlan(
        people={_ID: StagePerson(build.body, Blocking(start=mark, end=mark))},
        frames=_FRAME + 10,
        cues=(Cue(asset_id=_ID, clip=act, start=0, duration=_FRAME + 10),),
        furniture={"seat": StageFurniture(np.eye(4), (0.44, 0.44, SEAT_HEIGHT), (seat,), "seat")} if sits else {},
        seed=len(act),
    )
    bake(solve_shot(plan, 24), {_ID: build.armature}, {}, _ID, 1)
    for obj in build.meshes:
        fewer = obj.modifiers.new("fewer", "DECIMATE")
        fewer.ratio = _FACES
    scene.frame_set(1 + _FRAME)
    try:
        yield bpy.context.evaluated_depsgraph_get()
    finally:
        remove(_ID)
        for obj in (*build.meshes, build.armature):
            bpy.data.objects.remove(obj)


def _take(builder: MeshBuilder, obj: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> None:
    """Add what an object looks like now, a part for each of its materials, in flat colours."""
    mesh = obj.evaluated_get(depsgraph).to_mesh()
    points = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", points)
    matrix = np.array(obj.evaluated_get(depsgraph).matrix_world)
    world = points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
    parts: dict[int, list[tuple[int, ...]]] = {}
    for face in mesh.polygons:
        parts.setdefault(face.material_index, []).append(tuple(face.vertices))
    for slot, faces in sorted(parts.items()):
        used = np.unique([corner for face in faces for corner in face])
        place = {int(old): new for new, old in enumerate(used)}
        flat = [tuple(place[corner] for corner in face) for face in faces]
        builder.add(_flat(mesh, slot, used), world[used], flat)
    obj.evaluated_get(depsgraph).to_mesh_clear()


def _flat(mesh: bpy.types.Mesh, slot: int, used: np.ndarray) -> bpy.types.Material:
    """Return a material in the mean of the painted colours, or the material as it is."""
    own = mesh.materials[slot].original  # the evaluated copy does not outlive the evaluation
    if not own.name.endswith("(painted)") or "Color" not in mesh.color_attributes:
        return own
    layer = mesh.color_attributes["Color"]
    colors = np.empty(len(layer.data) * 4, np.float32)
    layer.data.foreach_get("color", colors)
    values = colors.reshape(-1, 4)[:, :3]
    shown = values[used] if layer.domain == "POINT" else values
    red, green, blue = (round(float(value), 3) for value in np.median(shown, axis=0))
    finish = own.name.split(" ")[0]
    return material(Paint((red, green, blue), finish))
