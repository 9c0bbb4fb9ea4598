"""Packets of Live Link Face: golden ones by their layout, real takes, and every damage is rejected."""

import csv
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.live_link_face import VALUES, decode_live_link_face, encode_live_link_face, frame_of_values
from omote.inputs.trackers.tracker_frame import TrackerError, TrackerFrame
from tests.inputs.trackers.packets import live_link_face

TAKES = Path(__file__).parents[4] / "shared" / "data" / "livelinkface"
STILL = [0.0] * VALUES
WEIGHTS = st.lists(st.floats(-0.5, 1.5, width=32), min_size=52, max_size=52)
ANGLE = st.floats(-1.0, 1.0)


def test_a_golden_packet_is_read_by_name() -> None:
    values = STILL.copy()
    values[17], values[52:55], values[55], values[58] = 0.75, [0.3, -0.2, 0.1], 0.2, 0.4
    (frame,) = decode_live_link_face(live_link_face(values, "Ada"))
    assert (frame.subject, frame.time, frame.found) == ("Ada", 2.0083333333333333, True)
    assert {name: value for name, value in frame.weights.items() if value} == {"jawOpen": 0.75}
    assert frame.head == pytest.approx((-0.3, 0.2, 0.1))
    assert frame.gaze == pytest.approx((-0.3, 0.0))


@given(WEIGHTS, st.tuples(ANGLE, ANGLE, ANGLE), st.tuples(ANGLE, ANGLE), st.text("abcÄ ", max_size=20))
def test_what_is_sent_is_read_as_it_was(
    weights: list[float], head: tuple[float, float, float], gaze: tuple[float, float], subject: str
) -> None:
    packet = encode_live_link_face(weights, head, gaze, device="omote", subject=subject.strip(), frame=90)
    (frame,) = decode_live_link_face(packet)
    assert list(frame.weights.values()) == weights
    assert frame.head == pytest.approx(head, abs=1e-6)
    assert frame.gaze == pytest.approx(gaze, abs=1e-6)
    assert (frame.subject, frame.time) == (subject.strip(), 1.5)


def test_a_packet_without_a_face_says_that_nobody_is_seen() -> None:
    packet = live_link_face(STILL)
    for short in (packet[: -4 * VALUES - 17], packet[: -4 * VALUES - 1] + b"\0"):
        (frame,) = decode_live_link_face(short)
        assert (frame.found, frame.weights, frame.subject) == (False, {}, "Phone")


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "nothing"),
        (b"\x05" + live_link_face(STILL)[1:], "expected version 6"),
        (b"\x06\0\0", "device's name"),
        (b"\x06\x7f\0\0\0", "bytes, which are not there"),
        (live_link_face(STILL)[:52], "time code"),
        (live_link_face(STILL)[:-1], "announces 61 values in 243 bytes"),
        (live_link_face(STILL) + b"\0", "announces 61"),
        (live_link_face(STILL[:51]), "announces 51"),
        (live_link_face(STILL[:52])[:-1], "announces 52 values in 207 bytes"),
    ],
)
def test_damage_is_rejected_with_a_reason(data: bytes, why: str) -> None:
    with pytest.raises(TrackerError, match=why):
        decode_live_link_face(data)


@pytest.mark.parametrize(
    ("index", "wrong", "name"),
    [(0, float("nan"), "eyeBlinkLeft"), (0, 2.0, "eyeBlinkLeft"), (52, float("inf"), "head"), (59, 1e30, "gaze")],
)
def test_one_wrong_value_costs_itself(index: int, wrong: float, name: str) -> None:
    values = STILL.copy()
    values[17], values[index] = 0.75, wrong
    (frame,) = decode_live_link_face(live_link_face(values))
    assert frame.weights["jawOpen"] == 0.75
    assert (frame.head is None, frame.gaze is None) == (name == "head", name == "gaze")
    assert [said for said, _ in frame.left_out] == [name]


def test_an_app_that_sends_no_angles_or_more_values_is_read_by_what_it_has() -> None:
    values = STILL.copy()
    values[17], values[52] = 0.75, 0.25
    (short,) = decode_live_link_face(live_link_face(values[:52]))
    (long,) = decode_live_link_face(live_link_face([*values, 9.0]))
    assert short.weights == long.weights
    assert (short.head, long.head) == (None, (-0.25, 0.0, 0.0))


@pytest.mark.data
@pytest.mark.parametrize("take", ["alex_rom_3", "apfel", "S07-001"])
def test_eyes_of_real_takes_turn_where_their_coefficients_say(take: str) -> None:
    if not TAKES.exists():
        pytest.skip("needs ../shared/data")
    with (TAKES / f"{take}.csv").open() as file:
        rows = [row for row in csv.DictReader(file) if row["TongueOut"]][::10]  # others are of dropped frames
    names = {name.lower(): name for name in rows[0]}
    angles = "HeadYaw HeadPitch HeadRoll LeftEyeYaw LeftEyePitch LeftEyeRoll RightEyeYaw RightEyePitch RightEyeRoll"
    order = [*(names[name.lower()] for name in ARKIT_NAMES), *angles.split()]
    frames = [frame_of_values([float(row[name]) for name in order]) for row in rows]
    gaze = np.array([frame.gaze for frame in frames])
    assert np.corrcoef(gaze[:, 0], difference(frames, "eyeLookOutLeft", "eyeLookInLeft"))[0, 1] > 0.9
    assert np.corrcoef(gaze[:, 0], difference(frames, "eyeLookInRight", "eyeLookOutRight"))[0, 1] > 0.9
    assert np.corrcoef(gaze[:, 1], difference(frames, "eyeLookUpLeft", "eyeLookDownLeft"))[0, 1] > 0.9


def difference(frames: list[TrackerFrame], more: str, less: str) -> list[float]:
    """How much more of one coefficient there is than of another, frame by frame."""
    return [frame.weights[more] - frame.weights[less] for frame in frames]
