"""Where people and things are in relation to each other (notes of the director, 4.3)."""

from __future__ import annotations

import re
from collections.abc import Iterable

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.clauses import Clause
from storyblender.agents.director.reader.coreference import resolve, resolve_owner
from storyblender.agents.director.reader.people_meant import resolve_mention
from storyblender.agents.director.reader.phrases import NounPhrase, Phrase
from storyblender.agents.director.reader.roles import Place, Roles
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reader.states import hold
from storyblender.agents.director.reader.words import joined
from storyblender.agents.director.reading import Person
from storyblender.memory.vocabulary import RelationKind

_Stated = tuple[str, RelationKind, str]
"""Who or what, the relation, to whom or what."""
_STATIVE = lexicon.words("stative")
_AT_REST = lexicon.words("at_rest")
"""Verbs that tell where a thing is, not what somebody does."""
_TURNING = frozenset({"turn", "hesitate"})
"""``turns at the door``."""
_ARRIVING = frozenset({"drop", "emerge", "step", "watch", "follow", "appear", "stop", "pause"}) | _TURNING
"""Verbs that place only relative to people: behind, before, beside."""
_STILL = frozenset({"sit", "stand", "lie_down", "kneel", "lean", "sleep", "hide", "crouch"})
_PLACING = lexicon.words("placing")
_ANCHORS = frozenset({"prop", "set_piece", "worn", "unknown", "scenery"})
_THINGS = frozenset({"prop", "set_piece", "worn", "unknown"})
_ATTACHING, _SURFACES, _GAZE = lexicon.words("attaching"), lexicon.words("surfaces"), lexicon.words("gaze")
_BESIDE = frozenset(word.replace("_", " ") for word in lexicon.words("beside"))
"""Prepositions that tell where somebody is whatever they do: ``runs alongside him``."""
_COMING_TO_REST, _WHERE = (
    lexicon.words("coming_to_rest"),
    ("on", "to", "in", "into", "onto", "under", "behind", "beneath"),
)
_AT_WORK = frozenset({"cook", "eat", "drink", "read", "write", "type", "work", "cut", "clean", "pour", "play_music"})
_CONSUMING = frozenset({"eat", "drink", "read", "smoke"})
"""``eats a sandwich on a ladder``: it is the eater who is on it."""
_BOXES = frozenset({"crate", "box", "trunk", "barrel", "chest", "basket", "suitcase", "bucket"})
"""Somebody sits on them, but things are put in them."""
_BACKING = frozenset(
    {"back", "press", "flatten", "shrink", "retreat", "stagger", "crash", "slam", "lean", "prop", "brace"}
)
"""``backs against the wall``."""
_HOLDING = frozenset({"hold", "raise", "lift", "wave", "swing"})
_MOVED = frozenset({"put_down", "drop", "throw"})
_OPENINGS = frozenset({"door", "window", "gate"})
_IMAGES = frozenset({"mirror", "photo", "photograph", "picture", "painting", "screen", "monitor", "reflection"})
_ONTO_SOMEBODY = frozenset({"on", "onto", "to", "around", "round", "about", "over", "across", "behind", "between"})
_FLOOR = frozenset({"rug", "carpet", "floor", "ground"})
_ON_THE_SIDE = re.compile(r"\bto (?:her|his|their|the) (left|right)\b")
_BESIDE_FURNITURE = ("by", "near", "next to", "beside", "in front of")
_GRIPS = frozenset({"hand", "fist", "arm", "paw", "grip"})
"""What is in a hand or under an arm is held."""
_SEATING = lexicon.words("seating")
"""``She sat him on a stool``."""
_OF_THE_NOUN: frozenset[RelationKind] = frozenset(
    {"on", "under", "in_front_of", "behind", "next_to", "in", "over", "against"}
)


def relate_clause(stage: Stage, clause: Clause, roles: Roles, motion: str | None, first: bool) -> None:
    """State the relations a clause tells.

    Args:
        stage: The state before.
        clause: Not negated.
        roles: Its people and things.
        motion: The motion of its subject.
        first: Whether it is the first clause of its sentence.
    """
    located = [person.id for person in roles.subjects] or [
        thing for thing in roles.subject_things if stage.inventory.class_of(thing) in _THINGS
    ]
    found: list[_Stated] = []
    if located:
        for place in _telling_places(stage, clause, roles, motion):
            found += _placed(stage, clause, place, located, motion)
        if _is_still(clause, roles, motion):
            _between(stage, roles, located)
        elif motion in ("climb", "jump") and not clause.opening:
            found += _onto(roles, located)
    if first and roles.subjects:
        _left_or_right(stage, roles.subjects)
    if _puts_something(clause, roles, motion):
        found += _put(stage, roles)
    for subject, kind, anchor in _seat_beside(stage, roles, motion, found):
        stage.relate(subject, kind, anchor)


