"""The extension, installed from its zip as a user does, and a layout that checks what a panel draws on it."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy

from storyblender.extension_repository import write_repository

REPOSITORY = "storyblender_test"
PACKAGE = f"bl_ext.{REPOSITORY}.storyblender"
PANELS = ("Shots", "Shot", "Notes", "Takes")


@contextmanager
def installed(folder: Path) -> Iterator[None]:
    """Install the extension into a repository of its own, switched on; it is taken out at the end."""
    zipped, place = folder / "written", folder / "extensions"
    name, _ = write_repository(zipped)
    place.mkdir()
    repos = bpy.context.preferences.extensions.repos
    repo = repos.new(name=REPOSITORY, module=REPOSITORY, custom_directory=str(place))
    bpy.ops.extensions.package_install_files(filepath=str(zipped / name), repo=REPOSITORY, enable_on_install=True)
    try:
        yield
    finally:
        bpy.ops.preferences.addon_disable(module=PACKAGE)
        repos.remove(repo)


def part(name: str) -> Any:
    """Return a module of the installed extension."""
    return import_module(f"{PACKAGE}.{name}")


def settle(seconds: float = 300.0) -> None:
    """Do what Blender's timer does while it runs, until nothing is under way."""
    work, end = part("work").WORK, time.monotonic() + seconds
    while work.under_way and time.monotonic() < end:
        work.look()
        time.sleep(0.02)
    assert not work.under_way, work.doing


def panel_state() -> Any:
    return bpy.context.window_manager.storyblender


def drawn() -> str:
    """Return all that the panels show, line by line; what Blender would refuse to draw fails."""
    layout, panels = Layout(), part("panels")
    for name in PANELS:
        panel = getattr(panels, name)
        if panel.poll(bpy.context):
            panel.draw(SimpleNamespace(layout=layout), bpy.context)
    state = panel_state()
    for index, row in enumerate(state.shots):
        panels.ShotList.draw_item(None, bpy.context, layout, state, row, 0, state, "active", index)
    return "\n".join(layout.said)


class Layout:
    """Takes what a panel draws, a paragraph as one line; refuses icons, operators and properties that do not exist."""

    ICONS = frozenset(bpy.types.UILayout.bl_rna.functions["label"].parameters["icon"].enum_items.keys())

    def __init__(self) -> None:
        self.said: list[str] = []
        self.active, self.alert, self.alignment = True, False, "EXPAND"

    def row(self, align: bool = False) -> Layout:
        return self

    def split(self, factor: float) -> Layout:
        return self

    def column(self, align: bool = False) -> Layout:
        return self

    def box(self) -> Layout:
        return self

    def label(self, text: str = "", icon: str = "NONE") -> None:
        assert icon in self.ICONS, icon
        if icon == "BLANK1":  # a line of the paragraph above
            self.said[-1] += f" {text}"
        else:
            self.said.append(f"{icon} {text}")

    def prop(self, data: Any, name: str, text: str = "", placeholder: str = "") -> None:
        assert name in data.bl_rna.properties, name

    def template_list(
        self, kind: str, name: str, data: Any, rows_of: str, active_of: Any, active: str, rows: int
    ) -> None:
        assert hasattr(bpy.types, kind) and {rows_of, active} <= set(data.bl_rna.properties.keys())

    def template_icon(self, icon_value: int, scale: float) -> None:
        self.said.append("picture")

    def operator(self, name: str, text: str = "", icon: str = "NONE", depress: bool = False) -> Any:
        assert icon in self.ICONS, icon
        group, _, operator = name.partition(".")
        kind = getattr(getattr(bpy.ops, group), operator).get_rna_type()
        self.said.append(f"{icon} {text or kind.name}{' (on)' if depress else ''}")
        return _Properties(set(kind.properties.keys()))


class _Properties:
    def __init__(self, names: set[str]) -> None:
        object.__setattr__(self, "names", names)

    def __setattr__(self, name: str, value: object) -> None:
        assert name in self.names, name
