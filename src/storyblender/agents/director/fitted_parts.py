"""Parts that are fitted into a vehicle: they are where it is, and never stand about, lie or are held on their own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from storyblender.agents.director.fixtures import head_of
from storyblender.agents.director.reading import Deed, Reading, Thing, Unit
from storyblender.catalog.parts import is_shell, is_sure_part, part_named, side_named
from storyblender.catalog.props.prop_families import family_of
from storyblender.catalog.props.prop_names import kind_named
from storyblender.memory.scene_context import Spot

_MOTOR = {*family_of("car"), "truck", "bus", "fire_engine", "tractor"}
_INSIDE = frozenset({"on", "in", "inside"})
_CAR = "car"
"""Key of the set kit of the inside of a car."""


@dataclass(frozen=True)
class FittedParts:
    """The parts of vehicles in a reading.

    Attributes:
        whole: Part -> its vehicle; empty where it is the car of the set.
        shell: Doors, windows and the like -> the vehicle: to a person who acts on them they are it.
        names: Id -> name of both.
        vehicles: Ids of the motor vehicles.
    """

    whole: Mapping[str, str]
    shell: Mapping[str, str]
    names: Mapping[str, str]
    vehicles: frozenset[str] = frozenset()

    @classmethod
    def of(cls, reading: Reading) -> FittedParts:
        """Return the parts of vehicles in a reading."""
        things = {thing.id: thing for thing in reading.things}
        whole: dict[str, str] = {}
        shell: dict[str, str] = {}
        for thing in reading.things:
            if not (part_named(thing.name) or is_shell(thing.name)):
                continue
            found = _vehicle_of(thing, things, reading)
            if found is not None and part_named(thing.name):
                whole[thing.id] = found
            elif found:
                shell[thing.id] = found
        names = {id_: things[id_].name for id_ in (*whole, *shell)}
        return cls(whole, shell, names, frozenset(each.id for each in reading.things if _is_motor_vehicle(each)))

    def rewritten(self, reading: Reading) -> Reading:
        """Return the reading with people at, in and on the vehicles where it has them at, in and on their parts."""
        if not (self.names or self.vehicles):
            return reading
        own = {*self.whole, *self.shell}
        relations = [
            (index, each.model_copy(update={"anchor_asset_id": self._thing(each.anchor_asset_id) or each.asset_id}))
            for index, each in reading.relations
            if each.asset_id not in own
        ]
        units = [self._unit(unit) for unit in reading.units]
        kept = [(index, each) for index, each in relations if each.anchor_asset_id != each.asset_id]
        things = [thing for thing in reading.things if thing.id not in self.shell]
        return replace(reading, units=units, relations=kept, things=things)

    def _thing(self, id_: str | None) -> str | None:
        """Return the vehicle of a part, and any other id as it is."""
        return self.whole.get(id_ or "", self.shell.get(id_ or "", id_)) or None

    def _shown(self, id_: str | None) -> str | None:
        """Return the vehicle of a door or a window, and any other id as it is."""
        return self.shell.get(id_ or "", id_)

    def _unit(self, unit: Unit) -> Unit:
        seats = {id_ for id_ in self.whole if part_named(self.names[id_]).startswith("seat_")}
        posture = {
            who: (pose, self._thing(support) if support in {*seats, *self.shell} else support)
            for who, (pose, support) in unit.posture.items()
        }
        loose = {who: [each for each in things if each not in self.names] for who, things in unit.held.items()}
        grips = {
            who: {id_: grip for id_, grip in told.items() if id_ not in self.names} for who, told in unit.grips.items()
        }
        spots = {who: self._spot(spot) for who, spot in unit.spots.items() if who not in self.names}
        for deed in unit.deeds:  # who drives sits at the wheel
            vehicle = next((each for each in (deed.target, deed.prop) if each in self.vehicles), None)
            if deed.motion == "drive" and vehicle is not None and posture.get(deed.actor, ("sit", None))[0] == "sit":
                posture[deed.actor] = ("sit", vehicle)
                spots.setdefault(deed.actor, Spot(relation="inside", anchor_id=vehicle, side="driver"))
        return replace(
            unit,
            deeds=[self._deed(deed, seats) for deed in unit.deeds],
            posture=posture,
            held=loose,
            grips=grips,
            gaze={who: self._shown(each) or each for who, each in unit.gaze.items()},
            spots=spots,
            things=list(dict.fromkeys(self._shown(each) or each for each in unit.things)),
            absent=[each for each in unit.absent if each not in self.names],
            changes=[
                replace(change, subject=self._shown(change.subject) or change.subject)
                for change in unit.changes
                if change.subject not in self.whole
            ],
        )

    def _deed(self, deed: Deed, seats: set[str]) -> Deed:
        target, prop = self._shown(deed.target), deed.prop
        if prop in self.names:
            target, prop = target or self._shown(prop), None
        if target in seats and deed.motion == "sit":
            target = self._thing(target)
        return replace(deed, target=target, prop=prop)

    def _spot(self, spot: Spot) -> Spot:
        facing = self._shown(spot.facing)
        if spot.anchor_id is None or spot.anchor_id not in self.names:
            return spot.model_copy(update={"facing": facing})
        name, vehicle = self.names[spot.anchor_id], self._thing(spot.anchor_id)
        seated = spot.relation in _INSIDE and part_named(name).startswith("seat_")
        relation = "inside" if seated else spot.relation if spot.relation == "next_to" else "at"
        told = {"relation": relation, "anchor_id": vehicle, "side": spot.side or side_named(name), "facing": facing}
        return spot.model_copy(update=told)


def _vehicle_of(thing: Thing, things: Mapping[str, Thing], reading: Reading) -> str | None:
    """Return the vehicle that a thing is a part of; empty for the car of the set; None if it is no vehicle's part."""
    at, seen = thing, {thing.id}
    while at.part_of is not None and at.part_of in things and at.part_of not in seen:
        at = things[at.part_of]
        seen.add(at.id)
        if _is_motor_vehicle(at):
            return at.id
    if at is not thing and not part_named(at.name):
        return None
    shown = {unit.scene for unit in reading.units if seen & _named(unit)}
    inside = {index for index in shown if _is_in_car(reading, index)}
    if not inside and not is_sure_part(thing.name):
        return None
    vehicles = [each for each in reading.things if _is_motor_vehicle(each)]
    places = {word for index in shown for word in reading.scenes[index].place.lower().split()}
    of_place = [each for each in vehicles if head_of(each.name) in places]
    there = [each for each in vehicles if any(each.id in _named(u) for u in reading.units if u.scene in shown)]
    found = next(iter([*of_place, *(there if len(there) == 1 else ())]), None)
    return found.id if found is not None else "" if inside else None


def _is_in_car(reading: Reading, index: int) -> bool:
    """Return whether a scene is inside a car."""
    scene = reading.scenes[index]
    return _CAR in (scene.kit, scene.place_kind)


def _is_motor_vehicle(thing: Thing) -> bool:
    kind = kind_named(thing.name)
    return kind in _MOTOR or (thing.kind == "vehicle" and not kind)


def _named(unit: Unit) -> set[str]:
    """Return the ids of everything that a unit names."""
    spots = [id_ for spot in unit.spots.values() for id_ in (spot.anchor_id, spot.facing) if id_]
    deeds = [id_ for deed in unit.deeds for id_ in (deed.target, deed.prop) if id_]
    supports = [support for _, support in unit.posture.values() if support]
    return {*unit.things, *deeds, *spots, *supports, *unit.gaze.values(), *(change.subject for change in unit.changes)}
