"""The rule-based reader of the Director: a screenplay becomes a Reading in one pass."""

from __future__ import annotations

import math
import re
from collections import Counter

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.action import read_action
from storyblender.agents.director.reader.bearing.calls import keep_calls
from storyblender.agents.director.reader.cast.foreign_cast import add_foreign
from storyblender.agents.director.reader.cast.prose_cast import find_prose_cast
from storyblender.agents.director.reader.cast.screenplay_cast import find_screenplay_cast
from storyblender.agents.director.reader.deeds.entrances import carry_over_people, restore_people
from storyblender.agents.director.reader.deeds.exits import clear_exits
from storyblender.agents.director.reader.era import age_of
from storyblender.agents.director.reader.foreign import read_foreign
from storyblender.agents.director.reader.inserts import locate_insert, note_insert
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.manuscript import Manuscript, open_manuscript
from storyblender.agents.director.reader.page.cutting import cut_page
from storyblender.agents.director.reader.page.sentences import Sentence
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.reader.props import Inventory
from storyblender.agents.director.reader.reasons import page_facts, stage_facts
from storyblender.agents.director.reader.speech import read_parenthetical_action, read_speech
from storyblender.agents.director.reader.state import ReaderState, SceneState
from storyblender.agents.director.reading import CameraNote, Person, Reading, Unit
from storyblender.agents.director.rules import as_rule, rule, watch_facts
from storyblender.memory.vocabulary import Gender
from storyblender.screenplay.model import Screenplay

_THROUGH = re.compile(r"window|binocular|scope|keyhole|screen|glass|monitor", re.IGNORECASE)
"""What a POV looks through at somewhere else."""
_SURFACES = lexicon.words("surfaces")
"""What things lie on or in without being an asset: the floor, a corner."""
_CARRIED = 8
"""Words at the start of a prose scene in which a pronoun brings the people of the last scene along."""


_TOWARDS_OTHERS = frozenset({"at", "to", "toward", "towards"})
"""``gives it to her``: one is not what one's own deed goes to."""


def read_script(screenplay: Screenplay) -> Reading:
    """Return the reading of a script by rules, without a language model.

    Args:
        screenplay: Any format.

    Returns:
        People, things, scenes and units with offsets into ``screenplay.text``; what was a guess is flagged.
    """
    script = open_manuscript(screenplay)
    reading = Reading(screenplay, age=age_of(screenplay))
    watch_facts(lambda: page_facts(reading))
    with as_rule("people.described", 0, len(script.text)):
        roster = _find_people(script, reading)
    sentences = cut_page(script, roster, reading.scenes)
    _guess_genders(sentences, roster, script.prose)
    state = ReaderState(roster, Inventory(roster.ids), reading, script.tongue, age=reading.age)
    watch_facts(lambda: stage_facts(state))
    if script.tongue:
        reason = f"the page is in {script.tongue.name}: what people do is told by a table of common words"
        state.flag("language", script.tongue.key, reason, 0, 0)
    for sentence in sentences:
        with as_rule("page.sentence", sentence.start, sentence.end):
            _read(state, sentence)
    _finish_reading(state)
    return reading


def _find_people(script: Manuscript, reading: Reading) -> Roster:
    """Return the cast, with the looks that are told beside their names."""
    roster = find_prose_cast(script) if script.prose else find_screenplay_cast(script)
    add_foreign(roster, script)
    roster.index()
    reading.people = roster.people
    return roster


