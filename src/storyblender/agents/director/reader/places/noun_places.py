"""Places that belong to a noun and not to a verb: ``the phone on the wall``, ``a coffee cup in front of her``."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.deeds.outcomes import hold
from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase
from storyblender.agents.director.reader.people.coreference import Referents, record_reference, resolve, resolve_owner
from storyblender.agents.director.reader.people.person_reference import resolve_mention
from storyblender.agents.director.reader.places.anchors import (
    BODY_OR_DRESS,
    CLOTHS,
    CONTAINERS,
    FITTINGS,
    OPENINGS,
    SURFACES,
    TOUCHING,
    exact_relation,
    is_carried_support,
    is_scene_place,
    relation_at_body,
)
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import RelationKind

_CONSUMING = frozenset({"eat", "drink", "read", "smoke"})
_HOLDING = frozenset({"hold", "raise", "lift", "wave", "swing"})
_GRIPS = frozenset({"hand", "fist", "arm", "paw", "grip"})
"""What is in a hand or under an arm is held."""
_BEARING = frozenset({"lap", "knee", "shoulder", "thigh"})
"""What is on them is a thing, whatever it is called."""
_BACKS = frozenset({"back", "shoulder"})
"""``his back against the wall``: he himself."""
_PICTURES = frozenset({"photograph", "photo", "picture", "portrait", "painting", "drawing", "sketch", "statue"})
_PASSING = lexicon.words("passing")
"""``slides the box across the table``: it does not stay there."""
_STATIVE, _PLACING = lexicon.words("stative"), lexicon.words("placing")
_BOARDS = lexicon.words("boards")
_SITTING = frozenset({"sit", "perch", "squat", "crouch", "kneel", "slump"})
_OPEN = frozenset({"open", "shut", "up", "down", "out", "back", "over"})
"""``a book open on her lap``."""
_OF_THE_NOUN: frozenset[RelationKind] = frozenset(
    {"on", "under", "in_front_of", "behind", "next_to", "in", "over", "against", "between", "left_of", "right_of"}
)
_LEADS_TO = frozenset({"at", "to", "toward", "towards", "for", "with", "of", "from", "past", "on", "through"})
"""``stares at the clock above the door``: it is the clock that is above it."""


@rule("relations.noun_phrase")
def relate_noun_phrases(
    state: ReaderState, phrases: list[Phrase], subjects: list[Person], previous: list[Person]
) -> None:
    """State where the nouns are that have a prepositional phrase of their own right after them.

    Args:
        state: The reader's state after the clauses of the sentence.
        phrases: Phrases of the sentence.
        subjects: Subjects of the sentence.
        previous: Subjects of the sentence before.
    """
    for index, phrase in enumerate(phrases):
        at = _place_after(phrases, index)
        while phrase.noun and at:
            _relate(state, phrases, index, at, subjects, previous)
            onward = at + 2 if _stands_apart(phrases, index) else len(phrases)
            at = onward if onward + 1 < len(phrases) and phrases[onward].kind == "preposition" else 0


@rule("relations.listed")
def relate_listed(state: ReaderState, phrases: list[Phrase]) -> None:
    """State that listed things are on or in the thing before a colon: ``a table laid for one: a plate, a cup``.

    Args:
        state: The reader's state; the sentence has no verb.
        phrases: Phrases of the sentence.
    """
    text = state.reading.screenplay.text[: state.unit.start].rstrip()
    here = {thing for _, thing in state.sentence.things}
    before = next((thing for thing in state.discourse.recent_things if thing not in here), None)
    head = state.inventory.head(before)
    if not text.endswith(":") or before is None or not (head in CONTAINERS or head in _BOARDS):
        return
    for noun in _listed(phrases, 0):
        thing = state.inventory.id_of(noun.key, state.sentence.words[noun.index].start)
        if noun.kind == "thing" and state.inventory.class_of(thing) in ("prop", "worn"):
            state.relate(thing, "in" if head in CONTAINERS else "on", before)


def _place_after(phrases: list[Phrase], index: int) -> int:
    """Index of the preposition after a noun: ``a book open on her lap``; 0 where there is none."""
    at = index + 1
    if at + 1 < len(phrases) and phrases[at].kind == "preposition" and phrases[at].text in _OPEN:
        at += phrases[at + 1].kind == "preposition"
    return at if at + 1 < len(phrases) and phrases[at].kind == "preposition" else 0


def _stands_apart(phrases: list[Phrase], index: int) -> bool:
    """Whether a noun stands apart from the clause: ``, the helmet on the floor in front of her``."""
    return index > 0 and phrases[index - 1].text in (",", "with", ";")


def _relate(
    state: ReaderState, phrases: list[Phrase], index: int, at: int, subjects: list[Person], previous: list[Person]
) -> None:
    """State the relation of the noun at ``index`` to the place whose preposition is at ``at``."""
    noun, preposition = phrases[index].noun, phrases[at].text
    kind, first = _relation_of_noun(preposition), phrases[at + 1].noun
    if noun is None or first is None:
        return
    if first.head in ("left", "right") and first.possessor is not None and preposition in ("to", "on", "at"):
        kind = "left_of" if first.head == "left" else "right_of"
    anchors = _listed(phrases, at + 1)[: 2 if kind == "between" else 1]
    at_side = first.head in lexicon.BODY and first.possessor is not None and preposition in ("at", "by")
    at_window = kind == "at" and first.head in OPENINGS and noun.kind == "thing" and noun.head in lexicon.SET_PIECES
    if kind not in _OF_THE_NOUN and not at_side and not at_window:
        return
    if _is_depicted(phrases, index):
        return
    _resolve_it(state, phrases[:index], first)
    left = phrases[index - 1] if index else None
    nobody = noun.mention is not None and not resolve_mention(state, noun.mention)
    if nobody:  # a bolt cutter, a cat that nobody knows
        noun = replace(noun, kind="thing", key=noun.head, mention=None)
    if noun.mention:
        if first.head in _GRIPS and preposition in ("in", "under"):
            return
        on_body = first.head in lexicon.BODY and left is not None and (left.text == "," or left.kind == "verb")
        others = [p.noun.mention for p in phrases[max(0, index - 2) : index] if p.noun and p.noun.mention]
        others = others if left is not None and left.text == "and" and phrases[max(0, index - 3)].text == "," else []
        apart = left is not None and (left.text == "," or bool(others)) and any(p.verb for p in phrases[:index])
        ends = at + 2 >= len(phrases) or phrases[at + 2].text in (".", ",", ";")
        if left and (
            left.text == "with"
            or _continues_with(phrases, index)
            or on_body
            or (apart and ends and not any(p.verb for p in phrases[at:]))
        ):
            kind = relation_at_body(preposition, first.head, kind) if first.head in lexicon.BODY else kind
            told = [person for mention in [*others, noun.mention] for person in resolve_mention(state, mention)]
            for person in told if kind else []:
                for target in _anchors(state, first, kind or "on", subjects, previous):
                    state.relate(person.id, kind or "on", target)
    elif noun.head in _BACKS and noun.possessor is not None and kind == "against":
        resolve_owner(state, noun, "possessor", subjects, subjects or previous)
        for target in _anchors(state, first, kind, subjects, previous) if noun.owner else ():
            state.relate(noun.owner or "", kind, target)
    elif noun.kind == "thing" and _is_of_the_noun(phrases, index, preposition, kind):
        noun = _container_of(phrases, index) or noun
        _relate_thing(state, noun, preposition, kind, anchors, subjects, previous)


def _continues_with(phrases: list[Phrase], index: int) -> bool:
    """Whether a noun continues a list after ``with``: ``with Luc on her left and Elise on her right``."""
    before = phrases[max(0, index - 5) : index]
    return len(before) > 4 and (before[0].text, before[2].kind, before[4].text) == ("with", "preposition", "and")


def _container_of(phrases: list[Phrase], index: int) -> NounPhrase | None:
    """Return the container of a noun: the plate in ``a plate of bacon in front of him``."""
    holder = phrases[index - 2].noun if index > 1 and phrases[index - 1].text == "of" else None
    return holder if holder and holder.head in CONTAINERS | {"plate", "tray", "platter"} else None


def _is_depicted(phrases: list[Phrase], index: int) -> bool:
    """Whether a noun is only the subject of a picture: ``a portrait of a general on a horse``."""
    picture = phrases[index - 2].noun if index > 1 and phrases[index - 1].text == "of" else None
    return picture is not None and picture.head in _PICTURES


def _resolve_it(state: ReaderState, before: list[Phrase], anchor: NounPhrase) -> None:
    """Record ``it`` as the sentence's first thing: ``A caravan stands by the fence, a trough in front of it``."""
    if anchor.head != "it" or anchor.index in state.sentence.pronouns:
        return
    for index, phrase in enumerate(before):
        if phrase.noun and phrase.noun.kind == "thing" and not (index and before[index - 1].kind == "preposition"):
            thing = state.inventory.id_of(phrase.noun.key, state.sentence.words[phrase.noun.index].start)
            if state.inventory.class_of(thing) in ("prop", "set_piece"):
                record_reference(state, anchor.index, Referents([], thing))
            return


