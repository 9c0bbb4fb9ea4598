"""The reference of the show file has every table and column that a new file gets."""

from __future__ import annotations

import sqlite3
from contextlib import closing

from omote.showfile.schema import migrate
from tools.website.file_reference import PURPOSES, file_page


def test_every_table_and_column_is_there() -> None:
    page = file_page()
    with closing(sqlite3.connect(":memory:")) as made:
        migrate(made, 0)
        tables = {name for (name,) in made.execute("SELECT name FROM sqlite_schema WHERE type = 'table'")}
        columns = {row[0] for name in tables for row in made.execute("SELECT name FROM pragma_table_xinfo(?)", (name,))}
    assert tables == PURPOSES.keys()
    assert [name for name in tables if f"## `{name}`" not in page] == []
    assert [name for name in columns if f"| `{name}` |" not in page] == []
