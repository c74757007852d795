"""``python -m storyblender.blender --root FOLDER``: the worker, an MCP server over standard input and output."""

from __future__ import annotations

import argparse
import ctypes
import gc
import os
import signal
import sys
import threading
import time
import traceback
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

_SIGNAL_AT_PARENTS_END = 1
"""``PR_SET_PDEATHSIG``: an option of the system call ``prctl``."""

_YIELDING = 10
"""Added to how nice the process is to others: it gets a tenth of a processor that a person waits for."""


def main() -> None:
    """Serve until the client closes the pipe, then exit at once: an interpreter that used Blender may hang at exit."""
    status = 1
    try:
        _serve(sys.argv[1:])
        status = 0
    except SystemExit as end:
        status = end.code if isinstance(end.code, int) else 1
    except BaseException:  # noqa: BLE001 - logged, and the process ends
        with suppress(OSError):  # the log may lie on a full disk
            traceback.print_exc()
    finally:
        with suppress(OSError):
            sys.stderr.flush()
        os._exit(status)


def _serve(words: Sequence[str]) -> None:
    """Parse the command line and serve a session over standard input and output."""
    gc.disable()  # collecting garbage among imports takes a tenth of the start-up time
    parser = argparse.ArgumentParser(prog="storyblender.blender", description="StoryBlender's Blender worker")
    parser.add_argument("--root", type=Path, required=True, help="the project folder; no job may leave it")
    parser.add_argument("--models", type=Path, action="append", default=[], help="a folder of models it may read")
    parser.add_argument("--build", type=Path, default=None, help="folder for names below build/")
    parser.add_argument("--give-way", action="store_true", help="take only the processor time that others leave")
    arguments = parser.parse_args(words)
    if arguments.give_way and hasattr(os, "nice"):
        os.nice(_YIELDING)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the client, which ends us
    _end_with(os.getppid())
    from storyblender.blender.progress import Progress
    from storyblender.blender.server import claim_standard_output, read_lines, serve

    wire = claim_standard_output()  # before the import of Blender, which prints
    from storyblender.blender.session import BlenderSession

    gc.freeze()
    gc.enable()
    progress = Progress(wire)
    session = BlenderSession(arguments.root, arguments.models, arguments.build, progress)
    serve(session.tools, read_lines(sys.stdin.buffer), wire, progress)


def _end_with(client: int) -> None:
    """End this process when the client process is killed."""

    def watch() -> None:
        while os.getppid() == client:
            time.sleep(1.0)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()
    if sys.platform == "linux":  # even while Blender blocks our thread
        ctypes.CDLL(None).prctl(_SIGNAL_AT_PARENTS_END, signal.SIGKILL)


if __name__ == "__main__":
    main()
