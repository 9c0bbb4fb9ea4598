"""Orders and news arrive as they were sent, and an end is an end."""

import os
import socket

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.server.process.notice_board import MOST_NOTICES
from omote.server.process.process_messages import (
    TICK,
    Ended,
    Failover,
    News,
    Order,
    Ready,
    ShowMoved,
    SpareOrder,
    Started,
    read_news,
    read_pulse,
    receive_order,
    send_news,
    send_order,
    write_notice,
)
from omote.show.objects.link import Notice

NOTICES = st.lists(st.builds(Notice, st.text(), st.floats(0, 4e9), st.text(max_size=400)), max_size=5)


def test_an_order_arrives_with_its_pipes() -> None:
    ours, theirs = socket.socketpair()
    control, end = os.pipe()
    with ours, theirs:
        send_order(ours, Order(epoch=3, neutral=True), control, end)
        taken = receive_order(theirs)
    assert taken is not None
    order, (got_control, got_pulse) = taken
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
            send_news(theirs, Ready(11))
        ours.close()
        assert receive_order(theirs) is None


@pytest.mark.parametrize("order", [Order(epoch=1, neutral=False), SpareOrder()])
def test_an_order_without_what_belongs_to_it_is_none(order: Order | SpareOrder) -> None:
    ours, theirs = socket.socketpair()
    with ours, theirs:
        ours.sendall(msgspec.json.encode(order))
        assert receive_order(theirs) is None


def test_an_order_for_a_spare_arrives_with_its_line() -> None:
    ours, theirs = socket.socketpair()
    near, far = socket.socketpair()
    with ours, theirs, near, far:
        send_order(ours, SpareOrder(), far.fileno())
        taken = receive_order(theirs)
        assert taken is not None
        order, (line,) = taken
        assert order == SpareOrder()
        os.write(line, b"ready")
        assert near.recv(10) == b"ready"
        os.close(line)


def test_news_arrive_in_order() -> None:
    ours, theirs = socket.socketpair()
    news: list[News] = [Ready(11), Started(pid=12), Ended(pid=12, code=-9)]
    with ours, theirs:
        for each in news:
            send_news(ours, each)
        assert read_news(theirs.recv(4096)) == news


def test_news_to_nobody_are_no_fault() -> None:
    ours, theirs = socket.socketpair()
    theirs.close()
    with ours:
        send_news(ours, Ready(11))


def test_an_order_brings_what_the_crew_was_told() -> None:
    notices = [Notice(str(number), 1.7e9, "n" * 400) for number in range(MOST_NOTICES)]
    order = Order(epoch=3, neutral=False, failover=Failover(2, 5.5, hung=True), notices=notices)
    ours, theirs = socket.socketpair()
    control, end = os.pipe()
    with ours, theirs:
        send_order(ours, order, control, end)
        taken = receive_order(theirs)
    assert taken is not None
    assert taken[0] == order
    for descriptor in (control, end, *taken[1]):
        os.close(descriptor)


def test_a_pulse_tells_where_the_show_file_is_from_now_on() -> None:
    moved = ShowMoved('/x/a "b"-2.omote')
    notice = Notice("1", 1.0, "moved")
    stream = TICK + write_notice(moved) + TICK + write_notice(notice) + TICK
    assert read_pulse(stream) == ([moved, notice], b"")


@given(notices=NOTICES, ticks=st.lists(st.integers(0, 3), min_size=6, max_size=6), size=st.integers(1, 50))
def test_notices_come_through_a_pulse_between_ticks_however_it_is_cut(
    notices: list[Notice], ticks: list[int], size: int
) -> None:
    stream = TICK * ticks[5] + b"".join(
        TICK * count + write_notice(notice) for count, notice in zip(ticks, notices, strict=False)
    )
    found = list[Notice | ShowMoved]()
    rest = b""
    for start in range(0, len(stream), size):
        new, rest = read_pulse(rest + stream[start : start + size])
        found += new
    assert found == notices
    assert rest == b""


def test_half_a_notice_of_a_dying_process_is_passed_over() -> None:
    whole = write_notice(Notice("1", 1.0, "whole"))
    assert read_pulse(b'tt{"id": "0", "ti\ntt' + whole + b"tt") == ([Notice("1", 1.0, "whole")], b"")
    assert read_pulse(b"t" + whole[:9]) == ([], whole[:9])