def _relation_of_noun(preposition: str) -> RelationKind | None:
    """Return the relation that a preposition states after a noun, or None."""
    return "next_to" if preposition in ("around", "round", "about") else lexicon.relation_of(preposition)


def _is_of_the_noun(phrases: list[Phrase], index: int, preposition: str, kind: RelationKind | None) -> bool:
    """Whether a place belongs to the noun before it and not to the verb of the clause."""
    verb = next((p.verb.lemma for p in reversed(phrases[:index]) if p.verb), "")
    left = phrases[index - 1] if index else None
    if preposition in ("onto", "on to", "into") and verb:
        return left is not None and left.text in (",", "and")
    if preposition in ("across", "over", "around", "round", "against") and verb in _PASSING:
        return False
    anchor = phrases[index + 2].noun if index + 2 < len(phrases) else None
    seat = kind == "on" and anchor is not None and anchor.head in lexicon.SEATS
    if seat and verb in _SITTING and left is not None and left.kind == "preposition":
        return False  # sits in front of the stove on a crate
    if kind == "on" and verb in TOUCHING and left is not None and left.kind == "verb":
        return False
    if left is None or left.kind != "preposition" or left.text == "with" or kind == "on":
        return True
    if verb in _PLACING - _STATIVE and kind in ("over", "under", "behind", "in_front_of"):
        return left.text in ("on", "in", "to", "onto", "into", "at")
    return left.text in _LEADS_TO and verb not in _STATIVE | _PLACING and verb != ""


