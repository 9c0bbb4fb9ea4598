"""The show that benchmarks of a night play: four characters, of which two are tracked and two move by themselves."""

from __future__ import annotations

import numpy as np

import omote
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.characters import AddCharacter
from omote.show.objects.link import Hello
from omote.show.objects.sources import Drive, Source
from omote.show.session import ShowSession
from omote.show.wire import encode

RATE = 60
CONSOLES = ("ana", "bo", "cy", "di")


def tracked_names(cast: omote.Cast) -> list[str]:
    """The channels that trackers send."""
    return [name for name, title in cast.titles.items() if title.kind == "arkit"]


def begin_show(cast: omote.Cast) -> ShowSession:
    """A show of four consoles and four characters: trackers drive the first two, the others move by themselves."""
    session = ShowSession(cast)
    for who in CONSOLES:
        session.receive(who, Hello("console", PROTOCOL_VERSION, who), 0.0)
    for number in range(1, 4):
        session.receive("ana", AddCharacter(f"add{number}", f"c{number}", f"C{number}", "generic"), 0.0)
    characters = list(session.scene)
    for who in characters[:2]:
        session.receive("ana", Source(f"tracker {who}", "tracker", tracked_names(cast), [who]), 0.0)
    for who in characters[2:]:
        session.scene[who].set_motion(0.5)
    return session


def track(frame: int, channels: int, rng: np.random.Generator) -> list[bytes]:
    """What both trackers send in a frame: every value swings, with noise in its last bits. channels: how many."""
    phase = frame / RATE * 3.0 + np.arange(channels)
    return [(0.45 + 0.4 * np.sin(phase + n) + 0.03 * rng.random(channels)).astype("<f4").tobytes() for n in (0, 1)]


def drive(session: ShowSession, frame: int, values: list[bytes]) -> None:
    """Sends a frame of both trackers. values: as of `track`."""
    for index, weights in enumerate(values):
        message = Drive(index + 1, weights, (0.1, 0.05, 0.0), (0.1, -0.1))
        session.receive_bytes("ana", encode(message), frame / RATE)
