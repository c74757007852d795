"""Layer 1, the Storyboard Outline: scenes and shots in order, with the words they come from."""

from __future__ import annotations

import re
import textwrap
from functools import lru_cache
from typing import Literal

from pydantic import Field

from storyblender.memory.base import Digest, Frozen, SceneId, ShotId, dropping

LINE = 90
"""Characters of a title."""


WORDS_PER_SECOND = 2.5
"""How fast people speak."""
_UNSPACED = re.compile(r"[\u3040-\u30ff\u3400-\u9fff\uac00-\ud7af]")
_WORD = re.compile(r"[^\W_]+(?:['’-][^\W_]+)*")


@lru_cache(maxsize=8192)
def word_count(text: str) -> int:
    """Return the number of words; in scripts without spaces two characters count as one word."""
    unspaced = len(_UNSPACED.findall(text))
    return len(_WORD.findall(_UNSPACED.sub(" ", text))) + (unspaced + 1) // 2


class SourceSpan(Frozen):
    """A piece of the script as the user wrote it: characters ``start`` to ``end`` of the decoded text."""

    start: int = Field(ge=0)
    end: int = Field(ge=0)


class ScriptLine(Frozen):
    """One line that a shot covers, verbatim."""

    kind: Literal["action", "dialogue"]
    text: str
    span: SourceSpan
    speaker: str | None = None
    """Asset id of the speaker, for dialogue."""
    speaker_name: str = ""
    """The cue as written, for display."""
    parenthetical: str = ""
    off_screen: bool = False

    @property
    def word_count(self) -> int:
        """Number of words of the text."""
        return word_count(self.text)


class ShotOutline(Frozen):
    """A single shot within the outline."""

    shot_id: ShotId
    lines: tuple[ScriptLine, ...] = ()
    notes: tuple[str, ...] = ()
    """Notes (``[[ ]]``) of the script that stand in this shot's lines or after them, in order, without their marks."""
    _former = dropping("shot_description")


class SceneOutline(Frozen):
    """A single scene within the outline."""

    scene_id: SceneId
    scene_description: str
    heading: str = ""
    script_number: str = ""
    """The scene number written in the screenplay, if any."""
    span: SourceSpan | None = None
    shots: tuple[ShotOutline, ...] = ()
    plan_digest: Digest = ""
    """Hash of all that the crew's work on the scene rests on; the same in another plan, and the work stays."""
    notes: tuple[str, ...] = ()
    """Notes (``[[ ]]``) of the script about the scene: in its heading, or before its first line."""

    @property
    def title(self) -> str:
        """The heading; where the script has none, where and when it is and how it begins, in one line."""
        return self.heading or textwrap.shorten(self.scene_description, LINE, placeholder=" …")

    @property
    def numbered_title(self) -> str:
        """The title after the scene's number in the script, where it has one."""
        return f"{self.script_number}  {self.title}" if self.script_number else self.title
