"""The page in the package is the one that its sources make."""

from __future__ import annotations

import hashlib
import re
from importlib.resources import files
from pathlib import Path

STATIC = Path(str(files("storyblender.web_studio") / "static"))
SOURCES = Path(__file__).parents[3] / "web_page"


def test_the_bundle_is_made_from_the_sources() -> None:
    digest = hashlib.sha256()
    for path in (SOURCES / "package-lock.json", *sorted((SOURCES / "src").iterdir())):
        digest.update(path.read_bytes())
    first = (STATIC / "studio.js").read_text(encoding="utf-8").partition("\n")[0]
    assert digest.hexdigest() in first, "run `npm install && npm run build` in web_page"


def test_the_page_loads_nothing_from_elsewhere() -> None:
    for path in STATIC.iterdir():
        text = path.read_text(encoding="utf-8")
        loaded = re.findall(r"""(?:src|href|@import|url\(|from)\s*=?\s*["'(]?\s*(?:https?:)?//[^"')]+""", text)
        assert not loaded, path.name
