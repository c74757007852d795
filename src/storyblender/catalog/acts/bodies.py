"""Full-body acts: bending, slipping, fighting, and acts of two people."""

from __future__ import annotations

from dataclasses import replace

from storyblender.catalog.acts import hands as at
from storyblender.catalog.acts.entry import Act, FootPose, HandPose, Key
from storyblender.catalog.motion_entry import AWAKE, UPRIGHT

_THROAT = HandPose((-0.02, 0.0, -0.20), (-0.4, 0.7, 0.5), (-0.9, 0.3, 0), (0.9, 0, -0.4), (50, 56, 20), "their_head")
_CHEEK = HandPose((0.06, -0.02, -0.04), (-0.1, 0.5, 0.8), (-1, 0.1, 0), (0.8, 0.1, -0.6), (12, 16, 0), "their_head")
_SHOULDER = HandPose(
    (0.02, -0.02, 0.055), (-0.2, 1, -0.15), (0, 0.1, -1), (0.8, 0, -0.6), (20, 26, 0), "their_shoulder"
)
_CHEST = HandPose((0.10, -0.02, -0.04), (-0.1, 0.4, 0.9), (-0.1, 1, 0), (0.8, 0, -0.5), at.FLAT, "their_chest")
_HAND = HandPose((0.0, -0.03, 0.02), (-0.3, 0.8, -0.5), (-0.8, 0.2, 0), (0.5, 0, -0.9), at.GRIP, "their_hand")

