"""One camera changed: from the command to the frame, in a project that is made here first."""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from storyblender.memory.base import shot_name
from storyblender.project import read_project_graph

EXAMPLE = Path(__file__).parent.parent / "examples" / "casablanca.fountain"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--project", type=Path, help="a finished project; the example is made if not given")
    arguments = parser.parse_args()
    storyblender = [sys.executable, "-m", "storyblender"]
    with tempfile.TemporaryDirectory() as folder:
        project = arguments.project or Path(folder) / "example"
        if arguments.project is None:
            command = [*storyblender, "make", str(EXAMPLE), "--out", str(project), "--no-animatic", "--quiet"]
            subprocess.run(command, check=True)
        shots = read_project_graph(project).shots
        shot = shots[len(shots) // 2]
        name = shot_name(shot.scene_id, shot.shot_id)
        frame = project / "frames" / f"{name}.png"
        print(f"{'look':>8} {'lens':>5} {'seconds to the frame':>21}")
        for look, lens in (("board", 40), ("fast", 55)):
            before = frame.stat().st_mtime_ns
            start = time.perf_counter()
            command = [*storyblender, "render", str(project), "--shot", name, "--lens", str(lens), "--look", look]
            run = subprocess.Popen([*command, "--quiet"])
            while frame.stat().st_mtime_ns == before and run.poll() is None:
                time.sleep(0.02)
            print(f"{look:>8} {lens:>5} {time.perf_counter() - start:>21.1f}", flush=True)
            run.wait()


if __name__ == "__main__":
    main()
