"""What else a thing could be: the user's library is shown, and no service is asked behind a person's back."""

from __future__ import annotations

from pathlib import Path

from tests.home import SETTINGS
from tests.services.story_with_services import open_sites, services_of

from storyblender.library.shared.entries import EntryFacts
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Credit
from storyblender.memory.jobs import FETCHED
from storyblender.studio import Studio


def test_models_of_the_library_are_among_the_candidates_and_services_are_not_asked(
    folder: Path, tmp_path: Path
) -> None:
    kept = tmp_path / "kept"
    kept.mkdir()
    (kept / "it.glb").write_bytes(b"x")
    credit = Credit(author="Ann", license="CC0-1.0")
    facts = EntryFacts(kind="model", name="Red Sofa", main="it.glb", credit=credit, source="museum", source_id="s1")
    SharedLibrary.open().add(facts, kept)
    with open_sites() as sites:
        settings = SETTINGS.model_copy(update={"services": services_of(*sites)})
        with Studio(settings).open(folder) as session:
            sofa = next(asset for asset in session.graph.assets if asset.name == "sofa")
            made = [asset.canonical for asset in session.candidates(sofa.asset_id)]
        assert not sites[0].hits and not sites[1].hits
    shown = next(each for each in made if each is not None and each.key == "museum/s1/it.glb")
    assert shown.params["content"] and (folder / FETCHED / shown.key).is_file()
