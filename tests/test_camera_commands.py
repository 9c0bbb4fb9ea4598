"""`omote track`: what it says, and that it opens the page; the server is in tests/server/camera."""

from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.cli import app
from omote.server.camera.show_relay import ShowTarget


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The pages that were opened."""
    pages: list[str] = []
    monkeypatch.setattr("webbrowser.open", pages.append)
    return pages


def serve(reason: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Has the command find a show in this state."""

    def track(target: ShowTarget, port: int, announce: Callable[[str, str], None]) -> None:
        announce(f"http://localhost:{port}/camera", reason)

    monkeypatch.setattr("omote.server.camera.track_server.track", track)


def test_it_says_where_the_page_is_and_opens_it(monkeypatch: pytest.MonkeyPatch, opened: list[str]) -> None:
    serve("", monkeypatch)
    done = CliRunner().invoke(app, ["track", "--to", "192.168.1.5"])
    assert done.exit_code == 0, done.stderr
    assert "the show at http://192.168.1.5:8090 hears this machine" in done.stderr
    assert opened == ["http://localhost:8095/camera"]


def test_it_says_why_a_show_cannot_be_reached(monkeypatch: pytest.MonkeyPatch, opened: list[str]) -> None:
    serve("the show at http://x cannot be reached: it asks for a token", monkeypatch)
    done = CliRunner().invoke(app, ["track", "--to", "x", "--port", "9000", "--no-open"])
    assert "it asks for a token. The page tries again by itself." in done.stderr
    assert "http://localhost:9000/camera" in done.stderr
    assert opened == []


@pytest.mark.parametrize(
    ("to", "said"), [("ftp://show", "no address of a show"), ("show:x", "no address"), ("''", "no address of a show")]
)
def test_what_is_no_show_is_said(to: str, said: str) -> None:
    done = CliRunner().invoke(app, ["track", "--to", to])
    assert done.exit_code == 1
    assert said in done.stderr


def test_a_certificate_for_a_show_without_https_and_a_file_that_is_none_are_said(tmp_path: Path) -> None:
    picture = tmp_path / "pic.jpg"
    picture.write_bytes(b"\xff\xd8\xff")
    for to, said in (("show", "--to https://show:8090"), ("https://show", "it holds none")):
        done = CliRunner().invoke(app, ["track", "--to", to, "--authority", str(picture)])
        assert done.exit_code == 1
        assert said in done.stderr


def test_a_certificate_that_is_not_there_is_said(tmp_path: Path) -> None:
    done = CliRunner().invoke(app, ["track", "--to", "https://show", "--authority", str(tmp_path / "none.pem")])
    assert done.exit_code == 1
    assert "no certificate to trust" in done.stderr
