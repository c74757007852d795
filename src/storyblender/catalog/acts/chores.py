"""Acts with tools and objects: kitchen, workshop, garden, desk."""

from __future__ import annotations

from dataclasses import replace

from storyblender.catalog.acts import hands as at
from storyblender.catalog.acts.entry import Act, FootPose, HandPose, Key
from storyblender.catalog.motion_entry import UPRIGHT


def _at_work(place: tuple[float, float, float], *, tool: tuple | None = None, curl: tuple = at.GRIP) -> HandPose:
    """Return a hand pose over the work piece, holding a tool."""
    return HandPose(place, (-0.35, 0.9, -0.3), (-0.6, 0, -0.7), (0.8, 0.1, -0.5), curl, "work", tool)


_DOWN = ((0, -0.5, 0.85), (0, 0.85, 0.5))
"""Tool directions (top, front): top up and slightly back."""
_BLADE = ((0, 0.1, 1), (-0.2, 0.9, -0.35))
"""Tool directions of a knife: blade forward and down."""
_STRUCK = ((0, 1, 0.15), (0, 0, -1))
"""Tool directions of a hammer at the moment of impact: head forward."""
_RAISED = ((0, 0.1, 1), (0, 1, 0))

CHORES: tuple[Act, ...] = (
    Act("stir", "stir", ("mix", "whisk"), (
        Key(0.6, 0.1, lead=_at_work((0.02, 0.04, 0.16), tool=((0.1, -0.35, 0.9), (0, 0.2, -1))),
            far=replace(at.STEADYING, at=(0.16, 0.02, 0.08)), spine=(6, 0, 0), gaze="hands"),
        Key(0.3, 0.0, lead=_at_work((-0.05, 0.06, 0.16), tool=((-0.1, -0.35, 0.9), (0, 0.2, -1)))),
        Key(0.3, 0.0, lead=_at_work((0.02, 0.10, 0.16), tool=((0.1, -0.25, 0.9), (0, 0.2, -1)))),
    ), again=1, stretches=True, still_key=0, reach="thing", distance=0.5, directs=("cook",)),
    Act("cut", "cut", ("slice", "chop food", "carve"), (
        Key(0.6, 0.2, lead=_at_work((0.04, 0.02, 0.09), tool=_BLADE), far=at.STEADYING, spine=(8, 0, 0), gaze="hands"),
        Key(0.25, 0.1, lead=_at_work((0.04, 0.05, 0.045), tool=_BLADE)),
        Key(0.25, 0.0, lead=_at_work((0.05, 0.01, 0.10), tool=_BLADE)),
    ), again=1, stretches=True, still_key=1, reach="thing", distance=0.5),
    Act("wash", "wash", ("wash dishes", "wash hands", "scrub", "rinse"), (
        Key(0.6, 0.2, lead=_at_work((0.03, 0.02, 0.06), curl=(30, 36, 10)), far=replace(at.STEADYING, at=(0.07, 0.04,
            0.05)),
            spine=(12, 0, 0), gaze="hands"),
        Key(0.25, 0.0, lead=_at_work((-0.03, 0.06, 0.06), curl=(30, 36, 10))),
        Key(0.25, 0.0, lead=_at_work((0.04, 0.0, 0.06), curl=(30, 36, 10))),
    ), again=1, stretches=True, still_key=0, reach="thing", distance=0.5),
    Act("knead", "knead", ("press dough", "massage"), (
        Key(0.6, 0.1, lead=replace(at.ON_TOP, at=(0.07, 0.0, 0.06)), far=replace(at.ON_TOP, at=(0.07, 0.0, 0.06)),
            spine=(14, 0, 0), hips=(0, -0.04, 0, 8), gaze="hands"),
        Key(0.35, 0.1, lead=replace(at.ON_TOP, at=(0.07, 0.1, 0.03)), far=replace(at.ON_TOP, at=(0.07, 0.1, 0.03)),
            spine=(20, 0, 0)),
        Key(0.35, 0.0, lead=replace(at.ON_TOP, at=(0.07, 0.0, 0.06)), far=replace(at.ON_TOP, at=(0.07, 0.0, 0.06)),
            spine=(14, 0, 0)),
    ), again=1, stretches=True, still_key=1, reach="thing", distance=0.45),
    Act("iron", "iron", ("press clothes",), (
        Key(0.6, 0.1, lead=_at_work((0.1, 0.0, 0.10), tool=((0, 0, 1), (0, 1, 0))), far=at.STEADYING, spine=(10, 0,
            0), gaze="hands"),
        Key(0.5, 0.1, lead=_at_work((-0.12, 0.05, 0.10), tool=((0, 0, 1), (0, 1, 0)))),
        Key(0.5, 0.0, lead=_at_work((0.1, 0.0, 0.10), tool=((0, 0, 1), (0, 1, 0)))),
    ), again=1, stretches=True, still_key=1, reach="thing", distance=0.5),
    Act("sweep", "sweep", ("mop", "rake", "vacuum"), (
        Key(0.6, 0.1, lead=HandPose((-0.06, 0.42, -0.42), tool=((0.12, -0.45, 0.9), (0, 1, 0.3)), curl=at.GRIP),
            spine=(14, 0, 8), hips=(0, 0, -0.03, 4), gaze="down", far_foot=FootPose(0.02, 0.18)),
        Key(0.55, 0.1, lead=HandPose((-0.14, 0.30, -0.36), tool=((-0.2, -0.35, 0.9), (0.2, 1, 0.3)), curl=at.GRIP),
            spine=(14, 0, -8)),
        Key(0.55, 0.0, lead=HandPose((-0.06, 0.42, -0.42), tool=((0.12, -0.45, 0.9), (0, 1, 0.3)), curl=at.GRIP),
            spine=(14, 0, 8)),
    ), again=1, stretches=True, still_key=0, before=UPRIGHT, second=-0.42),
    Act("dig", "dig", ("shovel", "spade", "bury"), (
        Key(0.7, 0.2, lead=HandPose((0.04, 0.22, 0.62), tool=((0.05, -0.45, 0.85), (0, 0.85, 0.4)), frame="ground",
            curl=at.GRIP,
                                    elbow=(0.9, -0.4, 0.3)),
            spine=(30, 0, 6), hips=(0, -0.08, -0.14, 16), gaze="down", face="tired", far_foot=FootPose(0.03, 0.30),
            lead_foot=FootPose(0.04, -0.12)),
        Key(0.6, 0.2, lead=HandPose((0.12, 0.18, 0.86), tool=((0.25, -0.7, 0.35), (0, 0.35, 1)), frame="ground",
            curl=at.GRIP,
                                    elbow=(0.9, -0.4, 0.3)), spine=(12, 0, -14), hips=(0, -0.02, -0.08, 6)),
    ), again=0, stretches=True, still_key=0, before=UPRIGHT, second=-0.45),
    Act("hammer", "hammer", ("nail", "knock in", "forge"), (
        Key(0.5, 0.05, lead=_at_work((0.06, -0.05, 0.34), tool=_RAISED), far=replace(at.STEADYING, at=(0.10, 0.06,
            0.04)),
            spine=(8, 0, 6), gaze="hands"),
        Key(0.14, 0.2, lead=_at_work((0.05, -0.12, 0.07), tool=_STRUCK), spine=(12, 0, -2)),
    ), again=0, stretches=True, still_key=0, reach="thing", distance=0.55),
    Act("saw", "saw", ("cut wood",), (
        Key(0.6, 0.05, lead=_at_work((0.06, -0.20, 0.10), tool=_BLADE), far=replace(at.STEADYING, at=(0.16, 0.06,
            0.03)),
            spine=(20, 0, 6), hips=(0, -0.06, -0.03, 12), gaze="hands"),
        Key(0.35, 0.0, lead=_at_work((0.05, 0.04, 0.06), tool=_BLADE), spine=(24, 0, 0)),
        Key(0.35, 0.0, lead=_at_work((0.06, -0.20, 0.10), tool=_BLADE), spine=(20, 0, 6)),
    ), again=1, stretches=True, still_key=1, reach="thing", distance=0.6),
    Act("chop", "chop", ("chop wood", "axe", "hew", "hack"), (
        Key(0.7, 0.1, lead=HandPose((-0.18, 0.45, 0.55), tool=((0, -0.5, 0.8), (0, 0.8, 0.5)), curl=at.GRIP,
                elbow=(0.9, 0.3, 0.2)),
            spine=(-6, 0, 4), face="angry", gaze="down", far_foot=FootPose(0.08, 0.05), lead_foot=FootPose(0.08,
            -0.05)),
        Key(0.32, 0.5, lead=HandPose((-0.30, 0.72, -0.62), tool=((0, 0.85, -0.4), (0, -0.4, -0.9)), curl=at.GRIP,
                elbow=(0.9, 0.1, -0.2)),
            spine=(34, 0, 0), hips=(0, -0.1, -0.14, 16)),
    ), again=0, stretches=True, still_key=0, before=UPRIGHT, second=-0.16),
    Act("fix", "repair", ("mend", "tinker", "screw", "wire", "assemble"), (
        Key(0.6, 0.4, lead=_at_work((0.05, 0.0, 0.05), tool=_BLADE), far=replace(at.STEADYING, at=(0.09, 0.03, 0.04)),
            spine=(14, 0, 0), face="thoughtful", gaze="hands"),
        Key(0.3, 0.2, lead=_at_work((0.03, 0.02, 0.05), tool=_BLADE)),
    ), again=0, stretches=True, still_key=0, reach="thing", distance=0.5, directs=("repair",)),
    Act("sew", "sew", ("knit", "stitch", "embroider", "darn"), (
        Key(0.6, 0.3, lead=HandPose((-0.20, 0.46, -0.36), (-0.6, 0.6, 0.4), (-0.5, -0.7, 0.2), curl=(45, 50, 20)),
            far=HandPose((-0.24, 0.44, -0.42), (-0.7, 0.6, 0.2), (-0.3, -0.5, 0.8), curl=(40, 45, 15)), spine=(8, 0,
            0),
            nod=(14, 0, 0), gaze="hands"),
        Key(0.45, 0.1, lead=HandPose((0.05, 0.52, -0.16), (-0.4, 0.6, 0.7), (-0.5, -0.7, 0.2), curl=(45, 50, 20))),
    ), again=0, stretches=True, still_key=1),
    Act("paint", "paint", ("paint a picture", "at an easel", "brush colour on"), (
        Key(0.6, 0.4, lead=HandPose((-0.10, 0.92, 0.06), (-0.3, 0.9, 0.3), (-0.8, 0, -0.4), curl=(45, 52, 20),
                                    tool=((0, 0.9, 0.4), (0, 0.4, -0.9))),
            far=HandPose((-0.10, 0.50, -0.52), (-0.3, 0.9, 0.1), (-0.2, 0, 1), curl=(20, 26, 20)), spine=(4, 0, 0),
            face="thoughtful", gaze="hands"),
        Key(0.5, 0.1, lead=HandPose((-0.26, 0.90, 0.16), (-0.3, 0.9, 0.3), (-0.8, 0, -0.4), curl=(45, 52, 20),
                                    tool=((0, 0.9, 0.4), (0, 0.4, -0.9)))),
        Key(0.5, 0.1, lead=HandPose((-0.06, 0.92, 0.0), (-0.3, 0.9, 0.3), (-0.8, 0, -0.4), curl=(45, 52, 20),
                                    tool=((0, 0.9, 0.4), (0, 0.4, -0.9)))),
    ), again=0, stretches=True, still_key=0),
    Act("draw", "draw", ("sketch", "chalk on a board"), (
        Key(0.6, 0.2, lead=HandPose((-0.22, 0.56, -0.30), (-0.5, 0.7, -0.2), (-0.6, -0.3, -0.6), curl=(48, 56, 20)),
            far=HandPose((-0.22, 0.46, -0.44), (-0.7, 0.7, 0.1), (-0.2, -0.2, 1), curl=(14, 18, 25)), spine=(6, 0, 0),
            nod=(12, 0, 0), face="thoughtful", gaze="hands"),
        Key(0.35, 0.1, lead=HandPose((-0.30, 0.60, -0.26), (-0.5, 0.7, -0.2), (-0.6, -0.3, -0.6), curl=(48, 56, 20))),
    ), again=0, stretches=True, still_key=0),
    Act("row", "row", ("paddle", "pull the oars"), (
        Key(0.7, 0.1, lead=HandPose((-0.10, 0.95, -0.35), (-0.2, 1, 0), (0, 0, -1), curl=at.FIST),
            far=HandPose((-0.10, 0.95, -0.35), (-0.2, 1, 0), (0, 0, -1), curl=at.FIST), spine=(26, 0, 0)),
        Key(0.8, 0.1, lead=HandPose((-0.12, 0.36, -0.40), (-0.2, 1, 0), (0, 0, -1), curl=at.FIST),
            far=HandPose((-0.12, 0.36, -0.40), (-0.2, 1, 0), (0, 0, -1), curl=at.FIST), spine=(-12, 0, 0)),
    ), again=0, stretches=True, still_key=0),
    Act("drive", "drive", ("steer", "at the wheel"), (
        Key(0.5, 0.8, lead=HandPose((-0.08, 0.78, -0.24), (-0.35, 0.7, 0.6), (-0.5, 0.6, -0.3), curl=at.GRIP),
            far=HandPose((-0.08, 0.78, -0.24), (-0.35, 0.7, 0.6), (-0.5, 0.6, -0.3), curl=at.GRIP)),
        Key(0.8, 0.6, lead=HandPose((-0.12, 0.78, -0.16), (-0.35, 0.7, 0.6), (-0.5, 0.6, -0.3), curl=at.GRIP),
            far=HandPose((-0.06, 0.78, -0.32), (-0.35, 0.7, 0.6), (-0.5, 0.6, -0.3), curl=at.GRIP)),
    ), again=0, stretches=True, still_key=0),
    Act("knock_over", "knock over", ("tip over", "upset", "overturn", "sweep off"), (
        Key(0.4, 0.05, lead=HandPose((0.32, -0.06, 0.14), (-0.2, 0.8, 0.1), (-1, 0, 0), (0.9, -0.2, -0.4), at.FLAT,
            "work"),
            spine=(4, 0, 16), face="angry", gaze="hands"),
        Key(0.22, 0.7, lead=HandPose((-0.30, 0.10, 0.10), (-0.5, 0.8, 0), (-1, 0.1, 0), (0.9, -0.1, -0.4), at.FLAT,
            "work"),
            spine=(10, 0, -18)),
    ), reach="thing", distance=0.5),
    Act("slam", "slam", ("bang a fist on the table", "pound"), (
        Key(0.35, 0.05, lead=replace(at.AIR_FIST, at=(0.05, 0.45, 0.35)), spine=(-2, 0, 6), face="rage"),
        Key(0.13, 0.9, lead=HandPose((0.02, 0.0, 0.04), (-0.3, 0.9, 0), (-1, 0, -0.2), (0.8, 0, 0.2), at.FIST, "work"),
            spine=(18, 0, -4), hips=(0, -0.03, 0, 6), gaze="target"),
    ), reach="thing", distance=0.5, directs=("bang",)),
    Act("smash", "smash", ("break", "shatter"), (
        Key(0.4, 0.1, lead=replace(at.AIR_FIST, at=(0.1, 0.1, 0.8)), far=replace(at.AIR_FIST, at=(0.1, 0.1, 0.8)),
            spine=(-8, 0, 0),
            face="rage"),
        Key(0.18, 0.7, lead=at.AHEAD_DOWN, far=at.AHEAD_DOWN, spine=(30, 0, 0), hips=(0, -0.06, -0.08, 14),
            gaze="hands"),
    ), still_key=0),
    Act("tear", "tear", ("rip up", "crumple", "tear to pieces"), (
        Key(0.5, 0.3, lead=HandPose((-0.20, 0.52, -0.22), (-0.5, 0.6, 0.6), (-0.5, -0.6, 0.2), curl=at.GRIP),
            far=HandPose((-0.22, 0.52, -0.22), (-0.5, 0.6, 0.6), (-0.5, -0.6, 0.2), curl=at.GRIP), nod=(12, 0, 0),
            face="angry",
            gaze="hands"),
        Key(0.25, 0.7, lead=HandPose((0.12, 0.52, -0.28), (-0.3, 0.7, 0.5), (-0.6, -0.4, 0.2), curl=at.GRIP),
            far=HandPose((0.02, 0.54, -0.16), (-0.3, 0.7, 0.5), (-0.6, -0.4, 0.2), curl=at.GRIP)),
    )),
    Act("fold", "fold", ("wrap", "pack", "unfold"), (
        Key(0.6, 0.3, lead=_at_work((0.14, 0.02, 0.06), curl=(30, 36, 14)), far=_at_work((0.14, 0.02, 0.06),
            curl=(30, 36, 14)),
            spine=(12, 0, 0), gaze="hands"),
        Key(0.5, 0.3, lead=_at_work((0.03, 0.06, 0.10), curl=(30, 36, 14)), far=_at_work((0.03, 0.0, 0.05), curl=(30,
            36, 14))),
    ), again=0, stretches=True, still_key=0, reach="thing", distance=0.5),
    Act("tie", "tie", ("bind", "knot", "handcuff", "bandage"), (
        Key(0.6, 0.4, lead=_at_work((0.05, 0.02, 0.06), curl=(50, 55, 20)), far=_at_work((0.05, 0.02, 0.05),
            curl=(50, 55, 20)),
            spine=(14, 0, 0), gaze="hands"),
        Key(0.35, 0.2, lead=_at_work((0.18, 0.0, 0.10), curl=(50, 55, 20)), far=_at_work((0.18, 0.0, 0.08), curl=(50,
            55, 20))),
    ), again=0, stretches=True, still_key=1, reach="thing", distance=0.5, directs=("bind",)),
    Act("lock", "lock", ("unlock", "turn a key", "turn a knob"), (
        Key(0.6, 0.4, lead=_at_work((0.0, -0.05, 0.0), curl=(50, 60, 15)), spine=(8, 0, 0), gaze="hands"),
        Key(0.3, 0.6, lead=HandPose((0.0, -0.05, 0.0), (-0.9, 0.4, -0.1), (-0.1, 0.2, -1), (0.8, 0, 0.3), (50, 60,
            15), "work")),
    ), reach="thing", distance=0.5),
    Act("deal_cards", "deal or play cards", ("play a game", "play chess"), (
        Key(0.5, 0.3, lead=HandPose((-0.24, 0.46, -0.36), (-0.4, 0.8, 0.3), (-0.3, -0.5, 0.7), curl=(30, 36, 20)),
            far=HandPose((-0.16, 0.46, -0.30), (-0.3, 0.6, 0.7), (-0.5, -0.8, 0.1), curl=(30, 40, 10)), gaze="hands"),
        Key(0.4, 0.3, lead=HandPose((-0.10, 0.76, -0.46), (-0.2, 1, 0), (-0.2, 0, -1), curl=(24, 30, 14))),
    ), again=0, stretches=True, still_key=1, directs=("play_game",)),
)  # fmt: skip
"""Acts with a tool or on an object."""
