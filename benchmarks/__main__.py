"""``python -m benchmarks``: print every table; ``python -m benchmarks NAME`` one of them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
TABLES = {
    "layout": [str(HERE / "layout_solver.py")],
    "director": [
        str(HERE / "director" / "score.py"),
        *sorted(map(str, (HERE.parent / "tests/data/director").glob("*.gold"))),
    ],
    "scale": [str(HERE / "scale.py")],
    "edit": [str(HERE / "edit.py")],
}


def main(names: list[str]) -> int:
    unknown = [name for name in names if name not in TABLES]
    if unknown:
        print(f"no benchmark {unknown[0]!r}; there are {', '.join(TABLES)}")
        return 2
    for name in names or list(TABLES):
        print(f"\n== {name}", flush=True)
        code = subprocess.run([sys.executable, *TABLES[name]], check=False).returncode
        if code:
            return code
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
