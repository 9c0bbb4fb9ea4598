"""One source: what it sends is read, listened to and measured; what cannot be is refused by name."""

import numpy as np
import pytest

from omote.show.objects.sources import Drive
from omote.show.sources.calibration import AS_IT_IS, measure_of
from omote.show.sources.open_source import (
    OpenSource,
    begin_range,
    check_channels,
    hear_values,
    measured_by,
    read_values,
    source_values,
)
from omote.show.validation import Refusal

NAMES = ("jawOpen", "smile")


def opened() -> OpenSource:
    return OpenSource("phone", "tracker", "a", NAMES, "Mira", measure_of(AS_IT_IS, NAMES))


def heard(source: OpenSource, *values: float, found: bool = True) -> OpenSource:
    frame = Drive(1, np.array(values, "<f4").tobytes(), found=found)
    return hear_values(source, read_values(source, frame), found=found, share=1.0)


def test_frames_without_a_performer_count_and_change_no_value() -> None:
    source = heard(heard(opened(), 0.5, 0.25), 0.0, 0.0, found=False)
    assert source.sent is not None
    assert (source.sent.tolist(), source.frames, source.found) == ([0.5, 0.25], 2, False)
    told = source_values(source)
    assert told is not None
    assert np.frombuffer(told.sent, "<f4").tolist() == [0.5, 0.25]
    assert source_values(opened()) is None


def test_a_range_is_the_largest_of_its_channels_alone() -> None:
    source = heard(begin_range(heard(opened(), 0.1, 0.1), ("smile",)), 0.9, 0.75)
    assert measured_by(heard(source, 0.0, 0.0), AS_IT_IS, "done").highest == {"smile": 0.75}


def test_what_cannot_be_read_or_measured_is_refused_by_name() -> None:
    with pytest.raises(Refusal, match="phone sent 4 bytes for 2 channels; send 4 for each"):
        heard(opened(), 0.5)
    with pytest.raises(ValueError, match="smile of phone is 2"):
        heard(opened(), 0.5, 2.0)
    with pytest.raises(ValueError, match="there is no channel of phone 'gone'"):
        check_channels(opened(), ["gone"])
    with pytest.raises(ValueError, match="phone has not sent a frame yet"):
        measured_by(opened(), AS_IT_IS, "neutral")
