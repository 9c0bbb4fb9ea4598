"""What correctives need to know of the skin around eyes and mouth."""

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.geometry.orientation import area_shares, rest_normals
from omote.model.cast import Cast
from omote.model.space.lid_lip_lines import RUNGS
from omote.model.transfer.compound import compound
from omote.model.transfer.corrective_regions import CORNERS, REACH, THROAT, CorrectiveRegions, find_corrective_regions


@pytest.fixture(scope="module")
def cast() -> Cast:
    return load_cast()


@pytest.fixture(scope="module")
def regions(cast: Cast) -> CorrectiveRegions:
    found = find_corrective_regions(cast.space)
    assert found is not None
    return found


def test_only_a_smooth_space_with_lines_has_one(cast: Cast) -> None:
    assert find_corrective_regions(cast.space) is find_corrective_regions(cast.space)
    assert find_corrective_regions(cast.space.under("paper")) is None


def test_each_vertex_gives_way_to_one_line_and_fully_on_it(regions: CorrectiveRegions, cast: Cast) -> None:
    near = np.concatenate([crossing.near for crossing in regions.crossings])
    assert len(np.unique(near)) == len(near)
    for crossing, line in zip(regions.crossings, cast.space.lines, strict=True):
        side = np.zeros(len(regions.rows))
        side[crossing.near] = crossing.side
        upper = crossing.vertices[:, :2]
        lower = crossing.vertices[:, 2:]
        # All but the corners, where both halves meet.
        assert np.quantile(side[upper], 0.1) == pytest.approx(1.0)
        assert np.quantile(side[lower], 0.9) == pytest.approx(-1.0)
        assert np.abs(side).max() == pytest.approx(1.0)
        assert np.array_equal(regions.rows[crossing.vertices], line.vertices)


def test_shares_grow_along_the_line(regions: CorrectiveRegions) -> None:
    for crossing in regions.crossings:
        share = np.full(len(regions.rows), np.nan)
        share[crossing.near] = crossing.share
        middles = (np.arange(RUNGS) + 0.5) / RUNGS
        for columns in (slice(0, 2), slice(2, 4)):
            weights = np.abs(crossing.weights[:, columns])
            found = (share[crossing.vertices[:, columns]] * weights).sum(axis=1)
            assert found[1:-1] == pytest.approx(middles[1:-1], abs=1e-9)  # the corners give way to neither side


def test_triangles_are_those_of_the_sheet_between_rows(regions: CorrectiveRegions, cast: Cast) -> None:
    inside = np.isin(cast.space.sheet_triangles, regions.rows).all(axis=1)
    assert np.array_equal(regions.rows[regions.triangles], cast.space.sheet_triangles[inside])


def test_rows_lie_around_the_lines_on_the_throat_and_at_the_jaws_corners(
    regions: CorrectiveRegions, cast: Cast
) -> None:
    points = cast.space.points
    loops = {line.kind: points[line.loop] for line in cast.space.lines}
    width = max(np.ptp(points[line.loop, 0]) for line in cast.space.lines)
    every = np.concatenate([points[line.loop] for line in cast.space.lines])
    here = points[np.unique(cast.space.sheet_triangles)]
    inside = np.isin(np.unique(cast.space.sheet_triangles), regions.rows)
    near = np.linalg.norm(here[:, None] - every, axis=2).min(axis=1) < REACH * width
    lips = loops["lips"]
    below = here[:, 1] < lips[:, 1].min() + CORNERS * np.ptp(lips[:, 0])
    throat = below & (np.linalg.norm(here[:, None] - lips, axis=2).min(axis=1) < THROAT * np.ptp(lips[:, 0]))
    assert np.array_equal(inside, near | throat)


@pytest.mark.parametrize("face", ["baby", "round", "kaori", "alien", "dog"])
def test_a_mouth_opened_wide_leaves_a_quarter_of_each_triangle_beyond_rows(
    regions: CorrectiveRegions, cast: Cast, face: str
) -> None:
    triangles = cast.space.sheet_triangles
    beyond = triangles[~np.isin(triangles, regions.rows).all(axis=1)]
    normals, sizes = rest_normals(cast.faces[face].positions.astype(np.float64), beyond)
    worn = compound(cast.space, cast.faces[face], cast.expressions["mouth-open"]).astype(np.float64)
    assert area_shares(worn, normals, sizes, beyond).min() > 0.25


def test_patches_share_all_skin_but_the_jaws(regions: CorrectiveRegions, cast: Cast) -> None:
    patches = regions.patches
    shares = patches.shares.sum(axis=1)
    heights = cast.space.points[regions.rows, 1]
    lips = next(line for line in cast.space.lines if line.kind == "lips")
    eyes = np.concatenate([line.loop for line in cast.space.lines if line.kind == "lids"])
    assert (patches.shares >= 0.0).all()
    assert shares.max() < 1.0 + 1e-6
    assert (shares[np.isin(regions.rows, eyes)] > 1.0 - 1e-6).all()
    assert (shares[heights < cast.space.points[lips.loop, 1].min() - 0.05] < 0.01).all()
    assert (np.diff(patches.ends, prepend=0) > 0).all()
    assert (patches.ends[-1], patches.members.max() + 1) == (len(patches.triangles), len(patches.ends))


def test_lids_lie_around_their_own_eye(regions: CorrectiveRegions, cast: Cast) -> None:
    x = cast.space.points[regions.rows[regions.lids], 0]
    for number, name in enumerate(regions.eyes):
        centre = cast.space.parts[name].points[:, 0].mean()
        other = -centre
        mine = x[regions.eye == number]
        assert len(mine) > 0
        assert (np.abs(mine - centre) < np.abs(mine - other) + 1e-9).all()


def test_inner_skin_follows_and_lashes_stick(regions: CorrectiveRegions, cast: Cast) -> None:
    assert regions.attached_parts == ("lashes",)
    assert not np.isin(regions.followers, regions.rows).any()
    assert (regions.weights.sum(axis=1) < 1.0 + 1e-5).all()
