"""Economy: joins the shots of a scene to fit its budget (notes of the director, section 2, last paragraph).

Given up in this order: inserts without a line of their own, split speeches, reactions, talk, actions of one actor, and
last whatever is short and close.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import replace
from heapq import heappop, heappush

from storyblender.agents.director.cutting import size_steps
from storyblender.agents.director.draft import Beat, ShotDraft
from storyblender.agents.director.durations import shot_seconds
from storyblender.agents.director.settings import DirectorSettings
from storyblender.memory.shot_sizes import SHOT_SIZES, ShotSize


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
    scene = _Economy(list(drafts), people, text, settings)
    scene.pictures()
    if settings.shots_per_scene is None:
        return scene.drafts
    for give_up in (
        scene.inserts,
        scene.split_speeches,
        scene.reactions,
        scene._join_talk,
        scene.actor,
        scene.neighbours,
    ):
        give_up()
    return scene.drafts


class _Economy:
    """Joins the shots of one scene step by step."""

    def __init__(self, drafts: list[ShotDraft], people: Collection[str], text: str, settings: DirectorSettings) -> None:
        self.drafts = drafts
        self.people = people
        self.text = text
        self.settings = settings
        self.target = settings.shots_per_scene or 0

    def pictures(self) -> None:
        """Merge the units of each numbered picture into one shot, and drop shots without lines between pictures."""
        if not any(draft.picture is not None for draft in self.drafts):
            return
        kept: list[ShotDraft] = []
        for index, draft in enumerate(self.drafts):
            following = next((later.picture for later in self.drafts[index:] if later.beats), None)
            if not draft.beats and not draft.has_note and following is not None:
                continue
            if kept and draft.picture is not None and kept[-1].picture == draft.picture:
                self._join(kept[-1], draft)
            else:
                kept.append(draft)
        self.drafts = kept

    def inserts(self) -> None:
        """Drop inserts without a line; the shot before widens to show the thing."""
        kept: list[ShotDraft] = []
        surplus = len(self.drafts) - self.target
        for draft in self.drafts:
            if surplus <= 0 or draft.kind != "insert" or draft.beats or draft.has_note or not kept:
                kept.append(draft)
                continue
            surplus -= 1
            if not kept[-1].has_note:
                kept[-1].add_focus(*draft.focus)
                kept[-1].size, kept[-1].kind = _wider(kept[-1].size, "MS"), "action"
        self.drafts = kept

    def split_speeches(self) -> None:
        """Give a long speech that was cut to its listener back to the speaker."""
        kept: list[ShotDraft] = []
        surplus = len(self.drafts) - self.target
        for draft in self.drafts:
            before = kept[-1].beats if kept else []
            goes_on = draft.beats and before and before[-1].unit is draft.beats[0].unit
            if surplus <= 0 or draft.kind != "reaction" or draft.has_note or not goes_on:
                kept.append(draft)
                continue
            surplus -= 1
            before[-1] = Beat.whole(before[-1].unit)
            before += draft.beats[1:]
        self.drafts = kept

    def reactions(self) -> None:
        """Fold a reaction into the shot beside it."""
        self._join_closest(lambda a, b: a.kind == "reaction" or b.kind == "reaction", self._distance)

    def _join_talk(self) -> None:
        """Join neighbouring speeches of one conversation into the two-shot; the last word is kept longest."""
        last = next((draft for draft in reversed(self.drafts) if draft.speech_only), None)

        def cost(a: ShotDraft, b: ShotDraft) -> float:
            return self._seconds(a, b) + (3.0 if b is last else 0.0)

        def joined(a: ShotDraft, b: ShotDraft) -> None:
            nonlocal last
            last = a if b is last else last

        self._join_closest(lambda a, b: a.speech_only and b.speech_only and _one_conversation(a, b), cost, joined)

    def actor(self) -> None:
        """Join what one actor does, and says right after it."""

        def fits(a: ShotDraft, b: ShotDraft) -> bool:
            return a.kind != "establishing" and _is_subset(self._faces(a), self._faces(b))

        self._join_closest(fits, self._distance)

    def neighbours(self) -> None:
        """Join neighbours that are short and close."""
        self._join_closest(lambda a, b: True, self._distance)

    def _join_closest(
        self,
        fits: Callable[[ShotDraft, ShotDraft], bool],
        cost: Callable[[ShotDraft, ShotDraft], float],
        joined: Callable[[ShotDraft, ShotDraft], None] = lambda a, b: None,
    ) -> None:
        """Join the two neighbours that cost least, then the next two, until the target is met; the first wins a tie.

        Args:
            fits: Whether two neighbours may be joined here, besides that they may share a shot at all.
            cost: Of joining two neighbours; depends on these two alone.
            joined: Told of every join.
        """
        drafts: list[ShotDraft | None] = [*self.drafts]
        after = list(range(1, len(drafts) + 1))
        before = list(range(-1, len(drafts) - 1))
        changes = [0] * len(drafts)
        queue: list[tuple[float, int, int, int, int]] = []

        def offer(left: int, right: int) -> None:
            if left < 0 or right >= len(drafts):
                return
            a, b = drafts[left], drafts[right]
            if a and b and self._may_share(a, b) and fits(a, b):
                heappush(queue, (cost(a, b), left, right, changes[left], changes[right]))

        for index in range(len(drafts) - 1):
            offer(index, index + 1)
        surplus = len(drafts) - self.target
        while surplus > 0 and queue:
            _, left, right, *versions = heappop(queue)
            a, b = drafts[left], drafts[right]
            if a is None or b is None or versions != [changes[left], changes[right]]:
                continue
            self._join(a, b)
            joined(a, b)
            surplus -= 1
            drafts[right] = None
            changes[left] += 1
            after[left] = after[right]
            if after[left] < len(drafts):
                before[after[left]] = left
            offer(before[left], left)
            offer(left, after[left])
        self.drafts = [draft for draft in drafts if draft]

    def _may_share(self, a: ShotDraft, b: ShotDraft) -> bool:
        """Whether neighbours are short enough together, and at most one of them was ordered."""
        ordered = (
            a.has_note
            or b.has_note
            or (a.has_key_action and b.has_key_action)
            or a.picture is not None
            or b.picture is not None
        )
        return not ordered and bool(a.beats and b.beats) and self._seconds(a, b) <= self._limit(a, b)

    def _limit(self, a: ShotDraft, b: ShotDraft) -> float:
        """Return the longest that two joined shots may be, in seconds."""
        return self.settings.longest_talk if a.speech_only and b.speech_only else self.settings.longest_action

    def _seconds(self, a: ShotDraft, b: ShotDraft) -> float:
        """Return how long two shots last together."""
        return shot_seconds(a, self.text) + shot_seconds(b, self.text)

    def _distance(self, a: ShotDraft, b: ShotDraft) -> float:
        """How much a join costs: seconds, sizes apart, more for what is to be seen alone, for talk in a wide."""
        apart = 0.0 if a.beats[-1].unit.element == b.beats[0].unit.element else 2.0
        alone = sum(4.0 for draft in (a, b) if draft.kind in ("establishing", "insert"))
        strangers = 0.0 if set(a.focus) & set(b.focus) else 2.0
        strangers += 4.0 if len({*self._faces(a), *self._faces(b)}) > 2 else 0.0
        mixed = 4.0 if a.speech_only != b.speech_only and (a.whole_body or b.whole_body) else 0.0
        return self._seconds(a, b) + abs(size_steps(a.size, b.size)) + apart + alone + strangers + mixed

    def _faces(self, draft: ShotDraft) -> list[str]:
        """Return the people in the focus of a shot."""
        return [each for each in draft.focus if each in self.people]

    def _join(self, a: ShotDraft, b: ShotDraft) -> None:
        """Merge shot ``b`` into ``a``: keep the framing of the one the script orders, else widen to hold both."""
        if b.has_note and not a.has_note:
            ordered = replace(b, beats=a.beats + b.beats, on_stage=list(dict.fromkeys([*a.on_stage, *b.on_stage])))
            vars(a).update(vars(ordered))
            return
        if a.has_note:
            a.beats += b.beats
            a.on_stage = list(dict.fromkeys([*a.on_stage, *b.on_stage]))
            return
        talk = a.speech_only and b.speech_only
        a.size = a.size if a.kind == "establishing" else _wider(a.size, b.size, "MS" if talk else a.size)
        a.add_focus(*([b.over] if b.over else []), *b.focus)
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
            a.add_focus(a.over)
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
    """Return the widest of some shot sizes."""
    return min(sizes, key=SHOT_SIZES.index)


def _is_subset(one: list[str], other: list[str]) -> bool:
    """Whether one of two focuses contains the other."""
    return bool(one and other) and (set(one) <= set(other) or set(other) <= set(one))


def _one_conversation(a: ShotDraft, b: ShotDraft) -> bool:
    """Whether two shots have the same line, or share a speaker or listener."""
    if a.axis and b.axis:
        return set(a.axis) == set(b.axis)
    return bool({*a.focus, a.over} & {*b.focus, b.over} - {None})
