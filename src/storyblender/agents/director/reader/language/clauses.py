"""Clauses of a regular sentence: its phrases put together in one pass from left to right, without a parser.

Clauses follow from the order of phrases. Anything that produces ``Clause`` could stand in place of this.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clause import Clause
from storyblender.agents.director.reader.language.clause_order import has_own_place, inverts
from storyblender.agents.director.reader.language.clause_repairs import repair
from storyblender.agents.director.reader.language.morphology import VerbForm
from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase
from storyblender.agents.director.reader.language.tagging import PERCEIVING
from storyblender.agents.director.reader.language.words import Word

_SUBJECT_ONLY = frozenset({"he", "she", "they", "i", "we"})
"""``At seven she pulls herself up``: no object of the preposition before."""
_NEAR = 4
"""Phrases back to whom ``who`` means."""
_HYPOTHETICAL = frozenset({"if", "unless"})


@dataclass
class _Builder:
    """What has been read of the sentence so far."""

    phrases: list[Phrase]
    words: list[Word]
    clauses: list[Clause] = field(default_factory=list)
    subject: list[NounPhrase] = field(default_factory=list)
    """Subject of the clauses so far; a verb without one inherits it."""
    outer: list[NounPhrase] = field(default_factory=list)
    """Subject of the clause around ``where he told her``: its verbs go on after a comma."""
    pending: list[NounPhrase] = field(default_factory=list)
    """A noun read before its verb."""
    relative: list[NounPhrase] = field(default_factory=list)
    """``a man, who, peering in, knocked``: whose verbs come next."""
    inserted: bool = False
    """The noun before its verb stands after ``where`` or ``until``."""
    preposition: str = ""
    aside: bool = False
    """Within ``, a book in her lap``: its places are the book's, not the clause's."""
    leading: list[tuple[str, list[NounPhrase]]] = field(default_factory=list)
    """Places told before the first clause: ``On top of the stone sat a fox``."""
    fronted: list[tuple[str, list[NounPhrase]]] | None = None
    """Places told before a later clause: ``; behind him Silas pulled at the oars``."""
    closed: bool = False
    """A comma stands after the last verb: ``feet up`` is no ``slump up``."""
    negated: bool = False
    unreal: bool = False
    passive: bool = False
    perfect: bool = False
    """``has fallen``: somebody's own deed."""

    @property
    def current(self) -> Clause | None:
        return self.clauses[-1] if self.clauses else None


def find_clauses(words: list[Word], phrases: list[Phrase]) -> list[Clause]:
    """Put phrases together to clauses.

    Args:
        words: A regular sentence.
        phrases: Its phrases, in order.
    """
    builder = _Builder(phrases, words)
    for index, phrase in enumerate(phrases):
        if phrase.text in (";", "and", ",") and builder.clauses and _is_fronted(phrases, index + 1):
            builder.fronted = []
        if phrase.kind == "negation":
            builder.negated = builder.negated or phrase.text != "modal"
            builder.unreal = builder.unreal or phrase.text == "modal"
        elif phrase.kind == "verb":
            _take_verb(builder, index, phrase)
        elif phrase.kind == "preposition":
            _take_preposition(builder, index, phrase)
        elif phrase.kind == "noun" and phrase.noun:
            if not builder.clauses and _is_other_side(builder, index):
                builder.leading[-1][1].append(phrase.noun)
            else:
                _take_noun(builder, index, phrase.noun)
        elif phrase.text in ("and", "but", "then") or phrase.text in ".;:,":
            builder.preposition, builder.aside = "", False
            builder.closed = builder.closed or phrase.text == ","
        elif phrase.text in ("who", "that", "which"):
            _take_relative(builder, index, phrase.text)
        elif phrase.text in _HYPOTHETICAL:
            builder.unreal = True
    _finish(builder)
    return builder.clauses


def _take_relative(builder: _Builder, index: int, pronoun: str) -> None:
    """Whose verbs come next: ``a man, who``, ``the letter that lies there``."""
    if pronoun == "who":
        nouns = [p.noun for p in builder.phrases[max(0, index - _NEAR) : index] if p.noun]
        builder.relative = [noun for noun in nouns if noun.kind == "person"][-1:]
        if builder.current and _is_object(builder.current, builder.relative):
            builder.subject = builder.relative
    elif _verb_touches(builder, index):
        builder.relative = [p.noun for p in builder.phrases[max(0, index - 2) : index] if p.noun][-1:]


