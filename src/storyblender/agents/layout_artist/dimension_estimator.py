"""The Dimension Estimator: for every asset the one dimension that is surest, in metres (paper, appendix).

People are as tall as their age and gender; things are as large as the catalog's, stand-ins as their class;
words of size scale both. Furniture keeps close to its size.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Literal

from pydantic import Field

from storyblender.agents.concept_artist.asset_retriever_view import RETRIEVAL_THRESHOLD
from storyblender.agents.side_views import nothing_drawn
from storyblender.catalog.bodies import typical_stature
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import prop_of
from storyblender.catalog.sets import SETS
from storyblender.look.surface import Surface
from storyblender.memory.asset_sheet import PLAUSIBLE, Asset, AssetDimension, CharacterLook
from storyblender.memory.base import Vec3
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.measure import AssetViews
from storyblender.memory.vocabulary import SizeWord, StatureWord
from storyblender.reflection import Critique, Fault

Side = Literal["width", "depth", "height"]
_SIDES: tuple[Side, Side, Side] = ("width", "depth", "height")

_SCALES: dict[SizeWord, float] = {
    "tiny": 0.5, "minuscule": 0.5, "miniature": 0.5, "small": 0.75, "little": 0.75, "low": 0.75, "short": 0.75,
    "narrow": 0.75, "compact": 0.75, "big": 1.25, "large": 1.25, "tall": 1.25, "wide": 1.25, "long": 1.25,
    "broad": 1.25, "huge": 1.7, "enormous": 1.7, "massive": 1.7, "giant": 1.7, "gigantic": 1.7, "towering": 1.7,
    "colossal": 1.7,
}  # fmt: skip
_STATURES: dict[StatureWord, float] = {
    "tall": 1.06, "towering": 1.1, "giant": 1.12, "huge": 1.08, "big": 1.03, "short": 0.94, "small": 0.94,
    "little": 0.94, "petite": 0.93, "tiny": 0.9,
}  # fmt: skip
"""Factors for people, who vary less than things."""
_DEFAULT_SIDE: tuple[Side, float] = ("height", 0.4)
_FURNITURE = 0.4
"""Exponent on the factor of a word of size for furniture, which is made for people."""
_TOY = 0.3
"""Metres of the longest side of a toy."""
_IN_HAND = 0.45
"""Metres of the longest side of an unknown thing in a hand."""
_IN_ARMS = 0.55
"""Metres of the height of a plant that a person carries."""
_ROOM_SHARES = (0.45, 0.6, 0.92)
"""Shares of a room's shorter side, longer side and height that one thing may take."""
_CARRIED_ANIMAL = 1.2
"""Metres of length from which an animal in a person's hands is a toy."""


@dataclass(frozen=True)
class DimensionEstimatorView:
    """What the Dimension Estimator sees.

    Attributes:
        assets: Assets to size, with their geometry if it is decided.
        rooms: Width, depth and height in metres of the smallest room of assets that are never outdoors, by asset id.
        draw: Draws an object. Raises NoAnswer.
    """

    assets: tuple[Asset, ...]
    rooms: Mapping[str, Vec3] = field(default_factory=dict[str, Vec3])
    draw: Annotated[Callable[[Asset], AssetViews], Field(exclude=True)] = field(default=nothing_drawn, compare=False)


def dimension_estimator_view(
    graph: ContinuityMemoryGraph, assets: Sequence[Asset], draw: Callable[[Asset], AssetViews] = nothing_drawn
) -> DimensionEstimatorView:
    """Return the Dimension Estimator's projection of the graph.

    Args:
        graph: The graph, with the places of the Director's plan.
        assets: Assets to size, with their geometry if it is decided.
        draw: Draws an object. Raises NoAnswer.
    """
    setups = [scene.setup for scene in graph.scenes]
    outdoors = {asset_id for setup in setups if setup.scene_type == "outdoor" for asset_id in setup.asset_ids}
    rooms: dict[str, Vec3] = {}
    for setup in setups:
        kit = SETS[setup.kit]
        room = (kit.width.most, kit.depth.most, kit.height.usual)
        for asset_id in set(setup.asset_ids) - outdoors:
            rooms[asset_id] = min(rooms.get(asset_id, room), room, key=math.prod)
    sized = {asset.asset_id for asset in assets}
    return DimensionEstimatorView(tuple(assets), {key: room for key, room in rooms.items() if key in sized}, draw)


class RulesDimensionEstimator:
    """The Dimension Estimator without a model; its draft has a dimension by asset id."""

    def propose(self, view: DimensionEstimatorView) -> dict[str, AssetDimension]:
        """Return exactly one dimension for each asset."""
        return {asset.asset_id: estimate_dimension(asset, view.rooms.get(asset.asset_id)) for asset in view.assets}

    def refine(
        self, draft: dict[str, AssetDimension], critique: Critique, view: DimensionEstimatorView
    ) -> dict[str, AssetDimension]:
        """Return the draft with the rules' own estimate for every asset that has a fault.

        Args:
            draft: Dimensions by asset id.
            critique: Its faults.
            view: The assets.
        """
        wrong = {fault.subject for fault in critique.faults}
        return {name: size if name in wrong else draft[name] for name, size in self.propose(view).items()}


