"""The narrator of a story in the first person: who ``I``, ``my``, ``we`` and ``us`` mean."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import LOWER, UPPER
from storyblender.agents.director.reader.language.morphology import FORMS
from storyblender.agents.director.reader.language.words import Mention, Word
from storyblender.agents.director.reader.manuscript import QUOTATION, Manuscript, without_asides, without_quotations
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Gender

ALONE, TOGETHER = frozenset({"i", "me", "myself"}), frozenset({"we", "us", "ourselves"})
OWN = frozenset({"my", "our"})
_I = re.compile(r"\bI\b(?= [a-z]|['’,])")
_I_DO = re.compile(r"\bI (?:[a-z]+ly |then |just |had |was |am )?([a-z]+)\b")
_MINE = re.compile(r"\b(?:[Mm]e|[Mm]y|[Mm]yself)\b")
_OFTEN = 2
"""Uses of ``I`` and ``my`` outside speech that make a narrator, and no numeral."""
_SPOUSES: dict[str, Gender] = {"wife": "male", "husband": "female", "girlfriend": "male", "boyfriend": "female"}
_INTRODUCED = re.compile(
    r"\b[Mm]y (?:\w+ )?(?:friend|associate|colleague|companion|assistant|partner)(?: and \w+)?,? "
    rf"((?:(?:Mr|Mrs|Miss|Ms|Dr)\.? )?[{UPPER}][{LOWER}]+(?: [{UPPER}][{LOWER}]+)?)"
)
"""``"This is my friend, Dr. Watson"``, in a story that Dr. Watson tells."""
_MINDFUL = frozenset({"think", "talk", "listen"})
"""``I think``, ``I ask for a quiet panel``: verbs that a writer also uses to address the reader."""
_MY_SPOUSE = re.compile(rf"\b[Mm]y ({'|'.join(_SPOUSES)})\b")


@rule("people.narrator")
def find_narrator(script: Manuscript, roster: Roster) -> None:
    """Add the first-person narrator of a story to the cast, if there is one.

    Args:
        script: A story.
        roster: Its cast, filled here.
    """
    told = [(paragraph.start, without_quotations(paragraph.raw)) for paragraph in script.paragraphs]
    uses = [start + match.start() for start, text in told for match in _I.finditer(text)]
    owned = sum(len(_MINE.findall(text)) for _, text in told)
    if not uses or len(uses) + owned < _OFTEN or not any(_acts_in_story(text) for _, text in told):
        return
    roster.narrator = roster.add("Narrator", uses[0])
    roster.add_alias(roster.narrator, "i")
    for paragraph in script.paragraphs:
        for quotation in QUOTATION.finditer(paragraph.raw):
            introduced = _INTRODUCED.search(quotation.group(0))
            if introduced and not roster.find(introduced.group(1)):
                roster.add_alias(roster.narrator, bare(introduced.group(1)))
                roster.add_alias(roster.narrator, bare(introduced.group(1)).split()[-1])
    spouse = next((match for _, text in told if (match := _MY_SPOUSE.search(text))), None)
    roster.narrator.gender = _SPOUSES[spouse.group(1)] if spouse else "unknown"


def _acts_in_story(told: str) -> bool:
    """Whether ``I`` acts in the story and not only writes it: ``I should like to record``."""
    text = without_asides(told)
    for match in _I_DO.finditer(text):
        form = FORMS.get(match.group(1))
        motion = lexicon.MOTION_OF_VERB.get(form.lemma) if form else None
        if motion and form and (form.kind in ("past", "ing") or motion not in _MINDFUL):
            return True
    return False


def mark_narrator(words: Sequence[Word], narrator: Person | None) -> None:
    """Mark ``I`` and ``me`` as mentions of the narrator, ``we`` and ``us`` of the narrator and others.

    Args:
        words: Words of a sentence; changed in place.
        narrator: The narrator, or None where the story has none.
    """
    for word in words if narrator else ():
        if word.quotation or (word.low == "us" and word.text.isupper()):
            continue
        if word.low in ALONE and narrator:
            word.mention = Mention("name", [narrator], word.low, start=word.start)
        elif word.low in TOGETHER:
            word.mention = Mention("group", [], word.low, number=2, start=word.start)


def narrator_group(state: ReaderState, word: str) -> list[Person]:
    """Return the people whom ``my``, ``our``, ``we`` or ``us`` means.

    Args:
        state: The reader's state.
        word: The pronoun, in lower case.
    """
    narrator = state.roster.narrator
    if narrator is None:
        return []
    return [narrator] if word == "my" else _narrator_with_others(state, narrator)


def _narrator_with_others(state: ReaderState, narrator: Person) -> list[Person]:
    """Return the narrator with those who last acted together with him, else with who was mentioned last."""
    for _, group, _ in reversed(state.discourse.groups):
        if narrator in group and all(person.id in state.scene.on for person in group):
            return group
    others = [person for person in state.on_stage() if person is not narrator and person.kind == "human"]
    others.sort(key=lambda person: -state.discourse.last_named.get(person.id, 0))
    return [narrator, *others[:1]]
