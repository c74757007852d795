"""What a role proposes, and how a fault is mended, in a few words with units, for the log of the crew at work."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import fields, is_dataclass
from typing import Any, Final

from pydantic import BaseModel

_LISTED, _LONGEST = 6, 80
"""Most values of a list, and most letters of a text, that are told."""
_UNITS: Final = {"width": "m", "depth": "m", "height": "m", "distance": "m", "lens": "mm", "duration": "frames"}
_FIXES: Final[dict[str, tuple[str, str]]] = {
    "azimuth": ("{} degrees around to the right", "{} degrees around to the left"),
    "elevation": ("{} degrees up", "{} degrees down"),
    "roll": ("leaned by {} degrees", "leaned back by {} degrees"),
    "turn": ("turned by {} degrees", "turned back by {} degrees"),
    "dolly": ("{} steps nearer", "{} steps farther"),
    "pan_x": ("{} of the picture's height to the right", "{} of the picture's height to the left"),
    "pan_y": ("{} of the picture's height up", "{} of the picture's height down"),
    "move_x": ("{} m to the right", "{} m to the left"),
    "move_y": ("{} m to the back", "{} m to the front"),
    "move_z": ("{} m up", "{} m down"),
    "width": ("{} m wide", "{} m wide"),
    "depth": ("{} m deep", "{} m deep"),
    "height": ("{} m high", "{} m high"),
}
"""What a number of a fix means if it is positive, and if it is negative."""


def fix_in_words(fix: Mapping[str, float | str]) -> str:
    """Return the fix of a fault in words: ``9.33 degrees around to the right, or orbit left``.

    Args:
        fix: Numbers that mend it, and under ``ops`` the names of operations to try, separated by spaces.
    """
    numbers = [_number_of_fix(name, value) for name, value in fix.items() if not isinstance(value, str) and value]
    tried = [operation.replace("_", " ") for operation in str(fix.get("ops", "")).split()]
    return ", or ".join(filter(None, (", ".join(numbers), " or ".join(tried))))


def _number_of_fix(name: str, value: float) -> str:
    words = _FIXES.get(name)
    return words[value < 0].format(_rounded(abs(value))) if words else f"{name.replace('_', ' ')} {_rounded(value)}"


def draft_in_words(draft: object) -> str:
    """Return what a draft says, in a line: its values that are not the usual ones, and how many of a kind it lists."""
    if isinstance(draft, str):
        return draft
    if isinstance(draft, int | float):
        return _rounded(draft)
    if isinstance(draft, Mapping):
        return _listed([f"{name}: {'; '.join(_facts(value)) or value}" for name, value in draft.items()], "; ")
    return "; ".join(_facts(draft))


def _facts(value: object) -> Iterator[str]:
    """Yield what the fields of a value say; what is as usual, or said before, is passed over."""
    told: list[object] = []
    for name, part, usual in _parts(value):
        if part == usual or part in told or not _says_something(part):
            continue
        told.append(part)
        label = name.replace("_", " ")
        if isinstance(part, BaseModel) or _is_dataclass_value(part):
            inner = ", ".join(said for each, own, plain in _parts(part) if own != plain and (said := _said(each, own)))
            yield f"{label}: {inner}" if inner else label
        elif said := _said(label, part):
            yield said


def _said(name: str, value: object) -> str:
    """Return a value with its name; empty for what is not told in a line."""
    label = name.replace("_", " ")
    if not _says_something(value):
        return ""
    if isinstance(value, bool):
        return label
    if isinstance(value, int | float):
        return f"{label} {_rounded(value)} {_UNITS.get(name, '')}".rstrip()
    if isinstance(value, str):
        text = " ".join(value.split())
        return f"{label} {text if len(text) <= _LONGEST else text[: _LONGEST - 3] + '...'}"
    if isinstance(value, Mapping):
        scalar = {key: each for key, each in value.items() if isinstance(each, str | int | float)}
        pairs = [_said(str(key), each) for key, each in scalar.items()] if len(scalar) == len(value) else []
        return f"{label}: {_listed(pairs, ', ')}" if pairs else _counted(len(value), label)
    if isinstance(value, Collection):
        if all(isinstance(each, int | float) for each in value):
            return f"{label} {', '.join(_rounded(each) for each in value)}" if len(value) < 4 else ""  # no rotations
        texts = [each for each in value if isinstance(each, str)]
        return f"{label} {_listed(texts, ', ')}" if len(texts) == len(value) else _counted(len(value), label)
    return ""


def _parts(value: object) -> Iterator[tuple[str, Any, Any]]:
    """Yield name, value and usual value of each field of a model or dataclass."""
    if isinstance(value, BaseModel):
        for name, field in type(value).model_fields.items():
            yield name, getattr(value, name), field.default
    elif _is_dataclass_value(value):
        for field in fields(value):  # type: ignore[arg-type]
            yield field.name, getattr(value, field.name), field.default


def _is_dataclass_value(value: object) -> bool:
    return is_dataclass(value) and not isinstance(value, type)


def _says_something(value: object) -> bool:
    return value is not None and value is not False and value not in ("", (), {}, [])


def _counted(number: int, label: str) -> str:
    return f"{number} {label.removesuffix('s') if number == 1 else label}"


def _listed(texts: list[str], between: str) -> str:
    more = [f"{len(texts) - _LISTED} more"] if len(texts) > _LISTED else []
    return between.join([*texts[:_LISTED], *more])


def _rounded(value: float) -> str:
    return f"{round(value, 2):g}"
