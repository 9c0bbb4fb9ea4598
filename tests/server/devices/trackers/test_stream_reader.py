"""Trackers over TCP: packets of connections that come and go, cut anywhere, and answers to them."""

import socket
import time
from collections.abc import Iterator

import pytest

from omote.inputs.allowed_senders import THIS_MACHINE
from omote.inputs.trackers.face_motion.face_stream import END
from omote.server.devices.rejection_log import RejectionLog
from omote.server.devices.trackers import stream_reader
from omote.server.devices.trackers.stream_reader import StreamReader

HOST = "127.0.0.1"
LONG = 10.0


@pytest.fixture
def said() -> list[str]:
    """What the terminal was told."""
    return []


@pytest.fixture
def reader(said: list[str]) -> Iterator[StreamReader]:
    listening = socket.socket()
    listening.bind((HOST, 0))
    listening.listen()
    made = StreamReader(listening, "iFacialMocap TCP", THIS_MACHINE, RejectionLog(said.append))
    yield made
    made.close()


def connect(reader: StreamReader) -> socket.socket:
    return socket.create_connection(reader.socket.getsockname())


def read_until(reader: StreamReader, count: int) -> list[tuple[tuple[str, int], bytes]]:
    """Reads until so many packets have come."""
    found = list(reader.read())
    until = time.monotonic() + LONG
    while len(found) < count and time.monotonic() < until:
        found += reader.read()
    return found


def read_until_open(reader: StreamReader, count: int) -> None:
    """Reads until so many connections are open."""
    until = time.monotonic() + LONG
    while len(reader._connections) != count and time.monotonic() < until:
        list(reader.read())
    assert len(reader._connections) == count


def test_packets_of_each_connection_come_whole_and_are_answered_there(reader: StreamReader) -> None:
    with connect(reader) as first, connect(reader) as second:
        first.sendall(b"jawOpen&1|")
        second.sendall(b"jawOpen&2|" + END + b"jawOpen&3|" + END)
        assert [data for _, data in read_until(reader, 2)] == [b"jawOpen&2|", b"jawOpen&3|"]
        first.sendall(END)
        ((place, data),) = read_until(reader, 1)
        assert (place, data) == (first.getsockname(), b"jawOpen&1|")
        reader.send(b"heard", place)
        assert first.recv(10) == b"heard"
    read_until_open(reader, 0)


def test_who_is_no_connection_is_asked_over_udp(reader: StreamReader) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:
        phone.bind((HOST, 0))
        phone.settimeout(LONG)
        reader.send(b"begin", phone.getsockname())
        assert phone.recv(10) == b"begin"


def test_what_cannot_be_read_on_is_closed_and_said(reader: StreamReader, said: list[str]) -> None:
    with connect(reader) as phone:
        phone.settimeout(LONG)
        read_until_open(reader, 1)
        phone.sendall(b"x" * 40_000)
        read_until_open(reader, 0)
        reader._log.tell(0.0)
        assert "without the end of a frame" in said[0]


def test_many_connections_push_the_oldest_out(reader: StreamReader, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stream_reader, "MOST_CONNECTIONS", 2)
    phones = [connect(reader) for _ in range(3)]
    read_until_open(reader, 2)
    phones[2].sendall(b"jawOpen&1|" + END)
    assert len(read_until(reader, 1)) == 1
    for phone in phones:
        phone.close()


def test_who_may_not_play_is_not_heard(reader: StreamReader, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reader, "hears", lambda host: False)
    with connect(reader) as phone:
        phone.settimeout(LONG)
        list(reader.read())
        assert phone.recv(1) == b""
    assert not reader._connections
