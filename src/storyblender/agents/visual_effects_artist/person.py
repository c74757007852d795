"""One person of the scene as the Animator stages them: place, posture and hands after the last cue written."""

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
class StagedPerson:
    """A person of the scene, as of the cue written last."""

    asset_id: str
    scale: float
    """Stature over 1.7 m."""
    place: Vec2 = (0.0, 0.0)
    """Metres on the floor of the set; of a seated person, the middle of the seat's front edge."""
    yaw: float = 0.0
    """Radians, counter-clockwise; 0 faces the audience at -Y."""
    posture: Posture = "stand"
    support: str | None = None
    """Node id of the furniture that carries the person; None on the floor."""
    anchor: str = ""
    """Name of the anchor of that furniture, such as a seat."""
    held: dict[Hand, str] = field(default_factory=dict)
    """Asset id of the prop in each hand that is not empty."""
    on_body: dict[str, Grip] = field(default_factory=dict)
    """Asset ids of props carried in no hand, with the way they are carried: under the arm, in the mouth, worn."""
    present: bool = False
    busy: float = 0.0
    """Second of the shot until which the body acts."""
    acted: bool = False
    """Whether the person has moved in this shot, so that the start mark must stay."""
    entering: bool = False
    """Whether the person comes in through a door as the shot begins."""
    pace: str = ""
    """Key of the motion of the next walk, if the script gave it before the goal; empty if not."""

    goal: Vec2 | None = None
    """Floor point where the next walk is asked to end; None lets its target decide."""
    via: tuple[Vec2, ...] = ()
    """Floor points that a person set, through which the next walk of the shot goes."""
    z: float = 0.0
    """Height of the feet above the floor, metres."""
    spot: Spot | None = None
    """The spot of the script at which the person was placed last."""
    activity: str = ""
    """Lasting activity, kept from shot to shot until it changes."""
    scripted_activity: str = ""
    """The last activity in the script."""
    opened: str = ""
    """Asset id of the prop opened in this shot where it stands; empty if none."""

    watches: bool = False
    """Whether a person decided what they look at in this shot: they do not turn to who speaks."""

    @property
    def upright(self) -> bool:
        """Whether the person stands and can walk off at once."""
        return self.posture == "stand"

    def mark(self, **changes: object) -> Mark:
        """Return the mark of the person's place, posture and hands; ``changes`` replace fields of the mark."""
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
        """Return the hand that holds a prop (asset id); None if no hand does."""
        return next((hand for hand, held in self.held.items() if held == prop), None)

    def let_go(self, prop: str) -> None:
        """Remove a prop (asset id) from the hands and the body."""
        self.held = {hand: held for hand, held in self.held.items() if held != prop}
        self.on_body.pop(prop, None)

    def set_grip(self, prop: str, grip: Grip | None) -> None:
        """Move a prop (asset id) to the hands or body part of a grip; it stays if that is None or a hand is taken."""
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
        """Return an empty hand, ``wish`` if it is empty; None if both hold something."""
        far: Hand = "L" if wish == "R" else "R"
        return next((hand for hand in (wish, far) if hand not in self.held), None)


def stature_of(asset: Asset) -> float:
    """Return a character's height in metres: as measured, else as described, else 1.7."""
    if asset.canonical is not None:
        return asset.canonical.dimensions[2]
    return (look.stature if (look := asset.decided_look) else None) or 1.7
