"""The story's .blend, or that of one sequence: packed scenes with cameras, lights, markers and a scene with the cut.

Scenes are named ``SC010``, cameras and markers ``SC010_SH020``; a library scene has the canonical assets marked for the
Asset Browser, the EDIT scene one strip per shot. Nothing is linked from other files.
"""

from __future__ import annotations

import bpy

from storyblender.blender.appending import append
from storyblender.blender.asset_store import AssetStore
from storyblender.blender.cameras import make_camera
from storyblender.blender.cut import EDIT, add_edit, in_film
from storyblender.blender.hiding import is_hidden, key_hidden
from storyblender.blender.library_scene import LIBRARY, add_assets, new_file
from storyblender.blender.merge import merge_duplicates
from storyblender.blender.motion.by_hand_reading import PACK
from storyblender.blender.pack import save_pack
from storyblender.blender.progress import Report, ignore
from storyblender.blender.sections import SECTION
from storyblender.blender.story_light import light_scene
from storyblender.blender.story_values import write_values
from storyblender.blender.tidying import set_render_defaults, show_on_opening, tidy, write_version_note
from storyblender.folder import Folder
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.jobs import PackRef, StoryJob
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext


def compile_story(job: StoryJob, files: Folder, report: Report = ignore) -> None:
    """Compile and save the file, or replace the changed scenes in it.

    Args:
        job: The story and its packs; if only some scenes changed, the .blend exists already.
        files: The project folder.
        report: Receives the number of scenes added.
    """
    changed = job.changed
    if changed is None:
        new_file()
    else:
        bpy.ops.wm.open_mainfile(filepath=str(files.path(job.out)), load_ui=False, use_scripts=False)
        _take_out([EDIT, *map(scene_name, changed)])
    scenes = {scene.scene_id: scene for scene in job.scenes}
    for step, pack in enumerate(job.packs):
        report(step, len(job.packs))
        if changed is None or pack.scene_id in changed:
            shots = tuple(shot for shot in job.shots if shot.scene_id == pack.scene_id)
            _add_scene(job, pack, scenes[pack.scene_id], shots, files)
    if changed is None:
        add_assets(job.assets, AssetStore(files), job.paints)
    write_version_note()
    add_edit(job.format, job.packs, in_film(job))
    show_on_opening(bpy.data.scenes[scene_name(job.packs[0].scene_id)])
    bpy.data.orphans_purge(do_recursive=True)
    write_values(job.version)
    with files.writing(job.out) as part:
        save_pack(part)
        files.refuse_change(job.out, job.former)


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
    """Append one packed scene and add its cameras, lights, markers and wild walls."""
    name = scene_name(pack.scene_id)
    (scene,) = append(files.path(pack.path), "scenes", [name])
    bpy.context.window.scene = scene
    merge_duplicates()  # scene by scene: the fewer data-blocks there are, the less the next one costs
    tidy(scene.objects)
    set_render_defaults(scene)
    scene.render.resolution_x, scene.render.resolution_y = job.format.width, job.format.height
    scene.render.resolution_percentage = 100
    scene.render.fps = job.format.fps
    scene["scene_id"], scene[PACK] = pack.scene_id, pack.path
    scene["heading"] = next((o.heading for o in job.outline if o.scene_id == pack.scene_id), "")
    cameras, lights = _child(scene, "cameras"), _child(scene, "lights")
    lasting = [shot for shot in shots if (shot.scene_id, shot.shot_id) not in job.beside]
    light_scene(scene, lights, context, lasting, pack, files)
    hidden: dict[str, list[int]] = {}
    for shot in shots:
        start = pack.start_of(shot.shot_id)
        camera = make_camera(scene, cameras, shot, start)
        if shot not in lasting:
            continue
        marker = scene.timeline_markers.new(shot_name(shot.scene_id, shot.shot_id), frame=start)
        marker.camera = camera
        scene.camera = scene.camera or camera
        if shot.camera is not None:
            for node_id in shot.camera.hidden_node_ids:
                hidden.setdefault(node_id, []).append(shot.shot_id)
    for obj in scene.objects:
        away = [*hidden.get(str(obj.get("node_id", "")), ()), *hidden.get(str(obj.get(SECTION, "")), ())]
        if away:
            starts = [(shot.shot_id, pack.start_of(shot.shot_id)) for shot in lasting]
            shown = [(start, shot_id not in away and not is_hidden(obj, start)) for shot_id, start in starts]
            key_hidden(obj, shown)
    scene.frame_set(1)


def _child(scene: bpy.types.Scene, part: str) -> bpy.types.Collection:
    """Create and link a collection of a scene."""
    collection = bpy.data.collections.new(f"{scene.name}_{part}")
    scene.collection.children.link(collection)
    return collection
