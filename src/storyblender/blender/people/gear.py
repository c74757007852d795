"""Accessories worn on the body: head cloths, backpacks, necklaces, capes, wings."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.people.cloth import Bolt, single_bolt
from storyblender.blender.people.eyewear import build_glasses
from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.figure import FAR, BodyFigure
from storyblender.blender.people.pack import PARTS
from storyblender.blender.people.sheet import Sheet, clip, join, loosened, rigid_sheet
from storyblender.blender.people.solids import ball, bar, skinned
from storyblender.blender.people.worn_layers import WornLayers
from storyblender.catalog.cuts import Gear, HeadCloth
from storyblender.geometry.solids import Floats, skin_faces

BUCKLE, DARK = "#8a8d92", "#1b1b1e"


def _face(base: Floats, width: float, low: float, high: float) -> Floats:
    """Return the field (V,) outside an oval of the face; lengths in decimetres on the base mesh."""
    middle, tall = (low + high) / 2, (high - low) / 2
    inside = 1 - np.hypot(base[:, 0] / width, (base[:, 1] - middle) / tall)
    return np.where(base[:, 2] > 0.55, -inside, FAR)


def build_head_cloth(cut: HeadCloth, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a head cloth, cut from the skin of the head and offset outwards."""
    sheet = figure.part("skin")
    base = sheet.base
    match cut.region:
        case "hood" | "scarf":
            low = 6.05 if cut.region == "hood" else 6.75
            field = np.minimum(base[:, 1] - low, _face(base, 0.66, 6.42, 7.78))
            if cut.region == "scarf":
                field = np.minimum(field, 0.9 - base[:, 2])
        case "balaclava":
            field = np.minimum(base[:, 1] - 6.0, _face(base, 0.6, 7.08, 7.5))
        case "mask":
            field = np.minimum.reduce([base[:, 1] - 6.52, 7.18 - base[:, 1], base[:, 2] - 0.5])
        case "blindfold":
            field = np.minimum(base[:, 1] - 7.1, 7.45 - base[:, 1])
        case "band":
            field = np.minimum(base[:, 1] - (7.62 - 0.12 * (base[:, 2] < 0.4)), 7.95 - base[:, 1])
    sheet = clip(sheet, field * 0.1)
    rounds = {"hood": 14, "scarf": 16, "balaclava": 6}.get(cut.region, 8)
    sheet = loosened(sheet, cut.ease * figure.head_scale, rounds)
    return single_bolt(cut, sheet)


