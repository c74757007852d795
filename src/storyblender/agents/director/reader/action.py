"""Reads one sentence of action: its clauses change the reader's state in reading order."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader import noticing
from storyblender.agents.director.reader.bearing.calls import note_calls
from storyblender.agents.director.reader.bearing.faces import note_expressions, note_gaze
from storyblender.agents.director.reader.bearing.grips import note_grips, note_possession, note_tethers
from storyblender.agents.director.reader.bearing.looks import note_fragment, note_looks, note_worn
from storyblender.agents.director.reader.bearing.postures import note_lasting_activities, note_posture
from storyblender.agents.director.reader.deeds import changes, deeds, entrances, exits, outcomes
from storyblender.agents.director.reader.deeds.motions import motion_of
from storyblender.agents.director.reader.deeds.needs import fitting_motion
from storyblender.agents.director.reader.deeds.unread import flag_unread, nearest_motion, note_unread
from storyblender.agents.director.reader.depicted import split_depicted
from storyblender.agents.director.reader.language.bare_places import insert_place_nouns
from storyblender.agents.director.reader.language.body_parts import motion_of_part
from storyblender.agents.director.reader.language.clauses import Clause, find_clauses
from storyblender.agents.director.reader.language.phrases import find_phrases
from storyblender.agents.director.reader.language.rewrite import regularise
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.page.sentences import Sentence
from storyblender.agents.director.reader.people.coreference import resolve_owner
from storyblender.agents.director.reader.people.introduced import resolve_introduction_pronouns
from storyblender.agents.director.reader.people.person_reference import resolve_mention
from storyblender.agents.director.reader.people.roles import Roles, resolve_objects, resolve_subject
from storyblender.agents.director.reader.people.thing_reference import ASIDE, SEEN, raise_things
from storyblender.agents.director.reader.places import noun_places, relations
from storyblender.agents.director.reader.places.place_pronouns import resolve_place_pronouns
from storyblender.agents.director.reader.state import ReaderState, SentenceState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_POSED = frozenset({"seat", "slump", "sprawl", "curl", "perch", "huddle", "crouch", "settle"})
"""``is slumped over the bar``: a posture, done by nobody else."""
_OPENINGS = frozenset({"door", "doorway", "window", "threshold", "gate"})
"""``JOANNA in the doorway``: there one stands."""
_FOLLOWED = frozenset({"follow", "pursue", "chase"})
"""``walks out, followed by Mia``: it is Mia who follows."""
_STATIVE = lexicon.words("stative")
_SPOKEN = frozenset({"call", "shout", "yell"})
_OPENING = 2
"""Words in which the subject of a sentence without a known verb stands: ``Her husband interposed.``"""
_BEFORE_LOOK = lexicon.PREPOSITIONS | lexicon.DETERMINERS | lexicon.POSSESSIVES
_ADJECTIVES = 4
"""Words before a garment that may describe it."""
_POSE_ON = {"knee": "kneel", "knees": "kneel", "back": "lie_down", "stomach": "lie_down", "belly": "lie_down"}
"""``is on her knees``, ``is flat on his back``."""


def read_action(state: ReaderState, sentence: Sentence) -> None:
    """Read a sentence of action into the current unit.

    Args:
        state: The reader's state; changed in place.
        sentence: The sentence.
    """
    lately = [state.inventory.head(thing) for thing in state.discourse.recent_things]
    named = any(word.mention and word.mention.kind == "name" for word in sentence.words)
    elsewhere = sentence.pictured and named  # what a known person does in another place
    there, shown = ([], sentence.words) if sentence.pictured else split_depicted(sentence.words, lately)
    state.scene.pictured |= _people_on_screen(state, shown)
    words = regularise(sentence.words if elsewhere else there)
    phrases = insert_place_nouns(find_phrases(words))
    clauses = find_clauses(words, phrases)
    previous = state.discourse.subjects
    state.sentence = SentenceState(words, pictured=elsewhere)
    noticing.notice_nouns(state, phrases)
    resolve_place_pronouns(state, phrases)
    if not clauses:
        note_fragment(state, words, previous, sentence.paragraph.start)
        _enter_named_people(state)
        noun_places.relate_listed(state, phrases)
    for index, clause in enumerate(clauses):
        _read_clause(state, clause, state.sentence.subjects or previous, first=index == 0)
    entrances.enter_named(state, words, clauses)
    subjects = state.sentence.subjects
    relations.relate_side_by_side(state, sentence.words, subjects)
    resolve_introduction_pronouns(state, sentence.words, sentence.end)
    note_worn(state, phrases)
    noun_places.relate_noun_phrases(state, phrases, subjects, previous)
    outcomes.hold_drawn_things(state, subjects or previous)
    changes.note_sounds(state, clauses)
    _note_bearing(state, clauses, subjects or previous)
    flag_unread(state)
    raise_things(state, dict.fromkeys(thing for _, thing in state.sentence.things), SEEN)
    state.discourse.moving = state.sentence.first_thing
    if subjects:
        state.discourse.subjects = subjects


def _note_bearing(state: ReaderState, clauses: list[Clause], people: list[Person]) -> None:
    """Note expressions, gaze, lasting activities, grips and tethers."""
    here = [person for person in people if person.id in state.scene.on]
    if state.sentence.pictured:
        return
    note_expressions(state, state.sentence.words, here)
    note_gaze(state, here)
    note_lasting_activities(state, clauses, here)
    note_grips(state, state.sentence.words, here)
    note_calls(state, here)
    note_tethers(state, state.sentence.words, here)


def _people_on_screen(state: ReaderState, shown: list[Word]) -> set[str]:
    """Return the ids of people who are only seen on a screen: those named there, and animals."""
    seen = [word.mention.candidates[0] for word in shown if word.mention and word.mention.candidates]
    named = {word.mention.candidates[0].id for word in shown if word.named and word.mention and word.mention.candidates}
    return {p.id for p in seen if p.id in named or p.kind == "animal"} - {*state.scene.on}


@rule("people.named_without_verb")
def _enter_named_people(state: ReaderState) -> None:
    """Bring the people on stage whom a sentence without a clause names."""
    named: list[Person] = []
    for index, word in enumerate(state.sentence.words):
        definite = word.mention and word.mention.determiner not in ("", "a", "an") and index <= _OPENING
        if word.mention and (word.named or definite) and not entrances.is_elsewhere(state, index):
            named += resolve_mention(state, word.mention)
    for person in named:
        state.mention(person, 0.6)
        if not state.sentence.pictured:
            state.enter(person)
            state.add_to_unit(person)
    if named:
        state.sentence.subjects = named[:1]


def _read_clause(state: ReaderState, clause: Clause, previous: list[Person], first: bool) -> None:
    """Read one clause: its people and things, motion, deeds, changes and relations."""
    state.sentence.verb = clause.verb
    roles = resolve_subject(state, clause, previous)
    if first:
        state.sentence.first_thing = roles.subject_things[0] if roles.subject_things and not roles.subjects else None
    if len(roles.subjects) > 1:
        discourse = state.discourse
        discourse.groups.append((discourse.sentence, list(roles.subjects), discourse.clock + len(roles.subjects)))
    part = None if roles.subjects else motion_of_part(clause)
    owner = state.person(clause.subject[0].owner or "") if part else None
    roles.subjects = [owner] if owner else roles.subjects
    seen = entrances.enter_subjects(state, clause, roles.subjects)
    if roles.subjects and (clause.main or not state.sentence.subjects):
        state.sentence.subjects = roles.subjects
    exits.note_left_alone(state, clause, roles.subjects)
    exits.note_gone(state, clause, roles.subjects)
    exits.note_everyone_leaves(state, clause)
    if not roles.subjects and not state.sentence.subjects:
        _owner_is_subject(state, clause)
    resolve_objects(state, clause, roles, previous)
    followers = [] if clause.object else _agents(clause, roles)
    if followers:
        roles.subjects, roles.people, clause.passive = followers, roles.subjects, False
        roles.things = roles.things or roles.subject_things
        roles.places = [p for p in roles.places if p.preposition != "by" or clause.verb in _FOLLOWED]
        entrances.enter_subjects(state, clause, followers)
    for noun in clause.asides:
        resolve_owner(state, noun, "possessor", roles.subjects, previous)
        raise_things(state, [state.inventory.id_of(noun.key, state.sentence.words[noun.index].start)], ASIDE)
    note_looks(state, clause, roles)
    _note_clothes(state, roles)
    exits.note_seen_off(state, clause, roles)
    exits.note_taken_away(state, clause, roles)
    changes.note_changes(state, clause, roles)
    if clause.negated or clause.unreal or (clause.verb in _SPOKEN and not seen):
        return
    outcomes.drop_slipped_things(state, clause, roles)
    motion = part or _motion(state, clause, roles)
    relations.relate_clause(state, clause, roles, motion, first)
    noticing.notice_things(state, clause, roles, motion)
    note_possession(state, clause, roles)
    if state.sentence.plural_thing:
        state.discourse.last_plural = (state.sentence.plural_thing, state.discourse.sentence)
    entrances.enter_objects(state, clause, roles, motion)
    changes.note_facial_deeds(state, clause, roles.subjects)
    motion = motion or _posture(state, clause, roles)
    if not motion:
        motion = nearest_motion(clause, roles)
        note_unread(state, clause, roles, motion)
    if roles.subjects and motion and not clause.earlier:
        outcomes.apply_outcomes(state, deeds.add_deeds(state, clause, roles, motion), clause, roles)
    note_posture(state, clause, roles)
    if roles.subjects and motion and not clause.earlier:
        exits.note_exits(state, clause, roles, motion)


def _agents(clause: Clause, roles: Roles) -> list[Person]:
    """Return who does a passive clause: ``followed by Mia``, ``The door is opened by Peg``."""
    resting = clause.verb in _STATIVE
    return roles.people_after("by") if clause.verb in _FOLLOWED or (clause.passive and not resting) else []


def _owner_is_subject(state: ReaderState, clause: Clause) -> None:
    """Make the owner of a subject the topic: ``Ling's goggles slip off. She goes on``."""
    owner = next((state.person(noun.owner) for noun in clause.subject if noun.owner), None)
    if owner:
        state.sentence.subjects = [owner]
        state.mention(owner, 0.6)


