"""Shared fixtures, and the clean end of a process that used Blender."""

from __future__ import annotations

import os
import sys

import pytest


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """Bpy hangs at interpreter exit after some uses: end the process once the report is out."""
    if "bpy" in sys.modules and not hasattr(config, "workerinput"):
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(getattr(config, "storyblender_exit", 0))


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    session.config.storyblender_exit = int(exitstatus)  # type: ignore[attr-defined]


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Blender is one global state: the tests of a file that uses it stay together on one process, in order."""
    for item in items:
        if "tests/blender/" in item.nodeid:
            item.add_marker(pytest.mark.xdist_group(item.nodeid.partition("::")[0]))
