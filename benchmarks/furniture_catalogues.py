"""Models of another program with what is true of them: the catalogues of Sweet Home 3D, which are not ours to ship.

A ``.sh3f`` or ``.jar`` is a zip with a ``.properties`` file that says the true width, depth and height of each model in
centimetres, and the rotation that brings a model to its front where it has another. A piece's front is towards the
lower edge of the plan: +Z of an .obj with Y up, which is -Y here.
"""

from __future__ import annotations

import re
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

import numpy as np

_FIELD = re.compile(r"([A-Za-z]+)#(\d+)\s*=\s*(.*)")
_BASE = "com/eteks/sweethome3d/io/DefaultFurnitureCatalog.properties"
_PLANTS = frozenset(
    ("tree", "plant", "flower", "flowers", "palm", "pine", "bush", "cactus", "bamboo", "hedge", "fern", "bonsai")
)
_ROOMS = frozenset(("bedroom", "living room", "office", "kitchen", "bathroom", "exterior"))
STRATA: Mapping[str, int] = {"furniture": 24, "opening": 7, "plant": 5, "vehicle": 5, "lamp": 5, "stairs": 2}
"""How many models of each sort a sample has; 48 together. The catalogues have only five stairs."""


@dataclass(frozen=True)
class TrueModel:
    """A model of a catalogue.

    Attributes:
        archive: The catalogue's file.
        member: Of the archive.
        name: What the thing is, as the catalogue says.
        sort: Key of ``STRATA``; empty for what is none of them.
        size: Width, depth and height in metres.
        rotation: (3, 3) from the file's frame, Y up, to the true one.
        other_fronts: Quarters by which it may be turned as well: 1 has its right side as its front.
    """

    archive: Path
    member: str
    name: str
    sort: str
    size: tuple[float, float, float]
    rotation: np.ndarray
    other_fronts: tuple[int, ...] = ()

    @property
    def stem(self) -> str:
        """The file's name without its suffix."""
        return PurePosixPath(self.member).stem

    def unpack(self, folder: Path) -> Path:
        """Write the model, its materials and its pictures into an empty folder; return the model."""
        base = PurePosixPath(self.member).parent
        with zipfile.ZipFile(self.archive) as archive:
            for name in archive.namelist():
                path = PurePosixPath(name)
                if path.parent == base and path.suffix.lower() not in ("", ".class", ".properties"):
                    (folder / path.name).write_bytes(archive.read(name))
        return folder / PurePosixPath(self.member).name


def read_catalogues(folder: Path) -> list[TrueModel]:
    """Return the .obj models of every catalogue below a folder, in a fixed order."""
    archives = sorted(path for path in folder.rglob("*") if path.suffix in (".sh3f", ".jar"))
    return [model for archive in archives for model in _models(archive)]


def samples(models: Sequence[TrueModel], seeds: Sequence[int]) -> list[list[TrueModel]]:
    """Return a random sample for each seed, none with a model of an earlier one."""
    left, found = list(models), []
    for seed in seeds:
        rng = np.random.default_rng(seed)
        chosen: list[TrueModel] = []
        for sort, count in STRATA.items():
            there = [model for model in left if model.sort == sort]
            chosen += [there[index] for index in sorted(rng.permutation(len(there))[:count])]
        left = [model for model in left if model not in chosen]
        found.append(chosen)
    return found


def _models(path: Path) -> Iterator[TrueModel]:
    with zipfile.ZipFile(path) as archive:
        members = (name for name in archive.namelist() if name.endswith(".obj"))
        surfaces = {name for name in members if b"\nf " in archive.read(name)}
        name = next((each for each in ("PluginFurnitureCatalog.properties", _BASE) if each in archive.namelist()), None)
        lines = archive.read(name).decode("latin-1").splitlines() if name else ()
    rows: dict[int, dict[str, str]] = {}
    for line in lines:
        if found := _FIELD.match(line.strip()):
            rows.setdefault(int(found[2]), {})[found[1]] = found[3]
    for _, row in sorted(rows.items()):
        member = row.get("model", "").lstrip("/")
        if member in surfaces:
            width, depth, height = (float(row[side]) / 100 for side in ("width", "depth", "height"))
            turn = [float(value) for value in row.get("modelRotation", "1 0 0 0 1 0 0 0 1").split()]
            sort = _sort(row["name"].lower(), row.get("category", "").lower(), max(width, depth, height))
            yield TrueModel(path, member, row["name"], sort, (width, depth, height), np.reshape(turn, (3, 3)))


def _sort(name: str, category: str, largest: float) -> str:
    if "stair" in category or "stair" in name:
        return "stairs"
    for word, sort in (("door", "opening"), ("vehicle", "vehicle"), ("light", "lamp")):
        if word in category:
            return sort
    if _PLANTS & set(name.split()):
        return "plant"
    return "furniture" if category in _ROOMS and largest >= 0.4 else ""
