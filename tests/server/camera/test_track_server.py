"""`omote track` on the performer's own machine: which show is meant, which page is served, and to whom."""

import socket
from pathlib import Path

import pytest
from aiohttp import web
from aiohttp.test_utils import TestClient, TestServer

from omote.server.camera import track_server
from omote.server.camera.show_relay import ShowTarget
from omote.server.camera.track_server import application, find_target
from omote.server.http.static_pages import Page

PAGES = {
    "/camera": Page(b"the page", "text/html", immutable=False),
    "/static/a.js": Page(b"a", "text/javascript", True),
}


@pytest.mark.parametrize(
    ("typed", "address", "token"),
    [
        ("192.168.1.5", "http://192.168.1.5:8090", ""),
        ("show.local:8471", "http://show.local:8471", ""),
        ("http://192.168.1.5:8090/console?token=abc", "http://192.168.1.5:8090", "abc"),
        ("https://192.168.1.5:8090", "https://192.168.1.5:8090", ""),
        (" show/camera ", "http://show:8090", ""),
    ],
)
def test_the_show_is_named_as_people_name_it(typed: str, address: str, token: str) -> None:
    target = find_target(typed, None, None)
    assert (target.address, target.token) == (address, token)
    assert (target.trusted is None) == address.startswith("http:")
    assert find_target(typed, "other", None).token == "other"


def test_what_names_no_show_is_rejected(tmp_path: Path) -> None:
    for typed in ("", "ftp://show", "show:port"):
        with pytest.raises(ValueError, match="address"):
            find_target(typed, None, None)
    with pytest.raises(ValueError, match="token"):
        find_target("show", "ä", None)
    with pytest.raises(OSError, match="no certificate to trust"):
        find_target("https://show", None, tmp_path / "missing.pem")


@pytest.mark.asyncio
async def test_only_this_machine_s_own_pages_get_the_page() -> None:
    served: TestServer = TestServer(application(ShowTarget("http://far:8090"), PAGES))
    client: TestClient[web.Request, web.Application] = TestClient(served)
    async with client:
        for path in ("/", "/camera"):
            answer = await client.get(path)
            assert await answer.text() == "the page"
            assert "default-src 'self'" in answer.headers["Content-Security-Policy"]
        console = await client.get("/console", allow_redirects=False)
        assert (console.status, console.headers["Location"]) == (302, "http://far:8090/console")
        missing = await client.get("/editor")
        assert (missing.status, "http://far:8090" in await missing.text()) == (404, True)
        foreign = await client.get("/camera", headers={"Host": "evil.example"})
        assert foreign.status == 403
        other = await client.get("/camera/link", headers={"Origin": "http://evil.example"})
        assert other.status == 403


def test_a_show_that_is_away_is_said_and_the_page_is_served_all_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(track_server, "read_pages", lambda: PAGES)
    with socket.socket() as away:
        away.bind(("127.0.0.1", 0))
        target = ShowTarget(f"http://127.0.0.1:{away.getsockname()[1]}")
        said: list[tuple[str, str]] = []

        def announce(page: str, reason: str) -> None:
            said.append((page, reason))
            raise KeyboardInterrupt

        with pytest.raises(KeyboardInterrupt):
            track_server.track(target, 0, announce)
    ((page, reason),) = said
    assert page.endswith("/camera")
    assert "cannot be reached" in reason
