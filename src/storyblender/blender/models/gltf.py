"""Reads the surface of a glTF model: where its meshes stand, their faces, colours and pictures. Nothing else is taken.

glTF says what is up and front and that it is in metres; the result is Z up, front -Y, as Blender has it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.models.blend import read_aside
from storyblender.blender.models.credits import credit_in_gltf
from storyblender.blender.models.document import Document, Json, finite_numbers, read_document, whole
from storyblender.blender.models.gltf_materials import read_materials
from storyblender.blender.models.limits import CORNERS, DEPTH, NODES, PARTS
from storyblender.blender.models.parts import Part, joined, within_bounds
from storyblender.blender.models.pictures import clean_picture
from storyblender.blender.models.plain import PlainModel, PlainRig
from storyblender.errors import InputError

Matrix = NDArray[np.float64]

_UPRIGHT = np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
"""Z up from Y up."""
_READ = ("KHR_materials_", "KHR_texture_transform", "KHR_mesh_quantization", "KHR_lights_punctual", "EXT_texture_webp")
"""Required extensions that the surface can be read with."""
_DRACO = "KHR_draco_mesh_compression"
_TRIANGLES, _STRIP, _FAN = 4, 5, 6


def read_gltf(path: Path, folder: Path) -> PlainModel:
    """Read a .glb or .gltf.

    Args:
        path: The file.
        folder: The folder of models; what the file names must be in it.

    Raises:
        InputError: It cannot be read; one clause, without the file's name.
    """
    document = read_document(path, folder)
    required = document.json.get("extensionsRequired", [])
    for name in required if isinstance(required, list) else [required]:
        if name != _DRACO and not str(name).startswith(_READ):
            mend = "export it again without compression" if "compression" in str(name) else ""
            raise InputError(f"it needs the glTF extension {str(name)[:60]!r}, which cannot be read", mend=mend)
    if isinstance(required, list) and _DRACO in required:
        return _unpacked(document, path, folder)
    notes: list[str] = []
    materials = tuple(read_materials(document, notes))
    parts: list[Part] = []
    vertices = faces = 0
    for part in _parts(document, len(materials)):
        vertices, faces = vertices + len(part.vertices), faces + len(part.triangles)
        within_bounds(vertices, faces)
        parts.append(part)
    model = joined(parts).with_materials(materials, tuple(dict.fromkeys(notes)))
    credit, rig = credit_in_gltf(document.json.get("asset")), _rig(document, parts)
    return replace(model, credit=credit, unit=1.0, rig=rig)


def _unpacked(document: Document, path: Path, folder: Path) -> PlainModel:
    """Return a model whose meshes only Blender can unpack, once its nodes, sizes and addresses have been checked."""
    _places(document)
    within_bounds(
        sum(whole(record.get("count"), "count", CORNERS) for record in document.items("accessors")) // 4 or 1, 1
    )
    for index, buffer in enumerate(document.items("buffers")):
        document.resource(buffer.get("uri"), index)
    for index in range(len(document.items("bufferViews"))):
        document.bytes_of(index)
    for image in document.items("images"):
        if image.get("uri") is not None:
            clean_picture(document.resource(image["uri"], -1), str(image.get("name", ""))[:60])
    return replace(read_aside(path, folder), credit=credit_in_gltf(document.json.get("asset")))


# ---------------------------------------------------------------------- nodes


def _parts(document: Document, materials: int) -> Iterator[Part]:
    places = _places(document)
    skins = document.items("skins")
    for index, place in places.items():
        node = document.items("nodes")[index]
        if node.get("mesh") is None:
            continue
        mesh = document.item("meshes", node["mesh"])
        primitives = mesh.get("primitives")
        if not isinstance(primitives, list) or len(primitives) > PARTS:
            raise InputError("a mesh in it has no list of primitives")
        skin = None if node.get("skin") is None else skins[whole(node["skin"], "skin", len(skins) - 1)]
        joints = None if skin is None else _joints(document, skin, places)
        moved_by = [] if skin is None else _indices(skin.get("joints", []), len(document.items("nodes")), "joint")
        for primitive in primitives:
            if not isinstance(primitive, dict):
                raise InputError("a mesh in it has a primitive that is none")
            part = _part(document, primitive, _UPRIGHT @ place, joints, materials)
            if part is not None:
                yield replace(part, **_skin_of(document, primitive["attributes"], moved_by, index, len(part.vertices)))


def _skin_of(document: Document, attributes: Json, moved_by: list[int], node: int, count: int) -> dict[str, Any]:
    """Return the nodes that move a primitive's vertices, and how much: its skin's, else the node that it is at."""
    which = _attribute(document, attributes, "JOINTS_0", 4, count) if moved_by else None
    weights = _attribute(document, attributes, "WEIGHTS_0", 4, count) if moved_by else None
    if which is None or weights is None:
        return {"joints": np.full((count, 4), (node, -1, -1, -1)), "weights": np.full((count, 4), (1.0, 0, 0, 0))}
    return {
        "joints": np.array(moved_by)[which.astype(int)],
        "weights": weights / np.maximum(weights.sum(axis=1, keepdims=True), 1e-9),
    }


def _rig(document: Document, parts: Sequence[Part]) -> PlainRig | None:
    """Return the skeleton of the document's skins; None where nothing is skinned."""
    if not document.items("skins"):
        return None
    nodes, places = document.items("nodes"), _places(document)
    parents = np.full(len(nodes), -1)
    for index, node in enumerate(nodes):
        parents[_indices(node.get("children", []), len(nodes), "child of a node")] = index
    stand = np.array([_UPRIGHT @ places.get(index, np.eye(4)) for index in range(len(nodes))])
    return PlainRig(
        names=tuple(str(node.get("name", ""))[:60] for node in nodes),
        parents=tuple(parents.tolist()),
        heads=stand[:, :3, 3].astype(np.float32),
        joints=np.concatenate([part.joints for part in parts if part.joints is not None]).astype(np.int32),
        weights=np.concatenate([part.weights for part in parts if part.weights is not None]).astype(np.float32),
    )


