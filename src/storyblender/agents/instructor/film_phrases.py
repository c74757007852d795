"""The phrases about the picture of the whole film that the rules know: its shape and its sensor."""

from __future__ import annotations

from typing import Final

from pydantic import ValidationError

from storyblender.agents.instructor.parsing import Table
from storyblender.memory.picture_format import FormatDecision

_NUMBER: Final = r"\d{1,2}(?:\.\d{1,3})?"
_PICTURE: Final = r"(?:aspect(?: ratio)?|picture|format)"
_PHRASES: Final[Table[dict[str, str]]] = Table(
    (rf"(?:in )?(?:an? )?(?P<aspect>{_NUMBER}:\d{{1,2}})(?: {_PICTURE})?", {}),
    (rf"(?:an? )?{_PICTURE} (?:of )?(?P<aspect>{_NUMBER}(?::\d{{1,2}})?)", {}),
    (rf"(?:an? )?(?P<aspect>{_NUMBER}) {_PICTURE}", {}),
    (rf"(?:in )?(?:cinemascope|scope)(?: {_PICTURE})?", {"aspect": "2.39:1"}),
    (rf"(?:in )?(?:a )?square {_PICTURE}", {"aspect": "1:1"}),
    (rf"(?:in )?(?:an? )?(?:upright|vertical) {_PICTURE}", {"aspect": "9:16"}),
    (r"(?:on |with )?(?:a )?(?P<sensor_width>super ?16|super ?35)(?: (?:sensor|camera))?", {}),
    (r"(?:on |with )?(?:a )?(?P<sensor_width>full ?frame) (?:sensor|camera)", {}),
    (r"(?:on )?(?P<sensor_width>65 ?mm film)", {}),
    (rf"(?:on |with )?(?:an? )?(?P<sensor_width>{_NUMBER}) ?mm sensor", {}),
)


def format_decision(words: str) -> FormatDecision | str | None:
    """Return what words decide about the picture of the film, or in one sentence why it cannot be; None for nothing.

    Args:
        words: In lower case: ``2.39:1``, ``cinemascope``, ``on super 35``.
    """
    found = _PHRASES.look_up(words)
    if found is None:
        return None
    match, said = found
    told = {name: value for name, value in match.groupdict().items() if value is not None}
    try:
        return FormatDecision.model_validate({**said, **told})
    except ValidationError:
        return "an aspect ratio is 0.4 to 4, and a sensor 4 to 70 mm wide"
