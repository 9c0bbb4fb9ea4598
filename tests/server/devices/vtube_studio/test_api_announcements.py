"""Where VTube Studio runs: others may hear it too, and what is none is left out."""

import json
import socket
import time

from omote.server.devices.vtube_studio.api_announcements import MOST_HEARD, ApiAnnouncements

HOST = "127.0.0.1"
LONG = 10.0


def announce(port: int, at: int, data: bytes | None = None) -> None:
    state = {"active": True, "port": at, "instanceID": "93aa0d04", "windowTitle": "VTube Studio"}
    head = {"apiName": "VTubeStudioPublicAPI", "apiVersion": "1.0", "messageType": "VTubeStudioAPIStateBroadcast"}
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as program:
        program.sendto(data or json.dumps({**head, "data": state}).encode(), (HOST, port))


def test_many_programs_take_no_memory_and_damage_is_left_out() -> None:
    heard = ApiAnnouncements(0)
    announce(heard.port, 0, b"hello")
    for at in range(8000, 8030):
        announce(heard.port, at)
    until = time.monotonic() + LONG
    while (HOST, 8029) not in heard.look(0.0) and time.monotonic() < until:
        pass
    assert len(heard.look(0.0)) == MOST_HEARD
    heard.close()
    assert heard.look(0.0)


def test_a_port_that_cannot_be_had_finds_nothing() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("", 0))
        heard = ApiAnnouncements(other.getsockname()[1])
        assert (heard.port, heard.look(0.0)) == (0, {})
