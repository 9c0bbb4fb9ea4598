"""The newest entries are kept, in the order in which they came."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from omote.perform.newest_entries import with_newest


@given(st.lists(st.tuples(st.sampled_from("abcdef"), st.integers()), min_size=1), st.integers(1, 4))
def test_the_newest_of_each_key_are_kept_the_last_one_last(given_entries: list[tuple[str, int]], most: int) -> None:
    entries: dict[str, int] = {}
    for key, entry in given_entries:
        entries = with_newest(entries, key, entry, most)
    newest = dict(reversed({key: (place, entry) for place, (key, entry) in enumerate(given_entries)}.items()))
    expected = sorted(newest.items(), key=lambda each: each[1])[-most:]
    assert [*entries.items()] == [(key, entry) for key, (_, entry) in expected]
