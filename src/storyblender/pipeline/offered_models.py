"""What the catalogues of services offer for a thing, with small pictures, for a person to choose by eye."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from storyblender.catalog.recipe import EXACT, Recipe
from storyblender.errors import InputError, ServiceFailure
from storyblender.library.catalogue_source import CatalogueSource
from storyblender.library.small_picture import small_picture
from storyblender.memory.asset_sheet import Provenance
from storyblender.memory.base import content_hash
from storyblender.pipeline.asset_pictures import SHOWN, view_for
from storyblender.pipeline.fetching import fetched
from storyblender.pipeline.run import Run
from storyblender.ports import AssetSource
from storyblender.services.offers import Offer


@dataclass(frozen=True)
class OfferedModel:
    """A model of a catalogue that is not fetched yet.

    Attributes:
        key: An edit names it so once it is fetched.
        score: How well it fits, 1 to 10.
        offer: What the service says of it.
    """

    key: str
    score: float
    offer: Offer

    @property
    def picture(self) -> str:
        """Name of its picture in the project."""
        return picture_name(self.key)


def picture_name(key: str) -> str:
    """Return the name, in the project, of the picture of an offered model.

    Args:
        key: Of the model.
    """
    return f"{SHOWN}/{content_hash('offer', key)}.png"


@dataclass(frozen=True)
class OfferedModels:
    """What catalogues offer for a thing.

    Attributes:
        models: Best first.
        waiting: Services that have not answered yet.
        failures: What is wrong with those that cannot be asked, one sentence each.
    """

    models: tuple[OfferedModel, ...]
    waiting: tuple[str, ...]
    failures: tuple[str, ...]


def offered_models(run: Run, asset_id: str, words: str) -> OfferedModels:
    """Return what the catalogues of the settings offer for a thing so far; nothing is fetched, no service waited for.

    Asked again, it has what has come since. A service that does not answer within seconds is among the failures.

    Args:
        run: Its sources offer.
        asset_id: The thing.
        words: What is looked for; what the script says of the thing if empty.
    """
    view = view_for(run, asset_id, words)
    models: list[OfferedModel] = []
    waiting: list[str] = []
    failures: list[str] = []
    for source in catalogues_of(run.sources):
        try:
            found = source.offered(view)
        except ServiceFailure as failure:
            failures.append(str(failure))
            continue
        if found is None:
            waiting.append(source.name)
        models += [OfferedModel(recipe.key, recipe.score, source.offer_of(recipe.key)) for recipe in found or ()]
    return OfferedModels(tuple(sorted(models, key=lambda each: -each.score)), tuple(waiting), tuple(failures))


def catalogues_of(sources: Iterable[AssetSource]) -> list[CatalogueSource]:
    """Return the catalogues of services among the sources of assets, in their order."""
    return [source for source in sources if isinstance(source, CatalogueSource)]


def picture_of_offer(run: Run, key: str) -> Path | None:
    """Return the picture of an offered model, asked for once; None where the service has none, or does not give it.

    Args:
        run: Its sources offered it.
        key: Of the model.

    Raises:
        InputError: It is not offered any more.
    """
    name, source = picture_name(key), _source(run, key)
    if not run.outputs.whole(name):
        try:
            run.outputs.write(name, small_picture(source.thumbnail(key)))
        except (ServiceFailure, InputError):
            return None
    return run.project.path(name)


def take_offer(run: Run, key: str) -> None:
    """Fetch an offered model into the project and the user's library, where an edit finds it.

    Args:
        run: Its sources offered it.
        key: Of the model.

    Raises:
        InputError: It is not offered any more, the service cannot give it, or there is no library to keep it in.
    """
    if run.library is None:
        raise InputError("what services give is kept in your library, which is turned off", mend="set library = true")
    provenance = Provenance(source=_source(run, key).name, file=key)
    fetched(run, Recipe(source="file", key=key, score=EXACT, reason="a person chose it", provenance=provenance))


def _source(run: Run, key: str) -> CatalogueSource:
    """Return the catalogue that offered a model. Raises InputError."""
    for source in catalogues_of(run.sources):
        if source.offers(key):
            return source
    raise InputError("it is not offered any more", mend="look for it again")
