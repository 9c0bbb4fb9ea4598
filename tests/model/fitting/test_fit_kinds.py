"""Heads that are no person's: they begin from sculpted ones; people, and who says too little, are fitted as before."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import omote
from omote.builtin import load_head_kinds, load_identity_modes
from omote.geometry.proximity import winding_numbers
from omote.model.fitting import fit_kinds as module
from omote.model.fitting.find_head import find_head
from omote.model.fitting.fit_face import Fit, fit_face
from omote.model.fitting.fit_kinds import BEYOND, FEWEST, bend_to_landmarks, fit_kinds, measure_miss
from omote.model.fitting.landmarks import find_landmarks
from omote.model.fitting.scan import Scan
from omote.model.space.face import Face

CAST = omote.load_cast()
SPACE = CAST.space
MODES = load_identity_modes()
KINDS = load_head_kinds()
ROWS = find_landmarks(SPACE)
DOG, OLD = (CAST.faces[name].positions.astype(np.float64) for name in ("dog", "old"))
Values = NDArray[np.float64]


def marks_of(skin: Values) -> dict[str, Values]:
    return {name: skin[row] for name, row in ROWS.items()}


def fit_marked(skin: Values, marks: Mapping[str, Values], told: list[float] | None = None) -> Fit:
    scan = Scan(skin, SPACE.triangles)
    place = find_head(SPACE, MODES, scan, landmarks=marks)
    follow = None if told is None else lambda done, _: told.append(done)
    return fit_kinds(SPACE, KINDS, scan, place, landmarks=marks, shut=False, follow=follow)


def test_an_animal_is_found_again_from_an_animal_without_a_fold_and_with_one_doubt() -> None:
    told = list[float]()
    found = fit_marked(1.1 * DOG, marks_of(1.1 * DOG), told)
    assert np.nanmedian(found.residual) < 0.05
    (doubt,) = found.doubts  # so nothing stays folded
    assert "it began from the cast's dog" in doubt
    assert found.kind == "dog"
    assert told == sorted(told)
    assert told[-1] == 1.0


@pytest.mark.slow
def test_a_person_is_fitted_as_before() -> None:
    scan = Scan(OLD, SPACE.triangles)
    marks = marks_of(OLD)
    place = find_head(SPACE, MODES, scan, landmarks=marks)
    plain = fit_face(SPACE, MODES, scan, place.similarity, landmarks=marks, shut=False)
    found = fit_marked(OLD, marks)
    np.testing.assert_array_equal(found.face.positions, plain.face.positions)
    assert (found.doubts, found.kind) == (plain.doubts, "people")


@pytest.mark.slow
def test_few_landmarks_and_none_say_too_little_for_an_animal() -> None:
    few = dict(list(marks_of(DOG).items())[: FEWEST - 1])
    assert not any("no person's" in doubt for doubt in fit_marked(DOG, few).doubts)


@pytest.mark.slow
def test_where_no_animal_can_be_fitted_a_person_is(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise ValueError("too flat")

    monkeypatch.setattr(module, "_fit_bent", refuse)
    assert not any("no person's" in doubt for doubt in fit_marked(DOG, marks_of(DOG)).doubts)


def test_a_tongue_below_the_chin_becomes_smaller_until_it_lies_inside_of_the_mouth_that_closes_again() -> None:
    cat = CAST.faces["cat"]
    low = {name: cat.parts[name] - np.array([0.0, 0.02, 0.0], np.float32) for name in ("tongue", "teeth_lower")}
    assert outside(replace(cat, parts={**cat.parts, **low})) > 0
    found = module._fit_mouth(SPACE, replace(cat, parts={**cat.parts, **low}))
    assert outside(found) == 0
    assert np.ptp(found.parts["tongue"]) < np.ptp(cat.parts["tongue"])
    np.testing.assert_array_equal(found.parts["eye_left"], cat.parts["eye_left"])
    assert module._fit_mouth(SPACE, cat) is cat


def outside(face: Face) -> int:
    """How many points of the tongue lie outside of a skin."""
    probes = face.parts["tongue"].astype(np.float64)
    skin = face.positions.astype(np.float64)
    return int((winding_numbers(skin[SPACE.location_triangles], probes) < 0.5).sum())


def test_people_and_animals_are_told_apart_by_their_landmarks() -> None:
    miss = {name: measure_miss(SPACE, MODES, marks_of(face.positions.astype(np.float64))) for name, face in
            CAST.faces.items()}  # fmt: skip
    assert [name for name, away in miss.items() if away > BEYOND] == ["dog"]


@given(st.integers(0, 2**32 - 1), st.floats(0.001, 0.03))
def test_a_head_is_bent_towards_landmarks_and_stays_where_they_are_met(seed: int, size: float) -> None:
    goals = {name: point + size * np.random.default_rng(seed).normal(size=3) for name, point in
             marks_of(MODES.skin).items()}  # fmt: skip
    bent = bend_to_landmarks(SPACE, MODES, goals)
    before, after = (
        np.linalg.norm([skin[ROWS[name]] - goal for name, goal in goals.items()]) for skin in (MODES.skin, bent.skin)
    )
    assert after < 0.5 * before
    same = bend_to_landmarks(SPACE, MODES, marks_of(MODES.skin))
    np.testing.assert_array_equal(same.skin, MODES.skin)
    assert all(np.array_equal(points, MODES.parts[name]) for name, points in same.parts.items())
