"""Reads the surface of an .obj and the colours and pictures of its .mtl, line by line.

An .obj does not say what is up, and its unit only in a comment of some programs; Y up and front +Z are assumed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.models.addresses import inside, readable
from storyblender.blender.models.limits import CORNERS, FACES, MATERIALS, MIB, TEXT_BYTES, VERTICES
from storyblender.blender.models.parts import checked, within_bounds
from storyblender.blender.models.pictures import clean_channel, clean_normals, clean_picture, is_normal_map
from storyblender.blender.models.plain import PlainMaterial, PlainModel
from storyblender.errors import InputError
from storyblender.memory.base import Color

_MOST_CORNERS = 4096
"""Most corners of one face."""
_OPTIONS = {"-s": 3, "-o": 3, "-t": 3, "-mm": 2, "-bm": 1, "-blendu": 1, "-blendv": 1, "-boost": 1, "-cc": 1,
            "-clamp": 1, "-texres": 1, "-imfchan": 1, "-type": 1, "-colorspace": 1}  # fmt: skip
"""Options of a texture statement, with the most values of each."""


_UNIT = re.compile(rb"^\s*#.*\bunits?\b\s*[:=]?\s*(?:is\s+|are\s+|in\s+)?(?P<name>[a-z]+)", re.IGNORECASE)
"""A comment that states the unit, as ``# File units = inches``."""
_UNITS = {"m": 1.0, "meter": 1.0, "metre": 1.0, "cm": 0.01, "centimeter": 0.01, "centimetre": 0.01, "mm": 0.001,
          "millimeter": 0.001, "millimetre": 0.001, "in": 0.0254, "inch": 0.0254, "inches": 0.0254, "ft": 0.3048,
          "foot": 0.3048, "feet": 0.3048}  # fmt: skip
_HEAD = 4096
"""Bytes at the beginning in which the unit may be stated."""


