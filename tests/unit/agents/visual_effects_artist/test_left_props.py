"""What nobody holds any more lies on something, though no action puts it down."""

from __future__ import annotations

import pytest
from tests.unit.agents.visual_effects_artist.test_animator import ASSETS, LAYOUT, SIZE, _at, _shot, _thing

from storyblender.agents.visual_effects_artist.animator import AnimatorView, RulesAnimator
from storyblender.catalog.set_plan import SetPlan
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Spot
from storyblender.memory.shot_context import BodyState, PropState

BOOK = _thing("book", (0.3, 0.4, 0.06))
TREE = _thing("tree", (3.0, 3.0, 6.0))


def _left(place: tuple[float, float], spot: Spot | None = None, absent: tuple[str, ...] = ()) -> PropState:
    """Where a book is in the shot after the one in which Rick had it, as he stands at a place."""
    people = tuple(_at("rick", *place) if item.asset_id == "rick" else item for item in LAYOUT.objects)
    layout = LAYOUT.model_copy(update={"objects": (*people, _at("book", 1.6, -1.6), _at("tree", -2.0, -1.5))})
    had = _shot(1, states=(BodyState(asset_id="rick", held=("book",)),))
    spots = {} if spot is None else {"book": spot}
    has_not = _shot(2, states=(BodyState(asset_id="rick"),), thing_spots=spots, absent=absent)
    view = AnimatorView(
        scene_id=1, layout=layout, plan=SetPlan(kit="office", indoor=True, size=SIZE), assets=(*ASSETS, BOOK, TREE),
        shots=(had, has_not),
    )  # fmt: skip
    states = RulesAnimator().propose(view).shots[1].prop_states
    return next(state for state in states if state.asset_id == "book")


@pytest.mark.parametrize(("place", "height"), [((0.0, 0.2), 0.75), ((0.0, -1.8), 0.0)])
def test_it_is_on_the_table_within_reach_else_on_the_floor(place: tuple[float, float], height: float) -> None:
    state = _left(place)
    assert state.held_by is None and state.visible
    assert state.location is not None and state.location[2] == pytest.approx(height)


def test_it_is_where_the_script_says() -> None:
    location = _left((0.0, -1.8), Spot(relation="on", anchor_id="table")).location
    assert location is not None and location[2] == pytest.approx(0.75)


def test_it_does_not_lie_up_in_a_tree() -> None:
    location: Vec3 | None = _left((0.0, -1.8), Spot(relation="on", anchor_id="tree")).location
    assert location is not None and location[2] == 0.0


def test_what_is_absent_is_not_seen() -> None:
    assert not _left((0.0, 0.2), absent=("book",)).visible
