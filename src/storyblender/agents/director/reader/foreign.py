"""Reads action in German, Spanish, French and Italian by word tables: subjects, motions, objects, places, postures.

There is no grammar here. A clause is the text between two links; its subject is the person or pronoun before its
verb, else the person after it, else the subject of the clause before; the verb and its companion words give the motion.
"""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.lexicon.foreign import Tongue
from storyblender.agents.director.reader.deeds.outcomes import hold
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.page.sentences import Sentence
from storyblender.agents.director.reader.people.person_reference import resolve_mention
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Deed, Person, StateChange
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Posture, RelationKind

_POSTURES: dict[str, Posture] = {
    "sit": "sit", "lie_down": "lie", "kneel": "kneel", "crouch": "crouch", "lean": "lean", "sleep": "asleep",
    "fall": "lie", "stand": "stand", "stand_up": "stand", "walk": "stand", "run": "stand", "jump": "stand",
}  # fmt: skip
_RESTING = frozenset({"sit", "lie_down", "kneel", "stand", "lean", "sleep", "crouch"})
_TAKING = frozenset({"take", "pick_up", "hold", "carry", "catch"})
_SHORTEST = 3
"""Least letters of a noun at the end of a compound."""
_LEAVING = {
    "de": frozenset({"verlässt", "hinaus", "raus"}),
    "es": frozenset({"sale", "salen"}),
    "fr": frozenset({"sort", "sortent"}),
    "it": frozenset({"esce", "escono"}),
}
_CHANGES = {"open": "open", "close": "closed"}


@rule("deeds.another_language")
def read_foreign(state: ReaderState, sentence: Sentence, tongue: Tongue) -> None:
    """Read a sentence of action in another language into the current unit.

    Args:
        state: The state before the sentence.
        sentence: The sentence, with the names of the cast marked.
        tongue: The language of the sentence.
    """
    state.sentence.words = sentence.words
    subjects = _carried(state)
    for clause in _clauses(sentence.words, tongue):
        subjects = _read_clause(state, clause, tongue, subjects)
    state.discourse.subjects = subjects


def _carried(state: ReaderState) -> list[Person]:
    """Return the people of the scene before who come along."""
    return [person for person in state.discourse.subjects if person.id in state.scene.on]


def _clauses(words: Sequence[Word], tongue: Tongue) -> list[list[Word]]:
    """Split a sentence at links; a piece without a verb joins the clause before."""
    pieces: list[list[Word]] = [[]]
    for word in words:
        if word.low in tongue.links and not word.mention:
            pieces.append([])
        else:
            pieces[-1].append(word)
    joined: list[list[Word]] = []
    for piece in pieces:
        if joined and not any(_is_verb(piece, at, tongue) for at in range(len(piece))):
            joined[-1] += piece
        elif piece:
            joined.append(piece)
    return joined


def _read_clause(state: ReaderState, words: Sequence[Word], tongue: Tongue, before: list[Person]) -> list[Person]:
    """Read one clause and return its subjects."""
    verb = next((at for at in range(len(words)) if _is_verb(words, at, tongue)), None)
    named = [(at, person) for at, word in enumerate(words) for person in _people(state, words, at, word, tongue)]
    things = [(at, thing) for at, word in enumerate(words) if (thing := _thing(state, word, tongue))]
    for _, person in named:
        state.mention(person, 1.0)
        state.enter(person)
        state.add_to_unit(person)
    if verb is None:
        return [person for _, person in named[:1]] or before
    subjects = _subjects(state, words, verb, named, things, before, tongue)
    motion = _motion(words, verb, tongue)
    if motion is None or not subjects:
        return subjects or before
    _act(state, words, verb, motion, subjects, [p for at, p in named if p not in subjects], things, tongue)
    return subjects


def _is_verb(words: Sequence[Word], at: int, tongue: Tongue) -> bool:
    """Whether a word is used as a verb: not in ``en la cocina``."""
    placed = at > 1 and words[at - 1].low in tongue.articles and words[at - 2].low in tongue.places
    noun = tongue.key == "de" and at > 0 and words[at].text[0].isupper()
    return words[at].mention is None and words[at].low in tongue.verbs and not (placed or noun)


def _people(state: ReaderState, words: Sequence[Word], at: int, word: Word, tongue: Tongue) -> list[Person]:
    """Return the people a word names; a person after ``von`` or ``de`` is only an owner."""
    if at and words[at - 1].low in ("von", "de", "del", "di"):
        return []
    if word.mention is None:
        return state.roster.find(word.low)[:1] if word.low in tongue.people or word.text[0].isupper() else []
    return resolve_mention(state, word.mention) or word.mention.candidates[:1]


def _thing(state: ReaderState, word: Word, tongue: Tongue) -> str | None:
    """Return the id of the thing that a word names, or None."""
    english = _english(word, tongue) if word.mention is None else None
    if english is None:
        return None
    thing = state.inventory.id_of(english, word.start)
    state.inventory.note(thing, "seen")
    if thing not in state.unit.things:
        state.unit.things.append(thing)
    return thing


def _english(word: Word, tongue: Tongue) -> str | None:
    """Return the English noun of a noun, for a German compound of its last part: ``Schuppentür``; else None."""
    if word.low in tongue.things or tongue.key != "de" or not word.text[0].isupper():
        return tongue.things.get(word.low)
    ends = [noun for noun in tongue.things if len(noun) >= _SHORTEST and word.low.endswith(noun)]
    return tongue.things[max(ends, key=len)] if ends else None


