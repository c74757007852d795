"""Builds a SetPlan: walls, slabs, pieces, backdrops as tagged objects. Furnishings are props, placed by the layout."""

from __future__ import annotations

import math

import bpy
import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.backdrops import backdrop_mesh
from storyblender.blender.sets.finish import finish, view_outside
from storyblender.blender.sets.pieces import piece_mesh
from storyblender.blender.sets.textured import lies_across, skin_of, with_tangents
from storyblender.blender.sets.walls import leaf_meshes, wall_mesh
from storyblender.blender.tags import Surface, tag
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.set_plan import SetPlan, Slab, Wall
from storyblender.catalog.sets.finishes import finish_of
from storyblender.memory.texture import Texture


def build_set(plan: SetPlan, scene: bpy.types.Scene, collection: bpy.types.Collection) -> list[bpy.types.Object]:
    """Build all of a plan but its furnishings and lamps.

    Every object carries ``kind = "set"`` and the ``node_id`` of its part of the plan: a wall, its joinery and its door
    leaves share one, so hiding that node takes the whole wall away. Pieces that look alike share a mesh. The scene's
    custom property ``open_sky`` tells the viewfinder whether emptiness above the horizon is sky.

    Args:
        plan: What to build; the pictures of its surfaces are in the open file (``textured.load_textures``).
        scene: Whose daylight the lit windows follow.
        collection: Receives the objects.

    Returns:
        The objects in the order of the plan.

    Raises:
        KeyError: The plan names a part or a material that nobody builds.
    """
    objects = [obj for wall in plan.walls if not wall.missing for obj in _wall(wall, indoor=plan.indoor)]
    objects += [_slab(slab, scene) for slab in plan.slabs]
    objects += _pieces(plan, scene)
    for card in plan.backdrops:
        obj = _object(backdrop_mesh(card, scene, indoor=not plan.under_the_sky), card.node_id, Surface.CARD)
        obj.visible_shadow = False
        objects.append(obj)
    for obj in objects:
        obj.name = f"{scene.name}.{obj.name}"
        obj.display.show_shadows = False
        collection.objects.link(obj)
    scene["open_sky"] = plan.under_the_sky
    return objects


def _object(mesh: bpy.types.Mesh, node_id: str, surface: Surface, name: str = "") -> bpy.types.Object:
    """Return a tagged object of the set; it is named after its node unless ``name`` is given."""
    obj = bpy.data.objects.new(name or node_id, with_tangents(mesh))
    return tag(obj, kind="set", node_id=node_id, surface=surface)


def _wall(wall: Wall, *, indoor: bool) -> list[bpy.types.Object]:
    """Return a wall and the leaves of its doors, placed in the world."""
    angle = math.atan2(wall.end[1] - wall.start[1], wall.end[0] - wall.start[0])
    body = _object(wall_mesh(wall, indoor=indoor), wall.node_id, Surface.SET)
    body.location, body.rotation_euler = (*wall.start, wall.base), (0, 0, angle)
    objects = [body]
    for opening, mesh, hinge, swing in leaf_meshes(wall):
        leaf = _object(mesh, wall.node_id, Surface.SET, f"{wall.node_id}_{opening.name}")
        along = (math.cos(angle) * hinge, math.sin(angle) * hinge)
        leaf.location = (wall.start[0] + along[0], wall.start[1] + along[1], wall.base)
        leaf["opening"], leaf["shut"], leaf["swing"] = opening.name, angle, math.radians(-swing)
        swing_door(leaf, opening.state)
        objects.append(leaf)
    return objects


def swing_door(leaf: bpy.types.Object, state: str) -> None:
    """Open or close a door leaf that ``build_set`` made; it swings away from the room.

    Args:
        leaf: The object with the property ``opening``.
        state: ``open`` or ``closed``.
    """
    leaf.rotation_euler = (0, 0, leaf["shut"] + (leaf["swing"] if state == "open" else 0.0))


def _slab(slab: Slab, scene: bpy.types.Scene) -> bpy.types.Object:
    """Return a floor, ceiling or block, with its beams."""
    builder = MeshBuilder(slab.node_id)
    outside = slab.role == "patch" and slab.z < 0
    skin = _outside(slab.material, scene) if outside else skin_of(slab.material, slab.texture)
    if slab.role == "block":
        builder.extrude(skin, slab.polygon, slab.thickness, base=slab.z - slab.thickness)
    elif slab.role == "ceiling":
        builder.polygon(skin, [(x, y, slab.z) for x, y in reversed(slab.polygon)])
        _beams(builder, slab)
    else:
        corners = [(x, y, slab.z) for x, y in slab.polygon]
        laid = [(y, -x) for x, y in slab.polygon] if lies_across(slab.texture, slab.polygon) else None
        builder.polygon(skin, corners, uv=None if laid is None else np.array(laid) / skin["tile"])
    return _object(builder.mesh(), slab.node_id, Surface.WET if slab.wet else Surface.SET)


def _outside(key: str, scene: bpy.types.Scene) -> bpy.types.Material:
    """Return the material of the ground before a room's windows."""
    chosen = finish_of(key)
    return view_outside(key, chosen.color or MATERIALS[chosen.material].color, scene)


def _beams(builder: MeshBuilder, slab: Slab) -> None:
    """Add the beams under a ceiling, along X."""
    xs, ys = [x for x, _ in slab.polygon], [y for _, y in slab.polygon]
    for index in range(slab.beams):
        y = min(ys) + (index + 0.5) * (max(ys) - min(ys)) / slab.beams
        middle = ((min(xs) + max(xs)) / 2, y, slab.z - 0.09)
        builder.box(finish("wood_dark"), middle, (max(xs) - min(xs), 0.17, 0.18), bevel=0.015)


def _pieces(plan: SetPlan, scene: bpy.types.Scene) -> list[bpy.types.Object]:
    """Return the pieces of a plan; those that look alike share a mesh."""
    meshes: dict[tuple[str, str, Texture | None], tuple[bpy.types.Mesh, Surface]] = {}
    objects = []
    for piece in plan.pieces:
        key = (piece.part, repr(sorted(piece.params.items())), piece.texture)
        if key not in meshes:
            meshes[key] = piece_mesh(piece, scene)
        mesh, surface = meshes[key]
        obj = _object(mesh, piece.node_id, surface)
        obj.location, obj.rotation_euler = piece.location, (0, 0, math.radians(piece.yaw))
        obj.scale = (piece.scale,) * 3
        objects.append(obj)
    return objects
