"""``python -m storyblender.blender --root FOLDER``: the worker, an MCP server over standard input and output."""

from __future__ import annotations

import argparse
import gc
import os
import signal
import sys
import threading
import time
import traceback
from pathlib import Path


def main() -> None:
    """Parse the command line and serve until the client closes the pipe."""
    gc.disable()  # what is imported stays: to look for garbage among it takes a tenth of the time to come up
    parser = argparse.ArgumentParser(prog="storyblender.blender", description="StoryBlender's Blender worker")
    parser.add_argument("--root", type=Path, required=True, help="the project folder; no job may leave it")
    parser.add_argument("--models", type=Path, default=None, help="a folder of models that may be read")
    arguments = parser.parse_args()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the client, which ends us
    threading.Thread(target=_end_with, args=(os.getppid(),), daemon=True).start()
    from storyblender.blender.server import lines_of, serve, take_wire

    wire = take_wire()  # before Blender is imported: it prints as it likes
    from storyblender.blender.session import Session

    gc.freeze()
    gc.enable()
    status = 1
    try:
        serve(Session(arguments.root, arguments.models).tools, lines_of(sys.stdin.buffer), wire)
        status = 0
    finally:
        if status:
            traceback.print_exc()
        sys.stderr.flush()
        os._exit(status)  # an interpreter that used Blender may hang on the way out, for ever


def _end_with(client: int) -> None:
    """End when the client was killed: a long job would go on for nobody."""
    while os.getppid() == client:
        time.sleep(1.0)
    os._exit(1)


if __name__ == "__main__":
    main()
