"""Trackers and receivers of faces, switched as pages ask: heard at once, kept, and what cannot be is said."""

import asyncio
import socket
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
import pytest_asyncio

from omote.inputs.face_output.face_target import read_targets
from omote.server.devices.face_output import FaceOutput
from omote.server.devices.mediapipe_link import MediapipeLink
from omote.server.devices.rejection_log import RejectionLog
from omote.server.devices.switches.device_switches import DeviceSwitches, Switched
from omote.server.devices.trackers.tracker_listener import TrackerListener
from omote.server.devices.trackers.tracker_sockets import read_trackers
from omote.server.devices.vtube_studio.api_announcements import ApiAnnouncements
from omote.server.devices.vtube_studio.api_programs import ApiPrograms
from omote.server.persistence.device_file import DeviceFile, DeviceNotes, read_notes, write_notes
from omote.show.objects.devices import SwitchDevice, TrackerOffer
from omote.show.session import ShowSession
from tests.inputs.trackers.packets import live_link_face
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio
HOST = "127.0.0.1"
FACE = live_link_face([0.5 if index == 17 else 0.0 for index in range(61)])


def free_port(kind: socket.SocketKind = socket.SOCK_DGRAM) -> int:
    """A port that nobody has, for a moment."""
    with socket.socket(socket.AF_INET, kind) as taken:
        taken.bind(("", 0))
        return int(taken.getsockname()[1])


@dataclass
class Room:
    """A show with what can be switched, and the words on its terminal."""

    harness: ShowHarness
    switched: Switched
    notes: Path
    said: list[str]
    outside: str = ""

    def open(self, listen: str = "", send: str = "") -> DeviceSwitches:
        file = DeviceFile(self.notes, self.said.append)
        file.load()
        made = DeviceSwitches(
            self.switched, read_trackers(listen), read_targets(send), file, self.said.append, lambda: self.outside
        )
        made.restore()
        return made

    async def tick_until(self, reached: Callable[[], bool]) -> None:
        while not reached():
            self.harness.tick()
            await asyncio.sleep(0.001)


@pytest_asyncio.fixture
async def room(show_harness: ShowHarness, tmp_path: Path) -> AsyncIterator[Room]:
    said: list[str] = []

    def session() -> ShowSession:
        return show_harness.show.session

    log = RejectionLog(said.append)
    faces = FaceOutput((), session, said.append)
    programs = ApiPrograms(session, log, DeviceFile(None), faces.weigh, ApiAnnouncements(0))
    switched = Switched(TrackerListener([], session, log), MediapipeLink(session, log), programs, faces)
    sources = (switched.trackers, switched.mediapipe, switched.programs, switched.faces)
    show_harness.show.sources += sources
    yield Room(show_harness, switched, tmp_path / "a.devices", said)
    for each in sources:
        await each.close()


def listen(word: str, *, on: bool = True) -> SwitchDevice:
    return SwitchDevice("listen", word, on)


def send(word: str, *, on: bool = True) -> SwitchDevice:
    return SwitchDevice("send", word, on)


def offer(switches: DeviceSwitches, name: str) -> TrackerOffer:
    (found,) = [each for each in switches.describe(0.0).trackers if each.name == name]
    return found


async def test_a_tracker_is_heard_while_it_is_on(room: Room) -> None:
    switches = room.open()
    port = free_port()
    assert offer(switches, "livelink").word == ""
    switches.switch(listen(f"livelink:{port}"), 0.0)
    found = offer(switches, "livelink")
    assert (found.word, found.port, found.fixed) == (f"livelink:{port}", port, False)
    assert f"port {port}" in found.advice
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:
        phone.sendto(FACE, (HOST, port))
    await room.tick_until(lambda: any(each.heard for each in room.switched.trackers.inputs))
    session = room.harness.show.session
    assert [each.name for each in session.sources.states({})] == ["Live Link Face Phone 127.0.0.1"]
    switches.switch(listen(f"livelink:{port}", on=False), 0.0)
    assert offer(switches, "livelink").word == ""
    assert room.switched.trackers.inputs == []
    assert not [who for who in session.crew if who.startswith("livelink")]
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("", port))  # the port is free again


