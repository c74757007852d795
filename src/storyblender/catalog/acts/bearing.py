"""Acts of bearing and small business: how a person stands, and what hands do with clothes, sticks, belts, mirrors."""

from __future__ import annotations

from dataclasses import replace

from storyblender.catalog.acts import hands as at
from storyblender.catalog.acts.entry import Act, HandPose, Key
from storyblender.catalog.motion_entry import AWAKE, UPRIGHT

_UPRIGHT_TOOL = ((0, 0, 1), (0, 1, 0))
_PINCH = (40.0, 55.0, 25.0)
_BEHIND = HandPose((-0.25, -0.40, -0.78), (-0.9, -0.1, -0.3), (0.1, -1, 0.1), (0.9, -0.8, 0), (30, 36, 10), "upright")
_THIGH = HandPose((0.04, 0.10, -1.0), (-0.1, 0.2, -1), (-1, 0, 0), (0.6, -0.6, 0), (22, 28, 5), "upright")
_BUCKLE = HandPose((-0.27, 0.33, -0.70), (-0.75, 0.6, -0.1), (0.0, -0.7, 0.5), (0.95, -0.1, -0.3), _PINCH, "upright")
_RUNG = HandPose((0.06, -0.05, 0.03), (-0.2, 0.9, 0.3), (-0.1, 0.5, -0.9), (0.8, -0.1, -0.6), (70, 76, 40), "work")

