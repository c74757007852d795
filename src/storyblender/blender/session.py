"""The Blender state of one worker: the open pack, and the engine's jobs as tools.

Modules that build are imported by the tools that build, so that a worker that only draws starts a quarter sooner
(measured).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import PurePosixPath
from typing import TYPE_CHECKING, Any

import bpy

from storyblender.blender.asset_session import AssetSession
from storyblender.blender.cameras import make_camera
from storyblender.blender.measure.collisions import find_collisions
from storyblender.blender.measure.drift import spatial_drift
from storyblender.blender.measure.figures import figures
from storyblender.blender.measure.view import ViewfinderPose
from storyblender.blender.render.frame import FrameRequest, PersonHead, render_frame
from storyblender.blender.render.motion_frames import GROWN_HEAD, render_motion
from storyblender.blender.render.picture import write_png
from storyblender.blender.still import held_still
from storyblender.blender.windows import light_windows
from storyblender.geometry.framing import Figure
from storyblender.look.aperture import look_through
from storyblender.look.grade import AGX_CONTRAST, display_of
from storyblender.memory.base import content_hash, scene_name, shot_name
from storyblender.memory.blend_values import AdoptedObject, BlendReading
from storyblender.memory.graph import ProjectFormat
from storyblender.memory.jobs import (
    DRAWING_VERSION,
    CutJob,
    ExportJob,
    FrameJob,
    FrameReport,
    MomentJob,
    MotionJob,
    PackRef,
    SceneJob,
    StoryJob,
)
from storyblender.memory.measure import CameraView, Collision, ViewRequest
from storyblender.memory.request import Picture

if TYPE_CHECKING:
    pass


class BlenderSession(AssetSession):
    """Does the engine's jobs in this process."""

    @property
    def tools(self) -> list[Callable[..., Any]]:
        """The functions that a client may call."""
        return [
            self.build_asset,
            self.pack_scene,
            self.rehearse,
            self.read_figures,
            self.look,
            self.preview,
            self.find_collisions,
            self.measure_drift,
            self.render_frame,
            self.write_moment,
            self.render_motion,
            self.compile_story,
            self.compile_cut,
            self.read_story,
            self.adopt_object,
            self.export_scene,
            self.portrait,
            self.write_asset,
            self.draw_sides,
        ]

    def pack_scene(self, job: SceneJob) -> PackRef:
        """Build one scene and save it as a pack."""
        from storyblender.blender.pack import ScenePacker, save_pack

        self._close_pack()
        pack = ScenePacker(job, self._store).build(self._report)
        with self._files.writing(job.out) as part:
            save_pack(part)
        return pack

    def rehearse(self, job: SceneJob, shot_ids: Sequence[int]) -> PackRef:
        """Have a scene in the open file be as its pack will be, in some of its shots; return what the pack is so far.

        The next calls on that pack then see it, though it is not saved.

        Args:
            job: The scene; where only places and motion differ from its last rehearsal, it is changed in place.
            shot_ids: Staged shots of it that will be looked at.
        """
        from storyblender.blender.rehearsal import Rehearsals

        self._release_viewfinder()
        if self._rehearsals is None:
            self._close_pack()
            self._rehearsals = Rehearsals(self._store)
        self._open = ""  # should it fail
        try:
            pack = self._rehearsals.perform(job, shot_ids)
        except BaseException:
            self._rehearsals = None  # a scene may be half built
            raise
        self._open = pack.path
        return pack

    def read_figures(self, pack: PackRef, frames: Sequence[int]) -> list[list[Figure]]:
        """Return the faces of all people at frames of the scene's timeline, frame by frame.

        Args:
            pack: The packed scene.
            frames: On the scene's timeline, not the shot's.
        """
        scene = self._open_pack(pack, frames)
        return [list(figures(scene, frame)) for frame in frames]

    def find_collisions(self, pack: PackRef) -> list[Collision]:
        """Return the collisions of people with props and with each other in every shot of a pack."""
        scene = self._open_pack(pack)
        bodies = {
            str(obj["asset_id"]): self._store.body(str(obj.data["digest"]))
            for obj in scene.objects
            if obj.type == "ARMATURE"
        }
        ends = [start for _, start in pack.starts[1:]] + [scene.frame_end + 1]
        frames = {
            shot_name(pack.scene_id, shot_id): range(start, end)
            for (shot_id, start), end in zip(pack.starts, ends, strict=True)
        }
        return find_collisions(scene, bodies, frames)

    def measure_drift(self, pack: PackRef) -> float:
        """Return the Spatial Drift Error of a scene, metres."""
        return spatial_drift(self._open_pack(pack), [start for _, start in pack.starts])

    def look(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> list[CameraView]:
        """Return what cameras see through the viewfinder; ``aspect`` is width over height.

        Args:
            pack: The packed scene.
            requests: Each with a shot, a frame from the shot's start and a camera.
            aspect: Width of the picture over its height.
        """
        self._background.submit(display_of, AGX_CONTRAST)  # needed by the next render
        poses = list(_poses(pack, requests))
        opened = self._viewfinder[0][1] if self._viewfinder is not None else None
        seen: dict[int, CameraView] = {}
        # Each frame once, the one that is open already first: opening a viewfinder costs more than two looks.
        for number in sorted(
            range(len(poses)), key=lambda number: (poses[number].frame != opened, poses[number].frame)
        ):
            seen[number] = self._viewfinder_at(pack, poses[number].frame, aspect)(poses[number])
        return [seen[number] for number in range(len(poses))]

    def preview(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> list[Picture]:
        """Return pictures of what cameras see, for a model or a person: wider than the frame, the subjects outlined.

        Args:
            pack: The packed scene.
            requests: As ``look`` takes them.
            aspect: Width of the frame over its height.
        """
        from storyblender.blender.measure.preview import preview

        return [
            Picture(
                name="preview",
                png=preview(self._viewfinder_at(pack, pose.frame, aspect), pose, aspect),
                drawn_from=content_hash(pack.path, request, aspect, DRAWING_VERSION),
            )
            for pose, request in zip(_poses(pack, requests), requests, strict=True)
        ]

    def render_frame(self, job: FrameJob) -> FrameReport:
        """Render the board frame of one shot and return its report."""
        start = job.pack.start_of(job.shot.shot_id)
        scene = self._open_pack(job.pack, (start + job.frame,))
        assert job.shot.camera is not None, "the Camera Operator comes before the camera"
        light_windows(scene, job.lighting.sky)
        request = FrameRequest(
            look=job.look,
            width=job.format.width,
            height=job.format.height,
            seed=job.format.seed,
            hidden_node_ids=job.shot.camera.hidden_node_ids,
            panorama=job.lighting.panorama and self._files.path(job.lighting.panorama.file),
            draft=job.draft,
        )
        heads = [_head(figure, job.shot.in_frame) for figure in figures(scene, start + job.frame)]
        with held_still(scene, start + job.frame) as still:
            camera = make_camera(still, still.collection, job.shot, start)
            try:
                result = render_frame(still, camera, job.lighting, heads, request)
            finally:
                _remove_camera(camera)
        instruction = job.shot.camera_instruction
        with self._files.writing(job.out) as part:
            write_png(look_through(result.image, instruction.through, instruction.soft_focus), part)
        cast = {str(obj["node_id"]) for obj in scene.objects if obj.get("kind") == "character"}
        return FrameReport(
            out=job.out,
            lights=result.lights,
            face_luminance=result.statistics.face_luminance,
            void=result.statistics.void,
            visible=tuple(sorted(node for node in result.statistics.visible if node in cast)),
        )

    def write_moment(self, job: MomentJob) -> str:
        """Write what a scene looks like at one moment as glTF."""
        from storyblender.blender.moment_glb import write_moment

        scene = self._open_pack(job.pack, (job.frame,))
        with self._files.writing(job.out) as part:
            write_moment(scene, job.frame, part)
        return job.out

    def render_motion(self, job: MotionJob) -> int:
        """Render the moving frames of one shot into its folder; return their number."""
        scene = self._open_pack(job.pack)
        start = job.pack.start_of(job.shot.shot_id)
        light_windows(scene, job.lighting.sky)
        camera = make_camera(scene, scene.collection, job.shot, start)
        assert job.shot.camera is not None, "make_camera has made sure"
        height = ProjectFormat(aspect=job.format.aspect, width=job.width).height
        frames = range(start, start + job.shot.duration, job.step)
        hidden, instruction = job.shot.camera.hidden_node_ids, job.shot.camera_instruction
        try:
            with self._files.writing_tree(job.folder) as part:
                pictures = render_motion(
                    scene, camera, frames, job.width, height, part, job.lighting,
                    hidden_node_ids=hidden, through=instruction.through,
                    soft_focus=instruction.soft_focus,
                    report=self._report,
                )  # fmt: skip
                return len(pictures)
        finally:
            _remove_camera(camera)

    def compile_story(self, job: StoryJob) -> str:
        """Compile the .blend of a story or of one sequence."""
        from storyblender.blender.story import compile_story

        self._close_pack()
        compile_story(job, self._files, self._report)
        return job.out

    def compile_cut(self, job: CutJob) -> str:
        """Compile the .blend of a long story, which links its scenes."""
        from storyblender.blender.cut import compile_cut

        self._close_pack()
        compile_cut(job, self._files)
        return job.out

    def read_story(self, name: str) -> BlendReading:
        """Return what a .blend of the story was compiled as, and what it holds now."""
        from storyblender.blender.motion.by_hand_reading import read_by_hand
        from storyblender.blender.story_values import read_file

        self._close_pack()
        reading = read_file(str(self._files.path(name)))
        return reading.model_copy(update={"by_hand": read_by_hand(reading, self._files)})

    def adopt_object(self, name: str, scene: str, node: str, keep: bool) -> AdoptedObject:
        """Write an object of a .blend of the story as a model of its own."""
        from storyblender.blender.adopt import adopt_object

        self._close_pack()
        return adopt_object(name, scene, node, self._files, keep=keep)

    def export_scene(self, job: ExportJob) -> str:
        """Write one scene as glTF or USD."""
        from storyblender.blender.export import export_scene

        self._close_pack()
        with self._files.writing(job.out) as part:
            export_scene(self._files.path(job.story), scene_name(job.scene_id), job.format, part)
            for picture in sorted(part.parent.glob("textures/*")):  # equal names, equal pictures, in all scenes
                beside = PurePosixPath(job.out).parent / "textures" / picture.name
                self._files.write(beside.as_posix(), picture.read_bytes())
        return job.out


def _poses(pack: PackRef, requests: Sequence[ViewRequest]) -> Iterator[ViewfinderPose]:
    """Yield the poses of requests, each with its frame on the scene's timeline."""
    for each in requests:
        frame = pack.start_of(each.shot_id) + each.frame
        yield ViewfinderPose(each.pose, frame, each.sensor_width, each.focus_ids, each.hidden_node_ids, each.other_ids)


def _head(figure: Figure, in_frame: Sequence[str]) -> PersonHead:
    """Return a person's head for the renderer."""
    return PersonHead(
        asset_id=figure.node_id,
        location=figure.face,
        yaw=figure.yaw,
        scale=figure.head / GROWN_HEAD,
        in_frame=figure.node_id in in_frame,
    )


def _remove_camera(camera: bpy.types.Object) -> None:
    """Remove a camera and its actions."""
    data = camera.data
    for block in (camera, data):
        if block.animation_data and block.animation_data.action:
            bpy.data.actions.remove(block.animation_data.action)
    bpy.data.objects.remove(camera)
    bpy.data.cameras.remove(data)
