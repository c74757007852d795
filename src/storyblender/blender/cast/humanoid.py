"""A user's mesh as a body: fitted, bound and brought to the rest pose of our skeleton. No bpy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.cast.binding import weights_for
from storyblender.blender.cast.doll import bones_of_parts, joints_between
from storyblender.blender.cast.fitting import Fit, Fitter, sampled
from storyblender.blender.cast.own_rig import OwnRig
from storyblender.blender.cast.posed_bones import PosedBones
from storyblender.blender.cast.shells import edges_of, pieces_of
from storyblender.blender.cast.stance import stance_of
from storyblender.blender.cast.template import Template
from storyblender.catalog.skeleton import SKELETON
from storyblender.errors import InputError
from storyblender.geometry.solids import Floats

Ints = NDArray[np.int64]

SAMPLES = 6000
"""Points of the mesh that the fit looks at."""
MISFIT, STRAIN = 0.036, 0.42
"""From which mean distance from a body, as a share of the stature, and from how odd proportions on a mesh is none."""
HIPS_Y = -0.014
"""y of the hips of a person of 1.70 m who stands at the origin, metres."""


@dataclass(frozen=True, eq=False)
class BoundMesh:
    """A mesh that our skeleton moves, at rest: A-pose, soles at z = 0, facing -Y, metres.

    Attributes:
        points: (V, 3).
        weights: (V, B) columns as in ``SKELETON``.
        heads: (B, 3) joints.
        tails: (B, 3).
        stature: Height of the crown without hat and hair.
        turned: Whether it faced the other way.
        misfit: Mean distance of the fitted body from the mesh, as a share of the stature.
    """

    points: Floats
    weights: Floats
    heads: Floats
    tails: Floats
    stature: float
    turned: bool
    misfit: float

    @property
    def joints(self) -> dict[str, Floats]:
        """The joints by the names of the body data."""
        ends = {bone.tail: tail for bone, tail in zip(SKELETON, self.tails, strict=True)}
        return ends | {bone.head: head for bone, head in zip(SKELETON, self.heads, strict=True)}


def bound_mesh(
    points: Floats,
    normals: Floats,
    triangles: Ints,
    template: Template,
    *,
    front_known: bool = False,
    own: OwnRig | None = None,
) -> BoundMesh:
    """Bind a mesh to the skeleton.

    Args:
        points: (V, 3) metres, Z up.
        normals: (V, 3) of the vertices.
        triangles: (T, 3).
        template: The body that is fitted into it.
        front_known: Whether it is sure that it faces -Y; else it may also face +Y.
        own: The skeleton that its file has, if its bones are known by name.

    Raises:
        InputError: It is no human figure.
    """
    low, high = points.min(0), points.max(0)
    middle: Floats = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    points = points - middle
    fit = _fitted(points, triangles, template, front_known, own)
    face: Floats = np.array((-1.0, -1.0, 1.0) if fit.back else (1.0, 1.0, 1.0))
    points, normals = points * face, normals * face
    stance = stance_of(template, fit.values[None])
    body = stance.points(template.points, template.weights)[0]
    facing = np.einsum("nb,bij,nj->ni", template.weights, stance.turns[0], template.normals)
    scale = float(body[:, 2].max()) / 1.7
    weights = weights_for(points, normals, triangles, body, facing, template.weights, scale)
    tails = np.einsum("bij,bj->bi", stance.linear[0], template.tails) + stance.shift[0]
    posed = PosedBones(stance.heads[0], tails, stance.turns[0])
    if own is not None:
        held = own.weights.any(1)
        weights[held] = own.weights[held]
        places: dict[str, Floats] = {bone: (head - middle) * face for bone, head in own.heads.items()}
        posed = posed.moved_to(places)
    else:
        pieces = pieces_of(len(points), edges_of(triangles))
        parts = bones_of_parts(points, pieces, posed.heads, posed.tails, 1.7 * scale)
        if parts is not None:
            weights = np.eye(len(SKELETON))[parts]
            posed = posed.moved_to(joints_between(points, parts))
    return _at_rest(points, weights, posed, float(body[:, 2].max()), fit)


def _fitted(points: Floats, triangles: Ints, template: Template, front_known: bool, own: OwnRig | None) -> Fit:
    """Return the fit. Raises InputError where it is no human figure."""
    width, depth, height = np.ptp(points, axis=0)
    if height < 0.5 * max(width, depth):
        raise InputError("it is no human figure: it is wider than high", mend="give a figure that stands upright")
    fitter = Fitter(template, sampled(points, triangles, SAMPLES))
    if own is not None:
        return fitter.best((own.faces_away,))
    fit = fitter.best((False,) if front_known else (False, True))
    if fit.misfit > MISFIT or fit.strain > STRAIN:
        mend = "give a figure with a head, two arms and two legs that stands upright with its arms at its sides or out"
        raise InputError("it is no human figure", mend=mend)
    return fit


def _at_rest(points: Floats, weights: Floats, posed: PosedBones, crown: float, fit: Fit) -> BoundMesh:
    """Return the mesh with its arms as the template has them; the legs stay as they stand.

    What moves it there is the inverse of the skinning, so that the pose of the file comes out as it was.
    """
    turns, heads, tails = posed.at_rest()
    shifts = posed.heads - np.einsum("bij,bj->bi", turns, heads)
    blended = np.einsum("vb,bij->vij", weights, turns)
    rest = np.einsum("vij,vj->vi", np.linalg.inv(blended), points - weights @ shifts)
    sole = float(rest[:, 2].min())
    scale = (crown - sole) / 1.7
    origin = np.array((heads[0][0], heads[0][1] - HIPS_Y * scale, sole))
    return BoundMesh(rest - origin, weights, heads - origin, tails - origin, crown - sole, fit.back, fit.misfit)
