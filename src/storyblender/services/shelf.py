"""Answers of catalogues that are kept between runs, so that the same thing is asked at most once a day."""

from __future__ import annotations

import hashlib
import json
import re
import time
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, Final

from storyblender.errors import InputError
from storyblender.folder import Folder

DAY: Final = 86400.0
"""Seconds after which an answer is asked for anew."""
_LEAD = re.compile(r"[^a-z0-9]+")


@dataclass(frozen=True)
class Kept:
    """An answer that was kept.

    Attributes:
        value: The answer, as JSON has it.
        etag: What the service calls this state of it; empty where it says none.
        asked: When it was asked for, seconds since 1970.
    """

    value: Any
    etag: str
    asked: float

    @property
    def is_fresh(self) -> bool:
        """Whether it need not be asked for anew."""
        return 0 <= time.time() - self.asked < DAY


@dataclass(frozen=True)
class Shelf:
    """A folder of answers.

    Attributes:
        folder: Of the user; None keeps nothing.
    """

    folder: Folder | None = None

    def recall(self, *name: str) -> Kept | None:
        """Return an answer; None if it is not there or cannot be read.

        Args:
            name: Service, its address and what was asked.
        """
        if self.folder is None:
            return None
        try:
            kept = json.loads(self.folder.path(_file(name)).read_bytes())
            return Kept(kept["value"], str(kept["etag"]), float(kept["asked"]))
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            return None

    def keep(self, value: Any, *name: str, etag: str = "") -> None:
        """Keep an answer; where the disk cannot take it, it is asked for again.

        Args:
            value: What JSON can hold.
            name: As for ``recall``.
            etag: What the service calls this state of it.
        """
        if self.folder is None:
            return
        with suppress(InputError):
            self.folder.write(_file(name), json.dumps({"asked": time.time(), "etag": etag, "value": value}))


def _file(name: tuple[str, ...]) -> str:
    lead = _LEAD.sub("_", name[0].lower())[:30]
    return f"{lead}/{hashlib.sha256(json.dumps(name).encode()).hexdigest()[:24]}.json"
