"""Builds outline, asset sheet and scene contexts from the reading and the final cut."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import accumulate
from string import capwords

from storyblender.agents.director.casting import age_word, cast_look, describe_person, introduction_words
from storyblender.agents.director.creatures import describe_creature, size_in_script
from storyblender.agents.director.draft import Beat, ShotDraft
from storyblender.agents.director.fixtures import is_piece, is_scenery
from storyblender.agents.director.lighting import opening_light, usual_light
from storyblender.agents.director.motion_families import GETTING, PARTING
from storyblender.agents.director.reading import Person, Reading, SceneReading, Thing, Unit
from storyblender.agents.director.scene_continuity import LIGHT, inherited_positions, inherited_states
from storyblender.agents.director.script_notes import notes_by_scene, notes_by_shot
from storyblender.agents.director.set_choice import ChosenSet, SetChoice
from storyblender.agents.director.size_words import stated_size
from storyblender.agents.director.staging import Staging
from storyblender.agents.director.story_assets import StoryAssets, unique
from storyblender.agents.director.wording import modifiers_of, one_line
from storyblender.agents.director.writing import writing_on
from storyblender.catalog.fixtures import named_pieces
from storyblender.catalog.homelands import homeland_of
from storyblender.catalog.liquids import liquid_named
from storyblender.catalog.parts import PART_PROPS, part_named
from storyblender.catalog.props.prop_names import kind_named
from storyblender.catalog.sets import SETS, plan_of
from storyblender.catalog.states import SEEN_AGAIN
from storyblender.memory.asset_sheet import FITTED, Asset, CharacterLook, Garment
from storyblender.memory.outline import SceneOutline, ScriptLine, ShotOutline, SourceSpan
from storyblender.memory.scene_context import Environment, Relation, SceneContext, SceneSetup


class Assembly:
    """Builds the layers of the graph above the shots.

    Args:
        reading: The reading of the script.
        story: The people and things on the asset sheet.
        summary: Summary of the story.
    """

    def __init__(self, reading: Reading, story: StoryAssets, summary: str) -> None:
        self.reading = reading
        self.story = story
        self.text = reading.screenplay.text
        self.sets = SetChoice(reading, summary)
        self.inherited_positions = inherited_positions(reading)
        self.inherited = inherited_states(reading)
        self.handled = {thing.id for thing in reading.things if thing.handled and thing.kind == "prop"}
        self.inanimate = story.assets - story.actors
        self.starts = [scene.start for scene in reading.scenes]
        self.homelands = [homeland_of(scene.heading) for scene in reading.scenes]
        self.latest_homelands = list(accumulate(self.homelands, lambda before, here: here or before))
        self.notes = notes_by_scene(reading.screenplay, reading.scenes)
        self.relations: dict[int, list[Relation]] = {}
        for index, relation in reading.relations:
            self.relations.setdefault(reading.scenes[index].id, []).append(relation)

    def asset_sheet(self) -> tuple[Asset, ...]:
        """Return the people who are ever on stage, then the things."""
        people: list[Asset] = []
        for person in self.story.people:
            people.append(self._person(person, [other.look.garments for other in people if other.look is not None]))
        things = (thing for thing in self.reading.things if thing.id in self.story.assets)
        return (*people, *(self._thing(thing) for thing in things))

    def _person(self, person: Person, worn_by_others: Sequence[tuple[Garment, ...]]) -> Asset:
        """Return the asset of a person, an animal or a robot."""
        character = person.id in self.story.actors
        name = self.story.names[person.id]
        description = describe_person(person) if character else describe_creature(person, self.reading)
        figure = replace(person, hair=(), outfit=(), face=())
        tags = [] if character else ["animal"]
        tags += [person.kind] if person.kind != "human" and person.kind not in tags else []
        return Asset(
            asset_id=person.id,
            asset_type="character" if character else "object",
            description=description,
            name=name,
            kind=None if character else kind_named(description) or kind_named(name),
            stated_size=stated_size(name, describe_person(figure) if character else description, person=character),
            tags=tuple(tags),
            look=self._look(person, worn_by_others) if character else None,
            reference_character=person.variant_of if person.variant_of in self.story.actors else None,
        )

    def _look(self, person: Person, worn_by_others: Sequence[tuple[Garment, ...]]) -> CharacterLook:
        """Return the look of a person, dressed for where the story is when they are first named."""
        scene = bisect_right(self.starts, person.first) - 1
        reached = self.latest_homelands[scene] if scene >= 0 else None
        homeland = reached or next((homeland for homeland in self.homelands if homeland), None)
        aged = person if person.age else replace(person, age=age_word(person, self.text))
        return cast_look(
            aged, introduction_words(person, self.text), self.reading.age or "today", homeland, worn_by_others
        )

    def _thing(self, thing: Thing) -> Asset:
        """Return the asset of a thing."""
        name, modifiers = self.story.names[thing.id], modifiers_of(thing, self.text)
        part = part_named(thing.name) if thing.id in self.story.fitted else ""
        whole = self.story.fitted.get(thing.id) or thing.part_of
        description = thing.description or one_line(f"{size_in_script(thing, self.text)} {modifiers} {thing.name}")
        return Asset(
            asset_id=thing.id,
            asset_type="object",
            description=description,
            name=name,
            kind=PART_PROPS.get(part) or kind_named(name),
            stated_size=stated_size(name, description, person=False, kind=kind_named(name)),
            writing=thing.writing or writing_on(thing.name, thing.first, self.text),
            liquid=liquid_named(f"{description} {name}"),
            part_of=whole if whole in self.story.assets else None,
            tags=(thing.kind, *(("handled",) if thing.handled else ()), *((FITTED, part) if part else ())),
        )

    def scene_outline(self, scene: SceneReading, drafts: Sequence[ShotDraft]) -> SceneOutline:
        """Return a scene with its shots and their lines.

        Args:
            scene: The scene.
            drafts: The final cut of the scene.
        """
        first = next((b.unit.text for d in drafts for b in d.beats if b.unit.kind == "action"), "")
        place = scene.place or scene.heading
        where = f"{capwords(place)}, {scene.time}" if place else scene.time.capitalize()
        lines = [tuple(self._line(beat) for beat in draft.beats) for draft in drafts]
        notes = notes_by_shot(self.notes.get(scene.id, ()), [[line.span for line in shot] for shot in lines], self.text)
        return SceneOutline(
            scene_id=scene.id,
            scene_description=f"{where}. {one_line(first)}".strip(),
            heading=scene.heading,
            script_number=scene.number,
            span=SourceSpan(start=scene.start, end=max(scene.start, scene.end)),
            shots=tuple(
                ShotOutline(
                    shot_id=index + 1,
                    lines=lines[index],
                    notes=tuple(notes.get(index, ())),
                )
                for index, draft in enumerate(drafts)
            ),
            notes=tuple(notes.get(None, ())),
        )

    def _line(self, beat: Beat) -> ScriptLine:
        """Return the script line that a beat covers."""
        unit = beat.unit
        return ScriptLine(
            kind="dialogue" if unit.kind == "dialogue" else "action",
            text=self.text[beat.start : beat.end],
            span=SourceSpan(start=beat.start, end=beat.end),
            speaker=unit.speaker if unit.speaker in self.story.assets else None,
            speaker_name=unit.speaker_name,
            parenthetical=unit.parenthetical,
            off_screen=unit.off_screen,
        )

    def scene_context(self, scene: SceneReading, units: Sequence[Unit], outline: SceneOutline) -> SceneContext:
        """Return what a scene starts with: set, assets and relations; called in story order.

        Args:
            scene: The scene.
            units: The units of the scene.
            outline: Its shots with their lines.
        """
        relations = self._relations(scene, units)
        present = unique(
            each
            for unit in units
            for each in (
                *unit.on_stage,
                *unit.things,
                *(id_ for deed in unit.deeds for id_ in (deed.target, deed.prop)),
                *(support for _, support in unit.posture.values()),
                *(thing for things in unit.held.values() for thing in things),
                *(thing for grips in unit.grips.values() for thing in grips),
                *unit.gaze.values(),
                *(id_ for id_, spot in unit.spots.items() for id_ in (id_, spot.anchor_id)),
                *(id_ for tether in unit.tethers for id_ in (tether.holder, tether.held)),
            )
            if each in self.story.assets
        )
        stated = [id_ for relation in relations for id_ in (relation.asset_id, relation.anchor_asset_id)]
        present += [whole for each in present if (whole := self.story.fitted.get(each)) in self.story.assets]
        ids = unique((*present, *(thing for thing in scene.furniture if thing in self.story.assets), *stated))
        action = "\n".join(line.text for shot in outline.shots for line in shot.lines if line.kind == "action")
        chosen = self.sets.decide(scene, ids, self._contents(scene, relations), action)
        return SceneContext(
            scene_id=scene.id,
            setup=SceneSetup(
                reference_scene_id=scene.reference,
                asset_ids=tuple(ids),
                scene_type=scene.scene_type,
                place=scene.place,
                kit=chosen.kit,
                set_options=chosen.set_options,
                snow=chosen.snow,
                crowd=chosen.crowd,
                time_of_day=scene.time,
                weather=scene.weather,
                light=opening_light(units) or usual_light(scene.scene_type, scene.time),
                relations=tuple(relations),
                scenery=tuple(self._scenery(scene, chosen, ids)),
                found={each: states for each, states in self.inherited[scene.id].items() if self._is_known(each)},
            ),
        )

    def _scenery(self, scene: SceneReading, chosen: ChosenSet, ids: Sequence[str]) -> Iterator[str]:
        """Yield those of the things with these ids that the chosen set of a scene shows by itself."""
        things = [thing for thing in self.reading.things if thing.id in ids and thing.kind == "set_piece"]
        plan = plan_of(Environment(kit=chosen.kit, params=dict.fromkeys(chosen.set_options, True)))
        pieces = [name for names in named_pieces(plan) for name in names] if things else []
        built_in = {thing.id for thing in things if is_piece(thing, pieces)}
        for each in ids:
            named = is_scenery(self.story.names[each], scene.place, SETS[chosen.kit])
            if each in self.inanimate and (named or each in built_in):
                yield each

    def _inherited_relations(self, scene: SceneReading) -> Iterator[Relation]:
        """Yield the positions of things that an earlier scene in this place left broken, tipped or burning."""
        inherited = self.inherited[scene.id].items()
        left = {thing for thing, found in inherited if SEEN_AGAIN & {*found.states} and "gone" not in found.states}
        for earlier in self.reading.scenes:
            same = scene.reference is not None and scene.reference in (earlier.id, earlier.reference)
            if earlier.id < scene.id and same:
                yield from (each for each in self.relations.get(earlier.id, ()) if each.asset_id in left)

    def _is_known(self, id_: str) -> bool:
        """Whether an id is on the asset sheet, part of the set, or the light of the place."""
        return id_ == LIGHT or id_ in self.story.assets or id_ in self.story.fixtures

    def _relations(self, scene: SceneReading, units: Sequence[Unit]) -> list[Relation]:
        """Return the relations that hold as the scene opens, without those that deeds bring about later."""
        staging = Staging(units, self.story.assets)
        handling = [deed for unit in units for deed in unit.deeds if deed.prop and deed.motion in GETTING | PARTING]
        first = {deed.prop: deed.motion for deed in reversed(handling)}
        placed = {prop for prop, motion in first.items() if motion in ("put_down", "throw", "drop")}
        found: dict[str, Relation] = {}
        for relation in self.relations.get(scene.id, []):
            ends = {relation.asset_id, relation.anchor_asset_id}
            if len(ends) < 2 or not ends <= self.story.assets:
                continue
            if relation.asset_id in self.story.actors:
                holds = relation.asset_id in staging.opening and relation.anchor_asset_id not in self.handled
            else:
                holds = relation.asset_id not in placed and relation.anchor_asset_id not in self.story.actors
            if holds:
                found.setdefault(relation.asset_id, relation)
        for relation in (*self._inherited_relations(scene), *self.inherited_positions[scene.id]):
            if {relation.asset_id, relation.anchor_asset_id} <= self.inanimate:
                found.setdefault(relation.asset_id, relation)
        return list(found.values())

    def _contents(self, scene: SceneReading, relations: Sequence[Relation]) -> str:
        """Return the place, its furniture and the relations in words."""
        names = self.story.names
        stated = [
            f"{names[relation.asset_id]} {relation.kind.replace('_', ' ')} {names[relation.anchor_asset_id]}"
            for relation in relations
        ]
        furniture = ", ".join(names[thing] for thing in scene.furniture if thing in names)
        place = capwords(scene.place) or "A place"
        return "; ".join([f"{place} with {furniture}" if furniture else place, *stated]) + "."
