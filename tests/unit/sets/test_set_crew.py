"""Environment Designer, Set Dresser, Lighting Arranger: rules and critics."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from tests.crew import RULES
from tests.every import every

from storyblender.agents.director.lighting import light_change, light_qualities
from storyblender.agents.visual_effects_artist.environment_designer import (
    EnvironmentDesignerCritic,
    EnvironmentDesignerView,
    RulesEnvironmentDesigner,
)
from storyblender.agents.visual_effects_artist.furniture import prop_size
from storyblender.agents.visual_effects_artist.light_level import scale_lamps_to_level
from storyblender.agents.visual_effects_artist.lighting_arranger import (
    LightingArrangerView,
    RulesLightingArranger,
    light_place,
)
from storyblender.agents.visual_effects_artist.lighting_arranger_view import MOST_LIGHTS
from storyblender.agents.visual_effects_artist.set_dresser import RulesSetDresser, SetDresserCritic, SetDresserView
from storyblender.catalog.light_recipes import HOURS, LAMPS, WEATHERS, area_watts, open_sky_light, sun_position
from storyblender.catalog.sets import SETS, plan_of
from storyblender.look.illumination import light_field
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.scene_context import Environment, Light, Lighting, Relation, SceneSetup, Sky
from storyblender.memory.vocabulary import Age
from storyblender.reflection import reflect


def asset(name: str) -> Asset:
    return Asset(asset_id=name, asset_type="object", name=name.replace("_", " "), description=name)


# ---------------------------------------------------------------------- environment


def test_the_same_place_again_is_the_same_set() -> None:
    first = Environment(kit="bar", params={"width": 9.0}, seed=7)
    again = RulesEnvironmentDesigner().propose(EnvironmentDesignerView(SceneSetup(kit="bar"), reference=first))
    assert again == first


def test_more_people_and_longer_ways_get_a_larger_room() -> None:
    setup = SceneSetup(kit="office")
    few = RulesEnvironmentDesigner().propose(EnvironmentDesignerView(setup, people=2))
    many = RulesEnvironmentDesigner().propose(EnvironmentDesignerView(setup, people=14, travel=7.0))
    assert float(many.params["width"]) > float(few.params["width"]) + 1
    assert (
        EnvironmentDesignerCritic().judge(few, EnvironmentDesignerView(setup, people=14)).faults[0].kind == "too_small"
    )


def test_the_critics_fix_is_applied() -> None:
    view = EnvironmentDesignerView(SceneSetup(kit="office"), people=12)
    critic, designer = EnvironmentDesignerCritic(), RulesEnvironmentDesigner()
    small = Environment(kit="office")
    mended = designer.refine(small, critic.judge(small, view), view)
    assert not critic.judge(mended, view).faults


@pytest.mark.parametrize(
    ("kit", "age", "period"),
    [("living_room", "classic", None), ("kitchen", "victorian", "past"), ("archive", None, None)],
)
def test_the_age_of_a_story_furnishes_its_rooms(kit: str, age: Age | None, period: str | None) -> None:
    environment = RulesEnvironmentDesigner().propose(EnvironmentDesignerView(SceneSetup(kit=kit), age=age))
    assert (environment.kit, environment.params.get("period")) == (kit, period)


def test_a_story_of_today_has_modern_rooms_and_one_that_tells_no_age_its_usual_ones() -> None:
    for age, period in (("today", "modern"), (None, None)):
        room = RulesEnvironmentDesigner().propose(EnvironmentDesignerView(SceneSetup(kit="kitchen"), age=age))  # type: ignore[arg-type]
        assert room.params.get("period") == period


@every("kit", SETS)
def test_no_set_has_what_its_time_does_not_know(kit: str) -> None:
    unknown = {
        "past": {"fridge", "television", "telephone", "computer", "car", "pendant_lamp", "table_lamp", "radio"},
        "classic": {"computer", "laptop", "microwave", "security_camera"},
    }
    for period, things in unknown.items():
        plan = plan_of(Environment(kit=kit, params={"period": period}, seed=2))
        its_own = {kit}
        assert not (things - its_own) & {item.prop for item in plan.furnishings}


def test_the_options_of_a_scene_and_its_snow_are_parameters_of_the_set() -> None:
    setup = SceneSetup(scene_type="outdoor", kit="street", set_options=("frontier",), snow=True)
    street = RulesEnvironmentDesigner().propose(EnvironmentDesignerView(setup, age="west"))
    assert (street.params["frontier"], street.params["snow"]) == (True, True)
    parts = {piece.part for piece in plan_of(street).pieces}
    assert "false_front" in parts and "facade" not in parts
    plain = setup.model_copy(update={"set_options": (), "snow": False})
    town = RulesEnvironmentDesigner().propose(EnvironmentDesignerView(plain))
    assert not {"frontier", "snow"} & town.params.keys()


def yard(snow: bool, reference: Environment | None = None) -> Environment:
    setup = SceneSetup(place="YARD", kit="back_yard", scene_type="outdoor", snow=snow)
    return RulesEnvironmentDesigner().propose(EnvironmentDesignerView(setup, reference=reference))


def test_snow_covers_the_ground_and_what_grows_until_it_thaws() -> None:
    white = yard(snow=True)
    plan = plan_of(white)
    assert {slab.material for slab in plan.slabs} == {"snow"}
    assert not {piece.part for piece in plan.pieces} & {"grass_tuft", "flowers"}
    assert all(piece.params["snow"] for piece in plan.pieces if piece.part in ("hedge", "broad_tree"))
    thawed = yard(snow=False, reference=white)
    assert "snow" not in thawed.params and yard(snow=True, reference=thawed) == white


def test_snow_is_seen_from_a_room_and_not_in_it() -> None:
    view = EnvironmentDesignerView(SceneSetup(kit="kitchen", snow=True))
    plan = plan_of(RulesEnvironmentDesigner().propose(view))
    assert {slab.material for slab in plan.slabs if slab.z < 0} == {"snow"}
    assert "snow" not in {slab.material for slab in plan.slabs if slab.z >= 0}


# ---------------------------------------------------------------------- dressing


def cafe(*objects: str, relations: tuple[Relation, ...] = (), people: int = 2) -> SetDresserView:
    setup = SceneSetup(place="CAFE", relations=relations)
    return SetDresserView(
        setup, plan_of(Environment(kit="cafe", seed=1)), tuple(asset(name) for name in objects), people
    )


def test_the_scripts_piano_takes_the_kits_place() -> None:
    view = cafe("piano", "gun")
    planned = next(item for item in view.plan.furnishings if item.prop == "piano")
    dressing = RulesSetDresser().propose(view)
    piano = next(item for item in dressing.objects if item.node_id == "piano")
    assert math.dist(piano.location, planned.location) < 0.2
    assert piano.fixed
    assert planned.node_id not in {item.node_id for item in dressing.objects}
    assert dressing.pending == ("gun",)


def test_what_stands_on_something_waits_for_the_planner() -> None:
    relation = Relation(asset_id="table_lamp", kind="on", anchor_asset_id="table")
    dressing = RulesSetDresser().propose(cafe("table_lamp", "table", relations=(relation,)))
    assert dressing.pending == ("table_lamp",)


def test_a_lantern_of_paper_hangs_where_a_lamp_hung() -> None:
    view = SetDresserView(SceneSetup(), plan_of(Environment(kit="bar", seed=1)), (asset("paper_lantern"),))
    dressing = RulesSetDresser().propose(view)
    assert next(item for item in dressing.objects if item.node_id == "paper_lantern").location[2] > 1.8
    assert "paper_lantern" not in dressing.pending


def test_a_chair_goes_to_its_table() -> None:
    relation = Relation(asset_id="chair", kind="next_to", anchor_asset_id="table")
    dressing = RulesSetDresser().propose(cafe("chair", "table", relations=(relation,)))
    places = {item.node_id: item.location for item in dressing.objects}
    assert math.dist(places["chair"], places["table"]) < 1.5


def test_dressing_is_shared_between_scenes() -> None:
    ids = []
    for kit in ("cafe", "bar"):
        plan = plan_of(Environment(kit=kit))
        dressing = RulesSetDresser().propose(SetDresserView(SceneSetup(), plan))
        ids.append({item.asset_id: item for item in dressing.assets})
    assert ids[0]["set_chair"] == ids[1]["set_chair"]
    assert all(item.origin == "dressing" for item in ids[0].values())


@every("kit", SETS)
def test_every_kit_is_dressed_without_faults(kit: str) -> None:
    view = SetDresserView(SceneSetup(), plan_of(Environment(kit=kit, seed=5)))
    assert not SetDresserCritic().judge(RulesSetDresser().propose(view), view).faults


def test_a_crowd_pushes_the_dressing_out() -> None:
    few, many = (RulesSetDresser().propose(cafe(people=people)) for people in (2, 20))
    assert len(many.objects) < len(few.objects)


# ---------------------------------------------------------------------- light


def test_area_watts_give_the_wanted_level() -> None:
    lamp = Light(name="a", kind="AREA", location=(0, 0, 2), target=(0, 0, 0), power=area_watts(0.4, 2, 1.2), size=1.2)
    field = light_field(lamp, np.zeros((1, 1, 3), np.float32), np.array([[[0, 0, 1]]], np.float32))
    assert float(field.amount[0, 0]) == pytest.approx(0.4, rel=0.02)


def test_an_even_sky_lights_with_its_own_luminance() -> None:
    gray = (0.5, 0.5, 0.5)
    assert open_sky_light(Sky(zenith=gray, horizon=gray, ground=gray)) == pytest.approx(gray, rel=0.01)


def test_the_sun_stands_where_it_is_told() -> None:
    assert sun_position(90, 0)[2] == pytest.approx(50)
    assert sun_position(0, 0) == pytest.approx((0, -50, 0), abs=1e-9)
    assert sun_position(0, 90) == pytest.approx((-50, 0, 0), abs=1e-9)


def lighting_of(kit: str, time: str, weather: str = "clear", words: str = ""):
    where = "indoor" if SETS[kit].indoor else "outdoor"
    setup = SceneSetup(scene_type=where, time_of_day=time, weather=weather, light=light_qualities(words))  # type: ignore[arg-type]
    environment = Environment(kit=kit, seed=1)
    return LightingArrangerView(setup, plan_of(environment), environment)


@every("kit time weather", product(("cafe", "interrogation", "street", "forest"), HOURS, WEATHERS))
def test_every_hour_and_weather_passes_the_critic(kit: str, time: str, weather: str) -> None:
    view = lighting_of(kit, time, weather)
    outcome = reflect(RULES.lighting_arranger, kit, view)
    assert outcome.accepted
    assert len(outcome.draft.lights) <= MOST_LIGHTS


def test_day_has_a_sun_and_night_has_lamps() -> None:
    day, night = (RulesLightingArranger().propose(lighting_of("street", time)) for time in ("day", "night"))
    assert {light.role for light in day.lights} == {"sun"}
    assert sum(light.role == "practical" for light in night.lights) > 3
    assert day.sky.horizon > night.sky.horizon
    assert day.set_luminance > 2 * night.set_luminance


def test_rain_and_fog_are_in_the_air() -> None:
    rain = RulesLightingArranger().propose(lighting_of("street", "day", "rain"))
    fog = RulesLightingArranger().propose(lighting_of("street", "day", "fog"))
    assert rain.rain > 0.5
    assert fog.fog is not None and rain.fog is not None and fog.fog.density > 2 * rain.fog.density


def test_the_lights_go_out_and_come_back() -> None:
    view, arranger = lighting_of("cafe", "night"), RulesLightingArranger()
    lit = arranger.propose(view)
    dark = arranger.propose(replace(view, current=lit, change=light_change("Suddenly the lights go out.")))
    assert dark.set_luminance < lit.set_luminance / 2
    assert not any(light.role == "practical" for light in dark.lights)
    assert arranger.propose(replace(view, current=dark, change=light_change("The lamps flicker back on."))) == lit


def test_words_that_change_no_light_change_nothing() -> None:
    view, arranger = lighting_of("office", "day"), RulesLightingArranger()
    lit = arranger.propose(view)
    assert arranger.propose(replace(view, current=lit, change=light_change("He signs the letter."))) is lit


def test_the_sun_goes_down_over_a_scene() -> None:
    view, arranger = lighting_of("beach", "day"), RulesLightingArranger()
    day, change = arranger.propose(view), light_change("The sun sets.")
    assert arranger.propose(replace(view, current=day, change=change)) != day


@pytest.mark.parametrize(
    ("kit", "words"),
    [("cafe", "warm lamps, deep shadows, dark windows"), ("street", "moonlight and a few warm lamps in the dark")],
)
def test_a_night_with_its_lamps_lit_can_be_read(kit: str, words: str) -> None:
    plain, described = (RulesLightingArranger().propose(lighting_of(kit, "night", words=text)) for text in ("", words))
    assert described.set_luminance == plain.set_luminance >= 0.05


def test_fog_glows_at_night() -> None:
    fog, clear = (RulesLightingArranger().propose(lighting_of("airfield", "night", air)) for air in ("fog", "clear"))
    assert fog.fog and fog.fog.color[2] > fog.fog.color[0] > 0.07
    assert fog.ambient[2] > 1.15 * clear.ambient[2], "a clear night is lit enough to be read, and fog more"


def test_a_dim_room_is_darker() -> None:
    plain, dim = (
        RulesLightingArranger().propose(lighting_of("bar", "night", words=words)) for words in ("", "dimly lit")
    )
    assert dim.set_luminance < plain.set_luminance


def test_every_lamp_prop_of_the_plan_burns_at_night() -> None:
    plan = plan_of(Environment(kit="interrogation"))
    lighting = light_place(SceneSetup(time_of_day="night"), plan, Environment(kit="interrogation"))
    lamp = next(item for item in plan.furnishings if item.prop == "pendant_lamp")
    light = next(light for light in lighting.lights if light.name == f"{lamp.node_id}_light")
    assert math.dist(light.location[:2], lamp.location[:2]) < 0.2
    assert lamp.location[2] - 0.2 < light.location[2] < lamp.location[2] + 0.3


def test_lamps_that_burn_on_a_rainy_day_do_not_light_the_place() -> None:
    plan = plan_of(Environment(kit="park"))

    def lamps(hour: str, weather: str) -> float:
        setup = SceneSetup(scene_type="outdoor", time_of_day=hour, weather=weather)  # type: ignore[arg-type]
        lighting = light_place(setup, plan, Environment(kit="park"))
        return max((light.power for light in lighting.lights if light.role == "practical"), default=0.0)

    assert 0 < lamps("noon", "rain") < 0.5 * lamps("night", "clear")


def test_a_lamp_that_is_raised_for_a_whole_park_does_not_drown_it_in_its_halo() -> None:
    setup = SceneSetup(scene_type="outdoor", time_of_day="night")
    plan = plan_of(Environment(kit="park"))
    lamps = [light for light in light_place(setup, plan, Environment(kit="park")).lights if light.role == "practical"]
    recipe = LAMPS["lamppost"]
    for lamp in lamps:
        raised = lamp.power / recipe.watts
        assert raised > 3
        assert 1.0 < lamp.glow * lamp.power / (recipe.glow * recipe.watts) < 0.6 * raised


def test_a_camp_fire_does_not_burn_out_who_sits_at_it() -> None:
    plan = plan_of(Environment(kit="open_ground"))
    fire = Light(
        name="campfire_light", kind="POINT", role="practical", location=(0.9, 1.5, 0.8), target=(0.9, 1.5, 0), power=60
    )
    sky = Sky(zenith=(0.01, 0.01, 0.02), horizon=(0.02, 0.03, 0.05), ground=(0.01, 0.01, 0.01))
    lit = scale_lamps_to_level(Lighting(lights=(fire,), sky=sky, set_luminance=0.05), plan, all_lights=False)
    assert fire.power < lit.lights[0].power < 300


def test_the_lighthouse_of_a_beach_stands_far_off() -> None:
    plan = plan_of(Environment(kit="beach", params={"lighthouse": True}))
    towers = [piece.location for piece in plan.pieces if piece.part == "lighthouse"]
    assert [math.hypot(*location[:2]) > 40 for location in towers] == [True]  # or a wide picture cuts its 19 m off


def test_the_place_itself_is_not_put_on_the_stage() -> None:
    setup = SceneSetup(scene_type="outdoor", place="harbour", scenery=("pier",))
    view = SetDresserView(setup, plan_of(Environment(kit="dock", seed=1)), (asset("pier"), asset("gun")))
    assert RulesSetDresser().propose(view).pending == ("gun",)


@pytest.mark.parametrize("relation", [None, "at", "on"])
def test_a_boat_lies_in_the_water_beside_the_quay(relation: str | None) -> None:
    plan = plan_of(Environment(kit="dock", seed=1))
    water = next(slab for slab in plan.slabs if slab.material == "water_deep")
    relations = (Relation(asset_id="boat", kind=relation, anchor_asset_id="pier"),) if relation else ()  # type: ignore[arg-type]
    setup = SceneSetup(scene_type="outdoor", place="harbour", relations=relations, scenery=("pier",))
    dressing = RulesSetDresser().propose(SetDresserView(setup, plan, (asset("boat"), asset("pier"))))
    boat = next(item for item in dressing.objects if item.node_id == "boat")
    assert boat.fixed and water.z - 0.1 < boat.location[2] < water.z
    side = boat.location[1] - prop_size("rowing_boat", {})[0] / 2
    assert min(y for _, y in water.polygon) < side < plan.size.y + 0.3, "beside the quay, and a step from it"


def test_what_is_called_like_a_piece_of_the_set_and_is_no_prop_is_that_piece() -> None:
    plan = plan_of(Environment(kit="airfield", seed=1))
    tower = asset("control_tower").model_copy(update={"kind": ""})
    rock = asset("rock").model_copy(update={"kind": "rock"})
    assert "control_tower" in {piece.part for piece in plan.pieces}
    assert RulesSetDresser().propose(SetDresserView(SceneSetup(), plan, (tower, rock))).pending == ("rock",)


@pytest.mark.parametrize(("kit", "name"), [("square", "fountain"), ("ballroom", "chandelier")])
def test_what_the_set_is_furnished_with_is_the_scripts_own(kit: str, name: str) -> None:
    view = SetDresserView(SceneSetup(scenery=(name,)), plan_of(Environment(kit=kit, seed=1)), (asset(name),))
    dressing = RulesSetDresser().propose(view)
    assert name in {item.node_id for item in dressing.objects} and not dressing.pending


def test_the_scripts_fountain_is_the_one_on_the_square() -> None:
    setup = SceneSetup(scene_type="outdoor", place="market square")
    view = SetDresserView(setup, plan_of(Environment(kit="square", seed=1)), (asset("fountain"),))
    dressing = RulesSetDresser().propose(view)
    assert [item.node_id for item in dressing.objects if "fountain" in item.node_id] == ["fountain"]


def test_what_the_set_has_takes_nothing_elses_place() -> None:
    plan = plan_of(Environment(kit="courtroom"))
    setup = SceneSetup(place="COURT", scenery=("bench",))
    dressing = RulesSetDresser().propose(SetDresserView(setup, plan, (asset("bench"),)))
    assert "bench" not in {*dressing.pending, *(item.node_id for item in dressing.objects)}


def test_who_sits_on_the_bed_of_a_tent_has_the_canvas_above_the_head() -> None:
    for size in ({}, {"width": 5.0, "height": 2.6}):
        plan = plan_of(Environment(kit="tent", params=size))
        bed = next(item for item in plan.furnishings if item.prop == "bed")
        slope = next(piece for piece in plan.pieces if piece.part == "roof_slope")
        inwards = abs(abs(slope.location[0]) - abs(bed.location[0])) / float(slope.params["run"])
        assert float(slope.params["eave"]) + inwards * float(slope.params["rise"]) > 1.75


def test_the_bar_and_the_counter_of_a_saloon_are_one() -> None:
    plan = plan_of(Environment(kit="bar"))
    both = SetDresserView(SceneSetup(place="SALOON"), plan, (asset("bar"), asset("counter")))
    dressing = RulesSetDresser().propose(both)
    assert {"bar", "counter"} & {*dressing.pending, *(item.node_id for item in dressing.objects)} == {"bar"}


def test_houses_that_are_seen_from_a_room_do_not_stand_in_it() -> None:
    plan = plan_of(Environment(kit="living_room"))
    view = SetDresserView(SceneSetup(place="LOUNGE"), plan, (asset("house"), asset("radio"), asset("crate")))
    dressing = RulesSetDresser().propose(view)
    assert "house" not in {*dressing.pending, *(item.node_id for item in dressing.objects)}
    assert "crate" in {*dressing.pending, *(item.node_id for item in dressing.objects)}


def test_a_small_place_stays_small_for_the_things_in_it() -> None:
    view = EnvironmentDesignerView(SceneSetup(kit="closet"), footprints=((0.9, 0.3), (0.3, 0.3)))
    plan = plan_of(RulesEnvironmentDesigner().propose(view))
    assert plan.size.x - plan.size.x_negative < 2.6
