"""One morphed body for the tailor: joints, landmarks, limb coordinates, and the scalar fields that cut cloth.

A field has one value per vertex of a sheet, positive inside and roughly in metres. It is evaluated where the vertices
lay on the bare body (``Sheet.skin``), so the same field cuts a garment, hides the skin below it and the shirt under a
jacket.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.people.pack import PARTS, BodyPack
from storyblender.blender.people.sheet import Sheet
from storyblender.catalog.cuts import GarmentOpening, Level
from storyblender.catalog.skeleton import columns
from storyblender.geometry.solids import Floats

FAR = 0.1
"""Value of a field far inside; its negative is far outside."""
ADULT_HEAD = 0.225
"""Metres from the neck joint to the crown of an adult of 1.70 m."""


class BodyFigure:
    """A morphed body and the fields of the tailor.

    Args:
        pack: The body data.
        points: (V, 3) all vertices of the morphed base mesh, metres, soles at z = 0, facing -Y.
    """

    def __init__(self, pack: BodyPack, points: Floats) -> None:
        self.pack = pack
        self.points = points
        self.stature = float(points[PARTS["skin"], 2].max())
        self.scale = self.stature / 1.7
        """Stature over 1.7 m; multiplies lengths authored for 1.70 m (local variable ``k``)."""
        self._joints: dict[str, Floats] = {}

    def joint(self, name: str) -> Floats:
        """Return the position of a joint of the body pack, metres; read-only and cached."""
        if name not in self._joints:
            self._joints[name] = self.pack.joint(self.points, name)
            self._joints[name].flags.writeable = False
        return self._joints[name]

    @cached_property
    def head_scale(self) -> float:
        """Size of the head relative to an adult's; children have larger heads for their height."""
        return float(self.stature - self.joint("neck")[2]) / ADULT_HEAD

    @cached_property
    def heights(self) -> dict[str, float]:
        """Height of each landmark that garments name, metres."""
        z = {name: float(self.joint(name)[2]) for name in (
            "l-ankle", "l-knee", "l-upper-leg", "pelvis", "spine-4", "spine-3", "spine-2", "spine-1", "neck",
        )}  # fmt: skip
        return {
            "sole": 0.0,
            "ankle": z["l-ankle"],
            "knee": z["l-knee"],
            "crotch": z["l-upper-leg"] - 0.055 * self.scale,
            "hip": z["pelvis"],
            "belt": 0.7 * z["spine-3"] + 0.3 * z["spine-4"],
            "waist": z["spine-3"],
            "ribs": z["spine-2"],
            "chest": z["spine-1"],
            "neck": z["neck"],
        }

    def height(self, level: Level) -> float:
        """Return the height in metres of a level such as ``("knee", -0.02)``: landmark and offset."""
        landmark, offset = level
        return self.heights[landmark] + offset * self.scale

    def part(self, name: str) -> Sheet:
        """Return one part of the base mesh (a key of ``PARTS``) as a new sheet."""
        span = PARTS[name]
        first = self.pack.faces[:, 0]
        faces = self.pack.faces[(first >= span.start) & (first < span.stop)] - span.start
        points = self.points[span]
        source = np.arange(span.start, span.stop)
        sheet = Sheet(
            points.copy(),
            faces,
            self.pack.weights[span],
            self.pack.points[span],
            points,
            source,
            np.zeros(len(faces), np.int64),
        )
        return sheet.keep_faces(np.ones(len(faces), bool))

    def arm_share(self, sheet: Sheet) -> Floats:
        """Return the share of each vertex's weights on the arms, (V,) 0..1."""
        limbs = columns("upper_arm", "forearm", "hand", "thumb", "index1", "index2", "fingers1", "fingers2")
        return sheet.weights[:, limbs].sum(1)

    def along_arm(self, sheet: Sheet) -> tuple[Floats, Floats]:
        """Return the place along the arm, (V,) 0 shoulder, 1 elbow, 2 wrist, and the vector (V, 3) from its axis."""
        place = np.zeros(len(sheet.points))
        radial = np.zeros((len(sheet.points), 3))
        for side in "lr":
            shoulder, elbow, wrist = (self.joint(f"{side}-{name}") for name in ("shoulder", "elbow", "hand"))
            upper, fore = elbow - shoulder, wrist - elbow
            on_upper = (sheet.skin - shoulder) @ upper / (upper @ upper)
            on_fore = (sheet.skin - elbow) @ fore / (fore @ fore)
            axis = np.where(
                (on_upper > 1)[:, None], elbow + np.outer(on_fore, fore), shoulder + np.outer(on_upper, upper)
            )
            mine = sheet.base[:, 0] * (1 if side == "l" else -1) > 0
            place = np.where(mine, np.minimum(on_upper, 1) + np.maximum(on_fore, 0), place)
            radial = np.where(mine[:, None], sheet.points - axis, radial)
        return place, radial

    def along_leg(self, sheet: Sheet) -> tuple[Floats, Floats]:
        """Return the place along the leg by height, (V,) 0 hip, 1 knee, 2 ankle, and the leg's axis there, (V, 3)."""
        z = sheet.points[:, 2]
        place = np.zeros(len(z))
        axis = np.zeros((len(z), 3))
        for side in "lr":
            hip, knee, ankle = (self.joint(f"{side}-{name}") for name in ("upper-leg", "knee", "ankle"))
            upper = z > knee[2]
            t = np.where(upper, (hip[2] - z) / (hip[2] - knee[2]), 1 + (knee[2] - z) / (knee[2] - ankle[2]))
            line = np.where(upper[:, None], hip + np.outer(t, knee - hip), knee + np.outer(t - 1, ankle - knee))
            mine = sheet.base[:, 0] * (1 if side == "l" else -1) > 0
            place = np.where(mine, t, place)
            axis = np.where(mine[:, None], line, axis)
        axis[:, 2] = z
        return place, axis

    def inside_sleeve(self, sheet: Sheet, end: float) -> Floats:
        """Return the field of the trunk, and of the arms down to ``end`` (0 shoulder, 1 elbow, 2 wrist)."""
        place, _ = self.along_arm(sheet)
        arm = self.arm_share(sheet)
        return np.where(arm > 0.02, (end - place) * 0.28 * self.scale, FAR) + FAR * np.clip((0.4 - arm) / 0.35, 0, 1)

    def below(self, sheet: Sheet, height: float) -> Floats:
        """Return the field below ``height`` metres; the arms, which hang past the hips, are outside."""
        return np.where(self.arm_share(sheet) > 0.4, -FAR, height - sheet.skin[:, 2])

    def above(self, sheet: Sheet, height: float) -> Floats:
        """Return the field above ``height`` metres; the arms are inside."""
        return np.where(self.arm_share(sheet) > 0.4, FAR, sheet.skin[:, 2] - height)

    def up_neck(self, sheet: Sheet) -> Floats:
        """Return the distance of each vertex above the base of the neck along the neck, (V,) metres."""
        base = self.joint("neck")
        axis = self.joint("head") - base
        return (sheet.skin - base) @ (axis / np.linalg.norm(axis))

    def below_neck(self, sheet: Sheet, height: float) -> Floats:
        """Return the field on a sheet below a neckline ``height`` metres (at 1.70 m) up the neck."""
        return height * self.scale - self.up_neck(sheet)

    def is_front(self, sheet: Sheet) -> NDArray[np.bool_]:
        """Return which vertices lie in front of the neck's axis, (V,)."""
        return sheet.skin[:, 1] < self.joint("neck")[1] - 0.01 * self.scale

    def beside_opening(self, sheet: Sheet, opening: GarmentOpening) -> Floats:
        """Return the field beside a neckline's opening in front: a V, or a gap down to the hem."""
        bottom, top = self.height(opening.bottom), self.heights["neck"]
        z = sheet.skin[:, 2]
        width = (opening.width * np.clip((z - bottom) / (top - bottom), 0, 1.15) + opening.gap) * self.scale
        if not opening.gap:  # closed below the V
            width = width - np.maximum(bottom - z, 0)
        # Towards the shoulder's ridge the opening closes in a curve.
        depth = np.clip((self.joint("neck")[1] - 0.01 * self.scale - sheet.skin[:, 1]) / (0.035 * self.scale), 0, 1)
        return np.where(
            self.is_front(sheet), np.abs(sheet.skin[:, 0]) - width * np.where(width > 0, np.sqrt(depth), 1), 0.05
        )
