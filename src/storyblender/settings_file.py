"""A file of settings: TOML beside a script, JSON in a project; and in which line of it a setting stands."""

from __future__ import annotations

import json
import re
import reprlib
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from storyblender.errors import InputError

_LONGEST_FILE = 1024**2
"""Bytes of settings, far more than anyone writes."""
_PLACE = re.compile(r" \(at (?:line (\d+), column \d+|end of document)\)$")
"""Where Python's TOML reader says that it stopped."""

REMEMBERED = "settings.json"
"""In a project: what it was made with."""


@dataclass(frozen=True)
class SettingsFile:
    """A file of settings as it was read: TOML beside a script, JSON in a project."""

    path: Path
    text: str
    values: dict[str, Any]

    def paths(self, name: str) -> Any:
        """Return a setting with each path in it, one or a list, taken from the file's folder; else as it is."""
        value, home = self.values[name], self.path.parent.absolute()
        if isinstance(value, list):
            return [home / item if isinstance(item, str) else item for item in value]
        return home / value if isinstance(value, str) else value

    @classmethod
    def read(cls, path: Path) -> SettingsFile | None:
        """Read a file; None where there is none.

        Raises:
            InputError: It holds something else than settings.
        """
        try:
            if not path.is_file():
                return None
        except OSError:  # the name is too long for the disk; the folder itself is refused when it is made
            return None
        text, line = "", None
        try:
            if path.stat().st_size > _LONGEST_FILE:
                raise ValueError("it is far too long")
            text = path.read_bytes().decode("utf-8-sig")
            values = tomllib.loads(text) if path.suffix == ".toml" else json.loads(text)
            if not isinstance(values, dict):
                raise ValueError("it should be names and values")
            return cls(path, text, values)
        except RecursionError:
            problem = "it is nested too deeply"
        except UnicodeDecodeError:
            problem = "it is not UTF-8 text"
        except json.JSONDecodeError as error:
            problem, line = error.msg, error.lineno
        except ValueError as error:
            problem = str(error)
            if place := _PLACE.search(problem):
                problem, line = problem[: place.start()], int(place[1]) if place[1] else text.count("\n") + 1
            if "integer string conversion" in problem:
                problem = "a number has thousands of digits"
        raise InputError(f"cannot be read as settings ({problem})", mend="mend or delete it", path=path, line=line)

    def line_of(self, name: str) -> int | None:
        """Return the line that a setting stands in, if it is to be found."""
        for part in reversed(name.split(".")):
            key = rf'^\s*[\["\'{{]*\s*["\']?{re.escape(part)}["\']?\s*[\]=:.]'
            if found := re.search(key, self.text, re.MULTILINE):
                return self.text.count("\n", 0, found.end()) + 1
        return None


def short(value: object) -> str:
    """Return a value as it is written, cut where it is long or deep."""
    shortened = reprlib.Repr()
    shortened.maxstring = shortened.maxother = 60
    return shortened.repr(value)
