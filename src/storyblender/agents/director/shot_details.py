"""The shots of a scene as the graph keeps them: bodies, actions, changes and the camera of each."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Sequence
from typing import Any

from storyblender.agents.director.action_words import with_facts
from storyblender.agents.director.apertures import aperture_of
from storyblender.agents.director.camera_phrases import from_behind
from storyblender.agents.director.draft import Beat, ShotDraft
from storyblender.agents.director.durations import frame_count, shot_seconds
from storyblender.agents.director.feelings import mood_of
from storyblender.agents.director.fine_motions import UNREAD, fine_motion
from storyblender.agents.director.lighting import light_change, opening_light
from storyblender.agents.director.motion_families import GETTING, SPOKEN, TRAVEL
from storyblender.agents.director.reading import Deed, Unit
from storyblender.agents.director.scene_continuity import LIGHT, absent_until_brought
from storyblender.agents.director.staging import Staging
from storyblender.agents.director.story_assets import StoryAssets, unique
from storyblender.agents.director.wording import deed_words, one_line
from storyblender.catalog.motions import MOTION_KEYS
from storyblender.catalog.sets import SETS
from storyblender.memory.scene_context import SceneContext, Spot
from storyblender.memory.shot_context import (
    AssetModification,
    CameraInstruction,
    CharacterAction,
    Flag,
    ShotContext,
    Tether,
)
from storyblender.memory.shot_sizes import TIGHT
from storyblender.memory.thing_states import state_values

_OUT_OF = (
    r"(?:draws?|drew|produces?d?|fish(?:es|ed)?)\b|(?:pulls?|pulled|takes?|took)\b.*\b(?:out"
    r"|from (?:his|her|their|a|the) \w*\s?(?:jacket|coat|pocket|bag|purse|sleeve|belt|satchel))\b"
)
_UNSTAGED = ("intercut", "split_screen", "match_cut")
"""Sizes that hold one face."""
_SHOWS_FACES = ("action", "single", "reaction", "group", "two_shot")
"""Kinds of shots that turn to the faces of their people unless the script shows them from behind."""
_F_NUMBER_OF = {"shallow": 1.4, "deep": 32.0}
"""f-number of what a script says of the focus."""
_POV_LENS = 35.0
"""mm: about what an eye takes in."""


class ScriptFlags:
    """Finds the flags of the reader by their place in the script.

    Args:
        flags: As the reader raised them; they are found in this order.
    """

    def __init__(self, flags: Sequence[Flag]) -> None:
        self._flags = flags
        self._order = sorted(range(len(flags)), key=lambda index: flags[index].start)
        self._starts = [flags[index].start for index in self._order]

    def of(self, units: Sequence[Unit]) -> list[Flag]:
        """Return the flags that were raised about the words of some units."""
        found: set[int] = set()
        for unit in units:
            first = bisect_left(self._starts, unit.start)
            found.update(self._order[first : bisect_left(self._starts, max(unit.end, unit.start + 1))])
        return [self._flags[index] for index in sorted(found)]


class ShotDetails:
    """Writes the shots of one scene, in order.

    Args:
        text: The script.
        company: Who and what is on the sheet.
        scene: The scene, with its set kit.
        units: Its units.
        flags: What the reader was not sure of in the whole script.
    """

    def __init__(
        self, text: str, story: StoryAssets, scene: SceneContext, units: Sequence[Unit], flags: ScriptFlags
    ) -> None:
        self.story = story
        self.scene_id = scene.scene_id
        self.text = text
        self.flags = flags
        kit = SETS[scene.setup.kit]
        self.staging = Staging(units, story.assets, story.fixtures, seated=kit.seated, on_foot=kit.on_foot)
        self.later = absent_until_brought(units, story.assets - story.actors - story.creatures)
        self.lit_at_first = units[0] if opening_light(units) else None
        """The unit that states the light of the scene, which is no change of it."""
        self.told: set[int] = set()
        """Starts of the units that a shot has played."""
        self.seen: set[str] = set()
        """Things that have been in view."""

    def write(self, drafts: Sequence[ShotDraft], fps: int) -> tuple[ShotContext, ...]:
        """Return the shots; bodies and things are carried from one to the next.

        Args:
            drafts: The final cut.
            fps: Frames per second of the project.
        """
        return tuple(self._shot(number, draft, fps) for number, draft in enumerate(drafts, 1))

    def _shot(self, number: int, draft: ShotDraft, fps: int) -> ShotContext:
        states, end_states = self.staging.states(draft)
        units = [beat.unit for beat in draft.beats] or ([draft.before] if draft.before else [])
        fresh = [beat.unit for beat in draft.beats if beat.unit.start not in self.told]
        self.told |= {unit.start for unit in fresh}
        on_stage = [person for person in draft.on_stage if person in self.story.actors]
        # A thing in a person's hands is not shown without them.
        holders = [state.asset_id for state in states if draft.kind == "insert" and {*state.held} & {*draft.focus}]
        line = max((index for index, unit in enumerate(units) if unit.moment), default=None)
        changed = [unit for unit in fresh if unit is not self.lit_at_first]
        light = next((change.state for unit in changed for change in unit.changes if change.subject == "light"), "")
        return ShotContext(
            scene_id=self.scene_id,
            shot_id=number,
            on_stage=tuple(on_stage),
            in_frame=tuple(unique([*self._in_frame(draft, on_stage), *holders])),
            states=tuple(state for state in states if state.asset_id in self.story.actors),
            end_states=tuple(state for state in end_states if state.asset_id in self.story.actors),
            thing_spots=self._thing_spots(units),
            absent=self._absent(units),
            tethers=self._tethers(units),
            moment=units[line].moment if line is not None else None,
            moment_line=line if draft.beats else None,
            asset_modifications=tuple(self._modifications(fresh)),
            character_actions=tuple(self._actions(draft, on_stage)),
            light_change=light_change(light),
            sound_effect=", ".join(unique(sound for unit in fresh for sound in unit.sounds)) or None,
            camera_instruction=self._camera(draft),
            duration=frame_count(shot_seconds(draft, self.text), fps),
            flags=tuple(self._flags(draft, fresh)),
        )

    def _flags(self, draft: ShotDraft, units: Sequence[Unit]) -> list[Flag]:
        """Return what the reader was not sure of in these words, and what of a direction cannot be staged."""
        found = self.flags.of(units)
        if draft.note and draft.note.kind in _UNSTAGED and draft.beats:
            unit, what = draft.beats[0].unit, draft.note.kind.replace("_", " ")
            reason = f"{what} is recognised but not staged"
            found.append(Flag(topic="camera", choice="plain shot", reason=reason, start=unit.start, end=unit.end))
        for unit in units:
            for change in unit.changes:
                if change.subject != LIGHT and not state_values(change.state).state:
                    what, reason = change.subject, f"{change.state!r} is no state that can be shown"
                    found.append(Flag(topic=what, choice="unchanged", reason=reason, start=unit.start, end=unit.end))
        return found

    def _in_frame(self, draft: ShotDraft, on_stage: Sequence[str]) -> list[str]:
        shown = [*draft.focus, *([draft.over] if draft.over else [])]
        if draft.kind == "establishing" and not draft.has_note:
            shown += on_stage
        if draft.size not in TIGHT:
            shown += _walking_along(draft)
        if draft.size not in (*TIGHT, "MS") and draft.kind not in ("insert", "pov", "ots", "single"):
            shown += [deed.actor for beat in draft.beats for deed in beat.unit.deeds]
        return [person for person in unique(shown) if person in on_stage and person != draft.pov]

    def _thing_spots(self, units: Sequence[Unit]) -> dict[str, Spot]:
        """Return the spots of things, and of animals outside the cast, at the end of these units."""
        told = {each: spot for unit in units for each, spot in unit.spots.items()}
        placed = self.story.assets - self.story.actors
        return {each: self.staging.known_spot(spot) for each, spot in told.items() if each in placed}

    def _absent(self, units: Sequence[Unit]) -> tuple[str, ...]:
        """Return the things missing in all of these units; a thing that comes or goes in between is shown."""
        missing = [{*unit.absent} | self.later.get(unit.start, set()) for unit in units]
        return tuple(sorted(set[str].intersection(*missing) & self.story.assets)) if missing else ()

    def _tethers(self, units: Sequence[Unit]) -> tuple[Tether, ...]:
        told = {(tether.holder, tether.held): tether for unit in units for tether in unit.tethers}
        return tuple(tether for ends, tether in told.items() if self.story.assets.issuperset(ends))

    def _focus(self, draft: ShotDraft) -> dict[str, Any]:
        """Return the fields of the camera that say what is sharp, where the script does."""
        said = draft.note.focus if draft.note else ""
        rack = [self.story.visible_id(each) for each in draft.rack or ()]
        racked = dict(zip(("focus", "focus_to"), rack, strict=False)) if self.story.assets.issuperset(rack) else {}
        return {"f_number": _F_NUMBER_OF.get(said), "soft_focus": said == "soft", **racked}

    def _camera(self, draft: ShotDraft) -> CameraInstruction:
        return CameraInstruction(
            focus_on_ids=tuple(
                unique(each for part in draft.focus if (each := self.story.visible_id(part)) in self.story.assets)
            ),
            kind=draft.kind,
            size=draft.size,
            angle=draft.angle,
            detail=draft.detail,
            movement=draft.movement,
            direction=draft.direction,
            over_id=draft.over,
            pov_id=draft.pov if draft.pov in self.story.actors else None,
            lens=_POV_LENS if draft.kind == "pov" else None,
            **self._focus(draft),
            axis=draft.axis,
            order=one_line(draft.note.phrase) if draft.note else "",
            explicit=draft.script_directed,
            through=aperture_of(draft.note.through) if draft.note and draft.kind == "pov" else None,
            behind=draft.kind in _SHOWS_FACES
            and any(from_behind(self.text[beat.start : beat.end]) for beat in draft.beats),
        )

    def _modifications(self, units: Sequence[Unit]) -> list[AssetModification]:
        """Return what changes: doors and lamps, things that break or go, things brought out of a pocket."""
        found: list[AssetModification] = []
        for unit in units:
            for deed in unit.deeds:
                if (
                    deed.prop in self.story.assets
                    and deed.prop not in self.seen
                    and _brought_out(deed, unit, self.text)
                ):
                    found.append(AssetModification(asset_id=deed.prop, modification_type="add"))
            for change in unit.changes:
                subject = self.story.visible_id(change.subject)
                told = state_values(change.state)
                if told.state and subject in self.story.assets | self.story.fixtures:
                    kind = "remove" if told.state == "gone" else "transform"
                    found.append(AssetModification(asset_id=subject, modification_type=kind, **told._asdict()))
            self.seen.update(unit.things)
            self.seen.update(deed.prop for deed in unit.deeds if deed.prop)
        return found

    def _actions(self, draft: ShotDraft, on_stage: Sequence[str]) -> list[CharacterAction]:
        """Return what people do in a shot: deeds, speech, faces; a person without a deed listens or waits."""
        actions: list[CharacterAction] = []
        for index, beat in enumerate(draft.beats):
            actions += self._deeds(beat, index) if beat.start == beat.unit.start else []
            if beat.unit.kind == "dialogue":
                actions += self._speech(beat, index)
        actions += self._unread(draft, {action.asset_id for action in actions if action.motion != UNREAD})
        busy = {action.asset_id for action in actions}
        speaker = next((b.unit.speaker for b in draft.beats if b.unit.kind == "dialogue" and b.unit.speaker), None)
        for person in self._in_frame(draft, on_stage):
            if person in busy:
                continue
            heard = speaker if speaker in self.story.names else None
            actions.append(
                CharacterAction(
                    asset_id=person,
                    action_description=f"listens to {self.story.names[heard]}" if heard else "waits",
                    motion="listen" if heard else "idle",
                    target_id=heard if heard in self.story.assets else None,
                )
            )
        names = {person: self.story.names[person] for person in on_stage}
        return [with_facts(action, names) for action in actions]

    def _unread(self, draft: ShotDraft, busy: set[str]) -> list[CharacterAction]:
        """Return an action with the unit's own words for its only person, if the reader found no deed of theirs."""
        found: list[CharacterAction] = []
        for index, beat in enumerate(draft.beats):
            unit = beat.unit
            person = unit.people[0] if len(unit.people) == 1 and unit.kind == "action" and not unit.deeds else ""
            if person not in self.story.actors or person in busy:
                continue
            act = fine_motion(UNREAD, "", unit.text)
            if act != UNREAD:
                found.append(
                    CharacterAction(asset_id=person, action_description=unit.text, motion=act, line_index=index)
                )
        return found

    def _deeds(self, beat: Beat, index: int) -> list[CharacterAction]:
        unit = beat.unit
        found: list[CharacterAction] = []
        for deed in unit.deeds:
            acts = deed.actor in self.story.actors | self.story.creatures
            if not acts or (unit.kind == "dialogue" and deed.motion in SPOKEN):
                continue
            face = unit.expressions.get(deed.actor, "")
            words = deed_words(deed, unit, self.text)
            target, prop = (self.story.wholes.get(each or "", each) for each in (deed.target, deed.prop))
            found.append(
                CharacterAction(
                    asset_id=deed.actor,
                    action_description=words,
                    motion=UNREAD if self.staging.already(deed, unit) else fine_motion(deed.motion, deed.verb, words),
                    target_id=target if target in self.story.assets | self.story.fixtures else None,
                    prop_id=prop if prop in self.story.assets else None,
                    distance=deed.distance,
                    mood=deed.mood if deed.mood != "neutral" else mood_of(face, direction=True),
                    line_index=index,
                )
            )
        acting = {action.asset_id for action in found}
        for person, face in unit.expressions.items():
            if person in self.story.actors and person not in acting and person != unit.speaker:
                found.append(
                    CharacterAction(
                        asset_id=person, action_description=face, mood=mood_of(face, direction=True), line_index=index
                    )
                )
        return found

    def _speech(self, beat: Beat, index: int) -> list[CharacterAction]:
        unit = beat.unit
        if unit.speaker not in self.story.actors or unit.speaker not in unit.on_stage or unit.off_screen:
            return []
        spoken = next((deed for deed in unit.deeds if deed.actor == unit.speaker and deed.motion in SPOKEN), None)
        motion = spoken.motion if spoken else "talk"
        to = unit.to if unit.to in self.story.assets else None
        words = " ".join((unit.parenthetical, unit.expressions.get(unit.speaker, "")))
        return [
            CharacterAction(
                asset_id=unit.speaker,
                action_description=f"speaks to {self.story.names[to]}" if to else "speaks",
                motion=MOTION_KEYS[motion],
                target_id=to,
                mood=spoken.mood if spoken and spoken.mood != "neutral" else mood_of(words, direction=True),
                line_index=index,
            )
        ]


def _walking_along(draft: ShotDraft) -> list[str]:
    """Return who goes where the focus goes: the camera that holds one of them holds the others."""
    going = [{deed.actor for deed in beat.unit.deeds if deed.actor and deed.motion in TRAVEL} for beat in draft.beats]
    return sorted(person for walkers in going if walkers & {*draft.focus} for person in walkers)


def _brought_out(deed: Deed, unit: Unit, text: str) -> bool:
    """Whether a thing comes out of clothes or a bag, so that it was not to be seen before."""
    words = deed_words(deed, unit, text).lower()
    return deed.motion in GETTING and bool(re.match(_OUT_OF, words))