@rule("people.gender_by_pronouns")
def _guess_genders(sentences: list[Sentence], roster: Roster, prose: bool) -> None:
    """Set unknown genders by vote: pronouns after the only name of a sentence, or in the next one."""
    votes: dict[str, Counter[str]] = {person.id: Counter() for person in roster.people}
    last: str | None = None
    for sentence in sentences:
        named = [
            (index, word.mention.candidates[0])
            for index, word in enumerate(sentence.words)
            if word.mention
            and len(word.mention.candidates) == 1
            and word.mention.kind != "group"
            and word.mention.candidates[0] is not roster.narrator
        ]
        if sentence.speech and not prose:
            last = None
            continue
        first = lexicon.PRONOUNS.get(sentence.words[0].low) if sentence.words else None
        before = roster.person(last or "")
        animal = before is not None and before.kind == "animal"
        if last and not animal and first in ("male", "female"):
            votes[last][first] += 1
        alone = len({person.id for _, person in named}) == 1
        if alone:
            start, one = named[0]
            voting = ("he", "she") if one.kind == "animal" else tuple(lexicon.PRONOUNS)
            own = (w for at, w in enumerate(sentence.words) if at >= start and not _is_other_person(sentence.words, at))
            kinds = (lexicon.PRONOUNS[word.low] for word in own if word.low in voting)
            votes[one.id].update(kind for kind in kinds if kind in ("male", "female"))
        gendered = any(lexicon.PRONOUNS.get(word.low) in ("male", "female") for word in sentence.words)
        last = named[0][1].id if alone and not gendered else None
    for person in roster.people:
        count = votes[person.id]
        gender, most = count.most_common(1)[0] if count else ("", 0)
        fewest, share = _enough_votes(person)
        if most >= fewest and most > share * count.total():
            person.gender = _as_gender(gender)


def _enough_votes(person: Person) -> tuple[float, float]:
    """Return the number and the share of pronouns that outweigh a person's name or role."""
    if person.gender == "unknown":
        return 1, 0.6
    if lexicon.gender_of_word(person.role) != "unknown":
        return math.inf, 1.0
    names = set(person.aliases)
    return (2, 0.6) if names & lexicon.UNISEX else (3, 0.9) if names & lexicon.FIRST_NAMES else (math.inf, 1.0)


def _is_other_person(words: list[Word], at: int) -> bool:
    """Whether ``her`` is another person: ``watches her``, ``talks to her``, but not ``her ear`` or ``behind her``."""
    if not at or words[at - 1].low in lexicon.PREPOSITIONS - _TOWARDS_OTHERS:
        return False
    after = words[at + 1] if at + 1 < len(words) else None
    noun = after is not None and after.solid and after.low not in lexicon.PREPOSITIONS | lexicon.CONJUNCTIONS
    return words[at].low == "him" or (words[at].low == "her" and not noun)


def _as_gender(word: str) -> Gender:
    """Return the gender of a pronoun, or ``unknown``."""
    return "female" if word == "female" else "male"


def _read(state: ReaderState, sentence: Sentence) -> None:
    """Read one sentence into a new unit, and note who and what is there after it."""
    state.discourse.next_sentence()
    units = state.reading.units
    if not units or units[-1].scene != sentence.scene:
        _open_scene(state, sentence)
    elif units:
        clear_exits(state)
    text = state.reading.screenplay.text
    start = max(sentence.paragraph.start, len(text[: sentence.start].rstrip("_*")))
    unit = Unit(
        sentence.beside or "action",
        sentence.scene,
        sentence.paragraph.element,
        start,
        sentence.end,
        text[start : sentence.end],
        picture=sentence.paragraph.picture,
    )
    units.append(unit)
    if sentence.beside:
        _keep_people(state, sentence)
        return
    shown = _note_camera(state, sentence.camera) if sentence.camera else None
    if sentence.words and state.tongue:
        read_foreign(state, sentence, state.tongue)
    elif sentence.words:
        _read_action(state, sentence)
    if shown and not unit.deeds:
        locate_insert(state, shown, sentence.words)
    if sentence.speech:
        read_speech(state, sentence, sentence.speech)
        read_parenthetical_action(state, sentence, sentence.speech)
    if (
        sentence.camera
        and sentence.camera.kind == "pov"
        and _THROUGH.search(sentence.camera.phrase + sentence.camera.subject)
    ):
        state.scene.leaving += [person for person in unit.entering if person not in state.scene.leaving]
    unit.leaving = list(state.scene.leaving)
    _write_present(state)


def _read_action(state: ReaderState, sentence: Sentence) -> None:
    """Read the action of a sentence, in English or in the language of the script."""
    if state.reading.screenplay.format != "prose":
        carry_over_people(state, sentence)
    read_action(state, sentence)


def _keep_people(state: ReaderState, sentence: Sentence) -> None:
    """Keep all people in place for on-screen text, sounds and asides."""
    unit = state.unit
    if sentence.beside == "sound":
        unit.sounds = [" ".join(unit.text.split())]
    _write_present(state)


def _write_present(state: ReaderState) -> None:
    """Write the people present, their postures and the things they hold into the unit."""
    unit = state.unit
    keep_calls(state)
    unit.on_stage = list(state.scene.on)
    unit.posture = dict(state.scene.posture)
    unit.held = {person: list(things) for person, things in state.scene.held.items() if things}


