"""The phrases of light, set, staging and things that the rules know; their words are those of the catalogue."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any, Final, get_args

from storyblender.agents.director import lexicon
from storyblender.agents.director.lighting import light_qualities
from storyblender.agents.director.reader.page.hours import time_in_text
from storyblender.agents.instructor.scene_view import SceneNow
from storyblender.catalog.props.prop_names import kind_named, prop_named
from storyblender.catalog.sets import SETS
from storyblender.catalog.sets.terms_of_finishes import finish_named
from storyblender.memory.edits import AssetEdit, Edit, LayoutEdit, LightEdit, LockEdit, SetEdit, UnlockEdit
from storyblender.memory.scene_decision import LightDecision, SetDecision
from storyblender.memory.vocabulary import Period, TimeOfDay

_MUCH: Final = r"(?:(?P<much>much|a lot|far|way)\s+)?"
_LIGHT: Final = r"(?:\s+(?:light|lighting|lights|colou?rs?|mood|tones?))?"
_THE: Final = r"(?:(?:the|a|an|some|all|all the|another|that|this|its|his|her|their)\s+)?"
_STEPS: Final[tuple[tuple[str, str, float], ...]] = (
    (r"warmer", "warmth", 1.0), (r"(?:colder|cooler)", "warmth", -1.0),
    (r"(?:brighter|lighter)", "brightness", 1.0), (r"(?:darker|dimmer|gloomier)", "brightness", -1.0),
    (r"(?:more contrast(?:y)?|contrastier|harder|harsher|more dramatic)", "contrast", 1.0),
    (r"(?:less contrast(?:y)?|softer|flatter)", "contrast", -1.0),
)  # fmt: skip
"""What is said, the field of the decision, and the step; twice that for ``much``."""
_PLAIN: Final = frozenset(
    ("a", "an", "the", "it", "at", "by", "in", "of", "to", "is", "make", "let", "be", "set", "change", "into", "around",
     "scene", "time", "light", "lighting", "sky", "weather", "with", "under", "early", "late", "all", "over", "outside",
     "there", "some", "hour", "now", "put", "turn", "falls", "falling", "comes")
)  # fmt: skip
"""Words that add nothing to an hour, a weather or a quality of the light."""
_STAGING: Final = re.compile(
    r"(?:an?other|different|new|next) (?:staging|layout|arrangement|blocking)"
    r"|(?:re-?stage|re-?arrange)(?: it| the scene)?"
    r"|(?:stage|arrange|lay out|block)(?: it| the scene)? (?:again|differently|another way|anew)"
)
_FIRST_STAGING: Final = re.compile(r"(?:the )?(?:first|original) (?:staging|layout|arrangement)")
_REPLACE: Final[tuple[str, ...]] = (
    rf"(?:replace|swap|exchange|trade|change|turn|make)\s+{_THE}(?P<thing>.+?)\s+(?:by|with|for|to|into)\s+{_THE}(?P<model>.+)",
    rf"{_THE}(?P<model>.+?)\s+(?:instead of|in place of|rather than)\s+{_THE}(?P<thing>.+)",
    r"make\s+the\s+(?P<thing>\w+(?: \w+)?)\s+an?\s+(?P<model>.+)",
)
_REMOVE: Final = rf"(?:remove|delete|lose|take away|take out|clear away|get rid of|without|no)\s+{_THE}(?P<thing>.+)"
_ADD: Final = r"(?:add|put in|bring in|with|place)\s+(?:an?|some|another)\s+(?P<model>.+)"
_GROW: Final = 1.3
"""Times by which a larger set is wider and deeper."""
_SIZES: Final[tuple[tuple[str, Mapping[int, float]], ...]] = (
    (r"(?:larger|bigger|more spacious)", {0: _GROW, 1: _GROW}), (r"smaller|tighter", {0: 1 / _GROW, 1: 1 / _GROW}),
    (r"wider", {0: _GROW}), (r"narrower", {0: 1 / _GROW}),
    (r"deeper|longer", {1: _GROW}), (r"shallower", {1: 1 / _GROW}),
)  # fmt: skip
_PLACE: Final = r"(?:room|set|place|space|stage)"
_SIDES: Final = ("width", "depth", "height")


def edits_of_scene(clause: str, scene: SceneNow) -> list[Edit]:
    """Return the edits of a scene that a clause means; none where its words are not known.

    Args:
        clause: ``warmer``, ``after sunset``, ``brick walls``, ``another staging``, ``replace the sofa by a bench``.
        scene: As it is.
    """
    words = " ".join(re.sub(r"[!?\"“”]", " ", clause.lower()).split())
    words = re.sub(r"^(?:a bit|a little|slightly|make it|make this|it is|it's|now)\s+", "", words)
    for read in (_lock, _staging, _light, _set, _things):
        if found := read(words, scene):
            return found
    return []


def _lock(words: str, scene: SceneNow) -> list[Edit]:
    match = re.fullmatch(r"(?P<un>un)?lock (?:the )?(?P<part>light|lighting|set|layout|staging)", words)
    if match is None:
        return []
    part = {"lighting": "light", "staging": "layout"}.get(match["part"], match["part"])
    said: dict[str, Any] = {"target": scene.name, "parts": (part,)}
    return [UnlockEdit(**said) if match["un"] else LockEdit(**said)]


def _staging(words: str, scene: SceneNow) -> list[Edit]:
    if _FIRST_STAGING.fullmatch(words):
        return [LayoutEdit(scene=scene.name, staging=0)]
    return [LayoutEdit(scene=scene.name)] if _STAGING.fullmatch(re.sub(r"^(?:try )?(?:an? )?", "", words)) else []


def _light(words: str, scene: SceneNow) -> list[Edit]:
    """Return what words change about the light: a step of it, an hour, the weather, its character, its side."""
    said: dict[str, Any] = {}
    for pattern, field, step in _STEPS:
        if match := re.fullmatch(rf"{_MUCH}{pattern}{_LIGHT}", words):
            wanted = (getattr(scene.light, field) or 0.0) + step * (2 if match["much"] else 1)
            most = 2.0 if field == "contrast" else 3.0
            said = {field: min(max(wanted, -most), most)}
    if match := re.fullmatch(r"(?:key|lit|light|sun)(?: comes| light)?(?: from)?(?: the)? (left|right)", words):
        said = {"key_side": match[1]}
    said = said or _hour(words) or _weather(words) or _character(words)
    return [LightEdit(scene=scene.name, decision=LightDecision.model_validate(said))] if said else []


def _hour(words: str) -> dict[str, Any]:
    """Return the hour that words tell; ``after`` and ``before`` it are the next and the last one."""
    dark = re.sub(r"\b(?:after|by) dark\b", "at night", words)
    match = re.fullmatch(r"(?:(?:just|right|shortly) )?(?:(after|before) )?(.+)", dark)
    hour = time_in_text(dark)
    if match is None or hour is None:
        return {}
    known = {*lexicon.TIME_WORDS, *(word for phrase in lexicon.TIME_PHRASES for word in phrase.split())}
    if {*match[2].split()} - known - _PLAIN:
        return {}
    hours = get_args(TimeOfDay)
    step = {"after": 1, "before": -1}.get(match[1] or "", 0)
    return {"time_of_day": hours[(hours.index(hour) + step) % len(hours)]}


def _weather(words: str) -> dict[str, Any]:
    if re.fullmatch(
        r"(?:no|without) (?:rain|fog|snow|storm|clouds)|(?:a )?clear (?:sky|weather|day)|(?:in the )?sunshine", words
    ):
        return {"weather": "clear"}
    told = words.split()
    named = [lexicon.WEATHER_WORDS[word] for word in told if word in lexicon.WEATHER_WORDS]
    plain = {*told} - lexicon.WEATHER_WORDS.keys() - _PLAIN - {"rains", "snows", "heavy", "thick"}
    rains = [word.removesuffix("s") for word in told if word in ("rains", "snows")]
    named += [lexicon.WEATHER_WORDS[word] for word in rains]
    return {"weather": named[0]} if named and not plain else {}


def _character(words: str) -> dict[str, Any]:
    """Return the qualities of the light that words name, if they name nothing else."""
    found = light_qualities(words)
    rest = {*words.split()} - _PLAIN - {"very", "lit", "glow", "key", "low", "high"}
    return {"qualities": found} if found and all(light_qualities(word) or word == "red" for word in rest) else {}


def _set(words: str, scene: SceneNow) -> list[Edit]:
    """Return what words change about the set: a material, an option, its size, its period, another kit."""
    said = _finish(words, scene) or _option(words, scene) or _size(words, scene) or _kit(words, scene)
    return [SetEdit(scene=scene.name, decision=SetDecision.model_validate(said))] if said else []


def _finish(words: str, scene: SceneNow) -> dict[str, Any]:
    surfaces = (("walls", r"walls?"), ("ground", r"(?:floors?|ground|flooring)"))
    for field, named in surfaces:
        match = re.fullmatch(rf"(?:with |make |paint )?{_THE}(?P<what>.+?) {named}", words)
        match = match or re.fullmatch(
            rf"(?:make |paint |have )?{_THE}{named}(?: (?:of|in|into|to|made of|are|is|be))? {_THE}(?P<what>.+)", words
        )
        finish = finish_named(match["what"], getattr(scene, field)) if match is not None else ""
        if finish:
            return {field: finish}
    return {}


def _option(words: str, scene: SceneNow) -> dict[str, Any]:
    """Return an option of the kit that words turn on or off, snow on the ground, or a period of furniture."""
    if re.fullmatch(r"(?:with )?snow (?:lies )?on the ground|snow-?covered|snowed in|under snow", words):
        return {"snow": True}
    match = re.fullmatch(rf"(?P<off>no|without|remove|lose)?(?:with|add|put in)?\s*{_THE}(?P<what>.+)", words)
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
        if re.fullmatch(rf"{_THE}(?:{pattern}) {_PLACE}", words):
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


def _things(words: str, scene: SceneNow) -> list[Edit]:
    """Return what words replace, take away or add: only of what is there, and only what the library has."""
    for pattern in _REPLACE:
        match = re.fullmatch(pattern, words)
        if match is not None and (thing := _there(match["thing"], scene)) and prop_named(match["model"]):
            return [AssetEdit(action="replace", thing=thing, scene=scene.name, model=match["model"])]
    match = re.fullmatch(_REMOVE, words)
    if match is not None and (thing := _there(match["thing"], scene)):
        return [AssetEdit(action="remove", thing=thing, scene=scene.name)]
    match = re.fullmatch(_ADD, words)
    if match is not None and prop_named(match["model"]):
        return [AssetEdit(action="add", scene=scene.name, model=match["model"])]
    return []


def _there(name: str, scene: SceneNow) -> str:
    """Return how an edit calls what words name, if the scene has it: the id of a thing, or the words themselves."""
    as_id, kind = "_".join(name.split()), kind_named(name)
    if as_id in scene.things:
        return as_id
    own = next((asset_id for asset_id, prop in scene.things.items() if kind and prop == kind), "")
    furnished = as_id in scene.furniture or (bool(kind) and kind in scene.furniture.values())
    return own or (as_id if as_id in scene.furniture else name if furnished or kind else "")
