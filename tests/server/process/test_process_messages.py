"""Orders and news arrive as they were sent, and an end is an end."""

import os
import socket

import msgspec
import pytest

from omote.server.process.process_messages import (
    Ended,
    News,
    Order,
    Ready,
    Started,
    read_news,
    receive_order,
    send_news,
    send_order,
)


def test_an_order_arrives_with_its_pipes() -> None:
    ours, theirs = socket.socketpair()
    control, end = os.pipe()
    with ours, theirs:
        send_order(ours, Order(epoch=3, neutral=True), control, end)
        taken = receive_order(theirs)
    assert taken is not None
    order, got_control, got_pulse = taken
    assert order == Order(epoch=3, neutral=True)
    os.write(got_pulse, b"t")
    assert os.read(got_control, 10) == b"t"
    for descriptor in (control, end, got_control, got_pulse):
        os.close(descriptor)


@pytest.mark.parametrize("unread", [False, True])
def test_the_end_of_the_line_is_no_order(unread: bool) -> None:
    ours, theirs = socket.socketpair()
    with theirs:
        if unread:
            send_news(theirs, Ready())
        ours.close()
        assert receive_order(theirs) is None


def test_an_order_without_its_pipes_is_none() -> None:
    ours, theirs = socket.socketpair()
    with ours, theirs:
        ours.sendall(msgspec.json.encode(Order(epoch=1, neutral=False)))
        assert receive_order(theirs) is None


def test_news_arrive_in_order() -> None:
    ours, theirs = socket.socketpair()
    news: list[News] = [Ready(), Started(pid=12), Ended(pid=12, code=-9)]
    with ours, theirs:
        for each in news:
            send_news(ours, each)
        assert read_news(theirs.recv(4096)) == news


def test_news_to_nobody_are_no_fault() -> None:
    ours, theirs = socket.socketpair()
    theirs.close()
    with ours:
        send_news(ours, Ready())
