"""Props that the script tips over, spills or breaks: from that shot on they lie on their side."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from storyblender.catalog.states import topples
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import PropState, ShotContext
from storyblender.memory.thing_states import LYING_STATES, Condition


class FallenProps:
    """Things lying on their side, carried from shot to shot.

    Args:
        assets: Assets of the scene, with their sizes.
        objects: The layout, for the positions of things that have not been moved.
        found: States of things as the scene opens, by asset id.
    """

    def __init__(
        self, assets: Sequence[Asset], objects: Sequence[LayoutObject], found: Mapping[str, Condition] = {}
    ) -> None:
        self._sizes: dict[str, Vec3] = {
            asset.asset_id: asset.canonical.dimensions
            for asset in assets
            if asset.asset_type == "object" and asset.canonical is not None
        }
        self._homes = {item.asset_id: (item.location, item.rotation) for item in reversed(objects)}
        down = (name for name, states in found.items() if LYING_STATES & {*states.states})
        self._down: dict[str, None] = {name: None for name in down if self._can_fall(name)}

    def add_fallen(
        self, shot: ShotContext, states: tuple[PropState, ...], lying: Mapping[str, Vec3]
    ) -> tuple[PropState, ...]:
        """Return the prop states of a shot, including fallen things on their side.

        Args:
            shot: The shot; its state changes are applied first.
            states: States of all props that have left their places.
            lying: Positions of props that nobody holds, by asset id.
        """
        for change in shot.asset_modifications:
            if change.state in LYING_STATES and self._can_fall(change.asset_id):
                self._down[change.asset_id] = None
            elif change.state == "upright":
                self._down.pop(change.asset_id, None)
        kept = {state.asset_id: state for state in states}
        for name in self._down:
            state = kept.get(name)
            if state is not None and (state.held_by is not None or not state.visible):
                continue
            place, turn = self._homes.get(name, (None, (0.0, 0.0, 0.0)))
            place = (state.location if state is not None else None) or lying.get(name) or place
            if place is None:
                continue
            raised = (place[0], place[1], round(place[2] + self._sizes[name][1] / 2, 3))
            kept[name] = PropState(asset_id=name, location=raised, rotation=(90.0, 0.0, turn[2]))
        return tuple(kept.values())

    def _can_fall(self, name: str) -> bool:
        """Tell whether a thing (asset id) is of a shape that falls over."""
        return name in self._sizes and topples(self._sizes[name])
