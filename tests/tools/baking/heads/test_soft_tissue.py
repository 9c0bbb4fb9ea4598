"""What hangs of a face moves to one side together, gently, and leaves lips, lids and parts alone."""

import numpy as np
import pytest

import omote
from tools.baking.expressions import SPRING_SKIN
from tools.baking.heads.soft_tissue import soft_gains, soft_moves

SPACE = omote.load_cast().space
MOVES = soft_moves(SPACE)


def test_there_is_a_move_for_each_that_springs_play() -> None:
    assert [*MOVES] == [*SPRING_SKIN]


@pytest.mark.parametrize(("name", "axis", "millimetres"), [("jowls-sway", 0, 3.2), ("cheeks-bounce", 1, 2.2)])
def test_both_sides_go_the_same_way(name: str, axis: int, millimetres: float) -> None:
    moved = 1000.0 * MOVES[name].skin
    others = [each for each in range(3) if each != axis]
    assert not moved[:, others].any()
    assert moved[:, axis].min() == 0.0
    left, right = (moved[side * SPACE.points[:, 0] > 0.02, axis].max() for side in (1.0, -1.0))
    assert left == pytest.approx(right, abs=1e-3)
    assert 0.9 * millimetres < left <= millimetres
    assert not any(part.any() for part in MOVES[name].parts.values())


def test_lips_hardly_move_and_lids_do_not() -> None:
    lines = {line.kind: SPACE.welded[line.loop] for line in SPACE.lines}
    for move in MOVES.values():
        assert np.abs(move.skin[lines["lids"]]).max() == 0.0
        assert np.abs(move.skin[lines["lips"]]).max() < 0.0012


def test_a_face_has_as_much_as_is_said_wherever_it_lies() -> None:
    gains = soft_gains(jowls=2.0, cheeks=0.5)
    assert {(gain.expression, gain.value) for gain in gains} == {("jowls-sway", 2.0), ("cheeks-bounce", 0.5)}
    assert {gain.region for gain in gains} == {"cheeks", "mouth", "jaw"}
