"""A person from casting words: body, face, hair and clothes on one armature."""

from __future__ import annotations

from dataclasses import dataclass

import bpy

from storyblender.blender.people import face, hair, rig, skin, tailor
from storyblender.blender.people.body import Body
from storyblender.blender.people.figure import Figure
from storyblender.blender.people.pack import PARTS, BodyPack, load_body_pack
from storyblender.blender.people.parts import Paint, build_object
from storyblender.blender.people.sheet import hemmed, join
from storyblender.blender.tags import Surface, tag
from storyblender.catalog.bodies import Complexion, complexion, recipe, resolved_gender
from storyblender.catalog.garments import dressed
from storyblender.catalog.skeleton import SKELETON
from storyblender.memory.asset_sheet import CharacterLook

HEM = 0.004


@dataclass(frozen=True)
class PersonBuild:
    """A finished person.

    Attributes:
        armature: Named like the asset, at the origin, soles at z = 0, facing -Y.
        meshes: Everything that hangs on it.
        body: What the motion solver needs.
    """

    armature: bpy.types.Object
    meshes: list[bpy.types.Object]
    body: Body


def build_person(asset_id: str, look: CharacterLook, seed: int) -> PersonBuild:
    """Build a clothed, rigged person in the open scene; equal arguments give equal vertices.

    Args:
        asset_id: Name of the armature object and tag of every part.
        look: Casting words; gaps are filled from gender, age and seed.
        seed: Makes two people with the same words different.
    """
    pack = load_body_pack()
    assert pack
    figure = Figure(pack, pack.shape(recipe(look, seed)))
    gender = resolved_gender(look, seed)
    colors = complexion(look, seed)
    joints = {name: figure.joint(name) for bone in SKELETON for name in (bone.head, bone.tail)}
    armature = rig.build_armature(asset_id, joints)
    tag(armature, kind="character", node_id=asset_id, asset_id=asset_id)
    wardrobe = tailor.dress(figure, dressed(look, gender, seed), seed)
    meshes = [
        *_head_and_body(pack, figure, armature, look, colors, wardrobe),
        *_clothes(figure, armature, wardrobe),
    ]
    sheet = hair.cap(figure, 0.022, 0.010)
    meshes.append(
        build_object(
            f"{asset_id}_hair",
            sheet,
            [Paint(colors.hair, "hair")],
            armature,
            surface=Surface.HAIR,
            ink_group=f"{asset_id}_hair",
        )
    )
    bare = PARTS["skin"]
    body = rig.measure_body(armature, figure.points[bare], pack.weights[bare], figure.stature, tuple(skin.EXPRESSIONS))
    return PersonBuild(armature, meshes, body)


def _head_and_body(
    pack: BodyPack,
    figure: Figure,
    armature: bpy.types.Object,
    look: CharacterLook,
    colors: Complexion,
    wardrobe: list[tailor.Worn],
) -> list[bpy.types.Object]:
    name = armature.name
    every = skin.expressions(pack)
    bare = skin.skin_sheet(figure)
    bare = bare.keep_faces(~tailor.covered_skin(figure, bare, wardrobe))
    paint = skin.paint_skin(figure, bare, colors, look.age, 0.15)
    lashes, teeth, tongue = (figure.part(part) for part in ("lashes", "teeth", "tongue"))
    brow, brow_keys = face.brows(figure, 0.034, every)
    sheets = [bare, lashes, teeth, tongue, brow]
    import numpy as np

    for slot, sheet in enumerate(sheets):
        sheet.slot[:] = slot
    keys = {
        key: np.concatenate([*(skin.keys_for(sheet, every)[key] for sheet in sheets[:4]), brow_keys[key]])
        for key in every
    }
    body = join(sheets)
    flat = np.zeros((len(body.points) - len(bare.points), 3))
    group = f"{name}_skin"
    paints = [
        Paint(colors.skin, "skin", vertex_colors=True),
        Paint((0.01, 0.008, 0.006), "cloth"),
        Paint((0.75, 0.72, 0.65), "satin"),
        Paint((0.4, 0.12, 0.1), "skin"),
        Paint(colors.brow, "hair"),
    ]
    skin_object = build_object(
        f"{name}_skin", body, paints, armature, surface=Surface.SKIN, ink_group=group,
        colors=np.concatenate([paint, flat]), shape_keys=keys,
    )  # fmt: skip
    iris = colors.iris
    limbus = tuple(c * 0.35 for c in iris)
    eye_paints = [
        Paint((0.005, 0.005, 0.005), "eye"),
        Paint(iris, "eye"),
        Paint(limbus, "eye"),
        Paint((0.78, 0.76, 0.74), "eye"),
        Paint((1, 1, 1), "eye"),
    ]
    eyes = build_object(f"{name}_eyes", face.eyes(figure), eye_paints, armature, surface=Surface.EYE, ink_group=group)
    return [skin_object, eyes]


def _clothes(figure: Figure, armature: bpy.types.Object, wardrobe: list[tailor.Worn]) -> list[bpy.types.Object]:
    made = []
    for worn in wardrobe:
        sheets, paints = [], []
        for bolt in worn.bolts:
            sheet = hemmed(bolt.sheet, HEM * figure.k)
            paint = Paint(tailor.tinted(worn.color, bolt.tint), bolt.fabric)
            if paint not in paints:
                paints.append(paint)
            sheet.slot[:] = paints.index(paint)
            sheets.append(sheet)
        made.append(
            build_object(f"{armature.name}_{worn.spec.key}", join(sheets), paints, armature, surface=Surface.CLOTH)
        )
    return made
