"""The web server over real sockets: pages, documents, links."""

import asyncio

import pytest

from omote.server.access.security import HEADERS
from omote.show.declaration import SPEECH_LIMIT
from omote.show.messages import LINK_PATH
from omote.show.objects.calls import CallFace
from omote.show.objects.faders import SetChannel, SetGaze
from omote.show.objects.link import Notice, Notices, Refused
from omote.show.objects.stages import Crew, Drawing, StageReport
from omote.show.objects.state import State
from omote.show.wire import encode
from tests.server.conftest import ShowHarness, answer, send_and_wait, state

pytestmark = pytest.mark.asyncio


async def test_all_consoles_get_the_same_states(show_harness: ShowHarness) -> None:
    links = [await show_harness.link("console"), await show_harness.link("console"), await show_harness.link("stage")]
    await send_and_wait(links[0], CallFace("one", "1", "broad", 1.0, "smooth"))
    await send_and_wait(links[1], SetChannel("one", "jawOpen", 0.5))
    for _ in range(30):
        show_harness.tick()
        states = [await state(link) for link in links]
        assert states[0] == states[1] == states[2]
    assert states[0].epoch == 7
    assert states[0].number == 30
    assert states[0].characters["one"].faces == pytest.approx({"generic": 0.5, "broad": 0.5}, abs=0.05)
    assert states[0].characters["one"].channels == {"jawOpen": 0.5}


async def test_each_link_gets_the_states_of_its_bus_alone(show_harness: ShowHarness) -> None:
    wall = await show_harness.link("stage")
    desk = await show_harness.link(bus="preview")
    await send_and_wait(desk, CallFace("one", "1", "broad", 0.0))
    late = await show_harness.link("stage", bus="preview")
    for _ in range(3):
        show_harness.tick()
        air = await state(wall)
        assert (air.bus, air.characters["one"].faces) == ("air", {"generic": 1.0})
        for link in (desk, late):
            unseen = await state(link)
            assert (unseen.bus, unseen.characters["one"].faces) == ("preview", {"broad": 1.0})


async def test_a_latecomer_needs_one_state(show_harness: ShowHarness) -> None:
    first = await show_harness.link()
    await send_and_wait(first, SetChannel("one", "smile", 1.5), SetGaze("one", 0.2, 0.1))
    for _ in range(10):
        show_harness.tick()
    late = await show_harness.link("stage")
    show_harness.tick()
    seen = await state(late)
    assert (seen.number, seen.characters["one"].channels, seen.characters["one"].gaze) == (
        11,
        {"smile": 1.5},
        (0.2, 0.1),
    )


async def test_a_link_survives_everything_it_says_wrong(show_harness: ShowHarness) -> None:
    link = await show_harness.link()
    for data in (b"", b"\xc1", b"\x91" * 1000, encode(SetChannel("one", "jawOpen", float("nan")))):
        await link.send_bytes(data)
        assert isinstance(await answer(link), Refused)
    await link.send_str("panic")
    refused = await answer(link)
    assert isinstance(refused, Refused)
    assert "MessagePack" in refused.reason
    await send_and_wait(link, SetChannel("one", "jawOpen", 1.0))
    show_harness.tick()
    assert (await state(link)).characters["one"].channels == {"jawOpen": 1.0}


async def test_a_message_too_long_closes_its_link_and_no_other(show_harness: ShowHarness) -> None:
    link = await show_harness.link()
    other = await show_harness.link()
    await link.send_bytes(bytes(SPEECH_LIMIT + 1))
    refused = await answer(link)
    assert isinstance(refused, Refused)
    assert f"longer than {SPEECH_LIMIT} bytes" in refused.reason
    closed = await link.receive()
    assert (closed.data, closed.extra) == (1009, refused.reason)  # message too big
    show_harness.tick()
    assert (await state(other)).number == 1


async def test_the_crew_is_broadcast(show_harness: ShowHarness) -> None:
    stage = await show_harness.link("stage")
    console = await show_harness.link("console")
    await send_and_wait(stage, Drawing(59.5, "low"))
    show_harness.show.broadcast_crew()
    assert await answer(stage) == await answer(console) == Crew(stages=[StageReport(59.5, "low")], consoles=1)


