"""The cast changes during the show: pages take it in without a reload, what is on air passes over without a jump."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Coroutine, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any
from urllib.parse import quote

import aiohttp
import msgspec
import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page, expect

import omote
from omote.edit.protocol import messages as editing
from omote.edit.protocol.messages import EDITING_PATH
from omote.model.cast import Cast
from omote.show.cast_documents import CompoundAsset
from omote.show.declaration import ClientMessage
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace
from omote.show.objects.items import KeepFace
from omote.show.objects.link import Hello, Ping, Pong
from omote.show.wire import decode_answer, encode
from omote.stage_data.assets import rest_positions
from tests.browser.conftest import playing
from tests.browser.waiting import floats, wait_until
from tests.compound_assets import unpack_compound
from tests.server.conftest import Editor

OpenPage = Callable[..., Page]
Floats = NDArray[np.float64]
LARGEST_STEP = 0.1
"""Seconds that a stage draws in one frame at most (`face_view.ts`)."""
TOLERANCE = 0.05e-3  # metres


@pytest.fixture(scope="module")
def show(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A show of this module alone, for its cast changes."""
    yield from playing(tmp_path_factory.mktemp("live") / "live.omote")


@pytest.fixture(scope="module")
def cast() -> Cast:
    """The built-in cast."""
    return omote.load_cast()


def run(work: Coroutine[Any, Any, Any]) -> Any:
    """What some work gives, done in a thread of its own: this one's loop belongs to the browser."""
    with ThreadPoolExecutor(max_workers=1) as thread:
        return thread.submit(asyncio.run, work).result()


@dataclass(frozen=True)
class Author:
    """An editor without a page."""

    url: str

    def work(self, doing: Callable[[Editor], Awaitable[Any]]) -> Any:
        """Greets, does something and leaves."""

        async def whole() -> Any:
            async with (
                aiohttp.ClientSession() as http,
                http.ws_connect(self.url + EDITING_PATH, max_msg_size=0) as link,
            ):
                page = Editor(link)
                await page.greet()
                return await doing(page)

        return run(whole())

    def expression(self, label: str) -> Any:
        """A new own expression, saved: the smile, higher."""

        async def make(page: Editor) -> Any:
            draft = await page.ask(editing.CreateExpression, label, {"smile": 1.0}, False)
            await page.ask(editing.Save, draft.item, "")
            return draft

        return self.work(make)

    def raise_it(self, draft: Any, metres: float) -> Any:
        """The next revision of an expression: all points so much higher."""

        async def change(page: Editor) -> Any:
            opened = await page.ask(editing.OpenItem, draft.item)
            vectors = [(0.0, metres, 1.0)] * len(opened.recipe.net)
            moved = await page.ask(editing.SetVectors, draft.item, vectors, "up")
            await page.ask(editing.Save, draft.item, "")
            return moved

        return self.work(change)

    def play(self, *messages: ClientMessage) -> None:
        """Plays as a console does, and waits until it was heard."""

        async def say() -> None:
            async with aiohttp.ClientSession() as http, http.ws_connect(self.url + LINK_PATH) as link:
                for message in (Hello("console", PROTOCOL_VERSION), *messages, Ping(0.0)):
                    await link.send_bytes(encode(message))
                while not isinstance(decode_answer(await link.receive_bytes()), Pong):
                    pass

        run(say())

    def wear(self, cast: Cast, content: str) -> Floats:
        """The generic face wearing a content, as the server has it, (vertices, 3) metres."""

        async def fetch() -> bytes:
            address = f"{self.url}/compounds/{cast.digest}/generic/{quote(content, safe='')}"
            async with aiohttp.ClientSession() as http, http.get(address) as response:
                return await response.read()

        rest = rest_positions(cast, cast.faces["generic"]).astype(np.float64)
        moves: Floats = rest + unpack_compound(msgspec.msgpack.decode(run(fetch()), type=CompoundAsset), len(rest))
        return moves


@pytest.fixture
def author(show: str) -> Author:
    """Somebody who authors in this show."""
    return Author(show)


def shown(page: Page) -> Floats:
    """The positions that a stage draws, (vertices, 3) metres."""
    return floats(page, "window.omoteStage.readPositions()").reshape(-1, 3)


def test_a_saved_expression_is_on_the_console_and_on_air_without_a_reload(
    open_page: OpenPage, author: Author, cast: Cast
) -> None:
    stage = open_page("/stage", width=320, height=240)
    console = open_page("/console", pictures=False)
    wait_until(stage, "window.omoteStage && window.omoteStage.settled()")
    tiles = console.locator("omote-palette .tile")
    expect(tiles.first).to_be_visible()
    for page in (stage, console):
        page.evaluate("window.sameAsBefore = true")
    draft = author.expression("Broad grin")
    own = console.locator("omote-palette .tile[data-name='broad_grin']")
    expect(own).to_contain_text("Broad grin")
    own.click()
    wait_until(stage, "window.omoteStage.pose().expressions.broad_grin === 1 && window.omoteStage.settled()")
    assert np.abs(shown(stage) - author.wear(cast, draft.content)).max() < TOLERANCE
    assert [page.evaluate("window.sameAsBefore") for page in (stage, console)] == [True, True]


def test_a_changed_expression_on_air_passes_to_the_new_one_without_a_jump(
    open_page: OpenPage, author: Author, cast: Cast
) -> None:
    draft = author.expression("Lopsided")
    author.play(CallExpression("one", "call", "lopsided", 0.0, "smooth"))
    stage = open_page("/stage", width=160, height=120)
    wait_until(stage, "window.omoteStage?.pose()?.expressions.lopsided === 1 && window.omoteStage.settled()")
    before = author.wear(cast, draft.content)
    stage.evaluate("""() => {
        window.frames_seen = [];
        const keep = () => {
            window.frames_seen.push(window.omoteStage.readPositions());
            if (window.frames_seen !== null) requestAnimationFrame(keep);
        };
        keep();
    }""")
    moved = author.raise_it(draft, 0.002)
    after = author.wear(cast, moved.content)
    row = int(np.linalg.norm(after - before, axis=1).argmax())
    wait_until(stage, f"Math.hypot(...[0, 1, 2].map((axis) => window.frames_seen.at(-1)[{3 * row} + axis] "
                    f"- {after[row].tolist()}[axis])) < 1e-5")  # fmt: skip
    places = np.array(stage.evaluate(f"window.frames_seen.map((all) => all.slice({3 * row}, {3 * row + 3}))"))
    way = after[row] - before[row]
    share = (places - before[row]) @ way / (way @ way)
    assert np.abs(places - before[row] - share[:, None] * way).max() < TOLERANCE  # straight from one to the other
    assert share[0] == pytest.approx(0.0, abs=0.01)
    steps = np.diff(share)
    assert steps.min() > -0.01
    assert steps.max() < 1.5 * LARGEST_STEP / 0.25 + 0.01  # the steepest of a smooth quarter of a second


def test_what_is_kept_on_air_is_in_the_palette(open_page: OpenPage, author: Author) -> None:
    console = open_page("/console", pictures=False)
    expect(console.locator("omote-palette .tile").first).to_be_visible()
    author.play(CallFace("one", "half", "dog", 0.0, "smooth"), KeepFace("one", "kept"))
    expect(console.locator("omote-palette .tile[data-source^='#'] .name", has_text="On air")).to_have_count(1)
