"""Results of MediaPipe: golden ones of browsers, what programs in Python make of them, and damage."""

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
        (b'{"faceLandmarks":[[{"x":0.5}]],"faceBlendshapes":[]}', "outputFaceBlendshapes"),
        (b'{"face_landmarks":[[{"x":0.5}]]}', "outputFaceBlendshapes"),
    ],
)
def test_damage_is_rejected_with_a_reason(data: bytes, why: str) -> None:
    with pytest.raises(TrackerError, match=why):
        decode_mediapipe(data)


PYTHON = [{"index": 25, "score": 0.5, "display_name": "", "category_name": "jawOpen"}]


@pytest.mark.parametrize(
    "faces",
    [
        {"face_blendshapes": [PYTHON]},
        {"face_blendshapes": [{"categories": PYTHON}]},
        {"face_blendshapes": PYTHON},
        {"faceBlendshapes": [{"jawOpen": 0.5}]},
        {"faceBlendshapes": [[{"score": "0,5", "categoryName": "jawOpen"}, {"score": 1, "categoryName": None}]]},
    ],
)
@pytest.mark.parametrize("form", ["rows", "columns", "row by row", "typed array", "none"])
def test_a_result_as_a_program_in_python_writes_it_is_read(faces: dict[str, Any], form: str) -> None:
    head = (0.3, -0.2, 0.1)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = head_matrix(*head), (1.0, 2.0, -40.0)
    turns: dict[str, Any] = {
        "rows": [matrix.tolist()],
        "columns": [matrix.T.tolist()],
        "row by row": [{"rows": 4, "cols": 4, "data": matrix.ravel().tolist()}],
        "typed array": [{"data": {str(at): number for at, number in enumerate(matrix.T.ravel().tolist())}}],
        "none": None,
    }
    document = {**faces, "facial_transformation_matrixes": turns[form], "face_landmarks": [], "timestamp": None}
    (frame,) = decode_mediapipe(json.dumps(document).encode())
    assert frame.weights == {"jawOpen": 0.5}
    assert frame.head == (None if form == "none" else pytest.approx(head, abs=1e-6))


def test_rows_of_a_matrix_without_a_place_are_rows() -> None:
    matrix = np.eye(4)
    matrix[:3, :3] = head_matrix(0.3, -0.2, 0.1)
    document = {"face_blendshapes": [PYTHON], "facial_transformation_matrixes": [matrix.tolist()]}
    assert decode_mediapipe(json.dumps(document).encode())[0].head == pytest.approx((0.3, -0.2, 0.1), abs=1e-6)


@pytest.mark.parametrize("wrong", [None, float("nan"), "wide", 1e400])
def test_a_score_that_is_no_number_costs_itself(wrong: object) -> None:
    categories = [*CATEGORIES, {"score": wrong, "categoryName": "cheekPuff"}]
    (frame,) = decode_mediapipe(result(categories, matrix=[0.0] * 16))
    assert (frame.weights, frame.head) == ({"jawOpen": 0.5}, None)
    assert {name for name, _ in frame.left_out} == {"cheekPuff", "head"}


def test_a_name_of_a_stranger_costs_nothing_and_no_face_is_a_loss_in_python_too() -> None:
    (frame,) = decode_mediapipe(result([*CATEGORIES, {"score": 7.0, "categoryName": "x" * 81}]))
    assert frame.weights["jawOpen"] == 0.5
    for none in ("[]", "null"):
        assert not decode_mediapipe(f'{{"face_blendshapes":{none},"face_landmarks":{none}}}'.encode())[0].found
