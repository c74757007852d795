"""What stays after a sentence: postures, things in hand, doors, lamps and light, and what is heard or shows on a face."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.clauses import Clause
from storyblender.agents.director.reader.morphology import singular
from storyblender.agents.director.reader.roles import Roles
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reader.words import joined
from storyblender.agents.director.reading import Deed, Person, StateChange
from storyblender.memory.vocabulary import Posture

_POSTURE_OF_MOTION: dict[str, Posture] = {
    "sit": "sit", "lie_down": "lie", "kneel": "kneel", "crouch": "crouch", "sleep": "asleep", "crawl": "kneel",
    "fall": "lie", "wake": "lie", "lean": "lean",
}  # fmt: skip
_UPRIGHT = frozenset(
    {"stand_up", "stand", "walk", "run", "jump", "climb", "dance", "stagger", "sneak", "fight", "swim"}
)
_TAKING = frozenset({"pick_up", "take", "hold", "carry", "catch"})
_LOSING = frozenset({"put_down", "drop", "throw"})
_NOT_HELD = frozenset({"abstract", "body", "set_piece", "scenery"})
_SUPPORTED = frozenset({"sit", "lie_down", "sleep", "lean", "kneel"})
_READY = re.compile(r"\b([a-z-]+) (drawn|raised|ready|in hand|at the ready|in his hand|in her hand)(?! of)\b")


def settle(stage: Stage, deeds: Sequence[Deed], clause: Clause, roles: Roles) -> None:
    """Carry the outcome of deeds into the scene: postures, things in hand, vehicles."""
    for deed in deeds:
        posture = _POSTURE_OF_MOTION.get(deed.motion)
        if posture:
            stage.scene.posture[deed.actor] = (posture, _support(stage, deed, roles))
        elif deed.motion in _UPRIGHT:
            stage.scene.posture[deed.actor] = ("stand", None)
        _board(stage, deed, clause, roles)
        _handle(stage, deed)


def _support(stage: Stage, deed: Deed, roles: Roles) -> str | None:
    """What somebody sits, lies or leans on."""
    if deed.motion not in _SUPPORTED:
        return None
    for place in roles.places:
        kind = lexicon.relation_of(place.preposition)
        for thing in place.things:
            if kind in ("on", "in", "against") and stage.inventory.class_of(thing) in ("set_piece", "prop"):
                return thing
    seat = stage.inventory.head(deed.target) in lexicon.SEATS
    if seat:
        return deed.target
    known = stage.scene.posture.get(deed.actor)
    return known[1] if known and known[0] in ("sit", "lie", "asleep") and deed.motion in ("sit", "sleep") else None


def _board(stage: Stage, deed: Deed, clause: Clause, roles: Roles) -> None:
    """Getting into a vehicle is sitting in it; getting out is standing again."""
    if clause.verb not in ("get", "climb", "step", "slide", "jump") or deed.motion not in ("walk", "climb", "jump"):
        return
    prepositions = roles.prepositions | {clause.particle}
    if stage.inventory.head(deed.target) in lexicon.VEHICLES and prepositions & {"in", "into", "inside"}:
        stage.scene.posture[deed.actor] = ("sit", deed.target)
    elif prepositions & {"out", "out of"}:
        stage.scene.posture[deed.actor] = ("stand", None)


def _handle(stage: Stage, deed: Deed) -> None:
    thing, held = deed.prop, stage.scene.held
    if not thing or stage.inventory.class_of(thing) in _NOT_HELD:
        return
    if deed.motion in _TAKING:
        hold(stage, deed.actor, thing)
    elif deed.motion in _LOSING and thing in held.get(deed.actor, ()):
        held[deed.actor].remove(thing)
    elif deed.motion == "give":
        _release(stage, thing)
        if deed.target and stage.person(deed.target):
            hold(stage, deed.target, thing)


def hold(stage: Stage, person: str, thing: str) -> None:
    """Put a thing into somebody's hand, out of everybody else's."""
    if thing not in stage.scene.held.get(person, ()):
        _release(stage, thing)
        stage.scene.held.setdefault(person, []).append(thing)


def _release(stage: Stage, thing: str) -> None:
    for things in stage.scene.held.values():
        if thing in things:
            things.remove(thing)


def drawn_weapons(stage: Stage, people: Sequence[Person]) -> None:
    """``Gun drawn``, ``notebook in hand``: the subject holds it."""
    text = joined(stage.sentence.words)
    for match in _READY.finditer(text):
        noun = singular(match.group(1))
        if noun not in lexicon.PROPS or not people:
            continue
        at = next((word.start for word in stage.sentence.words if word.low == match.group(1)), stage.unit.start)
        thing = stage.inventory.id_of(noun, at)
        stage.inventory.seen(thing, "handled")
        hold(stage, people[0].id, thing)
        known = any(deed.actor == people[0].id and deed.motion == "hold" for deed in stage.unit.deeds)
        if "hand" in match.group(2) and not known:
            stage.unit.deeds.append(Deed(people[0].id, "hold", thing, thing, at, "hold"))


# -- doors, lamps, light -----------------------------------------------------------------------------------------

_BY_VERB = {
    "open": "open", "unlock": "open", "pop": "open", "close": "closed", "shut": "closed", "slam": "closed", "lock": "closed",
    "break": "broken", "shatter": "broken", "smash": "broken", "crack": "broken", "burst": "broken", "explode": "broken",
}  # fmt: skip
_PARTICLE_STATE = {"open": "open", "shut": "closed", "on": "on", "off": "off", "out": "off"}
_LAMPS = frozenset(
    {
        "lamp",
        "light",
        "lights",
        "bulb",
        "candle",
        "lantern",
        "torch",
        "flashlight",
        "fire",
        "tv",
        "radio",
        "television",
        "screen",
    }
)
_LIGHTING = frozenset({"light", "lights", "bulb", "power", "room", "electricity"})
_GOING_OUT = frozenset({"go", "die", "fail", "blow", "flicker", "dim", "come", "snap", "blink"})


def changes(stage: Stage, clause: Clause, roles: Roles) -> None:
    """Emit what the clause changes: doors that open, lamps and lights that go on or off, things that break."""
    if clause.negated or clause.unreal:
        return
    _openings(stage, clause, roles)
    _lights(stage, clause, roles)


def _openings(stage: Stage, clause: Clause, roles: Roles) -> None:
    state = _BY_VERB.get(clause.verb) or {"open": "open", "shut": "closed"}.get(clause.particle)
    if clause.verb == "be":
        state = next(
            (s for noun in clause.complement if (s := {"open": "open", "closed": "closed"}.get(noun.head))), state
        )
    if state is None:
        return
    for thing in roles.things or (roles.subject_things if not roles.subjects else []):
        openable = stage.inventory.head(thing) in lexicon.OPENABLE
        if (openable and state in ("open", "closed")) or (
            state == "broken" and stage.inventory.class_of(thing) in ("prop", "set_piece")
        ):
            _change(stage, thing, state, clause.at)


def _lights(stage: Stage, clause: Clause, roles: Roles) -> None:
    """``The lights go out`` darkens the scene; ``She lights a candle`` switches one thing on."""
    state = _PARTICLE_STATE.get(clause.particle)
    switched = clause.verb in ("turn", "switch", "flip", "flick", "click", "snap", "blow", "put") and state in (
        "on",
        "off",
    )
    for thing in roles.things:
        if switched and stage.inventory.head(thing) in _LAMPS:
            _change(stage, _light_or_thing(stage, thing), state or "", clause.at)
        elif clause.verb in ("light", "ignite", "kindle") and stage.inventory.head(thing) in _LAMPS | {"match"}:
            _change(stage, thing, "on", clause.at)
    if roles.subjects or clause.verb not in _GOING_OUT:
        return
    for thing in roles.subject_things:
        if stage.inventory.head(thing) in _LAMPS | _LIGHTING:
            failed = clause.verb in ("die", "fail") or (state == "off")
            shown = (
                "off" if failed else "on" if state == "on" else clause.verb if clause.verb in ("flicker", "dim") else ""
            )
            if shown:
                _change(
                    stage,
                    _light_or_thing(stage, thing),
                    {"flicker": "flickering", "dim": "dim"}.get(shown, shown),
                    clause.at,
                )


def _light_or_thing(stage: Stage, thing: str) -> str:
    return "light" if stage.inventory.head(thing) in _LIGHTING else thing


def _change(stage: Stage, subject: str, state: str, at: int) -> None:
    change = StateChange(subject, state, at)
    if change not in stage.unit.changes:
        stage.unit.changes.append(change)


# -- sounds and faces --------------------------------------------------------------------------------------------

_SOUNDING = frozenset(
    {"ring", "sound", "bark", "rumble", "howl", "creak", "blare", "wail", "echo", "toll", "chime", "roar", "rattle", "buzz",
     "beep", "tick", "hiss", "crackle", "boom", "crash", "shatter", "slam", "thunder", "whistle", "hammer", "pound", "roll",
     "explode", "break", "go", "start", "hum", "ping", "clang", "rustle", "snap", "die"}
)  # fmt: skip
_LOUD = frozenset(
    {"bang", "crash", "boom", "explosion", "gunshot", "gunshots", "gunfire", "thunder", "siren", "sirens", "alarm", "thud",
     "click", "beep", "buzz", "whoosh", "splash", "footsteps", "applause", "laughter", "scream", "knock", "creak", "rumble",
     "static", "ping", "klaxon", "doorbell", "birdsong", "music", "whistle", "crack", "slam"}
)  # fmt: skip
_SOUND_OF_MOTION = {"shoot": "gunshot", "knock": "knock", "clap": "applause"}


def sounds(stage: Stage, clauses: Sequence[Clause]) -> None:
    """Collect the sound effects of the sentence: BANG, thunder rumbles, the phone rings, somebody shoots."""
    found: list[str] = [_SOUND_OF_MOTION[d.motion] for d in stage.unit.deeds if d.motion in _SOUND_OF_MOTION]
    verbs = {clause.verb for clause in clauses if not clause.negated}
    for clause in clauses:
        heads = [noun.head for noun in clause.subject if noun.kind == "thing"]
        if clause.verb == "hear":
            found += [lexicon.SOUNDS[noun.head] for noun in clause.object if noun.head in lexicon.SOUNDS]
        if clause.verb in _SOUNDING:
            found += [lexicon.SOUNDS[head] for head in heads if head in lexicon.SOUNDS]
        if "door" in " ".join(heads + [noun.head for noun in clause.object]) and clause.verb == "slam":
            found.append("door_slam")
    for word in stage.sentence.words:
        if word.low in _LOUD and word.verb is None and (word.text.isupper() or not verbs):
            found.append(lexicon.SOUNDS[word.low])
    for sound in found:
        if sound not in stage.unit.sounds:
            stage.unit.sounds.append(sound)


def expressions(stage: Stage, clause: Clause, people: Sequence[Person]) -> None:
    """Keep what shows on a face: smiles, frowns."""
    if clause.verb in lexicon.FACE_VERBS and not clause.negated and not clause.unreal:
        for person in people:
            stage.unit.expressions[person.id] = clause.verb
