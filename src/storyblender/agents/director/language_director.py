"""The Director played by a language model: it annotates the units of the page scene by scene, and never rewrites them.

The page reader cuts the script into numbered units; the model says what each of them shows. Cast, things and places
run along from scene to scene, so that a request stays small however long the script is. The rules' own reading is the
second opinion: where the two differ on cast, places or things, a flag says so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from itertools import chain, groupby
from typing import Any, TypeVar, get_args

from storyblender.agents.asking import Asker
from storyblender.agents.director.annotation import (
    DIRECTORS_PICTURES,
    PlaceNotes,
    SceneNotes,
    UnitNotes,
    annotated_scene,
    annotated_unit,
    new_scene,
    person_of,
    thing_of,
    with_speakers,
)
from storyblender.agents.director.custody import Custody, things_in_hands, with_things_in_hands
from storyblender.agents.director.directions import camera_notes_by_unit, camera_words
from storyblender.agents.director.director import RulesDirector
from storyblender.agents.director.kit_choice import choose_kit
from storyblender.agents.director.reading import CameraNote, Person, Reading, Thing, Unit, ids_in
from storyblender.agents.director.reading_file import reading_with_fixtures, unknown_names, unknown_sets
from storyblender.agents.director.second_opinion import differences
from storyblender.agents.nearest import nearest_entries
from storyblender.catalog.fixtures import named_pieces
from storyblender.catalog.motions import MOTIONS, motion_words
from storyblender.catalog.sets import SETS, plan_of
from storyblender.memory.scene_context import Environment
from storyblender.memory.vocabulary import SceneType
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import Critique
from storyblender.screenplay.model import Screenplay

Place = TypeVar("Place", bound=PlaceNotes)

_MOST_UNITS = 40
"""Units in one request; a longer scene is read in parts."""
_KITS = 6
"""Set kits nearest to the heading, and to the action, that a request describes; of the others it has the keys."""
_COMING = 6
"""Units of the next scene that a request shows, so that nothing is staged that they contradict."""
_SHOWN_MOTIONS = {key: motion_words(key) for key in sorted(MOTIONS)}
"""Motions by key, with what they are and what target and prop mean."""
_FIXTURES = ("door", "window")
"""Parts of any set that may be named without being listed."""


@dataclass(frozen=True)
class _Part:
    """A run of units of one scene that is read in one request."""

    number: int
    scene: int
    """Index of its scene on the page."""
    units: tuple[Unit, ...]
    first: int
    """Number of its first unit."""
    goes_on: bool
    """Whether its scene began in the part before."""


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
        reading.units = with_speakers(with_things_in_hands(reading.units, reading.things), reading.people)
        reading.flags = list(differences(reading, page))
        return reading_with_fixtures(reading)

    def _asked(
        self, part: _Part, page: Reading, so_far: Reading, before: SceneNotes | None, faults: tuple[str, ...]
    ) -> SceneNotes:
        """Return the notes on a part; ``before`` is the answer that the faults are about."""
        return self._asker.ask(
            f"scene {page.scenes[part.scene].id} from unit {part.first}",
            self._shown(part, page, so_far),
            lambda notes: _wrong(notes, part, page, so_far),
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
        text, written = page.screenplay.text, camera_notes_by_unit(page)
        return {
            "title": page.screenplay.title,
            "scene": {"number": len(so_far.scenes) + (not part.goes_on), "heading": heading},
            "script": text[part.units[0].start : part.units[-1].end],
            "goes_on_from": _standing(so_far) if part.goes_on else None,
            "units": [
                _shown_unit(number, unit, text, written.get(number - 1))
                for number, unit in enumerate(part.units, start=part.first)
            ],
            "coming": [unit.text for unit in page.units[after : after + _COMING]],
            "cast_so_far": [_shown_person(person) for person in so_far.people],
            "things_so_far": {thing.id: thing.name for thing in so_far.things},
            "places_so_far": [
                {"number": each.id, "heading": each.heading or each.place, "kit": each.kit} for each in so_far.scenes
            ],
            "parts_of_any_set": _FIXTURES,
            "kits": {key: _shown_kit(key) for key in SETS if key in kits},
            "other_kits": {
                sort: [key for key in SETS if key not in kits and _sort_of(key) == sort]
                for sort in get_args(SceneType)
            },
            "motions": _SHOWN_MOTIONS,
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
            parts.append(_Part(len(parts), scene, tuple(unit for _, unit in chosen), chosen[0][0], start > 0))
    return parts


def _standing(reading: Reading) -> dict[str, Any]:
    """Return the place of the last scene so far, and how people and things in it are when its last unit ends."""
    scene, last = reading.scenes[-1], reading.units[-1]
    states: dict[str, dict[str, Any]] = {each: {} for each in last.on_stage if each not in last.leaving}
    for unit in reading.units:
        if unit.scene != last.scene:
            continue
        for each, (posture, support) in unit.posture.items():
            states.setdefault(each, {}).update(posture=posture, on=support)
        for name, values in (("holds", unit.held), ("looks_at", unit.gaze), ("activity", unit.activities)):
            for each, value in values.items():
                states.setdefault(each, {})[name] = value
        for each, spot in unit.spots.items():
            states.setdefault(each, {})["spot"] = spot.model_dump(mode="json", exclude_defaults=True)
    return {"kit": scene.kit, "time": scene.time, "states": states, "absent": last.absent}


@cache
def _shown_kit(key: str) -> str:
    """Return name, description, furniture, built-in pieces and options of a set kit."""
    kit, plan = SETS[key], plan_of(Environment(kit=key))
    near, far = named_pieces(plan)
    lists = (
        ("Has", dict.fromkeys(each.prop.replace("_", " ") for each in plan.furnishings)),
        ("Built in:", near),
        ("Beyond the playing area:", far),
        ("Options:", kit.options),
    )
    told = (f"{words} {', '.join(names)}." for words, names in lists if names)
    return " ".join(filter(None, (f"{kit.name}, {_sort_of(key)}.", kit.description, *told)))


def _sort_of(key: str) -> SceneType:
    """Return whether a set kit is indoor or outdoor."""
    return "indoor" if SETS[key].indoor else "outdoor"


def _shown_unit(number: int, unit: Unit, script: str, camera: CameraNote | None) -> dict[str, Any]:
    """Return a unit as the model is shown it; where a speech is mixed with action, also as it is written."""
    told = {"number": number, "kind": unit.kind, "text": unit.text}
    written = script[unit.start : unit.end]
    if " ".join(written.split()) != " ".join(unit.text.split()):
        told["written"] = written
    if unit.kind == "dialogue":
        told |= {"speaker": unit.speaker_name, "parenthetical": unit.parenthetical}
    if camera is not None:
        told["camera"] = camera_words(camera)
    return {name: value for name, value in told.items() if value}


def _shown_person(person: Person) -> dict[str, Any]:
    """Return a person as the model is shown them."""
    told: dict[str, Any] = {name: getattr(person, name) for name in ("id", "name", "kind", "gender", "age", "role")}
    told["looks"] = [*person.build, *person.hair, *person.outfit, *person.face]
    told["count"] = person.count if person.kind == "group" else None
    return {name: value for name, value in told.items() if value}


def _wrong(notes: SceneNotes, part: _Part, page: Reading, so_far: Reading) -> Iterator[str]:
    """Yield what no schema can say of an answer: units that are missing, names that do not exist."""
    wanted = [*range(part.first, part.first + len(part.units))]
    given = [unit.number for unit in notes.units]
    if given != wanted:
        yield f"units must be numbered {wanted[0]} to {wanted[-1]}, each once and in order; they are {given}"
        return
    yield from _wrong_places(notes, part, page, so_far)
    people = {each.id for each in (*so_far.people, *notes.people)}
    known = people | {each.id for each in (*so_far.things, *notes.things)} | {*_FIXTURES}
    begun = (unit.new_scene.relations for unit in notes.units if unit.new_scene is not None)
    for relation in chain(notes.relations, *begun):
        for each in (relation.asset_id, relation.anchor_asset_id, relation.second_anchor_asset_id):
            if each is not None and each not in known:
                yield f"a relation names {each!r}, which is neither in `people` nor in `things`; add it or leave it out"
    yield from _wrong_hands(notes, part, so_far)
    for unit, noted in zip(part.units, notes.units, strict=True):
        name = f"unit {noted.number}"
        for kind, unknown in dict.fromkeys(unknown_names(annotated_unit(unit, noted, 0, 0), people, known)):
            mend = "take one of `motions`" if kind == "motion" else "add it to `people` or `things`, or take another"
            yield f"{name} names the {kind} {unknown!r}, which does not exist; {mend}"
        done_to = (each for deed in noted.deeds for each in (deed.target, deed.prop))
        for each in dict.fromkeys(each for each in done_to if each is not None and each not in known):
            yield f"a deed of {name} names {each!r}, which is neither in `people` nor in `things`; add it"
        for deed in noted.deeds:
            if deed.prop is not None and deed.prop == deed.target:
                yield f"a deed of {name} is done to {deed.target!r} with {deed.prop!r} itself; leave one of them out"
        for state in noted.states:
            if state.on is not None and state.posture is None:
                yield f"{name} says what {state.id} is `on`, and no `posture`; say both"
        if unit.kind == "dialogue" and noted.speaker is None:
            yield f"{name} is a speech and has no speaker"
        if noted.speaker is not None and noted.speaker not in noted.on_stage and not noted.off_screen:
            yield f"{noted.speaker} speaks in {name}, and is neither on_stage nor off_screen"


def _wrong_hands(notes: SceneNotes, part: _Part, so_far: Reading) -> Iterator[str]:
    """Yield what of an answer cannot be with the things in people's hands."""
    new = (thing_of(thing, 0) for thing in notes.things)
    things = {thing.id: thing for thing in (*new, *so_far.things)}
    custody = Custody(*things_in_hands([*things.values()]))
    if part.goes_on:
        for number, unit in enumerate(so_far.units, start=1):
            if unit.scene == so_far.units[-1].scene:
                custody.play(unit, number)
    for unit, noted in zip(part.units, notes.units, strict=True):
        if noted.new_scene is not None:
            custody = Custody(custody.things, custody.shared)
        yield from custody.play(annotated_unit(unit, noted, 0, 0), noted.number)


