"""The register of asset sources: every place that assets come from is one entry, in the order of preference."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib.util import find_spec
from threading import Event as Signal
from typing import TYPE_CHECKING

from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.library.built_in import BuiltInLibrary
from storyblender.library.library_source import LibrarySource
from storyblender.library.model_folders import ModelFolders
from storyblender.library.shared.place import library_folder
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.ports import AssetSource, Embedder
from storyblender.service_setting import services_in
from storyblender.settings import Settings

if TYPE_CHECKING:
    from storyblender.library.pictures import Pictures
    from storyblender.services.register import ServiceRun

Warn = Callable[[str], None]
"""Hears a sentence for people."""
SourceFactory = Callable[[Settings, Callable[[], Embedder]], AssetSource]

SOURCES: dict[str, SourceFactory] = {
    "models": lambda settings, embedder: ModelFolders(settings.models, embedder),
    "library": lambda settings, embedder: LibrarySource(SharedLibrary.open(), embedder, settings.licences),
    "built_in": lambda settings, embedder: BuiltInLibrary(embedder),
}
"""Name to what makes the source from the settings. Of equal candidates that of the earlier source is taken."""


def asset_sources(
    settings: Settings,
    embedder: Callable[[], Embedder],
    services: ServiceRun | None = None,
    warn: Warn = lambda sentence: None,
) -> tuple[AssetSource, ...]:
    """Return every source of the register, and before the built-in library the catalogues that the settings name.

    Args:
        settings: Say where the user's models are.
        embedder: Loads the sentence model, for likeness of meaning.
        services: What the run gives services; None asks none.
        warn: Hears that a service failed.
    """
    made = {name: make(settings, embedder) for name, make in SOURCES.items() if settings.library or name != "library"}
    last = made.pop("built_in")
    return (*made.values(), *(_catalogue_sources(settings, embedder, services, warn) if services else ()), last)


def offered_pictures(
    settings: Settings, embedder: Callable[[], Embedder], services: ServiceRun | None, warn: Warn
) -> Pictures | None:
    """Return what surfaces and panoramas there are; None where the settings name no catalogue and there is no library.

    Args:
        settings: Name the services, and whether there is a library.
        embedder: Loads the sentence model.
        services: What the run gives services; None asks none.
        warn: Hears that a service failed.
    """
    kept = settings.library and (services is not None or library_folder().exists())
    library = SharedLibrary.open() if kept else None
    if services is None and library is None:
        return None
    from storyblender.library.pictures import Pictures

    found = ()
    if services is not None:
        from storyblender.services.register import catalogues

        found = catalogues(services_in(settings.services), services)
    return Pictures(library, found, services, embedder, warn, settings.licences)


def service_run(settings: Settings, cancelled: Signal) -> ServiceRun | None:
    """Return what a run gives the services that it asks; None where the settings name none.

    Args:
        settings: Name the services, and the limits on them.
        cancelled: Set when the run is cancelled.

    Raises:
        InputError: The extra ``services`` is not installed.
    """
    if not settings.services:
        return None
    if any(find_spec(name) is None for name in ("httpx2", "tenacity")):
        raise InputError("services need the extra `services`", mend='pip install "storyblender[services]"')
    from storyblender.services.budget import ServiceBudget
    from storyblender.services.register import ServiceRun
    from storyblender.services.shelf import Shelf

    shelf = Shelf(Folder(library_folder() / "answers"))
    return ServiceRun(ServiceBudget(settings.service_limits), settings.licences, shelf, cancelled=cancelled)


def _catalogue_sources(
    settings: Settings, embedder: Callable[[], Embedder], services: ServiceRun, warn: Warn
) -> Iterator[AssetSource]:
    from storyblender.library.catalogue_source import CatalogueSource
    from storyblender.services.register import catalogues

    library = SharedLibrary.open() if settings.library else None
    for catalogue in catalogues(services_in(settings.services), services):
        yield CatalogueSource(catalogue, services, embedder, library, warn)
