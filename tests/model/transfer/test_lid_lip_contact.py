"""Contact: a line is opened by exactly what it lacks, bin by bin, and nothing else moves."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.transfer.fold_repair import build_sheet_geometry
from omote.model.transfer.lid_lip_contact import BINS, FARTHEST_WIDTHS, build_contact, close_contact, hat_functions
from tests.model.space.test_lid_lip_lines import line


@pytest.mark.parametrize("count", BINS.values())
def test_the_hats_sum_to_one_on_every_rung(count: int) -> None:
    assert np.allclose(hat_functions(count).sum(axis=0), 1.0)
    assert (hat_functions(count) >= 0).all()


@pytest.mark.parametrize("name", ["lid_left", "lips"])
@pytest.mark.parametrize("face", ["baby", "doll"])
def test_each_bin_is_opened_alone_by_its_answer(name: str, face: str) -> None:
    cast = omote.load_cast()
    positions = cast.faces[face].positions.astype(np.float64)
    sheet = build_sheet_geometry(cast.space.points, positions, cast.space.skin_triangles)
    contact = build_contact(line(cast.space, name), cast.space.points, positions, sheet)
    count = BINS[contact.line.kind]
    for bin_ in range(count):
        moved = positions.copy()
        moved[contact.near] += 0.001 * contact.response[:, bin_]
        change = contact.line.rungs(moved) - contact.line.rungs(positions)
        assert contact.bins @ (contact.target * change).sum(axis=1) == pytest.approx(
            0.001 * np.eye(count)[bin_], abs=1e-9
        )


@pytest.mark.parametrize("face", ["baby", "cat"])
def test_each_bin_of_a_lid_opens_as_on_the_source(face: str) -> None:
    """However little it lacks: nothing is tolerated."""
    cast = omote.load_cast()
    generic = cast.space.points
    positions = cast.faces[face].positions.astype(np.float64)
    sheet = build_sheet_geometry(generic, positions, cast.space.skin_triangles)
    contact = build_contact(line(cast.space, "lid_left"), generic, positions, sheet)
    moved = generic.copy()
    closed = positions.copy()
    upper = np.unique(contact.line.vertices[:, :2])
    for drop in (0.00002, 0.001, 0.004):
        moved[upper, 1] = generic[upper, 1] - drop
        close_contact(contact, closed, moved)
        wanted = contact.ratios * (contact.source * contact.line.rungs(moved)).sum(axis=1)
        opening = (contact.target * contact.line.rungs(closed)).sum(axis=1)
        assert contact.bins @ opening == pytest.approx(contact.bins @ wanted, abs=1e-9)


def test_a_line_that_lacks_nothing_is_left_alone_and_one_that_gapes_is_closed() -> None:
    cast = omote.load_cast()
    generic = cast.space.points
    positions = cast.faces["baby"].positions.astype(np.float64)
    sheet = build_sheet_geometry(generic, positions, cast.space.skin_triangles)
    contact = build_contact(line(cast.space, "lips"), generic, positions, sheet)
    still = positions.copy()
    close_contact(contact, still, generic)
    assert np.abs(still - positions).max() < 1e-9
    # The source opens its lips by its rungs' lengths; the face follows by as much, times the growth of the width.
    opened = generic.copy()
    upper = np.unique(contact.line.vertices[:, :2])
    opened[upper, 1] += 0.004
    close_contact(contact, still, opened)
    change = (contact.line.rungs(still) - contact.line.rungs(positions))[:, 1]
    wanted = (contact.line.rungs(opened) - contact.line.rungs(generic))[:, 1] * contact.gain
    assert contact.bins @ change == pytest.approx(contact.bins @ wanted)
    width = np.ptp(positions[contact.line.loop, 0])
    away = np.linalg.norm(positions - positions[contact.line.loop].mean(axis=0), axis=1) > (FARTHEST_WIDTHS + 1) * width
    assert np.array_equal(still[away], positions[away])
