"""Who leaves the stage, alone, led, sent or carried; exits take effect after the sentence (notes, 1e)."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.phrases import NounPhrase
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.people.roles import Place, Roles
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_LEAVING = re.compile(
    r"(exit|leave|depart|withdraw|retire|vanish|disappear|flee|escape"
    r"|(drive|slip|steal|ride|run|walk|hurry) (away|off))$"
)
_GOING = frozenset({"walk", "run", "sneak", "stagger", "crawl", "ride", "drive", "climb", "jump", "carry", "swim"})
_HAULING = frozenset({"drag", "haul", "wheel", "lug", "cart"})
"""``wheels the cart out``: who pushes goes along."""
_AWAY = frozenset({"out", "off", "away", "outside"})
_ASCENDING = frozenset({"upstairs", "downstairs"})
_COMING_OUT = frozenset({"crawl", "pull", "burst", "come", "get", "look", "emerge", "lean", "appear", "pop"})
_GETTING_OFF = frozenset({"climb", "jump", "leap", "hop", "step", "slide"})
"""``steps off``, ``hops out``: of a platform, a cart; into another room only where the words say so."""
_TAKING_ALONG = frozenset(
    {"lead", "usher", "escort", "march", "drag", "haul", "carry", "take", "chase", "walk", "guide", "wheel", "shepherd"}
    | {"follow", "show", "see", "accompany", "hustle", "bring", "frogmarch", "pursue", "pull", "help"}
)
_SENDING = frozenset(
    {"send", "push", "shove", "throw", "kick", "boot", "toss", "hurl", "shoo", "wave", "bundle", "drive", "pack"}
    | {"order", "hurry", "chuck", "fling", "force", "rush", "dismiss", "banish", "evict", "eject", "expel"}
)
"""Verbs whose object goes, and who does it stays."""
_OUTRIGHT = frozenset({"dismiss", "banish", "evict", "eject", "expel"})
_STAYS = frozenset(
    f"{verb} {particle}"
    for verb in (
        "back",
        "turn",
        "look",
        "step",
        "pull",
        "shrink",
        "lean",
        "edge",
        "inch",
        "draw",
        "shy",
        "move",
        "scoot",
    )
    for particle in ("away", "off", "back")
) | {
    "go on",
    "go over",
    "go through",
    "pass out",
    "go off",
    "take off",
    "carry on",
    "drift off",
    "doze off",
    "go quiet",
}
"""``backs away``, ``goes on to explain``, ``passes out``: the person stays."""
_ARISING = frozenset({"go", "make"})
"""``goes for the gun``, ``makes for the table``."""
_FOLLOWING = frozenset({"follow", "accompany", "trail", "pursue", "chase", "join"})
_OTHER = frozenset({"another", "next", "other", "adjoining"})
_BEYOND = frozenset({"sight", "view", "earshot"})
_OPENINGS = frozenset({"door", "doorway", "window", "gate", "hatch", "exit", "entrance", "tent", "flap"})
_PASSAGES = frozenset(
    {"hall", "hallway", "corridor", "street", "night", "yard", "garden", "passage", "rain", "alley", "courtyard"}
    | {"lobby", "stairwell", "darkness", "dark", "fog", "mist", "crowd", "woods", "distance", "snow", "storm", "wing"}
)
"""Where a person goes who leaves a room."""
_WIDE = frozenset({"darkness", "dark", "fog", "mist", "crowd", "woods", "distance", "night", "house", "building"})
"""Where a person is lost who is out of doors."""
_ALL = frozenset({"everyone", "everybody", "rest", "others"})
_STAYING = frozenset({"stand", "be", "remain", "stay", "sit"})
_WEATHER = lexicon.WEATHER_NOUNS | lexicon.WEATHER_WORDS.keys()
_FORSAKEN = re.compile(r"\b(?:left|leaving (?:her|him|them|it)|finally|alone) alone\b|\balone (?:again|now|at last)\b")
_ROOMS = lexicon.INDOOR - {"house", "home", "apartment", "flat", "hotel", "building", "castle", "school", "inn"}
_GONE = frozenset({"gone", "vanished", "disappeared"})
_CLOSED = frozenset({"close", "shut", "slam", "swing", "bang", "click", "bolt", "lock"})


@rule("people.leaves")
def note_exits(state: ReaderState, clause: Clause, roles: Roles, motion: str) -> None:
    """Note who leaves by a motion of their own, and whom they take along.

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
        roles: The people and things of the clause.
        motion: Motion of its subject, or None.
    """
    if _is_exit(state, clause, roles, motion):
        _mark_leaving(state, roles.subjects)


@rule("people.taken_away")
def note_taken_away(state: ReaderState, clause: Clause, roles: Roles) -> None:
    """Note who leaves because of others: ``throws Ben out``, ``Ben is dragged off``.

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
        roles: The people and things of the clause.
    """
    if clause.negated or clause.unreal or clause.verb not in _TAKING_ALONG | _SENDING:
        return
    moved = roles.subjects if clause.passive else roles.people
    if not moved or not (clause.verb in _OUTRIGHT or _leads_out(state, clause, roles)):
        return
    _mark_leaving(state, moved)
    if clause.verb in _TAKING_ALONG and not clause.passive:
        _mark_leaving(state, roles.subjects)


def is_through_a_door(clause: Clause) -> bool:
    """Whether the words say that a person is out already: ``Eddie is already through the door``."""
    return clause.verb == "be" and any(
        preposition in ("through", "out", "out of") and any(noun.head in _OPENINGS for noun in nouns)
        for preposition, nouns in clause.places
    )


@rule("people.found_gone")
def note_gone(state: ReaderState, clause: Clause, subjects: Sequence[Person]) -> None:
    """Note people whose absence the words state: ``Ben is gone``, ``But she has already vanished.``

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
        subjects: Subjects of the clause.
    """
    after = [word.low for word in state.sentence.words[clause.index + 1 : clause.index + 4]]
    told = [low for low in after if low not in lexicon.ADVERBS and not low.endswith("ly")]
    if clause.verb in ("be", "have") and told and told[0] in _GONE and not clause.negated:
        _mark_leaving(state, subjects)
        clear_exits(state)


@rule("people.all_leave")
def note_everyone_leaves(state: ReaderState, clause: Clause) -> None:
    """Note that all leave except the people named: ``Everybody leaves but Nora.``

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
    """
    heads = {noun.head for noun in clause.subject}
    goes = _LEAVING.match(clause.verb) or f"{clause.verb} {clause.particle}" in ("go out", "file out", "walk out")
    if heads & _ALL and goes and not (clause.negated or clause.unreal):
        kept = {person.id for word in state.sentence.words if word.mention for person in word.mention.candidates}
        _mark_leaving(state, [person for person in state.on_stage() if person.id not in kept])


@rule("people.left_alone")
def note_left_alone(state: ReaderState, clause: Clause, subjects: Sequence[Person]) -> None:
    """Note that all others are gone: ``Rick stands alone in the fog.``, but not ``alone at a table``.

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
        subjects: Subjects of the clause.
    """
    words = state.sentence.words
    alone = any(word.low == "alone" and word.verb is None for word in words)
    spot = any(phrase.head not in _WEATHER for _, phrases in clause.places for phrase in phrases)
    told = alone and clause.verb in _STAYING and not spot and not _takes_an_object(words)
    forsaken = _FORSAKEN.search(" ".join(word.low for word in words if not word.inserted)) and (
        clause.verb != "leave" or clause.passive
    )
    if (told or forsaken) and subjects and not (clause.negated or clause.unreal):
        _mark_leaving(state, [person for person in state.on_stage() if person not in subjects])
        clear_exits(state)


def _takes_an_object(words: Sequence[Word]) -> bool:
    """Whether ``alone with`` names a second person: ``to be alone with her``."""
    alone = next(index for index, word in enumerate(words) if word.low == "alone")
    return alone + 1 < len(words) and words[alone + 1].low == "with"


@rule("people.seen_off")
def note_seen_off(state: ReaderState, clause: Clause, roles: Roles) -> None:
    """Note who left as others see: ``shuts the door behind him``, ``watched him down the road``.

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
        roles: The people and things of the clause.
    """
    things = roles.things if roles.subjects else roles.subject_things
    doors = [thing for thing in things if state.inventory.head(thing) in ("door", "gate")]
    gone = roles.people_after("behind", "after") if clause.verb in _CLOSED and doors else []
    came = {deed.actor for unit in state.reading.units[-2:] for deed in unit.deeds if deed.motion in _GOING}
    arrived = {person for unit in state.reading.units[-2:] for person in unit.entering if person in came}
    gone = [person for person in gone if person.id not in arrived]
    if clause.verb in ("watch", "see") and roles.prepositions & {"down", "out of", "along"}:
        gone = roles.people
    _mark_leaving(state, [person for person in gone if person not in roles.subjects])


def clear_exits(state: ReaderState) -> None:
    """Take those who left off the stage, before the next unit."""
    for person in state.scene.leaving:
        if person in state.scene.on:
            state.scene.on.remove(person)
        state.scene.held.pop(person, None)
    state.scene.gone = state.scene.leaving
    state.scene.leaving = []


def _mark_leaving(state: ReaderState, people: Sequence[Person]) -> None:
    """Mark people to leave when the sentence is over."""
    state.scene.leaving += [person.id for person in people if person.id not in state.scene.leaving]


def _is_exit(state: ReaderState, clause: Clause, roles: Roles, motion: str) -> bool:
    """Whether a motion of a clause is an exit."""
    phrase = f"{clause.verb} {clause.particle}".strip()
    next_word = [word.low for word in state.sentence.words[clause.index + 1 : clause.index + 2]]
    goes_on = clause.verb == "go" and next_word == ["on"]
    if phrase in _STAYS or goes_on or (clause.verb in _ARISING and "for" in roles.prepositions):
        return False
    alone = not (roles.places or roles.people or roles.things)
    bare = alone and not clause.particle
    if clause.verb in _FOLLOWING and not roles.prepositions - {"by"} and (bare or roles.people):
        after = {person.id for person in roles.people} or set(state.scene.gone + state.scene.leaving)
        if after & {*state.scene.gone, *state.scene.leaving}:
            return True
    if (clause.verb in ("go", "bolt") and bare) or (phrase == "take off" and alone):
        return True
    if clause.verb == "leave" and _leaves_something(state, roles):
        return False
    indoors = state.place.scene_type == "indoor"
    if not indoors and "into" in roles.prepositions and not _leads_out(state, clause, roles):
        return False
    if _LEAVING.match(phrase) or _LEAVING.match(clause.verb):
        return True
    if is_through_a_door(clause) or any(noun.head == "exit" for noun in clause.object):
        return True
    goes = motion in _GOING or clause.verb in _HAULING
    return goes and clause.verb not in _COMING_OUT and _leads_out(state, clause, roles)


def _leaves_something(state: ReaderState, roles: Roles) -> bool:
    """Whether the verb leaves a thing and not the scene: ``leaves the keys on the table``."""
    kinds = {state.inventory.class_of(thing) for thing in roles.things}
    return bool(kinds & {"prop", "body", "worn", "set_piece"})


def _leads_out(state: ReaderState, clause: Clause, roles: Roles) -> bool:
    """Whether the words after a verb of going lead out of the scene."""
    indoors = state.place.scene_type == "indoor"
    if clause.particle in _AWAY and (clause.particle != "off" or clause.verb not in _GETTING_OFF):
        return clause.particle != "out" or indoors or clause.verb not in _GETTING_OFF
    rest = [word.low for word in state.sentence.words[clause.index + 1 : clause.index + 5]]
    if indoors and _ASCENDING & set(rest) and clause.verb not in ("come", "look", "return"):
        return True
    if not indoors and clause.particle == "inside":
        return True
    return any(_place_leads_out(state, place, indoors) for place in roles.places)


def _place_leads_out(state: ReaderState, place: Place, indoors: bool) -> bool:
    """Whether a place of a clause leads out of the scene."""
    heads = {noun.head for noun in place.nouns if noun.kind == "thing"}
    if place.preposition == "out of" and heads & _BEYOND:
        return True
    if not indoors:
        return place.preposition in ("into", "inside") and bool(heads & _WIDE)
    here = set(state.place.place.lower().split())
    if place.preposition in ("out of", "from", "out"):
        return bool(heads & (_OPENINGS | {"room"} | here)) or bool(heads & lexicon.INDOOR)
    if place.preposition == "into" and heads & _PASSAGES - here:
        return True
    return any(_is_another_room(state, place, noun, here) for noun in place.nouns)


def _is_another_room(state: ReaderState, place: Place, noun: NounPhrase, here: set[str]) -> bool:
    """Whether a place is a room other than the scene: ``runs for his room``, ``returns to the cellar``."""
    if (
        noun.kind != "thing"
        or noun.head not in lexicon.INDOOR
        or place.preposition not in ("into", "to", "for", "back to")
    ):
        return False
    if noun.head != "room" and noun.head in here:
        return False
    words = state.sentence.words
    other = noun.possessor is not None or {w.low for w in words[max(0, noun.index - 2) : noun.index]} & _OTHER
    return bool(other) or (bool(here & _ROOMS) and noun.head in _ROOMS and noun.head != "room")
