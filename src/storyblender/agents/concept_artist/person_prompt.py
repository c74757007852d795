"""Text-to-image prompts for characters: one standing figure, of which a model can be made and bound to a skeleton."""

from __future__ import annotations

from collections.abc import Iterator

from storyblender.agents.concept_artist.image_prompt import PERIODS
from storyblender.catalog.bodies import complexion, resolved_gender
from storyblender.catalog.color_words import color_word
from storyblender.catalog.hair import HAIRSTYLES
from storyblender.catalog.wardrobe import garment_words, person_seed, worn_by
from storyblender.memory.asset_sheet import PROMPT_LENGTH, Asset, CharacterLook
from storyblender.memory.vocabulary import Age

_GROWN_UP = 18
"""Years."""
_DESCRIBED = 600
"""Most letters of a description."""


def person_prompt(person: Asset, age: Age | None) -> str:
    """Return the prompt for the picture of a character; it depends on their look and description only.

    Args:
        person: A character.
        age: When the story plays; None leaves the period out.
    """
    told = " ".join(person.description.split())[:_DESCRIBED].rstrip(". ")
    counts = "the story" if person.look_decision is None else "the first description"
    period = f", {PERIODS[age]}" if age is not None else ""
    parts = [
        f"One person, the whole figure from head to feet: {'; '.join(_looks(person))}{period}.",
        f"The story says of them: {told}. Where that differs, {counts} counts." if told else "",
        "Standing upright, exact front view, facing the camera, a calm face, legs a little apart.",
        "Both arms straight and held slightly away from the body (A-pose), with a clear gap between arms and body; "
        "hands open and empty.",
        "The figure is centred, with a clear margin on all sides.",
        "Plain white background, no ground, no shadow, soft even light from all sides.",
        "Realistic proportions, true colours, distinct materials, clean shapes that are easy to model.",
        "One figure only: nobody else, nothing beside it, no second view, no writing and no logo.",
    ]
    return " ".join(filter(None, parts))[:PROMPT_LENGTH]


def _looks(person: Asset) -> Iterator[str]:
    """Yield what a character looks like, part by part."""
    look, seed = person.decided_look or CharacterLook(), person_seed(person)
    gender = resolved_gender(look, seed)
    who = {"female": ("girl", "woman"), "male": ("boy", "man")}[gender][look.age >= _GROWN_UP]
    height = f", {look.stature:g} m tall" if look.stature is not None else ""
    yield f"a {who} of {look.age:g} years{height}"
    yield f"{look.build} build"
    yield f"{look.skin} skin"
    hair = HAIRSTYLES[look.hair].name.lower() if look.hair in HAIRSTYLES else look.hair.replace("_", " ")
    yield f"hair: {hair}, {color_word(complexion(look, seed).hair)}"
    if look.facial_hair != "none":
        yield f"a {look.facial_hair}" if look.facial_hair != "stubble" else "stubble"
    if look.glasses:
        yield "glasses"
    yield f"wears {', '.join(garment_words(each) for each in worn_by(person))}"
    if look.face:
        yield f"face number {look.face} of those that fit this"
