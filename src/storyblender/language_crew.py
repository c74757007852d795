"""The crew with language models: each role that is played by one asks it first, and hands over to its rules."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from typing import Any, Final

from pydantic import BaseModel

from storyblender.agents.asking import read_answer_as
from storyblender.agents.concept_artist.asset_critic import AssetCriticNotes, with_asset_critic
from storyblender.agents.concept_artist.language_asset_formatter import PoseNotes, language_asset_formatter
from storyblender.agents.concept_artist.language_asset_retriever import ChoiceNotes, language_asset_retriever
from storyblender.agents.concept_artist.language_image_prompt import ImagePromptNotes, language_image_prompts
from storyblender.agents.concept_artist.reference_picture import with_picture_critic
from storyblender.agents.director.annotation import SceneNotes
from storyblender.agents.director.director import RulesDirector, RulesShotDirector
from storyblender.agents.director.language_director import LanguageDirector
from storyblender.agents.director.language_shot_director import CutNotes, LanguageShotDirector
from storyblender.agents.instructor.instructor import Instruction
from storyblender.agents.instructor.language_instructor import language_instructor
from storyblender.agents.layout_artist.camera_critic import CameraCriticNotes, with_camera_critic
from storyblender.agents.layout_artist.language_camera_operator import CameraNotes, language_operator
from storyblender.agents.layout_artist.language_dimension_estimator import (
    DimensionNotes,
    language_dimension_estimator,
)
from storyblender.agents.layout_artist.language_spatial_planner import LayoutNotes, language_spatial_planner
from storyblender.agents.layout_artist.layout_critic import LayoutCriticNotes, with_layout_critic
from storyblender.agents.visual_effects_artist.language_animator import (
    StagingNotes,
    language_animator,
)
from storyblender.agents.visual_effects_artist.language_environment_designer import (
    SetNotes,
    language_environment_designer,
)
from storyblender.agents.visual_effects_artist.language_lighting_arranger import (
    LightNotes,
    language_lighting_arranger,
)
from storyblender.agents.visual_effects_artist.language_set_dresser import DressingNotes, language_set_dresser
from storyblender.agents.visual_effects_artist.light_critic import LightCriticNotes, with_light_critic
from storyblender.crew import Crew
from storyblender.crew_setting import RoleName
from storyblender.language.answer_folder import asked, is_unfinished
from storyblender.ports import Answerer, AssetSource, Embedder
from storyblender.reflection import Policy

ANSWERS: Final[Mapping[str, type[BaseModel]]] = {
    "asset_critic": AssetCriticNotes,
    "asset_formatter": PoseNotes,
    "asset_generator": ImagePromptNotes,
    "asset_retriever": ChoiceNotes,
    "camera_critic": CameraCriticNotes,
    "camera_operator": CameraNotes,
    "dimension_estimator": DimensionNotes,
    "director": SceneNotes,
    "shot_director": CutNotes,
    "environment_designer": SetNotes,
    "spatial_planner": LayoutNotes,
    "layout_critic": LayoutCriticNotes,
    "lighting_arranger": LightNotes,
    "light_critic": LightCriticNotes,
    "animator": StagingNotes,
    "set_dresser": DressingNotes,
    "instructor": Instruction,
}
"""What each role answers with."""
_Maker = Callable[[Answerer, Callable[[], Embedder]], Policy[Any, Any]]
_POLICIES: Final[Mapping[RoleName, _Maker]] = {
    "asset_generator": language_image_prompts,
    "asset_formatter": language_asset_formatter,
    "dimension_estimator": language_dimension_estimator,
    "director": lambda answerer, embedder: LanguageDirector(answerer, RulesDirector(embedder), embedder),
    "shot_director": lambda answerer, embedder: LanguageShotDirector(answerer, RulesShotDirector()),
    "environment_designer": language_environment_designer,
    "spatial_planner": language_spatial_planner,
    "lighting_arranger": language_lighting_arranger,
    "animator": language_animator,
    "set_dresser": language_set_dresser,
    "instructor": language_instructor,
}
"""Makes the policy of each role that a model can play, if it needs no more than these two."""


def language_crew(
    crew: Crew,
    answerers: Mapping[RoleName, Answerer],
    embedder: Callable[[], Embedder],
    sources: Sequence[AssetSource],
) -> Crew:
    """Return a crew whose named roles are played by language models before rules.

    Args:
        crew: The crew of rules.
        answerers: Who answers, by role.
        embedder: Loads the sentence model; called once, at the first need.
        sources: Where assets come from.
    """
    embedder = cache(embedder)
    played: dict[str, Any] = {}
    retriever = partial(language_asset_retriever, sources=sources)
    makers: dict[RoleName, _Maker] = {**_POLICIES, "asset_retriever": retriever}
    for name, make in makers.items():
        if (answerer := answerers.get(name)) is not None:
            role = getattr(crew, name)
            played[name] = replace(role, policies=(make(answerer, embedder), *role.policies))
    if (answerer := answerers.get("asset_critic")) is not None:
        played["asset_retriever"] = with_asset_critic(answerer, played.get("asset_retriever", crew.asset_retriever))
        played["reference_picture"] = with_picture_critic(answerer, crew.reference_picture)
    if (answerer := answerers.get("layout_critic")) is not None:
        played["spatial_planner"] = with_layout_critic(answerer, played.get("spatial_planner", crew.spatial_planner))
    if (answerer := answerers.get("light_critic")) is not None:
        played["lighting_arranger"] = with_light_critic(
            answerer, played.get("lighting_arranger", crew.lighting_arranger)
        )
    operator = crew.camera_operator
    if (answerer := answerers.get("camera_operator")) is not None:
        operator = language_operator(answerer, operator)
    if (answerer := answerers.get("camera_critic")) is not None:
        operator = with_camera_critic(answerer, operator)
    played["camera_operator"] = operator
    return replace(crew, **played)


@dataclass(frozen=True)
class CheckedAnswer:
    """A request in a folder.

    Attributes:
        name: Of the request.
        answered: Whether its answer is there.
        problem: What is wrong with the form of the answer; empty if nothing is.
    """

    name: str
    answered: bool
    problem: str = ""


def check_answers(folder: Path) -> list[CheckedAnswer]:
    """Return the requests of a folder, in order, with what is wrong with the form of their answers.

    Raises:
        InputError: There is no such folder, or an answer cannot be read.
    """
    checked: list[CheckedAnswer] = []
    for name, answer in asked(folder):
        kind = ANSWERS.get(name.partition("-")[0])
        wrong = read_answer_as(kind, answer)[1] if answer is not None and kind is not None else []
        if answer is not None and is_unfinished(answer):
            wrong = ["it ends in the middle; complete it"]
        checked.append(CheckedAnswer(name, answer is not None, wrong[0] if wrong else ""))
    return checked
