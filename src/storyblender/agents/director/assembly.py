"""Assembly: drafts and reading become the four layers of the graph, ready for the other roles."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from string import capwords

from storyblender.agents.director.casting import cast, describe, introduction
from storyblender.agents.director.draft import Beat, ShotDraft
from storyblender.agents.director.durations import frames, shot_seconds
from storyblender.agents.director.motion_families import GETTING, SPOKEN
from storyblender.agents.director.place_words import ground, lighting, walls
from storyblender.agents.director.reading import Deed, Person, Reading, SceneReading, Thing, Unit
from storyblender.agents.director.settings import DirectorSettings
from storyblender.agents.director.staging import Staging
from storyblender.agents.director.wording import camera_sentence, deed_words, mood_of, one_line, shot_sentence
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.outline import SceneOutline, ScriptLine, ShotOutline, SourceSpan
from storyblender.memory.scene_context import Relation, SceneContext, SceneSetup
from storyblender.memory.shot_context import (
    AssetModification,
    CameraInstruction,
    CharacterAction,
    Flag,
    ShotContext,
)
from storyblender.memory.vocabulary import DISTANCE_OF_SIZE

_OUT_OF = (
    r"(?:draws?|drew|produces?d?|fish(?:es|ed)?)\b|(?:pulls?|pulled|takes?|took)\b.*\b(?:out"
    r"|from (?:his|her|their|a|the) \w*\s?(?:jacket|coat|pocket|bag|purse|sleeve|belt|satchel))\b"
)
_UNSTAGED = ("intercut", "split_screen", "match_cut")
_POV_LENS = 35.0
"""mm: about what an eye takes in."""


class Assembly:
    """Builds the layers of one story.

    Args:
        reading: What the script says.
        settings: For the frame rate.
    """

    def __init__(self, reading: Reading, settings: DirectorSettings) -> None:
        self.reading = reading
        self.settings = settings
        self.text = reading.screenplay.text
        staged = {person for unit in reading.units for person in unit.on_stage}
        self.people = [person for person in reading.people if person.id in staged]
        self.actors = {person.id for person in self.people if is_character(person)}
        self.assets = {person.id for person in self.people} | {thing.id for thing in reading.things}
        self.names = {each.id: _shown_name(each) for each in (*reading.people, *reading.things)}

    def asset_sheet(self) -> tuple[Asset, ...]:
        """Return everybody who is ever on stage, then every thing."""
        people = [self._person(person) for person in self.people]
        return (*people, *(self._thing(thing) for thing in self.reading.things))

    def _person(self, person: Person) -> Asset:
        character = person.id in self.actors
        tags = [] if character else ["animal"]
        tags += [person.kind] if person.kind != "human" and person.kind not in tags else []
        return Asset(
            asset_id=person.id,
            asset_type="character" if character else "object",
            description=describe(person)
            if character
            else one_line(f"{' '.join(person.build)} {person.role or person.name}"),
            name=self.names[person.id],
            tags=tuple(tags),
            look=cast(person, introduction(person, self.text)) if character else None,
            reference_character=person.variant_of if person.variant_of in self.actors else None,
        )

    def _thing(self, thing: Thing) -> Asset:
        return Asset(
            asset_id=thing.id,
            asset_type="object",
            description=thing.description or thing.name,
            name=self.names[thing.id],
            tags=(thing.kind, *(("handled",) if thing.handled else ())),
        )

    # -- scenes ----------------------------------------------------------------------------------------------------
    def scene_outline(self, scene: SceneReading, drafts: Sequence[ShotDraft]) -> SceneOutline:
        """Return the scene with its shots and their lines."""
        first = next((b.unit.text for d in drafts for b in d.beats if b.unit.kind == "action"), "")
        place = scene.place or scene.heading
        return SceneOutline(
            scene_id=scene.id,
            scene_description=f"{capwords(place) or 'A place'}, {scene.time}. {one_line(first)}".strip(),
            heading=scene.heading,
            script_number=scene.number,
            span=SourceSpan(start=scene.start, end=max(scene.start, scene.end)),
            shots=tuple(
                ShotOutline(
                    shot_id=number,
                    shot_description=shot_sentence(draft, self.text, self.names, capwords(place)),
                    lines=tuple(self._line(beat) for beat in draft.beats),
                )
                for number, draft in enumerate(drafts, 1)
            ),
        )

    def _line(self, beat: Beat) -> ScriptLine:
        unit = beat.unit
        return ScriptLine(
            kind=unit.kind,
            text=self.text[beat.start : beat.end],
            span=SourceSpan(start=beat.start, end=beat.end),
            speaker=unit.speaker if unit.speaker in self.assets else None,
            speaker_name=unit.speaker_name,
            parenthetical=unit.parenthetical,
            off_screen=unit.off_screen,
        )

    def scene_context(self, scene: SceneReading, units: Sequence[Unit]) -> SceneContext:
        """Return what the scene starts with."""
        relations = self._relations(scene, units)
        present = _unique(
            each
            for unit in units
            for each in (
                *unit.on_stage,
                *unit.things,
                *(id_ for deed in unit.deeds for id_ in (deed.target, deed.prop)),
                *(support for _, support in unit.posture.values()),
                *(thing for things in unit.held.values() for thing in things),
            )
            if each in self.assets
        )
        stated = [id_ for relation in relations for id_ in (relation.asset_id, relation.anchor_asset_id)]
        ids = _unique((*present, *(thing for thing in scene.furniture if thing in self.assets), *stated))
        return SceneContext(
            scene_id=scene.id,
            setup=SceneSetup(
                reference_scene_id=scene.reference,
                asset_ids=tuple(ids),
                scene_type=scene.scene_type,
                place=scene.place,
                place_kind=scene.place_kind,
                time_of_day=scene.time,
                weather=scene.weather,
                layout_description=self._layout(scene, relations),
                lighting_description=lighting(scene),
                ground_description=ground(scene),
                wall_description=walls(scene),
                relations=tuple(relations),
            ),
        )

    def _relations(self, scene: SceneReading, units: Sequence[Unit]) -> list[Relation]:
        """The relations that hold as the scene opens; what its people bring about later is left to them."""
        staging = Staging(units, self.assets)
        placed = {deed.prop for unit in units for deed in unit.deeds if deed.motion in ("put_down", "throw", "drop")}
        handled = {thing.id for thing in self.reading.things if thing.handled and thing.kind == "prop"}
        found: dict[str, Relation] = {}
        for index, relation in self.reading.relations:
            ends = {relation.asset_id, relation.anchor_asset_id}
            if self.reading.scenes[index].id != scene.id or len(ends) < 2 or not ends <= self.assets:
                continue
            if relation.asset_id in self.actors:
                holds = relation.asset_id in staging.opening and relation.anchor_asset_id not in handled
            else:
                holds = relation.asset_id not in placed and relation.anchor_asset_id not in self.actors
            if holds:
                found.setdefault(relation.asset_id, relation)
        return list(found.values())

    def _layout(self, scene: SceneReading, relations: Sequence[Relation]) -> str:
        stated = [
            f"{self.names[relation.asset_id]} {relation.kind.replace('_', ' ')} {self.names[relation.anchor_asset_id]}"
            for relation in relations
        ]
        furniture = ", ".join(self.names[thing] for thing in scene.furniture if thing in self.names)
        place = capwords(scene.place) or "A place"
        return "; ".join([f"{place} with {furniture}" if furniture else place, *stated]) + "."

    # -- shots -----------------------------------------------------------------------------------------------------
    def shot_contexts(
        self, scene: SceneReading, units: Sequence[Unit], drafts: Sequence[ShotDraft]
    ) -> tuple[ShotContext, ...]:
        """Return the shots of a scene; bodies and things are carried from one to the next."""
        staging = Staging(units, self.assets)
        told: set[int] = set()
        seen: set[str] = set()
        shots: list[ShotContext] = []
        for number, draft in enumerate(drafts, 1):
            states = staging.states(draft)
            fresh = [beat.unit for beat in draft.beats if beat.unit.start not in told]
            told |= {unit.start for unit in fresh}
            on_stage = [person for person in draft.on_stage if person in self.actors]
            shots.append(
                ShotContext(
                    scene_id=scene.id,
                    shot_id=number,
                    on_stage=tuple(on_stage),
                    in_frame=tuple(self._in_frame(draft, on_stage)),
                    states=tuple(state for state in states if state.asset_id in self.actors),
                    asset_modifications=tuple(self._modifications(fresh, seen)),
                    character_actions=tuple(self._actions(draft, on_stage, staging)),
                    new_lighting_description=next(
                        (c.state for u in fresh for c in u.changes if c.subject == "light"), None
                    ),
                    sound_effect=", ".join(_unique(sound for unit in fresh for sound in unit.sounds)) or None,
                    camera_instruction=self._camera(draft, scene),
                    duration=frames(shot_seconds(draft, self.text), self.settings.fps),
                    flags=tuple(self._flags(draft, fresh)),
                )
            )
        return tuple(shots)

    def _flags(self, draft: ShotDraft, units: Sequence[Unit]) -> list[Flag]:
        """What the reader was not sure of in these words, and what of a direction cannot be staged."""
        found = [
            flag
            for flag in self.reading.flags
            if any(unit.start <= flag.start < max(unit.end, unit.start + 1) for unit in units)
        ]
        if draft.note and draft.note.kind in _UNSTAGED and draft.beats:
            unit, what = draft.beats[0].unit, draft.note.kind.replace("_", " ")
            reason = f"{what} is recognised but not staged"
            found.append(Flag(topic="camera", choice="plain shot", reason=reason, start=unit.start, end=unit.end))
        return found

    def _in_frame(self, draft: ShotDraft, on_stage: Sequence[str]) -> list[str]:
        shown = [*draft.focus, *([draft.over] if draft.over else [])]
        if draft.kind == "establishing" and not draft.explicit:
            shown += on_stage
        return [person for person in _unique(shown) if person in on_stage and person != draft.pov]

    def _camera(self, draft: ShotDraft, scene: SceneReading) -> CameraInstruction:
        return CameraInstruction(
            focus_on_ids=tuple(each for each in draft.focus if each in self.assets),
            kind=draft.kind,
            size=draft.size,
            angle=draft.angle,
            distance=DISTANCE_OF_SIZE[draft.size],
            movement=draft.movement,
            direction=draft.direction,
            over_id=draft.over,
            pov_id=draft.pov if draft.pov in self.actors else None,
            lens=_POV_LENS if draft.kind == "pov" else None,
            axis=draft.axis,
            description=camera_sentence(draft, self.names, capwords(scene.place)),
            explicit=draft.explicit,
        )

    def _modifications(self, units: Sequence[Unit], seen: set[str]) -> list[AssetModification]:
        """What changes: doors and lamps, things that break or go, things that are brought out of a pocket."""
        found: list[AssetModification] = []
        for unit in units:
            for deed in unit.deeds:
                if deed.prop in self.assets and deed.prop not in seen and _brought_out(deed, unit, self.text):
                    hand = f"in the hand of {self.names.get(deed.actor, deed.actor)}"
                    found.append(AssetModification(asset_id=deed.prop, modification_type="add", description=hand))
            for change in unit.changes:
                if change.subject in self.assets:
                    found.append(
                        AssetModification(
                            asset_id=change.subject,
                            modification_type="remove" if change.state == "gone" else "transform",
                            description=f"{self.names[change.subject]}: {change.state}",
                            state=change.state,
                        )
                    )
            seen.update(unit.things)
            seen.update(deed.prop for deed in unit.deeds if deed.prop)
        return found

    def _actions(self, draft: ShotDraft, on_stage: Sequence[str], staging: Staging) -> list[CharacterAction]:
        """What everybody in the shot does: deeds, speech, faces; whoever is seen and does nothing listens or waits."""
        actions: list[CharacterAction] = []
        for index, beat in enumerate(draft.beats):
            actions += self._deeds(beat, index, staging) if beat.start == beat.unit.start else []
            if beat.unit.kind == "dialogue":
                actions += self._speech(beat, index)
        busy = {action.asset_id for action in actions}
        speaker = next((b.unit.speaker for b in draft.beats if b.unit.kind == "dialogue" and b.unit.speaker), None)
        for person in self._in_frame(draft, on_stage):
            if person in busy:
                continue
            heard = speaker if speaker in self.names else None
            actions.append(
                CharacterAction(
                    asset_id=person,
                    action_description=f"listens to {self.names[heard]}" if heard else "waits",
                    motion="listen" if heard else "idle",
                    target_id=heard if heard in self.assets else None,
                )
            )
        return actions

    def _deeds(self, beat: Beat, index: int, staging: Staging) -> list[CharacterAction]:
        unit = beat.unit
        found: list[CharacterAction] = []
        for deed in unit.deeds:
            if deed.actor not in self.actors or (unit.kind == "dialogue" and deed.motion in SPOKEN):
                continue
            face = unit.expressions.get(deed.actor, "")
            found.append(
                CharacterAction(
                    asset_id=deed.actor,
                    action_description=deed_words(deed, unit, self.text),
                    motion="idle" if staging.already(deed, unit) else deed.motion,
                    target_id=deed.target if deed.target in self.assets else None,
                    prop_id=deed.prop if deed.prop in self.assets else None,
                    distance=deed.distance,
                    mood=deed.mood if deed.mood != "neutral" else mood_of(face),
                    line_index=index,
                )
            )
        acting = {action.asset_id for action in found}
        for person, face in unit.expressions.items():
            if person in self.actors and person not in acting and person != unit.speaker:
                found.append(
                    CharacterAction(asset_id=person, action_description=face, mood=mood_of(face), line_index=index)
                )
        return found

    def _speech(self, beat: Beat, index: int) -> list[CharacterAction]:
        unit = beat.unit
        if unit.speaker not in self.actors or unit.speaker not in unit.on_stage or unit.off_screen:
            return []
        spoken = next((deed for deed in unit.deeds if deed.actor == unit.speaker and deed.motion in SPOKEN), None)
        motion = spoken.motion if spoken else "talk"
        to = unit.to if unit.to in self.assets else None
        words = " ".join((unit.parenthetical, unit.expressions.get(unit.speaker, "")))
        return [
            CharacterAction(
                asset_id=unit.speaker,
                action_description=f"speaks to {self.names[to]}" if to else "speaks",
                motion=motion,
                target_id=to,
                mood=spoken.mood if spoken and spoken.mood != "neutral" else mood_of(words),
                line_index=index,
            )
        ]


def _brought_out(deed: Deed, unit: Unit, text: str) -> bool:
    """Whether a thing comes out of clothes or a bag, so that it was not to be seen before."""
    words = deed_words(deed, unit, text).lower()
    return deed.motion in GETTING and bool(re.match(_OUT_OF, words))


def is_character(person: Person) -> bool:
    """Whether somebody is cast: people, and animals that speak."""
    return person.kind != "animal" or person.speaks


def _shown_name(each: Person | Thing) -> str:
    return capwords(each.name) if each.name.isupper() else each.name


def _unique(items: Iterable[str | None]) -> list[str]:
    return list(dict.fromkeys(item for item in items if item))
