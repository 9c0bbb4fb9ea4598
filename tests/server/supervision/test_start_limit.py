"""The start limit: failed starts end a show that never played, never one that has."""

from __future__ import annotations

import pytest

from omote.server.process.process_messages import REJECTED
from omote.server.supervision.start_limit import FAILURES, LONGEST_PAUSE_SECONDS, PAUSE_SECONDS, StartLimit


def test_it_is_reached_by_so_many_failures_of_standbys_and_servers_together() -> None:
    limit = StartLimit()
    for number in range(FAILURES):
        assert not limit.reached
        if number % 2:
            limit.record_server()
        else:
            limit.record_standby(1, ready=False, plays=False)
    assert limit.reached


def test_one_standby_that_is_rejected_reaches_it() -> None:
    limit = StartLimit()
    limit.record_standby(REJECTED, ready=False, plays=False)
    assert limit.reached


@pytest.mark.parametrize("status", [REJECTED, 1, -9])
def test_a_show_that_has_played_is_never_given_up(status: int) -> None:
    limit = StartLimit()
    assert [limit.record_play(), limit.record_play()] == [True, False]
    for _ in range(2 * FAILURES):
        limit.record_server()
        limit.record_standby(status, ready=False, plays=False)
    assert not limit.reached


def test_pauses_grow_beside_a_server_that_plays_and_stay_short_without_one() -> None:
    limit = StartLimit()
    limit.record_play()
    pauses = [limit.record_standby(1, ready=False, plays=True) for _ in range(20)]
    assert pauses[:3] == [PAUSE_SECONDS, 2 * PAUSE_SECONDS, 4 * PAUSE_SECONDS]
    assert pauses == sorted(pauses)
    assert pauses[-1] == LONGEST_PAUSE_SECONDS
    assert limit.record_standby(1, ready=False, plays=False) == PAUSE_SECONDS
    assert limit.record_standby(-9, ready=True, plays=True) == 0.0
    assert limit.record_standby(1, ready=False, plays=True) == PAUSE_SECONDS
