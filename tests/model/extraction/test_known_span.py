"""The nearest sum of known expressions: found exactly, though part of the field is wrong."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.model.extraction.known_span import fit_known
from omote.model.space.expression import Expression

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
    found = min(sums, key=lambda each: float(np.abs(each.dh - meant.dh).max()))
    assert np.abs(found.dh - meant.dh).max() < 1e-6
    assert np.abs(found.dtheta - meant.dtheta).max() < 1e-5
    assert np.abs(found.ratio - meant.ratio).max() < 1e-5
    assert np.abs(found.residual - meant.residual).max() < 1e-6


def test_the_fewest_are_named_where_two_are_alike() -> None:
    """A unit and twice the same: the sum is the unit, whichever of them is taken."""
    smile = UNITS["mouthSmileLeft"]
    *_, found = fit_known(CAST.space, smile, [smile, smile, UNITS["jawOpen"]])
    assert np.abs(found.dh - smile.dh).max() < 1e-7


def test_where_nothing_known_moves_the_skin_the_sum_is_at_rest() -> None:
    (found,) = fit_known(CAST.space, UNITS["jawOpen"], [CAST.expressions["neutral"]])
    assert np.abs(found.dh).max() < 1e-6
    assert np.abs(found.ratio - 1.0).max() < 1e-6
