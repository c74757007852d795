"""``python -m storyblender.blender.models.blend_reader FILE FOLDER OUT``: the meshes of a file as plain data.

Runs in a process of its own with bounded time and memory. No script, driver or handler of the file runs, as it is
appended from and never opened, and only arrays and pictures leave the process.
"""

from __future__ import annotations

import os
import sys
import threading
import time
from pathlib import Path

from storyblender.blender.models.limits import FILE_BYTES, MEMORY, SECONDS
from storyblender.errors import InputError
from storyblender.file_reading_process import PROBLEM


def main() -> None:
    """Read, write and end at once: the way out of an interpreter with Blender in it may hang."""
    path, folder, out = (Path(argument) for argument in sys.argv[1:4])
    bound_process()
    status = 0
    try:
        from storyblender.blender.models.blend_scene import read_scene
        from storyblender.blender.models.plain import save

        save(read_scene(path, folder), out)
    except InputError as error:
        (out / PROBLEM).write_text(f"{error.problem}\n{error.mend}", encoding="utf-8")
    except (RuntimeError, OSError, ValueError, MemoryError, ReferenceError) as error:
        print(error, file=sys.stderr)
        status = 1
    sys.stdout.flush()
    os._exit(status)


def bound_process() -> None:
    """Bound what this process may take, and end it with the worker that waits for it."""
    threading.Thread(target=_end_with, args=(os.getppid(),), daemon=True).start()
    try:
        import resource
    except ImportError:  # not on Windows; the worker still stops it by the clock
        return
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_BYTES, FILE_BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _end_with(parent: int) -> None:
    while os.getppid() == parent:
        time.sleep(1.0)
    os._exit(1)


if __name__ == "__main__":
    main()
