"""The people of the built-in cast and what they can do."""

from dataclasses import replace
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import omote
from omote import builtin
from omote.builtin.binding import PARTS
from omote.geometry.orientation import area_shares, rest_normals
from omote.model.space.ears import rotations
from omote.model.space.face import Face
from omote.model.space.gain import gain_of
from omote.model.space.skin_sheet import refuse_axis_outside
from omote.model.transfer.compound import compound_parts
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.smooth_map import prepare_smooth_map
from tests.pictures import read_png
from tools.baking.expressions import (
    ARKIT,
    MAKEHUMAN,
    OMOTE,
    PERFORMED,
    PUPILS,
    SPRING_EARS,
    SPRINGS,
    ear_turns,
    head_turn,
)

CAST = omote.load_cast()
LIMBS = [*builtin.load_figures().limb_fields]
GENERIC = CAST.faces["generic"]
FACES = list(CAST.faces.values())
ANIMAL_EMOTIONS = ("surprise", "sad", "disgust", "angry", "fear")
# On the generic head, metres: middles of the upper and the lower lid, and of both lips.
LIDS_AND_LIPS = np.array([[31, 4.7, 141], [31, -4.4, 140], [0, -62, 160], [0, -74, 156]]) / 1000


def name_of(face: Face) -> str:
    return face.name


def moved_skin(name: str) -> NDArray[np.float64]:
    """How far each vertex of the generic skin goes, metres."""
    worn = omote.compound(CAST.space, GENERIC, CAST.expressions[name])
    return np.asarray(np.linalg.norm(worn.astype(np.float64) - GENERIC.positions, axis=1))


def moved_parts(name: str) -> dict[str, NDArray[np.float64]]:
    """How each part of the generic face goes, (n, 3) metres, eyeballs before their turn."""
    worn = compound_parts(CAST.space, GENERIC, CAST.expressions[name])
    return {part: worn[part].astype(np.float64) - GENERIC.parts[part] for part in PARTS}


def still_parts(name: str) -> set[str]:
    """The parts that do not move by a hundredth of a millimetre."""
    return {part for part, moves in moved_parts(name).items() if np.linalg.norm(moves, axis=1).max() < 1e-5}


def animal_signals(face: Face, name: str) -> tuple[float, float, float, float]:
    """How far an emotion lays the ears back and raises the head, degrees, and opens lids and lips, millimetres."""
    expression = CAST.expressions[name]
    worn = omote.compound(CAST.space, face, expression).astype(np.float64) - face.positions
    rows = [np.linalg.norm(CAST.space.points - place, axis=1).argmin() for place in LIDS_AND_LIPS]
    upper_lid, lower_lid, upper_lip, lower_lip = 1000 * worn[rows, 1]
    back = gain_of(face.gains, "ears", name) * np.degrees(expression.ears[0, 0])
    pitch = gain_of(face.gains, "head", name) * np.degrees(expression.head[1])
    return back, pitch, upper_lid - lower_lid, upper_lip - lower_lip


def test_the_skin_is_the_designs() -> None:
    assert (CAST.space.vertex_count, len(CAST.space.triangles)) == (4278, 8508)


def test_there_are_twelve_people_and_five_sculpted_faces() -> None:
    assert {"generic", "kaori", "round", "child", "old", "doll"} < CAST.faces.keys()
    assert [*CAST.faces][12:] == ["auntie", "cat", "count", "dog", "noh"]


def test_the_generic_face_is_the_spaces_own() -> None:
    np.testing.assert_array_equal(GENERIC.positions, CAST.space.points.astype(np.float32))


def test_people_differ_by_millimetres() -> None:
    for a, b in combinations(FACES, 2):
        assert np.sqrt(((a.positions - b.positions) ** 2).sum(axis=1).mean()) > 0.003, (a.name, b.name)


def test_looks_differ() -> None:
    assert len({CAST.looks[face.name].skin for face in FACES}) == len(FACES)


