"""The phrases about cameras that the rules know: a table of patterns and the fields that each decides.

A named group of a pattern is the field of the decision that its mention or number gives; the camera terms of scripts
(``cowboy shot``, ``crane up``, ``Nahaufnahme``) are the Director's.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from pydantic import ValidationError

from storyblender.agents.director.camera_phrases import meaning_of_term
from storyblender.agents.instructor.mentions import MARK, WHO, Mentions, Present, is_group
from storyblender.agents.instructor.parsing import ARTICLES, Table
from storyblender.memory.camera_decision import CameraDecision, CameraInstruction
from storyblender.memory.shot_sizes import SHOT_SIZES
from storyblender.memory.vocabulary import Angle


@dataclass(frozen=True)
class Steps:
    """Another value of the same scale; twice as far for ``much``."""

    by: int


@dataclass(frozen=True)
class Times:
    """A multiple of the present value."""

    factor: float


_HEIGHTS: Final[tuple[Angle, ...]] = ("worm's-eye", "low angle", "eye-level", "high angle", "bird's-eye")
_SCALES: Final[Mapping[str, Sequence[str]]] = {"size": SHOT_SIZES, "angle": _HEIGHTS}
_CLOSER, _WIDER, _UP, _DOWN = Steps(1), Steps(-1), Steps(1), Steps(-1)
_MUCH: Final = r"(?:(?P<much>much|lot|far|way) )?"
_COME: Final = r"(?:(?:move|come|bring|step|go|get)(?: camera)? )?"
_NUMBER: Final = r"\d+(?:[.,]\d+)?"
_MOTION: Final = r"(?:move(?:s|ment)?|moving|motion)"
_ON: Final = r"(?:on|onto|of|to|at|towards?|around|with)"
_OF: Final = rf"(?: (?:on|of) (?P<focus_on_ids>{WHO}))?"
_SHOW: Final = r"(?:on|of|show(?: us)?|see|look(?:ing)? at|frame|feature|point(?: camera)? at)"

PHRASES: Final[Table[dict[str, Any]]] = Table(
    # Size
    (rf"{_MUCH}{_COME}(?:closer|tighter|nearer)(?: in)?(?: {_ON} (?P<focus_on_ids>{WHO}))?", {"size": _CLOSER}),
    (rf"{_MUCH}(?:less|not so|not as|too|not that) (?:wide|loose|far(?: away| back| off)?|small)", {"size": _CLOSER}),
    (rf"{_MUCH}{_COME}(?:wider|looser|farther|further)(?: away| back| out| off)?|(?:more|some) (?:space|air|room)"
     r"|(?:back|step|move) (?:back|off|away|up)|back", {"size": _WIDER}),
    (rf"{_MUCH}(?:less|not so|not as|too|not that) (?:close|tight|near)(?: in)?", {"size": _WIDER}),
    (rf"(?:extreme|very|big) close(?:[- ]?up)?(?: shot)?{_OF}", {"size": "ECU"}),
    (rf"med(?:ium)? close(?:[- ]?up)?(?: shot)?{_OF}", {"size": "MCU"}),
    (rf"(?:close(?:[- ]?up)?|tight)(?: shot)?{_OF}", {"size": "CU"}),
    (rf"(?:mid|waist)[- ]?shot{_OF}", {"size": "MS"}),
    (r"(?:from )?head to (?:toe|foot)", {"size": "FS"}),
    (rf"(?:wide(?:[- ]angle)?(?: shot| view)?|long shot|master(?: shot)?){_OF}", {"size": "WS"}),
    (r"establishing(?: shot)?", {"size": "EWS"}),
    # Angle
    (rf"{_MUCH}(?:{_COME}higher(?: up)?|(?:too|not so|less) low)|(?:raise|lift) camera|camera (?:up|higher)",
     {"angle": _UP}),
    (rf"{_MUCH}(?:{_COME}lower(?: down)?|(?:too|not so|less) high)|(?:lower|drop) camera|camera (?:down|lower)",
     {"angle": _DOWN}),
    (rf"(?:seen |shot )?from (?:high )?above|looking down(?: (?:on|at) (?P<focus_on_ids>{WHO}))?|(?:from )?high up"
     r"|high[- ]angle(?: shot)?", {"angle": "high angle"}),
    (rf"(?:seen |shot )?from (?:down )?below|looking up(?: at (?P<focus_on_ids>{WHO}))?|(?:from )?low down"
     r"|low[- ]angle(?: shot)?", {"angle": "low angle"}),
    (r"(?:from )?(?:straight|directly) (?:above|overhead|down)|bird'?s[- ]eye(?: view)?",
     {"angle": "bird's-eye"}),
    (r"worm'?s[- ]eye(?: view)?|(?:from )?ground level|from floor", {"angle": "worm's-eye"}),
    (r"(?:at )?eye[- ](?:level|height)|(?:level|straighten) horizon|(?:no|without|not) (?:dutch(?: angle)?|tilt)",
     {"angle": "eye-level"}),
    (r"(?:tilt|cant|skew) (?:horizon|frame|picture)|(?:tilted|canted|crooked)(?: (?:horizon|angle|frame|shot))?"
     r"|dutch(?: (?:angle|tilt))?", {"angle": "dutch"}),
    # Lens and focus
    (rf"(?P<lens>{_NUMBER}) ?mm(?: lens)?", {}),
    (rf"{_MUCH}(?:longer|tele(?:photo)?) lens", {"lens": Times(1.4)}),
    (rf"{_MUCH}(?:shorter|wider) lens", {"lens": Times(1 / 1.4)}),
    (r"wide(?:[- ]angle)? lens", {"lens": 24.0}),
    (r"long lens", {"lens": 100.0}),
    (r"(?:normal|standard) lens", {"lens": 50.0}),
    (rf"(?:at )?f ?/? ?(?P<f_number>{_NUMBER})", {}),
    (r"blur(?:red|ry)? background|background (?:blurred|blurry|soft|out of focus)|soft background"
     r"|background in blur|(?:shallow|narrow|selective) (?:focus|depth of field)", {"f_number": 1.4}),
    (r"(?:everything|all|whole picture) (?:sharp|in focus)|sharp background|background (?:sharp|in focus)"
     r"|(?:don't|do not) blur background|(?:keep )?background sharp|no blur|deep (?:focus|depth of field)",
     {"f_number": 32.0}),
    (rf"focus (?:is )?on (?P<focus>{MARK})|(?:keep )?(?P<focus>{MARK}) (?:sharp|in focus)", {}),
    (rf"(?:rack|pull|shift)(?: focus)?(?: from (?P<focus>{MARK}))? to (?P<focus_to>{MARK})", {}),
    # Moves
    (rf"(?:hold |stay |keep )?(?:camera )?(?:still|static)|lock(?:ed)?[- ]off|(?:hold|stop) camera"
     rf"|(?:no|without)(?: camera)? {_MOTION}|(?:don't|do not|never|stop) (?:move|moving)(?: camera)?"
     r"|camera (?:does not|doesn't|should not|shouldn't|must not) move|camera stays(?: still| put)?",
     {"movement": "static"}),
    (rf"(?:follow|track(?: with)?) (?P<focus_on_ids>{WHO})", {"movement": "track"}),
    # Subjects
    (rf"{_SHOW} (?P<focus_on_ids>{WHO})", {}),
    (rf"(?P<focus_on_ids>{WHO}) in (?:frame|picture|shot)", {}),
    (rf"(?:only|just)(?: {_SHOW})? (?P<focus_on_ids>{MARK})|(?:{_SHOW} )?(?P<focus_on_ids>{MARK}) (?:alone|only)"
     rf"|single (?:shot )?(?:on|of) (?P<focus_on_ids>{MARK})", {"kind": "single"}),
    (rf"(?:two|2)[- ]?shot{_OF}", {"kind": "two_shot"}),
    (rf"group(?: shot)?{_OF}", {"kind": "group"}),
    (rf"(?:insert|detail)(?: (?:on|of) (?P<focus_on_ids>{MARK}))?", {"kind": "insert"}),
    (rf"reaction (?:shot )?(?:on|of) (?P<focus_on_ids>{MARK})", {"kind": "reaction"}),
    (rf"over (?P<over_id>{MARK})(?:'s?)? shoulder(?: {_ON} (?P<focus_on_ids>{WHO}))?", {"kind": "ots"}),
    (rf"over shoulder of (?P<over_id>{MARK})(?: {_ON} (?P<focus_on_ids>{WHO}))?", {"kind": "ots"}),
    (rf"(?:from )?(?P<pov_id>{MARK})(?:'s?)? (?:pov|point of view)(?: {_ON} (?P<focus_on_ids>{WHO}))?",
     {"kind": "pov"}),
    (rf"(?:pov|point of view) of (?P<pov_id>{MARK})(?: {_ON} (?P<focus_on_ids>{WHO}))?", {"kind": "pov"}),
    (rf"what (?P<pov_id>{MARK}) sees|through (?P<pov_id>{MARK})(?:'s?)? eyes|as (?P<pov_id>{MARK}) sees it",
     {"kind": "pov"}),
)  # fmt: skip
"""What is said, without articles and with a mark for each person or thing, and what it decides; the first that fits."""

_TERM: Final = re.compile(
    r"(?:(?:slow|slowly|gentle|gently) )?(?P<term>\S.*?)(?: (?:shot|angle|view|move))?"
    rf"(?: (?:to )?(?P<direction>left|right|up|down))?(?: (?:slowly|gently))?(?: {_ON} (?P<focus_on_ids>{WHO}))?"
)
_ALONE: Final = re.compile(rf"(?P<focus_on_ids>{MARK})")
_AIMED: Final = ("pan", "tilt", "pedestal", "truck", "track", "orbit")
"""Moves that have a direction."""


class CameraWords:
    """What words decide about the camera of a shot.

    Args:
        camera: As it is wanted now.
        lens: mm, as it is now.
        mentions: Finds people and things of the story.
        present: Who is there.
    """

    def __init__(self, camera: CameraInstruction, lens: float, mentions: Mentions, present: Present) -> None:
        self._camera, self._lens, self._mentions, self._present = camera, lens, mentions, present

    def read(self, words: str) -> CameraDecision | str | None:
        """Return what words decide, or in one sentence why they cannot; None where they are not known.

        Args:
            words: In lower case: ``closer``, ``85 mm``, ``over Rick's shoulder on Ilsa``.
        """
        bare = " ".join(word for word in words.split() if word not in ARTICLES)
        marked, named = self._mentions.marked(bare)
        for text in dict.fromkeys((bare, marked)):
            if found := PHRASES.look_up(text):
                return self._decision(*found, named)
        if marked == MARK and is_group(named[0]):
            return self._decision(_ALONE.fullmatch(marked), {}, named)
        match = _TERM.fullmatch(marked)
        meant = meaning_of_term(match["term"]) if match is not None else {}
        aimless = match is not None and match["direction"] and meant.get("movement") not in _AIMED
        return self._decision(match, meant, named) if meant and not aimless else None

    def _decision(
        self, match: re.Match[str] | None, decided: Mapping[str, Any], named: Sequence[str]
    ) -> CameraDecision | str:
        """Return the decision of a phrase: its own fields, and those that its groups fill."""
        assert match is not None, "it was matched"
        told = {field: value for field, value in match.groupdict().items() if value is not None and field != "term"}
        far = 2 if told.pop("much", "") else 1
        said: dict[str, Any] = {}
        for field, value in decided.items():
            if (stepped := self._stepped(field, value, far)) is None:
                return f"it is {getattr(self._camera, field)} already"
            said[field] = stepped
        for field, value in told.items():
            if MARK not in value:
                said[field] = value.replace(",", ".")
                continue
            first = match.string[: match.start(field)].count(MARK)
            ids: list[str] = []
            for mention in named[first : first + value.count(MARK)]:
                found = self._mentions.ids(mention, self._present)
                if not found or (field != "focus_on_ids" and len(found) > 1):
                    return f"on stage: {', '.join(self._present.people) or 'no one'}"
                ids += found
            said[field] = tuple(dict.fromkeys(ids)) if field == "focus_on_ids" else ids[0]
        try:
            return CameraDecision.model_validate(said)
        except ValidationError as error:
            return "; ".join(f"{'.'.join(map(str, each['loc']))}: {each['msg'].lower()}" for each in error.errors())

    def _stepped(self, field: str, value: Any, far: int) -> Any:
        """Return the value of a field; None for a step that leads nowhere."""
        if isinstance(value, Times):
            return round(self._lens * value.factor**far)
        if not isinstance(value, Steps):
            return value
        scale, now = _SCALES[field], getattr(self._camera, field)
        if now not in scale:
            return None
        wanted = scale[min(max(scale.index(now) + value.by * far, 0), len(scale) - 1)]
        return None if wanted == now else wanted


def problem_of(decision: CameraDecision) -> str:
    """Return in one sentence why a decision cannot be as a whole; empty if it can."""
    shown = decision.focus_on_ids
    if decision.kind == "two_shot" and shown is not None and len(shown) != 2:
        return f"a two-shot is of two, not of {', '.join(shown)}"
    behind = next((each for each in (decision.over_id, decision.pov_id) if shown and each in shown), None)
    return f"{behind} is behind the camera, and cannot be what it looks at" if behind is not None else ""
