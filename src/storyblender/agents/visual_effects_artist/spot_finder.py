"""Finds the floor place of a spot in the script: at the sink, behind the bar, in the doorway, beside a person."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from storyblender.agents.visual_effects_artist.floor import BODY, Floor
from storyblender.agents.visual_effects_artist.person import SEATED, StagedPerson
from storyblender.agents.visual_effects_artist.placed_objects import PlacedObject, SeatPlace
from storyblender.agents.visual_effects_artist.seats import Seats
from storyblender.catalog.fixtures import fixtures_called
from storyblender.geometry.boxes import Box, yaw_along
from storyblender.geometry.paths import clearance
from storyblender.geometry.stations import Sort, Station, stations, turn_towards_audience
from storyblender.memory.scene_context import Spot
from storyblender.memory.shot_context import BodyState
from storyblender.memory.vocabulary import Posture

WITHIN = frozenset({"in", "inside", "on", "above", "under", "over"})
"""Relations in which a person is at the thing's own place, so that no other place has to be free."""
_TIGHT, _CROWDED, _FAR = 8.0, 5.0, 0.1
"""Penalties in metres: per metre less room than a body needs, per metre closer to others, per metre to go."""
_APART = 0.6
"""Metres between two people at one place."""
_TOO_NEAR = 0.42
"""Metres around a person within which no other person is placed."""
_DOOR_SIDE = 0.9
"""Least metres from a vehicle's centre line at which a door counts as one of that side."""
_LIE = ("lie", "asleep")
_SAME_THING_DISTANCE = 1.8
"""Metres to a seated person within which a standing one is taken to be at the same thing."""
_IN_THE_AIR: tuple[Posture, ...] = ("hang", "float", "upside_down")
_MAX_CLIMB, _FOOTING = 1.3, 0.3
"""Metres: people do not stand on higher or narrower things, unless the script gives a height."""
_ON_BACK = (0.22, 0.62)
"""Metres behind and above the carrier's place for a rider on their back, times the carrier's stature over 1.7."""


