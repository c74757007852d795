"""What a person decided about a material: of one asset, of one scene, or of the whole story.

It lies over what is built from the catalogue and from models, and is laid on when a scene is packed. Of several that
mean the same surface the narrowest counts.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated, Self

from pydantic import Field, model_validator

from storyblender.memory.base import Described, Identifier, SceneId, is_none
from storyblender.memory.scene_decision import Share

MaterialName = Annotated[str, Field(min_length=1, max_length=128)]
"""As it was before anybody painted it: ``wood_dark``, ``fabric_8a2f2a``, or the name in a user's model."""


class PaintDecision(Described):
    """How a material looks; what is left out stays as it was made."""

    finish: Identifier | None = Field(default=None, exclude_if=is_none)
    """A material of ``catalog materials`` in its place: ``wood_dark``."""
    color: tuple[Share, Share, Share] | None = Field(default=None, exclude_if=is_none)
    """Red, green and blue, scene-linear, 0 to 1; a pattern keeps its light and dark."""
    roughness: Share | None = Field(default=None, exclude_if=is_none)
    """0 is a mirror, 1 is chalk."""
    metallic: Share | None = Field(default=None, exclude_if=is_none)
    """1 is metal."""
    plain: bool | None = Field(default=None, exclude_if=is_none)
    """Whether it loses its pattern."""

    @property
    def words(self) -> str:
        """The decision as a person reads it, e.g. ``color #8a2f2a, roughness 0.3``."""
        color = "".join(f"{round(255 * _encoded(each)):02x}" for each in self.color or ())
        said = {
            "finish": f"{self.finish}".replace("_", " "), "color": f"color #{color}",
            "roughness": f"roughness {self.roughness}", "metallic": f"metallic {self.metallic}",
            "plain": "plain" if self.plain else "with its pattern",
        }  # fmt: skip
        return ", ".join(words for name, words in said.items() if getattr(self, name) is not None)

    def then(self, later: Self) -> Self:
        """Return this decision with a later one on top; another finish has a look of its own."""
        said = {name: value for name, value in later if value is not None}
        return later if later.finish is not None else self.model_copy(update=said)


class PaintTarget(Described):
    """Which surfaces are meant; what is left out does not narrow them."""

    material: MaterialName | None = Field(default=None, exclude_if=is_none)
    """The material; left out, of an asset the one that covers most of it."""
    asset_id: Identifier | None = Field(default=None, exclude_if=is_none)
    """A thing or a person, wherever it is shown."""
    scene_id: SceneId | None = Field(default=None, exclude_if=is_none)
    """Only in this scene."""
    node_id: Annotated[str, Field(min_length=1, max_length=128)] | None = Field(default=None, exclude_if=is_none)
    """Only this object of the scene: a thing of its layout, or a piece of its set."""

    @model_validator(mode="after")
    def _means_something(self) -> Self:
        if self.material is None and self.asset_id is None and self.node_id is None:
            raise ValueError("what is painted is a material, a thing, or both")
        if self.node_id is not None and self.scene_id is None:
            raise ValueError("an object is one of a scene")
        return self

    @property
    def narrowness(self) -> int:
        """Of several that mean a surface the one with the highest counts."""
        told = (self.material, self.scene_id, self.asset_id, self.node_id)
        return sum(1 << place for place, each in enumerate(told) if each is not None)


class Paint(Described):
    """Which surfaces a person painted, and how."""

    target: PaintTarget
    """Which surfaces."""
    look: PaintDecision
    """How."""


def paints_in(paints: Iterable[Paint], scene_id: int, asset_ids: Iterable[str]) -> tuple[Paint, ...]:
    """Return the paints that may show in a scene.

    Args:
        paints: Of the story.
        scene_id: The scene.
        asset_ids: Of all that it shows.
    """
    shown = {None, *asset_ids}
    return tuple(
        each for each in paints if each.target.scene_id in (None, scene_id) and each.target.asset_id in shown
    )  # fmt: skip


def _encoded(value: float) -> float:
    """Return a linear channel as sRGB has it."""
    return 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055
