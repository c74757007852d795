"""Acts with instruments, cameras and glasses."""

from __future__ import annotations

from dataclasses import replace

from storyblender.catalog.acts import hands as at
from storyblender.catalog.acts.entry import Act, FootPose, HandPose, Key
from storyblender.catalog.motion_entry import AWAKE

_STICK_UP = HandPose((-0.05, 0.55, -0.28), (-0.2, 0.9, 0.3), (-0.4, 0, -0.9), curl=at.GRIP)
_STICK_DOWN = HandPose((-0.08, 0.60, -0.46), (-0.2, 0.9, -0.3), (-0.4, 0, -0.9), curl=at.GRIP)

ARTS: tuple[Act, ...] = (
    Act("photograph", "take a photograph", ("snap", "take a picture"), (
        Key(0.6, 1.4, lead=at.AT_EYES, far=at.AT_EYES, spine=(4, 0, 0), gaze="target"),
    ), stretches=True, directs=("take_picture",)),
    Act("film", "film", ("shoot with a camera", "record"), (
        Key(0.6, 1.6, lead=replace(at.AT_EYES, at=(0.05, 0.17, -0.03)),
            far=HandPose((0.02, 0.30, -0.06), (-0.3, 0.6, 0.6), (-0.2, -0.3, 1), (0.6, 0.2, -0.9), (30, 36, 10),
                "head"),
            spine=(6, 0, 0), gaze="target", far_foot=FootPose(0.03, 0.16)),
    ), stretches=True, before=AWAKE),
    Act("watch_through", "look through binoculars", ("telescope", "spyglass", "field glasses"), (
        Key(0.6, 1.6, lead=at.AT_EYES, far=at.AT_EYES, gaze="target"),
    ), stretches=True, directs=("binoculars",)),
    Act("text", "tap on a mobile phone", ("text", "scroll", "dial"), (
        Key(0.5, 0.6, lead=HandPose((-0.20, 0.50, -0.30), (-0.3, 0.6, 0.7), (-0.4, -0.8, 0.3), curl=(30, 50, 0)),
            far=HandPose((-0.26, 0.48, -0.34), (-0.5, 0.6, 0.5), (-0.2, -0.7, 0.6), curl=(30, 50, 0)), nod=(16, 0, 0),
            gaze="hands"),
        Key(0.25, 0.2, lead=HandPose((-0.21, 0.50, -0.29), (-0.35, 0.6, 0.7), (-0.4, -0.8, 0.3), curl=(20, 50, 20))),
    ), again=0, stretches=True, still_key=0),
    Act("conduct", "conduct", ("lead an orchestra",), (
        Key(0.5, 0.1, lead=HandPose((0.10, 0.55, 0.30), (0, 0.7, 0.7), (-0.5, 0.2, -0.8), curl=(30, 60, 20)),
            far=HandPose((0.15, 0.55, 0.10), (0.1, 0.8, 0.5), (-0.3, 0.2, -0.9), curl=at.FLAT), spine=(-2, 0, 0)),
        Key(0.4, 0.1, lead=HandPose((-0.05, 0.62, -0.15), (0, 0.9, 0), (-0.5, 0.2, -0.8), curl=(30, 60, 20)),
            far=HandPose((0.0, 0.62, -0.25), (0, 1, 0), (-0.3, 0.2, -0.9), curl=at.FLAT), spine=(6, 0, 0)),
    ), again=0, stretches=True, still_key=0),
    Act("violin", "play the violin", ("fiddle", "viola"), (
        Key(0.7, 0.1, lead=HandPose((0.22, 0.62, 0.06), (-0.5, 0.2, 0.8), (-0.6, -0.7, 0.2), (0.3, 0.1, -1), (50, 55,
            10),
                                    tool=((0.45, 0.85, 0.08), (0.25, 0, 1))),
            far=HandPose((-0.02, 0.56, -0.12), (-0.7, 0.5, 0.1), (-0.3, 0.1, -1), (1, 0, 0), (45, 50, 20)),
            spine=(2, 0, 8), nod=(6, 14, 14)),
        Key(0.7, 0.0, far=HandPose((-0.20, 0.50, 0.0), (-0.7, 0.5, 0.2), (-0.3, 0.1, -1), (1, 0, 0.2), (45, 50, 20))),
        Key(0.7, 0.0, far=HandPose((0.10, 0.56, -0.22), (-0.7, 0.5, 0.1), (-0.3, 0.1, -1), (1, 0, 0), (45, 50, 20))),
    ), again=1, stretches=True, still_key=0),
    Act("flute", "play the flute", ("blow a pipe", "recorder", "clarinet"), (
        Key(0.7, 0.4, lead=HandPose((0.12, 0.10, -0.12), (-0.2, 0.9, 0.3), (-0.4, -0.3, 0.8), (0.8, 0.1, -0.6), (40,
            40, 10), "head",
                                    tool=((0, 0, 1), (0, 1, 0))),
            far=HandPose((-0.09, 0.16, -0.13), (-0.7, 0.5, 0.4), (0.2, -0.8, 0.3), (0.5, 0.1, -1), (40, 40, 10),
                "head"),
            nod=(2, -8, -10), face="whistle"),
        Key(0.5, 0.1, nod=(6, -4, -6)), Key(0.5, 0.1, nod=(0, -8, -10)),
    ), again=1, stretches=True, still_key=0),
    Act("trumpet", "play the trumpet", ("horn", "bugle", "trombone", "saxophone"), (
        Key(0.6, 0.5, lead=HandPose((0.02, 0.24, -0.10), (-0.3, 0.3, 0.9), (-0.9, -0.2, 0), (0.7, 0.1, -0.8),
            at.GRIP, "head",
                                    tool=((0, 0.1, 1), (0, 1, 0.1))),
            far=HandPose((0.02, 0.20, -0.12), (-0.3, 0.4, 0.8), (-0.9, -0.2, 0), (0.7, 0.1, -0.8), at.GRIP, "head"),
            spine=(-5, 0, 0), nod=(-6, 0, 0), face="whistle"),
        Key(0.5, 0.1, spine=(2, 0, 4)), Key(0.5, 0.1, spine=(-6, 0, -4)),
    ), again=1, stretches=True, still_key=0),
    Act("drum", "drum", ("beat a drum", "bang on"), (
        Key(0.4, 0.05, lead=_STICK_UP, far=_STICK_DOWN, spine=(6, 0, 0)),
        Key(0.16, 0.05, lead=_STICK_DOWN, far=_STICK_UP), Key(0.16, 0.05, lead=_STICK_UP, far=_STICK_DOWN),
    ), again=1, stretches=True, still_key=0),
)  # fmt: skip
"""Acts of artists, and acts with cameras and optical instruments."""
