"""Does the cost of a shot grow with the story? The same scenes once and several times over, in one run."""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from storyblender.project import read_project_graph

EXAMPLE = Path(__file__).parent.parent / "examples" / "casablanca.fountain"


def seconds_and_shots(script: Path, out: Path, look: str, width: int) -> tuple[float, int]:
    start = time.perf_counter()
    command = [sys.executable, "-m", "storyblender", "make", str(script), "--out", str(out), "--look", look]
    subprocess.run([*command, "--width", str(width), "--no-animatic", "--quiet"], check=True)
    return time.perf_counter() - start, len(read_project_graph(out).shots)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--times", type=int, default=10)
    parser.add_argument("--look", default="fast")
    parser.add_argument("--width", type=int, default=320)
    arguments = parser.parse_args()
    title, _, scenes = EXAMPLE.read_text(encoding="utf-8").partition("\n\n")
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        print(f"{'story':>8} {'shots':>6} {'seconds':>8} {'per shot':>9}")
        per_shot: list[float] = []
        for times in (1, arguments.times):
            script = root / f"x{times}.fountain"
            script.write_text(title + "\n\n" + "\n\n".join([scenes] * times), encoding="utf-8")
            seconds, shots = seconds_and_shots(script, root / f"x{times}", arguments.look, arguments.width)
            per_shot.append(seconds / shots)
            print(f"{times:>7}x {shots:>6} {seconds:>8.1f} {per_shot[-1]:>9.2f}", flush=True)
        print(f"a shot of the long story costs {per_shot[1] / per_shot[0]:.2f} times a shot of the short one")


if __name__ == "__main__":
    main()
