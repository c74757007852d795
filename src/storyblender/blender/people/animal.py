"""Anthropomorphic animals: an animal's head, coat and tail on a person's body and rig."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import bpy
import numpy as np

from storyblender.blender.people import animal_coat, animal_eyes, animal_growths, animal_heads
from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.figure import ADULT_HEAD, BodyFigure
from storyblender.blender.people.pack import BodyPack
from storyblender.blender.people.parts import Paint, build_object
from storyblender.blender.people.sheet import join
from storyblender.blender.people.solids import bar
from storyblender.blender.people.tailor import Worn
from storyblender.blender.tags import Surface
from storyblender.catalog.bodies import mix, recipe, typical_stature
from storyblender.catalog.materials import hex_color
from storyblender.catalog.skeleton import SKELETON
from storyblender.catalog.species import Species
from storyblender.geometry.solids import Floats
from storyblender.memory.asset_sheet import CharacterLook
from storyblender.memory.base import Color

_PUPIL, _WHITE, _GLINT = (0.005, 0.005, 0.005), (0.72, 0.70, 0.66), (1.0, 1.0, 1.0)
_FRAME = (0.012, 0.010, 0.009)
_SMALL = 1.0
"""Height in metres below which an animal gets the proportions of a child."""


class AnimalBody:
    """The body of an animal, before it is dressed.

    Args:
        pack: The body data.
        species: Species of the animal.
        look: Casting words.
        seed: Seed of the variation between individuals.

    Attributes:
        figure: Body for the tailor, with an animal skull instead of a person's head.
        joints: Positions of all joints of the rig, metres.
    """

    def __init__(self, pack: BodyPack, species: Species, look: CharacterLook, seed: int) -> None:
        self.species = species
        self.coat: Color = look.hair_color or hex_color(species.coat)
        wanted = look.stature or species.height
        age = 9.0 if wanted < _SMALL else 14.0 if wanted < 1.25 else 30.0
        build = look.build if look.build != "average" else species.build
        gender = look.gender if wanted >= _SMALL else "male"
        shape = look.model_copy(update={"age": age, "build": build, "gender": gender, "stature": None})
        natural = replace(recipe(shape, seed), stature=typical_stature(gender, age))
        points = pack.shape(natural)
        points *= wanted / natural.stature
        neck = pack.joint(points, "neck")
        scale = (wanted - float(neck[2])) / ADULT_HEAD
        places = {"neck": neck, "l-eye": pack.joint(points, "l-eye")}
        self.center, self.radius = animal_heads.place_skull(points, places, species, scale)
        self.figure = BodyFigure(pack, animal_heads.replace_head(pack.points, points, self.center, self.radius))
        self.head = animal_heads.build_head(self.figure, species, self.coat, self.center, self.radius)
        animal_growths.add_growths(self.head)
        self.joints = self._joints()

    def _joints(self) -> dict[str, Floats]:
        """Return the joint positions in metres, with eyes, mouth and chin moved to the animal's."""
        joints = {name: self.figure.joint(name) for bone in SKELETON for name in (bone.head, bone.tail)}
        skull = self.head.skull
        for side, eye in animal_heads.eye_centers(self.head).items():
            joints[f"{side.lower()}-eye"] = eye
            joints[f"{side.lower()}-eye-target"] = eye - (0.0, 0.03, 0.0)
        joints["mouth"] = self.head.to_metres((0.0, -0.1, -0.35))
        joints["jaw"] = self.head.to_metres((0.0, -0.7, min(-0.72, float(skull.tip[2]) - 0.8 * skull.thick)))
        joints["head-2"] = self.head.to_metres((0.0, 0.0, 0.95))
        return joints

    def build(self, armature: bpy.types.Object, wardrobe: Sequence[Worn], *, glasses: bool) -> list[bpy.types.Object]:
        """Return the mesh objects of the animal without its clothes.

        Args:
            armature: Armature that deforms the objects.
            wardrobe: Garments that cover the coat.
            glasses: Whether to add glasses.
        """
        group = f"{armature.name}_skin"
        painted = [Paint(self.coat, self.species.finish, vertex_colors=True)]
        sheet, colors, keys = self.head.joined()
        made = [
            build_object(f"{armature.name}_head", sheet, painted, armature, surface=Surface.SKIN, ink_group=group,
                         colors=colors, shape_keys=keys),
            self._eyes(armature, group),
        ]  # fmt: skip
        fur, colors = animal_coat.build_coat(self.figure, self.species, self.coat, wardrobe)
        made.append(build_object(group, fur, painted, armature, surface=Surface.SKIN, ink_group=group, colors=colors))
        tail = animal_coat.build_tail(self.figure, self.species, self.coat)
        if tail is not None:
            name = f"{armature.name}_tail"
            made.append(
                build_object(name, tail[0], painted, armature, surface=Surface.HAIR, ink_group=name, colors=tail[1])
            )
        return [*made, *([self._glasses(armature)] if glasses else [])]

    def _eyes(self, armature: bpy.types.Object, group: str) -> bpy.types.Object:
        """Build the eyeballs."""
        radius = self.head.skull.eye * self.radius
        sheet = animal_eyes.eyeballs(animal_heads.eye_centers(self.head), radius)
        iris = hex_color(self.species.iris)
        shades = (_PUPIL, iris, mix(iris, (0, 0, 0), 0.65), _WHITE, _GLINT)
        paints = [Paint(shade, "eye") for shade in shades]
        return build_object(f"{armature.name}_eyes", sheet, paints, armature, surface=Surface.EYE, ink_group=group)

    def _glasses(self, armature: bpy.types.Object) -> bpy.types.Object:
        """Return round glasses in front of the eyes, with temples to the ears."""
        skull, thick = self.head.skull, 0.022 * self.radius
        turns = np.linspace(0, 2 * np.pi, 25)[:-1]
        x, y, z = skull.eyes
        front = y - skull.eye * 1.15
        wide = min(skull.eye * 1.45, x - 0.06)
        rings, ends = [], []
        for side in (1, -1):
            rim = np.stack([side * x + wide * np.cos(turns), 0 * turns + front, z + 1.1 * wide * np.sin(turns)], 1)
            rings.append(bar(self.head.to_metres(rim), thick, bone_weights("head"), closed=True))
            arm = [(side * (x + wide), front, z), (side * 0.98, -0.3, z), (side * 0.95, 0.15, z)]
            rings.append(bar(self.head.to_metres(arm), thick, bone_weights("head")))
            ends.append((side * (x - wide), front, z))
        rings.append(bar(self.head.to_metres(ends), thick, bone_weights("head")))
        return build_object(
            f"{armature.name}_glasses", join(rings), [Paint(_FRAME, "satin")], armature, surface=Surface.PROP
        )
