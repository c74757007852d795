"""Whose work a model is: from the ``credits.toml`` beside it, else from what its own file says. Read as data only."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from storyblender.blender.models.addresses import readable
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Credit
from storyblender.model_content import MOST_CREDIT_BYTES, credit_files, credit_lines


def with_files(credit: Credit, path: Path, folder: Path, notes: list[str]) -> Credit:
    """Return a credit overruled by the credits files that apply to a model, the nearest first.

    Args:
        credit: As the model's own file says.
        path: The model.
        folder: The folder of models.
        notes: Takes a sentence for each file that cannot be read.
    """
    told: dict[str, str] = {}
    for file in credit_files(path, folder):
        try:
            if readable(folder, file).stat().st_size > MOST_CREDIT_BYTES:
                raise ValueError("too long")
            told = {**credit_lines(tomllib.loads(file.read_bytes().decode("utf-8-sig"))), **told}
        except (InputError, OSError, ValueError, RecursionError) as error:
            notes.append(f"{file.name} cannot be read ({type(error).__name__}); it is left out")
    return credit.model_copy(update=told)


def credit_in_gltf(asset: Any) -> Credit:
    """Return the credit in the ``asset`` object of a glTF: its copyright, and the extras that Sketchfab writes."""
    asset = asset if isinstance(asset, Mapping) else {}
    extras = asset.get("extras")
    extras = extras if isinstance(extras, Mapping) else {}
    told = {**extras, "url": extras.get("source") or extras.get("url"), "copyright": asset.get("copyright")}
    return Credit(**credit_lines(told))


def credit_of(author: str, license_name: str, copyright_notice: str) -> Credit:
    """Return the credit that Blender's asset metadata gives.

    Args:
        author: Text of the field ``author``; each may be empty.
        license_name: Text of the field ``license``.
        copyright_notice: Text of the field ``copyright``.
    """
    return Credit(**credit_lines({"author": author, "license": license_name, "copyright": copyright_notice}))
