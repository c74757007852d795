"""Why a reading is as it is: each of its facts with the rule that decided it and the words it stands on."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from typing import NamedTuple

from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Deed, Person, Reading, Unit
from storyblender.agents.director.rules import Decision, Fact, Ledger


class Reason(NamedTuple):
    """A decision in the unit it belongs to."""

    unit: int
    """Counted from 1; what stands between two units belongs to the next."""
    rule: str
    kind: str
    what: str
    start: int
    end: int
    words: str
    """Of the script, from start to end."""


_NOTICES = ("held", "handled", "met", "with", "shown", "related", "placed", "seen")
"""How a thing comes up, what counts most first."""


def page_facts(reading: Reading) -> Iterator[Fact]:
    """Yield what is known of places and people before the sentences are read."""
    for scene in reading.scenes:
        end = scene.start + max(len(scene.heading), 1)
        what = f"{scene.id}: {scene.place or 'nowhere told'}, {scene.place_kind or 'no kind'}, {scene.scene_type}"
        yield Fact("place", f"{what}, {scene.time}", words=(scene.start, end))
    for person in reading.people:
        for look in (person.age, *person.build, *person.hair, *person.outfit, *person.face):
            if look:
                yield Fact(
                    "look", f"{person.id}: {look}", words=_words_about_look(person, look, reading.screenplay.text)
                )
        if person.gender != "unknown":
            yield Fact("gender", f"{person.id}: {person.gender}", words=_words_about_look(person, person.name, ""))


def stage_facts(state: ReaderState) -> Iterator[Fact]:
    """Yield every fact of the reader's state at one point of the script."""
    reading = state.reading
    yield from page_facts(reading)
    for scene, relation in reading.relations:
        ends = (relation.asset_id, relation.kind, relation.anchor_asset_id, relation.second_anchor_asset_id)
        yield Fact("relation", " ".join(filter(None, ends)), scene)
    for thing, notices in state.inventory.notices():
        for how in notices:
            yield Fact("thing", f"{thing} {how}")
    if reading.units:
        yield from _unit_facts(reading.units[-1], len(reading.units))
    for person, (posture, support) in state.scene.posture.items():
        yield Fact("posture", " ".join(filter(None, (person, posture, support))))
    for person, things in state.scene.held.items():
        for thing in things:
            yield Fact("held", f"{person} {thing}")


def _unit_facts(unit: Unit, number: int) -> Iterator[Fact]:
    """Yield the facts of a unit."""
    for deed in unit.deeds:
        yield Fact("deed", _deed_told(deed), number)
    for person in unit.entering:
        yield Fact("enters", person, number)
    for person in unit.leaving:
        yield Fact("leaves", person, number)
    if unit.speaker:
        yield Fact("speaker", f"{unit.speaker} to {unit.to}" if unit.to else unit.speaker, number)
    for change in unit.changes:
        yield Fact("change", f"{change.subject} {change.state}", number)
    for kind, said in (("face", unit.expressions), ("gaze", unit.gaze), ("activity", unit.activities)):
        for person, what in said.items():
            yield Fact(kind, f"{person} {what}", number)
    for person, grips in unit.grips.items():
        for thing, grip in grips.items():
            yield Fact("grip", f"{person} {thing} {grip}", number)
    for each, spot in unit.spots.items():
        yield Fact("spot", " ".join(filter(None, (each, spot.relation, spot.anchor_id))), number)
    for tether in unit.tethers:
        yield Fact("tether", f"{tether.holder} {tether.held} {tether.kind}", number)
    for sound in unit.sounds:
        yield Fact("sound", sound, number)


def _deed_told(deed: Deed) -> str:
    """Return a deed in words: actor, motion, target and prop."""
    return " ".join(filter(None, (deed.actor, deed.motion, deed.target, deed.prop if deed.prop != deed.target else "")))


def reasons_of(reading: Reading, ledger: Ledger) -> list[Reason]:
    """Return the decisions that the finished reading stands on, unit by unit.

    Args:
        reading: The finished reading.
        ledger: Kept while it was made.
    """
    people, things = {person.id for person in reading.people}, {thing.id for thing in reading.things}
    told = {_plain(fact) for number, unit in enumerate(reading.units) for fact in _unit_facts(unit, number)}
    kinds = {kind for kind, _ in told}
    best: dict[str, tuple[int, Decision]] = {}
    kept: list[Decision] = []
    for decision in ledger.decisions:
        words = decision.what.replace(":", "").split()
        if decision.kind == "thing":
            rank = _NOTICES.index(words[1])
            if words[0] in things and rank < best.get(words[0], (len(_NOTICES), None))[0]:
                best[words[0]] = rank, decision._replace(what=words[0])
        elif decision.kind in kinds:
            kept += [decision] if _plain(decision) in told else []
        elif decision.kind not in ("person", "look", "gender") or words[0] in people:
            kept.append(decision)
    kept += [decision for _, decision in best.values()]
    starts = [unit.start for unit in reading.units]
    text = reading.screenplay.text
    return [
        Reason(_unit_at(each.start, reading, starts), *each, " ".join(text[each.start : each.end].split()))
        for each in sorted(kept, key=lambda each: (each.start, each.kind))
    ]


def _plain(said: Fact | Decision) -> tuple[str, str]:
    """Return a fact for comparison: of a deed only actor and motion, as its target may be dropped later."""
    return said.kind, " ".join(said.what.split()[:2]) if said.kind == "deed" else said.what


def _unit_at(at: int, reading: Reading, starts: list[int]) -> int:
    """Return the number of the unit that an offset is in, or of the next, counted from 1."""
    number = bisect_right(starts, at)
    within = number > 0 and at < reading.units[number - 1].end
    return number if within else min(number + 1, len(starts))


def _words_about_look(person: Person, look: str, text: str) -> tuple[int, int]:
    """Return start and end of the words that tell a look, after the first mention of its person."""
    at = text.lower().find(look.lower(), person.first)
    return (at, at + len(look)) if at >= 0 else (person.first, person.first + len(person.name))
