"""The mouth of a new face at rest: put in order once, and then it stays."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.recipes.face_handles import default_handles, drag_handles
from omote.model.sculpting.caricature import caricature
from omote.model.sculpting.regions import regional
from omote.model.sculpting.sculpt import Sculpt, sculpted
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.transfer.mouth.gum_line import find_gum_line, measure_gums
from omote.model.transfer.mouth.lip_closure import measure_slits
from omote.model.transfer.mouth.mouth_at_rest import FLOATING, SHALLOW, fit_mouth_at_rest, mend_mouth
from omote.model.transfer.mouth_bag import find_mouth_bag
from omote.model.transfer.mouth_bag_fit import measure_shallow
from tests.synthetic import space

CAST = omote.load_cast()


@pytest.mark.parametrize("name", ["kaori", "man", "count"])
def test_only_lips_and_bag_of_a_face_change_and_hardly_any_more_once_they_are_in_order(name: str) -> None:
    face, bag = CAST.faces[name], find_mouth_bag(CAST.space)
    assert bag is not None
    again = fit_mouth_at_rest(CAST.space, face.positions, face.parts)
    outside = ~np.isin(CAST.space.welded, bag.vertices)
    assert np.abs(again - face.positions)[outside].max() < 1e-7
    assert np.quantile(np.abs(again - face.positions).max(axis=1)[~outside], 0.9) < 0.002


def test_a_head_without_a_mouth_stays() -> None:
    positions = space().points.astype(np.float32)
    assert np.array_equal(fit_mouth_at_rest(space(), positions, {}), positions)


def made_at_run_time() -> list[Face]:
    """A caricature, a face with another's mouth, a dragged one and a sculpt."""
    faces, space = CAST.faces, CAST.space
    lips = next(line.loop for line in space.lines if line.kind == "lips")
    rows = [handle.row for handle in default_handles(space)]
    moves = np.zeros((len(rows), 3))
    moves[np.linalg.norm(space.points[rows] - space.points[lips].mean(axis=0), axis=1) < 0.03, 1] = -0.012
    points = np.array([[0, -0.1, 0.148], [0.08, 0, 0.04], [0, 0.12, 0.04], [0, -0.13, -0.02], [0, -0.035, 0.168]])
    sculpt = Sculpt("long", points, np.array([[0, -0.02, 0.01], *np.zeros((4, 3))]))
    return [
        caricature(space, faces["dog"], 1.5),
        regional(space, "hers", {"mouth": faces["dog"], "jaw": faces["dog"]}, rest=faces["kaori"]),
        drag_handles(space, faces["kaori"], "dragged", rows=rows, moves=moves),
        sculpted(space, sculpt),
    ]


def test_the_mouth_of_a_face_made_at_run_time_is_in_order() -> None:
    """Lips meet, gums end at the bag, crowns are in the mouth and the bag behind the skin, as on the cast."""
    line = find_gum_line(CAST.space)
    assert line is not None
    for face in made_at_run_time():
        edges, crowns = measure_gums(line, face.positions.astype(np.float64), fit(CAST.space, face).parts)
        assert measure_slits(CAST.space, face.positions).max() == 0.0, face.name
        assert np.quantile(edges, 0.9) < FLOATING, face.name
        assert crowns.min() > -0.0005, face.name
        assert measure_shallow(CAST.space, face.positions) < SHALLOW, face.name


@pytest.mark.parametrize("name", CAST.faces)
def test_a_face_whose_mouth_is_in_order_comes_back_itself(name: str) -> None:
    assert mend_mouth(CAST.space, CAST.faces[name]) is CAST.faces[name]
