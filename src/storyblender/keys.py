"""Keys of models and services: from the environment, else from the keyring of the operating system, never from a file.

A key is for the own servers of whoever gave it. A server with an address of its own has a key named after its host, so
that a project from elsewhere, which remembers addresses, cannot send a key anywhere.
"""
# pyright: reportMissingImports=false
# the extras with keyring are not installed where nobody uses a model or a service

from __future__ import annotations

import os
import re
from typing import Final
from urllib.parse import urlsplit

from storyblender.service_setting import ServiceChoice, ServiceName

SERVICE_KEYS: Final[dict[ServiceName, str]] = {
    "sketchfab": "SKETCHFAB_API_TOKEN", "gemini": "GOOGLE_API_KEY", "openai": "OPENAI_API_KEY",
    "meshy": "MESHY_API_KEY",
}  # fmt: skip
"""Service -> the environment variable of its key, and the name under which the keyring has it."""
TENCENT_KEYS: Final = ("TENCENTCLOUD_SECRET_ID", "TENCENTCLOUD_SECRET_KEY")
"""Names of the two halves of the key of ``hunyuan3d``."""


def known_key(name: str) -> str:
    """Return a key; empty if neither the environment nor the keyring has it.

    Args:
        name: Of the environment variable, and of the entry in the keyring.
    """
    if os.environ.get(name):
        return os.environ[name].strip()
    try:
        import keyring
        from keyring.errors import KeyringError
    except ImportError:
        return ""
    try:
        return (keyring.get_password("storyblender", name) or "").strip()
    except KeyringError:
        return ""


def key_name_of_host(address: str) -> str:
    """Return the name of the key for a server with an address of its own.

    Args:
        address: Its URL.
    """
    return "STORYBLENDER_KEY_" + re.sub(r"[^A-Z0-9]+", "_", urlsplit(address).netloc.upper())


def service_key_name(choice: ServiceChoice) -> str:
    """Return the name of the key that a service may have; empty where it needs none."""
    return key_name_of_host(choice.address) if choice.address else SERVICE_KEYS.get(choice.name, "")


def key_names(name: ServiceName) -> tuple[str, ...]:
    """Return the names of the keys that a service's own servers ask for; none where they ask for none."""
    return TENCENT_KEYS if name == "hunyuan3d" else tuple(filter(None, (SERVICE_KEYS.get(name, ""),)))


def service_key(choice: ServiceChoice) -> str:
    """Return the key of a service; empty if there is none."""
    name = service_key_name(choice)
    return known_key(name) if name else ""