def test_all_units_are_there_by_their_exact_names() -> None:
    kinds: dict[str, list[str]] = {}
    for name in CAST.expressions:
        kinds.setdefault(CAST.titles[name].kind, []).append(name)
    expected = {"neutral": ["neutral"], "performed": [*PERFORMED], "arkit": [*ARKIT], "makehuman": [*MAKEHUMAN]}
    expected |= {"omote": [*OMOTE], "spring": [*SPRINGS], "limb": LIMBS}
    assert kinds == expected
    assert {kind: len(names) for kind, names in kinds.items()} == {
        "neutral": 1, "performed": 20, "arkit": 52, "makehuman": 34, "omote": 6, "spring": 4, "limb": 10,
    }  # fmt: skip
    assert {
        "smile",
        "laugh",
        "sad",
        "cry",
        "angry",
        "surprise",
        "fear",
        "disgust",
        "sleepy",
        "kiss",
    } <= PERFORMED.keys()


def test_titles_name_a_region_of_the_face() -> None:
    regions = {"brows", "eyes", "nose", "cheeks", "mouth", "jaw", "tongue", "ears", "whole", "body"}
    assert {title.region for title in CAST.titles.values()} == regions
    assert CAST.titles["mouth-corner-puller"].label == "Smile with closed lips"


def test_every_expression_but_neutral_moves_something() -> None:
    for name in CAST.expressions:
        still = (
            moved_skin(name).max() < 1e-5 and still_parts(name) == {*PARTS} and not CAST.expressions[name].eyes.any()
        )
        assert still == (name == "neutral" or name in (*OMOTE, *SPRING_EARS, *LIMBS)), name


def test_pupils_move_by_what_the_table_says() -> None:
    for name, expression in CAST.expressions.items():
        assert expression.pupil == pytest.approx({**PUPILS, **OMOTE}.get(name, 0.0)), name


def test_ears_and_heads_turn_by_what_the_tables_say_and_no_persons_do() -> None:
    for name, expression in CAST.expressions.items():
        assert (expression.name, expression.signed) == (name, name in SPRINGS)
        np.testing.assert_allclose(expression.ears, ear_turns(name), atol=1e-7)
        np.testing.assert_allclose(expression.head, head_turn(name), atol=1e-7)
    assert not any(CAST.faces[name].gains for name in ("generic", "kaori", "man"))


@pytest.mark.parametrize("face", FACES, ids=name_of)
@pytest.mark.parametrize("name", SPRINGS)
def test_what_springs_play_folds_no_face_at_either_end(face: Face, name: str) -> None:
    """Seen along normals at rest, which turn with the ears."""
    rest = face.positions.astype(np.float64)
    corners = CAST.space.sheet_triangles
    moved = omote.compound(CAST.space, face, CAST.expressions[name]).astype(np.float64) - rest
    turns = gain_of(face.gains, "ears", name) * CAST.expressions[name].ears
    for weight in (-1.0, -0.5, 0.5, 1.0):
        normals, sizes = rest_normals(rest, corners)
        for weights, (_, axis) in rotations(CAST.space, face.positions, weight * turns) if turns.any() else ():
            normals = Rotation.from_rotvec(weights[corners].mean(axis=1)[:, None] * axis).apply(normals)
        assert area_shares(rest + weight * moved, normals, sizes, corners).min() > 0.0, weight


def test_ears_swing_on_animals_alone_and_jowls_most_on_the_heavy() -> None:
    def reach(face: Face, name: str) -> float:
        worn = omote.compound(CAST.space, face, CAST.expressions[name]).astype(np.float64)
        return float(np.linalg.norm(worn - face.positions, axis=1).max())

    for name in SPRING_EARS:
        assert {face.name for face in FACES if reach(face, name) > 1e-5} == {"dog", "cat"}
    for name in ("jowls-sway", "cheeks-bounce"):
        reached = {face.name: reach(face, name) for face in FACES}
        assert max(reached, key=lambda each: reached[each]) == "heavy"
        assert max(reached[each] for each in ("noh", "doll", "gaunt")) < 0.5 * reached["generic"]


