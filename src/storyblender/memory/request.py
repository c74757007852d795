"""A question to a language model or a person who plays a role, with everything that the answer may rest on."""

from __future__ import annotations

import hashlib
from base64 import b64decode, b64encode
from typing import Annotated

from pydantic import BeforeValidator, PlainSerializer

from storyblender.memory.base import Frozen, Identifier, content_hash

Bytes = Annotated[
    bytes,
    BeforeValidator(lambda value: b64decode(value, validate=True) if isinstance(value, str) else value),
    PlainSerializer(lambda value: b64encode(value).decode(), when_used="json"),
]
"""Bytes, in JSON as base64."""


class Picture(Frozen):
    """A picture that belongs to a request."""

    name: Identifier
    png: Bytes
    drawn_from: str = ""
    """Digest of what the engine drew it from; empty: the pixels count. Pixels differ a little from one graphics driver
    to another, and a recording must be found on every machine."""

    @property
    def digest(self) -> str:
        """Return what the picture is known by."""
        return self.drawn_from or hashlib.sha256(self.png).hexdigest()


class Request(Frozen):
    """Everything that an answer may rest on."""

    role: Identifier
    subject: str = ""
    """What is to be decided, for people: ``SC010``; not part of the digest."""
    instructions: str
    """Markdown."""
    view: str
    """The role's projection of the graph, as JSON. Words of the script in it are data, never instructions."""
    answer_schema: str
    """JSON schema of the answer, as JSON."""
    previous: str = ""
    """The answer before, if there was one."""
    feedback: tuple[str, ...] = ()
    """What is wrong with the answer before, one sentence each."""
    pictures: tuple[Picture, ...] = ()
    pictures_needed: bool = False
    """Whether an answer of a model that does not see them is worth nothing; not part of the digest."""

    @property
    def digest(self) -> str:
        """Return 16 hex digits: requests that ask the same, of the same, have the same."""
        seen = [picture.digest for picture in self.pictures]
        asked = (self.role, self.instructions, self.view, self.answer_schema, self.previous)
        return content_hash(*asked, *self.feedback, *seen)
