"""OSC over real sockets, from clients that are not ours: python-osc, and liblo's `oscsend` and `oscdump` where they
are."""

import asyncio
import shutil
import socket
import subprocess
import sys
from collections.abc import AsyncIterator, Iterable
from pathlib import Path

import aiohttp
import pytest
import pytest_asyncio
from pythonosc.osc_bundle_builder import OscBundleBuilder
from pythonosc.osc_message_builder import OscMessageBuilder
from pythonosc.tcp_client import SimpleTCPClient
from pythonosc.udp_client import SimpleUDPClient

from omote.inputs.allowed_senders import AllowedSenders
from omote.inputs.osc_input import OscInput
from omote.inputs.osc_packet import decode_packet, encode_bundle, encode_message
from omote.model.cast import Cast
from omote.server.devices.osc_listener import MOST_CONNECTIONS, MOST_WAITING, OBEY_SECONDS, OscListener
from omote.server.devices.rejection_log import RejectionLog
from omote.server.supervision.listening_socket import listen_for_osc
from omote.show.session import ShowSession
from tests.server.conftest import ShowHarness
from tools.node import find_node

pytestmark = pytest.mark.asyncio
HOST = "127.0.0.1"
WEB = Path(__file__).parents[3] / "web"


@pytest.fixture
def said() -> list[str]:
    """What the terminal was told."""
    return []


@pytest_asyncio.fixture
async def listener(show_harness: ShowHarness, said: list[str]) -> AsyncIterator[OscListener]:
    sockets = listen_for_osc(HOST, 0)
    made = OscListener(OscInput(lambda: show_harness.show.session), sockets, RejectionLog(said.append))
    await made.start()
    show_harness.show.sources.append(made)
    yield made
    await made.close()
    sockets.close()


@pytest.fixture
def port(listener: OscListener) -> int:
    number: int = listener._sockets.datagrams.getsockname()[1]
    return number


async def tick_until_heard(harness: ShowHarness, listener: OscListener, count: int) -> None:
    """Ticks until so many messages have been heard."""
    while listener.osc.heard < count:
        harness.tick()
        await asyncio.sleep(0.001)
    harness.tick()


def read_until(lines: Iterable[str], words: str) -> str:
    """The first line with these words."""
    return next(line for line in lines if words in line)


async def test_python_osc_plays_over_udp(show_harness: ShowHarness, listener: OscListener, port: int) -> None:
    client = SimpleUDPClient(HOST, port)
    client.send_message("/omote/one/face", ["broad", 0])
    client.send_message("/omote/one/channel/jawOpen", 0.5)
    bundle = OscBundleBuilder(2_000_000_000)
    for angle in ("10", 20):
        message = OscMessageBuilder("/omote/one/head")
        for value in (angle, 0.0, 0.0):
            message.add_arg(value)
        bundle.add_content(message.build())
    client._sock.sendto(bundle.build().dgram, (HOST, port))
    await tick_until_heard(show_harness, listener, 4)
    session = show_harness.show.session
    state = session.tick(show_harness.clock())
    assert (state.characters["one"].faces, state.characters["one"].channels) == ({"broad": 1.0}, {"jawOpen": 0.5})
    assert state.characters["one"].head == pytest.approx((0.349066, 0.0, 0.0), abs=1e-5)
    client._sock.close()


@pytest.mark.parametrize("mode", ["1.0", "1.1"])
async def test_python_osc_plays_over_tcp_and_hears_the_state(
    show_harness: ShowHarness, listener: OscListener, port: int, mode: str
) -> None:
    with SimpleTCPClient(HOST, port, mode=mode) as client:  # type: ignore[no-untyped-call]
        client.send_message("/omote/subscribe", [])
        client.send_message("/omote/one/expression", ["smile", 0])
        await tick_until_heard(show_harness, listener, 2)
        heard = dict[str, object]()
        while "/omote/one/expression" not in heard:  # later than the rest: it is its own
            show_harness.tick()
            await asyncio.sleep(0.001)
            for data in client.receive(timeout=0.01):
                heard |= {message.address: message.arguments for message in decode_packet(data)}
        assert heard["/omote/one/expression"] == ("smile",)
    while show_harness.show.session.crew:
        show_harness.tick()
        await asyncio.sleep(0.001)


