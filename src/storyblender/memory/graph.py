"""The Continuity Memory Graph: the four layers as one frozen value (paper, section 3.2)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from pydantic import Field

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Digest, Frozen, SceneId, is_none
from storyblender.memory.outline import SceneOutline
from storyblender.memory.paint import Paint
from storyblender.memory.panorama import Panorama
from storyblender.memory.picture_format import FormatDecision
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext
from storyblender.memory.texture import Texture
from storyblender.memory.vocabulary import Age

SCHEMA_VERSION = 8
"""Raised with every change of the stored models, with an upgrade in ``history_files.UPGRADES``."""

_T = TypeVar("_T")


class Storyboard(Frozen):
    """The Director's result (the paper's top-level schema): the skeleton of the graph."""

    story_summary: str
    storyboard_outline: tuple[SceneOutline, ...]
    asset_sheet: tuple[Asset, ...]
    scene_details: tuple[SceneContext, ...]
    shot_details: tuple[ShotContext, ...]
    age: Age | None = None


class ProjectFormat(Frozen):
    """What the whole project is made for; stored in the graph because frames depend on it."""

    fps: int = Field(default=24, ge=1, le=240)
    aspect: float = Field(default=16 / 9, ge=0.1, le=10)
    width: int = Field(default=960, ge=4, le=16_384)
    sensor_width: float = Field(default=36.0, ge=1, le=100)
    """mm."""
    seed: int = Field(default=0, ge=0, lt=2**63)

    @property
    def height(self) -> int:
        """Pixel rows of a frame: width / aspect, in fours: a board's light is a quarter the size."""
        return max(4, round(self.width / self.aspect / 4) * 4)


