"""Props that the script moves or removes between shots: the tray is now by the door, the car has gone."""

from __future__ import annotations

import math
from collections.abc import Mapping

from storyblender.agents.visual_effects_artist.placed_objects import is_put_on
from storyblender.agents.visual_effects_artist.spot_finder import SpotFinder
from storyblender.catalog.hollows import place_inside
from storyblender.geometry.stations import stations
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Spot
from storyblender.memory.shot_context import PropState, ShotContext

_IN = ("in", "inside")
_ON = ("on", *_IN)
_UNDER = ("under", "around")
_GAP = 0.12
"""Metres between a thing and the anchor beside it, if the script gives no distance."""


class ScriptedProps:
    """Moves props to their spots in the script, from shot to shot.

    Args:
        places: Finds the places of spots.
        lying: Positions of all props that nobody holds, by asset id; changed in place.
        sizes: Width and depth of things in metres, by asset id.
    """

    def __init__(self, places: SpotFinder, lying: dict[str, Vec3], sizes: Mapping[str, tuple[float, float]]) -> None:
        self.spot_finder, self.prop_places, self.sizes = places, lying, sizes
        self._told: dict[str, Spot] = {}

    def settle(self, shot: ShotContext, held: set[str], touched: Mapping[str, None]) -> list[str]:
        """Move things to the spots of a shot, unless an action brings them there.

        Args:
            shot: The shot, with its ``thing_spots``.
            held: Asset ids of held things.
            touched: Asset ids of things that have left their places in the layout.

        Returns:
            Asset ids of the things that were moved.
        """
        handled = {name for action in shot.character_actions for name in (action.prop_id, action.target_id)}
        moved: list[str] = []
        for thing, spot in shot.thing_spots.items():
            before = self._told.get(thing)
            self._told[thing] = spot
            as_laid_out = before is None and thing not in touched and thing in self.prop_places
            if before == spot or as_laid_out or thing in handled or thing in held or thing not in self.sizes:
                continue
            location = self._find_location(thing, spot)
            if location is not None:
                self.prop_places[thing] = location
                moved.append(thing)
        return moved

    def told_place(self, thing: str) -> Vec3 | None:
        """Return the position in metres of the spot at which the script had a thing last; None if it had none."""
        spot = self._told.get(thing)
        return self._find_location(thing, spot) if spot is not None and thing in self.sizes else None

    def _find_location(self, thing: str, spot: Spot) -> Vec3 | None:
        """Return the position in metres of a thing (asset id) at a spot; None if the spot's anchor is unknown."""
        found = self.spot_finder.find_anchor(spot.anchor_id)
        if found is None:
            return None
        box, sort, base = found
        if base is not None and spot.relation in _IN:
            size, here = self.sizes[thing], base.location
            key = self.spot_finder.floor.kinds.get(base.asset_id)
            others = sum(math.dist(place[:2], here[:2]) < max(base.size[:2]) / 2 for place in self.prop_places.values())
            place = place_inside(key, base.size, (*size, 0.0), others - (base.asset_id in self.prop_places))
            if place is not None:
                return base.to_world(place)
        if sort == "window" and spot.relation == "on":
            return box.x, box.y, box.z
        if base is not None and spot.relation in _ON and is_put_on(base):
            return self.spot_finder.floor.point_on_top(
                base, base.location[:2]
            ) or self.spot_finder.floor.nearest_point_on_top(base, base.location[:2])
        if spot.relation in _UNDER:
            return box.x, box.y, spot.height or 0.0
        reach = max(self.sizes[thing]) / 2
        gap = reach + (_GAP if spot.distance is None else spot.distance)
        if sort == "person":
            gap = max(gap, reach + 0.3)
        options = stations(box, sort, spot.relation, spot.side, gap)
        best = min(options, key=lambda each: round(each.dislike - 2 * min(self._clearance((each.x, each.y)), reach), 4))
        return best.x, best.y, spot.height or 0.0

    def _clearance(self, point: tuple[float, float]) -> float:
        """Return the metres from a floor point to the nearest obstacle or body, negative inside one."""
        others = [p.place for p in self.spot_finder.people.values() if p.present]
        free = self.spot_finder.floor.room_at(point)
        return min([free, *(math.dist(point, other) - 0.25 for other in others)])


def hide_absent_props(states: tuple[PropState, ...], shot: ShotContext) -> tuple[PropState, ...]:
    """Return the prop states of a shot in which things that the script has removed are hidden, unless they are held.

    Args:
        states: States of the props that have left their places.
        shot: The shot, with its ``absent`` things.
    """
    by_thing = {state.asset_id: state for state in states}
    for thing in shot.absent:
        if thing not in by_thing or by_thing[thing].held_by is None:
            by_thing[thing] = PropState(asset_id=thing, visible=False)
    return tuple(by_thing.values())
