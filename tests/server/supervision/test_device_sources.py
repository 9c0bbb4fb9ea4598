"""Devices of a server, on the sockets of its supervisor."""

import asyncio
import socket
from pathlib import Path
from typing import Any

import pytest

from omote.inputs.osc_packet import encode_message
from omote.model.cast import Cast
from omote.server.access.show_addresses import own_address
from omote.server.devices.dmx_listener import DmxListener
from omote.server.devices.face_output import FaceOutput
from omote.server.devices.guarded_source import GuardedSource
from omote.server.devices.mediapipe_link import MediapipeLink
from omote.server.devices.osc_listener import OscListener
from omote.server.devices.page_device_source import PageDeviceSource
from omote.server.devices.trackers.tracker_listener import TrackerListener
from omote.server.devices.trackers.tracker_sockets import listen_for_trackers, read_trackers
from omote.server.persistence import restore
from omote.server.supervision.device_sockets import DeviceOptions, listen_for_artnet
from omote.server.supervision.device_sources import load_bindings, start_devices
from omote.server.supervision.early_tick import EarlyTicks
from omote.server.supervision.listening_socket import listen_for_osc
from omote.server.supervision.source_report import SourceReport
from omote.show.objects.bindings import Bind, BindingDocument, BindingList, BindingsChanged
from omote.show.objects.devices import MidiBytes, Plug
from omote.show.objects.faders import SetChannel
from omote.show.objects.hand.setups import KeepSetup, SetupList
from omote.show.objects.link import Ping, Pong
from omote.show.objects.state import State
from omote.show.wire import encode
from tests.server.conftest import ShowHarness, answer, open_edit_harness, send_and_wait

HOST = "127.0.0.1"
LONG = 30.0
"""Seconds for which nobody waits: something has been sent."""
BOUND = '[[binding]]\ndevice = "Art-Net"\ncontrol = "3/1"\nto = "/omote/panic"\n'


@pytest.mark.asyncio
async def test_what_was_asked_for_is_heard(show_harness: ShowHarness, tmp_path: Path) -> None:
    (tmp_path / "desk.toml").write_text(BOUND)
    with listen_for_artnet(HOST, 0) as artnet:
        osc = listen_for_osc(HOST, 0)
        options = DeviceOptions(
            osc.datagrams.fileno(), artnet=artnet.fileno(), allow="10.0.0.7", bindings=str(tmp_path / "desk.toml")
        )
        started = await start_devices(show_harness.show, options, lambda _: None)
        guarded = show_harness.show.sources
        assert all(isinstance(source, GuardedSource) for source in guarded)
        *heard_first, report = [source.source for source in guarded if isinstance(source, GuardedSource)]
        assert isinstance(report, SourceReport)
        assert [id(each) for each in heard_first] == [id(each) for each in started]
        heard, dmx, *_, pages = started
        assert isinstance(heard, OscListener)
        assert isinstance(dmx, DmxListener)
        assert isinstance(pages, PageDeviceSource)
        assert [each.name for each in pages.devices.devices_now(0.0).devices] == ["OSC", "Art-Net", "Camera"]
        assert heard._reader.hears("10.0.0.7")
        assert heard._reader.hears(own_address() or HOST)
        assert not heard._reader.hears("10.0.0.8")
        assert show_harness.show.oscquery is not None
        assert dmx.bindings.bindings.controls == [("Art-Net", "3/1")]
        for each in started:
            await each.close()
        osc.close()


@pytest.mark.asyncio
async def test_trackers_are_heard_and_faces_sent(show_harness: ShowHarness) -> None:
    opened = listen_for_trackers(read_trackers("vmc:0,meowface:0@127.0.0.1"), list[str]().append)
    osc = listen_for_osc(HOST, 0)
    descriptors = {name: each.fileno() for name, each in opened.items()}
    options = DeviceOptions(
        osc.datagrams.fileno(), trackers=descriptors, listen="vmc:0,meowface:0@127.0.0.1,mediapipe",
        send="vmc:127.0.0.1:9,osc:127.0.0.1:9",
    )  # fmt: skip
    started = await start_devices(show_harness.show, options, lambda _: None)
    surfaces, trackers, browsers, _, faces, *_, pages = started
    assert isinstance(browsers, MediapipeLink)
    assert show_harness.show._heard["/mediapipe"] == browsers.respond
    assert isinstance(surfaces, OscListener)
    assert isinstance(trackers, TrackerListener)
    assert isinstance(faces, FaceOutput)
    assert isinstance(pages, PageDeviceSource)
    heard = [each.name for each in pages.devices.devices_now(0.0).devices]
    assert heard == ["OSC", "VMC", "MeowFace", "MediaPipe", "Camera"]
    assert surfaces.osc.news(show_harness.show.session.tick(0.0), 1e6)  # a surface that was named is told for ever
    for closing in started:
        await closing.close()
    osc.close()
    for each in opened.values():
        each.close()


