"""The paper's frozen-slot engine and the weight vectors are one and the same (docs/method.md, "Weights are enough")."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from omote.model.cast import Cast
from omote.model.transfer.compound import compound
from omote.perform.axis import Axis, slot_rates, slots, weights
from omote.perform.mix import Weights
from omote.perform.performer import Performer
from omote.perform.snapshot import Snapshot
from tests.conftest import Command, random_moves
from tests.perform.frozen_slots import FrozenSlots
from tests.synthetic import EXPRESSIONS, FACES

SOME = slice(None, None, 9)


@pytest.fixture(scope="module")
def compounds(cast: Cast) -> NDArray[np.float64]:
    """(faces, expressions, some vertices, 3)."""
    return np.array(
        [[compound(cast.space, cast.faces[i], cast.expressions[j])[SOME] for j in EXPRESSIONS] for i in FACES],
        np.float64,
    )


def blended(compounds: NDArray[np.float64], faces: Weights, expressions: Weights) -> NDArray[np.float64]:
    s = np.array([faces.get(name, 0.0) for name in FACES])
    t = np.array([expressions.get(name, 0.0) for name in EXPRESSIONS])
    result: NDArray[np.float64] = np.einsum("i,j,ijvc->vc", s, t, compounds)
    return result


def follow(engine: FrozenSlots, command: Command, before: Snapshot) -> None:
    """What the paper's engine does at a call; T-bars reach it only as slot weights."""
    axis = {"call_face": before.face, "call_expression": before.expression}.get(command.name)
    if axis is not None:
        getattr(engine, command.name)(command.arguments[0], slots(axis), slot_rates(axis))


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=8)
def test_a_thousand_calls_and_fader_moves_leave_both_engines_at_the_same_place(
    cast: Cast, compounds: NDArray[np.float64], seed: int
) -> None:
    performer = Performer(cast)
    engine = FrozenSlots(compounds, FACES, EXPRESSIONS, "generic", "neutral")
    farthest = 0.0
    for command in random_moves(seed, 1000):
        follow(engine, command, performer.snapshot())
        command.play(performer)
        frame = performer.advance(command.wait)
        now = performer.snapshot()
        there = engine.positions(slots(now.face), slots(now.expression))
        farthest = max(farthest, np.abs(there - blended(compounds, frame.faces, frame.expressions)).max())
    assert farthest < 1e-6


def test_the_freeze_itself_moves_nothing(cast: Cast, compounds: NDArray[np.float64]) -> None:
    engine = FrozenSlots(compounds, FACES, EXPRESSIONS, "generic", "neutral")
    engine.call_face("broad", slots(Axis("generic")), slot_rates(Axis("generic")))
    before = engine.positions((0.4, 0.6, 0.1), (0.0, 1.0, 0.0))
    engine.call_face("long", (0.4, 0.6, 0.1), (-1.0, 1.0, 0.0))
    assert engine.positions((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)) == pytest.approx(before, abs=1e-15)
    engine.call_expression("smile", (0.0, 1.0, 0.0), (0.0, 0.0, 0.0))
    assert engine.positions((1.0, 0.0, 0.0), (1.0, 0.0, 0.0)) == pytest.approx(before, abs=1e-15)


def test_freezing_at_s_and_fading_by_u_is_the_weight_vector_of_the_paper(compounds: NDArray[np.float64]) -> None:
    engine = FrozenSlots(compounds, FACES, EXPRESSIONS, "generic", "neutral")
    engine.call_face("broad", (0.0, 1.0, 0.0), (0.0, 0.0, 0.0))
    engine.call_face("long", (0.7, 0.3, 0.0), (0.0, 0.0, 0.0))
    u = 0.25
    expected = blended(compounds, {"generic": (1 - u) * 0.7, "broad": (1 - u) * 0.3, "long": u}, {"neutral": 1.0})
    assert engine.positions((1 - u, u, 0.0), (0.0, 1.0, 0.0)) == pytest.approx(expected, abs=1e-15)


def test_weights_at_rest_are_the_slots_at_rest() -> None:
    assert weights(Axis("long")) == {"long": 1.0}
    assert tuple(slots(Axis("long"))) == (0.0, 1.0, 0.0)


def test_compounds_of_another_shape_are_refused(compounds: NDArray[np.float64]) -> None:
    with pytest.raises(ValueError, match=r"for 2 faces and 12 expressions; expected \(faces, expressions, V, 3\)"):
        FrozenSlots(compounds, FACES[:2], EXPRESSIONS, "generic", "neutral")
