"""The meshes of a .blend as one plain model: modifiers applied within bounds, materials as colour and picture."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import bpy
import numpy as np

from storyblender.blender.models.addresses import readable
from storyblender.blender.models.credits import credit_of
from storyblender.blender.models.limits import MATERIALS, NODES, PARTS
from storyblender.blender.models.parts import Part, checked, joined, within_bounds
from storyblender.blender.models.pictures import clean_channel, clean_normals, clean_picture
from storyblender.blender.models.plain import PlainMaterial, PlainModel
from storyblender.blender.models.usd_layers import LAYERS, UsdLayers, open_layers
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Credit
from storyblender.memory.base import Color

_SOLID = frozenset(("MESH", "CURVE", "SURFACE", "FONT", "META"))
_MODIFIERS = frozenset(
    ("ARMATURE", "ARRAY", "BEVEL", "BOOLEAN", "CAST", "CURVE", "DECIMATE", "DISPLACE", "EDGE_SPLIT", "LATTICE",
     "MIRROR", "SCREW", "SHRINKWRAP", "SIMPLE_DEFORM", "SMOOTH", "SOLIDIFY", "SUBSURF", "TRIANGULATE", "WARP",
     "WEIGHTED_NORMAL", "WELD", "WIREFRAME")
)  # fmt: skip
"""Modifiers that are applied; node groups, simulations and particles are left out."""
_MOST = (("levels", 2), ("count", 200), ("steps", 64), ("render_steps", 64), ("segments", 6))
"""Settings of modifiers and the most of each that is applied."""
_PAINT = frozenset(("VERTEX_COLOR", "ATTRIBUTE"))


def read_scene(path: Path, folder: Path) -> PlainModel:
    """Read the meshes of a .blend, glTF, .fbx, .stl, .ply or USD into the open file, and return them as plain data.

    Args:
        path: The file.
        folder: The folder of models; what the file names must be in it.

    Raises:
        InputError: It holds no mesh, is too large, or takes parts from elsewhere.
    """
    credit, unit = Credit(), 1.0
    shelf = _Shelf(path, folder)
    if path.suffix.lower() == ".blend":
        credit = _credit(path)
        _append(path, folder)
    elif path.suffix.lower() in LAYERS:
        layers = open_layers(path, folder)
        _import_usd(path, layers)
        shelf.notes += layers.notes
        unit = 1.0 if layers.says_unit else None
    else:
        _import(path)
    parts: list[Part] = []
    vertices = faces = count = 0
    for instance in bpy.context.evaluated_depsgraph_get().object_instances:
        count += 1
        if count > PARTS:
            raise InputError(f"it has more than {PARTS} objects and copies of them")
        obj = instance.object
        if obj.type not in _SOLID or obj.original.hide_render:
            continue
        mesh = obj.to_mesh()
        if mesh is None or not len(mesh.polygons):
            continue
        mesh.calc_loop_triangles()
        vertices, faces = vertices + len(mesh.vertices), faces + len(mesh.loop_triangles)
        within_bounds(vertices, faces)
        parts += _parts(obj, mesh, np.array(instance.matrix_world), shelf)
        obj.to_mesh_clear()
    model = checked(joined(parts)).with_materials(tuple(shelf.materials), tuple(dict.fromkeys(shelf.notes)))
    return replace(model, credit=credit, unit=unit)


def _credit(path: Path) -> Credit:
    """Return what the asset metadata in a .blend says; of several assets the first that says something."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with bpy.data.libraries.load(str(path), link=True, assets_only=True) as (source, target):
        target.collections, target.objects = list(source.collections)[:PARTS], list(source.objects)[:PARTS]
    marked = [block.asset_data for block in (*target.collections, *target.objects) if block and block.asset_data]
    found = (credit_of(data.author, data.license, data.copyright) for data in marked)
    return next((credit for credit in found if credit != Credit()), Credit())


def _import(path: Path) -> None:
    """Import a file with Blender's importer for it, into an empty file."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    match path.suffix.lower():
        case ".fbx":
            bpy.ops.import_scene.fbx(
                filepath=str(path),
                use_anim=False,
                use_image_search=False,
                use_custom_props=False,
                ignore_leaf_bones=True,
            )
        case ".stl":
            bpy.ops.wm.stl_import(filepath=str(path))
        case ".ply":
            bpy.ops.wm.ply_import(filepath=str(path), import_colors="LINEAR")
            _show_paint()
        case _:
            bpy.ops.import_scene.gltf(filepath=str(path), disable_bone_shape=True)
    _tame_all()


def _import_usd(path: Path, layers: UsdLayers) -> None:
    """Import a USD file whose layers were checked into an empty file: Z up, in metres if it says its unit."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.usd_import(
        filepath=str(path),
        set_frame_range=False,
        import_cameras=False,
        import_curves=False,
        import_lights=False,
        import_volumes=False,
        import_skeletons=False,
        import_blendshapes=False,
        import_points=False,
        read_mesh_attributes=False,
        validate_meshes=True,
        import_textures_mode="IMPORT_NONE",
        create_world_material=False,
        apply_unit_conversion_scale=layers.says_unit,
    )
    _show_paint()
    _tame_all()


