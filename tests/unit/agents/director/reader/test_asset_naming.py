from pydantic import TypeAdapter

from storyblender.agents.director.naming import asset_id
from storyblender.memory.base import Identifier


def test_names_become_snake_case_ascii() -> None:
    assert asset_id("Nora Vance") == "nora_vance"
    assert asset_id("MAN #2") == "man_2"
    assert asset_id("Élodie Größe") == "elodie_grosse"
    assert asset_id("the Old Woman's dog") == "old_woman_dog"
    assert asset_id("MRS. PELL") == "mrs_pell"


def test_ids_are_always_valid_and_never_twice() -> None:
    assert asset_id("1st guard") == "asset_1st_guard"
    assert asset_id("日本") == "asset"
    assert asset_id("guard", {"guard", "guard_2"}) == "guard_3"
    longest = TypeAdapter(Identifier).validate_python(asset_id("Ha" * 300))
    assert TypeAdapter(Identifier).validate_python(asset_id("ha " * 300)) != longest
    assert asset_id("Ha" * 300, {longest}) == f"{longest}_2"
