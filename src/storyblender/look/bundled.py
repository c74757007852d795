"""Finds the libraries that ship inside Blender's wheel (OpenColorIO) without importing Blender."""

from __future__ import annotations

import importlib.util
import sys
from functools import cache
from pathlib import Path
from types import ModuleType


@cache
def blender_folder() -> Path | None:
    """Return the versioned folder of Blender's data (``.../bpy/4.5``), or None where Blender is not installed."""
    spec = importlib.util.find_spec("bpy")
    if spec is None or spec.origin is None:
        return None
    origin = Path(spec.origin).parent
    # Once bpy is imported its spec points into <version>/scripts/modules/bpy, before that to the wheel's root.
    for root in (origin, *origin.parents[:3]):
        for folder in (*sorted(root.glob("*/datafiles")), root / "datafiles"):
            if (folder / "colormanagement" / "config.ocio").is_file():
                return folder.parent
    return None


@cache
def bundled_module(name: str) -> ModuleType | None:
    """Import a package from Blender's own site-packages; None if it is not there or does not load."""
    folder = blender_folder()
    if folder is None:
        return None
    for package in sorted(folder.glob(f"python/lib/python*/site-packages/{name}/__init__.py")):
        spec = importlib.util.spec_from_file_location(name, package, submodule_search_locations=[str(package.parent)])
        if spec is None or spec.loader is None:
            continue
        module = importlib.util.module_from_spec(spec)
        previous = sys.modules.get(name)
        sys.modules[name] = module
        try:
            spec.loader.exec_module(module)
        except ImportError:
            if previous is None:
                del sys.modules[name]
            else:
                sys.modules[name] = previous
            continue
        return module
    return None