def _finish(builder: _Builder) -> None:
    """What is left over when the sentence is over: a last place, places before the first verb, delayed subjects."""
    if builder.fronted and builder.pending:
        at = builder.pending[0].index
        clause = Clause(at, builder.words[at].start, "be", subject=builder.pending, places=builder.fronted)
        clause.opening = len(builder.fronted)
        builder.clauses.append(clause)
    if builder.clauses:
        builder.clauses[0].places += builder.leading
        builder.clauses[0].opening = len(builder.leading)
    if builder.clauses and builder.words[0].low in _WONDERING:
        builder.clauses[0].unreal = True
    repair(builder.clauses, builder.words)
    for clause in builder.clauses:
        if clause.verb == "be":
            clause.complement, clause.object = clause.object, []


def _is_object(clause: Clause, nouns: list[NounPhrase]) -> bool:
    """``thrusts it at Percy, who sits up, opens it and reads``: all that Percy does."""
    after = [*clause.object, *clause.recipient, *(noun for _, place in clause.places for noun in place)]
    return bool(nouns) and all(any(noun is other for other in after) for noun in nouns)


def _verb_touches(builder: _Builder, index: int) -> bool:
    """``the letter that lies there``, but not ``that man``, ``that she lies``."""
    following = builder.phrases[index + 1] if index + 1 < len(builder.phrases) else None
    return following is not None and following.kind == "verb"


def _is_fronted(phrases: list[Phrase], at: int) -> bool:
    """``under the window was a wheel``, ``behind him Al sat``: whether places that start here lead a clause."""
    start = at
    while at + 1 < len(phrases) and phrases[at].kind == "preposition" and phrases[at + 1].kind == "noun":
        if phrases[at].text not in lexicon.RELATION_OF_PREPOSITION:
            return False
        at += 2
    if at == start or at >= len(phrases):
        return False
    at += phrases[at].text == "," and at + 1 < len(phrases)
    new = phrases[at].noun
    if new and phrases[start - 1].text != "," and (new.kind == "person" or new.determiner in ("a", "an")):
        return True  # a bed, and behind it a lamp
    inverted = phrases[at].kind == "verb"
    verb = phrases[at if inverted or at + 1 == len(phrases) else at + 1].verb
    if verb is None or verb.kind not in ("past", "aux", "3sg") or not (inverted or phrases[at].kind == "noun"):
        return False
    return not inverted or (verb.lemma in lexicon.INVERTING | {"be"} and phrases[start - 1].text != ",")


def _take_verb(builder: _Builder, index: int, phrase: Phrase) -> None:
    verb = phrase.verb or VerbForm(phrase.text, "past")
    following = builder.phrases[index + 1] if index + 1 < len(builder.phrases) else None
    if verb.kind == "aux" and following and following.kind in ("verb", "negation"):
        past = following.verb if following.verb and following.verb.kind in ("past", "pp") else None
        builder.passive = past is not None and verb.lemma == "be"
        builder.perfect = past is not None and verb.lemma == "have" and past.lemma in _ARRIVED
        return
    left = builder.phrases[index - 1] if index else None
    rested = builder.current is not None and builder.current.verb in _RESTING
    if rested and left and left.kind == "verb" and (verb.kind == "pp" or (verb.kind == "past" and not builder.pending)):
        return  # sits hunched, sat propped against the wall
    if builder.outer and not builder.pending and left and left.text == ",":
        builder.subject, builder.outer = builder.outer, []
    if builder.pending and builder.clauses and builder.inserted:
        builder.outer = builder.subject
    participle = verb.kind in ("ing", "inf")
    clause = Clause(
        phrase.first,
        builder.words[phrase.first].start,
        verb.lemma,
        subject=_subject(builder, index, verb),
        participle=participle,
        infinitive=verb.kind == "inf",
        passive=(verb.kind == "pp" and not builder.perfect) or builder.passive,
        negated=builder.negated,
        unreal=builder.unreal or _is_unreal(builder, index),
        main=not builder.clauses or not participle,
    )
    builder.negated = builder.unreal = builder.passive = builder.perfect = False
    if builder.relative and not builder.pending:
        clause.subject = builder.relative
        clause.main = not builder.clauses
        builder.relative = builder.relative if participle else []
        builder.preposition, builder.aside, builder.closed = "", False, False
        builder.clauses.append(clause)
        return
    if builder.fronted is not None:
        clause.subject, clause.places = builder.pending, builder.fronted
        clause.opening, builder.fronted = len(builder.fronted), None
    clause.elided = not clause.subject
    clause.absolute = bool(builder.pending) and (participle or verb.kind == "pp") and len(builder.clauses) > 0
    if builder.pending and verb.kind not in ("ing", "inf") and not clause.absolute:
        builder.subject = builder.pending
    elif builder.current and not clause.opening and not clause.subject and not builder.current.absolute:
        clause.subject = builder.current.subject
    builder.pending, builder.preposition, builder.aside, builder.closed = [], "", False, False
    builder.clauses.append(clause)


