"""Surfaces and skies of a place as pictures that the user's library or a catalogue has; else they stay as drawn."""

from __future__ import annotations

from storyblender.agents.visual_effects_artist.surroundings import PictureWish, ground_wish, sky_wish, wall_wish
from storyblender.catalog.sets import plan_of
from storyblender.memory.base import scene_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.panorama import Panorama, panorama_file
from storyblender.memory.scene_context import Environment, SceneContext
from storyblender.memory.scene_decision import SetDecision
from storyblender.memory.texture import Texture
from storyblender.pipeline.run import Run
from storyblender.trace import Event


def with_pictured_surfaces(
    run: Run, graph: ContinuityMemoryGraph, scene_id: int, environment: Environment
) -> Environment:
    """Return a set with pictures on undecided walls and ground; a place that has its set keeps them.

    Args:
        run: What pictures there are.
        graph: The story.
        scene_id: A scene in the place.
        environment: Its set, as it was designed and decided.
    """
    if run.pictures is None:
        return environment
    scene = graph.scene(scene_id)
    decided, earlier = scene.set_decision or SetDecision(), scene.setup.reference_scene_id
    first = graph.scene(earlier).environment if earlier is not None else None
    plan, update = plan_of(environment), dict[str, Texture | None]()
    snowed = first is not None and first.params.get("snow") != environment.params.get("snow")
    if decided.walls is None and decided.wall_texture is None and first is None:
        update["wall_texture"] = _texture(run, wall_wish(plan), scene_id, "walls")
    if decided.ground is None and decided.ground_texture is None and (first is None or snowed):
        update["ground_texture"] = _texture(run, ground_wish(plan), scene_id, "ground")
    return environment.model_copy(update=update) if update else environment


def with_offered_panorama(run: Run, scene: SceneContext) -> SceneContext:
    """Return a scene with the panorama that the Lighting Arranger may light it by; scenes alike share it.

    Args:
        run: What panoramas there are, and the other scenes.
        scene: With its set.
    """
    if run.pictures is None or run.graph.panorama is not None or scene.environment is None:
        return scene
    if scene.light_decision is not None and scene.light_decision.panorama is not None:
        return scene
    setup = scene.decided_setup
    wish = sky_wish(setup, plan_of(scene.environment))
    alike = (each for each in run.graph.scenes if each.offered_panorama is not None and each != scene)
    told = setup.place, setup.time_of_day, setup.weather
    same = next((each for each in alike if _said(each) == told), None)
    found = same.offered_panorama if same is not None else _panorama(run, wish, scene.scene_id)
    return scene.model_copy(update={"offered_panorama": found if wish is not None else None})


def _said(scene: SceneContext) -> tuple[str, ...]:
    setup = scene.decided_setup
    return setup.place, setup.time_of_day, setup.weather


def _texture(run: Run, wish: PictureWish | None, scene_id: int, surface: str) -> Texture | None:
    if wish is None or run.pictures is None:
        return None
    picture = run.pictures.best("texture", wish.phrase, wish.fits)
    taken = run.pictures.texture(picture, run.project.files) if picture is not None else None
    if picture is None or taken is None:
        return None
    texture, pictures = taken
    for name, data in pictures.items():
        if not run.outputs.whole(name):
            run.outputs.write(name, data)
    _tell(run, scene_id, f"{surface} ({wish.phrase}): {picture.name} of {picture.place.partition('/')[0]}")
    return texture


def _panorama(run: Run, wish: PictureWish | None, scene_id: int) -> Panorama | None:
    if wish is None or run.pictures is None:
        return None
    picture = run.pictures.best("panorama", wish.phrase, wish.fits)
    taken = run.pictures.panorama(picture, run.project.files) if picture is not None else None
    if picture is None or taken is None:
        return None
    panorama, data = taken
    if not run.outputs.whole(name := panorama_file(panorama.provenance.digest)):
        run.outputs.write(name, data)
    _tell(run, scene_id, f"light of the sky: {picture.name} of {picture.place.partition('/')[0]}")
    return panorama


def _tell(run: Run, scene_id: int, message: str) -> None:
    run.tell(Event(kind="accept", role="environment_designer", subject=scene_name(scene_id), message=message))
