"""Linux Show Player plays the list of a show by OSC: the real program, where it is installed with liblo's `oscsend`:
`apt-get install --no-install-recommends linux-show-player liblo-tools`."""

import asyncio
import json
import os
import shutil
import tempfile
import xmlrpc.client
from collections.abc import AsyncIterator
from pathlib import Path

import pytest
import pytest_asyncio

from omote.inputs.osc_input import OscInput
from omote.server.devices.osc_listener import OscListener
from omote.server.devices.rejection_log import RejectionLog
from omote.server.supervision.listening_socket import listen_for_osc
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.cues import PutCue
from omote.show.objects.link import Hello
from tests.server.conftest import ShowHarness
from tests.server.devices.test_ola import free_ports

PLAYER = "/usr/bin/linux-show-player"
"""Debian's, which its own Python runs."""
pytestmark = [
    pytest.mark.asyncio,
    pytest.mark.skipif(
        not Path(PLAYER).exists() or shutil.which("oscsend") is None,
        reason="Linux Show Player or liblo-tools is not installed",
    ),
]
HOST = "127.0.0.1"


@pytest_asyncio.fixture
async def port(show_harness: ShowHarness) -> AsyncIterator[int]:
    """Where a show with three cues hears OSC."""
    session = show_harness.show.session
    session.receive("ana", Hello("console", PROTOCOL_VERSION), 0.0)
    for number in ("1", "2", "7.5"):
        assert session.receive("ana", PutCue(f"p{number}", number=number), 0.0) == []
    sockets = listen_for_osc(HOST, 0)
    listener = OscListener(OscInput(lambda: session), sockets, RejectionLog(lambda _: None))
    await listener.start()
    show_harness.show.sources.append(listener)
    yield sockets.datagrams.getsockname()[1]
    await listener.close()
    sockets.close()


@pytest_asyncio.fixture
async def player(port: int) -> AsyncIterator[xmlrpc.client.ServerProxy]:
    """The program with a list of its own, whose cues send what docs/howto/other-programs.md says; it is played by its
    remote control."""
    (remote,) = free_ports(1)
    sent = ("/omote/go", "/omote/go s 7.5", "/omote/back", "/omote/pause i 1")
    cues = [
        {"_type_": "CommandCue", "id": words, "index": place, "command": f"oscsend {HOST} {port} {words}"}
        for place, words in enumerate(sent)
    ]
    with tempfile.TemporaryDirectory() as name:
        settings = Path(name, ".linux_show_player")
        settings.mkdir()
        defaults = Path("/usr/lib/python3/dist-packages/lisp/default.cfg").read_text()
        (settings / "config.cfg").write_text(defaults.replace("8070", str(remote)).replace("0.0.0.0", HOST))
        session = Path(name, "evening.lsp")
        session.write_text(json.dumps({"cues": cues, "plugins": {}, "application": {"layout": "List Layout"}}))
        own = {"HOME": name, "QT_QPA_PLATFORM": "offscreen", "PATH": os.environ["PATH"], "XDG_RUNTIME_DIR": name}
        process = await asyncio.create_subprocess_exec(PLAYER, "-f", str(session), env=own)
        try:
            proxy = xmlrpc.client.ServerProxy(f"http://{HOST}:{remote}")
            while not await asks(process, proxy):
                await asyncio.sleep(0.02)
            yield proxy
        finally:
            process.kill()
            await process.wait()


async def asks(process: asyncio.subprocess.Process, proxy: xmlrpc.client.ServerProxy) -> bool:
    """Whether the program answers, with its list."""
    assert process.returncode is None, f"Linux Show Player has ended with {process.returncode}"
    try:
        return bool(await asyncio.to_thread(proxy.get_cue_at, 3))
    except (OSError, xmlrpc.client.Fault):  # before it listens, and before its list is read
        return False


async def test_linux_show_player_plays_the_list(show_harness: ShowHarness, player: xmlrpc.client.ServerProxy) -> None:
    lists = show_harness.show.session.cues
    way = lists._players["main"]
    for place, number in ((0, "1"), (1, "7.5"), (2, "1")):
        await asyncio.to_thread(player.execute, place)
        while way.current is None or way.current.number != number:
            show_harness.tick()
            await asyncio.sleep(0.001)
        for _ in range(20):
            show_harness.tick()  # the gap of a GO
    await asyncio.to_thread(player.execute, 3)
    while not lists._paused:
        show_harness.tick()
        await asyncio.sleep(0.001)
