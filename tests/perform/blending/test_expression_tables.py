"""The mix of fields: one expression alone is the compiled one; the mix is linear where nothing lands elsewhere."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.space.expression import Expression
from omote.model.space.face_fit import fit
from omote.model.transfer.paper_map import compile_expression, wear
from omote.perform.blending.expression_tables import ExpressionTables, tables_of
from tests.synthetic import EXPRESSIONS

FIELDS = ("dtheta", "dh", "ratio", "residual")
some = st.dictionaries(st.sampled_from(EXPRESSIONS), st.floats(-0.3, 1.0), min_size=1)


def mixed_field(cast: Cast, weights: dict[str, float]) -> Expression:
    """The sum of fields, in double precision and by hand."""
    total = {field: np.zeros_like(getattr(cast.expressions["neutral"], field)) for field in FIELDS}
    for name, weight in weights.items():
        worn = cast.expressions[name]
        for field in FIELDS:
            total[field] += weight * (getattr(worn, field) - (1.0 if field == "ratio" else 0.0))
    return Expression(total["dtheta"], total["dh"], 1.0 + total["ratio"], total["residual"])


@given(
    st.dictionaries(st.sampled_from(EXPRESSIONS), st.floats(-0.3, 1.0), min_size=1),
    st.sampled_from(["generic", "long"]),
)
def test_a_mix_is_the_compiled_sum_of_the_fields(cast: Cast, weights: dict[str, float], face: str) -> None:
    fitted = fit(cast.space, cast.faces[face])
    expected = wear(cast.space, fitted, compile_expression(cast.space, mixed_field(cast, weights)))
    assert wear(cast.space, fitted, ExpressionTables(cast.space, cast.expressions).mix(weights)) == pytest.approx(
        expected, abs=1e-6
    )


def test_nothing_mixed_is_the_face_itself(cast: Cast) -> None:
    fitted = fit(cast.space, cast.faces["long"])
    assert wear(cast.space, fitted, tables_of(cast).mix({})) == pytest.approx(fitted.positions, abs=1e-7)


def test_no_sum_of_fields_turns_a_radius_over(cast: Cast) -> None:
    shrunk = dict.fromkeys(("jawOpen", "smile", "browInnerUp"), -30.0)
    assert tables_of(cast).mix(shrunk).ratios.min() > 0.0
    assert np.isfinite(tables_of(cast).mix(shrunk).weights).all()


def test_each_cast_has_its_own(cast: Cast) -> None:
    assert tables_of(cast) is tables_of(cast)
    assert tables_of(cast.with_faces()) is not tables_of(cast)
