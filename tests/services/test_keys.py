"""Where the key of a service comes from, and for whom it is."""

from __future__ import annotations

import keyring
import pytest

from storyblender.keys import service_key, service_key_name
from storyblender.service_setting import services_in


@pytest.fixture(autouse=True)
def no_keyring(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        keyring, "get_password", lambda service, name: "from the ring" if name == "MESHY_API_KEY" else None
    )


def test_a_key_comes_from_the_environment_then_from_the_keyring(monkeypatch: pytest.MonkeyPatch) -> None:
    (meshy,) = services_in("meshy")
    monkeypatch.delenv("MESHY_API_KEY", raising=False)
    assert service_key(meshy) == "from the ring"
    monkeypatch.setenv("MESHY_API_KEY", " from the environment ")
    assert service_key(meshy) == "from the environment"


def test_a_service_elsewhere_never_gets_the_key_of_the_real_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SKETCHFAB_API_TOKEN", "the real one")
    monkeypatch.setenv("STORYBLENDER_KEY_EVIL_EXAMPLE_8080", "its own")
    (theirs,) = services_in("sketchfab@http://evil.example:8080")
    assert service_key_name(theirs) == "STORYBLENDER_KEY_EVIL_EXAMPLE_8080"
    assert service_key(theirs) == "its own"
    monkeypatch.delenv("STORYBLENDER_KEY_EVIL_EXAMPLE_8080")
    assert service_key(theirs) == ""


def test_a_service_without_keys_asks_for_none() -> None:
    assert [service_key_name(choice) for choice in services_in("poly_haven,trellis")] == ["", ""]
