"""Work in a child process: its answer and its progress come back; what dies, lasts or takes too much is refused."""

import contextlib
import os
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.model.fitting.doubt import EYES, Doubt
from omote.server.sandbox.child_task import Limits, Tell, run_limited


def test_an_answer_and_the_progress_come_back() -> None:
    told: list[tuple[float, str]] = []

    def work(tell: Tell) -> bytes:
        tell(0.25, "reading")
        tell(0.5, "thinking")
        return bytes(3_000_000)

    answer = run_limited(work, bytes, Limits(), exhausted="too much", follow=lambda *each: told.append(each))
    assert answer == bytes(3_000_000)
    assert told == [(0.25, "reading"), (0.5, "thinking")]


@dataclass(frozen=True, eq=False)
class Found:
    """What a child may send: arrays, by name too, and doubts."""

    points: NDArray[np.float64]
    rows: NDArray[np.integer] | None
    moves: Mapping[str, NDArray[np.float64]]
    doubts: tuple[Doubt, ...] = ()
    far: float = 0.0
    sure: bool = False


def test_arrays_and_doubts_come_back_as_they_were() -> None:
    """Numbers out of an array too: a head of an anime was fitted, and its distance could not be sent."""
    points = np.arange(6.0).reshape(2, 3)
    moves = MappingProxyType({"smile": points})
    sent = Found(points[:, ::-1], None, moves, (Doubt("Shut?", EYES),), points[0, 1], np.bool_(True))  # type: ignore[arg-type]
    found = run_limited(lambda _: sent, Found, Limits(), exhausted="too much")
    np.testing.assert_array_equal(found.points, sent.points)
    np.testing.assert_array_equal(found.moves["smile"], points)
    assert (found.far, found.sure) == (1.0, True)
    assert (found.rows, [(str(doubt), doubt.kind) for doubt in found.doubts]) == (None, [("Shut?", EYES)])


@dataclass(frozen=True)
class Counted:
    """Plain numbers that a child may have as numpy's."""

    scale: float
    count: int
    sure: bool


def _give(value: Counted, _: Tell) -> Counted:
    return value


def test_numpy_s_numbers_come_back_as_plain_ones() -> None:
    for whole, part in ((np.int64, np.float64), (np.uint8, np.float32)):
        sent = Counted(part(0.5), whole(7), np.bool_(True))  # type: ignore[arg-type]
        found = run_limited(partial(_give, sent), Counted, Limits(), exhausted="too much")
        assert found == Counted(0.5, 7, True)
        assert [type(each) for each in (found.scale, found.count, found.sure)] == [float, int, bool]


@pytest.mark.parametrize(
    "sent",
    [
        {"points": ["<f8", [2, 3], bytes(40)], "rows": None, "moves": {}},
        {"points": ["|O", [1], bytes(8)], "rows": None, "moves": {}},
        {"points": ["<i8", [1], bytes(8)], "rows": None, "moves": {}},
        {"points": ["<f8", [1], bytes(8)], "rows": ["<f8", [1], bytes(8)], "moves": {}},
        {"points": ["<f8", [1], bytes(8)], "rows": None, "moves": {}, "doubts": [["Shut?", "else"]]},
        7,
    ],
)
def test_what_is_none_of_the_kind_is_refused(sent: object) -> None:
    with pytest.raises(ValueError, match=r"^too much$"):
        run_limited(lambda _: sent, Found, Limits(), exhausted="too much")


def test_a_sentence_comes_back() -> None:
    def work(_: Tell) -> bytes:
        raise ValueError("no head: give one")

    with pytest.raises(ValueError, match=r"^no head: give one$"):
        run_limited(work, bytes, Limits(), exhausted="too much")


def test_an_error_of_ours_is_told_as_one() -> None:
    def work(_: Tell) -> bytes:
        raise KeyError("strange")

    with pytest.raises(ValueError, match=r"^Omote failed at it \(KeyError: 'strange'\); please report this$"):
        run_limited(work, bytes, Limits(), exhausted="too much")


def die(_: Tell) -> bytes:
    os._exit(0)


def spin(_: Tell) -> bytes:
    while True:
        pass


def sleep(_: Tell) -> bytes:
    time.sleep(60)
    return b""


def hoard(_: Tell) -> bytes:
    return np.ones(2**31).tobytes()


def open_many(_: Tell) -> bytes:
    return bytes(len([Path("/dev/null").open("rb") for _ in range(100)]))


@pytest.mark.parametrize("work", [die, spin, hoard, open_many])
def test_what_takes_too_much_or_dies_is_refused_in_time(work: Callable[[Tell], bytes]) -> None:
    begun = time.monotonic()
    with pytest.raises(ValueError, match=r"^too much$"):
        run_limited(work, bytes, Limits(seconds=1, memory=2**28), exhausted="too much")
    assert time.monotonic() - begun < 60.0


def test_what_a_busy_machine_leaves_no_time_for_is_not_called_too_much() -> None:
    with pytest.raises(ValueError, match=r"not done after 1 s: this machine is busy with other work.*try again"):
        run_limited(sleep, bytes, Limits(patience=1.0), exhausted="too much")


def test_the_child_is_gone_when_following_it_fails() -> None:
    seen: list[int] = []

    def work(tell: Tell) -> bytes:
        tell(float(os.getpid()), "")
        time.sleep(60)
        return b""

    def follow(pid: float, _: str) -> None:
        seen.append(int(pid))
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_limited(work, bytes, Limits(), exhausted="too much", follow=follow)
    with pytest.raises(ProcessLookupError):
        os.kill(seen[0], 0)


def test_files_are_written_only_where_that_is_allowed(tmp_path: Path) -> None:
    def work(_: Tell) -> bytes:
        (tmp_path / "a").write_bytes(b"x")
        return b"written"

    with pytest.raises(ValueError, match="too much"):
        run_limited(work, bytes, Limits(), exhausted="too much")
    assert run_limited(work, bytes, Limits(writes=True), exhausted="too much") == b"written"


def test_descriptors_that_the_parent_has_open_do_not_count(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"x")

    def work(_: Tell) -> bytes:
        return (tmp_path / "a").read_bytes()

    with contextlib.ExitStack() as stack:
        for _ in range(40):
            stack.enter_context((tmp_path / "a").open("rb"))
        assert run_limited(work, bytes, Limits(files=4), exhausted="too much") == b"x"


def test_nothing_is_printed_by_decoders(capfd: pytest.CaptureFixture[str]) -> None:
    def work(_: Tell) -> bytes:
        os.write(2, b"libtiff is astonished")
        return b""

    run_limited(work, bytes, Limits(), exhausted="too much")
    assert capfd.readouterr().err == ""
