"""The plan of a layout, and the vision critic who looks at it beside the one who measures."""

from __future__ import annotations

import io
import json
from dataclasses import replace
from typing import Any

from PIL import Image
from tests.answering import Alike, Scripted
from tests.crew import RULES
from tests.unit.agents.layout_artist.test_spatial_planner import view_of

from storyblender.agents.layout_artist.language_spatial_planner import language_spatial_planner
from storyblender.agents.layout_artist.layout_critic import with_layout_critic
from storyblender.agents.layout_artist.plan_picture import plan_picture
from storyblender.agents.layout_artist.room_steps import ROOM_STEPS, find_fitting_room
from storyblender.agents.layout_artist.spatial_planner import RulesSpatialPlanner
from storyblender.errors import NoAnswer
from storyblender.reflection import reflect

VIEW = view_of(["table", "jewel_box"], [("jewel_box", "on", "table")], ["ana", "ben"], groups=(("ana", "ben"),))


def said(score: float, *faults: dict[str, Any]) -> str:
    return json.dumps({"score": score, "faults": faults})


def test_the_plan_shows_people_things_and_walls() -> None:
    layout = RulesSpatialPlanner().propose(VIEW)
    picture = plan_picture(layout, VIEW)
    image = Image.open(io.BytesIO(picture.png)).convert("RGB")
    colors = {color for _, color in image.getcolors(1 << 16) or ()}
    assert {(0xF6, 0xC9, 0xB4), (0xCF, 0xE0, 0xF2), (0x4A, 0x4A, 0x4A)} <= colors
    assert plan_picture(layout, VIEW) == picture
    fewer = layout.model_copy(update={"objects": layout.objects[1:]})
    assert plan_picture(fewer, VIEW).digest != picture.digest


def test_a_plan_that_the_critic_likes_stays_as_the_rules_have_it() -> None:
    critic = Scripted([said(9)])
    outcome = reflect(with_layout_critic(critic, RULES.spatial_planner), "SC010", VIEW)
    assert outcome.draft == RulesSpatialPlanner().propose(VIEW)
    (asked,) = critic.asked
    assert (asked.role, asked.subject, [each.name for each in asked.pictures]) == ("layout_critic", "SC010", ["plan"])
    assert {"people", "things", "in_conversation"} <= json.loads(asked.view).keys()


def test_without_an_answer_the_measures_decide() -> None:
    critic = Scripted([NoAnswer("nobody", mend="")])
    outcome = reflect(with_layout_critic(critic, RULES.spatial_planner), "SC010", VIEW)
    assert outcome.critique.score == 10
    assert any("layout_critic" in remark for remark in outcome.critique.remarks)


def test_what_it_minds_goes_to_the_planner_with_the_plan() -> None:
    fault = {"message": "ana stands with her back to ben", "subject": "ana", "operations": ["turn_to_it"]}
    planner = Scripted([json.dumps({"places": []}), json.dumps({"places": [
        {"id": "ana", "relation": "next_to", "anchor": "table", "facing": "ben"}
    ]})])  # fmt: skip
    critic = Scripted([said(5, fault), said(9)])
    role = replace(RULES.spatial_planner, policies=(language_spatial_planner(planner, Alike),))
    reflect(with_layout_critic(critic, role), "SC010", VIEW)
    first, second = planner.asked
    assert first.pictures == ()
    assert [each.name for each in second.pictures] == ["plan"]
    assert second.feedback == ("ana stands with her back to ben (try turn_to_it)",)


def test_taste_asks_for_no_larger_set() -> None:
    role = with_layout_critic(Scripted([said(3, {"message": "dull"})] * 3), RULES.spatial_planner)
    tried: list[object] = []

    def stage(room: Any, faulty: Any) -> Any:
        tried.append(room)
        return room, reflect(role, "SC010", VIEW)

    find_fitting_room(stage)
    assert tried == [ROOM_STEPS[0]]
