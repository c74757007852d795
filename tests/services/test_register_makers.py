"""Makers from the settings: each with its own key, for its own server; without one a sentence says what to set."""

from __future__ import annotations

import pytest

from storyblender.errors import ServiceFailure
from storyblender.service_setting import services_in
from storyblender.services.making import Maker
from storyblender.services.register import IMAGE_MODELS, MODEL_MAKERS, ServiceRun

KEYS = ("GOOGLE_API_KEY", "OPENAI_API_KEY", "MESHY_API_KEY", "TENCENTCLOUD_SECRET_ID", "TENCENTCLOUD_SECRET_KEY")


def maker_of(setting: str) -> Maker:
    (choice,) = services_in(setting)
    make = {**IMAGE_MODELS, **MODEL_MAKERS}[choice.name]
    return make(choice, ServiceRun()).maker


@pytest.mark.parametrize("name", ["gemini", "openai", "meshy", "hunyuan3d"])
def test_a_missing_key_is_named(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for key in KEYS:
        monkeypatch.delenv(key, raising=False)
    with pytest.raises(ServiceFailure, match=f"no key for {name}; set ({'|'.join(KEYS)})"):
        maker_of(name)


def test_trellis_needs_an_address() -> None:
    with pytest.raises(ServiceFailure, match="trellis@http"):
        maker_of("trellis")


def test_models_and_prices(monkeypatch: pytest.MonkeyPatch) -> None:
    for key in KEYS:
        monkeypatch.setenv(key, "a-key")
    found = {
        setting: maker_of(setting)
        for setting in ("gemini", "gemini:gemini-2.5-flash-image", "openai", "openai:gpt-image-9", "meshy", "hunyuan3d")
    }
    assert [(each.model, each.price) for each in found.values()] == [
        ("gemini-3-pro-image-preview", 0.134),
        ("gemini-2.5-flash-image", 0.039),
        ("gpt-image-1", 0.042),
        ("gpt-image-9", 0.2),
        ("meshy-6", 0.6),
        ("pro", 0.4),
    ]


@pytest.mark.parametrize("name", ["hunyuan3d", "trellis", "openai", "gemini"])
def test_a_server_of_ones_own_costs_nothing_and_gets_no_key_of_others(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for key in KEYS:
        monkeypatch.setenv(key, "a-key")
    assert maker_of(f"{name}@http://127.0.0.1:8081").price == 0
    (choice,) = services_in(f"{name}@http://127.0.0.1:8081")
    made = {**IMAGE_MODELS, **MODEL_MAKERS}[choice.name](choice, ServiceRun())
    assert "a-key" not in str(vars(vars(made)["_web"]))


def test_the_international_cloud_is_a_cloud(monkeypatch: pytest.MonkeyPatch) -> None:
    for key in KEYS:
        monkeypatch.setenv(key, "a-key")
    assert maker_of("hunyuan3d@https://hunyuan.intl.tencentcloudapi.com").price > 0
    assert maker_of("hunyuan3d@https://tencentcloudapi.com.example.org").price == 0
