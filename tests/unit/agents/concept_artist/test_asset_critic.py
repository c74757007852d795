"""A vision critic of assets: it looks at likenesses and stand-ins, and what it refuses is not taken."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import pytest
from tests.answering import Answering, Scripted
from tests.model_files import tile
from tests.unit.agents.concept_artist.test_language_asset_retriever import Hashed

from storyblender.agents.concept_artist.asset_critic import with_asset_critic
from storyblender.agents.concept_artist.asset_retriever_view import AssetRetrieverView
from storyblender.agents.concept_artist.language_asset_retriever import language_asset_retriever
from storyblender.catalog.recipe import AssetQuery, Recipe
from storyblender.crew import rules_crew
from storyblender.errors import NoAnswer
from storyblender.folder import Folder
from storyblender.library.built_in import BuiltInLibrary
from storyblender.memory.asset_sheet import Asset, Provenance
from storyblender.memory.measure import AssetViews
from storyblender.ports import Answerer
from storyblender.reflection import Outcome, reflect
from storyblender.settings import Settings

SOURCES = (BuiltInLibrary(Hashed),)
POOR = {"score": 2, "faults": [{"message": "it is an animal", "operations": ["take_another"]}]}
GOOD = {"score": 9}
CHOICE = '{"choice": 2, "fit": 7}'


class Camera:
    """Draws assets, and notes which."""

    def __init__(self) -> None:
        self.drawn: list[str] = []

    def __call__(self, asset: Asset) -> AssetViews:
        assert asset.canonical is not None
        self.drawn.append(asset.canonical.key)
        return AssetViews(
            digest=asset.canonical.key, dimensions=(1, 1, 1), pictures={"portrait": tile(len(self.drawn))}
        )


def found(
    critic: Answerer, name: str, camera: Callable[[Asset], AssetViews], retriever: Answerer | None = None
) -> Outcome[AssetRetrieverView, Recipe]:
    role = rules_crew(Settings(), Hashed, SOURCES).asset_retriever
    if retriever is not None:
        role = replace(role, policies=(language_asset_retriever(retriever, Hashed, SOURCES), *role.policies))
    asset = Asset(asset_id=name, asset_type="object", description="", name=name, tags=("prop",))
    return reflect(with_asset_critic(critic, role), name, AssetRetrieverView(asset=asset, draw=camera))


def test_what_has_the_name_is_not_looked_at() -> None:
    camera = Camera()
    assert found(Scripted([]), "chair", camera).draft.key == "chair"
    assert camera.drawn == []


def test_a_likeness_that_looks_right_stays() -> None:
    camera = Camera()
    critic = Answering(lambda view: GOOD)
    outcome = found(critic, "bat", camera, Scripted([CHOICE]))
    assert [outcome.draft.key] == camera.drawn
    assert any("asset_critic gives 9" in remark for remark in outcome.critique.remarks)
    (picture,) = critic.asked[0].pictures
    assert picture.drawn_from
    assert outcome.draft.key not in critic.asked[0].view, "it is not told what it sees"


def test_what_is_refused_is_not_offered_again_and_the_retriever_hears_why() -> None:
    camera = Camera()
    retriever = Scripted(['{"choice": 2, "fit": 8}', '{"choice": 2, "fit": 8}'])
    critic = Answering(lambda view: POOR if len(camera.drawn) == 1 else GOOD)
    outcome = found(critic, "bat", camera, retriever)
    first, second = camera.drawn
    assert outcome.draft.key == second != first
    view: dict[str, Any] = json.loads(retriever.asked[1].view)
    assert view["refused"] == [{"model": first, "because": "it is an animal"}]
    assert "refused" not in json.loads(retriever.asked[0].view)


def test_after_a_refusal_what_was_found_under_other_words_is_offered_still() -> None:
    camera = Camera()
    retriever = Scripted(['{"keywords": "crow"}', '{"choice": 2, "fit": 8}', '{"choice": 1, "fit": 8}'])
    outcome = found(Answering(lambda view: POOR if len(camera.drawn) == 1 else GOOD), "bat", camera, retriever)
    assert outcome.draft.key == "crow"
    assert json.loads(retriever.asked[2].view)["also_searched_for"] == "crow"


def test_after_a_refusal_the_thing_of_that_name_is_looked_at_as_well() -> None:
    """The model took another thing than a baseball bat on purpose."""
    camera = Camera()
    found(Answering(lambda view: POOR), "bat", camera, Answering(lambda view: {"choice": 2, "fit": 7}))
    assert "bat" in camera.drawn


def test_where_everything_is_refused_a_plain_shape_stands_in() -> None:
    camera = Camera()
    plain = {"score": 1, "faults": [{"message": "it is an animal", "operations": ["take_plain_shape"]}]}
    assert found(Answering(lambda view: plain), "frobnicator", camera).draft.source == "stand_in"


def test_a_poor_likeness_is_kept_before_a_plain_shape() -> None:
    fair = {"score": 5, "faults": [{"message": "it is too thin", "operations": ["take_another"]}]}
    camera = Camera()
    draft = found(Answering(lambda view: fair), "bat", camera, Scripted([CHOICE, NoAnswer("gone")])).draft
    assert draft.key == camera.drawn[0]


@pytest.mark.parametrize("name", ["bat", "frobnicator", "chair"])
def test_a_silent_critic_or_no_picture_leaves_all_as_it_was(name: str) -> None:
    def cannot(asset: Asset) -> AssetViews:
        raise NoAnswer("it cannot be drawn")

    class Silent:
        def answer(self, request: object) -> str:
            raise NoAnswer("gone")

    role = rules_crew(Settings(), Hashed, SOURCES).asset_retriever
    asset = Asset(asset_id=name, asset_type="object", description="", name=name, tags=("prop",))
    usual = reflect(replace(role, horizon=3), name, AssetRetrieverView(asset=asset)).draft
    for critic, camera in ((Silent(), Camera()), (Scripted([]), cannot)):
        draft = found(critic, name, camera).draft
        assert draft.source == usual.source or draft.score >= usual.score


class Shop:
    """Offers one model under the name of whatever is looked for."""

    def __init__(self, name: str) -> None:
        self.name = name

    def search(self, query: AssetQuery, *, by_meaning: bool = False) -> Sequence[Recipe]:
        place = Provenance(source=self.name, file="a.glb")
        return [Recipe(source="file", key=f"{self.name}/a.glb", score=10.0, reason="", provenance=place)]

    def inventory(self) -> Mapping[str, str]:
        return {}

    def fetch(self, recipe: Recipe, files: Folder) -> Recipe:
        return recipe


@pytest.mark.parametrize(("name", "looks"), [("sketchfab", 1), ("library", 1), ("models", 0)])
def test_a_name_that_somebody_else_gave_is_not_believed(name: str, looks: int) -> None:
    camera = Camera()
    role = rules_crew(Settings(), Hashed, (Shop(name), *SOURCES)).asset_retriever
    asset = Asset(asset_id="chair", asset_type="object", description="", name="chair", tags=("prop",))
    view = AssetRetrieverView(asset=asset, draw=camera)
    assert reflect(with_asset_critic(Answering(lambda view: GOOD), role), "chair", view).draft.key == f"{name}/a.glb"
    assert len(camera.drawn) == looks
    camera = Camera()
    critic = with_asset_critic(Answering(lambda view: POOR if len(camera.drawn) == 1 else GOOD), role)
    draft = reflect(critic, "chair", view.model_copy(update={"draw": camera})).draft
    assert draft.key == ("chair" if looks else f"{name}/a.glb")
