"""Two evaluators of one frame: the paper's blend, and the mixed face wearing the mixed expression."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import omote
from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS
from omote.model.space.face_fit import fit
from omote.model.space.parts import eye_rotation
from omote.model.transfer.compound import compound, compound_parts
from omote.perform.blending.evaluate import MODES, Mode, evaluate, evaluate_parts, warm
from omote.perform.blending.region_masks import play_masks
from omote.perform.frame import Frame, Gaze, Head
from omote.perform.saturation import saturate
from tests.synthetic import EXPRESSIONS, FACES


def mixes(names: tuple[str, ...]) -> st.SearchStrategy[dict[str, float]]:
    """Weights that sum to one, some beyond 0..1 as in a call."""
    parts = st.dictionaries(st.sampled_from(names), st.floats(0.05, 1.0), min_size=1, max_size=3)
    return parts.map(lambda found: {name: weight / math.fsum(found.values()) for name, weight in found.items()})


channels = st.dictionaries(st.sampled_from(EXPRESSIONS[1:]), st.floats(-0.5, 1.5), max_size=3)
frames = st.builds(Frame, mixes(FACES), mixes(EXPRESSIONS), channels)


@given(frames)
@example(Frame({FACES[0]: 1.0}, {"jawOpen": 1.0}, {"jawOpen": 0.5}))
def test_bilinear_is_the_papers_formula(cast: Cast, frame: Frame) -> None:
    """Of channels with what they add to the units that expressions wear."""
    added = saturate(cast.expressions, frame, frame.channels)

    def worn(i: str, k: str) -> np.ndarray:
        return compound(cast.space, cast.faces[i], cast.expressions[k]).astype(np.float64)

    expected = np.zeros((cast.space.vertex_count, 3))
    for i, s in frame.faces.items():
        for j, t in frame.expressions.items():
            expected += s * t * worn(i, j)
        for k, c in added.items():
            expected += s * c * (worn(i, k) - cast.faces[i].positions)
    assert evaluate(cast, frame) == pytest.approx(expected, abs=2e-7)


@given(st.sampled_from(FACES), st.sampled_from(EXPRESSIONS))
def test_one_face_with_one_expression_is_its_compound_in_both_modes(cast: Cast, face: str, name: str) -> None:
    expected = compound(cast.space, cast.faces[face], cast.expressions[name])
    frame = Frame({face: 1.0}, {name: 1.0})
    assert np.array_equal(evaluate(cast, frame), expected)
    assert evaluate(cast, frame, "exact") == pytest.approx(expected, abs=1e-6)


@given(mixes(FACES))
def test_without_expression_both_modes_are_the_mixed_face(cast: Cast, faces: dict[str, float]) -> None:
    expected = sum(s * cast.faces[i].positions.astype(np.float64) for i, s in faces.items())
    for mode in MODES:
        assert evaluate(cast, Frame(faces, {"neutral": 1.0}), mode) == pytest.approx(expected, abs=1e-6)


@given(frames, frames, st.floats(0.0, 1.0))
def test_bilinear_is_linear_along_each_axis(cast: Cast, one: Frame, other: Frame, u: float) -> None:
    def at(faces: Any) -> np.ndarray:
        return evaluate(cast, Frame(faces, one.expressions, one.channels)).astype(np.float64)

    between = {name: (1 - u) * one.faces.get(name, 0.0) + u * other.faces.get(name, 0.0) for name in FACES}
    assert at(between) == pytest.approx((1 - u) * at(one.faces) + u * at(other.faces), abs=5e-7)


@given(frames)
def test_the_modes_stay_within_a_few_millimetres(cast: Cast, frame: Frame) -> None:
    reach = 1.0 + sum(abs(weight) for weight in frame.channels.values())
    assert np.abs(evaluate(cast, frame) - evaluate(cast, frame, "exact")).max() < 0.004 * reach**2


@given(frames)
def test_the_direction_of_the_head_is_left_to_the_stage(cast: Cast, frame: Frame) -> None:
    turned = Frame(frame.faces, frame.expressions, frame.channels, head=Head(0.3, 0.2, 0.1))
    for mode in MODES:
        assert np.array_equal(evaluate(cast, turned, mode), evaluate(cast, frame, mode))


@pytest.mark.parametrize("mode", MODES)
@given(st.sampled_from(FACES), st.sampled_from(EXPRESSIONS))
def test_parts_of_one_compound_are_those_of_the_model(cast: Cast, mode: Mode, face: str, name: str) -> None:
    found = evaluate_parts(cast, Frame({face: 1.0}, {name: 1.0}), mode)
    expected = compound_parts(cast.space, cast.faces[face], cast.expressions[name])
    assert found["teeth_lower"] == pytest.approx(expected["teeth_lower"], abs=1e-6)
    for row, eye in enumerate(("eye_left", "eye_right")):
        centre = fit(cast.space, cast.faces[face]).centres[eye]
        turned = (expected[eye] - centre) @ eye_rotation(*cast.expressions[name].eyes[row]).T + centre
        assert found[eye] == pytest.approx(turned, abs=1e-6)


@given(mixes(FACES), st.floats(-0.5, 0.5), st.floats(-0.4, 0.4))
def test_eyeballs_turn_rigidly_to_the_gaze(cast: Cast, faces: dict[str, float], yaw: float, pitch: float) -> None:
    ahead = evaluate_parts(cast, Frame(faces, {"neutral": 1.0}))
    looking = evaluate_parts(cast, Frame(faces, {"neutral": 1.0}, gaze=Gaze(yaw, pitch)))
    for eye in ("eye_left", "eye_right"):
        centre = ahead[eye].mean(axis=0)
        assert looking[eye] - centre == pytest.approx((ahead[eye] - centre) @ eye_rotation(yaw, pitch).T, abs=1e-6)
    assert looking["teeth_lower"] == pytest.approx(ahead["teeth_lower"], abs=1e-6)


def test_the_lower_teeth_go_with_the_jaw_in_both_modes(cast: Cast) -> None:
    rest = evaluate_parts(cast, Frame({"long": 1.0}, {"neutral": 1.0}))["teeth_lower"]
    for mode in MODES:
        frame = Frame({"long": 1.0}, {"neutral": 1.0}, {"jawOpen": 0.5})
        drop = evaluate_parts(cast, frame, mode)["teeth_lower"] - rest
        assert drop[:, 1].max() < -0.003
        assert np.ptp(drop, axis=0) == pytest.approx(np.zeros(3), abs=1e-6)


@pytest.mark.parametrize(
    ("frame", "sentence"),
    [
        (Frame({"nobody": 1.0}, {"neutral": 1.0}), "there is no face 'nobody'"),
        (Frame({"generic": 1.0}, {"sulk": 1.0}), "there is no expression 'sulk'"),
        (Frame({"generic": 1.0}, {"neutral": 1.0}, {"tail": 1.0}), "there is no channel 'tail'"),
        (Frame({"generic": math.nan}, {"neutral": 1.0}), "the weight of the face generic is no number"),
        (Frame({"generic": 1.0}, {"neutral": 1.0}, {"smile": math.inf}), "the channel smile is inf"),
        (Frame({}, {"neutral": 1.0}), "faces sum to 0; expected one"),
        (Frame({"generic": 1.0}, {}), "expressions sum to 0; expected one"),
    ],
)
def test_a_frame_that_this_cast_cannot_show_is_refused(cast: Cast, frame: Frame, sentence: str) -> None:
    for evaluator in (evaluate, evaluate_parts):
        with pytest.raises(ValueError, match=sentence):
            evaluator(cast, frame)


@pytest.mark.parametrize(
    ("frame", "sentence"),
    [
        (Frame({"long": 4.0, "broad": 5.0}, {"neutral": 1.0}), "faces sum to 9; expected one"),
        (Frame({"generic": 1e308}, {"neutral": 1.0}), "face generic is 1e.308; give a number from -10 to 10"),
        (Frame({"generic": 1.0}, {"neutral": 50.0, "smile": -49.0}), "from -10 to 10"),
        (Frame({"generic": 1.0}, {"neutral": 1.0}, {"smile": 1.6}), "the channel smile is 1.6"),
    ],
)
def test_weights_that_are_no_average_are_refused(cast: Cast, frame: Frame, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        evaluate(cast, frame)


@pytest.mark.parametrize(
    ("faces", "sentence"), [({"generic": True}, "must be a number, not True"), (None, "expected weights by name")]
)
def test_weights_that_are_no_numbers_are_refused(cast: Cast, faces: Any, sentence: str) -> None:
    with pytest.raises(TypeError, match=sentence):
        evaluate(cast, Frame(faces, {"neutral": 1.0}))


def test_what_is_no_frame_is_refused(cast: Cast) -> None:
    with pytest.raises(TypeError, match="got Cast and str; expected a Cast and a Frame"):
        evaluate(cast, "frame")  # type: ignore[arg-type]


def test_an_unknown_mode_is_refused(cast: Cast) -> None:
    with pytest.raises(ValueError, match="mode is 'linear'; expected one of 'bilinear', 'exact'"):
        evaluate(cast, Frame({"generic": 1.0}, {"neutral": 1.0}), "linear")  # type: ignore[arg-type]


def test_a_warm_cast_compiles_nothing_more(cast: Cast) -> None:
    from omote.geometry.locate import walk_strip
    from omote.model.transfer.paper_map import follow_anchors, gather_points
    from omote.perform.blending.expression_tables import _spread

    warm(cast)
    kernels: list[Any] = [walk_strip, gather_points, follow_anchors, _spread]
    before = [len(kernel.signatures) for kernel in kernels]
    for mode in MODES:
        frame = Frame({"long": 0.4, "broad": 0.6}, {"smile": 1.0}, {"jawOpen": 0.3}, gaze=Gaze(0.2, 0.1))
        evaluate(cast, frame, mode)
        evaluate_parts(cast, frame, mode)
    assert [len(kernel.signatures) for kernel in kernels] == before
    assert all(before)


# ---- regions of a call

BUILT_IN = omote.load_cast()
PAPER = BUILT_IN.under("paper")
WORN = ("joy", "angry", "surprise", "asleep", "kiss", "neutral")
built_in_mixes = mixes(("kaori", "dog", "old"))
regional = st.dictionaries(st.sampled_from(PLAY_REGIONS), mixes(WORN), min_size=1)
few = settings(max_examples=12)


@few
@given(built_in_mixes, mixes(WORN), regional)
def test_a_vertex_shows_the_mean_of_its_regions(faces: Any, whole: Any, regions: Any) -> None:
    """Under the paper's map nothing is corrected, and the sum of masks times mixes is exact."""
    masks = play_masks(PAPER.space)
    found = evaluate(PAPER, Frame(faces, whole, regions=regions))
    parts = evaluate_parts(PAPER, Frame(faces, whole, regions=regions))
    wanted = np.zeros(found.shape)
    wanted_parts = {name: np.zeros(part.shape) for name, part in parts.items()}
    for region, mask in masks.items():
        frame = Frame(faces, regions.get(region, whole))
        wanted += mask.skin * evaluate(PAPER, frame).astype(np.float64)
        for name, part in evaluate_parts(PAPER, frame).items():
            wanted_parts[name] += mask.parts[name] * part
    assert np.abs(found - wanted).max() < 2e-6
    assert all(np.abs(parts[name] - part).max() < 2e-6 for name, part in wanted_parts.items())


