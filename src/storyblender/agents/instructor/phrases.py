"""The phrases that the rules know: of the camera as scripts write them, of lengths and locks, and ``closer``."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

from pydantic import ValidationError

from storyblender.agents.director.camera_phrases import parse_note
from storyblender.agents.instructor.shot_phrases import FILLER, edits_of_shot
from storyblender.memory.camera_decision import CameraDecision, CameraInstruction
from storyblender.memory.edits import CameraEdit, DurationEdit, Edit, LockEdit, TakeEdit, UnlockEdit
from storyblender.memory.shot_sizes import SHOT_SIZES
from storyblender.memory.vocabulary import Angle

_NUMBER = r"(\d+(?:[.,]\d+)?)"
_MUCH = r"(?P<much>much|a lot|far|way)?\s*"
_F_NUMBERS: Final = {"shallow": 1.4, "deep": 32.0}
_HEIGHTS: Final[tuple[Angle, ...]] = ("worm's-eye", "low angle", "eye-level", "high angle", "bird's-eye")
_LONGER_LENS, _LONGER_SHOT = 1.4, 1.5
"""Times that ``a longer lens`` is longer, and ``longer`` a shot."""
_SHOWN = re.compile(
    r"(?:(?P<kind>single|two[- ]shot|group(?: shot)?|insert|reaction)\s*)?"
    r"(?:on|of|show|see|look at|frame)\s+(?P<who>.+)",
    re.IGNORECASE,
)
_KINDS = ("two_shot", "group", "insert")
_Change = dict[str, Any]


def edits_of_clause(
    clause: str, shot: str, camera: CameraInstruction, lens: float, seconds: float, names: Mapping[str, str]
) -> list[Edit]:
    """Return the edits of a shot that a clause means; none where its words are not known.

    Args:
        clause: ``closer``, ``85 mm``, ``over Rick's shoulder on Ilsa``, ``4 seconds``.
        shot: Name of the shot.
        camera: As it is wanted now.
        lens: mm, as it is now.
        seconds: Length of the shot now.
        names: Name of every character and object by id.
    """
    words = " ".join(FILLER.sub(" ", clause.lower()).split())
    if re.fullmatch(r"lock(?: as is)?|keep(?: as is)?|leave(?: as is)?", words):
        return [LockEdit(target=shot)]
    if words == "unlock":
        return [UnlockEdit(target=shot)]
    if whole := edits_of_shot(words, shot):
        return whole
    if (take := _take(words, shot)) is not None:
        return [take]
    if (length := _length(words, seconds)) is not None:
        return [DurationEdit(shot=shot, seconds=round(length, 3))]
    said = _relative(words, camera, lens) or _subjects(clause, names) or _direction(clause, names)
    if not said:
        return []
    try:
        return [CameraEdit(shot=shot, decision=CameraDecision.model_validate(said))]
    except ValidationError:
        return []


def _take(words: str, shot: str) -> TakeEdit | None:
    """Return what words do with takes: ``keep this take``, ``another take``, ``take 2``, ``drop take 1``."""
    if re.fullmatch(r"keep (?:(?:this|as|a|as a) )?take|(?:an?other|new|next) take|one more(?: take)?", words):
        return TakeEdit(shot=shot)
    match = re.fullmatch(r"(?:(use|choose|back to|show|drop|delete|forget) )?take (\d{1,3})", words)
    if match is None:
        return None
    dropped = match[1] in ("drop", "delete", "forget")
    return TakeEdit(shot=shot, action="drop" if dropped else "choose", number=int(match[2]))


def _length(words: str, seconds: float) -> float | None:
    """Return the length in seconds that words give a shot: ``4 seconds``, ``longer``, ``twice as long``."""
    if match := re.search(rf"{_NUMBER}\s*s(?:ec(?:ond)?s?)?\b(?!\w)", words):
        told = float(match[1].replace(",", "."))
        return seconds + told if "longer" in words else max(seconds - told, 0.1) if "shorter" in words else told
    factors = {r"twice as long|double.*|much longer": 2.0, r"half as long|much shorter": 0.5,
        r"longer|hold longer|slower": _LONGER_SHOT, r"shorter|quicker|faster": 1 / _LONGER_SHOT}  # fmt: skip
    return next((seconds * factor for pattern, factor in factors.items() if re.fullmatch(pattern, words)), None)


def _relative(words: str, camera: CameraInstruction, lens: float) -> _Change:
    """Return what changes against the present camera: ``closer``, ``lower``, ``longer lens``, ``f/2``, ``85 mm``."""
    if match := re.search(rf"\bf\s?/?\s?{_NUMBER}\b", words):
        return {"f_number": float(match[1].replace(",", "."))}
    if match := re.search(rf"{_NUMBER}\s*mm\b", words):
        return {"lens": float(match[1].replace(",", "."))}
    if re.fullmatch(r"(?:longer|tele(?:photo)?) lens", words):
        return {"lens": round(lens * _LONGER_LENS)}
    if re.fullmatch(r"(?:shorter|wider) lens", words):
        return {"lens": round(lens / _LONGER_LENS)}
    steps: tuple[tuple[str, str, Sequence[Any], int], ...] = (
        (r"(?:closer|tighter|nearer)(?: in)?", "size", SHOT_SIZES, 1),
        (r"(?:wider|looser|farther|further|more space|back)(?: away| back| out)?", "size", SHOT_SIZES, -1),
        (r"lower(?: down)?", "angle", _HEIGHTS, -1),
        (r"higher(?: up)?", "angle", _HEIGHTS, 1),
    )
    for pattern, field, scale, way in steps:
        match, now = re.fullmatch(_MUCH + f"(?:{pattern})", words), getattr(camera, field)
        if match and now in scale:
            at = scale.index(now) + way * (2 if match["much"] else 1)
            return {field: scale[min(max(at, 0), len(scale) - 1)]}
    return {}


def _subjects(clause: str, names: Mapping[str, str]) -> _Change:
    """Return whom or what a clause points the camera, or the focus, at."""
    if match := re.search(r"\b(?:rack|pull|shift)(?:\s+focus)?(?: from (.+?))? to (.+)", clause, re.IGNORECASE):
        first, last = named_in(match[1] or "", names), named_in(match[2], names)
        return {**({"focus": first[0]} if first else {}), "focus_to": last[0]} if last else {}
    if match := re.search(r"\bfocus (?:is )?on (.+)", clause, re.IGNORECASE):
        found = named_in(match[1], names)
        return {"focus": found[0]} if found else {}
    kinds: tuple[tuple[str, Callable[[list[str]], _Change]], ...] = (
        (r"\bover (.+?)(?:['’]s?)? shoulder", lambda who: {"kind": "ots", "over_id": who[0]}),
        (r"\b(.+?)(?:['’]s?)? (?:pov|point of view)|\bpov of (.+)", lambda who: {"kind": "pov", "pov_id": who[0]}),
    )
    for pattern, change in kinds:
        if match := re.search(pattern, clause, re.IGNORECASE):
            who = named_in(" ".join(filter(None, match.groups())), names)
            rest = [each for each in named_in(clause[match.end() :], names) if each not in who]
            return {**change(who), **({"focus_on_ids": rest} if rest else {})} if who else {}
    match = _SHOWN.fullmatch(clause)
    if match is None:
        return {}
    who = named_in(match["who"], names)
    kind = (match["kind"] or "").lower().replace("-", "_").replace(" ", "_").removesuffix("_shot")
    kind = {"two": "two_shot"}.get(kind, kind)
    return {"focus_on_ids": who, **({"kind": kind} if kind else {})} if who else {}


def _direction(clause: str, names: Mapping[str, str]) -> _Change:
    """Return what a camera direction, as scripts write them, asks for: ``low angle``, ``slow push in on Ilsa``."""
    if re.fullmatch(r"no (?:move|movement)|(?:hold |stay )?still|static|lock(?:ed)? off", clause.lower()):
        return {"movement": "static"}
    note = parse_note(f"SHOT: {clause}")
    if note is None:
        return {}
    said: _Change = {
        "size": note.size, "angle": note.angle, "movement": note.movement, "direction": note.direction,
        "f_number": _F_NUMBERS.get(note.focus), "kind": note.kind if note.kind in _KINDS else "",
    }  # fmt: skip
    if (said["size"] or said["movement"] or said["kind"]) and (who := named_in(note.subject, names)):
        said["focus_on_ids"] = who
    return {field: value for field, value in said.items() if value}


def named_in(words: str, names: Mapping[str, str]) -> list[str]:
    """Return the ids of the people and things that words name, in order: by id, whole name, or a word of the name.

    Args:
        words: Of a person.
        names: Name of every character and object by id.
    """
    told, found = words.lower(), dict[str, int]()
    for asset_id, name in names.items():
        for known in (name.lower(), asset_id.replace("_", " "), *name.lower().split()):
            match = re.search(rf"(?<!\w){re.escape(known)}(?!\w)", told)
            if match and len(known) > 2:
                found[asset_id] = match.start()
                break
    return sorted(found, key=lambda asset_id: found[asset_id])
