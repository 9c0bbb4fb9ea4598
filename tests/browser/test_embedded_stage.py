"""A stage in a frame of another site: drawn where the show names that site, and refused by the browser elsewhere."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import pytest
from playwright.sync_api import Browser, expect

from tests.browser.conftest import playing
from tests.browser.waiting import PATIENCE, wait_until


class FramingPage(BaseHTTPRequestHandler):
    """Answers with a page that frames the address of its query."""

    def do_GET(self) -> None:
        body = f'<iframe src="{self.path.partition("?")[2]}" width="160" height="120"></iframe>'.encode()
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_: object) -> None:
        """Says nothing on the terminal."""


@contextmanager
def serving() -> Iterator[str]:
    """The origin of a site whose pages frame what they are told."""
    with ThreadingHTTPServer(("127.0.0.1", 0), FramingPage) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@pytest.fixture(scope="module")
def sites() -> Iterator[tuple[str, str]]:
    """Two sites: one that the show names, and another."""
    with ExitStack() as stack:
        yield stack.enter_context(serving()), stack.enter_context(serving())


@pytest.fixture(scope="module")
def show(sites: tuple[str, str], tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A show that names the first of the sites."""
    yield from playing(tmp_path_factory.mktemp("embedded") / "test.omote", "--embed", sites[0])


def test_a_named_site_frames_a_stage_alone_and_others_are_refused(
    browser: Browser, show: str, sites: tuple[str, str]
) -> None:
    named, other = sites
    page = browser.new_context().new_page()
    page.set_default_timeout(1000 * PATIENCE)
    said: list[str] = []
    page.on("console", lambda message: said.append(message.text))
    stage = f"{show}/stage?quality=lowest"
    page.goto(f"{named}/?{stage}")
    framed = page.frames[1]
    wait_until(framed, "window.omoteStage?.settled() === true")
    assert not any("frame-ancestors" in text for text in said)
    for site, address in ((other, stage), (named, f"{show}/console")):
        said.clear()
        page.goto(f"{site}/?{address}")
        expect(page.locator("iframe")).to_be_visible()
        assert page.frames[1].url.startswith("chrome-error:")
        assert any("frame-ancestors" in text for text in said)
    page.context.close()
