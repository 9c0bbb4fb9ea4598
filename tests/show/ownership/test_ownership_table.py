"""Who holds and wants what, whatever seats do in whatever order."""

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule

from omote.show.ownership.ownership_table import AWAY_SECONDS, TOUCH_SECONDS, OwnershipTable
from omote.show.ownership.parts import expression_of, regions_of

SEATS = ["ana", "ben", "eva"]
KEYS = ["one/face", "one/expression", "one/mouth", "one/brows", "two/expression", "*/light"]
seat = st.sampled_from(SEATS)
keys = st.lists(st.sampled_from(KEYS), min_size=1, max_size=3, unique=True)


class LeaseMachine(RuleBasedStateMachine):
    """Seats come and go, touch, lease, take over and release; a model knows what must be."""

    def __init__(self) -> None:
        super().__init__()
        self.table = OwnershipTable()
        self.now = 0.0
        self.left: dict[str, float] = {}
        self.characters = {"one", "two"}

    def tick(self) -> None:
        self.table.expire({*SEATS} - {*self.left}, self.characters, self.now)

    @rule(on=st.booleans(), seat=seat)
    def switch(self, on: bool, seat: str) -> None:
        self.come_back(seat)
        manager = self.table.manager
        self.table.switch(on, seat)
        assert self.table.on == on
        if on:
            assert self.table.manager == (manager or seat), "who is there stays the stage manager"
        else:
            assert (self.table.held, self.table.manager) == ({}, "")

    @rule(seat=seat, keys=keys)
    def touch(self, seat: str, keys: list[str]) -> None:
        """As a message that plays: rejected where others hold it, else its parts are the sender's."""
        self.come_back(seat)
        if not self.table.on:
            assert not self.table.foreign(seat, keys), "off: everything passes"
        held = dict(self.table.held)
        if self.table.foreign(seat, keys):
            assert any(
                held.get(near, seat) != seat for key in keys for near in (key, expression_of(key), *regions_of(key))
            )
            return
        assert self.table.take(seat, keys) == {}, "nobody loses what nobody took over"
        assert self.table.held == (held | dict.fromkeys(keys, seat) if self.table.on else {})

    @rule(seat=seat, keys=keys)
    def take_over(self, seat: str, keys: list[str]) -> None:
        self.come_back(seat)
        before = dict(self.table.held)
        lost = self.table.take(seat, keys)
        assert lost.items() <= before.items()
        assert seat not in lost.values()
        if self.table.on:
            assert not self.table.foreign(seat, keys), "who took it over may play it"

    @rule(seat=seat, keys=keys)
    def release(self, seat: str, keys: list[str]) -> None:
        others = {key: holder for key, holder in self.table.held.items() if holder != seat}
        self.table.release(seat, keys)
        assert others.items() <= self.table.held.items(), "nobody releases for others"
        assert all(self.table.held.get(key) != seat for key in keys), "a released part is free"

    @rule(seat=seat)
    def leave(self, seat: str) -> None:
        if seat not in self.left:
            self.tick()
            self.left[seat] = self.now
            self.tick()

    @rule(seat=seat)
    def return_(self, seat: str) -> None:
        self.come_back(seat)

    def come_back(self, seat: str) -> None:
        """Only who has a link plays."""
        self.left.pop(seat, None)
        self.tick()

    @rule(seconds=st.floats(0.0, 2.0 * AWAY_SECONDS))
    def wait(self, seconds: float) -> None:
        before = dict(self.table.held)
        self.now += seconds
        self.tick()
        gone = {each for each, since in self.left.items() if self.now - since >= AWAY_SECONDS}
        assert self.table.held == {key: each for key, each in before.items() if each not in gone}

    @rule()
    def lose_a_character(self) -> None:
        before = dict(self.table.held)
        self.table.expire({*SEATS}, {"one"}, self.now)
        assert self.table.held == {key: each for key, each in before.items() if not key.startswith("two/")}
        self.tick()

    @invariant()
    def holders_are_here_or_were_just_now(self) -> None:
        for each in {*self.table.held.values(), self.table.manager} & {*self.left}:
            assert self.now - self.left[each] < AWAY_SECONDS

    @invariant()
    def off_nobody_holds_anything(self) -> None:
        assert self.table.on or not self.table.held