class SpotFinder:
    """Finds the floor places of the script's spots, in one scene.

    Args:
        floor: Positions of things on the floor.
        people: The current state of everyone in the scene, by asset id.
        seats: Chooses people's seats.
    """

    def __init__(self, floor: Floor, people: Mapping[str, StagedPerson], seats: Seats) -> None:
        self.floor, self.people, self.seats = floor, people, seats

    def settle(self, person: StagedPerson, state: BodyState) -> bool:
        """Cut a person to the spot of a state, unless they have been brought there before.

        Args:
            person: The person; changed in place.
            state: Their state at the start of the shot.

        Returns:
            Whether they have been moved.
        """
        spot = state.spot
        if state.posture == "ride" and self._mount(person, state):
            person.spot = spot
            return True
        if spot is None or spot == person.spot:
            person.spot = spot
            return False
        person.spot = spot
        seat = self.seat_of_spot(person, state)
        if seat is not None:
            person.place, person.yaw, person.posture, person.z = seat.edge, seat.yaw, "sit", 0.0
            person.support, person.anchor = seat.node_id, seat.anchor
            return True
        if state.posture in SEATED and person.support is not None:
            return False
        if self._is_out_of_reach(person, spot):
            return False  # the layout has them as near as people get
        there = self._place_before_seat(person, state) or self.find_station(person, spot, state.posture)
        if there is None:
            return False
        person.place, person.yaw, person.z = (there.x, there.y), there.yaw, there.z
        return True

    def _mount(self, person: StagedPerson, state: BodyState) -> bool:
        """Put a person on their mount: an animal, a bicycle, another's back; return whether there is one."""
        name = state.support_id or (state.spot.anchor_id if state.spot is not None else None)
        carrier, thing = self.people.get(name or ""), self.floor.thing(name)
        if carrier is not None and carrier is not person and carrier.present:
            (x, y), yaw = carrier.place, carrier.yaw
            back = _ON_BACK[0] * carrier.scale
            person.place, person.yaw = (x - back * math.sin(yaw), y + back * math.cos(yaw)), yaw
            person.z, person.support = _ON_BACK[1] * carrier.scale, None
            return True
        if thing is None:
            return False
        person.place, person.yaw, person.z, person.support = thing.location[:2], thing.yaw, 0.0, thing.node_id
        return True

    def seat_of_spot(self, person: StagedPerson, state: BodyState) -> SeatPlace | None:
        """Return the seat at the spot of a person's state, if they sit there or board it; None if it has no seat."""
        spot = state.spot
        if spot is None or state.posture in _LIE or (state.posture != "sit" and not self._is_boarded(spot)):
            return None
        thing = self.floor.thing(state.support_id) or self.floor.thing(spot.anchor_id)
        if thing is None:
            return None
        on_it = spot.relation == "on" and spot.anchor_id in (thing.node_id, thing.asset_id)
        return self.seats.choose(person, thing.node_id, side=spot.side, on_it=on_it)

    def _place_before_seat(self, person: StagedPerson, state: BodyState) -> Station | None:
        """Return the place of a standing person whose spot is a seat or a bed, from which they can sit or lie down."""
        spot = state.spot
        thing = self.floor.thing(spot.anchor_id) if spot is not None and spot.relation == "on" else None
        if spot is None or thing is None or spot.height is not None or not thing.anchors_of("seat", "bed"):
            return None
        seats = self.floor.seats(thing.node_id) or [edge for edge, _ in self.floor.bed_edges(thing.node_id)]
        seat = min(seats, key=lambda each: math.dist(each.edge, person.place))
        x, y = self.floor.seat_access(seat, person.scale)
        return Station(x, y, seat.yaw)

    def _is_boarded(self, spot: Spot) -> bool:
        """Tell whether a spot is in a thing with seats, such as a car or a boat."""
        thing = self.floor.thing(spot.anchor_id)
        return thing is not None and spot.relation in ("in", "inside") and bool(thing.anchors_of("seat"))

    def find_station(self, person: StagedPerson, spot: Spot, posture: Posture = "stand") -> Station | None:
        """Return the best place for a person at a spot: near, with room, away from others; None without an anchor.

        Args:
            person: The person who stands there.
            spot: The spot in the script.
            posture: Their posture.
        """
        found = self.find_anchor(spot.anchor_id, person)
        if found is None:
            return self._turn_station(person, spot, Station(*person.place, person.yaw), None) if spot.facing else None
        box, sort, thing = found
        spot = _move_spot_to_floor(spot, posture, box, sort)
        options = self._at_door(thing, spot) or stations(
            box, sort, spot.relation, spot.side, spot.distance, person.scale
        )
        best = min(options, key=lambda each: self._cost(person, each, spot.relation in WITHIN))
        if spot.relation not in WITHIN:
            best = self._clear_of_people(person, best)
        if thing is not None and spot.relation == "on":
            top = self.floor.point_on_top(thing, thing.location[:2])
            best = Station(best.x, best.y, best.yaw, z=top[2] if top else best.z)
        return self._turn_station(person, spot, best, box)

    def _is_out_of_reach(self, person: StagedPerson, spot: Spot) -> bool:
        """Tell whether every place of a spot is outside the playing area, such as by a plane on the runway."""
        found = self.find_anchor(spot.anchor_id, person)
        if found is None or spot.relation in WITHIN or spot.height is not None:
            return False
        box, sort, _ = found
        places = stations(box, sort, spot.relation, spot.side, spot.distance, person.scale)
        return not any(self.floor.inside((each.x, each.y)) for each in places)

    def _clear_of_people(self, person: StagedPerson, station: Station) -> Station:
        """Return the station, or the nearest free place if another person is there."""
        point = (station.x, station.y)
        others = [each.place for each in self.people.values() if each.present and each is not person]
        reached = self.floor.inside(
            point, -self.floor.walk_on_distance
        )  # walk towards things that are only seen in the distance
        if reached and all(math.dist(point, other) > _TOO_NEAR for other in others):
            return station
        x, y = self.floor.free_spot(point, person.scale, others, apart=_APART)
        return replace(station, x=x, y=y)

    def find_anchor(
        self, name: str | None, person: StagedPerson | None = None
    ) -> tuple[Box, Sort, PlacedObject | None] | None:
        """Return the anchor of a spot: its box, its sort, and the placed object if it is one; None if it is unknown.

        Args:
            name: Id of the anchor.
            person: The person at the spot; people are never their own anchor.
        """
        holder = next((each for each in self.people.values() if each.hand_of(name or "")), None)
        other = holder or self.people.get(name or "")  # in front of the pistol is in front of its holder
        if other is not None and other is not person:
            return (
                (Box(*other.place, 0.0, 0.5, 0.36, 1.7 * other.scale, other.yaw), "person", None)
                if other.present
                else None
            )
        thing = self.floor.thing(name, person.place if person is not None else None)
        if thing is not None:
            sort: Sort = "thing"
            if thing in self.floor.openings:
                sort = "window" if thing.asset_id == "window" else "door"
            return Box(*thing.location, *thing.size, thing.yaw), sort, thing
        fixture = next(iter(fixtures_called(self.floor.plan, name)), None)
        if fixture is None:
            return None
        sorts: dict[str, Sort] = {"wall": "wall", "corner": "point", "mark": "point"}
        return fixture.box, sorts.get(fixture.kind, "thing"), None

    def _at_door(self, thing: PlacedObject | None, spot: Spot) -> list[Station]:
        """Return the places at the doors of a vehicle, on the side that the spot gives."""
        doors = thing.anchors_of("door") if thing is not None else []
        if thing is None or not doors or spot.side is None or spot.relation not in ("at", "next_to", "in_front_of"):
            return []
        left = {"driver": 1.0, "left": 1.0, "passenger": -1.0, "right": -1.0}.get(spot.side)
        found: list[Station] = []
        for door in doors:
            x, y, _ = door.location
            if left is None or x * left > min(_DOOR_SIDE, thing.size[0] / 4):
                wx, wy, _ = thing.to_world((x + math.copysign(0.15, x), y, 0.0))
                yaw = yaw_along(thing.location[0] - wx, thing.location[1] - wy)
                found.append(Station(wx, wy, yaw, dislike=0.2 * y))
        return found

    def _cost(self, person: StagedPerson, station: Station, within: bool) -> float:
        """Return the penalty of a station in metres: its own dislike, crowding, distance and lack of room."""
        point = (station.x, station.y)
        others = [each.place for each in self.people.values() if each.present and each is not person]
        crowded = sum(max(0.0, _APART - math.dist(point, other)) for other in others)
        cost = station.dislike + _CROWDED * crowded + _FAR * math.dist(point, person.place)
        if within:
            return round(cost, 4)
        room = float(clearance(np.array([point]), self.floor.obstacles())[0]) if self.floor.inside(point) else -1.0
        return round(cost + _TIGHT * max(0.0, BODY * person.scale + 0.02 - room), 4)

    def _nearest_at(self, person: StagedPerson, station: Station) -> StagedPerson | None:
        """Return the nearest seated or kneeling person: a person who stops beside a piano turns to its player."""
        here = (station.x, station.y)
        others = [each for each in self.people.values() if each.present and each is not person and not each.upright]
        near = [each for each in others if math.dist(each.place, here) < _SAME_THING_DISTANCE]
        return min(near, key=lambda each: math.dist(each.place, here), default=None)

    def _turn_station(self, person: StagedPerson, spot: Spot, station: Station, anchor: Box | None) -> Station:
        """Return a station with the facing and the height that the script gives."""
        yaw, here = station.yaw, (station.x, station.y)
        if spot.facing == "camera":
            yaw = 0.0
        elif spot.facing == "away" and anchor is not None:
            yaw = yaw_along(here[0] - anchor.x, here[1] - anchor.y)
        elif spot.facing is None and spot.relation == "next_to" and (other := self._nearest_at(person, station)):
            yaw = turn_towards_audience(yaw_along(other.place[0] - here[0], other.place[1] - here[1]))
        elif spot.facing is not None and (found := self.find_anchor(spot.facing, person)) is not None:
            yaw = turn_towards_audience(yaw_along(found[0].x - here[0], found[0].y - here[1]))
        height = spot.height if spot.height is not None else station.z
        return Station(station.x, station.y, yaw, station.dislike, height)


def _move_spot_to_floor(spot: Spot, posture: Posture, box: Box, sort: Sort) -> Spot:
    """Return a spot moved to the floor beside its anchor, if a body cannot be on or above it and no height is given."""
    if spot.height is not None or spot.relation not in ("on", "above", "over") or posture in _IN_THE_AIR:
        return spot
    flat = (
        sort in ("thing", "point")
        and box.top < _MAX_CLIMB
        and (sort == "point" or min(box.width, box.depth) > _FOOTING)
    )
    if spot.relation == "on" and flat:
        return spot
    return spot.model_copy(update={"relation": "at" if sort in ("door", "window", "wall") else "next_to"})
