"""Places where people put props down: on the floor beside them, in front of a sitter, on a seat, on a top. Pure.

Places are in metres in the set; yaws are in radians, counter-clockwise, and 0 faces the audience at -Y.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.placed_objects import PlacedObject
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.catalog.hollows import OPEN_ABOVE, place_inside
from storyblender.memory.base import Vec3
from storyblender.memory.vocabulary import Hand

BEFORE_SEAT = 0.27
"""Metres from the front edge of a sitter's seat to a prop that is put down in front of them."""
TO_THE_SIDE = 0.18
"""Metres: the greatest sideways offset of a prop that is put down in front of a sitter."""
AT_TABLE = 1.3
"""Metres between a person and a spot in front of a sitter within which the person puts a prop there."""
BEHIND_SEAT_EDGE = 0.2
"""Metres behind the front edge of a seat at which a prop is put on it."""
HALF_HIPS = 0.18
"""Metres: half the width that a sitter takes on a seat, times stature over 1.7."""
BAG_LENGTH = 0.4
"""Metres: a bag's largest extent is at least this."""
STICK_WIDTH = 0.06
"""Metres: a long prop whose second largest extent is less is a stick, not a bag."""
BESIDE_FOOT = 0.34
"""Metres from a person's place to a bag that is put down beside them, times stature over 1.7."""
CLEAR_OF_FEET = 0.6
"""Metres between a bag on the floor and the places of other people."""


class PropSpots:
    """Finds free spots for props that people put down.

    Args:
        stage: People and props of the scene.
    """

    def __init__(self, stage: StageState) -> None:
        self.stage = stage

    def is_bag(self, prop: str, *, min_depth: float = 0.0) -> bool:
        """Tell whether a prop (asset id) is as long as a bag, wider than a stick, and ``min_depth`` metres deep."""
        size = self.stage.size_of(prop)
        return size is not None and size[2] >= BAG_LENGTH and size[1] >= STICK_WIDTH and size[0] >= min_depth

    def find_beside(self, person: StagedPerson, prop: str, hand: Hand | None) -> Vec3 | None:
        """Return a free spot on the floor beside a person, ahead of them rather than behind.

        Args:
            person: The person who puts the prop down.
            prop: Asset id of the prop.
            hand: The hand that holds the prop; spots on its side come first.

        Returns:
            Spot in metres in the set; None if there is no room.
        """
        half = (self.stage.size_of(prop) or [0.2])[1] / 2
        away = BESIDE_FOOT * person.scale + max(0.0, half - 0.1)
        side = 1 if hand == "L" else -1
        others = self.stage.others(person)
        for turn in (50, -50, 90, -90, 130, -130):  # what is ahead needs no turn
            yaw = person.yaw + side * math.radians(turn)
            spot = (person.place[0] + away * math.sin(yaw), person.place[1] - away * math.cos(yaw))
            clear = all(math.dist(spot, place) > CLEAR_OF_FEET for place in others)
            clear = clear and self.stage.floor.room_at(spot) > half
            if clear and self._move_clear_of_props((*spot, 0.0)) == (*spot, 0.0):
                return (*spot, 0.0)
        return None

    def find_on(self, thing: PlacedObject, person: StagedPerson, prop: str) -> Vec3:
        """Return the spot on or in a piece of furniture on which a person puts a prop.

        A prop goes into a hollow such as a bin; else beside the people who sit on the furniture; else in front of a
        sitter at a table, shifted towards the person; else to the point of the top that is nearest to the person.

        Args:
            thing: The furniture.
            person: The person who puts the prop down.
            prop: Asset id of the prop.

        Returns:
            Spot in metres in the set.
        """
        floor = self.stage.floor
        key, (low, middle, long) = floor.kinds.get(thing.asset_id), self.stage.size_of(prop) or (0.1, 0.1, 0.1)
        if key in OPEN_ABOVE and (place := place_inside(key, thing.size, (long, middle, low))) is not None:
            return thing.to_world(place)
        sitters = [p for p in self.stage.people.values() if p.present and p.posture == "sit"]
        if (beside := self._find_beside_sitters(thing, person, prop, sitters)) is not None:
            return beside
        for sitter in sorted(sitters, key=lambda each: math.dist(each.place, person.place)):
            (x, y), yaw = sitter.place, sitter.yaw
            away = (person.place[0] - x) * math.cos(yaw) + (person.place[1] - y) * math.sin(yaw)
            most = 0.5 * TO_THE_SIDE if ("L" if away > 0 else "R") in sitter.held else TO_THE_SIDE
            aside = max(-most, min(most, away))
            ahead = (x + BEFORE_SEAT * math.sin(yaw), y - BEFORE_SEAT * math.cos(yaw))
            spot = floor.point_on_top(thing, (ahead[0] + aside * math.cos(yaw), ahead[1] + aside * math.sin(yaw)))
            if spot is not None and math.dist(spot[:2], person.place) < AT_TABLE:
                return self._move_clear_of_props(spot)
        return self._move_clear_of_props(floor.nearest_point_on_top(thing, person.place))

    def _find_beside_sitters(
        self, thing: PlacedObject, person: StagedPerson, prop: str, sitters: Sequence[StagedPerson]
    ) -> Vec3 | None:
        """Return the free spot on a seat between its two nearest sitters, or beside its only one.

        Args:
            thing: The furniture with the seat.
            person: The person who puts the prop down.
            prop: Asset id of the prop.
            sitters: Everybody who sits, on any furniture.

        Returns:
            Spot in metres in the set; None if nobody sits on the furniture or no spot is free.
        """
        there = [each for each in sitters if each.support == thing.node_id]
        if not there:
            return None
        there.sort(key=lambda each: math.dist(each.place, person.place))
        (x, y), yaw = there[0].place, there[0].yaw
        left = (math.cos(yaw), math.sin(yaw))
        along = [(each.place[0] - x) * left[0] + (each.place[1] - y) * left[1] for each in there]
        wish = sum(along[:2]) / len(along[:2])
        half = (self.stage.size_of(prop) or [0.2])[-1] / 2
        full = person is there[0] and person.free_hand() is None  # then the other hand cannot take it across
        free: list[tuple[float, Vec3]] = []
        for step in range(-24, 25):
            s = 0.05 * step
            edge = (x + s * left[0], y + s * left[1])
            back = (edge[0] - BEHIND_SEAT_EDGE * math.sin(yaw), edge[1] + BEHIND_SEAT_EDGE * math.cos(yaw))
            spot = self.stage.floor.point_on_top(thing, back)
            clear = all(abs(s - at) > HALF_HIPS * each.scale + half for at, each in zip(along, there, strict=True))
            if spot is not None and clear and self._move_clear_of_props(spot) == spot:
                across = full and (s > 0) == (person.hand_of(prop) == "R")
                free.append((abs(s - wish) + across, spot))
        return min(free)[1] if free else None

    def _move_clear_of_props(self, spot: Vec3) -> Vec3:
        """Return a spot moved aside by up to 0.35 m so that no prop lies within 0.15 m; unmoved if all is full."""
        taken = [place for place in self.stage.prop_places.values() if abs(place[2] - spot[2]) < 0.1]
        for dx, dy in ((0.0, 0.0), (0.18, 0.0), (-0.18, 0.0), (0.0, 0.16), (0.0, -0.16), (0.3, 0.1), (-0.3, 0.1)):
            moved = (spot[0] + dx, spot[1] + dy, spot[2])
            if all(math.dist(moved[:2], place[:2]) > 0.15 for place in taken):
                return moved
        return spot
