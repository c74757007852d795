"""The materials of a glTF: colours, factors and maps, each map as a plain picture of what it is for."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

from storyblender.blender.models.document import Document, Json, finite_numbers, whole
from storyblender.blender.models.limits import MATERIALS, PICTURES
from storyblender.blender.models.pictures import clean_channel, clean_normals, clean_picture
from storyblender.blender.models.plain import PlainMaterial
from storyblender.errors import InputError


def read_materials(document: Document, notes: list[str]) -> Iterator[PlainMaterial]:
    """Yield the materials of a document.

    Args:
        document: The glTF.
        notes: Takes a sentence for each picture that is left out.

    Raises:
        InputError: There are too many, or a value in one is out of range.
    """
    found = document.items("materials")
    if len(found) > MATERIALS:
        raise InputError(f"it has {len(found)} materials; at most {MATERIALS} are read")
    shelf = _Pictures(document, notes)
    for record in found:
        base = _object(record.get("pbrMetallicRoughness"))
        extensions = _object(record.get("extensions"))
        old = _object(extensions.get("KHR_materials_pbrSpecularGlossiness"))
        factor = base.get("baseColorFactor", old.get("diffuseFactor", (1, 1, 1, 1)))
        red, green, blue, alpha = np.clip(finite_numbers(factor, 4), 0, 1).tolist()
        strength = _object(extensions.get("KHR_materials_emissive_strength")).get("emissiveStrength", 1.0)
        light = np.clip(finite_numbers(record.get("emissiveFactor", (0, 0, 0)), 3), 0, 1) * np.clip(
            finite_numbers([strength], 1), 0, 100
        )
        colors = _object(base.get("baseColorTexture", old.get("diffuseTexture")))
        rough = _share(base.get("roughnessFactor", 1.0))
        metallic = _share(base.get("metallicFactor", 1.0))
        bumps, glows = _object(record.get("normalTexture")), _object(record.get("emissiveTexture"))
        surface = _object(base.get("metallicRoughnessTexture"))
        laid = _layout(colors or surface or bumps or glows)
        maps = {
            "roughness_map": shelf.read(surface, laid, clean_channel, 1, rough),
            "metallic_map": shelf.read(surface, laid, clean_channel, 2, metallic),
            "normal_map": shelf.read(bumps, laid, clean_normals),
            "glow_map": shelf.read(glows, laid, clean_picture) if light.any() else b"",
        }
        if glows and not maps["glow_map"]:
            light = light * 0
        yield PlainMaterial(
            name=str(record.get("name", "")),
            color=(red, green, blue),
            alpha=1.0 if record.get("alphaMode", "OPAQUE") == "OPAQUE" else alpha,
            roughness=rough,
            metallic=metallic if not surface else 0.0,
            emission=tuple(light.tolist()),
            picture=shelf.read(colors, laid, clean_picture),
            relief=float(np.clip(finite_numbers([bumps.get("scale", 1.0)], 1)[0], 0, 4)),
            **maps,
            layer=laid.layer,
            offset=laid.offset,
            repeat=laid.repeat,
            turn=laid.turn,
        )


class _Layout(NamedTuple):
    """How a texture lies on the surface: which coordinates, and how they are moved (KHR_texture_transform)."""

    layer: int
    offset: tuple[float, float]
    repeat: tuple[float, float]
    turn: float


def _layout(texture: Json) -> _Layout:
    moved = _object(_object(texture.get("extensions")).get("KHR_texture_transform"))
    return _Layout(
        layer=min(whole(moved.get("texCoord", texture.get("texCoord", 0)), "texCoord", 64), 1),
        offset=_pair(moved.get("offset", (0, 0))),
        repeat=_pair(moved.get("scale", (1, 1))),
        turn=float(finite_numbers([moved.get("rotation", 0.0)], 1)[0]),
    )


class _Pictures:
    """The pictures of a document, of which so many are read at most; those that cannot be used are left out."""

    def __init__(self, document: Document, notes: list[str]) -> None:
        self._document, self._notes = document, notes
        self._read: set[int] = set()
        self._known: dict[tuple[object, ...], bytes] = {}

    def read(self, texture: Json, laid: _Layout, clean: Callable[..., bytes], *given: float) -> bytes:
        """Return a texture's picture; empty, with a note, if it cannot be used.

        Args:
            texture: As a material names it; empty for none.
            laid: How the material's maps lie: one that lies otherwise is left out.
            clean: Makes a plain picture of the bytes and the name of a file.
            given: What else it takes.
        """
        if not texture:
            return b""
        try:
            if _layout(texture) != laid:
                raise InputError("one of its maps has other texture coordinates than its colours")
            index = self._index(texture)
            key = (index, clean, given)
            if key not in self._known:
                self._known[key] = clean(*self._raw(index), *given)
            return self._known[key]
        except InputError as error:
            self._notes.append(f"{error.problem}; it is left out")
            return b""

    def _index(self, texture: Json) -> int:
        record = self._document.item("textures", texture.get("index"))
        webp = _object(_object(record.get("extensions")).get("EXT_texture_webp"))
        index = whole(webp.get("source", record.get("source")), "picture", len(self._document.items("images")) - 1)
        self._read.add(index)
        if len(self._read) > PICTURES:
            raise InputError(f"it has more than {PICTURES} pictures")
        return index

    def _raw(self, index: int) -> tuple[bytes, str]:
        """Return the bytes and the name of a picture."""
        image = self._document.items("images")[index]
        view, address = image.get("bufferView"), image.get("uri")
        data = bytes(self._document.bytes_of(view)) if view is not None else self._document.resource(address, -1)
        return data, str(image.get("name") or address or index)[:60]


def _object(value: Any) -> Json:
    return value if isinstance(value, dict) else {}


def _share(value: Any) -> float:
    return float(np.clip(finite_numbers([value], 1)[0], 0, 1))


def _pair(value: Any) -> tuple[float, float]:
    first, second = finite_numbers(value, 2).tolist()
    return first, second
