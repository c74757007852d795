"""Words about the light become values: its character, and lamps or an hour that change it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from storyblender.agents.director.reading import Unit
from storyblender.memory.shot_context import LightChange
from storyblender.memory.vocabulary import LightQuality, SceneType, TimeOfDay

_SWITCHES: Final = r"turn(s|ed)?|switch(es|ed)?|flip(s|ped)?|snuff(s|ed)?|blow(s|n)?"
_OUT: Final = (
    r"\b(lights?|lamps?|power|electricity|bulbs?|candles?)\b.{0,24}\b(out|off|dies?|fails?|blow)\b"
    r"|\b(black ?out|pitch dark|plunged? into darkness|goes dark|total darkness)\b"
    rf"|\b({_SWITCHES}) (off|out)\b|^(off|out|dead|dark|darkness|black)\.?$"
)
_ON: Final = (
    r"\b(lights?|lamps?|power|bulbs?|candles?)\b.{0,24}\b(on|back|up|lit)\b"
    rf"|\b({_SWITCHES}) on\b|\blights? (a|the) (lamp|candle)\b|^(on|lit|bright|back)\.?$"
)
_HOURS: Final[tuple[tuple[str, TimeOfDay], ...]] = (
    (r"\b(sun ?rise|sun rises|sun (comes|is coming) up|dawn breaks|first light)\b", "dawn"),
    (r"\b(sun ?set|sun sets|sun (goes|is going) down)\b", "sunset"),
    (r"\b(night falls|night has fallen)\b", "night"),
    (r"\b(dusk|twilight) (falls|comes)\b", "dusk"),
)
_QUALITIES: Final[dict[LightQuality, str]] = {
    # Windows are dark and lamps burn "in the dark" on every night; only a dark place or dark light asks for less.
    "dim": r"dim|dimly|gloomy|low key|low-key|shadowy|murky|(?<!in the )dark(?! (blue|windows?|sk(y|ies)|panes?))",
    "bright": "bright|brightly|high key|high-key|well lit|well-lit|sunny|radiant",
    "harsh": "harsh|hard light|stark",
    "soft": "soft|gentle|diffuse",
    "candlelight": "firelight|fire ?light|fire-lit|candle ?lit|candle ?light|by candle",
    "cold": "cold|blue light|bluish|moonlit|moonlight",
    "warm": "warm|golden|amber",
    "red": "red light|red glow|emergency light",
}
_BY_HOUR: Final[dict[TimeOfDay, tuple[tuple[LightQuality, ...], tuple[LightQuality, ...]]]] = {
    "dawn": (("cold",), ("cold",)), "morning": ((), ("soft",)), "day": (("soft",), ("bright",)),
    "noon": (("bright",), ()), "afternoon": (("warm",), ("warm",)), "sunset": (("warm",), ("warm",)),
    "dusk": ((), ()), "evening": (("warm",), ("warm",)), "night": (("warm",), ("cold", "warm")),
}  # fmt: skip
"""Hour -> usual qualities of the light indoors and outdoors (notes, 4.4)."""


def usual_light(scene_type: SceneType, time: TimeOfDay) -> tuple[LightQuality, ...]:
    """Return the qualities that light usually has at an hour, indoors or outdoors; empty if none in particular."""
    indoor, outdoor = _BY_HOUR[time]
    return indoor if scene_type == "indoor" else outdoor


def light_qualities(words: str) -> tuple[LightQuality, ...]:
    """Return the qualities of the light that words name, in the order of ``LightQuality``."""
    return tuple(name for name, pattern in _QUALITIES.items() if re.search(rf"\b({pattern})\b", words.lower()))


def light_change(words: str) -> LightChange | None:
    """Return what words change about the light: ``Suddenly the lights go out``; None if they change nothing."""
    plain = words.lower()
    lamps = "off" if re.search(_OUT, plain) else "on" if re.search(_ON, plain) else None
    hours: list[TimeOfDay] = [time for pattern, time in _HOURS if re.search(pattern, plain)]
    change = LightChange(lamps=lamps, hour=next(iter(hours), None), qualities=light_qualities(words))
    return None if change == LightChange() else change


def opening_light(units: Sequence[Unit]) -> tuple[LightQuality, ...]:
    """Return the character of the light that the first unit of a scene states, if nobody changes it there.

    Args:
        units: Of the scene, in order; empty for a scene without any.
    """
    told = units[0].changes if units else ()
    change = next((light_change(each.state) for each in told if each.subject == "light"), None)
    still = change is not None and change.lamps is None and change.hour is None
    return change.qualities if change is not None and still else ()
