"""Key, fill and rim for one person, from where the face looks and where the camera stands (notes 1.3)."""

from __future__ import annotations

import math

from storyblender.look.illumination import power_for
from storyblender.memory.base import Color, Vec3
from storyblender.memory.scene_context import Light, Lighting

_KEY_TURN = 0.35
"""Share of the way from where the face looks to the camera: profiles keep a lit side towards the lens."""
_SIDE_TURN = 50.0
"""Most degrees from where the face looks to a key light that comes from one side of the set."""
_KEY_ELEVATION = 36.0
_KEY_DISTANCE = 2.3
_RIM_ELEVATION = 40.0
_RIM_STRENGTH = 0.9


def face_lights(head: Vec3, face_yaw: float, camera: Vec3, lighting: Lighting, name: str) -> tuple[Light, ...]:
    """Return the three lamps of one person.

    Args:
        head: Centre of the face, world, metres.
        face_yaw: Where the face looks, degrees; 0 is -Y, counter-clockwise.
        camera: The eye, world, metres.
        lighting: Gives colours, face luminance, key to fill ratio and the side of the key.
        name: asset_id of the person.
    """
    toward_camera = math.degrees(math.atan2(camera[0] - head[0], -(camera[1] - head[1])))
    turn = (toward_camera - face_yaw + 180) % 360 - 180
    level, key_turn = lighting.face_luminance, _KEY_TURN * turn
    if lighting.key_side is not None:
        toward_side = -90.0 if lighting.key_side == "left" else 90.0
        key_turn = max(-_SIDE_TURN, min(_SIDE_TURN, (toward_side - face_yaw + 180) % 360 - 180))

    def lamp(
        role: str, yaw: float, elevation: float, distance: float, share: float, color: Color, cone: float
    ) -> Light:
        return Light.model_validate({
            "name": f"{name[:56]}_{role}",
            "kind": "SPOT",
            "role": role,
            "location": _around(head, yaw, elevation, distance),
            "target": head,
            "power": power_for(level * share, distance, color),
            "color": color,
            "size": 0.25 if role != "fill" else 0.7,
            "cone": cone,
            "blend": 1.0 if role == "key" else 0.7,
            "for_asset": name,
        })  # fmt: skip

    side = 1 if turn >= 0 else -1
    return (
        lamp("key", face_yaw + key_turn, _KEY_ELEVATION, _KEY_DISTANCE, 1.0, lighting.key_color, 60),
        lamp("fill", toward_camera + 12 * side, 8, 2.6, 1 / lighting.key_fill_ratio, lighting.fill_color, 50),
        lamp("rim", toward_camera + 180 - 35 * side, _RIM_ELEVATION, 2.4, _RIM_STRENGTH, lighting.rim_color, 34),
    )


def _around(center: Vec3, yaw: float, elevation: float, distance: float) -> Vec3:
    """Return the point at a distance in metres from a centre; degrees, yaw 0 at -Y and 90 at +X."""
    angle, height = math.radians(yaw), math.radians(elevation)
    flat = distance * math.cos(height)
    return (
        center[0] + flat * math.sin(angle),
        center[1] - flat * math.cos(angle),
        center[2] + distance * math.sin(height),
    )