def _is_still(clause: Clause, roles: Roles, motion: str | None) -> bool:
    """Whether a clause tells where its subject is: it stands, is laid, hangs there."""
    moved = clause.verb in _PLACING and bool(roles.things)
    still = (clause.verb in _STATIVE and not moved) or clause.verb in _ARRIVING or motion in _STILL
    laid = clause.verb in _AT_REST and not roles.subjects
    return still or laid or (clause.passive and clause.verb in _PLACING | _AT_REST | _ATTACHING)


def _has_furniture(stage: Stage, place: Place) -> bool:
    """``writes at the desk``, but not ``works at the knot``."""
    return any(stage.inventory.class_of(thing) in ("set_piece", "scenery") for thing in place.things)


def _telling_places(stage: Stage, clause: Clause, roles: Roles, motion: str | None) -> list[Place]:
    """The places of a clause that tell where its subject is once it is over."""
    if _is_still(clause, roles, motion):
        return [place for at, place in enumerate(roles.places) if not (at and _goes_with(roles.places[at - 1], place))]
    if clause.opening:
        return roles.places[-clause.opening :]
    if motion == "fall" or (roles.subject_things and clause.verb in _COMING_TO_REST):
        return [place for place in roles.places if place.preposition in _WHERE]
    if not roles.subjects or clause.verb in _GAZE or (clause.verb in _PLACING and roles.things):
        return []
    return [
        place
        for place in roles.places
        if (place.preposition == "at" and motion in _AT_WORK and _has_furniture(stage, place))
        or (place.preposition in ("on", "in") and motion in _CONSUMING and not place.people)
        or (place.preposition == "against" and clause.verb in _BACKING and not roles.things and bool(place.things))
        or (place.preposition in _BESIDE and (place.people or not roles.things + roles.people))
    ]


def _goes_with(before: Place, place: Place) -> bool:
    """``sits with her feet on the desk``: the feet are on it."""
    return (
        before.preposition == "with" and bool(before.things) and place.preposition in ("on", "over", "under", "across")
    )


def _puts_something(clause: Clause, roles: Roles, motion: str | None) -> bool:
    """Whether things, or people, end up somewhere else."""
    carried = motion in _MOVED or clause.verb in _PLACING or bool(roles.prepositions & {"into", "onto"})
    seated = bool(roles.people) and (clause.verb in _SEATING or motion in _MOVED | {"pull", "push", "carry"})
    return (bool(roles.things) and carried and not clause.passive) or seated


def _onto(roles: Roles, located: list[str]) -> list[_Stated]:
    """``climbs onto a chair``."""
    chairs = [thing for place in roles.places if place.preposition == "onto" for thing in place.things]
    return [(subject, "on", chair) for chair in chairs for subject in located]


def _placed(stage: Stage, clause: Clause, place: Place, located: list[str], motion: str | None) -> list[_Stated]:
    kind = lexicon.relation_of(place.preposition)
    grounded = not stage.person(located[0]) and any(stage.inventory.head(thing) in _FLOOR for thing in place.things)
    kind = "on" if place.preposition == "to" and (clause.verb in _ATTACHING or grounded) else kind
    if kind is None or kind == "between" or place.preposition == "down":
        return []
    past_it = place.preposition == "across" and clause.verb == "be" and stage.person(located[0]) is not None
    if past_it or _is_an_image(stage, kind, place):
        return []
    if kind == "on" and any(stage.inventory.head(thing) in _OPENINGS for thing in place.things):
        return []  # with his hand upon the gate
    doorway = any(stage.inventory.head(thing) == "doorway" for thing in place.things)
    doorway |= (
        kind == "at"
        and clause.verb in _TURNING
        and any(stage.inventory.head(thing) in _OPENINGS for thing in place.things)
    )
    if (
        clause.verb in _ARRIVING
        and motion != "sit"
        and kind not in ("behind", "in_front_of", "next_to")
        and not doorway
    ):
        return []
    anchors = [person.id for person in place.people]
    anchors += [thing for thing in place.things if stage.inventory.class_of(thing) in _ANCHORS]
    if kind in ("in", "at") and place.things and stage.inventory.class_of(place.things[0]) == "scenery":
        anchors = [person.id for person in place.people]
        surfaces = kind == "in" or place.preposition in ("on", "onto", "upon")
        anchors += [thing for thing in place.things if surfaces and stage.inventory.head(thing) in _SURFACES]
    body = next((noun for noun in place.nouns if noun.kind == "thing" and noun.head in lexicon.BODY), None)
    if body and body.owner and kind == "under":
        return []  # ducks under his arm
    if body and body.owner:
        anchors, kind = [body.owner], ("on" if place.preposition in ("across", "in", "over") else kind)
    return [
        (subject, _exact_kind(stage, kind, anchor, clause.verb), anchor)
        for anchor in anchors
        if not (_is_the_place(stage, anchor) and kind in ("in", "at"))
        for subject in located
        if subject != anchor
    ]


