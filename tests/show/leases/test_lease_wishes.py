"""A wish stands until it is answered or taken back, or its reason has gone; nothing else ends it."""

import pytest

from omote.show.leases.lease_table import AWAY_SECONDS
from omote.show.leases.lease_wishes import TOUCH_SECONDS, LeaseWishes

HERE = frozenset({"ana", "ben", "desk"})
CONSOLES = frozenset({"ana", "ben"})


@pytest.fixture
def wishes() -> LeaseWishes:
    """Ben and a desk want the face."""
    wishes = LeaseWishes()
    for seat in ("ben", "desk"):
        wishes.note(seat, ["one/face"], 1.0)
    return wishes


def seats(wishes: LeaseWishes) -> list[str]:
    return [wish.seat for wish in wishes]


def test_an_operators_wish_stands_however_long_and_a_desks_while_it_touches(wishes: LeaseWishes) -> None:
    assert not wishes.expire(lambda *_: True, HERE, CONSOLES, 1.0)
    assert wishes.expire(lambda *_: True, HERE, CONSOLES, 1.0 + TOUCH_SECONDS)
    assert seats(wishes) == ["ben"]
    wishes.note("ben", ["one/face"], 3600.0)
    assert [wish.since for wish in wishes] == [1.0]


def test_a_reload_keeps_a_wish_and_leaving_ends_it(wishes: LeaseWishes) -> None:
    away = {"desk"}
    wishes.expire(lambda *_: True, away, away, 2.0)
    assert wishes.expire(lambda *_: True, away, away, 1.0 + 0.9 * AWAY_SECONDS) is False
    wishes.expire(lambda *_: True, HERE, HERE, 100.0)
    assert seats(wishes) == ["ben", "desk"]
    wishes.expire(lambda *_: True, away, away, 100.0 + AWAY_SECONDS)
    assert seats(wishes) == ["desk"]


def test_what_nobody_else_holds_any_more_is_wanted_no_more(wishes: LeaseWishes) -> None:
    wishes.expire(lambda seat, key: (seat, key) == ("ben", "one/face"), HERE, HERE, 1.0)
    assert seats(wishes) == ["ben"]


def test_a_wish_is_taken_back_or_answered(wishes: LeaseWishes) -> None:
    assert not wishes.withdraw("ben", ["one/head"])
    assert wishes.withdraw("ben", ["one/face"])
    assert wishes.answer(["one/face", "one/head"]) == {"desk": ["one/face"]}
    assert seats(wishes) == []
