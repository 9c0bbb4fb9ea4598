"""Ctrl-C at any instant ends the command without a traceback, also while its modules are loaded."""

import os
import signal
import subprocess
import sys

import pytest

pytestmark = [
    pytest.mark.skipif(os.name == "nt", reason="Windows has no signals"),
    pytest.mark.usefixtures("children_hear_ctrl_c"),
]

INTERRUPTED = """
import os, signal, sys
class Interrupt:
    def find_spec(name, *rest):
        if name == {module!r}:
            os.kill(os.getpid(), signal.SIGINT)
sys.meta_path.insert(0, Interrupt)
sys.argv = ["omote", "cast"]
from omote.entry_point import main
main()
"""


def interrupted(module: str) -> tuple[int, str]:
    """Exit status and error messages of `omote cast`, interrupted when it begins to load a module."""
    command = [sys.executable, "-c", INTERRUPTED.format(module=module)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stderr


def test_ctrl_c_ends_the_command_without_a_traceback() -> None:
    for module in ("omote.cli", "typer"):
        assert interrupted(module) == (-signal.SIGINT, "")


def test_ctrl_c_is_heard_by_a_command_that_runs() -> None:
    status, said = interrupted("omote.builtin")
    assert (status, "Traceback" in said) == (130, False)
