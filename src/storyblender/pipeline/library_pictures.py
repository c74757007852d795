"""What a person adds to the user's library is read, and its surfaces and panoramas are chosen for a scene."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TypeVar

from storyblender.catalog.recipe import EXACT, Recipe
from storyblender.errors import EngineError, InputError
from storyblender.library.library_source import may_be_used, placed_model
from storyblender.library.model_folders import MODEL_SUFFIXES
from storyblender.library.pictures import PictureKind
from storyblender.library.shared.entries import LibraryEntry
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.jobs import AssetJob
from storyblender.memory.panorama import Panorama
from storyblender.memory.texture import Texture
from storyblender.pipeline.asset_pictures import view_name
from storyblender.pipeline.panorama import take_in_panorama
from storyblender.pipeline.run import Run
from storyblender.pipeline.textures import take_in_texture
from storyblender.ports import Engine

_Taken = TypeVar("_Taken", Texture, Panorama)


def library_pictures(run: Run, kind: PictureKind, words: str) -> list[LibraryEntry]:
    """Return the surfaces or the panoramas of the library that the licence setting allows, the newest first.

    Args:
        run: Its settings say whether there is a library.
        kind: What is wanted.
        words: All of them are in name, tags, author or licence; empty for all.

    Raises:
        InputError: The library cannot be read.
    """
    found = run.library.find(words, kind) if run.library is not None else []
    return [entry for entry in found if may_be_used(entry, run.settings.licences)]


def draw_library_picture(run: Run, digest: str) -> None:
    """Draw the picture of a model of the user's library, and keep it there.

    Args:
        run: Its engine draws.
        digest: Of the entry.

    Raises:
        InputError: It is gone or damaged, or no model.
        EngineError: It cannot be read.
    """
    entry = run.library.get(digest) if run.library is not None else None
    if run.library is None or entry is None or entry.kind != "model":
        raise InputError("the library has no such model", mend="see `storyblender library list`")
    recipe = placed_model(run.library, entry, Recipe(source="file", key=entry.key, score=EXACT), run.project.files)
    job = picture_job(entry, recipe)
    name = view_name(run.graph, job.asset, "png")
    run.engine.portrait(job, name).result()
    run.outputs.note(name)
    picture = run.library.files.name_of(run.library.thumbnail_of(entry))
    run.library.files.write(picture, run.project.path(name).read_bytes())


def picture_job(entry: LibraryEntry, recipe: Recipe) -> AssetJob:
    """Return the job of drawing a model of the library by itself.

    Args:
        entry: The model.
        recipe: Where the engine that draws has its file.
    """
    canonical = recipe.canonical()
    return AssetJob(
        asset=Asset(asset_id="it", asset_type="object", description="", name=entry.name, canonical=canonical)
    )


def check_readable(engine: Engine, paths: Iterable[Path], top: Path) -> None:
    """Have models and panoramas read as for a story.

    Args:
        engine: Has the folder among its folders of models.
        paths: Of the files.
        top: The folder that they are in.

    Raises:
        InputError: One cannot be read.
    """
    from storyblender.library.panorama_file import read_panorama

    for path in paths:
        if path.suffix.lower() not in MODEL_SUFFIXES:
            read_panorama(path)
            continue
        key = path.relative_to(top).as_posix()
        recipe = Recipe(source="file", key=key, score=EXACT)
        asset = Asset(asset_id="it", asset_type="object", description="", name=path.stem, canonical=recipe.canonical())
        try:
            engine.build_asset(AssetJob(asset=asset)).result()
        except EngineError as error:
            raise InputError(str(error).rpartition(f"{top.resolve() / key}: ")[2], path=path) from error


def take_texture(run: Run, digest: str, metres: float | None = None) -> Texture:
    """Keep the pictures of a surface of the library in the project, and return what an edit of a set names it by.

    Args:
        run: The run.
        digest: Of the entry.
        metres: Width of the picture on the wall; None for what the library says, or the usual.

    Raises:
        InputError: It is gone or damaged, or no surface.
    """
    entry, path = _whole(run, digest, "texture")
    return _placed(take_in_texture(run, path.parent, metres), entry)


def take_panorama(run: Run, digest: str) -> Panorama:
    """Keep the picture of a panorama of the library in the project, and return what an edit of light names it by.

    Args:
        run: The run.
        digest: Of the entry.

    Raises:
        InputError: It is gone or damaged, or no panorama.
    """
    entry, path = _whole(run, digest, "panorama")
    return _placed(take_in_panorama(run, path), entry)


def _whole(run: Run, digest: str, kind: PictureKind) -> tuple[LibraryEntry, Path]:
    """Return an entry of the library that may be used, with its main file. Raises InputError."""
    entry = run.library.get(digest) if run.library is not None else None
    if run.library is None or entry is None or entry.kind != kind or not may_be_used(entry, run.settings.licences):
        raise InputError(f"the library has no such {kind}", mend="see `storyblender library list`")
    return entry, run.library.path_of(entry)


def _placed(taken: _Taken, entry: LibraryEntry) -> _Taken:
    """Return what was taken in, named by its source and its place in the library, where it is found again."""
    named = {"source": entry.place.partition("/")[0], "file": entry.place, **entry.credit.model_dump()}
    return taken.model_copy(update={"provenance": taken.provenance.model_copy(update=named)})