def _tame_all() -> None:
    for obj in bpy.data.objects:
        _tame(obj)
    bpy.context.view_layer.update()


def _show_paint() -> None:
    """Give meshes that have vertex colours and no material one that shows them."""
    painted = [mesh for mesh in bpy.data.meshes if mesh.color_attributes and not mesh.materials]
    if not painted:
        return
    material = bpy.data.materials.new("painted")
    material.use_nodes = True
    tree = material.node_tree
    paint = tree.nodes.new("ShaderNodeVertexColor")
    tree.links.new(paint.outputs["Color"], tree.nodes["Principled BSDF"].inputs["Base Color"])
    for mesh in painted:
        mesh.materials.append(material)


def _append(path: Path, folder: Path) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.preferences.filepaths.use_scripts_auto_execute = False
    with bpy.data.libraries.load(str(path), link=False) as (source, target):
        if len(source.objects) > NODES:
            raise InputError(f"it has {len(source.objects)} objects; at most {NODES} are read")
        target.objects = list(source.objects)
    real, root = path.resolve(), folder.resolve()
    for library in bpy.data.libraries:
        taken = Path(bpy.path.abspath(library.filepath)).resolve()
        if taken != real and not taken.is_relative_to(root):
            raise InputError("it takes parts from another file outside the folder of models")
    for obj in target.objects:
        if obj is None or obj.library is not None:
            continue
        _tame(obj)
        bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.update()


def _tame(obj: bpy.types.Object) -> None:
    """Leave an object as it stands: no animation, drivers or constraints, and only plain modifiers."""
    obj.animation_data_clear()
    if obj.data is not None and obj.data.library is None:
        obj.data.animation_data_clear()
    keys = getattr(obj.data, "shape_keys", None)
    if keys is not None and keys.library is None:
        keys.animation_data_clear()
    obj.constraints.clear()
    obj.hide_viewport = False
    for modifier in list(obj.modifiers):
        if modifier.type not in _MODIFIERS or not modifier.show_viewport:
            obj.modifiers.remove(modifier)
            continue
        for name, most in _MOST:
            if hasattr(modifier, name):
                setattr(modifier, name, min(getattr(modifier, name), most))
    for system in list(obj.particle_systems):
        obj.modifiers.remove(next(m for m in obj.modifiers if getattr(m, "particle_system", None) == system))


class _Shelf:
    """The materials met so far, each once."""

    def __init__(self, path: Path, folder: Path) -> None:
        self._path, self._folder = path, folder
        self._numbers: dict[str, int] = {}
        self.materials: list[PlainMaterial] = []
        self.painted: list[bool] = []
        self.notes: list[str] = []

    def number(self, material: bpy.types.Material | None) -> int:
        """Return the number of a material, read the first time it is met; -1 for none."""
        if material is None:
            return -1
        name = material.name_full
        if name not in self._numbers:
            if len(self.materials) == MATERIALS:
                raise InputError(f"it has more than {MATERIALS} materials")
            self._numbers[name] = len(self.materials)
            plain, painted = self._plain(material)
            self.materials.append(plain)
            self.painted.append(painted)
        return self._numbers[name]

    def _plain(self, material: bpy.types.Material) -> tuple[PlainMaterial, bool]:
        shown = _color(material.diffuse_color)
        nodes = material.node_tree.nodes if material.use_nodes and material.node_tree else ()
        shader = next((node for node in nodes if node.type in ("BSDF_PRINCIPLED", "EMISSION", "BSDF_DIFFUSE")), None)
        if shader is None:
            return PlainMaterial(name=material.name, color=shown, roughness=material.roughness), False
        base = shader.inputs[0]
        color = _color(base.default_value)
        picture, painted = b"", False
        if base.is_linked:
            source = _upstream(base)
            picture = self._picture(source.image) if source is not None and source.type == "TEX_IMAGE" else b""
            painted = source is not None and source.type in _PAINT
            color = (1.0, 1.0, 1.0) if picture or painted else shown
        if shader.type != "BSDF_PRINCIPLED":
            light = color if shader.type == "EMISSION" else (0.0, 0.0, 0.0)
            return PlainMaterial(name=material.name, color=color, emission=light, picture=picture), painted
        strength = float(shader.inputs["Emission Strength"].default_value)
        light = [min(strength, 100.0) * float(value) for value in shader.inputs["Emission Color"].default_value[:3]]
        normals, relief = self._normals(shader.inputs["Normal"])
        plain = PlainMaterial(
            name=material.name,
            color=color,
            alpha=_value(shader, "Alpha", 1.0),
            roughness=_value(shader, "Roughness", 0.5),
            metallic=_value(shader, "Metallic", 0.0),
            roughness_map=self._channel(shader.inputs["Roughness"]),
            metallic_map=self._channel(shader.inputs["Metallic"]),
            normal_map=normals,
            relief=relief,
            emission=(light[0], light[1], light[2])
            if not shader.inputs["Emission Color"].is_linked
            else (0.0, 0.0, 0.0),
            picture=picture,
        )
        return plain, painted

    def _channel(self, socket: bpy.types.NodeSocket) -> bytes:
        """Return the channel of a picture that a socket is linked to, by itself or through Separate Color."""
        source = _upstream(socket)
        if source is None or source.type != "TEX_IMAGE":
            return b""
        channel = {"Green": 1, "Blue": 2}.get(socket.links[0].from_socket.name, 0)
        return self._picture(source.image, lambda data, name: clean_channel(data, name, channel))

    def _normals(self, socket: bpy.types.NodeSocket) -> tuple[bytes, float]:
        """Return the normal map that a socket is linked to, and its strength."""
        node = socket.links[0].from_node if socket.is_linked else None
        if node is None or node.type != "NORMAL_MAP" or node.space != "TANGENT":
            return b"", 1.0
        source = _upstream(node.inputs["Color"])
        found = self._picture(source.image, clean_normals) if source and source.type == "TEX_IMAGE" else b""
        return found, float(np.clip(node.inputs["Strength"].default_value, 0, 4))

    def _picture(self, image: bpy.types.Image | None, clean: Callable[[bytes, str], bytes] = clean_picture) -> bytes:
        """Return a picture that is packed or lies in the folder of models; another is left out with a note."""
        if image is None or image.source not in ("FILE", "TILED"):
            return b""
        try:
            if image.packed_file is not None:
                return clean(bytes(image.packed_file.data), image.name)
            found = Path(bpy.path.abspath(image.filepath, start=str(self._path.parent)))
            return clean(readable(self._folder, found).read_bytes(), image.name)
        except InputError as error:
            self.notes.append(f"{error.problem}; it is left out")
            return b""


