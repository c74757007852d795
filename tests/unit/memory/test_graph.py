"""What roles see of a scene's own objects does not depend on how far the scene is staged."""

from __future__ import annotations

from storyblender.agents.visual_effects_artist.environment_designer import environment_designer_view
from storyblender.agents.visual_effects_artist.furniture import dressing_asset
from storyblender.agents.visual_effects_artist.set_dresser import set_dresser_view
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import Environment, Layout, LayoutObject, SceneContext, SceneSetup, SceneSize

TRUNK = Asset(
    asset_id="trunk", asset_type="object", description="a trunk", canonical=dressing_asset("chest", {}).canonical
)
SOFA = dressing_asset("sofa", {})
SIZE = SceneSize(x=3, x_negative=-3, y=3, y_negative=-3)


def test_a_staged_scene_is_designed_and_dressed_as_before_when_its_run_goes_on() -> None:
    setup = SceneSetup(kit="living_room", asset_ids=("trunk",))
    scene = SceneContext(scene_id=1, setup=setup, environment=Environment(kit="living_room"))
    objects = (LayoutObject(node_id="set_sofa_1", asset_id=SOFA.asset_id, location=(0, 0, 0)),)
    laid_out = scene.model_copy(update={"layout": Layout(scene_size=SIZE, objects=objects)})
    bare = ContinuityMemoryGraph(assets=(TRUNK,), scenes=(scene,))
    staged = ContinuityMemoryGraph(assets=(TRUNK, SOFA), scenes=(laid_out,))
    assert staged.assets_of(1) == (TRUNK, SOFA)
    assert staged.own_objects_of(1) == bare.own_objects_of(1) == (TRUNK,)
    assert environment_designer_view(staged, 1) == environment_designer_view(bare, 1)
    assert set_dresser_view(staged, 1) == set_dresser_view(bare, 1)
