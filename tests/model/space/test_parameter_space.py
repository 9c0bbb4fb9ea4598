"""The parameter space: one clean layer on any head, found without help, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from omote.geometry import mesh
from omote.model.space.parameter_space import ParameterSpace, smoothed_scale
from omote.model.space.skin_sheet import unwrap_corners
from tests.model.heads import ict_facekit, perry_smith
from tests.synthetic import head


def layers_over(space: ParameterSpace, theta: np.ndarray, h: np.ndarray) -> np.ndarray:
    """How many location triangles hold each point, by looking at all of them."""
    corners = space.location_triangles
    x, y = unwrap_corners(space.theta, corners), space.h[corners]
    count = np.zeros(len(theta), int)
    for i, (angle, height) in enumerate(zip(theta, h, strict=True)):
        near = angle + 2 * np.pi * np.round((x.mean(axis=1) - angle) / (2 * np.pi))
        sides = [
            (x[:, (k + 1) % 3] - x[:, k]) * (height - y[:, k]) - (y[:, (k + 1) % 3] - y[:, k]) * (near - x[:, k])
            for k in range(3)
        ]
        count[i] = (np.min(sides, axis=0) > 0).sum()
    return count


def assert_clean(space: ParameterSpace) -> None:
    """One layer, no holes but the rims around the axis; every vertex is either on the sheet or inner skin."""
    corners = space.location_triangles
    metric = float(space.cylinder.unroll(space.points[space.on_sheet])[2].mean())
    plane = np.stack([space.theta * metric, space.h], axis=1)
    for loop in mesh.boundary_loops(corners, plane, period=2 * np.pi * metric):
        steps = np.diff(space.theta[np.r_[loop, loop[0]]])
        around = ((steps + np.pi) % (2 * np.pi) - np.pi).sum()
        assert abs(abs(around) - 2 * np.pi) < 1e-6, f"a hole of {len(loop)} vertices stayed open"
    rng = np.random.default_rng(0)
    low, high = np.quantile(space.h[space.on_sheet], [0.2, 0.9])
    h = rng.uniform(low, high, 300)
    assert (layers_over(space, rng.uniform(-np.pi, np.pi, 300), h) == 1).all()
    assert np.array_equal(np.flatnonzero(~space.on_sheet), space.inner.vertices)
    assert np.allclose(space.inner.weights.sum(axis=1), 1.0, atol=1e-5)
    assert space.on_sheet[space.inner.anchors[space.inner.weights > 0]].all()


def test_the_synthetic_head_is_clean_and_its_mouth_is_closed_by_membranes() -> None:
    space = ParameterSpace.build(*head())
    assert_clean(space)
    assert len(space.membranes) > 0
    assert len(space.inner.vertices) > 0


@pytest.mark.data
def test_the_ict_head_gives_a_clean_sheet() -> None:
    space = ParameterSpace.build(*ict_facekit())
    assert_clean(space)
    assert space.on_sheet.sum() > 9000


@pytest.mark.data
def test_the_perry_smith_scan_gives_a_clean_sheet() -> None:
    space = ParameterSpace.build(*perry_smith())
    assert_clean(space)
    assert space.on_sheet.sum() > 5000


def test_a_space_does_not_depend_on_the_unit_of_length() -> None:
    points, triangles = head()
    small = ParameterSpace.build(points, triangles)
    large = ParameterSpace.build(points * 100, triangles)
    assert np.array_equal(small.skin_triangles, large.skin_triangles)
    assert np.isclose(small.cylinder.z * 100, large.cylinder.z)


def test_vertices_doubled_at_a_seam_change_nothing() -> None:
    points, triangles = head()
    whole = ParameterSpace.build(points, triangles)
    split = triangles.copy()
    half = points[triangles].mean(axis=1)[:, 0] > 0
    copies = np.unique(triangles[half])
    split[half] = np.searchsorted(copies, triangles[half]) + len(points)
    seamed = ParameterSpace.build(np.concatenate([points, points[copies]]), split)
    assert len(seamed.skin_triangles) == len(whole.skin_triangles)
    assert len(seamed.membranes) == len(whole.membranes)


def test_the_scale_of_a_larger_face_is_its_size() -> None:
    space = ParameterSpace.build(*head())
    assert np.allclose(smoothed_scale(space, space.points * 1.7), 1.7)


def test_a_space_refuses_what_is_no_head() -> None:
    points, triangles = head()
    broken = points.copy()
    broken[7, 1] = np.nan
    with pytest.raises(ValueError, match=r"points\[7\].*finite"):
        ParameterSpace.build(broken, triangles)
    flat = points.copy()
    flat[triangles[5, 0]] = flat[triangles[5, 1]]
    with pytest.raises(ValueError, match="has no area"):
        ParameterSpace.build(flat, triangles)
    with pytest.raises(ValueError, match="wound counter-clockwise"):
        ParameterSpace.build(points, triangles[:, ::-1])
    with pytest.raises(ValueError, match=r"outside the head|straight ahead"):
        ParameterSpace.build(points, triangles, axis=(0.0, -0.5))
    for axis in (
        3.0,
        (0.0,),
        (0.0, 0.0, 0.0),
        "ab",
        (None, 0.0),
        (True, False),
        (1j, 0.0),
        (np.inf, 0.0),
        (1e300, 0.0),
    ):
        with pytest.raises(ValueError, match=r"axis .*expected (two|finite|an array)|axis has no numbers"):
            ParameterSpace.build(points, triangles, axis=axis)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"radius is array.*expected one of"):
        ParameterSpace.build(points, triangles, radius=np.zeros(3))  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"no vertex lies in the upper half .*expected a head"):
        ParameterSpace.build([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    with pytest.raises(ValueError, match="radius is 'paper'; expected one of 'origin', 'surface'"):
        ParameterSpace.build(points, triangles, radius="paper")  # type: ignore[arg-type]
