"""The inventory of things: which nouns name a thing, and which things matter to the story (notes, 4.2)."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from storyblender.agents.director.lexicon import (
    ADJECTIVES,
    ANIMALS,
    LIQUIDS,
    MOVABLE,
    PART_OF,
    PARTS,
    SEATS,
    SHAPELESS,
    VEHICLES,
    WORN,
    NounClass,
    noun_class,
    words,
)
from storyblender.agents.director.naming import asset_id
from storyblender.agents.director.reader.language.morphology import form_kind, is_person_noun
from storyblender.agents.director.reading import Thing
from storyblender.memory.scene_context import Relation

_ENDS_IN_A_SEAT = {seat: re.compile(rf"[a-z]{seat}$") for seat in SEATS}
"""``armchair`` ends in ``chair``."""
Notice = Literal["seen", "with", "related", "placed", "shown", "met", "handled", "held"]
"""How a thing comes up: mentioned, ``with X``, part of a relation, put somewhere, in capitals, looked at or what
something is done at, used, taken in the hand."""

_ORDINALS = frozenset({"first", "third", "fourth", "fifth", "next"})
_MANNER = words("manner")
_PEOPLE = words("pairs")
_WALLS = frozenset({"wall", "ceiling"})
_OPENINGS = frozenset({"door", "doorway", "window", "entrance", "gate", "counter", "monitor"})
"""What hangs over them is fixed there."""


@dataclass
class Item:
    """A noun that names a thing, and how it was mentioned."""

    id: str
    key: str
    noun_class: NounClass
    first: int
    last: int = 0
    """Where it was named last."""
    notices: Counter[str] = field(default_factory=Counter)
    determined: bool = False
    """Stood after a determiner when handled, so an unknown noun is a thing and no adverb."""


class Inventory:
    """All nouns that name things, by noun and by id.

    Args:
        ids: Asset ids in use; shared with the roster.
    """

    def __init__(self, ids: set[str]) -> None:
        self._ids = ids
        self._by_key: dict[str, Item] = {}
        self._by_id: dict[str, Item] = {}
        self._short: dict[str, Item] = {}
        self._ending: dict[str, Item] = {}
        """What a noun ends in -> the last of such nouns that came up: ``booth`` -> the corner booth."""
        self._last_seat: dict[str, Item] = {}
        self._first: dict[str, int] = {}
        """Head noun -> where it came up first."""
        self._scene_start = 0

    def id_of(self, key: str, at: int, definite: bool = False) -> str:
        """Return the id of a thing's noun, new at its first mention.

        Args:
            key: The noun with its compound: ``coffee cup``.
            at: Offset in the script.
            definite: Whether it may be a thing named before: ``the cup`` is the ``coffee cup``.
        """
        item = self._by_key.get(key) or self._short.get(key) or (self._longer(key) if definite else None)
        if item is None:
            item = Item(asset_id(key, self._ids), key, noun_class(key), at)
            self._ids.add(item.id)
            self._by_id[item.id] = item
            self._by_key[key] = item
            self._index(item)
        if " " in key and (item.noun_class == "prop" or key.rsplit(" ", 1)[-1] in VEHICLES):
            self._by_key[key.rsplit(" ", 1)[-1]] = item
        item.last = at
        return item.id

    def _index(self, item: Item) -> None:
        """Note the head noun of a new item and the nouns it ends in."""
        words = item.key.split(" ")
        for start in range(1, len(words)):
            self._ending[" ".join(words[start:])] = item
        self._last_seat.update({seat: item for seat in SEATS if _ENDS_IN_A_SEAT[seat].search(item.key)})
        self._first[words[-1]] = min(item.first, self._first.get(words[-1], item.first))

    def open_scene(self, at: int) -> None:
        """Begin a scene at an offset: from here on ``the table`` is no longer the card table of before."""
        self._scene_start, self._short = at, {}

    def _longer(self, key: str) -> Item | None:
        """Return the last item of the scene whose name ends in a noun: ``booth`` finds the corner booth."""
        seat = self._last_seat.get(key)
        if seat is not None:
            self._by_key[key] = seat
            return seat
        longer = self._ending.get(key)
        if longer is None or longer.last < self._scene_start:
            return None
        self._short[key] = longer
        return longer

    def _is_mounted(self, relation: Relation) -> bool:
        """Whether a relation fixes a thing: ``the bell over the door``, ``a telephone on the wall``."""
        anchor = self.head(relation.anchor_asset_id)
        return anchor in _WALLS or (relation.kind == "over" and anchor in _OPENINGS)

    def detach(self, id: str) -> None:
        """Make a body part without an owner present a thing of its own: the monkey's paw on the table."""
        if self._by_id[id].noun_class == "body":
            self._by_id[id].noun_class = "prop"

    def class_of(self, id: str | None) -> NounClass:
        """Return the noun class of an id; ``unknown`` for people."""
        item = self._by_id.get(id or "")
        return item.noun_class if item else "unknown"

    def head(self, id: str | None) -> str:
        """Return the head noun of an id, or an empty string."""
        item = self._by_id.get(id or "")
        return item.key.rsplit(" ", 1)[-1] if item else ""

    def note(self, id: str, how: Notice, determined: bool = False) -> None:
        """Note how a thing is mentioned; people are passed over.

        Args:
            id: Id of the thing.
            how: Named, used, held, placed ...
            determined: Whether it has a determiner or an owner, so that it surely is a thing.
        """
        item = self._by_id.get(id)
        if item:
            item.notices[how] += 1
            item.determined |= determined and how == "held"

    def notices(self) -> list[tuple[str, list[str]]]:
        """Return the id of each thing with the ways it was mentioned."""
        return [(id, [how for how, times in item.notices.items() if times]) for id, item in self._by_id.items()]

    def forget(self, id: str) -> None:
        """Remove a thing that is no physical prop: it is painted on a wall, or films the scene."""
        for how in ("seen", "met") if id in self._by_id else ():
            self._by_id[id].notices[how] = max(0, self._by_id[id].notices[how] - 1)

    def ids(self) -> list[str]:
        """Return the ids of all things so far."""
        return list(self._by_id)

    def story_things(self, relations: Sequence[Relation]) -> list[tuple[Thing, bool]]:
        """Return the things for the asset sheet in order of mention, each with whether its noun is unknown.

        Args:
            relations: Where things are; what hangs or lies somewhere is no garment that is only worn.
        """
        placed = [relation for relation in relations if relation.anchor_asset_id in self._by_id]
        apart = {relation.asset_id for relation in placed}
        borne = {relation.asset_id for relation in placed if relation.kind in ("on", "in")}
        mounted = {relation.asset_id for relation in placed if self._is_mounted(relation)}
        things: list[tuple[Thing, bool]] = []
        for item in sorted(self._by_id.values(), key=lambda item: (item.first, item.id)):
            handled = bool(item.notices["handled"] + item.notices["held"])
            if not item.notices.total() or self._is_part(item):
                continue
            if item.noun_class == "set_piece":
                head = item.key.rsplit(" ", 1)[-1]
                kind = "vehicle" if head in VEHICLES else "set_piece"
                kind = "prop" if head in MOVABLE and (handled or item.id in borne) else kind
                things.append((Thing(item.id, item.key, kind, handled=handled, first=item.first), False))
            elif _belongs_on_sheet(item, item.id in apart):
                thing = Thing(item.id, item.key, "prop", handled=handled, first=item.first)
                thing.kind = "set_piece" if item.id in mounted and not handled else "prop"
                things.append((thing, item.noun_class == "unknown"))
        return things

    def _is_part(self, item: Item) -> bool:
        """Whether a thing belongs to one named before it: the engine of a van, the trunk of a tree."""
        wholes = PART_OF.get(item.key, frozenset())
        return any(self._first.get(whole, item.first) < item.first for whole in wholes)

    def parts(self) -> set[str]:
        """Return ids of things that are used but not built: parts of other things, food and drink."""
        used = {id for id, item in self._by_id.items() if item.notices["handled"]}
        return {id for id in used if self.head(id) in PARTS | LIQUIDS or self._is_part(self._by_id[id])}


def _belongs_on_sheet(item: Item, apart: bool) -> bool:
    """Whether a prop, a garment or an unknown noun belongs on the asset sheet.

    Args:
        item: The noun.
        apart: Whether it has a place of its own, not on a person.
    """
    notices, head = item.notices, item.key.rsplit(" ", 1)[-1]
    used = notices["handled"] + notices["held"]
    if item.noun_class == "unknown":
        return notices["held"] > 0 and item.determined and not _names_no_thing(head)
    if item.noun_class == "worn" or (item.noun_class == "prop" and head in WORN):
        return used > 0 or apart
    if item.noun_class != "prop":
        return False
    if head in PARTS:
        return notices["held"] > 0
    if head in LIQUIDS:
        return used > (1 if head in SHAPELESS else 0)
    return True


def _names_no_thing(word: str) -> bool:
    """Whether a noun is no thing's name: ``lets go of it``, ``so wet``, ``sunburned``, ``his partner``."""
    person = word in _PEOPLE or (is_person_noun(word) and word not in ANIMALS)
    other = word in ADJECTIVES or word in _ORDINALS or word in _MANNER or word.endswith("ed")
    return person or other or form_kind(word) == "base"
