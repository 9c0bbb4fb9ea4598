"""Frames of several layers at once are those of one layer after the other, to the bit."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.frame import Gaze, Head, Held
from omote.perform.layers.direct_frames import drive_direct
from omote.perform.layers.layer_names import LayerName
from omote.perform.layers.layer_vectors import Layers
from omote.perform.layers.layers import advance, begin, drive, leave
from omote.perform.layers.source_frame import SourceFrame


def frames(step: int) -> dict[LayerName, SourceFrame]:
    """What a character's own motion sends at a step."""
    way = 0.01 * (step % 50)
    return {
        "breath": SourceFrame(("jawOpen",), np.array([way / 20]), Head(way, 0.0, 0.0), source="own", direct=True),
        "gaze": SourceFrame((), np.zeros(0), Head(way, -way, 0.0), Gaze(way, -way), source="own", direct=True),
        "blink": SourceFrame(("smile",), np.array([way]), source="own", direct=True),
    }


def same(one: Layers, other: Layers) -> bool:
    """Whether two characters' layers are the same in all that follows."""
    vectors = zip((one.goal, one.first, one.second), (other.goal, other.first, other.second), strict=True)
    return all(np.array_equal(*each) for each in vectors) and (one.drivers, one.owners) == (other.drivers, other.owners)


@given(st.lists(st.sampled_from(["send", "send", "send", "rest", "leave"]), min_size=5, max_size=40))
@settings(max_examples=25, deadline=None)
def test_at_once_is_one_after_the_other(cast: Cast, events: list[str]) -> None:
    one = other = begin(cast, Held())
    for step, event in enumerate(events):
        if event == "send":
            one = drive_direct(cast, one, frames(step))
            for layer, frame in frames(step).items():
                other = drive(cast, other, layer, frame)
        if event == "leave":
            one, other = leave(one, "gaze", "own"), leave(other, "gaze", "own")
        dt = 1.0 if event == "rest" else 1 / 60
        one, other = (advance(cast, each, Held(), dt, still=True) for each in (one, other))
        assert same(one, other)
