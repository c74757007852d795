"""A whole feature from script to board, killed twice on the way, beside a short of the same manner."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from benchmarks.feature_script import SCENES, feature
from benchmarks.watched_run import Watch, watched

from storyblender.project import read_project_graph

KILLS = (("camera", 0.5), ("frames", 0.5))
SHORT = 10
"""Scenes of the short."""
SIZES = ("graph.json", "history", "trace.jsonl", "assets", "build", "frames", "story.blend", "board.pdf", "index.html")


def main() -> None:
    """Make the short and the feature, and print what they took."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=SCENES)
    parser.add_argument("--shots-per-scene", type=int, default=6)
    parser.add_argument("--look", default="fast")
    parser.add_argument("--width", type=int, default=320)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--animatic", action="store_true")
    parser.add_argument("--no-kills", action="store_true")
    parser.add_argument("--folder", type=Path, help="where the projects stay; a temporary folder if not given")
    arguments = parser.parse_args()
    options = ["--look", arguments.look, "--width", str(arguments.width), "--jobs", str(arguments.jobs)]
    options += ["--shots-per-scene", str(arguments.shots_per_scene)]
    options += ["--animatic" if arguments.animatic else "--no-animatic"]
    with tempfile.TemporaryDirectory() as temporary:
        root = arguments.folder or Path(temporary)
        root.mkdir(parents=True, exist_ok=True)
        short = _made(root, "short", min(SHORT, arguments.scenes), options, ())
        long = _made(root, "feature", arguments.scenes, options, () if arguments.no_kills else KILLS)
        wall, processor = (there / here for there, here in zip(long, short, strict=True))
        print(f"a shot of the feature costs {wall:.2f} times the wall time of a shot of the short,", end=" ")
        print(f"{processor:.2f} times its processor time")


def _made(
    root: Path, name: str, scenes: int, options: list[str], kills: tuple[tuple[str, float], ...]
) -> tuple[float, float]:
    """Make a story, print its table, and return seconds a shot: wall, processor."""
    script, project = root / f"{name}.fountain", root / f"{name}.storyboard"
    script.write_text(feature(scenes), encoding="utf-8")
    total = processor = 0.0
    for kill_at in (*kills, None):
        watch = watched(["make", str(script), "--out", str(project), *options], kill_at)
        total += watch.seconds
        processor += sum(watch.processor.values())
        _print_run(name, kill_at, watch)
        if kill_at is None and watch.code:
            raise SystemExit(f"{name} ended with {watch.code}")
    shots = len(read_project_graph(project).shots)
    print(f"{name}: {scenes} scenes, {shots} shots, {total:.0f} s, {total / shots:.2f} s a shot,", end=" ")
    print(f"{processor:.0f} s of processor, {processor / shots:.2f} s a shot")
    print("  " + ", ".join(f"{part} {_megabytes(project / part):.1f} MB" for part in SIZES), flush=True)
    return total / shots, processor / shots


def _print_run(name: str, kill_at: tuple[str, float] | None, watch: Watch) -> None:
    end = f"killed in {kill_at[0]}" if kill_at and watch.code < 0 else f"exit {watch.code}"
    workers = ", ".join(f"{peak:.0f}" for peak in watch.workers.values())
    print(f"{name}: {watch.seconds:.0f} s, {end}; client {watch.client:.0f} MiB, workers {workers} MiB at most")
    print("  " + ", ".join(f"{stage} {seconds:.1f} s" for stage, seconds in watch.stages.items()))
    print(f"  longest silence {watch.silence[0]:.1f} s, in {watch.silence[1]}", flush=True)


def _megabytes(path: Path) -> float:
    files = path.rglob("*") if path.is_dir() else [path]
    return sum(file.stat().st_size for file in files if file.is_file()) / 1e6


if __name__ == "__main__":
    main()
