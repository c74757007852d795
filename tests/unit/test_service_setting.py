from __future__ import annotations

import pytest

from storyblender.service_setting import ServiceChoice, services_in


def test_services_are_read_in_order_with_model_and_address() -> None:
    read = services_in("poly_haven, openai:gpt-image-1,hunyuan3d@http://127.0.0.1:8081")
    assert read == (
        ServiceChoice("poly_haven"),
        ServiceChoice("openai", "gpt-image-1"),
        ServiceChoice("hunyuan3d", address="http://127.0.0.1:8081"),
    )
    assert services_in("") == ()


@pytest.mark.parametrize(
    "setting", ["turbosquid", "meshy,meshy", "meshy@ftp://here", "meshy@http://me:word@here/?key=1"]
)
def test_what_is_no_service_is_refused(setting: str) -> None:
    with pytest.raises(ValueError, match=r"service"):
        services_in(setting)