def _is_an_image(stage: Stage, kind: RelationKind, place: Place) -> bool:
    """``In the mirror stands a man``: he is somewhere else."""
    return kind == "in" and any(stage.inventory.head(thing) in _IMAGES for thing in place.things)


def _exact_kind(stage: Stage, kind: RelationKind, anchor: str, verb: str) -> RelationKind:
    """In an armchair is on it, at the window is next to it, leaning on is against."""
    head = stage.inventory.head(anchor)
    if kind == "on" and verb in ("lean", "slouch"):
        return "against"
    if kind == "in" and head in lexicon.SEATS and not (verb == "put" and head in _BOXES):
        return "on"
    return "next_to" if kind == "at" and head in _OPENINGS else kind


def _is_the_place(stage: Stage, anchor: str) -> bool:
    """Whether a noun only names the scene's own place: ``He sits in the cafe``."""
    head = stage.inventory.head(anchor)
    return bool(head) and head in stage.place.place.lower().split()


def _between(stage: Stage, roles: Roles, located: list[str]) -> None:
    """Between two anchors; a group counts as its members."""
    for place in roles.places:
        anchors = [person.id for person in place.people] + place.things
        if place.preposition == "between" and len(anchors) > 1:
            for subject in located:
                stage.relate(subject, "between", anchors[0], anchors[1])


def _left_or_right(stage: Stage, subjects: list[Person]) -> None:
    """``To her left, Dutch chews a toothpick.``"""
    side = _ON_THE_SIDE.search(joined(stage.sentence.words))
    if side is None:
        return
    kind: RelationKind = "left_of" if side.group(1) == "left" else "right_of"
    pronouns = stage.sentence.pronouns
    owner = next((pronouns[i][0] for i in sorted(pronouns) if stage.sentence.words[i].low in ("her", "his")), [])
    others = [person for person in owner if person not in subjects]
    others = others or [person for person in stage.on_stage() if person not in subjects][:1]
    for subject in subjects:
        for other in others:
            stage.relate(subject.id, kind, other.id)


def _put(stage: Stage, roles: Roles) -> list[_Stated]:
    """Puts the tray on the table, the ring into the pocket, the bag over one shoulder."""
    found: list[_Stated] = []
    moved = [thing for thing in roles.things if stage.inventory.class_of(thing) != "body"]
    moved += [person.id for person in roles.people]
    for place in roles.places:
        wearer = _wearer(place)
        if wearer and roles.things:
            for thing in moved:
                if not stage.person(thing):
                    found.append((thing, "on", wearer))
            continue
        kind = lexicon.relation_of(place.preposition)
        kind = "on" if place.preposition == "to" and stage.sentence.verb in _ATTACHING else kind
        if kind not in ("on", "in", "under", "next_to", "behind", "against", "in_front_of"):
            continue
        beside = kind in ("in_front_of", "next_to") or (roles.people and kind == "behind")
        anchors = [person.id for person in place.people if beside]
        anchors += [
            thing
            for thing in place.things
            if stage.inventory.class_of(thing) in _THINGS or stage.inventory.head(thing) in _SURFACES
        ]
        if kind == "on" and roles.subjects and any(noun.head in lexicon.BODY for noun in place.nouns):
            anchors.append(roles.subjects[0].id)
        for anchor in anchors:
            for thing in moved:
                if thing != anchor:
                    found.append((thing, _exact_kind(stage, kind, anchor, "put"), anchor))
    return _furniture_beside(stage, roles, found)


def _wearer(place: Place) -> str | None:
    """``pins it on the old woman's coat``, ``around her shoulders``: it is on her."""
    if place.preposition not in _ONTO_SOMEBODY:
        return None
    return next((n.owner for n in place.nouns if n.owner and n.head in lexicon.BODY | lexicon.WORN), None)


