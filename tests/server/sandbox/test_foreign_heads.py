"""Heads of any topology bring their shapes as expressions, tagged with the units that they are named after."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.interchange.formats.glb_reader import Piece
from omote.interchange.scans.scan_reader import ScanFile
from omote.model.fitting.doubt import EYES, Doubt
from omote.model.fitting.fit_face import Fit, fit_face
from omote.model.fitting.scan import Scan
from omote.model.transfer.compound import compound
from omote.server.sandbox import foreign_heads
from omote.server.sandbox.foreign_heads import foreign_expressions, is_foreign
from omote.server.sandbox.import_files import expressions_from
from tests.interchange.scans.scan_samples import ball
from tests.model.fitting.foreign.retriangulated import retriangulate

CAST = load_cast()
OLD = CAST.faces["old"]


@pytest.fixture
def scan() -> Scan:
    """Old's head in another topology: looks whose eyeballs are left to bones, an open jaw, and nothing."""

    def moves(name: str) -> NDArray[np.float64]:
        return compound(CAST.space, OLD, CAST.expressions[name]).astype(np.float64) - OLD.positions

    still = np.zeros((CAST.space.vertex_count, 3))
    down = moves("eyeLookDownLeft") + moves("eyeLookDownRight")
    shapes = {"eyeLookUp_L": moves("eyeLookUpLeft"), "lookDown": down, "Agape": moves("jawOpen"), "empty": still}
    return retriangulate(CAST.space, OLD, shapes)


def as_pieces(scan: Scan) -> tuple[Piece, ...]:
    """The scan as a reader of meshes gives it."""
    return (Piece("head", scan.positions, None, dict(scan.shapes)),)


@pytest.mark.parametrize("suffix", [".glb", ".vrm"])
def test_shapes_of_strangers_come_in_by_name(
    suffix: str, scan: Scan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:  # fmt: skip
    path = (tmp_path / "head").with_suffix(suffix)
    path.write_bytes(b"glTF")

    monkeypatch.setattr(foreign_heads, "read_scan_in_sandbox", lambda _: ScanFile(scan))
    monkeypatch.setattr("omote.server.sandbox.import_files.read_in_sandbox", lambda _: as_pieces(scan))
    found = {arrival.label: (arrival, told) for arrival, told in expressions_from(CAST, [path])}
    assert set(found) == {"eyeLookUp_L", "lookDown", "Agape"}
    look, told = found["eyeLookUp_L"]
    assert look.tags == ("eyeLookUpLeft", "gaze")
    assert f"taken from the head in head{suffix}, as eyeLookUpLeft" in told
    assert not isinstance(look.made, tuple)
    np.testing.assert_array_equal(look.made.eyes, CAST.expressions["eyeLookUpLeft"].eyes)
    down, told = found["lookDown"]
    assert down.tags == ("eyeLookDownLeft", "eyeLookDownRight", "gaze")
    assert "as eyeLookDownLeft and eyeLookDownRight" in told
    assert not isinstance(down.made, tuple)
    both = [CAST.expressions[f"eyeLookDown{side}"].eyes for side in ("Left", "Right")]
    np.testing.assert_allclose(down.made.eyes, both[0] + both[1], atol=1e-12)
    agape, told = found["Agape"]
    assert agape.tags == ()
    assert "'empty' moves nothing of the face, so it is left out." in told


def test_what_is_doubtful_of_a_strangers_head_is_told_with_its_shapes(
    scan: Scan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "head.glb"
    path.write_bytes(b"glTF")

    def doubt(*given: Any, **options: Any) -> Fit:
        return replace(fit_face(*given, **options), doubts=(Doubt("Are its eyes shut?", EYES),))

    monkeypatch.setattr(foreign_heads, "fit_face", doubt)
    monkeypatch.setattr(foreign_heads, "read_scan_in_sandbox", lambda _: ScanFile(scan))
    *_, (_, told) = foreign_expressions(CAST, path)
    assert "Are its eyes shut?" in told


def test_heads_of_ours_are_not_foreign(scan: Scan) -> None:
    rest = OLD.positions.astype(np.float64)
    assert is_foreign(CAST, as_pieces(scan))
    assert is_foreign(CAST, as_pieces(replace(scan, shapes={})))
    assert not is_foreign(CAST, (Piece("skin", rest, None, {"grin": np.zeros_like(rest)}),))


def test_a_head_without_shapes_is_refused(scan: Scan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:

    monkeypatch.setattr(foreign_heads, "read_scan_in_sandbox", lambda _: ScanFile(replace(scan, shapes={})))
    with pytest.raises(ValueError, match=r"head\.glb: the head has no shapes .* omote face head\.glb -o show\.omote"):
        list(foreign_expressions(CAST, tmp_path / "head.glb"))


def test_what_may_be_no_face_is_asked_about_and_brings_nothing(
    scan: Scan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:  # fmt: skip
    """A ball with a shape, and a head that is found with a doubt."""
    points, triangles = ball()
    odd = Scan(points, triangles, shapes={"jawOpen": 0.1 * points})
    monkeypatch.setattr(foreign_heads, "read_scan_in_sandbox", lambda _: ScanFile(odd))
    with pytest.raises(ValueError, match=r"ball\.glb: nothing in the scan could be a face.*export the head alone"):
        list(foreign_expressions(CAST, tmp_path / "ball.glb"))

    doubted = SimpleNamespace(doubts=("This may be no face.",))
    monkeypatch.setattr(foreign_heads, "read_scan_in_sandbox", lambda _: ScanFile(scan))
    monkeypatch.setattr(foreign_heads, "find_head", lambda *_: doubted)
    with pytest.raises(ValueError, match=r"fox\.glb: This may be no face\. Points cannot be given to this command"):
        list(foreign_expressions(CAST, tmp_path / "fox.glb"))
