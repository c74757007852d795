"""Files that a browser sends: kept aside, in no project, until a call takes them or others come."""

from __future__ import annotations

import re
from collections.abc import AsyncIterator
from pathlib import Path, PurePosixPath
from tempfile import TemporaryDirectory
from typing import Final

from storyblender.errors import InputError
from storyblender.library.model_folders import MODEL_SUFFIXES
from storyblender.model_content import MOST_BYTES
from storyblender.pipeline.given_models import COMPANIONS, is_file_name

BATCH: Final = re.compile(r"[0-9a-f]{16}")
"""What a page calls the files that belong together."""
_MOST_FILES: Final = 64


class TooLarge(InputError):
    """More was sent than is kept."""


class Uploads:
    """The files that came last; those of an earlier batch are forgotten when another begins."""

    def __init__(self) -> None:
        self._room: TemporaryDirectory[str] | None = None
        self._batch = ""

    async def receive(self, batch: str, name: str, pieces: AsyncIterator[bytes]) -> None:
        """Keep one file.

        Args:
            batch: Those that belong together have the same, ``BATCH``.
            name: Of the file, no path.
            pieces: What is in it.

        Raises:
            TooLarge: It is larger than a model may be, with the others of its batch, or there are too many.
            InputError: Its name is none, or that of something that is no part of a model; or the disk refuses.
        """
        suffix = PurePosixPath(name).suffix.lower()
        if not BATCH.fullmatch(batch) or not is_file_name(name) or suffix not in (*MODEL_SUFFIXES, *COMPANIONS):
            raise InputError(f"{name!r} is no file of a model", mend=f"a model ends in {', '.join(MODEL_SUFFIXES)}")
        part = self._folder(batch) / name
        others = [each for each in self.files(batch).values() if each != part]
        left = MOST_BYTES - sum(each.stat().st_size for each in others)
        if len(others) >= _MOST_FILES:
            raise TooLarge(f"a model has more than {_MOST_FILES} files", mend="give it as one .glb")
        try:
            with part.open("wb") as file:
                async for piece in pieces:
                    left -= len(piece)
                    if left < 0:
                        raise TooLarge(f"{name} is larger than {MOST_BYTES >> 20} MiB", mend="make it smaller")
                    file.write(piece)
        except TooLarge:
            part.unlink(missing_ok=True)
            raise
        except OSError as error:
            raise InputError(f"{name} cannot be kept ({error.strerror})", mend="choose it again") from error

    def files(self, batch: str) -> dict[str, Path]:
        """Return the files of a batch by name; none if it is not the last one."""
        if self._room is None or batch != self._batch:
            return {}
        return {path.name: path for path in sorted(Path(self._room.name).iterdir())}

    def forget(self) -> None:
        """Delete what is kept."""
        if self._room is not None:
            self._room.cleanup()
        self._room, self._batch = None, ""

    def _folder(self, batch: str) -> Path:
        if self._room is None or batch != self._batch:
            self.forget()
            self._room, self._batch = TemporaryDirectory(prefix="storyblender-"), batch
        return Path(self._room.name)
