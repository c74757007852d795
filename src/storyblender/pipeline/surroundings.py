"""Surfaces and skies of a place as pictures that the user's library or a catalogue has; else they stay as drawn."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

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

if TYPE_CHECKING:
    from storyblender.folder import Folder
    from storyblender.library.pictures import OfferedPicture, PictureKind

_Value = TypeVar("_Value", Texture, Panorama)


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
    return _taken(run, scene_id, "texture", wish, f"{surface} ({wish.phrase})", run.pictures.texture)


def _panorama(run: Run, wish: PictureWish | None, scene_id: int) -> Panorama | None:
    if wish is None or run.pictures is None:
        return None
    pictures = run.pictures

    def with_file(picture: OfferedPicture, files: Folder) -> tuple[Panorama, dict[str, bytes]] | None:
        taken = pictures.panorama(picture, files)
        return None if taken is None else (taken[0], {panorama_file(taken[0].provenance.digest): taken[1]})

    return _taken(run, scene_id, "panorama", wish, "light of the sky", with_file)


def _taken(
    run: Run,
    scene_id: int,
    kind: PictureKind,
    wish: PictureWish,
    purpose: str,
    take: Callable[[OfferedPicture, Folder], tuple[_Value, dict[str, bytes]] | None],
) -> _Value | None:
    """Return the best texture or panorama for a wish, its files written into the project; None where there is none.

    Args:
        run: What pictures there are.
        scene_id: The scene that it is for.
        kind: What is wanted.
        wish: What it shows.
        purpose: What it is for, as people are told.
        take: Reads an offered picture, with its files by name.
    """
    picture = run.pictures.best(kind, wish.phrase, wish.fits) if run.pictures is not None else None
    taken = take(picture, run.project.files) if picture is not None else None
    if picture is None or taken is None:
        return None
    value, files = taken
    for name, data in files.items():
        if not run.outputs.whole(name):
            run.outputs.write(name, data)
    _tell(run, scene_id, f"{purpose}: {picture.name} of {picture.place.partition('/')[0]}")
    return value


def _tell(run: Run, scene_id: int, message: str) -> None:
    run.tell(Event(kind="accept", role="environment_designer", subject=scene_name(scene_id), message=message))