@pytest.mark.parametrize("face", ["dog", "cat"])
def test_animals_tell_emotions_by_ears_head_lids_and_teeth(face: str) -> None:
    ears, head, lids, lips = np.transpose([animal_signals(CAST.faces[face], name) for name in ANIMAL_EMOTIONS])
    surprise, sad, disgust, angry, fear = range(5)
    assert ears[surprise] < -20 < 0 < 1.25 * ears[sad] < ears[disgust] < 0.75 * ears[angry] < 0.75 * ears[fear]
    assert head[sad] < -12 < -5 > head[angry]
    assert head[fear] > 5
    assert lids[disgust] < 2 * lids[angry] < 0
    assert min(lids[fear], lids[surprise]) > 5
    assert lips[sad] < 0.1
    assert lips[angry] > 1.75 * lips[disgust] > 0


@pytest.mark.parametrize("face", FACES, ids=name_of)
def test_a_change_of_face_leaves_the_eyes_where_they_are(face: Face) -> None:
    def middle(of: Face) -> NDArray[np.float64]:
        eyes = np.concatenate([of.parts["eye_left"], of.parts["eye_right"]]).astype(np.float64)
        return np.asarray((eyes.min(axis=0) + eyes.max(axis=0)) / 2)

    np.testing.assert_allclose(middle(face), middle(GENERIC), atol=1e-6)
    np.testing.assert_allclose(middle(face)[:2], 0.0, atol=1e-6)


@pytest.mark.parametrize("face", FACES, ids=name_of)
def test_the_axis_is_inside_every_skull(face: Face) -> None:
    points = face.positions.astype(np.float64)
    refuse_axis_outside(points, CAST.space.location_triangles, CAST.space.cylinder)
    assert points[:, 2].min() < -0.025 < 0.1 < points[:, 2].max()


@pytest.mark.parametrize("face", FACES, ids=name_of)
def test_heads_are_of_one_order_of_size(face: Face) -> None:
    def above_the_eyes(of: Face) -> float:
        return float(of.positions[:, 1].max())

    assert 0.7 < above_the_eyes(face) / above_the_eyes(GENERIC) < 1.2


@pytest.mark.parametrize("face", FACES, ids=name_of)
@pytest.mark.parametrize("side", ["left", "right"])
def test_eyes_sit_in_their_sockets(face: Face, side: str) -> None:
    ball = face.parts[f"eye_{side}"].astype(np.float64)
    centre = ball.mean(axis=0)
    radius = np.linalg.norm(ball - centre, axis=1)
    lids = CAST.space.parts["lashes"].anchors
    lids = np.unique(lids[(GENERIC.parts["lashes"][:, 0] > 0) == (side == "left")])
    off = np.linalg.norm(face.positions[lids] - centre, axis=1) / radius.mean()
    assert np.ptp(radius) < 0.1 * radius.mean()
    assert (off > 0.7).all()
    assert np.median(off) < 1.25


@pytest.mark.parametrize("name", ["jawOpen", "mouth-open"])
def test_an_opened_jaw_takes_the_lower_teeth_and_the_tongue_along(name: str) -> None:
    moves = moved_parts(name)
    assert moves["teeth_lower"][:, 1].mean() < -0.015
    assert moves["tongue"][:, 1].mean() < -0.01
    assert still_parts(name) == {"eye_left", "eye_right", "teeth_upper", "lashes"}


def test_tongue_out_moves_only_the_tongue() -> None:
    assert moved_skin("tongueOut").max() < 1e-7  # float32
    assert still_parts("tongueOut") == {*PARTS} - {"tongue"}
    assert moved_parts("tongueOut")["tongue"][:, 2].mean() > 0.01


@pytest.mark.parametrize("side", ["Left", "Right"])
@pytest.mark.parametrize("way", ["Up", "Down", "In", "Out"])
def test_looking_turns_the_eyeball_rigidly_and_moves_the_lashes(side: str, way: str) -> None:
    name = f"eyeLook{way}{side}"
    eyes = CAST.expressions[name].eyes
    this, other = (0, 1) if side == "Left" else (1, 0)
    assert np.abs(eyes[this]).max() > 0.15
    np.testing.assert_allclose(eyes[other], 0.0, atol=1e-6)
    assert still_parts(name) == {*PARTS} - {"lashes"}