def _relate_thing(
    state: ReaderState,
    noun: NounPhrase,
    preposition: str,
    kind: RelationKind | None,
    anchors: list[NounPhrase],
    subjects: list[Person],
    previous: list[Person],
) -> None:
    """State the relation of a thing's noun to its anchors, or put the thing into a hand."""
    anchor = anchors[0]
    if not _can_be_placed(noun, anchor):
        return
    thing = state.inventory.id_of(noun.key, state.sentence.words[noun.index].start)
    if lexicon.noun_class(noun.key) == "unknown":
        state.inventory.note(thing, "held", determined=True)
    if anchor.head in _GRIPS and preposition in ("in", "under"):
        for holder in _anchors(state, anchor, "in", subjects, previous):
            hold(state, holder, thing)
            state.inventory.note(thing, "handled")
        return
    if anchor.head in BODY_OR_DRESS and anchor.possessor is not None:
        around = preposition in ("around", "round")
        worn = around and noun.head not in CLOTHS  # a whistle round her neck, but a blanket round his shoulders
        held_over = kind == "over" and state.sentence.verb in _HOLDING
        told = None if worn else kind if held_over else relation_at_body(preposition, anchor.head, kind)
        heavy = told == "on" and lexicon.noun_class(noun.key) == "set_piece" and noun.head not in lexicon.PORTABLE
        if told is None or told == "against" or heavy:
            state.inventory.note(thing, "related")
            return
        kind = told
    kind = "on" if kind == "over" and noun.head in CLOTHS else kind
    if kind is None or (noun.head in OPENINGS and kind == "behind" and anchor.kind != "thing"):
        return
    consumed = lexicon.MOTION_OF_VERB.get(state.sentence.verb) in _CONSUMING
    if consumed and thing == state.sentence.object_thing and kind in ("on", "in"):
        return
    targets = [target for each in anchors for target in _anchors(state, each, kind, subjects, previous)]
    if kind == "between":
        if len(targets) > 1:
            state.relate(thing, kind, targets[0], targets[1])
        return
    for target in targets:
        around = preposition in ("around", "round", "about") and state.person(target) and kind == "next_to"
        if is_carried_support(state, thing, target):
            state.inventory.note(thing, "related")
        elif not around:
            state.relate(thing, exact_relation(state, kind, target, ""), target)


