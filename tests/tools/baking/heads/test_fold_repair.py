"""What units and performed expressions fold on the generic head is turned back, and nothing else has moved."""

import numpy as np
import pytest

import omote
from omote.geometry.orientation import area_shares, rest_normals
from omote.model.space.lid_lip_lines import Line
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import predict_part
from omote.model.transfer.corrective_regions import CorrectiveRegions, find_corrective_regions
from tools.baking.heads.fold_repair import OVERLAP, repair_folds
from tools.baking.heads.moves import Move

ROUNDING = 1e-6
"""Metres: positions are float32."""
SLACK = 5e-5
"""Metres: triangles are turned upright once more after lids have met."""
EYE = ("wink", "eyeBlinkLeft", "eyeSquintLeft", "cheekSquintLeft")


@pytest.fixture(scope="module")
def space() -> ParameterSpace:
    return omote.load_cast().space


@pytest.fixture(scope="module")
def regions(space: ParameterSpace) -> CorrectiveRegions:
    found = find_corrective_regions(space)
    assert found is not None
    return found


@pytest.fixture(scope="module")
def corrected(space: ParameterSpace, moves: dict[str, Move]) -> dict[str, Move]:
    return repair_folds(space, moves)


def count_folds(space: ParameterSpace, regions: CorrectiveRegions, move: Move) -> int:
    here = space.points[regions.rows]
    there = (space.points + move.skin)[regions.rows]
    normals, sizes = rest_normals(here, regions.triangles)
    return int((area_shares(there, normals, sizes, regions.triangles) < 0.0).sum())


def least_opening(space: ParameterSpace, line: Line, move: Move) -> float:
    """The least opening of a line's rungs, along those at rest, metres."""
    still = line.rungs(space.points)
    now = line.rungs(space.points + move.skin)
    return float(((still * now).sum(axis=1) / np.linalg.norm(still, axis=1)).min())


def test_a_wink_folds_as_the_sum_of_its_units_and_no_more_once_corrected(
    space: ParameterSpace, regions: CorrectiveRegions, moves: dict[str, Move], corrected: dict[str, Move]
) -> None:
    assert count_folds(space, regions, moves["wink"]) > 0
    assert all(count_folds(space, regions, corrected[name]) == 0 for name in EYE)


def test_lids_that_close_lie_over_each_other_by_the_overlap_at_most(
    space: ParameterSpace, moves: dict[str, Move], corrected: dict[str, Move]
) -> None:
    for line in (line for line in space.lines if line.kind == "lids"):
        assert min(least_opening(space, line, moves[name]) for name in ("asleep", "pain")) < -5 * OVERLAP
        for name, move in corrected.items():
            assert least_opening(space, line, move) > -OVERLAP - SLACK, name


def test_what_folds_nothing_stays_and_lashes_go_with_their_lids(
    space: ParameterSpace, regions: CorrectiveRegions, moves: dict[str, Move], corrected: dict[str, Move]
) -> None:
    for name in ("jawOpen", "mouthClose", "browInnerUp", "eyeWideLeft"):
        assert np.abs(corrected[name].skin - moves[name].skin).max() < ROUNDING
    mended = corrected["wink"].skin - moves["wink"].skin
    for part in regions.attached_parts:
        hung = corrected["wink"].parts[part] - moves["wink"].parts[part]
        np.testing.assert_allclose(hung, predict_part(space, part, mended), atol=1e-12)
    assert np.abs(mended - mended[space.welded]).max() == 0.0
