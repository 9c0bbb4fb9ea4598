"""What a tracker sends is recorded as it comes, and a phone is asked for it."""

import socket
import threading
from pathlib import Path

import pytest

from omote.inputs.takes.packet_capture import read_packets
from omote.inputs.takes.packet_take import choose_protocol, read_packet_take
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.server.devices.trackers.take_recorder import check_recordable, count_packets, record_take
from omote.server.devices.trackers.tracker_sockets import TrackerWish, read_wish
from tests.inputs.trackers.packets import live_link_face

HOST = "127.0.0.1"
FACE = live_link_face([0.5 if index == 17 else 0.0 for index in range(61)])


def test_packets_are_recorded_and_play(tmp_path: Path) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind((HOST, 0))
        port = taken.getsockname()[1]
    path, told = tmp_path / "take.pcap", list[tuple[int, str]]()
    ended = threading.Event()

    def send() -> None:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:
            while not ended.wait(0.01):
                phone.sendto(FACE, (HOST, port))

    sender = threading.Thread(target=send)
    sender.start()
    count = record_take(
        path, read_wish(f"livelink:{port}"), seconds=0.3, tell=lambda count, host: told.append((count, host))
    )
    ended.set()
    sender.join()
    packets = read_packets(path.read_bytes())
    assert count == len(packets) == count_packets(path) > 1
    assert told[0][1] == HOST
    take = read_packet_take(packets, choose_protocol(packets))  # by the usual port, wherever it was recorded
    assert take.values[0][take.names.index("jawOpen")] == 0.5
    assert 0.1 < take.seconds < 5.0


def test_a_phone_is_asked_and_nothing_is_an_empty_capture(tmp_path: Path) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:
        phone.bind((HOST, 0))
        phone.settimeout(10.0)
        protocol = TRACKER_PROTOCOLS["ifacialmocap"]
        asked = type(protocol)(**{**vars(protocol), "phone_port": phone.getsockname()[1]})
        times = iter([0.0, 0.0, float("inf")])
        assert record_take(tmp_path / "a.pcap", TrackerWish(asked, 0, HOST), clock=lambda: next(times)) == 0
        assert phone.recv(200).startswith(b"iFacialMocap")
    assert count_packets(tmp_path / "a.pcap") == 0


def test_what_is_no_packet_of_udp_cannot_be_recorded() -> None:
    check_recordable(read_wish("vmc"))
    for word in ("mediapipe", "ifacialmocap-tcp", "vtubestudio-pc"):
        with pytest.raises(ValueError, match="cannot be recorded"):
            check_recordable(read_wish(word))
