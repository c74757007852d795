"""The story's .blend: every packed scene in one file, with cameras, lights, markers and an EDIT, ready to work in.

Conventions (design): scenes ``SC010``, cameras and markers ``SC010_SH020``, a library scene with the canonical
assets marked for the Asset Browser, an EDIT scene with one strip per shot. Nothing is linked from outside.
"""

from __future__ import annotations

import math

import bpy

from storyblender.blender.appending import append
from storyblender.blender.asset_store import AssetStore
from storyblender.blender.cameras import make_camera
from storyblender.blender.hiding import is_hidden, key_hidden
from storyblender.blender.light import make_lights
from storyblender.blender.merge import merge_duplicates
from storyblender.blender.opening import open_on
from storyblender.blender.pack import save_pack
from storyblender.blender.sets.world import set_world
from storyblender.blender.tags import tag
from storyblender.folder import Folder
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.jobs import PackRef, StoryJob
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext

LIBRARY = "00_ASSET_LIBRARY"
EDIT = "EDIT"


def compile_story(job: StoryJob, files: Folder) -> None:
    """Compile and save the file, or put the changed scenes into it anew.

    Args:
        job: The story and its packs; the .blend is there already where only some scenes changed.
        files: The project folder, which the paths are relative to.
    """
    changed = job.changed
    if changed is None:
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.context.scene.name = LIBRARY
    else:
        bpy.ops.wm.open_mainfile(filepath=str(files.path(job.out)), load_ui=False, use_scripts=False)
        _take_out([EDIT, *map(scene_name, changed)])
    scenes = {scene.scene_id: scene for scene in job.scenes}
    for pack in job.packs:
        if changed is None or pack.scene_id in changed:
            shots = tuple(shot for shot in job.shots if shot.scene_id == pack.scene_id)
            _add_scene(job, pack, scenes[pack.scene_id], shots, files)
    if changed is None:
        _add_library(job, bpy.data.scenes[LIBRARY], AssetStore(files))
    merge_duplicates()
    _add_edit(job)
    open_on(bpy.data.scenes[scene_name(job.packs[0].scene_id)])
    bpy.data.orphans_purge(do_recursive=True)
    with files.writing(job.out) as part:
        save_pack(part)


def _take_out(names: list[str]) -> None:
    """Remove scenes with everything that only they use, so that their names are free again."""
    bpy.context.window.scene = bpy.data.scenes[LIBRARY]
    for name in names:
        scene = bpy.data.scenes[name]
        bpy.data.batch_remove([scene, *scene.objects, *scene.collection.children_recursive])
    bpy.data.orphans_purge(do_recursive=True)


def _add_scene(
    job: StoryJob, pack: PackRef, context: SceneContext, shots: tuple[ShotContext, ...], files: Folder
) -> None:
    name = scene_name(pack.scene_id)
    (scene,) = append(files.path(pack.path), "scenes", [name])
    bpy.context.window.scene = scene
    scene.render.resolution_x, scene.render.resolution_y = job.format.width, job.format.height
    scene.render.resolution_percentage = 100
    scene.render.fps = job.format.fps
    scene["scene_id"] = pack.scene_id
    scene["heading"] = next((o.heading for o in job.outline if o.scene_id == pack.scene_id), "")
    cameras, lights = _child(scene, "cameras"), _child(scene, "lights")
    if context.lighting is not None:
        set_world(scene, context.lighting.sky)
        make_lights(context.lighting.lights, scene, lights)
    hidden: dict[str, list[int]] = {}
    for shot in shots:
        start = pack.start_of(shot.shot_id)
        camera = make_camera(scene, cameras, shot, start)
        marker = scene.timeline_markers.new(shot_name(shot.scene_id, shot.shot_id), frame=start)
        marker.camera = camera
        scene.camera = scene.camera or camera
        if shot.camera is not None:
            for node_id in shot.camera.hidden_node_ids:
                hidden.setdefault(node_id, []).append(shot.shot_id)
        _shot_lights(scene, lights, shot, shots, pack)
    for obj in scene.objects:
        away = hidden.get(str(obj.get("node_id", "")))
        if away:
            starts = [(shot.shot_id, pack.start_of(shot.shot_id)) for shot in shots]
            shown = [(start, shot_id not in away and not is_hidden(obj, start)) for shot_id, start in starts]
            key_hidden(obj, shown)
    scene.frame_set(1)


def _shot_lights(
    scene: bpy.types.Scene,
    collection: bpy.types.Collection,
    shot: ShotContext,
    shots: tuple[ShotContext, ...],
    pack: PackRef,
) -> None:
    """Key, fill and rim burn only during their shot."""
    prefix = shot_name(shot.scene_id, shot.shot_id)
    for obj in make_lights(shot.lights, scene, collection):
        obj.name = f"{prefix}.{obj.name.split('.')[0]}"
        key_hidden(obj, [(pack.start_of(other.shot_id), other is shot) for other in shots])


def _child(scene: bpy.types.Scene, part: str) -> bpy.types.Collection:
    collection = bpy.data.collections.new(f"{scene.name}_{part}")
    scene.collection.children.link(collection)
    return collection


def _add_library(job: StoryJob, library: bpy.types.Scene, store: AssetStore) -> None:
    """Show every canonical asset once, on a grid, each in a collection marked for the Asset Browser."""
    bpy.context.window.scene = library
    columns = max(1, math.ceil(math.sqrt(len(job.assets))))
    for index, asset in enumerate(job.assets):
        if asset.canonical is None:
            continue
        collection = bpy.data.collections.new(f"AST_{asset.asset_id}")
        library.collection.children.link(collection)
        place = (2.5 * (index % columns), 2.5 * (index // columns), 0.0)
        for obj in _canonical_objects(asset, store):
            collection.objects.link(obj)
            if obj.parent is None:
                obj.location = place
        collection.asset_mark()
        collection.asset_data.description = asset.description
        collection.asset_data.author = "StoryBlender"
        for word in asset.tags:
            collection.asset_data.tags.new(word, skip_if_exists=True)


def _canonical_objects(asset: Asset, store: AssetStore) -> list[bpy.types.Object]:
    if asset.asset_type == "character":
        member = store.append_person(asset)
        return [member.armature, *member.meshes]
    obj = bpy.data.objects.new(asset.asset_id, store.append_mesh(asset))
    return [tag(obj, kind="prop", node_id=asset.asset_id, asset_id=asset.asset_id)]


def _add_edit(job: StoryJob) -> None:
    """String the shots in the sequencer: one strip a shot, so that an editor can re-order and trim them."""
    edit = bpy.data.scenes.new(EDIT)
    edit.render.resolution_x, edit.render.resolution_y = job.format.width, job.format.height
    edit.render.fps = job.format.fps
    edit.view_settings.view_transform = "Standard"
    sequencer = edit.sequence_editor_create()
    packs = {pack.scene_id: pack for pack in job.packs}
    frame = 1
    for shot in job.shots:
        pack = packs.get(shot.scene_id)
        if pack is None:
            continue
        name = shot_name(shot.scene_id, shot.shot_id)
        scene = bpy.data.scenes[scene_name(shot.scene_id)]
        offset = pack.start_of(shot.shot_id) - scene.frame_start
        strip = sequencer.strips.new_scene(name, scene, channel=1, frame_start=frame - offset)
        strip.scene_input = "CAMERA"
        strip.scene_camera = bpy.data.objects[name]
        strip.frame_offset_start = offset
        strip.frame_final_duration = shot.duration
        frame += shot.duration
    edit.frame_start, edit.frame_end = 1, max(1, frame - 1)
