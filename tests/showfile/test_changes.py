"""What is kept of authored work is plain data: it survives encoding, and every change tells its own kind."""

import msgspec
from hypothesis import given

from omote.showfile.changes import Change, Stored
from tests.showfile.authored_work import FIRST, AuthoredTables, puts


@given(puts)
def test_a_change_survives_encoding(change: Change) -> None:
    data = msgspec.msgpack.encode(change)
    again: Change = msgspec.msgpack.decode(data, type=Change)
    assert again == change


def test_a_whole_store_survives_encoding() -> None:
    tables = AuthoredTables()
    assert all(tables.make(change) for change in FIRST)
    stored = tables.stored
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(stored), type=Stored) == stored
    assert stored.items[0].head == stored.revisions[0].number
