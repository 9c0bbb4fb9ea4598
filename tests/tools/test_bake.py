"""The bake as a whole: the same bytes again, and a sentence where it cannot be done."""

import os
from pathlib import Path

import pytest

from omote import builtin
from tools import bake
from tools.baking.package import VARIABLE, WHEEL, BakeError, Package

pytestmark = pytest.mark.long


@pytest.mark.slow
def test_the_cast_in_place_is_what_the_tools_bake_to_the_byte() -> None:
    wheel = Path(os.environ.get(VARIABLE, bake.CACHE / WHEEL))
    if not wheel.is_file():
        pytest.skip(f"{WHEEL} is not at hand: the cast was baked elsewhere")
    steps: list[str] = []
    files = bake.bake(Package(wheel), steps.append)
    assert len(steps) == bake.STEPS - 1  # the first step is the wheel itself
    assert set(files) == {"cast.npz", "figures.npz", "identity_modes.npz", "mask.png", "NOTICE-CC0.md"}
    for name, data in files.items():
        assert data == (builtin.HERE / name).read_bytes(), f"{name} is stale; run `make bake`"


def test_a_refusal_is_one_sentence_and_writes_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    def refuses(cache: Path) -> Path:
        raise BakeError("there is no network")

    monkeypatch.setattr(bake, "find_wheel", refuses)
    monkeypatch.setattr(bake, "TARGET", tmp_path)
    assert bake.main() == 1
    assert capsys.readouterr().err == "The cast was not baked: there is no network\n"
    assert list(tmp_path.iterdir()) == []


def test_the_three_files_are_put_in_place(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setattr(bake, "find_wheel", lambda cache: cache)
    monkeypatch.setattr(bake, "Package", lambda wheel: wheel)
    monkeypatch.setattr(bake, "bake", lambda package, step: {"cast.npz": b"cast", "mask.png": b"mask"})
    monkeypatch.setattr(bake, "TARGET", tmp_path)
    assert bake.main() == 0
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {"cast.npz": b"cast", "mask.png": b"mask"}
    assert "17 faces, 117 expressions, 15 hair styles, 17 bodies: cast.npz" in capsys.readouterr().out
