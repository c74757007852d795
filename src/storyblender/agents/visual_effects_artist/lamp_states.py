"""Which lamps of a scene burn in which shot, and where: switched, blown out, carried about, gone."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from storyblender.agents.visual_effects_artist.lighting_arranger import lights_out
from storyblender.agents.visual_effects_artist.lighting_arranger_view import (
    MOST_LIGHTS,
    CarriedLamp,
    LightingArrangerView,
    burning_lamps,
    strongest_lights,
)
from storyblender.catalog.fixtures import fixtures_called
from storyblender.catalog.light_recipes import HOURS, LAMPS
from storyblender.catalog.props.prop_names import prop_of, props_of
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Light, Lighting
from storyblender.memory.shot_context import AssetModification, Mark, ShotContext
from storyblender.memory.thing_states import OFF_STATES, ON_STATES, Condition

LIGHT = "light"
"""Asset id in a scene's found states for the light of the whole place."""
_HAND_HEIGHTS: dict[str, float] = {"sit": 0.85, "kneel": 0.8, "crouch": 0.7, "lie": 0.4, "asleep": 0.3}
"""Metres of a hand-held lamp above the floor, by posture of its holder; of a standing one."""
_STANDING = 1.12
"""Height in metres of a hand-held lamp above the floor, by posture of its holder."""
_REACH = 0.42
"""Metres from the body to the hand."""
_BEAM, _BEAM_END = 6.0, 0.7
"""Metres to the point that a beam without an aim shines at, and that point's height."""
_AIMING = frozenset({"point", "aim", "look", "show", "search", "stare", "peek"})
"""Clips in which a person points a lamp at their target."""
_CHEST = 1.2
_DIMMEST = 0.5
"""Least share of the level of a set that stays while one of its lamps burns."""


@dataclass
class LampStates:
    """The lamps of a scene, followed from shot to shot.

    Args:
        view: The scene as the Lighting Arranger sees it.
        found: States of things as the scene opens, by asset id.

    Attributes:
        burning: Whether a lamp burns, by asset id, if the story says so.
        without_power: Lamps that are dark because the light of the place is out.
        dark: Whether the light of the place is out.
        dark_at_first: State changes of lamps that an earlier scene in the place has switched.
    """

    view: LightingArrangerView
    found: Mapping[str, Condition]
    burning: dict[str, bool] = field(default_factory=dict)
    without_power: dict[str, None] = field(default_factory=dict)
    dark: bool = False
    dark_at_first: tuple[AssetModification, ...] = ()

    def __post_init__(self) -> None:
        for asset_id, states in self.found.items():
            for state in states.states:
                self._note_state(asset_id, state)
        for state in self.found.get(LIGHT, Condition()).states:
            if state in OFF_STATES | ON_STATES:
                self.dark_at_first = tuple(self._switch_lamps("off" if state in OFF_STATES else "on", ()))

    def play(self, shot: ShotContext) -> tuple[ShotContext, LightingArrangerView]:
        """Follow one shot.

        Args:
            shot: The next shot of the scene, staged.

        Returns:
            The shot with the state changes of its lamps, and the view of the scene at its end.
        """
        for change in shot.asset_modifications:
            self._note_state(change.asset_id, change.state)
        if shot.light_change is not None and shot.light_change.lamps is not None:
            changes = shot.asset_modifications
            switched = self._switch_lamps(shot.light_change.lamps, {change.asset_id for change in changes})
            shot = shot.model_copy(update={"asset_modifications": (*changes, *switched)})
        held = {state.asset_id for state in shot.prop_states if state.held_by is not None and state.visible}
        gone = {state.asset_id for state in shot.prop_states if not state.visible} | {*shot.absent}
        lamps = {asset_id: LAMPS[key] for asset_id, key in props_of(self.view.assets).items() if key in LAMPS}
        told = {
            **dict.fromkeys((lamp for lamp in held & lamps.keys() if lamps[lamp].off_by_default), True),
            **self.burning,
        }
        told |= dict.fromkeys(gone, False)
        return shot, replace(self.view, burning=told, carried=dict(_find_carried_lamps(shot, lamps.keys(), self.view)))

    def _note_state(self, asset_id: str, state: str) -> None:
        """Note whether a state of an asset lights or darkens it."""
        if state in OFF_STATES or state == "gone":
            self.burning[asset_id] = False
        elif state in ON_STATES:
            self.burning[asset_id] = True
            self.without_power.pop(asset_id, None)

    def _switch_lamps(self, lamps: Literal["on", "off"], changed: Collection[str]) -> Iterator[AssetModification]:
        """Yield the state changes of the lamps that go on or off with the light: those without a flame or battery."""
        self.dark = lamps == "off"
        if lamps == "on":
            fed = [lamp for lamp in self.without_power if lamp not in changed]
            self.without_power.clear()
            self.burning |= dict.fromkeys(fed, True)
            yield from (_lamp_change(lamp, "on") for lamp in fed)
        else:
            placed = {item.asset_id for item in self.view.layout.objects} if self.view.layout else set[str]()
            for asset in self.view.assets:
                key, lit = prop_of(asset), self.burning.get(asset.asset_id)
                if key not in LAMPS or asset.asset_id in changed or asset.asset_id not in placed or lit is False:
                    continue
                if (lit is None and not LAMPS[key].off_by_default) or not LAMPS[key].without_mains:
                    self.burning[asset.asset_id] = False
                    self.without_power[asset.asset_id] = None
                    yield _lamp_change(asset.asset_id, "off")


