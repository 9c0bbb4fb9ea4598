"""Parameters of VTube Studio: what it sends is read, and what we set is read back as it was."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.vtube_studio.api_parameters import (
    custom_name,
    read_parameters,
    write_custom,
    write_parameters,
)

REST = {"EyeOpenLeft": 0.5, "BrowLeftY": 0.5, "MouthSmile": 0.5, "Brows": 0.5, "MouthX": 0.0}


def test_a_face_at_rest_is_at_rest() -> None:
    frame = read_parameters({**REST, "MouthOpen": 0.0})
    assert set(frame.weights.values()) == {0.0}
    assert (frame.head, frame.gaze) == (None, None)


@pytest.mark.parametrize(
    ("name", "value", "expected"),
    [
        ("EyeOpenLeft", 0.0, {"eyeBlinkLeft": 1.0, "eyeWideLeft": 0.0}),
        ("EyeOpenRight", 1.0, {"eyeBlinkRight": 0.0, "eyeWideRight": 1.0}),
        ("BrowLeftY", 0.25, {"browDownLeft": 0.5, "browOuterUpLeft": 0.0}),
        ("MouthSmile", 0.75, {"mouthSmileLeft": 0.5, "mouthSmileRight": 0.5, "mouthFrownLeft": 0.0,
                              "mouthFrownRight": 0.0}),
        ("MouthX", -0.5, {"mouthLeft": 0.0, "mouthRight": 0.5}),
        ("MouthPucker", -0.5, {"mouthPucker": 0.5}),
        ("TongueOut", 7.0, {"tongueOut": 1.0}),
        ("OmoteTongueOut", 1.0, {}),
        ("MousePositionX", 1.0, {}),
        ("BrowInnerUp", 0.5, {"browInnerUp": 0.5}),
    ],
)  # fmt: skip
def test_a_parameter_says_what_its_maker_has_put_into_it(name: str, value: float, expected: dict[str, float]) -> None:
    assert read_parameters({name: value}).weights == pytest.approx(expected)


def test_of_two_that_open_the_mouth_the_larger_counts_and_coefficients_count_most() -> None:
    assert read_parameters({"MouthOpen": 0.2, "JawOpen": 0.6}).weights["jawOpen"] == 0.6
    assert read_parameters({"Brows": 1.0, "browInnerUp": 0.1}).weights["browInnerUp"] == 0.1


def test_angles_are_the_performer_s_own() -> None:
    frame = read_parameters(
        {"FaceAngleX": 20.0, "FaceAngleY": 10.0, "FaceAngleZ": 5.0, "EyeLeftX": 1.0, "EyeRightX": 0.5}
    )
    assert frame.head == pytest.approx((math.radians(-20), math.radians(10), math.radians(-5)))
    assert frame.gaze == pytest.approx((math.radians(-30), 0.0))


def test_what_is_no_number_is_left_out() -> None:
    assert read_parameters({"JawOpen": math.nan, "FaceAngleX": math.inf}).weights == {}


@given(
    st.lists(st.floats(0, 1), min_size=52, max_size=52),
    st.tuples(*[st.floats(-0.5, 0.5)] * 3),
    st.tuples(*[st.floats(-0.4, 0.4)] * 2),
)
def test_what_is_set_turns_as_ours_does_and_says_our_units(
    values: list[float], head: tuple[float, float, float], gaze: tuple[float, float]
) -> None:
    weights = dict(zip(ARKIT_NAMES, values, strict=True))
    frame = read_parameters(write_parameters(weights, head, gaze))
    assert frame.head == pytest.approx(head)
    assert frame.gaze == pytest.approx(gaze)
    assert frame.weights["jawOpen"] == pytest.approx(weights["jawOpen"])
    assert frame.weights["mouthPucker"] == pytest.approx(weights["mouthPucker"])
    assert write_custom(weights) == {custom_name(name): weight for name, weight in weights.items()}


def test_names_that_are_added_are_such_as_it_takes() -> None:
    for name in map(custom_name, ARKIT_NAMES):
        assert name.isalnum()
        assert 4 <= len(name) <= 32
