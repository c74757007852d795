"""Who is meant: pronouns, ``the old woman``, ``the two men``, in reading order (notes of the director, 1d)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.phrases import NounPhrase
from storyblender.agents.director.reader.language.words import Mention
from storyblender.agents.director.reader.people.narrator import ALONE, OWN, own_people
from storyblender.agents.director.reader.people.person_reference import fits, is_neuter, resolve_mention
from storyblender.agents.director.reader.people.thing_reference import meant_by_it
from storyblender.agents.director.reader.state import Stage
from storyblender.agents.director.reading import Person
from storyblender.memory.vocabulary import Gender

Role = Literal["subject", "object", "possessor", "other"]

_CLOSE_CALL = 0.3
"""A pronoun whose best two candidates lie nearer than this is flagged."""
_GROUP_MEMORY = 15
"""Sentences for which ``they`` can mean people who acted together; four for ``them``."""
_LIVING = frozenset(verb.split(" ")[0] for verb in lexicon.MOTION_OF_VERB) | lexicon.words("living")
"""Verbs for animals more than for things."""
_OF_VEHICLES = lexicon.words("vehicle_parts") - {"door", "wheel", "boot", "trunk", "bow", "stern", "wing"} | {"bumper"}
_PARTS = lexicon.words("parts")
_NOBODY = frozenset({"neither", "none", "both", "either", "nobody"})
"""``neither of them``: of people."""
_THEM = " of them"
"""``the two of them``: a group, and a pronoun."""
_SIDES = frozenset({"edge", "end"})
"""``perches on the edge``: of the table named last."""

_OF_SEATS = frozenset({"seat", "arm"})
_CHAIRS = frozenset({"chair", "armchair", "sofa", "couch", "settee", "rocking chair"})
"""``a book on the seat``: of the armchair named before."""


class Referents(NamedTuple):
    """What a noun phrase means: people, or a thing (its id)."""

    people: list[Person]
    thing: str | None = None


# -- pronouns ----------------------------------------------------------------------------------------------------


def resolve_pronoun(
    stage: Stage,
    pronoun: str,
    role: Role,
    subjects: Sequence[Person] = (),
    previous: Sequence[Person] = (),
    excluded: Sequence[Person] = (),
) -> list[Person]:
    """Decide who a pronoun for people means.

    Args:
        stage: The state before it.
        pronoun: Lower case; not ``it``.
        role: Its role in the clause.
        subjects: Subject of the clause it stands in.
        previous: Subject of the sentence before.
        excluded: Who it cannot be: ``her brother`` is not her.
    """
    kind = lexicon.PRONOUNS[pronoun]
    if kind == "plural":
        return _they(stage, role, subjects, excluded)
    gender: Gender = "female" if kind == "female" else "male"
    pool = [
        person
        for person in stage.told_of()
        if person.kind != "group" and person is not stage.roster.narrator and fits(person, gender)
    ]
    if role in ("object", "other"):
        pool = [person for person in pool if person not in subjects] or pool
    pool = [person for person in pool if person not in excluded]
    if not pool and role == "subject":
        pool = [person for person in stage.roster.people if person.gender == gender and person.kind == "human"]
        pool = pool if len(pool) == 1 else []
    if not pool:
        return []

    last, now = stage.discourse.last_sentence, stage.discourse.sentence
    prose = stage.reading.screenplay.format == "prose"
    known = any(p.gender == gender and p.kind == "human" and last.get(p.id, -9) >= now - 3 for p in pool)

    def score(person: Person) -> tuple[float, int]:
        unsure = -0.5 if known else 0.1
        value = stage.discourse.salience.get(person.id, 0.0) + (0.45 if person.gender == gender else unsure)
        handled = role == "object" and person.id in stage.sentence.named and person not in subjects
        value -= (1.0 if person.gender != gender else 0.4) * (person.kind == "animal" and not handled)
        value += 0.5 * handled
        sure = person.gender == gender or not known
        value += 0.8 * (role == "subject" and [person] == list(previous) and sure) + 1.2 * (
            role == "possessor"
            and (person in subjects or (prose and not subjects and [person] == list(previous) and sure))
        )
        return value, stage.discourse.last_named.get(person.id, 0)

    ranked = sorted(pool, key=score, reverse=True)
    best = ranked[0]
    own = prose and role == "possessor" and [best] == list(subjects)
    if best.gender == "unknown" and (own or not any(person.gender == gender for person in pool)):
        best.gender = gender
    if len(ranked) > 1 and score(best)[0] - score(ranked[1])[0] < _CLOSE_CALL:
        unit = stage.unit
        stage.flag("pronoun", best.id, f"“{pronoun}” may also be {ranked[1].name}", unit.start, unit.end)
    return [best]


def _they(stage: Stage, role: Role, subjects: Sequence[Person], excluded: Sequence[Person] = ()) -> list[Person]:
    if role == "possessor" and len(subjects) > 1:
        return list(subjects)
    discourse = stage.discourse
    here = [person for person in stage.spoken_of() if person not in excluded]
    bands = [person for person in here if person.count > 1 and person not in subjects]
    last = discourse.last_named
    if bands:
        band = max(bands, key=lambda person: last.get(person.id, 0))
        if not discourse.groups or last.get(band.id, 0) > discourse.groups[-1][2]:
            return [band]
    memory = 4 if role == "object" else _GROUP_MEMORY
    for sentence, group, _ in reversed(discourse.groups):
        shared = {person.id for person in group} & {person.id for person in subjects}
        overlaps = role in ("object", "possessor") and shared and len(shared) != len(group)
        if (
            group
            and stage.roster.narrator not in group
            and (not here or set(_ids(group)) & set(stage.scene.on))
            and discourse.sentence - sentence <= memory
            and not overlaps
            and not set(_ids(group)) & set(_ids(excluded))
        ):
            return group
    if role == "object":
        here = [person for person in here if person not in subjects]
    if len(here) <= 2:
        return here
    here = [person for person in here if stage.scene.posture.get(person.id, ("", None))[0] != "asleep"] or here
    for age in (2, 4, 6):
        recent = [p for p in here if discourse.sentence - discourse.last_sentence.get(p.id, -99) <= age]
        humans = [person for person in recent if person.kind != "animal"]
        if len(recent) > 1:
            return humans if len(humans) > 1 else recent
    return here


def _ids(people: Sequence[Person]) -> list[str]:
    return [person.id for person in people]


# -- noun phrases ------------------------------------------------------------------------------------------------


def resolve(
    stage: Stage,
    noun: NounPhrase,
    role: Role = "object",
    subjects: Sequence[Person] = (),
    previous: Sequence[Person] = (),
    place: bool = False,
) -> Referents:
    """Decide who or what a noun phrase means, and keep it for the record; ``place``: after a preposition of place."""
    if noun.kind == "person" and noun.mention:
        people = _resolve_person(stage, noun, noun.mention)
        if people or noun.head not in lexicon.PROPS | lexicon.ANIMALS:
            return Referents(people)
        return Referents([], stage.inventory.id_of(noun.head, stage.sentence.words[noun.index].start))
    settled = noun.index in stage.sentence.pronouns
    if place and noun.head == "it" and not settled and not any(is_neuter(person) for person in previous):
        return remember(stage, noun.index, Referents([], meant_by_it(stage, noun.index, "place")))
    whole = _whole(stage, noun) if noun.kind == "thing" and noun.owner is None else None
    if whole:
        return Referents([], whole)
    if noun.kind == "thing":
        return Referents([], stage.inventory.id_of(noun.key, stage.sentence.words[noun.index].start))
    if noun.head == "":
        return Referents(list(previous) or stage.discourse.subjects[:1])
    known = stage.sentence.pronouns.get(noun.index)
    if known:
        return Referents(*known)
    return remember(stage, noun.index, _resolve_pronoun_phrase(stage, noun, role, subjects, previous))


def _whole(stage: Stage, noun: NounPhrase) -> str | None:
    """What a part belongs to: ``on the edge``, ``strapped to the roof``, ``on the seat``, ``on its lid``."""
    if noun.possessor is not None:
        return (
            stage.sentence.pronouns.get(noun.possessor, ([], None))[1] if noun.head in _PARTS | _OF_VEHICLES else None
        )
    lately = [thing for thing in stage.discourse.recent_things if stage.inventory.head(thing) != noun.head]
    wholes: list[str] = []
    if noun.determiner == "the" and noun.head in _SIDES:
        wholes = [thing for thing in lately if stage.inventory.class_of(thing) == "set_piece"]
    elif noun.determiner == "the" and noun.head in _OF_SEATS:
        wholes = [thing for thing in lately if stage.inventory.head(thing) in _CHAIRS | lexicon.VEHICLES]
    elif noun.determiner == "the" and noun.head == "head":
        wholes = [thing for thing in lately if stage.inventory.head(thing) in ("table", "desk")]
    elif noun.determiner == "the" and noun.head in _OF_VEHICLES:
        here = [
            thing for unit in reversed(stage.reading.units) if unit.scene == stage.unit.scene for thing in unit.things
        ]
        wholes = [thing for thing in [*lately, *here] if stage.inventory.head(thing) in lexicon.VEHICLES]
    return next(iter(wholes), None)


def _resolve_pronoun_phrase(
    stage: Stage, noun: NounPhrase, role: Role, subjects: Sequence[Person], previous: Sequence[Person]
) -> Referents:
    discourse, pronoun = stage.discourse, noun.head
    kind = lexicon.PRONOUNS[pronoun]
    if kind == "thing":
        return _it(stage, noun.index, role, subjects, previous)
    if pronoun.endswith(("self", "selves")) and subjects:
        return Referents(list(subjects))
    plural = discourse.last_plural
    before = [word.low for word in stage.sentence.words[max(0, noun.index - 2) : noun.index]]
    if kind == "plural" and before[1:] == ["of"] and before[0] in _NOBODY:
        return Referents(resolve_pronoun(stage, pronoun, "other"))
    if kind == "plural" and role == "object" and plural and plural[1] >= discourse.sentence - 1:
        return Referents([], plural[0])
    return Referents(resolve_pronoun(stage, pronoun, role, list(subjects), list(previous)))


def _it(stage: Stage, index: int, role: Role, subjects: Sequence[Person], previous: Sequence[Person]) -> Referents:
    if role == "subject":
        neuter = [person for person in previous if is_neuter(person)] or _animal_named(stage)
        return Referents(neuter) if len(neuter) == 1 else Referents([], meant_by_it(stage, index, "subject"))
    meant = meant_by_it(stage, index, "object", _animals(stage, subjects))
    animal = stage.person(meant or "")
    return Referents([animal]) if animal else Referents([], meant)


def _animals(stage: Stage, subjects: Sequence[Person]) -> list[Person]:
    """Everybody on stage whom ``it`` may mean."""
    return [person for person in stage.on_stage() if is_neuter(person) and person not in subjects]


def _animal_named(stage: Stage) -> list[Person]:
    """The animal of the last sentence, which may be ``it``."""
    last = stage.discourse.last_sentence
    named = [p for p in stage.on_stage() if is_neuter(p) and last.get(p.id, -9) >= stage.discourse.sentence - 1]
    return [max(named, key=stage.presence)] if named and stage.sentence.verb in _LIVING else []


def _its(stage: Stage, noun: NounPhrase, subjects: Sequence[Person], previous: Sequence[Person]) -> Referents:
    """Whose ``its lid`` is: the animal's that does something, else the thing's that is handled or does something."""
    doing = stage.sentence.subject_thing
    neuter = [person for person in (subjects or ([] if doing else previous)) if is_neuter(person)]
    if not neuter and noun.head in lexicon.BODY:
        neuter = sorted(_animals(stage, ()), key=lambda animal: -stage.discourse.last_named.get(animal.id, 0))
    if neuter:
        return Referents(neuter[:1])
    thing = stage.sentence.object_thing or doing
    return Referents([], thing or meant_by_it(stage, noun.possessor or noun.index, "subject"))


def remember(stage: Stage, index: int, referents: Referents) -> Referents:
    """Keep what the pronoun at a position means, for this sentence and for the record."""
    word = stage.sentence.words[index]
    stage.sentence.pronouns[index] = (referents.people, referents.thing)
    who = [person.id for person in referents.people] or ([referents.thing] if referents.thing else [])
    if who or lexicon.PRONOUNS.get(word.low) != "thing":
        stage.record(word.start, word.text, who)
    return referents


def _resolve_person(stage: Stage, noun: NounPhrase, mention: Mention) -> list[Person]:
    people = resolve_mention(stage, mention)
    _record_indirect(stage, mention, people, stage.sentence.words[noun.index].end)
    return people


def _record_indirect(stage: Stage, mention: Mention, people: Sequence[Person], end: int) -> None:
    """Keep who ``the old woman`` is, once."""
    indirect = (
        mention.kind in ("group", "generic")
        or mention.head in ALONE
        or (mention.kind == "role" and people and mention.head not in people[0].name.lower().split())
    )
    if people and not mention.recorded and stage.reading.screenplay.text[end - len(_THEM) : end] == _THEM:
        mention.recorded = True
        stage.record(end - len("them"), "them", [p.id for p in people])
    if people and indirect and not mention.recorded:
        mention.recorded = True
        stage.record(mention.start, stage.reading.screenplay.text[mention.start : end], [p.id for p in people])


def resolve_owner(
    stage: Stage,
    noun: NounPhrase,
    role: Role,
    subjects: Sequence[Person],
    previous: Sequence[Person],
) -> None:
    """Find out whose a thing is (``her hand``, ``Nora's car``) and note it in the phrase."""
    if noun.possessor is None:
        return
    word = stage.sentence.words[noun.possessor]
    if word.low in OWN:
        owners = own_people(stage, word.low)
        if owners and noun.possessor not in stage.sentence.pronouns:
            remember(stage, noun.possessor, Referents(owners))
        noun.owner = owners[0].id if owners else None
        return
    if word.mention:
        owners = resolve_mention(stage, word.mention)
        _record_indirect(stage, word.mention, owners, word.end)
        for person in owners:
            stage.mention(person, 0.2)
            noun.owner = person.id
        return
    known = stage.sentence.pronouns.get(noun.possessor)
    if word.low == "its" and known is None:
        known = remember(stage, noun.possessor, _its(stage, noun, subjects, previous))
    elif known is None and lexicon.PRONOUNS.get(word.low, "thing") != "thing":
        excluded = resolve_mention(stage, noun.mention) if noun.mention else []
        people = resolve_pronoun(stage, word.low, role, subjects, previous, excluded)
        known = remember(stage, noun.possessor, Referents(people))
    if known and known[0]:
        noun.owner = known[0][0].id
