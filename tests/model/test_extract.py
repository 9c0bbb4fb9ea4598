"""Extraction: what is no displacement of a face is refused; round trips are in test_transfer and test_compound."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from omote.model.extract import extract
from tests.synthetic import cast, space


def test_displacements_are_refused() -> None:
    face, count = cast().faces["generic"], space().vertex_count
    broken = np.zeros((count, 3))
    broken[4, 2] = np.inf
    with pytest.raises(ValueError, match=r"displacement\[4\]"):
        extract(space(), face, broken)
    with pytest.raises(ValueError, match=f"displacement has 5 rows; expected {count}"):
        extract(space(), face, np.zeros((5, 3)))
    with pytest.raises(ValueError, match="'beak'; expected one of"):
        extract(space(), face, np.zeros((count, 3)), parts={"beak": np.zeros((2, 3))})
    with pytest.raises(ValueError, match="part 'eye_left' has 2 rows"):
        extract(space(), face, np.zeros((count, 3)), parts={"eye_left": np.zeros((2, 3))})


@pytest.mark.parametrize("wrong", [None, np.zeros((3, 3)), "generic"])
def test_what_is_no_space_and_no_face_is_refused(wrong: Any) -> None:
    still, kind = np.zeros_like(space().points), type(wrong).__name__
    with pytest.raises(TypeError, match=f"the face is a {kind}; expected an omote.Face"):
        extract(space(), wrong, still)
    with pytest.raises(TypeError, match=f"the space is a {kind}; expected an omote.ParameterSpace"):
        extract(wrong, cast().faces["generic"], still)


@pytest.mark.parametrize(
    ("displacement", "sentence"),
    [
        (np.zeros_like(space().points, dtype=complex), "displacement has no numbers but complex128"),
        (np.zeros_like(space().points, dtype=bool), "displacement has no numbers but bool"),
        (np.full_like(space().points, 1e39), r"displacement\[0\] is .*at most 1e\+06 from zero"),
        ([[0, 0, 0], [1]], "displacement has rows of different lengths"),
    ],
)
def test_what_is_no_displacement_is_refused(displacement: Any, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        extract(space(), cast().faces["generic"], displacement)


def test_parts_that_are_no_mapping_are_refused() -> None:
    with pytest.raises(TypeError, match="parts is a list; expected a mapping"):
        extract(space(), cast().faces["generic"], np.zeros_like(space().points), parts=[1])  # type: ignore[arg-type]