def _subjects(
    state: ReaderState,
    words: Sequence[Word],
    verb: int,
    named: Sequence[tuple[int, Person]],
    things: Sequence[tuple[int, str]],
    before: list[Person],
    tongue: Tongue,
) -> list[Person]:
    """Return the people before the verb, else after it if unambiguous, else the subjects before."""
    leading = [person for at, person in named if at < verb and not _is_placed(words, at, tongue)]
    if leading:
        return leading
    for word in words[:verb] or words[verb + 1 : verb + 2]:
        if word.low in tongue.pronouns:
            return _pronoun(state, tongue.pronouns[word.low], before)
    if any(at < verb and not _is_placed(words, at, tongue) for at, _ in things) or _is_of_a_noun(words[:verb], tongue):
        return []  # the door flies open
    inverted = [person for at, person in named if at > verb and not _is_placed(words, at, tongue)]
    first = words[0].low in tongue.places or verb == 0
    noun_follows = words[0].low in tongue.places and _is_of_a_noun(words[verb + 1 :], tongue)
    if noun_follows and not inverted:
        return []  # behind the hedge stands a house
    return inverted[:1] if inverted and first and tongue.key != "es" else before or inverted[:1]


def _is_of_a_noun(words: Sequence[Word], tongue: Tongue) -> bool:
    """Whether an article or possessive stands before a noun that is no member of the cast: ``Das Licht``."""
    if len(words) < 2 or words[0].low not in tongue.articles:
        return False
    return not any(word.mention or word.low in tongue.people for word in words[:4])


def _is_placed(words: Sequence[Word], at: int, tongue: Tongue) -> bool:
    """Whether a preposition stands before a word."""
    return at > 0 and any(
        word.low in tongue.places or word.low in ("a", "zu", "à") for word in words[max(0, at - 2) : at]
    )


def _pronoun(state: ReaderState, gender: str, before: list[Person]) -> list[Person]:
    """Return the people a pronoun means."""
    here = state.referable_people()
    if gender == "unknown":
        return [person for person in here if person.kind != "animal"]
    fitting = [person for person in here if person.gender in (gender, "unknown")]
    for person in before:
        if person in fitting:
            return [person]
    best = max(fitting, key=state.prominence, default=None)
    return [best] if best else before


def _motion(words: Sequence[Word], verb: int, tongue: Tongue) -> str | None:
    """Return the motion of the table row that matches most words near the verb, or None."""
    around = {word.low for word in words}
    for others, motion in tongue.verbs[words[verb].low]:
        if all(other in around for other in others):
            return motion
    return None


def _act(
    state: ReaderState,
    words: Sequence[Word],
    verb: int,
    motion: str,
    subjects: list[Person],
    others: list[Person],
    things: Sequence[tuple[int, str]],
    tongue: Tongue,
) -> None:
    """Add the deeds of a clause and the postures and places that result."""
    placed: list[tuple[str, RelationKind]] = [
        (thing, kind) for at, thing in things if (kind := _relation(words, at, tongue))
    ]
    handled = [thing for at, thing in things if not _relation(words, at, tongue)]
    anchor: tuple[str, RelationKind] | None = placed[0] if placed else None
    if motion in _RESTING and anchor is None and handled:
        anchor = (handled[0], "at")
        handled = handled[1:]
    prop = handled[0] if handled else None
    target = others[0].id if others else prop or (anchor[0] if anchor else None)
    for person in subjects:
        state.unit.deeds.append(Deed(person.id, motion, target, prop, words[verb].start, words[verb].low))
        if motion in _POSTURES:
            support = anchor[0] if anchor and motion in _RESTING else None
            state.scene.posture[person.id] = (_POSTURES[motion], support)
        if anchor and motion in _RESTING:
            seat = anchor[1] == "in" and state.inventory.head(anchor[0]) in lexicon.SEATS
            state.relate(person.id, "on" if seat else anchor[1], anchor[0])
        if prop and motion in _TAKING:
            hold(state, person.id, prop)
        elif prop and motion == "give" and others:
            hold(state, others[0].id, prop)
        elif prop and prop in state.scene.held.get(person.id, ()) and motion in ("put_down", "throw", "drop"):
            state.scene.held[person.id].remove(prop)
    for thing in handled:
        state.inventory.note(thing, "handled", determined=True)
    for thing, kind in placed:
        state.inventory.note(thing, "related")
        if prop and motion == "put_down":
            state.relate(prop, kind, thing)
    if prop and motion in _CHANGES and state.inventory.head(prop) in lexicon.OPENABLE:
        state.unit.changes.append(StateChange(prop, _CHANGES[motion], words[verb].start))
    if {word.low for word in words} & _LEAVING[tongue.key]:
        state.scene.leaving += [person.id for person in subjects if person.id not in state.scene.leaving]


def _relation(words: Sequence[Word], at: int, tongue: Tongue) -> RelationKind | None:
    """Return the relation of a preposition at most three words before a thing, or None."""
    for word in reversed(words[max(0, at - 3) : at]):
        if word.low in tongue.places:
            return tongue.places[word.low]
        if word.mention or word.low in tongue.verbs:
            return None
    return None
