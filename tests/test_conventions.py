"""docs/conventions.md in a form that fails; every test here is named on that page."""

import ast
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


PARTICIPLES = {
    "omote.perform.axis": {"called", "faded", "released", "advanced", "halted"},
}
"""Participles allowed: each returns a changed copy of its first argument."""
PUBLIC_PARTICIPLES = {"sculpted", "restored"}
"""Public names of `omote` that stay: a function, and the classmethod that makes an object from its snapshot."""
NOUNS = {"stored"}
"""Nouns with the form of a participle: `stored` gives a `Stored`."""
IRREGULAR = set(
    "bent born bound bought broken brought built caught cut dealt drawn driven drunk eaten fallen fed felt found given "
    "gone grown held heard hidden hung kept known laid led left lent lit lost made meant met paid put risen said seen "
    "sent set sewn shaken shown shut slid sold spent spoken spread spun stood stuck sung sunk swept swollen taken "
    "taught told thought thrown torn understood woken won worn wound woven written".split()
)
COMMANDS = {"set", "put", "cut", "shut", "spread"}
"""Verbs whose participle is the same word."""
PARTICIPLE_ENDINGS = re.compile(r"[a-z]{2,}[^e]ed")
"""Regular participles; `feed`, `need` and `speed` are none."""


def is_participle(name: str) -> bool:
    """Whether a name is a bare past participle, such as `mailed` or `woven`."""
    return bool(PARTICIPLE_ENDINGS.fullmatch(name)) or name in IRREGULAR - COMMANDS


def defined_functions() -> Iterator[tuple[str, str]]:
    """The module and the name of every public function and method in src/omote; properties are left out."""
    source = Path(omote.__file__).parent
    for path in sorted(source.rglob("*.py")):
        module = ".".join(("omote", *path.relative_to(source).with_suffix("").parts)).removesuffix(".__init__")
        for node in ast.walk(ast.parse(path.read_text())):
            if not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) or node.name.startswith("_"):
                continue
            if not any("property" in ast.unparse(decorator) for decorator in node.decorator_list):
                yield module, node.name


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
    crown, nose = generic[generic[:, 1].argmax()], generic[generic[:, 2].argmax()]
    frame = omote.Performer(cast).advance(0.0)
    eyes = omote.evaluate_parts(cast, frame)
    left, right = eyes["eye_left"].mean(axis=0), eyes["eye_right"].mean(axis=0)
    assert abs(nose[0]) < 0.005
    assert crown[1] > left[1] > nose[1]
    assert nose[2] > left[2] > crown[2]
    assert left[0] > 0.02
    np.testing.assert_allclose(left, right * [-1, 1, 1], atol=1e-3)


@pytest.mark.parametrize("name", SIDED)
def test_left_units_move_the_left(cast: omote.Cast, generic: NDArray[np.float64], name: str) -> None:
    energy = (moved(cast, name) ** 2).sum(axis=1)
    side = 1 if name.endswith("Left") else -1
    assert side * (energy @ generic[:, 0]) / energy.sum() > 0.005


def test_triangles_wind_counter_clockwise_seen_from_outside(cast: omote.Cast, generic: NDArray[np.float64]) -> None:
    space = cast.space
    a, b, c = generic[space.skin_triangles].transpose(1, 0, 2)
    from_axis = (a + b + c) / 3 - [space.cylinder.x, 0, space.cylinder.z]
    from_axis[:, 1] = 0
    assert ((np.cross(b - a, c - a) * from_axis).sum(axis=1) > 0).mean() > 0.95
    theta, h = space.theta[space.skin_triangles], space.h[space.skin_triangles]
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
    face, expression = cast.faces["generic"], cast.expressions["jawOpen"]
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


@pytest.mark.parametrize(("name", "function"), [*public_callables()])
def test_one_option_at_most_may_be_given_by_place(name: str, function: Callable[..., object]) -> None:
    parameters = inspect.signature(function).parameters.values()
    options = [p for p in parameters if p.default is not p.empty]
    assert len([p for p in options if p.kind is not p.KEYWORD_ONLY]) <= 1, f"{name}{inspect.signature(function)}"


def test_functions_are_verbs_or_nouns() -> None:
    assert all(map(is_participle, ("mailed", "hired", "woven", "kept", "seen", "copied", "painted")))
    assert not any(map(is_participle, ("feed", "need", "speed", "fit", "compile", "blend", "weights", "set")))
    allowed = {(module, name) for module, names in PARTICIPLES.items() for name in names}
    found = {(module, name) for module, name in defined_functions() if is_participle(name)}
    free = {each for each in found if each[1] in PUBLIC_PARTICIPLES | NOUNS}
    assert found - free == allowed


@pytest.mark.parametrize("name", sorted({*omote.__all__, *(name for name, _ in public_callables())}))
def test_public_names_are_documented(name: str) -> None:
    value: object = omote
    for part in name.split("."):
        value = getattr(value, part)
    sentence = (inspect.getdoc(value) or "").split("\n\n")[0]
    assert re.match(r"\S.*[.:;,)]", sentence, re.DOTALL), f"{name} says {sentence!r}"


def test_arkit_units_have_their_exact_names(cast: omote.Cast) -> None:
    assert len(set(ARKIT)) == 52
    assert set(ARKIT) <= cast.expressions.keys()
