"""The Frame Critic's view of a finished frame: its part of the graph, and the measurements of its picture."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from storyblender.agents.layout_artist.story_moment import board_frame, cue_span, cues_of
from storyblender.agents.visual_effects_artist.motions_by_hand import is_left_out
from storyblender.catalog.motions import MOTIONS
from storyblender.look.picture_measure import PictureMeasure
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.jobs import PlayedCue
from storyblender.memory.measure import CameraView, SubjectView
from storyblender.memory.shot_context import CharacterAction, Flaw, ShotContext

_WAITING = ("idle", "stand", "listen")
"""Motions that do not have to be visible."""
_SPEAKING = ("talk", "whisper", "shout", "sing")
_LOOKING = ("look", "look_up", "look_down", "look_back", "look_left", "look_right", "look_away", "look_around")
"""Motions of head and eyes, which any frame of a shot may show."""
_HOLDING = ("hold", "take", "pick_up", "catch")
"""Motions that a thing in the hand shows as well."""


@dataclass(frozen=True)
class FrameView:
    """One finished frame.

    Attributes:
        shot: The shot as drawn.
        seen: Measurements of the ID mask at the story moment.
        people: node_ids of all characters with a face.
        picture: Measurements of the pixels; None if the frame is not drawn yet.
        assets: Assets of the whole story by asset id.
        nodes: node_ids that show each asset in the scene, by asset id.
        staged: Flaws of the staging in the shot.
        built: Asset ids of things that the set itself shows, such as its own pool.
        aspect: Width of the picture over its height.
        played: The cues of the shot as the engine played them.
    """

    shot: ShotContext
    seen: CameraView
    people: frozenset[str]
    picture: PictureMeasure | None
    assets: Mapping[str, Asset]
    nodes: Mapping[str, tuple[str, ...]]
    staged: tuple[Flaw, ...] = ()
    built: frozenset[str] = frozenset()
    aspect: float = 16 / 9
    played: tuple[PlayedCue, ...] = ()

    @property
    def subjects(self) -> dict[str, SubjectView]:
        """The measured subjects by node_id."""
        return {subject.node_id: subject for subject in self.seen.subjects}

    def subject(self, asset_id: str) -> SubjectView | None:
        """Return the largest visible node that shows an asset; None if the mask has none."""
        subjects = self.subjects
        shown = [subjects[node] for node in self.nodes.get(asset_id, (asset_id,)) if node in subjects]
        return max(shown, key=lambda subject: subject.pixels, default=None)


def actions_to_see(shot: ShotContext) -> list[CharacterAction]:
    """Return the actions of a shot that must be visible: neither waiting nor talk."""
    decided = shot.blocking_decision.people if shot.blocking_decision is not None else {}
    return [
        action
        for action in shot.character_actions
        if action.motion not in (*_WAITING, *_SPEAKING) and not is_left_out(action, decided)
    ]


def actions_not_shown(shot: ShotContext, played: Sequence[PlayedCue] = ()) -> list[CharacterAction]:
    """Return the actions in the lines that nobody does at the story moment; members of a group count once.

    Looks do not count, nor taking a thing that is in the hand already, nor the walk to a place of another action, nor a
    posture that is already taken.

    Args:
        shot: The shot with its cues.
        played: The cues as the engine played them; may be empty.
    """
    moment = board_frame(shot, played)
    held = {(state.asset_id, prop) for state in shot.states for prop in state.held}
    missed: dict[tuple[str, str], CharacterAction] = {}
    shown: set[tuple[str, str]] = set()
    doing: set[str] = set()
    for action in actions_to_see(shot):
        if action.motion in _LOOKING or (action.motion in _HOLDING and (action.asset_id, action.prop_id) in held):
            continue
        deed = (action.motion, action.action_description)
        for cue in cues_of(action, shot):
            start, length = cue_span(cue, shot, played)
            stays = cue.lasting or MOTIONS[cue.clip].after not in (None, "stand")
            if start <= moment and (stays or moment <= start + length):
                shown.add(deed)
                doing.add(action.asset_id)
        missed.setdefault(deed, action)
    undone = [action for deed, action in missed.items() if deed not in shown]
    return [each for each in undone if MOTIONS[each.motion].speed is None or each.asset_id not in doing]


def speakers(shot: ShotContext) -> list[str]:
    """Return the asset ids of people who speak in a shot."""
    said = (action.asset_id for action in shot.character_actions if action.motion in _SPEAKING)
    return list(dict.fromkeys(said))


def things_to_see(shot: ShotContext) -> list[str]:
    """Return the asset ids of the things that the actions of a shot use or its instruction names."""
    used = (id_ for action in actions_to_see(shot) for id_ in (action.prop_id, action.target_id))
    return _each_once([*used, *shot.camera_instruction.focus_on_ids], without=set(shot.on_stage))


def _each_once(ids: Iterable[str | None], without: set[str]) -> list[str]:
    """Return the ids in order, each once, but for those in ``without``."""
    return [id_ for id_ in dict.fromkeys(ids) if id_ and id_ not in without]
