"""VTube Studio at a show, against a server of ours made from its documentation: read, set, denied, gone and back."""

import asyncio
import json
import socket
from collections.abc import AsyncIterator
from dataclasses import dataclass

import pytest
import pytest_asyncio
from aiohttp.test_utils import TestServer

from omote.inputs.face_output.face_target import FaceTarget
from omote.server.devices.face_output import FaceOutput
from omote.server.devices.rejection_log import RejectionLog
from omote.server.devices.vtube_studio import api_link
from omote.server.devices.vtube_studio.api_announcements import LOST_SECONDS, ApiAnnouncements
from omote.server.devices.vtube_studio.api_programs import ApiPrograms
from omote.server.persistence.device_file import DeviceFile
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Hello
from omote.show.session import ShowSession
from tests.server.conftest import ShowHarness
from tests.server.devices.vtube_studio.false_vtube_studio import TOKEN, FalseVtubeStudio, open_false_vtube_studio

pytestmark = pytest.mark.asyncio
HOST = "127.0.0.1"


@dataclass
class Room:
    """A show, the programs at it, a VTube Studio of ours, and what the terminal was told."""

    harness: ShowHarness
    programs: ApiPrograms
    studio: FalseVtubeStudio
    server: TestServer
    notes: DeviceFile
    said: list[str]

    @property
    def port(self) -> int:
        assert self.server.port is not None
        return self.server.port

    @property
    def target(self) -> FaceTarget:
        return FaceTarget("vtubestudio-pc", HOST, self.port)

    async def tick(self) -> None:
        """A tick, and time for what travels."""
        self.harness.tick()
        await asyncio.sleep(0.001)


@pytest_asyncio.fixture
async def room(show_harness: ShowHarness, monkeypatch: pytest.MonkeyPatch) -> AsyncIterator[Room]:
    monkeypatch.setattr(api_link, "RETRY_SECONDS", 0.01)
    said: list[str] = []
    notes = DeviceFile(None)

    def session() -> ShowSession:
        return show_harness.show.session

    faces = FaceOutput((), session)
    programs = ApiPrograms(session, RejectionLog(said.append), notes, faces.weigh, ApiAnnouncements(0))
    show_harness.show.sources.append(programs)
    async with open_false_vtube_studio() as (studio, server):
        yield Room(show_harness, programs, studio, server, notes, said)
        await programs.close()


async def test_its_parameters_drive_a_character(room: Room) -> None:
    room.studio.parameters |= {"MouthOpen": 0.6, "FaceAngleX": -15.0}
    room.programs.read(HOST, room.port)
    while not room.programs.trackers.values():
        await room.tick()
    assert room.notes.token(f"VTube Studio {HOST}:{room.port}") == TOKEN
    assert room.programs.trackers.values()["jawOpen"] == pytest.approx(0.6)
    await room.tick()
    (probe,) = room.programs.probes
    assert probe().name == "VTube Studio PC"
    layer = room.harness.show.session.tick(room.harness.clock()).characters["one"].layers["tracker"]
    assert layer.source == f"VTube Studio PC {HOST}"
    room.programs.stop_reading()
    assert room.programs.probes == []


async def test_a_face_is_set_at_its_own_and_at_added_parameters(room: Room) -> None:
    session = room.harness.show.session
    session.receive("console", Hello("console", PROTOCOL_VERSION), 0.0)
    session.receive("console", SetChannel("one", "jawOpen", 0.75), 0.0)
    room.programs.add(room.target)
    while not room.studio.injected:
        await room.tick()
    values = {each["id"]: each["value"] for each in room.studio.injected[-1]["parameterValues"]}
    assert values["MouthOpen"] == values["OmoteJawOpen"] == 0.75
    assert "TongueOut" not in values, "it has none"
    (receiver,) = room.programs.receivers
    assert receiver.sent > 0
    assert receiver.fault == ""
    room.programs.remove(room.target.word)
    assert room.programs.receivers == []


async def test_a_user_who_denies_is_said_and_not_asked_again(room: Room) -> None:
    room.studio.allows = False
    room.programs.add(room.target)
    (receiver,) = room.programs.receivers
    while "denied" not in receiver.fault:
        await room.tick()
    for _ in range(10):
        await room.tick()
    assert room.studio.heard == ["AuthenticationTokenRequest"]
    assert any("User has denied API access" in each for each in room.said)


async def test_one_that_goes_and_comes_is_read_again_by_the_same_token(room: Room) -> None:
    room.programs.read(HOST, room.port)
    while room.studio.heard.count("InputParameterListRequest") < 2:
        await room.tick()
    for link in room.studio.links:
        await link.close()
    asked = len(room.studio.heard)
    while "InputParameterListRequest" not in room.studio.heard[asked:]:
        await room.tick()
    assert room.studio.heard.count("AuthenticationTokenRequest") == 1


async def test_one_that_is_away_is_said(room: Room) -> None:
    with socket.socket() as taken:
        taken.bind((HOST, 0))
        port = taken.getsockname()[1]
    room.programs.read(HOST, port)
    (probe,) = room.programs.probes
    while "does not answer" not in probe().advice:
        await room.tick()
    assert "Allow Plugin API access" in probe().advice


async def test_one_that_announces_itself_is_found_and_read(room: Room) -> None:
    def announce(*, active: bool) -> None:
        state = {"active": active, "port": room.port, "instanceID": "93aa0d04", "windowTitle": "VTube Studio"}
        document = {
            "apiName": "VTubeStudioPublicAPI", "apiVersion": "1.0", "timestamp": 1630159656406,
            "messageType": "VTubeStudioAPIStateBroadcast", "requestID": "VTubeStudioAPIStateBroadcast", "data": state,
        }  # fmt: skip
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as program:
            program.sendto(json.dumps(document).encode(), (HOST, room.programs.announcements.port))

    announce(active=True)
    while not room.programs.announced:
        await room.tick()
    assert room.programs.announced == {(HOST, room.port): "VTube Studio"}
    room.programs.read("", 8001)
    while not room.programs.trackers.values():
        await room.tick()
    room.harness.clock.now += LOST_SECONDS
    room.harness.tick()
    assert room.programs.announced == {}
    announce(active=False)
    await room.tick()
    assert room.programs.announced == {}