BODIES: tuple[Act, ...] = (
    Act("bend", "bend down", ("stoop", "bend forward", "double over"), (
        Key(0.7, 0.9, lead=at.KNEE, far=at.KNEE, spine=(34, 0, 0), hips=(0, -0.12, -0.05, 30), nod=(-8, 0, 0),
            gaze="down"),
    ), before=UPRIGHT),
    Act("lean_over", "lean over", ("bend over somebody", "bend over a table"), (
        Key(0.7, 1.2, lead=at.ON_TOP, far=at.ON_TOP, spine=(22, 0, 0), hips=(0, -0.08, -0.02, 18), gaze="target"),
    ), reach="thing", distance=0.5, before=AWAKE),
    Act("lean_in", "lean in", ("lean forward", "lean close"), (
        Key(0.6, 1.2, spine=(24, 0, 0), hips=(0, -0.05, -0.01, 12), nod=(-8, 0, 0), gaze="target"),
    ), before=AWAKE, directs=("lean_forward",)),
    Act("lean_back", "lean back", ("sit back",), (Key(0.6, 1.2, spine=(-14, 0, 0), nod=(6, 0, 0)),), before=AWAKE),
    Act("curtsy", "curtsy", ("make a curtsy",), (
        Key(0.7, 0.7, lead=HandPose((0.28, 0.12, -0.82), (0.2, 0.3, -0.9), (-0.6, -0.6, 0), (1, -0.4, 0), at.GRIP,
            "upright"),
            far=HandPose((0.28, 0.12, -0.82), (0.2, 0.3, -0.9), (-0.6, -0.6, 0), (1, -0.4, 0), at.GRIP, "upright"),
            spine=(8, 0, 0), hips=(0, 0, -0.14, 4), nod=(14, 0, 0), lead_foot=FootPose(-0.06, -0.30, 0.05, -34)),
    ), before=UPRIGHT),
    Act("recoil", "shrink back", ("back away", "step back"), (
        Key(0.35, 1.1, lead=at.WARDING, far=replace(at.WARDING, at=(-0.02, 0.5, -0.12)), spine=(-10, 0, -6),
            hips=(0, -0.12, -0.05, -6), face="afraid", gaze="target", lead_foot=FootPose(0.02, -0.34)),
    ), before=UPRIGHT),
    Act("cower", "cower", ("shield oneself", "duck", "protect the head"), (
        Key(0.35, 1.4, lead=replace(at.CROWN, at=(0.03, 0.06, 0.15)), far=replace(at.CROWN, at=(0.0, 0.09, 0.12)),
            spine=(34, 0, 0), hips=(0, -0.1, -0.22, 14), nod=(22, 0, 0), face="terrified"),
    ), before=UPRIGHT),
    Act("slip", "slip", ("skid", "lose one's footing"), (
        Key(0.3, 0.7, lead=at.FLUNG, far=replace(at.FLUNG, at=(0.6, -0.1, 0.35)), spine=(-20, 6, 0), nod=(8, 0, 0),
            hips=(0, -0.12, -0.12, -16), face="terrified", lead_foot=FootPose(0.02, 0.50, 0.22, 40),
            far_foot=FootPose(0, 0.12, 0, 0)),
    ), before=UPRIGHT),
    Act("trip", "trip", ("stumble over", "lose the balance"), (
        Key(0.3, 0.7, lead=at.AHEAD_DOWN, far=replace(at.FLUNG, at=(0.5, 0.5, -0.05)), spine=(26, 0, 8), nod=(-14, 0,
            0),
            hips=(0, 0.22, -0.12, 24), face="surprised", lead_foot=FootPose(0, 0.42), far_foot=FootPose(0, -0.25,
            0.12, -40)),
    ), before=UPRIGHT),
    Act("march", "march on the spot", ("parade", "stamp"), (
        Key(0.35, 0.1, lead=HandPose((0.05, 0.5, -0.75), (0, 0.8, -0.5), (-1, 0, 0), curl=at.FIST),
            far=HandPose((0.05, -0.3, -0.9), (0, -0.3, -1), (-1, 0, 0), curl=at.FIST),
            far_foot=FootPose(0, 0.28, 0.22, -10), spine=(-3, 0, 0)),
        Key(0.3, 0.0, far_foot=FootPose()),
        Key(0.35, 0.1, far=HandPose((0.05, 0.5, -0.75), (0, 0.8, -0.5), (-1, 0, 0), curl=at.FIST),
            lead=HandPose((0.05, -0.3, -0.9), (0, -0.3, -1), (-1, 0, 0), curl=at.FIST), lead_foot=FootPose(0, 0.28,
            0.22, -10)),
        Key(0.3, 0.0, lead_foot=FootPose()),
    ), again=0, stretches=True, still_key=0, before=UPRIGHT),
    Act("stamp", "stamp a foot", ("stomp", "tantrum"), (
        Key(0.3, 0.05, lead_foot=FootPose(0, 0.12, 0.24, 0), lead=at.FIST_CHEST, far=at.FIST_CHEST, face="rage"),
        Key(0.14, 0.7, lead_foot=FootPose(0, 0.12, 0, 0), spine=(8, 0, 0)),
    ), still_key=0, before=UPRIGHT),
    Act("guard", "put up the fists", ("box", "square up", "ready to fight"), (
        Key(0.45, 1.5, lead=HandPose((-0.12, 0.48, 0.02), (-0.2, 0.4, 0.9), (-0.9, -0.4, 0), (0.7, 0.1, -0.9),
            at.FIST),
            far=HandPose((-0.12, 0.66, 0.06), (-0.2, 0.5, 0.85), (-0.9, -0.4, 0), (0.7, 0.1, -0.9), at.FIST),
            spine=(10, 0, 12), hips=(0, 0, -0.06, 4), face="angry", gaze="target",
            far_foot=FootPose(0.04, 0.20), lead_foot=FootPose(0.06, -0.18)),
    ), before=UPRIGHT, stays=True),
    Act("punch", "punch", ("box", "strike", "uppercut"), (
        Key(0.35, 0.05, lead=HandPose((0.16, 0.30, -0.34), (-0.1, 0.9, 0.2), (-1, 0, 0), (0.6, -0.5, -0.7), at.FIST),
            far=HandPose((-0.12, 0.52, -0.05), (-0.2, 0.5, 0.85), (-0.9, -0.4, 0), (0.7, 0.1, -0.9), at.FIST),
            spine=(2, 0, 22), hips=(0, -0.04, -0.05, 0), face="rage", gaze="target",
            far_foot=FootPose(0.03, 0.2), lead_foot=FootPose(0.05, -0.2)),
        Key(0.2, 0.7, lead=HandPose((-0.03, -0.10, -0.06), (-0.1, 1, 0.1), (-1, 0, -0.1), (0.7, 0, -0.4), at.FIST,
            "their_head"),
            spine=(14, 0, -20), hips=(0, 0.08, -0.06, 6)),
    ), reach="person", distance=0.72, before=UPRIGHT, partner=(
        Key(0.5, 0.0), Key(0.2, 0.7, spine=(-18, 10, 14), nod=(-14, 8, 30), face="pained", hips=(0, -0.08, -0.04,
            -8),
                            lead=at.FLUNG, lead_foot=FootPose(0.02, -0.28)),
    )),
    Act("slap", "slap", ("smack", "box somebody's ears"), (
        Key(0.35, 0.05, lead=HandPose((0.42, 0.42, 0.10), (0.1, 0.5, 0.8), (-0.9, 0.4, 0), (0.4, -0.3, -0.9), at.FLAT),
            spine=(0, 0, 20), face="angry", gaze="target"),
        Key(0.24, 0.8, lead=_CHEEK, spine=(6, 0, -12)),
    ), reach="person", distance=0.62, partner=(
        Key(0.5, 0.0), Key(0.2, 0.8, spine=(0, 4, 8), nod=(4, 10, 38), face="pained"),
    )),
    Act("choke", "choke somebody", ("strangle", "throttle"), (
        Key(0.5, 0.4, lead=_THROAT, far=_THROAT, spine=(10, 0, 0), face="rage", gaze="target", hips=(0, 0.04, -0.04,
            6)),
        Key(0.2, 0.1, spine=(14, 2, 0)), Key(0.2, 0.1, spine=(10, -2, 0)),
    ), again=1, stretches=True, still_key=0, reach="person", distance=0.6, partner=(
        Key(0.5, 2.0, lead=at.HEART, far=at.HEART, spine=(-12, 0, 0), nod=(-16, 0, 0), face="terrified"),
    )),
    Act("grab", "grab somebody", ("seize", "hold by the arm", "collar", "restrain"), (
        Key(0.4, 1.4, lead=_SHOULDER, far=_SHOULDER, spine=(8, 0, 0), face="angry", gaze="target"),
    ), reach="person", distance=0.6, partner=(Key(0.4, 1.4, spine=(-6, 0, 0), face="afraid"),),
    directs=("shake_person",)),
    Act("push_away", "push somebody away", ("shove", "thrust back"), (
        Key(0.4, 0.1, lead=_CHEST, far=_CHEST, spine=(4, 0, 0), face="angry", gaze="target"),
        Key(0.3, 0.7, lead=at.AHEAD_DOWN, far=at.AHEAD_DOWN, spine=(18, 0, 0), hips=(0, 0.08, -0.05, 8),
            lead_foot=FootPose(0, 0.25)),
    ), reach="person", distance=0.6, before=UPRIGHT, partner=(
        Key(0.45, 0.0), Key(0.35, 0.7, lead=at.FLUNG, far=at.FLUNG, spine=(-18, 0, 0), hips=(0, -0.2, -0.06, -10),
                            face="surprised", lead_foot=FootPose(0.02, -0.42), far_foot=FootPose(0, -0.12)),
    )),
    Act("comfort", "put an arm around somebody", ("console", "pat the shoulder"), (
        Key(0.6, 1.4, lead=_SHOULDER, spine=(6, 0, 4), nod=(6, 6, 0), face="tender", gaze="target"),
    ), reach="person", distance=0.55, directs=("console",)),
    Act("caress", "touch somebody's cheek", ("stroke the face", "cup the face"), (
        Key(0.7, 1.5, lead=replace(_CHEEK, at=(0.075, -0.015, -0.05)), spine=(4, 0, 4), face="tender", gaze="target"),
    ), reach="person", distance=0.55),
    Act("whisper_to", "whisper in somebody's ear", ("tell a secret",), (
        Key(0.6, 1.6, lead=HandPose((0.06, 0.11, -0.08), (-0.2, 0.3, 0.95), (-0.9, 0.2, 0), (0.7, 0.2, -0.8), (14,
            18, 0),
                                    "head"), spine=(16, -6, 8), gaze="target"),
    ), reach="person", distance=0.42),
    Act("hold_hands", "hold hands", ("take by the hand", "hand in hand"), (
        Key(0.6, 1.8, lead=_HAND, gaze="target"),
    ), reach="person", distance=0.55, stays=True),
    Act("lead", "lead by the hand", ("drag along", "pull along by the wrist"), (
        Key(0.6, 1.4, lead=replace(_HAND, at=(0.0, -0.05, 0.03)), spine=(8, 0, -14), hips=(0, 0.10, -0.04, 4),
            lead_foot=FootPose(0, 0.05), far_foot=FootPose(0, -0.25, 0, 0)),
    ), reach="person", distance=0.7),
    Act("high_five", "slap hands", ("high five",), (
        Key(0.5, 0.8, lead=replace(at.PALM_OUT, at=(-0.05, 0.75, 0.4)), face="laugh", gaze="target"),
    ), reach="person", distance=0.8, partner=(
        Key(0.5, 0.8, lead=replace(at.PALM_OUT, at=(-0.05, 0.75, 0.4)), face="laugh", gaze="target"),
    )),
    Act("tickle", "tickle", ("tease",), (
        Key(0.4, 0.2, lead=replace(_CHEST, at=(0.14, -0.02, -0.22)), far=replace(_CHEST, at=(0.14, -0.02, -0.2)),
            spine=(12, 0, 0), face="laugh", gaze="target"),
        Key(0.15, 0.0, lead=replace(_CHEST, at=(0.16, -0.03, -0.18))),
        Key(0.15, 0.0, lead=replace(_CHEST, at=(0.14, -0.02, -0.22))),
    ), again=1, stretches=True, still_key=0, reach="person", distance=0.6,
        partner=(Key(0.4, 1.4, lead=at.BELLY, far=at.BELLY, spine=(16, 8, 0), face="laugh"),)),
    Act("feed", "feed somebody", ("spoon-feed",), (
        Key(0.7, 1.3, lead=HandPose((0.02, -0.13, -0.10), (-0.2, 0.9, 0.2), (-0.8, 0, 0.3), (0.8, 0, -0.6), at.GRIP,
                                    "their_head"), spine=(8, 0, 6), gaze="target"),
    ), reach="person", distance=0.6, partner=(Key(0.6, 1.2, face="surprised"),)),
    Act("comb", "comb or brush hair", ("brush the hair", "do the hair"), (
        Key(0.6, 0.3, lead=at.CROWN, nod=(4, 8, 0)), Key(0.6, 0.2, lead=at.TEMPLE, nod=(4, 8, 0)),
    ), again=0, stretches=True, still_key=1),
    Act("shave", "shave", ("apply make-up", "powder the face", "brush the teeth"), (
        Key(0.5, 0.3, lead=replace(at.CHEEK, curl=at.GRIP), nod=(-8, 4, 8)),
        Key(0.4, 0.2, lead=replace(at.CHEEK, at=(0.06, 0.07, -0.10), curl=at.GRIP)),
    ), again=0, stretches=True, still_key=0, directs=("make_up",)),
    Act("adjust_clothes", "straighten one's clothes", ("tie a tie", "button a coat", "adjust a collar"), (
        Key(0.5, 0.6, lead=HandPose((-0.30, 0.30, -0.06), (-0.4, 0.1, 0.9), (-0.4, -0.9, 0), (0.8, 0, -0.6), (45, 50,
            15)),
            far=HandPose((-0.30, 0.31, -0.14), (-0.4, 0.1, 0.9), (-0.4, -0.9, 0), (0.8, 0, -0.6), (45, 50, 15)),
            nod=(10, 0, 0)),
        Key(0.4, 0.5, lead=HandPose((-0.28, 0.31, -0.30), (-0.5, 0.3, 0.6), (-0.3, -0.9, 0), (0.8, 0, -0.6), (45, 50,
            15)),
            far=HandPose((-0.30, 0.31, -0.36), (-0.5, 0.3, 0.6), (-0.3, -0.9, 0), (0.8, 0, -0.6), (45, 50, 15))),
    ), still_key=0, directs=("button", "tie_clothes")),
    Act("tie_shoe", "tie a shoe", ("lace the boots",), (
        Key(0.8, 1.6, lead=replace(at.FLOOR, at=(-0.03, 0.36, 0.12), curl=at.GRIP),
            far=replace(at.FLOOR, at=(0.12, 0.36, 0.12), curl=at.GRIP), spine=(40, 0, 0), hips=(0, -0.05, -0.42, 26),
            nod=(6, 0, 0), gaze="hands", far_foot=FootPose(0, 0.18), lead_foot=FootPose(0.02, -0.16, 0.04, -36)),
    ), before=UPRIGHT),
)  # fmt: skip
"""Full-body acts, alone and with a partner."""