@pytest.mark.skipif(sys.platform == "win32", reason="there is no uvloop")
async def test_a_surface_plays_over_tcp_on_the_loop_that_a_show_has(cast: Cast, said: list[str]) -> None:
    import uvloop

    session = ShowSession(cast)
    osc = OscInput(lambda: session)

    async def play() -> None:
        sockets = listen_for_osc(HOST, 0)
        listener = OscListener(osc, sockets, RejectionLog(said.append))
        await listener.start()
        number = sockets.datagrams.getsockname()[1]
        _, writer = await asyncio.open_connection(HOST, number)
        writer.write(b"\xc0" + encode_message("/omote/one/channel/jawOpen", 0.5) + b"\xc0")
        async with asyncio.timeout(60):
            while not osc.heard:
                listener.hear(0.0)
                await asyncio.sleep(0.001)
        writer.close()
        await listener.close()
        sockets.close()

    await asyncio.to_thread(uvloop.run, play())
    assert (osc.heard, session.tick(0.0).characters["one"].channels) == (1, {"jawOpen": 0.5})


NPM_OSC = """
const osc = require("osc");
const port = new osc.TCPSocketPort({ address: "127.0.0.1", port: Number(process.argv[1]) });
port.on("ready", () => {
  port.send({ address: "/omote/subscribe", args: [] });
  port.send({ address: "/omote/one/face", args: [{ type: "s", value: "broad" }, { type: "f", value: 0 }] });
});
port.on("message", (heard) => {
  if (heard.address === "/omote/one/face" && heard.args[0] === "broad") process.exit(0);
});
port.open();
"""


async def test_npm_osc_plays_over_tcp_and_hears(show_harness: ShowHarness, listener: OscListener, port: int) -> None:
    path = find_node()
    assert path is not None
    node = await asyncio.create_subprocess_exec("node", "-e", NPM_OSC, str(port), cwd=WEB, env={"PATH": path})
    ended = asyncio.ensure_future(node.wait())
    while not ended.done():
        show_harness.tick()
        await asyncio.sleep(0.005)
    assert await ended == 0


@pytest.mark.skipif(shutil.which("oscsend") is None, reason="liblo-tools is not installed")
async def test_liblo_plays_and_hears(show_harness: ShowHarness, listener: OscListener, port: int) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind((HOST, 0))
        back = free.getsockname()[1]
    dump = subprocess.Popen(["stdbuf", "-oL", "oscdump", str(back)], stdout=subprocess.PIPE, text=True)
    assert dump.stdout is not None
    try:
        for words in (f"/omote/subscribe i {back}", "/omote/one/face sf broad 0.0"):
            subprocess.run(["oscsend", HOST, str(port), *words.split()], check=True)
        await tick_until_heard(show_harness, listener, 2)
        found = asyncio.get_running_loop().run_in_executor(None, read_until, dump.stdout, "/omote/one/face s")
        while not found.done():
            listener.osc.subscribe((HOST, back), show_harness.clock())  # oscdump may have opened its port only now
            show_harness.tick()
            await asyncio.sleep(0.01)
        assert '/omote/one/face s "broad"' in await found
    finally:
        dump.kill()
        dump.communicate()


async def test_a_flood_is_bounded_and_the_newest_wins(
    show_harness: ShowHarness, listener: OscListener, port: int, said: list[str]
) -> None:
    for number in range(10 * MOST_WAITING):
        listener.wait((HOST, 5), encode_message("/omote/one/channel/jawOpen", number / (10 * MOST_WAITING)))
    assert len(listener._waiting) == MOST_WAITING
    assert listener.dropped == 9 * MOST_WAITING
    while listener._waiting:
        show_harness.tick()
    weight = show_harness.show.session.tick(show_harness.clock()).characters["one"].channels["jawOpen"]
    assert weight == pytest.approx(1.0 - 1.0 / (10 * MOST_WAITING), abs=1e-6)


