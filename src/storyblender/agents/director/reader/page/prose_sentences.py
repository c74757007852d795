"""Sentences of prose: quoted speech with its speaker, and the rest as action."""

from __future__ import annotations

import re
from itertools import takewhile

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import FORMS
from storyblender.agents.director.reader.language.words import Mention, Word, tokenize
from storyblender.agents.director.reader.manuscript import QUOTATION, QUOTATION_MARKS, Paragraph
from storyblender.agents.director.reader.page.sentences import Sentence, SpokenText, of_readable_length
from storyblender.agents.director.reader.people.mentions import mark_mentions
from storyblender.agents.director.reader.people.narrator import mark_narrator
from storyblender.agents.director.reader.people.roster import Roster

_ANSWER = re.compile(r"(?:was|came) (?:the|his|her) (?:\w+ )?(?:answer|reply)\b")
_OPENERS = lexicon.DETERMINERS | lexicon.POSSESSIVES
_SMALL = lexicon.PREPOSITIONS | lexicon.CONJUNCTIONS


def prose_sentences(paragraph: Paragraph, scene: int, roster: Roster) -> list[Sentence]:
    """Return the sentences of a paragraph of prose.

    Args:
        paragraph: The paragraph.
        scene: Index of its scene.
        roster: The cast.
    """
    words = mark_mentions(_words_and_quotations(paragraph.raw, paragraph.start), roster)
    mark_narrator(words, roster.narrator)
    _mark_the_other(words)
    sentences: list[Sentence] = []
    for run in _split(words):
        quotations = [word for word in run if word.quotation]
        told = [word for word in run if not word.quotation]
        start, end = min(word.start for word in run), max(word.end for word in run)
        sentence = Sentence(paragraph, scene, start, end, told)
        if quotations:
            text = " ".join(word.quotation.strip(QUOTATION_MARKS) for word in quotations)
            sentence.words, sentence.speech = _split_attribution(told, " ".join(text.split()))
        sentences.append(sentence)
    _who_follows(sentences)
    return sentences


def _who_follows(sentences: list[Sentence]) -> None:
    """Note the person mentioned after an opening quotation, and which quotations stand alone."""
    first = sentences[0] if sentences else None
    if first is None or first.speech is None or first.words:
        return
    told = next((sentence.words for sentence in sentences if sentence.words), [])
    first.speech.alone = not told
    opens = next((word for word in told[:3] if word.mention or word.low in ("he", "she")), None)
    if opens and not any(word.low == "'s" for word in told[:4]):
        first.speech.after = opens


def _mark_the_other(words: list[Word]) -> None:
    """Mark ``the other`` and ``The latter`` as a person where no noun follows."""
    for at in range(1, len(words)):
        word, before = words[at], words[at - 2] if at > 1 else None
        following = words[at + 1] if at + 1 < len(words) else None
        opens = before is None or before.text in ".!?;" or before.quotation != "" or _is_speech_verb(before)
        opens = opens or (before is not None and before.low in ("and", "but", "while") and _is_past(following))
        ends = following is None or not following.text.isalpha() or following.low in FORMS or following.low in _SMALL
        ends = ends or (following is not None and following.low.endswith("ly"))
        if word.low in ("other", "latter", "former") and words[at - 1].low == "the" and opens and ends:
            word.mention = Mention("generic", [], word.low, "the", start=words[at - 1].start)


def _is_past(word: Word | None) -> bool:
    """Whether a word is a verb in the past tense."""
    return word is not None and word.low in FORMS and FORMS[word.low].kind == "past"


def _words_and_quotations(text: str, offset: int) -> list[Word]:
    """Return the words of a text, each quotation as one word."""
    words: list[Word] = []
    at = 0
    for match in QUOTATION.finditer(text):
        words += tokenize(text[at : match.start()], offset + at)
        quotation = match.group(0)
        words.append(
            Word("“”", offset + match.start(), offset + match.end(), quotation=quotation,
                 closes=_closes(quotation))
        )  # fmt: skip
        at = match.end()
    return words + tokenize(text[at:], offset + at)


def _closes(quotation: str) -> bool:
    """Whether a quotation ends with a full stop, an exclamation or a question mark."""
    return any(
        mark in ".!?…" for mark in takewhile(lambda mark: not (mark.isalnum() or mark == "_"), reversed(quotation))
    )


def _split(words: list[Word]) -> list[list[Word]]:
    """Cut after full stops outside quotations, and after quotations that nothing is said about."""
    sentences: list[list[Word]] = [[]]
    for index, word in enumerate(words):
        sentences[-1].append(word)
        following = words[index + 1 : index + 3]
        if (word.text in (".", "!", "?") and words[index - 1].low not in ("mr", "mrs", "dr", "ms")) or (
            word.closes and _starts_sentence(following)
        ):
            sentences.append([])
    told = [part for sentence in sentences for part in of_readable_length(sentence)]
    return [part for part in told if any(word.quotation or word.text[0].isalnum() for word in part)] or told


def _starts_sentence(following: list[Word]) -> bool:
    """Whether a new sentence, and no ``said the fox``, follows a closed quotation."""
    if not following or following[0].quotation:
        return True
    first = following[0]
    if not first.text[0].isupper():
        return False
    speaks = len(following) > 1 and _is_speech_verb(following[1])
    return not ((speaks and first.mention is not None) or first.text in ("He", "She", "They"))


def _is_speech_verb(word: Word) -> bool:
    """Whether a word is a verb of saying."""
    verb = FORMS[word.low].lemma if word.low in FORMS else ""
    return verb in lexicon.SPEECH_VERBS or lexicon.MOTION_OF_VERB.get(verb) in ("talk", "whisper", "shout")


def _split_attribution(words: list[Word], text: str) -> tuple[list[Word], SpokenText]:
    """Return the words in plain order, and the speech with the subject of its verb of saying."""
    if _ANSWER.match(" ".join(word.low for word in words)):
        return words, SpokenText(text, verb="answer")
    at = next((index for index, word in enumerate(words) if _is_speech_verb(word)), None)
    if at is None:
        return words, SpokenText(text)
    verb = FORMS[words[at].low].lemma
    end = _subject_end(words, at + 1)
    inverted = (at == 0 or words[at - 1].text in ",—-") and end > at + 1
    if not inverted:
        return words, SpokenText(text, verb=verb, subject=words[:at])
    subject = words[at + 1 : end]
    before = [word for word in words[:at] if word.text != ","]
    return [*before, *subject, words[at], *words[end:]], SpokenText(text, verb=verb, subject=subject)


def _subject_end(words: list[Word], start: int) -> int:
    """Return the index after the noun phrase that starts at ``start``."""
    at = start
    if start + 1 < len(words) and words[start].low in ("one", "all", "both", "some") and words[start + 1].low == "of":
        at = start + 2
    while at < len(words) and at < start + 4:
        word = words[at]
        noun_like = word.text.isalpha() and word.low not in _SMALL and not word.low.endswith("ly")
        if not (word.low in _OPENERS or word.mention or noun_like):
            break
        at += 1
        if word.mention or (word.low in lexicon.PRONOUNS and word.low not in lexicon.POSSESSIVES):
            break
    return at
