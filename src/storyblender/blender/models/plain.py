"""A model as plain data: what is left of a file when everything but its surface is taken away."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from storyblender.errors import InputError
from storyblender.geometry.mesh_repair import Surface, find_foreign, find_inside_out
from storyblender.geometry.thinning import thin_out
from storyblender.memory.asset_sheet import Credit
from storyblender.memory.base import Color

Floats = NDArray[np.float32]
Ints = NDArray[np.int32]


@dataclass(frozen=True)
class PlainMaterial:
    """What a surface is made of.

    Attributes:
        name: As in the file, for people.
        color: Scene-linear; multiplies the picture.
        alpha: 0..1.
        roughness: 0..1.
        metallic: 0..1.
        emission: Scene-linear colour times strength.
        picture: Base colour map: bytes of a PNG or JPEG in sRGB; empty for none, as of the other maps.
        roughness_map: Grey PNG, 0 mirror to 1 matt; replaces ``roughness``.
        metallic_map: Grey PNG, 0..1; replaces ``metallic``.
        normal_map: PNG or JPEG of tangent space normals, +Y up (OpenGL).
        relief: Strength of the normal map; 1 is as it was made.
        glow_map: PNG or JPEG in sRGB that multiplies ``emission``.
        layer: Which texture coordinates lay out the maps.
        offset: Of the maps, in their own size.
        repeat: Of the maps.
        turn: Radians.
    """

    name: str = ""
    color: Color = (0.8, 0.8, 0.8)
    alpha: float = 1.0
    roughness: float = 0.6
    metallic: float = 0.0
    emission: Color = (0.0, 0.0, 0.0)
    picture: bytes = b""
    roughness_map: bytes = b""
    metallic_map: bytes = b""
    normal_map: bytes = b""
    relief: float = 1.0
    glow_map: bytes = b""
    layer: int = 0
    offset: tuple[float, float] = (0.0, 0.0)
    repeat: tuple[float, float] = (1.0, 1.0)
    turn: float = 0.0

    @property
    def is_mapped(self) -> bool:
        """Whether any map is laid out on the surface."""
        return any(getattr(self, name) for name in MAPS)


MAPS = ("picture", "roughness_map", "metallic_map", "normal_map", "glow_map")
"""Fields of a material with the bytes of a picture."""


@dataclass(frozen=True, eq=False)
class PlainRig:
    """The skeleton that a file has for its surface, as it stands in the file.

    Attributes:
        names: Of its J joints.
        parents: (J,) the joint that each hangs on, -1 for none.
        heads: (J, 3) where the joints are, in the model's frame and unit.
        joints: (n, 4) joints that move each vertex, -1 for none.
        weights: (n, 4) how much; rows sum to 1, or to 0 where nothing moves a vertex.
    """

    names: tuple[str, ...]
    parents: tuple[int, ...]
    heads: Floats
    joints: Ints
    weights: Floats


@dataclass(frozen=True)
class PlainModel:
    """One surface: polygons with materials, in the file's units, Z up, as its importer turned it.

    Attributes:
        vertices: (n, 3).
        corners: (c,) vertex of each corner.
        sizes: (f,) corners of each face.
        slots: (f,) material of each face; an index into ``materials``, or -1.
        smooth: (f,) whether a face is shaded smooth.
        layers: (k, c, 2) texture coordinates, k of 0 to 2.
        paint: (c, 3) scene-linear vertex colours, or (0, 3) if the file has none.
        materials: Of the faces.
        notes: Sentences about what was left out.
        credit: Whose work it is, as the file says.
        unit: Metres of the unit that the file or its format states; None if it states none.
        rig: The file's own skeleton; of skinned glTF files only.
    """

    vertices: Floats
    corners: Ints
    sizes: Ints
    slots: Ints
    smooth: NDArray[np.bool_]
    layers: Floats
    paint: Floats
    materials: tuple[PlainMaterial, ...] = ()
    notes: tuple[str, ...] = field(default=())
    credit: Credit = field(default_factory=Credit)
    unit: float | None = None
    rig: PlainRig | None = None

    def with_materials(self, materials: tuple[PlainMaterial, ...], notes: tuple[str, ...]) -> PlainModel:
        """Return the same surface with materials and further notes."""
        return replace(self, materials=materials, notes=(*self.notes, *notes))

    def repaired(self) -> PlainModel:
        """Return the surface without what is none of the thing, all closed parts of it with their outer side out."""
        foreign, notes = find_foreign(self._surface())
        model = self._with(np.repeat(~foreign, self.sizes), ~foreign) if foreign.any() else self
        inverted = find_inside_out(model._surface())
        if inverted.any():
            starts = np.repeat(np.cumsum(model.sizes) - model.sizes, model.sizes)
            ends = starts + np.repeat(model.sizes, model.sizes) - 1
            at = np.arange(len(model.corners))
            model = model._with(np.where(np.repeat(inverted, model.sizes), starts + ends - at, at), slice(None))
        used, corners = np.unique(model.corners, return_inverse=True)
        vertices, corners = model.vertices[used], corners.ravel().astype(np.int32)
        return replace(model, vertices=vertices, corners=corners, notes=(*self.notes, *notes))

    def thinned(self, most: int) -> PlainModel:
        """Return the surface with about so many triangles at most, if it has more: what is finer than any picture."""
        if len(self.corners) - 2 * len(self.sizes) <= most:
            return self
        model = self._triangles()
        triangles = model.corners.reshape(-1, 3).astype(np.int64)
        stand_in, kept = thin_out(model.vertices.astype(float), triangles, most)
        moved = replace(model, corners=stand_in[model.corners].astype(np.int32))
        return moved._with(np.repeat(kept, 3), kept)

    def _triangles(self) -> PlainModel:
        """Return the surface with every polygon as a fan of triangles."""
        if (self.sizes == 3).all():
            return self
        faces = np.repeat(np.arange(len(self.sizes)), self.sizes - 2)
        starts = (np.cumsum(self.sizes) - self.sizes)[faces]
        step = np.arange(len(faces)) - np.repeat(np.cumsum(self.sizes - 2) - (self.sizes - 2), self.sizes - 2) + 1
        corners = np.stack([starts, starts + step, starts + step + 1], axis=1).ravel()
        return replace(self._with(corners, faces), sizes=np.full(len(faces), 3, np.int32))

    def _surface(self) -> Surface:
        return Surface(self.vertices.astype(float), self.corners.astype(np.int64), self.sizes.astype(np.int64))

    def _with(
        self, corners: NDArray[np.bool_] | NDArray[np.int64], faces: NDArray[np.bool_] | NDArray[np.int64] | slice
    ) -> PlainModel:
        """Return the model with these corners, in this order, and these faces."""
        return replace(
            self,
            corners=self.corners[corners],
            sizes=self.sizes[faces],
            slots=self.slots[faces],
            smooth=self.smooth[faces],
            layers=self.layers[:, corners],
            paint=self.paint[corners] if len(self.paint) else self.paint,
        )


_ARRAYS = ("vertices", "corners", "sizes", "slots", "smooth", "layers", "paint")


def save(model: PlainModel, folder: Path) -> None:
    """Write a ``model`` into a ``folder`` that exists: arrays, a record, and a file a map."""
    np.savez(folder / "model.npz", **{name: getattr(model, name) for name in _ARRAYS})
    materials: list[dict[str, Any]] = []
    for index, material in enumerate(model.materials):
        for name in MAPS:
            (folder / f"{index}.{name}").write_bytes(getattr(material, name))
        materials.append({key: value for key, value in vars(material).items() if key not in MAPS})
    (folder / "model.json").write_text(
        json.dumps({"materials": materials, "notes": model.notes, "credit": dict(model.credit), "unit": model.unit})
    )


def load(folder: Path) -> PlainModel:
    """Read what ``save`` wrote.

    Raises:
        InputError: It is not whole.
    """
    try:
        record = json.loads((folder / "model.json").read_text())
        with np.load(folder / "model.npz", allow_pickle=False) as stored:
            arrays = {name: stored[name] for name in _ARRAYS}
        materials = tuple(
            PlainMaterial(**{name: (folder / f"{index}.{name}").read_bytes() for name in MAPS}, **_tuples(fields))
            for index, fields in enumerate(record["materials"])
        )
        credit = Credit(**record["credit"])
    except (OSError, ValueError, KeyError, EOFError) as error:
        raise InputError("what was read of it is not whole") from error
    return PlainModel(**arrays, materials=materials, notes=tuple(record["notes"]), credit=credit, unit=record["unit"])


def _tuples(fields: dict[str, Any]) -> dict[str, Any]:
    return {key: tuple(value) if isinstance(value, list) else value for key, value in fields.items()}
