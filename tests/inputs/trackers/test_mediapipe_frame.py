"""Results of MediaPipe: golden ones of browsers and of Python, and every damage is rejected."""

import json
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.trackers.mediapipe_frame import decode_mediapipe
from omote.inputs.trackers.tracker_frame import TrackerError
from tests.inputs.trackers.packets import head_matrix

ANGLE = st.floats(-1.4, 1.4)
CATEGORIES = [
    {"index": 0, "score": 0.9, "categoryName": "_neutral", "displayName": ""},
    {"index": 25, "score": 0.5, "categoryName": "jawOpen", "displayName": ""},
]


def result(categories: list[Any] | None = None, matrix: list[float] | None = None, **more: Any) -> bytes:
    faces = [{"categories": CATEGORIES if categories is None else categories, "headIndex": -1, "headName": ""}]
    turns = [] if matrix is None else [{"rows": 4, "columns": 4, "data": matrix}]
    return json.dumps(
        {"faceLandmarks": [], "faceBlendshapes": faces, "facialTransformationMatrixes": turns, **more}
    ).encode()


def test_a_result_of_a_browser_is_read_by_name() -> None:
    (frame,) = decode_mediapipe(result(timestamp=1500.0, subject="Ada"))
    assert (frame.weights, frame.head, frame.time, frame.subject) == ({"jawOpen": 0.5}, None, 1.5, "Ada")


def test_a_result_of_python_is_read_too() -> None:
    (frame,) = decode_mediapipe(result([{"score": 0.25, "category_name": "browDownLeft"}]))
    assert frame.weights == {"browDownLeft": 0.25}


@given(st.tuples(ANGLE, ANGLE, ANGLE), st.floats(0.5, 2.0))
def test_its_matrix_turns_the_head(head: tuple[float, float, float], scale: float) -> None:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = scale * head_matrix(*head), (1.0, 2.0, -40.0)
    (frame,) = decode_mediapipe(result(matrix=matrix.T.ravel().tolist()))
    assert frame.head == pytest.approx(head, abs=1e-6)


def test_no_face_is_a_loss() -> None:
    assert not decode_mediapipe(b'{"faceBlendshapes":[]}')[0].found


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "no result"),
        (b"{}", "faceBlendshapes"),
        (b"\xff", "no result"),
        (b"[" * 100_000, "no result"),
        (result([]), "no categories"),
        (result([{"score": 2.0, "categoryName": "jawOpen"}]), "jawOpen is 2"),
        (result(matrix=[0.0] * 16), "turns nothing"),
        (result(matrix=[0.0] * 15), "no result"),
    ],
)
def test_damage_is_rejected_with_a_reason(data: bytes, why: str) -> None:
    with pytest.raises(TrackerError, match=why):
        decode_mediapipe(data)