def _subject(builder: _Builder, index: int, verb: VerbForm) -> list[NounPhrase]:
    """Whose verb it is: of the noun before it; of whom is seen doing it; else of the clauses before."""
    before = builder.current
    if before and verb.kind == "inf":
        if before.infinitive:
            return before.subject
        return list(before.object) or list(builder.subject)
    left = builder.phrases[index - 1] if index else None
    touches = left is not None and left.kind == "noun" and left.noun is not None
    if before and verb.kind == "ing" and touches and before.verb in PERCEIVING and before.object and not before.places:
        return list(before.object)
    if before and left and left.noun and not builder.pending and _describes(left.noun, verb):
        return [left.noun]
    return list(builder.pending or builder.subject)


def _describes(noun: NounPhrase, verb: VerbForm) -> bool:
    """``grabs the gun lying there``, ``reads a note pinned to the door``: it is the gun that lies."""
    resting = verb.kind == "ing" and verb.lemma in _RESTING
    return noun.kind != "pronoun" and (resting or (verb.kind == "pp" and noun.kind == "thing"))


def _is_unreal(builder: _Builder, index: int) -> bool:
    """``without looking``, ``wants to leave``, ``stops mopping``."""
    left = builder.phrases[index - 1] if index else None
    if left is None:
        return False
    before = builder.current
    if before is not None and left.kind == "verb" and before.verb in _ENDINGS and before.index == left.first:
        return True
    if before is not None and left.kind == "verb" and before.index == left.first and (before.negated or before.unreal):
        return True
    if left.kind != "preposition":
        return False
    if left.text == "without" or (left.text == "to" and before and _is_wished(before)):
        return True
    if left.text == "to" and index > 1 and builder.phrases[index - 2].text == "about":
        return True
    seeing = before is not None and before.verb in _DISCOVERING and bool(before.object or before.particle)
    return left.text == "to" and not seeing and builder.words[builder.phrases[index].first].low in _PURPOSES


def _is_wished(before: Clause) -> bool:
    """``wants to leave``, ``tells Ben to sit``, ``would like to dance``, ``does not stop to look``."""
    return before.verb in _WISHES or before.verb in _ORDERS or before.negated or before.unreal


_ADVERBIAL = frozenset({"outside", "inside", "without", "within", "above", "below"})
"""``Outside a blizzard was raging``: no preposition where subject and verb follow."""
_RESTING = lexicon.words("stative") - {"be"}
_ARRIVED = frozenset(
    {"fall", "come", "go", "sit", "rise", "kneel", "enter", "arrive", "return", "climb", "step", "stop"}
)
"""``has fallen asleep``, ``had come in``: what somebody has done shows still."""
_WONDERING = frozenset({"how", "why", "whether"})
_INSERTING = frozenset({"where", "when", "until", "because", "since"})
_ENDINGS = frozenset({"stop", "quit", "avoid", "consider", "finish", "suggest", "imagine"})
_PURPOSES = frozenset({"see", "find", "get", "hear"})
_DISCOVERING = frozenset({"open", "turn", "look", "wake", "return", "enter"})
"""``opens the door to find Otto``: he is there."""
_WISHES = frozenset(
    {"want", "need", "refuse", "hope", "decide", "wait", "hesitate", "fail", "intend", "plan", "long", "threaten"}
    | {"promise", "offer", "agree", "expect", "mean", "forget", "prepare", "wish", "dare", "choose"}
)
_ORDERS = lexicon.words("ordering")


def _take_preposition(builder: _Builder, index: int, phrase: Phrase) -> None:
    """A particle of the verb (``picks up``) or a preposition with a noun to come."""
    clause = builder.current
    if index == 0 and phrase.text in _ADVERBIAL and _verb_follows(builder.phrases, 1) and not inverts(builder.phrases):
        return
    following = builder.phrases[index + 1] if index + 1 < len(builder.phrases) else None
    if clause and phrase.text in lexicon.PARTICLES and not clause.particle and not builder.closed:
        noun_follows = following is not None and following.kind == "noun"
        pair = f"{clause.verb} {phrase.text}"
        known = (pair in lexicon.MOTION_OF_VERB or pair in lexicon.OVERRIDDEN_PARTICLES) and not clause.object
        if not noun_follows or (known and phrase.text != "through"):
            clause.particle, builder.preposition = phrase.text, ""
            return
    absolute = phrase.text == "with" and clause is not None and _is_absolute(builder.phrases, index + 1)
    builder.preposition = "" if absolute else phrase.text


