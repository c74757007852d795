"""A key goes to its own service, and nowhere else: into no message, no trace, no file."""

from __future__ import annotations

import base64
import os
import re
import subprocess
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from storyblender.crew_setting import Player, players
from storyblender.errors import InputError, NoAnswer
from storyblender.language.budget import Budget
from tests.wire.conftest import request_of
from tests.wire.loopback import Act, Cut, Fail, Raw, Say, Server, serving
from tests.wire.wires import SERVICES, Service

KEY = "odd-Zebra-42-quagga"
"""Found nowhere but where it belongs."""
every_service = pytest.mark.parametrize("service", SERVICES.values(), ids=SERVICES)
ACTS: dict[str, Act] = {
    "401": Fail(401, "bad key in "), "400": Fail(400, "bad request with "), "404": Fail(404, "no such "),
    "429": Fail(429, "too many of "), "500": Fail(500, "crashed at "), "cut": Cut(),
    "answer": Say(f'{{"number": "{KEY}"}}'),
    "text": Raw(f"<html>{KEY}</html>".encode(), "text/html"), "refusal": Say(f"not for {KEY}", "refusal"),
}  # fmt: skip


def key_name(server: Server) -> str:
    """Return where the key for a server is looked for."""
    return "STORYBLENDER_KEY_" + re.sub(r"\W", "_", server.address.removeprefix("http://").replace(".", "_"))


@every_service
@pytest.mark.parametrize("act", ACTS.values(), ids=ACTS)
def test_a_server_that_repeats_the_key_does_not_make_us_say_it(
    service: Service, act: Act, provider: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    with serving(service.wire, act, gossips=True) as server:
        monkeypatch.setenv(key_name(server), KEY)
        with pytest.raises(NoAnswer) as caught:
            provider(service, server).answer(request_of())
    assert KEY in str(server.headers[0]), "it arrived where it belongs"
    assert KEY not in "".join(traceback.format_exception(caught.value))


@every_service
def test_the_key_of_a_provider_goes_to_no_other_address(
    service: Service, provider: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    with serving(service.wire, Say('{"number": 3}')) as server:
        asks = provider(service, server)
        for name in ("OPENAI_API_KEY", "ANTHROPIC_API_KEY", "GOOGLE_API_KEY", "GEMINI_API_KEY", "OLLAMA_API_KEY"):
            monkeypatch.setenv(name, KEY)
        asks = provider(service, server)
        asks.answer(request_of())
    assert KEY not in str(server.headers)


@pytest.mark.parametrize("provider_name", ["openai", "openai-chat", "anthropic", "google", "openrouter"])
def test_a_missing_key_is_one_sentence(provider_name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    from threading import Event

    import keyring
    from keyring.errors import NoKeyringError

    from storyblender.language.provider import Provider

    def none(service: str, name: str) -> str | None:
        raise NoKeyringError

    monkeypatch.setattr(keyring, "get_password", none)
    player = Player("model", provider_name, "some/model")
    for name in ("OPENAI_API_KEY", "ANTHROPIC_API_KEY", "GOOGLE_API_KEY", "OPENROUTER_API_KEY"):
        monkeypatch.delenv(name, raising=False)
    with pytest.raises(
        InputError, match=rf"no key for {provider_name}; set \w+_API_KEY in the environment, or `keyring"
    ):
        Provider(player, Budget({}), Event())
    monkeypatch.setattr(keyring, "get_password", lambda service, name: KEY if service == "storyblender" else None)
    Provider(player, Budget({}), Event())


@pytest.mark.parametrize("address", [f"https://me:{KEY}@host/v1", f"https://host/v1?key={KEY}", f"https://{KEY}@host"])
def test_an_address_holds_no_key(address: str) -> None:
    with pytest.raises(ValueError, match="can play a role"):
        players(f"openai-chat:some-model@{address}")


SPELLINGS = (KEY, base64.b64encode(KEY.encode()).decode(), KEY.encode().hex(), KEY[::-1])
"""The key, and what a careless program could make of it."""


@pytest.mark.parametrize("name", ["openai_chat", "ollama"])
def test_what_is_recorded_of_a_run_has_no_key(name: str, tmp_path: Path) -> None:
    service, script = SERVICES[name], tmp_path / "doors.fountain"
    script.write_text("INT. HALL - DAY\n\nANNA opens the door.\n\nEXT. STREET - NIGHT\n\nANNA runs.\n")
    answers = (Say('{"units": []}'), Say("not an answer"), Say(f'{{"units": "{KEY}"}}'), Say('{"units": []}'))
    with serving(service.wire, *answers, gossips=True) as server:
        player = f"{service.provider}:{service.model}@{server.address}{service.path}"
        variables = {key_name(server): KEY, "OPENAI_LOG": "debug"}
        command = [sys.executable, "-m", "storyblender", "plan", str(script), "--crew", player]
        done = subprocess.run(
            command, env=os.environ | variables, capture_output=True, text=True, timeout=300, check=False
        )
    assert done.returncode == 0 and all(KEY in str(headers) for headers in server.headers), "it came by environment"
    files = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    recorded = [path for path in files if path.parent.name == "answers"]
    assert [path for path in recorded if path.name.endswith(".request.md")], "requests are recorded"
    assert [path for path in recorded if files[path] == b"not an answer"], "answers are recorded as they were given"
    for spelling in SPELLINGS:
        assert [path.name for path, text in files.items() if spelling.encode() in text] == []
        assert [path.name for path in files if spelling in str(path)] == []
        assert spelling not in done.stdout + done.stderr


@pytest.mark.parametrize("name", ["openai_chat", "openai_responses", "anthropic", "gemini"])
def test_no_file_and_no_output_of_a_run_has_the_key(name: str, tmp_path: Path) -> None:
    service, script = SERVICES[name], tmp_path / "doors.fountain"
    script.write_text("INT. HALL - DAY\n\nANNA opens the door.\n\nEXT. STREET - NIGHT\n\nANNA runs.\n")
    acts = (Fail(500, "crashed at "), Say(f'{{"units": "{KEY}"}}'), Fail(400, "no such form "), Fail(401, "bad key "))
    with serving(service.wire, *acts, gossips=True) as server:
        crew = f"director={service.provider}:{service.model}@{server.address}{service.path}"
        variables = {key_name(server): KEY, "OPENAI_LOG": "info", "ANTHROPIC_LOG": "info"}
        command = [sys.executable, "-m", "storyblender", "plan", str(script), "--crew", crew]
        done = subprocess.run(
            command, env=os.environ | variables, capture_output=True, text=True, timeout=300, check=False
        )
    assert done.returncode == 0 and KEY in str(server.headers)
    texts = {path.name: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    assert "trace.jsonl" in texts and b"did not answer" in texts["trace.jsonl"]
    assert [name for name, text in texts.items() if KEY.encode() in text] == []
    assert KEY not in done.stdout + done.stderr
