"""The register of asset sources: every place that assets come from is one entry, in the order of preference."""

from __future__ import annotations

from collections.abc import Callable

from storyblender.library.built_in import BuiltInLibrary
from storyblender.library.library_source import LibrarySource
from storyblender.library.model_folders import ModelFolders
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.ports import AssetSource, Embedder
from storyblender.settings import Settings

SourceFactory = Callable[[Settings, Callable[[], Embedder]], AssetSource]

SOURCES: dict[str, SourceFactory] = {
    "models": lambda settings, embedder: ModelFolders(settings.models, embedder),
    "library": lambda settings, embedder: LibrarySource(SharedLibrary.open(), embedder, settings.licences),
    "built_in": lambda settings, embedder: BuiltInLibrary(embedder),
}
"""Name to what makes the source from the settings. Of equal candidates that of the earlier source is taken."""


def asset_sources(settings: Settings, embedder: Callable[[], Embedder]) -> tuple[AssetSource, ...]:
    """Return every source of the register.

    Args:
        settings: Say where the user's models are.
        embedder: Loads the sentence model, for likeness of meaning.
    """
    made = [make for name, make in SOURCES.items() if settings.library or name != "library"]
    return tuple(make(settings, embedder) for make in made)
