"""What a model's file name says: which of its words is the thing, and which only say more about it.

People write ``office_chair``, ``chair-office``, ``ChairOffice01`` and ``object-lamp``; collections put the noun first
as often as last.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from itertools import takewhile
from pathlib import PurePath

from storyblender.catalog.props import PROPS
from storyblender.catalog.props.variants import words_of
from storyblender.memory.asset_sheet import Asset

_SAYS_NOTHING: frozenset[str] = frozenset(
    ("object", "obj", "model", "prop", "asset", "mesh", "item", "sm", "geo", "low", "poly", "lowpoly", "lod", "final",
     "export", "exported", "copy", "untitled", "rigged", "free", "game", "ready", "cc", "glb", "gltf", "blend")
)  # fmt: skip
_COUNTED = re.compile(r"v?\d+[a-z]?|[a-z]")
_SEAM = re.compile(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])|(?<=[A-Za-z])(?=\d)")
_HEADS: frozenset[str] = frozenset(
    ("blind", "blinds", "blossom", "brewer", "case", "cover", "detector", "dispenser", "dryer", "feeder", "frame",
     "goal", "grinder", "handle", "hanger", "holder", "hook", "hutch", "leg", "lid", "lift", "maker", "mount",
     "ottoman", "part", "press", "puzzle", "rack", "reel", "shade", "shutter", "sleeve", "stand", "strap", "switch",
     "tray", "unit", "warmer", "wheel")
)  # fmt: skip
"""Words that name another thing after the name of one: a shoe rack is no shoe, a table leg no table."""


CAST_FOLDERS = frozenset(("cast", "characters", "people"))
"""Folders in which models are characters, whatever they are called."""


@dataclass(frozen=True)
class FileName:
    """The words of a name that say something, lower-case, and the one that names the thing."""

    words: tuple[str, ...]
    noun: str


def words_of_file(path: str) -> FileName:
    """Return what a model is called by its file's name.

    Args:
        path: Of the file; its folders do not count.
    """
    words = words_of(_SEAM.sub(" ", PurePath(path).stem))
    told = [word for word in words if word not in _SAYS_NOTHING and not _COUNTED.fullmatch(word)] or words
    if len(told) == 2 and (whole := "".join(told)) in _things():
        return FileName((whole,), whole)
    return FileName(tuple(told), _noun(told))


def character_file(asset: Asset, names: Iterable[str]) -> str:
    """Return the model that is called like a character: ``anna.glb``; empty where there is none.

    A name that is a thing's counts only in a folder of characters: ``rose.glb`` is a flower, ``cast/rose.glb`` is Rose.

    Args:
        asset: The character.
        names: Paths of models in the user's folders.
    """
    called = {tuple(words_of(words)) for words in (asset.name, asset.asset_id.replace("_", " ")) if words}
    for name in names:
        words = words_of_file(name).words
        if words in called and (CAST_FOLDERS & {*PurePath(name).parts[:-1]} or not set(words) & _things()):
            return name
    return ""


def _noun(words: list[str]) -> str:
    """Return the word for the thing: the last as in English, or the first if its reverse is a thing.

    Words after the things that a name begins with do not count: ``table_lamp_broken`` is a lamp.
    """
    if len(words) < 2 or words[0] not in _things() or words[-1] in _HEADS:
        return words[-1] if words else ""
    compound = words if words[-1] in _things() else [*takewhile(_things().__contains__, words)]
    return words[0] if " ".join([*compound[1:], words[0]]) in _names() else compound[-1]


@cache
def _names() -> frozenset[str]:
    return frozenset(" ".join(words_of(term)) for entry in PROPS.values() for term in (entry.name, *entry.tags))


@cache
def _things() -> frozenset[str]:
    """Return the words that alone name a thing."""
    return frozenset(name for name in _names() if " " not in name)
