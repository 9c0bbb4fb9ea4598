"""What a tracker sends is recorded as it comes, and a phone is asked for it."""

import socket
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from omote.inputs.takes.packet_capture import read_packets
from omote.inputs.takes.packet_take import choose_protocol, read_packet_take
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.server.devices.trackers.take_recorder import check_recordable, record_take
from omote.server.devices.trackers.tracker_sockets import TrackerWish, read_wish
from tests.inputs.trackers.packets import live_link_face

HOST = "127.0.0.1"
FACE = live_link_face([0.5 if index == 17 else 0.0 for index in range(61)])


def stopped_after(looks: int) -> Callable[[], float]:
    """A clock that is looked at so often before Ctrl-C comes."""
    left = [looks]

    def clock() -> float:
        left[0] -= 1
        if left[0] < 0:
            raise KeyboardInterrupt
        return 0.0

    return clock


def test_packets_are_recorded_and_play(tmp_path: Path) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind((HOST, 0))
        port = taken.getsockname()[1]
    path = tmp_path / "take.pcap"
    told = list[tuple[int, str, float]]()
    ended = threading.Event()

    def send() -> None:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:
            while not ended.wait(0.01):
                phone.sendto(FACE, (HOST, port))

    sender = threading.Thread(target=send)
    sender.start()
    count = record_take(path, read_wish(f"livelink:{port}"), seconds=0.3, tell=lambda *said: told.append(said))
    ended.set()
    sender.join()
    packets = read_packets(path.read_bytes())
    assert count == len(packets) > 1
    assert told[0][0] == 0
    take = read_packet_take(packets, choose_protocol(packets))  # by the usual port, wherever it was recorded
    assert take.values[0][take.names.index("jawOpen")] == 0.5
    assert 0.1 < take.seconds < 5.0


def test_a_phone_is_asked_and_without_a_packet_no_file_is_written(tmp_path: Path) -> None:
    path = tmp_path / "a.pcap"
    opened = list[int]()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:
        phone.bind((HOST, 0))
        phone.settimeout(10.0)
        protocol = TRACKER_PROTOCOLS["ifacialmocap"]
        asked = type(protocol)(**{**vars(protocol), "phone_port": phone.getsockname()[1]})
        wish = TrackerWish(asked, 0, HOST)
        assert record_take(path, wish, opened=opened.append, clock=stopped_after(2)) == 0
        assert phone.recv(200).startswith(b"iFacialMocap")
    assert not path.exists()
    assert opened[0] > 0, "the port that the system chose is told"


def test_nothing_is_claimed_or_written_where_the_port_or_the_file_cannot_be_had(tmp_path: Path) -> None:
    opened = list[int]()
    before = tmp_path / "before.pcap"
    before.write_bytes(b"a take")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("", 0))
        with pytest.raises(OSError, match="another program has it"):
            record_take(before, read_wish(f"livelink:{taken.getsockname()[1]}"), opened=opened.append)
    for path in (tmp_path, tmp_path / "gone" / "a.pcap"):
        with pytest.raises(OSError, match=r"gone|Is a directory"):
            record_take(path, read_wish("livelink:0"), opened=opened.append)
    assert opened == []
    assert before.read_bytes() == b"a take"


def test_a_take_that_nothing_came_for_stays_what_it_was(tmp_path: Path) -> None:
    before = tmp_path / "before.pcap"
    before.write_bytes(b"a take")
    assert record_take(before, read_wish("livelink:0"), clock=stopped_after(2)) == 0
    assert before.read_bytes() == b"a take"


def test_what_is_no_packet_of_udp_cannot_be_recorded() -> None:
    check_recordable(read_wish("vmc"))
    for word in ("mediapipe", "ifacialmocap-tcp", "vtubestudio-pc"):
        with pytest.raises(ValueError, match="cannot be recorded"):
            check_recordable(read_wish(word))


def test_what_came_before_ctrl_c_is_in_the_file(tmp_path: Path) -> None:
    path = tmp_path / "take.pcap"
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:

        def send(port: int) -> None:
            phone.sendto(FACE, (HOST, port))

        assert record_take(path, read_wish("livelink:0"), opened=send, clock=stopped_after(3)) == 1
    assert [packet.data for packet in read_packets(path.read_bytes())] == [FACE]


def test_how_long_nothing_has_come_is_told(tmp_path: Path) -> None:
    times = iter([0.0, 0.0, 1.5, 3.0])
    told = list[tuple[int, str, float]]()

    def clock() -> float:
        if (now := next(times, None)) is None:
            raise KeyboardInterrupt
        return now

    record_take(tmp_path / "a.pcap", read_wish("livelink:0"), tell=lambda *said: told.append(said), clock=clock)
    assert told == [(0, "", 0.0), (0, "", 1.5), (0, "", 3.0)]