BEARING: tuple[Act, ...] = (
    Act("hands_behind_back", "hands behind the back", ("hands clasped behind", "stand at ease like a guard"), (
        Key(0.6, 1.6, lead=_BEHIND, far=replace(_BEHIND, at=(-0.27, -0.36, -0.86)), spine=(-3, 0, 0)),
    ), stays=True, before=AWAKE),
    Act("lean_on_stick", "lean on a stick in the hand", ("lean on a cane", "rest on a crutch", "lean on a spade"), (
        Key(0.7, 1.6, lead=HandPose((0.20, 0.27, 0.0), (-0.2, 0.8, -0.5), (-0.2, 0, -1), (0.9, -0.5, 0), at.GRIP,
            "planted", _UPRIGHT_TOOL), spine=(9, 7, 0), hips=(0.05, -0.01, -0.02, 3), nod=(-4, -4, 0)),
    ), stays=True, before=UPRIGHT),
    Act("push_back_cap", "push the cap back on the head", ("tip back a hat", "cap pushed back"), (
        Key(0.5, 0.3, lead=at.BRIM, nod=(2, 0, 0)),
        Key(0.3, 1.0, lead=replace(at.BRIM, at=(0.05, 0.10, 0.125), fingers=(-0.4, -0.2, 0.9)), nod=(-10, 4, 0),
            spine=(-5, 0, 0)),
    )),
    Act("peer_through", "stoop to look through or into something", ("stoop to read", "look through a low window",
        "peer under", "bend to a keyhole"), (
        Key(0.7, 1.5, lead=at.KNEE, far=at.KNEE, spine=(30, 0, 0), hips=(0, -0.13, -0.07, 30), nod=(-30, 0, 0),
            gaze="target", face="thoughtful"),
    ), before=UPRIGHT),
    Act("grip_rail", "grip a rung, a rail or a bar", ("hold on to a railing", "hand on the banister"), (
        Key(0.6, 1.6, lead=_RUNG, spine=(6, 0, 0)),
    ), reach="thing", distance=0.45, stays=True, before=AWAKE),
    Act("bid", "raise a paddle or a card to bid", ("bid at an auction", "hold up a number"), (
        Key(0.5, 1.4, lead=HandPose((0.38, 0.30, 0.40), (0, 0.3, 1), (-0.7, 0.7, 0), (1, -0.1, -0.6), at.GRIP,
            "upright"), spine=(-2, 0, 4), gaze="target"),
    ), before=AWAKE),
    Act("adjust_mirror", "adjust a mirror", ("tilt the rear-view mirror", "turn a mirror"), (
        Key(0.6, 1.2, lead=HandPose((-0.20, 0.74, 0.30), (-0.35, 0.5, 0.8), (-0.5, 0.8, -0.1), (0.7, 0.1, -0.8),
            _PINCH), spine=(4, 0, 6), nod=(-6, 0, -8), gaze="hands"),
        Key(0.4, 0.6, lead=HandPose((-0.16, 0.76, 0.34), (-0.55, 0.5, 0.7), (-0.5, 0.8, -0.1), (0.7, 0.1, -0.8),
            _PINCH)),
    ), still_key=0, before=AWAKE),
    Act("buckle_belt", "buckle a belt round the waist", ("fasten a belt", "do up the trousers"), (
        Key(0.6, 0.8, lead=_BUCKLE, far=replace(_BUCKLE, at=(-0.25, 0.34, -0.72)), spine=(6, 0, 0), nod=(22, 0, 0),
            gaze="down"),
        Key(0.3, 0.6, lead=replace(_BUCKLE, at=(-0.20, 0.34, -0.71))),
    ), still_key=0, before=AWAKE),
    Act("buckle_up", "fasten a seat belt", ("buckle up", "strap oneself in", "undo the seat belt"), (
        Key(0.6, 0.2, lead=HandPose((0.12, 0.16, 0.04), (-0.5, -0.3, 0.8), (-0.6, -0.7, 0), (0.9, 0.2, -0.4), _PINCH),
            nod=(0, 6, 24), spine=(0, 0, 8)),
        Key(0.6, 1.2, lead=HandPose((-0.56, 0.22, -0.78), (-0.7, 0.3, -0.7), (-0.2, -0.6, -0.3), (0.7, 0.3, -0.5),
            _PINCH), nod=(20, 0, -16), spine=(6, 0, -8), gaze="hands"),
    ), before=AWAKE),
    Act("strike_match", "light a match", ("strike a match", "flick a lighter"), (
        Key(0.5, 0.2, lead=HandPose((-0.27, 0.48, -0.28), (-0.6, 0.6, 0.4), (-0.5, -0.6, 0.2), curl=_PINCH),
            far=HandPose((-0.25, 0.46, -0.32), (-0.6, 0.6, 0.3), (-0.4, -0.4, 0.7), curl=_PINCH), nod=(14, 0, 0),
            gaze="hands"),
        Key(0.25, 1.3, lead=HandPose((-0.20, 0.50, -0.06), (-0.45, 0.5, 0.75), (-0.6, -0.6, 0.1), curl=_PINCH),
            far=HandPose((-0.26, 0.42, -0.28), (-0.6, 0.6, 0.3), (-0.4, -0.4, 0.7), curl=_PINCH), nod=(8, 0, 0)),
    ), before=AWAKE),
    Act("lower_weapon", "lower a weapon", ("lower the gun", "point it at the ground", "stand down"), (
        Key(0.7, 1.4, lead=HandPose((0.06, 0.22, -0.92), (-0.1, 0.5, -0.85), (-1, 0, 0), (0.6, -0.6, -0.3), at.GRIP,
            "upright", ((0, 0.85, 0.5), (-0.1, 0.5, -0.85))), far=_THIGH, spine=(2, 0, 0), hips=(0, 0, 0, 0)),
    ), stays=True, before=AWAKE),
    Act("shoulder", "carry a long thing on the shoulder", ("shoulder a ladder", "with a plank on the shoulder"), (
        Key(0.8, 1.6, lead=HandPose((0.10, 0.26, 0.14), (-0.4, 0.4, 0.8), (-0.6, 0.2, -0.7), (0.9, 0.2, -0.5),
            at.GRIP, "upright", ((0, 1, 0.08), (1, 0, 0))), spine=(0, -4, 0), nod=(0, -6, 0)),
    ), stays=True, before=UPRIGHT),
)  # fmt: skip
"""Acts of bearing and business."""
