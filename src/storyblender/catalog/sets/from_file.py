"""Loads kit files as set kits: the head when the catalog loads, the tables when the kit is first drawn."""

from __future__ import annotations

import re
import tomllib
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Any, TypeVar

import numpy as np
from pydantic import BaseModel, ValidationError

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.kit_file import KitBody, KitHead
from storyblender.catalog.sets.tables import draw_tables
from storyblender.errors import InputError

Table = TypeVar("Table", bound=BaseModel)
_FIRST_TABLE = re.compile(r"^\[", re.MULTILINE)


@cache
def kits_from_files() -> tuple[SetKit, ...]:
    """Return the kits of the folder ``kits``, sorted by name. Raises InputError for an invalid file."""
    folder = files(__name__.rpartition(".")[0]) / "kits"
    found = (item for item in folder.iterdir() if item.name.endswith(".toml"))
    return tuple(read_kit(item) for item in sorted(found, key=lambda item: item.name))


def read_kit(file: Traversable) -> SetKit:
    """Return the kit of a file; its tables are read and checked when it first draws.

    Raises:
        InputError: The file is not a valid kit file; the message says what is wrong and where.
    """
    try:
        text = file.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise _unusable(file, "it is not UTF-8 text") from error
    head = text[: found.start()] if (found := _FIRST_TABLE.search(text)) else text
    said = _checked(file, KitHead, _parsed(file, head))
    key = file.name.removesuffix(".toml")

    @cache
    def body() -> KitBody:
        tables = {name: value for name, value in _parsed(file, text).items() if name not in KitHead.model_fields}
        return _checked(file, KitBody, tables)

    def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
        try:
            return draw_tables(key, body(), params, rng)
        except ValueError as error:
            raise _unusable(file, str(error)) from error

    plain = said.model_dump(exclude={"width", "depth", "height", "options"})
    return SetKit(
        key=key,
        draw=draw,
        width=Span(*said.width),
        depth=Span(*said.depth),
        height=Span(*said.height),
        options=dict.fromkeys(said.options, False),
        option_words=said.options,
        **plain,
    )


def _parsed(file: Traversable, text: str) -> dict[str, Any]:
    """Return the values of a TOML text. Raises InputError where it is not TOML."""
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _unusable(file, str(error)) from error


def _checked(file: Traversable, model: type[Table], values: dict[str, Any]) -> Table:
    """Return values as a model of the schema. Raises InputError that names the first wrong one."""
    try:
        return model.model_validate(values)
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        where = " ".join(str(part + 1) if isinstance(part, int) else part for part in first["loc"])
        what = first["msg"].removeprefix("Value error, ")
        raise _unusable(file, f"{where}: {what}" if where else what) from error


def _unusable(file: Traversable, why: str) -> InputError:
    """Return the error for a kit file that cannot be used."""
    return InputError(f"the kit file {file.name} cannot be used ({why})", mend="see docs/add-a-set.md")
