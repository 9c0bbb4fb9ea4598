"""One column for each channel and angle; under other columns every follower keeps where it is."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.layers.columns import ANGLES, PLACES, SECTIONS, make_columns, moved_to
from omote.perform.layers.layer_names import DRIVEN, LAYERS
from tests.synthetic import EXPRESSIONS

some = st.sets(st.sampled_from(EXPRESSIONS[1:]))


def test_every_follower_lies_in_one_section(cast: Cast) -> None:
    columns = make_columns(cast, ["smile"])
    counts = np.zeros(columns.size)
    for section in SECTIONS:
        counts[columns.sections[section]] += 1
    assert (counts == 1.0).all()
    assert columns.rows(counts, "streams").shape == (len(DRIVEN), columns.width)
    assert columns.rows(counts, "share").shape == (len(LAYERS), PLACES)
    assert columns.rows(counts, "trust").shape == (len(DRIVEN), PLACES)
    assert len(columns.parts) == columns.width == len(columns.names) + len(ANGLES)


@given(some, some, st.integers(0, 2**31))
def test_what_two_columns_share_moves_there_and_back(cast: Cast, before: set[str], added: set[str], seed: int) -> None:
    old = make_columns(cast, before)
    new = make_columns(cast, before | added)
    vector = 0.5 * np.random.default_rng(seed).random(old.size)  # in the range of every column
    assert np.array_equal(moved_to(moved_to(vector, old, new), new, old), vector)


def test_what_the_cast_has_not_is_left_out(cast: Cast) -> None:
    assert make_columns(cast, ["gone", "smile"]).names == make_columns(cast, ["smile"]).names
