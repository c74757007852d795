"""What the Frame Critic knows of one finished frame: its projection of the graph, and what was measured of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from storyblender.catalog.motions import clip_of
from storyblender.look.picture_measure import PictureMeasure
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.measure import CameraView, Collision, SubjectView
from storyblender.memory.shot_context import CharacterAction, Flaw, ShotContext

_WAITING = ("idle", "listen")
"""Motions of people who do nothing that has to be seen."""
_SPEAKING = ("talk", "whisper", "shout", "sing")


@dataclass(frozen=True)
class FrameView:
    """One frame.

    Attributes:
        shot: As it was drawn.
        seen: The ID mask at the moment that is drawn.
        people: node_ids of everybody with a face.
        picture: Measures of the pixels.
        assets: By asset id, of the whole story.
        nodes: asset id to the node_ids that show it in the scene.
        staged: What could not be staged in the shot.
        collisions: People inside things or each other in the shot.
        built: Assets that no object shows because the set itself does, as its own pool.
    """

    shot: ShotContext
    seen: CameraView
    people: frozenset[str]
    picture: PictureMeasure
    assets: Mapping[str, Asset]
    nodes: Mapping[str, tuple[str, ...]]
    staged: tuple[Flaw, ...] = ()
    collisions: tuple[Collision, ...] = ()
    built: frozenset[str] = frozenset()

    @property
    def subjects(self) -> dict[str, SubjectView]:
        """What was measured, by node id."""
        return {subject.node_id: subject for subject in self.seen.subjects}

    def subject(self, asset_id: str) -> SubjectView | None:
        """Return the best seen of the nodes that show an asset; None where none is in the mask."""
        subjects = self.subjects
        shown = [subjects[node] for node in self.nodes.get(asset_id, (asset_id,)) if node in subjects]
        return max(shown, key=lambda subject: subject.pixels, default=None)


def actions_to_see(shot: ShotContext) -> list[CharacterAction]:
    """Return what people do in a shot and has to be seen: neither waiting nor mere talk."""
    return [action for action in shot.character_actions if clip_of(action.motion).key not in (*_WAITING, *_SPEAKING)]


def speakers(shot: ShotContext) -> list[str]:
    """Return who is heard and on stage in a shot."""
    said = (action.asset_id for action in shot.character_actions if action.motion in _SPEAKING)
    return list(dict.fromkeys(said))


def things_to_see(shot: ShotContext) -> list[str]:
    """Return the asset ids of the things that a shot's actions are done with or to, and of those in the hands."""
    used = (id_ for action in actions_to_see(shot) for id_ in (action.prop_id, action.target_id))
    return _each_once([*used, *shot.camera_instruction.focus_on_ids], without=set(shot.on_stage))


def _each_once(ids: Iterable[str | None], without: set[str]) -> list[str]:
    return [id_ for id_ in dict.fromkeys(ids) if id_ and id_ not in without]
