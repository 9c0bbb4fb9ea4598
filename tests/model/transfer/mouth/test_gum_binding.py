"""Gums go with their teeth: rigidly at the edges, with the lips at the lips."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.space.face_fit import fit
from omote.model.transfer.compound import move_parts
from omote.model.transfer.mouth.gum_binding import bind_to_gums, carry_bag, share_jaws
from omote.model.transfer.mouth.gum_line import find_gum_line
from omote.model.transfer.paper_map import compile_expression
from omote.model.transfer.pipeline import LINEAR_INNER_STAGES, transfer_expression
from tests.synthetic import space

CAST = omote.load_cast()
LINE = find_gum_line(CAST.space)
JAWS = ("jawOpen", "mouth-open", "laugh", "shout", "jawLeft", "mouthSmileLeft", "mouthPucker")


def test_shares_are_none_at_the_lips_and_whole_behind_the_gums() -> None:
    assert LINE is not None
    shares = np.stack(share_jaws(CAST.space, LINE))
    assert (shares >= 0).all()
    assert (shares.sum(axis=0) <= 1 + 1e-9).all()
    assert np.allclose(shares.sum(axis=0)[LINE.bag.distance > 0.028], 1.0)
    assert shares[:, LINE.bag.distance.argmin()].sum() < 0.1


@pytest.mark.parametrize("name", CAST.faces)
def test_lining_and_gum_stay_together_in_every_expression(name: str) -> None:
    """What holds the edge of a gum moves as that gum does, before the skin in front of it may push it back."""
    assert LINE is not None
    face = CAST.faces[name]
    fitted = fit(CAST.space, face)
    edge = np.flatnonzero(LINE.edge)
    for unit in JAWS:
        expression = CAST.expressions[unit]
        compiled = compile_expression(CAST.space, expression)
        skin = transfer_expression(CAST.space, face, compiled, LINEAR_INNER_STAGES).astype(np.float64)
        parts = move_parts(CAST.space, fitted, skin.astype(np.float32), expression.parts)
        teeth = LINE.gather(parts) - LINE.gather(fitted.parts)
        lining = (LINE.weights[..., None] * (skin - face.positions)[LINE.corners]).sum(axis=1)
        off = np.linalg.norm(lining - teeth, axis=1)[edge]
        assert np.quantile(off, 0.9) < 0.001, unit


def test_a_carried_displacement_moves_the_gums_with_the_teeth_and_leaves_all_other_skin() -> None:
    assert LINE is not None
    rng = np.random.default_rng(75)
    skin, teeth = rng.normal(0, 0.001, CAST.space.points.shape), CAST.space.parts["teeth_lower"].points
    turned = 0.1 * (teeth - teeth.mean(axis=0))[:, [0, 2, 1]] * [1, 1, -1]
    moved = carry_bag(CAST.space, skin[CAST.space.welded], turned)
    others = np.setdiff1d(CAST.space.welded, LINE.bag.vertices)
    assert np.array_equal(moved[others], skin[CAST.space.welded][others])
    lower = LINE.edge & (LINE.names == "teeth_lower")
    lining = (LINE.weights[..., None] * moved[LINE.corners]).sum(axis=1)[lower]
    assert np.quantile(np.linalg.norm(lining - turned[LINE.rows[lower]], axis=1), 0.9) < 0.0005


def test_weights_of_the_inner_skin_sum_to_what_does_not_stay() -> None:
    inner = CAST.space.inner
    sums = inner.weights.sum(axis=1)
    assert (sums <= 1 + 1e-5).all()
    outside = ~np.isin(CAST.space.welded[inner.vertices], LINE.bag.vertices if LINE else [])
    assert np.allclose(sums[outside], 1.0, atol=1e-5)


def test_a_space_without_gums_comes_back_as_it_is() -> None:
    assert bind_to_gums(space()) is space()
    displaced = np.ones_like(space().points)
    assert carry_bag(space(), displaced, np.zeros((3, 3))) is displaced
