"""What is called of a figure: bodies of faces and apart, and rest."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

import omote
from omote.builtin import load_figures
from omote.perform.axis import called
from omote.perform.figures.figure_axes import AT_REST, FACES_OWN, FigureAxes, advance_figure, halt_figure, mixed_bodies

FIGURES = load_figures()
CAST = omote.load_cast()


@given(st.dictionaries(st.sampled_from([*CAST.faces]), st.floats(0.1, 1.0), min_size=1, max_size=3))
def test_faces_bring_their_bodies_and_one_called_apart_stays(faces: dict[str, float]) -> None:
    known = FIGURES.bodies
    assert mixed_bodies({FACES_OWN: 1.0}, faces, known) == pytest.approx(faces)
    assert mixed_bodies({"heavy": 1.0}, faces, known) == {"heavy": 1.0}
    assert set(mixed_bodies({FACES_OWN: 1.0}, {"unknown": 1.0}, known)) == {next(iter(known))}


def test_a_figure_at_rest_is_none_and_one_that_halts_stays() -> None:
    assert advance_figure(None, 1.0) is None
    assert advance_figure(AT_REST, 1.0) is None
    assert halt_figure(None, 0.25) is None
    moving = advance_figure(FigureAxes(called(AT_REST.pose, "bow", 1.0, "smooth")), 0.5)
    still = advance_figure(halt_figure(moving, 0.25), 1.0)
    assert still == advance_figure(still, 1.0)