async def test_a_packet_of_many_messages_is_obeyed_over_several_ticks(
    show_harness: ShowHarness, listener: OscListener, monkeypatch: pytest.MonkeyPatch
) -> None:
    steps = iter(range(1000))
    monkeypatch.setattr("omote.server.devices.osc_listener.time.perf_counter", lambda: 0.6 * OBEY_SECONDS * next(steps))
    listener.wait((HOST, 5), encode_bundle([encode_message("/omote/one/channel/jawOpen", n / 4) for n in range(4)]))
    heard = []
    for _ in range(6):
        listener.hear(show_harness.clock())
        heard.append(listener.osc.heard)
    assert heard == [0, 1, 2, 3, 4, 4]


class Nobody(AllowedSenders):
    """As a foreign host meets it."""

    def allows(self, host: str) -> bool:  # noqa: ARG002
        return False


async def test_who_may_not_play_gets_no_connection_and_is_named(show_harness: ShowHarness, said: list[str]) -> None:
    sockets = listen_for_osc(HOST, 0)
    listener = OscListener(OscInput(lambda: show_harness.show.session), sockets, RejectionLog(said.append), Nobody())
    await listener.start()
    reader, writer = await asyncio.open_connection(HOST, sockets.datagrams.getsockname()[1])
    with pytest.raises((ConnectionError, asyncio.IncompleteReadError)):
        await reader.readexactly(1)
    writer.close()
    listener.hear(0.0)
    await listener.close()
    assert said == ["OSC from 127.0.0.1 is not heard: --allow 127.0.0.1 lets it play."]


async def test_the_terminal_hears_of_rejections_once_a_second(
    show_harness: ShowHarness, listener: OscListener, said: list[str]
) -> None:
    for _ in range(90):  # ticks: a second and a half
        listener.wait((HOST, 5), encode_message("/omote/one/face", "nobody"))
        show_harness.tick()
    assert len(said) == 2
    assert "OSC from 127.0.0.1: /omote/one/face: there is no face 'nobody'" in said[0]
    assert said[1].endswith("(60 were rejected).") or "were rejected" in said[1]


async def test_a_stream_that_cannot_be_read_is_closed_and_too_many_are_not_taken(
    show_harness: ShowHarness, listener: OscListener, port: int
) -> None:
    reader, writer = await asyncio.open_connection(HOST, port)
    writer.write(b"\xdbx\xc0")
    with pytest.raises((ConnectionError, asyncio.IncompleteReadError)):
        await reader.readexactly(1)
    opened = [await asyncio.open_connection(HOST, port) for _ in range(MOST_CONNECTIONS + 1)]
    while len(listener._connections) < MOST_CONNECTIONS:
        await asyncio.sleep(0.001)
    last, _ = opened[-1]
    with pytest.raises((ConnectionError, asyncio.IncompleteReadError)):
        await last.readexactly(1)
    for _, each in [(reader, writer), *opened]:
        each.close()


async def test_a_web_page_that_sends_frames_behind_a_request_plays_nothing(
    show_harness: ShowHarness, listener: OscListener, port: int, said: list[str]
) -> None:
    order = encode_message("/omote/one/face", "dog", 0.0)
    async with aiohttp.ClientSession() as http:
        with pytest.raises(aiohttp.ClientError):
            await http.post(f"http://{HOST}:{port}/", data=b"\xc0".join([b"", order, order, b""]))
    show_harness.tick()
    assert listener.osc.heard == 0
    assert "which is no OSC: its connection is ended" in said[0]
    reader, writer = await asyncio.open_connection(HOST, port)
    writer.write(b"\xc0".join([b"", encode_message("/omote/panic"), b"GET / HTTP/1.1", order, b""]))
    with pytest.raises((ConnectionError, asyncio.IncompleteReadError)):
        await reader.readexactly(1)
    writer.close()
    show_harness.tick()
    assert listener.osc.heard == 0


async def test_a_port_that_is_taken_is_said() -> None:
    sockets = listen_for_osc(HOST, 0)
    try:
        with pytest.raises(OSError, match=r"cannot be opened for OSC .*another program has it.*--osc off"):
            listen_for_osc(HOST, sockets.datagrams.getsockname()[1])
    finally:
        sockets.close()
