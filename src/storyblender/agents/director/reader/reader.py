"""The rule-based reader of the Director: a screenplay becomes a Reading, in one pass in reading order."""

from __future__ import annotations

import math
import re
from collections import Counter

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.action import read_action
from storyblender.agents.director.reader.bearing.calls import keep_calls
from storyblender.agents.director.reader.cast.foreign_cast import add_foreign
from storyblender.agents.director.reader.cast.prose_cast import find_prose_cast
from storyblender.agents.director.reader.cast.screenplay_cast import find_cast
from storyblender.agents.director.reader.deeds.entrances import bring_along, come_back
from storyblender.agents.director.reader.deeds.exits import clear_exits
from storyblender.agents.director.reader.era import age_of
from storyblender.agents.director.reader.foreign import read_foreign
from storyblender.agents.director.reader.inserts import lies_there, show_thing
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.manuscript import Manuscript, open_manuscript
from storyblender.agents.director.reader.page.cutting import cut_page
from storyblender.agents.director.reader.page.sentences import Sentence
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.reader.props import Inventory
from storyblender.agents.director.reader.reasons import page_facts, stage_facts
from storyblender.agents.director.reader.speech import act_beside, speak
from storyblender.agents.director.reader.state import SceneState, Stage
from storyblender.agents.director.reading import CameraNote, Person, Reading, Unit
from storyblender.agents.director.rules import by_rule, rule, watch
from storyblender.memory.vocabulary import Gender
from storyblender.screenplay.model import Screenplay

_THROUGH = re.compile(r"window|binocular|scope|keyhole|screen|glass|monitor", re.IGNORECASE)
"""What a POV looks through at somewhere else."""
_SURFACES = lexicon.words("surfaces")
"""What things lie on or in without being an asset: the floor, a corner."""
_CARRIED = 8
"""Words at the start of a prose scene in which a pronoun brings the people of the last scene along."""


def read_script(screenplay: Screenplay) -> Reading:
    """Understand a script without a language model.

    Args:
        screenplay: Any format.

    Returns:
        People, things, scenes and units with offsets into ``screenplay.text``; what was a guess is flagged.
    """
    script = open_manuscript(screenplay)
    reading = Reading(screenplay, age=age_of(screenplay))
    watch(lambda: page_facts(reading))
    with by_rule("people.described", 0, len(script.text)):
        roster = _find_people(script, reading)
    sentences = cut_page(script, roster, reading.scenes)
    _guess_genders(sentences, roster, script.prose)
    stage = Stage(roster, Inventory(roster.ids), reading, script.tongue, age=reading.age)
    watch(lambda: stage_facts(stage))
    if script.tongue:
        reason = f"the page is in {script.tongue.name}: what people do is told by a table of common words"
        stage.flag("language", script.tongue.key, reason, 0, 0)
    for sentence in sentences:
        with by_rule("page.sentence", sentence.start, sentence.end):
            _read(stage, sentence)
    _close(stage)
    return reading


def _find_people(script: Manuscript, reading: Reading) -> Roster:
    """Find the cast, with the looks that stand beside their names."""
    roster = find_prose_cast(script) if script.prose else find_cast(script)
    add_foreign(roster, script)
    roster.index()
    reading.people = roster.people
    return roster


@rule("people.gender_by_pronouns")
def _guess_genders(sentences: list[Sentence], roster: Roster, prose: bool) -> None:
    """Where a sentence names one person only, the pronouns after the name, or at the start of the next, vote."""
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
            own = (w for at, w in enumerate(sentence.words) if at >= start and not _another(sentence.words, at))
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
    """How many pronouns, and what share of them, say more of somebody's gender than their name or role does."""
    if person.gender == "unknown":
        return 1, 0.6
    if lexicon.gender_of_word(person.role) != "unknown":
        return math.inf, 1.0
    names = set(person.aliases)
    return (2, 0.6) if names & lexicon.UNISEX else (3, 0.9) if names & lexicon.FIRST_NAMES else (math.inf, 1.0)


def _another(words: list[Word], at: int) -> bool:
    """``watches her in the mirror``: an object is somebody else; ``her ear`` and ``behind her`` may be one's own."""
    if not at or words[at - 1].low in lexicon.PREPOSITIONS:
        return False
    after = words[at + 1] if at + 1 < len(words) else None
    noun = after is not None and after.solid and after.low not in lexicon.PREPOSITIONS | lexicon.CONJUNCTIONS
    return words[at].low == "him" or (words[at].low == "her" and not noun)


def _as_gender(word: str) -> Gender:
    return "female" if word == "female" else "male"


