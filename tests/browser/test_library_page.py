"""The user's library in a real browser, and what is chosen by eye; nothing of an entry is read as markup."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page, expect

from storyblender.library.shared.entries import EntryFacts
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Credit
from tests.browser.conftest import RunningStudio
from tests.textures import write_surface


@pytest.fixture
def shelved(page: Page, tmp_path: Path, studio: RunningStudio) -> Iterator[Page]:
    library = SharedLibrary.open(studio.library)
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


def test_walls_are_made_of_a_surface_that_is_chosen_by_eye_with_the_keyboard(page: Page, studio: RunningStudio) -> None:
    write_surface(studio.folder / "woods")
    page.get_by_role("button", name="Set and light", exact=True).click()
    choice = page.locator("sb-pictures[data-part=walls]")
    choice.locator("summary").press("Enter")
    card = choice.locator(".face").filter(has_text="oak boards")
    expect(card.locator("img")).to_be_visible()
    card.press("Enter")
    expect(choice.locator("summary")).to_contain_text("oak boards")
    expect(page.locator(".decided")).to_contain_text("oak_boards")
    assert Axe().run(page).violations_count == 0
    page.get_by_role("button", name="Undo").click()
    expect(choice.locator("summary")).to_contain_text("the finish")
