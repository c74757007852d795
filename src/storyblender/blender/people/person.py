"""Builds a person from a character look: body, face, hair and clothes on one armature."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.people import eyewear, face, hair, mannequin, mouth, rig, skin, tailor, whiskers
from storyblender.blender.people.animal import AnimalBody
from storyblender.blender.people.body import RiggedBody
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.pack import PARTS, BodyPack, load_body_pack
from storyblender.blender.people.parts import Paint, build_object
from storyblender.blender.people.scalp import covered_scalp
from storyblender.blender.people.sheet import hemmed, join
from storyblender.blender.people.tailor import Worn
from storyblender.blender.tags import Surface, tag
from storyblender.catalog.bodies import Complexion, complexion, mix, recipe, resolved_gender
from storyblender.catalog.cuts import hides_hair
from storyblender.catalog.expressions import FACE
from storyblender.catalog.garments import dressed
from storyblender.catalog.hair import hairstyle
from storyblender.catalog.skeleton import SKELETON
from storyblender.catalog.species import SPECIES
from storyblender.catalog.wardrobe import clothes_of_animal
from storyblender.memory.asset_sheet import CharacterLook

HEM = 0.004
"""Visible thickness of cloth on a person of 1.70 m, metres."""
PUPIL, SCLERA = (0.005, 0.005, 0.005), (0.78, 0.76, 0.74)
LASH, FRAME = (0.010, 0.008, 0.006), (0.012, 0.010, 0.009)
Expressions = dict[str, NDArray[np.float64]]


@dataclass(frozen=True)
class PersonBuild:
    """A finished person.

    Attributes:
        armature: Named like the asset, at the origin, soles at z = 0, facing -Y.
        meshes: Mesh objects that it deforms.
        body: Measured body for the motion solver.
        stand_in: Whether this is a plain mannequin, because the body data has not been fetched.
    """

    armature: bpy.types.Object
    meshes: list[bpy.types.Object]
    body: RiggedBody
    stand_in: bool = False


def build_person(asset_id: str, look: CharacterLook, seed: int) -> PersonBuild:
    """Build a clothed, rigged person in the open scene; equal arguments give equal vertices.

    Args:
        asset_id: Name of the armature object and tag of every part.
        look: Casting words; gaps are filled from gender, age and seed.
        seed: Varies people with the same words.
    """
    pack = load_body_pack()
    if pack is None:
        return _build_stand_in(asset_id, look, seed)
    look = look.model_copy(update={"gender": resolved_gender(look, seed)})
    if look.species in SPECIES:
        return _build_animal(asset_id, look, seed, pack)
    colors = complexion(look, seed)
    figure = BodyFigure(pack, pack.shape(recipe(look, seed)))
    armature = rig.build_armature(asset_id, {n: figure.joint(n) for bone in SKELETON for n in (bone.head, bone.tail)})
    tag(armature, kind="character", node_id=asset_id, asset_id=asset_id)
    wardrobe = tailor.dress_figure(figure, dressed(look, look.gender, seed), seed)
    every = skin.expression_offsets(pack)
    meshes = [
        _build_skin(figure, armature, look, colors, wardrobe, every),
        _build_eyes(figure, armature, colors),
        *_build_hair(figure, armature, look, colors, wardrobe, seed),
        *_build_whiskers(figure, armature, look, colors, every, seed),
        *_build_glasses(figure, armature, look),
        *(_build_garment(figure, armature, worn) for worn in wardrobe),
    ]
    return PersonBuild(armature, meshes, _measured(figure, armature))


def _build_animal(asset_id: str, look: CharacterLook, seed: int, pack: BodyPack) -> PersonBuild:
    """Build an animal that acts like a person."""
    animal = AnimalBody(pack, SPECIES[look.species], look, seed)
    armature = rig.build_armature(asset_id, animal.joints)
    tag(armature, kind="character", node_id=asset_id, asset_id=asset_id)
    wardrobe = tailor.dress_figure(animal.figure, clothes_of_animal(look), seed)
    meshes = [
        *animal.build(armature, wardrobe, glasses=look.glasses),
        *(_build_garment(animal.figure, armature, worn) for worn in wardrobe),
    ]
    return PersonBuild(armature, meshes, _measured(animal.figure, armature))


def _measured(figure: BodyFigure, armature: bpy.types.Object) -> RiggedBody:
    """Return the measured body of a figure."""
    bare = PARTS["skin"]
    return rig.measure_body(armature, figure.points[bare], figure.pack.weights[bare], figure.stature, FACE)


def _build_stand_in(asset_id: str, look: CharacterLook, seed: int) -> PersonBuild:
    """Build a mannequin of the look's stature; its armature has the custom property ``stand_in``."""
    stature = recipe(look, seed).stature
    armature = rig.build_armature(asset_id, mannequin.mannequin_joints(stature))
    tag(armature, kind="character", node_id=asset_id, asset_id=asset_id)
    armature["stand_in"] = True
    sheet = mannequin.build_mannequin(stature)
    paint = Paint(mannequin.CLAY, "cloth")
    mesh = build_object(f"{asset_id}_mannequin", sheet, [paint], armature, surface=Surface.CLOTH)
    body = rig.measure_body(armature, sheet.points, sheet.weights, stature, ())
    return PersonBuild(armature, [mesh], body, stand_in=True)


