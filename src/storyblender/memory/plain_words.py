"""Sentences of the program as people read them: names in place of ids, numbers rounded, no underscores."""

from __future__ import annotations

import re
from collections.abc import Mapping

from storyblender.memory.graph import ContinuityMemoryGraph

_KEPT = r"“[^”]*”|`[^`]*`|(?<![\w/.\-])[\w/.\-]+\.[a-zA-Z]\w{1,5}\b"
"""Words of the script, commands, and names of files."""
_ARTICLES = "[Tt]he|[Aa]n?|no|key|its|his|her|their|your|this|that|another|other|things"
"""What stands before a thing so that no further article does."""
_WORD = rf"(?:\b(?P<article>{_ARTICLES}) )?(?<![\w/.\-'])(?P<word>[a-z]\w*+)(?!\.\w)"
_NUMBER = r"(?P<number>(?<![\w.])-?\d+\.\d{3,}(?![\w.]))"
_PARTS = re.compile(f"{_KEPT}|{_WORD}|{_NUMBER}")
_PLACED = re.compile(r"(?:(?:set|kept)_)*(?P<name>\w*?)_\d+")
"""The id of a thing of the set: the numbers tell several of a kind apart."""


def names_of(graph: ContinuityMemoryGraph) -> dict[str, str]:
    """Return the display name of every asset and placed object by id: ``Ilsa Lund``, ``the round table``."""
    names = {
        asset.asset_id: asset.name if asset.asset_type == "character" and asset.name else f"the {asset.name}"
        for asset in graph.assets
        if asset.name
    }
    placed = {
        item.node_id: names[item.asset_id]
        for scene in graph.scenes
        if scene.layout is not None
        for item in scene.layout.objects
        if item.asset_id in names
    }
    return placed | names


def plain(text: str, names: Mapping[str, str]) -> str:
    """Return a sentence as people read it; words of the script in “quotes” and commands in backticks stay as they are.

    Args:
        text: With ids, and numbers as the program has them.
        names: Display names by asset_id and node_id, from ``names_of``.
    """

    def said(found: re.Match[str]) -> str:
        if found["number"] is not None:
            return f"{float(found['number']):.2f}".rstrip("0").rstrip(".")
        word, article = found["word"], found["article"]
        if word is None:
            return found[0]
        name = names.get(word) or _without_underscores(word)
        if article is None:
            return name
        return f"{article} {name.removeprefix('the ')}" if name.startswith("the ") or word not in names else name

    return _PARTS.sub(said, text)


def _without_underscores(word: str) -> str:
    """Return a word of the program as people write it; a thing of the set that has no name is named after its id."""
    placed = _PLACED.fullmatch(word)
    if placed is not None and placed["name"]:
        return f"the {placed['name'].replace('_', ' ')}"
    return word.replace("_", " ").strip() or word
