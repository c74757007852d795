"""The phrases about a set that the rules know: materials, options of its kit, its size, its period, another kit."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, Final, get_args

from storyblender.agents.instructor.scene_view import SceneNow
from storyblender.catalog.props.variants import PLAIN, words_of
from storyblender.catalog.sets import SETS
from storyblender.catalog.sets.terms_of_finishes import finish_named
from storyblender.memory.vocabulary import Period

THE: Final = r"(?:(?:the|a|an|some|all|all the|another|that|this|its|his|her|their)\s+)?"
_GROW: Final = 1.3
"""Times by which a larger set is wider and deeper."""
_SIZES: Final[tuple[tuple[str, Mapping[int, float]], ...]] = (
    (r"(?:larger|bigger|more spacious)", {0: _GROW, 1: _GROW}), (r"smaller|tighter", {0: 1 / _GROW, 1: 1 / _GROW}),
    (r"wider", {0: _GROW}), (r"narrower", {0: 1 / _GROW}),
    (r"deeper|longer", {1: _GROW}), (r"shallower", {1: 1 / _GROW}),
)  # fmt: skip
_PLACE: Final = r"(?:room|set|place|space|stage)"
_SIDES: Final = ("width", "depth", "height")


def set_decision(words: str, scene: SceneNow) -> dict[str, Any] | str:
    """Return the fields of a decision about a set that words mean, or in one sentence why they cannot be; else nothing.

    Args:
        words: In lower case: ``brick walls``, ``carpet on the floor``, ``a larger room``, ``in a kitchen``.
        scene: As it is.
    """
    return _option(words, scene) or _finish(words, scene) or _size(words, scene) or _kit(words, scene)


def _finish(words: str, scene: SceneNow) -> dict[str, Any] | str:
    for field, patterns in _surfaces().items():
        match = next(filter(None, (pattern.fullmatch(words) for pattern in patterns)), None)
        finish = finish_named(match["what"], getattr(scene, field)) if match is not None else ""
        if match is not None and finish:
            said = [word for word in words_of(match["what"]) if word in PLAIN - {"the", "a", "an"}]
            idle = [word for word in said if not finish_named(word)]
            return f"the {field} cannot be {' '.join(idle)!r}" if idle else {field: finish}
    return {}


@cache
def _surfaces() -> dict[str, tuple[re.Pattern[str], ...]]:
    """Return how people speak of the walls and of the ground."""
    surfaces = {"walls": r"walls?", "ground": r"(?:floors?|ground|flooring)"}
    return {
        field: (
            re.compile(rf"(?:with |make |paint |lay |put )?{THE}(?P<what>.+?) on (?:the )?{named}"),
            re.compile(rf"(?:with |make |paint )?{THE}(?P<what>.+?) {named}"),
            re.compile(
                rf"(?:make |paint |have )?{THE}{named}(?: (?:of|in|into|to|made of|are|is|be|should be))?"
                rf" {THE}(?P<what>.+)"
            ),
        )
        for field, named in surfaces.items()
    }


def _option(words: str, scene: SceneNow) -> dict[str, Any]:
    """Return an option of the kit that words turn on or off, snow on the ground, or a period of furniture."""
    if re.fullmatch(r"(?:with )?snow (?:lies )?on the ground|snow-?covered|snowed in|under snow", words):
        return {"snow": True}
    match = re.fullmatch(rf"(?P<off>no|without|remove|lose)?(?:with|add|put in)?\s*{THE}(?P<what>.+)", words)
    if match is not None:
        what = match["what"]
        kit = SETS.get(scene.kit)
        for option, on in scene.options.items():
            known = {option.replace("_", " "), *(kit.option_words.get(option, ()) if kit is not None else ())}
            if what in known and on == bool(match["off"]):
                return {"options": {option: not match["off"]}}
    period = re.fullmatch(rf"({'|'.join(get_args(Period))}) (?:furniture|furnishings?|period|interior)", words)
    return {"period": period[1]} if period is not None else {}


def _size(words: str, scene: SceneNow) -> dict[str, Any]:
    if not scene.size[0]:
        return {}
    if match := re.fullmatch(r"(higher|lower) ceiling", words):
        return {"height": round(scene.size[2] * (_GROW if match[1] == "higher" else 1 / _GROW), 2)}
    for pattern, grows in _SIZES:
        if re.fullmatch(rf"{THE}(?:{pattern}) {_PLACE}", words):
            return {_SIDES[side]: round(scene.size[side] * factor, 2) for side, factor in grows.items()}
    return {}


def _kit(words: str, scene: SceneNow) -> dict[str, Any]:
    """Return another kit that words name: ``in a kitchen``."""
    match = re.fullmatch(r"(?:play it |set it |move it |make it )?(?:in|into|to)?\s*an? (?P<what>.+)", words)
    if match is None:
        return {}
    fits = [kit for kit in SETS.values() if kit.indoor == scene.indoor]
    names: tuple[Callable[[Any], bool], ...] = (
        lambda kit: match["what"] in (kit.name.lower(), kit.key.replace("_", " ")),
        lambda kit: match["what"] in kit.tags[:4],
    )
    found = next((kit.key for named in names for kit in fits if named(kit)), "")
    return {"kit": found} if found and re.match(r"(?:play|set|move|make|in)\b", words) else {}
