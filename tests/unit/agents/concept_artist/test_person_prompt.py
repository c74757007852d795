"""The prompt of a character tells their look, and nothing that changes while that stays."""

from __future__ import annotations

from storyblender.agents.concept_artist.person_prompt import person_prompt
from storyblender.catalog.materials import hex_color
from storyblender.memory.asset_sheet import Asset, CanonicalAsset, CharacterLook, Garment, LookDecision

LOOK = CharacterLook(gender="male", age=50, build="stocky", facial_hair="beard", garments=(Garment(key="coat"),))
RICK = Asset(asset_id="rick", asset_type="character", name="Rick", description="A sailor.", look=LOOK)


def test_look_description_and_period_are_told_and_no_name() -> None:
    prompt = person_prompt(RICK, "medieval")
    for told in ("a man of 50 years", "stocky", "beard", "coat", "A sailor", "medieval", "One figure only"):
        assert told in prompt
    assert "Rick" not in prompt


def test_what_a_person_decided_counts_more_than_the_script() -> None:
    garments = (Garment(key="coat", color=hex_color("#a8242a")),)
    decided = RICK.model_copy(update={"look_decision": LookDecision(garments=garments)})
    assert "red coat" in person_prompt(decided, None)
    assert "the first description counts" in person_prompt(decided, None)
    assert "the story counts" in person_prompt(RICK, None)


def test_another_face_is_another_prompt_and_another_model_is_not() -> None:
    other = RICK.model_copy(update={"look": LOOK.model_copy(update={"face": 2})})
    assert person_prompt(other, None) != person_prompt(RICK, None)
    made = CanonicalAsset(source="file", key="a.glb", dimensions=(1, 1, 1), digest="")
    assert person_prompt(RICK.model_copy(update={"canonical": made}), None) == person_prompt(RICK, None)