@pytest.mark.asyncio
async def test_what_comes_by_osc_is_seen_between_ticks(show_harness: ShowHarness) -> None:
    osc = listen_for_osc(HOST, 0)
    early = EarlyTicks()
    assert osc.connections is not None
    options = DeviceOptions(osc.datagrams.fileno(), osc.connections.fileno())
    started = await start_devices(show_harness.show, options, lambda _: None, early)
    with socket.socket(type=socket.SOCK_DGRAM) as out:
        out.sendto(encode_message("/omote/panic"), osc.datagrams.getsockname())
        assert await early.spoke_within(LONG)
    show_harness.tick()
    early.forget()
    assert not await early.spoke_within(0.0), "a tick has read it"
    _, writer = await asyncio.open_connection(*osc.connections.getsockname()[:2])
    writer.write(b"\xc0" + encode_message("/omote/panic") + b"\xc0")
    assert await early.spoke_within(LONG)
    writer.close()
    for each in started:
        await each.close()
    osc.close()


@pytest.mark.asyncio
async def test_a_device_at_a_page_is_noted_and_a_hand_at_a_console_waits_for_the_beat(
    show_harness: ShowHarness,
) -> None:
    noted: list[None] = []
    show_harness.show.device_spoke = lambda: noted.append(None)
    desk = await show_harness.link()
    await send_and_wait(desk, SetChannel("one", "jawOpen", 0.5))
    assert not noted
    await send_and_wait(desk, Plug("pad", "midi"))
    assert noted


@pytest.mark.asyncio
async def test_a_file_of_bindings_that_is_gone_does_not_stop_the_show(show_harness: ShowHarness) -> None:
    said: list[str] = []
    with listen_for_artnet(HOST, 0) as artnet:
        options = DeviceOptions(artnet=artnet.fileno(), bindings="gone.toml")
        for each in await start_devices(show_harness.show, options, said.append):
            await each.close()
    assert said == ["gone.toml cannot be read (it is not there); nothing is bound."]


@pytest.mark.asyncio
async def test_pages_alone_have_devices_where_nothing_else_was_asked_for(show_harness: ShowHarness) -> None:
    started = await start_devices(show_harness.show, DeviceOptions(), lambda _: None)
    pages = started[-1]
    assert isinstance(pages, PageDeviceSource)
    assert [each.name for each in pages.devices.devices_now(0.0).devices] == ["Camera"]  # a page of the show
    for each in started:
        await each.close()


@pytest.mark.asyncio
async def test_what_a_page_binds_lies_in_the_show_file_and_plays_after_a_restart(
    cast: Cast, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(restore, "FIRST_LIVELINESS", 0.0)  # over what moves by itself a fader is followed
    bound = BindingDocument("pad", "1/cc7", "/omote/one/channel/jawOpen", pick_up=False)
    for expected in (0.0, 1.0):
        async with open_edit_harness(cast, tmp_path / "a.omote") as harness:
            started = await start_devices(harness.show, DeviceOptions(), harness.said.append)
            desk = await harness.link()
            said = (
                Plug("pad", "midi"),
                MidiBytes("pad", bytes([0xB0, 7, 127])),
                Bind(f"b {expected}", bound),
                *(() if expected else (KeepSetup("k", "right"),)),
            )
            for each in (*said, Ping(1.0)):
                await desk.send_bytes(encode(each))
            while not isinstance(await answer(desk), Pong):
                pass  # the server has heard all
            harness.tick()
            heard: dict[type, Any] = {}
            while not {BindingList, SetupList} <= heard.keys():
                message = await answer(desk)
                heard[type(message)] = message
            assert heard[State].characters["one"].channels.get("jawOpen", 0.0) == expected
            assert heard[BindingList].bindings == heard[BindingsChanged].added
            assert heard[SetupList].names == ["right"]
            assert harness.said == []
            for closing in started:
                await closing.close()


def test_a_picture_is_no_file_of_bindings(tmp_path: Path) -> None:
    path = tmp_path / "pic.jpg"
    path.write_bytes(b"\xff\xd8\xff\xe0")
    with pytest.raises(ValueError, match=r"pic.jpg: its text is not UTF-8$"):
        load_bindings(path)


def test_what_is_wrong_with_a_file_names_it(tmp_path: Path) -> None:
    (tmp_path / "desk.toml").write_text("[[binding")
    with pytest.raises(ValueError, match=r"desk\.toml: it is no TOML"):
        load_bindings(tmp_path / "desk.toml")
