"""Eq. 1: accept, refine, hand over."""

from __future__ import annotations

from storyblender.errors import NoAnswer
from storyblender.reflection import Critique, Fault, Outcome, Role, Typed, reflect
from storyblender.trace import Event


class Climber:
    """Starts at a score and gains one at each refinement, up to a ceiling."""

    def __init__(self, start: float, ceiling: float) -> None:
        self.start, self.ceiling = start, ceiling

    def propose(self, view: str) -> float:
        return self.start

    def refine(self, draft: float, critique: Critique, view: str) -> float:
        return min(draft + 1, self.ceiling)


class Scale:
    def judge(self, draft: float, view: str) -> Critique:
        return Critique(
            score=draft, faults=(Fault(kind="low", message=f"only {draft}", fix={"add": 1}),) if draft < 8 else ()
        )


def run(policy: Climber, fallback: Climber | None = None, horizon: int = 5) -> tuple[Outcome[str, float], list[Event]]:
    events: list[Event] = []
    policies = (policy,) if fallback is None else (policy, fallback)
    role = Role("role", str, policies, Scale(), Typed(float), horizon=horizon)
    outcome = reflect(role, "x", "view", events.append)
    return outcome, events


def test_refines_until_the_threshold() -> None:
    outcome, events = run(Climber(5, 10))
    assert (outcome.draft, outcome.turns, outcome.handed_over, outcome.accepted) == (8, 3, False, True)
    assert [event.score for event in events if event.kind == "score"] == [5, 6, 7, 8]


def test_every_proposal_score_and_fix_is_told() -> None:
    _, events = run(Climber(7, 10))
    assert [(event.kind, event.turn, event.message) for event in events] == [
        ("propose", 0, "7"), ("score", 0, ""), ("refine", 1, "8"), ("score", 1, ""), ("accept", 1, ""),
    ]  # fmt: skip
    assert events[2].details == ("only 7: add 1",)


def test_hands_over_after_the_horizon() -> None:
    outcome, events = run(Climber(2, 4), fallback=Climber(9, 9))
    assert outcome.handed_over and outcome.draft == 9
    assert [event.kind for event in events].count("handover") == 1


def test_keeps_the_best_where_nobody_converges() -> None:
    outcome, _ = run(Climber(2, 4), fallback=Climber(3, 3), horizon=2)
    assert (outcome.draft, outcome.handed_over, outcome.accepted) == (4, False, False)


def test_score_never_falls_under_one() -> None:
    assert Critique.of(tuple(Fault(kind="x", message="", severity=4) for _ in range(5))).score == 1


class Silent:
    """A model whose server is gone, after some answers."""

    def __init__(self, drafts: list[float]) -> None:
        self.drafts = iter(drafts)

    def propose(self, view: str) -> float:
        return self.refine(0, Critique.of(()), view)

    def refine(self, draft: float, critique: Critique, view: str) -> float:
        try:
            return next(self.drafts)
        except StopIteration:
            raise NoAnswer("the server is gone") from None


def test_where_no_answer_comes_the_next_policy_takes_over() -> None:
    events: list[Event] = []
    role = Role("role", str, (Silent([]), Climber(8, 8)), Scale(), Typed(float))
    outcome = reflect(role, "x", "view", events.append)
    assert (outcome.draft, outcome.handed_over) == (8, True)
    assert [event.message for event in events if event.kind == "warning"] == ["the server is gone"]
    assert [event.message for event in events if event.kind == "handover"] == ["the rules take over as role"]


def test_that_one_rule_follows_another_is_in_the_trace_and_not_said() -> None:
    events: list[Event] = []
    reflect(
        Role("role", str, (Climber(2, 2), Climber(9, 9)), Scale(), Typed(float), rules=2), "x", "view", events.append
    )
    assert [event.message for event in events if event.kind == "handover"] == [""]


def test_the_best_draft_before_the_silence_is_kept() -> None:
    role = Role("role", str, (Silent([7]), Climber(3, 3)), Scale(), Typed(float))
    outcome = reflect(role, "x", "view")
    assert (outcome.draft, outcome.handed_over) == (7, False)


def test_several_policies_of_rules_are_no_models() -> None:
    policies = (Climber(9, 9), Climber(2, 2), Climber(3, 3))
    for rules, by in ((1, "model"), (2, "model"), (3, "rules")):
        role = Role("role", str, policies, Scale(), Typed(float), rules=rules)
        assert reflect(role, "x", "view").by == by
