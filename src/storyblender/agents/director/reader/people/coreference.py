"""Resolves noun phrases to people and things in reading order: pronouns, ``the old woman`` (notes, 1d)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.phrases import NounPhrase
from storyblender.agents.director.reader.language.words import Mention
from storyblender.agents.director.reader.people.narrator import ALONE, OWN, narrator_group
from storyblender.agents.director.reader.people.person_reference import gender_fits, may_be_it, resolve_mention
from storyblender.agents.director.reader.people.thing_reference import thing_for_it
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.memory.vocabulary import Gender

GrammaticalRole = Literal["subject", "object", "possessor", "other"]

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
    """What a noun phrase means: people, or the id of a thing."""

    people: list[Person]
    thing: str | None = None


# -- pronouns ----------------------------------------------------------------------------------------------------


def resolve_pronoun(
    state: ReaderState,
    pronoun: str,
    role: GrammaticalRole,
    subjects: Sequence[Person] = (),
    previous: Sequence[Person] = (),
    excluded: Sequence[Person] = (),
) -> list[Person]:
    """Return the people whom a pronoun means, by gender, salience and grammatical role.

    Args:
        state: The reader's state.
        pronoun: The pronoun in lower case.
        role: Its grammatical role.
        subjects: Subjects of the clause.
        previous: Subjects of the clause or sentence before.
        excluded: People it cannot mean.
    """
    kind = lexicon.PRONOUNS[pronoun]
    if kind == "plural":
        return _resolve_they(state, role, subjects, excluded)
    gender: Gender = "female" if kind == "female" else "male"
    pool = [
        person
        for person in state.seen_or_mentioned()
        if person.kind != "group" and person is not state.roster.narrator and gender_fits(person, gender)
    ]
    if role in ("object", "other"):
        pool = [person for person in pool if person not in subjects] or pool
    pool = [person for person in pool if person not in excluded]
    if not pool and role == "subject":
        pool = [person for person in state.roster.people if person.gender == gender and person.kind == "human"]
        pool = pool if len(pool) == 1 else []
    if not pool:
        return []

    last, now = state.discourse.last_sentence, state.discourse.sentence
    prose = state.reading.screenplay.format == "prose"
    known = any(p.gender == gender and p.kind == "human" and last.get(p.id, -9) >= now - 3 for p in pool)

    def score(person: Person) -> tuple[float, int]:
        unsure = -0.5 if known else 0.1
        value = state.discourse.salience.get(person.id, 0.0) + (0.45 if person.gender == gender else unsure)
        handled = role == "object" and person.id in state.sentence.named and person not in subjects
        value -= (1.0 if person.gender != gender else 0.4) * (person.kind == "animal" and not handled)
        value += 0.5 * handled
        sure = person.gender == gender or not known
        value += 0.8 * (role == "subject" and [person] == list(previous) and sure) + 1.2 * (
            role == "possessor"
            and (person in subjects or (prose and not subjects and [person] == list(previous) and sure))
        )
        return value, state.discourse.last_named.get(person.id, 0)

    ranked = sorted(pool, key=score, reverse=True)
    best = ranked[0]
    own = prose and role == "possessor" and [best] == list(subjects)
    if best.gender == "unknown" and (own or not any(person.gender == gender for person in pool)):
        best.gender = gender
    if len(ranked) > 1 and score(best)[0] - score(ranked[1])[0] < _CLOSE_CALL:
        unit = state.unit
        state.flag("pronoun", best.id, f"“{pronoun}” may also be {ranked[1].name}", unit.start, unit.end)
    return [best]


def _resolve_they(
    state: ReaderState, role: GrammaticalRole, subjects: Sequence[Person], excluded: Sequence[Person] = ()
) -> list[Person]:
    """Return the people whom ``they`` or ``them`` means."""
    if role == "possessor" and len(subjects) > 1:
        return list(subjects)
    discourse = state.discourse
    here = [person for person in state.referable_people() if person not in excluded]
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
            and state.roster.narrator not in group
            and (not here or set(_ids(group)) & set(state.scene.on))
            and discourse.sentence - sentence <= memory
            and not overlaps
            and not set(_ids(group)) & set(_ids(excluded))
        ):
            return group
    if role == "object":
        here = [person for person in here if person not in subjects]
    if len(here) <= 2:
        return here
    here = [person for person in here if state.scene.posture.get(person.id, ("", None))[0] != "asleep"] or here
    for age in (2, 4, 6):
        recent = [p for p in here if discourse.sentence - discourse.last_sentence.get(p.id, -99) <= age]
        humans = [person for person in recent if person.kind != "animal"]
        if len(recent) > 1:
            return humans if len(humans) > 1 else recent
    return here


def _ids(people: Sequence[Person]) -> list[str]:
    """Return the ids of people."""
    return [person.id for person in people]


# -- noun phrases ------------------------------------------------------------------------------------------------


def resolve(
    state: ReaderState,
    noun: NounPhrase,
    role: GrammaticalRole = "object",
    subjects: Sequence[Person] = (),
    previous: Sequence[Person] = (),
    place: bool = False,
) -> Referents:
    """Return what a noun phrase means, and record it.

    Args:
        state: The reader's state.
        noun: The noun phrase.
        role: Its grammatical role.
        subjects: Subjects of the clause.
        previous: Subjects of the clause or sentence before.
        place: Whether it follows a preposition of place.
    """
    if noun.kind == "person" and noun.mention:
        people = _resolve_person(state, noun, noun.mention)
        if people or noun.head not in lexicon.PROPS | lexicon.ANIMALS:
            return Referents(people)
        return Referents([], state.inventory.id_of(noun.head, state.sentence.words[noun.index].start))
    settled = noun.index in state.sentence.pronouns
    if place and noun.head == "it" and not settled and not any(may_be_it(person) for person in previous):
        return record_reference(state, noun.index, Referents([], thing_for_it(state, noun.index, "place")))
    whole = _whole_of_part(state, noun) if noun.kind == "thing" and noun.owner is None else None
    if whole:
        return Referents([], whole)
    if noun.kind == "thing":
        return Referents([], state.inventory.id_of(noun.key, state.sentence.words[noun.index].start))
    if noun.head == "":
        return Referents(list(previous) or state.discourse.subjects[:1])
    known = state.sentence.pronouns.get(noun.index)
    if known:
        return Referents(*known)
    return record_reference(state, noun.index, _resolve_pronoun_phrase(state, noun, role, subjects, previous))


def _whole_of_part(state: ReaderState, noun: NounPhrase) -> str | None:
    """Return the id of the thing that a part belongs to: ``on the edge``, ``on its lid``; None if unknown."""
    if noun.possessor is not None:
        return (
            state.sentence.pronouns.get(noun.possessor, ([], None))[1] if noun.head in _PARTS | _OF_VEHICLES else None
        )
    lately = [thing for thing in state.discourse.recent_things if state.inventory.head(thing) != noun.head]
    wholes: list[str] = []
    if noun.determiner == "the" and noun.head in _SIDES:
        wholes = [thing for thing in lately if state.inventory.class_of(thing) == "set_piece"]
    elif noun.determiner == "the" and noun.head in _OF_SEATS:
        wholes = [thing for thing in lately if state.inventory.head(thing) in _CHAIRS | lexicon.VEHICLES]
    elif noun.determiner == "the" and noun.head == "head":
        wholes = [thing for thing in lately if state.inventory.head(thing) in ("table", "desk")]
    elif noun.determiner == "the" and noun.head in _OF_VEHICLES:
        here = [
            thing for unit in reversed(state.reading.units) if unit.scene == state.unit.scene for thing in unit.things
        ]
        wholes = [thing for thing in [*lately, *here] if state.inventory.head(thing) in lexicon.VEHICLES]
    return next(iter(wholes), None)


def _resolve_pronoun_phrase(
    state: ReaderState, noun: NounPhrase, role: GrammaticalRole, subjects: Sequence[Person], previous: Sequence[Person]
) -> Referents:
    """Return what a pronoun as a noun phrase means."""
    discourse, pronoun = state.discourse, noun.head
    kind = lexicon.PRONOUNS[pronoun]
    if kind == "thing":
        return _resolve_it(state, noun.index, role, subjects, previous)
    if pronoun.endswith(("self", "selves")) and subjects:
        return Referents(list(subjects))
    plural = discourse.last_plural
    before = [word.low for word in state.sentence.words[max(0, noun.index - 2) : noun.index]]
    if kind == "plural" and before[1:] == ["of"] and before[0] in _NOBODY:
        return Referents(resolve_pronoun(state, pronoun, "other"))
    if kind == "plural" and role == "object" and plural and plural[1] >= discourse.sentence - 1:
        return Referents([], plural[0])
    return Referents(resolve_pronoun(state, pronoun, role, list(subjects), list(previous)))


def _resolve_it(
    state: ReaderState, index: int, role: GrammaticalRole, subjects: Sequence[Person], previous: Sequence[Person]
) -> Referents:
    """Return the thing or animal that ``it`` means."""
    if role == "subject":
        neuter = [person for person in previous if may_be_it(person)] or _animal_of_last_sentence(state)
        return Referents(neuter) if len(neuter) == 1 else Referents([], thing_for_it(state, index, "subject"))
    meant = thing_for_it(state, index, "object", _possible_animals(state, subjects))
    animal = state.person(meant or "")
    return Referents([animal]) if animal else Referents([], meant)


def _possible_animals(state: ReaderState, subjects: Sequence[Person]) -> list[Person]:
    """Return the people and animals on stage that ``it`` may mean."""
    return [person for person in state.on_stage() if may_be_it(person) and person not in subjects]


def _animal_of_last_sentence(state: ReaderState) -> list[Person]:
    """Return the animals named in the last sentence."""
    last = state.discourse.last_sentence
    named = [p for p in state.on_stage() if may_be_it(p) and last.get(p.id, -9) >= state.discourse.sentence - 1]
    return [max(named, key=state.prominence)] if named and state.sentence.verb in _LIVING else []


def _resolve_its(
    state: ReaderState, noun: NounPhrase, subjects: Sequence[Person], previous: Sequence[Person]
) -> Referents:
    """Return whose ``its lid`` is: the acting animal's, else the thing's that was handled or acts."""
    doing = state.sentence.subject_thing
    neuter = [person for person in (subjects or ([] if doing else previous)) if may_be_it(person)]
    if not neuter and noun.head in lexicon.BODY:
        neuter = sorted(_possible_animals(state, ()), key=lambda animal: -state.discourse.last_named.get(animal.id, 0))
    if neuter:
        return Referents(neuter[:1])
    thing = state.sentence.object_thing or doing
    return Referents([], thing or thing_for_it(state, noun.possessor or noun.index, "subject"))


def record_reference(state: ReaderState, index: int, referents: Referents) -> Referents:
    """Record what the pronoun at a word index means, for this sentence and for the reading.

    Args:
        state: The reader's state.
        index: Index of the pronoun in the sentence.
        referents: What it means.

    Returns:
        The same referents.
    """
    word = state.sentence.words[index]
    state.sentence.pronouns[index] = (referents.people, referents.thing)
    who = [person.id for person in referents.people] or ([referents.thing] if referents.thing else [])
    if who or lexicon.PRONOUNS.get(word.low) != "thing":
        state.record_pronoun(word.start, word.text, who)
    return referents


def _resolve_person(state: ReaderState, noun: NounPhrase, mention: Mention) -> list[Person]:
    """Return the people whom a mention means."""
    people = resolve_mention(state, mention)
    _record_indirect(state, mention, people, state.sentence.words[noun.index].end)
    return people


def _record_indirect(state: ReaderState, mention: Mention, people: Sequence[Person], end: int) -> None:
    """Record once who ``the old woman`` is."""
    indirect = (
        mention.kind in ("group", "generic")
        or mention.head in ALONE
        or (mention.kind == "role" and people and mention.head not in people[0].name.lower().split())
    )
    if people and not mention.recorded and state.reading.screenplay.text[end - len(_THEM) : end] == _THEM:
        mention.recorded = True
        state.record_pronoun(end - len("them"), "them", [p.id for p in people])
    if people and indirect and not mention.recorded:
        mention.recorded = True
        state.record_pronoun(mention.start, state.reading.screenplay.text[mention.start : end], [p.id for p in people])


def resolve_owner(
    state: ReaderState,
    noun: NounPhrase,
    role: GrammaticalRole,
    subjects: Sequence[Person],
    previous: Sequence[Person],
) -> None:
    """Set the owner of a noun phrase: ``her hand``, ``Nora's car``.

    Args:
        state: The reader's state.
        noun: The noun phrase; its ``owner`` is set.
        role: Grammatical role of the owner.
        subjects: Subjects of the clause.
        previous: Subjects of the clause or sentence before.
    """
    if noun.possessor is None:
        return
    word = state.sentence.words[noun.possessor]
    if word.low in OWN:
        owners = narrator_group(state, word.low)
        if owners and noun.possessor not in state.sentence.pronouns:
            record_reference(state, noun.possessor, Referents(owners))
        noun.owner = owners[0].id if owners else None
        return
    if word.mention:
        owners = resolve_mention(state, word.mention)
        _record_indirect(state, word.mention, owners, word.end)
        for person in owners:
            state.mention(person, 0.2)
            noun.owner = person.id
        return
    known = state.sentence.pronouns.get(noun.possessor)
    if word.low == "its" and known is None:
        known = record_reference(state, noun.possessor, _resolve_its(state, noun, subjects, previous))
    elif known is None and lexicon.PRONOUNS.get(word.low, "thing") != "thing":
        excluded = resolve_mention(state, noun.mention) if noun.mention else []
        people = resolve_pronoun(state, word.low, role, subjects, previous, excluded)
        known = record_reference(state, noun.possessor, Referents(people))
    if known and known[0]:
        noun.owner = known[0][0].id
