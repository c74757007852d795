"""A scene pack: one Blender scene with set, objects, people and the motion of all its shots.

It has no cameras and no face lights, so that a changed camera never rebuilds a scene. Names and custom properties are
the interface: scene ``SC010``, objects ``SC010.<node_id>`` with ``node_id``, ``asset_id`` and ``kind``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import bpy
from mathutils import Euler, Matrix, Vector

from storyblender.blender.asset_store import AssetStore, CastMember
from storyblender.blender.doors import Door, swing_doors
from storyblender.blender.hiding import key_hidden
from storyblender.blender.merge import merge_duplicates
from storyblender.blender.motion.bake import bake, remove
from storyblender.blender.motion.by_hand import with_motion_by_hand
from storyblender.blender.motion.plan import Performance, PlayedTimes
from storyblender.blender.motion.solve import SolvedShot
from storyblender.blender.painting import paint_objects
from storyblender.blender.progress import Report, ignore
from storyblender.blender.sections import split_sections, with_sections
from storyblender.blender.sets.build import build_set
from storyblender.blender.sets.textured import load_textures
from storyblender.blender.staging import StagePlanner, moved_assets
from storyblender.blender.state_parts import StateParts
from storyblender.blender.tags import surface_of, tag
from storyblender.catalog.fixtures import fixtures_called
from storyblender.catalog.openings import openings_of
from storyblender.catalog.parts import DRAWN
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import plan_of
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.jobs import PackRef, PlayedCue, SceneJob
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import Flaw, ShotContext
from storyblender.memory.thing_states import Condition


class ScenePacker:
    """Builds one scene into the open file.

    Args:
        job: The scene to build.
        store: The canonical assets.
    """

    def __init__(self, job: SceneJob, store: AssetStore) -> None:
        self._job, self._store = job, store
        self._name = scene_name(job.scene.scene_id)
        self._assets = {asset.asset_id: asset for asset in job.assets}
        self._starts = shot_starts(job.shots)
        self._placed: dict[str, bpy.types.Object] = {}
        self._props: dict[str, bpy.types.Object] = {}
        self._nodes: dict[str, list[bpy.types.Object]] = {}
        self._cast: dict[str, CastMember] = {}
        self._performances: dict[int, Performance] = {}
        self._played: dict[int, PlayedTimes] = {}

    def build(self, report: Report = ignore) -> PackRef:
        """Build everything and return what the pack will be.

        Args:
            report: Receives the number of shots animated.
        """
        self.set_up(begin_file())
        for step, shot in enumerate(self._job.shots):
            report(step, len(self._job.shots))
            self.pose(shot, self.solve(shot), range(shot.duration))
        self.finish()
        return self.reference()

    def set_up(self, scene: bpy.types.Scene) -> None:
        """Build the set, its things where the layout has them, its people without motion.

        Args:
            scene: Empty; it becomes the scene, and that of the context.
        """
        bpy.context.window.scene = self._scene = scene
        scene.name = self._name
        scene.render.fps = self._job.fps
        scene.frame_start = 1
        scene.frame_end = _length_of(self._job)
        environment = self._job.scene.environment
        assert environment is not None, "the Environment Designer comes before the pack"
        self._plan = plan_of(environment)
        load_textures(self._plan, self._store.files)
        self._set = build_set(self._plan, scene, self._collection("set"))
        self._place_objects()
        self._states = StateParts(self._job, self._store, self._nodes)
        self._place_people()
        paint_objects(scene.objects, self._job.paints, self._job.scene.scene_id)
        self._planner = self._new_planner()

    def move_to(self, job: SceneJob) -> None:
        """Have the things stand, and the people do, as a later version of the scene says; no shot is performed then.

        Args:
            job: The scene with other places, other motion and other lengths of shots, and else as it is.
        """
        self.remove_motion()
        self._job, self._starts = job, shot_starts(job.shots)
        self._scene.frame_end = _length_of(job)
        self._states.follow(job)
        assert job.scene.layout is not None, "as before"
        for item in job.scene.layout.objects:
            if item.node_id in self._placed:
                _put(self._placed[item.node_id], item)
        self._planner = self._new_planner()

    def remove_motion(self) -> None:
        """Have no shot be performed."""
        for shot_id in self._performances:
            remove(shot_name(self._job.scene.scene_id, shot_id))
        self._performances.clear()
        self._played.clear()

    def solve(self, shot: ShotContext) -> SolvedShot:
        """Solve the timing of all motion of a shot; ``pose`` then bakes it."""
        solved = SolvedShot(self._planner.plan(shot), self._job.fps)
        self._played[shot.shot_id] = solved.played
        return solved

    def pose(self, shot: ShotContext, solved: SolvedShot, frames: Sequence[int]) -> None:
        """Bake a shot in place of what is baked of it.

        Args:
            shot: Of the job.
            solved: The shot.
            frames: From its start, ascending, its first and its last among them; what lies between is interpolated,
                which makes feet slide (notes: motion, section 6).
        """
        motions = {each.asset_id: each.motion for each in self._job.by_hand if each.shot_id == shot.shot_id}
        performance = with_motion_by_hand(solved.at(frames), motions)
        armatures = {asset_id: member.armature for asset_id, member in self._cast.items()}
        name = shot_name(shot.scene_id, shot.shot_id)
        bake(performance, armatures, self._props, name, self._starts[shot.shot_id])
        self._performances[shot.shot_id] = performance

    def finish(self) -> None:
        """Let doors swing and things appear after what is baked."""
        self._swing_doors()
        self._key_visibility(tuple(self._timing()))
        merge_duplicates()

    def reference(self) -> PackRef:
        """Return what the pack is so far."""
        problems = (flaw for shot in self._job.shots for flaw in self._problems(shot))
        return PackRef(
            scene_id=self._job.scene.scene_id,
            path=self._job.out,
            starts=tuple(self._starts.items()),
            problems=tuple(problems),
            timing=tuple(self._timing()),
        )

    def _new_planner(self) -> StagePlanner:
        bodies = {asset_id: member.body for asset_id, member in self._cast.items()}
        return StagePlanner(self._job, self._plan, bodies, self._store.mocap)

    def _collection(self, part: str) -> bpy.types.Collection:
        """Create and link the collection of a part of the scene."""
        collection = bpy.data.collections.new(f"{self._name}_{part}")
        self._scene.collection.children.link(collection)
        return collection

    def _place_objects(self) -> None:
        """Place the objects of the layout; movable ones without a place wait below the floor."""
        layout = self._job.scene.layout
        assert layout is not None, "the Spatial Planner comes before the pack"
        collection = self._collection("props")
        parts = [item for item in layout.objects if self._assets[item.asset_id].fitted_part]
        for item in layout.objects:
            if self._assets[item.asset_id].asset_type == "object" and item not in parts:
                self._place(item, collection, [each for each in parts if each.anchor_asset_id == item.node_id])
        for asset_id in moved_assets(self._job):
            if asset_id not in self._props:
                self._place(LayoutObject(node_id=asset_id, asset_id=asset_id, location=(0, 0, -5)), collection)

    def _place(self, item: LayoutObject, collection: bpy.types.Collection, parts: Sequence[LayoutObject] = ()) -> None:
        """Place one object, and the story's parts of it: its own where its model has them, else drawn there."""
        asset = self._assets[item.asset_id]
        obj = bpy.data.objects.new(f"{self._name}.{item.node_id}", self._store.append_mesh(asset))
        _put(obj, item)
        self._placed[item.node_id] = obj
        tag(obj, kind="prop", node_id=item.node_id, asset_id=item.asset_id, surface=surface_of(obj))
        collection.objects.link(obj)
        self._props.setdefault(item.asset_id, obj)
        self._nodes.setdefault(item.asset_id, []).append(obj)
        named = {self._assets[each.asset_id].fitted_part: (each.node_id, each.asset_id) for each in reversed(parts)}
        own = split_sections(obj, named)
        for each in parts:
            if self._assets[each.asset_id].fitted_part not in own:
                self._fit(each, obj, collection)

    def _fit(self, item: LayoutObject, whole: bpy.types.Object, collection: bpy.types.Collection) -> None:
        """Place a part whose vehicle's model does not have it apart; a seat or a door is in the model already."""
        asset = self._assets[item.asset_id]
        drawn = asset.fitted_part in DRAWN
        mesh = self._store.append_mesh(asset) if drawn else bpy.data.meshes.new(f"{self._name}.{item.node_id}")
        part = bpy.data.objects.new(f"{self._name}.{item.node_id}", mesh)
        placed = Matrix.LocRotScale(Vector(item.location), Euler([math.radians(a) for a in item.rotation]), None)
        part.parent = whole
        part.matrix_local = whole.matrix_basis.inverted() @ placed
        tag(part, kind="prop", node_id=item.node_id, asset_id=item.asset_id, surface=surface_of(part))
        collection.objects.link(part)

    def _place_people(self) -> None:
        """Append the people who appear in any shot."""
        collection = self._collection("cast")
        present = {blocking.start.asset_id for shot in self._job.shots for blocking in shot.blocking}
        for asset in self._job.assets:
            if asset.asset_type != "character" or asset.asset_id not in present:
                continue
            member = self._store.append_person(asset)
            member.armature.name = f"{self._name}.{asset.asset_id}"
            member.armature.rotation_mode = "XYZ"
            for obj in (member.armature, *member.meshes):
                collection.objects.link(obj)
            for mesh in member.meshes:
                mesh.name = f"{self._name}.{mesh.name.split('.')[0]}"
            self._cast[asset.asset_id] = member

    def _timing(self) -> Iterator[PlayedCue]:
        """Yield the actual timing of the cues of solved shots, from which the moment of a board frame is chosen."""
        fps = self._job.fps
        for shot_id, played in self._played.items():
            for (who, clip, start), (began, over) in played.items():
                spans = {"began": round(began * fps), "over": round(over * fps)}
                yield PlayedCue(shot_id=shot_id, asset_id=who, clip=clip, start=start, **spans)

    def _problems(self, shot: ShotContext) -> Iterator[Flaw]:
        """Yield what could not be staged of a shot."""
        name, performance = shot_name(shot.scene_id, shot.shot_id), self._performances.get(shot.shot_id)
        for found in performance.problems if performance is not None else ():
            yield Flaw(kind=found.kind, subject=found.asset_id, weight=found.amount, message=found.message, shot=name)

    def _swing_doors(self) -> None:
        """Play the doors through the scene; nobody passes them in shots that are not performed."""
        found = self._job.scene.setup.found
        doors = [
            Door(place, self._job.fps, _left_open(self._plan, place.opening.name, found))
            for wall in self._plan.walls
            for place in openings_of(wall)
            if place.opening.kind == "door"
        ]
        for door in doors:
            for shot in self._job.shots:
                door.play(self._performances.get(shot.shot_id), shot.cues, shot.duration)
        swing_doors(doors, self._set)

    def _key_visibility(self, timing: Sequence[PlayedCue]) -> None:
        """Key which people and props are hidden in each shot."""
        for asset_id, member in self._cast.items():
            shown = [
                (self._starts[shot.shot_id], any(b.start.asset_id == asset_id and b.visible for b in shot.blocking))
                for shot in self._job.shots
            ]
            for obj in (member.armature, *member.meshes):
                key_hidden(obj, shown)
        for asset_id in {**dict.fromkeys(moved_assets(self._job)), **dict.fromkeys(self._states.changing)}:
            seen = {
                self._starts[shot.shot_id]: all(each.visible for each in shot.prop_states if each.asset_id == asset_id)
                for shot in self._job.shots
            }
            for obj, shown in self._states.visibility(asset_id, seen, timing):
                for each in with_sections(obj):
                    key_hidden(each, shown)


