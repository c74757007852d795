"""A critic with eyes: a language model looks at a picture of the draft, beside the engine's critic, who computes.

The paper's critics (section 3, appendix on reflection) score 1 to 10 and say in words what is wrong. Here a fault may
also name operations of the role's closed list, so that code can try them.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, Final, Generic

from pydantic import Field, create_model

from storyblender.agents.asking import Answer, Asker, Notes
from storyblender.errors import NoAnswer
from storyblender.memory.request import Picture
from storyblender.reflection import SEEN, UNUSABLE, Critic, Critique, Draft, Fault, View

_GOOD: Final = 8.0
"""Score from which a vision critic accepts (paper, section 3); under it, it has to say what is wrong."""


class SeenFault(Notes):
    """One thing that is wrong with the picture."""

    message: Annotated[str, Field(min_length=1, max_length=300)]
    """One sentence: what is wrong, and where in the picture."""
    subject: str = ""
    """Id of the person or thing it is about, if it is about one."""
    operations: Annotated[tuple[str, ...], Field(max_length=4)] = ()
    """What would mend it, in order."""


class CriticNotes(Notes):
    """What a critic says of the picture."""

    score: Annotated[float, Field(ge=0, le=10)]
    """10: nothing could be better; 8: good; 6: a fault that everyone sees; under 4: it shows the wrong thing."""
    faults: Annotated[tuple[SeenFault, ...], Field(max_length=6)] = ()
    """The worst first; none if the picture is right."""


def critic_notes(operations: Any) -> type[CriticNotes]:
    """Return the answer of a role's vision critic, whose faults name operations of a closed list.

    Args:
        operations: The list, as ``Literal[...]``.
    """
    fault = _narrowed(SeenFault, "operations", tuple[operations, ...])
    return _narrowed(CriticNotes, "faults", tuple[fault, ...])


def _narrowed(kind: type[Answer], name: str, narrower: Any) -> type[Answer]:
    """Return a model with the type of one field narrowed."""
    fields: dict[str, Any] = {name: (narrower, kind.model_fields[name])}
    return create_model(kind.__name__, __base__=kind, __doc__=kind.__doc__, **fields)


@dataclass(frozen=True)
class VisionCritic(Generic[View, Draft]):
    """The engine's critic and a vision critic together: the faults of both, the lower score of the two.

    Without an answer the engine's critic decides alone. A draft that the graph cannot hold is not drawn at all.

    Attributes:
        engine: The critic who computes.
        asker: Asks the vision critic; its role has a prompt of its own.
        subject: Returns what a view is about, for people.
        show: Returns what the critic is told of a draft, as JSON values: what it is to show, ids and names.
        pictures: Draws the draft.
        ids: Returns the ids that a fault may name.
        wanted: Returns whether the vision critic judges a view at all.
        threshold: tau of the role. A vision critic's 8 counts as this score, so that a role whose engine's critic is
            stricter than the paper's stays so.
    """

    engine: Critic[View, Draft]
    asker: Asker[CriticNotes]
    subject: Callable[[View], str]
    show: Callable[[Draft, View], Mapping[str, Any]]
    pictures: Callable[[Draft, View], tuple[Picture, ...]]
    ids: Callable[[View], Collection[str]] = lambda view: ()
    wanted: Callable[[View], bool] = lambda view: True
    threshold: float = _GOOD

    def judge(self, draft: Draft, view: View) -> Critique:
        """Return what both critics say of a draft.

        Args:
            draft: The draft.
            view: The role's projection of the graph.

        Raises:
            AnswerAwaited: The answer has to come from outside first.
        """
        computed = self.engine.judge(draft, view)
        if not self.wanted(view) or any(fault.severity >= UNUSABLE for fault in computed.faults):
            return computed
        known = self.ids(view)

        def wrong(notes: CriticNotes) -> Iterator[str]:
            if notes.score < _GOOD and not notes.faults:
                yield f"name the faults for which the score is {notes.score:g}"
            for number, fault in enumerate(notes.faults):
                if fault.subject and fault.subject not in known:
                    yield (
                        f"faults[{number}].subject: there is no id {fault.subject!r}; leave it out or take one of "
                        + (", ".join(known) or "none")
                    )

        role = self.asker.role
        try:
            notes = self.asker.ask(
                self.subject(view),
                self.show(draft, view),
                wrong,
                pictures=self.pictures(draft, view),
                pictures_needed=True,
            )
        except NoAnswer as error:
            return computed.model_copy(update={"remarks": (*computed.remarks, f"{role} is not heard: {error}")})
        score = self._scaled(notes.score)
        return Critique(
            score=max(1.0, min(computed.score, score)),
            faults=(*computed.faults, *_faults(notes, 10 - score)),
            remarks=(*computed.remarks, _remark(role, notes)),
        )

    def _scaled(self, score: float) -> float:
        """Return a vision critic's score with its 8 at the role's threshold; 0 and 10 stay."""
        if score < _GOOD:
            return score * self.threshold / _GOOD
        return self.threshold + (score - _GOOD) * (10 - self.threshold) / (10 - _GOOD)


def _faults(notes: CriticNotes, points: float) -> tuple[Fault, ...]:
    """Return the faults of an answer; together they cost so many points."""
    return tuple(
        Fault(
            kind=SEEN,
            subject=fault.subject,
            message=fault.message,
            severity=points / len(notes.faults),
            fix={"ops": " ".join(fault.operations)} if fault.operations else {},
        )
        for fault in notes.faults
    )


def _remark(role: str, notes: CriticNotes) -> str:
    """Return what a vision critic said, for the trace."""
    found = "; ".join(
        f"{fault.message} ({', '.join(fault.operations)})" if fault.operations else fault.message
        for fault in notes.faults
    )
    return f"{role} gives {notes.score:g}: {found}" if found else f"{role} gives {notes.score:g}"
