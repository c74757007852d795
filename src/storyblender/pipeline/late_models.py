"""Models that an earlier run had begun at a service and did not wait for are taken by the next ``make``."""

from __future__ import annotations

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.scene_context import SceneContext
from storyblender.pipeline.materializing import workshop_of
from storyblender.pipeline.run import Run
from storyblender.trace import Event


def take_late_models(run: Run) -> None:
    """Give things that something stands in for the models that are done by now; their scenes are to be staged anew.

    Args:
        run: Of a planned project; ``materialize`` then builds what was taken.
    """
    if run.services is None or run.settings.licences == "free":
        return
    waiting = [asset for asset in run.graph.assets if _waits(run, asset)]
    workshop = workshop_of(run) if waiting else None
    if workshop is None:
        return
    found = [made for asset in waiting if (made := workshop.made_meanwhile(asset)) is not None]
    for asset in found:
        name = asset.name or asset.asset_id
        message = f"the {name}, which was begun in an earlier run, is made now"
        run.tell(Event(kind="accept", role="asset_generator", subject=asset.asset_id, message=message))
    if found:
        taken = {asset.asset_id for asset in found}
        scenes = [_staged_again(scene) for scene in run.graph.scenes if taken & _shown(run, scene)]
        fresh = [asset.model_copy(update={"dimension": None}) for asset in found]
        run.commit("asset_generator", "models that an earlier run had begun", *fresh, *scenes)


def _waits(run: Run, asset: Asset) -> bool:
    """Return whether something stands in for a thing that may be made, and neither it nor its place is locked."""
    if not asset.image_prompt or asset.canonical is None or asset.locked or asset.decision is not None:
        return False
    scenes = [scene for scene in run.graph.scenes if asset.asset_id in _shown(run, scene)]
    shots = [shot for scene in scenes for shot in run.graph.shots_of(scene.scene_id)]
    return not any("layout" in scene.locked for scene in scenes) and not any(
        "blocking" in each.locked for each in shots
    )


def _shown(run: Run, scene: SceneContext) -> set[str]:
    return {asset.asset_id for asset in run.graph.assets_of(scene.scene_id)}


def _staged_again(scene: SceneContext) -> SceneContext:
    if scene.lighting is None:
        return scene
    return scene.model_copy(update={"stale": tuple(dict.fromkeys((*scene.stale, "layout")))})
