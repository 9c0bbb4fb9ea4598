"""Readings are values: the same control at the same place is the same reading."""

from omote.inputs.reading import Reading


def test_readings_are_compared_by_what_they_say() -> None:
    assert Reading("pad", "1/cc7", 0.5) == Reading("pad", "1/cc7", 0.5, key=False)
    assert Reading("pad", "1/cc7", 0.5) != Reading("other", "1/cc7", 0.5)
