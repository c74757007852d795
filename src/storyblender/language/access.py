"""Where a model is, and the key that it asks for: from the environment or the keyring of the operating system.

A provider's key is for its own servers only. A server with an address of its own has a key named after its host, so
that a project from elsewhere, which remembers its crew, cannot send a key anywhere.
"""

from __future__ import annotations

import os
from typing import Final

from storyblender.crew_setting import Player
from storyblender.errors import InputError
from storyblender.keys import key_name_of_host, known_key

_KEYS: Final = {
    "anthropic": "ANTHROPIC_API_KEY", "google": "GOOGLE_API_KEY", "openai": "OPENAI_API_KEY",
    "openai-chat": "OPENAI_API_KEY", "openrouter": "OPENROUTER_API_KEY",
}  # fmt: skip
"""Provider -> the environment variable of its key, and the name under which the keyring has it."""
_LOCAL: Final = {
    "ollama": ("OLLAMA_BASE_URL", "http://127.0.0.1:11434/v1"), "vllm": ("VLLM_BASE_URL", "http://127.0.0.1:8000/v1"),
}  # fmt: skip
"""Provider -> the environment variable of its address, and the usual one."""


def address_of(player: Player) -> str:
    """Return the address of a player's server; empty for the provider's own."""
    name, usual = _LOCAL.get(player.where, ("", ""))
    return player.address or (os.environ.get(name) or usual if name else "")


def key_of(player: Player) -> str:
    """Return the key of a player, empty if none is needed; a provider's key is for its own servers only.

    Raises:
        InputError: It is missing.
    """
    if player.address:
        return known_key(key_name_of_host(player.address))
    name = _KEYS.get(player.where)
    key = known_key(name) if name else ""
    if name and not key:
        mend = f"set {name} in the environment, or `keyring set storyblender {name}`"
        raise InputError(f"there is no key for {player.where}", mend=mend)
    return key
