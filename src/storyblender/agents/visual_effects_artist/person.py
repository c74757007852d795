"""One person of the scene as the Animator sees them: place, posture, hands, as of the cue written last. Pure."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from storyblender.geometry.paths import Vec2
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.scene_context import Spot
from storyblender.memory.shot_context import Mark
from storyblender.memory.vocabulary import Grip, Hand, Posture

SEATED: tuple[Posture, ...] = ("sit", "lie", "asleep")


@dataclass
class Person:
    """Somebody of the scene, as of the cue written last."""

    asset_id: str
    k: float
    place: Vec2 = (0.0, 0.0)
    yaw: float = 0.0
    posture: Posture = "stand"
    support: str | None = None
    anchor: str = ""
    held: dict[Hand, str] = field(default_factory=dict)
    on_body: dict[str, Grip] = field(default_factory=dict)
    """What is carried in no hand, and how: under the arm, in the mouth, worn."""
    present: bool = False
    busy: float = 0.0
    """Second of the shot until which the body acts."""
    acted: bool = False
    """Has moved in this shot: the start mark stands."""
    entering: bool = False
    """Comes in through a door as the shot begins."""
    pace: str = ""
    """How the next way is gone, where the script said so before it said where to."""

    z: float = 0.0
    """Height of the feet above the floor, metres."""
    spot: Spot | None = None
    """The spot of the script that they were last brought to."""
    activity: str = ""
    """Lasting motion, kept from shot to shot until it changes."""
    told: str = ""
    """The last activity in the script."""
    opened: str = ""
    """What they have opened in this shot without taking it in hand."""

    @property
    def upright(self) -> bool:
        """Can walk off without getting up."""
        return self.posture == "stand"

    def mark(self, **changes: object) -> Mark:
        """Return where this person is."""
        values: dict[str, object] = {
            "asset_id": self.asset_id,
            "location": (round(self.place[0], 3), round(self.place[1], 3), round(self.z, 3)),
            "yaw": round(math.degrees(self.yaw) % 360.0, 1),
            "posture": self.posture,
            "support_id": self.support,
            "anchor_name": self.anchor,
            "held": tuple(sorted(self.held.items())),
        }
        return Mark.model_validate({**values, **changes})

    def hand_of(self, prop: str) -> Hand | None:
        """Return the hand that holds a prop."""
        return next((hand for hand, held in self.held.items() if held == prop), None)

    def let_go(self, prop: str) -> None:
        """Have a thing no more, in hand or on the body."""
        self.held = {hand: held for hand, held in self.held.items() if held != prop}
        self.on_body.pop(prop, None)

    def hold_as(self, prop: str, grip: Grip | None) -> None:
        """Hold a thing as the script says: in one hand, in both, or in none if it is on the body."""
        kept: dict[Hand, str] = {hand: held for hand, held in self.held.items() if held != prop}
        wish: dict[str, tuple[Hand, ...]] = {"left": ("L",), "right": ("R",), "both": ("L", "R")}
        if grip is not None and grip not in wish:
            self.held, self.on_body[prop] = kept, grip
            return
        hands = wish.get(grip or "")
        if hands is None or len(kept) == len(self.held) or {*hands} & {*kept}:
            return
        self.held = kept
        for hand in hands:
            self.held[hand] = prop

    def free_hand(self, wish: Hand = "R") -> Hand | None:
        """Return an empty hand, the wished one first."""
        far: Hand = "L" if wish == "R" else "R"
        return next((hand for hand in (wish, far) if hand not in self.held), None)


def stature_of(asset: Asset) -> float:
    """Return somebody's height in metres."""
    if asset.canonical is not None:
        return asset.canonical.dimensions[2]
    return (asset.look.stature if asset.look else None) or 1.7