LeaseMachine.TestCase.settings = settings(max_examples=100, stateful_step_count=25, deadline=None)
TestTable = LeaseMachine.TestCase


def test_a_region_that_is_taken_from_an_expression_leaves_its_holder_the_rest() -> None:
    table = OwnershipTable(on=True)
    table.take("ana", ["one/expression"])
    assert table.foreign("ben", ["one/mouth"]) == {"one/mouth": "ana"}
    assert table.take("ben", ["one/mouth"]) == {}
    assert table.foreign("ben", ["one/mouth"]) == {}
    assert table.foreign("ana", ["one/expression"]) == {"one/mouth": "ben"}, "a whole call would move the mouth"
    assert table.foreign("ana", ["one/brows"]) == {}
    assert table.take("ana", ["one/expression"]) == {"one/mouth": "ben"}


def test_one_who_comes_back_in_time_keeps_what_it_holds_and_the_next_time_counts_anew() -> None:
    table = OwnershipTable(on=True)
    table.take("ana", ["one/face"])
    for now, present in (
        (0.0, set()),
        (AWAY_SECONDS - 0.1, set()),
        (AWAY_SECONDS, {"ana"}),
        (AWAY_SECONDS + 1.0, set()),
    ):
        table.expire(present, {"one"}, now)
    assert table.held == {"one/face": "ana"}


def test_leases_of_a_restart_count_where_they_were_on() -> None:
    assert OwnershipTable(on=True, manager="ana", held={"one/face": "ana"}).held == {"one/face": "ana"}
    assert OwnershipTable(held={"one/face": "ana"}).held == {}


HERE = frozenset({"ana", "ben", "desk"})
CONSOLES = frozenset({"ana", "ben"})


@pytest.fixture
def wishes() -> OwnershipTable:
    """Ben and a desk want the face, which Eva holds."""
    wishes = OwnershipTable(on=True, held={"one/face": "eva"})
    for seat in ("ben", "desk"):
        wishes.want(seat, ["one/face"], 1.0)
    return wishes


def seats(wishes: OwnershipTable) -> list[str]:
    return [wish.seat for wish in wishes.wishes()]


def test_an_operators_wish_stands_however_long_and_a_desks_while_it_touches(wishes: OwnershipTable) -> None:
    assert not wishes.expire_wishes(HERE, CONSOLES, 1.0)
    assert wishes.expire_wishes(HERE, CONSOLES, 1.0 + TOUCH_SECONDS)
    assert seats(wishes) == ["ben"]
    wishes.want("ben", ["one/face"], 3600.0)
    assert [wish.since for wish in wishes.wishes()] == [1.0]


def test_a_reload_keeps_a_wish_and_leaving_ends_it(wishes: OwnershipTable) -> None:
    away = {"desk"}
    wishes.expire_wishes(away, away, 2.0)
    assert wishes.expire_wishes(away, away, 1.0 + 0.9 * AWAY_SECONDS) is False
    wishes.expire_wishes(HERE, HERE, 100.0)
    assert seats(wishes) == ["ben", "desk"]
    wishes.expire_wishes(away, away, 100.0 + AWAY_SECONDS)
    assert seats(wishes) == ["desk"]


def test_what_nobody_else_holds_any_more_is_wanted_no_more(wishes: OwnershipTable) -> None:
    wishes.take("desk", ["one/face"])
    wishes.expire_wishes(HERE, HERE, 1.0)
    assert seats(wishes) == ["ben"]


def test_a_wish_is_taken_back_or_answered(wishes: OwnershipTable) -> None:
    assert not wishes.withdraw("ben", ["one/head"])
    assert wishes.withdraw("ben", ["one/face"])
    assert wishes.answer(["one/face", "one/head"]) == {"desk": ["one/face"]}
    assert seats(wishes) == []
