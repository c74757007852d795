"""What two do together: going to somebody, embracing, dancing, handing over, and parting again. Pure."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.visual_effects_artist.company import Company
from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.floor import BODY, facing
from storyblender.agents.visual_effects_artist.handling import Handling
from storyblender.agents.visual_effects_artist.person import SEATED, Person
from storyblender.catalog.carrying import hand_towards
from storyblender.catalog.motions import MOTIONS, Motion, clip_of, natural_seconds
from storyblender.geometry.paths import Vec2
from storyblender.memory.shot_context import CharacterAction

TOGETHER = frozenset({"hug", "kiss"})
HELD_ON = TOGETHER | {"dance"}
"""What goes on until the shot ends, where nothing comes after it."""
MUTUAL = HELD_ON | {"shake_hands"}
"""Who does this with somebody who does it with them does it once."""
EMPTY_HANDED = frozenset({"hug", "dance", "lift"})
"""What both do with both hands."""
QUIET = frozenset({"idle", "listen", "look"})
LOW = frozenset({"kneel", "crouch"})
BY_KNEES = 1.1
"""Metres from which who kneels reaches somebody without getting up."""
IN_ARMS = 0.08
"""Metres more than an embrace's distance that are not walked."""
TO_KNEEL = 0.72
"""Metres from somebody to who kneels to them."""
BEFORE_SITTER, BY_EDGE, BESIDE_KNEES, APART = 0.68, 0.25, 0.42, 0.45
"""Metres from a seat's edge to who bends to the one who sits there: before them, or beside their knees, so far
aside and so far from others."""
FAR = 0.4
"""Metres more than its distance from which who sits, lies or kneels does not reach the other."""
TOO_NEAR = 0.17
"""Metres less than its distance from which one who meets somebody steps back."""
PARTED = 0.72
"""Metres between two after an embrace: who came to the other steps back."""


