"""docs/conventions.md in a form that fails; every test here is named on that page."""

import dataclasses
import inspect
import re
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.geometry.cylinder import Cylinder
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST

PAGE = (Path(__file__).parent.parent / "docs" / "conventions.md").read_text()
HERE = Path(__file__).read_text()
ELSEWHERE = (Path(__file__).parent / "test_architecture.py").read_text()

# The 52 blend shapes of ARKit's ARFaceAnchor, as its documentation lists them.
ARKIT = """
eyeBlinkLeft eyeLookDownLeft eyeLookInLeft eyeLookOutLeft eyeLookUpLeft eyeSquintLeft eyeWideLeft
eyeBlinkRight eyeLookDownRight eyeLookInRight eyeLookOutRight eyeLookUpRight eyeSquintRight eyeWideRight
jawForward jawLeft jawRight jawOpen
mouthClose mouthFunnel mouthPucker mouthLeft mouthRight mouthSmileLeft mouthSmileRight mouthFrownLeft mouthFrownRight
mouthDimpleLeft mouthDimpleRight mouthStretchLeft mouthStretchRight mouthRollLower mouthRollUpper mouthShrugLower
mouthShrugUpper mouthPressLeft mouthPressRight mouthLowerDownLeft mouthLowerDownRight mouthUpperUpLeft mouthUpperUpRight
browDownLeft browDownRight browInnerUp browOuterUpLeft browOuterUpRight cheekPuff cheekSquintLeft cheekSquintRight
noseSneerLeft noseSneerRight tongueOut
""".split()
SIDED = [name for name in ARKIT if name.endswith(("Left", "Right")) and name not in ("jawLeft", "jawRight")]
SIDED = [
    name for name in SIDED if name not in ("mouthLeft", "mouthRight")
]  # these move the whole jaw or mouth to a side


@pytest.fixture(scope="module")
def cast() -> omote.Cast:
    """The built-in cast."""
    built_in: omote.Cast = omote.load_cast()
    return built_in


@pytest.fixture(scope="module")
def generic(cast: omote.Cast) -> NDArray[np.float64]:
    """The generic face, (V, 3) metres."""
    return cast.faces["generic"].positions.astype(np.float64)


def moved(cast: omote.Cast, name: str) -> NDArray[np.float64]:
    """Where a unit moves the generic face, (V, 3) metres."""
    face = cast.faces["generic"]
    return omote.compound(cast.space, face, cast.expressions[name]).astype(np.float64) - face.positions


def public_callables() -> Iterator[tuple[str, Callable[..., object]]]:
    """Every public function and every public method of a public class."""
    for name in omote.__all__:
        value = getattr(omote, name)
        if not inspect.isclass(value):
            yield name, value
            continue
        for method, function in inspect.getmembers(value, callable):
            if not method.startswith("_"):
                yield f"{name}.{method}", function


def test_the_page_names_every_test_here_and_no_other() -> None:
    named = set(re.findall(r"`(test_\w+)`", PAGE))
    assert named <= set(re.findall(r"^def (test_\w+)", HERE + ELSEWHERE, re.MULTILINE))
    assert set(re.findall(r"^def (test_\w+)", HERE, re.MULTILINE)) - named == {
        "test_the_page_names_every_test_here_and_no_other"
    }


def test_lengths_are_metres(generic: NDArray[np.float64]) -> None:
    width, height, depth = np.ptp(generic, axis=0)
    assert 0.13 < width < 0.25
    assert 0.2 < height < 0.4
    assert 0.15 < depth < 0.3


def test_y_is_up_z_is_forward_x_is_the_characters_left(cast: omote.Cast, generic: NDArray[np.float64]) -> None:
    crown = generic[generic[:, 1].argmax()]
    nose = generic[generic[:, 2].argmax()]
    frame = omote.Performer(cast).advance(0.0)
    eyes = omote.evaluate_parts(cast, frame)
    left = eyes["eye_left"].mean(axis=0)
    right = eyes["eye_right"].mean(axis=0)
    assert abs(nose[0]) < 0.005
    assert crown[1] > left[1] > nose[1]
    assert nose[2] > left[2] > crown[2]
    assert left[0] > 0.02
    np.testing.assert_allclose(left, right * [-1, 1, 1], atol=1e-3)


def test_left_units_move_the_left(cast: omote.Cast, generic: NDArray[np.float64]) -> None:
    for name in SIDED:
        energy = (moved(cast, name) ** 2).sum(axis=1)
        side = 1 if name.endswith("Left") else -1
        assert side * (energy @ generic[:, 0]) / energy.sum() > 0.005, name


def test_triangles_wind_counter_clockwise_seen_from_outside(cast: omote.Cast, generic: NDArray[np.float64]) -> None:
    space = cast.space
    a, b, c = generic[space.skin_triangles].transpose(1, 0, 2)
    from_axis = (a + b + c) / 3 - [space.cylinder.x, 0, space.cylinder.z]
    from_axis[:, 1] = 0
    assert ((np.cross(b - a, c - a) * from_axis).sum(axis=1) > 0).mean() > 0.95
    theta = space.theta[space.skin_triangles]
    h = space.h[space.skin_triangles]
    u, v = np.remainder(theta[:, 1:] - theta[:, :1] + np.pi, 2 * np.pi) - np.pi, h[:, 1:] - h[:, :1]
    assert (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0] > 0).all()


