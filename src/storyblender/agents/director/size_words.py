"""Sizes in words become values: measures such as ``2 m tall``, words such as ``tiny``, and whether a thing is a toy."""

from __future__ import annotations

import re
from typing import Final, Literal, get_args

from storyblender.catalog.props import PROPS
from storyblender.catalog.props.variants import TOY_WORDS
from storyblender.memory.asset_sheet import PLAUSIBLE, AssetDimension, StatedSize
from storyblender.memory.vocabulary import SizeWord, StatureWord

_MEASURE: Final = re.compile(
    r"(\d+(?:\.\d+)?)[ -]?(mm|millimet(?:er|re)s?|cm|centimet(?:er|re)s?|m|met(?:er|re)s?|feet|foot|ft|inch(?:es)?)\b"
    r"[ -]?(tall|high|wide|long|deep)?",
)
_OWN_WORDS: Final = re.compile(
    r"[,;.:(]|\b(?:and|as|at|before|behind|beside|by|for|from|has|in|inside|into|is|like|near|of|on|over|that|through|"
    r"to|under|where|which|who|whose|with)\b"
)
"""What ends the words that are said of a thing itself: ``a brass lamp`` in ``a brass lamp with a tall glass``."""
_SLIGHTLY: Final = re.compile(r"\ba little (\w+)(?=\W*$|[,;.])")
"""``a little windblown``: no little thing, but slightly so."""
_HUNG_LOW: Final = re.compile(r"\b(?:low|high|wide|long)[ -](?=\w+(?:ing|ed)\b)")
"""``a low hanging lamp``: how it hangs, not how large it is."""
Side = Literal["width", "depth", "height"]
_UNITS: Final = {"mm": 0.001, "mi": 0.001, "cm": 0.01, "ce": 0.01, "m": 1.0, "me": 1.0, "fe": 0.3048, "fo": 0.3048,
                 "ft": 0.3048, "in": 0.0254}  # fmt: skip


def stated_size(name: str, description: str, *, person: bool, kind: str | None = None) -> StatedSize:
    """Return the size that words state of an asset.

    Args:
        name: Of the asset.
        description: Of the asset, from the script.
        person: Whether it is cast as a human figure, of whom other words are said and bare measures mean nothing.
        kind: Key of the prop that it is; how long such a thing is, its longest side says.
    """
    text = f"{name}. {description}".lower()
    said = set(re.findall(r"\w+", _words_of_size(name.lower(), description.lower(), person)))
    word = next((word for word in get_args(StatureWord if person else SizeWord) if word in said), None)
    return StatedSize(
        measure=_measure(text, person, kind), word=word, toy=not person and not said.isdisjoint(TOY_WORDS)
    )


def _words_of_size(name: str, description: str, person: bool) -> str:
    """Return the words that can say how large a person or thing is: its name, and what is said of it itself."""
    name, own = (words if person else _OWN_WORDS.split(words.strip(), maxsplit=1)[0] for words in (name, description))
    nouns = re.findall(r"\w+", name)
    own = _SLIGHTLY.sub(lambda found: found[0] if found[1] in nouns else "", own)
    return _HUNG_LOW.sub("", f"{name}. {own}")


def _measure(text: str, person: bool, kind: str | None) -> AssetDimension | None:
    """Return a measure in metres: ``two metres`` is not read, ``2 m tall`` and ``30 cm`` are."""
    found = _MEASURE.search(text)
    if found is None or (person and not found[3]):
        return None
    value = float(found[1]) * _UNITS["m" if found[2] == "m" else found[2][:2]]
    sides: dict[str, Side] = {"wide": "width", "long": _length_of(kind), "deep": "depth"}
    side = sides.get(found[3] or "", "height")
    return AssetDimension(**{side: round(value, 3)}) if PLAUSIBLE[0] <= value <= PLAUSIBLE[1] else None


def _length_of(kind: str | None) -> Side:
    """Return the side that the length of a prop is: its longest; of an unknown one its depth."""
    sides: tuple[Side, Side, Side] = ("width", "depth", "height")
    known = PROPS.get(kind or "")
    size = known.size if known is not None else (0.0, 1.0, 0.0)
    return sides[size.index(max(size))]
