"""Where everybody is, in which posture and with what in hand, at the start and end of every shot."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from itertools import takewhile
from typing import get_args

from storyblender.agents.director.draft import ShotDraft
from storyblender.agents.director.feelings import expression_of
from storyblender.agents.director.motion_families import GETTING, HOLDING, PARTING, PORTABLE, POSES, POSING, TRAVEL
from storyblender.agents.director.reading import Deed, Unit
from storyblender.catalog.motions import MOTION_KEYS
from storyblender.memory.scene_context import Spot
from storyblender.memory.shot_context import BodyState
from storyblender.memory.vocabulary import Expression, GazeDirection, Grip, Posture

_KEYBOARDS = ("piano", "organ", "harpsichord", "keyboard")
"""Instruments that are played sitting before them."""


@dataclass
class _Body:
    """State of one person or thing that moves."""

    posture: Posture = "stand"
    support: str | None = None
    held: list[str] = field(default_factory=list)
    looking_at: str | None = None
    gaze: GazeDirection | None = None
    expression: Expression = "neutral"
    activity: str = ""
    grips: dict[str, Grip] = field(default_factory=dict)
    spot: Spot | None = None


class Staging:
    """The body states of one scene, carried from shot to shot.

    Args:
        units: The scene's units.
        assets: Ids on the asset sheet; only these can support, be held or be looked at.
        fixtures: Ids of parts of the set: people can be beside them.
        seated: Everyone in the place sits unless they walk in: a car.
        on_foot: Trades that stand in such a place.
    """

    def __init__(
        self,
        units: Sequence[Unit],
        assets: Collection[str],
        fixtures: Collection[str] = (),
        *,
        seated: bool = False,
        on_foot: Sequence[str] = (),
    ) -> None:
        self.assets = assets
        self.places = {*assets, *fixtures}
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
        """Return what people have from the start: person -> thing -> offset where they part with it.

        A thing that was absent before is not among it, nor are those of people whose hands every unit tells.
        """
        brought: dict[str, dict[str, int]] = {}
        seen: set[str] = set()
        unsaid = {person for unit in units for person in unit.on_stage if person not in unit.held}
        for unit in units:
            seen.update(unit.absent)
            for deed in unit.deeds:
                has = deed.motion in PARTING | HOLDING and deed.actor in unsaid
                if deed.prop and deed.prop not in seen and has:
                    brought.setdefault(deed.actor, {})[deed.prop] = unit.start
                seen.update(filter(None, (deed.prop, deed.target)))
            seen.update(unit.things if not unit.people else ())
        return brought

    def already(self, deed: Deed, unit: Unit) -> bool:
        """Whether a deed only tells how a person is found, e.g. ``Nora sits in a booth`` as a scene opens.

        Args:
            deed: The deed.
            unit: Its unit.
        """
        if self.opening.get(deed.actor) is not unit:
            return False
        mine = [other for other in unit.deeds if other.actor == deed.actor]
        posed = list(takewhile(lambda other: other.motion in POSES, mine))
        return deed in posed

    def states(self, draft: ShotDraft) -> tuple[tuple[BodyState, ...], tuple[BodyState, ...]]:
        """Return the body states at the start of the shot, and those that its text has changed at its end.

        A posture, an expression or a held thing that no deed of the shot brings about holds from its first frame.
        """
        for person in draft.on_stage:
            if person not in self.bodies:
                self.bodies[person] = self._found(person)
        if draft.before:
            self._hold_what_is_shown(draft.before, draft.focus)
        units = [beat.unit for beat in draft.beats]
        self._set_scene(units)
        start = units[0].start if units else -1
        states = tuple(self._state(person, start) for person in draft.on_stage)
        for unit in units:
            self._play(unit)
        ends = (self._state(person, start) for person in draft.on_stage)
        changed = tuple(end for end, state in zip(ends, states, strict=True) if end != state)
        return states, changed

    def _set_scene(self, units: Sequence[Unit]) -> None:
        """Put people into the postures and places that units state without a deed that leads there."""
        deeds = [deed for unit in units for deed in unit.deeds]
        movers = {deed.actor for deed in deeds if deed.motion in TRAVEL}
        posing = movers | {deed.actor for deed in deeds if deed.motion in POSING}
        got = {(deed.actor, deed.prop) for deed in deeds if deed.motion in GETTING}
        got |= {(deed.target or "", deed.prop) for deed in deeds if deed.motion == "give"}
        used = {(deed.actor, deed.prop) for deed in deeds}
        for person in {person for unit in units for person in unit.held}:
            body = self._body(person)
            kept = {thing for unit in units for thing in unit.held.get(person, body.held)}
            body.held = [thing for thing in body.held if thing in kept or (person, thing) in used]
        for unit in units:
            self._set_faces(unit)
            drivers = {person for person in unit.posture if _drives(person, unit)}
            posing, movers = posing - drivers, movers - drivers
            for person in unit.posture.keys() - posing:
                self._pose(person, unit)
            for person in unit.spots.keys() - movers:
                self._body(person).spot = unit.spots[person]
            for person, things in unit.held.items():
                body = self._body(person)
                body.held += [t for t in things if t not in body.held and (person, t) not in got]

    def _set_faces(self, unit: Unit) -> None:
        """Apply the expressions, gaze, lasting activities and grips of a unit."""
        for person, words in unit.expressions.items():
            self._body(person).expression = expression_of(words)
        if unit.kind == "dialogue" and unit.speaker and unit.parenthetical and unit.speaker not in unit.expressions:
            told = expression_of(unit.parenthetical)
            if told != "neutral":
                self._body(unit.speaker).expression = told
        for person, where in unit.gaze.items():
            body = self._body(person)
            direction = next((each for each in get_args(GazeDirection) if each == where), None)
            body.gaze, body.looking_at = direction, None if direction else where
        for person, motion in unit.activities.items():
            self._body(person).activity = motion
        for person, grips in unit.grips.items():
            self._body(person).grips.update(grips)

    def known_spot(self, spot: Spot) -> Spot:
        """Return a spot with only those references that are on the asset sheet or parts of the set."""
        facing = spot.facing if spot.facing in {*self.places, "away", "camera"} else None
        anchor = spot.anchor_id if spot.anchor_id in self.places else None
        return spot.model_copy(update={"anchor_id": anchor, "facing": facing})

    def _hold_what_is_shown(self, unit: Unit, shown: Sequence[str]) -> None:
        """Put a thing into the hand before its unit: ``CLOSE ON the coin in his palm``."""
        taken = {(deed.actor, deed.prop) for deed in unit.deeds if deed.motion in GETTING}
        for person, things in unit.held.items():
            body = self._body(person)
            body.held += [t for t in things if t in shown and t not in body.held and (person, t) not in taken]

    def _found(self, person: str) -> _Body:
        """Return how a person is first seen in the scene."""
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
        drives = _drives(person, unit)
        if any(self.already(deed, unit) for deed in mine) or (not mine and person in unit.posture) or drives:
            body.posture, body.support = unit.posture.get(person, (usual, None))
        instrument = _keyboard(mine)
        if instrument is not None and body.posture in ("stand", "sit"):
            body.posture, body.support = "sit", instrument
        if drives or all(deed.motion not in TRAVEL for deed in mine):
            body.spot = unit.spots.get(person)
        return body

    def _pose(self, person: str, unit: Unit) -> None:
        """Set the posture that a unit states for a person."""
        posture, support = unit.posture[person]
        body = self._body(person)
        kept = body.support if posture == body.posture and posture != "stand" else None
        body.posture, body.support = posture, support or kept

    def _play(self, unit: Unit) -> None:
        """Apply a unit: postures, things in hand, gaze, spots."""
        for person in unit.posture:
            self._pose(person, unit)
        for person in unit.on_stage:
            body = self._body(person)
            body.held = list(unit.held.get(person, []))
            body.grips = {thing: grip for thing, grip in body.grips.items() if thing in body.held or grip == "worn"}
        for deed in unit.deeds:
            body = self._body(deed.actor)
            if deed.motion in TRAVEL:
                body.spot = None
                body.support = None if body.posture == "stand" else body.support
                body.activity = body.activity if body.activity in PORTABLE else ""
            if deed.motion in ("look", "read", "aim", "talk", "whisper", "shout", "listen"):
                body.looking_at = deed.target or deed.prop
            elif deed.motion in TRAVEL or deed.motion in ("turn", "look_around"):
                body.looking_at = None
        if unit.kind == "dialogue" and unit.speaker:
            for person in unit.on_stage:
                other = unit.to if person == unit.speaker else unit.speaker
                self.bodies[person].looking_at = other if other != person else None
        self._set_faces(unit)
        for person in unit.spots:
            self._body(person).spot = unit.spots[person]

    def _state(self, person: str, start: int) -> BodyState:
        """Return the body state of a person at a shot that starts at an offset."""
        body = self.bodies[person]
        brought = [thing for thing, parted in self.brought.get(person, {}).items() if start <= parted]
        held = tuple(thing for thing in dict.fromkeys([*body.held, *brought]) if thing in self.assets)
        grips = tuple(sorted(pair for pair in body.grips.items() if pair[0] in self.assets))
        spot = self.known_spot(body.spot) if body.spot else None
        told = (
            body.posture, body.support, held, body.looking_at, body.gaze, body.expression, body.activity, grips, spot,
        )  # fmt: skip
        last = self._last.get(person)
        if last is None or last[0] != told:
            state = BodyState(
                asset_id=person,
                posture=body.posture,
                support_id=self._known(body.support),
                held=held,
                looking_at=self._known(body.looking_at),
                gaze=body.gaze,
                expression=body.expression,
                activity=MOTION_KEYS.get(body.activity, ""),
                grips=grips,
                spot=spot,
            )
            last = self._last[person] = (told, state)
        return last[1]

    def _body(self, person: str) -> _Body:
        """Return the state of a person, new if not seen yet."""
        if person not in self.bodies:
            self.bodies[person] = _Body()
        return self.bodies[person]

    def _known(self, id_: str | None) -> str | None:
        """Return an id that is on the asset sheet, else None."""
        return id_ if id_ in self.assets else None


def _keyboard(deeds: Sequence[Deed]) -> str | None:
    """Return the keyboard that a person plays, or sits down at, in these deeds; else None."""
    at_it = (deed for deed in deeds if deed.motion in ("play_music", "sit"))
    played = (thing for deed in at_it for thing in (deed.target, deed.prop) if thing)
    return next((thing for thing in played if thing.endswith(_KEYBOARDS)), None)


def _drives(person: str, unit: Unit) -> bool:
    """Whether a person drives in a unit and sits for it: they are at the wheel from its first frame."""
    seated = unit.posture.get(person, ("", None))[0] == "sit"
    return seated and any(deed.actor == person and deed.motion == "drive" for deed in unit.deeds)


def _comes_in(person: str, unit: Unit) -> bool:
    """Whether a person's first unit brings them on stage."""
    return person in unit.entering and any(deed.actor == person and deed.motion in TRAVEL for deed in unit.deeds)