def _length_of(job: SceneJob) -> int:
    """Return the frames of a scene."""
    return max(1, sum(shot.duration for shot in job.shots))


def _put(obj: bpy.types.Object, item: LayoutObject) -> None:
    """Put an object where the layout has it."""
    obj.rotation_mode = "XYZ"
    obj.location = item.location
    obj.rotation_euler = [math.radians(angle) for angle in item.rotation]


def _left_open(plan: SetPlan, name: str, found: Mapping[str, Condition]) -> bool | None:
    """Return whether an earlier scene left a door open (True) or shut (False); None if it did not touch it."""
    for thing, states in found.items():
        if any(fixture.name == name for fixture in fixtures_called(plan, thing)[:1]):
            return next((state == "open" for state in reversed(states.states) if state in ("open", "closed")), None)
    return None


def shot_starts(shots: tuple[ShotContext, ...]) -> dict[int, int]:
    """Return each shot's first frame on the scene's timeline; the scene begins at frame 1."""
    starts: dict[int, int] = {}
    frame = 1
    for shot in shots:
        starts[shot.shot_id] = frame
        frame += shot.duration
    return starts


def begin_file() -> bpy.types.Scene:
    """Begin an empty file, and return its scene."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return bpy.context.scene


def save_pack(part: Path) -> None:
    """Save the open file as ``part``."""
    bpy.ops.wm.save_as_mainfile(filepath=str(part), compress=True, copy=True)
