"""Chooses people's seats: their own in the layout, one on the thing the script names, or one at the table."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence

from storyblender.agents.visual_effects_artist.floor import PERSONAL, Floor
from storyblender.agents.visual_effects_artist.person import SEATED, StagedPerson
from storyblender.agents.visual_effects_artist.placed_objects import SeatPlace
from storyblender.geometry.paths import Vec2
from storyblender.geometry.seating import NEAR_TABLE, TABLE_GAP, select_seats
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import BodyState

OWN_SEAT_DISTANCE = 2.0
"""Metres from their place in the layout within which people take their own seat."""


class Seats:
    """The seats of a scene.

    Args:
        floor: Positions of things on the floor.
        people: Everyone in the scene by asset id.
        objects: The layout, for the people's own seats.
        things: Returns the positions of loose props that block a seat.
    """

    def __init__(
        self,
        floor: Floor,
        people: Mapping[str, StagedPerson],
        objects: Sequence[LayoutObject],
        things: Callable[[], Iterable[Vec3]],
    ) -> None:
        self.floor, self.people, self.things = floor, people, things
        placed = [item for item in reversed(objects) if item.asset_id in people]
        self.home: dict[str, Vec2] = {item.asset_id: item.location[:2] for item in placed}
        self.seated_on = {
            item.asset_id: item.anchor_asset_id
            for item in placed
            if item.anchor_asset_id is not None and item.relationship is None and item.direction is None
        }

    def own_seat(self, person: StagedPerson, state: BodyState) -> SeatPlace | None:
        """Return a person's seat in the layout, if they stand near it and the state names no other support.

        Args:
            person: The person, as of the cue written last.
            state: The state that has them sit.
        """
        node, home = self.seated_on.get(person.asset_id), self.home.get(person.asset_id, (0.0, 0.0))
        support = self.floor.thing(state.support_id)
        told = support is None or node in (support.node_id, *(seat.node_id for seat in self.seats_at(support.node_id)))
        if node is None or not told or person.posture != "stand" or math.dist(home, person.place) > OWN_SEAT_DISTANCE:
            return None
        taken = [p.place for p in self.people.values() if p.present and p is not person and p.posture in SEATED]
        seats = self._free(self.floor.seats(node, asked=True), taken)
        return min(seats, key=lambda seat: math.dist(seat.edge, home), default=None)

    def with_layout_seat(self, person: StagedPerson, state: BodyState) -> BodyState:
        """Return a state, seated if the script says nothing of a person and the layout has seated them.

        Args:
            person: The person, as of the cue written last.
            state: Their state at the start of the shot.
        """
        node = self.seated_on.get(person.asset_id)
        told = state.posture != "stand" or state.spot is not None or person.posture != "stand"
        if node is None or told or math.dist(self.home[person.asset_id], person.place) > OWN_SEAT_DISTANCE:
            return state
        return state.model_copy(update={"posture": "sit", "support_id": node})

    def choose(
        self,
        person: StagedPerson,
        name: str | None,
        beside: StagedPerson | None = None,
        side: str | None = None,
        on_it: bool = False,
    ) -> SeatPlace | None:
        """Return the nearest free seat: of the thing ``beside`` sits on, of or at a named thing, else of the whole set.

        Args:
            person: The person who sits down.
            name: Id of the thing they sit on or at, from the script.
            beside: The person they sit next to.
            side: Side of a vehicle: ``driver``, ``passenger``, ``left``, ``right``; None for any.
            on_it: Whether they sit on the thing itself, even if chairs stand at it.
        """
        next_to = beside.support if beside is not None else None
        if beside is not None and next_to and (free := self.floor.free_seats(next_to, self._others(person))):
            return self._choose_best(free, beside.place, person)
        taken = [p.place for p in self.people.values() if p.present and p is not person and p.posture in SEATED]
        free: list[SeatPlace] = []
        if name:
            free = [] if on_it else self._free(self.seats_at(name), taken)
            free = free or self.floor.free_seats(name, taken)
            free = free or (self._free(self.floor.seats(name, on_top=True), taken) if on_it else [])
            free = select_seats(free, side, self._place_in_vehicle) if side else free
        return self._choose_best(free or self.floor.free_seats(None, taken), person.place, person)

    def seats_at(self, name: str | None) -> list[SeatPlace]:
        """Return the seats drawn up to a thing without a seat, the chairs of a table, else those near it."""
        table = self.floor.thing(name)
        if table is None or table.anchors_of("seat", "bed") or not table.anchors_of("top"):
            return []
        seats = [seat for node in self.floor.things if node != table.node_id for seat in self.floor.seats(node)]
        found, near = [], []
        for seat in seats:
            away = math.dist(seat.edge, table.nearest_edge(seat.edge))
            if away < NEAR_TABLE:
                near.append(seat)
            x, y = seat.edge[0] + 0.3 * math.sin(seat.yaw), seat.edge[1] - 0.3 * math.cos(seat.yaw)
            if away < TABLE_GAP and math.dist((x, y), table.location[:2]) < math.dist(seat.edge, table.location[:2]):
                found.append(seat)
        return found or near

    def _free(self, seats: Sequence[SeatPlace], taken: Sequence[Vec2]) -> list[SeatPlace]:
        """Return the seats that are more than 0.4 m from all taken floor points."""
        return [seat for seat in seats if all(math.dist(seat.edge, spot) > 0.4 for spot in taken)]

    def _place_in_vehicle(self, seat: SeatPlace) -> Vec2:
        """Return the place of a seat in its vehicle, in metres to the left and to the front."""
        x, y = self.floor.things[seat.node_id].to_local(seat.edge)
        return x, -y

    def _others(self, person: StagedPerson) -> list[Vec2]:
        """Return the floor points of everybody else on stage."""
        return [p.place for p in self.people.values() if p.present and p is not person]

    def _choose_best(self, seats: Sequence[SeatPlace], near: Vec2, person: StagedPerson) -> SeatPlace | None:
        """Return the nearest usable seat: no prop or person is in the way and nobody needs it in a later shot."""
        absent = [place for name, place in self.home.items() if not self.people[name].present]

        def unfit(seat: SeatPlace) -> bool:
            crowded = any(
                math.dist(seat.standing_spot(person.scale), other) < PERSONAL for other in self._others(person)
            )
            kept = any(math.dist(seat.edge, place) < 0.3 for place in absent)
            return crowded or kept or any(seat.is_blocked_by(at) for at in self.things())

        return min(seats, key=lambda seat: (unfit(seat), math.dist(seat.edge, near)), default=None)
