"""Text-to-image prompts of the things that no source has: by rules, by a model, in the graph and in the lists."""

from __future__ import annotations

import csv
import json
from functools import cache
from pathlib import Path

import pytest
from tests.answering import Alike, Scripted
from tests.crew import RULES
from tests.stand_in_engine import StandInEngine

from storyblender.agents.concept_artist.image_prompt import ImagePromptView, RulesImagePrompts, image_prompt_view
from storyblender.agents.concept_artist.language_image_prompt import language_image_prompts
from storyblender.deliver.asset_list import ASSETS_FILE
from storyblender.history_files import load
from storyblender.memory.asset_sheet import PROMPT_LENGTH, Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.project import read_project_graph
from storyblender.reflection import reflect
from storyblender.settings import Settings
from storyblender.studio import Studio

ORRERY = Asset(asset_id="orrery", asset_type="object", name="orrery", description="a brass orrery")
SIGN = Asset(asset_id="sign", asset_type="object", name="sign", description="", writing="KEEP  OUT")
VIEW = ImagePromptView((ORRERY, SIGN), title="The Heavens", age="victorian")


@pytest.mark.parametrize("told", ["a brass orrery", "", "x" * 3000])
def test_rules_say_what_it_is_and_what_every_picture_has_to_have(told: str) -> None:
    thing = ORRERY.model_copy(update={"description": told})
    prompt = RulesImagePrompts().propose(ImagePromptView((thing,), age="victorian"))["orrery"]
    assert "orrery" in prompt and len(prompt) <= PROMPT_LENGTH
    if len(told) < 100:
        for needed in ("single", "whole object", "hree-quarter", "white background", "nineteenth century", "no people"):
            assert needed in prompt
        assert prompt.lower().count("orrery") == 1


def test_only_the_words_that_are_on_a_thing_may_be_read_on_it() -> None:
    prompts = RulesImagePrompts().propose(VIEW)
    assert "“KEEP OUT”" in prompts["sign"] and "No writing" in prompts["orrery"]


def test_a_model_says_what_a_thing_looks_like_and_code_adds_the_rest() -> None:
    looks = "An orrery of turned brass:\n seven small planets on curved arms above a round oak base."
    wrong = json.dumps({"things": [{"id": "globe", "looks": looks}]})
    right = json.dumps({"things": [{"id": "orrery", "looks": looks, "view": "side"}]})
    model = Scripted([wrong, right])
    policy = language_image_prompts(model, cache(Alike))
    prompts = policy.propose(VIEW)
    assert "'globe' is not in `things`" in model.asked[1].feedback[0]
    assert "brass: seven small planets" in prompts["orrery"] and "side view" in prompts["orrery"]
    assert "white background" in prompts["orrery"]
    assert prompts["sign"] == RulesImagePrompts().propose(VIEW)["sign"], "what is left out is described by rules"


def test_a_missing_prompt_is_written_by_rules() -> None:
    class Forgetful(RulesImagePrompts):
        def propose(self, view: ImagePromptView) -> dict[str, str]:
            return {}

    role = RULES.asset_generator
    said = role.critic.judge({}, VIEW)
    assert said.score < role.threshold and [fault.subject for fault in said.faults] == ["orrery", "sign"]
    assert reflect(role, "assets", VIEW).draft.keys() == {"orrery", "sign"}
    assert image_prompt_view(ContinuityMemoryGraph(), (ORRERY,)).assets == (ORRERY,)


SCRIPT = """INT. STUDY - NIGHT

ADA (30) sits at the table. A gramophone, a hectograph and a lamp stand on the table.

ADA
Copy this.
"""


def test_what_stands_in_has_a_prompt_in_graph_list_page_and_history(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    script, project = tmp_path / "a.fountain", tmp_path / "p"
    script.write_text(SCRIPT)
    Studio(Settings(width=160, look="fast", animatic=False)).make(script, project)
    graph = read_project_graph(project)
    prompts = {asset.asset_id: asset.image_prompt for asset in graph.assets if asset.image_prompt}
    assert prompts.keys() == {"hectograph"}, "the library has a table and a gramophone"
    rows = {row["asset"]: row for row in csv.DictReader((project / ASSETS_FILE).open(encoding="utf-8-sig"))}
    assert {"ada", "hectograph", "gramophone"} <= rows.keys()
    assert (rows["hectograph"]["stands_in"], rows["gramophone"]["stands_in"]) == ("yes", "")
    assert rows["hectograph"]["image_prompt"] == prompts["hectograph"] and rows["ada"]["scenes"] == "SC010"
    page = (project / "index.html").read_text()
    assert prompts["hectograph"] in page and ASSETS_FILE in page
    (project / "graph.json").unlink()
    assert load(project).graph == graph
