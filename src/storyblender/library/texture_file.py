"""Reads the pictures of a user's surface and prepares them for the engine: square, 1k, written anew.

A surface is a colour picture with its other maps beside it, told apart by the endings that Poly Haven, ambientCG and
others use, such as ``oak_diff_1k.jpg``, ``oak_nor_gl_1k.png``. Blender never opens what came from outside.
"""

from __future__ import annotations

import hashlib
import io
import re
import struct
import tomllib
import warnings
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Literal
from urllib.parse import unquote

import numpy as np
from PIL import Image, UnidentifiedImageError

from storyblender.errors import InputError
from storyblender.library.model_folders import MODEL_SUFFIXES
from storyblender.memory.asset_sheet import Provenance
from storyblender.memory.texture import Texture, TextureMap
from storyblender.model_content import CREDITS, credit_beside

SIDE = 1024
"""Pixels of the prepared pictures, which are square; smaller ones stay as they are."""
OWN = "texture"
"""Source of a surface that a person has."""
USUAL_METRES = 2.0
"""Width of a surface whose size is not told."""
_MOST_BYTES, _MOST_PIXELS, _LEAST = 64 << 20, 64_000_000, 16
_MOST_FILES = 500
"""Names in a folder that are looked at."""
_MODELS = frozenset((*MODEL_SUFFIXES, ".mtl"))
_NAMING = frozenset((".gltf", ".mtl"))
"""Files whose text names the pictures of a model."""
_MOST_TEXT = 1 << 20
_TEXTURES = re.compile(r"textures?|surfaces?|materials?", re.IGNORECASE)
"""In the name of a folder whose pictures are surfaces."""
_FORMATS = ("PNG", "JPEG", "WEBP", "TGA", "BMP", "TIFF")
_SUFFIXES = frozenset((".png", ".jpg", ".jpeg", ".webp", ".tga", ".bmp", ".tif", ".tiff"))
_DAMAGE = (UnidentifiedImageError, Image.DecompressionBombError, OSError, ValueError, SyntaxError, EOFError, TypeError,
           LookupError, ArithmeticError, MemoryError, struct.error, zlib.error)  # fmt: skip
"""What decoders of damaged pictures end with."""
_MEND = "give the colour picture of a surface, or a folder with its maps (_diff, _nor_gl, _rough): PNG or JPEG"
_LINES = 1.6
"""Times as much change across as along a grain: from there on boards have a direction."""

_Source = Literal["color", "normal", "normal_dx", "roughness", "gloss", "arm"]
_NAMES: dict[_Source, str] = {
    "color": "diff diffuse col color colour basecolor basecolour albedo alb",
    "normal": "nor norgl normal normalgl nrm norm",
    "normal_dx": "nordx normaldx",
    "roughness": "rough roughness rgh",
    "gloss": "gloss glossiness",
    "arm": "arm orm aorm",
}
_ENDINGS: dict[str, _Source] = {name: kind for kind, names in _NAMES.items() for name in names.split()}
_ENDING = re.compile(r"(?:^|[ _.-]+)(base[ _-]?colou?r|nor(?:mal)?[ _-]?(?:gl|dx)|[a-z]+)$", re.IGNORECASE)
_SIZE = re.compile(r"[ _.-]+(?:\d+k(?:[ _-](?:jpg|png))?|\d{3,4}(?:x\d{3,4})?|jpg|png)$", re.IGNORECASE)


def read_texture(path: Path, metres: float | None = None) -> tuple[Texture, dict[str, bytes]]:
    """Read a surface.

    Args:
        path: The user's colour picture, or the folder of one surface; ``credits.toml`` there says whose work it is.
        metres: Width of the picture on the wall; None for what ``credits.toml`` says, or the usual.

    Returns:
        What the graph keeps of it, and its prepared pictures by their paths in a project.

    Raises:
        InputError: It is missing, broken, or no surface.
    """
    if not path.exists():
        raise InputError("there is no such picture or folder", mend=_MEND, path=path)
    found = _maps_in(path) if path.is_dir() else _maps_beside(path)
    data: dict[_Source, bytes] = {name: _content(file) for name, file in found.items()}
    digest = hashlib.sha256()
    for name in sorted(data):
        digest.update(f"{name}:{len(data[name])}:".encode() + data[name])
    pictures = _pictures(found, data)
    copies, shape = _copies(*pictures["color"].size), pictures["color"].size
    squared: dict[TextureMap, Image.Image] = {
        name: _squared(picture, copies, shape, name) for name, picture in pictures.items()
    }
    color = np.asarray(squared["color"], np.float32) / 255
    linear = np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)
    rough = squared.get("roughness")
    width = (metres or _width_beside(found["color"]) or USUAL_METRES) * copies[0]
    if not 0.01 <= width <= 100:
        raise InputError("is to be too small or too large", mend="give it a width of 0.01 to 25 metres", path=path)
    texture = Texture(
        provenance=Provenance(
            source=OWN, file=found["color"].name, digest=digest.hexdigest(), **credit_beside(found["color"])
        ),
        metres=round(width, 4),
        color=tuple(round(float(each), 4) for each in linear.mean(axis=(0, 1))),  # pyright: ignore[reportArgumentType]
        roughness=0.8 if rough is None else round(float(np.asarray(rough, np.float32).mean() / 255), 3),
        maps=tuple(squared),
        upright=_upright(color),
    )
    return texture, {texture.file(name): _jpeg(picture, name) for name, picture in squared.items()}


