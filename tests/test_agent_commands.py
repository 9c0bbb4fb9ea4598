"""The command `omote mcp`."""

import pytest
from typer.testing import CliRunner

from omote import agent_commands
from omote.cli import app

runner = CliRunner()


def test_without_a_show_or_without_the_package_it_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    done = runner.invoke(app, ["mcp", "--show", "ftp://stage"])
    assert done.exit_code == 1
    assert "no address of a show" in done.stderr
    monkeypatch.setattr(agent_commands, "find_spec", lambda _: None)
    done = runner.invoke(app, ["mcp"])
    assert done.exit_code == 1
    assert "pip install 'omote[agents]'" in done.stderr