def light_shots(
    usual: Lighting,
    view: LightingArrangerView,
    shots: Sequence[ShotContext],
    found: Mapping[str, Condition],
    change: Callable[[Lighting, ShotContext], Lighting],
) -> tuple[Lighting, tuple[ShotContext, ...], dict[str, Condition]]:
    """Return the light of a scene, its shots with a plan wherever the light changes, and the states as it opens.

    Args:
        usual: The plan of the scene if nothing is switched.
        view: The scene.
        shots: Its shots, staged, in order.
        found: States of things as the scene opens, by asset id.
        change: Returns the light after the change that a shot has.
    """
    lamps = LampStates(view, found)
    first_changes: dict[str, str] = {}
    for each in (each for shot in shots for each in shot.asset_modifications):
        first_changes.setdefault(each.asset_id, each.state)
    for lamp in (lamp for lamp, state in first_changes.items() if state in ON_STATES):
        lamps.burning.setdefault(lamp, False)  # nobody has lit it yet, though it is in a hand
    plan = lights_out(usual, indoor=view.plan.indoor) if lamps.dark else usual
    first = current = plan_with_lamps(plan, replace(view, burning=dict(lamps.burning)), dark=lamps.dark)
    lit: list[ShotContext] = []
    for shot in shots:
        shot, seen = lamps.play(shot)
        plan = change(plan, shot) if shot.light_change else plan
        now = plan_with_lamps(plan, seen, dark=lamps.dark)
        lit.append(shot.model_copy(update={"lighting": now}) if now != current else shot)
        current = now
    out = {each.asset_id: Condition().after(each.state) for each in lamps.dark_at_first}
    return first, tuple(lit), {**found, **out}


def plan_with_lamps(plan: Lighting, view: LightingArrangerView, *, dark: bool) -> Lighting:
    """Return a light plan with the lamps that burn at a moment.

    Args:
        plan: The light if nothing is switched.
        view: The scene, with the lamps that burn and where they are.
        dark: Whether the light of the place is out.
    """
    burning = {light.name: light for light in burning_lamps(view, 1.0)}
    usual = {light.name: light for light in burning_lamps(replace(view, burning={}, carried={}), 1.0)}
    night = HOURS[view.setup.time_of_day].lamps > 0.8
    if night and view.plan.indoor and usual and not burning and not dark:
        return lights_out(plan, indoor=True)
    gains = [light.power / usual[light.name].power for light in plan.lights if light.name in usual]
    gain = max(gains, default=1.0)
    lit = _scripted_light_names(view)
    own = {light.name for light in plan.lights}
    kept = [light for light in plan.lights if light.name not in usual or light.name in burning]
    lights = [light.model_copy(update=_burning_place(burning.get(light.name))) for light in kept]
    added = (light for name, light in burning.items() if name in lit and name not in own)
    lights += [light.model_copy(update={"power": round(light.power * gain, 3)}) for light in added]
    share = sum(light.power for light in burning.values()) / max(sum(each.power for each in usual.values()), 1e-6)
    level = plan.set_luminance
    if night and not dark and usual and share < 0.999:
        level = round(level * max(_DIMMEST, share**0.5), 4)
    if tuple(lights) == plan.lights and level == plan.set_luminance:
        return plan
    return plan.model_copy(update={"lights": strongest_lights(tuple(lights), MOST_LIGHTS), "set_luminance": level})