@pytest.mark.parametrize("code", [1000, 1001, 4000, None])
async def test_a_stage_whose_link_breaks_is_told_from_one_whose_page_is_closed(
    show_harness: ShowHarness, code: int | None
) -> None:
    stage = await show_harness.link("stage")
    console = await show_harness.link("console")
    if code is None:
        next(iter(show_harness.show.links)).transport.abort()  # as one that has been behind for too long
    else:
        await stage.close(code=code)
    await send_and_wait(console)
    show_harness.show.broadcast_crew()
    assert await answer(console) == Crew(stages=[], consoles=1, lost=0 if code in (1000, 1001) else 1)


async def test_who_goes_is_gone(show_harness: ShowHarness) -> None:
    stage = await show_harness.link("stage")
    console = await show_harness.link("console")
    await stage.close()
    await send_and_wait(console)  # after an answer to the one that stayed, the other is out of the list
    show_harness.show.broadcast_crew()
    assert await answer(console) == Crew(stages=[], consoles=1)
    assert len(show_harness.show.links) == 1


@pytest.mark.parametrize(
    ("host", "origin", "status"),
    [
        ("127.0.0.1", None, 101),
        ("localhost:8090", None, 101),
        ("localhost:8090", "http://localhost:8090", 101),
        ("192.168.1.5:8090", "http://192.168.1.5:8090", 101),
        ("localhost:8090", "http://localhost:9000", 403),
        ("localhost:8090", "http://evil.example", 403),
        ("localhost:8090", "http://localhost:8090.evil.example", 403),
        ("localhost:8090", "null", 403),
        ("localhost:8090", "file://", 403),
        ("evil.example", "http://evil.example", 403),
        ("evil.example:8090", None, 403),
        ("", None, 403),
        ("[::1", None, 403),
    ],
)
async def test_only_our_own_pages_may_link(
    show_harness: ShowHarness, host: str, origin: str | None, status: int
) -> None:
    headers = {"Host": host, "Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": "13"}
    headers |= {"Sec-WebSocket-Key": "AAAAAAAAAAAAAAAAAAAAAA=="} | ({"Origin": origin} if origin else {})
    async with show_harness.client.get(LINK_PATH, headers=headers) as response:
        assert response.status == status


@pytest.mark.parametrize("path", ["/", "/stage", "/console", "/manifest", "/nothing", LINK_PATH])
async def test_every_answer_carries_the_headers(show_harness: ShowHarness, path: str) -> None:
    response = await show_harness.client.get(path)
    for name, value in HEADERS.items():
        assert response.headers[name] == value


async def test_pages_are_found_by_name_only(show_harness: ShowHarness) -> None:
    assert await (await show_harness.client.get("/console")).text() == "page /console"
    for path in ("/consol", "/console/", "/..%2f..%2fetc%2fpasswd", "/%00", "/stage.html", "/CON", "/" + "x" * 300):
        assert (await show_harness.client.get(path)).status == 404


async def test_bad_requests_fill_no_terminal(show_harness: ShowHarness, caplog: pytest.LogCaptureFixture) -> None:
    for noise in (b"\x00" * 100, b"GET / HTTP/9.9\r\n\r\n", b"GET /" + b"a" * 20000 + b" HTTP/1.1\r\n\r\n"):
        reader, writer = await asyncio.open_connection(show_harness.client.host, show_harness.client.port)
        writer.write(noise)
        assert (await reader.readline()).startswith(b"HTTP/1.0 400")
        writer.close()
    assert caplog.records == []


async def test_a_notice_reaches_consoles_at_once_and_again_and_late_ones_with_their_welcome(
    show_harness: ShowHarness,
) -> None:
    first = await show_harness.link()
    stage = await show_harness.link("stage")
    notices = [Notice("1", 1.7e9, "The show's process ended.")]
    show_harness.show.post(notices)
    assert await answer(first) == Notices(notices)
    late = await show_harness.link()
    assert await answer(late) == Notices(notices)
    show_harness.show.broadcast_notices()
    assert [await answer(first), await answer(late)] == [Notices(notices)] * 2
    show_harness.tick()
    assert isinstance(await answer(stage), State)  # and nothing else
