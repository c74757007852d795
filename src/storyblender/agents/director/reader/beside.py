"""Actions during a speech, in brackets: ``(picking up the rose)``, ``(folds the letter)``."""

from __future__ import annotations

import re
from dataclasses import replace

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.action import read_action
from storyblender.agents.director.reader.language.morphology import FORMS
from storyblender.agents.director.reader.language.row import is_adverb
from storyblender.agents.director.reader.language.words import Mention, Word, tokenize
from storyblender.agents.director.reader.page.sentences import Sentence, Speech
from storyblender.agents.director.reader.people.mentions import mark_mentions
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.rules import rule

_VOICE = frozenset({"talk", "whisper", "shout", "sing", "phone"})
"""How it is said is told by the speech itself."""


@rule("speech.brackets")
def act_beside(stage: Stage, sentence: Sentence, speech: Speech) -> None:
    """Read what the brackets of a speech tell of the speaker into the unit of the speech.

    Args:
        stage: Its unit is the speech, with its speaker.
        sentence: Of the speech.
        speech: With what stands in brackets.
    """
    speaker = stage.person(stage.unit.speaker or "")
    if speaker is None or stage.unit.off_screen:
        return
    discourse, spoken = stage.discourse, len(stage.unit.deeds)
    present, subjects = discourse.salience.get(speaker.id, 0.0), discourse.subjects
    for part in re.split(r"[,;]\s*|\s+and\s+(?=[a-z]+(?:s|ing)\b)", speech.parenthetical.strip("()[] ")):
        words = mark_mentions(tokenize(part, sentence.start), stage.roster)
        first = next((word for word in words if not is_adverb(word)), None)
        form = FORMS.get(first.low) if first else None
        if form and form.kind in ("ing", "3sg") and lexicon.MOTION_OF_VERB.get(form.lemma, "talk") not in _VOICE:
            mention = Mention("name", [speaker], speaker.name.lower(), start=sentence.start)
            name = Word(speaker.name, sentence.start, sentence.start, mention)
            read_action(stage, replace(sentence, words=[name, *words], speech=None))
    deeds = stage.unit.deeds
    stage.unit.deeds = deeds[spoken:] + deeds[:spoken]
    # Brackets are no sentence: who ``she`` is next is told by the speech.
    discourse.salience[speaker.id], discourse.subjects = present, subjects
