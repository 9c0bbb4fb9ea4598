"""sACN and Art-Net over real sockets on the loopback network; sACN from a library that is not ours."""

import asyncio
import os
import socket
from collections.abc import AsyncIterator

import pytest
import pytest_asyncio
import sacn

from omote.inputs.bindings.binding_file import read_bindings
from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.dmx.dmx_input import DmxInput
from omote.server.devices.dmx_listener import LOST_TICKS, DmxListener
from omote.server.devices.rejection_log import RejectionLog
from omote.server.supervision.device_sockets import listen_for_artnet, listen_for_sacn
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio
HOST = "127.0.0.1"
UNIVERSE = 1 + os.getpid() % 60_000
"""Each process of the tests has its own: all share the port of sACN."""
BOUND = f"""
[[binding]]
device = "sACN"
control = "{UNIVERSE}/2"
to = "/omote/one/channel/jawOpen"

[[binding]]
device = "Art-Net"
control = "0/1"
to = "/omote/one/gaze"
axis = "yaw"

[[binding]]
device = "Art-Net"
control = "0/2"
to = "/omote/one/face"
arguments = ["broad", 0.0]
"""


@pytest.fixture
def said() -> list[str]:
    """What the terminal was told."""
    return []


@pytest_asyncio.fixture
async def listener(show_harness: ShowHarness, said: list[str]) -> AsyncIterator[DmxListener]:
    bindings = BindingInput(Bindings(read_bindings(BOUND)), lambda: show_harness.show.session)
    dmx = DmxInput([UNIVERSE])
    dmx.watch(bindings.bindings.controls)
    sockets = listen_for_sacn(HOST, [UNIVERSE]), listen_for_artnet(HOST, 0)
    made = DmxListener(dmx, bindings, RejectionLog(said.append), sacn=sockets[0], artnet=sockets[1], report=said.append)
    show_harness.show.sources.append(made)
    yield made
    await made.close()


@pytest.fixture
def artnet(listener: DmxListener) -> int:
    """The port of Art-Net."""
    assert listener._artnet is not None
    port: int = listener._artnet.socket.getsockname()[1]
    return port


async def tick_until(harness: ShowHarness, weight: float) -> None:
    """Ticks until a channel has a weight."""
    while harness.show.session.scene["one"].snapshot().channels.get("jawOpen") != pytest.approx(weight):
        harness.tick()
        await asyncio.sleep(0.001)


async def test_a_desk_plays_by_sacn_to_its_group(show_harness: ShowHarness, listener: DmxListener) -> None:
    desk = sacn.sACNsender(HOST, 0, source_name="Desk", universeDiscovery=False)
    desk.start()
    try:
        desk.activate_output(UNIVERSE)
        desk[UNIVERSE].multicast = True
        desk[UNIVERSE].ttl = 0
        for level in (255, 51):
            desk[UNIVERSE].dmx_data = (0, level)
            await tick_until(show_harness, level / 255)
    finally:
        desk.stop()
    assert listener.dmx.rejected == 0


async def test_a_desk_plays_by_artnet_and_finds_the_show(
    show_harness: ShowHarness, listener: DmxListener, artnet: int
) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as desk:
        desk.bind((HOST, 0))
        desk.setblocking(False)
        desk.sendto(b"Art-Net\0\x00\x50\x00\x0e\x01\x00\x00\x00\x00\x02\xff\xff", (HOST, artnet))
        desk.sendto(b"Art-Net\0\x00\x20\x00\x0e\x02\x00", (HOST, artnet))
        while listener.dmx.heard < 2:
            show_harness.tick()
            await asyncio.sleep(0.001)
        reply = await asyncio.get_running_loop().sock_recv(desk, 1000)
    assert (reply[:10], reply[10:14]) == (b"Art-Net\0\x00\x21", b"\x7f\0\0\x01")
    state = show_harness.show.session.tick(show_harness.clock())
    assert state.characters["one"].faces == {"broad": 1.0}
    assert state.characters["one"].gaze[0] == pytest.approx(0.698, abs=1e-3)


async def test_damage_is_told_and_a_lost_desk_too(
    show_harness: ShowHarness, listener: DmxListener, artnet: int, said: list[str]
) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as desk:
        desk.sendto(b"hello", (HOST, artnet))
        desk.sendto(b"Art-Net\0\x00\x50\x00\x0e\x01\x00\x00\x00\x00\x02\x01\x00", (HOST, artnet))
    while listener.dmx.heard < 2:
        show_harness.tick()
        await asyncio.sleep(0.001)
    show_harness.clock.now += 3.0
    for _ in range(LOST_TICKS):
        show_harness.tick()
    assert said == [
        "Art-Net from 127.0.0.1: a packet of 5 bytes is too short for Art-Net.",
        "Art-Net universe 0 has lost its source; its last levels hold.",
    ]
