"""One more browser is let in by a fresh address of the studio that has the project open, and by no other."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from typer.testing import CliRunner

from storyblender.cli import app
from storyblender.errors import InputError
from storyblender.web_studio.address_file import ADDRESS_FILE, AddressFile
from storyblender.web_studio.link import address_for_one_more


class Studio(BaseHTTPRequestHandler):
    """Answers a program that names its key."""

    def do_POST(self) -> None:
        known = self.headers["Authorization"] == "Bearer key" and self.path == "/calls"
        self.rfile.read(int(self.headers["Content-Length"]))
        self.send_response(200 if known else 403)
        self.end_headers()
        self.wfile.write(b'{"id": 1, "ok": true, "value": {"address": "fresh"}}' if known else b"no")

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing."""


@pytest.fixture
def address() -> Iterator[str]:
    server = ThreadingHTTPServer(("127.0.0.1", 0), Studio)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_address[1]}"
    server.shutdown()
    server.server_close()


@pytest.fixture
def project(tmp_path: Path) -> Path:
    project = tmp_path / "tale.storyboard"
    project.mkdir()
    (tmp_path / "tale.fountain").touch()
    return project


def test_the_studio_is_found_by_project_script_and_folder(address: str, project: Path) -> None:
    AddressFile(address, "key").follow(project)
    for place in (project, project.with_suffix(".fountain"), project.parent):
        assert address_for_one_more(place) == "fresh"
    done = CliRunner().invoke(app, ["studio", str(project), "--link"])
    assert done.exit_code == 0 and done.stdout == "fresh\n"


@pytest.mark.parametrize("key", ["key", "another"])
def test_what_is_no_studio_of_this_user_is_refused_in_a_sentence(address: str, project: Path, key: str) -> None:
    with pytest.raises(InputError, match="no studio has it open; start one"):
        address_for_one_more(project)
    AddressFile(address, key).follow(project)
    if key == "key":
        (project / ADDRESS_FILE).chmod(0o644)
    with pytest.raises(InputError, match="no studio has it open"):
        address_for_one_more(project)
    AddressFile("http://127.0.0.1:1", "key").follow(project)
    with pytest.raises(InputError, match="no studio has it open"):
        address_for_one_more(project.parent)
