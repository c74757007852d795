"""Acts of head and hands: gestures, emotions, habits."""

from __future__ import annotations

from dataclasses import replace

from storyblender.catalog.acts import hands as at
from storyblender.catalog.acts.entry import Act, HandPose, Key

SIGNS: tuple[Act, ...] = (
    Act("look_up", "look up", ("at the sky", "upwards"), (Key(0.5, 0.9, nod=(-8, 0, 0), gaze="up"),)),
    Act("look_down", "look down", ("at the floor",), (Key(0.5, 0.9, nod=(10, 0, 0), gaze="down"),)),
    Act("look_back", "look over the shoulder", ("behind", "back"), (
        Key(0.55, 0.9, spine=(0, -3, -34), nod=(0, 0, -12), gaze="back"),
    )),
    Act("look_left", "look to the left", (), (Key(0.5, 0.9, gaze="left"),)),
    Act("look_right", "look to the right", (), (Key(0.5, 0.9, gaze="right"),)),
    Act("look_away", "look away", ("avert the eyes", "avoid somebody's eyes"), (
        Key(0.5, 1.0, spine=(2, 0, 8), nod=(6, 0, 6), gaze="away"),
    )),
    Act("close_eyes", "close the eyes", ("shut the eyes",), (Key(0.3, 1.2, nod=(3, 0, 0), face="asleep"),), stays=True),
    Act("stare", "stare", ("gape", "freeze"), (Key(0.2, 1.4, spine=(-4, 0, 0), face="surprised", gaze="target"),)),
    Act("double_take", "double take", ("look twice",), (
        Key(0.35, 0.3, gaze="away"), Key(0.25, 0.7, spine=(8, 0, 0), face="surprised", gaze="target"),
    )),
    Act("cover_mouth", "cover the mouth", ("gasp", "hand to mouth"), (
        Key(0.4, 1.4, lead=at.MOUTH, spine=(-3, 0, 0), face="surprised"),
    ), stays=True),
    Act("cover_face", "cover the face", ("hide the face", "face in hands"), (
        Key(0.6, 1.4, lead=at.FACE, far=at.FACE, spine=(12, 0, 0), nod=(22, 0, 0), face="cry"),
    )),
    Act("cover_eyes", "cover the eyes", ("shield the eyes",), (
        Key(0.5, 1.3, lead=at.EYES, far=replace(at.EYES, at=(0.01, 0.135, 0.005)), nod=(8, 0, 0), face="asleep"),
    )),
    Act("cover_ears", "cover the ears", ("hands over the ears",), (
        Key(0.5, 1.4, lead=at.EAR, far=at.EAR, spine=(10, 0, 0), nod=(10, 0, 0), face="pained"),
    )),
    Act("listen_close", "listen at a door", ("eavesdrop", "cup an ear"), (
        Key(0.6, 1.6, lead=at.CUPPED_EAR, spine=(14, 12, 0), nod=(0, 12, -18), face="thoughtful"),
    ), stretches=True, again=0, reach="thing", distance=0.45, directs=("eavesdrop",)),
    Act("wipe_eyes", "wipe tears away", ("dab the eyes", "dry the eyes"), (
        Key(0.5, 0.5, lead=at.CHEEK, nod=(8, 0, 0), face="cry"),
        Key(0.35, 0.4, lead=replace(at.CHEEK, at=(0.09, 0.06, -0.03))),
    ), still_key=0),
    Act("wipe_brow", "wipe the brow", ("wipe sweat away",), (
        Key(0.5, 0.4, lead=at.BROW, nod=(-4, 0, 0), face="tired"),
        Key(0.4, 0.3, lead=replace(at.BROW, at=(0.07, 0.09, 0.06))),
    ), still_key=0),
    Act("scratch_head", "scratch the head", ("puzzled",), (
        Key(0.5, 0.5, lead=at.CROWN, nod=(8, 8, 0), face="thoughtful"),
        Key(0.2, 0.1, lead=replace(at.CROWN, at=(0.075, -0.03, 0.155))),
        Key(0.2, 0.6, lead=at.CROWN),
    ), still_key=0),
    Act("facepalm", "hand to the forehead", ("slap the forehead", "dismay"), (
        Key(0.45, 1.2, lead=replace(at.FACE, at=(0.0, 0.115, 0.035)), nod=(18, 0, 0), face="pained"),
    )),
    Act("hold_head", "hold the head", ("headache", "despair"), (
        Key(0.6, 1.3, lead=at.TEMPLE, far=at.TEMPLE, spine=(14, 0, 0), nod=(20, 0, 0), face="pained"),
    )),
    Act("rub_neck", "rub the neck", ("embarrassed",), (Key(0.6, 1.2, lead=at.NECK, nod=(14, 8, 0), face="tired"),)),
    Act("tip_hat", "tip the hat", ("doff the hat",), (
        Key(0.5, 0.3, lead=at.BRIM, nod=(4, 0, 0)), Key(0.3, 0.5, lead=at.BRIM, nod=(16, 0, 0), face="smile"),
    ), still_key=0),
    Act("shade_eyes", "shade the eyes", ("scan the horizon", "look into the distance"), (
        Key(0.5, 1.4, lead=at.SHADE, spine=(5, 0, 0), face="suspicious"),
    ), directs=("scan_horizon",)),
    Act("whistle", "whistle", ("whistle a tune",), (
        Key(0.4, 0.8, nod=(-5, 5, 0), face="whistle"), Key(0.4, 0.8, nod=(-5, -5, 0), face="whistle"),
    ), again=0, stretches=True),
    Act("sing", "sing", ("chant", "croon"), (
        Key(0.5, 0.5, lead=at.OPEN_ARMS, far=at.HEART, spine=(-4, 0, 0), nod=(-8, 0, 0), face="sing"),
        Key(0.6, 0.3, lead=replace(at.OPEN_ARMS, at=(0.45, 0.62, -0.2)), nod=(-4, 5, 0), face="sing"),
    ), again=0, stretches=True),
    Act("shush", "finger to the lips", ("hush", "silence"), (Key(0.45, 1.2, lead=at.LIPS, spine=(5, 0, 0),
        gaze="target"),)),
    Act("yawn", "yawn", ("tired", "bored"), (
        Key(0.6, 1.1, lead=replace(at.MOUTH, at=(-0.015, 0.15, -0.085)), nod=(-14, 0, 0), face="yawn"),
    )),
    Act("sneeze", "sneeze", ("achoo",), (
        Key(0.6, 0.2, spine=(-6, 0, 0), nod=(-16, 0, 0), face="pained"),
        Key(0.16, 0.6, lead=replace(at.MOUTH, curl=at.FIST), spine=(24, 0, 0), nod=(18, 0, 0), face="pained"),
    )),
    Act("cough", "cough", ("clear the throat", "choke"), (
        Key(0.4, 0.2, lead=replace(at.MOUTH, curl=at.FIST), spine=(12, 0, 0), nod=(10, 0, 0), face="pained"),
        Key(0.15, 0.2, spine=(22, 0, 0), nod=(16, 0, 0)),
        Key(0.2, 0.1, spine=(14, 0, 0)),
        Key(0.15, 0.4, spine=(22, 0, 0)),
    ), still_key=1),
    Act("stretch", "stretch", ("stretch the arms", "wake up"), (
        Key(0.9, 0.8, lead=replace(at.AIR_FIST, at=(0.22, -0.05, 0.9)), far=replace(at.AIR_OPEN, at=(0.1, -0.1, 0.85)),
            spine=(-12, 4, 0), nod=(-12, 6, 0), face="yawn"),
    )),
    Act("beckon", "beckon", ("come here", "wave over"), (
        Key(0.45, 0.15, lead=HandPose((-0.05, 0.66, 0.02), (-0.1, 0.5, 0.85), (-0.1, -1, 0.5), curl=at.FLAT),
            gaze="target"),
        Key(0.25, 0.1, lead=HandPose((-0.08, 0.48, 0.08), (-0.2, -0.2, 1), (-0.1, -1, 0), curl=(45, 55, 0))),
        Key(0.25, 0.1, lead=HandPose((-0.05, 0.66, 0.02), (-0.1, 0.5, 0.85), (-0.1, -1, 0.5), curl=at.FLAT)),
        Key(0.25, 0.3, lead=HandPose((-0.08, 0.48, 0.08), (-0.2, -0.2, 1), (-0.1, -1, 0), curl=(45, 55, 0))),
    ), still_key=0),
    Act("halt", "raise a hand to stop somebody", ("stop", "hold up a palm"), (
        Key(0.4, 1.3, lead=at.PALM_OUT, spine=(4, 0, 10), gaze="target"),
    )),
    Act("thumbs_up", "thumb up", ("approve",), (
        Key(0.4, 1.1, lead=HandPose((-0.05, 0.62, -0.12), (-0.55, 0.8, 0), (-0.75, -0.6, 0), curl=(80, 88, -45)),
            face="smile",
            gaze="target"),
    )),
    Act("raise_hand", "raise a hand", ("ask to speak", "swear", "volunteer"), (Key(0.6, 1.4, lead=at.HAND_UP),)),
    Act("raise_fist", "raise a fist", ("shake a fist", "threaten"), (
        Key(0.4, 0.4, lead=replace(at.AIR_FIST, at=(0.12, 0.35, 0.45)), spine=(4, 0, 8), face="rage", gaze="target"),
        Key(0.2, 0.1, lead=replace(at.AIR_FIST, at=(0.12, 0.5, 0.38))),
        Key(0.2, 0.3, lead=replace(at.AIR_FIST, at=(0.12, 0.35, 0.45))),
    ), still_key=0),
    Act("cheer", "cheer", ("rejoice", "celebrate", "arms in the air"), (
        Key(0.4, 0.5, lead=at.AIR_FIST, far=at.AIR_FIST, spine=(-6, 0, 0), nod=(-12, 0, 0), face="laugh"),
        Key(0.25, 0.1, lead=replace(at.AIR_FIST, at=(0.15, 0.2, 0.7)), far=replace(at.AIR_FIST, at=(0.15, 0.2, 0.7))),
        Key(0.25, 0.4, lead=at.AIR_FIST, far=at.AIR_FIST),
    ), again=1, stretches=True, still_key=0),
    Act("surrender", "hands up", ("give up", "put the hands up"), (
        Key(0.5, 1.6, lead=at.SURRENDER, far=at.SURRENDER, face="afraid", gaze="target"),
    ), stays=True, directs=("hands_up",)),
    Act("cross_arms", "cross the arms", ("arms folded",), (
        Key(0.6, 1.6, lead=at.ARM_OVER, far=at.ARM_UNDER, spine=(-3, 0, 0)),
    ), stays=True),
    Act("hands_on_hips", "hands on the hips", ("arms akimbo",), (
        Key(0.5, 1.6, lead=at.HIP, far=at.HIP, spine=(-3, 0, 0)),
    ), stays=True),
    Act("hands_in_pockets", "hands in the pockets", (), (Key(0.6, 1.6, lead=at.POCKET, far=at.POCKET),), stays=True),
    Act("heart", "hand on the heart", ("swear", "touched", "moved"), (Key(0.5, 1.5, lead=at.HEART, nod=(4, 4, 0)),),
        stays=True),
    Act("clutch_chest", "clutch the chest", ("heart attack", "shot", "wounded"), (
        Key(0.3, 1.4, lead=at.HEART, far=replace(at.HEART, at=(-0.26, 0.32, -0.36)), spine=(18, 0, 0), nod=(8, 0, 0),
            hips=(0, -0.03, -0.05, 4), face="pained"),
    )),
    Act("clutch_belly", "hold the belly", ("stomach ache", "sick", "vomit"), (
        Key(0.4, 1.4, lead=at.BELLY, far=at.BELLY, spine=(30, 0, 0), nod=(10, 0, 0), hips=(0, -0.06, -0.06, 8),
            face="pained"),
    )),
    Act("hug_self", "hug oneself", ("shiver", "freeze", "cold"), (
        Key(0.5, 0.2, lead=at.HUGGED, far=at.HUGGED, spine=(12, 0, 0), nod=(8, 0, 0), face="afraid"),
        Key(0.12, 0.0, spine=(14, 2, 0)), Key(0.12, 0.0, spine=(12, -2, 0)),
    ), again=1, stretches=True, directs=("shiver",)),
    Act("beg", "beg", ("plead", "implore"), (
        Key(0.5, 0.6, lead=at.CLASPED, far=at.CLASPED, spine=(14, 0, 0), nod=(-10, 0, 0), face="sad", gaze="target"),
        Key(0.25, 0.1, lead=replace(at.CLASPED, at=(-0.31, 0.62, -0.1)), far=replace(at.CLASPED, at=(-0.31, 0.62,
            -0.1))),
        Key(0.25, 0.3, lead=at.CLASPED, far=at.CLASPED),
    ), still_key=0, directs=("plead",)),
    Act("wring_hands", "wring the hands", ("fret", "fidget"), (
        Key(0.5, 0.3, lead=replace(at.CLASPED, at=(-0.31, 0.42, -0.55)), far=replace(at.CLASPED, at=(-0.31, 0.42,
            -0.55)),
            spine=(6, 0, 0), face="afraid"),
        Key(0.4, 0.2, lead=replace(at.CLASPED, at=(-0.28, 0.46, -0.5)), far=replace(at.CLASPED, at=(-0.34, 0.4,
            -0.55))),
    ), again=0, stretches=True),
    Act("open_arms", "spread the arms", ("welcome", "ta-da"), (
        Key(0.5, 1.3, lead=at.OPEN_ARMS, far=at.OPEN_ARMS, spine=(-3, 0, 0), face="smile", gaze="target"),
    ), directs=("welcome",)),
    Act("toast", "raise a glass", ("cheers", "drink to"), (
        Key(0.6, 1.4, lead=HandPose((-0.08, 0.72, 0.12), (-0.2, 1, 0.1), (-1, 0, 0), (0.8, 0, -0.6), at.GRIP,
                                    tool=((0, 0, 1), (0, 1, 0))), face="smile", gaze="target"),
    )),
    Act("show", "hold something up", ("display", "hold aloft"), (
        Key(0.6, 1.4, lead=HandPose((-0.12, 0.72, 0.12), (-0.2, 0.5, 0.9), (-0.7, -0.6, 0.1), (0.8, 0, -0.6), (30,
            40, 10)),
            gaze="hands"),
    )),
    Act("pocket", "put in a pocket", ("slip into a pocket", "tuck away", "put away"), (
        Key(0.6, 1.0, lead=HandPose((-0.24, 0.24, -0.34), (-0.9, 0.1, 0.2), (0.05, -1, 0.1), (0.9, 0.1, -0.4),
                                    at.GRIP), nod=(14, 0, 0), gaze="hands"),
    )),
    Act("hide_behind", "hide behind what one holds", ("hide behind a fan", "hide behind a newspaper"), (
        Key(0.6, 1.4, lead=HandPose((-0.03, 0.30, -0.12), (-0.3, 0.4, 0.85), (-0.9, -0.3, 0), (0.7, 0.2, -0.9),
                                    at.GRIP, "head", tool=((0, 0, 1), (0, 1, 0))), nod=(8, 0, 0), gaze="down"),
    ), stays=True),
    Act("offer", "hold something out", ("hold out", "proffer", "present"), (
        Key(0.6, 1.4, lead=at.OFFERED, spine=(6, 0, 6), gaze="target"),
    )),
    Act("blow", "blow", ("blow out a candle", "blow a kiss"), (Key(0.5, 1.0, spine=(16, 0, 0), nod=(6, 0, 0),
        face="whistle"),)),
    Act("sniff", "smell", ("sniff", "inhale"), (Key(0.5, 1.0, spine=(10, 0, 0), nod=(-4, 0, 0), face="eyes_closed"),)),
    Act("check_watch", "look at the watch", ("check the time",), (Key(0.5, 1.2, lead=at.WRIST, nod=(14, 0, 0),
        gaze="hands"),)),
    Act("flinch", "flinch", ("recoil", "start", "wince", "duck away"), (
        Key(0.2, 1.0, lead=at.WARDING, far=at.WARDING, spine=(-10, 8, -8), nod=(6, 8, -14), hips=(0, -0.07, -0.04, -4),
            face="terrified"),
    )),
)  # fmt: skip
"""Acts that need no particular place and no tool."""
