"""The standby makes servers by copying itself, and tells how they end."""

import os
import signal
import socket
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from omote.server.process.process_messages import (
    REJECTED,
    Ended,
    News,
    Order,
    Ready,
    SpareOrder,
    Started,
    read_news,
    send_order,
)
from omote.server.supervision.standby import main, reap_servers, serve_orders


def in_a_process(run: Callable[[socket.socket], object]) -> tuple[int, socket.socket]:
    """Runs something in a copy of this process; its id and the line to it."""
    ours, theirs = socket.socketpair()
    pid = os.fork()
    if pid == 0:
        ours.close()
        try:
            run(theirs)
        finally:
            os._exit(0)
    theirs.close()
    return pid, ours


def news_of(line: socket.socket, count: int) -> list[News]:
    """So many news."""
    line.settimeout(60.0)
    lines = b""
    while lines.count(b"\n") < count:
        lines += line.recv(4096)
    return read_news(lines)


def ordered(line: socket.socket) -> tuple[int, int]:
    """Orders a server; our ends of its control and its pulse."""
    control, ours = os.pipe()
    far, pulse = os.pipe()
    send_order(line, Order(epoch=1, neutral=False), control, pulse)
    os.close(control)
    os.close(pulse)
    return ours, far


def standing_by(play: Callable[[int, int], None]) -> tuple[int, socket.socket]:
    """A standby whose servers do this with their control and pulse."""

    def run(line: socket.socket) -> None:
        serve_orders(line, lambda _, control, pulse: play(control, pulse))

    return in_a_process(run)


def wait_for_the_end(control: int, _: int) -> None:
    """A server that does nothing until it is ended."""
    os.read(control, 1)


def test_each_order_makes_a_server_of_its_own() -> None:
    def play(control: int, pulse: int) -> None:
        os.write(pulse, b"%d" % os.getpid())
        os.read(control, 1)

    pid, line = standing_by(play)
    for _ in range(3):
        control, pulse = ordered(line)
        (started,) = news_of(line, 1)
        assert isinstance(started, Started)
        assert int(os.read(pulse, 20)) == started.pid
        os.close(control)  # the end of its pipe is its end
        assert news_of(line, 1) == [Ended(started.pid, 0)]
        assert os.read(pulse, 1) == b""
        os.close(pulse)
    line.close()
    assert os.waitpid(pid, 0) == (pid, 0)


def test_the_pulse_of_a_killed_server_ends_at_once() -> None:
    pid, line = standing_by(wait_for_the_end)
    control, pulse = ordered(line)
    (started,) = news_of(line, 1)
    assert isinstance(started, Started)
    os.kill(started.pid, signal.SIGKILL)
    assert os.read(pulse, 1) == b""  # nobody else holds it
    assert news_of(line, 1) == [Ended(started.pid, -signal.SIGKILL)]
    os.close(control)
    os.close(pulse)
    line.close()
    os.waitpid(pid, 0)


def test_a_server_that_fails_ends_with_one_and_harms_nobody(capfd: pytest.CaptureFixture[str]) -> None:
    def fail(_: int, __: int) -> None:
        raise ArithmeticError("a poisoned state")

    pid, line = standing_by(fail)
    for _ in range(2):
        ends = ordered(line)
        news = news_of(line, 2)
        assert [type(each) for each in news] == [Started, Ended]
        assert isinstance(news[1], Ended)
        assert news[1].code == 1
        for descriptor in ends:
            os.close(descriptor)
    assert "a poisoned state" in capfd.readouterr().err
    line.close()
    assert os.waitpid(pid, 0) == (pid, 0)


