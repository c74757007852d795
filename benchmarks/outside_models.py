"""Models of another program, imported as a user's are: upright, front, size, and people who sit and lie on them.

``python -m benchmarks outside_models FOLDER`` wants a folder with the catalogues of Sweet Home 3D (``.sh3f``, and
``sweethome3d.jar`` with its own). Four samples are drawn by seed, none with a model of an earlier one: mechanisms were
mended on the first three and on models of no sample; the fourth one is held out. A sort that is used up is left out:
the third sample has one of the five stairs, the fourth none. A model is known by its file's name, and to a crew by its
pictures. What it became is compared with its file in the 24 right-angled poses: it is right if no other pose fits
better than the catalogue's. Its size is right within 1.25 times; within 1.5 is counted too, for a file whose unit is no
usual one has only the usual size of such things to go by.
``--sample simulators`` wants clones of the libraries that ``simulator_models.py`` names, and is held out too.
What the catalogue calls a seat or a bed must have one, and a man must come to rest on each without sinking in.
``--sheet FILE`` draws all of them with the person; ``--tipped`` turns and tips every file at random first.
``--crew SETTING`` asks an Asset Formatter and a Dimension Estimator, as ``make`` does. With ``ask:FOLDER`` answer and
run the same command again, twice: the sizes are asked for once the poses are known.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise, permutations, product
from pathlib import Path

import bpy
import numpy as np
from benchmarks.crewed_models import looked_at
from benchmarks.furniture_catalogues import TrueModel, read_catalogues, samples
from benchmarks.people_on_models import Rested, rest_on, stand_beside, tile_sheet
from benchmarks.simulator_models import read_simulators
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from storyblender.agents.layout_artist.dimension_estimator import estimate_dimension
from storyblender.blender.props.build import PropBuild
from storyblender.blender.props.imported import build_from_file
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import kind_named
from storyblender.errors import AnswerAwaited, InputError
from storyblender.library.file_names import words_of_file
from storyblender.memory.asset_sheet import Asset, ModelPose

SEEDS = {"first": 16, "held out": 1616, "third": 161616, "fourth": 16161616}
FACTOR, WIDE_FACTOR = 1.25, 1.5
SEATS = frozenset(("chair", "armchair", "sofa", "couch", "stool", "bench", "settee", "throne", "toilet"))
BEDS = frozenset(("bed",))
_CLOSER = 0.002
"""Mean distance, in largest extents, by which another pose must fit better to be the right one."""


@dataclass(frozen=True)
class Outcome:
    """What became of one model: ``upright`` and ``front`` as is right, ``factor`` of the true size."""

    model: TrueModel
    kind: str
    upright: bool
    front: bool
    factor: float
    rests: tuple[Rested, ...]
    wanted: str
    seconds: float
    faces: int
    notes: tuple[str, ...]

    @property
    def is_sized(self) -> bool:
        """Whether its size is right."""
        return self.is_within(FACTOR)

    def is_within(self, factor: float) -> bool:
        """Return whether its size is right within a factor."""
        return 1 / factor <= self.factor <= factor

    @property
    def is_used(self) -> bool:
        """Whether people rest on it, if it is there for that."""
        fits = not self.wanted or any(rest.kind == self.wanted for rest in self.rests)
        return fits and all(rest.is_good for rest in self.rests)

    @property
    def is_right(self) -> bool:
        """Whether all is."""
        return self.is_right_within(FACTOR)

    def is_right_within(self, factor: float) -> bool:
        """Return whether all is, if its size may be off by a factor."""
        return self.upright and self.front and self.is_within(factor) and self.is_used


def _rotations() -> list[np.ndarray]:
    """Return the 24 right-angled rotations: those that keep +Z up first: 0 to 3 quarters clockwise."""
    found = [
        np.array(
            [[sign if column == axis else 0 for column in range(3)] for axis, sign in zip(order, signs, strict=True)]
        )
        for order in permutations(range(3))
        for signs in product((1, -1), repeat=3)
    ]
    turns = [turn for turn in found if np.linalg.det(turn) > 0]
    sides = (0, -1), (1, 0), (0, 1), (-1, 0)
    upright = [next(turn for turn in turns if turn[2, 2] == 1 and (*-turn[1, :2],) == side) for side in sides]
    return [*upright, *(turn for turn in turns if turn[2, 2] != 1)]


def taken_for(path: Path) -> str:
    """Return the catalog key of what a file is taken for by its name; empty where the catalog has no such thing."""
    return kind_named(" ".join(words_of_file(path.name).words)) or kind_named(words_of_file(path.name).noun)


def import_as_decided(path: Path, asset: Asset) -> tuple[PropBuild, str]:
    """Return what the pipeline would make of a file that a crew looked at, and what it takes it for."""
    made, kind = asset.canonical, asset.kind or ""
    if made is None:
        return build_from_file(path, asset.dimension, prop=kind), kind
    pose = ModelPose.of(made.params)
    return build_from_file(path, asset.dimension, prop=kind, certainty=made.certainty, pose=pose), kind


def import_model(path: Path) -> tuple[PropBuild, str]:
    """Return what the pipeline would make of a file that a script's words found, and what it takes it for."""
    kind = taken_for(path)
    asset = Asset(asset_id="thing", asset_type="object", description="", kind=kind)
    return build_from_file(path, estimate_dimension(asset) if kind in PROPS else None, prop=kind), kind