def surfaces_in(folder: Path, root: Path) -> list[Path]:
    """Return the pictures in a folder that are offered as surfaces, by name.

    They are those whose name says that they are a colour map, in a folder of textures any that is no other map; none
    that belongs to a model, because the model's file names it or is named as it is.

    Args:
        folder: Of the user.
        root: The folder that it is in, or itself: models there may have their pictures in it.
    """
    of_textures = _TEXTURES.search(folder.name) is not None
    kinds: tuple[_Source | None, ...] = ("color", None) if of_textures else ("color",)
    found = [file for file in _files(folder) if _named(file)[1] in kinds]
    models = [each for place in {folder, root} for each in _models(place)] if found else []
    names = {_named(model)[0] for model in models}
    told = "".join(map(_text, models))
    return [file for file in found if _named(file)[0] not in names and file.name not in told]


def surface_name(file: Path) -> str:
    """Return what a surface is called, by the name of its colour picture: without its map and size.

    Args:
        file: The colour picture.
    """
    return _named(file)[0].replace("_", " ").strip() or file.stem


def _maps_in(folder: Path) -> dict[_Source, Path]:
    """Return the maps of the one surface in a folder."""
    surfaces: dict[str, dict[_Source, Path]] = {}
    for file in _files(folder):
        surface, kind = _named(file)
        if kind is not None:
            surfaces.setdefault(surface, {}).setdefault(kind, file)
    whole = [maps for maps in surfaces.values() if "color" in maps]
    if len(whole) > 1:
        names = ", ".join(sorted(maps["color"].name for maps in whole)[:5])
        raise InputError(f"holds several surfaces ({names})", mend="name the colour picture of one", path=folder)
    if whole:
        return whole[0]
    pictures = _files(folder)
    if len(pictures) == 1:
        return {"color": pictures[0]}
    raise InputError("holds no colour picture of a surface", mend=_MEND, path=folder)


def _maps_beside(file: Path) -> dict[_Source, Path]:
    """Return a colour picture with the maps of its surface that lie beside it."""
    surface, kind = _named(file)
    if kind not in ("color", None):
        raise InputError(f"is the {kind} map of a surface", mend="name its colour picture", path=file)
    maps: dict[_Source, Path] = {}
    for each in _files(file.parent) if kind else ():
        other, sort = _named(each)
        if other == surface and sort is not None:
            maps.setdefault(sort, each)
    return {**maps, "color": file}


def _files(folder: Path) -> list[Path]:
    """Return the pictures in a folder by name."""
    names = sorted(each for each in folder.iterdir() if each.suffix.lower() in _SUFFIXES and each.is_file())
    return names[:_MOST_FILES]


def _models(folder: Path) -> list[Path]:
    """Return the models in a folder, and the files that say what those are made of."""
    names = sorted(each for each in folder.iterdir() if each.suffix.lower() in _MODELS and each.is_file())
    return names[:_MOST_FILES]


def _text(model: Path) -> str:
    """Return what a file says of the pictures of a model, where that can be read as text."""
    if model.suffix.lower() not in _NAMING or model.stat().st_size > _MOST_TEXT:
        return ""
    return unquote(model.read_text(encoding="utf-8", errors="replace"))


def _named(file: Path) -> tuple[str, _Source | None]:
    """Return the surface that a picture's name tells, and which of its maps it is."""
    stem = file.stem
    while (size := _SIZE.search(stem)) is not None:
        stem = stem[: size.start()]
    ending = _ENDING.search(stem)
    kind = _ENDINGS.get(re.sub(r"[ _-]", "", ending.group(1).lower())) if ending is not None else None
    if ending is None or kind is None:
        return stem.lower(), None
    surface = stem[: ending.start()]
    while (size := _SIZE.search(surface)) is not None:
        surface = surface[: size.start()]
    return surface.lower(), kind


def _width_beside(file: Path) -> float | None:
    """Return the metres that ``credits.toml`` beside a picture says it is wide."""
    try:
        told = tomllib.loads((file.parent / CREDITS).read_text(encoding="utf-8-sig")).get("width")
    except (OSError, ValueError):
        return None
    return float(told) if isinstance(told, int | float) and 0.01 <= told <= 25 else None


