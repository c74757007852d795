"""Files that appear whole or not at all, however many workers write the same one."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def part_file(path: Path) -> Iterator[Path]:
    """Give a file to write that becomes ``path`` once it is whole, and is deleted if writing fails.

    Args:
        path: The file to make. Its part file lies beside it, keeps its suffix and carries the number of this process:
            another worker that writes the same file has another part file.
    """
    part = path.with_name(f"{path.stem}.{os.getpid()}.part{path.suffix}")
    try:
        yield part
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)
