"""OSCQuery over HTTP, read by a client that is not ours: npm's `oscquery`."""

import asyncio
import json
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from aiohttp.test_utils import TestClient, TestServer

from omote.inputs.oscquery_tree import build_addresses
from omote.model.cast import Cast
from omote.perform.scene.scene import Scene
from omote.server.access.security import own_names
from omote.server.http.app import ShowServer
from omote.server.http.cast_documents import CastDocuments
from omote.show.session import ShowSession
from tests.server.conftest import Clock, ShowHarness
from tests.server.synthetic_server import MASK, PAGES, meshes
from tools.node import find_node as find_node_path

pytestmark = pytest.mark.asyncio
WEB = Path(__file__).parents[3] / "web"
OSC_PORT = 9123
READ = """
const { OSCQueryDiscovery } = require("oscquery");
const discovery = new OSCQueryDiscovery();
discovery.queryNewService("127.0.0.1", Number(process.argv[1])).then((show) => {
  const nodes = show.flat().map((node) => [node.full_path, node]);
  const told = nodes.map(([path, node]) => [path, (node.arguments ?? []).map((a) => [a.type, a.range, a.value])]);
  console.log(JSON.stringify({ host: show.hostInfo, tree: Object.fromEntries(told) }));
});
"""


@pytest_asyncio.fixture
async def harness(cast: Cast) -> AsyncIterator[ShowHarness]:
    """A show whose OSC is on."""
    clock = Clock()
    documents = CastDocuments(cast, meshes(cast), MASK)
    show = ShowServer(ShowSession(cast, epoch=7), documents, PAGES, clock=clock)
    show.enable_oscquery(OSC_PORT)
    async with TestClient(TestServer(show.application(own_names()))) as client:
        yield ShowHarness(show, client, clock)
    documents.close()


async def read(harness: ShowHarness, path: str) -> Any:
    """What a surface that takes anything gets."""
    async with harness.client.get(path) as response:
        assert (response.status, response.content_type) == (200, "application/json")
        return await response.json()


async def test_npm_oscquery_reads_the_whole_tree(harness: ShowHarness) -> None:
    harness.tick()
    path = find_node_path()
    assert path is not None
    node = await asyncio.create_subprocess_exec(
        "node", "-e", READ, str(harness.client.port), cwd=WEB, env={"PATH": path}, stdout=asyncio.subprocess.PIPE
    )
    printed, _ = await node.communicate()
    told = json.loads(printed)
    assert told["host"]["oscPort"] == OSC_PORT
    ((kind, span, value),) = told["tree"]["/omote/one/channel/jawOpen"]
    assert (kind, span["min"], span["max"], value) == ("f", -0.5, 1.5, 0.0)
    ((kind, span, value),) = told["tree"]["/omote/one/face"]
    assert (kind, value) == ("s", next(iter(harness.show.session.cast.faces)))
    assert span["vals"] == list(harness.show.session.cast.faces)


async def test_a_node_one_attribute_and_what_is_not_there(harness: ShowHarness, cast: Cast) -> None:
    assert await read(harness, "/") == build_addresses(
        cast, ["one"], {name: pad.dimensions for name, pad in Scene.begun(cast).pads.items()}
    )
    harness.tick()
    assert (await read(harness, "/omote/one/face"))["TYPE"] == "s"
    assert await read(harness, "/omote/one/fade/face?VALUE") == {"VALUE": [0.0]}
    assert (await read(harness, "/?HOST_INFO"))["OSC_PORT"] == OSC_PORT
    for path, status in (("/omote/panic?VALUE", 204), ("/omote/one/nobody", 404), ("/omote?COLOUR", 400)):
        async with harness.client.get(path) as response:
            assert response.status == status


async def test_a_browser_still_gets_the_page(harness: ShowHarness) -> None:
    async with harness.client.get("/", headers={"Accept": "text/html,*/*"}) as response:
        assert await response.read() == PAGES["/"].body


async def test_a_show_without_osc_has_no_tree(show_harness: ShowHarness) -> None:
    async with show_harness.client.get("/omote") as response:
        assert response.status == 404


async def test_somebody_at_a_terminal_is_told_in_words_and_a_surface_is_not(harness: ShowHarness) -> None:
    harness.tick()
    for agent, told in (("curl/8.5.0", "/console plays it"), ("node", '"FULL_PATH":"/"')):
        async with harness.client.get("/", headers={"User-Agent": agent, "Accept": "*/*"}) as response:
            assert told in await response.text()
    async with harness.client.get("/", headers={"User-Agent": "curl/8", "Accept": "application/json"}) as response:
        assert response.content_type == "application/json"


async def test_the_tree_is_made_once_for_a_cast_and_its_characters(harness: ShowHarness) -> None:
    show = harness.show
    harness.tick()
    assert show.oscquery is not None
    first = await read(harness, "/omote")
    made = show.oscquery._addresses
    show.session.scene["one"].set_channel("jawOpen", 0.5)
    harness.tick()
    assert (await read(harness, "/omote/one/channel/jawOpen"))["VALUE"] == [0.5]
    assert show.oscquery._addresses is made
    show.session.scene.add("two")
    assert "two" in (await read(harness, "/omote"))["CONTENTS"]
    assert "two" not in first["CONTENTS"]
