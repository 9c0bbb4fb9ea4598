"""Extraction: under the smooth map too, what is taken from a face is given back; parts and turns are read."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.model.extraction.extract import extract
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.transfer.compound import compound
from tests.synthetic import cast, space

UNITS = ("jawOpen", "eyeBlinkLeft", "mouthSmileRight", "mouthFunnel")


CAST = omote.load_cast()
KNOWN = [
    CAST.expressions[name]
    for name in (*UNITS, "mouthClose", "jawForward", "mouth-open", "mouthSmileLeft", "browInnerUp")
]


def measure_errors(face: Face, shape: Expression, taken: Expression, wearer: Face) -> tuple[float, float]:
    """The worst vertex of what was taken: on the face itself, and on another wearer, metres."""
    errors = [
        np.linalg.norm(compound(CAST.space, each, taken).astype(np.float64) - compound(CAST.space, each, shape), axis=1)
        for each in (face, wearer)
    ]
    return float(errors[0].max()), float(errors[1].max())


def displace(face: Face, shape: Expression) -> NDArray[np.float64]:
    """What a shape does to a face, metres."""
    return compound(CAST.space, face, shape).astype(np.float64) - face.positions


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("name", ["kaori", "dog"])
def test_what_is_taken_from_a_face_is_right_on_it_and_on_others(name: str, unit: str) -> None:
    """Within 0.05 mm on the face, 1 mm on another (what was measured is a twentieth of that), no name being told."""
    face = CAST.faces[name]
    shape = CAST.expressions[unit]
    taken = extract(CAST.space, face, displace(face, shape), known=KNOWN)
    itself, other = measure_errors(face, shape, taken, CAST.faces["man"])
    assert itself < 5e-5
    assert other < 1e-3


@pytest.mark.parametrize(("name", "unit"), [("baby", "eyeBlinkLeft"), ("dog", "mouth-open")])
def test_weights_are_found_so_exactly_that_lids_and_mouth_bag_come_out_the_same(name: str, unit: str) -> None:
    """Most of what moves on the baby is not what the blink says, and a ray of the dog's mouth bag tells nanometres."""
    face = CAST.faces[name]
    shape = CAST.expressions[unit]
    itself, other = measure_errors(
        face, shape, extract(CAST.space, face, displace(face, shape), known=KNOWN), CAST.faces["man"]
    )
    assert itself < 2e-6
    assert other < (2e-6 if unit == "eyeBlinkLeft" else 2e-4)


def test_a_sum_is_taken_from_a_random_face_and_is_right_on_others() -> None:
    weights = np.random.default_rng(11).dirichlet(np.ones(3))
    mixed = sum(
        weight * CAST.faces[name].positions for weight, name in zip(weights, ("dog", "man", "old"), strict=True)
    )
    face = Face("mixed", np.asarray(mixed))
    parts = [CAST.expressions[name] for name in ("jawOpen", "mouthSmileRight")]
    shape = Expression(
        0.4 * parts[0].dtheta + 0.6 * parts[1].dtheta,
        0.4 * parts[0].dh + 0.6 * parts[1].dh,
        0.4 * parts[0].ratio + 0.6 * parts[1].ratio,
        0.4 * parts[0].residual + 0.6 * parts[1].residual,
    )
    taken = extract(CAST.space, face, displace(face, shape), known=KNOWN)
    itself, other = measure_errors(face, shape, taken, CAST.faces["baby"])
    assert itself < 5e-5
    assert other < 1e-3


@pytest.mark.parametrize("unit", UNITS)
def test_nothing_need_be_known_to_give_a_compound_back(unit: str) -> None:
    """Within 0.01 mm, the mouth bag too; a blink's lids, unfolded or pushed out of the eyeball, within 0.05 mm."""
    for name in ("kaori", "doll") if unit == "eyeBlinkLeft" else ("kaori", "baby", "doll"):
        face = CAST.faces[name]
        shape = CAST.expressions[unit]
        taken = extract(CAST.space, face, displace(face, shape))
        itself, _ = measure_errors(face, shape, taken, face)
        assert itself < (5e-5 if unit == "eyeBlinkLeft" else 1e-5), name


def test_what_is_known_must_belong_to_the_space() -> None:
    face = CAST.faces["kaori"]
    still = np.zeros_like(CAST.space.points)
    with pytest.raises(ValueError, match="it was made on another space"):
        extract(CAST.space, face, still, known=[cast().expressions["jawOpen"]])
    with pytest.raises(TypeError, match="the expression is a str"):
        extract(CAST.space, face, still, known=["jawOpen"])  # type: ignore[list-item]


def test_a_displacement_that_asks_for_no_unfolding_comes_back() -> None:
    built = omote.load_cast()
    for name in ("kaori", "baby", "doll", "alien"):
        face = built.faces[name]
        lift = np.zeros((built.space.vertex_count, 3))
        chin = face.positions[built.space.points[:, 2].argmax()] - [0.0, 0.05, 0.0]  # far from eyeballs
        lift[:, 1] = 0.004 * np.exp(-(((face.positions - chin) / 0.02) ** 2).sum(axis=1))
        error = np.abs(compound(built.space, face, extract(built.space, face, lift)) - face.positions - lift)
        assert error[built.space.on_sheet].max() < 1e-5, name


def test_what_is_taken_from_the_generic_face_is_the_same_field_under_both_rules() -> None:
    face = cast().faces["generic"]
    jaw = cast().expressions["jawOpen"]
    moved = compound(space(), face, jaw) - face.positions
    smooth = extract(space(), face, moved)
    paper = extract(space().under("paper"), face, moved)
    assert smooth.dtheta == pytest.approx(paper.dtheta, abs=1e-9)
    assert smooth.dh == pytest.approx(paper.dh, abs=1e-9)
    assert smooth.ratio == pytest.approx(paper.ratio, abs=1e-9)
    assert (smooth.transfer, paper.transfer) == ("smooth", "paper")


def test_positions_and_millimetres_are_rejected_with_what_to_do() -> None:
    face = CAST.faces["kaori"]
    moved = displace(face, CAST.expressions["jawOpen"])
    worn = face.positions + moved
    for wrong, message in (
        (worn, "these are positions; expected how far each vertex goes from rest, metres: subtract face.positions"),
        (1000.0 * worn, "these are positions in millimetres; expected how far"),
        (
            1000.0 * moved,
            r"row \d+ of the displacement is .* m; expected at most 0.25 m, as the head is long: give it in met",
        ),
    ):
        with pytest.raises(ValueError, match=message):
            extract(CAST.space, face, wrong)
    name, points = next(iter(face.parts.items()))
    with pytest.raises(ValueError, match=f"row 0 of the displacement of part '{name}' is .*divide millimetres by 1000"):
        extract(CAST.space, face, moved, parts={name: np.full_like(points, 3.0)})