class _Surface:
    """What an .obj has said so far."""

    def __init__(self) -> None:
        self.points: list[list[float]] = []
        self.paint: dict[int, list[float]] = {}
        self.layout: list[list[float]] = []
        self.corners: list[int] = []
        self.laid: list[int] = []
        self.sizes: list[int] = []
        self.slots: list[int] = []
        self.smooth: list[bool] = []
        self.names: dict[str, int] = {}
        self.libraries: list[str] = []
        self.slot, self.is_smooth = -1, False

    def take(self, word: str, rest: list[str], line: str) -> None:
        """Add one line of the file; statements that describe no surface are skipped."""
        match word:
            case "v":
                values = [float(value) for value in rest[:7]]
                if len(values) >= 6:
                    self.paint[len(self.points)] = values[-3:]
                self.points.append([*values[:3], 0.0, 0.0][:3] if len(values) >= 3 else [float("nan")] * 3)
            case "vt":
                self.layout.append([*(float(value) for value in rest[:2]), 0.0, 0.0][:2])
            case "f":
                self._face(rest)
            case "usemtl":
                name = line.split(maxsplit=1)[1].strip() if rest else ""
                self.slot = self.names.setdefault(name, len(self.names))
            case "mtllib" if rest:
                self.libraries.append(line.split(maxsplit=1)[1].strip())
            case "s":
                self.is_smooth = rest[:1] not in ([], ["0"], ["off"])

    def _face(self, rest: list[str]) -> None:
        if not 3 <= len(rest) <= _MOST_CORNERS:
            return
        for corner in rest:
            place, _, others = corner.partition("/")
            laid = others.partition("/")[0]
            self.corners.append(_index(place, len(self.points)))
            self.laid.append(_index(laid, len(self.layout)) if laid else -1)
        self.sizes.append(len(rest))
        self.slots.append(self.slot)
        self.smooth.append(self.is_smooth)
        if len(self.sizes) > FACES or len(self.corners) > CORNERS or len(self.points) > VERTICES:
            within_bounds(len(self.points), max(len(self.sizes), len(self.corners) // 4))


def read_obj(path: Path, folder: Path) -> PlainModel:
    """Read an .obj.

    Args:
        path: The file.
        folder: The folder of models; what the file names must be in it.

    Raises:
        InputError: It cannot be read; one clause, without the file's name.
    """
    surface = _Surface()
    for number, line in _lines(path):
        word, *rest = line.split()
        try:
            surface.take(word, rest, line)
        except ValueError as error:
            raise InputError(f"its line {number} is no {word!r}: {line[:40]!r}") from error
    within_bounds(len(surface.points), len(surface.sizes))
    if len(surface.names) > MATERIALS:
        raise InputError(f"it has {len(surface.names)} materials; at most {MATERIALS} are read")
    notes: list[str] = []
    known: dict[str, PlainMaterial] = {}
    for library in dict.fromkeys(surface.libraries):
        try:
            for name, material in _materials(inside(folder, path.parent, library), folder, notes):
                known.setdefault(name, material)
        except InputError as error:
            notes.append(f"{error.problem}; it is left out")
    materials = tuple(known.get(name, PlainMaterial(name=name)) for name in surface.names)
    with np.errstate(over="ignore"):  # what becomes infinite is refused
        model = _model(surface)
    model = replace(checked(model), unit=_stated_unit(path))
    return model.with_materials(materials, tuple(dict.fromkeys(notes)))


def _stated_unit(path: Path) -> float | None:
    """Return the metres of the unit that a comment at the beginning states, if any."""
    with path.open("rb") as file:
        names = (
            found["name"].decode().lower().rstrip("s")
            for line in file.read(_HEAD).splitlines()
            if (found := _UNIT.match(line))
        )
        return next((_UNITS[name] for name in names if name in _UNITS), None)


def _model(surface: _Surface) -> PlainModel:
    points = np.array(surface.points)
    corners = np.array(surface.corners, np.int64)
    if corners.min() < 0 or corners.max() >= len(points):
        raise InputError("a face in it has a corner that is not there")
    laid = np.array(surface.laid)
    layers = np.zeros((0, len(corners), 2), np.float32)
    if surface.layout and (laid >= 0).any() and laid.max() < len(surface.layout):
        layout = np.nan_to_num(np.array(surface.layout), posinf=0.0, neginf=0.0)
        layers = np.where(laid[:, None] >= 0, layout[np.maximum(laid, 0)], 0.0)[None].astype(np.float32)
    paint = np.zeros((0, 3), np.float32)
    if len(surface.paint) == len(points):
        paint = _linear(np.array(list(surface.paint.values())))[corners].astype(np.float32)
    return PlainModel(
        vertices=np.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=1).astype(np.float32),
        corners=corners.astype(np.int32),
        sizes=np.array(surface.sizes, np.int32),
        slots=np.array(surface.slots, np.int32),
        smooth=np.array(surface.smooth, bool),
        layers=layers,
        paint=paint,
    )


def _index(written: str, count: int) -> int:
    """Return a 0-based index of one that counts from 1, or from the end if it is negative."""
    index = int(written)
    return index - 1 if index > 0 else count + index if index < 0 else -1


def _lines(path: Path) -> Iterator[tuple[int, str]]:
    """Yield the lines with words on them and their numbers; a backslash at the end joins the next line."""
    size = path.stat().st_size
    if size > TEXT_BYTES:
        raise InputError(f"it has {size // MIB} MiB; at most {TEXT_BYTES // MIB} are read", mend="export it as .glb")
    with path.open("rb") as file:
        whole: list[str] = []
        for number, raw in enumerate(file, start=1):
            line = raw.split(b"#", 1)[0].decode("utf-8", "replace").rstrip("\r\n")
            if line.endswith("\\"):
                whole.append(line[:-1])
                continue
            line = " ".join([*whole, line]).strip()
            whole.clear()
            if line:
                yield number, line


def _materials(path: Path, folder: Path, notes: list[str]) -> Iterator[tuple[str, PlainMaterial]]:
    """Yield the materials of an .mtl by name."""
    readable(folder, path)
    name, fields = "", {}
    for _, line in _lines(path):
        word, *rest = line.split()
        if word == "newmtl":
            if name:
                yield name, _material(name, fields)
            name, fields = line.split(maxsplit=1)[1].strip() if rest else "", {}
            continue
        try:
            fields |= _property(word, rest, path, folder)
        except InputError as error:
            notes.append(f"{error.problem}; it is left out")
        except ValueError:
            notes.append(f"its {path.name!r} has a line that is no {word!r}; it is left out")
    if name:
        yield name, _material(name, fields)


def _material(name: str, fields: dict[str, Any]) -> PlainMaterial:
    """Return a material of an .mtl; its picture is shown as it is, wherever ``Kd`` stands."""
    white = {"color": (1.0, 1.0, 1.0)} if "picture" in fields else {}
    return PlainMaterial(name=name, **{**fields, **white})


def _property(word: str, rest: list[str], path: Path, folder: Path) -> dict[str, object]:
    match word:
        case "Kd" | "Ke":
            return {"color" if word == "Kd" else "emission": _color(rest)}
        case "d":
            return {"alpha": _share(rest[-1])}
        case "Tr":
            return {"alpha": 1 - _share(rest[-1])}
        case "Pr":
            return {"roughness": _share(rest[-1])}
        case "Pm":
            return {"metallic": _share(rest[-1])}
        case "Ns":
            return {"roughness": 1 - (_share(str(float(rest[-1]) / 1000))) ** 0.5}
        case "map_Kd" | "map_Pr" | "map_Pm" | "norm" | "map_Kn" | "map_Bump" | "map_bump" | "bump" if rest:
            address = _address(rest)
            data, name = inside(folder, path.parent, address).read_bytes(), address[-60:]
            if word == "map_Kd":
                return {"picture": clean_picture(data, name)}
            if word in ("map_Pr", "map_Pm"):
                return {"roughness_map" if word == "map_Pr" else "metallic_map": clean_channel(data, name, 0)}
            normals = clean_normals(data, name)
            if not is_normal_map(normals):
                raise InputError(f"its picture {name!r} holds heights and no normals")
            return {"normal_map": normals}
    return {}


def _address(words: list[str]) -> str:
    """Return a picture's address without the options before it."""
    at = 0
    while at < len(words) - 1 and words[at] in _OPTIONS:
        last = min(at + _OPTIONS[words[at]], len(words) - 2)
        at += 1
        while at <= last and _is_value(words[at]):
            at += 1
    return " ".join(words[at:])


def _is_value(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return word in ("on", "off")
    return True


def _color(rest: list[str]) -> Color:
    red, green, blue = (float(value) for value in (rest * 3 if len(rest) == 1 else rest)[:3])
    clipped = np.nan_to_num(np.clip([red, green, blue], 0, 1)).tolist()
    return clipped[0], clipped[1], clipped[2]


def _share(text: str) -> float:
    return float(np.nan_to_num(np.clip(float(text), 0, 1)))


def _linear(encoded: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return scene-linear colours of sRGB ones."""
    shares = np.nan_to_num(np.clip(encoded / (255 if encoded.max() > 2 else 1), 0, 1))
    return np.where(shares <= 0.04045, shares / 12.92, ((shares + 0.055) / 1.055) ** 2.4)
