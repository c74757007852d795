"""One small registry for everything that has a key: props, garments, motions, materials, set kits, looks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Generic, Protocol, TypeVar

from storyblender.memory.asset_sheet import ParamValue

__all__ = ["Catalog", "Entry", "ParamValue"]


class Entry(Protocol):
    """What every catalog entry has."""

    @property
    def key(self) -> str:
        """Unique snake_case name within its catalog."""
        ...

    @property
    def name(self) -> str:
        """Name for people."""
        ...

    @property
    def tags(self) -> tuple[str, ...]:
        """Other words for it; searched by meaning."""
        ...


EntryT = TypeVar("EntryT", bound=Entry)


class Catalog(Mapping[str, EntryT], Generic[EntryT]):
    """An ordered, read-only collection of entries by key.

    Args:
        kind: What it holds, for error messages, e.g. ``prop``.
        entries: In the order they are listed to people.
    """

    def __init__(self, kind: str, entries: tuple[EntryT, ...]) -> None:
        self.kind = kind
        self._entries: dict[str, EntryT] = {}
        for entry in entries:
            if entry.key in self._entries:
                raise ValueError(f"{kind} {entry.key!r} is in the catalog twice")
            self._entries[entry.key] = entry

    def __getitem__(self, key: str) -> EntryT:
        return self._entries[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)