def build_gear(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a solid accessory, outside the worn layers."""
    return {
        "backpack": _backpack,
        "tank": _tank,
        "necklace": _necklace,
        "stethoscope": _stethoscope,
        "wings": _wings,
        "cape": _cape,
        "satchel": _satchel,
        "braces": _braces,
        "sunglasses": _sunglasses,
        "eyepatch": _eyepatch,
        "headphones": _headphones,
    }[cut.shape](cut, figure, layers)


def _back(figure: BodyFigure) -> Floats:
    """Return the point of the back between the shoulder blades, metres."""
    near = figure.points[: len(figure.pack.ears)]
    chest, k = figure.heights["chest"], figure.scale
    band = near[(np.abs(near[:, 2] - chest) < 0.03 * k) & (np.abs(near[:, 0]) < 0.08 * k)]
    return np.array((0.0, float(band[:, 1].max()) + 0.012 * k, chest))


def _straps(figure: BodyFigure, layers: WornLayers, apart: float, low: float) -> list[Sheet]:
    """Return two straps ``apart`` from the middle, from the back over the shoulders down to height ``low`` in front."""
    k, weights = figure.scale, bone_weights("upper_chest")
    back, sheets = _back(figure), []
    top = figure.heights["neck"]
    for side in (-1, 1):
        x = side * apart * k
        path = [np.array((x * 0.9, back[1], back[2]))]
        for z in np.linspace(top + 0.0 * k, low, 7):
            spot = layers.front(x, float(z))
            if spot is not None:
                path.append(spot.location + spot.normal * 0.008 * k)
        crest = np.array((x, (path[0][1] + path[-1][1]) / 2, top + 0.02 * k))
        sheets.append(
            bar([path[0], (path[0] + crest) / 2 + (0, 0.01 * k, 0.015 * k), crest, *path[1:]], 0.011 * k, weights)
        )
    return sheets


def _backpack(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a backpack with its straps."""
    k, weights, back = figure.scale, bone_weights("upper_chest"), _back(figure)
    body = ball(back + np.array((0, 0.085, -0.10)) * k, np.array((0.15, 0.085, 0.22)) * k, weights, softness=0.35)
    pocket = ball(back + np.array((0, 0.17, -0.18)) * k, np.array((0.11, 0.04, 0.1)) * k, weights, softness=0.35)
    straps = _straps(figure, layers, 0.085, figure.heights["ribs"])
    return [Bolt(body, cut.tint, cut.fabric), Bolt(pocket, "dark", cut.fabric), Bolt(join(straps), "dark", cut.fabric)]


def _tank(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of two gas bottles on the back."""
    k, weights, back = figure.scale, bone_weights("upper_chest"), _back(figure)
    bodies = []
    for side in (-1, 1):
        foot = back + np.array((side * 0.075, 0.09, -0.28)) * k
        path = [foot + np.array((0, 0, up * k)) for up in (0.0, 0.04, 0.38, 0.42)]
        bodies.append(bar(path, [0.03 * k, 0.066 * k, 0.066 * k, 0.03 * k], weights))
    block = ball(back + np.array((0, 0.04, -0.08)) * k, np.array((0.14, 0.05, 0.18)) * k, weights, softness=0.25)
    return [Bolt(join(bodies), cut.tint, cut.fabric), Bolt(block, "dark", cut.fabric)]


def _around_neck(figure: BodyFigure, layers: WornLayers, low: float, half: float) -> list[Floats]:
    """Return the points of a loop around the neck that hangs ``low`` (times the scale) below its base in front."""
    k = figure.scale
    neck = figure.joint("neck")
    loop = []
    for turn in np.linspace(0, 2 * math.pi, 25)[:-1]:
        x = half * k * math.cos(turn)
        front = max(0.0, -math.sin(turn))
        z = neck[2] + (0.035 - 0.035 * front - low * front**2) * k
        spot = layers.front(x, float(z)) if front > 0.2 else None
        y = float(spot.location[1]) - 0.008 * k if spot is not None else neck[1] + 0.075 * k * math.sin(turn)
        loop.append(np.array((x, y, z)))
    return loop


def _necklace(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a string of beads with a pendant."""
    weights, k = bone_weights("upper_chest"), figure.scale
    loop = _around_neck(figure, layers, 0.06, 0.075)
    beads = [ball(at, np.full(3, 0.0065 * k), weights) for at in loop]
    drop = min(loop, key=lambda at: float(at[2]))
    return [
        Bolt(join(beads), cut.tint, cut.fabric),
        Bolt(ball(drop - (0, 0.004 * k, 0.012 * k), np.array((0.011, 0.006, 0.014)) * k, weights), "main", "metal"),
    ]


def _stethoscope(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a stethoscope around the neck."""
    weights, k = bone_weights("upper_chest"), figure.scale
    loop = _around_neck(figure, layers, 0.17, 0.08)
    drop = min(loop, key=lambda at: float(at[2]))
    return [
        Bolt(bar(loop, 0.0065 * k, weights, closed=True), cut.tint, cut.fabric),
        Bolt(ball(drop - (0, 0.006 * k, 0.02 * k), np.array((0.022, 0.008, 0.022)) * k, weights), BUCKLE, "metal"),
    ]


def _braces(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of trouser braces."""
    straps = _straps(figure, layers, 0.07, figure.heights["belt"] + 0.01 * figure.scale)
    return single_bolt(cut, join(straps))


def _satchel(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a shoulder bag at the hip with its strap."""
    k, weights = figure.scale, bone_weights("hips")
    at = np.array((-0.215 * k, figure.joint("pelvis")[1], figure.heights["hip"] - 0.04 * k))
    bag = ball(at, np.array((0.045, 0.14, 0.11)) * k, weights, softness=0.3)
    flap = ball(at + np.array((-0.02, 0, 0.04)) * k, np.array((0.032, 0.145, 0.075)) * k, weights, softness=0.3)
    path = [at + np.array((0.03, -0.05, 0.1)) * k]
    for share in np.linspace(0.12, 1.0, 6):
        x = (-0.17 + 0.25 * share) * k
        z = float(at[2] + (figure.heights["neck"] - at[2]) * share)
        spot = layers.front(x, z)
        if spot is not None:
            path.append(spot.location + spot.normal * 0.008 * k)
    top = np.array((0.08 * k, figure.joint("neck")[1], figure.heights["neck"] + 0.03 * k))
    back = _back(figure)
    path += [top, np.array((0.05 * k, back[1], back[2] + 0.02 * k)), at + np.array((0.03, 0.08, 0.1)) * k]
    return [
        Bolt(bag, cut.tint, "leather"),
        Bolt(flap, "dark", "leather"),
        Bolt(bar(path, 0.011 * k, bone_weights("upper_chest")), "dark", "leather"),
    ]


def _headphones(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of headphones."""
    weights, s = bone_weights("head"), figure.head_scale
    ears = figure.points[: len(figure.pack.ears)][figure.pack.ears]
    middle, wide = ears.mean(0), float(ears[:, 0].max()) + 0.006 * s
    top = figure.stature + 0.012 * s
    arc = [
        np.array((wide * math.cos(t), middle[1] - 0.01 * s, middle[2] + (top - middle[2]) * math.sin(t)))
        for t in np.linspace(0, math.pi, 15)
    ]
    cups = [
        ball((side * wide, middle[1], middle[2]), np.array((0.02, 0.036, 0.042)) * s, weights, softness=0.6)
        for side in (-1, 1)
    ]
    return [Bolt(join(cups), cut.tint, cut.fabric), Bolt(bar(arc, 0.008 * s, weights), "dark", cut.fabric)]


def _lens(figure: BodyFigure, side: str, size: tuple[float, float]) -> Sheet:
    """Return a lens over one eye; ``size`` is its half width and half height on an adult's head, metres."""
    eye, s = figure.joint(f"{side}-eye"), figure.head_scale
    lids = figure.points[PARTS["skin"]]
    near = lids[np.hypot(lids[:, 0] - eye[0], lids[:, 2] - eye[2]) < 0.02 * s]
    center = (eye[0] * 1.04, float(near[:, 1].min()) - 0.006 * s, eye[2] - 0.003 * s)
    return ball(center, np.array((size[0], 0.004, size[1])) * s, bone_weights("head"), softness=0.7)


def _sunglasses(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of sunglasses."""
    lenses = [_lens(figure, side, (0.026, 0.021)) for side in "lr"]
    return single_bolt(cut, join([build_glasses(figure), *lenses]))


def _eyepatch(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of an eyepatch with its band."""
    band = build_head_cloth(HeadCloth(region="band", ease=0.004, tint=cut.tint), figure, layers)
    return [Bolt(_lens(figure, "l", (0.028, 0.028)), cut.tint, cut.fabric), *band]


def _cape(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a cloth from the shoulders down the back, in soft folds; it follows trunk and legs."""
    k = figure.scale
    top, hem, wide = figure.heights["neck"] + 0.01 * k, figure.heights["ankle"] + 0.1 * k, 0.2 * k
    back, axis = _back(figure), float(figure.joint("neck")[1])
    rows, weights = 12, []
    points, columns = [], 21
    chest, hips = bone_weights("upper_chest"), bone_weights("hips")
    for row in range(rows):
        fall = row / (rows - 1)
        z = top + (hem - top) * fall
        reach = wide * (0.62 + 0.75 * fall**0.5)
        deep = (back[1] - axis + 0.03 * k) * (1 + 0.9 * fall)
        for column in range(columns):
            turn = math.pi * (-0.12 + 1.24 * column / (columns - 1))
            fold = 1 + 0.09 * fall * math.sin(column * math.pi * 0.55)
            points.append((reach * math.cos(turn) * fold, axis + deep * math.sin(turn) * fold, z))
            share = min(1.0, max(0.0, (fall - 0.2) / 0.4))
            weights.append(chest * (1 - share) + hips * share)
    faces = skin_faces(rows, columns, False)
    outer = rigid_sheet(np.array(points), faces, np.array(weights))
    inner = rigid_sheet(np.array(points) * (0.985, 0.985, 1), [face[::-1] for face in faces], np.array(weights))
    return [Bolt(outer, cut.tint, cut.fabric), Bolt(inner, "dark", cut.fabric)]


def _wings(cut: Gear, figure: BodyFigure, layers: WornLayers) -> list[Bolt]:
    """Return the bolts of a pair of feathered wings."""
    k, weights, back = figure.scale, bone_weights("upper_chest"), _back(figure)
    sheets = []
    for side in (-1, 1):
        for place in range(7):
            lean, long = math.radians(62 - 22 * place), (0.62 - 0.05 * place) * k
            way = np.array((side * math.cos(lean), 0.25, math.sin(lean)))
            root = back + np.array((side * 0.03, 0.01 + 0.006 * place, 0.02)) * k
            normal = np.array((0.0, 1.0, 0.0))
            across = np.cross(way, normal)
            rings = [
                [
                    root + way * long * t + (across * a + normal * n) * w * k
                    for a, n in ((1, 0), (0, 0.25), (-1, 0), (0, -0.25))
                ]
                for t, w in ((0.0, 0.02), (0.4, 0.055), (0.85, 0.06), (1.0, 0.012))
            ]
            sheets.append(skinned(rings, weights))
    return single_bolt(cut, join(sheets))
