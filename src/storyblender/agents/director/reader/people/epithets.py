"""Who ``the visitor``, ``his host``, ``the other`` or ``the detective`` is: somebody who is there already."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.words import Mention
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reading import Person
from storyblender.memory.vocabulary import Gender


def is_epithet(noun: str) -> bool:
    """Whether a noun rather means somebody known than somebody new when it is definite."""
    return noun in lexicon.ARRIVALS | lexicon.HOSTS | lexicon.COMPANY | lexicon.CALLINGS


def meant_by_epithet(stage: Stage, mention: Mention) -> list[Person]:
    """Decide who of those on stage an epithet means.

    The visitor came last, the host was there first, the companion is not whoever acted last, the latter was named
    last. Who was called so before and is still there is called so again.
    """
    told = {person.id: person for person in stage.spoken_of()}
    here = [told[id] for id in stage.scene.on if id in told and told[id].kind == "human" and told[id].count == 1]
    gender = lexicon.gender_of_word(mention.head)
    here = [person for person in here if gender in (person.gender, "unknown") or person.gender == "unknown"]
    called = stage.discourse.epithets.get(mention.head)
    if called in here and "new" not in mention.adjectives:
        return [called]
    by_recency = sorted(here, key=lambda person: -stage.discourse.last_named.get(person.id, 0))
    if mention.head in lexicon.ARRIVALS:
        found = here[::-1]
    elif mention.head in lexicon.HOSTS:
        found = here
    elif mention.head in ("latter", "former"):
        return by_recency[:1] if mention.head == "latter" else by_recency[1:2]
    elif mention.head in lexicon.COMPANY:
        others = [person for person in by_recency if person not in stage.discourse.subjects]
        newest = [stage.discourse.epithets.get(noun) for noun in sorted(lexicon.ARRIVALS)]
        old_friends = [person for person in others if person not in newest]
        return (others if mention.head == "other" else old_friends or others)[:1]
    else:
        found = by_recency or nearest_named(stage, mention.start, gender)
    if found:
        stage.discourse.epithets[mention.head] = found[0]
    return found[:1]


def listeners(stage: Stage) -> list[Person]:
    """``His three listeners``: everybody there but who spoke last."""
    return [person for person in stage.on_stage() if person not in stage.discourse.subjects]


def nearest_named(stage: Stage, at: int, gender: Gender) -> list[Person]:
    """A story may begin with ``the old lady`` and name her later: the cast by how near their first mention is.

    Args:
        stage: The state before the mention.
        at: Offset of the mention.
        gender: What the noun tells; unknown fits everybody.
    """
    if stage.reading.screenplay.format != "prose":
        return []
    cast = [person for person in stage.roster.people if person.kind == "human" and person.count == 1]
    cast = [person for person in cast if gender == "unknown" or person.gender == gender]
    return sorted(cast, key=lambda person: (person.id not in stage.scene.named, abs(person.first - at)))
