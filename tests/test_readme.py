"""The Python example of the README runs, and gives what its comments say."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

README = (Path(__file__).parent.parent / "README.md").read_text()


@pytest.fixture(scope="module")
def names() -> dict[str, Any]:
    """What the example leaves behind."""
    (example,) = re.findall(r"^```python\n(.*?)^```", README, re.MULTILINE | re.DOTALL)
    left: dict[str, Any] = {}
    exec(compile(example, "README.md", "exec"), left)
    return left


def test_the_frame_is_on_its_way(names: dict[str, Any]) -> None:
    frame = names["frame"]
    assert sum(frame.faces.values()) == pytest.approx(1)
    assert {"generic", "round"} <= frame.faces.keys()
    assert frame.channels["jawOpen"] == 0.4


def test_positions_are_finite_and_in_metres(names: dict[str, Any]) -> None:
    assert np.isfinite(names["points"]).all()
    assert 0.2 < np.ptp(names["points"], axis=0)[1] < 0.5
    assert {"eye_left", "teeth_lower", "tongue", "lashes"} <= names["parts"].keys()


def test_an_expression_comes_off_one_face_and_goes_onto_another(names: dict[str, Any]) -> None:
    again = names["omote"].compound(names["cast"].space, names["cast"].faces["kaori"], names["smile"])
    np.testing.assert_allclose(again, names["smiling"], atol=1e-5)
    assert 1e-3 < np.abs(names["on_old"] - names["cast"].faces["old"].positions).max() < 0.05


def test_any_head_may_be_the_generic_face(names: dict[str, Any]) -> None:
    assert len(names["space"].skin_triangles) > 0.5 * len(names["space"].triangles)
