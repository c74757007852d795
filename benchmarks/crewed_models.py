"""The models of ``outside_models`` with an Asset Formatter and a Dimension Estimator that look at them.

They are asked as ``make`` asks them, for a story whose things are made from these files: by the file's name and by
pictures of it, of a dozen models of a story at a time.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from threading import Event as Signal

from storyblender.crew import rules_crew
from storyblender.engine.blender_engine import BlenderEngine
from storyblender.errors import AnswerAwaited
from storyblender.language.answerers import answerers
from storyblender.language_crew import language_crew
from storyblender.library.embedder import load_embedder
from storyblender.library.file_names import words_of_file
from storyblender.library.sources import asset_sources
from storyblender.memory.asset_sheet import Asset, AssetDecision
from storyblender.pipeline.asset_views import asset_views
from storyblender.pipeline.materializing import ConceptArtist, all_sized
from storyblender.pipeline.run import Run
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.trace import silent

_THINGS = 12
"""Models in one story."""


def looked_at(models: Mapping[str, str], folder: Path, crew: str) -> dict[str, Asset]:
    """Return an asset for each model, with the pose and the dimension that the crew gave it.

    Args:
        models: What each is taken for, a key of the catalog or empty, by its path in the folder.
        folder: The folder of models.
        crew: As ``--crew`` has it.

    Raises:
        AnswerAwaited: Questions wait for their answers; all that can be asked now is asked.
        InputError: The crew cannot play.
    """
    settings = Settings(models=(folder,), library=False, crew=crew)
    sources = asset_sources(settings, load_embedder)
    with tempfile.TemporaryDirectory() as scratch:
        by_role = answerers(crew, Path(scratch), settings.limits, Signal(), silent)
        players = language_crew(rules_crew(settings, load_embedder, sources), by_role, load_embedder, sources)
        with (
            Project(Path(scratch) / "story.storyboard") as project,
            BlenderEngine(project.folder, (folder,), settings.jobs) as engine,
        ):
            run = Run(project, engine, players, settings, silent, sources)
            return dict(zip(models, _formatted_and_sized(run, models), strict=True))


def _formatted_and_sized(run: Run, models: Mapping[str, str]) -> list[Asset]:
    draw = asset_views(run)
    concept = ConceptArtist(run, draw)
    decided = concept.all_decided([_asset(name, kind) for name, kind in models.items()])
    formatted = concept.all_formatted(decided)
    stories = [formatted[start : start + _THINGS] for start in range(0, len(formatted), _THINGS)]
    return _asked_for_all(lambda story: all_sized(run, concept, story, draw), stories)


def _asset(name: str, kind: str) -> Asset:
    """Return a thing of a story that a person had made from a file."""
    words = words_of_file(name).words
    asset_id = "_".join((*words, *Path(name).parent.parts)).lower()
    asset_id = "".join(each if each.isascii() and each.isalnum() else "_" for each in asset_id)
    called = " ".join(words)
    return Asset(
        asset_id=f"thing_{asset_id}",
        asset_type="object",
        name=called,
        description=called,
        kind=kind,
        decision=AssetDecision(file=name),
    )


def _asked_for_all(size: Callable[[Sequence[Asset]], list[Asset]], stories: Iterable[Sequence[Asset]]) -> list[Asset]:
    """Return the things of all stories with their sizes. Raises AnswerAwaited once all are asked about."""
    sized: list[Asset] = []
    awaited: list[AnswerAwaited] = []
    for story in stories:
        try:
            sized += size(story)
        except AnswerAwaited as error:
            awaited.append(error)
    if awaited:
        raise AnswerAwaited.of(awaited)
    return sized
