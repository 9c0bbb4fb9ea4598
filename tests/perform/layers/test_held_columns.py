"""What hands hold is there at once where nothing plays below, and keeps its value while it is let go."""

from omote.model.cast import Cast
from omote.perform.frame import Held
from omote.perform.layers.held_columns import are_hands_settled, hold_by
from omote.perform.layers.layers import begin


def test_a_hand_is_immediate_where_nothing_plays(cast: Cast) -> None:
    layers = hold_by(cast, begin(cast, Held()), Held({"jawOpen": 0.5}))
    place = layers.columns.index["jawOpen"]
    assert layers.columns.rows(layers.second, "hands")[place] == 0.5
    assert layers.columns.rows(layers.second, "hold")[place] == 1.0
    assert are_hands_settled(layers)


def test_what_is_let_go_keeps_its_value(cast: Cast) -> None:
    layers = hold_by(cast, begin(cast, Held({"jawOpen": 0.5})), Held())
    place = layers.columns.index["jawOpen"]
    assert layers.columns.rows(layers.goal, "hold")[place] == 0.0
    assert layers.columns.rows(layers.goal, "hands")[place] == 0.5
