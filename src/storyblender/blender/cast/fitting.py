"""Fits the template into a user's mesh: sizes and pose by iterated closest points, from several guesses. No bpy.

Each guess is another pose of the arms, another size of the head and another front. Every step pairs points whose
normals agree both ways, weighs far pairs down, and solves for all numbers at once (Gauss-Newton, numeric derivatives).
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.cast.stance import COUNT, PLACE, SIZE_OF, TURN_OF, Stance, stance_of
from storyblender.blender.cast.template import Template
from storyblender.geometry.solids import Floats

ARMS = (45.0, 0.0, -38.0)
"""Degrees by which the arms are raised over the template's A-pose: a T, an A, and hanging arms."""
HEADS = (0.0, 0.35, 0.85)
"""Logarithms of the size of the head, over a grown-up's for the stature."""
NORMAL = 0.05
"""Metres that a difference of normals by one counts as, on a body of 1.70 m."""
STEP = 1e-4
"""Change of a number by which a derivative is measured."""
STAGES = ((3, 220, 6, (0.10, 0.05)), (1, 320, 7, (0.07, 0.03)), (1, 700, 8, (0.04, 0.02)))
"""How many of the best fits of each front go on, after how many points of each side and how many steps, and the
distance at which a pair of points counts half, at first and at last, as a share of the height."""
LAST = (1500, 12, (0.03, 0.01))
"""The same of the fit that is chosen."""
TOES, LEAN = 4.0, 0.05
"""Weight of where the toes point, as a share of the height, beside the logarithm of the fits' ratio; and how much it
takes to believe that a mesh faces +Y though its file says -Y."""


