"""Mappings that keep the newest of what they are given: what was changed last can be taken back, all else is gone."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeVar

Entry = TypeVar("Entry")


def with_newest(entries: Mapping[str, Entry], key: str, entry: Entry, most: int) -> dict[str, Entry]:
    """The entries with one more, the newest last, in the place of the one of its key; the oldest go where there are too
    many.

    key: of the new entry; most: how many are kept.
    """
    others = {name: other for name, other in entries.items() if name != key}
    return dict([*others.items(), (key, entry)][-most:])
