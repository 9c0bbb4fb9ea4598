"""Datagrams of those who may play, over real sockets."""

import socket
from collections.abc import Iterator
from types import SimpleNamespace

import pytest

from omote.inputs.allowed_senders import THIS_MACHINE, AllowedSenders
from omote.server.devices.datagram_reader import READ_SECONDS, DatagramReader
from omote.server.devices.rejection_log import RejectionLog

HOST = "127.0.0.1"


class Nobody(AllowedSenders):
    """As a foreign host meets it."""

    def allows(self, host: str) -> bool:  # noqa: ARG002
        return False


@pytest.fixture(autouse=True)
def stopped_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    """No time passes while reading: a loaded machine ends no tick's reading early."""
    monkeypatch.setattr("omote.server.devices.datagram_reader.time", SimpleNamespace(perf_counter=lambda: 0.0))


@pytest.fixture
def pair() -> Iterator[tuple[socket.socket, socket.socket]]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ours, socket.socket(type=socket.SOCK_DGRAM) as theirs:
        ours.bind((HOST, 0))
        theirs.bind((HOST, 0))
        theirs.connect(ours.getsockname())
        yield ours, theirs


def test_what_has_come_is_read_without_waiting(pair: tuple[socket.socket, socket.socket]) -> None:
    ours, theirs = pair
    reader = DatagramReader(ours, "OSC", THIS_MACHINE, RejectionLog(lambda _: None))
    assert list(reader.read()) == []
    for data in (b"a", b""):
        theirs.send(data)
    assert list(reader.read()) == [(theirs.getsockname(), b"a"), (theirs.getsockname(), b"")]


def test_who_may_not_play_is_counted_and_named(pair: tuple[socket.socket, socket.socket]) -> None:
    ours, theirs = pair
    said: list[str] = []
    log = RejectionLog(said.append)
    reader = DatagramReader(ours, "OSC", Nobody(), log)
    for _ in range(3):
        theirs.send(b"a")
    assert list(reader.read()) == []
    log.tell(0.0)
    assert reader.foreign == 3
    assert said == ["OSC from 127.0.0.1 is not heard: --allow 127.0.0.1 lets it play (3 were rejected)."]


def test_a_tick_reads_for_a_bounded_time(
    pair: tuple[socket.socket, socket.socket], monkeypatch: pytest.MonkeyPatch
) -> None:
    ours, theirs = pair
    clock = iter(step * READ_SECONDS / 9.5 for step in range(1000))
    monkeypatch.setattr("omote.server.devices.datagram_reader.time", SimpleNamespace(perf_counter=lambda: next(clock)))
    for _ in range(30):
        theirs.send(b"a")
    reader = DatagramReader(ours, "OSC", THIS_MACHINE, RejectionLog(lambda _: None))
    assert [len(list(reader.read())) for _ in range(3)] == [9, 9, 9]
