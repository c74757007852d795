"""Resolves an action of the script on the stage: its prop, its partner, and the motion that can be played."""

from __future__ import annotations

import math
from collections.abc import Mapping

from storyblender.agents.visual_effects_artist.handling import fits_in_clothes
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.catalog.motions import IN_THEIR_SEAT, MOTIONS, Motion
from storyblender.memory.shot_context import BodyState, CharacterAction

MOTION_WITH_PERSON = {"take": "touch", "catch": "touch", "pick_up": "lift", "hold": "hug"}
"""Motion with a prop -> the motion with a person in its place."""
PHONE_CALL = "phone"
"""Activity of a telephone call."""
MAX_LIFTED_STATURE = 0.82
"""Largest stature of a lifted person, as a share of the lifter's."""
BLOWS = frozenset({"hit", "punch", "slap"})
"""Blows that also hit things."""
MOTION_WITH_PROP = {"give": "put_down", "hug": "hold", "lift": "pick_up", "grab": "pick_up", "push_away": "push"}
"""Motion with a person -> the motion with a prop in their place; motions that are not listed touch the prop."""
GRASPED = frozenset({"hold", "take", "catch", "pick_up"})
"""Motions that only touch a thing which nobody can carry, such as a lamp post or a railing."""
FIXED_HEIGHT = 2.2
"""Height in metres above which a thing is not picked up."""


class ActionResolver:
    """Chooses prop, partner and motion of an action where the script leaves them open.

    Args:
        stage: The people and props of the scene.
        ends: Each person's state at the end of the shot, by asset id.
    """

    def __init__(self, stage: StageState, ends: Mapping[str, BodyState]) -> None:
        self.stage, self.ends = stage, ends

    def prop_of(self, action: CharacterAction, person: StagedPerson) -> str | None:
        """Return the asset id of the prop that a person handles in an action; a call uses the phone in their hand.

        Args:
            action: The action in the script.
            person: The person who does it.

        Returns:
            None for a thing that cannot be carried, such as a lamp post.
        """
        held = next(iter(person.held.values()), None) if action.motion == PHONE_CALL else None
        if held is not None and action.prop_id is None:
            return held
        prop, thing = self.stage.prop_of(action), self.stage.floor.thing(action.target_id)
        if prop is not None and self._fitted_part(prop):
            return None
        stands_fast = thing is not None and thing.size[2] > FIXED_HEIGHT
        return None if prop != action.prop_id and stands_fast else prop

    def resolve_motion(
        self,
        action: CharacterAction,
        motion: Motion,
        person: StagedPerson,
        prop: str | None,
        instead: StagedPerson | None,
    ) -> Motion:
        """Return the motion to play instead of one that this person cannot do with this prop or partner.

        Args:
            action: The action in the script.
            motion: The motion of its words.
            person: The person who does it.
            prop: Asset id of the prop; None if there is none.
            instead: The partner in the place of a prop; None if there is none.
        """
        if motion.key == "climb" and self.stage.floor.thing(action.target_id) is None:
            return MOTIONS["walk"]
        if motion.key == "hide" and prop is not None and prop == action.prop_id:
            return MOTIONS["pocket" if fits_in_clothes(self.stage.size_of(prop)) else "hide_behind"]
        if motion.key in GRASPED and prop is None and instead is None and self.stage.floor.thing(action.target_id):
            return MOTIONS["touch"]
        if person.posture == "float" and motion.speed is not None and not action.prop_id:
            return MOTIONS["float"]
        part = self._fitted_part(action.target_id or action.prop_id)
        if part == "steering_wheel" and person.posture == "sit" and motion.hands:
            return MOTIONS["drive"]
        if part and (motion.key in GRASPED or (motion.before and person.posture not in motion.before)):
            return MOTIONS["touch"]
        if motion.before and person.posture not in motion.before and self._keeps_posture(person):
            return MOTIONS[IN_THEIR_SEAT.get(motion.key, "idle")]
        if instead is None or motion.key not in MOTION_WITH_PERSON:
            return motion
        key = MOTION_WITH_PERSON[motion.key]
        return MOTIONS["hug" if key == "lift" and instead.scale > MAX_LIFTED_STATURE * person.scale else key]

    def _fitted_part(self, asset_id: str | None) -> str:
        """Return which part of a vehicle a thing is; empty for any other: a part is reached for where it is."""
        asset = self.stage.assets.get(asset_id or "")
        return asset.fitted_part if asset is not None else ""

    def _keeps_posture(self, person: StagedPerson) -> bool:
        """Tell whether the script keeps a person in a posture, such as seated, to the end of the shot."""
        state = self.ends.get(person.asset_id)
        return state is not None and not person.upright and state.posture == person.posture

    def find_partner(
        self, action: CharacterAction, person: StagedPerson, prop: str | None
    ) -> tuple[Motion, StagedPerson | None]:
        """Return the motion of an action and the other person in it.

        Things are hit with what is in both hands, a tool or a fist. A partner whom the script does not name is the
        nearest person; a seated person who hits nobody drums on their knees.

        Args:
            action: The action in the script.
            person: The person who does it.
            prop: Asset id of the prop; None if there is none.
        """
        motion = MOTIONS[action.motion]
        partner = self.stage.people.get(action.target_id or "")
        if partner is not None and partner.present and partner is not person:
            return motion, partner
        if motion.reach != "person":
            return motion, None
        if motion.key in BLOWS and (prop is not None or self.stage.floor.thing(action.target_id) is not None):
            return MOTIONS[("slam", "hammer", "drum")[min(2, len(person.held))]], None
        if motion.key in BLOWS and action.target_id is None and not person.upright:
            return MOTIONS["drum"], None
        named = self.stage.assets.get(action.target_id or "")
        to_a_thing = named is not None and named.asset_type == "object"
        if to_a_thing or (motion.key == "touch" and (prop or action.target_id) and named is None):
            return MOTIONS[MOTION_WITH_PROP.get(motion.key, "touch")], None
        return motion, self._nearest(person)

    def _nearest(self, person: StagedPerson) -> StagedPerson | None:
        """Return the nearest other person on stage; None if there is none."""
        others = [p for p in self.stage.people.values() if p.present and p is not person]
        return min(others, key=lambda p: math.dist(p.place, person.place), default=None)