async def test_a_phone_is_sent_to_a_page_only_where_one_reaches_it(room: Room, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.server.devices.switches.device_switches.own_address", lambda: "192.168.1.20")
    switches = room.open()
    found = switches.describe(0.0)
    assert (found.phone_page, found.host) == ("", "192.168.1.20"), "its apps reach the show, its browser does not"
    room.outside = "http://192.168.1.20:8095"
    assert switches.describe(0.0).phone_page == "/connect"


async def test_a_port_that_the_system_chose_is_told(room: Room) -> None:
    switches = room.open()
    switches.switch(listen("livelink:0"), 0.0)
    (heard,) = room.switched.trackers._heard
    port = heard.tracker.datagrams.getsockname()[1]
    assert port > 0
    assert offer(switches, "livelink").port == port
    assert str(port) in offer(switches, "livelink").advice


async def test_what_was_switched_on_is_on_again_after_a_restart(room: Room) -> None:
    port = free_port()
    switches = room.open()
    switches.switch(listen(f"vmc:{port}"), 0.0)
    switches.switch(send("livelink:10.0.0.9"), 0.0)
    switches.switch(send("livelink:10.0.0.8"), 0.0)
    switches.switch(send("livelink:10.0.0.8", on=False), 0.0)
    switches._notes.close()
    assert read_notes(room.notes) == DeviceNotes((f"vmc:{port}",), ("livelink:10.0.0.9:11111",))
    room.switched.trackers.remove("vmc")
    room.switched.faces.remove("livelink:10.0.0.9:11111")
    again = room.open()
    assert offer(again, "vmc").word == f"vmc:{port}"
    assert [each.word for each in again.describe(0.0).receivers] == ["livelink:10.0.0.9:11111"]
    assert room.said == []


async def test_what_cannot_be_on_again_is_said(room: Room) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("", 0))
        port = other.getsockname()[1]
        write_notes(room.notes, DeviceNotes((f"vmc:{port}", "gone"), ("livelink:10.0.0.9",)))
        switches = room.open(send="livelink:10.0.0.9")
    assert offer(switches, "vmc").word == ""
    assert [each.partition(":")[0] for each in room.said] == ["vmc", "gone stays off", "livelink"]
    assert "another program has it" in room.said[0]


async def test_what_the_command_line_asks_for_no_page_takes_away(room: Room) -> None:
    switches = room.open("mediapipe", "vmc:10.0.0.5")
    assert room.switched.mediapipe.on
    assert offer(switches, "mediapipe").fixed
    (receiver,) = switches.describe(0.0).receivers
    assert (receiver.word, receiver.fixed) == ("vmc:10.0.0.5:39539", True)
    for message in (
        listen("mediapipe", on=False), listen("mediapipe"), send("vmc:10.0.0.5"), send("vmc:10.0.0.5", on=False),
    ):  # fmt: skip
        with pytest.raises(ValueError, match="asked for on the command line"):
            switches.switch(message, 0.0)
    assert room.switched.mediapipe.on


async def test_a_tracker_of_the_command_line_whose_port_is_taken_is_off_with_the_reason_and_can_be_switched_on(
    room: Room,
) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("", 0))
        port = other.getsockname()[1]
        switches = room.open(f"livelink:{port},vmc:{free_port()}")
    found = offer(switches, "livelink")
    assert (found.word, found.fixed) == ("", False)
    assert f"port {port} cannot be opened for Live Link Face (another program has it)" in found.fault
    assert offer(switches, "vmc").fault == ""
    assert found.again == f"livelink:{port}"
    switches.switch(listen(found.again), 0.0)
    found = offer(switches, "livelink")
    assert (found.word, found.fault) == (f"livelink:{port}", "")
    switches._notes.close()
    assert read_notes(room.notes).listen == (f"livelink:{port}",)
    room.switched.trackers.remove("livelink")
    assert offer(room.open(f"livelink:{port}"), "livelink").fixed
    assert room.said == [], "what the command line asks for again is no fault of the notes"


