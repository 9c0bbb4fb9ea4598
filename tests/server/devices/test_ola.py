"""sACN and Art-Net from a lighting desk that is not ours: the daemon of OLA (Open Lighting Architecture), where it is
installed: `apt-get install --no-install-recommends ola`."""

import asyncio
import os
import shutil
import socket
import tempfile
from collections.abc import AsyncIterator
from contextlib import ExitStack
from pathlib import Path
from typing import NamedTuple

import pytest
import pytest_asyncio
from aiohttp import ClientConnectionError, ClientSession

from omote.inputs.allowed_senders import THIS_MACHINE
from omote.inputs.bindings.binding_file import read_bindings
from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.bindings import Bindings
from omote.inputs.dmx.dmx_input import SACN, DmxInput
from omote.server.access.show_addresses import own_address
from omote.server.devices.dmx_listener import DmxListener
from omote.server.devices.rejection_log import RejectionLog
from omote.server.supervision.device_sockets import listen_for_artnet, listen_for_sacn
from tests.server.conftest import ShowHarness

pytestmark = [
    pytest.mark.asyncio,
    pytest.mark.skipif(shutil.which("olad") is None, reason="OLA is not installed"),
]
HOST = "127.0.0.1"
UNIVERSE = 16 * (100 + os.getpid() % 3_800)
"""Each process of the tests has its own. OLA's Art-Net takes the number modulo 16, so that this one is 0."""
BOUND = f"""
[[binding]]
device = "sACN"
control = "{UNIVERSE}/2"
to = "/omote/one/channel/jawOpen"

[[binding]]
device = "sACN"
control = "{UNIVERSE}/512"
to = "/omote/one/face"
arguments = ["broad", 0.0]

[[binding]]
device = "Art-Net"
control = "0/1"
to = "/omote/one/gaze"
axis = "yaw"
"""
SETTINGS = {
    "e131": "output_ports = 1\ninput_ports = 0\nrevision = 0.46\n",
    "artnet": "use_loopback = true\nalways_broadcast = true\n",
}
OTHERS = (
    "dummy espnet ftdidmx gpio karate kinet milinst opendmx openpixelcontrol osc pathport renard sandnet shownet spi "
    "stageprofi uartdmx usbdmx usbserial"
).split()
"""Plugins of OLA that stay off: they open ports and devices of their own."""
NOBODY = 65534
"""OLA refuses to run as root."""


class Ola(NamedTuple):
    """A daemon of OLA. ports: what its Art-Net and its sACN call the ports that send."""

    http: ClientSession
    ports: dict[str, str]

    async def patch(self, universe: int, protocol: str) -> None:
        """Lets a universe be sent by a protocol."""
        await self._post("new_universe", {"id": universe, "name": "Desk", "add_ports": self.ports[protocol]})

    async def set_priority(self, universe: int, priority: int) -> None:
        """Sets the priority with which sACN is sent."""
        port = self.ports["E1.31"]
        changed: dict[str, str | int] = {"id": universe, "name": "Desk", "modify_ports": port}
        changed |= {f"{port}_priority_mode": "static", f"{port}_priority_value": priority}
        await self._post("modify_universe", changed)

    async def set_levels(self, universe: int, levels: list[int]) -> None:
        """Sets the levels of a universe, the first slots first."""
        await self._post("set_dmx", {"u": universe, "d": ",".join(map(str, levels))})

    async def _post(self, path: str, values: dict[str, str | int]) -> None:
        async with self.http.post(f"/{path}", data={name: str(value) for name, value in values.items()}) as answer:
            text = await answer.text()
            assert answer.status == 200, text
            assert text == "ok" or (await answer.json(content_type=None))["ok"], text


def free_ports(count: int) -> list[int]:
    """Ports that nobody has."""
    with ExitStack() as opened:
        sockets = [opened.enter_context(socket.socket()) for _ in range(count)]
        for each in sockets:
            each.bind((HOST, 0))
        return [each.getsockname()[1] for each in sockets]


