"""Coverage: every shot that a scene calls for, before the budget cuts it (notes of the director, section 2).

One pass over the units of a scene. Geography before detail; the whole body while it travels; hands and both faces
when a thing changes hands; a master, then over the shoulder, then singles that tighten while people talk.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Final

from storyblender.agents.director.cutting import (
    does_more_than_handle,
    listener_of,
    looked_at_prop,
    size_for_motions,
    size_steps,
    split_of_speech,
)
from storyblender.agents.director.directions import directed_shot, is_direction_only, racks_within
from storyblender.agents.director.draft import Beat, ShotDraft
from storyblender.agents.director.durations import action_seconds, speech_seconds
from storyblender.agents.director.motion_families import FAST, HANDS, LOW, TRAVEL, WHOLE_BODY
from storyblender.agents.director.reading import CameraNote, SceneReading, Unit
from storyblender.agents.director.story_assets import unique
from storyblender.memory.outline import word_count
from storyblender.memory.shot_sizes import ShotSize
from storyblender.memory.vocabulary import ShotKind

if TYPE_CHECKING:
    from storyblender.agents.director.coverage import Coverage

_REPLY_WORDS: Final = 3
"""A reply of so few words stays in the shot it answers."""
_LONG_SPEECH_WORDS: Final = 25
"""A longer speech leaves room to cut to the listener."""
_JOINED_SECONDS: Final = 7.0
"""Sentences of one paragraph share a shot up to this many seconds."""
_ESTABLISHED_SECONDS: Final = 7.0
"""An establishing shot takes in what follows in its paragraph up to this many seconds."""
_MAX_FACES: Final = 5
"""No more faces than this in one group."""
ATTACHED_KINDS = frozenset({"title", "sound", "aside"})
"""Kinds of units that get no shot of their own."""


class SceneCoverage:
    """Coverage of one scene, built unit by unit; ``notes`` are its camera directions by index into ``units``."""

    def __init__(
        self, story: Coverage, scene: SceneReading, units: Sequence[Unit], notes: Mapping[int, CameraNote]
    ) -> None:
        self.scene = scene
        self.units = units
        self.notes = notes
        self.text = story.text
        self.names = story.names
        self.props = story.props
        self.things = story.things
        self.establish = story.is_new(scene)
        self.last_speech = max((index for index, unit in enumerate(units) if unit.kind == "dialogue"), default=-1)
        self.drafts: list[ShotDraft] = []
        self.speeches = 0
        """Speeches since the geography was last shown."""
        self.open_direction: ShotDraft | None = None
        """The last shot, if a direction without action ordered it: the line below the direction plays in it."""
        self.people_shown = -1
        self.talkers = {each for unit in units if unit.kind == "dialogue" for each in (unit.speaker, unit.to)}
        self.axes: dict[frozenset[str], tuple[str, str]] = {}
        self.waiting: list[Unit] = []
        """On-screen text and asides before the first shot of the scene or of a picture."""

    def shots(self) -> list[ShotDraft]:
        """Return the shots of the scene, in order."""
        for index, unit in enumerate(self.units):
            note = self.notes.get(index)
            if self.waiting and self.waiting[0].picture not in (None, unit.picture):
                self._add_waiting_shot()
            before = len(self.drafts)
            if unit.kind in ATTACHED_KINDS:
                self._attach(unit)
            elif note:
                self._follow_direction(index, unit, note)
            elif self._continues_direction(unit):
                self._continue_direction(unit)
            else:
                self.open_direction = None
                (self._action if unit.kind == "action" else self._speech)(index, unit)
            if self.waiting and len(self.drafts) > before:
                self.drafts[before].beats[:0] = [Beat.whole(each) for each in self.waiting]
                self.waiting = []
        if self.waiting or not self.drafts:
            self._add_waiting_shot()
        for draft in self.drafts:
            if draft.kind == "action" and not draft.focus:
                draft.add_focus(*draft.on_stage[:2])
        return self.drafts

    def _attach(self, unit: Unit) -> None:
        """Attach on-screen text, a sound or an aside to the shot before, or to the next first shot."""
        if self._last and self._last.beats and unit.picture in (None, self._last.picture):
            self._last.beats.append(Beat.whole(unit))
        else:
            self.waiting.append(unit)

    def _add_waiting_shot(self) -> None:
        """Add a shot of the place for on-screen text that no other shot takes."""
        draft = self._add("action" if self.drafts else "establishing", self._widest, [], *self.waiting)
        draft.add_focus(*draft.on_stage[:2])
        self.waiting = []

    @property
    def _widest(self) -> ShotSize:
        """Size of the establishing shot."""
        return "EWS" if self.scene.scene_type == "outdoor" else "WS"

    @property
    def _last(self) -> ShotDraft | None:
        """The last shot so far, or None."""
        return self.drafts[-1] if self.drafts else None

    def _add(self, kind: ShotKind, size: ShotSize, focus: Sequence[str | None], *units: Unit) -> ShotDraft:
        """Add a shot that covers whole units."""
        draft = ShotDraft(kind, size, beats=[Beat.whole(unit) for unit in units])
        draft.add_focus(*focus)
        draft.on_stage = list(units[0].on_stage) if units else list(self._last.on_stage) if self._last else []
        self.drafts.append(draft)
        return draft

    def _axis(self, one: str | None, other: str | None) -> tuple[str, str] | None:
        """Return the line between two people, in the same order all through the scene; None for fewer."""
        if not one or not other or one == other:
            return None
        return self.axes.setdefault(frozenset((one, other)), (one, other))

    def _follow_direction(self, index: int, unit: Unit, note: CameraNote) -> None:
        """Add the shot that a written direction orders, and what the unit tells besides."""
        if self._last and racks_within(self._last, unit, note, self.names):
            self.open_direction = self._last if not unit.deeds and is_direction_only(unit.text) else None
            return
        default = size_for_motions({deed.motion for deed in unit.deeds}) if unit.deeds else "MS"
        draft = directed_shot(unit, note, self.names, default, self._last)
        if draft.kind in ("ots", "two_shot"):
            pair = [draft.over, *draft.focus] if draft.over else draft.focus
            draft.axis = self._axis(*pair[:2]) if len(pair) > 1 else None
        elif not note.phrase and unit.kind == "dialogue" and unit.speaker in draft.focus:
            draft.axis = self._axis(unit.speaker, listener_of(unit, unit.speaker))
        alone = draft.kind == "insert" and not draft.detail and does_more_than_handle(unit, draft.focus)
        if alone:
            draft.before = unit
            draft.beats, draft.on_stage = [], [person for person in unit.on_stage if person not in unit.entering]
        self.drafts.append(draft)
        self.open_direction = draft if not unit.deeds and is_direction_only(unit.text) else None
        if alone:
            self.establish = False
            self._action(index, unit)
            return
        self.establish = self.establish and size_steps(draft.size, "FS") > 0 and draft.kind in ("insert", "pov")
        self.speeches = max(self.speeches, int(draft.kind in ("two_shot", "group")))

    def _continues_direction(self, unit: Unit) -> bool:
        """Whether a unit is the line under a direction that tells nothing itself: ``CLOSE ON the ring.``

        A speech always plays in that shot, even if its speaker is not shown; an action only if the shot can show it.
        """
        shot = self.open_direction
        if shot is None:
            return False
        under = shot.beats[1:]
        if shot.picture != unit.picture:
            return False
        if under:
            return under[0].unit.element == unit.element and self._can_show(shot, unit)
        return unit.kind == "dialogue" or self._can_show(shot, unit)

    def _can_show(self, shot: ShotDraft, unit: Unit) -> bool:
        """Whether a directed shot can show what people do in a unit."""
        actors = {deed.actor for deed in unit.deeds}
        if shot.kind == "insert" and any(thing in self.things for thing in shot.focus):
            return not does_more_than_handle(unit, shot.focus)
        if shot.pov in actors:
            return False
        return actors <= {*shot.focus} or size_steps(shot.size, "MS") <= 0

    def _continue_direction(self, unit: Unit) -> None:
        """Add a unit to the directed shot that is still open."""
        shot = self.open_direction
        assert shot is not None, "it was asked whether there is one"
        shot.beats.append(Beat.whole(unit))
        shot.on_stage = unique([*shot.on_stage, *unit.on_stage])
        if not shot.focus:
            shot.add_focus(*(deed.actor for deed in unit.deeds))
        if unit.kind == "dialogue":
            self.speeches = max(self.speeches, 1)
        self.establish = False
        self.people_shown = len(unit.on_stage)

    # -- action ----------------------------------------------------------------------------------------------------
    def _action(self, index: int, unit: Unit) -> None:
        """Add the shots of a unit of action, or join it to the last shot."""
        motions = {deed.motion for deed in unit.deeds}
        if motions & (TRAVEL | WHOLE_BODY) or len(unit.on_stage) != self.people_shown:
            self.speeches = 0
        self.people_shown = len(unit.on_stage)
        if self.establish:
            self.establish = False
            self._add("establishing", self._widest, unit.on_stage if unit.deeds else [], unit)
            return
        drafts = self._action_shots(index, unit, motions)
        if len(drafts) == 1 and self._joins(drafts[0]):
            self._join(drafts[0])
        else:
            self.drafts += drafts

    def _action_shots(self, index: int, unit: Unit, motions: set[str]) -> list[ShotDraft]:
        """Return the shots of a unit of action."""
        actors = unique(deed.actor for deed in unit.deeds)
        if not unit.deeds:
            return [self._actionless_shot(unit)]
        seen = looked_at_prop(unit.deeds, self.props)
        if seen and motions <= {"look", "read", "think", "idle"}:
            looker = ShotDraft("reaction", "MCU", actors[:2], [Beat.whole(unit)], on_stage=list(unit.on_stage))
            return [looker, ShotDraft("insert", "CU", [seen], on_stage=list(unit.on_stage))]
        partners = [deed.target for deed in unit.deeds if deed.target in unit.on_stage and deed.target not in actors]
        hands = bool(motions & HANDS) and not motions & (TRAVEL | WHOLE_BODY)
        props = unique(deed.prop for deed in unit.deeds if deed.prop in self.props)
        size = size_for_motions(motions)
        kind: ShotKind = "action" if motions & (TRAVEL | WHOLE_BODY | HANDS) or len(actors) > 1 else "reaction"
        if len(actors) > 2:
            kind, size = "group", "FS" if motions & TRAVEL else "MWS"
        draft = ShotDraft(kind, size, [], [Beat.whole(unit)], on_stage=list(unit.on_stage))
        draft.add_focus(*actors[:_MAX_FACES], *partners, *(props if hands else []))
        draft.whole_body = bool(motions & TRAVEL)
        if index and set(unit.entering) & set(actors) and draft.whole_body:
            draft.size = "FS"
        if motions & FAST:
            draft.movement = "track"
        elif "walk" in motions and len(actors) == 1 and not partners:
            draft.movement = "pan"
        if motions & LOW:
            draft.angle = "high angle"
        elif "aim" in motions:
            draft.angle = "low angle"
        return [draft]

    def _actionless_shot(self, unit: Unit) -> ShotDraft:
        """Return the shot of a sentence in which nobody acts: faces, things, weather."""
        people = [person for person in unit.people if person in unit.on_stage]
        shown = [thing for thing in unit.things if thing in self.things]
        if people:
            face = len(people) == 1 and bool(unit.expressions)
            draft = ShotDraft("reaction" if face else "action", "MCU" if face else "MS", people[:_MAX_FACES])
        elif shown and shown[0] in self.props:
            draft = ShotDraft("insert", "CU", shown[:1])
        elif shown:
            draft = ShotDraft("action", "MS", shown[:1])
        else:
            # A door that opens is seen with who comes in; where nobody does, with who is there.
            draft = ShotDraft("action", "MS" if self.drafts and unit.on_stage else "WS")
        draft.beats, draft.on_stage = [Beat.whole(unit)], list(unit.on_stage)
        return draft

    def _joins(self, new: ShotDraft) -> bool:
        """Whether a shot joins the last: one paragraph, the same people, sizes that are close."""
        last = self._last
        if (
            last is None
            or last.has_note
            or not last.beats
            or last.kind not in ("establishing", "action", "reaction", "group")
            or (last.has_key_action and new.has_key_action)
            or last.picture != new.picture
        ):
            return False
        unit, before = new.beats[0].unit, last.beats[-1].unit
        seconds = sum(action_seconds(beat.unit.text) for beat in last.beats) + action_seconds(unit.text)
        empty = not unit.deeds and not unit.people and not unit.things
        if empty:
            return seconds <= _JOINED_SECONDS and len(last.beats) < 3
        if before.element != unit.element or before.kind != "action":
            return False
        if last.kind == "establishing":
            return (
                seconds <= _ESTABLISHED_SECONDS
                and not new.whole_body
                and not new.has_key_action
                and new.kind != "insert"
            )
        nested = set(new.focus) <= set(last.focus) or set(last.focus) <= set(new.focus)
        return nested and seconds <= _JOINED_SECONDS and abs(size_steps(new.size, last.size)) <= 2

    def _join(self, new: ShotDraft) -> None:
        """Join a shot to the last one."""
        last = self.drafts[-1]
        last.beats += new.beats
        last.on_stage = unique([*last.on_stage, *new.on_stage])
        people = [each for each in new.focus if each in self.names.people]
        # A wide view shows the furniture anyway: with a person there it is about that person.
        last.add_focus(*(people if last.kind == "establishing" and last.focus else new.focus))
        last.focus.sort(key=lambda each: each not in self.names.people)
        if last.kind == "establishing":
            return
        if size_steps(last.size, new.size) > 0 or new.whole_body:
            last.size = new.size
        last.whole_body = last.whole_body or new.whole_body
        if last.movement == "static":
            last.movement = new.movement

    # -- speech ----------------------------------------------------------------------------------------------------
    def _speech(self, index: int, unit: Unit) -> None:
        """Add the shots of a speech, or join it to the last shot."""
        if self.establish:
            self.establish = False
            self._add("establishing", self._widest, []).on_stage = [p for p in unit.on_stage if p not in unit.entering]
        speaker = unit.speaker if unit.speaker in unit.on_stage and not unit.off_screen else None
        if speaker is None:
            self._off_screen_speech(unit)
            return
        listener = listener_of(unit, speaker)
        if self._continues_shot(unit, speaker):
            self._continue_shot(unit)
            return
        self.speeches += 1
        draft = self._speech_shot(unit, speaker, listener, final=index == self.last_speech)
        draft.axis = self._axis(speaker, listener)
        if draft.kind == "single" and any(deed.motion == "shout" for deed in unit.deeds):
            draft.angle = "low angle"
        self._cut_to_listener(draft, unit, listener)

    def _speech_shot(self, unit: Unit, speaker: str, listener: str | None, *, final: bool) -> ShotDraft:
        """Add the shot of a speaker: group or two-shot first, then over the shoulder, then singles."""
        others = [p for p in unit.on_stage if p in self.talkers and p not in (speaker, listener)]
        crowd = bool(others) if listener else len(unit.on_stage) > 1
        if self.speeches == 1:
            last = self._last
            if crowd and not (last and last.kind == "group"):
                return self._add("group", "MWS", [speaker, listener, *others][:_MAX_FACES], unit)
            if crowd or not listener:
                return self._add("single", "MCU" if crowd else "MS", [speaker], unit)
            return self._add("two_shot", "MS", [speaker, listener], unit)
        if self.speeches <= 4 and listener:
            draft = self._add("ots", "MS" if self.speeches == 2 else "MCU", [speaker], unit)
            draft.over = listener
            return draft
        return self._add(
            "single", "CU" if self.speeches >= 7 or (final and self.speeches > 2) else "MCU", [speaker], unit
        )

    def _off_screen_speech(self, unit: Unit) -> None:
        """Cover a voice from off screen by the listener, or by the place."""
        last = self._last
        listeners = [person for person in unit.on_stage if person != unit.speaker]
        seen = [person for draft in reversed(self.drafts) for person in draft.focus if person in listeners]
        acting = next(iter([*seen, *listeners]), None)
        held = last and not last.has_note and last.focus[:1] == ([acting] if acting else []) and last.beats
        if last and held and last.picture == unit.picture:
            seconds = speech_seconds(unit.text) + sum(action_seconds(beat.unit.text) for beat in last.beats)
            if seconds <= _JOINED_SECONDS:
                last.beats.append(Beat.whole(unit))
                return
        self._add("reaction" if acting else "action", "MCU" if acting else "WS", [acting], unit)

    def _continues_shot(self, unit: Unit, speaker: str) -> bool:
        """Whether a speech needs no cut: a short reply, the same speaker, or dual dialogue."""
        last = self._last
        if not last or last.has_note or not last.beats or last.beats[-1].unit.kind != "dialogue":
            return False
        if last.picture != unit.picture:
            return False
        before = last.beats[-1].unit
        if unit.dual and before.speaker in unit.on_stage:
            return True
        seconds = sum(speech_seconds(beat.unit.text) for beat in last.beats) + speech_seconds(unit.text)
        if before.speaker == speaker and speaker in last.focus:
            return seconds <= _JOINED_SECONDS
        shown = last.kind in ("two_shot", "group") and speaker in last.focus
        return shown and word_count(unit.text) <= _REPLY_WORDS and len(last.beats) < 3

    def _continue_shot(self, unit: Unit) -> None:
        """Add a speech to the last shot."""
        last = self.drafts[-1]
        if unit.dual and unit.speaker not in last.focus:
            last.kind, last.size, last.over = "two_shot", "MS", None
            last.add_focus(unit.speaker)
            last.axis = self._axis(last.focus[0], unit.speaker)
        last.beats.append(Beat.whole(unit))
        last.on_stage = unique([*last.on_stage, *unit.on_stage])

    def _cut_to_listener(self, draft: ShotDraft, unit: Unit, listener: str | None) -> None:
        """Give the second half of a long speech to the listener."""
        long = listener and word_count(unit.text) > _LONG_SPEECH_WORDS and unit.picture is None
        if not long or (cut := split_of_speech(self.text, unit)) is None:
            return
        draft.beats = [Beat(unit, unit.start, cut[0])]
        reaction = self._add("reaction", "MCU", [listener])
        reaction.beats, reaction.axis = [Beat(unit, cut[1], unit.end)], draft.axis
