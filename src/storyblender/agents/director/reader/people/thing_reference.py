"""Which thing ``it`` and ``its`` mean: by salience, from what was done with each thing and how long ago."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Literal

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.catalog.inflection import PLURAL_ONLY

Use = Literal["subject", "object", "place"]

_HANDLED, _SUBJECT, ASIDE, _PLACE, SEEN = 1.0, 0.8, 0.6, 0.45, 0.3
"""What a clause adds to the weight of its object, its subject, a thing beside it, its places, and of any noun."""
_MOST = 1.3
"""The weight of a thing that a story dwells on."""
_FADING = 0.8
"""What weight keeps from one clause to the next; a new sentence takes more."""
_KINDS = {"prop": 0.1, "worn": 0.0, "set_piece": 0.0, "unknown": -0.2, "scenery": -0.4, "body": -0.3}
_SUITS, _UNFIT = 0.5, 0.6
"""What a thing gains that its verb asks for (a door is opened), and what loses that cannot be taken in the hand."""
_IN_HAND = 0.4
_LOSING = frozenset({"put_down", "give", "throw", "drop"})
_ASIDE = frozenset({"beside", "to", "of", "behind", "by", "near"})
_POURING = frozenset({"pour", "ladle"})
_ANIMAL = 0.8
_AT = 0.3
"""What furniture gains after a preposition of place."""


def raise_things(state: ReaderState, things: Iterable[str], weight: float) -> None:
    """Raise the salience of things, so that ``it`` may mean them.

    Args:
        state: The reader's state.
        things: Ids of the things.
        weight: What is added to their salience.
    """
    weights = state.discourse.things
    for thing in things:
        if thing not in state.sentence.plurals:
            weights[thing] = min(weights.get(thing, 0.0) + weight, _MOST)


def raise_clause_things(
    state: ReaderState, subjects: Sequence[str], objects: Sequence[str], places: Sequence[str]
) -> None:
    """Raise the salience of the things of a clause by their part in it; earlier things fade.

    Args:
        state: The reader's state; changed in place.
        subjects: Ids of the things that act.
        objects: Ids of the things that something is done to.
        places: Ids of the things in places.
    """
    if (
        places
        and state.sentence.verb in _POURING
        and all(state.inventory.head(each) in lexicon.LIQUIDS for each in objects)
    ):
        objects, places = places, objects  # what tea is poured into is what is then given away
    weights = state.discourse.things
    for thing in weights:
        weights[thing] *= _FADING
    raise_things(state, subjects, _SUBJECT)
    raise_things(state, objects, _HANDLED)
    raise_things(state, places, _PLACE)


def thing_for_it(state: ReaderState, index: int, use: Use, animals: Sequence[Person] = ()) -> str | None:
    """Return the id of the thing or animal that the pronoun ``it`` means, or None.

    Args:
        state: The reader's state before the clause.
        index: Word index of the pronoun in the sentence.
        use: Its part in the clause; ``place`` after a preposition of place.
        animals: Animals that it may mean.

    Returns:
        The id of a thing or of one of the animals.
    """
    if use == "place" and (placed := _placed_here(state, index)):
        return placed
    weights = dict(state.discourse.things)
    before = [(at, thing) for at, thing in state.sentence.things if at < index]
    for at, thing in before:
        weights[thing] = weights.get(thing, 0.0) + SEEN + 0.01 * at
    arguments = {state.sentence.object_thing, state.sentence.subject_thing}
    if use == "place" and len(before) > 1 and before[-1][0] == index - 2:
        arguments = {before[-1][1]}
        apart = {word.low for word in state.sentence.words[before[-2][0] : before[-1][0]]}
        told = [thing for thing in (state.sentence.object_thing, state.sentence.subject_thing) if thing in weights]
        whole = next((thing for thing in told if thing != before[-1][1]), before[-2][1])
        weights[whole] += _HANDLED * ("with" in apart)  # drags in a sledge with a tree on it
    weights |= {animal.id: _ANIMAL * state.discourse.salience.get(animal.id, 0.0) for animal in animals}
    pool = [thing for thing in weights if thing not in arguments and _can_be_it(state, thing)]
    aside = use == "place" and state.sentence.words[index - 1].low in _ASIDE
    return max(pool, key=lambda thing: weights[thing] + _fitness(state, thing, use, aside)) if pool else None


def _fitness(state: ReaderState, thing: str, use: Use, aside: bool) -> float:
    """Return how well a thing goes with what is said of it, a term added to its salience."""
    kind, verb = state.inventory.class_of(thing), state.sentence.verb
    motion = lexicon.MOTION_OF_VERB.get(verb)
    fitness = _KINDS.get(kind, 0.0) + _SUITS * (state.inventory.head(thing) in lexicon.SUITING.get(verb, ()))
    fixed = kind in ("set_piece", "scenery")
    if use == "place":
        return fitness + _AT * (kind == "set_piece" and not aside)
    if use == "object" and motion in lexicon.GRIPPING:
        held = any(thing in things for things in state.scene.held.values())
        return fitness - _UNFIT * fixed + _IN_HAND * held * ((motion in _LOSING) - (motion == "pick_up"))
    return fitness


def _placed_here(state: ReaderState, index: int) -> str | None:
    """Return the thing beside which ``it`` is: the hat in ``puts the hat down and lays a coin beside it``."""
    last = state.scene.relations[-1][1].asset_id if state.scene.relations else None
    here = {thing for _, thing in state.sentence.things} | {it for _, it in state.sentence.pronouns.values() if it}
    beside = state.sentence.words[index - 1].low in _ASIDE and last in here and last != state.sentence.object_thing
    return last if beside and state.inventory.class_of(last) == "prop" else None


def _can_be_it(state: ReaderState, thing: str) -> bool:
    """Whether ``it`` can mean a thing: nothing abstract, no weather, and no noun that is always plural."""
    head = state.inventory.head(thing)
    weather = head in lexicon.WEATHER_NOUNS | lexicon.WEATHER_WORDS.keys()
    return state.inventory.class_of(thing) != "abstract" and not weather and head not in PLURAL_ONLY