def _burning_place(light: Light | None) -> dict[str, object]:
    """Return the fields for the place and aim of a burning light; empty if it does not burn."""
    return {} if light is None else {"location": light.location, "target": light.target}


def _scripted_light_names(view: LightingArrangerView) -> set[str]:
    """Return the names of the lights of lamps that the story has lit."""
    lit = {asset_id for asset_id, burns in view.burning.items() if burns}
    placed = view.layout.objects if view.layout is not None else ()
    names = lit | {item.node_id for item in placed if item.asset_id in lit}
    return {f"{name}_light" for name in names}


def _find_carried_lamps(
    shot: ShotContext, lamps: Collection[str], view: LightingArrangerView
) -> Iterator[tuple[str, CarriedLamp]]:
    """Yield the lamps that have left their places at the end of a shot, with their places and aims."""
    ends = {blocking.end.asset_id: blocking.end for blocking in shot.blocking}
    aims = {cue.asset_id: cue.target_id for cue in shot.cues if cue.clip in _AIMING and cue.target_id is not None}
    for state in shot.prop_states:
        if state.asset_id not in lamps:
            continue
        mark = ends.get(state.held_by or "")
        if mark is not None:
            yaw = math.radians(mark.yaw)
            x, y, z = mark.location
            ahead = math.sin(yaw), -math.cos(yaw)
            aim = _find_aim_point(aims.get(mark.asset_id), ends, view)
            if aim is None or math.dist(aim[:2], (x, y)) < _REACH:
                aim = x + _BEAM * ahead[0], y + _BEAM * ahead[1], z + _BEAM_END
            else:
                way = math.dist(aim[:2], (x, y))
                ahead = (aim[0] - x) / way, (aim[1] - y) / way
            place = x + _REACH * ahead[0], y + _REACH * ahead[1], z + _HAND_HEIGHTS.get(mark.posture, _STANDING)
            yield state.asset_id, CarriedLamp(_rounded(place), _rounded(aim))
        elif state.location is not None:
            yield state.asset_id, CarriedLamp(state.location, None)


def _find_aim_point(name: str | None, people: Mapping[str, Mark], view: LightingArrangerView) -> Vec3 | None:
    """Return the middle of a person, a thing or a part of the set in world metres; None if it is unknown."""
    if name is None:
        return None
    if name in people:
        x, y, z = people[name].location
        return x, y, z + _CHEST
    sizes = {asset.asset_id: asset.canonical.dimensions for asset in view.assets if asset.canonical is not None}
    for item in view.layout.objects if view.layout is not None else ():
        if name in (item.node_id, item.asset_id):
            x, y, z = item.location
            return x, y, z + sizes.get(item.asset_id, (0.0, 0.0, 1.0))[2] / 2
    box = next((fixture.box for fixture in fixtures_called(view.plan, name)), None)
    return None if box is None else (box.x, box.y, box.z + min(box.height / 2, _CHEST))


def _rounded(place: Vec3) -> Vec3:
    return (round(place[0], 3), round(place[1], 3), round(place[2], 3))


def _lamp_change(asset_id: str, state: Literal["on", "off"]) -> AssetModification:
    return AssetModification(asset_id=asset_id, modification_type="transform", state=state)
