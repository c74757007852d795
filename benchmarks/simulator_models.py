"""Models of robot simulators with what is true of them; they are not ours to ship.

A folder holds clones of ``gazebo_models``, ``aws-robomaker-small-house-world`` and ``aws-robomaker-bookstore-world``.
``simulator_models.csv`` says of each model its size in the simulator, and which sides two people who were told
nothing else took for its front. A .dae becomes an .obj as Blender writes it: Y up, in metres, without textures. A file
that is an .obj already stays as it is, in the unit and with the top that its author chose.
"""

from __future__ import annotations

import csv
import re
import shutil
import tempfile
from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np
from benchmarks.furniture_catalogues import TrueModel

_ROWS = Path(__file__).with_suffix(".csv")
_QUARTERS = "front", "right", "back", "left"
_Z_UP = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
"""From a file with Z up to one with Y up."""
_QUARTER = np.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]])
"""Brings the right side of a model with Y up to its front, +Z."""


@dataclass(frozen=True)
class SimulatorModel(TrueModel):
    """A model of a simulator: ``archive`` is its mesh, ``member`` the name of the .obj."""

    def unpack(self, folder: Path) -> Path:
        """Write the model as .obj into an empty folder, and return it."""
        path = folder / self.member
        if self.archive.suffix.lower() == ".obj":
            shutil.copy(self.archive, path)
            for each in self.archive.parent.glob("*.mtl"):
                shutil.copy(each, folder)
        else:
            _import_collada(self.archive)
            bpy.ops.wm.obj_export(filepath=str(path))
        return path


def read_simulators(folder: Path) -> list[TrueModel]:
    """Return the models of the table, in its order.

    Args:
        folder: With the clones.
    """
    with _ROWS.open(encoding="utf-8", newline="") as file:
        return [_model(folder, row) for row in csv.DictReader(file)]


def _model(folder: Path, row: dict[str, str]) -> SimulatorModel:
    upright = _Z_UP if row["up"] == "z" else np.eye(3)
    first, *others = (_QUARTERS.index(side) for side in row["fronts"].split())
    return SimulatorModel(
        archive=folder / row["mesh"],
        member=f"{row['file']}.obj",
        name=row["name"],
        sort=row["sort"],
        size=(float(row["width"]), float(row["depth"]), float(row["height"])),
        rotation=np.linalg.matrix_power(_QUARTER, first) @ upright,
        other_fronts=tuple((other - first) % 4 for other in others),
    )


def _import_collada(path: Path) -> None:
    """Open a .dae in an empty scene; what Blender's importer stumbles over in files of 3ds Max is mended first."""
    text = path.read_text("utf-8", "replace")
    text = re.sub(r"<library_images>.*?</library_images>", "", text, flags=re.S)
    text = re.sub(r"<texture\b.*?(</texture>|/>)", "<color>.5 .5 .5 1</color>", text, flags=re.S)
    text = re.sub(r"<transparen(?:t|cy)\b.*?</transparen(?:t|cy)>", "", text, flags=re.S)
    text = re.sub(r'\b(id|url|source|target|symbol|material)="[^"]*"', lambda found: found[0].replace(" ", "_"), text)
    text = re.sub(r'<visual_scene id="([^"]*)"', r'<visual_scene id="\1-scene"', text)
    text = re.sub(r'<instance_visual_scene url="#([^"]*)"', r'<instance_visual_scene url="#\1-scene"', text)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with tempfile.TemporaryDirectory() as scratch:
        mended = Path(scratch) / "model.dae"
        mended.write_text(text, "utf-8")
        bpy.ops.wm.collada_import(filepath=str(mended))
