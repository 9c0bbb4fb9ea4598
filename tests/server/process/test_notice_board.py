"""What the crew must know is posted from any thread, kept in order, and bounded."""

import threading

import msgspec
import pytest

from omote.server.process.notice_board import LONGEST_NOTICE, MOST_NOTICES, NoticeBoard
from omote.show.objects.link import Notice


def texts(board: NoticeBoard) -> list[str]:
    """What stands on a board."""
    return [notice.text for notice in board.notices]


def test_notices_stay_in_order_and_are_new_once() -> None:
    board = NoticeBoard(clock=lambda: 1_700_000_000_000_000_000)
    assert board.take_new() == []
    board.post("the disk is full.")
    board.post("/x/a.omote is damaged.")
    assert texts(board) == ["The disk is full.", "/x/a.omote is damaged."]
    assert board.take_new() == board.notices
    assert board.take_new() == []
    first, second = board.notices
    assert first.time == pytest.approx(1.7e9)
    assert int(second.id) == int(first.id) + 1  # each has its own, whatever the clock does


def test_the_same_again_is_new_and_stands_once() -> None:
    board = NoticeBoard()
    board.post("the disk is full.")
    (old,) = board.notices
    board.post("other")
    board.post("the disk is full.")
    assert texts(board) == ["Other", "The disk is full."]
    assert board.notices[-1].id != old.id  # whoever dismissed it the first time sees it


def test_what_was_said_before_stays_and_the_oldest_go() -> None:
    board = NoticeBoard([Notice(str(number), 0.0, f"N{number}") for number in range(MOST_NOTICES)])
    assert board.take_new() == []  # the others know
    board.post("x" * 1000)
    assert texts(board)[0] == "N1"
    assert len(board.notices) == MOST_NOTICES
    assert len(board.notices[-1].text) == LONGEST_NOTICE
    assert len(msgspec.json.encode(board.notices)) < 4096 * MOST_NOTICES


def test_a_report_goes_to_the_terminal_and_to_the_board() -> None:
    board = NoticeBoard()
    said = list[str]()
    board.with_report(said.append)("the disk is full.")
    assert (said, texts(board)) == (["the disk is full."], ["The disk is full."])


def test_what_is_solved_says_so_in_the_place_of_what_it_solves() -> None:
    board = NoticeBoard()
    tell = board.with_report(list[str]().append)
    tell("the disk is full.")
    tell("the disk is written again.", solves="the disk is full.")
    assert [(notice.text, notice.solved) for notice in board.notices] == [("The disk is written again.", True)]
    assert len(board.take_new()) == 2


def test_threads_lose_nothing() -> None:
    board = NoticeBoard()
    found: list[Notice] = []

    def post(name: int) -> None:
        for number in range(50):
            board.post(f"{name} {number}")

    threads = [threading.Thread(target=post, args=(name,)) for name in range(4)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        found += board.take_new()
    found += board.take_new()
    assert len({notice.id for notice in found}) == len(found) == 200
