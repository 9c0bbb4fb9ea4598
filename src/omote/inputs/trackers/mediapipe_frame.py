"""Results of MediaPipe's face landmarker as JSON: its categories, and the matrix that turns its face model.

The document is what `JSON.stringify` gives of a result in a browser, or the same with Python's names: each category has
a name and a score. Of its 52 categories `_neutral` is none of a face, and `tongueOut` does not exist.
"""

from __future__ import annotations

import math
from typing import Annotated

import msgspec

from omote.inputs.trackers.head_angles import HeadAngles
from omote.inputs.trackers.tracker_frame import TrackerError, TrackerFrame, read_json, trim_subject

MOST_CATEGORIES = 256
NEUTRAL = "_neutral"
SIDE = 4
"""Rows of a matrix; its numbers come column by column."""
LEAST_COLUMN = 1e-3


class Category(msgspec.Struct, frozen=True):
    """A coefficient, by the names of the browser (`categoryName`) and of Python (`category_name`)."""

    score: float
    category_name: Annotated[str, msgspec.Meta(max_length=80)] = ""
    browser_name: Annotated[str, msgspec.Meta(max_length=80)] = msgspec.field(default="", name="categoryName")

    @property
    def name(self) -> str:
        """The name of the coefficient."""
        return self.browser_name or self.category_name


class Classifications(msgspec.Struct, frozen=True):
    """The coefficients of one face."""

    categories: Annotated[list[Category], msgspec.Meta(max_length=MOST_CATEGORIES)]


class Matrix(msgspec.Struct, frozen=True):
    """A matrix of four rows, column by column."""

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
    result = read_json(Landmarks, data, "this is no result of MediaPipe")
    subject = trim_subject(result.subject)
    time = None if result.timestamp is None else 0.001 * result.timestamp
    if not result.face_blendshapes:
        return [TrackerFrame(found=False, time=time, subject=subject)]
    categories = result.face_blendshapes[0].categories
    weights = {category.name: category.score for category in categories if category.name and category.name != NEUTRAL}
    if not weights:
        raise TrackerError("the result has no categories with names; turn outputFaceBlendshapes on")
    matrices = result.facial_transformation_matrixes
    return [TrackerFrame(weights, _turn(matrices[0]) if matrices else None, time=time, subject=subject)]


def _turn(matrix: Matrix) -> HeadAngles:
    """The turn of a matrix: x to the performer's left, y up, z to the camera, as ours; its columns may be scaled."""
    columns = [matrix.data[SIDE * column : SIDE * column + 3] for column in range(3)]
    lengths = [math.hypot(*column) for column in columns]
    if not all(LEAST_COLUMN < length < math.inf for length in lengths):
        raise TrackerError("the matrix of the face turns nothing: its columns have no length")
    (_, left_up, _), (_, up_up, _), forward = (
        [component / n for component in c] for c, n in zip(columns, lengths, strict=True)
    )
    pitch = math.asin(max(-1.0, min(1.0, forward[1])))
    return math.atan2(forward[0], forward[2]), pitch, -math.atan2(left_up, up_up)
