"""``python -m benchmarks``: print every quick table; ``python -m benchmarks NAME [OPTIONS]`` one of them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
SCORED = ("fresh_*.gold", "unseen_*.gold")
"""Pages that no rule of the reader quotes; the others served to write it (see ``director/ANNOTATING.md``)."""
TABLES = {
    "layout": [str(HERE / "layout_solver.py")],
    "layout_reflection": ["-m", "benchmarks.layout_reflection"],
    "camera_servo": ["-m", "benchmarks.camera_servo"],
    "director": [
        str(HERE / "director" / "score.py"),
        *sorted(str(path) for name in SCORED for path in (HERE.parent / "tests/data/director").glob(name)),
    ],
    "readings": ["-m", "benchmarks.readings"],
    "scale": [str(HERE / "scale.py")],
    "edit": [str(HERE / "edit.py")],
    "framing": ["-m", "benchmarks.framing_requests"],
    "recordings": ["-m", "benchmarks.recordings"],
    "feature": ["-m", "benchmarks.feature"],
    "bound_cast": ["-m", "benchmarks.bound_cast"],
    "library": ["-m", "benchmarks.library_search"],
    "library_reuse": ["-m", "benchmarks.library_reuse"],
    "motions": ["-m", "benchmarks.motions"],
    "studio_preview": ["-m", "benchmarks.studio_preview"],
    "outside_models": ["-m", "benchmarks.outside_models"],
}
LONG = (
    "bound_cast", "camera_servo", "framing", "feature", "layout_reflection", "library_reuse", "motions",
    "outside_models", "recordings", "studio_preview",
)  # fmt: skip
"""Run for minutes or an hour, or want a project: only when asked for by name."""


def main(arguments: list[str]) -> int:
    """Run the tables asked for; what follows the name of one goes to it."""
    asked, options = arguments[:1], arguments[1:]
    unknown = [name for name in asked if name not in TABLES]
    if unknown:
        print(f"no benchmark {unknown[0]!r}; there are {', '.join(TABLES)}")
        return 2
    for name in asked or [name for name in TABLES if name not in LONG]:
        print(f"\n== {name}", flush=True)
        code = subprocess.run([sys.executable, *TABLES[name], *options], check=False).returncode
        if code:
            return code
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