def _furniture_beside(stage: Stage, roles: Roles, found: list[_Stated]) -> list[_Stated]:
    """``Lays her hat on the chair by the stove``: it is the chair that is by the stove."""
    pieces = [
        anchor for _, kind, anchor in found if kind in ("on", "in") and stage.inventory.class_of(anchor) == "set_piece"
    ]
    beside = [
        place for place in roles.places if place.things and place.preposition in ("by", "near", "next to", "beside")
    ]
    if not pieces or not beside or beside[0].things[0] == pieces[0]:
        return found
    other = beside[0].things[0]
    return [*(relation for relation in found if relation[2] != other), (pieces[0], "next_to", other)]


def _seat_beside(stage: Stage, roles: Roles, motion: str | None, found: list[_Stated]) -> list[_Stated]:
    """``Sits in the armchair by the window``: it is the armchair that is by the window."""
    if motion not in ("sit", "lie_down", "sleep"):
        return found
    seats = [
        place.things[0]
        for place in roles.places
        if place.things
        and lexicon.relation_of(place.preposition) in ("on", "in", "at")
        and stage.inventory.class_of(place.things[0]) != "body"
        and stage.inventory.head(place.things[0]) in lexicon.SEATS | {"table", "desk"}
    ]
    beside = [
        place
        for place in roles.places
        if place.things
        and (
            (place.preposition in _BESIDE_FURNITURE and stage.inventory.class_of(place.things[0]) == "set_piece")
            or (place.preposition == "in" and stage.inventory.head(place.things[0]) == "corner")
        )
    ]
    at_table = any(kind == "at" for _, kind, _ in found)
    if not seats or not beside or (at_table and beside[0].preposition == "in front of"):
        return found
    if stage.inventory.head(seats[0]) in _FLOOR:
        return found
    window = beside[0].things[0]
    kind = lexicon.relation_of(beside[0].preposition)
    moved = [relation for relation in found if relation[2] != window]
    return [*moved, (seats[0], kind, window)] if kind else moved


# -- relations outside clauses -----------------------------------------------------------------------------------


def relate_noun_phrases(stage: Stage, phrases: list[Phrase], subjects: list[Person], previous: list[Person]) -> None:
    """A noun with its own place: ``a cold coffee cup in front of her``, ``the phone on the wall``."""
    for index, phrase in enumerate(phrases[:-2]):
        noun, preposition, anchor = phrase.noun, phrases[index + 1], phrases[index + 2].noun
        left = phrases[index - 1] if index else None
        if not (noun and preposition.kind == "preposition" and anchor):
            continue
        kind = lexicon.relation_of(preposition.text)
        if kind in _OF_THE_NOUN and noun.mention and left and left.text == "with":
            for person in resolve_mention(stage, noun.mention):
                for target in _anchors(stage, anchor, subjects, previous):
                    stage.relate(person.id, kind, target)
        if (
            kind not in _OF_THE_NOUN
            or noun.kind != "thing"
            or lexicon.noun_class(noun.key) not in ("prop", "set_piece")
        ):
            continue
        if left and left.kind == "preposition" and left.text != "with" and kind != "on":
            continue
        if anchor.head in lexicon.BODY and (kind == "in" or (kind == "over" and stage.sentence.verb not in _HOLDING)):
            kind = "on"
        if noun.head in _OPENINGS and kind == "behind" and anchor.kind != "thing":
            continue
        thing = stage.inventory.id_of(noun.key, stage.sentence.words[noun.index].start)
        consumed = lexicon.MOTION_OF_VERB.get(stage.sentence.verb) in _CONSUMING
        if consumed and thing == stage.sentence.object_thing and kind in ("on", "in"):
            continue
        if anchor.head in _GRIPS:
            for holder in _anchors(stage, anchor, subjects, previous):
                hold(stage, holder, thing)
                stage.inventory.seen(thing, "handled")
            continue
        for target in _anchors(stage, anchor, subjects, previous):
            stage.relate(thing, _exact_kind(stage, kind, target, ""), target)


def _anchors(stage: Stage, anchor: NounPhrase, subjects: list[Person], previous: list[Person]) -> Iterable[str]:
    if anchor.kind == "thing" and anchor.head in lexicon.BODY:
        resolve_owner(stage, anchor, "possessor", subjects, previous)
        return [anchor.owner] if anchor.owner else []
    if anchor.kind == "pronoun" and lexicon.PRONOUNS.get(anchor.head) == "thing":
        return []
    found = resolve(
        stage, anchor, "possessor" if anchor.kind == "pronoun" else "object", subjects, subjects or previous
    )
    if found.thing and (
        (
            stage.inventory.class_of(found.thing) not in ("prop", "set_piece")
            and stage.inventory.head(found.thing) not in _SURFACES
        )
        or _is_the_place(stage, found.thing)
    ):
        return []
    return [person.id for person in found.people] + ([found.thing] if found.thing else [])
