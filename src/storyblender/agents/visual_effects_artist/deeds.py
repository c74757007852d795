"""What an action of the script comes to on this stage: with whom, with what, and by which motion. Pure."""

from __future__ import annotations

import math
from collections.abc import Mapping

from storyblender.agents.visual_effects_artist.company import Company
from storyblender.agents.visual_effects_artist.handling import fits_in_clothes
from storyblender.agents.visual_effects_artist.person import Person
from storyblender.catalog.motions import IN_THEIR_SEAT, MOTIONS, Motion, clip_of
from storyblender.memory.shot_context import BodyState, CharacterAction

WITH_SOMEBODY = {"take": "touch", "catch": "touch", "pick_up": "lift", "hold": "hug"}
"""Motion with a prop -> the motion with a person in its place."""
CALL = "phone"
LIGHTER = 0.82
"""Largest stature of a lifted person, as a share of the lifter's."""
BLOWS = frozenset({"hit", "punch", "slap"})
"""Blows that things get too."""
TO_A_THING = {"give": "put_down", "hug": "hold", "lift": "pick_up", "grab": "pick_up", "push_away": "push"}
"""Motion with a person -> the motion with a prop in their place; motions that are not listed touch the prop."""
GRASPED = frozenset({"hold", "take", "catch", "pick_up"})
"""What is done to a thing that nobody can carry by laying a hand on it: a lamp post, a railing."""
TALL = 2.2
"""Metres of what stands too tall to be picked up where it stands."""


class Deeds:
    """Says what the people of a shot do where the words leave it open.

    Args:
        company: The people and props of the scene.
        ends: Each person's state at the end of the shot, by asset id.
    """

    def __init__(self, company: Company, ends: Mapping[str, BodyState]) -> None:
        self.company, self.ends = company, ends

    def prop_of(self, action: CharacterAction, person: Person) -> str | None:
        """Return the thing an action handles, if it is one that can be carried: a lamp post stays where it stands.

        A call is on the phone in the hand.
        """
        held = next(iter(person.held.values()), None) if clip_of(action.motion).key == CALL else None
        if held is not None and action.prop_id is None:
            return held
        prop, thing = self.company.prop_of(action), self.company.floor.thing(action.target_id)
        stands_fast = thing is not None and thing.size[2] > TALL
        return None if prop != action.prop_id and stands_fast else prop

    def meant(
        self, action: CharacterAction, motion: Motion, person: Person, prop: str | None, instead: Person | None
    ) -> Motion:
        """Return what is done: with somebody instead of a thing, going where there is nothing to climb, putting away
        what is hidden, laying a hand on what cannot be taken along, swimming where one floats."""
        if motion.key == "climb" and self.company.floor.thing(action.target_id) is None:
            return MOTIONS["walk"]
        if motion.key == "hide" and prop is not None and prop == action.prop_id:
            return MOTIONS["pocket" if fits_in_clothes(self.company.size_of(prop)) else "hide_behind"]
        if motion.key in GRASPED and prop is None and instead is None and self.company.floor.thing(action.target_id):
            return MOTIONS["touch"]
        if person.posture == "float" and motion.speed is not None and not action.prop_id:
            return MOTIONS["float"]
        if motion.before and person.posture not in motion.before and self._stays(person):
            return MOTIONS[IN_THEIR_SEAT.get(motion.key, "idle")]
        if instead is None or motion.key not in WITH_SOMEBODY:
            return motion
        key = WITH_SOMEBODY[motion.key]
        return MOTIONS["hug" if key == "lift" and instead.scale > LIGHTER * person.scale else key]

    def _stays(self, person: Person) -> bool:
        """Tell whether the script keeps a person in a posture, such as seated, to the end of the shot."""
        state = self.ends.get(person.asset_id)
        return state is not None and not person.upright and state.posture == person.posture

    def with_whom(self, action: CharacterAction, person: Person, prop: str | None) -> tuple[Motion, Person | None]:
        """Return the motion of an action and the other person in it.

        A thing is hit with what is in both hands, with a tool, or with the fist; what is named and is no person is
        touched where it is. A partner without a name in the script is the nearest person, but who sits and hits
        nobody that is named beats time on their own knees.
        """
        motion = clip_of(action.motion)
        partner = self.company.people.get(action.target_id or "")
        if partner is not None and partner.present and partner is not person:
            return motion, partner
        if motion.reach != "person":
            return motion, None
        if motion.key in BLOWS and (prop is not None or self.company.floor.thing(action.target_id) is not None):
            return MOTIONS[("slam", "hammer", "drum")[min(2, len(person.held))]], None
        if motion.key in BLOWS and action.target_id is None and not person.upright:
            return MOTIONS["drum"], None
        named = self.company.assets.get(action.target_id or "")
        to_a_thing = named is not None and named.asset_type == "object"
        if to_a_thing or (motion.key == "touch" and (prop or action.target_id) and named is None):
            return MOTIONS[TO_A_THING.get(motion.key, "touch")], None
        return motion, self._nearest(person)

    def _nearest(self, person: Person) -> Person | None:
        """Return the partner of an action whose partner the script does not name."""
        others = [p for p in self.company.people.values() if p.present and p is not person]
        return min(others, key=lambda p: math.dist(p.place, person.place), default=None)
