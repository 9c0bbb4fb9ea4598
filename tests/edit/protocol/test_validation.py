"""Validation: recipes pass unchanged, or are rejected with an error message that names what and where."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from omote.edit.protocol.validation import (
    DH,
    DTHETA,
    FEWEST_POINTS,
    MOST_LAYERS,
    MOST_POINTS,
    RATIO,
    Bounds,
    check_net,
    check_recipe,
    check_targets,
    check_vectors,
)
from omote.model.recipes.recipe import FaceRecipe, GainRow, Layer, Pull, Recipe
from omote.show.validation import Refusal

BOUNDS = Bounds(np.arange(1000) < 900, frozenset({"smiler", "frowner"}), frozenset({"bob", "crop"}))
REST = (0.0, 0.0, 1.0)
GOOD = Recipe(
    net=(0, 5, 7),
    vectors=(REST, (0.1, -0.01, 1.2), REST),
    layers=(Layer("smile", "Smile", 0.5, "mouth", True),),
    pulls=(Pull("smiler", 0.3),),
    eyes=(0.1, 0.0, 0.1, 0.0),
    pupil=0.5,
)
FACE = FaceRecipe({"generic": 0.7, "broad": 0.3}, {"mouth": "broad"}, 1.2, (999, 3), ((0.0, 0.1, 0.0), (0.0, 0.0, 0.0)))
STRANGE = [math.nan, math.inf, -math.inf, 1e308]


def test_good_recipes_pass() -> None:
    check_recipe(GOOD, BOUNDS)
    check_recipe(FACE, BOUNDS)
    for style in ("", "bob", "crop"):
        check_recipe(replace(FACE, look={"hair_style": style, "hair": "#302010", "freckles": 0.4}), BOUNDS)


@given(st.lists(st.tuples(*[st.floats(q.low, q.high) for q in (DTHETA, DH, RATIO)]), min_size=3, max_size=9))
def test_every_vector_in_range_passes(vectors: list[tuple[float, float, float]]) -> None:
    check_vectors(vectors, range(len(vectors)))


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"net": (0, 5)}, "2 control points: a net has 3 to 400"),
        ({"net": tuple(range(MOST_POINTS + 1))}, "a net has 3 to 400"),
        ({"net": (0, 5, 5)}, "two control points stand on vertex 5"),
        ({"net": (0, 5, -1)}, "vertex -1: the skin has vertices 0 to 999"),
        ({"net": (0, 5, 1000)}, "vertex 1000: the skin has vertices 0 to 999"),
        ({"net": (0, 5, 950)}, "vertex 950, off the sheet"),
        ({"vectors": (REST,) * 4}, "4 vectors for 3 control points"),
        *[({"vectors": (REST, (x, 0.0, 1.0), REST)}, "dtheta") for x in (*STRANGE, 3.2)],
        *[({"vectors": (REST, (0.0, x, 1.0), REST)}, "dh") for x in (*STRANGE, -0.6)],
        *[({"vectors": (REST, (0.0, 0.0, x), REST)}, "R of a control point") for x in (*STRANGE, 0.0, -1.0)],
        *[({"layers": (Layer("smile", "Smile", x),)}, "a weight") for x in (*STRANGE, 2.1)],
        ({"layers": (Layer("smile", "Smile", 1.0, "tail"),)}, "no region 'tail': choose from brows"),
        ({"layers": (Layer("smile", "a\nb"),)}, "printable"),
        ({"layers": (Layer("smile", "Smile"),) * (MOST_LAYERS + 1)}, "201 layers: at most 200"),
        *[({"pulls": (Pull("smiler", x),)}, "contraction") for x in (*STRANGE, -1.1)],
        ({"pulls": (Pull("biter", 1.0),)}, "no muscle 'biter': choose from frowner, smiler"),
        ({"pulls": (Pull("smiler", 1.0), Pull("smiler", 0.5))}, "'smiler' is there twice"),
        *[({"eyes": (0.0, x, 0.0, 0.0)}, "an eyeball") for x in (*STRANGE, 1.6)],
        *[({"pupil": x}, "a pupil") for x in (*STRANGE, 2.5)],
    ],
)
def test_expressions_that_say_what_they_must_not_are_refused(change: dict[str, Any], sentence: str) -> None:
    with pytest.raises(Refusal, match=sentence):
        check_recipe(replace(GOOD, **change), BOUNDS)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"base": {}}, "sum to 0"),
        ({"base": {"generic": 0.5}}, "sum to 0.5: a mix of faces sums to 1"),
        *[({"base": {"generic": x}}, "a weight") for x in STRANGE],
        ({"regions": {"tail": "broad"}}, "no region"),
        *[({"amount": x}, "caricature") for x in (*STRANGE, 9.0)],
        ({"points": (3,)}, "2 moves for 1 handles"),
        ({"points": (3, 3)}, "two handles stand on vertex 3"),
        ({"points": (3, 1000)}, "a handle stands on vertex 1000"),
        ({"gains": (GainRow("tail", 1.0),)}, "a gain is of region 'tail'"),
        ({"gains": (GainRow("mouth", 1.0), GainRow("mouth", 2.0))}, "two gains of mouth for all expressions"),
        ({"gains": (GainRow("mouth", 1.0, "\n"),)}, "the expression of the gain of mouth is named"),
        ({"gains": (GainRow("mouth", 1.0),) * 401}, "401 gains"),
        *[({"gains": (GainRow("mouth", x),)}, "the gain of mouth is") for x in (*STRANGE, 4.1)],
        *[({"look": {"freckles": x}}, "freckles of a look is") for x in (*STRANGE, 1.1, "many")],
        ({"look": {"hair": "brown"}}, "hair of a look is 'brown'; expected a colour"),
        ({"look": {"hair": 0.5}}, "hair of a look is 0.5; expected a colour"),
        ({"look": {"hair_style": "beehive"}}, "no hair style 'beehive': choose from bob, crop"),
        ({"look": {"hair_style": 1.0}}, "hair_style of a look is 1.0; expected the name of a style"),
        ({"look": {"albedo": "x"}}, "a look has no 'albedo' to choose"),
        ({"look": {"beard": 1.0}}, "a look has no 'beard' to choose"),
        *[({"moves": ((x, 0.0, 0.0),) * 2}, "a handle's move") for x in (*STRANGE, 0.6)],
    ],
)
def test_faces_that_say_what_they_must_not_are_refused(change: dict[str, Any], sentence: str) -> None:
    with pytest.raises(Refusal, match=sentence):
        check_recipe(replace(FACE, **change), BOUNDS)


@pytest.mark.parametrize("x", [*STRANGE, 1.01])
def test_points_are_not_dragged_out_of_reach(x: float) -> None:
    check_targets([(0.1, -0.9, 0.0)])
    with pytest.raises(Refusal, match="where a point is put"):
        check_targets([(0.0, 0.0, x)])


def test_a_net_has_at_least_a_triangle() -> None:
    check_net(range(FEWEST_POINTS), BOUNDS)
    with pytest.raises(Refusal, match="control points"):
        check_net(range(FEWEST_POINTS - 1), BOUNDS)
