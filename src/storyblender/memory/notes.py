"""Notes: what people write about a finished shot, to be done or to be remembered."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from storyblender.memory.base import Frozen

MOST_NOTES = 999
"""Of a shot."""
NoteText = Annotated[str, Field(min_length=1, max_length=2000)]
NoteAuthor = Annotated[str, Field(max_length=64)]


class Note(Frozen):
    """A note on a shot."""

    number: int = Field(ge=1, le=MOST_NOTES)
    """Within its shot; never given twice while the note is there."""
    text: NoteText
    author: NoteAuthor = ""
    """Who wrote it; may be empty."""
    resolved: bool = False
    """Whether it is done."""

    @property
    def words(self) -> str:
        """The note as a person reads it: ``Ilsa: slower here``."""
        return f"{self.author}: {self.text}" if self.author else self.text
