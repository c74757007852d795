"""What a critic who looked at the light may ask for, and what it does to the numbers of a light plan."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Final, Literal, get_args

from storyblender.agents.visual_effects_artist.decided import warmed
from storyblender.memory.scene_context import Fog, Lighting
from storyblender.reflection import Fault

Air = Literal["clear", "haze", "smoke"]
LightOperation = Literal[
    "set_darker", "set_lighter", "faces_darker", "faces_lighter", "warmer", "cooler", "more_contrast", "less_contrast",
    "key_from_left", "key_from_right", "lamp_brighter", "lamp_dimmer", "haze", "clear_air",
]  # fmt: skip
"""The closed list of operations."""

_STOP: Final = 2.0
"""Factor of an operation on the level of the set, of which a board shows a part only, and on the power of a lamp."""
_STEP: Final = 2**0.5
"""The same on the level of faces and on the contrast: half a stop."""
_LEAST: Final = 0.006
"""Least luminance of a set that a board can show."""
_RATIO: Final = (1.0, 16.0)
"""Least and most key to fill."""
_THINNER: Final = 0.4
"""Share of the density of the air that is left where it is clear."""
_AIR: Final[dict[str, tuple[float, float]]] = {"haze": (0.014, 3.0), "smoke": (0.028, 2.0)}
"""Least density per metre of the air, and metres from the camera to where it begins at most."""
_Update = dict[str, object]


def with_air(fog: Fog, air: Air) -> Fog:
    """Return the air of a light plan made clear, hazy or full of smoke; thick air stays as thick.

    Args:
        fog: As planned.
        air: As it is to be.
    """
    density, start = _AIR.get(air, (0.0, fog.start))
    density = max(density, fog.density) if density else fog.density * _THINNER
    return fog.model_copy(update={"density": density, "start": min(start, fog.start)})


def after_operations(plan: Lighting, faults: Iterable[Fault]) -> Lighting:
    """Return a light plan after the operations that faults name, each once.

    Args:
        plan: The light plan.
        faults: ``lamp_brighter`` and ``lamp_dimmer`` are about the light that is the fault's subject, and about every
            lamp in the picture where that is none; all others are about the plan.
    """
    named = ((str(operation), fault.subject) for fault in faults for operation in str(fault.fix.get("ops", "")).split())
    asked = dict.fromkeys(
        (name, subject if name in _LAMPS else "") for name, subject in named if name in get_args(LightOperation)
    )
    for name, subject in asked:
        if name in _LAMPS:
            plan = _with_lamps(plan, subject, _LAMPS[name])
        else:
            plan = plan.model_copy(update=_OPERATIONS[name](plan))
    return plan


def _with_lamps(plan: Lighting, name: str, gain: float) -> Lighting:
    """Return a plan with one light, or else all lamps in the picture, stronger by a factor."""
    known = name in {light.name for light in plan.lights}
    lights = tuple(
        light.model_copy(update={"power": round(light.power * gain, 3)})
        if light.name == name or (not known and light.role == "practical")
        else light
        for light in plan.lights
    )
    return plan.model_copy(update={"lights": lights})


def _level(name: str, gain: float) -> Callable[[Lighting], _Update]:
    """Return the operation that multiplies a luminance of a plan; a set is never darker than a board can show."""
    return lambda plan: {name: round(max(getattr(plan, name) * gain, _LEAST), 4)}


def _contrast(gain: float) -> Callable[[Lighting], _Update]:
    """Return the operation that multiplies the key to fill ratio of a plan."""
    least, most = _RATIO
    return lambda plan: {"key_fill_ratio": round(min(max(plan.key_fill_ratio * gain, least), most), 2)}


def _air(air: Air) -> Callable[[Lighting], _Update]:
    """Return the operation that changes the air of a plan."""
    return lambda plan: {} if plan.fog is None else {"fog": with_air(plan.fog, air)}


_LAMPS: Final[Mapping[str, float]] = {"lamp_brighter": _STOP, "lamp_dimmer": 1 / _STOP}
_OPERATIONS: Final[Mapping[str, Callable[[Lighting], _Update]]] = {
    "set_darker": _level("set_luminance", 1 / _STOP),
    "set_lighter": _level("set_luminance", _STOP),
    "faces_darker": _level("face_luminance", 1 / _STEP),
    "faces_lighter": _level("face_luminance", _STEP),
    "warmer": lambda plan: warmed(plan, 1.0),
    "cooler": lambda plan: warmed(plan, -1.0),
    "more_contrast": _contrast(_STEP),
    "less_contrast": _contrast(1 / _STEP),
    "key_from_left": lambda plan: {"key_side": "left"},
    "key_from_right": lambda plan: {"key_side": "right"},
    "haze": _air("haze"),
    "clear_air": _air("clear"),
}
"""What each operation does to the fields of a plan."""
