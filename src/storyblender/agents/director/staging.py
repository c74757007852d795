"""Who is where in which posture with what in hand, at the start of every shot."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from itertools import takewhile

from storyblender.agents.director.draft import ShotDraft
from storyblender.agents.director.motion_families import GETTING, HOLDING, PARTING, POSES, TRAVEL
from storyblender.agents.director.reading import Deed, Unit
from storyblender.memory.shot_context import BodyState
from storyblender.memory.vocabulary import Posture

_KEYBOARDS = ("piano", "organ", "harpsichord", "keyboard")
"""Instruments that are played sitting before them."""


@dataclass
class _Body:
    posture: Posture = "stand"
    support: str | None = None
    held: list[str] = field(default_factory=list)
    looking_at: str | None = None


class Staging:
    """The bodies of one scene, carried from shot to shot.

    Args:
        units: The scene's units.
        assets: Ids on the asset sheet; nothing else can support, be held or be looked at.
        seated: The place is one where everybody sits unless they come in: a car.
        on_foot: Trades that do not sit there.
    """

    def __init__(
        self, units: Sequence[Unit], assets: Collection[str], *, seated: bool = False, on_foot: Sequence[str] = ()
    ) -> None:
        self.assets = assets
        self.seated = seated
        self.on_foot = {*on_foot}
        self.bodies: dict[str, _Body] = {}
        self._last: dict[str, tuple[tuple[object, ...], BodyState]] = {}
        """The last state of each person: most do not change from one shot to the next."""
        self.first: dict[str, Unit] = {}
        for unit in units:
            for person in unit.on_stage:
                self.first.setdefault(person, unit)
        self.brought = self._brought(units)
        self.opening = {person: unit for person, unit in self.first.items() if not _comes_in(person, unit)}

    @staticmethod
    def _brought(units: Sequence[Unit]) -> dict[str, dict[str, int]]:
        """What people have with them, though nobody saw them take it: person -> thing -> where they part with it."""
        brought: dict[str, dict[str, int]] = {}
        seen: set[str] = set()
        for unit in units:
            for deed in unit.deeds:
                if deed.prop and deed.prop not in seen and deed.motion in PARTING | HOLDING:
                    brought.setdefault(deed.actor, {})[deed.prop] = unit.start
                seen.update(filter(None, (deed.prop, deed.target)))
            seen.update(unit.things if not unit.people else ())
        return brought

    def already(self, deed: Deed, unit: Unit) -> bool:
        """Whether a deed tells how somebody is found, e.g. ``Nora sits in a booth`` as a scene opens."""
        if self.opening.get(deed.actor) is not unit:
            return False
        mine = [other for other in unit.deeds if other.actor == deed.actor]
        posed = list(takewhile(lambda other: other.motion in POSES, mine))
        return deed in posed

    def states(self, draft: ShotDraft) -> tuple[BodyState, ...]:
        """Return the bodies as the shot begins, then play its units."""
        for person in draft.on_stage:
            if person not in self.bodies:
                self.bodies[person] = self._found(person)
        if draft.before:
            self._hold_what_is_shown(draft.before, draft.focus)
        start = draft.beats[0].unit.start if draft.beats else -1
        states = tuple(self._state(person, start) for person in draft.on_stage)
        for beat in draft.beats:
            self._play(beat.unit)
        return states

    def _hold_what_is_shown(self, unit: Unit, shown: Sequence[str]) -> None:
        """``CLOSE ON the coin in his palm``: it is there before the unit of these words begins."""
        taken = {(deed.actor, deed.prop) for deed in unit.deeds if deed.motion in GETTING}
        for person, things in unit.held.items():
            body = self._body(person)
            body.held += [t for t in things if t in shown and t not in body.held and (person, t) not in taken]

    def _found(self, person: str) -> _Body:
        """How a person is seen for the first time in the scene."""
        unit = self.first.get(person)
        sits = self.seated and person in self.opening and not self.on_foot & {*person.split("_")}
        usual: Posture = "sit" if sits else "stand"
        if unit is None:
            return _Body()
        mine = [deed for deed in unit.deeds if deed.actor == person]
        taken = {deed.prop for deed in mine if deed.motion in GETTING}
        given = {deed.prop for deed in unit.deeds if deed.motion == "give" and deed.target == person}
        held = [thing for thing in unit.held.get(person, []) if thing not in taken | given]
        body = _Body(posture=usual, held=held)
        if any(self.already(deed, unit) for deed in mine) or (not mine and person in unit.posture):
            body.posture, body.support = unit.posture.get(person, (usual, None))
        instrument = _keyboard(mine)
        if instrument is not None and body.posture in ("stand", "sit"):
            body.posture, body.support = "sit", instrument
        return body

    def _play(self, unit: Unit) -> None:
        for person, (posture, support) in unit.posture.items():
            body = self._body(person)
            kept = body.support if posture == body.posture else None
            body.posture, body.support = posture, support or kept
        for person in unit.on_stage:
            self._body(person).held = list(unit.held.get(person, []))
        for deed in unit.deeds:
            body = self._body(deed.actor)
            if deed.motion in ("look", "read", "aim", "talk", "whisper", "shout", "listen"):
                body.looking_at = deed.target or deed.prop
            elif deed.motion in TRAVEL or deed.motion in ("turn", "look_around"):
                body.looking_at = None
        if unit.kind == "dialogue" and unit.speaker:
            for person in unit.on_stage:
                other = unit.to if person == unit.speaker else unit.speaker
                self.bodies[person].looking_at = other if other != person else None

    def _state(self, person: str, start: int) -> BodyState:
        body = self.bodies[person]
        brought = [thing for thing, parted in self.brought.get(person, {}).items() if start <= parted]
        held = tuple(thing for thing in dict.fromkeys([*body.held, *brought]) if thing in self.assets)
        told = (body.posture, body.support, held, body.looking_at)
        last = self._last.get(person)
        if last is None or last[0] != told:
            state = BodyState(
                asset_id=person,
                posture=body.posture,
                support_id=self._known(body.support),
                held=held,
                looking_at=self._known(body.looking_at),
            )
            last = self._last[person] = (told, state)
        return last[1]

    def _body(self, person: str) -> _Body:
        if person not in self.bodies:
            self.bodies[person] = _Body()
        return self.bodies[person]

    def _known(self, id_: str | None) -> str | None:
        return id_ if id_ in self.assets else None


def _keyboard(deeds: Sequence[Deed]) -> str | None:
    """Return the keyboard that somebody plays, or sits down at, in these deeds."""
    at_it = (deed for deed in deeds if deed.motion in ("play_music", "sit"))
    played = (thing for deed in at_it for thing in (deed.target, deed.prop) if thing)
    return next((thing for thing in played if thing.endswith(_KEYBOARDS)), None)


def _comes_in(person: str, unit: Unit) -> bool:
    """Whether a person's first unit brings them on stage, instead of finding them there."""
    return person in unit.entering and any(deed.actor == person and deed.motion in TRAVEL for deed in unit.deeds)
