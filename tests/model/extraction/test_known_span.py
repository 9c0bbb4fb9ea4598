"""The nearest sum of known expressions: found exactly, though part of the field is wrong, and refined on a face."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.model.extraction.known_span import KnownSum, fit_known, refine_known
from omote.model.space.expression import Expression
from omote.model.transfer.compound import compound

CAST = omote.load_cast()
UNITS = {name: CAST.expressions[name] for name, title in CAST.titles.items() if title.kind in ("arkit", "makehuman")}


def add(weights: dict[str, float]) -> Expression:
    """The sum of units, each with its weight."""
    chosen = [(weight, UNITS[name]) for name, weight in weights.items()]
    return Expression(
        np.sum([weight * unit.dtheta for weight, unit in chosen], axis=0),
        np.sum([weight * unit.dh for weight, unit in chosen], axis=0),
        1.0 + np.sum([weight * (unit.ratio - 1.0) for weight, unit in chosen], axis=0),
        np.sum([weight * unit.residual for weight, unit in chosen], axis=0),
    )


@pytest.mark.parametrize(
    "weights", [{"jawOpen": 1.0}, {"mouthSmileLeft": 0.6, "eyeBlinkRight": 0.3, "mouth-open": 0.4}]
)
def test_a_sum_of_known_fields_is_found_though_a_corner_of_the_mouth_is_wrong(weights: dict[str, float]) -> None:
    """Outliers of 3 mm on every vertex within 15 mm of a point leave no trace of a micrometre."""
    meant = add(weights)
    corner = CAST.space.points[next(line for line in CAST.space.lines if line.kind == "lips").loop[0]]
    near = np.linalg.norm(CAST.space.points - corner, axis=1) < 0.015
    assert 40 < (near & CAST.space.on_sheet).sum() < 800
    sums = fit_known(CAST.space, replace(meant, dh=meant.dh + 0.003 * near), [*UNITS.values()])
    found = min((each.expression for each in sums), key=lambda each: float(np.abs(each.dh - meant.dh).max()))
    assert np.abs(found.dh - meant.dh).max() < 1e-6
    assert np.abs(found.dtheta - meant.dtheta).max() < 1e-5
    assert np.abs(found.ratio - meant.ratio).max() < 1e-5
    assert np.abs(found.residual - meant.residual).max() < 1e-6


def test_the_fewest_are_named_where_two_are_alike() -> None:
    """A unit and twice the same: the sum is the unit, whichever of them is taken."""
    smile = UNITS["mouthSmileLeft"]
    *_, found = fit_known(CAST.space, smile, [smile, smile, UNITS["jawOpen"]])
    assert np.abs(found.expression.dh - smile.dh).max() < 1e-7


def test_where_nothing_known_moves_the_skin_the_sum_is_at_rest() -> None:
    (found,) = fit_known(CAST.space, UNITS["jawOpen"], [CAST.expressions["neutral"]])
    assert (found.members, found.places) == ((), ())
    assert not found.expression.dh.any()
    assert (found.expression.ratio == 1.0).all()


def sum_up(*weights: float) -> KnownSum:
    """Of a smile, a blink and an open jaw."""
    names = ("mouthSmileLeft", "eyeBlinkRight", "jawOpen")
    return KnownSum(CAST.space, tuple(UNITS[name] for name in names), (0, 1, 2), np.array(weights))


def test_weights_are_refined_though_the_face_jumps_where_it_folds() -> None:
    """What the sum lacks is measured on the dog, which turns folds back, from two hundredths off."""
    face = CAST.faces["dog"]
    rows = CAST.space.on_sheet
    meant = sum_up(0.7, 0.4, 0.8)
    goal = compound(CAST.space, face, meant.expression)[rows].astype(np.float64)

    def measure_lack(each: KnownSum) -> np.ndarray:
        return goal - compound(CAST.space, face, each.expression)[rows]

    start = sum_up(0.72, 0.38, 0.79)
    assert np.abs(measure_lack(start)).max() > 3e-4
    found = refine_known(start, measure_lack)
    assert np.abs(found.share - meant.share).max() < 1e-5
    assert np.abs(measure_lack(found)).max() < 1e-6


def test_a_step_whose_slope_was_taken_across_a_jump_goes_on_as_far_as_it_helps() -> None:
    """A nudge past where a lid folds looks thirty times steeper: steps crept, and a blink stayed .006 mm off."""
    start = KnownSum(CAST.space, (CAST.expressions["eyeBlinkLeft"],), (0,), np.array([1.0006]))

    def measure_lack(each: KnownSum) -> np.ndarray:
        beyond = each.share[0] > start.share[0]
        return np.full((4, 3), 1.0 - each.share[0] - 0.006 * beyond)

    assert refine_known(start, measure_lack).share == pytest.approx([1.0], abs=1e-7)


def test_weights_that_lack_nothing_stay_and_a_refined_sum_never_lacks_more() -> None:
    start = sum_up(0.5, 0.5, 0.5)
    assert refine_known(start, lambda each: np.zeros((4, 3))) is start
    assert refine_known(start, lambda each: np.ones((4, 3))) is start
