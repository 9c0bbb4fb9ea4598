"""Lids of the generic head meet where a scan's do; where they do not, it is said."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import omote
from omote.model.fitting.lids.lid_motion import OVERLAP, describe_lids, lid_pairs, shut_lids
from omote.model.space.face_fit import generic_face
from omote.model.space.lid_lip_lines import RUNGS
from omote.model.transfer.lid_lip_contact import BINS, hat_functions

CAST = omote.load_cast()
SPACE = CAST.space
GENERIC = generic_face(SPACE)
REST = GENERIC.positions.astype(np.float64)


def half_blink() -> NDArray[np.float64]:
    """The generic head with its left eye half shut."""
    worn = omote.compound(SPACE, GENERIC, CAST.expressions["eyeBlinkLeft"])
    return REST + 0.5 * (worn.astype(np.float64) - REST)


def test_lids_meet_bin_by_bin_the_upper_one_more_and_the_other_eye_s_stay() -> None:
    pair, other = lid_pairs(SPACE)
    half = half_blink()
    moved = shut_lids(pair, half, np.full(RUNGS, 0.8))
    bins = hat_functions(BINS["lids"])
    assert bins @ ((pair.opening(moved) + OVERLAP) * pair.lengths) == pytest.approx(0.0, abs=1e-9)
    went = np.einsum("rkc,rc->rk", (moved - half)[pair.line.vertices], pair.ways) * np.abs(pair.line.weights)
    upper, lower = bins @ went[:, :2].sum(axis=1), bins @ went[:, 2:].sum(axis=1)
    assert upper == pytest.approx(-4.0 * lower)
    assert other.opening(moved) == pytest.approx(1.0)


def test_lids_that_do_not_close_as_the_scan_s_are_told_of() -> None:
    half = half_blink()
    assert describe_lids(SPACE, "wink", half, {"lid_right": np.ones(RUNGS)}) == [
        "'wink' moves the left eye's lids, but at rest the scan shows no opening between them: how far they close is a "
        "guess.",
        "'wink' shuts the right eye of the scan, but leaves 100% of it open here.",
    ]
    assert not describe_lids(SPACE, "half", half, {"lid_left": None})
    assert not describe_lids(SPACE, "rest", REST, {})
