"""What VRM's expressions are made of: the right units on the right side, overrides where lids and lips go twice."""

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.interchange.avatar.preset_expressions import (
    EMOTIONS,
    PRESETS,
    UNITS,
    VOWELS,
    Overrides,
    custom_expressions,
    find_overrides,
    preset_weights,
    required_expressions,
)
from omote.interchange.export_face import SKIN, named_compound_meshes
from omote.model.cast import Cast
from omote.model.space.face_fit import fit
from omote.model.space.head_size import HEAD_METRES, head_height
from omote.model.space.parameter_space import ParameterSpace
from tests import synthetic
from tests.stage_data.heads import synthetic_cast


@pytest.fixture(scope="module")
def built_in() -> Cast:
    """The built-in cast; skipped where it was not baked."""
    return load_cast()


def test_there_are_the_presets_of_vrm_and_all_are_made_of_what_the_cast_has(built_in: Cast) -> None:
    emotions = "happy angry sad relaxed surprised"
    mouths = "aa ih ou ee oh"
    eyes = "blink blinkLeft blinkRight lookUp lookDown lookLeft lookRight"
    assert set(PRESETS) == {*emotions.split(), *mouths.split(), *eyes.split(), "neutral"}
    weights = preset_weights(built_in)
    assert [name for name, parts in weights.items() if not parts] == ["neutral"]
    assert all(0.0 < part <= 1.0 for parts in weights.values() for part in parts.values())
    assert set(weights) == {*EMOTIONS, *VOWELS, *UNITS}


def test_what_the_cast_lacks_is_left_out_and_a_chosen_one_takes_the_place_of_the_preset_of_its_name() -> None:
    cast = synthetic_cast()
    weights = preset_weights(cast)
    assert weights["lookLeft"] == {"eyeLookOutLeft": 1.0, "eyeLookInRight": 1.0}
    assert (weights["blink"], weights["happy"], weights["relaxed"]) == ({}, {}, {"smile": 1.0})
    own = cast.with_expressions(happy=cast.expressions["smile"])
    assert preset_weights(own, ["happy"])["happy"] == {"happy": 1.0}
    assert preset_weights(own)["happy"] == {}
    assert "happy" not in custom_expressions(own, ["happy", "smile"]).values()


def test_units_are_called_as_perfect_sync_calls_them() -> None:
    cast = synthetic_cast()
    customs = custom_expressions(cast, ["smile", "jawOpen"])
    units = [name for name in synthetic.EXPRESSIONS if name not in ("neutral", "smile")]
    assert customs == {name[0].upper() + name[1:]: name for name in units} | {"smile": "smile"}
    assert set(required_expressions(cast, [])) == {*units, "smile"}  # relaxed is a smile
    assert len(required_expressions(cast, ["smile", "jawOpen"])) == len(units) + 1


@pytest.mark.parametrize(("preset", "sign"), [("blinkLeft", 1), ("blinkRight", -1)])
def test_a_wink_is_on_the_characters_side(preset: str, sign: int, built_in: Cast) -> None:
    ((unit, weight),) = preset_weights(built_in)[preset].items()
    rest = fit(built_in.space, built_in.faces["kaori"]).positions
    seen = np.unique(built_in.space.skin_triangles)  # the lining of sockets is not
    far = np.abs(named_compound_meshes(built_in, "kaori", unit)[SKIN] - rest)[seen].max(axis=1) > 1e-3
    assert weight == 1.0
    assert far.any()
    assert (sign * rest[seen][far, 0] > 0).all()


@pytest.mark.parametrize(
    ("preset", "axis", "sign"), [("lookLeft", 0, 1), ("lookRight", 0, -1), ("lookUp", 1, 1), ("lookDown", 1, -1)]
)
def test_both_eyes_look_to_the_side_that_a_preset_says(preset: str, axis: int, sign: int, built_in: Cast) -> None:
    turns = sum(built_in.expressions[unit].eyes for unit in preset_weights(built_in)[preset])
    assert (sign * np.asarray(turns)[:, axis] > np.radians(5.0)).all()


@pytest.mark.parametrize("face", ["kaori", "dog", "old"])
def test_what_would_close_lids_or_open_lips_twice_is_overridden(face: str, built_in: Cast) -> None:
    presets = preset_weights(built_in)
    poses = {name: named_compound_meshes(built_in, face, name)[SKIN] for name in required_expressions(built_in, [])}
    rest = fit(built_in.space, built_in.faces[face]).positions.astype(np.float64)
    found = find_overrides(built_in.space, rest, poses, presets)
    assert found["surprised"] == Overrides(mouth=True)  # wide eyes, an open mouth
    assert found["relaxed"] == found["happy"] == Overrides()
    assert found["blink"] == Overrides(look=True)
    asleep = presets | {"happy": {"asleep": 1.0}}
    closed = poses | {"asleep": named_compound_meshes(built_in, face, "asleep")[SKIN]}
    assert find_overrides(built_in.space, rest, closed, asleep)["happy"].blink


def test_a_head_without_lids_overrides_nothing_but_the_gaze() -> None:
    space = synthetic.space()
    still = {preset: dict[str, float]() for preset in PRESETS}
    found = find_overrides(space, space.points, {}, still)
    assert found == dict.fromkeys(EMOTIONS, Overrides()) | {"blink": Overrides(look=True)}


@pytest.mark.parametrize("size", [0.7, 1.0, 2.0])
def test_lips_part_between_the_same_points_of_a_generic_head_of_any_size(size: float) -> None:
    egg = synthetic.space()
    scale = size * HEAD_METRES / head_height(egg)
    deep = np.array([1.0, 1.0, 1.7])  # its lips are as far ahead as a head's
    space = ParameterSpace.build(scale * deep * egg.points, egg.triangles)
    lower = space.points[:, 1] < -0.068 * size  # metres, between the lips of a head of the declared height
    dropped = space.points - np.where(lower[:, None], [0.0, 0.01 * size, 0.0], 0.0)
    presets = {preset: dict[str, float]() for preset in PRESETS} | {"aa": {"open": 1.0}, "surprised": {"open": 1.0}}
    found = find_overrides(space, space.points, {"open": dropped}, presets)
    assert [name for name, overrides in found.items() if overrides.mouth] == ["surprised"]
