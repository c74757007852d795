"""Folders of the user's own models as an asset source: a model is found by the name of its file."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from storyblender.catalog.recipe import AssetQuery, Recipe
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.library.matching import Likeness, Term
from storyblender.library.named_models import named, terms_of
from storyblender.memory.asset_sheet import Provenance
from storyblender.model_content import content_of
from storyblender.ports import Embedder

MODEL_SUFFIXES = (".glb", ".gltf", ".blend", ".obj", ".fbx", ".stl", ".ply", ".usd", ".usda", ".usdc", ".usdz")


@dataclass(frozen=True)
class ModelFile:
    """A model in one of the folders.

    Attributes:
        name: Path relative to its folder, with ``/`` between the parts.
        path: Where it lies.
        content: Digest of the file: a model that was changed is another model.
        place: Number of its folder; models in earlier folders win ties.
    """

    name: str
    path: Path
    content: str
    place: int = 0


class ModelFolders:
    """The user's folders of models.

    Args:
        folders: Earlier ones win ties; a file hides those of the same relative path in later folders.
        embedder: Loads the sentence model.
    """

    name = "models"

    def __init__(self, folders: Sequence[Path], embedder: Callable[[], Embedder]) -> None:
        self._folders, self._likeness = folders, Likeness(embedder)
        self._files: dict[str, ModelFile] | None = None
        self._terms: tuple[Term, ...] = ()

    def search(self, query: AssetQuery, *, by_meaning: bool = False) -> Sequence[Recipe]:
        """Return the models that fit, best first."""
        files = self._known()
        matches = named(query.phrase, [(file.name, file.name, file.place) for file in files.values()], self._terms)
        if by_meaning:
            matches = self._likeness.with_likely(matches, query, self._terms)
        return [
            Recipe(
                source="file",
                key=match.key,
                params={"content": files[match.key].content},
                score=match.score,
                reason=match.reason,
                by_meaning=match.by_meaning,
                provenance=Provenance(source=self.name, file=match.key),
            )
            for match in matches
        ]

    def inventory(self) -> Mapping[str, str]:
        """Return the content digest of every model by name; the folders are read anew."""
        self._files = None
        return {file.name: file.content for file in self._known().values()}

    def fetch(self, recipe: Recipe, files: Folder) -> Recipe:
        """Return the recipe with the digest of its file, which the engine reads where it lies.

        Raises:
            InputError: The file is gone.
        """
        path = self._known()[recipe.key].path
        try:
            with path.open("rb") as file:
                digest = hashlib.file_digest(file, "sha256").hexdigest()
        except OSError as error:
            raise InputError("the model cannot be read", mend="put it back", path=path) from error
        provenance = Provenance(source=self.name, file=recipe.key, digest=digest)
        return recipe.model_copy(update={"provenance": provenance})

    def _known(self) -> dict[str, ModelFile]:
        if self._files is None:
            self._files = {}
            for file in _model_files(self._folders):
                self._files.setdefault(file.name, file)
            self._terms = terms_of((name, name) for name in self._files)
        return self._files


def _model_files(folders: Sequence[Path]) -> Iterator[ModelFile]:
    """Yield the models of all folders, those of a folder by path."""
    for place, folder in enumerate(folders):
        for path in sorted(folder.rglob("*")):
            if path.suffix.lower() in MODEL_SUFFIXES and path.is_file():
                yield ModelFile(path.relative_to(folder).as_posix(), path, content_of(path, folder), place)
