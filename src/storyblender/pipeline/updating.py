"""A project is brought up to date before a call on it: its assets, what an edit made stale, its packs; or one scene."""

from __future__ import annotations

from storyblender.pipeline.asset_files import assets_to_build
from storyblender.pipeline.packing import pack_scenes
from storyblender.pipeline.panorama import keep_panoramas
from storyblender.pipeline.run import Run
from storyblender.pipeline.textures import keep_textures
from storyblender.settings import REMEMBERED
from storyblender.trace import Event


def bring_up_to_date(run: Run) -> None:
    """Restore missing assets, make anew what an edit made stale, and build the packs.

    Args:
        run: Of a made project.
    """
    folder = run.project.folder
    staged = any(scene.lighting is not None for scene in run.graph.scenes)
    if staged and not (folder / REMEMBERED).exists():
        message = f"{REMEMBERED} is missing; look, width and lenses are the defaults"
        run.tell(Event(kind="warning", role="project", subject=folder.name, message=message))
    keep_panoramas(run)
    keep_textures(run)
    if assets_to_build(run, run.graph.assets):
        from storyblender.pipeline.materializing import materialize

        materialize(run)
    if any(item.stale for item in (*run.graph.scenes, *run.graph.shots)):
        from storyblender.pipeline.restaging import make_stale_anew

        make_stale_anew(run)
    pack_scenes(run)


def bring_scene_up_to_date(run: Run, scene_id: int) -> None:
    """Restore missing assets of one scene, and make anew what an edit made stale of it; it is not packed.

    Args:
        run: Of a made project.
        scene_id: The scene; the others are not looked at, however many they are.
    """
    if missing := assets_to_build(run, run.graph.assets_of(scene_id)):
        from storyblender.pipeline.materializing import materialize

        materialize(run, missing)
    if any(item.stale for item in (run.graph.scene(scene_id), *run.graph.shots_of(scene_id))):
        from storyblender.pipeline.restaging import make_stale_anew

        make_stale_anew(run, {scene_id})