def _places(document: Document) -> dict[int, Matrix]:
    """Return the matrix of every node of the scene; a node that is its own ancestor is refused."""
    nodes = document.items("nodes")
    if len(nodes) > NODES:
        raise InputError(f"it has {len(nodes)} nodes; at most {NODES} are read")
    children = [_indices(node.get("children", []), len(nodes), "child of a node") for node in nodes]
    scenes = document.items("scenes")
    if scenes:
        scene = scenes[whole(document.json.get("scene", 0), "scene", len(scenes) - 1)]
        roots = _indices(scene.get("nodes", []), len(nodes), "node of the scene")
    else:
        below = {child for each in children for child in each}
        roots = [index for index in range(len(nodes)) if index not in below]
    places: dict[int, Matrix] = {}
    waiting = [(index, np.eye(4), 0) for index in reversed(roots)]
    while waiting:
        index, above, depth = waiting.pop()
        if index in places:
            raise InputError("a node in it is below itself or below two others")
        if depth > DEPTH:
            raise InputError(f"its nodes are nested more than {DEPTH} deep")
        places[index] = above @ _matrix(nodes[index])
        waiting += [(child, places[index], depth + 1) for child in reversed(children[index])]
    return places


def _matrix(node: Json) -> Matrix:
    if node.get("matrix") is not None:
        return finite_numbers(node["matrix"], 16).reshape(4, 4).T
    x, y, z, w = finite_numbers(node.get("rotation", (0, 0, 0, 1)), 4)
    length = math.sqrt(x * x + y * y + z * z + w * w) or 1.0
    x, y, z, w = (value / length for value in (x, y, z, w))
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    matrix = np.eye(4)
    matrix[:3, :3] = turn * finite_numbers(node.get("scale", (1, 1, 1)), 3)
    matrix[:3, 3] = finite_numbers(node.get("translation", (0, 0, 0)), 3)
    return matrix


def _joints(document: Document, skin: Json, places: dict[int, Matrix]) -> NDArray[np.float64]:
    """Return the (n, 4, 4) matrices that bring a skinned mesh to its resting pose."""
    joints = _indices(skin.get("joints", []), len(document.items("nodes")), "joint")
    if skin.get("inverseBindMatrices") is None:
        bound = np.tile(np.eye(4), (len(joints), 1, 1))
    else:
        numbers = document.numbers(skin["inverseBindMatrices"])
        if numbers.shape[1] != 16 or len(numbers) < len(joints):
            raise InputError("its skin has too few matrices")
        bound = numbers[: len(joints)].reshape(-1, 4, 4).transpose(0, 2, 1)
    stand = np.array([places.get(joint, np.eye(4)) for joint in joints]).reshape(-1, 4, 4)
    return _UPRIGHT @ stand @ bound