def judge(model: TrueModel, path: Path, sheet: list[Path] | None, asset: Asset | None = None) -> Outcome:
    """Import a model and compare it with what is true of it; draw it with a person for the sheet."""
    points, triangles = _read(path)
    true = points @ _TIPS.get(model.stem, np.eye(3)) @ model.rotation.T  # Y is up
    true = np.stack([true[:, 0], -true[:, 2], true[:, 1]], axis=1)
    started = time.process_time()
    build, kind = import_model(path) if asset is None else import_as_decided(path, asset)
    seconds = time.process_time() - started
    upright, front = _fit(build.mesh, true, triangles, model.other_fronts)
    factor = float(np.prod(build.dimensions) / np.prod(np.maximum(model.size, 1e-3))) ** (1 / 3)
    rests = tuple(rest_on(build))
    words = model.name.lower().split()
    wanted = "bed" if BEDS & set(words) else "seat" if SEATS & set(words) else ""
    if sheet is not None:
        sheet.append(stand_beside(build, rests, path.with_suffix(".sheet.png")))
    faces = len(build.mesh.polygons)
    return Outcome(model, kind, upright, front, factor, rests, wanted, seconds, faces, build.notes)


def _fit(
    mesh: bpy.types.Mesh, true: np.ndarray, triangles: np.ndarray, other_fronts: Sequence[int]
) -> tuple[bool, bool]:
    """Return whether no pose with another top, and none with another front, fits the file better than a true one."""
    sample = np.array([vertex.co[:] for vertex in mesh.vertices])
    low, extent = sample.min(axis=0), np.ptp(sample, axis=0)
    sample = (sample[:: max(1, len(sample) // 700)] - low - extent / 2) / extent.max()
    middle = (true[triangles].reshape(-1, 3).min(axis=0) + true[triangles].reshape(-1, 3).max(axis=0)) / 2
    file = (true - middle) / np.ptp(true[triangles].reshape(-1, 3), axis=0).max()
    tree = BVHTree.FromPolygons([Vector(each) for each in file], triangles.tolist())
    costs = [np.mean([tree.find_nearest(Vector(each))[3] for each in sample @ turn]) for turn in _rotations()]
    upright = min(costs[:4])
    front = min(costs[quarter] for quarter in (0, *other_fronts))
    return bool(upright < min(costs) + _CLOSER), bool(front < upright + _CLOSER)


def _read(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Return points and triangles of an .obj, as simply as can be."""
    points, triangles = [], []
    for line in path.read_text("latin-1").splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            points.append([float(value) for value in rest[:3]])
        elif word == "f":
            numbers = [int(corner.split("/")[0]) for corner in rest]
            face = [number - 1 if number > 0 else len(points) + number for number in numbers]
            triangles += [(face[0], *pair) for pair in pairwise(face[1:])]
    return np.array(points), np.array(triangles)


_TIPS: dict[str, np.ndarray] = {}


def _tip(path: Path, rng: np.random.Generator) -> None:
    """Turn and tip an .obj at random: any quarter about its up axis, and lying on its back half of the time."""
    quarter, tips = int(rng.integers(4)), int(rng.integers(2))
    spin = np.linalg.matrix_power(np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]]), quarter)
    turn = np.linalg.matrix_power(np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]), tips) @ spin
    _TIPS[path.stem] = turn
    lines = []
    for line in path.read_text("latin-1").splitlines():
        if line.startswith("v "):
            line = "v " + " ".join(f"{value:.6f}" for value in turn @ [float(value) for value in line.split()[1:4]])
        lines.append(line)
    path.write_text("\n".join(lines), "latin-1")


def unpack_all(models: Sequence[TrueModel], folder: Path, tip: bool) -> list[Path]:
    """Unpack the models, each into a folder of its own, and return their files; tipped at random on demand."""
    rng = np.random.default_rng(5)
    paths: list[Path] = []
    for number, model in enumerate(models):
        place = folder / f"{number:02}"
        place.mkdir()
        paths.append(model.unpack(place))
        if tip:
            _tip(paths[-1], rng)
    return paths


def outcomes(
    models: Sequence[TrueModel], paths: Sequence[Path], sheet: list[Path] | None, assets: Mapping[Path, Asset]
) -> Iterator[Outcome]:
    """Import the models one after another and say so as it goes; as a crew decided, where it looked at them."""
    for model, path in zip(models, paths, strict=True):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        try:
            found = judge(model, path, sheet, assets.get(path))
        except InputError as error:
            print(f"{model.stem:28} refused: {error}")
            continue
        _print(found)
        yield found


def _print(found: Outcome) -> None:
    marks = [found.upright, found.front, found.is_sized, found.is_used]
    shown = " ".join("yes" if mark else " NO" for mark in marks)
    rests = ", ".join(str(rest) for rest in found.rests) or (f"no {found.wanted}" if found.wanted else "")
    print(
        f"{found.model.stem[:26]:26} {found.model.name[:20]:20} {found.kind[:14]:14} {shown} {found.factor:6.2f} "
        f"{found.faces:7} {found.seconds:5.1f} s  {rests}",
        flush=True,
    )


def main() -> None:
    """Print a table for each sample, and its summary."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks outside_models", description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--sample", choices=(*SEEDS, "all", "simulators"), default="all")
    parser.add_argument("--tipped", action="store_true")
    parser.add_argument("--sheet", type=Path)
    parser.add_argument("--only", default="", help="part of the file's name")
    parser.add_argument("--crew", default="rules", help="who looks at the models, as for `storyblender make`")
    options = parser.parse_args()
    for name, sample in _drawn(options.folder, options.sample).items():
        print(f"\n{name}: {len(sample)} models; upright, front, size, used, factor of the size")
        with tempfile.TemporaryDirectory() as folder:
            sheet = [] if options.sheet else None
            asked = [model for model in sample if options.only in model.stem]
            paths = unpack_all(asked, Path(folder), options.tipped)
            try:
                assets = {} if options.crew == "rules" else _looked_at(paths, Path(folder), options.crew)
            except AnswerAwaited as error:
                sys.exit(str(error))
            done = list(outcomes(asked, paths, sheet, assets))
            if sheet:
                tile_sheet(sheet, [each.model.stem for each in done], options.sheet)
        _summarize(done, len(asked))


def _drawn(folder: Path, name: str) -> dict[str, list[TrueModel]]:
    """Return the sample of a name, or all that are drawn by seed."""
    if name == "simulators":
        return {name: read_simulators(folder)}
    drawn = dict(zip(SEEDS, samples(read_catalogues(folder), list(SEEDS.values())), strict=True))
    return drawn if name == "all" else {name: drawn[name]}


def _looked_at(paths: Sequence[Path], folder: Path, crew: str) -> dict[Path, Asset]:
    """Return what a crew decided of each file. Raises AnswerAwaited, InputError."""
    found = looked_at({path.relative_to(folder).as_posix(): taken_for(path) for path in paths}, folder, crew)
    return {folder / name: asset for name, asset in found.items()}


def _summarize(done: list[Outcome], total: int) -> None:
    counts = {
        "upright": sum(each.upright for each in done),
        "front": sum(each.front and each.upright for each in done),
        "size": sum(each.is_sized for each in done),
        "all three": sum(each.upright and each.front and each.is_sized for each in done),
        "used": sum(each.is_used for each in done),
        "all right": sum(each.is_right for each in done),
        f"size within {WIDE_FACTOR}": sum(each.is_within(WIDE_FACTOR) for each in done),
        f"all right within {WIDE_FACTOR}": sum(each.is_right_within(WIDE_FACTOR) for each in done),
    }
    rests = [rest for each in done for rest in each.rests]
    print(", ".join(f"{name} {count}/{total}" for name, count in counts.items()))
    held = sum(rest.is_good for rest in rests)
    seconds = [each.seconds for each in done]
    print(f"{held}/{len(rests)} seats and beds hold a person")
    print(f"{np.median(seconds):.2f} s a model (median), {max(seconds):.1f} s at most")


if __name__ == "__main__":
    main()
