"""Whether the frame of a shot shows it as it is: looked up, with nothing made or drawn to find out."""

from __future__ import annotations

from storyblender.memory.base import shot_name
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.asset_files import assets_to_build
from storyblender.pipeline.hand_motions import with_hand_motions
from storyblender.pipeline.packing import known_pack, scene_job, with_coverage
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import frame_picture


def is_drawn(run: Run, shot: ShotContext) -> bool:
    """Return whether the frame of a shot was drawn of the shot as it is; an artist may have painted on it since.

    Args:
        run: On the project; of its engine nothing is asked.
        shot: Of its story.
    """
    graph, scene_id = run.graph, shot.scene_id
    scene = graph.scene(scene_id)
    if shot.camera is None or scene.layout is None or any(item.stale for item in (scene, *graph.shots_of(scene_id))):
        return False
    if assets_to_build(run, graph.assets_of(scene_id)):
        return False
    pack = known_pack(run, with_hand_motions(run, scene_job(graph, scene_id)))
    if pack is None:
        return False
    run.packs[scene_id] = with_coverage(graph, pack)
    picture = frame_picture(run, shot)
    name = f"frames/{shot_name(scene_id, shot.shot_id)}.png"
    drawn = run.outputs.whole(picture) and run.outputs.digest(name) == run.outputs.digest(picture)
    return drawn and run.project.path(name).is_file()