# ---------------------------------------------------------------------- meshes


def _part(
    document: Document, primitive: Json, place: Matrix, joints: NDArray[np.float64] | None, materials: int
) -> Part | None:
    """Return the faces of a primitive; None for points, lines and nothing."""
    mode = primitive.get("mode", _TRIANGLES)
    attributes = primitive.get("attributes")
    if not isinstance(attributes, dict) or attributes.get("POSITION") is None:
        raise InputError("a mesh in it has no positions")
    if mode not in (_TRIANGLES, _STRIP, _FAN):
        return None
    points = _attribute(document, attributes, "POSITION", 3)
    assert points is not None
    triangles = _triangles(document, primitive, len(points), mode)
    if not len(triangles):
        return None
    layers = [_attribute(document, attributes, f"TEXCOORD_{layer}", 2, len(points)) for layer in (0, 1)]
    laid = [np.c_[layer[:, 0], 1 - layer[:, 1]] for layer in layers if layer is not None]
    paint = _attribute(document, attributes, "COLOR_0", None, len(points))
    slot = -1 if primitive.get("material") is None else whole(primitive["material"], "material", materials - 1)
    placed = _placed(points, place) if joints is None else _posed(document, attributes, points, joints, place)
    if joints is None and np.linalg.det(place[:3, :3]) < 0:
        triangles = triangles[:, ::-1]
    corners = triangles.ravel()
    return Part(
        placed,
        triangles,
        slot,
        smooth=attributes.get("NORMAL") is not None,
        layers=[layer[corners] for layer in laid],
        paint=None if paint is None else np.clip(paint[corners, :3], 0, 1),
    )


def _triangles(document: Document, primitive: Json, count: int, mode: int) -> NDArray[np.int64]:
    if primitive.get("indices") is None:
        order = np.arange(count)
    else:
        numbers = document.numbers(primitive["indices"])
        order = numbers[:, 0].astype(np.int64)
        if numbers.shape[1] != 1 or (len(order) and (order.min() < 0 or order.max() >= count)):
            raise InputError("a face in it has a corner that is not there")
    if mode == _TRIANGLES:
        return order[: len(order) // 3 * 3].reshape(-1, 3)
    if len(order) < 3:
        return np.zeros((0, 3), np.int64)
    if mode == _FAN:
        return np.stack([np.full(len(order) - 2, order[0]), order[1:-1], order[2:]], axis=1)
    strip = np.stack([order[:-2], order[1:-1], order[2:]], axis=1)
    strip[1::2] = strip[1::2, [1, 0, 2]]
    return strip


def _attribute(
    document: Document, attributes: Json, name: str, width: int | None, count: int | None = None
) -> NDArray[np.float64] | None:
    if attributes.get(name) is None:
        return None
    values = document.numbers(attributes[name])
    if (width is not None and values.shape[1] != width) or (count is not None and len(values) != count):
        raise InputError(f"its {name} has not one value for each vertex")
    if name == "COLOR_0" and values.shape[1] not in (3, 4):
        raise InputError("its COLOR_0 is no colour")
    return values if name == "POSITION" else np.nan_to_num(values, posinf=0.0, neginf=0.0)


def _placed(points: NDArray[np.float64], matrix: Matrix) -> NDArray[np.float64]:
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def _posed(
    document: Document, attributes: Json, points: NDArray[np.float64], joints: NDArray[np.float64], place: Matrix
) -> NDArray[np.float64]:
    """Return the points of a skinned mesh as its joints stand."""
    which = _attribute(document, attributes, "JOINTS_0", 4, len(points))
    weights = _attribute(document, attributes, "WEIGHTS_0", 4, len(points))
    if which is None or weights is None:
        return _placed(points, place)
    if len(which) and (not len(joints) or which.min() < 0 or which.max() >= len(joints)):
        raise InputError("its skin has a joint that is not there")
    result = np.zeros_like(points)
    total = np.maximum(weights.sum(axis=1, keepdims=True), 1e-9)
    for column in range(4):
        matrices = joints[which[:, column].astype(int)]
        moved = np.einsum("nij,nj->ni", matrices[:, :3, :3], points) + matrices[:, :3, 3]
        result += moved * weights[:, column, None] / total
    return result


def _indices(values: Any, count: int, what: str) -> list[int]:
    if not isinstance(values, list):
        raise InputError(f"its list of each {what} is none")
    return [whole(value, what, count - 1) for value in values]
