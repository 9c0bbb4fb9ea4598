"""What is on air as units: a sum of units is told as these, whoever sums them; others as the nearest."""

from dataclasses import replace

import numpy as np
import pytest

from omote.inputs.face_output.unit_weights import UnitWeights
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.model.cast import Cast
from omote.model.space.expression import Expression


def mixed(cast: Cast, **weights: float) -> Expression:
    """An expression that moves what units do, each by its weight."""
    units = [cast.expressions[name] for name in weights]
    shares = np.array(list(weights.values()))
    dtheta = shares @ np.stack([unit.dtheta for unit in units])
    dh = shares @ np.stack([unit.dh for unit in units])
    ratio = 1.0 + shares @ np.stack([unit.ratio - 1.0 for unit in units])
    return replace(cast.expressions["neutral"], dtheta=dtheta, dh=dh, ratio=ratio)


def moved(weights: dict[str, float]) -> dict[str, float]:
    return {name: weight for name, weight in weights.items() if weight}


def test_channels_are_told_as_they_are_within_0_and_1(cast: Cast) -> None:
    units = UnitWeights(cast.expressions)
    told = units.weigh({"neutral": 1.0}, {"jawOpen": 0.5, "smile": 1.0, "cheekPuff": -0.25, "mouthLeft": 1.25})
    assert list(told) == list(ARKIT_NAMES)
    assert moved(told) == {"jawOpen": 0.5, "mouthLeft": 1.0}


def test_a_unit_that_is_called_is_that_unit(cast: Cast) -> None:
    assert moved(UnitWeights(cast.expressions).weigh({"jawOpen": 0.75, "neutral": 0.25}, {})) == {"jawOpen": 0.75}


def test_an_expression_is_told_as_the_units_whose_sum_it_is(cast: Cast) -> None:
    named = {**cast.expressions, "grin": mixed(cast, jawOpen=0.5, browInnerUp=1.0)}
    told = UnitWeights(named).weigh({"grin": 0.5, "neutral": 0.5}, {"browInnerUp": 0.25})
    assert moved(told) == pytest.approx({"jawOpen": 0.25, "browInnerUp": 0.75}, abs=1e-3)


def test_what_no_unit_does_and_what_there_is_not_are_nothing(cast: Cast) -> None:
    against = {**cast.expressions, "shut": mixed(cast, jawOpen=-1.0)}
    assert moved(UnitWeights(against).weigh({"shut": 1.0, "gone": 1.0}, {})) == {}
    assert moved(UnitWeights({}).weigh({"smile": 1.0}, {"jawOpen": 1.0})) == {"jawOpen": 1.0}
