"""Cues of facial expressions, gazes, idle hands and lasting activities, in addition to the actions of a shot. Pure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.catalog.motions import MOTIONS, STANDING
from storyblender.memory.base import content_hash
from storyblender.memory.shot_context import BodyState, Cue, Mark, ShotContext
from storyblender.memory.vocabulary import GazeDirection, Hand

QUIET = frozenset({"talk", "whisper", "shout", "listen", "look", "idle", "face", "nod", "shake_head", "laugh"})
"""Motions that leave the hands free."""
ATTENDING = frozenset({"listen", "look", "idle", "face", "turn", "laugh"})
"""Motions of a person who has no action in a shot and does not speak."""
IDLE_HAND_MOTIONS: Mapping[str, tuple[str, ...]] = {
    "angry": ("hands_on_hips", "cross_arms"),
    "rage": ("hands_on_hips",),
    "suspicious": ("cross_arms", "hands_on_hips"),
    "afraid": ("wring_hands", "hug_self"),
    "terrified": ("heart",),
    "surprised": ("cover_mouth", ""),
    "thoughtful": ("think",),
    "cry": ("cry",),
}
"""Expression -> motions of empty hands; each person always uses the same one. An empty key leaves the hands still."""
SEATED_HAND_MOTIONS: Mapping[str, str] = {"hands_on_hips": "cross_arms"}
"""Motion of empty hands -> the motion that replaces it for a seated person."""
HANDS: tuple[Hand, ...] = ("R", "L")
GLANCE_FRAMES = 12
"""Length of a glance, frames."""
OFF_SCREEN_DISTANCE = 6.0
"""Metres from a person to the point they look at off screen, to the left or right or at the camera."""
OFF_SCREEN_FORWARD = 1.8
"""Metres by which that point is nearer to the audience, unless it is the camera."""
GAZE_HEIGHTS = {"up": 3.2, "down": 0.1}
"""Gaze -> height of the point looked at, metres above the floor; other points are at eye level."""
EYE_LEVEL = 1.55
"""Eye level above the floor of a person of 1.7 m, metres."""


class PostureCues:
    """Adds the cues of expressions, gazes, idle hands and lasting activities to the cue sheet of a shot.

    Args:
        stage: The people and props of the scene.
        sheet: The cue sheet that takes the cues.
    """

    def __init__(self, stage: StageState, sheet: CueSheet) -> None:
        self.stage, self.sheet = stage, sheet

    def add_posture_cues(self, shot: ShotContext) -> None:
        """Put the cues of everybody on stage before the cues of their actions."""
        cues: list[Cue] = []
        for state in shot.states:
            person = self.stage.people.get(state.asset_id)
            if person is not None and person.present:
                cues += self._cues(person, state)
        self.sheet.cues[:0] = cues

    def _cues(self, person: StagedPerson, state: BodyState) -> list[Cue]:
        """Return a person's cues from frame 0 on, as their state at the start of the shot asks for them."""
        found: list[Cue] = []
        if state.expression != "neutral":
            found.append(Cue(asset_id=person.asset_id, clip="face", start=0, expression=state.expression))
        if state.gaze == "closed":
            found.append(Cue(asset_id=person.asset_id, clip="close_eyes", start=0, lasting=True))
        elif state.gaze is not None:
            there = gaze_mark(person, state.gaze)
            found.append(Cue(asset_id=person.asset_id, clip="look", start=0, duration=GLANCE_FRAMES, mark=there))
        activity = self._lasting_activity(person, state)
        if activity:
            found.append(self._activity_cue(person, state, activity))
        elif motion := self._idle_hand_motion(person, state):
            found.append(Cue(asset_id=person.asset_id, clip=motion, start=0, lasting=True))
        return found

    def _idle_hand_motion(self, person: StagedPerson, state: BodyState) -> str:
        """Return the key of the motion that shows the mood in a person's hands; empty if they act or hold something."""
        busy = any(cue.asset_id == person.asset_id and cue.clip not in ATTENDING for cue in self.sheet.cues)
        habits = IDLE_HAND_MOTIONS.get(state.expression, ())
        if busy or not habits or person.held or person.posture not in ("stand", "sit"):
            return ""
        habit = habits[int(content_hash(person.asset_id), 16) % len(habits)]
        return SEATED_HAND_MOTIONS.get(habit, habit) if person.posture == "sit" else habit

    def _lasting_activity(self, person: StagedPerson, state: BodyState) -> str:
        """Return the key of a person's lasting activity; empty if none, or if their actions contain or end it."""
        if state.activity or person.scripted_activity:
            person.activity = state.activity
        person.scripted_activity = state.activity
        clip = person.activity
        own = [cue.clip for cue in self.sheet.cues if cue.asset_id == person.asset_id]
        if not clip or clip in own or clip in STANDING or MOTIONS[clip].speed is not None:
            return ""
        return clip

    def _activity_cue(self, person: StagedPerson, state: BodyState, clip: str) -> Cue:
        """Return the cue of a lasting activity ``clip``, with the prop in hand and the furniture it is done at."""
        motion = MOTIONS[clip]
        hand: Hand | None = next((side for side in HANDS if side in person.held), None)
        prop = person.held[hand] if hand is not None else None
        place = state.spot.anchor_id if state.spot is not None else None
        thing = self.stage.floor.thing(place or state.support_id) if motion.reach == "thing" else None
        return Cue(
            asset_id=person.asset_id,
            clip=clip,
            start=0,
            target_id=thing.node_id if thing is not None else None,
            prop_id=prop if motion.hands else None,
            hand=hand if motion.hands else None,
            lasting=True,
        )


def gaze_mark(person: StagedPerson, gaze: GazeDirection) -> Mark:
    """Return a mark on the point off screen that a person looks at, left and right as the audience sees them.

    Args:
        person: The person.
        gaze: The direction; not ``closed``.
    """
    x, y = person.place
    aside = {"left": -OFF_SCREEN_DISTANCE, "right": OFF_SCREEN_DISTANCE}.get(gaze, 0.0)
    height = GAZE_HEIGHTS.get(gaze, EYE_LEVEL * person.scale)
    ahead = OFF_SCREEN_DISTANCE if gaze == "camera" else OFF_SCREEN_FORWARD
    return Mark(asset_id=person.asset_id, location=(round(x + aside, 3), round(y - ahead, 3), height), yaw=0.0)


def extend_lasting_cues(cues: Sequence[Cue], frames: int) -> list[Cue]:
    """Return the cues of a shot; cues of lasting motions go on until another cue needs the same person's hands.

    Args:
        cues: The cues in the order they were written.
        frames: Length of the shot in frames.
    """
    return [_extend_cue(cue, cues, frames) for cue in cues]


def _extend_cue(cue: Cue, cues: Sequence[Cue], frames: int) -> Cue:
    """Return a cue, extended to the next of ``cues`` that needs the person's hands, or past the end at ``frames``."""
    if cue.lasting or not MOTIONS[cue.clip].lasts or cue.start >= frames:
        return cue
    later = [
        other.start
        for other in cues
        if other.asset_id == cue.asset_id and other.start > cue.start and other.clip not in QUIET and not other.lasting
    ]
    if later:
        return cue.model_copy(update={"duration": max(cue.duration or 1, min(later) - cue.start)})
    return cue.model_copy(update={"duration": None, "lasting": True})
