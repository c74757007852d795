"""Credits: what services ask to be said below the table, and what must not be passed on."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import cast

import pytest

from storyblender.deliver.credits import says_what_to_keep, write_credits
from storyblender.memory.asset_sheet import Asset, CanonicalAsset, Provenance
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.pipeline.delivery import warn_of_works_to_keep
from storyblender.pipeline.run import Run
from storyblender.trace import Event


def story_with(license: str, url: str, name: str = "lute") -> ContinuityMemoryGraph:
    provenance = Provenance(source="library", file="a/b.glb", author="Ann", license=license, url=url)
    made = CanonicalAsset(source="file", key="a/b.glb", dimensions=(1, 1, 1), digest="", provenance=provenance)
    lute = Asset(asset_id=name, asset_type="object", description=f"a {name}", name=name, canonical=made)
    return ContinuityMemoryGraph(title="Story", assets=(lute,))


@pytest.mark.parametrize(
    ("url", "said"), [("https://polyhaven.com/a/lute", True), ("https://example.com/polyhaven.com/", False)]
)
def test_poly_haven_is_named_where_something_is_from_there(url: str, said: bool, tmp_path: Path) -> None:
    write_credits(story_with("CC0-1.0", url), tmp_path / "credits.md")
    assert ("Powered by [Poly Haven]" in (tmp_path / "credits.md").read_text()) is said


@pytest.mark.parametrize(("license", "kept"), [("Sketchfab Standard", True), ("CC-BY-4.0", False)])
def test_a_work_that_must_not_be_passed_on_is_named_with_every_file_that_has_it(
    license: str, kept: bool, tmp_path: Path
) -> None:
    graph, told = story_with(license, "https://sketchfab.com/3d-models/0"), list[Event]()
    run = cast(Run, SimpleNamespace(graph=graph, tell=told.append))
    warn_of_works_to_keep(run, ["export/SC010.glb"])
    warn_of_works_to_keep(run, [])
    assert len(told) == kept
    assert all("export/SC010.glb" in each.message and "lute (Sketchfab Standard, Ann)" in each.message for each in told)
    assert not says_what_to_keep(graph, tmp_path / "credits.md")
    write_credits(graph, tmp_path / "credits.md")
    assert says_what_to_keep(graph, tmp_path / "credits.md")
    assert says_what_to_keep(story_with(license, "", "harp"), tmp_path / "credits.md") is not kept, (
        "another work is news"
    )
    assert ("Not to be passed on as models, nor in story.blend or exports: lute." in read(tmp_path)) is kept


@pytest.mark.parametrize(
    ("said", "written"),
    [
        ("tin_cup (2) #1 & co.", "tin_cup (2) #1 & co."),
        ("_tin_ *cup* a|b", r"\_tin\_ \*cup\* a\|b"),
        ("<b>[x](y) &lt;", r"\<b>\[x\](y) \&lt;"),
    ],
)
def test_words_are_legible_as_plain_text_and_are_no_markdown(said: str, written: str, tmp_path: Path) -> None:
    write_credits(story_with(said, ""), tmp_path / "credits.md")
    assert f"| {written} |" in read(tmp_path)


def read(folder: Path) -> str:
    return (folder / "credits.md").read_text()