def test_theta_is_zero_ahead_and_grows_to_the_left() -> None:
    theta, h, r = Cylinder(0.01, 0.02).unroll(np.array([[0.01, 5, 1.02], [1.01, 5, 0.02], [0.01, 5, -0.98]]))
    np.testing.assert_allclose(theta, [0, np.pi / 2, -np.pi])
    np.testing.assert_allclose(h, 5)
    np.testing.assert_allclose(r, 1)


@pytest.mark.parametrize("side", ["Left", "Right"])
def test_eyes_look_where_their_units_say(cast: omote.Cast, side: str) -> None:
    eye = 0 if side == "Left" else 1
    to_the_left = cast.expressions[f"eyeLook{'Out' if eye == 0 else 'In'}{side}"].eyes[eye]
    to_the_right = cast.expressions[f"eyeLook{'In' if eye == 0 else 'Out'}{side}"].eyes[eye]
    assert to_the_left[0] > 0.1
    assert to_the_right[0] < -0.1
    assert cast.expressions[f"eyeLookUp{side}"].eyes[eye, 1] > 0.1
    assert cast.expressions[f"eyeLookDown{side}"].eyes[eye, 1] < -0.1


def test_arrays_are_float32_and_int32_rows(cast: omote.Cast) -> None:
    frame = omote.Performer(cast).advance(0.0)
    points = [face.positions for face in cast.faces.values()]
    points += [omote.evaluate(cast, frame, mode="bilinear"), omote.evaluate(cast, frame, mode="exact")]
    points += [omote.compound(cast.space, cast.faces["generic"], cast.expressions["jawOpen"])]
    parts = list(omote.evaluate_parts(cast, frame).values())
    rows = [cast.space.triangles, cast.space.skin_triangles]
    assert {array.shape for array in points} == {(cast.space.vertex_count, 3)}
    assert {array.dtype for array in [*points, *parts]} == {np.dtype(np.float32)}
    assert {array.dtype for array in rows} == {np.dtype(np.int32)}
    assert {array.shape[1] for array in [*parts, *rows]} == {3}
    assert all(array.flags.c_contiguous for array in [*points, *parts, *rows])


def test_a_new_performer_shows_the_generic_face_at_rest(cast: omote.Cast) -> None:
    frame = omote.Performer(cast).advance(0.0)
    assert (dict(frame.faces), dict(frame.expressions), dict(frame.channels)) == (
        {"generic": 1.0},
        {"neutral": 1.0},
        {},
    )
    at_rest = cast.faces["generic"].positions
    np.testing.assert_allclose(omote.evaluate(cast, frame, mode="bilinear"), at_rest, rtol=0, atol=3e-8)  # float32


def test_channels_reach_from_minus_a_half_to_one_and_a_half(cast: omote.Cast) -> None:
    performer = omote.Performer(cast)
    assert (CHANNEL_LOWEST, CHANNEL_HIGHEST) == (-0.5, 1.5)
    for value in (CHANNEL_LOWEST, CHANNEL_HIGHEST):
        performer.set_channel("jawOpen", value)
        assert performer.advance(0.0).channels["jawOpen"] == value
    for value in (np.nextafter(CHANNEL_LOWEST, -1), np.nextafter(CHANNEL_HIGHEST, 2), np.nan, np.inf):
        with pytest.raises(ValueError, match="jawOpen"):
            performer.set_channel("jawOpen", float(value))
    assert performer.advance(0.0).channels["jawOpen"] == CHANNEL_HIGHEST


def test_faces_and_expressions_are_frozen(cast: omote.Cast) -> None:
    face = cast.faces["generic"]
    expression = cast.expressions["jawOpen"]
    arrays = (
        face.positions,
        expression.dtheta,
        expression.dh,
        expression.ratio,
        expression.residual,
        cast.space.triangles,
    )
    assert [array.flags.writeable for array in arrays] == [False] * len(arrays)
    for noun in (face, expression, cast.space, cast):
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(noun, dataclasses.fields(noun)[0].name, None)


def test_one_option_at_most_may_be_given_by_place() -> None:
    for name, function in public_callables():
        parameters = inspect.signature(function).parameters.values()
        options = [p for p in parameters if p.default is not p.empty]
        assert len([p for p in options if p.kind is not p.KEYWORD_ONLY]) <= 1, f"{name}{inspect.signature(function)}"


def test_public_names_are_documented() -> None:
    values = {name: getattr(omote, name) for name in omote.__all__} | dict(public_callables())
    sentences = {name: (inspect.getdoc(value) or "").split("\n\n")[0] for name, value in values.items()}
    assert {name: said for name, said in sentences.items() if not re.match(r"\S.*[.:;,)]", said, re.DOTALL)} == {}


def test_arkit_units_have_their_exact_names(cast: omote.Cast) -> None:
    assert len(set(ARKIT)) == 52
    assert set(ARKIT) <= cast.expressions.keys()
