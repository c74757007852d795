"""``credits.md``: what services ask to be said below the table."""

from __future__ import annotations

from pathlib import Path

import pytest

from storyblender.deliver.credits import write_credits
from storyblender.memory.asset_sheet import Asset, CanonicalAsset, Provenance
from storyblender.memory.graph import ContinuityMemoryGraph


def story_with(license: str, url: str) -> ContinuityMemoryGraph:
    provenance = Provenance(source="library", file="a/b.glb", author="Ann", license=license, url=url)
    made = CanonicalAsset(source="file", key="a/b.glb", dimensions=(1, 1, 1), digest="", provenance=provenance)
    lute = Asset(asset_id="lute", asset_type="object", description="a lute", name="lute", canonical=made)
    return ContinuityMemoryGraph(title="Story", assets=(lute,))


@pytest.mark.parametrize(
    ("url", "said"), [("https://polyhaven.com/a/lute", True), ("https://example.com/polyhaven.com/", False)]
)
def test_poly_haven_is_named_where_something_is_from_there(url: str, said: bool, tmp_path: Path) -> None:
    write_credits(story_with("CC0-1.0", url), tmp_path / "credits.md")
    assert ("Powered by [Poly Haven]" in (tmp_path / "credits.md").read_text()) is said
