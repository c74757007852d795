"""Builds a prop of the catalog: its mesh in the canonical frame and its anchors."""

from __future__ import annotations

from dataclasses import dataclass, field

import bpy
import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors
from storyblender.blender.props.asleep import lie_down
from storyblender.blender.props.darkened import put_out
from storyblender.blender.props.lettering import face_on, write_on
from storyblender.blender.props.registry import PropSpec, builders
from storyblender.catalog.props import PROPS
from storyblender.catalog.writing import SCREENS, WRITING
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Anchor, AssetDimension, Credit, ParamValue
from storyblender.memory.base import Vec3


@dataclass(frozen=True)
class PropBuild:
    """A built prop: origin bottom centre, front -Y, metres.

    Attributes:
        mesh: A new mesh data-block named after the key.
        anchors: What its builder declared; tops are found by ``measure.surfaces``.
        dimensions: Width, depth, height as built.
        notes: Sentences for the user about what was changed or left out; of models from files only.
        credit: Whose work it is; of models from files only.
    """

    mesh: bpy.types.Mesh
    anchors: Anchors
    dimensions: Vec3
    notes: tuple[str, ...] = ()
    credit: Credit = field(default_factory=Credit)


def build_prop(
    key: str, params: dict[str, ParamValue] | None = None, seed: int = 0, dimension: AssetDimension | None = None
) -> PropBuild:
    """Build one prop of the catalog.

    Args:
        key: A key of ``catalog.props``.
        params: Replaces the entry's defaults; also ``color``, ``material``, and ``width``, ``depth``, ``height`` in
            metres, which rebuild it at that size instead of scaling it.
        seed: Everything that varies follows from it.
        dimension: The wanted size; one number scales the whole, more stretch it.

    Raises:
        InputError: No such prop, or no such parameter.
    """
    if key not in PROPS:
        raise InputError(f"the catalog has no prop called {key!r}", mend="see `storyblender catalog props`")
    entry = PROPS[key]
    given = dict(params or {})
    text = str(given.pop("text", "")) if key in WRITING else ""
    caller = bool(given.pop("caller", False)) and key in SCREENS
    unlit = bool(given.pop("unlit", False)) and entry.lights
    unknown = sorted(set(given) - set(entry.params) - {"color", "material", "width", "depth", "height"})
    if unknown:
        raise InputError(f"the prop {key!r} has no parameter {unknown[0]!r}", mend=f"it has {sorted(entry.params)}")
    size = tuple(
        float(given.get(name, value)) for name, value in zip(("width", "depth", "height"), entry.size, strict=True)
    )
    rng = np.random.default_rng(seed)
    spec = PropSpec(entry, (size[0], size[1], size[2]), entry.params | given, rng, lettered=bool(text))
    builder = MeshBuilder(key)
    anchors = builders()[key](builder, spec)
    mesh = builder.mesh()
    if (caller and face_on(builder, mesh, WRITING[key])) or (text and write_on(builder, mesh, WRITING[key], text)):
        bpy.data.meshes.remove(mesh)
        mesh = builder.mesh()
    if spec.params.get("asleep") and key != "cat":
        lie_down(mesh)
    if unlit:
        put_out(mesh)
    return settle(mesh, anchors, dimension)


def settle(mesh: bpy.types.Mesh, anchors: Anchors, dimension: AssetDimension | None = None) -> PropBuild:
    """Scale a mesh to the wanted size and move its bottom centre to the origin, and its anchors with it.

    Args:
        mesh: Changed in place.
        anchors: In the mesh's frame.
        dimension: Wanted size; None keeps the size, one number scales the whole, more stretch it.
    """
    points = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", points)
    cloud = points.reshape(-1, 3).astype(float)
    low, high = cloud.min(axis=0), cloud.max(axis=0)
    factors = _scale_factors(high - low, dimension)
    origin = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    mesh.vertices.foreach_set("co", ((cloud - origin) * factors).astype(np.float32).ravel())
    mesh.update()
    width, depth, height = (float(extent) for extent in (high - low) * factors)
    return PropBuild(
        mesh, tuple(_rescale_anchor(anchor, origin, factors) for anchor in anchors), (width, depth, height)
    )


def _scale_factors(extent: np.ndarray, dimension: AssetDimension | None) -> np.ndarray:
    """Return the (3,) scale of each axis to the wanted size; an axis without one takes the mean."""
    wanted = (None, None, None) if dimension is None else (dimension.width, dimension.depth, dimension.height)
    ratios = [
        None if goal is None else goal / max(float(size), 1e-6) for goal, size in zip(wanted, extent, strict=True)
    ]
    known = [ratio for ratio in ratios if ratio is not None]
    rest = float(np.mean(known)) if known else 1.0
    return np.array([rest if ratio is None else ratio for ratio in ratios])


def _rescale_anchor(anchor: Anchor, origin: np.ndarray, factors: np.ndarray) -> Anchor:
    """Return an anchor moved by ``-origin`` (metres) and scaled by (3,) ``factors``."""
    x, y, z = (float(value) for value in (np.asarray(anchor.location) - origin) * factors)
    turned = abs(anchor.direction[0]) > abs(anchor.direction[1])
    across, along = (factors[1], factors[0]) if turned and anchor.kind != "top" else (factors[0], factors[1])
    size = (anchor.size[0] * float(across), anchor.size[1] * float(along))
    high = None if anchor.clearance is None else anchor.clearance * float(factors[2])
    return anchor.model_copy(update={"location": (x, y, z), "size": size, "clearance": high})
