"""What the Blender file of a long story costs: the packs of a finished project, many times over under other names."""

from __future__ import annotations

import argparse
import os
import resource
import shutil
import tempfile
import time
from pathlib import Path
from typing import cast

import bpy

from storyblender.engine.blender_engine import BlenderEngine
from storyblender.memory.base import scene_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import PackRef
from storyblender.pipeline.compiling import Compilation
from storyblender.pipeline.run import Run
from storyblender.project import Project, read_project_graph
from storyblender.settings import Settings

KINDS = ("scenes", "objects", "collections", "actions", "materials", "worlds", "meshes", "lights")


def copy_pack(source: Path, target: Path, old: str, new: str) -> None:
    """Write a pack under another scene's name, with all that is named after the scene."""
    bpy.ops.wm.open_mainfile(filepath=str(source), load_ui=False, use_scripts=False)
    for block in [block for kind in KINDS for block in getattr(bpy.data, kind) if old in block.name]:
        block.name = block.name.replace(old, new)
    for track in [t for o in bpy.data.objects if o.animation_data for t in o.animation_data.nla_tracks]:
        track.name = track.name.replace(old, new)
    target.parent.mkdir(parents=True, exist_ok=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(target), compress=True, copy=True)


def long_story(made: Path, root: Path, scenes: int) -> tuple[ContinuityMemoryGraph, dict[int, PackRef]]:
    """Return a graph of so many scenes, its packs written into ``root``."""
    graph = read_project_graph(made)
    known = [PackRef.model_validate_json(path.read_bytes()) for path in sorted((made / "build/scenes").glob("*.json"))]
    packs: dict[int, PackRef] = {}
    outline, contexts, shots = [], [], []
    for number in range(1, scenes + 1):
        pack = known[(number - 1) % len(known)]
        path = f"build/scenes/{scene_name(number)}.blend"
        if not (root / path).exists():
            copy_pack(made / pack.path, root / path, scene_name(pack.scene_id), scene_name(number))
        packs[number] = pack.model_copy(update={"scene_id": number, "path": path})
        same = {"scene_id": number}
        outline += [each.model_copy(update=same) for each in graph.outline if each.scene_id == pack.scene_id]
        contexts.append(graph.scene(pack.scene_id).model_copy(update=same))
        shots += [shot.model_copy(update=same) for shot in graph.shots_of(pack.scene_id)]
    parts = {"outline": tuple(outline), "scenes": tuple(contexts), "shots": tuple(shots)}
    return graph.model_copy(update=parts), packs


def compiled(project: Project, graph: ContinuityMemoryGraph, packs: dict[int, PackRef]) -> float:
    """Return the seconds that the files take with two workers."""
    start = time.perf_counter()
    with BlenderEngine(project.folder, jobs=2) as engine:
        project.graph = graph
        run = Run(project, engine, cast(object, None), Settings(), lambda event: None, packs)  # type: ignore[arg-type]
        Compilation(run).finish()
    return time.perf_counter() - start


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("project", type=Path, help="a finished project")
    parser.add_argument("scenes", type=int, nargs="+")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, Project(Path(folder)) as project:
        print("scenes  files  seconds  a scene  one edit  worker MB  disk MB", flush=True)
        for scenes in arguments.scenes:
            root = Path(folder)
            graph, packs = long_story(arguments.project, root, scenes)
            for left in (root / "story.blend", root / "story"):
                shutil.rmtree(left) if left.is_dir() else left.unlink(missing_ok=True)
            if not (root / "assets").exists():
                shutil.copytree(arguments.project / "assets", root / "assets")
            seconds = compiled(project, graph, packs)
            shot = graph.shots[0].model_copy(update={"duration": graph.shots[0].duration + 1})
            edit = compiled(project, graph.model_copy(update={"shots": (shot, *graph.shots[1:])}), packs)
            files = [root / "story.blend", *root.glob("story/*.blend")]
            size = sum(file.stat().st_size for file in files) / 2**20
            peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 2**10  # of the largest, of all so far
            cost = f"{scenes:>6} {len(files):>6} {seconds:>8.1f} {seconds / scenes:>8.2f} {edit:>9.1f}"
            print(f"{cost} {peak:>10.0f} {size:>8.0f}", flush=True)
    os._exit(0)  # Blender may hang on the way out


if __name__ == "__main__":
    main()