@few
@given(built_in_mixes, mixes(WORN), mixes(WORN), st.sampled_from(MODES))
def test_four_regions_alike_are_the_whole_face(faces: Any, whole: Any, other: Any, mode: Mode) -> None:
    everywhere = dict.fromkeys(PLAY_REGIONS, other)
    found = Frame(faces, whole, regions=everywhere)
    wanted = Frame(faces, other)
    assert np.abs(evaluate(BUILT_IN, found, mode) - evaluate(BUILT_IN, wanted, mode)).max() < 2e-6
    parts = evaluate_parts(BUILT_IN, found, mode)
    whole_parts = evaluate_parts(BUILT_IN, wanted, mode)
    assert all(np.abs(parts[name] - whole_parts[name]).max() < 2e-6 for name in parts)
    same = Frame(faces, other, regions=everywhere)
    assert np.array_equal(evaluate(BUILT_IN, same, mode), evaluate(BUILT_IN, wanted, mode))


@pytest.mark.parametrize("mode", MODES)
def test_an_eye_alone_closes_as_far_as_with_the_whole_face(mode: Mode) -> None:
    whole = evaluate(BUILT_IN, Frame({"kaori": 1.0}, {"asleep": 1.0}), mode)
    alone = evaluate(BUILT_IN, Frame({"kaori": 1.0}, {"angry": 1.0}, regions={"eyes": {"asleep": 1.0}}), mode)
    for line in BUILT_IN.space.lines[:2]:
        reach = np.abs(whole[line.loop] - alone[line.loop]).max()
        assert reach < (1e-4 if mode == "bilinear" else 5e-4), line.name


@pytest.mark.parametrize(
    ("regions", "error", "said"),
    [
        ({"tail": {"joy": 1.0}}, ValueError, "no region 'tail' to play in"),
        ({"mouth": {"joy": 0.5}}, ValueError, "weights of the frame's mouth expressions sum to 0.5"),
        ({"mouth": {"nobody": 1.0}}, ValueError, "nobody"),
        ({"mouth": 1.0}, TypeError, "expected weights by name"),
        (3, TypeError, "expected mixes by region"),
    ],
    ids=["no region", "no average", "no name", "no mix", "no regions"],
)
def test_regions_that_cannot_be_played_are_refused(regions: Any, error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        evaluate(BUILT_IN, Frame({"kaori": 1.0}, {"joy": 1.0}, regions=regions))
