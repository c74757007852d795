"""The Director played by a language model: it annotates the units of the page scene by scene, and never rewrites them.

The page reader cuts the script into numbered units; the model says what each of them shows. Cast, things and places
run along from scene to scene, so that a request stays small however long the script is. The rules' own reading is the
second opinion: where the two differ on cast, places or things, a flag says so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Any

from storyblender.agents.asking import Asker
from storyblender.agents.director.annotation import (
    PlaceNotes,
    SceneNotes,
    annotated_scene,
    annotated_unit,
    person_of,
    thing_of,
)
from storyblender.agents.director.director import RulesDirector
from storyblender.agents.director.kit_choice import choose_kit
from storyblender.agents.director.reading import Person, Reading, Thing, Unit
from storyblender.agents.director.reading_file import reading_with_fixtures, unknown_names
from storyblender.agents.director.second_opinion import differences
from storyblender.agents.nearest import nearest_entries
from storyblender.catalog.motions import MOTION_KEYS
from storyblender.catalog.sets import SETS
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import Critique
from storyblender.screenplay.model import Screenplay

_MOST_UNITS = 40
"""Units in one request; a longer scene is read in parts."""
_KITS = 6
"""Set kits nearest to the heading, and to the action, that a request describes; of the others it has the keys."""
_COMING = 6
"""Units of the next scene that a request shows, so that nothing is staged that they contradict."""
_PICTURES = 1000
"""Numbers of pictures that a part of a scene may have."""
_FIXTURES = ("door", "window")
"""Parts of any set that may be named without being listed."""


@dataclass(frozen=True)
class _Part:
    """A run of units of one scene that is read in one request."""

    number: int
    scene: int
    units: tuple[Unit, ...]
    first: int
    """Number of its first unit."""


class LanguageDirector:
    """Reads a script by a language model.

    Args:
        answerer: The model, or a person in its place.
        rules: Cuts the page into units, and gives the second opinion.
        embedder: Likeness of meaning; chooses the vocabulary of a request.
    """

    def __init__(self, answerer: Answerer, rules: RulesDirector, embedder: Callable[[], Embedder]) -> None:
        self._asker = Asker(answerer, "director", SceneNotes)
        self._rules, self._embedder = rules, embedder
        self._notes: dict[int, SceneNotes] = {}

    def propose(self, view: Screenplay) -> Reading:
        """Return the reading of a script. Raises NoAnswer or AnswerAwaited."""
        self._notes.clear()
        return self._read(view, {})

    def refine(self, draft: Reading, critique: Critique, view: Screenplay) -> Reading:
        """Return the reading with the scenes read again in which the critic found faults.

        Args:
            draft: The reading.
            critique: Its faults; their subjects are units.
            view: The script.
        """
        wrong: dict[int, list[str]] = {}
        for fault in critique.faults:
            number = fault.subject.removeprefix("unit ")
            if fault.subject.startswith("unit ") and number.isdigit():
                wrong.setdefault(int(number), []).append(fault.message)
        return self._read(view, wrong)

    def _read(self, script: Screenplay, wrong: dict[int, list[str]]) -> Reading:
        """Ask for every part that has no answer yet or is wrong; ``wrong`` has sentences by number of the unit."""
        page = self._rules.propose(script)
        reading = Reading(script, age=page.age)
        for part in _parts(page):
            faults = tuple(
                sentence for number in range(part.first, part.first + len(part.units))
                for sentence in wrong.get(number, ())
            )  # fmt: skip
            notes = self._notes.get(part.number)
            if notes is None or faults:
                notes = self._asked(part, page, reading, notes, faults)
                self._notes[part.number] = notes
            _add(reading, page, part, notes)
        _add_fixtures(reading)
        read = {scene.id: scene for scene in reading.scenes}
        reading.scenes = [read.get(scene.id, scene) for scene in page.scenes]
        reading.flags = list(differences(reading, page))
        return reading_with_fixtures(reading)

    def _asked(
        self, part: _Part, page: Reading, so_far: Reading, before: SceneNotes | None, faults: tuple[str, ...]
    ) -> SceneNotes:
        """Return the notes on a part; ``before`` is the answer that the faults are about."""
        return self._asker.ask(
            f"scene {page.scenes[part.scene].id} from unit {part.first}",
            self._shown(part, page, so_far),
            lambda notes: _wrong(notes, part, so_far),
            previous=before.model_dump_json(exclude_defaults=True) if before is not None and faults else "",
            feedback=faults,
        )

    def _shown(self, part: _Part, page: Reading, so_far: Reading) -> dict[str, Any]:
        """Return what the model is shown of a part."""
        scene = page.scenes[part.scene]
        heading = scene.heading or scene.place
        action = [unit.text for unit in part.units if unit.kind == "action"]
        kits = {choose_kit(scene, (), "", page.age), *self._nearest_kits([heading]), *self._nearest_kits(action)}
        after = part.first - 1 + len(part.units)
        earlier = so_far.units[-1] if so_far.units and so_far.units[-1].scene == part.scene else None
        return {
            "title": page.screenplay.title,
            "scene": {"number": scene.id, "heading": heading},
            "script": page.screenplay.text[part.units[0].start : part.units[-1].end],
            "on_stage_before": earlier.on_stage if earlier is not None else [],
            "units": [_shown_unit(number, unit) for number, unit in enumerate(part.units, start=part.first)],
            "coming": [unit.text for unit in page.units[after : after + _COMING]],
            "cast_so_far": [_shown_person(person) for person in so_far.people],
            "things_so_far": {thing.id: thing.name for thing in so_far.things},
            "places_so_far": [
                {"number": each.id, "heading": each.heading or each.place, "kit": each.kit} for each in so_far.scenes
            ],
            "parts_of_any_set": _FIXTURES,
            "kits": {kit.key: f"{kit.name}. {kit.description}".strip() for kit in SETS.values() if kit.key in kits},
            "other_kits": [key for key in SETS if key not in kits],
            "motions": sorted(MOTION_KEYS),
        }  # fmt: skip

    def _nearest_kits(self, texts: list[str]) -> list[str]:
        """Return the keys of the set kits nearest in meaning to some texts."""
        return [kit.key for kit in nearest_entries(SETS.values(), texts, self._embedder(), _KITS)]


def _parts(page: Reading) -> list[_Part]:
    """Return the script in parts, in order: each scene, or forty units of a longer one."""
    parts: list[_Part] = []
    numbered = enumerate(page.units, start=1)
    for scene, group in groupby(numbered, key=lambda pair: pair[1].scene):
        run = list(group)
        for start in range(0, len(run), _MOST_UNITS):
            chosen = run[start : start + _MOST_UNITS]
            parts.append(_Part(len(parts), scene, tuple(unit for _, unit in chosen), chosen[0][0]))
    return parts


def _shown_unit(number: int, unit: Unit) -> dict[str, Any]:
    told = {"number": number, "kind": unit.kind, "text": unit.text}
    if unit.kind == "dialogue":
        told |= {"speaker": unit.speaker_name, "parenthetical": unit.parenthetical}
    if unit.camera is not None:
        told["camera"] = unit.camera.phrase
    return {name: value for name, value in told.items() if value}


def _shown_person(person: Person) -> dict[str, Any]:
    told = {"id": person.id, "name": person.name, "kind": person.kind, "gender": person.gender, "age": person.age}
    looks = [*person.build, *person.hair, *person.outfit, *person.face]
    return {name: value for name, value in (told | {"role": person.role, "looks": looks}).items() if value}


def _wrong(notes: SceneNotes, part: _Part, so_far: Reading) -> Iterator[str]:
    """Yield what no schema can say of an answer: units that are missing, names that do not exist."""
    wanted = [*range(part.first, part.first + len(part.units))]
    given = [unit.number for unit in notes.units]
    if given != wanted:
        yield f"units must be numbered {wanted[0]} to {wanted[-1]}, each once and in order; they are {given}"
        return
    if notes.place.kit not in SETS:
        yield f"there is no kit {notes.place.kit!r}; take one of `kits` or `other_kits`"
    earlier = {scene.id: scene.kit for scene in so_far.scenes}
    same = notes.place.same_place_as
    if same is not None and same not in earlier:
        yield f"same_place_as {same} is no scene of `places_so_far`; leave it out"
    elif same is not None and earlier[same] != notes.place.kit:
        yield f"scene {same} has the kit {earlier[same]!r}; take the same kit, or leave same_place_as out"
    people = {each.id for each in (*so_far.people, *notes.people)}
    known = people | {each.id for each in (*so_far.things, *notes.things)} | {*_FIXTURES}
    for relation in notes.relations:
        for each in (relation.asset_id, relation.anchor_asset_id, relation.second_anchor_asset_id):
            if each is not None and each not in known:
                yield f"a relation names {each!r}, which is neither in `people` nor in `things`; add it or leave it out"
    for unit, noted in zip(part.units, notes.units, strict=True):
        name = f"unit {noted.number}"
        for kind, unknown in dict.fromkeys(unknown_names(annotated_unit(unit, noted, 0), people, known)):
            mend = "take one of `motions`" if kind == "motion" else "add it to `people` or `things`, or take another"
            yield f"{name} names the {kind} {unknown!r}, which does not exist; {mend}"
        done_to = (each for deed in noted.deeds for each in (deed.target, deed.prop))
        for each in dict.fromkeys(each for each in done_to if each is not None and each not in known):
            yield f"a deed of {name} names {each!r}, which is neither in `people` nor in `things`; add it"
        if unit.kind == "dialogue" and noted.speaker is None:
            yield f"{name} is a speech and has no speaker"
        if noted.speaker is not None and noted.speaker not in noted.on_stage and not noted.off_screen:
            yield f"{noted.speaker} speaks in {name}, and is neither on_stage nor off_screen"


def _add(reading: Reading, page: Reading, part: _Part, notes: SceneNotes) -> None:
    """Add the notes on a part to the reading."""
    scene = page.scenes[part.scene]
    start = part.units[0].start
    if all(each.id != scene.id for each in reading.scenes):
        reading.scenes.append(annotated_scene(scene, _with_reference(notes.place, reading)))
    for told in notes.people:
        _merge_person(reading.people, person_of(told, start))
    for thing in notes.things:
        if all(each.id != thing.id for each in reading.things):
            reading.things.append(thing_of(thing, start))
    reading.relations += [(part.scene, each) for each in notes.relations]
    for unit, noted in zip(part.units, notes.units, strict=True):
        reading.units.append(annotated_unit(unit, noted, _PICTURES * part.number))
    speakers = {unit.speaker for unit in reading.units}
    for index, person in enumerate(reading.people):
        reading.people[index] = replace(person, speaks=person.id in speakers)


def _add_fixtures(reading: Reading) -> None:
    """Add the doors and windows to the things that units name without listing them."""
    named = {relation.anchor_asset_id: 0 for _, relation in reading.relations if relation.anchor_asset_id in _FIXTURES}
    for unit in reading.units:
        done_to = (each for deed in unit.deeds for each in (deed.target, deed.prop))
        anchors = (each for spot in unit.spots.values() for each in (spot.anchor_id, spot.facing))
        supports = (support for _, support in unit.posture.values())
        changed = (change.subject for change in unit.changes)
        for each in (*unit.things, *unit.absent, *unit.gaze.values(), *done_to, *anchors, *supports, *changed):
            if each in _FIXTURES:
                named.setdefault(each, unit.start)
    listed = {thing.id for thing in reading.things}
    reading.things += [
        Thing(each, each, kind="set_piece", first=first) for each, first in named.items() if each not in listed
    ]


def _with_reference(place: PlaceNotes, reading: Reading) -> PlaceNotes:
    """Return a place with the first scene there as its reference, so that all scenes in it share one set."""
    if place.same_place_as is None:
        return place
    first = next(scene for scene in reading.scenes if scene.id == place.same_place_as)
    return place.model_copy(update={"same_place_as": first.reference or first.id, "kit": first.kit})


def _merge_person(people: list[Person], told: Person) -> None:
    """Add a new person, or what is new about a known person."""
    for index, known in enumerate(people):
        if known.id == told.id:
            lists = ("aliases", "build", "hair", "outfit", "face")
            looks = {name: tuple(dict.fromkeys((*getattr(known, name), *getattr(told, name)))) for name in lists}
            people[index] = replace(
                known, **looks, age=known.age or told.age, role=known.role or told.role,
                gender=told.gender if known.gender == "unknown" else known.gender, count=max(known.count, told.count),
            )  # fmt: skip
            return
    people.append(told)
