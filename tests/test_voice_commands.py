"""The command `omote voice`."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.cli import app
from tests.server.sandbox.piper_model import write_model

runner = CliRunner()


def test_a_model_is_kept_and_listed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    done = runner.invoke(app, ["voice", str(write_model(tmp_path))])
    assert (done.exit_code, done.stdout) == (0, "xx-tone\n")
    assert "xx-tone.onnx speaks, and is kept in" in done.stderr
    assert "xx-tone\tEnglish, Nowhere, tone low\n" in runner.invoke(app, ["voice"]).stdout
    done = runner.invoke(app, ["voice", str(tmp_path / "none.onnx")])
    assert (done.exit_code, done.stderr) == (1, f"omote: there is no model {tmp_path / 'none.onnx'}\n")


def test_a_machine_without_a_voice_is_told_how_to_get_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    done = runner.invoke(app, ["voice"])
    assert (done.exit_code, done.stdout) == (0, "")
    assert "this machine has no voice; install one where the show runs: pip install 'omote[voice]'" in done.stderr
