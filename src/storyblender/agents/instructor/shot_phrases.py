"""The phrases of notes, approval and the cut that the rules know."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from storyblender.memory.edits import ApproveEdit, Edit, NoteEdit, OmitEdit, ReorderEdit, RestoreEdit

FILLER: Final = re.compile(r"\b(?:make (?:it|this)|a bit|a little|slightly|go|get|the|it|this|camera|shot)\b")
"""Words that add nothing to a wish."""
_NOTE: Final = re.compile(
    r"(?:add (?:a )?)?note(?: (?:from|by) (?P<author>[^:]{1,64}))?\s*[:,]\s*(?P<text>.+)", re.IGNORECASE
)
_NUMBERED: Final = (
    (r"(?:resolve|close|check off|tick off) note (\d{1,3})|note (\d{1,3})(?: is)? (?:done|resolved|closed)", "resolve"),
    (r"reopen note (\d{1,3})", "reopen"),
    (r"(?:remove|delete|drop) note (\d{1,3})", "remove"),
)  # fmt: skip
_PLACE: Final = re.compile(r"(?:move |put |play |comes? )?(?P<where>before|after) (?P<near>sc\d+(?:_sh\d+)?)")


def note_on(words: str, shot: str) -> list[Edit]:
    """Return the note that words write on a shot: ``note: too slow, cut on the look``; none where they do not.

    Args:
        words: All that is said; a note may hold commas and full stops.
        shot: Name of the shot.
    """
    match = _NOTE.fullmatch(words.strip())
    return [NoteEdit(shot=shot, text=match["text"], author=match["author"] or "")] if match is not None else []


def edits_of_cut(clause: str, names: Sequence[str]) -> list[Edit]:
    """Return what words do with shots or scenes in the film; none where they mean something else.

    Args:
        clause: ``omit``, ``bring it back``, ``before SC010_SH010``.
        names: Of the shots or scenes.
    """
    words = " ".join(FILLER.sub(" ", clause.lower()).replace(" scene", "").split())
    if re.fullmatch(r"omit(?:ted)?|leave out|cut out|drop|lose", words):
        return [OmitEdit(target=name) for name in names]
    if re.fullmatch(r"restore|bring back|put back|back in", words):
        return [RestoreEdit(target=name) for name in names]
    if match := _PLACE.fullmatch(words):
        near, where = match["near"].upper(), match["where"]
        moved = names if where == "before" else names[::-1]
        return [ReorderEdit.model_validate({"target": name, where: near}) for name in moved]
    return []


def edits_of_shot(words: str, shot: str) -> list[Edit]:
    """Return the edits of a shot as a whole that words mean; none where they mean something else.

    Args:
        words: In lower case, without fillers: ``approve``, ``resolve note 2``.
        shot: Name of the shot.
    """
    if re.fullmatch(r"(?:i )?approved?|ok(?:ay)?|looks good|final", words):
        return [ApproveEdit(shot=shot)]
    if re.fullmatch(r"(?:un-?approve|not approved|(?:withdraw|take back) approval|reopen)", words):
        return [ApproveEdit(shot=shot, approved=False)]
    for pattern, action in _NUMBERED:
        if match := re.fullmatch(pattern, words):
            number = int(next(filter(None, match.groups())))
            return [NoteEdit.model_validate({"shot": shot, "action": action, "number": number})]
    return []
