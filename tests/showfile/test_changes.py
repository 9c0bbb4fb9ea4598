"""What is kept of authored work is plain data: it survives encoding."""

import msgspec

from omote.showfile.changes import Stored
from tests.showfile.authored_work import FIRST, AuthoredTables


def test_a_whole_store_survives_encoding() -> None:
    tables = AuthoredTables()
    assert all(tables.make(change) for change in FIRST)
    stored = tables.stored()
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(stored), type=Stored) == stored
    assert stored.items[0].head == stored.revisions[0].number
