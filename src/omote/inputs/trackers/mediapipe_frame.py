"""Results of MediaPipe's face landmarker as JSON: its categories, and the matrix that turns its face model.

The document is what `JSON.stringify` gives of a result in a browser, or what a program in Python makes of its own:
lists of categories, rows of matrices, null. Each category has a name and a score. Of its 52 categories `_neutral` is
none of a face, and `tongueOut` does not exist.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, Any

import msgspec

from omote.inputs.trackers.head_angles import HeadAngles
from omote.inputs.trackers.loose_json import find_field, load_loosely, read_number, read_pairs
from omote.inputs.trackers.tracker_frame import (
    MOST_SHAPES,
    LeftOut,
    TrackerError,
    TrackerFrame,
    read_json,
    trim_subject,
)

NEUTRAL = "_neutral"
SIDE = 4
"""Rows of a matrix."""
LAST_ROW = [0.0, 0.0, 0.0, 1.0]
"""Of a matrix that turns and moves."""
NO_CATEGORIES = "the result has no categories with names; turn outputFaceBlendshapes on"
NO_TURN = "the matrix of the face turns nothing: its columns have no length"
LEAST_COLUMN = 1e-3


class Category(msgspec.Struct, frozen=True):
    """A coefficient, by the names of the browser (`categoryName`) and of Python (`category_name`)."""

    score: float
    category_name: str = ""
    browser_name: str = msgspec.field(default="", name="categoryName")

    @property
    def name(self) -> str:
        """The name of the coefficient."""
        return self.browser_name or self.category_name


class Classifications(msgspec.Struct, frozen=True):
    """The coefficients of one face."""

    categories: list[Category]


class Matrix(msgspec.Struct, frozen=True):
    """A matrix of four rows, column by column, of Python row by row."""

    data: Annotated[list[float], msgspec.Meta(min_length=SIDE * SIDE, max_length=SIDE * SIDE)]


class Landmarks(msgspec.Struct, frozen=True, rename="camel"):
    """A result: of each face its coefficients and its matrix. subject: whose face it is, where a page says so."""

    face_blendshapes: Annotated[list[Classifications], msgspec.Meta(max_length=16)]
    facial_transformation_matrixes: Annotated[list[Matrix], msgspec.Meta(max_length=16)] = []
    subject: str = ""
    timestamp: float | None = None


def decode_mediapipe(data: bytes) -> list[TrackerFrame]:
    """The frame of the first face of a result; one without a face says that nobody is seen. TrackerError where it is
    none."""
    result = read_json(Landmarks, data, "this is no result of MediaPipe", _read_loosely)
    subject = trim_subject(result.subject)
    time = None if result.timestamp is None else 0.001 * result.timestamp
    if not result.face_blendshapes:
        if find_field(load_loosely(data), "facelandmarks"):
            raise TrackerError(NO_CATEGORIES)
        return [TrackerFrame(found=False, time=time, subject=subject)]
    categories = result.face_blendshapes[0].categories[:MOST_SHAPES]
    weights = {category.name: category.score for category in categories if category.name and category.name != NEUTRAL}
    if not weights:
        raise TrackerError(NO_CATEGORIES)
    matrices = result.facial_transformation_matrixes
    head = _turn(matrices[0].data) if matrices else None
    left_out = (LeftOut("head", NO_TURN),) if matrices and head is None else ()
    return [TrackerFrame(weights, head, time=time, subject=subject, left_out=left_out)]


def _read_loosely(document: Any) -> Landmarks | None:
    """The result as a program in Python writes it: lists, rows, null, values that are no numbers."""
    absent = object()
    faces = find_field(document, "faceblendshapes", absent)
    if faces is absent and find_field(document, "facelandmarks", absent) is absent:
        return None
    listed = faces[0] if isinstance(faces, list) and faces else []
    listed = faces if find_field(listed, "categoryname") else find_field(listed, "categories", listed)
    scores = read_pairs(listed, "categoryname", "score")
    found = [Classifications([Category(score, name) for name, score in scores.items()])] if listed else []
    matrices = find_field(document, "facialtransformationmatrixes")
    turned = [Matrix(numbers)] if (numbers := _read_matrix(matrices)) else []
    time = find_field(document, "timestamp")
    subject = find_field(document, "subject")
    return Landmarks(
        found, turned, subject if isinstance(subject, str) else "", time if isinstance(time, float) else None
    )


def _read_matrix(matrices: Any) -> list[float]:
    """The numbers of the first of some matrices, column by column; none where it has others."""
    first = matrices[0] if isinstance(matrices, list) and matrices else None
    listed = find_field(first, "data", first)
    if isinstance(listed, dict):  # what JSON makes of a typed array
        listed = [*listed.values()]
    if isinstance(listed, list) and all(isinstance(row, list) and len(row) == SIDE for row in listed):
        rows = [[read_number(number) for number in row] for row in listed]
        if len(rows) == SIDE and (rows[3] == LAST_ROW or [row[3] for row in rows] != LAST_ROW):
            rows = [*map(list, zip(*rows, strict=True))]
        listed = [number for row in rows for number in row]
    numbers = [*map(read_number, listed)] if isinstance(listed, list) else []
    return numbers if len(numbers) == SIDE * SIDE else []


def _turn(numbers: Sequence[float]) -> HeadAngles | None:
    """The turn of a matrix: x to the performer's left, y up, z to the camera, as ours; its columns may be scaled. None
    where they have no length."""
    if [*numbers[3::SIDE]] != LAST_ROW and [*numbers[12:]] == LAST_ROW:  # row by row
        numbers = [number for row in range(SIDE) for number in numbers[row::SIDE]]
    columns = [numbers[SIDE * column : SIDE * column + 3] for column in range(3)]
    lengths = [math.hypot(*column) for column in columns]
    if not all(LEAST_COLUMN < length < math.inf for length in lengths):
        return None
    (_, left_up, _), (_, up_up, _), forward = (
        [component / n for component in c] for c, n in zip(columns, lengths, strict=True)
    )
    pitch = math.asin(max(-1.0, min(1.0, forward[1])))
    return math.atan2(forward[0], forward[2]), pitch, -math.atan2(left_up, up_up)