def _can_be_placed(noun: NounPhrase, anchor: NounPhrase) -> bool:
    """Whether a noun names a thing that can have a place; a garment on a person is worn."""
    kind = lexicon.noun_class(noun.key)
    if kind == "unknown":
        return anchor.head in _BEARING and anchor.possessor is not None and noun.determiner != ""
    solid = kind in ("prop", "set_piece") or (kind == "worn" and anchor.head not in BODY_OR_DRESS)
    return solid and noun.head not in lexicon.LIQUIDS | FITTINGS | {"seat", "place"}


def _anchors(
    state: ReaderState, anchor: NounPhrase, kind: RelationKind, subjects: list[Person], previous: list[Person]
) -> Iterable[str]:
    """Return the ids that an anchor noun means; empty where it is no anchor."""
    beside = anchor.head in ("left", "right") and anchor.possessor is not None
    dress = anchor.head in lexicon.WORN and anchor.possessor is not None
    if anchor.kind == "thing" and (anchor.head in lexicon.BODY or dress or beside):
        resolve_owner(state, anchor, "possessor", subjects, previous)
        return [anchor.owner] if anchor.owner else []
    if anchor.possessor is not None and state.sentence.words[anchor.possessor].low == "its":
        resolve_owner(state, anchor, "possessor", subjects, previous)
    there = anchor.kind == "pronoun" and lexicon.PRONOUNS.get(anchor.head) == "thing"
    role = "possessor" if anchor.kind == "pronoun" and not there else "object"
    known = state.sentence.pronouns.get(anchor.index) if there else None
    found = Referents(*known) if known else resolve(state, anchor, role, subjects, subjects or previous, place=there)
    if found.thing and (
        (
            state.inventory.class_of(found.thing) not in ("prop", "set_piece")
            and not (kind == "in" and state.inventory.head(found.thing) in CONTAINERS)
            and (state.inventory.head(found.thing) not in SURFACES or kind not in ("on", "in", "under"))
        )
        or is_scene_place(state, found.thing)
    ):
        return []
    return [person.id for person in found.people] + ([found.thing] if found.thing else [])


def _listed(phrases: list[Phrase], index: int) -> list[NounPhrase]:
    """Return the nouns of a list that starts at an index: ``a lamp, two clocks and a vase``."""
    nouns: list[NounPhrase] = []
    while index < len(phrases):
        noun = phrases[index].noun
        if noun is None:
            break
        nouns.append(noun)
        measured = [phrase.text for phrase in phrases[index + 1 : index + 2]] == ["of"]
        index += 2 if measured and index + 2 < len(phrases) and phrases[index + 2].noun else 0
        after = [phrase.text for phrase in phrases[index + 1 : index + 3]]
        if not after or after[0] not in (",", "and"):
            break
        index += 3 if after == [",", "and"] else 2
    return nouns
