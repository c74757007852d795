"""What tells a user's model from any other: a digest of its file and of the credits files that apply to it."""

from __future__ import annotations

import hashlib
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from storyblender.errors import InputError
from storyblender.memory.asset_sheet import NOTE_LENGTH, Credit

MOST_BYTES = 256 << 20
"""A larger model is not read, so of that only the size counts."""
MOST_CREDIT_BYTES = 1 << 16
"""Of a credits file; a longer one is not read."""
CREDITS = "credits.toml"
"""File in a folder of models that says whose work the models in it and below it are."""


def credit_files(path: Path, folder: Path) -> list[Path]:
    """Return the credits files that apply to a model, the nearest first.

    Args:
        path: Of the model: ``chair.glb`` has ``chair.credits.toml`` beside it, or a ``credits.toml`` there or above.
        folder: The folder of models; nothing above it is looked at.
    """
    places = [place for place in path.parents if place == folder or folder in place.parents]
    names = [path.with_name(f"{path.stem}.{CREDITS}"), *(place / CREDITS for place in places)]
    return [name for name in names if name.is_file()]


def credit_lines(values: Mapping[str, Any]) -> dict[str, str]:
    """Return what a credit can hold: lines of text, each cut to its longest."""
    texts = {name: values.get(name) for name in Credit.model_fields}
    lines = {name: " ".join(text.split())[:NOTE_LENGTH] for name, text in texts.items() if isinstance(text, str)}
    return {name: "".join(filter(str.isprintable, line)) for name, line in lines.items() if line}


def credit_beside(path: Path) -> dict[str, str]:
    """Return what the credits files beside a file of the user say of it, the nearest first.

    Args:
        path: ``NAME.credits.toml`` beside it says whose work it is, or ``credits.toml``.

    Raises:
        InputError: One cannot be read.
    """
    told: dict[str, str] = {}
    for file in credit_files(path, path.parent):
        try:
            with file.open("rb") as opened:
                content = opened.read(MOST_CREDIT_BYTES + 1)
            if len(content) > MOST_CREDIT_BYTES:
                raise ValueError("too long")
            told = {**credit_lines(tomllib.loads(content.decode("utf-8-sig"))), **told}
        except (OSError, ValueError, RecursionError) as error:
            raise InputError("cannot be read as credits", mend="mend or delete it", path=file) from error
    return told


def content_of(path: Path, folder: Path) -> str:
    """Return what a model's content is known by: a changed model, or one with other credits, is another model.

    Args:
        path: Of the model.
        folder: Its folder of models.
    """
    size = path.stat().st_size
    if size > MOST_BYTES:
        return f"{size} bytes"
    with path.open("rb") as file:
        digest = hashlib.file_digest(file, "sha256")
    for credits_file in credit_files(path, folder):
        with credits_file.open("rb") as file:
            digest.update(file.read(MOST_CREDIT_BYTES + 1))
    return digest.hexdigest()[:16]
