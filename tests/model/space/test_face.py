"""Faces: frozen, checked, brought to where the generic one stands."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.space.face import Face
from tests.synthetic import head


def test_a_face_keeps_a_copy_nobody_can_write() -> None:
    points = head()[0]
    face = Face("a", points)
    points[0] = 9.0
    assert face.positions[0, 0] != 9.0
    assert face.positions.dtype == np.float32
    with pytest.raises(ValueError, match="read-only"):
        face.positions[0] = 0.0


def test_faces_are_refused() -> None:
    with pytest.raises(ValueError, match="a face is named ''"):
        Face("", np.zeros((4, 3)))
    with pytest.raises(ValueError, match=r"positions of face 'a' has shape \(4, 2\)"):
        Face("a", np.zeros((4, 2)))
    with pytest.raises(ValueError, match=r"positions of face 'a'\[0\]"):
        Face("a", np.full((4, 3), np.nan))
    with pytest.raises(ValueError, match="part 'eye' of face 'a' has no numbers but NoneType"):
        Face("a", np.zeros((4, 3)), {"eye": None})  # type: ignore[dict-item]
    with pytest.raises(TypeError, match="parts of face 'a' are a NoneType; expected a mapping"):
        Face("a", np.zeros((4, 3)), None)  # type: ignore[arg-type]
    for name in ("x" * 81, "a\nb", "\ud800", 3):
        with pytest.raises(ValueError, match=r"a face is named .*; expected a text of 1 to 80 printable characters"):
            Face(name, np.zeros((4, 3)))  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="part 'eye' of face 'a'"):
        Face("a", np.zeros((4, 3)), {"eye": np.full((1, 3), np.inf)})
