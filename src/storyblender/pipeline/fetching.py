"""Files of models that an asset source offers, brought to where the engine reads them."""

from __future__ import annotations

from storyblender.catalog.recipe import Recipe
from storyblender.pipeline.run import Run


def fetched(run: Run, recipe: Recipe) -> Recipe:
    """Return a recipe whose files the engine can read.

    Args:
        run: Its sources offer it.
        recipe: As it was found.

    Raises:
        InputError: Its source cannot give it.
    """
    origin = recipe.provenance.source if recipe.provenance else None
    source = next((each for each in run.sources if each.name == origin), None)
    return recipe if source is None else source.fetch(recipe, run.project.files)