def _color(values: Sequence[float]) -> Color:
    red, green, blue = (float(value) for value in values[:3])
    return red, green, blue


def _value(shader: bpy.types.Node, name: str, linked: float) -> float:
    socket = shader.inputs[name]
    return linked if socket.is_linked else float(np.clip(socket.default_value, 0, 1))


def _upstream(socket: bpy.types.NodeSocket) -> bpy.types.Node | None:
    """Return the first picture or vertex colour that a socket's value comes from."""
    waiting, seen = [link.from_node for link in socket.links], set()
    while waiting:
        node = waiting.pop(0)
        if node.name in seen:
            continue
        seen.add(node.name)
        if node.type == "TEX_IMAGE" or node.type in _PAINT:
            return node
        waiting += [link.from_node for entry in node.inputs for link in entry.links]
    return None


def _parts(obj: bpy.types.Object, mesh: bpy.types.Mesh, matrix: np.ndarray, shelf: _Shelf) -> list[Part]:
    """Return the faces of an evaluated object, a part for each material."""
    points = _read(mesh.vertices, "co", 3)
    points = points @ matrix[:3, :3].T + matrix[:3, 3]
    count = len(mesh.loop_triangles)
    loops = _read(mesh.loop_triangles, "loops", 3).astype(np.int64)
    faces = _read(mesh.loop_triangles, "material_index", 1)[:, 0].astype(np.int64)
    smooth = np.zeros(len(mesh.polygons), bool)
    mesh.polygons.foreach_get("use_smooth", smooth)
    vertex_of = _read(mesh.loops, "vertex_index", 1)[:, 0].astype(np.int64)
    if np.linalg.det(matrix[:3, :3]) < 0:
        loops = loops[:, ::-1]
    layer = next((each for each in mesh.uv_layers if each.active_render), None)
    laid = None if layer is None else _read(layer.uv, "vector", 2)
    slots = [shelf.number(slot.material) for slot in obj.material_slots] or [-1]
    paint = _paint(mesh, vertex_of) if any(slot >= 0 and shelf.painted[slot] for slot in slots) else None
    numbers = np.array(slots)[np.clip(faces, 0, len(slots) - 1)] if count else faces
    parts = []
    for number in np.unique(numbers):
        chosen = loops[numbers == number]
        corners = chosen.ravel()
        used, where = np.unique(vertex_of[corners], return_inverse=True)
        coated = paint is not None and number >= 0 and shelf.painted[number]
        parts.append(
            Part(
                points[used],
                where.reshape(-1, 3),
                int(number),
                smooth=bool(smooth.mean() > 0.5),
                layers=[laid[corners]] if laid is not None else [],
                paint=paint[corners] if coated and paint is not None else None,
            )
        )
    return parts


def _paint(mesh: bpy.types.Mesh, vertex_of: np.ndarray) -> np.ndarray | None:
    """Return the scene-linear colours of a mesh's corners."""
    colors = mesh.color_attributes.active_color or next(iter(mesh.color_attributes), None)
    if colors is None:
        return None
    values = _read(colors.data, "color", 4)[:, :3]
    return np.clip(values[vertex_of] if colors.domain == "POINT" else values, 0, 1)


def _read(items: bpy.types.bpy_prop_collection, name: str, width: int) -> np.ndarray:
    whole = name in ("loops", "material_index", "vertex_index")
    values = np.empty(len(items) * width, np.int32 if whole else np.float32)
    items.foreach_get(name, values)
    return values.reshape(-1, width).astype(np.int64 if whole else np.float64)