def _wrong_places(notes: SceneNotes, part: _Part, page: Reading, so_far: Reading) -> Iterator[str]:
    """Yield what is wrong with the places of an answer: kits, options and scenes that do not exist."""
    earlier = {scene.id: scene.kit for scene in so_far.scenes}
    if part.goes_on and notes.place.kit != so_far.scenes[-1].kit:
        yield f"the scene goes on with the kit {so_far.scenes[-1].kit!r}; begin another with `new_scene`"
    if not part.goes_on and notes.units[0].new_scene is not None:
        yield f"unit {part.first} is the first of its scene; its place is `place`, not `new_scene`"
    places = [] if part.goes_on else [("place", notes.place)]
    places += [
        (f"new_scene of unit {unit.number}", unit.new_scene) for unit in notes.units if unit.new_scene is not None
    ]
    for number, (name, place) in enumerate(places, start=len(so_far.scenes) + 1):
        if place.kit not in SETS:
            yield f"{name}: there is no kit {place.kit!r}; take one of `kits` or `other_kits`"
            continue
        if _sort_of(place.kit) != place.scene_type:
            yield (
                f"{name}: the kit {place.kit!r} is {_sort_of(place.kit)}, and scene_type is {place.scene_type!r}; "
                f"say {_sort_of(place.kit)!r} if the camera is there with the people, else take another kit"
            )
        for unknown, mend in unknown_sets(annotated_scene(page.scenes[part.scene], number, place)):
            yield f"{name} has {unknown}; {mend}"
        same = place.same_place_as
        if same is not None and same not in earlier:
            yield f"{name}: same_place_as {same} is no scene before it; leave it out"
        elif same is not None and earlier[same] != place.kit:
            yield f"{name}: scene {same} has the kit {earlier[same]!r}; take the same kit, or leave same_place_as out"
        earlier[number] = place.kit


