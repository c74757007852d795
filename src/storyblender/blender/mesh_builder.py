"""Builds a mesh from parts: boxes, lathes, lofts, tubes; textures are laid out in metres. Front is -Y.

Every method takes the material first, adds a part under the current transform and returns the builder.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TypeAlias

import bpy
import numpy as np
from numpy.typing import ArrayLike, NDArray

from storyblender.blender.materials import material as material_of
from storyblender.blender.panel_faces import mark_panels
from storyblender.geometry import solids
from storyblender.geometry.solids import Floats

MaterialRef: TypeAlias = "bpy.types.Material | str"  # a material, or a key of ``catalog.materials``
Faces = Sequence[Sequence[int]]

SHARP_ANGLE = math.radians(38)
"""Radians; edges that bend more are shaded sharp, and the ink draws creases at nearly the same angle."""


@dataclass(frozen=True)
class _MeshPart:
    """Vertices (V, 3), corner indices, corners per face, material slot, uv (corners, 2) and panel of one part."""

    vertices: Floats
    loops: NDArray[np.int64]
    sizes: NDArray[np.int64]
    material: int
    uv: Floats
    panel: str = ""


class MeshBuilder:
    """Collects parts and makes one mesh of them.

    Args:
        name: Name of the mesh data-block.
    """

    def __init__(self, name: str) -> None:
        self.name = name
        self._parts: list[_MeshPart] = []
        self._materials: list[bpy.types.Material] = []
        self._frames: list[Floats] = [np.eye(4)]
        self._vertex_count = 0
        self._panel = ""

    @contextmanager
    def panel(self, name: str) -> Iterator[MeshBuilder]:
        """Make what is added inside the ``with`` block a wild panel: a shot can hide it, as a stage takes out a wall.

        Args:
            name: Of the panel, such as ``roof``; parts of one name are one panel.
        """
        before, self._panel = self._panel, name
        try:
            yield self
        finally:
            self._panel = before

    @contextmanager
    def at(
        self,
        location: ArrayLike = (0.0, 0.0, 0.0),
        rotation: ArrayLike = (0.0, 0.0, 0.0),
        scale: float | ArrayLike = 1.0,
    ) -> Iterator[MeshBuilder]:
        """Place what is added inside the ``with`` block; blocks nest.

        Args:
            location: Metres, in the surrounding frame.
            rotation: Degrees about X, then Y, then Z.
            scale: One number or three; negative mirrors.
        """
        self._frames.append(self._frames[-1] @ solids.transform(location, rotation, scale))
        try:
            yield self
        finally:
            self._frames.pop()

    def quad(
        self,
        material: MaterialRef,
        a: ArrayLike,
        b: ArrayLike,
        c: ArrayLike,
        d: ArrayLike,
        *,
        uv: ArrayLike | None = None,
    ) -> MeshBuilder:
        """Add one four-cornered face.

        ``a`` to ``d`` are its corners (3,), counter-clockwise as seen from its front; ``uv`` is (4, 2) in image units.
        """
        return self.add(material, np.stack([np.asarray(point, float) for point in (a, b, c, d)]), [(0, 1, 2, 3)], uv=uv)

    def polygon(self, material: MaterialRef, points: ArrayLike, *, uv: ArrayLike | None = None) -> MeshBuilder:
        """Add one flat face, corners (N, 3) counter-clockwise as seen from its front; ``uv`` (N, 2) in image units."""
        corners = np.asarray(points, float)
        return self.add(material, corners, [tuple(range(len(corners)))], uv=uv)

    def extrude(
        self, material: MaterialRef, outline: ArrayLike, height: float, *, base: float = 0.0, taper: float = 1.0
    ) -> MeshBuilder:
        """Add a prism that stands on the XY plane; use ``at`` to turn it.

        Args:
            material: Key or material.
            outline: (n, 2) corners, either direction.
            height: Metres along +Z.
            base: Z of its foot.
            taper: Scale of the top outline about the outline's centre.
        """
        flat = np.asarray(outline, float)
        middle = flat.mean(axis=0)
        top = middle + (flat - middle) * taper
        rings = [np.c_[flat, np.full(len(flat), base)], np.c_[top, np.full(len(flat), base + height)]]
        return self.loft(material, rings)

    def box(
        self,
        material: MaterialRef,
        center: ArrayLike,
        size: ArrayLike,
        *,
        bevel: float = 0.0,
        taper: float = 1.0,
        rotation: ArrayLike = (0.0, 0.0, 0.0),
    ) -> MeshBuilder:
        """Add a box.

        Args:
            material: Key or material.
            center: Its middle.
            size: Extents in x, y, z.
            bevel: Width of the chamfer on every edge; 0 for none.
            taper: Scale of its top face in x and y.
            rotation: Degrees about its middle, X then Y then Z.
        """
        extent = np.abs(np.asarray(size, float))
        vertices, faces = solids.box(extent, min(bevel, float(extent.min()) * 0.45))
        if taper != 1.0:
            vertices[:, :2] *= 1 + (taper - 1) * (vertices[:, 2:] / extent[2] + 0.5)
        with self.at(center, rotation):
            return self.add(material, vertices, faces)

    def rounded_box(
        self,
        material: MaterialRef,
        center: ArrayLike,
        size: ArrayLike,
        radius: float,
        *,
        steps: int = 3,
        rotation: ArrayLike = (0.0, 0.0, 0.0),
    ) -> MeshBuilder:
        """Add a smooth box with rounded edges: upholstery, appliances, soap bars.

        Args:
            material: Key or material.
            center: Its middle.
            size: Extents in x, y, z.
            radius: Of its edges; kept below half its least extent.
            steps: Faces across the curve of an edge.
            rotation: Degrees about its middle, X then Y then Z.
        """
        extent = np.asarray(size, float)
        with self.at(center, rotation):
            return self.loft(material, solids.rounded_box_rings(extent, min(radius, float(extent.min()) * 0.49), steps))

    def cushion(
        self,
        material: MaterialRef,
        center: ArrayLike,
        size: ArrayLike,
        *,
        softness: float = 0.35,
        rotation: ArrayLike = (0.0, 0.0, 0.0),
    ) -> MeshBuilder:
        """Add a superellipsoid.

        Args:
            material: Key or material.
            center: Its middle.
            size: Extents in x, y, z.
            softness: 0.2 is nearly a box, 0.35 a stuffed cushion, 1 an ellipsoid.
            rotation: Degrees about its middle, X then Y then Z.
        """
        with self.at(center, rotation):
            return self.loft(material, solids.superellipsoid_rings(np.asarray(size, float) / 2, softness, 20, 10))

    def sphere(
        self,
        material: MaterialRef,
        center: ArrayLike,
        radius: float,
        *,
        scale: ArrayLike = (1.0, 1.0, 1.0),
        segments: int = 16,
        rings: int = 9,
    ) -> MeshBuilder:
        """Add a ball of a ``radius`` about a ``center``.

        ``scale``, factors in x, y, z, makes it an ellipsoid. It has ``segments`` faces around and ``rings`` up.
        """
        with self.at(center):
            half = radius * np.asarray(scale, float)
            return self.loft(material, solids.superellipsoid_rings(half, 1.0, segments, rings))

    def cylinder(
        self,
        material: MaterialRef,
        start: ArrayLike,
        end: ArrayLike,
        radius: float,
        end_radius: float | None = None,
        *,
        segments: int = 14,
        caps: bool = True,
    ) -> MeshBuilder:
        """Add a round bar from the point ``start`` to the point ``end``; a cone if it has another ``end_radius``.

        It has ``segments`` faces around and, with ``caps``, two flat ends.
        """
        foot = np.asarray(start, float)
        along = np.asarray(end, float) - foot
        top = radius if end_radius is None else end_radius
        profile = [(radius, 0.0), (top, float(np.linalg.norm(along)))]
        return self.lathe(material, profile, origin=foot, axis=along, segments=segments, caps=caps)

    def lathe(
        self,
        material: MaterialRef,
        profile: ArrayLike,
        *,
        origin: ArrayLike = (0.0, 0.0, 0.0),
        axis: ArrayLike = (0.0, 0.0, 1.0),
        segments: int = 20,
        caps: bool = True,
    ) -> MeshBuilder:
        """Turn a profile about an axis.

        Args:
            material: Key or material.
            profile: (n, 2) pairs of radius and height along the axis; up the outside, then down the inside if hollow.
            origin: Where height 0 is.
            axis: Direction of +height.
            segments: Sides of the turned shape.
            caps: Close the two ends with discs.
        """
        turned = np.asarray(profile, float)
        angle = np.arange(segments) * (2 * math.pi / segments)
        circle = np.c_[np.cos(angle), np.sin(angle), np.zeros(segments)]
        rings = [circle * max(radius, 1e-4) + (0, 0, height) for radius, height in turned]
        placed = solids.translation(origin) @ solids.z_to(axis)
        self._frames.append(self._frames[-1] @ placed)
        try:
            return self.loft(material, rings, caps=caps)
        finally:
            self._frames.pop()

    def tube(
        self,
        material: MaterialRef,
        points: ArrayLike,
        radius: float | Sequence[float],
        *,
        segments: int = 8,
        closed: bool = False,
    ) -> MeshBuilder:
        """Sweep a circle along a path, without twist.

        Args:
            material: Key or material.
            points: (n, 3) path.
            radius: Metres; or one per point.
            segments: Sides of the section.
            closed: Join the last point to the first.
        """
        rings = solids.tube_rings(np.asarray(points, float), radius, segments, closed)
        return self.loft(material, rings, caps=not closed)

    def loft(
        self, material: MaterialRef, rings: Sequence[ArrayLike], *, closed: bool = True, caps: bool = True
    ) -> MeshBuilder:
        """Skin over cross-sections with the same number of points.

        Args:
            material: Key or material.
            rings: k arrays of (n, 3) points.
            closed: The section is a loop; its faces are then turned outwards whatever its direction.
            caps: Close both ends of a closed section.
        """
        stack = np.asarray([np.asarray(ring, float) for ring in rings])
        count, points = stack.shape[:2]
        vertices = stack.reshape(-1, 3)
        faces = solids.skin_faces(count, points, closed)
        uv = solids.skin_uv(stack, closed, self._tile(material), bool(_resolve(material).get("grain", False)))
        if caps and closed:
            for ring, order in ((0, -1), (count - 1, 1)):
                faces.append(tuple(range(ring * points, (ring + 1) * points))[::order])
            uv = np.r_[uv, solids.box_uv(vertices, faces[-2:], False)]
        if closed and solids.signed_volume(vertices, faces) < 0:
            faces, uv = _flipped(faces, uv)
        return self._append(material, vertices, faces, uv)

    def add(
        self, material: MaterialRef, vertices: ArrayLike, faces: Faces, *, uv: ArrayLike | None = None
    ) -> MeshBuilder:
        """Add any vertices and faces.

        Args:
            material: Key or material.
            vertices: (n, 3) metres.
            faces: Corner indices, counter-clockwise as seen from outside.
            uv: (corners, 2) in image units, in the order of the faces; box-projected in metres if left out.
        """
        corners = np.asarray(vertices, float).reshape(-1, 3)
        if uv is not None:
            layout = np.asarray(uv, float).reshape(-1, 2) * self._tile(material)
        else:
            layout = solids.box_uv(corners, faces, bool(_resolve(material).get("grain", False)))
        return self._append(material, corners, faces, layout)

    def _append(self, material: MaterialRef, vertices: Floats, faces: Faces, uv: Floats) -> MeshBuilder:
        """Add vertices, faces and uv (metres) under the current transform."""
        block = _resolve(material)
        if block not in self._materials:
            self._materials.append(block)
        frame = self._frames[-1]
        if np.linalg.det(frame[:3, :3]) < 0:
            faces, uv = _flipped(faces, uv)
        placed = vertices @ frame[:3, :3].T + frame[:3, 3]
        sizes = np.fromiter((len(face) for face in faces), np.int64, len(faces))
        loops = self._vertex_count + np.fromiter((corner for face in faces for corner in face), np.int64)
        if block.get("grain", False):  # neighbouring boards show different parts of the picture
            uv = uv + np.array([0.37, 0.61]) * len(self._parts)
        self._parts.append(_MeshPart(placed, loops, sizes, self._materials.index(block), uv, self._panel))
        self._vertex_count += len(placed)
        return self

    def _tile(self, material: MaterialRef) -> float:
        """Return the metres of one repeat of a material's picture."""
        return float(_resolve(material).get("tile", 1.0))

    @property
    def vertices(self) -> Floats:
        """(n, 3) all vertices so far, metres."""
        return np.concatenate([part.vertices for part in self._parts]) if self._parts else np.zeros((0, 3))

    def mesh(self) -> bpy.types.Mesh:
        """Return a new mesh of all parts: smooth shading, edges sharp by angle, one UV layer, its materials."""
        mesh = bpy.data.meshes.new(self.name)
        for block in self._materials:
            mesh.materials.append(block)
        if not self._parts:
            return mesh
        loops = np.concatenate([part.loops for part in self._parts])
        sizes = np.concatenate([part.sizes for part in self._parts])
        owner = np.repeat([part.material for part in self._parts], [len(part.sizes) for part in self._parts])
        uv = np.concatenate([part.uv / self._tile(self._materials[part.material]) for part in self._parts])
        mesh.vertices.add(self._vertex_count)
        mesh.vertices.foreach_set("co", self.vertices.astype(np.float32).ravel())
        mesh.loops.add(len(loops))
        mesh.loops.foreach_set("vertex_index", loops.astype(np.int32))
        mesh.polygons.add(len(sizes))
        mesh.polygons.foreach_set("loop_start", (np.cumsum(sizes) - sizes).astype(np.int32))
        mesh.polygons.foreach_set("material_index", owner.astype(np.int32))
        mesh.polygons.foreach_set("use_smooth", np.ones(len(sizes), bool))
        mesh.update(calc_edges=True)
        mesh.uv_layers.new(name="UV").data.foreach_set("uv", uv.astype(np.float32).ravel())
        mark_panels(mesh, [(part.panel, len(part.sizes)) for part in self._parts])
        mesh.validate()
        mesh.set_sharp_from_angle(angle=SHARP_ANGLE)
        mesh.update()
        return mesh


def _resolve(material: MaterialRef) -> bpy.types.Material:
    """Return a material by key, or the material itself."""
    return material_of(material) if isinstance(material, str) else material


def _flipped(faces: Faces, uv: Floats) -> tuple[list[tuple[int, ...]], Floats]:
    """Return faces and their uv with reversed corners."""
    turned, layout, start = [], [], 0
    for face in faces:
        turned.append(tuple(face)[::-1])
        layout.append(uv[start : start + len(face)][::-1])
        start += len(face)
    return turned, np.concatenate(layout)