class Meetings:
    """Writes what people do with each other.

    Args:
        company: People and props.
        sheet: Where the cues go.
        hands: Puts aside what is in the way.
    """

    def __init__(self, company: Company, sheet: CueSheet, hands: Handling) -> None:
        self.company, self.sheet, self.hands = company, sheet, hands

    def already(self, motion: Motion, person: Person, partner: Person | None) -> bool:
        """Tell whether this is the other half of what the partner has just begun: ``they kiss``."""
        if partner is None or motion.key not in MUTUAL:
            return False
        pair = (person.asset_id, partner.asset_id)
        own = [cue for cue in self.sheet.cues if cue.asset_id in pair and cue.clip not in QUIET]
        last = max(own, key=lambda cue: cue.start, default=None)
        return last is not None and (last.clip, last.asset_id, last.target_id) == (motion.key, *pair[::-1])

    def meet(
        self,
        action: CharacterAction,
        motion: Motion,
        person: Person,
        partner: Person,
        prop: str | None,
        later: Sequence[CharacterAction],
    ) -> None:
        """Go to somebody and do something together."""
        if motion.key in TOGETHER and person.posture in SEATED and partner.posture not in SEATED:
            person, partner = partner, person  # to who sits the other comes
        start = self.sheet.earliest_start(person)
        giving = motion.key == "give"
        if giving and prop is not None and not person.hand_of(prop):
            self.sheet.start_with_prop_in_hand(person, prop)
        t = self._hands_ready(motion, person, partner, prop, start)
        t = self._gone_to(motion, person, partner, t)
        t = self._face_each_other(person, partner, max(t, partner.busy))
        hand = person.hand_of(prop) if prop else None
        about = {"target_id": partner.asset_id, "prop_id": prop, "hand": hand, "mood": action.mood}
        if motion.key in HELD_ON and not self._goes_on(motion, person, partner, later):
            about["duration"] = round(self.sheet.hard_limit * self.sheet.fps)
            parted = self._parted(motion, person, partner)
            if parted is not None:
                self.company.jumps[person.asset_id] = (parted, person.yaw)
        elif (parted := self._parted(motion, person, partner)) is not None:
            person.place = parted
            about["mark"] = person.mark()
        end = self.sheet.add_cue(person, motion.key, t, natural_seconds(motion), **about)
        if prop is not None and giving:
            self.company.hand_over(partner, prop, hand_towards(partner.place, partner.yaw, person.place))
        elif prop is not None and motion.key == "take":
            self.company.hand_over(person, prop, hand_towards(person.place, person.yaw, partner.place))
        partner.busy = max(partner.busy, end)
        self.sheet.finish_action(person, start, end, holds=True)

    def _hands_ready(self, motion: Motion, person: Person, partner: Person, prop: str | None, t: float) -> float:
        """Put aside or take over into the left hand what the hands hold that are wanted; return the end."""
        ends = [t]
        for one in (person, partner):
            if motion.key == "shake_hands":
                if "R" in one.held:
                    self.sheet.move_to_other_hand(one, one.held["R"])
                continue
            held = [name for name in dict.fromkeys(one.held.values()) if name != prop]
            takes = one is (partner if motion.key == "give" else person) and motion.key in ("give", "take")
            if motion.key in EMPTY_HANDED or (takes and self.company.full_handed(one)):
                largest = sorted(held, key=lambda name: self.company.size_of(name) or [], reverse=True)
                ends.append(self.hands.put_props_aside(one, largest[:1] if takes else largest, max(t, one.busy)))
        return max(ends)

    def _gone_to(self, motion: Motion, person: Person, partner: Person, t: float) -> float:
        """Go to where the two can do it, and kneel to who lies on the floor; return the end."""
        distance = motion.distance * 0.5 * (person.scale + partner.scale)
        if partner.posture in SEATED:
            distance = max(distance, 0.68)
        gap = math.dist(person.place, partner.place)
        near = IN_ARMS if motion.key in TOGETHER else 0.3
        by_knees = distance + near if motion.key in TOGETHER and partner.posture in SEATED else BY_KNEES
        low = person.posture in SEATED or (person.posture in LOW and gap < by_knees)
        on_floor = partner.posture in ("lie", "asleep") and partner.support is None
        if low and gap > distance + FAR:
            if partner.upright:
                return self._come_to(motion, person, partner, distance, t)
            low = False  # gets up: nobody else is able to come
        if not low and (gap > distance + near or gap < distance - TOO_NEAR):
            spot, _ = self.sheet.find_spot_beside(person, partner, distance)
            toward = partner.place
            if motion.key in TOGETHER and partner.posture == "sit":
                spot = self._before(partner, person) or spot
            elif on_floor:
                spot, toward = self._beside_breast(partner, person)
            t = self.sheet.walk_to(person, spot, facing(spot, toward), t, then=natural_seconds(motion))
        if on_floor and person.upright:
            t = self.sheet.add_cue(person, "kneel", t, natural_seconds(MOTIONS["kneel"]))
            person.posture = "kneel"
        return t

    def _come_to(self, motion: Motion, person: Person, partner: Person, distance: float, t: float) -> float:
        """Bring somebody to who sits, lies or kneels and has something for them; return the end."""
        spot = self._before(person, partner) if person.posture == "sit" else None
        spot = spot or self.sheet.find_spot_beside(partner, person, max(distance, BEFORE_SITTER))[0]
        return self.sheet.walk_to(partner, spot, facing(spot, person.place), max(t, partner.busy))

    def _goes_on(self, motion: Motion, person: Person, partner: Person, later: Sequence[CharacterAction]) -> bool:
        """Tell whether one of two does something after what they do together."""
        pair = {person.asset_id: partner.asset_id, partner.asset_id: person.asset_id}
        for action in later:
            key = clip_of(action.motion).key
            mutual = key == motion.key and action.target_id == pair.get(action.asset_id)
            if action.asset_id in pair and key not in QUIET and not mutual:
                return True
        return False

    def _parted(self, motion: Motion, person: Person, partner: Person) -> Vec2 | None:
        """Return where somebody stands who has stepped back from an embrace; None where they stay."""
        if motion.key not in TOGETHER or not person.upright or not partner.upright:
            return None
        gap = math.dist(person.place, partner.place)
        share = PARTED * 0.5 * (person.scale + partner.scale) / max(gap, 0.05)
        (x, y), (px, py) = partner.place, person.place
        spot = x + (px - x) * share, y + (py - y) * share
        return spot if share > 1 and self.company.floor.room_at(spot) > BODY * person.scale else None

    def _face_each_other(self, person: Person, partner: Person, t: float) -> float:
        """Turn two towards each other, at the same time; return when both have."""
        ends = [t]
        for one, other in ((person, partner), (partner, person)):
            if one.upright and other.posture not in ("lie", "asleep"):
                yaw = facing(one.place, other.place)
                ends.append(self.sheet.turn_to_yaw(one, yaw, t))
                one.yaw, one.acted = yaw, True
        return max(ends)

    def knees_to(self, person: Person, partner: Person) -> tuple[Vec2, Vec2]:
        """Return where one kneels to somebody, and to what of theirs."""
        if partner.posture in ("lie", "asleep") and partner.support is None:
            return self._beside_breast(partner, person)
        return self.sheet.find_spot_beside(person, partner, TO_KNEEL)[0], partner.place

    def _beside_breast(self, partner: Person, person: Person) -> tuple[Vec2, Vec2]:
        """Return where one kneels beside somebody who lies on the floor, feet where they stood, and their breast."""
        ahead, right = (math.sin(partner.yaw), -math.cos(partner.yaw)), (math.cos(partner.yaw), math.sin(partner.yaw))
        x, y = (v - 0.75 * partner.scale * a for v, a in zip(partner.place, ahead, strict=True))
        sides = [(x + way * 0.6 * right[0], y + way * 0.6 * right[1]) for way in (1, -1)]
        room = self.company.floor.room_at
        spot = max(sides, key=lambda side: 4 * min(0.3, room(side)) - math.dist(side, person.place))
        return spot, (x, y)

    def _before(self, partner: Person, person: Person) -> Vec2 | None:
        """Return the place beside the knees of somebody who sits, else before them, if there is room."""
        (x, y), yaw = partner.place, partner.yaw
        others = [spot for spot in self.company.others(person) if spot != partner.place]
        aside, room = BESIDE_KNEES * person.scale, 0.8 * BODY * person.scale
        places = [(BY_EDGE, aside), (BY_EDGE, -aside), (BEFORE_SITTER, 0.0)]
        spots = [
            (x + ahead * math.sin(yaw) + left * math.cos(yaw), y - ahead * math.cos(yaw) + left * math.sin(yaw))
            for ahead, left in places
        ]
        free = [
            spot
            for spot in spots
            if self.company.floor.room_at(spot) > room and all(math.dist(spot, other) > APART for other in others)
        ]
        beside = [spot for spot in free if spot != spots[-1]]
        return min(beside or free, key=lambda spot: math.dist(spot, person.place), default=None)
