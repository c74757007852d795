"""The crew: a role is one value, and the crew is a table of them, built once by Studio from the settings.

The pipeline names a role and never constructs a policy, so that another crew needs no change outside this module.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from storyblender.agents.concept_artist.generator import RulesAssetGenerator
from storyblender.agents.concept_artist.recipe import (
    RETRIEVAL_THRESHOLD,
    AssetRequest,
    MatchCritic,
    ModelFile,
    Recipe,
    asset_request,
)
from storyblender.agents.concept_artist.retriever import RulesAssetRetriever
from storyblender.agents.director.director import (
    ReadingCritic,
    RulesDirector,
    RulesShotDirector,
    ShotsCritic,
    ShotsView,
)
from storyblender.agents.director.reading import Reading
from storyblender.agents.director.settings import DirectorSettings
from storyblender.agents.layout_artist.camera_operator import CAMERA_HORIZON, CAMERA_THRESHOLD, Operator, rules_operator
from storyblender.agents.layout_artist.dimension_estimator import (
    DimensionCritic,
    DimensionView,
    RulesDimensionEstimator,
    dimension_view,
)
from storyblender.agents.layout_artist.layout_brief import LayoutBrief, layout_brief
from storyblender.agents.layout_artist.spatial_planner import LayoutCritic, RulesSpatialPlanner
from storyblender.agents.visual_effects_artist.animator import AnimatorDraft, AnimatorView, RulesAnimator, animator_view
from storyblender.agents.visual_effects_artist.animator_critic import AnimatorCritic
from storyblender.agents.visual_effects_artist.environment_designer import (
    EnvironmentCritic,
    EnvironmentView,
    RulesEnvironmentDesigner,
    environment_view,
)
from storyblender.agents.visual_effects_artist.lighting_arranger import (
    LightingCritic,
    LightingView,
    RulesLightingArranger,
    lighting_view,
)
from storyblender.agents.visual_effects_artist.set_dresser import (
    Dressing,
    DressingCritic,
    DressingView,
    RulesSetDresser,
    dressing_view,
)
from storyblender.memory.asset_sheet import Asset, AssetDimension
from storyblender.memory.graph import ContinuityMemoryGraph, Storyboard
from storyblender.memory.scene_context import Environment, Layout, Lighting
from storyblender.ports import Embedder
from storyblender.reflection import Role, Typed
from storyblender.screenplay.model import Screenplay
from storyblender.settings import Settings


@dataclass(frozen=True)
class Crew:
    """All roles of the paper (section 3), each with its policies and critic."""

    director: Role[[Screenplay], Screenplay, Reading]
    """Reads the script."""
    shot_director: Role[[Reading, DirectorSettings], ShotsView, Storyboard]
    """Cuts what was read into shots."""
    asset_retriever: Role[
        [ContinuityMemoryGraph, Asset, tuple[ModelFile, ...], Mapping[str, str]], AssetRequest, Recipe
    ]
    """Finds an asset; where nothing fits, the Asset Generator takes over."""
    dimension_estimator: Role[[ContinuityMemoryGraph, Sequence[Asset]], DimensionView, dict[str, AssetDimension]]
    environment_designer: Role[[ContinuityMemoryGraph, int], EnvironmentView, Environment]
    set_dresser: Role[[ContinuityMemoryGraph, int], DressingView, Dressing]
    spatial_planner: Role[..., LayoutBrief, Layout]
    animator: Role[[ContinuityMemoryGraph, int], AnimatorView, AnimatorDraft]
    lighting_arranger: Role[..., LightingView, Lighting]
    camera_operator: Operator


def rules_crew(settings: Settings, embedder: Callable[[], Embedder]) -> Crew:
    """Return the crew that needs no model.

    Args:
        settings: Thresholds and horizons by role.
        embedder: Loads the sentence model; called once, at the first need.
    """
    embedder = cache(embedder)
    retrievers = (RulesAssetRetriever(embedder), RulesAssetGenerator(embedder))
    camera = settings.limits("camera_operator", CAMERA_THRESHOLD, CAMERA_HORIZON)
    return Crew(
        director=Role(
            "director", _as_it_is, (RulesDirector(embedder),), ReadingCritic(), Typed(Reading),
            *settings.limits("director"),
        ),
        shot_director=Role(
            "shot_director", ShotsView, (RulesShotDirector(),), ShotsCritic(), Typed(Storyboard),
            *settings.limits("shot_director"),
        ),
        asset_retriever=Role(
            "asset_retriever", asset_request, retrievers, MatchCritic(), Typed(Recipe),
            *settings.limits("asset_retriever", RETRIEVAL_THRESHOLD, 1),
        ),
        dimension_estimator=Role(
            "dimension_estimator", dimension_view, (RulesDimensionEstimator(),), DimensionCritic(),
            Typed(dict[str, AssetDimension]), *settings.limits("dimension_estimator"),
        ),
        environment_designer=Role(
            "environment_designer", environment_view, (RulesEnvironmentDesigner(),), EnvironmentCritic(),
            Typed(Environment), *settings.limits("environment_designer"),
        ),
        set_dresser=Role(
            "set_dresser", dressing_view, (RulesSetDresser(),), DressingCritic(), Typed(Dressing),
            *settings.limits("set_dresser"),
        ),
        spatial_planner=Role(
            "spatial_planner", layout_brief, (RulesSpatialPlanner(),), LayoutCritic(), Typed(Layout),
            *settings.limits("spatial_planner"),
        ),
        animator=Role(
            "animator", animator_view, (RulesAnimator(),), AnimatorCritic(), Typed(AnimatorDraft),
            *settings.limits("animator"),
        ),
        lighting_arranger=Role(
            "lighting_arranger", lighting_view, (RulesLightingArranger(),), LightingCritic(), Typed(Lighting),
            *settings.limits("lighting_arranger"),
        ),
        camera_operator=lambda viewfinder: rules_operator(viewfinder, *camera),
    )  # fmt: skip


def _as_it_is(screenplay: Screenplay) -> Screenplay:
    """Return the Director's view of a script, which is the script."""
    return screenplay
