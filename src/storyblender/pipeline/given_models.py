"""A model from a person's disk: kept in the project's own folder of models, once the engine could read it."""

from __future__ import annotations

import re
import shutil
from collections.abc import Mapping
from itertools import count
from pathlib import Path, PurePosixPath

from storyblender.catalog.recipe import EXACT, Recipe
from storyblender.errors import EngineError, InputError
from storyblender.folder import Folder
from storyblender.library.model_folders import MODEL_SUFFIXES, ModelFolders
from storyblender.library.shared.adding import named_by
from storyblender.memory.asset_sheet import Asset, Provenance
from storyblender.memory.jobs import GIVEN, AssetJob
from storyblender.model_content import content_of
from storyblender.pipeline.fetching import fetched
from storyblender.pipeline.run import Run

COMPANIONS = (".bin", ".mtl", ".png", ".jpg", ".jpeg", ".webp", ".tga", ".bmp", ".tif", ".tiff")
"""Files that a model may name: its buffer, its materials, its pictures."""
_NAME = re.compile(r"(?![ .])[^\x00-\x1f\x7f/\\:*?\"<>|]{1,120}(?<![ .])")
_WITH = "choose it together with the model, or give the model as one .glb"


def is_file_name(text: str) -> bool:
    """Tell whether a text is the name of a file or a folder, on any system, and no path."""
    return _NAME.fullmatch(text) is not None


def take_in_model(run: Run, asset_id: str, files: Mapping[str, Path]) -> str:
    """Keep a model in the project, and return how an edit names it. A file that is there is never written over.

    Args:
        run: Its engine reads the model before anything is made from it.
        asset_id: The thing that is to be made from it.
        files: The model and the files that it names, by their names; they lie together in one folder.

    Raises:
        InputError: It is no model, cannot be read, or names a file that is not given.
    """
    mains = [name for name in files if PurePosixPath(name).suffix.lower() in MODEL_SUFFIXES]
    if len(mains) != 1:
        mend = f"give one file that ends in {', '.join(MODEL_SUFFIXES)}"
        raise InputError("several models were given at once" if mains else "no model was given", mend=mend)
    source = next(each for each in run.sources if isinstance(each, ModelFolders))
    key, written = _kept(run, source, mains[0], _parts(mains[0], files))
    readable = False
    try:
        _read(run, source, run.graph.asset(asset_id), key)
        readable = True
    except EngineError as error:
        said = str(error).rpartition(f"{run.project.path(GIVEN, key)}: ")[2]
        raise InputError(f"{mains[0]}: {said}") from error
    finally:
        if written and not readable:
            run.project.files.delete(written)
    return key


def _parts(main: str, files: Mapping[str, Path]) -> dict[str, Path]:
    """Return the files of a model by where it names them. Raises InputError."""
    try:
        named = named_by(files[main])
    except InputError as error:
        raise InputError(f"{main} {error.problem}", mend=error.mend) from error
    parts = dict(files)
    for name in named:
        path = PurePosixPath(name)
        if path.name not in files or not all(map(is_file_name, path.parts)):
            raise InputError(f"{main} names {name!r}, which was not given", mend=_WITH)
        parts[name] = parts.pop(path.name) if path.name in parts else files[path.name]
    return parts


def _kept(run: Run, source: ModelFolders, main: str, parts: Mapping[str, Path]) -> tuple[str, str]:
    """Write a model under a name that no other has; return how an edit names it, and what was written, if anything."""
    files, known = run.project.files, source.inventory()
    taken = {name.lower() for name in known}
    stem, suffix = PurePosixPath(main).stem, PurePosixPath(main).suffix
    key = place = ""
    for number in count(1):
        name = stem if number == 1 else f"{stem}_{number}"
        key, place = (f"{name}{suffix}", f"{name}{suffix}") if len(parts) == 1 else (f"{name}/{main}", name)
        if key in known and _is_there(files, key, known[key], parts):
            return key, ""
        if not files.path(GIVEN, place).exists() and key.lower() not in taken:
            break
    if len(parts) == 1:
        with files.writing(f"{GIVEN}/{place}") as part:
            shutil.copyfile(parts[main], part)
    else:
        with files.writing_tree(f"{GIVEN}/{place}") as room:
            for each, given in parts.items():
                part = room / each
                part.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(given, part)
    return key, f"{GIVEN}/{place}"


def _is_there(files: Folder, key: str, content: str, parts: Mapping[str, Path]) -> bool:
    """Tell whether the project has the same model under a name, and no other folder of models hides it."""
    model = files.path(GIVEN, key)
    if not model.is_file() or content_of(model, files.path(GIVEN)) != content:
        return False
    return all(_same(model.parent / each if len(parts) > 1 else model, given) for each, given in parts.items())


def _same(one: Path, other: Path) -> bool:
    return one.is_file() and one.stat().st_size == other.stat().st_size and one.read_bytes() == other.read_bytes()


def _read(run: Run, source: ModelFolders, asset: Asset, key: str) -> None:
    """Have the engine build a thing from a model, as it would be if it were chosen. Raises EngineError, InputError."""
    recipe = Recipe(
        source="file",
        key=key,
        params={"content": source.inventory()[key]},
        score=EXACT,
        reason="a person gave it",
        provenance=Provenance(source=source.name, file=key),
    )
    update = {"dimension": None, "decision": None, "canonical": fetched(run, recipe).canonical()}
    run.engine.build_asset(AssetJob(asset=asset.model_copy(update=update))).result()
