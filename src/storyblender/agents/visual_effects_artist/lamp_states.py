"""Which lamps of a scene burn in which shot, and where: switched, blown out, carried about, gone. Pure."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from storyblender.agents.visual_effects_artist.lighting_arranger import lights_out
from storyblender.agents.visual_effects_artist.lighting_arranger_view import (
    MOST_LIGHTS,
    Carried,
    LightingArrangerView,
    burning_lamps,
    prop_key,
    strongest,
)
from storyblender.catalog.fixtures import fixtures_called
from storyblender.catalog.light_recipes import HOURS, LAMPS
from storyblender.catalog.states import GONE, OFF_STATES, ON_STATES, Condition
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Light, Lighting
from storyblender.memory.shot_context import AssetModification, Mark, ShotContext

LIGHT = "light"
"""Subject of what happens to the light of a whole place."""
_HAND: dict[str, float] = {"sit": 0.85, "kneel": 0.8, "crouch": 0.7, "lie": 0.4, "asleep": 0.3}
_STANDING = 1.12
"""Height in metres of a hand-held lamp above the floor, by posture of its holder."""
_REACH = 0.42
"""Metres of the hand before the body."""
_BEAM, _BEAM_END = 6.0, 0.7
"""Metres to where a beam points if it is aimed at nothing, and the height there."""
_AIMING = frozenset({"point", "aim", "look", "show", "search", "stare", "peek"})
"""Clips in which one points a lamp at what one looks at."""
_CHEST = 1.2
_DIMMEST = 0.5
"""Share of the level of a set that stays while one of its lamps burns."""


@dataclass
class LampStates:
    """The lamps of a scene, followed from shot to shot.

    Args:
        view: The scene as the Lighting Arranger sees it.
        found: States in which things are as the scene opens.

    Attributes:
        told: Whether a lamp burns, for those of which the story tells it.
        cut: Lamps that are dark because the power is gone.
        dark: Whether the light of the place is out.
        dark_at_first: What an earlier scene in the place has put out with the light.
    """

    view: LightingArrangerView
    found: Mapping[str, Condition]
    told: dict[str, bool] = field(default_factory=dict)
    cut: dict[str, None] = field(default_factory=dict)
    dark: bool = False
    dark_at_first: tuple[AssetModification, ...] = ()

    def __post_init__(self) -> None:
        for asset_id, states in self.found.items():
            for state in states:
                self._note(asset_id, state)
        for state in self.found.get(LIGHT, ()):
            if state in OFF_STATES | ON_STATES:
                self.dark_at_first = tuple(self._switched("off" if state in OFF_STATES else "on", ()))

    def play(self, shot: ShotContext) -> tuple[ShotContext, LightingArrangerView]:
        """Follow one shot; return it with the lamps that go out or on with the light, and the view of its end."""
        for change in shot.asset_modifications:
            self._note(change.asset_id, change.state)
        if shot.light_change is not None and shot.light_change.lamps is not None:
            changes = shot.asset_modifications
            switched = self._switched(shot.light_change.lamps, {change.asset_id for change in changes})
            shot = shot.model_copy(update={"asset_modifications": (*changes, *switched)})
        held = {state.asset_id for state in shot.prop_states if state.held_by is not None and state.visible}
        gone = {state.asset_id for state in shot.prop_states if not state.visible} | {*shot.absent}
        lamps = {asset.asset_id: LAMPS[key] for asset in self.view.assets if (key := prop_key(asset)) in LAMPS}
        told = {
            **dict.fromkeys((lamp for lamp in held & lamps.keys() if lamps[lamp].off_by_default), True),
            **self.told,
        }
        told |= dict.fromkeys(gone, False)
        return shot, replace(self.view, told=told, carried=dict(_carried(shot, lamps.keys(), self.view)))

    def _note(self, asset_id: str, state: str) -> None:
        if state in OFF_STATES or state == GONE:
            self.told[asset_id] = False
        elif state in ON_STATES:
            self.told[asset_id] = True
            self.cut.pop(asset_id, None)

    def _switched(self, lamps: Literal["on", "off"], changed: Collection[str]) -> Iterator[AssetModification]:
        """Yield the changes of the lamps that a change of the light switches: all that no flame or battery feeds."""
        self.dark = lamps == "off"
        if lamps == "on":
            fed = [lamp for lamp in self.cut if lamp not in changed]
            self.cut.clear()
            self.told |= dict.fromkeys(fed, True)
            yield from (_modification(lamp, "on") for lamp in fed)
        else:
            placed = {item.asset_id for item in self.view.layout.objects} if self.view.layout else set[str]()
            for asset in self.view.assets:
                key, lit = prop_key(asset), self.told.get(asset.asset_id)
                if key not in LAMPS or asset.asset_id in changed or asset.asset_id not in placed or lit is False:
                    continue
                if (lit is None and not LAMPS[key].off_by_default) or not LAMPS[key].without_mains:
                    self.told[asset.asset_id] = False
                    self.cut[asset.asset_id] = None
                    yield _modification(asset.asset_id, "off")


def lit_shots(
    usual: Lighting,
    view: LightingArrangerView,
    shots: Sequence[ShotContext],
    found: Mapping[str, Condition],
    change: Callable[[Lighting, ShotContext], Lighting],
) -> tuple[Lighting, tuple[ShotContext, ...], dict[str, Condition]]:
    """Return the light plan of a scene, its shots with a plan wherever the light is another from then on, and what is
    found off as the scene opens.

    Args:
        usual: The plan of the scene as it is if nothing is switched.
        view: The scene.
        shots: Of the scene, staged.
        found: States in which things are as the scene opens.
        change: Gives the light after a shot changes it.
    """
    lamps = LampStates(view, found)
    plan = lights_out(usual, indoor=view.plan.indoor) if lamps.dark else usual
    first = current = with_lamps(plan, replace(view, told=dict(lamps.told)), dark=lamps.dark)
    lit: list[ShotContext] = []
    for shot in shots:
        shot, seen = lamps.play(shot)
        plan = change(plan, shot) if shot.light_change else plan
        now = with_lamps(plan, seen, dark=lamps.dark)
        lit.append(shot.model_copy(update={"lighting": now}) if now != current else shot)
        current = now
    out = {each.asset_id: (each.state,) for each in lamps.dark_at_first}
    return first, tuple(lit), {**found, **out}


def with_lamps(plan: Lighting, view: LightingArrangerView, *, dark: bool) -> Lighting:
    """Return a light plan with the lamps that burn at a moment: what is off gives no light, what is lit does.

    Args:
        plan: The light as it is if nothing is switched.
        view: The scene, with the lamps that burn and where they are.
        dark: Whether the light of the place is out.
    """
    burning = {light.name: light for light in burning_lamps(view, 1.0)}
    usual = {light.name: light for light in burning_lamps(replace(view, told={}, carried={}), 1.0)}
    night = HOURS[view.setup.time_of_day].lamps > 0.8
    if night and view.plan.indoor and usual and not burning and not dark:
        return lights_out(plan, indoor=True)
    gains = [light.power / usual[light.name].power for light in plan.lights if light.name in usual]
    gain = max(gains, default=1.0)
    lit = _told_lit(view)
    own = {light.name for light in plan.lights}
    kept = [light for light in plan.lights if light.name not in usual or light.name in burning]
    lights = [light.model_copy(update=_place(burning.get(light.name))) for light in kept]
    added = (light for name, light in burning.items() if name in lit and name not in own)
    lights += [light.model_copy(update={"power": round(light.power * gain, 3)}) for light in added]
    share = sum(light.power for light in burning.values()) / max(sum(each.power for each in usual.values()), 1e-6)
    level = plan.set_luminance
    if night and not dark and usual and share < 0.999:
        level = round(level * max(_DIMMEST, share**0.5), 4)
    if tuple(lights) == plan.lights and level == plan.set_luminance:
        return plan
    return plan.model_copy(update={"lights": strongest(tuple(lights), MOST_LIGHTS), "set_luminance": level})


def _place(light: Light | None) -> dict[str, object]:
    return {} if light is None else {"location": light.location, "target": light.target}


def _told_lit(view: LightingArrangerView) -> set[str]:
    """Return the names of the lights of lamps that the story has lit."""
    lit = {asset_id for asset_id, burns in view.told.items() if burns}
    placed = view.layout.objects if view.layout is not None else ()
    names = lit | {item.node_id for item in placed if item.asset_id in lit}
    return {f"{name}_light" for name in names}


def _carried(shot: ShotContext, lamps: Collection[str], view: LightingArrangerView) -> Iterator[tuple[str, Carried]]:
    """Yield where the lamps that have left their places are at the end of a shot, and where they point."""
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
            aim = _place_of(aims.get(mark.asset_id), ends, view)
            if aim is None or math.dist(aim[:2], (x, y)) < _REACH:
                aim = x + _BEAM * ahead[0], y + _BEAM * ahead[1], z + _BEAM_END
            else:
                way = math.dist(aim[:2], (x, y))
                ahead = (aim[0] - x) / way, (aim[1] - y) / way
            place = x + _REACH * ahead[0], y + _REACH * ahead[1], z + _HAND.get(mark.posture, _STANDING)
            yield state.asset_id, Carried(_rounded(place), _rounded(aim))
        elif state.location is not None:
            yield state.asset_id, Carried(state.location, None)


def _place_of(name: str | None, people: Mapping[str, Mark], view: LightingArrangerView) -> Vec3 | None:
    """Return the middle of a person, a thing or a part of the set."""
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


def _modification(asset_id: str, state: str) -> AssetModification:
    return AssetModification(
        asset_id=asset_id, modification_type="transform", description=f"goes {state} with the light", state=state
    )
