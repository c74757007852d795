"""The phrases about a scene that the rules know: its light here, its set and its things in rooms of their own."""

from __future__ import annotations

import re
from typing import Any, Final, get_args

from storyblender.agents.director import lexicon
from storyblender.agents.director.lighting import light_qualities
from storyblender.agents.instructor.parsing import Table
from storyblender.agents.instructor.scene_view import SceneNow
from storyblender.agents.instructor.set_phrases import set_decision
from storyblender.agents.instructor.thing_phrases import edits_of_things
from storyblender.memory.edits import Edit, LayoutEdit, LightEdit, LockEdit, SetEdit, UnlockEdit
from storyblender.memory.scene_decision import LightDecision, SetDecision
from storyblender.memory.vocabulary import TimeOfDay

_MUCH: Final = r"(?:(?:it's |it is )?(?P<much>much|a lot|far|way) )?"
_LIGHT: Final = r"(?: (?:light|lighting|lights|colou?rs?|mood|tones?))?"
_NOT_SO: Final = r"(?:less|not so|not as|not that|too)"
_STEPS: Final[Table[tuple[str, float]]] = Table(
    (rf"{_MUCH}warmer{_LIGHT}", ("warmth", 1.0)),
    (rf"{_MUCH}{_NOT_SO} (?:cold|cool|blue){_LIGHT}", ("warmth", 1.0)),
    (rf"{_MUCH}(?:colder|cooler){_LIGHT}", ("warmth", -1.0)),
    (rf"{_MUCH}{_NOT_SO} (?:warm|orange|yellow){_LIGHT}", ("warmth", -1.0)),
    (rf"{_MUCH}(?:brighter|lighter|more light){_LIGHT}|(?:turn )?(?:the )?lights? up", ("brightness", 1.0)),
    (rf"{_MUCH}{_NOT_SO} (?:dark|dim|gloomy){_LIGHT}", ("brightness", 1.0)),
    (rf"{_MUCH}(?:darker|dimmer|gloomier|less light){_LIGHT}|(?:turn )?(?:the )?lights? down|dim the lights?",
     ("brightness", -1.0)),
    (rf"{_MUCH}{_NOT_SO} bright{_LIGHT}", ("brightness", -1.0)),
    (rf"{_MUCH}(?:more contrast(?:y)?|contrastier|harder|harsher|more dramatic|{_NOT_SO} (?:flat|soft)){_LIGHT}",
     ("contrast", 1.0)),
    (rf"{_MUCH}(?:less contrast(?:y)?|softer|flatter|{_NOT_SO} (?:harsh|hard|contrasty)|too much contrast){_LIGHT}",
     ("contrast", -1.0)),
)  # fmt: skip
"""The field of the decision, and the step; twice that for ``much``."""
_SIDE: Final = re.compile(r"(?:key|lit|(?:the )?light|(?:the )?sun)(?: comes| light)?(?: from)?(?: the)? (left|right)")
_HOUR: Final = re.compile(
    r"(?:make it |it is |it's )?(?:(?:just |right |shortly )?(?P<step>after|before) "
    r"|(?:in|at|by|around|during|late|early) )?"
    r"(?:(?:in|late|early) )?(?:the |an? )?(?P<hour>.+)"
)
_WEATHER: Final = re.compile(
    r"(?:(?:make|let) it |it is |it's |it )?(?:in |with |under )?(?:the |a )?(?:heavy |thick )?(?P<word>[^ ]+?)"
    r"(?P<verb>s)?(?: (?:outside|sky|weather|day|falls|falling))?"
)
_CLEAR: Final = re.compile(
    r"(?:no|without|stop the) (?:rain|fog|snow|storm|clouds)|(?:a )?clear (?:sky|weather|day)|(?:in the )?sunshine"
)
_STAGING: Final = re.compile(
    r"(?:try )?(?:an? )?(?:an?other|different|new|next) (?:staging|layout|arrangement|blocking)"
    r"|(?:re-?stage|re-?arrange)(?: it| the scene)?"
    r"|(?:stage|arrange|lay out|block)(?: it| the scene)? (?:again|differently|another way|anew)"
)
_FIRST_STAGING: Final = re.compile(r"(?:the )?(?:first|original) (?:staging|layout|arrangement)")
_LIT: Final = frozenset(("very", "lit", "light", "lighting", "lights", "glow", "by", "key", "low", "high", "a", "the"))
"""Words that add nothing to a quality of the light."""


def edits_of_scene(words: str, scene: SceneNow) -> list[Edit] | str:
    """Return the edits of a scene that words mean, or in one sentence why they cannot be; none if they are not known.

    Args:
        words: In lower case: ``warmer``, ``after sunset``, ``brick walls``, ``another staging``, ``add a piano``.
        scene: As it is.
    """
    for read in (_lock, _staging, _light):
        if found := read(words, scene):
            return found
    decided = set_decision(words, scene)
    if isinstance(decided, str):
        return decided
    if decided:
        return [SetEdit(scene=scene.name, decision=SetDecision.model_validate(decided))]
    return edits_of_things(words, scene)


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
    return [LayoutEdit(scene=scene.name)] if _STAGING.fullmatch(words) else []


def _light(words: str, scene: SceneNow) -> list[Edit]:
    """Return what words change about the light: a step of it, an hour, the weather, its character, its side."""
    said: dict[str, Any] = {}
    if found := _STEPS.look_up(words):
        match, (field, step) = found
        wanted = (getattr(scene.light, field) or 0.0) + step * (2 if match.groupdict().get("much") else 1)
        most = 2.0 if field == "contrast" else 3.0
        said = {field: min(max(wanted, -most), most)}
    elif match := _SIDE.fullmatch(words):
        said = {"key_side": match[1]}
    said = said or _hour(words) or _weather(words) or _character(words)
    return [LightEdit(scene=scene.name, decision=LightDecision.model_validate(said))] if said else []


def _hour(words: str) -> dict[str, Any]:
    """Return the hour that words tell; ``after`` and ``before`` it are the next and the last one."""
    match = _HOUR.fullmatch(re.sub(r"\b(?:after|by) dark\b", "at night", words))
    told = match["hour"] if match is not None else ""
    hour = lexicon.TIME_PHRASES.get(told) or lexicon.TIME_WORDS.get(told)
    if match is None or hour is None:
        return {}
    hours = get_args(TimeOfDay)
    step = {"after": 1, "before": -1}.get(match["step"] or "", 0)
    return {"time_of_day": hours[(hours.index(hour) + step) % len(hours)]}


def _weather(words: str) -> dict[str, Any]:
    if _CLEAR.fullmatch(words):
        return {"weather": "clear"}
    match = _WEATHER.fullmatch(words)
    if match is None or (match["verb"] and not re.match(r"it\b", words)):
        return {}
    weather = lexicon.WEATHER_WORDS.get(match["word"])
    return {"weather": weather} if weather is not None else {}


def _character(words: str) -> dict[str, Any]:
    """Return the qualities of the light that words name, if they name nothing else."""
    found = light_qualities(words)
    rest = {*words.split()} - _LIT
    return {"qualities": found} if found and all(light_qualities(word) or word == "red" for word in rest) else {}
