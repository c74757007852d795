"""What the picture of a catalogue's entry shows: a thing, a person who wears it, or a story of one shot that the crew
stages like any other.
"""

from __future__ import annotations

from storyblender.catalog.motions import MOTIONS
from storyblender.catalog.sets import SETS
from storyblender.memory.asset_sheet import Asset, CanonicalAsset, CharacterLook, Garment, ParamValue
from storyblender.memory.graph import ContinuityMemoryGraph, ProjectFormat
from storyblender.memory.outline import SceneOutline, ShotOutline
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.memory.shot_context import BodyState, CameraInstruction, CharacterAction, ShotContext
from storyblender.memory.vocabulary import Posture

WIDTH = 640
"""Pixels of a picture."""
_ACTOR = Asset(
    asset_id="ada",
    asset_type="character",
    name="Ada",
    description="A woman.",
    look=CharacterLook(age=30, gender="female"),
)
_PARTNER = Asset(
    asset_id="tom", asset_type="character", name="Tom", description="A man.", look=CharacterLook(age=40, gender="male")
)
_CHILD = _PARTNER.model_copy(update={"look": CharacterLook(age=5, gender="male")})
"""Whom one lifts."""
_THINGS: dict[str, str] = {
    "sit": "chair", "lie_down": "bed", "lean": "bar counter", "climb": "ladder", "open": "wardrobe",
    "close": "wardrobe", "knock": "wardrobe", "push": "crate", "pull": "crate", "kick": "ball", "catch": "ball",
    "press": "radio", "work": "workbench", "search": "chest", "wipe": "round table",
    "pick_up": "suitcase", "take": "suitcase", "listen_close": "wardrobe", "lean_over": "round table",
    "stir": "pot", "cut": "crate", "wash": "plate", "knead": "round table", "iron": "round table",
    "hammer": "crate", "saw": "crate", "fix": "radio", "knock_over": "vase", "slam": "round table", "fold": "letter",
    "tie": "rope", "lock": "wardrobe", "grip_rail": "ladder", "cross_out": "round table",
}  # fmt: skip
"""What a motion is done to in its picture."""
_HELD: dict[str, str] = {
    "put_down": "suitcase", "give": "book", "drop": "cup", "hold": "cup", "drink": "cup", "throw": "ball",
    "eat": "apple", "smoke": "cigarette", "pour": "bottle", "phone": "telephone", "read": "book", "write": "pen",
    "aim": "gun", "lower_weapon": "gun", "lean_on_stick": "cane", "shoulder": "ladder", "play_guitar": "guitar",
    "strike_match": "matchbox", "bid": "book", "shoot": "gun", "dress": "hat",
}  # fmt: skip
"""What is in hand for it."""
_FROM: dict[str, Posture] = {"rise": "kneel", "sleep": "lie", "wake": "lie", "get_up": "lie"}
"""Postures that it is done in, where one does not stand."""


def asset_of(kind: str, key: str) -> Asset:
    """Return a thing, a person who wears a garment or a hair style, or a crate of a material.

    Args:
        kind: Catalogue: ``props``, ``garments``, ``hair`` or ``materials``.
        key: Of the entry in it.
    """
    match kind:
        case "garments":
            look = CharacterLook(garments=(Garment(key=key),))
        case "hair":
            look = CharacterLook(hair=key)
        case _:
            look = None
    params: dict[str, ParamValue] = {"material": key} if kind == "materials" else {}
    canonical = CanonicalAsset(
        source="person" if look else "catalog",
        key="crate" if params else key,
        params=params,
        dimensions=(1, 1, 1),
        digest="",
    )
    asset_type = "character" if look else "object"
    return Asset(asset_id=key, asset_type=asset_type, description=key, look=look, canonical=canonical)


def story_of(kind: str, key: str) -> ContinuityMemoryGraph | None:
    """Return a story that shows an entry; None for what is shown alone.

    Args:
        kind: Catalogue, a key of ``studio.CATALOGS``.
        key: Of the entry in it.
    """
    match kind:
        case "sets":
            return _set_story(key)
        case "motions":
            return _motion_story(key)
        case "looks":
            return _look_story()
    return None


def _set_story(key: str) -> ContinuityMemoryGraph:
    """Return the establishing shot of an empty set."""
    instruction = CameraInstruction(kind="establishing", size="WS")
    return _story(key, ShotContext(scene_id=1, shot_id=1, camera_instruction=instruction))


def _look_story() -> ContinuityMemoryGraph:
    """Return a story of one person in a café: skin, cloth, wood, lamps and a background."""
    instruction = CameraInstruction(focus_on_ids=(_ACTOR.asset_id,), kind="single", size="MS")
    return _story("cafe", _shot(instruction, _ACTOR), _ACTOR)


def _motion_story(key: str) -> ContinuityMemoryGraph:
    """Return a story of one person who performs a motion, with the partner and the things that it needs."""
    motion = MOTIONS[key]
    partner = (_CHILD if key == "lift" else _PARTNER,) if motion.reach == "person" else ()
    names = [found[key] for found in (_THINGS, _HELD) if key in found]
    things = [
        Asset(asset_id=name.replace(" ", "_"), asset_type="object", name=name, description=name) for name in names
    ]
    targets = [asset.asset_id for asset in (*partner, *things)]
    action = CharacterAction(
        asset_id=_ACTOR.asset_id,
        action_description=motion.name,
        motion=key,
        target_id=targets[0] if targets else None,
        prop_id=things[-1].asset_id if things else None,
    )
    people = (_ACTOR, *partner)
    instruction = CameraInstruction(
        focus_on_ids=tuple(person.asset_id for person in people), kind="two_shot" if partner else "action", size="FS"
    )
    held = tuple(thing.asset_id for thing in things if key in _HELD)
    shot = _shot(instruction, *people, action=action, posture=_FROM.get(key, "stand"), held=held)
    shot = shot.model_copy(update={"duration": round((motion.seconds + 1) * ProjectFormat().fps)})
    return _story("waiting_room", shot, *people, *things)


def _shot(
    instruction: CameraInstruction,
    *people: Asset,
    action: CharacterAction | None = None,
    posture: Posture = "stand",
    held: tuple[str, ...] = (),
) -> ShotContext:
    names = tuple(person.asset_id for person in people)
    states = [BodyState(asset_id=name) for name in names]
    states[0] = states[0].model_copy(update={"posture": posture, "held": held})
    return ShotContext(
        scene_id=1,
        shot_id=1,
        on_stage=names,
        in_frame=names,
        states=tuple(states),
        character_actions=(action,) if action else (),
        camera_instruction=instruction,
        duration=72,
    )


def _story(kit: str, shot: ShotContext, *assets: Asset) -> ContinuityMemoryGraph:
    setup = SceneSetup(
        place=SETS[kit].name,
        kit=kit,
        scene_type="indoor" if SETS[kit].indoor else "outdoor",
        asset_ids=tuple(asset.asset_id for asset in assets),
    )
    outline = SceneOutline(scene_id=1, scene_description=SETS[kit].name, shots=(ShotOutline(shot_id=1),))
    return ContinuityMemoryGraph(
        title="A sample",
        format=ProjectFormat(width=WIDTH),
        outline=(outline,),
        assets=assets,
        scenes=(SceneContext(scene_id=1, setup=setup),),
        shots=(shot,),
    )