@pytest.mark.parametrize("side", ["Left", "Right"])
def test_a_blink_takes_the_lashes_along_and_leaves_the_other_eye(side: str) -> None:
    moves = np.linalg.norm(moved_parts(f"eyeBlink{side}")["lashes"], axis=1)
    ours = (GENERIC.parts["lashes"][:, 0] > 0) == (side == "Left")
    assert moves[ours].max() > 0.005
    assert moves[~ours].max() < 1e-5


def test_the_mask_has_lips_brows_and_blush_where_the_face_has_them() -> None:
    mask = read_png(builtin.load_mask())
    skin = builtin.load_meshes()[0]
    assert mask.shape == (8 * 1024, 1024, 4)  # the layers lie one below the other; this is the first
    texel = (skin.uv * 1023).round().astype(int)
    lips, brows, blush, light = mask[texel[:, 1], texel[:, 0]].astype(float).T / 255
    x, y, z = GENERIC.positions[skin.source].T
    forehead = (z > 0.12) & (y > 0.045)
    cheek = (z > 0.1) & (np.abs(np.abs(x) - 0.043) < 0.006) & (np.abs(y + 0.03) < 0.006)
    assert lips[(z > 0.15) & (np.abs(x) < 0.005) & (np.abs(y + 0.072) < 0.003)].min() > 0.7
    assert forehead.any()
    assert (lips[forehead].max(), brows[forehead].max()) == (0.0, 0.0)
    assert light[forehead].min() > 0.9
    assert blush[cheek].min() > 0.4
    assert brows.max() > 0.5


def test_the_sky_is_open_over_the_forehead_and_shut_inside_the_mouth() -> None:
    meshes = {mesh.name: mesh for mesh in builtin.load_meshes()}
    for mesh in meshes.values():
        assert mesh.openness.shape == mesh.source.shape
    skin = meshes["skin"]
    forehead = np.linalg.norm(GENERIC.positions[skin.source] - (0.0, 0.063, 0.145), axis=1).argmin()
    assert skin.openness[forehead] > 230
    assert np.median(meshes["tongue"].openness) < 60


def test_a_missing_cast_is_refused_with_what_to_do(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"cast is missing: there is no cast.npz in .*; run `make bake`"):
        builtin.read_cast(tmp_path / "cast.npz")


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04 cut off", b"\x80\x04 a pickle"])
def test_a_broken_cast_is_refused_with_what_to_do(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "cast.npz"
    path.write_bytes(content)
    with pytest.raises(ValueError, match=r"cast.npz is not a cast of this version .*delete it and run `make bake`"):
        builtin.read_cast(path)


def test_a_missing_or_broken_mask_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "mask.png"
    monkeypatch.setattr(builtin, "MASK", path)
    builtin.load_mask.cache_clear()
    with pytest.raises(FileNotFoundError, match=r"no mask.png .*`make bake`"):
        builtin.load_mask()
    path.write_bytes(b"GIF89a")
    with pytest.raises(ValueError, match=r"mask.png is not .*it is no PNG.*`make bake`"):
        builtin.load_mask()
    builtin.load_mask.cache_clear()


def test_the_notice_travels_with_the_cast() -> None:
    text = builtin.NOTICE.read_text()
    assert "CC0 1.0 Universal" in text
    assert "Mika Suominen" in text


@pytest.mark.parametrize("face", [CAST.faces[name] for name in ("generic", "kaori", "baby", "cat", "dog")], ids=name_of)
def test_closed_eyes_fold_nothing_and_no_lid_lies_over_the_other(face: Face) -> None:
    """Crossed by a tenth of the eye's height at most; the published blink crosses by a half."""
    ready = prepare_smooth_map(CAST.space, face)
    for name in ("wink", "pain", "asleep", "eyeBlinkLeft", "cry"):
        still = replace(CAST.expressions[name], ears=np.zeros((2, 3)))  # how far ears turn is no fold
        worn = omote.compound(CAST.space, face, still).astype(np.float64)
        assert not find_folds(ready.geometry, worn, ready.generic).any(), name
        for contact in ready.contacts:
            if contact.line.kind == "lids":
                opening = (contact.target * contact.line.rungs(worn)).sum(axis=1)
                assert opening.min() > -0.1 * contact.here.max(), name
