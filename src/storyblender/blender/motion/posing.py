"""What poses a character or a thing besides its keys: constraints, switches of controls, bones that are not keyed."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator

import bpy

from storyblender.blender.motion.baked import bag_of, bags_of
from storyblender.blender.people.control_rig import SWITCHES

_DIGITS = 4


def posing_of(obj: bpy.types.Object) -> str:
    """Return a digest of what poses an object besides its keys; what is keyed is another at every frame.

    Args:
        obj: The object; it need not be evaluated.
    """
    return hashlib.sha256("\n".join(_facts(obj, _keyed(obj))).encode()).hexdigest()[:16]


def _keyed(obj: bpy.types.Object) -> set[str]:
    """Return the paths of all properties that are animated or driven."""
    data = obj.animation_data
    own = bag_of(data.action, data.action_slot) if data is not None else None
    paths = {curve.data_path for bag in (*bags_of(obj), own) if bag is not None for curve in bag.fcurves}
    return paths | ({curve.data_path for curve in data.drivers} if data is not None else set())


def _facts(obj: bpy.types.Object, keyed: set[str]) -> Iterator[str]:
    yield from _constraints(obj, "", keyed)
    for name in SWITCHES:
        if name in obj and f'["{name}"]' not in keyed:
            yield f"{name} {round(float(obj[name]), _DIGITS) + 0.0}"
    for bone in obj.pose.bones if obj.type == "ARMATURE" else ():
        path = bone.path_from_id()
        yield from _constraints(bone, f"{path}.", keyed)
        for name in ("location", f"rotation_{bone.rotation_mode.lower()}", "scale"):
            if f"{path}.{name}" not in keyed and hasattr(bone, name):
                values = [round(value, _DIGITS) + 0.0 for value in getattr(bone, name)]
                yield f"{bone.name} {name} {values}"


def _constraints(owner: bpy.types.Object | bpy.types.PoseBone, path: str, keyed: set[str]) -> Iterator[str]:
    for each in owner.constraints:
        target, bone = getattr(each, "target", None), getattr(each, "subtarget", "")
        driven = f'{path}constraints["{each.name}"].influence' in keyed
        influence = "" if driven else round(each.influence, _DIGITS)
        yield f"{path}{each.name} {each.type} {each.mute} {target and target.name} {bone} {influence}"
