"""The crew: a role is one value, and the crew is a table of them, built once by Studio from the settings.

The pipeline names a role and never constructs a policy, so that another crew needs no change outside this module.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from storyblender.agents.concept_artist.asset_formatter import (
    AssetFormatterCritic,
    AssetFormatterView,
    RulesAssetFormatter,
    asset_formatter_view,
)
from storyblender.agents.concept_artist.asset_retriever_view import (
    RETRIEVAL_THRESHOLD,
    AssetRetrieverCritic,
    AssetRetrieverView,
    asset_retriever_view,
)
from storyblender.agents.concept_artist.generator import RulesAssetGenerator
from storyblender.agents.concept_artist.image_prompt import (
    ImagePromptCritic,
    ImagePrompts,
    ImagePromptView,
    RulesImagePrompts,
    image_prompt_view,
)
from storyblender.agents.concept_artist.reference_picture import (
    MOST_PICTURES,
    PaintedByPrompt,
    ReferencePicture,
    ReferencePictureCritic,
    ReferencePictureView,
    reference_picture_view,
)
from storyblender.agents.concept_artist.retriever import RulesAssetRetriever
from storyblender.agents.director.director import (
    DirectorCritic,
    RulesDirector,
    RulesShotDirector,
    ShotDirectorCritic,
    ShotDirectorView,
)
from storyblender.agents.director.reading import Reading
from storyblender.agents.director.settings import DirectorSettings
from storyblender.agents.instructor.instructor import (
    Instruction,
    InstructorCritic,
    InstructorView,
    RulesInstructor,
    instructor_view,
)
from storyblender.agents.layout_artist.camera_operator import CAMERA_HORIZON, CAMERA_THRESHOLD, Operator, rules_operator
from storyblender.agents.layout_artist.dimension_estimator import (
    DimensionEstimatorCritic,
    DimensionEstimatorView,
    RulesDimensionEstimator,
    dimension_estimator_view,
)
from storyblender.agents.layout_artist.spatial_planner import RulesSpatialPlanner, SpatialPlannerCritic
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView, spatial_planner_view
from storyblender.agents.visual_effects_artist.animator import AnimatorDraft, AnimatorView, RulesAnimator, animator_view
from storyblender.agents.visual_effects_artist.animator_critic import AnimatorCritic
from storyblender.agents.visual_effects_artist.environment_designer import (
    EnvironmentDesignerCritic,
    EnvironmentDesignerView,
    RulesEnvironmentDesigner,
    environment_designer_view,
)
from storyblender.agents.visual_effects_artist.lighting_arranger import (
    LightingArrangerCritic,
    LightingArrangerView,
    RulesLightingArranger,
    lighting_arranger_view,
)
from storyblender.agents.visual_effects_artist.set_dresser import (
    RulesSetDresser,
    SetDresserCritic,
    SetDresserDraft,
    SetDresserView,
    set_dresser_view,
)
from storyblender.catalog.recipe import Recipe
from storyblender.crew_setting import RoleName
from storyblender.memory.asset_sheet import Asset, AssetDimension, ModelPose
from storyblender.memory.graph import ContinuityMemoryGraph, Storyboard
from storyblender.memory.measure import AssetViews
from storyblender.memory.scene_context import Environment, Layout, Lighting
from storyblender.ports import AssetSource, Embedder
from storyblender.reflection import Critic, Draft, Policy, Role, Subject, Typed, View
from storyblender.screenplay.model import Screenplay
from storyblender.settings import Settings


@dataclass(frozen=True)
class Crew:
    """All roles of the paper (section 3), each with its policies and critic."""

    director: Role[[Screenplay], Screenplay, Reading]
    """Reads the script."""
    shot_director: Role[[Reading, DirectorSettings], ShotDirectorView, Storyboard]
    """Cuts what was read into shots."""
    asset_retriever: Role[
        [ContinuityMemoryGraph, Asset, Mapping[str, str], Collection[str], Callable[[Asset], AssetViews]],
        AssetRetrieverView,
        Recipe,
    ]
    """Finds an asset; where nothing fits, the Asset Generator takes over."""
    asset_generator: Role[[ContinuityMemoryGraph, Sequence[Asset]], ImagePromptView, ImagePrompts]
    """Writes what an image service needs to make a thing that no source has."""
    asset_formatter: Role[[Asset, Callable[[Asset], AssetViews]], AssetFormatterView, ModelPose]
    """Finds the front and the top of a model file."""
    dimension_estimator: Role[
        [ContinuityMemoryGraph, Sequence[Asset], Callable[[Asset], AssetViews]],
        DimensionEstimatorView,
        dict[str, AssetDimension],
    ]
    environment_designer: Role[[ContinuityMemoryGraph, int], EnvironmentDesignerView, Environment]
    set_dresser: Role[[ContinuityMemoryGraph, int], SetDresserView, SetDresserDraft]
    spatial_planner: Role[..., SpatialPlannerView, Layout]
    animator: Role[[ContinuityMemoryGraph, int], AnimatorView, AnimatorDraft]
    lighting_arranger: Role[..., LightingArrangerView, Lighting]
    camera_operator: Operator
    instructor: Role[[ContinuityMemoryGraph, str], InstructorView, Instruction]
    """Turns a person's words into edits."""
    reference_picture: Role[[Asset, str, Callable[[str], bytes]], ReferencePictureView, ReferencePicture]
    """The Asset Generator again: has a picture drawn that is sound enough to make a model of."""