def _build_skin(
    figure: BodyFigure,
    armature: bpy.types.Object,
    look: CharacterLook,
    colors: Complexion,
    wardrobe: Sequence[Worn],
    every: Expressions,
) -> bpy.types.Object:
    """Build the visible skin with lashes, brows, teeth and tongue, which share the face's shape keys."""
    bare = figure.part("skin")
    hidden = tailor.covered_skin(figure, bare, wardrobe)
    hidden |= covered_scalp(figure, bare, hairstyle(look.hair), float(look.gender == "male"))
    bare = bare.keep_faces(~hidden)
    paint = skin.paint_skin(figure, bare, colors, look)
    sheets = [bare, *(figure.part(name) for name in ("lashes", "teeth", "tongue"))]
    keys = [skin.shape_keys_of(sheet, every) for sheet in sheets]
    brows, brow_keys = face.brows(figure, 0.034, every)
    sheets.append(brows)
    keys.append(brow_keys)
    for slot, sheet in enumerate(sheets):
        sheet.slot[:] = slot
    whole = join(sheets)
    painted = {0: paint, 2: mouth.paint_teeth(sheets[2].base)}  # by slot
    return build_object(
        f"{armature.name}_skin",
        whole,
        [
            Paint(colors.skin, "skin", vertex_colors=True),
            Paint(LASH, "cloth"),
            Paint(mouth.TOOTH, "satin", vertex_colors=True),
            Paint(mouth.TONGUE, "skin"),
            Paint(colors.brow, "hair"),
        ],
        armature,
        surface=Surface.SKIN,
        ink_group=f"{armature.name}_skin",
        colors=np.concatenate([painted.get(slot, np.zeros((len(part.points), 3))) for slot, part in enumerate(sheets)]),
        shape_keys={key: np.concatenate([part[key] for part in keys]) for key in every},
    )


def _build_eyes(figure: BodyFigure, armature: bpy.types.Object, colors: Complexion) -> bpy.types.Object:
    """Build the eyeballs."""
    limbus = mix(colors.iris, (0.0, 0.0, 0.0), 0.65)
    shades = (PUPIL, colors.iris, limbus, SCLERA, (1.0, 1.0, 1.0))
    return build_object(
        f"{armature.name}_eyes",
        face.eyes(figure),
        [Paint(shade, "eye") for shade in shades],
        armature,
        surface=Surface.EYE,
        ink_group=f"{armature.name}_skin",
    )


def _build_hair(
    figure: BodyFigure,
    armature: bpy.types.Object,
    look: CharacterLook,
    colors: Complexion,
    wardrobe: Sequence[Worn],
    seed: int,
) -> list[bpy.types.Object]:
    """Build the hair; empty for a shaved head or under a hood."""
    if any(hides_hair(piece) for worn in wardrobe for piece in worn.spec.pieces):
        return []
    clothes = [bolt.sheet for worn in wardrobe for bolt in worn.bolts]
    hatted = any("head" in worn.spec.covers for worn in wardrobe)
    grown = hair.build_hair(
        figure, look.hair, colors, float(look.gender == "male"), seed, clothes=clothes, hatted=hatted
    )
    if grown is None:
        return []
    group = f"{armature.name}_hair"
    paint = Paint(colors.hair, "hair", vertex_colors=True)
    return [
        build_object(
            group, grown.sheet, [paint], armature, surface=Surface.HAIR, ink_group=group, colors=grown.colors
        )
    ]  # fmt: skip


def _build_whiskers(
    figure: BodyFigure,
    armature: bpy.types.Object,
    look: CharacterLook,
    colors: Complexion,
    every: Expressions,
    seed: int,
) -> list[bpy.types.Object]:
    """Build the beard or moustache, if there is one."""
    if look.facial_hair not in ("moustache", "beard"):
        return []
    grown = whiskers.build_whiskers(figure, look.facial_hair, seed, every)
    return [
        build_object(
            f"{armature.name}_{look.facial_hair}",
            grown.sheet,
            [Paint(colors.hair, "hair", vertex_colors=True)],
            armature,
            surface=Surface.HAIR,
            ink_group=f"{armature.name}_hair",
            colors=np.clip(grown.shades[:, None] * np.array(colors.hair), 0, 1),
            shape_keys=grown.keys,
        )
    ]


def _build_glasses(figure: BodyFigure, armature: bpy.types.Object, look: CharacterLook) -> list[bpy.types.Object]:
    """Build the glasses, if there are any."""
    if not look.glasses:
        return []
    sheet = eyewear.build_glasses(figure)
    return [build_object(f"{armature.name}_glasses", sheet, [Paint(FRAME, "satin")], armature, surface=Surface.PROP)]


def _build_garment(figure: BodyFigure, armature: bpy.types.Object, worn: Worn) -> bpy.types.Object:
    """Build one garment; its custom property ``drapes`` says whether it lies on the lap of a seated person."""
    paints: list[Paint] = []
    sheets = []
    for bolt in worn.bolts:
        sheet = hemmed(bolt.sheet, HEM * figure.scale)
        paint = Paint(tailor.piece_color(worn.color, bolt.tint), bolt.fabric)
        if paint not in paints:
            paints.append(paint)
        sheet.slot[:] = paints.index(paint)
        sheets.append(sheet)
    name = f"{armature.name}_{worn.spec.key}"
    garment = build_object(name, join(sheets), paints, armature, surface=Surface.CLOTH)
    garment["drapes"] = tailor.hangs_below_hips(worn.spec)
    return garment
