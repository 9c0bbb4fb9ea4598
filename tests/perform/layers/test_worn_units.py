"""How much of a unit an expression wears: all of itself, none of what moves elsewhere, and never beyond 0 to 1."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.layers.worn_units import worn_by, worn_share
from tests.synthetic import EXPRESSIONS

named = st.sampled_from(EXPRESSIONS)


def test_a_unit_wears_itself_and_neutral_wears_nothing(cast: Cast) -> None:
    jaw = cast.expressions["jawOpen"]
    assert worn_share(jaw, jaw) == pytest.approx(1.0)
    assert worn_share(jaw, cast.expressions["neutral"]) == 0.0
    half = replace(jaw, dtheta=jaw.dtheta / 2, dh=jaw.dh / 2, ratio=1.0 + (jaw.ratio - 1.0) / 2)
    assert worn_share(jaw, half) == pytest.approx(0.5)


@given(st.dictionaries(named, st.floats(-0.1, 1.1), max_size=4), named)
def test_it_is_a_share(cast: Cast, mix: dict[str, float], unit: str) -> None:
    assert 0.0 <= worn_by(cast.expressions[unit], mix, cast.expressions) <= 1.0
