"""How the things of a sentence come up: named, used, held, looked at; what only is said to be like something is not."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clause import Clause
from storyblender.agents.director.reader.language.morphology import singular
from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.stage import Stage

_OBJECTLIKE = frozenset({"prop", "worn", "unknown", "set_piece"})
_TROPHIES = lexicon.words("trophies")
"""Parts of animals that may be things: the paw, where the story has no animal."""
_RECENT = 7
"""Things ``it`` can mean."""
_WITH = frozenset({"with", "off"})
_USING = frozenset({"on", "with", "into", "at", "through"})


def notice_nouns(stage: Stage, phrases: list[Phrase]) -> None:
    """Every noun that names a thing is seen; in capitals it is shown.

    Args:
        stage: The state before the sentence; the things of its sentence and unit are noted.
        phrases: The phrases of the sentence.
    """
    for index, phrase in enumerate(phrases):
        noun = phrase.noun
        if noun is None or noun.kind != "thing" or lexicon.noun_class(noun.key) == "abstract":
            continue
        word = stage.sentence.words[noun.index]
        if stage.place.weather == "clear" and noun.head in lexicon.WEATHER_WORDS:
            _notice_weather(stage, noun.head, phrases[index - 1] if index else None)
        thing = stage.inventory.id_of(noun.key, word.start, noun.determiner == "the")
        if noun.head in _TROPHIES and noun.determiner and not any(p.kind == "animal" for p in stage.roster.people):
            stage.inventory.detach(thing)
        stage.sentence.things.append((noun.index, thing))
        loud = word.text.isupper() and len(word.text) > 2 and singular(word.low) in lexicon.PROPS
        stage.inventory.seen(thing, "shown" if loud else "seen")
        stage.discourse.recent_things = [thing, *stage.discourse.recent_things[:_RECENT]]
        if stage.inventory.class_of(thing) in _OBJECTLIKE and thing not in stage.unit.things:
            stage.unit.things.append(thing)


def _notice_weather(stage: Stage, word: str, left: Phrase | None) -> None:
    """Rain hammers the windows; somebody walks through the fog. ``like thunder`` is no weather."""
    if left is None or left.kind in ("mark", "link") or left.text in ("in", "through", "into", "under", "of"):
        stage.place.weather = lexicon.WEATHER_WORDS[word]


def notice_things(stage: Stage, clause: Clause, roles: Roles, motion: str | None) -> None:
    """Note how the things of a clause come up.

    Args:
        stage: The state before the clause.
        clause: A clause that happens.
        roles: Who and what it is about.
        motion: What its people do; None where they do nothing to see.
    """
    inventory = stage.inventory
    if motion in lexicon.HANDLING and roles.subjects:
        how = "held" if motion in lexicon.GRIPPING else "handled"
        for thing in roles.things:
            inventory.seen(thing, how, _is_determined(clause, inventory.head(thing)))
    for place in roles.places:
        used = motion in lexicon.HANDLING and not roles.things and place.preposition in _USING
        for thing in place.things:
            if roles.subjects and used and inventory.class_of(thing) == "prop":
                inventory.seen(thing, "handled")
            elif roles.subjects and place.preposition in _WITH:
                inventory.seen(thing, "with")
    for thing in roles.subject_things:
        if inventory.class_of(thing) == "prop":
            inventory.seen(thing, "related")


def _is_determined(clause: Clause, head: str) -> bool:
    """Whether the object with this head is a thing for sure: it has a determiner or an owner."""
    noun: NounPhrase | None = next((n for n in clause.object if n.kind == "thing" and n.head == head), None)
    return noun is None or bool(noun.determiner) or noun.possessor is not None
