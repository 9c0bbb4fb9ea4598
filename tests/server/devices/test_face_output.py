"""The face on air over a real socket: each target its character, whoever hears it."""

import asyncio
import socket

import pytest

from omote.inputs.face_output.face_target import FaceTarget
from omote.inputs.trackers.live_link_face import decode_live_link_face
from omote.server.devices.face_output import FAULT_SECONDS, FaceOutput
from omote.show.objects.faders import SetChannel
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio
HOST = "127.0.0.1"


async def test_a_target_is_sent_its_character_with_each_tick(show_harness: ShowHarness) -> None:
    session = show_harness.show.session
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind((HOST, 0))
        receiver.setblocking(False)
        port = receiver.getsockname()[1]
        label = session.tick(0.0).characters["one"].label
        targets = [FaceTarget("livelink", HOST, port, label.upper()), FaceTarget("livelink", HOST, port, "gone")]
        said: list[str] = []
        output = FaceOutput(targets, lambda: session, said.append)
        show_harness.show.sources.append(output)
        session.join("hand", "hand")
        for weight in (0.25, 0.75):
            session.receive("hand", SetChannel("one", "jawOpen", weight), 0.0)
            show_harness.tick()
            (frame,) = decode_live_link_face(await asyncio.get_running_loop().sock_recv(receiver, 2000))
            assert frame.weights["jawOpen"] == weight
        with pytest.raises(BlockingIOError):
            receiver.recv(2000)
        assert output.probes == []
        assert said == [
            f"nothing is sent to livelink:{HOST}:{port}=gone: no character is called gone, or several are; "
            f"there are {label}."
        ]
        assert [(each.sent, each.character, each.fault) for each in output.receivers] == [(2, label, ""), (0, "", "")]
        output.remove(targets[0].word)
        show_harness.tick()
        with pytest.raises(BlockingIOError):
            receiver.recv(2000)
        await output.close()


async def test_a_receiver_that_is_nowhere_holds_nothing_up(show_harness: ShowHarness) -> None:
    targets = [FaceTarget("vmc", "255.255.255.255", 39539), FaceTarget("vmc", HOST, 9)]
    output = FaceOutput(targets, lambda: show_harness.show.session)
    show_harness.show.sources.append(output)
    for _ in range(3):
        show_harness.tick()
    await output.close()


async def test_a_receiver_that_is_not_there_is_said_once_and_shown_until_it_is(show_harness: ShowHarness) -> None:
    said: list[str] = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind((HOST, 0))
        port = taken.getsockname()[1]
    output = FaceOutput([FaceTarget("livelink", HOST, port)], lambda: show_harness.show.session, said.append)
    show_harness.show.sources.append(output)
    (receiver,) = output.receivers
    while not receiver.fault:
        show_harness.tick()
    for _ in range(20):
        show_harness.tick()
    assert said == [
        f"nobody hears the face that is sent to livelink:{HOST}:{port}: is the program there, and its receiver on."
    ]
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as program:
        program.bind((HOST, port))
        while receiver.fault:
            show_harness.tick()
            show_harness.clock.now += FAULT_SECONDS
    await output.close()
