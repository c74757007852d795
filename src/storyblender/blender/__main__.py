"""``python -m storyblender.blender --root FOLDER``: the worker, an MCP server over standard input and output."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path


def main() -> None:
    """Parse the command line and serve until the client closes the pipe."""
    parser = argparse.ArgumentParser(prog="storyblender.blender", description="StoryBlender's Blender worker")
    parser.add_argument("--root", type=Path, required=True, help="the project folder; no job may leave it")
    parser.add_argument("--models", type=Path, default=None, help="a folder of models that may be read")
    arguments = parser.parse_args()
    from storyblender.blender.server import serve, take_wire

    wire = take_wire()  # before Blender is imported: it prints as it likes
    from storyblender.blender.session import Session

    serve(Session(arguments.root, arguments.models).tools, sys.stdin.buffer, wire)
    sys.stderr.flush()
    os._exit(0)  # an interpreter that used Blender may hang on the way out


if __name__ == "__main__":
    main()
