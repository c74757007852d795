"""Changes that a sentence tells: doors, lamps and light, liquids, things that break; sounds; smiles and frowns."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person, StateChange
from storyblender.agents.director.rules import rule
from storyblender.catalog.liquids import LIQUIDS

_STATE_OF_VERB = {
    "open": "open", "unlock": "open", "pop": "open", "close": "closed", "shut": "closed", "slam": "closed",
    "lock": "closed", "break": "broken", "shatter": "broken", "smash": "broken", "crack": "broken", "burst": "broken",
    "explode": "broken", "overturn": "tipped", "topple": "tipped", "upend": "tipped", "capsize": "tipped",
    "spill": "spilled", "tip over": "tipped", "knock over": "tipped", "fall over": "tipped", "kick over": "tipped",
}  # fmt: skip
_HARMED = frozenset({"broken", "tipped", "spilled"})
_STATE_OF_PARTICLE = {"open": "open", "shut": "closed", "on": "on", "off": "off", "out": "off"}
_HALF_OUT = {"flicker": "flickering", "dim": "dim"}
_TAPS = lexicon.words("taps")
_POURING = frozenset({"run", "pour", "gush", "flow", "spurt", "spray", "stream", "splash", "drip"})
_SPILT = frozenset({"spill", "pour", "splash", "slop", "drip", "leak"})
_COMING = frozenset({"arrive", "appear", "materialize", "materialise", "emerge"})
_MOVING = frozenset({"drive", "pull", "roll", "draw", "come", "ride", "sail", "fly", "speed", "race", "screech"})
_COMES = frozenset({"up", "in", "into", "out", "along", "alongside"})
"""Particles with which a moving thing arrives."""
_LAMPS, _LIGHTING = lexicon.words("lamps"), lexicon.words("lighting")
_SWITCHING, _LIGHTING_UP = lexicon.words("switching"), lexicon.words("lighting_up")
_FAILING = lexicon.words("failing")
_SOUNDING, _LOUD = lexicon.words("sounding"), lexicon.words("loud")
_SOUND_OF_MOTION = {"shoot": "gunshot", "knock": "knock", "clap": "applause"}


@rule("changes.told")
def note_changes(state: ReaderState, clause: Clause, roles: Roles) -> None:
    """Add what a clause changes to the unit: doors, lamps and lights, liquids, things that break or appear.

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
        roles: The people and things of the clause.
    """
    if clause.negated or clause.unreal:
        return
    _note_openings(state, clause, roles)
    for thing in roles.things:
        _note_switched(state, clause, thing)
    for thing in roles.subject_things if not roles.subjects else ():
        _note_failure(state, clause, thing)
        _note_arrival(state, clause, thing)
    _note_liquids(state, clause, roles)


def _note_openings(state: ReaderState, clause: Clause, roles: Roles) -> None:
    """Note what opens, closes or breaks: ``opens the door``, ``The window shatters``."""
    ajar = clause.particle if clause.particle in ("open", "shut") else ""
    phrased = _STATE_OF_VERB.get(f"{clause.verb} {clause.particle}")
    condition = _STATE_OF_PARTICLE.get(ajar) or phrased or _STATE_OF_VERB.get(clause.verb)
    condition = condition or _STATE_OF_PARTICLE.get(clause.particle)
    for thing in roles.things or (roles.subject_things if not roles.subjects else ()):
        openable = state.inventory.head(thing) in lexicon.OPENABLE and condition in ("open", "closed")
        breakable = state.inventory.class_of(thing) in ("prop", "set_piece") and condition in _HARMED
        if condition and (openable or breakable):
            _add_change(state, thing, condition, clause.at)


def _note_switched(state: ReaderState, clause: Clause, thing: str) -> None:
    """Note lamps and taps turned on or off: ``turns off the lamp``, ``lights a candle``."""
    head, condition = state.inventory.head(thing), _STATE_OF_PARTICLE.get(clause.particle)
    if clause.verb in _SWITCHING and condition in ("on", "off") and head in _TAPS:
        _add_change(state, thing, "running" if condition == "on" else "off", clause.at)
    if clause.verb in _SWITCHING and condition in ("on", "off") and head in _LAMPS:
        _add_change(state, thing, condition, clause.at)
    elif clause.verb in _LIGHTING_UP and (head in _LAMPS or head == "match"):
        _add_change(state, thing, "on", clause.at)


def _note_arrival(state: ReaderState, clause: Clause, thing: str) -> None:
    """Note a thing that appears: before ``A car pulls up`` it was not there."""
    moves = clause.verb in _MOVING and clause.particle in _COMES
    comes = state.inventory.class_of(thing) == "prop" or state.inventory.head(thing) in lexicon.VEHICLES
    if comes and (clause.verb in _COMING or moves):
        _add_change(state, thing, "there", clause.at)


def _note_liquids(state: ReaderState, clause: Clause, roles: Roles) -> None:
    """Note what runs or spills: ``Water runs from the tap``, ``The milk spills over the table``."""
    named = next((noun.head for noun in clause.subject if noun.head in LIQUIDS), None)
    if named is None or roles.subjects:
        return
    around = [*roles.things, *(thing for place in roles.places for thing in place.things)]
    tap = next((thing for thing in around if state.inventory.head(thing) in _TAPS), None)
    if tap is not None and clause.verb in _POURING:
        _add_change(state, tap, "running", clause.at)
        return
    if clause.verb in _SPILT and state.scene.fallen:
        _add_change(state, state.scene.fallen, "spilled", clause.at)


def _note_failure(state: ReaderState, clause: Clause, thing: str) -> None:
    """Note lights that fail: ``The lights go out``, ``The lamp flickers``, ``The power dies``."""
    head = state.inventory.head(thing)
    if clause.verb not in _FAILING or head not in _LAMPS | _LIGHTING:
        return
    condition = "off" if clause.verb in ("die", "fail") else _HALF_OUT.get(clause.verb)
    condition = _STATE_OF_PARTICLE.get(clause.particle) or condition
    if condition:
        _add_change(state, thing, condition, clause.at)


def _add_change(state: ReaderState, thing: str, condition: str, at: int) -> None:
    """Add a change of state once; the lights of the whole place are the subject ``light``."""
    subject = "light" if state.inventory.head(thing) in _LIGHTING else thing
    change = StateChange(subject, condition, at)
    state.scene.fallen = thing if condition == "tipped" else state.scene.fallen
    if change not in state.unit.changes:
        state.unit.changes.append(change)


@rule("sounds.told")
def note_sounds(state: ReaderState, clauses: Sequence[Clause]) -> None:
    """Add the sound effects of a sentence to the unit: BANG, thunder, a phone that rings, a shot.

    Args:
        state: The reader's state; changed in place.
        clauses: Clauses of the sentence.
    """
    found = [_SOUND_OF_MOTION[deed.motion] for deed in state.unit.deeds if deed.motion in _SOUND_OF_MOTION]
    for clause in clauses:
        nouns = clause.object if clause.verb == "hear" else clause.subject if clause.verb in _SOUNDING else []
        heads = [noun.head for noun in nouns if noun.kind == "thing"]
        found += [lexicon.SOUNDS[head] for head in heads if head in lexicon.SOUNDS]
        if clause.verb == "slam" and any(noun.head == "door" for noun in clause.subject + clause.object):
            found.append("door_slam")
    alone = all(clause.negated for clause in clauses)
    for word in state.sentence.words:
        if word.low in _LOUD and word.verb is None and (word.text.isupper() or alone):
            found.append(lexicon.SOUNDS[word.low])
    state.unit.sounds += [sound for sound in dict.fromkeys(found) if sound not in state.unit.sounds]


@rule("bearing.face_by_verb")
def note_facial_deeds(state: ReaderState, clause: Clause, people: Sequence[Person]) -> None:
    """Keep the facial deeds of a clause as expressions: smiles, frowns.

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
        people: People whom the clause is about.
    """
    if clause.verb in lexicon.FACE_VERBS and not clause.negated and not clause.unreal:
        for person in people:
            state.unit.expressions[person.id] = clause.verb
