"""Every file of Blender tests begins with an empty Blender, whatever ran before it on the same process."""

import pytest


@pytest.fixture(scope="module", autouse=True)
def empty_blender() -> None:
    bpy = pytest.importorskip("bpy")
    bpy.ops.wm.read_factory_settings(use_empty=True)
