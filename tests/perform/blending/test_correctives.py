"""Combinations of compounds neither fold nor pierce where each alone does not; one alone hardly changes."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.builtin import load_cast
from omote.geometry.orientation import area_shares, rest_normals
from omote.model.cast import Cast
from omote.model.known_names import NEUTRAL
from omote.model.sculpting.regions import regional
from omote.model.space.face_fit import fit
from omote.model.transfer.compound import compound
from omote.model.transfer.corrective_regions import CorrectiveRegions, find_corrective_regions
from omote.perform.blending.correctives import FLOOR, Eyeballs, correct_combination, measure_allowance
from omote.perform.blending.evaluate import MODES, Mode, evaluate, evaluate_parts
from omote.perform.frame import Frame

CAST = load_cast()
UNITS = [name for name, title in CAST.titles.items() if title.kind in ("arkit", "makehuman")]
FACES = ("kaori", "goblin", "dog", "baby")
units = st.sampled_from(UNITS)
faces = st.sampled_from(FACES)
LIDS = ("eyeBlinkLeft", "eyeSquintLeft", "eyeLookDownLeft")
LIPS = ("mouthPucker", "mouthRollUpper", "mouthRollLower")


# Of a real take: blinks to contact and beyond it, with all that people do around their eyes.
MOMENTS = (
    {"eyeBlink": 0.97, "eyeLookDown": 0.29, "mouthFrown": 0.2},
    {"eyeBlink": 0.94, "eyeSquint": 0.64, "eyeLookDown": 0.4, "browDown": 0.93, "cheekSquint": 0.6, "noseSneer": 0.8},
    {"eyeBlink": 1.08, "eyeSquint": 0.7, "cheekSquint": 0.7, "mouthSmile": 0.9},
)
OVERDRIVEN = (
    ("mouth-corner-puller", "mouthSmileLeft", "mouth-upward-retraction"),
    ("eye-left-closure", "eyeBlinkLeft", "eye-left-slit"),
    ("eye-right-slit", "eyeBlinkRight", "eyeLookDownRight"),
)
SEEN = 1e-4
"""Metres that nobody sees."""


def corrective_regions() -> CorrectiveRegions:
    found = find_corrective_regions(CAST.space)
    assert found is not None
    return found


def shares(face: str, positions: np.ndarray) -> np.ndarray:
    """What is left of each triangle of the sheet, seen along its normal at rest, (T,)."""
    triangles = CAST.space.sheet_triangles
    normals, sizes = rest_normals(CAST.faces[face].positions.astype(np.float64), triangles)
    return area_shares(positions.astype(np.float64), normals, sizes, triangles)


def over(face: str, positions: np.ndarray) -> np.ndarray:
    """The triangles of the sheet that are turned over, (T,)."""
    return shares(face, positions) < 0.0


def worn(face: str, weights: dict[str, float]) -> np.ndarray:
    """The face as it is on air with channels."""
    return evaluate(CAST, Frame({face: 1.0}, {NEUTRAL: 1.0}, weights))


def crossed(face: str, positions: np.ndarray) -> np.ndarray:
    """How far lids and lips have crossed more than at rest, (lines, rungs) metres."""
    found = []
    for line in CAST.space.lines:
        rest = line.rungs(CAST.faces[face].positions.astype(float))
        now = line.rungs(positions.astype(float))
        up = np.array([[0.0, 1.0, 0.0]]) if line.kind == "lips" else rest / np.linalg.norm(rest, axis=1)[:, None]
        found.append(np.maximum(np.minimum((up * rest).sum(axis=1), 0.0) - (up * now).sum(axis=1), 0.0))
    return np.array(found)


def summed(face: str, *names: str) -> np.ndarray:
    """The plain sum of compounds."""
    rest = CAST.faces[face].positions
    return sum((compound(CAST.space, CAST.faces[face], CAST.expressions[name]) - rest for name in names), start=rest)


@pytest.mark.parametrize("mode", MODES)
@settings(max_examples=15)
@given(face=faces, name=st.sampled_from(sorted({*CAST.expressions} - {"tongueOut"})))  # which parts lips by itself
def test_one_compound_alone_changes_only_where_a_triangle_has_next_to_nothing_left(
    mode: Mode, face: str, name: str
) -> None:
    alone = compound(CAST.space, CAST.faces[face], CAST.expressions[name])
    worn = evaluate(CAST, Frame({face: 1.0}, {name: 1.0}), mode)
    least = shares(face, alone).min()
    if least >= FLOOR and mode == "bilinear":
        assert np.array_equal(worn, alone)
    elif least >= 0.0:
        assert worn == pytest.approx(alone, abs=1e-5 if least >= FLOOR else 2.0 * SEEN)


@pytest.mark.parametrize("face", ["round", "man", "baby"])
@pytest.mark.parametrize("names", OVERDRIVEN)
def test_a_mouth_or_an_eye_driven_over_and_over_folds_nothing(face: str, names: tuple[str, ...]) -> None:
    alone = np.any([over(face, worn(face, {name: 1.0})) for name in names], axis=0)
    assert not (over(face, worn(face, dict.fromkeys(names, 1.0))) & ~alone).any()


@pytest.mark.parametrize("face", ["generic", "kaori", "baby", "man"])
def test_lips_that_close_without_a_jaw_turn_no_triangle_over(face: str) -> None:
    alone = compound(CAST.space, CAST.faces[face], CAST.expressions["mouthClose"])
    worn = evaluate(CAST, Frame({face: 1.0}, {"mouthClose": 1.0}))
    assert over(face, alone).any()
    assert not over(face, worn).any()


@pytest.mark.parametrize("face", FACES)
@pytest.mark.parametrize("weights", MOMENTS)
def test_a_performance_turns_no_triangle_over(face: str, weights: dict[str, float]) -> None:
    channels = {name + side: weight for name, weight in weights.items() for side in ("Left", "Right")}
    assert not over(face, evaluate(CAST, Frame({face: 1.0}, {NEUTRAL: 1.0}, channels))).any()


@pytest.mark.parametrize("face", ["kaori", "goblin", "child"])  # some faces' lips never come so far
@pytest.mark.parametrize("names", [LIDS, LIPS, ("mouthShrugLower", "mouthClose")])
def test_lids_and_lips_that_sums_push_through_each_other_meet(face: str, names: tuple[str, ...]) -> None:
    plain = summed(face, *names)
    mixed = evaluate(CAST, Frame({face: 1.0}, {NEUTRAL: 1.0}, dict.fromkeys(names, 1.0)))
    alone = sum(crossed(face, summed(face, name)) for name in names)
    before = np.maximum(crossed(face, plain) - alone, 0.0).max()
    after = np.maximum(crossed(face, mixed) - alone, 0.0).max()
    assert before > 0.5e-3
    assert after < min(0.4e-3, 0.5 * before)


@settings(max_examples=60)
@given(face=faces, names=st.lists(units, min_size=2, max_size=3, unique=True))
def test_sums_turn_over_nothing_that_no_unit_does(face: str, names: list[str]) -> None:
    alone = np.any([over(face, summed(face, name)) for name in names], axis=0)
    assert not (over(face, worn(face, dict.fromkeys(names, 1.0))) & ~alone).any()


@pytest.mark.parametrize("face", ["kaori", "heavy", "man", "goblin"])
@pytest.mark.parametrize(
    "names",
    [("jawOpen", "neck-platysma"), ("mouth-open", "neck-platysma", "mouthDimpleLeft"), ("jawOpen", "mouth-open")],
)
def test_the_throat_folds_nothing_under_an_open_jaw(face: str, names: tuple[str, ...]) -> None:
    alone = np.any([over(face, summed(face, name)) for name in names], axis=0)
    assert not (over(face, worn(face, dict.fromkeys(names, 1.0))) & ~alone).any()


@pytest.mark.parametrize(
    ("jaw", "rest", "third"),
    [
        ("baby", "kaori", "mouthRollLower"), ("auntie", "child", "noseSneerLeft"), ("man", "baby", "mouthRollLower"),
        ("auntie", "gaunt", "noseSneerLeft"), ("round", "baby", "jawLeft"),
    ],
)  # fmt: skip
def test_a_jaw_opened_twice_folds_nothing_on_a_mix_of_faces(jaw: str, rest: str, third: str) -> None:
    """What eight rounds in the last block left turned over beside the chin."""
    mix = regional(CAST.space, "mix", {"jaw": CAST.faces[jaw]}, rest=CAST.faces[rest])
    units = ("jawOpen", "mouth-open", third)
    cast = Cast(CAST.space, {"mix": mix}, {name: CAST.expressions[name] for name in (NEUTRAL, *units)})
    now = evaluate(cast, Frame({"mix": 1.0}, {NEUTRAL: 1.0}, dict.fromkeys(units, 1.0)))
    triangles = CAST.space.sheet_triangles
    normals, sizes = rest_normals(mix.positions.astype(np.float64), triangles)

    def turned(positions: np.ndarray) -> np.ndarray:
        return area_shares(positions.astype(np.float64), normals, sizes, triangles) < 0.0

    alone = [turned(compound(CAST.space, mix, CAST.expressions[name])) for name in units]
    assert not (turned(now) & ~np.any(alone, axis=0)).any()


@settings(max_examples=60)
@given(face=faces, name=units, weight=st.floats(1.0, 1.5))
def test_a_unit_beyond_its_end_turns_over_nothing_that_it_does_not_there(face: str, name: str, weight: float) -> None:
    assert not (over(face, worn(face, {name: weight})) & ~over(face, summed(face, name))).any()


@pytest.mark.parametrize("face", ["kaori", "goblin", "baby"])
def test_a_blink_beyond_its_end_presses_the_lids_and_passes_none_through_the_other(face: str) -> None:
    rest = CAST.faces[face].positions
    shut = summed(face, "eyeBlinkLeft")
    before = crossed(face, rest + 1.5 * (shut - rest)).max() - crossed(face, shut).max()
    after = crossed(face, worn(face, {"eyeBlinkLeft": 1.5})).max() - crossed(face, shut).max()
    assert before > 1e-3
    assert after < 0.2e-3


@settings(max_examples=15)
@given(face=faces, names=st.lists(units, min_size=2, max_size=3, unique=True), weight=st.floats(0.1, 0.9))
def test_weights_that_change_little_change_little(face: str, names: list[str], weight: float) -> None:
    step = 1e-4
    here, there = (
        evaluate(CAST, Frame({face: 1.0}, {NEUTRAL: 1.0}, dict.fromkeys(names, weight + n * step))) for n in range(2)
    )
    reach = max(np.abs(summed(face, name) - CAST.faces[face].positions).max() for name in names)
    assert np.abs(there - here).max() < 40 * step * reach + 1e-6


def test_a_triangle_that_a_mix_of_faces_leaves_next_to_nothing_of_moves_no_patch() -> None:
    """A tenth of a millimetre turns it over: the skin around it gave way by 1.3 mm within two milliseconds."""
    begun = {
        "faces": {"goblin": 0.138, "baby": 0.8042, "dog": 0.0181, "generic": 0.0397},
        "mouth": {"contempt": 0.447, "disgust": 0.0909, "kiss": 0.1875, "pain": 0.0158, NEUTRAL: 0.2588},
        "channels": {"browDownLeft": 0.3583, "eyeBlinkLeft": 0.3236, "jawOpen": 0.4715, "mouthLeft": 0.3699,
                     "mouthRollUpper": 0.1978, "mouthUpperUpRight": 0.3653},
    }  # fmt: skip
    later = {
        "faces": {"goblin": 0.1367, "baby": 0.806, "dog": 0.0179, "generic": 0.0394},
        "mouth": {"contempt": 0.4486, "disgust": 0.091, "kiss": 0.1864, "pain": 0.0157, NEUTRAL: 0.2583},
        "channels": {"browDownLeft": 0.3588, "eyeBlinkLeft": 0.324, "jawOpen": 0.4719, "mouthLeft": 0.3697,
                     "mouthRollUpper": 0.1973, "mouthUpperUpRight": 0.3651},
    }  # fmt: skip
    here, there = (
        evaluate(CAST, Frame(one["faces"], {"cry": 0.55, "disgust": 0.19, NEUTRAL: 0.26}, one["channels"],
                             regions={"mouth": one["mouth"]}))
        for one in (begun, later)
    )  # fmt: skip
    assert np.abs(there - here).max() < 2.5e-4


def test_the_rest_of_the_head_never_moves() -> None:
    names = (*LIDS, *LIPS)
    mixed = evaluate(CAST, Frame({"kaori": 1.0}, {NEUTRAL: 1.0}, dict.fromkeys(names, 1.0)))
    regions = corrective_regions()
    others = np.setdiff1d(np.arange(CAST.space.vertex_count), np.concatenate([regions.rows, regions.followers]))
    assert mixed[others] == pytest.approx(summed("kaori", *names)[others], abs=1e-6)


def test_lashes_go_with_the_lids_that_are_corrected() -> None:
    paper = Frame({"kaori": 1.0}, {NEUTRAL: 1.0}, dict.fromkeys(LIDS, 1.0))
    lashes = evaluate_parts(CAST, paper)["lashes"]
    part = CAST.space.parts["lashes"]
    skin = evaluate(CAST, paper)
    rest = fit(CAST.space, CAST.faces["kaori"])
    move = np.einsum("nk,nkc->nc", part.weights, (skin - rest.positions)[part.anchors])
    own = sum(rest.sizes["lashes"] * CAST.expressions[name].parts.get("lashes", np.zeros(3)) for name in LIDS)
    assert lashes == pytest.approx(rest.parts["lashes"] + move + own, abs=2e-6)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_lids_leave_the_eyeball_where_the_cornea_bulges(sign: float) -> None:
    regions = corrective_regions()
    face = fit(CAST.space, CAST.faces["kaori"])
    balls = Eyeballs.of(face, regions.eyes, np.array([[sign * 0.4, 0.0], [sign * 0.4, 0.0]]))
    shut = compound(CAST.space, CAST.faces["kaori"], CAST.expressions["eyeBlinkLeft"])
    nothing = np.zeros(regions.size, np.float32)
    allowed = measure_allowance(regions, face, CAST.expressions["eyeBlinkLeft"], shut) + nothing
    pressed = shut.copy()
    rows = regions.rows[regions.lids[regions.eye == 0]]
    pressed[rows] -= np.float32(2e-3) * (pressed[rows] - face.centres["eye_left"]).astype(np.float32) / 0.015
    out = correct_combination(regions, face.positions, pressed, allowed, balls)
    distance = np.linalg.norm(out[rows] - face.centres["eye_left"], axis=1)
    before = np.linalg.norm(pressed[rows] - face.centres["eye_left"], axis=1)
    assert (distance - before).max() > 1e-3
    assert np.median(distance[before < balls.radii[0]]) >= balls.radii[0] - 2e-4


def test_the_papers_map_has_no_correctives() -> None:
    paper: Cast = CAST.under("paper")
    frame = Frame({"kaori": 1.0}, {NEUTRAL: 1.0}, dict.fromkeys(LIDS, 1.0))
    rest = paper.faces["kaori"].positions
    worn = [compound(paper.space, paper.faces["kaori"], paper.expressions[name]) - rest for name in LIDS]
    assert evaluate(paper, frame) == pytest.approx(rest + sum(worn), abs=1e-6)
