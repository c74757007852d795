"""What the catalog knows of one prop: words, size, parameters, materials, where it stands. Data only."""

from __future__ import annotations

from typing import Literal

from storyblender.catalog.registry import ParamValue
from storyblender.look.surface import Surface
from storyblender.memory.base import Frozen, Identifier, Vec3

Category = Literal["furniture", "fitting", "vehicle", "street", "nature", "hand", "animal"]
GLOWING = ("lamp_", "screen", "neon_", "flame", "fire", "ember")
"""How the keys of materials that shine begin."""
Placement = Literal["floor", "surface", "wall", "ceiling"]


class PropEntry(Frozen):
    """One prop that ``blender/props`` can build."""

    key: Identifier
    name: str
    tags: tuple[str, ...] = ()
    """Other names for it, and words that go with it."""
    description: str = ""
    category: Category
    size: Vec3
    """Width x, depth y, height z in metres, at its defaults."""
    params: dict[str, ParamValue] = {}
    """What the builder may vary, with defaults. Every prop also takes ``color`` (hex) and ``material`` (key)
    for the first of its materials."""
    materials: dict[str, Identifier] = {}
    """Role in the builder -> key of ``catalog.materials``; the first is the one people mean by its colour."""
    placement: Placement = "floor"
    """surface: on a table, a shelf or the floor; wall: its back (+Y) against one; ceiling: its top under one."""
    seats: int = 0
    holdable: bool = False
    """A person can carry it in one hand; the builder gives it grips."""
    lamp: Vec3 | None = None
    """Where its light sits, for lamps and fires; scales with the prop."""
    surface: Surface = Surface.PROP
    """How ink and light treat it."""

    @property
    def lights(self) -> bool:
        """Whether it has something that shines, which may be off."""
        return any(key.startswith(GLOWING) for key in self.materials.values()) or self.lamp is not None

    @property
    def life_size(self) -> bool:
        """Whether it is a creature or a vehicle, of which there are toys."""
        return self.category in ("animal", "vehicle")


def entry(
    category: Category,
    key: str,
    words: str,
    size: Vec3,
    materials: dict[str, str],
    description: str = "",
    **fields: object,
) -> PropEntry:
    """Return the catalog entry of a prop.

    Args:
        category: Sort of prop.
        key: snake_case key; its display name follows from it.
        words: Its other names, separated by commas.
        size: Width, depth and height in metres.
        materials: Role in the builder -> key of ``catalog.materials``.
        description: One sentence.
        **fields: Other fields of ``PropEntry``.
    """
    return PropEntry(
        key=key,
        name=key.replace("_", " "),
        tags=tuple(word.strip() for word in words.split(",")),
        description=description,
        category=category,
        size=size,
        materials=materials,
        **fields,  # pyright: ignore[reportArgumentType]
    )


def held(
    key: str,
    words: str,
    size: Vec3,
    materials: dict[str, str],
    description: str,
    params: dict[str, ParamValue] | None = None,
    surface: Surface = Surface.PROP,
) -> PropEntry:
    """Return the catalog entry of a prop that is held in one hand.

    Args:
        key: snake_case key; its display name follows from it.
        words: Its other names, separated by commas.
        size: Width, depth and height in metres.
        materials: Role in the builder -> key of ``catalog.materials``.
        description: One sentence.
        params: What the builder may vary, with defaults.
        surface: How ink and light treat it.
    """
    return entry(
        "hand", key, words, size, materials, description,
        params=params or {}, placement="surface", holdable=True, surface=surface,
    )  # fmt: skip