def rules_crew(settings: Settings, embedder: Callable[[], Embedder], sources: Sequence[AssetSource]) -> Crew:
    """Return the crew that needs no model.

    Args:
        settings: Thresholds and horizons by role.
        embedder: Loads the sentence model; called once, at the first need.
        sources: Where assets come from, in the order of preference.
    """
    embedder = cache(embedder)

    def role(
        name: RoleName,
        project: Callable[Subject, View],
        policies: Sequence[Policy[View, Draft]],
        critic: Critic[View, Draft],
        draft: type[Draft],
        threshold: float = 8.0,
        horizon: int = 5,
    ) -> Role[Subject, View, Draft]:
        limits = settings.reflection(name, threshold, horizon)
        return Role(name, project, tuple(policies), critic, Typed(draft), *limits, rules=len(policies))

    retrievers = (RulesAssetRetriever(sources), RulesAssetGenerator(embedder))
    dimensions = dict[str, AssetDimension]
    camera = settings.reflection("camera_operator", CAMERA_THRESHOLD, CAMERA_HORIZON)
    painters, examiner = [PaintedByPrompt()], ReferencePictureCritic()
    painter = role("asset_generator", reference_picture_view, painters, examiner, ReferencePicture)
    return Crew(
        role("director", _as_it_is, [RulesDirector(embedder)], DirectorCritic(), Reading),
        role("shot_director", ShotDirectorView, [RulesShotDirector()], ShotDirectorCritic(), Storyboard),
        role(
            "asset_retriever", asset_retriever_view, retrievers, AssetRetrieverCritic(), Recipe,
            RETRIEVAL_THRESHOLD, horizon=1,
        ),
        role("asset_generator", image_prompt_view, [RulesImagePrompts()], ImagePromptCritic(), dict[str, str]),
        role("asset_formatter", asset_formatter_view, [RulesAssetFormatter()], AssetFormatterCritic(), ModelPose),
        role(
            "dimension_estimator", dimension_estimator_view, [RulesDimensionEstimator()], DimensionEstimatorCritic(),
            dimensions,
        ),
        role(
            "environment_designer", environment_designer_view, [RulesEnvironmentDesigner()],
            EnvironmentDesignerCritic(), Environment,
        ),
        role("set_dresser", set_dresser_view, [RulesSetDresser()], SetDresserCritic(), SetDresserDraft),
        role("spatial_planner", spatial_planner_view, [RulesSpatialPlanner()], SpatialPlannerCritic(), Layout),
        role("animator", animator_view, [RulesAnimator()], AnimatorCritic(), AnimatorDraft),
        role(
            "lighting_arranger", lighting_arranger_view, [RulesLightingArranger()], LightingArrangerCritic(), Lighting
        ),
        lambda viewfinder: rules_operator(viewfinder, *camera),
        role("instructor", instructor_view, [RulesInstructor()], InstructorCritic(), Instruction),
        replace(painter, horizon=min(painter.horizon, MOST_PICTURES - 1)),
    )  # fmt: skip


def _as_it_is(screenplay: Screenplay) -> Screenplay:
    """Return the Director's view of a script, which is the script."""
    return screenplay
