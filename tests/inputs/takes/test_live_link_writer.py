"""Live Link CSV out: read by Python's own csv, and back by our reader of the app's files."""

from __future__ import annotations

import csv
from dataclasses import replace

import numpy as np
import pytest

from omote.inputs.takes.live_link_take import read_live_link_take
from omote.inputs.takes.live_link_writer import live_link_csv
from omote.inputs.takes.take_clip import clip_of_take
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.interchange.clips.clip_frames import ClipFrames, sample_clip
from omote.model.cast import Cast
from tests.interchange.clips.motion import frames_of

COLUMNS = 63
"""Time code, count, 52 weights and nine angles, as the app writes them."""


def frames_at_random(count: int = 200) -> ClipFrames:
    random = np.random.default_rng(1)
    weights = {name: random.uniform(0.0, 1.0, count) for name in ARKIT_NAMES if not name.startswith("eyeLook")}
    return ClipFrames(
        60.0, np.arange(count) / 60.0, weights, random.uniform(-0.6, 0.6, (count, 3)), np.zeros((count, 2))
    )


def test_each_column_has_what_the_app_has_in_it(cast: Cast) -> None:
    frames = frames_of(cast)
    text, notes = live_link_csv(frames, cast.expressions)
    header, *rows = csv.reader(text.splitlines())
    assert len(header) == COLUMNS == len(rows[0])
    assert header[:4] == ["Timecode", "BlendShapeCount", "EyeBlinkLeft", "EyeLookDownLeft"]
    assert {row[1] for row in rows} == {"61"}
    table = {name: np.array([float(row[place]) for row in rows]) for place, name in enumerate(header) if place}
    assert table["JawOpen"] == pytest.approx(frames.weights["jawOpen"], abs=1e-4)
    assert table["HeadYaw"] == pytest.approx(-frames.head[:, 0], abs=1e-4)
    assert table["HeadPitch"] == pytest.approx(-frames.head[:, 1], abs=1e-4)
    assert table["HeadRoll"] == pytest.approx(frames.head[:, 2], abs=1e-4)
    assert table["LeftEyeYaw"] == pytest.approx(-frames.gaze[:, 0], abs=1e-4)
    assert "smile is no coefficient of ARKit, and is left out" in notes


def test_all_comes_back_as_it_was(cast: Cast) -> None:
    frames = frames_at_random()
    text, notes = live_link_csv(frames, cast.expressions)
    assert notes == ()
    again = sample_clip(clip_of_take(read_live_link_take(text), cast))
    assert again.times == pytest.approx(frames.times, abs=1e-9)
    for name, values in frames.weights.items():
        assert again.weights[name] == pytest.approx(values, abs=1e-6), name
    assert again.head == pytest.approx(frames.head, abs=1e-6)


def test_what_the_format_cannot_say_is_told(cast: Cast) -> None:
    frames = frames_at_random()
    with pytest.raises(ValueError, match="60 frames a second, not 30"):
        live_link_csv(replace(frames, rate=30.0), cast.expressions)
    below = replace(frames, weights={"jawOpen": np.full(200, -0.1)})
    assert live_link_csv(below, cast.expressions)[1] == ("jawOpen goes below 0, where the format ends",)
