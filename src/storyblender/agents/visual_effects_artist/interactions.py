"""What two people do together: approaching, embracing, dancing, handing over, and stepping back."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.floor import BODY, facing
from storyblender.agents.visual_effects_artist.handling import Handling
from storyblender.agents.visual_effects_artist.person import SEATED, StagedPerson
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.catalog.carrying import hand_towards
from storyblender.catalog.motions import MOTIONS, Motion, natural_seconds
from storyblender.geometry.paths import Vec2
from storyblender.memory.shot_context import CharacterAction

EMBRACES = frozenset({"hug", "kiss"})
LASTING = EMBRACES | {"dance"}
"""Motions that go on to the end of the shot if nothing comes after them."""
MUTUAL = LASTING | {"shake_hands"}
"""Motions that are played once, though the script gives them to both people."""
EMPTY_HANDED = frozenset({"hug", "dance", "lift"})
"""Motions for which both people need both hands."""
QUIET = frozenset({"idle", "stand", "listen", "look"})
LOW = frozenset({"kneel", "crouch"})
REACH_KNEELING = 1.1
"""Metres within which a kneeling person reaches another without getting up."""
EMBRACE_SLACK = 0.08
"""Metres beyond an embrace's distance that are not walked."""
KNEELING_DISTANCE = 0.72
"""Metres between a person and the one they kneel to."""
BEFORE_SITTER, BY_EDGE, BESIDE_KNEES, APART = 0.68, 0.25, 0.42, 0.45
"""Metres from a seat's edge to a person who bends to its sitter: in front of them, or beside their knees;
metres aside there, and from others.
"""
SEATED_SLACK = 0.4
"""Metres beyond a motion's distance from which a seated, lying or kneeling person does not reach the other."""
STEP_BACK_FROM = 0.17
"""Metres below a motion's distance at which a person steps back."""
DISTANCE_AFTER_EMBRACE = 0.72
"""Metres between two people after an embrace, when the one who came has stepped back."""


