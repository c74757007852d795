"""What the pictures of the catalogue show: every entry has one, of things that the library has."""

from __future__ import annotations

from tests.every import every

from storyblender.catalog.motions import MOTIONS
from storyblender.catalog.props import PROPS
from storyblender.catalog.sets import SETS
from storyblender.memory.gatekeeper import Gatekeeper
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import changes_between
from storyblender.samples import asset_of, story_of


@every("key", SETS)
def test_the_picture_of_a_set_is_of_that_set(key: str) -> None:
    story = story_of("sets", key)
    assert story is not None and story.scenes[0].setup.kit == key


@every("key", MOTIONS)
def test_the_picture_of_a_motion_is_of_that_motion_and_of_things_there_are(key: str) -> None:
    story = story_of("motions", key)
    assert story is not None
    (action,) = story.shots[0].character_actions
    assert action.motion == key
    assert all(asset.asset_id in PROPS for asset in story.assets if asset.asset_type == "object")
    assert MOTIONS[key].reach != "thing" or action.target_id
    nothing = ContinuityMemoryGraph()
    Gatekeeper(nothing, MOTIONS).admit(story, changes_between(nothing, story))


def test_clothes_and_hair_are_shown_on_somebody_and_a_material_on_a_crate() -> None:
    look = asset_of("garments", "hat").look
    assert look is not None and look.garments[0].key == "hat"
    assert asset_of("props", "hat").look is None and asset_of("hair", "bob").asset_type == "character"
    brick = asset_of("materials", "brick").canonical
    assert brick is not None and (brick.key, dict(brick.params)) == ("crate", {"material": "brick"})
    assert story_of("garments", "hat") is None
