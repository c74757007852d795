"""Bearing of people during their actions: facial expression, gaze, and lasting activities. Pure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from storyblender.agents.visual_effects_artist.company import Company
from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.person import Person
from storyblender.catalog.motions import MOTIONS, clip_of
from storyblender.memory.base import content_hash
from storyblender.memory.shot_context import BodyState, Cue, Mark, ShotContext
from storyblender.memory.vocabulary import GazeDirection, Hand

QUIET = frozenset({"talk", "whisper", "shout", "listen", "look", "idle", "face", "nod", "shake_head", "laugh"})
"""Motions that leave the hands free."""
ATTENDING = frozenset({"listen", "look", "idle", "face", "turn", "laugh"})
"""Motions of who has no deed in a shot and says nothing."""
MANNERS: Mapping[str, tuple[str, ...]] = {
    "angry": ("hands_on_hips", "cross_arms"),
    "rage": ("hands_on_hips",),
    "suspicious": ("cross_arms", "hands_on_hips"),
    "afraid": ("wring_hands", "hug_self"),
    "terrified": ("heart",),
    "surprised": ("cover_mouth", ""),
    "thoughtful": ("think",),
    "cry": ("cry",),
}
"""Expression -> what empty hands do meanwhile, as it is somebody's habit; an empty name leaves them as they are."""
SEATED: Mapping[str, str] = {"hands_on_hips": "cross_arms"}
"""What who sits does instead."""
CARRIED_ON = frozenset({"phone", "drive", "row"})
"""Activities that speech does not end: they continue in the next shot."""
SIDES: tuple[Hand, ...] = ("R", "L")
GLANCE = 12
"""Frames of a glance."""
FAR, BEFORE = 6.0, 1.8
"""Metres: how far to the side something off screen is, and how much nearer to the audience."""
EYES = {"up": 3.2, "down": 0.1}
"""Metres above the floor of a point looked up or down at; other points are at eye height."""
EYE_LEVEL = 1.55


class Bearing:
    """Writes the cues of expressions, gaze and lasting activities, in addition to the actions of a shot.

    Args:
        company: The people and props of the scene.
        sheet: The cue sheet that takes the cues.
    """

    def __init__(self, company: Company, sheet: CueSheet) -> None:
        self.company, self.sheet = company, sheet

    def bear(self, shot: ShotContext) -> None:
        """Add the bearing of everyone on stage, before their actions."""
        cues: list[Cue] = []
        for state in shot.states:
            person = self.company.people.get(state.asset_id)
            if person is not None and person.present:
                cues += self._cues(person, state)
        self.sheet.cues[:0] = cues

    def _cues(self, person: Person, state: BodyState) -> list[Cue]:
        found: list[Cue] = []
        if state.expression != "neutral":
            found.append(Cue(asset_id=person.asset_id, clip="face", start=0, expression=state.expression))
        if state.gaze == "closed":
            found.append(Cue(asset_id=person.asset_id, clip="close_eyes", start=0, lasting=True))
        elif state.gaze is not None:
            there = self._off_screen(person, state.gaze)
            found.append(Cue(asset_id=person.asset_id, clip="look", start=0, duration=GLANCE, mark=there))
        activity = self._activity(person, state)
        if activity:
            found.append(self._going_on(person, state, activity))
        elif manner := self._manner(person, state):
            found.append(Cue(asset_id=person.asset_id, clip=manner, start=0, lasting=True))
        return found

    def _manner(self, person: Person, state: BodyState) -> str:
        """Return what the hands of somebody without a deed say of their mood; empty where they hold something."""
        busy = any(cue.asset_id == person.asset_id and cue.clip not in ATTENDING for cue in self.sheet.cues)
        habits = MANNERS.get(state.expression, ())
        if busy or not habits or person.held or person.posture not in ("stand", "sit"):
            return ""
        habit = habits[int(content_hash(person.asset_id), 16) % len(habits)]
        return SEATED.get(habit, habit) if person.posture == "sit" else habit

    def _off_screen(self, person: Person, gaze: GazeDirection) -> Mark:
        """Return the point of a person's gaze, in left and right as the audience sees it."""
        x, y = person.place
        aside = {"left": -FAR, "right": FAR}.get(gaze, 0.0)
        height = EYES.get(gaze, EYE_LEVEL * person.scale)
        ahead = FAR if gaze == "camera" else BEFORE
        return Mark(asset_id=person.asset_id, location=(round(x + aside, 3), round(y - ahead, 3), height), yaw=0.0)

    def _activity(self, person: Person, state: BodyState) -> str:
        """Return the clip of a person's lasting activity; empty if their own actions are or end it."""
        if state.activity or person.told:
            person.activity = state.activity
        person.told = state.activity
        clip = clip_of(person.activity).key if person.activity else ""
        own = [cue.clip for cue in self.sheet.cues if cue.asset_id == person.asset_id]
        if not clip or clip in own or clip == "idle" or MOTIONS[clip].speed is not None:
            return ""
        return clip

    def _going_on(self, person: Person, state: BodyState, clip: str) -> Cue:
        """Return the cue of a lasting activity, with its prop in hand and its place."""
        motion = MOTIONS[clip]
        hand: Hand | None = next((side for side in SIDES if side in person.held), None)
        prop = person.held[hand] if hand is not None else None
        place = state.spot.anchor_id if state.spot is not None else None
        thing = self.company.floor.thing(place or state.support_id) if motion.reach == "thing" else None
        return Cue(
            asset_id=person.asset_id,
            clip=clip,
            start=0,
            target_id=thing.node_id if thing is not None else None,
            prop_id=prop if motion.hands else None,
            hand=hand if motion.hands else None,
            lasting=True,
        )


def lasting(cues: Sequence[Cue], frames: int) -> list[Cue]:
    """Return the cues of a shot; a lasting cue continues until another cue needs the same person's hands.

    Args:
        cues: The cues in the order they were written.
        frames: Length of the shot in frames.
    """
    return [_kept_up(cue, cues, frames) for cue in cues]


def _kept_up(cue: Cue, cues: Sequence[Cue], frames: int) -> Cue:
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
