"""The user's library in a real browser: listed, narrowed by words, nothing of an entry is read as markup."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from storyblender.library.shared.entries import EntryFacts
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Credit
from tests.conftest import LIBRARY


@pytest.fixture
def shelved(page: Page, tmp_path: Path, pytestconfig: pytest.Config) -> Iterator[Page]:
    library = SharedLibrary.open(Path(pytestconfig.stash[LIBRARY]))  # of the studio's process
    for name in ("Arm Chair", "Street Lamp <img src=x onerror=alert(1)>"):
        (tmp_path / name[:5]).mkdir()
        (tmp_path / name[:5] / "it.glb").write_text(name)
        credit = Credit(author="Ann", license="CC-BY-4.0", url="https://museum.example/7")
        facts = EntryFacts(kind="model", name=name, main="it.glb", credit=credit, source="museum")
        library.add(facts, tmp_path / name[:5])
    page.get_by_role("button", name="Library", exact=True).click()
    yield page


def test_entries_are_listed_with_licence_and_narrowed_by_words(shelved: Page) -> None:
    rows = shelved.locator(".library li")
    expect(rows).to_have_count(2)
    expect(rows.filter(has_text="Arm Chair")).to_contain_text("Ann, CC-BY-4.0")
    expect(rows.first.get_by_role("link")).to_have_attribute("href", "https://museum.example/7")
    assert shelved.locator(".library img").count() == 0, "a name is text"
    shelved.get_by_role("searchbox").fill("lamp")
    expect(rows).to_have_count(1)
    shelved.get_by_role("searchbox").fill("samovar")
    expect(shelved.locator(".library [role=status]")).to_contain_text("Nothing of that")
