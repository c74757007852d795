"""Economy: as few boards as the scene can bear (notes of the director, section 2, last paragraph).

Given up in this order: inserts without a line of their own, reactions, over-the-shoulder pairs (they become the
two-shot), neighbouring actions of one actor, any close neighbours. What the script orders is never given up, and no
word of the script is lost: what a dropped shot covered goes to its neighbour. Two strong acts keep two pictures.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from itertools import pairwise

from storyblender.agents.director.cutting import step
from storyblender.agents.director.draft import Beat, ShotDraft
from storyblender.agents.director.durations import shot_seconds
from storyblender.agents.director.settings import DirectorSettings
from storyblender.memory.vocabulary import SHOT_SIZES, ShotSize

Pair = tuple[ShotDraft, ShotDraft]


def economise(
    drafts: list[ShotDraft], people: Collection[str], text: str, settings: DirectorSettings
) -> list[ShotDraft]:
    """Return the shots of one scene, joined until the target is met or nothing can be given up.

    Args:
        drafts: Full coverage.
        people: Ids of people, to tell faces from things in a focus.
        text: The script.
        settings: Target and longest shot.
    """
    kept = list(drafts)
    if settings.shots_per_scene is None:
        return kept
    scene = _Economy(kept, people, text, settings)
    for give_up in (scene.insert, scene.reaction, scene.talk, scene.actor, scene.neighbours):
        while len(kept) > settings.shots_per_scene and give_up():
            pass
    return kept


class _Economy:
    def __init__(self, drafts: list[ShotDraft], people: Collection[str], text: str, settings: DirectorSettings) -> None:
        self.drafts = drafts
        self.people = people
        self.text = text
        self.settings = settings

    def insert(self) -> bool:
        """Drop an insert without a line; the shot before widens to show the thing."""
        for index, draft in enumerate(self.drafts):
            if draft.kind == "insert" and not draft.beats and not draft.explicit and index:
                before = self.drafts[index - 1]
                if not before.explicit:
                    before.look_at(*draft.focus)
                    before.size, before.kind = _wider(before.size, "MS"), "action"
                del self.drafts[index]
                return True
        return False

    def reaction(self) -> bool:
        """Give a long speech back to its speaker, or fold a reaction into the shot beside it."""
        for index, draft in enumerate(self.drafts):
            if draft.kind != "reaction" or draft.explicit or not index:
                continue
            before = self.drafts[index - 1]
            if draft.beats and before.beats and before.beats[-1].unit is draft.beats[0].unit:
                before.beats[-1] = Beat.whole(before.beats[-1].unit)
                before.beats += draft.beats[1:]
                del self.drafts[index]
                return True
        pairs = [pair for pair in self._pairs() if any(draft.kind == "reaction" for draft in pair)]
        return self._join_best(pairs, self._distance)

    def talk(self) -> bool:
        """Join neighbouring speeches of one conversation into the two-shot; the last word is kept longest."""
        pairs = [(a, b) for a, b in self._pairs() if a.speech and b.speech and _one_conversation(a, b)]
        speeches = [draft for draft in self.drafts if draft.speech]
        return self._join_best(pairs, lambda a, b: self._seconds(a, b) + (3.0 if b is speeches[-1] else 0.0))

    def actor(self) -> bool:
        """Join what one actor does, and says right after it."""
        pairs = [(a, b) for a, b in self._pairs() if self._faces(a) and _nested(self._faces(a), self._faces(b))]
        return self._join_best([(a, b) for a, b in pairs if a.kind != "establishing"], self._distance)

    def neighbours(self) -> bool:
        """Join whatever is short and close."""
        return self._join_best(self._pairs(), self._distance)

    def _pairs(self) -> list[Pair]:
        """Neighbours that may share a shot: short enough together, and only one of them wants a picture of its own."""
        return [
            (a, b)
            for a, b in pairwise(self.drafts)
            if not (a.explicit or b.explicit or (a.strong and b.strong))
            and a.beats
            and b.beats
            and self._seconds(a, b) <= self._limit(a, b)
        ]

    def _limit(self, a: ShotDraft, b: ShotDraft) -> float:
        return self.settings.longest_talk if a.speech and b.speech else self.settings.longest_action

    def _seconds(self, a: ShotDraft, b: ShotDraft) -> float:
        return shot_seconds(a, self.text) + shot_seconds(b, self.text)

    def _distance(self, a: ShotDraft, b: ShotDraft) -> float:
        """How much a join costs: seconds, sizes apart, more for what is to be seen alone, for talk in a wide."""
        apart = 0.0 if a.beats[-1].unit.element == b.beats[0].unit.element else 2.0
        alone = sum(4.0 for draft in (a, b) if draft.kind in ("establishing", "insert"))
        strangers = 0.0 if set(a.focus) & set(b.focus) else 2.0
        strangers += 4.0 if len({*self._faces(a), *self._faces(b)}) > 2 else 0.0
        mixed = 4.0 if a.speech != b.speech and (a.whole_body or b.whole_body) else 0.0
        return self._seconds(a, b) + abs(step(a.size, b.size)) + apart + alone + strangers + mixed

    def _join_best(self, pairs: list[Pair], cost: Callable[[ShotDraft, ShotDraft], float]) -> bool:
        if not pairs:
            return False
        a, b = min(pairs, key=lambda pair: cost(*pair))
        self._join(a, b)
        self.drafts[:] = [draft for draft in self.drafts if draft is not b]
        return True

    def _faces(self, draft: ShotDraft) -> list[str]:
        return [each for each in draft.focus if each in self.people]

    def _join(self, a: ShotDraft, b: ShotDraft) -> None:
        """Let ``a`` tell ``b`` as well: wide enough for both, on the people of both."""
        talk = a.speech and b.speech
        a.size = a.size if a.kind == "establishing" else _wider(a.size, b.size, "MS" if talk else a.size)
        a.look_at(*([b.over] if b.over else []), *b.focus)
        a.focus.sort(key=lambda each: each not in self.people)
        a.beats += b.beats
        a.on_stage = list(dict.fromkeys([*a.on_stage, *b.on_stage]))
        a.axis = a.axis or b.axis
        a.whole_body = a.whole_body or b.whole_body
        if a.kind == "establishing":
            return
        a.movement = b.movement if a.movement == "static" else a.movement
        a.angle = a.angle if a.angle == b.angle else "eye-level"
        if a.over:
            a.look_at(a.over)
        a.over = None
        faces = self._faces(a)
        if talk and a.axis and len(faces) == 2:
            a.kind, a.size = "two_shot", _wider(a.size, "MS")
        elif len(faces) > 2:
            a.kind, a.size, a.focus = "group", _wider(a.size, "MWS"), faces
        else:
            a.kind = "single" if talk else "action"
            a.size = _wider(a.size, "MS") if len(faces) > 1 else a.size


def _wider(*sizes: ShotSize) -> ShotSize:
    return min(sizes, key=SHOT_SIZES.index)


def _nested(one: list[str], other: list[str]) -> bool:
    return bool(one and other) and (set(one) <= set(other) or set(other) <= set(one))


def _one_conversation(a: ShotDraft, b: ShotDraft) -> bool:
    if a.axis and b.axis:
        return set(a.axis) == set(b.axis)
    return bool({*a.focus, a.over} & {*b.focus, b.over} - {None})
