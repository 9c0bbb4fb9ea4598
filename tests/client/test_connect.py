"""Programs that play a running show: blocking from a thread of their own, and under asyncio."""

import asyncio
import datetime
from pathlib import Path
from typing import Any

import pytest
from aiohttp.test_utils import TestServer

import omote
from omote.server.access.access_control import AccessControl
from omote.server.access.certificates import load_context, make_certificate
from omote.server.access.people_file import open_people
from omote.server.access.security import own_names
from omote.show.access.people_list import token_of
from tests.client.test_program_link import ticking
from tests.server.conftest import ShowHarness


@pytest.mark.asyncio
async def test_a_blocking_program_plays_and_hears(show_harness: ShowHarness) -> None:
    def play(url: str) -> str:
        with omote.connect(url, name="robot") as show:
            show["one"].call_face("broad", seconds=0)
            show["one"].set_channel("jawOpen", 0.4)
            while show["one"].frame.channels != {"jawOpen": 0.4}:
                show.wait()
            with pytest.raises(ValueError, match="there is no face 'nobody'"):
                show["one"].call_face("nobody")
            assert show["one"].frame.faces == {"broad": 1.0}
        show.close()
        with pytest.raises(ConnectionError, match="the connection is closed; open another one"):
            show["one"].panic()
        return "played"

    async with ticking(show_harness):
        assert await asyncio.to_thread(play, str(show_harness.client.make_url("/"))) == "played"


@pytest.mark.asyncio
async def test_a_program_under_asyncio_plays_and_hears(show_harness: ShowHarness) -> None:
    url = str(show_harness.client.make_url("/console"))
    async with ticking(show_harness), await omote.connect_async(url) as show:
        await show["one"].call_face("broad", seconds=0)
        assert show["one"].frame.faces == {"broad": 1.0}
        await show["one"].fade_face(0.5)
        while show["one"].frame.face_fader != 0.5:
            await show.wait()


@pytest.mark.asyncio
async def test_a_program_builds_a_look_in_preview_and_takes_it(show_harness: ShowHarness) -> None:
    url = str(show_harness.client.make_url("/"))
    async with (
        ticking(show_harness),
        await omote.connect_async(url) as air,
        await omote.connect_async(url, name="unseen", bus="preview") as preview,
    ):
        await preview["one"].call_face("broad", seconds=0)
        assert (preview.state.bus, preview["one"].frame.faces) == ("preview", {"broad": 1.0})
        await air.wait()
        assert (air.state.bus, air["one"].frame.faces) == ("air", {"generic": 1.0})
        await preview.take(seconds=0)
        while air["one"].frame.faces != {"broad": 1.0}:
            await air.wait()


WRONG: dict[str, tuple[dict[str, Any], type[Exception], str]] = {
    "address": ({"url": "ftp://stage"}, ValueError, "no address of a show"),
    "no address": ({"url": 8090}, TypeError, "the address of a show is a int"),
    "long name": ({"name": "x" * 25}, ValueError, "give 1 to 24 letters"),
    "no name": ({"name": " "}, ValueError, "give 1 to 24 letters"),
    "number as name": ({"name": 3}, TypeError, "the name of a program is a int"),
    "no time": ({"timeout": 0.0}, ValueError, "the time to wait for a show"),
    "no bus": ({"bus": "blind"}, ValueError, "there is no bus 'blind'"),
    "text as time": ({"timeout": "long"}, TypeError, "the time to wait for a show"),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_cannot_be_is_refused_before_anything_opens(case: str) -> None:
    given, error, said = WRONG[case]
    arguments = {"url": "http://127.0.0.1:1", **given}
    with pytest.raises(error, match=said):
        omote.connect(**arguments)
    with pytest.raises(error, match=said):
        asyncio.run(omote.connect_async(**arguments))


@pytest.mark.asyncio
async def test_a_program_shows_its_token_and_ends_with_it(show_harness: ShowHarness, tmp_path: Path) -> None:
    control = AccessControl(tmp_path / "a.people", people := open_people(tmp_path / "a.people"))
    show_harness.show.enable_access(control)
    operate, view = (token_of(people, people.people[place]) for place in (1, 0))
    url = str(show_harness.client.make_url("/console"))
    async with ticking(show_harness):
        async with await omote.connect_async(f"{url}?token={operate}") as show:
            await show["one"].set_channel("jawOpen", 0.5)
        async with await omote.connect_async(url, token=view) as show:
            with pytest.raises(ValueError, match='needs the role "operate", and you are here with "view"'):
                await show["one"].panic()
        for token in ("", "x" * 30):
            with pytest.raises(ConnectionError, match="takes no program in: it asks for a token"):
                await omote.connect_async(url, token=token)


@pytest.mark.asyncio
async def test_https_that_does_not_come_about_is_explained(
    show_harness: ShowHarness, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "of another user"))
    now = datetime.datetime.now(datetime.UTC)
    files = make_certificate(["localhost"], now=now, folder=tmp_path / "https")
    secure = TestServer(show_harness.show.application(own_names()))
    await secure.start_server(ssl=load_context(files))
    place = f"//localhost:{secure.port}"
    plain = str(show_harness.client.make_url("/"))
    try:
        with pytest.raises(ConnectionError, match=f"not trusted .* https:{place}/certificate .* authority="):
            await omote.connect_async(f"https:{place}")
        with pytest.raises(ConnectionError, match="for other names and addresses"):
            await omote.connect_async(f"https://127.0.0.1:{secure.port}", authority=files.authority)
        with pytest.raises(ConnectionError, match=f"speaks no https; .* give {plain[:-1]}$"):
            await omote.connect_async(f"https{plain.removeprefix('http')}")
        with pytest.raises(ConnectionError, match="an address with https://"):
            await omote.connect_async(f"http:{place}", timeout=2.0)
    finally:
        await secure.close()


def test_a_certificate_that_cannot_be_read_is_said(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="no certificate to trust"):
        omote.connect("https://127.0.0.1:1", authority=tmp_path / "gone.pem")