def _add(reading: Reading, page: Reading, part: _Part, notes: SceneNotes) -> None:
    """Add the notes on a part to the reading."""
    scene, start = page.scenes[part.scene], part.units[0].start
    if not part.goes_on:
        place = _with_reference(notes.place, reading)
        reading.scenes.append(annotated_scene(scene, len(reading.scenes) + 1, place))
    for told in notes.people:
        _merge_person(reading.people, person_of(told, start))
    for thing in notes.things:
        if all(each.id != thing.id for each in reading.things):
            reading.things.append(thing_of(thing, start))
    reading.relations += [(len(reading.scenes) - 1, each) for each in notes.relations]
    for unit, noted in zip(part.units, notes.units, strict=True):
        _begin_scene(reading, unit, noted)
        reading.units.append(
            annotated_unit(unit, noted, len(reading.scenes) - 1, DIRECTORS_PICTURES * (part.number + 1))
        )
    speakers = {unit.speaker for unit in reading.units}
    for index, person in enumerate(reading.people):
        reading.people[index] = replace(person, speaks=person.id in speakers)


def _begin_scene(reading: Reading, unit: Unit, noted: UnitNotes) -> None:
    """Begin another scene with a unit, if its notes say so; the scene before ends there."""
    if noted.new_scene is None:
        return
    before = reading.scenes[-1]
    place = _with_reference(noted.new_scene, reading)
    reading.scenes[-1] = replace(before, end=unit.start)
    reading.relations += [(len(reading.scenes), each) for each in noted.new_scene.relations]
    reading.scenes.append(new_scene(len(reading.scenes) + 1, place, unit.start, before.end))


def _add_fixtures(reading: Reading) -> None:
    """Add the doors and windows to the things that units name without listing them."""
    named = {relation.anchor_asset_id: 0 for _, relation in reading.relations if relation.anchor_asset_id in _FIXTURES}
    for unit in reading.units:
        for each in ids_in(unit) & {*_FIXTURES}:
            named.setdefault(each, unit.start)
    listed = {thing.id for thing in reading.things}
    reading.things += [
        Thing(each, each, kind="set_piece", first=first) for each, first in named.items() if each not in listed
    ]


def _with_reference(place: Place, reading: Reading) -> Place:
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
