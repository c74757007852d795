"""Runs a module that reads a user's file with Blender in a process of its own, within a time limit."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Final

from storyblender.errors import InputError

PROBLEM: Final = "problem.txt"
"""File in which the process says why it failed: the problem on the first line, the mend, if any, on the next."""
_LONGEST_TEXT: Final = 500
"""Characters of a problem or mend that are shown."""


def run_reading(module: str, arguments: tuple[str, ...], folder: Path, seconds: float) -> None:
    """Run a module that reads a file and writes what it read into a folder.

    Args:
        module: Dotted name of the module.
        arguments: Its arguments before the folder, which comes last.
        folder: Empty folder, also its working directory.
        seconds: Time limit, in seconds.

    Raises:
        InputError: The file cannot be read; one clause, without the file's name.
    """
    try:
        done = subprocess.run(
            [sys.executable, "-m", module, *arguments, str(folder)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            timeout=seconds,
            check=False,
            cwd=folder,
        )
    except subprocess.TimeoutExpired as error:
        raise InputError(f"it could not be read within {seconds:g} seconds") from error
    if (folder / PROBLEM).is_file():
        problem, _, mend = (folder / PROBLEM).read_text(encoding="utf-8").partition("\n")
        raise InputError(problem[:_LONGEST_TEXT], mend=mend[:_LONGEST_TEXT])
    if done.returncode != 0:
        raise InputError("Blender could not read it: it is damaged, or far too large")
