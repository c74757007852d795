"""The scenes that benchmarks of the Layout Artist work on: the examples and the working pages, staged by the rules."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path

from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.crew import rules_crew
from storyblender.engine.blender_engine import BlenderEngine
from storyblender.library.embedder import load_embedder
from storyblender.library.sources import asset_sources
from storyblender.memory.base import scene_name
from storyblender.memory.scene_context import Layout
from storyblender.pipeline.grounding import ground
from storyblender.pipeline.materializing import materialize
from storyblender.pipeline.run import Run
from storyblender.pipeline.staging import stage
from storyblender.project import Project
from storyblender.reflection import reflect
from storyblender.settings import Settings
from storyblender.trace import silent

HERE = Path(__file__).parent
SCRIPTS = (".fountain", ".txt")
EXAMPLES = tuple(path for path in sorted((HERE.parent / "examples").iterdir()) if path.suffix in SCRIPTS)
PAGES = tuple(path for path in sorted((HERE / "pages" / "working").iterdir()) if path.suffix in SCRIPTS)


@dataclass(frozen=True)
class StagedScene:
    """A scene as the Spatial Planner was given it, and the layout that its critic accepted.

    Attributes:
        name: Of the script and the scene.
        view: What the Spatial Planner knows.
        layout: Its accepted layout; no fault is left in it.
    """

    name: str
    view: SpatialPlannerView
    layout: Layout


def open_run(folder: Path, stack: ExitStack, settings: Settings | None = None) -> Run:
    """Return a run of the rules crew on a project; it is closed with the stack.

    Args:
        folder: The project.
        stack: Closes the project and Blender.
        settings: As for ``storyblender make``.
    """
    settings = settings or Settings(look="fast", animatic=False, jobs=1)
    project = stack.enter_context(Project(folder))
    engine = stack.enter_context(BlenderEngine(project.folder))
    sources = asset_sources(settings, load_embedder)
    return Run(project, engine, rules_crew(settings, load_embedder, sources), settings, silent, sources)


def staged_scenes(script: Path, folder: Path) -> list[StagedScene]:
    """Return the scenes of a script whose layouts have no fault.

    Args:
        script: A script.
        folder: For its project.
    """
    views: dict[int, SpatialPlannerView] = {}
    with ExitStack() as stack:
        run = open_run(folder, stack)
        planner = run.crew.spatial_planner

        def project(*args: object, **kwargs: object) -> SpatialPlannerView:
            view = planner.project(*args, **kwargs)
            views[view.scene_id] = view
            return view

        run.crew = replace(run.crew, spatial_planner=replace(planner, project=project))
        ground(run, script)
        materialize(run)
        stage(run)
    named = {f"{script.stem} {scene_name(scene_id)}": view for scene_id, view in views.items()}
    ends = {name: reflect(planner, name, view) for name, view in named.items()}
    return [StagedScene(name, end.view, end.draft) for name, end in ends.items() if end.accepted]
