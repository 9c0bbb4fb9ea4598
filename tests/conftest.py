"""What tests of several folders share: the synthetic cast, and strategies for whole shows."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS
from omote.perform.easing import EASINGS
from omote.perform.lights import LIGHTS
from omote.perform.performer import Performer
from omote.server.supervision.supervisor import Supervisor
from tests import synthetic

# No test depends on how fast a machine is.
settings.register_profile(
    "omote", deadline=None, derandomize=True, max_examples=30, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("omote")


@dataclass(frozen=True)
class Command:
    """One thing an operator does, and the seconds that pass after it."""

    name: str
    arguments: tuple[Any, ...] = ()
    seconds: float | None = None
    easing: str = "smooth"
    wait: float = 0.0
    region: str | None = None

    def play(self, performer: Performer) -> None:
        """Does it."""
        options: dict[str, Any] = {} if self.seconds is None else {"seconds": self.seconds, "easing": self.easing}
        options |= {} if self.region is None else {"region": self.region}
        getattr(performer, self.name)(*self.arguments, **options)


_times = st.one_of(st.floats(0.0, 5.0), st.sampled_from([0.0, 0.1, 0.5, float("inf")]))
_easings = st.sampled_from(sorted(EASINGS))
_waits = st.floats(0.0, 1.0)
_hands = st.tuples(st.one_of(st.floats(0.0, 1.0), st.sampled_from([0.0, 1.0])))


def _call(axis: str, names: tuple[str, ...]) -> st.SearchStrategy[Command]:
    return st.builds(Command, st.just(f"call_{axis}"), st.tuples(st.sampled_from(names)), _times, _easings, _waits)


def _by_hand(axis: str) -> st.SearchStrategy[Command]:
    fade = st.builds(Command, st.just(f"fade_{axis}"), _hands, wait=_waits)
    return st.one_of(fade, fade, st.builds(Command, st.just(f"release_{axis}"), wait=_waits))


_channel = st.builds(
    Command, st.just("set_channel"), st.tuples(st.sampled_from(synthetic.EXPRESSIONS[1:]), st.floats(-0.5, 1.5))
)
_gaze = st.builds(Command, st.just("set_gaze"), st.tuples(st.floats(-0.69, 0.69), st.floats(-0.5, 0.5)))

_light = st.builds(
    Command, st.just("call_light"), st.tuples(st.sampled_from([*LIGHTS])), st.floats(0.0, 4.0), _easings, _waits
)

regional_calls = st.builds(
    Command,
    st.just("call_expression"),
    st.tuples(st.sampled_from(synthetic.EXPRESSIONS)),
    st.floats(0.0, 5.0),
    _easings,
    _waits,
    st.sampled_from(PLAY_REGIONS),
)

calls = st.one_of(_call("face", synthetic.FACES), _call("expression", synthetic.EXPRESSIONS))
moves = st.one_of(calls, calls, _by_hand("face"), _by_hand("expression"))
commands = st.one_of(moves, moves, regional_calls, _light, _channel, _gaze, st.just(Command("panic", wait=0.1)))
shows = st.lists(commands, max_size=30)


def random_moves(seed: int, count: int) -> list[Command]:
    """As many calls, T-bar moves and releases as asked for: longer than hypothesis would draw."""
    rng = np.random.default_rng(seed)
    names = {"face": synthetic.FACES, "expression": synthetic.EXPRESSIONS}
    moves = []
    for _ in range(count):
        axis = str(rng.choice(["face", "expression"]))
        wait = float(rng.exponential(0.3))
        kind = rng.choice(["call", "fade", "release"], p=[0.5, 0.4, 0.1])
        if kind == "call":
            time = float(rng.choice([0.0, np.inf, 0.05, 4.0 * rng.random()], p=[0.05, 0.15, 0.1, 0.7]))
            moves.append(
                Command(f"call_{axis}", (str(rng.choice(names[axis])),), time, str(rng.choice(list(EASINGS))), wait)
            )
        elif kind == "fade":
            moves.append(Command(f"fade_{axis}", (float(rng.choice([0.0, 1.0, rng.random()])),), wait=wait))
        else:
            moves.append(Command(f"release_{axis}", wait=wait))
    return moves


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Long tests first; all others stay in their order."""
    items.sort(key=lambda item: item.get_closest_marker("long") is None)


@pytest.fixture
def children_hear_ctrl_c() -> Iterator[None]:
    """What the test starts hears Ctrl-C, also where pytest was started with `&` or nohup, by which it would be ignored:
    a process ignores what its parent does."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def announcements_made(monkeypatch: pytest.MonkeyPatch) -> list[tuple[object, ...]]:
    """What would have been announced."""
    made: list[tuple[object, ...]] = []

    @contextmanager
    def announced(*what: object) -> Iterator[None]:
        made.append(what)
        yield

    monkeypatch.setattr("omote.server.devices.announcement.announce_beside", announced)
    return made


@pytest.fixture
def no_show(monkeypatch: pytest.MonkeyPatch, announcements_made: list[tuple[object, ...]]) -> list[Supervisor]:
    """Supervisors that are made but do not run; what would be announced of them is noted alone."""
    assert announcements_made == []
    made: list[Supervisor] = []

    def run(supervisor: Supervisor) -> int:
        made.append(supervisor)
        supervisor._opened()
        supervisor._listen.close()
        return 0

    monkeypatch.setattr(Supervisor, "run", run)
    return made


@pytest.fixture(scope="session")
def cast() -> Cast:
    """A small cast of three faces and twelve expressions, made without a file."""
    return synthetic.cast()
