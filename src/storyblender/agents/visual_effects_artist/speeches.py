"""Speeches: how long words take, whom they are addressed to, and who looks where meanwhile."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence

from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.catalog.motions import MOTIONS
from storyblender.memory.outline import WORDS_PER_SECOND, ScriptLine
from storyblender.memory.shot_context import CharacterAction, Cue, ShotContext

SPOKEN = ("talk", "whisper", "shout")


class Speeches:
    """Writes the speeches of one shot.

    Args:
        stage: People and props.
        sheet: The cue sheet that takes the cues.
        calling: Asset ids of people on the phone; they address nobody nearby unless the script says so.
    """

    def __init__(self, stage: StageState, sheet: CueSheet, calling: Collection[str] = ()) -> None:
        self.stage, self.sheet, self.calling = stage, sheet, calling

    def speech_seconds(self, shot: ShotContext, lines: Sequence[ScriptLine]) -> dict[int, float]:
        """Return the length of each speech in seconds, by number of its action; shortened to fit into the shot.

        Args:
            shot: The shot.
            lines: Lines of the script that it covers.
        """
        spoken: dict[int, float] = {}
        for number, action in enumerate(shot.character_actions):
            if action.motion in SPOKEN:
                line = _line_of_action(action, lines)
                words = line.word_count if line else 0
                spoken[number] = max(1.2, words / WORDS_PER_SECOND + 0.4) if words else MOTIONS["talk"].seconds
        total = sum(spoken.values())
        fit = max(0.5, min(1.0, (1.15 * self.sheet.length - 0.4) / total)) if total else 1.0
        return {number: seconds * fit for number, seconds in spoken.items()}

    def add_speech(
        self,
        action: CharacterAction,
        person: StagedPerson,
        seconds: float,
        cast: Sequence[StagedPerson],
    ) -> None:
        """Write the cues of a speech, and of everybody else meanwhile.

        Args:
            action: The speech.
            person: The speaker.
            seconds: Its length.
            cast: Everybody on stage.
        """
        partner = self.stage.people.get(action.target_id or "")
        others = [p for p in cast if p is not person and p.posture != "asleep"]
        if partner is None or not partner.present or partner is person:
            nearest = min(others, key=lambda p: math.dist(p.place, person.place), default=None)
            partner = None if person.asset_id in self.calling else nearest
        walking = person.busy
        start = max(self.sheet.clock, walking - 0.8 if person.upright else walking)
        turned = walking
        if partner is not None and start >= walking:
            start = self.sheet.turn_to_person(person, partner, start)
        elif partner is not None and person.upright:  # the speech begins on the way: the speaker turns on arrival
            turned = self.sheet.turn_to_person(person, partner, walking)
        target = partner.asset_id if partner else None
        recorded = {"mocap": action.mocap.digest} if action.mocap is not None else {}
        end = self.sheet.add_cue(person, action.motion, start, seconds, target_id=target, mood=action.mood, **recorded)
        for listener in others:
            if listener.busy <= start + 0.3:
                if math.dist(listener.place, person.place) < 6:
                    self.sheet.turn_to_person(listener, person, start + 0.1)
                self.sheet.add_cue(listener, "listen", start + 0.15, seconds, target_id=person.asset_id)
            else:
                self.sheet.add_cue(listener, "look", max(start, listener.busy), 0.6, target_id=person.asset_id)
        person.acted = True
        person.busy = max(person.busy, turned, end)
        self.sheet.clock = end

    def add_idle_looks(self, shot: ShotContext, cast: Sequence[StagedPerson]) -> None:
        """Let everybody without a first cue look where the script says, else at the person who acts first.

        Args:
            shot: The shot with the states of people.
            cast: Everybody on stage.
        """
        looks: Mapping[str, str | None] = {state.asset_id: state.looking_at for state in shot.states}
        elsewhere = {state.asset_id for state in shot.states if state.gaze is not None}
        first = min(self.sheet.cues, key=lambda cue: cue.start, default=None)
        for person in cast:
            if (
                person.posture == "asleep"
                or person.asset_id in elsewhere
                or any(c.asset_id == person.asset_id and c.start < 12 for c in self.sheet.cues)
            ):
                continue
            wanted = looks.get(person.asset_id)
            thing = self.stage.floor.thing(wanted)
            target = (
                wanted if wanted in self.stage.people and self.stage.people[wanted].present else thing and thing.node_id
            )
            if target is None and first is not None and first.asset_id != person.asset_id:
                target = first.asset_id
            if target is not None and target != person.asset_id:
                self.sheet.cues.append(
                    Cue(asset_id=person.asset_id, clip="look", start=0, duration=12, target_id=target)
                )


def _line_of_action(action: CharacterAction, lines: Sequence[ScriptLine]) -> ScriptLine | None:
    """Return the line of the script that an action speaks; None if it has none."""
    index = action.line_index
    return lines[index] if index is not None and 0 <= index < len(lines) else None
