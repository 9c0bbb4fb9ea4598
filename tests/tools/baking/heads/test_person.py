"""MakeHuman's sliders as weights of targets."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Look
from tools.baking.heads.people import PEOPLE
from tools.baking.heads.person import Build, Person, target_weights

LOOK = {"skin": "#ffffff", "lip": "#ffffff", "brow": "#ffffff", "blush": "#ffffff", "iris": "#ffffff"}
slider = st.floats(0.0, 1.0)


@given(slider, slider, slider, slider)
def test_the_combination_targets_share_the_whole(gender: float, age: float, muscle: float, weight: float) -> None:
    build = Build(gender, age, muscle, weight, {"asian": 0.25, "african": 0.75})
    weights = target_weights(Person(look=LOOK, build=build))
    universal = [w for name, w in weights.items() if "universal" in name]
    races = [w for name, w in weights.items() if "universal" not in name]
    assert math.isclose(sum(universal), 1.0)
    assert math.isclose(sum(races), 1.0)
    assert all(w >= 0 for w in weights.values())


def test_a_named_anchor_takes_one_target_each() -> None:
    weights = target_weights(Person(look=LOOK, build=Build(gender=1.0, age=1.0, muscle=1.0, weight=0.0)))
    assert weights == {
        "macrodetails/caucasian-male-old": 1.0,
        "macrodetails/universal-male-old-maxmuscle-minweight": 1.0,
    }


def test_a_star_stands_for_left_and_right() -> None:
    weights = target_weights(Person(look=LOOK, shape={"ears/*-ear-wing-incr": 0.5, "head/head-oval": 1.0}))
    assert weights == {"ears/l-ear-wing-incr": 0.5, "ears/r-ear-wing-incr": 0.5, "head/head-oval": 1.0}


@pytest.mark.parametrize("age", [-0.1, 1.2])
def test_sliders_beyond_their_anchors_are_refused(age: float) -> None:
    with pytest.raises(ValueError, match=rf"a slider stands at {age}, expected 0 to 1"):
        target_weights(Person(look=LOOK, build=Build(age=age)))


def test_the_generic_face_is_the_base_mesh_itself() -> None:
    assert target_weights(PEOPLE["generic"]) == {}
    assert PEOPLE["generic"].size == 1.0


def test_every_person_has_five_colours() -> None:
    for person in PEOPLE.values():
        assert set(LOOK) <= set(person.look) <= set(Look.__dataclass_fields__)
