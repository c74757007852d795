"""The Asset Formatter: which sides of a model file are the thing's front and top (paper, section 3.3 and appendix)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Annotated

from pydantic import Field

from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import prop_of
from storyblender.memory.asset_sheet import Asset, ModelPose
from storyblender.memory.measure import AssetViews
from storyblender.reflection import UNUSABLE, Critique, Fault

AS_IN_FILE = ModelPose(front="front", top="top")
"""The pose in which a model is looked at: as its file has it."""
_OPPOSITE = {"front": "back", "left": "right", "top": "bottom"}
_OPPOSITE |= {back: front for front, back in _OPPOSITE.items()}


@dataclass(frozen=True)
class AssetFormatterView:
    """What the Asset Formatter sees of a model file; it is the same for every asset that is made from it.

    Attributes:
        file: Its path in its source.
        content: Digest of what is in it.
        thing: What the catalog calls such a thing; empty where it knows none.
        look: Draws the model as its file has it. Raises NoAnswer.
    """

    file: str
    content: str
    thing: str
    look: Annotated[Callable[[], AssetViews], Field(exclude=True)] = field(compare=False)


def asset_formatter_view(asset: Asset, draw: Callable[[Asset], AssetViews]) -> AssetFormatterView:
    """Return the Asset Formatter's projection of an asset that is made from a model file.

    Args:
        asset: With its canonical.
        draw: Draws an asset.
    """
    made = asset.canonical
    assert made is not None, "decided before it is formatted"
    as_in_file = made.model_copy(update={"params": made.params | AS_IN_FILE.params})
    model = asset.model_copy(update={"canonical": as_in_file, "dimension": None})
    known = PROPS.get(prop_of(asset))
    return AssetFormatterView(
        file=made.key,
        content=str(made.params.get("content", "")),
        thing=known.name if known is not None else "",
        look=lambda: draw(model),
    )


class RulesAssetFormatter:
    """The Asset Formatter without a model: the engine finds front and top by the shape, as it builds the asset."""

    def propose(self, view: AssetFormatterView) -> ModelPose:
        """Return a pose that leaves all to the engine."""
        return ModelPose()

    def refine(self, draft: ModelPose, critique: Critique, view: AssetFormatterView) -> ModelPose:
        """Return what ``propose`` returns.

        Args:
            draft: Not used.
            critique: Not used.
            view: Not used.
        """
        return ModelPose()


class AssetFormatterCritic:
    """Checks that the front of a model is beside its top."""

    def judge(self, draft: ModelPose, view: AssetFormatterView) -> Critique:
        """Return the critique of a pose.

        Args:
            draft: The pose.
            view: Not used.
        """
        problem = pose_problem(draft)
        return Critique.of((Fault(kind="pose", message=problem, severity=UNUSABLE),) if problem else ())


def pose_problem(pose: ModelPose) -> str:
    """Return what is wrong with a pose; empty if nothing is."""
    if pose.front is not None and pose.top is None:
        return "a front needs a top"
    if pose.front is not None and pose.top in (pose.front, _OPPOSITE[pose.front]):
        return "the front cannot be the top or opposite it"
    return ""