@rule("looks.worn_in")
def _note_clothes(state: ReaderState, roles: Roles) -> None:
    """Add clothes to a person, so that they are no place: ``A woman in a grey suit``."""
    for place in [place for place in roles.places if place.preposition == "in" and place.things]:
        if all(state.inventory.class_of(thing) == "worn" for thing in place.things):
            roles.places.remove(place)
            for person in roles.subjects:
                if not person.outfit:
                    words = state.sentence.words
                    start = max(0, place.nouns[0].index - _ADJECTIVES)
                    described = [w.text for w in words[start : place.nouns[0].index + 1] if w.text.islower()]
                    cut = max((i for i, w in enumerate(described) if w in _BEFORE_LOOK), default=-1)
                    person.outfit = (" ".join(described[cut + 1 :]),)


def _motion(state: ReaderState, clause: Clause, roles: Roles) -> str | None:
    """Return the motion of a clause, or None."""
    if not roles.subjects or (clause.passive and clause.verb not in _POSED):
        return None
    head = state.inventory.head(roles.things[0]) if roles.things else "person" if roles.people else ""
    if roles.things and head in lexicon.BODY and state.inventory.class_of(roles.things[0]) == "prop":
        head = ""
    if any(noun.head.endswith(("self", "selves")) for noun in clause.object):
        head = "self"
    elif not head and any(noun.head == "it" for noun in clause.object):
        head = "it"
    posture = state.scene.posture.get(roles.subjects[0].id, ("stand", None))[0]
    motion = motion_of(clause, head, posture)
    motion = fitting_motion(state, clause, roles, motion) if motion else None
    voiced = motion in ("shout", "talk", "whisper") and all(p.kind == "animal" for p in roles.subjects)
    return None if voiced else motion


@rule("postures.being_somewhere")
def _posture(state: ReaderState, clause: Clause, roles: Roles) -> str | None:
    """Return the motion of a posture without a verb: ``MAN #2 is on the bed``, ``Hale is asleep``; else None."""
    if clause.verb != "be" or not roles.subjects or state.sentence.pictured:
        return None
    if any(noun.head == "asleep" for noun in clause.complement):
        return "sleep"
    if exits.is_through_a_door(clause):
        return "walk"
    for place in roles.places:
        pose = _POSE_ON.get(next((noun.head for noun in place.nouns), "")) if place.preposition == "on" else None
        if pose:
            return pose
    seated = any(
        state.inventory.head(place.things[0]) in lexicon.SEATS
        for place in roles.places
        if place.things and lexicon.relation_of(place.preposition) in ("on", "in")
    )
    if seated:
        return "sit"
    at_opening = any(p.preposition in ("at", "in") and any(n.head in _OPENINGS for n in p.nouns) for p in roles.places)
    return "stand" if at_opening else None
