"""Repairs that need all clauses of a sentence: delayed subjects, and two verbs that are one deed."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clause import Clause
from storyblender.agents.director.reader.language.words import Word

_NEAR = 4
"""Words between a comma and the subject it opens."""
_BURSTING = frozenset({"laugh", "cry", "giggle", "weep", "sob", "chuckle", "cackle", "guffaw"})
"""``bursts out laughing``, ``doubles up laughing``: one deed."""
_BACK = frozenset({"go", "return", "get", "turn", "come"})
"""``goes back to stirring``, ``goes back to sleep``: one deed."""
_BESIDE = frozenset({"come", "go"})
"""``comes running``: one deed."""
_ENDING = frozenset({"stop", "quit", "finish", "cease"})
"""``stops writing``: no deed."""
_FINDING = frozenset({"catch", "find", "spot", "notice"})
"""``catches Ben staring``: it is Ben who does something."""
_SLIPPING = frozenset({"fall", "drop", "slip", "go"})


def repair_clauses(clauses: list[Clause], words: list[Word]) -> None:
    """Give clauses the subjects that come later, and join verbs that tell one deed.

    Args:
        clauses: Of one sentence, in order; changed in place.
        words: The sentence.
    """
    _give_to_inverted(clauses)
    _give_to_following(clauses, words)
    following = [*clauses[1:], None]
    joined = [clause for at, clause in enumerate(clauses) if not _joins(clause, following[at], words)]
    for clause in [clause for clause in joined if clause.verb == "let"]:
        _resolve_let(joined, clause)
    clauses[:] = joined


def _joins(clause: Clause, following: Clause | None, words: list[Word]) -> bool:
    """Whether a verb only leads to the verb after it."""
    if following is None:
        return False
    between = [word.low for word in words[clause.index + 1 : following.index]]
    if (
        clause.verb in _BACK
        and between in (["back", "to"], ["to"])
        and (following.participle or following.verb == "sleep")
    ):
        return True
    if not following.participle or following.infinitive or clause.places:
        return False
    if following.verb in _BURSTING and between in (["out"], ["up"], ["over"], ["down"]):
        return True
    if clause.verb in _FINDING and clause.object and following.subject == clause.object:
        return True
    touches = following.index == clause.index + 1
    return touches and (clause.verb in _ENDING or (clause.verb in _BESIDE and not following.absolute))


def _resolve_let(clauses: list[Clause], clause: Clause) -> None:
    """Make ``lets the crowbar fall`` a drop; ``lets him go`` is nothing to be seen."""
    at = clauses.index(clause)
    following = clauses[at + 1] if at + 1 < len(clauses) else None
    if following and following.verb == "go" and following.index == clause.index + 1:
        clause.particle, clause.places = "go", [*clause.places, *following.places]
        clauses.remove(following)
        return
    if following is None or not following.infinitive or following.subject != clause.object or not clause.object:
        return
    if (clause.object[0].kind == "thing" or clause.object[0].head == "it") and following.verb in _SLIPPING:
        clause.verb = "drop"
        clauses.remove(following)
    elif following.verb == "go" and not (following.places or following.particle):
        clauses.remove(following)


def _give_to_inverted(clauses: list[Clause]) -> None:
    """Give an inverted subject to the clauses before: ``Under the stairs, sitting on a case, is DOLORES``."""
    if not clauses:
        return
    *before, last = clauses
    to_person = bool(last.object) and last.object[0].kind == "person"
    if last.opening and to_person and last.verb in lexicon.INVERTING and all(n.kind == "thing" for n in last.subject):
        last.subject, last.object = last.object, []  # In the booth, hats low, sit two THUGS
    if last.subject or not last.object or last.verb not in lexicon.INVERTING | {"be"}:
        return
    if all((clause.passive or (clause.participle and to_person)) and clause.elided for clause in before):
        for clause in before:
            clause.subject, clause.elided = last.object, False


def _give_to_following(clauses: list[Clause], words: list[Word]) -> None:
    """Give the subject of the main clause to the participle before: ``Sitting on the bench, Bob waves``."""
    for number, clause in enumerate(clauses):
        leads = clause.participle or (clause.passive and clause.elided)
        if not number and not (leads and (not clause.subject or clause.subject[0].head == "")):
            return
        if number and not clause.elided and not clause.participle and clause.subject and clause.subject[0].head:
            first = clause.subject[0].index
            comma = max((index for index in range(first) if words[index].text == ","), default=first)
            between = {word.low for word in words[comma:first]}
            if clause.subject[0].kind != "thing" and first - comma <= _NEAR and not between & lexicon.CONJUNCTIONS:
                for before in clauses[:number]:
                    before.subject, before.elided = clause.subject, False
            return
