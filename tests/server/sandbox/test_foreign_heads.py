"""Heads of any topology bring their shapes as expressions, tagged with the units that they are named after."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.interchange.formats.glb_reader import Piece
from omote.interchange.scans.scan_reader import ScanFile
from omote.model.fitting.scan import Scan
from omote.model.transfer.compound import compound
from omote.server.sandbox import foreign_heads
from omote.server.sandbox.foreign_heads import foreign_expressions, is_foreign
from omote.server.sandbox.import_files import expressions_from
from tests.model.fitting.foreign.retriangulated import retriangulate

CAST = load_cast()
OLD = CAST.faces["old"]


@pytest.fixture
def scan() -> Scan:
    """Old's head in another topology: a look whose eyeballs are left to bones, an open jaw, and nothing."""

    def moves(name: str) -> NDArray[np.float64]:
        return compound(CAST.space, OLD, CAST.expressions[name]).astype(np.float64) - OLD.positions

    still = np.zeros((CAST.space.vertex_count, 3))
    shapes = {"eyeLookUp_L": moves("eyeLookUpLeft"), "Agape": moves("jawOpen"), "empty": still}
    return retriangulate(CAST.space, OLD, shapes)


def as_pieces(scan: Scan) -> tuple[Piece, ...]:
    """The scan as a reader of meshes gives it."""
    return (Piece("head", scan.positions, None, dict(scan.shapes)),)


def test_shapes_of_strangers_come_in_by_name(
    scan: Scan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:  # fmt: skip
    path = tmp_path / "head.glb"
    path.write_bytes(b"glTF")

    monkeypatch.setattr(foreign_heads, "read_scan_in_sandbox", lambda _: ScanFile(scan))
    monkeypatch.setattr("omote.server.sandbox.import_files.read_in_sandbox", lambda _: as_pieces(scan))
    found = {arrival.label: (arrival, told) for arrival, told in expressions_from(CAST, [path])}
    assert set(found) == {"eyeLookUp_L", "Agape"}
    look, told = found["eyeLookUp_L"]
    assert look.tags == ("eyeLookUpLeft", "gaze")
    assert "taken from the head in head.glb, as eyeLookUpLeft" in told
    assert not isinstance(look.made, tuple)
    np.testing.assert_array_equal(look.made.eyes, CAST.expressions["eyeLookUpLeft"].eyes)
    agape, told = found["Agape"]
    assert agape.tags == ()
    assert "'empty' moves nothing of the face, so it is left out." in told


def test_heads_of_ours_and_heads_at_rest_are_not_foreign(scan: Scan) -> None:
    rest = OLD.positions.astype(np.float64)
    assert is_foreign(CAST, as_pieces(scan))
    assert not is_foreign(CAST, as_pieces(replace(scan, shapes={})))
    assert not is_foreign(CAST, (Piece("skin", rest, None, {"grin": np.zeros_like(rest)}),))


def test_a_head_without_shapes_is_refused(scan: Scan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:

    monkeypatch.setattr(foreign_heads, "read_scan_in_sandbox", lambda _: ScanFile(replace(scan, shapes={})))
    with pytest.raises(ValueError, match=r"head\.glb: the head has no shapes"):
        list(foreign_expressions(CAST, tmp_path / "head.glb"))