def _content(file: Path) -> bytes:
    try:
        if file.suffix.lower() not in _SUFFIXES:
            raise InputError("is no picture of a surface", mend=_MEND, path=file)
        if file.stat().st_size > _MOST_BYTES:
            raise InputError(f"has more than {_MOST_BYTES >> 20} MiB", mend="make it smaller", path=file)
        return file.read_bytes()
    except OSError as error:
        raise InputError(f"cannot be read ({error.strerror})", mend=_MEND, path=file) from error


def _pictures(found: Mapping[_Source, Path], data: Mapping[_Source, bytes]) -> dict[TextureMap, Image.Image]:
    """Return the decoded maps: colour first, normals with green up, roughness as grey."""
    read = {name: _decoded(content, found[name]) for name, content in data.items()}
    pictures: dict[TextureMap, Image.Image] = {"color": read["color"].convert("RGB")}
    for name in ("normal", "normal_dx"):
        if name in read:
            pictures["normal"] = _normals(read[name].convert("RGB"), found[name], flipped=name == "normal_dx")
            break
    if "roughness" in read:
        pictures["roughness"] = read["roughness"].convert("L")
    elif "gloss" in read:
        pictures["roughness"] = read["gloss"].convert("L").point([255 - level for level in range(256)])
    elif "arm" in read:
        pictures["roughness"] = read["arm"].convert("RGB").getchannel(1)
    return pictures


def _decoded(data: bytes, file: Path) -> Image.Image:
    """Return a picture with eight bits a channel; it is decoded only after its header was looked at."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            picture = Image.open(io.BytesIO(data), formats=_FORMATS)
            width, height = picture.size
            if width * height > _MOST_PIXELS or min(width, height) < _LEAST:
                raise InputError(f"is {width} x {height} pixels, too few or too many", mend=_MEND, path=file)
            if picture.mode.startswith(("I", "F")):
                levels = np.asarray(picture, np.float64)
                levels = levels / (257 if picture.mode.startswith("I") else 1 / 255)
                return Image.fromarray(np.clip(np.nan_to_num(levels), 0, 255).astype(np.uint8))
            return picture.convert("RGB")
    except _DAMAGE as error:
        raise InputError("cannot be read as a picture", mend=_MEND, path=file) from error


def _normals(picture: Image.Image, file: Path, *, flipped: bool) -> Image.Image:
    """Return a normal map whose green goes up. Raises InputError for a picture of something else."""
    red, green, blue = np.asarray(picture, np.float32).mean(axis=(0, 1)) / 255
    if blue < 0.6 or abs(red - 0.5) > 0.15 or abs(green - 0.5) > 0.15:
        raise InputError("is no normal map", mend="leave it out, or give one that is blue all over", path=file)
    if not flipped:
        return picture
    bands = picture.split()
    return Image.merge("RGB", (bands[0], bands[1].point([255 - level for level in range(256)]), bands[2]))


def _copies(width: int, height: int) -> tuple[int, int]:
    """Return how many times a picture is laid side by side and on top of each other to be square."""
    pairs = [(across, up) for across in range(1, 7) for up in range(1, 7)]

    def squeezed(pair: tuple[int, int]) -> float:
        return abs(np.log(pair[0] * width / (pair[1] * height)))

    near = [pair for pair in pairs if squeezed(pair) < 0.04]
    return min(near, key=sum) if near else min(pairs, key=squeezed)


def _squared(picture: Image.Image, copies: tuple[int, int], shape: tuple[int, int], name: TextureMap) -> Image.Image:
    """Return a map as a square, no larger than needed, whatever size it came in."""
    across, up = copies
    side = min(SIDE, max(across * shape[0], up * shape[1]))
    if picture.size != (side, side):
        picture = picture.resize((max(side // across, 1), max(side // up, 1)), Image.Resampling.BOX)
    if copies != (1, 1):
        whole = Image.new(picture.mode, (across * picture.width, up * picture.height))
        for x in range(across):
            for y in range(up):
                whole.paste(picture, (x * picture.width, y * picture.height))
        picture = whole.resize((side, side), Image.Resampling.BOX)
    return picture.convert("L" if name == "roughness" else "RGB")


def _upright(color: np.ndarray) -> bool | None:
    """Return whether the lines of a surface run up its picture: between boards it changes more than along them."""
    light = color.mean(axis=2)
    light = light[: len(light) // 4 * 4, : light.shape[1] // 4 * 4].reshape(len(light) // 4, 4, -1, 4).mean(axis=(1, 3))
    across, up = (float(np.square(np.diff(light, axis=axis)).mean()) for axis in (1, 0))
    return None if max(across, up) < _LINES * min(across, up) + 1e-9 else across > up


def _jpeg(picture: Image.Image, name: TextureMap) -> bytes:
    out = io.BytesIO()
    picture.save(out, "JPEG", quality=95 if name == "normal" else 92, subsampling=0)
    return out.getvalue()