async def test_who_sends_and_may_not_is_told_with_the_word_that_lets_it_play(room: Room) -> None:
    switches = room.open()
    port = free_port()
    switches.switch(listen(f"livelink:{port}"), 0.0)
    assert offer(switches, "livelink").stranger == ""
    assert not room.switched.trackers._heard[0].reader.hears("10.9.8.7")
    found = offer(switches, "livelink")
    assert (found.stranger, found.strange) == ("10.9.8.7", f"livelink:{port}@10.9.8.7")
    switches.switch(listen(found.strange), 0.0)
    assert room.switched.trackers._heard[0].reader.hears("10.9.8.7")
    assert offer(switches, "livelink").stranger == ""


async def test_mediapipe_and_a_phone_are_switched_as_others_are(room: Room) -> None:
    switches = room.open()
    port = free_port()
    switches.switch(listen("mediapipe"), 0.0)
    assert [probe().name for probe in room.switched.mediapipe.probes] == ["MediaPipe"]
    switches.switch(listen("mediapipe", on=False), 0.0)
    assert room.switched.mediapipe.probes == []
    switches.switch(listen(f"ifacialmocap:{port}@10.0.0.30"), 0.0)
    assert offer(switches, "ifacialmocap").word == f"ifacialmocap:{port}@10.0.0.30"
    switches.switch(listen(f"ifacialmocap:{port}"), 0.0)  # the same without the phone
    assert len(room.switched.trackers.inputs) == 1
    stream = free_port(socket.SOCK_STREAM)
    switches.switch(listen(f"ifacialmocap-tcp:{stream}"), 0.0)
    with socket.create_connection((HOST, stream)) as phone:
        phone.sendall(b"jawOpen&50|___iFacialMocap")
        await room.tick_until(lambda: sum(each.heard for each in room.switched.trackers.inputs) > 0)


async def test_receivers_tell_how_they_do(room: Room) -> None:
    switches = room.open()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as program:
        program.bind((HOST, 0))
        word = f"livelink:{HOST}:{program.getsockname()[1]}"
        switches.switch(send(word), 0.0)
        switches.switch(send(f"{word}=nobody"), 0.0)
        room.harness.tick()
        first, second = switches.describe(0.0).receivers
        assert (first.title, first.sent, first.fault) == ("Live Link Face (Unreal)", 1, "")
        assert first.character == room.harness.show.session.tick(0.0).characters["one"].label
        assert (second.sent, second.fault) == (0, "no character is called nobody, or several are")


async def test_vtube_studio_is_read_and_set_by_its_word(room: Room) -> None:
    switches = room.open()
    switches.switch(listen("vtubestudio-pc@10.0.0.4"), 0.0)
    assert room.switched.programs.reader is not None
    assert room.switched.programs.reader.place == ("10.0.0.4", 8001)
    with pytest.raises(ValueError, match="read already"):
        switches.switch(send("vtubestudio-pc:10.0.0.4"), 0.0)
    switches.switch(listen("vtubestudio-pc", on=False), 0.0)
    switches.switch(send("vtubestudio-pc:10.0.0.4"), 0.0)
    (receiver,) = switches.describe(0.0).receivers
    assert (receiver.title, receiver.where) == ("VTube Studio PC", "10.0.0.4:8001")
    switches.switch(send("vtubestudio-pc:10.0.0.4", on=False), 0.0)
    assert switches.describe(0.0).receivers == []


@pytest.mark.parametrize(
    ("message", "why"),
    [
        (listen("vcm"), "vmc"),
        (listen("ifacialmocap@phone.local"), "no address"),
        (send("vmc:unreal.local"), "no address"),
        (send("osc:10.0.0.5"), "asks by itself"),
        (send(""), "name one receiver"),
        (send("vmc:127.0.0.1:40001"), "its own face"),
    ],
)
async def test_what_cannot_be_is_said_and_changes_nothing(room: Room, message: SwitchDevice, why: str) -> None:
    switches = room.open()
    switches.switch(listen("vmc:40001"), 0.0)
    before = switches.describe(0.0)
    with pytest.raises(ValueError, match=why):
        switches.switch(message, 0.0)
    assert switches.describe(0.0) == before


async def test_receivers_are_few(room: Room) -> None:
    switches = room.open()
    for number in range(16):
        switches.switch(send(f"vmc:10.0.0.{number}"), 0.0)
    with pytest.raises(ValueError, match="16 receivers"):
        switches.switch(send("vmc:10.0.0.99"), 0.0)
