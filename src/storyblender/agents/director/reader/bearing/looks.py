"""Appearance of people anywhere in the text: ``Otto is bald``, ``She wears a red dress``, ``His hair is wet``."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.phrases import Phrase
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.people.look import age_phrase, read_description
from storyblender.agents.director.reader.people.person_reference import resolve_mention
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.catalog.inflection import singular

_BEING = frozenset({"be", "look"})
_WEARING = frozenset({"wear", "sport", "dress"})
_HAVING = frozenset({"have"})
_STOPS = frozenset({".", ";", ":", "!", "?", "(", ")", "--", "—", "–"})
_HAIRY = lexicon.words("hairy")
_FEATURES = lexicon.words("features")
_LOOKS = lexicon.BUILD | lexicon.HAIR | (lexicon.FACE - {"eyes", "tired", "lined"}) | set(lexicon.AGE_WORDS)
_UNSAID = lexicon.ANIMALS | {"like", "as", "if", "enough", "too"}
_DETERMINING = lexicon.DETERMINERS | lexicon.POSSESSIVES | {"'s", "own"}
_INSIDE = 2
"""Phrases back from a garment to its wearer."""
_MOST = 4
"""Most hair descriptions kept per person."""
_FRAGMENT = 7
"""Most words of a verbless sentence that describes appearance: ``Sixty-six. Bald.``"""


@rule("looks.told")
def note_looks(state: ReaderState, clause: Clause, roles: Roles) -> None:
    """Add the appearance that a clause describes to its person.

    Args:
        state: The state before the clause.
        clause: Any clause that really happens.
        roles: The people and things of the clause.
    """
    if clause.negated or clause.unreal or clause.earlier or state.sentence.pictured:
        return
    words = _words_after(state.sentence.words, clause.index)
    if len(roles.subjects) == 1:
        person = roles.subjects[0]
        worn = any(_is_worn(noun.head) for noun in clause.object)
        if clause.verb in _WEARING and (worn or clause.places):
            _dress(state, person, words)
        elif (clause.verb in _BEING and not clause.passive) or (
            clause.verb in _HAVING and any(n.head in _HAIRY | _FEATURES for n in clause.object)
        ):
            _add_appearance(state, person, words)
    elif not roles.subjects and clause.subject and (clause.verb in _BEING or clause.passive):
        _describe_part(state, clause, [state.sentence.words[clause.index]] if clause.passive else words)


@rule("looks.fragment")
def note_fragment(state: ReaderState, words: Sequence[Word], people: Sequence[Person], start: int) -> None:
    """Add the appearance that a fragment tells after an introduction: ``Sixty-six.``, ``Bald, in a torn coat.``

    Args:
        state: The state before.
        words: A sentence without a clause.
        people: The people of the sentence before.
        start: Offset of the paragraph.
    """
    if len(people) != 1 or people[0].first < start or any(word.mention for word in words):
        return
    written = [word.text for word in words if not word.inserted and word.text not in _STOPS]
    before = state.reading.units[-2] if len(state.reading.units) > 1 else None
    named = [thing for thing in before.things if state.inventory.class_of(thing) != "unknown"] if before else []
    if not 0 < len(written) <= _FRAGMENT or named:
        return
    _add_appearance(state, people[0], words)


@rule("looks.worn")
def note_worn(state: ReaderState, phrases: Sequence[Phrase]) -> None:
    """Add a garment that a person owns (``tips his hat``) or wears (``a boy in a torn coat``).

    Args:
        state: The state after the clauses of the sentence, in which owners are known.
        phrases: The phrases of the sentence.
    """
    for index, phrase in enumerate(phrases):
        noun = phrase.noun
        if noun is None or noun.kind != "thing" or not _is_worn(noun.head):
            continue
        owner = state.person(noun.owner or "") or _wearer_before(state, phrases, index)
        if owner is None or any(noun.head in piece.lower() or noun.key in piece.lower() for piece in owner.outfit):
            continue
        before = (word for word in state.sentence.words[phrase.first : noun.index] if not word.inserted)
        said = [word.text for word in before if word.low not in _DETERMINING and word.solid]
        _add_outfit(state, owner, " ".join([*said, state.sentence.words[noun.index].text.lower()]))


def _wearer_before(state: ReaderState, phrases: Sequence[Phrase], index: int) -> Person | None:
    """Return the person that the noun before ``in`` means, if it is one."""
    if index < _INSIDE or phrases[index - 1].text not in ("in", "wearing"):
        return None
    noun = phrases[index - _INSIDE].noun
    people = resolve_mention(state, noun.mention) if noun and noun.mention else []
    return people[0] if len(people) == 1 else None


def _words_after(words: Sequence[Word], index: int) -> list[Word]:
    """Return the words after a verb, up to a full stop or the next verb."""
    rest: list[Word] = []
    for word in words[index + 1 :]:
        acts = word.verb is not None and word.verb.kind != "pp"
        if word.text in _STOPS or acts or (word.mention is not None and word.mention.kind in ("name", "group")):
            break
        rest.append(word)
    return rest


def _parts(words: Sequence[Word]) -> list[str]:
    """Return the parts of a description between commas and ``and``."""
    text = " ".join(word.text for word in words if not word.inserted and word.text not in _STOPS)
    return [part.strip() for part in re.split(r" , |,| and | with |^with ", text) if part.strip()]


def _add_appearance(state: ReaderState, person: Person, words: Sequence[Word]) -> None:
    """Add the parts of a description that concern appearance."""
    for part in _parts(words):
        low = part.lower().split()
        if _UNSAID & set(low) or (low[0] in lexicon.PREPOSITIONS and low[0] not in ("in", "with")):
            continue
        worn = any(_is_worn(word) for word in low)
        plain = re.sub(r"^(?:an?|the|very|quite|rather|so|now|still|his|her) ", "", part.lower())
        if worn and low[0] in ("in", "wearing"):
            _add_outfit(state, person, part)
        elif age_phrase(plain) or (not worn and (_LOOKS | _HAIRY | _FEATURES) & set(low)):
            _describe_once(state, person, plain)


def _describe_once(state: ReaderState, person: Person, part: str) -> None:
    """Add a description once: a known age stays, hair keeps only a few words."""
    if (age_phrase(part) and person.age) or part in person.hair or len(person.hair) >= _MOST:
        return
    kind, role = person.kind, person.role
    read_description(state.roster, person, part)
    person.kind, person.role = kind, role


def _describe_part(state: ReaderState, clause: Clause, words: Sequence[Word]) -> None:
    """Add the look of hair or clothes to their owner: ``His hair is grey``, ``Her coat is torn``."""
    noun = clause.subject[0]
    owner = state.person(noun.owner or "") if noun.kind == "thing" else None
    said = [
        word for part in _parts(words)[:1] for word in part.split() if word.lower() not in ("a", "the", "all", "so")
    ]
    if owner is None or not said or len(said) > 2:
        return
    phrase = f"{' '.join(said)} {noun.head}"
    if noun.head in _HAIRY or noun.head in _FEATURES:
        _describe_once(state, owner, phrase)
    elif _is_worn(noun.head):
        _add_outfit(state, owner, phrase)


def _dress(state: ReaderState, person: Person, words: Sequence[Word]) -> None:
    """Add what a person wears: ``wears a red dress and boots``, ``is dressed in black``."""
    pieces = [part for part in _parts(words) if any(_is_worn(word) for word in part.lower().split())]
    for piece in pieces:
        _add_outfit(state, person, piece)


def _add_outfit(state: ReaderState, person: Person, piece: str) -> None:
    """Add clothes from the first scene that describes any; later changes of clothes are deeds."""
    scene = state.scene_dressed.setdefault(person.id, state.unit.scene)
    plain = re.sub(r"^(?:in |wearing |an? |the |his |her |their )+", "", piece.strip(), flags=re.IGNORECASE)
    if scene == state.unit.scene and plain and plain not in person.outfit:
        person.outfit = (*person.outfit, plain)


def _is_worn(word: str) -> bool:
    """Whether a word names a garment."""
    return word in lexicon.WORN or singular(word) in lexicon.WORN