@dataclass(frozen=True, eq=False)
class Surface:
    """Points all over a mesh, metres.

    Attributes:
        points: (n, 3).
        normals: (n, 3) unit.
    """

    points: Floats
    normals: Floats

    def some(self, count: int) -> Surface:
        """Return every so many of its points."""
        step = max(1, len(self.points) // count)
        return Surface(self.points[::step], self.normals[::step])


@dataclass(frozen=True, eq=False)
class Fit:
    """A template that has been fitted.

    Attributes:
        values: (``COUNT``,) as ``stance`` reads them.
        misfit: Mean distance of the surfaces, as a share of the stature.
        back: Whether the mesh faced +Y; it is turned first.
    """

    values: Floats
    misfit: float
    back: bool = False

    @property
    def strain(self) -> float:
        """How unlike a human being's its proportions are: the root mean square of the logarithms of the sizes."""
        sizes = np.array([self.values[column] for name, column in SIZE_OF.items() if name not in ("whole", "head")])
        return float(np.sqrt((sizes**2).mean()))


def sampled(points: Floats, triangles: NDArray[np.int64], count: int) -> Surface:
    """Return points all over a surface, equally spread by area; equal arguments give equal points.

    Args:
        points: (V, 3).
        triangles: (T, 3).
        count: How many.
    """
    corners = points[triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(across, axis=1)
    rng = np.random.default_rng(7)
    places = (np.arange(count) + rng.random(count)) / count
    chosen = np.minimum(np.searchsorted(np.cumsum(areas) / areas.sum(), places), len(areas) - 1)
    u, v = rng.random((2, count))
    flip = u + v > 1
    u, v = np.where(flip, 1 - u, u), np.where(flip, 1 - v, v)
    a, b, c = corners[chosen].transpose(1, 0, 2)
    spread = a + (b - a) * u[:, None] + (c - a) * v[:, None]
    mixed = rng.permutation(count)
    return Surface(spread[mixed], (across[chosen] / np.maximum(areas[chosen], 1e-12)[:, None])[mixed])


class Fitter:
    """Fits a template into a surface.

    Args:
        template: The body.
        surface: Standing on z = 0, centred over the origin.
    """

    def __init__(self, template: Template, surface: Surface) -> None:
        self._template, self._surface = template, surface
        self._height = float(surface.points[:, 2].max())
        rng = np.random.default_rng(3)
        self._order = rng.choice(len(template.points), len(template.points), replace=False, p=template.areas)

    def best(self, backs: tuple[bool, ...] = (False, True)) -> Fit:
        """Return the best fit of all guesses.

        Args:
            backs: Whether the surface may face -Y as it is (False), and +Y (True).
        """
        guesses = itertools.product(ARMS, HEADS, backs)
        fits = [Fit(self._guess(arms, head), 1.0, back) for arms, head, back in guesses]
        for kept, count, rounds, reach in STAGES:
            fits = [self._refined(fit, count, rounds, reach) for fit in fits]
            fits.sort(key=lambda fit: fit.misfit)
            fits = [fit for back in backs for fit in [fit for fit in fits if fit.back is back][:kept]]
        front = fits[0] if len(fits) < 2 or self._lean(*fits) < LEAN else fits[1]
        return self._refined(front, *LAST)

    def _lean(self, front: Fit, back: Fit) -> float:
        """Return how much more likely it is that the surface faces +Y: by the fits, and by its toes."""
        points, high = self._surface.points, self._surface.points[:, 2] / self._height
        feet, ankles = points[high < 0.04, 1], points[(high > 0.06) & (high < 0.14), 1]
        toes = (feet.mean() - ankles.mean()) / self._height if len(feet) and len(ankles) else 0.0
        return float(np.log(front.misfit / back.misfit) + TOES * toes)

    def _guess(self, arms: float, head: float) -> Floats:
        """Return the numbers of a body as high as the surface, with raised arms and a larger head."""
        values = np.zeros(COUNT)
        values[SIZE_OF["head"]] = head
        for side, sign in (("L", 1), ("R", -1)):
            values[TURN_OF[f"upper_arm.{side}"]] = (0, -np.radians(arms) * sign, 0)
        template = self._template
        stance = stance_of(template, values[None])
        high = float(stance.points(template.points, template.weights)[0, :, 2].max())
        values[SIZE_OF["whole"]] = np.log(self._height / high)
        placed = stance_of(template, values[None]).points(template.points, template.weights)[0]
        values[PLACE] = (0, 0, -placed[:, 2].min())
        return values

    def _refined(self, fit: Fit, count: int, rounds: int, reach: tuple[float, float]) -> Fit:
        """Return a fit after some steps.

        Args:
            fit: Where it starts.
            count: Points of each side that are paired.
            rounds: Steps.
            reach: Distance at which a pair counts half, at first and at last, as a share of the height.
        """
        template = self._template
        rows = self._order[:count]
        rest, normals, weights = template.points[rows], template.normals[rows], template.weights[rows]
        there = self._surface.some(count)
        values = fit.values
        if fit.back:
            there = Surface(there.points * (-1, -1, 1), there.normals * (-1, -1, 1))
        start, stiff = values.copy(), _stiffness(self._height)
        misfit = 1.0
        for turn in range(rounds):
            half = self._height * reach[0] * (reach[1] / reach[0]) ** (turn / max(rounds - 1, 1))
            variants = np.concatenate([values[None], values + STEP * np.eye(COUNT)])
            stance = stance_of(template, variants)
            places = stance.points(rest, weights)
            facing = _facing(stance, normals, weights)
            pairs = _pairs(places[0], facing, there, NORMAL * self._height / 1.7)
            misfit = pairs.misfit / self._height
            residual, slope = pairs.equations(places, facing, there, half)
            left = slope.T @ slope + np.diag(stiff)
            right = -slope.T @ residual - stiff * (values - start) * 0.3
            change = np.linalg.solve(left, right)
            values = values + np.clip(change, -0.35, 0.35)
        return Fit(values, misfit, fit.back)


def _facing(stance: Stance, normals: Floats, weights: Floats) -> Floats:
    """Return the (n, 3) normals of the first body."""
    turned = np.einsum("nb,bij,nj->ni", weights, stance.turns[0], normals)
    return turned / np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-12)


def _stiffness(height: float) -> Floats:
    """Return how strongly each number is held where the fit began."""
    stiff = np.full(COUNT, 0.02)
    stiff[PLACE] = 1e-4
    for name, column in SIZE_OF.items():
        stiff[column] = {"whole": 0.002, "neck": 0.2, "hand": 0.1, "foot": 0.1, "shoulders": 0.1}.get(name, 0.04)
    for name, columns in TURN_OF.items():
        stem = name.split(".")[0]
        stiff[columns] = {"hand": 0.15, "foot": 0.1, "chest": 0.3, "head": 0.3, "forearm": 0.05}.get(stem, 0.03)
    return stiff * height**2


@dataclass(frozen=True, eq=False)
class _Pairs:
    """Pairs of points: each of the body with one of the surface, and each of the surface with one of the body."""

    mine: np.ndarray
    theirs: np.ndarray
    distances: Floats
    misfit: float

    def equations(self, places: Floats, facing: Floats, there: Surface, half: float) -> tuple[Floats, Floats]:
        """Return residuals (m,) and their slope (m, ``COUNT``), far pairs weighed down.

        Args:
            places: (1 + ``COUNT``, n, 3) the body's points, as it is and with one number changed.
            facing: (n, 3) normals of the body.
            there: The surface.
            half: Metres at which a pair counts half.
        """
        weight = np.sqrt(1 / (1 + (self.distances / half) ** 2))
        apart = places[0][self.mine] - there.points[self.theirs]
        normal = there.normals[self.theirs] + facing[self.mine]
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-9)
        moved = (places[1:] - places[0]).transpose(1, 2, 0)[self.mine] / STEP  # (m, 3, COUNT)
        flat = np.einsum("mi,mi->m", normal, apart) * weight
        flat_slope = np.einsum("mi,mic->mc", normal, moved) * weight[:, None]
        full = (apart * weight[:, None] * 0.35).ravel()
        full_slope = (moved * weight[:, None, None] * 0.35).reshape(-1, moved.shape[2])
        scale = 1 / np.sqrt(len(self.mine) / 1000)
        return np.r_[flat, full] * scale, np.r_[flat_slope, full_slope] * scale


def _pairs(points: Floats, normals: Floats, there: Surface, normal: float) -> _Pairs:
    """Return the pairs of nearest points with like normals, both ways."""
    mine = np.c_[points, normals * normal].astype(np.float32)
    theirs = np.c_[there.points, there.normals * normal].astype(np.float32)
    square = (mine**2).sum(1)[:, None] + (theirs**2).sum(1)[None] - 2 * mine @ theirs.T
    to_theirs, to_mine = square.argmin(1), square.argmin(0)
    rows = np.r_[np.arange(len(mine)), to_mine]
    columns = np.r_[to_theirs, np.arange(len(theirs))]
    distances = np.linalg.norm(points[rows] - there.points[columns], axis=1)
    distances = np.sqrt(np.maximum(square[rows, columns], 0)).astype(float)
    cut = np.minimum(distances, 0.12 * float(there.points[:, 2].max()))
    return _Pairs(rows, columns, distances, float((cut[: len(mine)].mean() + cut[len(mine) :].mean()) / 2))
