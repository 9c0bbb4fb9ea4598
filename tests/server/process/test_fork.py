"""A forked process works, ends, and holds no descriptor of its parent open."""

import os
import subprocess
import sys

import pytest

from omote.server.process.fork import close_descriptors, fork_beside, fork_process


def test_a_copy_works_and_ends() -> None:
    theirs, ours = os.pipe()
    pid = fork_process(lambda: print(os.write(ours, b"done")))  # noqa: T201  (more than one thing to do)
    assert os.waitpid(pid, 0) == (pid, 0)
    assert os.read(theirs, 4) == b"done"
    os.close(theirs)
    os.close(ours)


def test_a_copy_that_fails_says_why(capfd: pytest.CaptureFixture[str]) -> None:
    def fail() -> None:
        raise ArithmeticError("nothing works")

    pid = fork_process(fail)
    assert os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == 1
    assert "nothing works" in capfd.readouterr().err


def test_a_copy_speaks_by_its_line_alone() -> None:
    end, held = os.pipe()
    pid, line = fork_beside(lambda theirs: theirs.sendall(theirs.recv(4)))
    os.close(held)
    assert os.read(end, 1) == b""  # although the copy still works
    line.sendall(b"echo")
    assert line.recv(4) == b"echo"
    assert os.waitpid(pid, 0) == (pid, 0)
    line.close()
    os.close(end)


def test_what_a_copy_lets_go_ends_with_its_parent() -> None:
    end, held = os.pipe()
    wait, go = os.pipe()

    def work() -> None:
        close_descriptors([wait])
        os.read(wait, 1)

    pid = fork_process(work)
    os.close(held)
    assert os.read(end, 1) == b""  # although the copy still works
    os.write(go, b"!")
    assert os.waitpid(pid, 0) == (pid, 0)
    for descriptor in (end, wait, go):
        os.close(descriptor)


SIGNALLED = """
import os, signal, sys
from omote.server.process.fork import fork_process

class Signalling:
    def flush(self):
        os.kill(os.getpid(), signal.SIGTERM)

def stop(*_):
    raise KeyboardInterrupt

def work():
    signal.signal(signal.SIGTERM, stop)
    sys.stderr = Signalling()

try:
    pid = fork_process(work)
except KeyboardInterrupt:
    print("the copy went on as its parent", flush=True)
    os._exit(1)
print(os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]))
"""


def test_a_copy_ends_although_a_signal_comes_as_it_ends() -> None:
    said = subprocess.run([sys.executable, "-c", SIGNALLED], capture_output=True, text=True, timeout=60, check=True)
    assert said.stdout.split() == ["0"]
