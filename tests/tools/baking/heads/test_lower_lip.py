"""The lower lip of the open jaw is round, and nothing else has changed."""

import numpy as np
import pytest

import omote
from omote.model.space.lid_lip_lines import chains
from tools.baking.expressions import PERFORMED, unit_weights
from tools.baking.heads.lower_lip import ROUND, measure_missing_drop, round_lower_lip
from tools.baking.heads.moves import Move, compose

X = np.linspace(-0.02, 0.02, 21)
LINE = np.stack([X, 0.0 * X, 0.0 * X], axis=1)


def dropped(drop: np.ndarray) -> np.ndarray:
    return np.stack([0.0 * X, -drop, 0.0 * X], axis=1)


def test_a_pointed_lip_lacks_what_a_round_one_has() -> None:
    half = np.abs(X) / 0.02
    pointed = 0.01 + 0.02 * (1.0 - half)
    round_ = 0.01 + 0.02 * (1.0 - half**ROUND)
    np.testing.assert_allclose(pointed + measure_missing_drop(LINE, dropped(pointed)), round_, atol=1e-12)
    np.testing.assert_allclose(measure_missing_drop(LINE, dropped(round_)), 0.0, atol=1e-12)
    assert not measure_missing_drop(LINE, dropped(np.full_like(X, 0.03))).any()


def test_the_lower_lip_alone_is_rounded_and_in_performed_expressions_too(moves: dict[str, Move]) -> None:
    space = omote.load_cast().space
    upper, lower = chains(space.points, space.welded[next(line.loop for line in space.lines if line.kind == "lips")])
    rounded = round_lower_lip(space, moves)
    more = rounded["jawOpen"].skin - moves["jawOpen"].skin
    assert np.abs(more[[*upper, lower[len(lower) // 2]]]).max() < 1e-3
    assert more[lower, 1].min() < -0.002
    assert (more[:, 1] <= 0).all()
    assert not more[:, [0, 2]].any()
    assert rounded["mouthFunnel"].skin == pytest.approx(moves["mouthFunnel"].skin, abs=0)
    for name in ("laugh", "smile"):
        parts = unit_weights(PERFORMED[name])
        np.testing.assert_allclose(rounded[name].skin, compose(rounded, parts).skin, atol=1e-12)
