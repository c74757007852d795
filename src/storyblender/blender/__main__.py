"""``python -m storyblender.blender --root FOLDER``: the worker, an MCP server over stdio.

bpy runs on the main thread and takes jobs from a queue; the server lives in a daemon thread (notes: stack,
section 2). The process ends by ``os._exit``: an interpreter that served bpy and MCP hangs on the way out.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import sys
import threading
from pathlib import Path


def main() -> None:
    """Parse the command line and serve until the client closes the pipe."""
    parser = argparse.ArgumentParser(prog="storyblender.blender", description="StoryBlender's Blender worker")
    parser.add_argument("--root", type=Path, required=True, help="the project folder; no job may leave it")
    parser.add_argument("--models", type=Path, default=None, help="a folder of models that may be read")
    arguments = parser.parse_args()
    from storyblender.blender.main_thread import MainThread
    from storyblender.blender.server import make_server
    from storyblender.blender.session import Session

    main_thread = MainThread()
    server = make_server(Session(arguments.root, arguments.models), main_thread)

    def serve() -> None:
        try:
            asyncio.run(server.run_stdio_async(show_banner=False))
        finally:
            main_thread.close()

    threading.Thread(target=serve, name="mcp", daemon=True).start()
    main_thread.run()
    sys.stdout.flush()
    os._exit(0)


if __name__ == "__main__":
    main()
