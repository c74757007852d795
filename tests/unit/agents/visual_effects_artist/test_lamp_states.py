"""No lamp that is off, gone or cut off gives light; what is lit does, where it is."""

from __future__ import annotations

from dataclasses import replace

import pytest

from storyblender.agents.director.lighting import light_change
from storyblender.agents.visual_effects_artist.lamp_states import light_shots
from storyblender.agents.visual_effects_artist.lighting_arranger import LightingArrangerView, RulesLightingArranger
from storyblender.catalog.light_recipes import LAMPS
from storyblender.catalog.props import PROPS
from storyblender.catalog.sets import plan_of
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.scene_context import Environment, Layout, LayoutObject, Lighting, SceneSetup
from storyblender.memory.shot_context import (
    AssetModification,
    Blocking,
    CameraInstruction,
    Mark,
    PropState,
    ShotContext,
)
from storyblender.memory.thing_states import Condition
from storyblender.memory.vocabulary import ThingState

_KEYS = sorted(key for key in LAMPS if key in PROPS and PROPS[key].placement != "ceiling")


def _view(*keys: str) -> LightingArrangerView:
    environment = Environment(kit="living_room")
    plan = plan_of(environment)
    assets = tuple(
        Asset(
            asset_id=key, asset_type="object", description=key,
            canonical=CanonicalAsset(source="catalog", key=key, dimensions=PROPS[key].size, digest=key),
        )
        for key in keys
    )  # fmt: skip
    objects = tuple(
        LayoutObject(node_id=f"{key}_1", asset_id=key, location=(0.4 * index, 0.5, 0.0))
        for index, key in enumerate(keys)
    )
    setup = SceneSetup(scene_type="indoor", time_of_day="night")
    return LightingArrangerView(setup, plan, environment, Layout(scene_size=plan.size, objects=objects), assets)


def _shot(number: int, *changes: tuple[str, str], light: str | None = None, **fields: object) -> ShotContext:
    made = tuple(
        AssetModification(asset_id=name, modification_type="transform", state=state) for name, state in changes
    )
    told = {"asset_modifications": made, "light_change": light_change(light or ""), **fields}
    return ShotContext.model_validate(
        {"scene_id": 1, "shot_id": number, "camera_instruction": CameraInstruction(), **told}
    )


def _changed(current: Lighting, shot: ShotContext) -> Lighting:
    view = replace(_view("floor_lamp", "table_lamp"), current=current, change=shot.light_change)
    return RulesLightingArranger().propose(view)


def _plans(
    view: LightingArrangerView, *shots: ShotContext, **found: tuple[ThingState, ...]
) -> tuple[list[Lighting], list[ShotContext]]:
    usual = RulesLightingArranger().propose(view)
    conditions = {name: Condition(states=states) for name, states in found.items()}
    current, lit, _ = light_shots(usual, view, shots, conditions, _changed)
    plans: list[Lighting] = []
    for shot in lit:
        current = shot.lighting or current
        plans.append(current)
    return plans, list(lit)


def _names(plan: Lighting) -> set[str]:
    return {light.name for light in plan.lights}


@pytest.mark.parametrize("key", _KEYS)
def test_a_lamp_burns_from_the_shot_that_lights_it_to_the_one_that_puts_it_out(key: str) -> None:
    view = _view(key, "wall_lamp" if key != "wall_lamp" else "floor_lamp")
    plans, _ = _plans(view, _shot(1, (key, "off")), _shot(2), _shot(3, (key, "lit")), _shot(4, (key, "gone")))
    assert [f"{key}_1_light" in _names(plan) for plan in plans] == [False, False, True, False]


@pytest.mark.parametrize("key", _KEYS)
def test_a_lamp_in_a_hand_is_dark_until_it_is_lit(key: str) -> None:
    mark = Mark(asset_id="ann", location=(1.0, -1.0, 0.0), yaw=90.0)
    blocking = (Blocking(start=mark, end=mark),)
    held = (PropState(asset_id=key, held_by="ann", hand="R"),)
    plans, _ = _plans(
        _view(key),
        _shot(1, blocking=blocking, prop_states=held),
        _shot(2, (key, "lit"), blocking=blocking, prop_states=held),
    )
    assert [f"{key}_1_light" in _names(plan) for plan in plans] == [False, True]


@pytest.mark.parametrize("key", _KEYS)
def test_a_lamp_that_an_earlier_scene_put_out_is_dark(key: str) -> None:
    plans, _ = _plans(_view(key), _shot(1), **{key: ("off",)})
    assert f"{key}_1_light" not in _names(plans[0])


@pytest.mark.parametrize(("kind", "shines"), [("floor_lamp", True), ("chair", False), ("", False)])
def test_a_users_model_of_a_lamp_gives_light(kind: str, shines: bool) -> None:
    view = _view("floor_lamp")
    (lamp,) = view.assets
    model = CanonicalAsset(source="file", key="a.glb", dimensions=(0.4, 0.4, 1.6), digest="a")
    view = replace(view, assets=(lamp.model_copy(update={"kind": kind, "canonical": model}),))
    plans, _ = _plans(view, _shot(1))
    assert ("floor_lamp_1_light" in _names(plans[0])) == shines


def test_the_last_lamp_that_goes_out_leaves_the_room_dark() -> None:
    plans, _ = _plans(
        _view("floor_lamp", "table_lamp"), _shot(1), _shot(2, ("floor_lamp", "off")), _shot(3, ("table_lamp", "off"))
    )
    levels = [plan.set_luminance for plan in plans]
    assert levels[0] > levels[1] > levels[2]


def test_when_the_lights_go_out_every_lamp_does_and_comes_back_with_them() -> None:
    view = _view("floor_lamp", "table_lamp", "candle")
    plans, shots = _plans(
        view, _shot(1, ("candle", "lit")), _shot(2, light="off"), _shot(3), _shot(4, light="The lights come back on.")
    )
    for plan in plans[1:3]:
        burning = {light.name for light in plan.lights if light.role == "practical"}
        assert burning == {"candle_1_light"}, "a flame needs no power"
    assert plans[1].set_luminance < 0.5 * plans[0].set_luminance
    changed = [{(each.asset_id, each.state) for each in shot.asset_modifications} for shot in shots]
    assert {("floor_lamp", "off"), ("table_lamp", "off")} <= changed[1] and ("candle", "off") not in changed[1]
    assert {("floor_lamp", "on"), ("table_lamp", "on")} <= changed[3]
    assert {"floor_lamp_1_light", "table_lamp_1_light"} <= _names(plans[3])


def test_a_torch_shines_from_the_hand_that_holds_it_and_to_where_its_holder_looks() -> None:
    mark = Mark(asset_id="ann", location=(1.0, -1.0, 0.0), yaw=90.0)
    held = PropState(asset_id="flashlight", held_by="ann", hand="R")
    shot = _shot(1, light="off", blocking=(Blocking(start=mark, end=mark),), prop_states=(held,))
    plans, _ = _plans(_view("flashlight"), shot, _shot(2, ("flashlight", "off")))
    (beam,) = [light for light in plans[0].lights if light.name == "flashlight_1_light"]
    assert beam.kind == "SPOT" and beam.location[0] > 1.0 and beam.target[0] > beam.location[0]
    assert "flashlight_1_light" not in _names(plans[1])


def test_a_torch_that_nobody_holds_gives_no_light() -> None:
    plans, _ = _plans(_view("flashlight", "floor_lamp"), _shot(1))
    assert "flashlight_1_light" not in _names(plans[0])
