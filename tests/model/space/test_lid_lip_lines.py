"""Lines: found around the openings, rungs from one side to the other."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.space.lid_lip_lines import JAW_ALIKE, LIPS_ALIKE, RUNGS, Line, find_line, jaw_amplitude, lip_amplitude
from omote.model.space.parameter_space import ParameterSpace


@pytest.fixture(scope="module")
def space() -> ParameterSpace:
    return omote.load_cast().space


def line(space: ParameterSpace, name: str) -> Line:
    eye = space.parts["eye_left"].points.mean(axis=0)
    near = {"lid_left": eye, "lid_right": eye * [-1, 1, 1], "lips": np.array([0.0, -0.067, 0.148])}[name]
    sheet = space.sheet_triangles
    kind = "lips" if name == "lips" else "lids"
    return find_line(name, kind, space.points, sheet, space.membranes, space.cylinder, near)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", ["lid_left", "lid_right", "lips"])
def test_a_line_is_a_closed_path_along_the_sheets_edges_that_visits_no_vertex_twice(
    space: ParameterSpace, name: str
) -> None:
    found = line(space, name)
    edges = {tuple(sorted(pair)) for a, b, c in space.skin_triangles.tolist() for pair in ((a, b), (b, c), (c, a))}
    loop = found.loop.tolist()
    assert all(tuple(sorted(pair)) in edges for pair in zip(loop, loop[1:] + loop[:1], strict=True))
    assert len(set(loop)) == len(loop)
    assert 20 <= len(loop) <= 60


def test_the_rungs_lead_up_and_a_shift_leaves_them_alone(space: ParameterSpace) -> None:
    for name in ("lid_left", "lid_right", "lips"):
        found = line(space, name)
        rungs = found.rungs(space.points)
        assert rungs.shape == (RUNGS, 3)
        assert (rungs[2:-2, 1] > 0).all()
        assert np.allclose(found.rungs(space.points + np.array([1.0, -2.0, 3.0])), rungs, atol=1e-9)
        assert np.isin(found.vertices, found.loop).all()


def test_left_and_right_lids_mirror_each_other(space: ParameterSpace) -> None:
    left = line(space, "lid_left")
    right = line(space, "lid_right")
    mirrored = np.sort(space.points[right.loop] * [-1, 1, 1], axis=0)
    assert np.allclose(np.sort(space.points[left.loop], axis=0), mirrored, atol=2e-4)


def test_the_jaw_goes_as_far_as_the_mouth_is_wide_and_no_farther_than_on_the_generic_face(
    space: ParameterSpace,
) -> None:
    wide = [
        jaw_amplitude(space.lines, space.points, scale * space.points) for scale in (0.5, 0.7, 0.95, 1.0, 1.05, 2.0)
    ]
    assert wide == pytest.approx([0.5 * np.exp(JAW_ALIKE), 0.7 * np.exp(JAW_ALIKE), 1.0, 1.0, 1.0, 1.0])
    assert jaw_amplitude((line(space, "lid_left"),), space.points, space.points) is None


def test_lips_open_as_the_mouth_is_wide_closer_than_the_jaw_goes(space: ParameterSpace) -> None:
    lips = line(space, "lips")
    scales = np.array([0.5, 0.9, 0.97, 1.0, 1.04, 1.1, 2.0])
    wide = [lip_amplitude(lips, space.points, scale * space.points) for scale in scales]
    slack = np.exp(LIPS_ALIKE)
    assert wide == pytest.approx([0.5 * slack, 0.9 * slack, 1.0, 1.0, 1.0, 1.1 / slack, 2.0 / slack])
    assert LIPS_ALIKE < JAW_ALIKE


def test_a_sheet_without_an_opening_is_refused() -> None:
    row, column = np.meshgrid(np.arange(9), np.arange(9), indexing="ij")
    points = np.stack([(column - 4) * 0.01, row * 0.01, np.full_like(row, 0.1, dtype=float)], axis=2).reshape(-1, 3)
    a = (row * 9 + column)[:-1, :-1].ravel()
    sheet = np.concatenate([np.stack([a, a + 1, a + 10], 1), np.stack([a, a + 10, a + 9], 1)]).astype(np.int32)
    cylinder = omote.load_cast().space.cylinder
    with pytest.raises(ValueError, match="no line 'lips' goes around the opening"):
        find_line("lips", "lips", points, sheet, sheet[:1], cylinder, points[0])