class Interactions:
    """Writes what two people do together.

    Args:
        stage: People and props.
        sheet: The cue sheet that takes the cues.
        hands: Puts props aside that are in the way.
    """

    def __init__(self, stage: StageState, sheet: CueSheet, hands: Handling) -> None:
        self.stage, self.sheet, self.hands = stage, sheet, hands

    def is_done_by_partner(self, motion: Motion, person: StagedPerson, partner: StagedPerson | None) -> bool:
        """Tell whether an action is the other half of a mutual motion that the partner has just begun: ``they kiss``.

        Args:
            motion: Motion of the action.
            person: The person of the action.
            partner: The other person; None if there is none.
        """
        if partner is None or motion.key not in MUTUAL:
            return False
        pair = (person.asset_id, partner.asset_id)
        own = [cue for cue in self.sheet.cues if cue.asset_id in pair and cue.clip not in QUIET]
        last = max(own, key=lambda cue: cue.start, default=None)
        return last is not None and (last.clip, last.asset_id, last.target_id) == (motion.key, *pair[::-1])

    def act_together(
        self,
        action: CharacterAction,
        motion: Motion,
        person: StagedPerson,
        partner: StagedPerson,
        prop: str | None,
        later: Sequence[CharacterAction],
    ) -> None:
        """Write the cues of an action with a partner, including the walk, the turn to each other and freed hands.

        Args:
            action: The action in the script.
            motion: Its motion.
            person: The person of the action.
            partner: The other person; the walker if only they stand.
            prop: Asset id of a prop that is given or taken; None if there is none.
            later: Actions of the shot after this one.
        """
        if motion.key in EMBRACES and person.posture in SEATED and partner.posture not in SEATED:
            person, partner = partner, person  # the standing person comes to the seated one
        start = self.sheet.earliest_start(person)
        giving = motion.key == "give"
        if giving and prop is not None and not person.hand_of(prop):
            self.sheet.start_with_prop_in_hand(person, prop)
        t = self._free_hands(motion, person, partner, prop, start)
        t = self._approach(motion, person, partner, t)
        t = self._face_each_other(person, partner, max(t, partner.busy))
        hand = person.hand_of(prop) if prop else None
        about = {"target_id": partner.asset_id, "prop_id": prop, "hand": hand, "mood": action.mood}
        if motion.key in LASTING and not self._has_later_action(motion, person, partner, later):
            about["duration"] = round(self.sheet.hard_limit * self.sheet.fps)
            parted = self._place_after_embrace(motion, person, partner)
            if parted is not None:
                self.stage.next_places[person.asset_id] = (parted, person.yaw)
        elif (parted := self._place_after_embrace(motion, person, partner)) is not None:
            person.place = parted
            about["mark"] = person.mark()
        end = self.sheet.add_cue(person, motion.key, t, natural_seconds(motion), **about)
        if prop is not None and giving:
            self.stage.put_in_hand(partner, prop, hand_towards(partner.place, partner.yaw, person.place))
        elif prop is not None and motion.key == "take":
            self.stage.put_in_hand(person, prop, hand_towards(person.place, person.yaw, partner.place))
        partner.busy = max(partner.busy, end)
        self.sheet.finish_action(person, start, end, holds=True)

    def _free_hands(
        self, motion: Motion, person: StagedPerson, partner: StagedPerson, prop: str | None, t: float
    ) -> float:
        """Put aside, or move to the left hand, the props in hands that the motion needs; return the end second."""
        ends = [t]
        for one in (person, partner):
            if motion.key == "shake_hands":
                if "R" in one.held:
                    self.sheet.move_to_other_hand(one, one.held["R"])
                continue
            held = [name for name in dict.fromkeys(one.held.values()) if name != prop]
            takes = one is (partner if motion.key == "give" else person) and motion.key in ("give", "take")
            if motion.key in EMPTY_HANDED or (takes and self.stage.has_hands_full(one)):
                largest = sorted(held, key=lambda name: self.stage.size_of(name) or [], reverse=True)
                ends.append(self.hands.put_props_aside(one, largest[:1] if takes else largest, max(t, one.busy)))
        return max(ends)

    def _approach(self, motion: Motion, person: StagedPerson, partner: StagedPerson, t: float) -> float:
        """Walk to where the motion can be played, and kneel to a person on the floor; return the end second."""
        distance = motion.distance * 0.5 * (person.scale + partner.scale)
        if partner.posture in SEATED:
            distance = max(distance, 0.68)
        gap = math.dist(person.place, partner.place)
        near = EMBRACE_SLACK if motion.key in EMBRACES else 0.3
        by_knees = distance + near if motion.key in EMBRACES and partner.posture in SEATED else REACH_KNEELING
        low = person.posture in SEATED or (person.posture in LOW and gap < by_knees)
        on_floor = partner.posture in ("lie", "asleep") and partner.support is None
        if low and gap > distance + SEATED_SLACK:
            if partner.upright:
                return self._bring_partner(person, partner, distance, t)
            low = False  # the person gets up: the partner cannot come
        if not low and (gap > distance + near or gap < distance - STEP_BACK_FROM):
            spot, _ = self.sheet.find_spot_beside(person, partner, distance)
            toward = partner.place
            if motion.key in EMBRACES and partner.posture == "sit":
                spot = self._place_at_sitter(partner, person) or spot
            elif on_floor:
                spot, toward = self._place_beside_lying(partner, person)
            t = self.sheet.walk_to(person, spot, facing(spot, toward), t, then=natural_seconds(motion))
        if on_floor and person.upright:
            t = self.sheet.add_cue(person, "kneel", t, natural_seconds(MOTIONS["kneel"]))
            person.posture = "kneel"
        return t

    def _bring_partner(self, person: StagedPerson, partner: StagedPerson, distance: float, t: float) -> float:
        """Let the partner walk to a person who sits, lies or kneels; return the end second."""
        spot = self._place_at_sitter(person, partner) if person.posture == "sit" else None
        spot = spot or self.sheet.find_spot_beside(partner, person, max(distance, BEFORE_SITTER))[0]
        return self.sheet.walk_to(partner, spot, facing(spot, person.place), max(t, partner.busy))

    def _has_later_action(
        self, motion: Motion, person: StagedPerson, partner: StagedPerson, later: Sequence[CharacterAction]
    ) -> bool:
        """Tell whether one of the two has another action later in the shot."""
        pair = {person.asset_id: partner.asset_id, partner.asset_id: person.asset_id}
        for action in later:
            mutual = action.motion == motion.key and action.target_id == pair.get(action.asset_id)
            if action.asset_id in pair and action.motion not in QUIET and not mutual:
                return True
        return False

    def _place_after_embrace(self, motion: Motion, person: StagedPerson, partner: StagedPerson) -> Vec2 | None:
        """Return the floor point to which a person steps back from an embrace; None if they stay."""
        if motion.key not in EMBRACES or not person.upright or not partner.upright:
            return None
        gap = math.dist(person.place, partner.place)
        share = DISTANCE_AFTER_EMBRACE * 0.5 * (person.scale + partner.scale) / max(gap, 0.05)
        (x, y), (px, py) = partner.place, person.place
        spot = x + (px - x) * share, y + (py - y) * share
        return spot if share > 1 and self.stage.floor.room_at(spot) > BODY * person.scale else None

    def _face_each_other(self, person: StagedPerson, partner: StagedPerson, t: float) -> float:
        """Turn both people towards each other from second ``t`` on; return the second at which both have turned."""
        ends = [t]
        for one, other in ((person, partner), (partner, person)):
            if one.upright and other.posture not in ("lie", "asleep"):
                yaw = facing(one.place, other.place)
                ends.append(self.sheet.turn_to_yaw(one, yaw, t))
                one.yaw, one.acted = yaw, True
        return max(ends)

    def kneeling_place(self, person: StagedPerson, partner: StagedPerson) -> tuple[Vec2, Vec2]:
        """Return the floor points, metres in the set, at which a person kneels to a partner and to which they face."""
        if partner.posture in ("lie", "asleep") and partner.support is None:
            return self._place_beside_lying(partner, person)
        return self.sheet.find_spot_beside(person, partner, KNEELING_DISTANCE)[0], partner.place

    def _place_beside_lying(self, partner: StagedPerson, person: StagedPerson) -> tuple[Vec2, Vec2]:
        """Return the floor point beside the chest of a partner who lies on the floor, and the point of the chest."""
        ahead, right = (math.sin(partner.yaw), -math.cos(partner.yaw)), (math.cos(partner.yaw), math.sin(partner.yaw))
        x, y = (v - 0.75 * partner.scale * a for v, a in zip(partner.place, ahead, strict=True))
        sides = [(x + way * 0.6 * right[0], y + way * 0.6 * right[1]) for way in (1, -1)]
        room = self.stage.floor.room_at
        spot = max(sides, key=lambda side: 4 * min(0.3, room(side)) - math.dist(side, person.place))
        return spot, (x, y)

    def _place_at_sitter(self, partner: StagedPerson, person: StagedPerson) -> Vec2 | None:
        """Return the floor point beside a seated partner's knees, else in front of them; None if neither is free."""
        (x, y), yaw = partner.place, partner.yaw
        others = [spot for spot in self.stage.others(person) if spot != partner.place]
        aside, room = BESIDE_KNEES * person.scale, 0.8 * BODY * person.scale
        places = [(BY_EDGE, aside), (BY_EDGE, -aside), (BEFORE_SITTER, 0.0)]
        spots = [
            (x + ahead * math.sin(yaw) + left * math.cos(yaw), y - ahead * math.cos(yaw) + left * math.sin(yaw))
            for ahead, left in places
        ]
        free = [
            spot
            for spot in spots
            if self.stage.floor.room_at(spot) > room and all(math.dist(spot, other) > APART for other in others)
        ]
        beside = [spot for spot in free if spot != spots[-1]]
        return min(beside or free, key=lambda spot: math.dist(spot, person.place), default=None)
