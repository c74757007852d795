"""The cut of a story as a scene of sequencer strips, and the .blend of a long story, which links its scenes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import bpy

from storyblender.blender.asset_store import AssetStore
from storyblender.blender.library_scene import add_assets, new_file
from storyblender.blender.tidying import show_on_opening, write_version_note
from storyblender.folder import Folder
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.blend_values import BlendValues, StripInEdit
from storyblender.memory.graph import ProjectFormat
from storyblender.memory.jobs import CutJob, PackRef, SequenceFile, StoryJob
from storyblender.memory.shot_context import ShotContext

EDIT = "EDIT"
TEXT = "storyblender.json"
"""The text block with the values that a file was compiled as."""


def compile_cut(job: CutJob, files: Folder) -> None:
    """Compile the .blend of a long story, which links its scenes from the files of its sequences.

    Blender reads everything that is linked, gigabytes for a feature, only to store names. So the file is made beside
    stand-ins of the sequences, with the same names and scenes that contain only cameras.

    Args:
        job: The sequences, which may still be compiling, and the content of the file itself.
        files: The project folder.
    """
    with TemporaryDirectory(prefix="storyblender_") as folder:
        beside = Folder(Path(folder))
        for sequence in job.sequences:
            _stand_in(beside, sequence, job)
        new_file()
        add_assets(job.assets, AssetStore(files), job.paints)
        write_version_note()
        bpy.ops.wm.save_as_mainfile(filepath=str(beside.path(job.out)))  # links are relative to where the file lies
        for sequence in job.sequences:
            names = [scene_name(scene_id) for scene_id in sequence.scene_ids]
            with bpy.data.libraries.load(str(beside.path(sequence.path)), link=True, relative=True) as (_, target):
                target.scenes = names
        add_edit(job.format, job.packs, in_film(job))
        show_on_opening(bpy.data.scenes[scene_name(job.packs[0].scene_id)])
        keep_values(BlendValues(version=job.version, scenes=(), cut=cut_values()))
        with files.writing(job.out) as part:
            bpy.ops.wm.save_as_mainfile(filepath=str(part), compress=True, copy=True, relative_remap=False)
            files.refuse_change(job.out, job.former)


def add_edit(film: ProjectFormat, packs: Sequence[PackRef], shots: Sequence[ShotContext]) -> None:
    """Add the scene with the cut: one sequencer strip per shot, which an editor can re-order and trim.

    Args:
        film: Size and frame rate.
        packs: The scenes in the file.
        shots: Of the film, in its order; those of other scenes are left out.
    """
    edit = bpy.data.scenes.new(EDIT)
    edit.render.resolution_x, edit.render.resolution_y = film.width, film.height
    edit.render.fps = film.fps
    edit.view_settings.view_transform = "Standard"
    sequencer = edit.sequence_editor_create()
    known = {pack.scene_id: pack for pack in packs}
    frame = 1
    for shot in shots:
        pack = known.get(shot.scene_id)
        if pack is None:
            continue
        name = shot_name(shot.scene_id, shot.shot_id)
        scene = bpy.data.scenes[scene_name(shot.scene_id)]
        offset = pack.start_of(shot.shot_id) - scene.frame_start
        strip = sequencer.strips.new_scene(name, scene, channel=1, frame_start=frame - offset)
        strip.scene_input = "CAMERA"
        strip.scene_camera = scene.objects[name]
        strip.frame_offset_start = offset
        strip.frame_final_duration = shot.duration
        frame += shot.duration
    edit.frame_start, edit.frame_end = 1, max(1, frame - 1)


def keep_values(values: BlendValues) -> None:
    """Write what the open file is compiled as into a text block of it."""
    text = bpy.data.texts.get(TEXT) or bpy.data.texts.new(TEXT)
    text.from_string(values.model_dump_json())
    text.use_fake_user = True


def cut_values() -> tuple[StripInEdit, ...] | None:
    """Return the strips of the scene with the cut in the open file, in order; None if it has no such scene."""
    edit = bpy.data.scenes.get(EDIT)
    if edit is None or edit.sequence_editor is None:
        return None
    strips = (strip for strip in edit.sequence_editor.strips if strip.type == "SCENE")
    return tuple(
        StripInEdit(
            name=strip.name, start=strip.frame_final_start, frames=strip.frame_final_duration,
            offset=round(strip.frame_offset_start), muted=strip.mute,
        )
        for strip in sorted(strips, key=lambda strip: (strip.frame_final_start, strip.name))
    )  # fmt: skip


def in_film(job: StoryJob | CutJob) -> tuple[ShotContext, ...]:
    """Return the shots of a job that are in the film, in its order."""
    shots = {(shot.scene_id, shot.shot_id): shot for shot in job.shots}
    return tuple(shots[key] for key in job.cut) if job.cut else job.shots


def _stand_in(beside: Folder, sequence: SequenceFile, job: CutJob) -> None:
    """Write a stand-in of a sequence's file: its scenes with cameras only."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scenes: set[bpy.types.ID] = set()
    for scene_id in sequence.scene_ids:
        scene = bpy.data.scenes.new(scene_name(scene_id))
        scene.render.fps = job.format.fps
        shots = [shot for shot in job.shots if shot.scene_id == scene_id]
        scene.frame_start, scene.frame_end = 1, max(1, sum(shot.duration for shot in shots))
        for shot in shots:
            name = shot_name(scene_id, shot.shot_id)
            camera = bpy.data.objects.new(name, bpy.data.cameras.new(name))
            scene.collection.objects.link(camera)
        scenes.add(scene)
    with beside.writing(sequence.path) as part:
        bpy.data.libraries.write(str(part), scenes)