class ContinuityMemoryGraph(Frozen):
    """The single source of truth. Views (the .blend, frames, board, page) are compiled from it."""

    schema_version: int = SCHEMA_VERSION
    title: str = ""
    script_name: str = ""
    """File name of the script; a copy lies in the project folder."""
    edition: str = ""
    """Version and date of the script, as its title page has them."""
    plan_digest: Digest = ""
    """Hash of the script and of the settings the plan depends on: another hash, another plan."""
    settings_digest: Digest = ""
    """Hash of those settings alone."""
    format: ProjectFormat = ProjectFormat()
    format_decision: FormatDecision | None = Field(default=None, exclude_if=is_none)
    """What a person decided of ``format``; it stays whatever the settings are."""
    story_summary: str = ""
    age: Age | None = None
    """When the story plays, where its words tell it."""
    panorama: Panorama | None = Field(default=None, exclude_if=is_none)
    """The user's, that may light exteriors."""
    scene_order: tuple[SceneId, ...] = Field(default=(), exclude_if=lambda value: not value)
    """The order that a person gave the scenes in the film; empty for that of the script."""
    paints: tuple[Paint, ...] = Field(default=(), exclude_if=lambda value: not value)
    """What a person decided about materials."""
    outline: tuple[SceneOutline, ...] = ()
    assets: tuple[Asset, ...] = ()
    scenes: tuple[SceneContext, ...] = ()
    shots: tuple[ShotContext, ...] = ()

    def asset(self, asset_id: str) -> Asset:
        """Return the asset with that id. Raises KeyError."""
        return _find(self.assets, asset_id, "asset_id")

    def scene(self, scene_id: int) -> SceneContext:
        """Return the scene with that id. Raises KeyError."""
        return _find(self.scenes, scene_id, "scene_id")

    def assets_of(self, scene_id: int) -> tuple[Asset, ...]:
        """Return every asset that a scene shows: the script's and the dressing."""
        scene = self.scene(scene_id)
        placed = {item.asset_id for item in scene.layout.objects} if scene.layout else set[str]()
        wanted = placed | set(scene.setup.asset_ids)
        return tuple(asset for asset in self.assets if asset.asset_id in wanted)

    def own_objects_of(self, scene_id: int) -> tuple[Asset, ...]:
        """Return the objects of a scene that are the story's own, without its dressing."""
        own = {*self.scene(scene_id).setup.asset_ids}
        objects = (asset for asset in self.assets if asset.asset_type == "object" and asset.asset_id in own)
        return tuple(asset for asset in objects if asset.origin != "dressing")

    def shots_of(self, scene_id: int) -> tuple[ShotContext, ...]:
        """Return the shots of a scene in order."""
        return tuple(shot for shot in self.shots if shot.scene_id == scene_id)

    def shot(self, scene_id: int, shot_id: int) -> ShotContext:
        """Return one shot.

        Args:
            scene_id: Its scene.
            shot_id: Within the scene.

        Raises:
            KeyError: There is no such shot.
        """
        return _find(self.shots_of(scene_id), shot_id, "shot_id")

    def staged_shots_of(self, scene_id: int) -> tuple[ShotContext, ...]:
        """Return the shots of a scene that the crew stages, in order: those of the Director."""
        return tuple(shot for shot in self.shots_of(scene_id) if shot.covers is None)

    def shots_in_order(self, scene_id: int) -> tuple[ShotContext, ...]:
        """Return the shots of a scene in the order of the film, with those that are omitted in their places."""
        shots = {shot.shot_id: shot for shot in self.shots_of(scene_id) if not shot.joined}
        return tuple(shots[shot_id] for shot_id in in_order(tuple(shots), self.scene(scene_id).shot_order))

    @property
    def scenes_in_order(self) -> tuple[SceneContext, ...]:
        """The scenes in the order of the film, with those that are omitted in their places."""
        scenes = {scene.scene_id: scene for scene in self.scenes}
        return tuple(scenes[scene_id] for scene_id in in_order(tuple(scenes), self.scene_order))

    @property
    def panoramas(self) -> tuple[Panorama, ...]:
        """The story's panorama, and those that a person or the crew chose for a scene; each once."""
        chosen = (scene.light_decision.panorama for scene in self.scenes if scene.light_decision is not None)
        offered = (scene.offered_panorama for scene in self.scenes)
        found = [self.panorama, *(each for each in chosen if each != "none"), *offered]
        return tuple({each.provenance.digest: each for each in found if each is not None}.values())

    @property
    def textures(self) -> tuple[Texture, ...]:
        """The pictures that sets are made of; each once."""
        found = (each for scene in self.scenes if scene.environment is not None for each in scene.environment.textures)
        return tuple({each.provenance.digest: each for each in found}.values())

    @property
    def cut(self) -> tuple[ShotContext, ...]:
        """The shots of the film, in its order."""
        edited = any(scene.omitted or scene.shot_order for scene in self.scenes)
        if not self.scene_order and not edited:
            return tuple(shot for shot in self.shots if not shot.omitted and not shot.joined)
        scenes = (scene for scene in self.scenes_in_order if not scene.omitted)
        return tuple(shot for scene in scenes for shot in self.shots_in_order(scene.scene_id) if not shot.omitted)

    def outline_of(self, scene_id: int) -> SceneOutline | None:
        """Return the words of a scene, if the outline has it."""
        return next((outline for outline in self.outline if outline.scene_id == scene_id), None)

    def people_in(self, scene_id: int) -> int:
        """Return how many characters are on stage at once in a scene, at most."""
        return max((len(shot.on_stage) for shot in self.shots_of(scene_id)), default=0)


def in_order(known: Sequence[int], wanted: Sequence[int]) -> tuple[int, ...]:
    """Return ids in the order that a person gave them; one that they did not know follows the one before it.

    Args:
        known: All ids, in the order of the script.
        wanted: Ids in the order of the film; may be empty, and may hold ids that are gone.
    """
    there = set(known)
    result = [each for each in wanted if each in there]
    if not result:
        return tuple(known)
    placed = set(result)
    for index, each in enumerate(known):
        if each not in placed:
            result.insert(result.index(known[index - 1]) + 1 if index else 0, each)
            placed.add(each)
    return tuple(result)


def _find(items: tuple[_T, ...], wanted: object, field: str) -> _T:
    for item in items:
        if getattr(item, field) == wanted:
            return item
    raise KeyError(wanted)
