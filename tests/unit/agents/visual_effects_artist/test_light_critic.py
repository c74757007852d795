"""The vision critic of light: it looks at shots in the proposed light, and code does what it names."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any, get_args

import pytest
from tests.answering import Scripted
from tests.crew import RULES

from storyblender.agents.visual_effects_artist.light_critic import with_light_critic
from storyblender.agents.visual_effects_artist.light_operations import LightOperation, after_operations
from storyblender.agents.visual_effects_artist.lighting_arranger import RulesLightingArranger
from storyblender.agents.visual_effects_artist.lighting_arranger_view import LightingArrangerView
from storyblender.catalog.sets import plan_of
from storyblender.memory.base import content_hash
from storyblender.memory.request import Picture
from storyblender.memory.scene_context import Environment, Lighting, SceneSetup
from storyblender.reflection import SEEN, Fault, Role, reflect, view_digest


def _draw(plan: Lighting) -> tuple[Picture, ...]:
    return (Picture(name="shot_1", png=b"", drawn_from=content_hash(plan)),)


CAFE = plan_of(Environment(kit="cafe"))
SETUP = SceneSetup(scene_type="indoor", time_of_day="night", kit="cafe", place="INT. CAFE - NIGHT")
VIEW = LightingArrangerView(SETUP, CAFE, Environment(kit="cafe"), draw=_draw)
PLAN = RulesLightingArranger().propose(VIEW)


def said(score: float, *faults: dict[str, Any]) -> str:
    return json.dumps({"score": score, "faults": faults})


def fault(*operations: str, subject: str = "") -> Fault:
    return Fault(kind=SEEN, message="it is wrong", subject=subject, fix={"ops": " ".join(operations)})


def judged(answers: list[str], view: LightingArrangerView = VIEW) -> tuple[Any, Scripted]:
    critic = Scripted(answers)
    role: Role[..., LightingArrangerView, Lighting] = with_light_critic(critic, RULES.lighting_arranger)
    return reflect(role, "SC010", view), critic


def test_what_it_names_is_done_by_code_and_drawn_again_until_it_is_content() -> None:
    outcome, critic = judged([
        said(5, {"message": "a friendly place", "operations": ["set_darker", "cooler"]}),
        said(6, {"message": "still too friendly", "operations": ["set_darker"]}),
        said(8.5),
    ])  # fmt: skip
    assert outcome.turns == 2 and outcome.critique.score == 8.5
    assert outcome.draft.set_luminance == pytest.approx(PLAN.set_luminance / 4, abs=2e-4)
    assert outcome.draft.key_color[0] / outcome.draft.key_color[2] < PLAN.key_color[0] / PLAN.key_color[2]
    first, second, third = critic.asked
    assert first.role == "light_critic" and first.pictures_needed
    assert len({request.pictures[0].digest for request in (first, second, third)}) == 3, "each light is drawn anew"


def test_after_five_turns_the_best_plan_is_kept() -> None:
    scores = [4, 7, 5, 3, 3, 3]
    worse = [said(score, {"message": "no", "operations": ["faces_lighter"]}) for score in scores]
    outcome, critic = judged(worse)
    assert len(critic.asked) == 6 and outcome.critique.score == 7
    assert outcome.draft == after_operations(PLAN, [fault("faces_lighter")])


def test_what_cannot_be_drawn_is_left_to_the_rules() -> None:
    outcome, critic = judged([], LightingArrangerView(SETUP, CAFE, Environment(kit="cafe")))
    assert outcome.draft == PLAN and not critic.asked
    assert "light_critic is not heard" in outcome.critique.remarks[0]


def test_a_light_that_does_not_exist_is_asked_for_again() -> None:
    wrong = said(6, {"message": "too dim", "subject": "moon_lamp", "operations": ["lamp_brighter"]})
    _, critic = judged([wrong, said(9)])
    assert "there is no id 'moon_lamp'" in critic.asked[1].feedback[0]


def test_pictures_are_no_part_of_what_a_plan_is_known_by() -> None:
    assert view_digest(VIEW) == view_digest(LightingArrangerView(SETUP, CAFE, Environment(kit="cafe")))


@pytest.mark.parametrize("operation", get_args(LightOperation))
def test_every_operation_changes_the_plan_and_no_plan_becomes_unusable(operation: str) -> None:
    plan = PLAN
    for _ in range(8):
        plan = after_operations(plan, [fault(operation)])
    assert plan != PLAN
    lit = RulesLightingArranger().refine(plan, RULES.lighting_arranger.critic.judge(plan, VIEW), VIEW)
    assert RULES.lighting_arranger.critic.judge(lit, VIEW).score >= 8


@pytest.mark.parametrize(
    ("there", "back"),
    [("set_darker", "set_lighter"), ("faces_lighter", "faces_darker"), ("warmer", "cooler"),
     ("more_contrast", "less_contrast"), ("lamp_dimmer", "lamp_brighter")],
)  # fmt: skip
def test_an_operation_and_its_opposite_leave_the_plan_as_it_was(there: str, back: str) -> None:
    after = after_operations(PLAN, [fault(there), fault(back)])
    for level in ("set_luminance", "face_luminance", "key_fill_ratio"):
        assert getattr(after, level) == pytest.approx(getattr(PLAN, level), rel=0.01)
    for one, other in zip(after.lights, PLAN.lights, strict=True):
        assert one.power == pytest.approx(other.power, rel=0.01)
        assert one.color == pytest.approx(other.color, abs=0.01)


def test_a_lamp_is_changed_by_its_name_once_however_often_it_is_named() -> None:
    name = next(light.name for light in PLAN.lights if light.role == "practical")
    after = after_operations(PLAN, [fault("lamp_brighter", subject=name), fault("lamp_brighter", subject=name)])
    gains = {new.name: new.power / old.power for new, old in zip(after.lights, PLAN.lights, strict=True)}
    assert gains.pop(name) == pytest.approx(2, rel=0.01) and set(gains.values()) <= {1.0}
    assert after_operations(after, [replace_ops(fault(), "fly away")]) == after, "only the closed list counts"


def replace_ops(given: Fault, operations: str) -> Fault:
    return given.model_copy(update={"fix": {"ops": operations}})


def test_a_view_is_drawn_where_other_views_of_it_are_made() -> None:
    assert replace(VIEW, burning={"lamp": True}).draw is _draw