@pytest.mark.parametrize("stopped", [False, True])
def test_a_standby_without_supervisor_sees_its_servers_out(stopped: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.server.supervision.standby.END_SECONDS", 0.2 if stopped else 60.0)
    pid, line = standing_by(wait_for_the_end)
    control, pulse = ordered(line)
    (started,) = news_of(line, 1)
    assert isinstance(started, Started)
    if stopped:
        os.kill(started.pid, signal.SIGSTOP)  # it cannot end by itself
    line.close()
    os.close(control)
    assert os.waitpid(pid, 0) == (pid, 0)
    with pytest.raises(ProcessLookupError):
        os.kill(started.pid, 0)
    os.close(pulse)


def test_a_spare_serves_orders_when_its_standby_and_the_server_are_killed_at_one_instant() -> None:
    pid, line = standing_by(wait_for_the_end)
    control, pulse = ordered(line)
    (started,) = news_of(line, 1)
    assert isinstance(started, Started)
    ours, theirs = socket.socketpair()
    send_order(line, SpareOrder(), theirs.fileno())
    theirs.close()
    (ready,) = news_of(ours, 1)
    assert isinstance(ready, Ready)
    assert os.getsid(ready.pid) not in (ready.pid, os.getsid(pid)), "what ends the standby's session spares it"
    for killed in (pid, started.pid):
        os.kill(killed, signal.SIGKILL)
    os.waitpid(pid, 0)
    assert line.recv(4096) == b"", "nobody else holds the line"
    assert os.read(pulse, 1) == b""
    next_control, next_pulse = ordered(ours)
    (second,) = news_of(ours, 1)
    assert isinstance(second, Started)
    os.close(next_control)
    assert news_of(ours, 1) == [Ended(second.pid, 0)]
    ours.shutdown(socket.SHUT_WR)
    assert ours.recv(4096) == b"", "it ends with its supervisor"
    for descriptor in (control, pulse, next_pulse):
        os.close(descriptor)
    line.close()
    ours.close()


def test_without_children_none_is_gone() -> None:
    assert reap_servers() == []


@pytest.mark.parametrize("error", [FileNotFoundError("run `make bake`"), ValueError("delete it and run `make bake`")])
def test_a_standby_without_its_cast_says_what_to_do(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], error: Exception
) -> None:
    def load() -> None:
        raise error

    before = signal.getsignal(signal.SIGINT)
    arguments = ["--show", str(tmp_path / "a.omote"), "--listen", "0", "--line", "0"]
    assert main(arguments, load) == REJECTED  # type: ignore[arg-type]
    signal.signal(signal.SIGINT, before)
    assert "run `make bake`" in capsys.readouterr().err


def test_a_standby_says_when_it_is_ready_and_has_one_thread(tmp_path: Path) -> None:
    ours, theirs = socket.socketpair()
    words = ["--show", str(tmp_path / "a.omote"), "--listen", "0", "--line", str(theirs.fileno())]
    os.set_inheritable(theirs.fileno(), True)
    pid = os.posix_spawn(
        sys.executable,
        [sys.executable, "-m", "tests.server.synthetic_server", *words],
        {**os.environ, "OPENBLAS_NUM_THREADS": "1"},
    )
    theirs.close()
    ours.settimeout(60.0)
    assert read_news(ours.recv(4096)) == [Ready(pid)]
    if (tasks := Path(f"/proc/{pid}/task")).exists():
        assert len(list(tasks.iterdir())) == 1  # a process of several threads cannot be copied whole
    ours.close()
    assert os.waitpid(pid, 0) == (pid, 0)


WARMED = """
import gc
import omote
from numba.core.dispatcher import Dispatcher
from omote.perform.scene.scene import Scene
from omote.server.http.cast_documents import built_in_documents
from omote.server.supervision.standby import warm
from omote.stage_data.assets import compound_asset

def compiled():
    found = [each for each in gc.get_objects() if isinstance(each, Dispatcher) and "omote" in each.py_func.__module__]
    return {(each.py_func.__module__, each.py_func.__name__, str(sign)) for each in found for sign in each.signatures}

documents = built_in_documents()
warm(documents)
gc.unfreeze()
before = compiled()
for face in documents.cast.faces.values():
    for expression in list(documents.cast.expressions)[::16]:
        compound_asset(documents.cast, face, expression)
scene = Scene.begun(documents.cast)
scene.move_pad("one", "mouth", 0.5)
scene["one"].drive({"jawOpen": 0.5})
scene["one"].set_mapping(omote.MacroMapping("mouth", [omote.MacroTarget("channel/jawOpen")]))
scene["one"].move_macro("mouth", 0.5)
scene.advance(1 / 60)
print(*sorted(compiled() - before), sep="\\n", end="")
"""


def test_no_face_and_no_motion_of_a_show_waits_for_a_compiler() -> None:
    done = subprocess.run([sys.executable, "-c", WARMED], capture_output=True, text=True, check=True)
    assert done.stdout == ""