def _take_noun(builder: _Builder, index: int, noun: NounPhrase) -> None:
    """A subject to come, the noun of a preposition, an object, a recipient, or one more of a list."""
    clause, left = builder.current, builder.phrases[index - 1] if index else None
    listed = left is not None and (left.kind == "mark" or (left.kind == "link" and left.text == "and"))
    linked = left is not None and (left.kind in ("link", "mark") or left.text == "with")
    if noun.head in _SUBJECT_ONLY:
        builder.preposition = ""
    starts_clause = not builder.preposition and (
        clause is None
        or noun.head in _SUBJECT_ONLY
        or builder.fronted is not None
        or (linked and (_verb_follows(builder.phrases, index) or _is_absolute(builder.phrases, index)))
    )
    if starts_clause:
        builder.inserted = left is not None and left.text in _INSERTING
        if left is not None and left.text in _INSERTING | {"as", "while"} and not listed and not builder.clauses:
            builder.outer = builder.pending
        builder.pending = [*builder.pending, noun] if listed and builder.pending else [noun]
        return
    if builder.preposition:
        if builder.fronted is not None:
            builder.fronted.append((builder.preposition, [noun]))
        elif not builder.aside and not (clause and builder.pending):
            places = clause.places if clause else builder.leading
            places.append((builder.preposition, [noun]))
        builder.preposition = ""
        return
    if clause is None:
        return
    if noun.kind == "person" and left and left.text == "," and has_own_place(builder.phrases, index):
        builder.aside = True
        return
    goes_on = listed and bool(clause.object) and not clause.places and _list_ends(builder.phrases, index)
    apart = (left is not None and left.text == ",") or bool(listed and clause.object and clause.places)
    builder.aside = noun.kind == "thing" and apart and not goes_on
    if builder.aside and not clause.object:
        clause.asides.append(noun)
        return
    of_both = bool(clause.places) and clause.places[-1][0] == "of" and clause.places[-1][1][-1].kind == noun.kind
    of_both |= bool(clause.places) and clause.places[-1][0] == "between"
    if left and left.kind == "link" and left.text == "and" and clause.places and (of_both or not clause.object):
        clause.places[-1][1].append(noun)
    elif linked and clause.object and (noun.kind == "person" or (goes_on and clause.object[0].kind == "thing")):
        clause.object.append(noun)
    elif clause.object and left and left.kind == "noun" and noun.kind == "thing" and _gets_it(clause):
        clause.recipient, clause.object = clause.object, [noun]
    elif not clause.object and len(clause.places) == clause.opening:
        clause.object = [noun]


def _is_other_side(builder: _Builder, index: int) -> bool:
    """``Between a radio and a lamp sits a cat``: the noun after ``and``."""
    place = builder.leading[-1] if builder.leading else ("", [])
    return place[0] == "between" and len(place[1]) == 1 and builder.phrases[index - 1].text == "and"


def _is_absolute(phrases: list[Phrase], index: int) -> bool:
    """``, the robot bumping along behind them``, ``, engine running``: somebody or something else does it."""
    left, following = phrases[index - 1], phrases[index + 1] if index + 1 < len(phrases) else None
    participle = following is not None and following.verb is not None and following.verb.kind in ("ing", "pp")
    return left.text in (",", "while", "with", "as") and participle


def _list_ends(phrases: list[Phrase], index: int) -> bool:
    """``a pistol, a map and a key``: whether the noun here is one of a list that an ``and`` closes."""
    while index > 0 and index < len(phrases) and phrases[index].kind == "noun":
        if phrases[index - 1].text == "and":
            return True
        after = [phrase.text for phrase in phrases[index + 1 : index + 3]]
        if not after or after[0] not in (",", "and"):
            return False
        index += 3 if after == [",", "and"] else 2
    return False


def _gets_it(clause: Clause) -> bool:
    """``hands Mia the key``, ``gives the box a shove``."""
    return _receives(clause.object[0]) or (clause.verb == "give" and clause.object[0].determiner != "")


def _receives(noun: NounPhrase) -> bool:
    """Whether a noun before another noun can be who gets it: ``hands Mia the key``."""
    return noun.kind == "person" or (noun.kind == "pronoun" and noun.head != "it")


def _verb_follows(phrases: list[Phrase], index: int) -> bool:
    """Whether a list of nouns that starts here ends at a finite verb: ``but her son, taking it, examined it``."""
    linked, aside = index > 0 and phrases[index - 1].kind == "link", phrases[index + 1 : index + 3]
    if linked and len(aside) > 1 and aside[0].text == "," and aside[1].verb and aside[1].verb.kind == "ing":
        return True
    while index < len(phrases):
        phrase = phrases[index]
        right = phrases[index + 1] if index + 1 < len(phrases) else None
        joins = (
            right is not None and right.kind == "noun" and (phrase.text in (",", "and") or phrase.kind == "preposition")
        )
        if phrase.kind != "noun" and not joins:
            return phrase.kind == "verb" and (phrase.verb is None or phrase.verb.kind != "ing")
        index += 1
    return False
