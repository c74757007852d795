"""The phrases of notes, approval, locks, takes, lengths and the cut that the rules know."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import Any, Final

from storyblender.agents.instructor.parsing import ARTICLES, Table
from storyblender.memory.edits import (
    ApproveEdit,
    DurationEdit,
    Edit,
    JoinEdit,
    LockEdit,
    NoteEdit,
    OmitEdit,
    ReorderEdit,
    RestoreEdit,
    SplitEdit,
    TakeEdit,
    UnlockEdit,
)

_NOTE: Final = re.compile(
    r"(?:add (?:a )?)?note(?: (?:from|by) (?P<author>[^:]{1,64}))?\s*[:,]\s*(?P<text>.+)", re.IGNORECASE
)
_ADDRESSED: Final = frozenset(("shot", "scene"))
_PLACE: Final = re.compile(r"(?:(?:move|put|play|comes?) )?(?P<where>before|after) (?P<near>sc\d+(?:_sh\d+)?)")
_NUMBERS: Final = {
    "half": 0.5, "one": 1.0, "two": 2.0, "three": 3.0, "four": 4.0, "five": 5.0, "six": 6.0, "seven": 7.0, "eight": 8.0,
    "nine": 9.0, "ten": 10.0, "couple of": 2.0, "one and half": 1.5,
}  # fmt: skip
_COUNT: Final = rf"\d+(?:[.,]\d+)?|{'|'.join(sorted(_NUMBERS, key=len, reverse=True))}"
_SECONDS: Final = rf"(?:(?P<number>{_COUNT}) ?(?:more )?s(?:ec(?:ond)?s?)?|second)"
_HOLD: Final = r"(?:(?:hold|keep|last|lasting)(?: for)? |for )?"
_LENGTHS: Final[Table[tuple[str, float]]] = Table(
    (rf"{_HOLD}{_SECONDS} (?:longer|more)|longer by {_SECONDS}|add {_SECONDS}", ("more", 1.0)),
    (rf"{_SECONDS} (?:shorter|less)|shorter by {_SECONDS}|(?:cut|trim|lose) {_SECONDS}", ("more", -1.0)),
    (rf"{_HOLD}{_SECONDS}(?: long)?", ("exactly", 1.0)),
    (r"twice as long|double(?: length)?|(?:much|lot|far) longer|(?:much|far) too short", ("times", 2.0)),
    (r"half as long|half length|(?:much|lot|far) shorter|(?:much|far) too long", ("times", 0.5)),
    (rf"{_HOLD}longer|slower|too (?:short|fast|quick)|(?:not so|less) (?:short|fast|quick)", ("times", 1.5)),
    (r"(?:cut )?shorter|quicker|faster|too (?:long|slow)|(?:not so|less) (?:long|slow)", ("times", 1 / 1.5)),
)
"""How a number, or the one given here, is meant: added, just that, a multiple of the present length."""
_OfShot = LockEdit | UnlockEdit | SplitEdit | JoinEdit | ApproveEdit | NoteEdit | TakeEdit
_WHOLE: Final[Table[tuple[type[_OfShot], dict[str, Any]]]] = Table(
    (r"(?:lock|keep|leave)(?: all)?(?: as is)?", (LockEdit, {})),
    (r"lock (?P<parts>camera|blocking|duration|length)", (LockEdit, {})),
    (r"unlock", (UnlockEdit, {})),
    (r"(?:split|cut) at line (?P<line>\d{1,3})", (SplitEdit, {})),
    (rf"(?:split|cut) (?:at|after) (?P<seconds>{_COUNT}) ?s(?:ec(?:ond)?s?)?", (SplitEdit, {})),
    (r"join (?:(?:with|to) )?(?P<other>sc\d+_sh\d+)", (JoinEdit, {})),
    (r"(?:i )?approved?|ok(?:ay)?|looks good|final", (ApproveEdit, {})),
    (r"un-?approve|not approved|(?:withdraw|take back) approval|reopen", (ApproveEdit, {"approved": False})),
    (r"(?:resolve|close|check off|tick off) note (?P<number>\d{1,3})", (NoteEdit, {"action": "resolve"})),
    (r"note (?P<number>\d{1,3})(?: is)? (?:done|resolved|closed)", (NoteEdit, {"action": "resolve"})),
    (r"reopen note (?P<number>\d{1,3})", (NoteEdit, {"action": "reopen"})),
    (r"(?:remove|delete|drop) note (?P<number>\d{1,3})", (NoteEdit, {"action": "remove"})),
    (r"keep (?:as )?take|(?:another|other|new|next) take|one more(?: take)?", (TakeEdit, {})),
    (r"(?:(?:use|choose|back to|show) )?take (?P<number>\d{1,3})", (TakeEdit, {"action": "choose"})),
    (r"(?:drop|delete|forget) take (?P<number>\d{1,3})", (TakeEdit, {"action": "drop"})),
)
"""The edit of a shot as a whole, with its fields; a group of the pattern fills another one."""


_FIELDS: Final[dict[str, Callable[[str], Any]]] = {
    "number": int,
    "line": int,
    "seconds": lambda told: _number(told),
    "other": str.upper,
    "parts": lambda told: ({"length": "duration"}.get(told, told),),
}
"""What a group of a pattern is in an edit."""


def note_on(words: str, shot: str) -> list[Edit]:
    """Return the note that words write on a shot: ``note: too slow, cut on the look``; none where they do not.

    Args:
        words: All that is said; a note may hold commas and full stops.
        shot: Name of the shot.
    """
    match = _NOTE.fullmatch(words.strip())
    return [NoteEdit(shot=shot, text=match["text"], author=match["author"] or "")] if match is not None else []


def edits_of_cut(words: str, names: Sequence[str]) -> list[Edit]:
    """Return what words do with shots or scenes in the film; none where they mean something else.

    Args:
        words: In lower case: ``omit``, ``bring it back``, ``before SC010_SH010``.
        names: Of the shots or scenes.
    """
    words = _bare(words)
    if re.fullmatch(r"omit(?:ted)?|(?:leave|cut|take) out|drop|lose", words):
        return [OmitEdit(target=name) for name in names]
    if re.fullmatch(r"restore|(?:bring|put) back(?: in)?|back in", words):
        return [RestoreEdit(target=name) for name in names]
    if match := _PLACE.fullmatch(words):
        near, where = match["near"].upper(), match["where"]
        moved = names if where == "before" else names[::-1]
        return [ReorderEdit.model_validate({"target": name, where: near}) for name in moved]
    return []


def edits_of_shot(words: str, shot: str, seconds: float) -> list[Edit]:
    """Return the edits of a shot as a whole that words mean; none where they mean something else.

    Args:
        words: In lower case: ``approve``, ``resolve note 2``, ``lock it``, ``take 2``, ``a second longer``.
        shot: Name of the shot.
        seconds: Its length now.
    """
    words = _bare(words)
    if found := _WHOLE.look_up(words):
        match, (edit, said) = found
        target = {"target": shot} if edit in (LockEdit, UnlockEdit) else {"shot": shot}
        told = {name: _FIELDS[name](value) for name, value in _groups(match)}
        return [edit.model_validate({**target, **said, **told})]
    length = _length(words, seconds)
    return [DurationEdit(shot=shot, seconds=round(length, 3))] if length is not None else []


def _length(words: str, seconds: float) -> float | None:
    """Return the length in seconds that words give a shot: ``4 seconds``, ``longer``, ``twice as long``."""
    found = _LENGTHS.look_up(words)
    if found is None:
        return None
    match, (meant, factor) = found
    told = dict(_groups(match)).get("number", "one")
    number = factor * _number(told)
    return {"more": max(seconds + number, 0.1), "exactly": number, "times": seconds * factor}[meant]


def _number(told: str) -> float:
    return _NUMBERS.get(told) or float(told.replace(",", "."))


def _groups(match: re.Match[str]) -> list[tuple[str, str]]:
    """Return the named groups that took part in a match."""
    return [(name, value) for name, value in match.groupdict().items() if value is not None]


def _bare(words: str) -> str:
    """Return words without articles, and without the names of what is spoken of."""
    return " ".join(word for word in words.split() if word not in ARTICLES | _ADDRESSED)
