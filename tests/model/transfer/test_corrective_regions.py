"""What sums need to know of the skin around eyes and mouth."""

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.model.cast import Cast
from omote.model.space.lid_lip_lines import RUNGS
from omote.model.transfer.corrective_regions import Settling, settling_of


@pytest.fixture(scope="module")
def cast() -> Cast:
    return load_cast()


@pytest.fixture(scope="module")
def settling(cast: Cast) -> Settling:
    found = settling_of(cast.space)
    assert found is not None
    return found


def test_only_a_smooth_space_with_lines_has_one(cast: Cast) -> None:
    assert settling_of(cast.space) is settling_of(cast.space)
    assert settling_of(cast.space.under("paper")) is None


def test_each_vertex_gives_way_to_one_line_and_fully_on_it(settling: Settling, cast: Cast) -> None:
    near = np.concatenate([crossing.near for crossing in settling.crossings])
    assert len(np.unique(near)) == len(near)
    for crossing, line in zip(settling.crossings, cast.space.lines, strict=True):
        side = np.zeros(len(settling.rows))
        side[crossing.near] = crossing.side
        upper, lower = crossing.vertices[:, :2], crossing.vertices[:, 2:]
        # All but the corners, where both halves meet.
        assert np.quantile(side[upper], 0.1) == pytest.approx(1.0)
        assert np.quantile(side[lower], 0.9) == pytest.approx(-1.0)
        assert np.abs(side).max() == pytest.approx(1.0)
        assert np.array_equal(settling.rows[crossing.vertices], line.vertices)


def test_shares_grow_along_the_line(settling: Settling) -> None:
    for crossing in settling.crossings:
        share = np.full(len(settling.rows), np.nan)
        share[crossing.near] = crossing.share
        middles = (np.arange(RUNGS) + 0.5) / RUNGS
        for columns in (slice(0, 2), slice(2, 4)):
            weights = np.abs(crossing.weights[:, columns])
            found = (share[crossing.vertices[:, columns]] * weights).sum(axis=1)
            assert found[1:-1] == pytest.approx(middles[1:-1], abs=1e-9)  # the corners give way to neither side


def test_triangles_are_those_of_the_sheet_between_rows(settling: Settling, cast: Cast) -> None:
    inside = np.isin(cast.space.sheet_triangles, settling.rows).all(axis=1)
    assert np.array_equal(settling.rows[settling.triangles], cast.space.sheet_triangles[inside])


def test_lids_lie_around_their_own_eye(settling: Settling, cast: Cast) -> None:
    x = cast.space.points[settling.rows[settling.lids], 0]
    for number, name in enumerate(settling.eyes):
        centre = cast.space.parts[name].points[:, 0].mean()
        other = -centre
        mine = x[settling.eye == number]
        assert len(mine) > 0
        assert (np.abs(mine - centre) < np.abs(mine - other) + 1e-9).all()


def test_inner_skin_follows_and_lashes_stick(settling: Settling, cast: Cast) -> None:
    assert settling.sticking == ("lashes",)
    assert not np.isin(settling.followers, settling.rows).any()
    assert (settling.weights.sum(axis=1) < 1.0 + 1e-5).all()
