"""Models that people choose by name: found in their folders and their library, and read before they are used."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import SequenceMatcher
from pathlib import PurePosixPath

from storyblender.catalog.recipe import EXACT, Recipe
from storyblender.errors import EngineError, InputError
from storyblender.library.library_source import LibrarySource
from storyblender.memory.asset_sheet import Asset, AssetDecision, Provenance, file_words
from storyblender.memory.jobs import AssetJob
from storyblender.pipeline.fetching import fetched
from storyblender.pipeline.run import Run

_MOST_NAMED = 6
"""Models that a refusal names."""


def chosen_model(run: Run, decision: AssetDecision, reason: str) -> Recipe:
    """Return the recipe of a model that is named, with its files where the engine reads them.

    Args:
        run: Its sources have the models.
        decision: Names a file: by its path in a folder of models, or as the library has it.
        reason: Why it is taken.

    Raises:
        InputError: Nothing is called that, or it cannot be fetched.
    """
    for source in run.sources:
        content = source.inventory().get(decision.file)
        if content is not None:
            recipe = Recipe(
                source="file",
                key=decision.file,
                params={"content": content, **decision.params},
                score=EXACT,
                reason=reason,
                provenance=Provenance(source=source.name, file=decision.file),
            )
            return fetched(run, recipe)
    libraries = [each for each in run.sources if isinstance(each, LibrarySource)]
    for recipe in filter(None, (each.chosen(decision.file) for each in libraries)):
        return fetched(run, recipe.model_copy(update={"params": decision.params}))
    names = [name for source in run.sources for name in source.inventory()]
    names += [name for library in libraries for name in library.models]
    problem = f"no folder of models and no library has {decision.file!r}"
    raise InputError(problem, mend=_instead(decision.file, names))


def refuse_unusable(run: Run, assets: Sequence[Asset]) -> None:
    """Refuse models that there are not, that cannot be used, or that a thing is made from as it is.

    Args:
        run: Its engine reads them.
        assets: As they are to be decided, each made from a model that is named.

    Raises:
        InputError: With the name of the model, and what is wrong with it.
    """
    for asset in assets:
        assert asset.decision is not None, "a person named a model"
        recipe, before = chosen_model(run, asset.decision, "a person chose it"), run.graph.asset(asset.asset_id)
        if before.decision == asset.decision and _is_made_from(before, recipe):
            raise InputError(f"{asset.name or asset.asset_id} is made from {file_words(asset.decision.file)} already")
        job = AssetJob(asset=asset.model_copy(update={"canonical": recipe.canonical()}))
        try:
            run.engine.build_asset(job).result()
        except EngineError as error:
            _, named, said = str(error).partition(f"{PurePosixPath(recipe.key).name}: ")
            if not named:
                raise
            raise InputError(said, path=asset.decision.file) from error


def _is_made_from(asset: Asset, recipe: Recipe) -> bool:
    """Return whether an asset is built from a model as its file is now."""
    made = asset.canonical
    if made is None or not made.geometry_hash:
        return False
    return (made.key, made.params.get("content")) == (recipe.key, recipe.params.get("content"))


def _instead(wanted: str, names: Sequence[str]) -> str:
    """Return what to do about a name that nothing has: which it is meant to be, or what there is, nearest first."""
    if not names:
        return "make the story with --models FOLDER, or add the file with `storyblender library add`"
    path = PurePosixPath(wanted.lower())
    inside = [name for name in names if path.is_relative_to("/") or path.parts[1:]]
    same = [
        name for name in inside if path.parts[-len(PurePosixPath(name).parts) :] == PurePosixPath(name.lower()).parts
    ]
    if same:
        return f"name it by its path in the folder: {max(same, key=len)}"
    near = sorted(names, key=lambda name: -SequenceMatcher(None, wanted.lower(), name.lower()).ratio())
    more = f" and {len(near) - _MOST_NAMED} more" if len(near) > _MOST_NAMED else ""
    return f"there are: {', '.join(near[:_MOST_NAMED])}{more}"