@rule("camera.subject")
def _note_camera(state: ReaderState, camera: CameraNote) -> str | None:
    """Note a camera direction: the person it shows or sees through is on stage. Return the person shown, or None."""
    state.unit.camera = camera
    person = None
    for name, shown in ((camera.who, False), (camera.subject, True)):
        person = state.find(name) if name else None
        if person:
            state.enter(person)
            state.add_to_unit(person)
            state.mention(person, 1.0)
            if shown:
                state.discourse.subjects = [person]
    return None if person else note_insert(state, camera)


@rule("people.carried_over")
def _open_scene(state: ReaderState, sentence: Sentence) -> None:
    """Begin a scene: note who may come along, and forget the rest."""
    prose = state.reading.screenplay.format == "prose"
    before = state.scene
    state.intercut = state.intercut and not state.reading.scenes[sentence.scene].heading
    state.scene = SceneState(sentence.scene, before=_able_to_go_on(before))
    state.inventory.open_scene(sentence.start)
    first = [word.low for word in sentence.words[:_CARRIED]]
    if prose and sentence.scene and any(word in ("they", "he", "she", "it", "i", "we") for word in first):
        state.scene.on = [person for person in before.on if person not in before.leaving]
        single = next(
            (lexicon.PRONOUNS.get(word, "") for word in first if word in ("they", "he", "she", "i", "we", "it")), ""
        )
        if single in ("male", "female"):
            state.scene.on = _main_person(state, state.scene.on, single)
    elif before.index != sentence.scene:
        restore_people(state)
    state.discourse.next_scene(keep_groups=prose)


def _able_to_go_on(scene: SceneState) -> list[str]:
    """Return the people on stage at the end of a scene who can come along: not those who left or lie there."""
    down = {person for person, (posture, on) in scene.posture.items() if posture in ("lie", "asleep") and on is None}
    return [person for person in scene.on if person not in down | {*scene.leaving}]


def _main_person(state: ReaderState, people: list[str], gender: str) -> list[str]:
    """Return the person of a gender whom the story tells most of: ``That night she``."""
    told = Counter(id for unit in state.reading.units for id in unit.people)
    fitting = [id for id in people if (person := state.person(id)) and person.gender == gender]
    return [max(fitting, key=lambda id: told[id])] if len(fitting) > 1 else people


def _finish_reading(state: ReaderState) -> None:
    """Write the asset sheet, drop targets that are not on it, and flag unknown nouns."""
    reading = state.reading
    for thing, unknown in state.inventory.story_things([relation for _, relation in reading.relations]):
        reading.things.append(thing)
        if unknown:
            end = thing.first + len(thing.name)
            state.flag("prop", thing.id, f"“{thing.name}” is not a word the reader knows", thing.first, end)
    known = {thing.id for thing in reading.things} | {person.id for person in reading.people}
    parts = state.inventory.parts()
    placed = known | {
        thing
        for thing in state.inventory.ids()
        if state.inventory.head(thing) in _SURFACES or state.inventory.class_of(thing) == "worn"
    }
    reading.relations[:] = [
        (scene, relation)
        for scene, relation in reading.relations
        if {relation.asset_id, relation.anchor_asset_id, relation.second_anchor_asset_id or relation.asset_id} <= placed
    ]
    for unit in reading.units:
        unit.things = [thing for thing in unit.things if thing in known]
        unit.spots = {each: spot for each, spot in unit.spots.items() if {each, spot.anchor_id or each} <= placed}
        unit.changes = [change for change in unit.changes if change.subject in known | {"light"}]
        unit.held = {person: kept for person, held in unit.held.items() if (kept := [t for t in held if t in known])}
        unit.posture = {
            person: (posture, support if support in known else None)
            for person, (posture, support) in unit.posture.items()
        }
        for deed in unit.deeds:
            deed.target = deed.target if deed.target in known | parts else deed.prop if deed.prop in parts else None
            deed.prop = deed.prop if deed.prop in known else None
    furniture = {thing.id for thing in reading.things if thing.kind == "set_piece"}
    for unit in reading.units:
        shown = reading.scenes[unit.scene].furniture
        shown += [thing for thing in unit.things if thing in furniture and thing not in shown]
