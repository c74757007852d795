"""Builds an asset from a user's model file: one mesh, metres, bottom-centre origin, front -Y, with places to use it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import bpy
import numpy as np

from storyblender.blender.measure.surfaces import level_field
from storyblender.blender.models.addresses import readable
from storyblender.blender.models.blend import read_blend, read_foreign
from storyblender.blender.models.credits import with_files
from storyblender.blender.models.gltf import read_gltf
from storyblender.blender.models.obj import read_obj
from storyblender.blender.models.plain import PlainModel
from storyblender.blender.models.rebuild import build_mesh
from storyblender.blender.models.simplify import MOST_FACES, THINNED_FACES, face_budget, simplified
from storyblender.blender.models.tangents import add_tangents
from storyblender.blender.models.usd import read_usd
from storyblender.blender.props.anchors import Anchors, grip
from storyblender.blender.props.build import PropBuild, settle
from storyblender.catalog.props import PROPS, PropEntry
from storyblender.catalog.props.prop_names import kind_named
from storyblender.catalog.usual_sizes import usual_size
from storyblender.errors import InputError
from storyblender.geometry.canonical import (
    TIPS,
    find_likely_tip,
    find_upright_rotation,
    measure_stability,
    proportion_error,
    rotation_of,
)
from storyblender.geometry.facing import crosswise, drives_backwards, quarters_to_hollow_front
from storyblender.geometry.holding import Hold, find_hold
from storyblender.geometry.resting import Places, Use, find_bed, find_seats
from storyblender.geometry.scaling import UsualSize, find_scale
from storyblender.library.file_names import words_of_file
from storyblender.memory.asset_sheet import AssetDimension, Certainty, ModelPose
from storyblender.memory.base import Vec3

_READERS: dict[str, Callable[[Path, Path], PlainModel]] = {
    ".glb": read_gltf,
    ".gltf": read_gltf,
    ".obj": read_obj,
    ".blend": read_blend,
    ".fbx": read_foreign,
    ".stl": read_foreign,
    ".ply": read_foreign,
    ".usd": read_usd,
    ".usda": read_usd,
    ".usdc": read_usd,
    ".usdz": read_usd,
}
SUFFIXES = tuple(_READERS)
"""The files that can be read."""
_SAYS_NO_UP = (".obj", ".stl", ".ply")
"""Files that do not say what is up."""
_LAIN_ON, _SAT_ON = ("cradle", "stretcher"), ("toilet",)
"""Props that one lies or sits on though their names do not say so."""
_LARGE = 12.0
"""Metres: no seat is looked for on a larger model."""
_REST_HEIGHTS = (0.25, 0.62)
"""Metres of most seats and beds; higher on what is higher than a metre."""
_FLAT_BACKED = frozenset(
    ("wardrobe", "dresser", "bookshelf", "cabinet", "filing_cabinet", "locker", "safe", "chest", "nightstand",
     "dressing_table", "piano", "fridge", "fireplace", "washing_machine", "printer", "sink",
     "wood_stove", "water_cooler", "glass_case", "slot_machine", "store_shelf")
)  # fmt: skip
"""Props that stand with a flat back against a wall."""
_LIKE_CARS = ("car", "taxi", "police_car", "jeep", "convertible")
_CABINS = (*_LIKE_CARS, "pickup", "van", "ambulance", "truck", "bus", "fire_engine")
"""Vehicles whose floor is no seat."""
_ON_WALLS = frozenset(("wall", "sconce", "switch", "socket", "outlet", "plug", "dimmer", "thermostat"))
"""Words of a name by which a thing hangs on a wall."""


AS_ITS_SHAPE_SAYS = ModelPose()
"""The pose of a model whose front and top are not decided."""


def build_from_file(
    path: Path,
    dimension: AssetDimension | None = None,
    *,
    folder: Path | None = None,
    prop: str | None = None,
    certainty: Certainty = "usual",
    pose: ModelPose = AS_ITS_SHAPE_SAYS,
) -> PropBuild:
    """Read a model and bring it to the canonical frame.

    Its meshes are joined; everything that is no surface is left out: lights, cameras, rigs, animation, scripts.

    Args:
        path: A file with one of ``SUFFIXES``.
        dimension: What the thing measures, usually; without it the unit is guessed.
        folder: The folder of models; what the file names must be in it. Its own folder if not given.
        prop: Catalog key of what it is, empty for what the catalog lacks; its file's name tells if not given.
        certainty: Of the dimension.
        pose: Its front and top, if they are decided; else they are found by its shape.

    Raises:
        InputError: The file cannot be read or holds no mesh.
    """
    read = read_model(path, folder or path.parent)
    model = read.thinned(THINNED_FACES).repaired()
    mesh = build_mesh(model, path.stem[:40])
    faces = len(mesh.polygons)
    mesh = simplified(mesh, MOST_FACES)
    entry, notes = PROPS.get(kind_named(path.stem) if prop is None else prop), list(model.notes)
    usual = _usual_size(path, entry, dimension)
    credit = with_files(model.credit, path, folder or path.parent, notes)
    if pose.top is not None:
        _transform(mesh, rotation_of(pose))
    elif path.suffix.lower() in _SAYS_NO_UP:
        _stand(mesh, entry, usual, notes, hangs=_hangs(path, entry))
    extent = np.ptp(_points(mesh), axis=0)
    scale, reason = find_scale(extent, usual, dimension, certainty=certainty, unit=model.unit)
    _transform(mesh, np.eye(3) * scale)
    _ground(mesh)
    mesh = simplified(mesh, face_budget(float((extent * scale).max())))
    if len(mesh.polygons) < faces:
        notes.append(f"its {faces} faces become {len(mesh.polygons)}, as many as show on its size")
    if reason:
        notes.append(f"{_size(extent)} becomes {_size(extent * scale)} ({scale:.4g} times): {reason}")
    places = _places(mesh, entry)
    if pose.front is None and (
        quarters := _quarters_to_front(mesh, entry, usual, places, decided=pose.top is not None)
    ):
        _transform(mesh, _quarter_turns(quarters))
        places = _places(mesh, entry)
        notes.append(f"it is turned by {90 * min(quarters, 4 - quarters)} degrees to face the front")
    elif places.backed and places.anchors[0].direction[1] > -0.9:
        notes.append("its front is as a person or a model chose it; by its shape it would face another way")
    build = settle(mesh, places.anchors)
    if not build.anchors:
        build = replace(build, anchors=_grips(find_hold(_points(mesh), _triangles(mesh))))
    if any(material.normal_map for material in model.materials):
        add_tangents(build.mesh)
    return replace(build, notes=tuple(f"{path.name}: {note}" for note in notes), credit=credit)


def read_model(path: Path, folder: Path) -> PlainModel:
    """Read the surface of a model.

    Args:
        path: A file with one of ``SUFFIXES``.
        folder: The folder of models; the file and what it names must be in it.

    Raises:
        InputError: It cannot be used; one sentence.
    """
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        named = path.suffix or "nameless"
        raise InputError(f"a {named} file is no model", mend=f"use {', '.join(SUFFIXES)}", path=path)
    if not path.is_file():
        raise InputError("there is no such model", path=path)
    try:
        return reader(readable(folder, path), folder)
    except InputError as error:
        mend = error.mend or "export it again as .glb"
        raise InputError(f"the model cannot be used: {error.problem}", mend=mend, path=path) from error
    except (OSError, MemoryError) as error:
        problem = f"the model cannot be read ({type(error).__name__})"
        raise InputError(problem, mend="export it again as .glb", path=path) from error


def _usual_size(path: Path, entry: PropEntry | None, dimension: AssetDimension | None) -> UsualSize | None:
    """Return how large a thing usually is: as its file's name says more closely, else as the catalog says.

    A dimension that differs from the catalog's, as of a small table, makes all of it smaller.
    """
    known = usual_size(words_of_file(path.name).words) or ((entry.size, 1.0) if entry is not None else None)
    if known is None:
        return None
    size, span = known
    share = 1.0
    if entry is not None and dimension is not None:
        side = next(side for side in ("width", "depth", "height") if getattr(dimension, side) is not None)
        share = getattr(dimension, side) / entry.size[("width", "depth", "height").index(side)]
    width, depth, height = (share * each for each in size)
    return UsualSize((width, depth, height), firm=entry is not None and entry.category == "furniture", span=span)


def _hangs(path: Path, entry: PropEntry | None) -> bool:
    """Return whether a thing hangs on a wall, by what it is called."""
    return bool(_ON_WALLS & {*words_of_file(path.name).words}) or (entry is not None and entry.placement == "wall")


def _use(entry: PropEntry | None) -> Use:
    """Return what a thing is for, by what it is called."""
    if entry is None:
        return ""
    if "bed" in (entry.key, entry.key.rpartition("_")[2]) or entry.key in _LAIN_ON:
        return "bed"
    return "seat" if entry.seats or entry.key in _SAT_ON else "other"


def _places(mesh: bpy.types.Mesh, entry: PropEntry | None) -> Places:
    """Return where one sits or lies on a mesh in metres."""
    use = _use(entry)
    if use == "other" or max(np.ptp(_points(mesh), axis=0)) > _LARGE:
        return Places()
    field = level_field(mesh)
    bed = find_bed(field, use)
    faces_front = entry is not None and entry.category in ("vehicle", "animal")
    if bed.anchors:
        return bed
    return find_seats(field, use, faces_front=faces_front, cabin=entry is not None and entry.key in _CABINS)


def _quarters_to_front(
    mesh: bpy.types.Mesh, entry: PropEntry | None, usual: UsualSize | None, places: Places, *, decided: bool
) -> int:
    """Return by how many quarters, counter-clockwise from above, a mesh turns to have its front at -Y.

    A back or a headboard tells it, else proportions, a flat back, and the bonnet of a car; not where a person or a
    model has looked and saw no front.
    """
    if places.backed:
        x, y = (round(value) for value in places.anchors[0].direction[:2])
        return {(0, -1): 0, (1, 0): 3, (0, 1): 2, (-1, 0): 1}[(x, y)]
    if entry is None or usual is None or decided or _use(entry) == "bed":
        return 0
    points, triangles = _points(mesh), _triangles(mesh)
    across = crosswise(np.ptp(points, axis=0), usual.size)
    if entry.key in _LIKE_CARS:
        turned = points @ _quarter_turns(int(across)).T
        return int(across) + 2 * drives_backwards(turned, triangles)
    if entry.key in _FLAT_BACKED:
        allowed = (1, 3) if across else (0, 1, 2, 3) if max(usual.size[:2]) < 1.3 * min(usual.size[:2]) else (0, 2)
        return quarters_to_hollow_front(points, triangles, allowed)
    return int(across)


def _quarter_turns(quarters: int) -> np.ndarray:
    """Return the (3, 3) rotation about Z, counter-clockwise from above."""
    return np.linalg.matrix_power(np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]), quarters)


def _stand(
    mesh: bpy.types.Mesh, entry: PropEntry | None, usual: UsualSize | None, notes: list[str], *, hangs: bool
) -> None:
    """Put a mesh on its feet: as one sits or lies on it, else in its usual proportions, else as it does not fall.

    What hangs on a wall stands on nothing.
    """
    points, triangles = _points(mesh), _triangles(mesh)
    turn = find_likely_tip(points, triangles, usual.size) if usual is not None else None
    if _use(entry) in ("seat", "bed") and usual is not None and not (entry and entry.category == "vehicle"):
        turn = _tip_to_rest_on(mesh, entry, usual)
    if turn is None:
        turn = np.eye(3) if hangs else find_upright_rotation(points, triangles)
    if not np.array_equal(turn, np.eye(3)):
        _transform(mesh, turn)
        notes.append("it is tipped up to stand on its feet")


def _tip_to_rest_on(mesh: bpy.types.Mesh, entry: PropEntry | None, usual: UsualSize) -> np.ndarray | None:
    """Return the tip after which one sits with a back behind one, or lies, as high as usual; None if there is none."""
    best, chosen = 0.0, None
    for turn, doubt in zip(TIPS, (0.0, 0.2, 0.5, 0.5), strict=True):
        found = _places_when(mesh, turn, entry, usual)
        if not found.anchors:
            continue
        height = found.anchors[0].location[2]
        fits = _REST_HEIGHTS[0] < height < _REST_HEIGHTS[1] * max(1.0, usual.size[2])
        points = _points(mesh) @ turn.T
        steady = float(np.clip(measure_stability(points, _triangles(mesh)), -1, 1))
        score = 1.0 + found.backed + fits + steady - proportion_error(np.ptp(points, axis=0), usual.size) - doubt
        if score > best:
            best, chosen = score, turn
        if found.backed and fits and steady > 0 and not doubt:
            break
    return chosen


def _places_when(mesh: bpy.types.Mesh, turn: np.ndarray, entry: PropEntry | None, usual: UsualSize | None) -> Places:
    """Return where one could sit or lie if a mesh stood in another way."""
    trial = mesh.copy()
    _transform(trial, turn)
    scale, _ = find_scale(np.ptp(_points(trial), axis=0), usual)
    _transform(trial, np.eye(3) * scale)
    _ground(trial)
    found = _places(trial, entry)
    bpy.data.meshes.remove(trial)
    return found


def _grips(hold: Hold | None) -> Anchors:
    """Return the grips of a small thing around its slender part, or at its side."""
    if hold is None:
        return ()
    x, y, z = hold.place
    ways: tuple[Vec3, Vec3]
    match hold.axis:
        case 0:
            place, ways = (x, y, z + hold.half), ((0.0, -1.0, 0.1), (0.0, -0.1, -1.0))
        case 1:
            place, ways = (x - hold.half, y, z), ((0.15, -0.4, -0.9), (1.0, 0.1, 0.0))
        case _:
            place, ways = (x - hold.half, y + 0.004, z), ((0.2, -1.0, 0.0), (1.0, 0.15, 0.0))
    (fx, fy, fz), (px, py, pz) = ways
    curl = (hold.closed, hold.closed, 0.6 * hold.closed)
    return (
        grip("grip_r", place, (fx, fy, fz), (px, py, pz), curl),
        grip("grip_l", (2 * x - place[0], place[1], place[2]), (-fx, fy, fz), (-px, py, pz), curl),
    )


def _points(mesh: bpy.types.Mesh) -> np.ndarray:
    points = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", points)
    return points.reshape(-1, 3).astype(float)


def _triangles(mesh: bpy.types.Mesh) -> np.ndarray:
    mesh.calc_loop_triangles()
    corners = np.empty(len(mesh.loop_triangles) * 3, np.int32)
    mesh.loop_triangles.foreach_get("vertices", corners)
    return corners.reshape(-1, 3).astype(np.int64)


def _transform(mesh: bpy.types.Mesh, matrix: np.ndarray) -> None:
    mesh.vertices.foreach_set("co", (_points(mesh) @ matrix.T).astype(np.float32).ravel())
    mesh.update()


def _ground(mesh: bpy.types.Mesh) -> None:
    """Move a mesh to the middle of the floor, wherever its file has it."""
    points = _points(mesh)
    low, high = points.min(axis=0), points.max(axis=0)
    mesh.vertices.foreach_set("co", (points - (*(low + high)[:2] / 2, low[2])).astype(np.float32).ravel())
    mesh.update()


def _size(extent: np.ndarray) -> str:
    return " x ".join(f"{value:.3g}" for value in extent) + " m"
