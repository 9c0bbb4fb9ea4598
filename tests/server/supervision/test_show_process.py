"""A server plays until its supervisor's pipe ends, and leaves the show in the file."""

import asyncio
import os
import socket
from collections.abc import Coroutine
from pathlib import Path

import aiohttp
import pytest

from omote.server.access.show_addresses import outside_address
from omote.server.http.app import ShowServer
from omote.server.http.static_pages import FOLDER
from omote.server.persistence import restore
from omote.server.process.notice_board import NoticeBoard
from omote.server.process.process_messages import TICK, Order
from omote.server.supervision.show_process import (
    Pipes,
    load_material,
    play,
    report,
    run_until_ended,
    serving,
)
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Hello
from omote.show.objects.state import State
from omote.show.session import ShowSession
from omote.show.wire import encode
from omote.showfile.backup import backup_paths
from omote.showfile.show_file import open_show
from tests.server.conftest import answer
from tests.server.synthetic_server import material


async def visit(port: int, pulse: int) -> State:
    """Plays a little on a server and gives what was on air last."""
    url = f"http://127.0.0.1:{port}{LINK_PATH}"
    async with aiohttp.ClientSession() as http, http.ws_connect(url) as link:
        await link.send_bytes(encode(Hello("console", PROTOCOL_VERSION)))
        await link.send_bytes(encode(SetChannel("one", "jawOpen", 0.5)))
        while True:
            seen = await answer(link)
            if isinstance(seen, State) and seen.characters["one"].channels:
                break
    assert os.read(pulse, 1) == TICK
    return seen


def test_a_server_plays_and_leaves_its_last_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(restore, "FIRST_LIVELINESS", 0.0)
    listening = socket.create_server(("127.0.0.1", 0))
    port = listening.getsockname()[1]
    control, ours = os.pipe()
    far, pulse = os.pipe()
    pipes = Pipes(listening.detach(), control, pulse)

    async def show() -> State:
        playing = asyncio.create_task(
            play(material(), Order(epoch=3, neutral=False), show=tmp_path / "a.omote", pipes=pipes, board=NoticeBoard())
        )
        seen = await visit(port, far)
        os.close(ours)
        await playing
        return seen

    seen = asyncio.run(show())
    assert seen.characters["one"].channels == {"jawOpen": 0.5}
    left = open_show(tmp_path / "a.omote")
    assert left.journal().epoch == seen.epoch
    assert b"jawOpen" in (left.journal().snapshot or b"")
    backup = open_show(backup_paths(tmp_path / "a.omote")[0])
    assert backup.journal() == left.journal()
    backup.close()
    left.close()
    for descriptor in (control, far, pulse):
        os.close(descriptor)


def test_a_tick_that_fails_ends_the_server_with_its_error() -> None:
    control, ours = os.pipe()

    async def failing() -> None:
        raise ArithmeticError("a tick failed")

    with pytest.raises(ArithmeticError, match="a tick failed"):
        asyncio.run(ended(failing(), control))
    os.close(control)
    os.close(ours)


async def ended(beating: Coroutine[object, object, None], control: int) -> None:
    """Plays with nothing around it."""
    await run_until_ended(beating, control)


@pytest.mark.parametrize("host", ["127.0.0.1", "0.0.0.0"])
def test_the_address_for_other_machines_is_known(host: str) -> None:
    async def served(show: ShowServer, listening: socket.socket) -> str:
        async with serving(show, os.dup(listening.fileno())):
            return show.outside

    documents = material().documents
    show = ShowServer(ShowSession(documents.cast), documents, {})
    with socket.create_server((host, 0)) as listening:
        assert asyncio.run(served(show, listening)) == outside_address(host, listening.getsockname()[1])
    documents.close()


def test_what_is_served_is_the_built_in_cast_and_the_built_pages() -> None:
    served = load_material()
    assert served.pages["/stage"].body == (FOLDER / "stage.html").read_bytes()
    assert "generic" in served.documents.cast.faces
    served.documents.close()


def test_sentences_go_to_the_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    report("the disk is full.")
    assert capsys.readouterr().err == "omote: the disk is full.\n"
