"""A terminal that nobody reads makes nobody wait, and one that is gone ends nothing."""

import os
import pty
import subprocess
import sys
from pathlib import Path

import pytest

from omote.server.process.terminal_relay import CHUNK, MOST_WAITING, WaitingOutput

ROOT = Path(__file__).parents[3]
LIMIT = 60.0
WRITES = """
import os, sys
from omote.server.process.terminal_relay import relay_terminal
with relay_terminal():
    for number in range({count}):
        print(f"line {{number}}", flush=True)
    sys.stderr.write("the end\\n")
    os.write({done}, b"done")
    os.read({go_on}, 1)
"""


def start(count: int, *, stdout: int, stderr: int) -> tuple[subprocess.Popen[bytes], int, int]:
    """A program that writes lines to its terminal, and then to a pipe that it is done; it ends when told to."""
    done, told = os.pipe()
    heard, go_on = os.pipe()
    program = WRITES.format(count=count, done=told, go_on=heard)
    process = subprocess.Popen(
        [sys.executable, "-c", program], cwd=ROOT, pass_fds=(told, heard), stdout=stdout, stderr=stderr
    )
    os.close(told)
    os.close(heard)
    return process, done, go_on


def finish(process: subprocess.Popen[bytes], done: int, go_on: int) -> int:
    """Lets a program that is done end; its status."""
    os.write(go_on, b".")
    for pipe in (done, go_on):
        os.close(pipe)
    return process.wait(LIMIT)


@pytest.mark.parametrize("opened", [pty.openpty, os.pipe])
def test_a_terminal_that_nobody_reads_makes_nobody_wait(opened: object) -> None:
    unread, terminal = opened()  # type: ignore[operator]
    process, *pipes = start(100_000, stdout=terminal, stderr=terminal)
    os.close(terminal)
    assert os.read(pipes[0], 4) == b"done"
    assert finish(process, *pipes) == 0
    os.close(unread)


def test_a_terminal_that_is_gone_ends_nothing() -> None:
    reader, writer = os.pipe()
    process, *pipes = start(100, stdout=writer, stderr=writer)
    os.close(reader)
    os.close(writer)
    assert os.read(pipes[0], 4) == b"done"
    assert finish(process, *pipes) == 0


def test_all_is_shown_in_its_order_where_it_is_read() -> None:
    process, *pipes = start(3000, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert process.stdout is not None
    assert os.read(pipes[0], 4) == b"done"
    os.write(pipes[1], b".")
    lines = process.stdout.read().decode().splitlines()
    assert lines == [*(f"line {number}" for number in range(3000)), "the end"]
    assert process.wait(LIMIT) == 0
    process.stdout.close()
    for pipe in pipes:
        os.close(pipe)


def test_what_waits_is_bounded_and_what_was_lost_is_said() -> None:
    output = WaitingOutput()
    for number in range(4 * MOST_WAITING // CHUNK):
        output.add(bytes([65 + number]) * CHUNK)
    taken = output.take()
    assert taken is not None
    lost, newest = taken[:-MOST_WAITING], taken[-MOST_WAITING:]
    assert newest[-CHUNK:] == bytes([65 + 4 * MOST_WAITING // CHUNK - 1]) * CHUNK
    assert str(3 * MOST_WAITING) in lost.decode()
    output.close()
    assert output.take() is None
