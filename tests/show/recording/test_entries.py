"""Entries as bytes: each kind comes back, and noise is none."""

from __future__ import annotations

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.show.recording.entries import decode_entries, encode_entries
from tests import synthetic
from tests.show.recording.random_show import RandomShow, as_stored

CAST = synthetic.cast()


def test_a_show_comes_back() -> None:
    show = RandomShow(13, {CAST.digest: CAST})
    show.play(5.0)
    again, _ = as_stored(show.entries)
    assert [type(entry) for entry in again] == [type(entry) for entry in show.entries]
    assert decode_entries(encode_entries(again)) == again


@given(st.binary(max_size=100))
def test_noise_is_no_entry(data: bytes) -> None:
    try:
        entries = decode_entries(data)
    except (msgspec.DecodeError, UnicodeDecodeError):
        return
    assert entries == []


def test_an_entry_of_another_kind_is_refused() -> None:
    with pytest.raises(msgspec.ValidationError):
        decode_entries(msgspec.msgpack.encode([["Sung", "ana"]]))
