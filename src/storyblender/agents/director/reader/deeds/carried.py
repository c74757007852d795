"""Who comes along into a scene that opens without a name: ``They sit on the swing. He hands her a cup``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.page.sentences import Sentence
from storyblender.agents.director.reader.people.people_meant import fits
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Gender

_SUBJECTS: dict[str, Gender] = {"he": "male", "she": "female", "they": "unknown", "both": "unknown"}
_OF_THEM = frozenset({"the", "both", "these", "those"})
_ANYBODY = frozenset({"friend", "other", "lover", "figure", "people", "them"}) | lexicon.words("pairs")
"""Heads that say nothing of who they are."""


@rule("people.brought_along")
def bring_along(stage: Stage, sentence: Sentence) -> None:
    """Put people of the scene before on stage, if a sentence means them before anybody is there.

    Args:
        stage: Its scene knows who was there before.
        sentence: A sentence of action of a script with scene headings.
    """
    before = stage.roster.in_order(filter(None, map(stage.roster.person, stage.scene.before)))
    if stage.scene.on or not before:
        return
    for word in sentence.words:
        mention = word.mention
        if mention is not None and mention.kind == "group" and mention.determiner in _OF_THEM:
            _bring(stage, _so_many(before, mention.head, mention.number))
        elif mention is not None:
            stage.scene.before = stage.scene.before if mention.kind == "group" else []
            before = [person for person in before if person not in mention.candidates]
        elif word.low in _SUBJECTS and stage.scene.before:
            _bring(stage, _meant(stage, before, word.low))


def _so_many(before: Sequence[Person], head: str, number: int) -> list[Person]:
    """The two women, the three men: all of those people, if there were as many."""
    gender = lexicon.gender_of_word(head)
    if head not in _ANYBODY and (gender == "unknown" or head in lexicon.KIN):
        return []
    fitting = [person for person in before if person.kind == "human" and fits(person, gender)]
    return fitting if len(fitting) == number else []


def _meant(stage: Stage, before: Sequence[Person], pronoun: str) -> list[Person]:
    """They: everybody; he or she: the one of whom the story has told most."""
    people = [person for person in before if person.kind != "animal"]
    if _SUBJECTS[pronoun] == "unknown":
        return people if len(people) > 1 or any(person.count > 1 for person in people) else []
    fitting = [person for person in people if person.gender == _SUBJECTS[pronoun]]
    told = Counter(id for unit in stage.reading.units for id in unit.people)
    return [max(fitting, key=lambda person: told[person.id])] if fitting else []


def _bring(stage: Stage, people: Sequence[Person]) -> None:
    """Put them on stage; from then on the scene speaks for itself."""
    stage.scene.on += [person.id for person in people if person.id not in stage.scene.on]
    stage.scene.before = [] if people else stage.scene.before


@rule("people.still_there")
def come_back(stage: Stage) -> None:
    """Put people back on stage, as they were, when the story returns to the place where it left them.

    The hour is the same, and nobody has seen them anywhere else since.

    Args:
        stage: Its scene has just begun; the unit that begins it is not there yet.
    """
    scenes, units = stage.reading.scenes, stage.reading.units
    here = scenes[stage.scene.index]
    places = {here.id, here.reference} - {None}
    earlier = next(
        (
            index
            for index in range(stage.scene.index - 1, -1, -1)
            if {scenes[index].id, scenes[index].reference} & places and scenes[index].time == here.time
        ),
        None,
    )
    if earlier is None or not here.place or "LATER" in here.time_written:
        return
    last = next((at for at in range(len(units) - 1, -1, -1) if units[at].scene == earlier), None)
    if last is None:
        return
    seen = {person for unit in units[last + 1 :] for person in (*unit.on_stage, *unit.people)}
    left = units[last]
    stage.scene.on = [person for person in left.on_stage if person not in seen | {*left.leaving}]
    stage.scene.posture = {person: left.posture[person] for person in stage.scene.on if person in left.posture}
    stage.scene.held = {person: list(left.held[person]) for person in stage.scene.on if person in left.held}
