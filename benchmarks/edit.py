"""One camera changed, at 5 shots and at 200: from the command to the frame, and to the end of the command.

The projects are talks in one room, whole but for their pictures: one frame is drawn and stands for all, since an edit
only binds the others.
"""

from __future__ import annotations

import argparse
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from storyblender.crew import rules_crew
from storyblender.engine.blender_engine import BlenderEngine
from storyblender.library.embedder import load_embedder
from storyblender.library.sources import asset_sources
from storyblender.memory.base import shot_name
from storyblender.pipeline.filming import film
from storyblender.pipeline.grounding import ground
from storyblender.pipeline.materializing import materialize
from storyblender.pipeline.packing import pack_scenes
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import shoot_frames
from storyblender.pipeline.staging import stage
from storyblender.project import Project, read_project_graph
from storyblender.settings import REMEMBERED, Settings
from storyblender.trace import silent

STORIES = ((1, 5), (5, 40))
"""Scenes, and shots in each."""
SCENE = """INT. CAFE - NIGHT

RICK (40, white dinner jacket) sits at a table. ILSA (30, red dress) stands by the piano.
"""
EDITS = (("board", "40"), ("fast", "55"))
"""Look and lens."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--project", type=Path, help="a finished project; two are made if not given")
    parser.add_argument("--short", action="store_true", help="only the short story")
    arguments = parser.parse_args()
    print(f"{'shots':>6} {'look':>6} {'to the frame, s':>16} {'whole command, s':>17} {'processor, s':>13}")
    with tempfile.TemporaryDirectory() as folder:
        stories = STORIES[:1] if arguments.short else STORIES
        projects = [arguments.project] if arguments.project else (made(Path(folder), *story) for story in stories)
        for project in projects:
            shots = read_project_graph(project).shots
            shot = shots[len(shots) // 2]
            for look, lens in EDITS:
                row = timed(project, shot_name(shot.scene_id, shot.shot_id), "--look", look, "--lens", lens)
                print(f"{len(shots):>6} {look:>6} {row[0]:>16.1f} {row[1]:>17.1f} {row[2]:>13.1f}", flush=True)


def made(folder: Path, scenes: int, shots: int) -> Path:
    """Make a story of so many scenes of so many shots; its .blend is compiled too."""
    script, out = folder / f"{scenes}.fountain", folder / f"{scenes}x{shots}"
    talk = "\n".join(f"{('RICK', 'ILSA')[turn % 2]}\nThis is line {turn} of tonight.\n" for turn in range(shots))
    script.write_text("Title: Talk\n\n" + f"{SCENE}\n{talk}\n" * scenes, encoding="utf-8")
    settings = Settings(shots_per_scene=shots, look="fast", animatic=False)
    with Project(out) as project, BlenderEngine(project.folder) as engine:
        sources = asset_sources(settings, load_embedder)
        run = Run(project, engine, rules_crew(settings, load_embedder, sources), settings, silent, sources)
        ground(run, script)
        materialize(run)
        stage(run)
        pack_scenes(run)
        film(run)
        first, *others = (shot_name(shot.scene_id, shot.shot_id) for shot in run.graph.shots)
        shoot_frames(run, run.graph.shots[:1])
        for name in others:
            shutil.copy(out / "frames" / f"{first}.png", out / "frames" / f"{name}.png")
        (out / REMEMBERED).write_text(settings.remembered(project.folder), encoding="utf-8")
    timed(out, first)
    return out


def timed(project: Path, name: str, *change: str) -> tuple[float, float, float]:
    """Edit the camera of a shot, or render it as it is; return seconds to its frame, to the end, and of processor."""
    frame = project / "frames" / f"{name}.png"
    before, spent = frame.stat().st_mtime_ns, processor()
    start = time.perf_counter()
    command = ["edit", str(project), name, *change] if change else ["render", str(project), "--shot", name]
    run = subprocess.Popen([sys.executable, "-m", "storyblender", *command, "--quiet"])
    while frame.stat().st_mtime_ns == before and run.poll() is None:
        time.sleep(0.02)
    seen = time.perf_counter() - start
    if run.wait():
        raise SystemExit(f"the edit failed: {name} {change}")
    return seen, time.perf_counter() - start, processor() - spent


def processor() -> float:
    """Seconds of processor that ended children and theirs have taken."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


if __name__ == "__main__":
    main()
