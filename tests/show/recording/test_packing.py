"""What is packed comes back to the last bit, and takes the room that is asked."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.show.objects.sources import Drive
from omote.show.recording.entries import AnyEntry, Left, Sent, Ticked, encode_entries
from omote.show.recording.packing import pack_entries, unpack_entries
from tests import synthetic
from tests.show.recording.random_show import RandomShow, as_stored

CAST = synthetic.cast()
frames = st.builds(
    Sent,
    st.sampled_from(["a", "b"]),
    st.floats(0.0, 1e6),
    st.builds(Drive, st.integers(0, 2), st.binary(max_size=800)),
)
entries = st.lists(
    st.one_of(frames, st.builds(Ticked, st.floats(0.0, 1e6), st.integers(0, 2**32 - 1)), st.builds(Left, st.text())),
    max_size=40,
)


@given(entries)
def test_any_entries_come_back(listed: list[AnyEntry]) -> None:
    assert unpack_entries(pack_entries(listed)) == listed


def test_a_show_comes_back_in_a_third_of_its_bytes() -> None:
    show = RandomShow(3, {CAST.digest: CAST})
    show.play(10.0)
    stored, _ = as_stored(show.entries)
    packed = pack_entries(stored)
    whole = encode_entries(stored)
    assert encode_entries(unpack_entries(packed)) == whole
    assert len(packed) < len(whole) / 3


@given(st.binary(max_size=200))
def test_noise_is_refused(data: bytes) -> None:
    with pytest.raises(ValueError, match="damaged"):
        unpack_entries(data)


@given(st.integers(0, 10_000), st.integers(1, 255))
def test_a_damaged_byte_is_refused_or_harmless(place: int, change: int) -> None:
    show = [Ticked(float(number), number) for number in range(500)]
    packed = bytearray(pack_entries([*show]))
    packed[place % len(packed)] ^= change
    with pytest.raises(ValueError, match="damaged"):
        unpack_entries(bytes(packed))
