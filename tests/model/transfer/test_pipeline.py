"""The stages of a compound: their order is the theory's, each keeps its promise, together they are the compound."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import omote
from omote.model.transfer.compound import compound
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.pipeline import (
    CONTINUOUS_STAGES,
    LINEAR_INNER_STAGES,
    SHEET_STAGES,
    STAGES,
    PartialCompound,
    apply_smooth_map,
    clear_eyeballs,
    fit_mouth_bag,
    fit_socket_lining,
    repair_folds,
    run,
    start,
    weld_seams,
)

METHOD = Path(__file__).parents[3] / "docs" / "method.md"
CAST = omote.load_cast()
CASES = [("baby", "eyeBlinkLeft"), ("gaunt", "mouth-open"), ("dog", "mouthFunnel")]


def begin(face: str, unit: str) -> PartialCompound:
    compiled = compile_expression(CAST.space, CAST.expressions[unit])
    return start(CAST.space, CAST.faces[face], displace_generic(CAST.space, compiled), compiled.residual)


def test_the_theory_names_the_stages_in_the_order_in_which_they_run() -> None:
    section = re.search(r"^## The smooth map\n(.*?)(?=^## |\Z)", METHOD.read_text(), re.MULTILINE | re.DOTALL)
    assert section is not None
    named = re.findall(r"^\d+\. .*?`(\w+)`", section[1], re.MULTILINE)
    assert named == [stage.__name__ for stage in STAGES]


@pytest.mark.parametrize(("face", "unit"), CASES)
def test_the_stages_one_after_another_are_the_compound(face: str, unit: str) -> None:
    partial = begin(face, unit)
    for stage in STAGES:
        partial = stage(partial)
    assert np.array_equal(partial.skin, compound(CAST.space, CAST.faces[face], CAST.expressions[unit]))


@pytest.mark.parametrize(("face", "unit"), CASES)
def test_a_stage_leaves_the_state_that_it_was_given_as_it_was(face: str, unit: str) -> None:
    partial = begin(face, unit)
    for stage in STAGES:
        sheet = partial.sheet.copy()
        skin = partial.skin.copy()
        after = stage(partial)
        assert np.array_equal(partial.sheet, sheet), stage.__name__
        assert np.array_equal(partial.skin, skin), stage.__name__
        partial = after


@pytest.mark.parametrize(("face", "unit"), CASES)
def test_each_group_of_stages_changes_what_it_is_named_after(face: str, unit: str) -> None:
    partial = begin(face, unit)
    sheet = run(SHEET_STAGES, partial)
    assert np.array_equal(sheet.skin, partial.skin)
    assert np.array_equal(sheet.sheet, apply_smooth_map(CAST.space, CAST.faces[face], partial.displacement))
    whole = run(STAGES, partial)
    assert np.array_equal(whole.sheet, sheet.sheet)
    loose = run(LINEAR_INNER_STAGES, partial).skin
    on_sheet = CAST.space.on_sheet
    assert np.array_equal(whole.skin[on_sheet], loose[on_sheet])
    assert np.array_equal(whole.skin[on_sheet], sheet.sheet[CAST.space.welded][on_sheet].astype(np.float32))


def test_the_groups_are_the_list_up_to_a_stage() -> None:
    assert (*CONTINUOUS_STAGES, clear_eyeballs) == STAGES[: len(CONTINUOUS_STAGES) + 1]
    assert (*SHEET_STAGES, weld_seams) == STAGES[: len(SHEET_STAGES) + 1]
    assert (*LINEAR_INNER_STAGES, fit_mouth_bag, fit_socket_lining) == STAGES


@pytest.mark.parametrize(("face", "unit"), CASES)
def test_a_sheet_that_was_repaired_and_not_pushed_since_is_left_alone(face: str, unit: str) -> None:
    repaired = repair_folds(run(CONTINUOUS_STAGES, begin(face, unit)))
    assert repair_folds(repaired) is repaired


def test_repair_leaves_no_fold_where_the_continuous_stages_leave_some() -> None:
    folds = list[int]()
    for face, unit in CASES:
        before = run(CONTINUOUS_STAGES, begin(face, unit))
        geometry = before.smooth_map.geometry
        folds.append(int(find_folds(geometry, before.sheet, before.source).sum()))
        assert find_folds(geometry, repair_folds(before).sheet, before.source).sum() == 0
    assert sum(folds) > 0


@pytest.mark.parametrize(("face", "unit"), [("cat", "asleep"), ("cat", "mouth-corner-puller")])
def test_what_least_squares_leave_folded_is_turned_upright(face: str, unit: str) -> None:
    done = run(SHEET_STAGES, begin(face, unit))
    assert find_folds(done.smooth_map.geometry, done.sheet, done.source).sum() == 0


def test_the_inner_skin_is_linear_in_the_residual_before_the_mouth_bag_is_fitted() -> None:
    partial = begin("kaori", "jawOpen")
    more = start(partial.space, partial.face, partial.displacement, 2.0 * partial.residual)
    none = start(partial.space, partial.face, partial.displacement, 0.0 * partial.residual)
    one, two, zero = (run(LINEAR_INNER_STAGES, begun).skin.astype(np.float64) for begun in (partial, more, none))
    assert two - one == pytest.approx(one - zero, abs=1e-7)
