"""A thing that is tipped over lies from then on, until it is taken up or stood up again."""

from __future__ import annotations

from types import SimpleNamespace

from storyblender.agents.visual_effects_artist.fallen_props import FallenProps
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import AssetModification, PropState


def _asset(name: str, height: float) -> Asset:
    made = CanonicalAsset(source="catalog", key="vase", dimensions=(0.2, 0.2, height), digest="x")
    return Asset(asset_id=name, asset_type="object", description=name, canonical=made)


def _shot(*changes: tuple[str, str]):
    made = tuple(
        AssetModification(asset_id=name, modification_type="transform", state=state) for name, state in changes
    )
    return SimpleNamespace(asset_modifications=made)


def _fallen() -> FallenProps:
    homes = [LayoutObject(node_id=name, asset_id=name, location=(1.0, 2.0, 0.75)) for name in ("vase", "plate")]
    return FallenProps([_asset("vase", 0.4), _asset("plate", 0.02)], homes)


def test_it_lies_on_its_side_from_the_shot_that_tells_it_on() -> None:
    fallen = _fallen()
    assert fallen.add_fallen(_shot(), (), {}) == ()  # type: ignore[arg-type]
    (state,) = fallen.add_fallen(_shot(("vase", "tipped")), (), {})  # type: ignore[arg-type]
    assert state.rotation[0] == 90 and state.location == (1.0, 2.0, 0.85)
    (later,) = fallen.add_fallen(_shot(), (), {})  # type: ignore[arg-type]
    assert later == state
    assert fallen.add_fallen(_shot(("vase", "upright")), (), {}) == ()  # type: ignore[arg-type]


def test_what_is_flat_or_held_does_not_lie() -> None:
    fallen = _fallen()
    assert fallen.add_fallen(_shot(("plate", "tipped")), (), {}) == ()  # type: ignore[arg-type]
    held = PropState(asset_id="vase", held_by="nora", hand="R")
    assert fallen.add_fallen(_shot(("vase", "spilled")), (held,), {}) == (held,)  # type: ignore[arg-type]