class DimensionEstimatorCritic:
    """Checks that each asset has exactly one plausible value, and people a human height."""

    def judge(self, draft: dict[str, AssetDimension], view: DimensionEstimatorView) -> Critique:
        """Return the critique of dimensions: a fault for each asset that is wrong.

        Args:
            draft: Dimensions by asset id.
            view: The assets.
        """
        faults = [
            Fault(kind="dimension", subject=asset.asset_id, severity=2.0, message=f"{asset.asset_id}: {problem}")
            for asset in view.assets
            if (problem := _find_problem(asset, draft.get(asset.asset_id)))
        ]
        return Critique.of(tuple(faults))


def _find_problem(asset: Asset, dimension: AssetDimension | None) -> str:
    """Return what is wrong with an asset's dimension; empty if nothing is."""
    values = [] if dimension is None else [value for value in dimension.model_dump().values() if value is not None]
    if len(values) != 1:
        return f"{len(values)} dimensions are given, one is wanted"
    if not PLAUSIBLE[0] <= values[0] <= PLAUSIBLE[1]:
        return f"{values[0]} m is not plausible"
    is_human = asset.asset_type == "character" and asset.look is not None
    if is_human and not (dimension is not None and dimension.height is not None and 0.4 <= dimension.height <= 2.4):
        return "a person is given by a height of 0.4 to 2.4 m"
    return ""


def estimate_dimension(asset: Asset, room: Vec3 | None = None) -> AssetDimension:
    """Return the surest dimension of an asset: the script's, else its kind's; no larger than its room.

    Args:
        asset: The asset, with its geometry if it is decided.
        room: Width, depth and height of its room in metres; None if it is ever outdoors.
    """
    return fit_to_room(_estimate_without_room(asset), asset, room)


def _is_furniture(asset: Asset) -> bool:
    """Return whether an asset is furniture, which keeps its size in any room."""
    made = asset.canonical
    return made is not None and made.source == "catalog" and PROPS[made.key].category == "furniture"


def fit_to_room(dimension: AssetDimension, asset: Asset, room: Vec3 | None) -> AssetDimension:
    """Return the dimension at which a thing fits into its room with space around it; people and furniture keep theirs.

    Args:
        dimension: One dimension of the asset.
        asset: The asset, with its geometry if it is decided.
        room: Width, depth and height of its room in metres; None if it is ever outdoors.
    """
    if room is None or asset.asset_type == "character" or _is_furniture(asset):
        return dimension
    side = next(side for side in _SIDES if getattr(dimension, side) is not None)
    value: float = getattr(dimension, side)
    shape = asset.canonical.dimensions if asset.canonical is not None else (1.0, 1.0, 1.0)
    width, depth, height = (value * length / shape[_SIDES.index(side)] for length in shape)
    sizes = (min(width, depth), max(width, depth), height)
    spaces = (min(room[:2]), max(room[:2]), room[2])
    scale = min(part * space / size for part, space, size in zip(_ROOM_SHARES, spaces, sizes, strict=True))
    return dimension if scale >= 1 else AssetDimension(**{side: round(value * scale, 2)})


def _estimate_without_room(asset: Asset) -> AssetDimension:
    """Return the dimension of an asset by measure, kind, class and words of size."""
    decided = asset.look_decision
    if asset.stated_size.measure is not None and (decided is None or decided.stature is None):
        return asset.stated_size.measure
    if (look := asset.decided_look) is not None and asset.asset_type == "character":
        return AssetDimension(height=round(min(max(_stature(look, asset.stated_size.word), 0.4), 2.4), 2))
    scale = next((factor for word, factor in _SCALES.items() if word == asset.stated_size.word), 1.0)
    if asset.canonical is not None and asset.canonical.source == "catalog":
        side, value = _largest_side(asset.canonical.dimensions)
        entry = PROPS[asset.canonical.key]
        carried = asset.tags[:1] == ("prop",) and "handled" in asset.tags
        too_large = carried and entry.category == "animal" and value > _CARRIED_ANIMAL
        if too_large or (entry.life_size and asset.stated_size.toy):
            value = _TOY
        elif carried and entry.surface is Surface.FOLIAGE:
            value = min(value, _IN_ARMS)
        elif carried and not entry.holdable and (asset.canonical.match_score or 10.0) < RETRIEVAL_THRESHOLD:
            value = min(value, _IN_HAND)
        elif entry.category == "furniture":
            scale **= _FURNITURE
    elif asset.canonical is not None and asset.canonical.source == "stand_in":
        side, value = _largest_side(asset.canonical.dimensions)
        if "handled" in asset.tags and max(asset.canonical.dimensions) <= _IN_HAND:
            value = min(value, _IN_HAND)
    else:
        entry = PROPS.get(prop_of(asset))
        side, value = _DEFAULT_SIDE if entry is None else _largest_side(entry.size)
    return AssetDimension(**{side: round(value * scale, 3 if value < 0.1 else 2)})


def _stature(look: CharacterLook, word: SizeWord | StatureWord | None) -> float:
    """Return a person's stature in metres: as described, else typical of age and gender with words of size."""
    if look.stature is not None:
        return look.stature
    genders = ("female", "male") if look.gender == "unknown" else (look.gender,)
    typical = sum(typical_stature(gender, look.age) for gender in genders) / len(genders)
    return typical * next((scale for each, scale in _STATURES.items() if each == word), 1.0)


def _largest_side(size: tuple[float, float, float]) -> tuple[Side, float]:
    """Return the largest side of a size, and its metres."""
    value = max(size)
    return _SIDES[size.index(value)], value
