"""Sets in Blender: every kit builds; walls carry their joinery; windows follow the sky; nothing is left open."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

import bpy
import numpy as np
import pytest
from tests.every import every

from storyblender.blender.props.build import build_prop
from storyblender.blender.sets.build import build_set, swing_door
from storyblender.blender.sets.pieces import piece_mesh
from storyblender.blender.sets.world import set_world
from storyblender.blender.story_light import make_lights
from storyblender.blender.windows import night_of
from storyblender.catalog.set_plan import Piece, SetPlan
from storyblender.catalog.sets import SETS, plan_of
from storyblender.memory.scene_context import Environment, Light, Sky

pytestmark = pytest.mark.blender

DAY = Sky(zenith=(0.3, 0.5, 0.9), horizon=(0.8, 0.9, 1.0), ground=(0.3, 0.3, 0.2))
NIGHT = Sky(zenith=(0.01, 0.01, 0.02), horizon=(0.02, 0.03, 0.05), ground=(0.01, 0.01, 0.01))


@pytest.fixture
def scene() -> Iterator[bpy.types.Scene]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.name = "SC010"
    yield bpy.context.scene


def built(kit: str, scene: bpy.types.Scene) -> tuple[SetPlan, list[bpy.types.Object]]:
    plan = plan_of(Environment(kit=kit, seed=2))
    objects = build_set(plan, scene, scene.collection)
    bpy.context.view_layer.update()
    return plan, objects


@dataclass(frozen=True)
class BuiltKit:
    """What is asked of every kit, measured while it stood.

    Attributes:
        planned: The ids of its plan.
        built: The ids of its objects.
        kinds: Their kinds.
        faulty: The names of objects without faces, or of another scene.
        lost: Degrees at which somebody in the middle looks past everything, for a place under the sky.
    """

    planned: set[str]
    built: set[str]
    kinds: set[str]
    faulty: list[str]
    lost: list[int]


@cache
def measured(kit: str) -> BuiltKit:
    """Build a kit in a scene without others and measure it; materials are left, their pictures take long to make."""
    scene = bpy.context.scene
    bpy.data.batch_remove(bpy.data.objects)
    bpy.data.batch_remove(bpy.data.meshes)
    plan, objects = built(kit, scene)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    walls = [wall for wall in plan.walls if not wall.missing]
    found = BuiltKit(
        planned={item.node_id for part in (walls, plan.slabs, plan.pieces, plan.backdrops) for item in part},
        built={obj["node_id"] for obj in objects},
        kinds={obj["kind"] for obj in objects},
        faulty=[obj.name for obj in objects if not (len(obj.data.polygons) and obj.name.startswith("SC010."))],
        lost=[degrees for degrees in range(0, 360, 3) if not plan.indoor and not meets(scene, depsgraph, degrees)],
    )
    return found


def meets(scene: bpy.types.Scene, depsgraph: bpy.types.Depsgraph, degrees: int) -> bool:
    direction = (np.sin(np.radians(degrees)), np.cos(np.radians(degrees)), -0.004)
    return scene.ray_cast(depsgraph, (0.2, -0.2, 1.6), direction, distance=400.0)[0]


def parts_of(kit: str) -> frozenset[str]:
    """Return the kinds of walls, pieces and backdrops that a kit is built of."""
    plan = plan_of(Environment(kit=kit, seed=2))
    kinds = {f"wall of {wall.material}" for wall in plan.walls}
    kinds |= {f"piece {piece.part}" for piece in plan.pieces} | {f"backdrop {drop.kind}" for drop in plan.backdrops}
    return frozenset(kinds)


def few_kits_with_all_parts() -> list[str]:
    """Return kits that have, together, every kind of part that a set is built of."""
    parts = {kit: parts_of(kit) for kit in SETS}
    left, chosen = frozenset[str]().union(*parts.values()), list[str]()
    while left:
        chosen.append(max(SETS, key=lambda kit: len(parts[kit] & left)))
        left -= parts[chosen[-1]]
    return chosen


def is_built_of_its_plan(kit: str) -> None:
    kit_built = measured(kit)
    assert kit_built.built == kit_built.planned
    assert kit_built.kinds == {"set"}
    assert not kit_built.faulty
    assert not kit_built.lost, "the horizon is closed"


@every("kit", few_kits_with_all_parts)
def test_kits_with_every_part_build_all_of_their_plan(kit: str, scene: bpy.types.Scene) -> None:
    is_built_of_its_plan(kit)


@pytest.mark.slow
@every("kit", SETS)
def test_every_kit_builds_all_of_its_plan(kit: str, scene: bpy.types.Scene) -> None:
    is_built_of_its_plan(kit)


def test_same_pieces_share_a_mesh(scene: bpy.types.Scene) -> None:
    _, objects = built("forest", scene)
    assert len({obj.data.name for obj in objects}) < len(objects) / 4


def test_something_stands_before_the_light_of_a_train_window(scene: bpy.types.Scene) -> None:
    mesh, _ = piece_mesh(Piece(node_id="train", part="train", location=(0, 0, 0), params={"carriages": 1}), scene)
    made = [material.name for material in mesh.materials]
    places = {"pane": [], "fabric": []}
    for face in mesh.polygons:
        for kind, found in places.items():
            if kind in made[face.material_index]:
                found.append((face.center.x, face.center.z, face.center.y))
    pane, cloth = (np.array(places[kind]) for kind in ("pane", "fabric"))
    # Outside is -Y: before most panes, and within a window's width of them, there is a curtain or a seat.
    near = (np.abs(pane[:, None, :2] - cloth[None, :, :2]) < (0.55, 0.4)).all(2) & (
        cloth[None, :, 2] < pane[:, None, 2]
    )
    outer = pane[:, 2] < np.median(pane[:, 2]) + 1e-3
    assert near.any(axis=1)[outer].mean() > 0.5


def test_two_builds_are_equal(scene: bpy.types.Scene) -> None:
    def points() -> np.ndarray:
        _, objects = built("cottage", scene)
        flat = [np.empty(len(obj.data.vertices) * 3, np.float32) for obj in objects]
        for obj, target in zip(objects, flat, strict=True):
            obj.data.vertices.foreach_get("co", target)
        return np.concatenate(flat)

    assert np.array_equal(points(), points())


def test_a_door_leaf_belongs_to_its_wall_and_swings_away(scene: bpy.types.Scene) -> None:
    plan, objects = built("office", scene)
    leaf = next(obj for obj in objects if "opening" in obj)
    assert leaf["node_id"] in {wall.node_id for wall in plan.walls}
    shut = np.abs(np.array([leaf.matrix_world @ vertex.co for vertex in leaf.data.vertices])[:, 0]).max()
    swing_door(leaf, "open")
    bpy.context.view_layer.update()
    opened = np.abs(np.array([leaf.matrix_world @ vertex.co for vertex in leaf.data.vertices])[:, 0]).max()
    assert opened > shut + 0.5, "the office's door is in the right wall and opens outwards"


@pytest.mark.parametrize("kit", ["room", "cell", "great_hall", "theatre", "warehouse"])
def test_no_ray_leaves_a_room_without_meeting_the_set(kit: str, scene: bpy.types.Scene) -> None:
    plan, _ = built(kit, scene)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    rng = np.random.default_rng(0)
    lost = 0
    for direction in rng.normal(size=(400, 3)):
        direction /= np.linalg.norm(direction)
        hit, *_ = scene.ray_cast(depsgraph, (0.1, 0.1, 1.5), direction)
        lost += not hit
    windows = sum(opening.kind == "window" for wall in plan.walls for opening in wall.openings)
    assert lost <= (12 if windows else 0), "only the sky over the backdrop may be seen"


def test_windows_are_lit_at_night_only(scene: bpy.types.Scene) -> None:
    built("street", scene)
    panes = [block for block in bpy.data.materials if block.get("follows") == scene.name and not block["day_emit"]]
    assert panes
    set_world(scene, DAY)
    assert all(block["emit"] == 0 for block in panes)
    set_world(scene, NIGHT)
    assert all(block["emit"] > 0.1 for block in panes)


def test_day_shines_outside_the_windows_of_a_room(scene: bpy.types.Scene) -> None:
    built("office", scene)
    outside = [block for block in bpy.data.materials if block.get("follows") == scene.name and not block["night_emit"]]
    set_world(scene, NIGHT)
    assert outside and all(block["emit"] == 0 for block in outside)
    set_world(scene, DAY)
    assert all(block["emit"] > 0.5 for block in outside)


def test_night_is_measured_on_the_sky() -> None:
    assert night_of(DAY) == 0.0
    assert night_of(NIGHT) == 1.0


def test_a_new_sky_replaces_the_old_world(scene: bpy.types.Scene) -> None:
    first = set_world(scene, DAY).name
    set_world(scene, NIGHT)
    assert len([world for world in bpy.data.worlds if world.name.startswith("SC010")]) == 1 and first


def test_lamps_are_tagged_and_unseen(scene: bpy.types.Scene) -> None:
    lamp = Light(name="window", kind="AREA", location=(1, 2, 3), target=(1, 2, 0), power=30, size=1.5)
    (obj,) = make_lights((lamp,), scene.collection, "SC010")
    assert (obj["kind"], obj["node_id"], obj.data.energy, obj.visible_camera) == ("light", "window", 30, False)
    assert tuple(obj.location) == (1, 2, 3)


@pytest.mark.parametrize(
    ("part", "prop"), [("broad_tree", "tree"), ("pine_tree", "pine"), ("palm_tree", "palm_tree"), ("rock", "rock")]
)
def test_what_grows_in_a_set_and_what_stands_there_as_a_prop_have_one_shape(
    part: str, prop: str, scene: bpy.types.Scene
) -> None:
    planted, _ = piece_mesh(Piece(node_id=part, part=part, location=(0, 0, 0)), scene)
    alone = build_prop(prop).mesh
    assert [len(face.vertices) for face in planted.polygons] == [len(face.vertices) for face in alone.polygons]


def test_foam_ends_under_the_water_so_that_it_throws_no_shadow(scene: bpy.types.Scene) -> None:
    mesh, _ = piece_mesh(Piece(node_id="surf", part="surf", location=(0, 0, 0), params={"length": 20.0}), scene)
    heights = np.array([vertex.co[2] for vertex in mesh.vertices])
    assert heights.max() > 0.02
    assert (heights < 0.012).sum() == 2 * (heights > 0.012).sum()