def _read(stage: Stage, sentence: Sentence) -> None:
    """Read one sentence: open its unit, tell it to the stage, note who and what is there after it."""
    stage.discourse.next_sentence()
    units = stage.reading.units
    if not units or units[-1].scene != sentence.scene:
        _open_scene(stage, sentence)
    elif units:
        clear_exits(stage)
    text = stage.reading.screenplay.text
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
        _stay(stage, sentence)
        return
    shown = _look_at(stage, sentence.camera) if sentence.camera else None
    if sentence.words and stage.tongue:
        read_foreign(stage, sentence, stage.tongue)
    elif sentence.words:
        _read_action(stage, sentence)
    if shown and not unit.deeds:
        lies_there(stage, shown, sentence.words)
    if sentence.speech:
        speak(stage, sentence, sentence.speech)
        act_beside(stage, sentence, sentence.speech)
    if (
        sentence.camera
        and sentence.camera.kind == "pov"
        and _THROUGH.search(sentence.camera.phrase + sentence.camera.subject)
    ):
        stage.scene.leaving += [person for person in unit.entering if person not in stage.scene.leaving]
    unit.leaving = list(stage.scene.leaving)
    _note_the_stage(stage)


def _read_action(stage: Stage, sentence: Sentence) -> None:
    if stage.reading.screenplay.format != "prose":
        bring_along(stage, sentence)
    read_action(stage, sentence)


def _stay(stage: Stage, sentence: Sentence) -> None:
    """Keep all people in place for on-screen text, sounds and asides."""
    unit = stage.unit
    if sentence.beside == "sound":
        unit.sounds = [" ".join(unit.text.split())]
    _note_the_stage(stage)


def _note_the_stage(stage: Stage) -> None:
    """Write into the unit the people present, their postures and the things in their hands."""
    unit = stage.unit
    keep_calls(stage)
    unit.on_stage = list(stage.scene.on)
    unit.posture = dict(stage.scene.posture)
    unit.held = {person: list(things) for person, things in stage.scene.held.items() if things}


@rule("camera.subject")
def _look_at(stage: Stage, camera: CameraNote) -> str | None:
    """Note a camera direction: whom it shows or looks through is there; ``She`` after CLOSE ON KIRA is Kira.

    Returns the thing it shows, if it is one.
    """
    stage.unit.camera = camera
    person = None
    for name, shown in ((camera.who, False), (camera.subject, True)):
        person = stage.find(name) if name else None
        if person:
            stage.enter(person)
            stage.involve(person)
            stage.mention(person, 1.0)
            if shown:
                stage.discourse.subjects = [person]
    return None if person else show_thing(stage, camera)


@rule("people.carried_over")
def _open_scene(stage: Stage, sentence: Sentence) -> None:
    prose = stage.reading.screenplay.format == "prose"
    before = stage.scene
    stage.intercut = stage.intercut and not stage.reading.scenes[sentence.scene].heading
    stage.scene = SceneState(sentence.scene, before=_on_their_feet(before))
    stage.inventory.open_scene(sentence.start)
    first = [word.low for word in sentence.words[:_CARRIED]]
    if prose and sentence.scene and any(word in ("they", "he", "she", "it", "i", "we") for word in first):
        stage.scene.on = [person for person in before.on if person not in before.leaving]
        single = next(
            (lexicon.PRONOUNS.get(word, "") for word in first if word in ("they", "he", "she", "i", "we", "it")), ""
        )
        if single in ("male", "female"):
            stage.scene.on = _of_whom_it_is_told(stage, stage.scene.on, single)
    elif before.index != sentence.scene:
        come_back(stage)
    stage.discourse.next_scene(keep_groups=prose)


def _on_their_feet(scene: SceneState) -> list[str]:
    """Who is there when a scene ends and can go on: not who left, nor who lies on the floor."""
    down = {person for person, (posture, on) in scene.posture.items() if posture in ("lie", "asleep") and on is None}
    return [person for person in scene.on if person not in down | {*scene.leaving}]


def _of_whom_it_is_told(stage: Stage, people: list[str], gender: str) -> list[str]:
    """``That night she``: of several women there, the one the story has told most of."""
    told = Counter(id for unit in stage.reading.units for id in unit.people)
    fitting = [id for id in people if (person := stage.person(id)) and person.gender == gender]
    return [max(fitting, key=lambda id: told[id])] if len(fitting) > 1 else people


def _close(stage: Stage) -> None:
    """Put the things on the sheet, drop targets that name nothing on it, flag unknown nouns."""
    reading = stage.reading
    for thing, unknown in stage.inventory.story_things([relation for _, relation in reading.relations]):
        reading.things.append(thing)
        if unknown:
            end = thing.first + len(thing.name)
            stage.flag("prop", thing.id, f"“{thing.name}” is not a word the reader knows", thing.first, end)
    known = {thing.id for thing in reading.things} | {person.id for person in reading.people}
    parts = stage.inventory.parts()
    placed = known | {
        thing
        for thing in stage.inventory.ids()
        if stage.inventory.head(thing) in _SURFACES or stage.inventory.class_of(thing) == "worn"
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