async def read_ports(http: ClientSession, process: asyncio.subprocess.Process) -> dict[str, str]:
    """The ports that send, by the first word of their device; waits until the daemon answers."""
    while process.returncode is None:
        try:
            async with http.get("/json/get_ports") as answer:
                ports = await answer.json(content_type=None)
        except ClientConnectionError:
            await asyncio.sleep(0.02)
            continue
        return {port["device"].split()[0]: port["id"] for port in ports if port["is_output"]}
    raise AssertionError(f"olad has ended with {process.returncode}")


@pytest_asyncio.fixture
async def ola() -> AsyncIterator[Ola]:
    http, rpc = free_ports(2)
    root = os.geteuid() == 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for plugin, text in {**SETTINGS, **dict.fromkeys(OTHERS, "enabled = false\n")}.items():
            (folder / f"ola-{plugin}.conf").write_text(text)
        for path in [folder, *folder.iterdir()] if root else []:
            os.chown(path, NOBODY, NOBODY)
        words = ["-c", name, "-p", str(http), "-r", str(rpc), "--no-register-with-dns-sd", "-l", "1"]
        who = {"user": NOBODY, "group": NOBODY, "extra_groups": []} if root else {}
        process = await asyncio.create_subprocess_exec("olad", *words, **who)  # type: ignore[arg-type]
        try:
            async with ClientSession(f"http://{HOST}:{http}") as session:
                yield Ola(session, await read_ports(session, process))
        finally:
            process.terminate()
            await process.wait()


@pytest_asyncio.fixture
async def listener(show_harness: ShowHarness, ola: Ola) -> AsyncIterator[DmxListener]:
    """Hears what a show of this machine alone hears: OLA sends sACN by a network card, never on loopback. Opened after
    OLA: the loopback network has no broadcast, and of several sockets at one port the newest gets what comes."""
    bindings = BindingInput(Bindings(read_bindings(BOUND)), lambda: show_harness.show.session)
    dmx = DmxInput([UNIVERSE])
    dmx.watch(bindings.bindings.controls)
    sacn = listen_for_sacn(HOST, [UNIVERSE])
    artnet = listen_for_artnet(HOST)
    allowed = THIS_MACHINE.with_host(own_address())
    made = DmxListener(dmx, bindings, RejectionLog(lambda _: None), sacn=sacn, artnet=artnet, allowed=allowed)
    show_harness.show.sources.append(made)
    yield made
    await made.close()


async def test_ola_plays_by_sacn_and_its_priority_counts(
    show_harness: ShowHarness, listener: DmxListener, ola: Ola
) -> None:
    one = show_harness.show.session.scene["one"]
    await ola.patch(UNIVERSE, "E1.31")
    await ola.set_levels(UNIVERSE, [0, 51, *[0] * 509, 255])
    while one.snapshot().channels.get("jawOpen") != pytest.approx(51 / 255):
        show_harness.tick()
        await asyncio.sleep(0.001)
    assert show_harness.show.session.tick(show_harness.clock()).characters["one"].faces == {"broad": 1.0}
    assert listener.dmx.counts[SACN].newest == f"universe {UNIVERSE}, 512 slots"
    universe = listener.dmx._universes[SACN, UNIVERSE]
    for priority, level in ((150, 51), (50, 204)):
        await ola.set_priority(UNIVERSE, priority)
        await ola.set_levels(UNIVERSE, [0, 51])
        while {each.priority for source, each in universe._sources.items() if source != b"other"} != {priority}:
            show_harness.tick()
            await asyncio.sleep(0.001)
        universe.receive(b"other", bytes([0, 204]), show_harness.clock())  # a second desk, at the usual priority
        show_harness.tick()
        assert one.snapshot().channels["jawOpen"] == pytest.approx(level / 255)
    assert listener.dmx.counts[SACN].rejected == 0


async def test_ola_plays_by_artnet(show_harness: ShowHarness, listener: DmxListener, ola: Ola) -> None:
    await ola.patch(UNIVERSE, "ArtNet")
    await ola.set_levels(UNIVERSE, [255])
    one = show_harness.show.session.scene["one"]
    while one.snapshot().gaze.yaw != pytest.approx(0.698, abs=1e-3):
        show_harness.tick()
        await asyncio.sleep(0.001)
