"""Commits: what changed, forwards and backwards."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import HEAD_FIELDS, Change, Commit, apply, changes_between, replace
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.memory.shot_context import CameraInstruction, ShotContext


def shot(scene_id: int, shot_id: int, duration: int = 24) -> ShotContext:
    return ShotContext(scene_id=scene_id, shot_id=shot_id, duration=duration, camera_instruction=CameraInstruction())


def story(*durations: int) -> ContinuityMemoryGraph:
    return ContinuityMemoryGraph(
        title="t",
        assets=(Asset(asset_id="rick", asset_type="character", description="a man"),),
        scenes=(SceneContext(scene_id=1, setup=SceneSetup()),),
        shots=tuple(shot(1, index + 1, duration) for index, duration in enumerate(durations)),
    )


def commit(old: ContinuityMemoryGraph, new: ContinuityMemoryGraph) -> Commit:
    return Commit(revision=1, author="user", reason="test", changes=changes_between(old, new))


def test_only_the_changed_item_is_in_the_commit() -> None:
    old = story(10, 20, 30)
    new = replace(old, shot(1, 2, 99))
    changes = changes_between(old, new)
    assert [(change.layer, change.key) for change in changes] == [("shots", (1, 2))]
    assert changes[0].before is not None and changes[0].before["duration"] == 20


durations = st.lists(st.integers(1, 99), max_size=6)


@given(durations, durations)
def test_a_commit_undone_is_as_if_never_made(before: list[int], after: list[int]) -> None:
    old, new = story(*before), story(*after).model_copy(update={"title": "u"})
    made = commit(old, new)
    assert apply(old, made) == new
    assert apply(new, made, backwards=True) == old


@pytest.mark.parametrize("content", [None, {}, {"assets": 5}, {"assets": [[]]}])
def test_an_order_that_is_none_is_refused(content: dict[str, Any] | None) -> None:
    made = Commit(revision=1, author="user", reason="", changes=(Change(layer="order", key=(), after=content),))
    with pytest.raises(ValueError, match="list of names"):
        apply(story(), made)


def test_replace_keeps_story_order_and_the_order_in_which_assets_joined() -> None:
    graph = replace(story(10), shot(1, 3), shot(1, 2), Asset(asset_id="ada", asset_type="object", description=""))
    assert [item.shot_id for item in graph.shots] == [1, 2, 3]
    assert [asset.asset_id for asset in graph.assets] == ["rick", "ada"]


def test_every_field_of_the_graph_is_in_the_history() -> None:
    layers = {"schema_version", "outline", "assets", "scenes", "shots"}
    assert set(ContinuityMemoryGraph.model_fields) == layers | set(HEAD_FIELDS)
