"""A thousand losses and returns of each kind of source, ours beside cutting; then all are gone, and nothing sticks.

Each kind plays a character of its own in one session, by the messages or the packets of the real one, at its own rate;
at random moments it is lost in one of its ways (silence, a performer who is not found, an end that it says, a link that
breaks) and comes back. An operator calls expressions of all characters meanwhile. Shown at 60 Hz. Measured is the
largest change of step from one frame to the next (second difference) of any channel or angle:

* cutting: what a source sends shows while it is there, and nothing while it is not;
* ours: at most 1/30 of that. Of a character that moves by itself (lids, saccades), and of lips, whose noise shows, what
  is more than the same does that is never lost, which is measured beside it.

Ten seconds after all have gone each character shows what one shows that nothing ever played, to the bit.

`python -m benchmarks.loss [--seed N] [--count N]`; without a seed each run draws its own and prints it.
"""

from __future__ import annotations

import os

from omote.show.declaration import ClientMessage
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression
from omote.show.objects.characters import AddCharacter
from omote.show.objects.link import Hello, Refused
from omote.show.objects.motion import LookAt, SetMotion
from omote.show.objects.sources import Drive, LeaveSource, RouteSource, Source, SourceIs, StreamKind
from omote.show.objects.state import CharacterState

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import secrets
import sys
from typing import ClassVar

import msgspec
import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table

import omote
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.live_link_face import encode_live_link_face
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.inputs.trackers.vmc_messages import encode_vmc
from omote.perform.performer import Performer
from omote.show.session import ShowSession

COUNT = 1000
RATE = 60
BAR = 1 / 30
MEAN_PLAY = 0.8
MEAN_LOSS = 0.8
"""Seconds, in the mean, for which a source plays and is lost."""
AFTER = 10.0
"""Seconds after the end of all in which everything comes to rest."""
OPERATOR = "operator"
PLAIN = "one"
"""Who commands, and the character that no source plays."""
NAMES = tuple(name for name in ARKIT_NAMES if not name.startswith("eye"))
MOUTH = tuple(name for name in NAMES if name.startswith(("mouth", "jaw")))
LIPS_INFLUENCE = 0.7

Values = NDArray[np.float64]


def obey(session: ShowSession, who: str, message: ClientMessage, now: float) -> None:
    """Has a message obeyed; RuntimeError where it is rejected."""
    answers = session.receive(who, message, now)
    if any(isinstance(each.message, Refused) for each in answers):
        raise RuntimeError(f"{message}: {answers}")


class Kind:
    """A kind of source: it begins, sends, is lost and ends. cut: what shows of it where it is cut in and out."""

    rate = 30
    ways: ClassVar[tuple[str, ...]] = ("silence", "not found", "ends", "link breaks")

    def __init__(self, session: ShowSession, character: str, rng: np.random.Generator) -> None:
        self.session = session
        self.character = character
        self.rng = rng
        self.who = f"source of {character}"
        self.speed = rng.uniform(0.2, 2.0, len(NAMES))
        self.phase = rng.uniform(0.0, 6.3, len(NAMES))
        self.weights = np.zeros(len(NAMES))
        self.head = (0.0, 0.0, 0.0)
        self.begin(0.0)

    def begin(self, now: float) -> None:
        """It is there for the first time, or after an end."""

    def send(self, now: float) -> None:
        """One frame."""

    def lose(self, way: str, now: float) -> None:
        """It is lost."""

    def end(self, _: float) -> None:
        """It has gone for ever."""
        self.session.leave(self.who)

    def move(self, now: float) -> None:
        """Weights and a head that all move, with noise."""
        moved = 0.5 + 0.45 * np.sin(self.speed * now + self.phase) + 0.02 * self.rng.standard_normal(len(NAMES))
        self.weights = np.clip(moved, 0.0, 1.0)
        yaw, pitch, roll = 0.5 * np.sin(0.7 * now + np.arange(3.0))
        self.head = float(yaw), float(pitch), float(roll)

    @property
    def cut(self) -> Values:
        """Channels, head and eyes."""
        return np.concatenate([self.weights, self.head, np.zeros(4)])


class Tracker(Kind):
    """A source of a link. kind: its layer; names: its channels."""

    kind: StreamKind = "tracker"
    names: tuple[str, ...] = NAMES
    index = 0

    def begin(self, now: float) -> None:
        """It opens its link, or is switched on."""
        if self.who not in self.session.crew:
            self.session.receive(self.who, Hello("console", PROTOCOL_VERSION, self.who[:24]), now)
        source = Source(self.who, self.kind, list(self.names), [self.character])
        for answer in self.session.receive(self.who, source, now):
            self.index = answer.message.index if isinstance(answer.message, SourceIs) else self.index

    def send(self, now: float) -> None:
        """It sends a frame."""
        self.move(now)
        self._drive(now, found=True)

    def lose(self, way: str, now: float) -> None:
        """It is lost in a way."""
        if way == "not found":
            self._drive(now, found=False)
        elif way == "ends":
            obey(self.session, self.who, LeaveSource(self.index), now)
        elif way == "link breaks":
            self.session.leave(self.who, lost=now)

    def _drive(self, now: float, *, found: bool) -> None:
        sent = self.weights[[NAMES.index(name) for name in self.names]].astype("<f4").tobytes()
        head = None if self.kind == "lips" else self.head
        obey(self.session, self.who, Drive(self.index, sent, head, None, found), now)


class Program(Tracker):
    """A program that plays a recording."""

    kind = "playback"
    rate = 60


class Speech(Tracker):
    """A page with a microphone, whose lips come at 100 Hz."""

    kind = "lips"
    rate = 100
    names = MOUTH

    def move(self, now: float) -> None:
        """As of all; `twin` hears it too, and is never lost: lips are followed so soon that their noise shows."""
        super().move(now)
        if not hasattr(self, "twin"):
            self.twin = Performer(self.session.cast)
        sent = dict(zip(NAMES, self.weights.tolist(), strict=True))
        self.twin.drive({name: sent[name] for name in MOUTH}, layer="lips")

    @property
    def never(self) -> Values:
        """What the twin shows."""
        if not hasattr(self, "twin"):
            return self.cut
        channels = self.twin.advance(1 / RATE).channels
        return np.array([*(channels.get(name, 0.0) for name in NAMES), *np.zeros(7)])

    @property
    def cut(self) -> Values:
        """The mouth alone, by the influence of lips."""
        shown = np.where([name in MOUTH for name in NAMES], LIPS_INFLUENCE * self.weights, 0.0)
        return np.concatenate([shown, np.zeros(7)])


class Idle(Tracker):
    """A tracker whose character idles while it is lost, with still lids."""

    def begin(self, now: float) -> None:
        """It opens its link, or is switched on."""
        super().begin(now)
        obey(self.session, OPERATOR, SetMotion(self.character, None, 0.0, 0.0, 2.0, idle=True), now)

    def end(self, now: float) -> None:
        """It has gone for ever."""
        super().end(now)
        obey(self.session, OPERATOR, SetMotion(self.character, idle=False), now)


class Phone(Kind):
    """A phone that sends Live Link Face by UDP. protocol: what it sends; host: from where."""

    rate = 60
    protocol = "livelink"
    host = "10.0.0.7"
    ways: ClassVar[tuple[str, ...]] = ("silence",)

    def begin(self, now: float) -> None:
        """It opens its link, or is switched on."""
        self.input = TrackerInput(TRACKER_PROTOCOLS[self.protocol], lambda: self.session)
        self.send(now)
        (name,) = (each.name for each in self.session.sources.states({}) if self.host in each.name)
        obey(self.session, OPERATOR, RouteSource(name, name, [self.character], "tracker"), now)

    def packets(self, now: float) -> list[bytes]:
        """The packets of one frame."""
        named = dict(zip(NAMES, self.weights.tolist(), strict=True))
        values = [named.get(name, 0.0) for name in ARKIT_NAMES]
        frame = int(self.rate * now)
        return [encode_live_link_face(values, self.head, (0.0, 0.0), device="D" * 36, subject="Phone", frame=frame)]

    def send(self, now: float) -> None:
        """It sends a frame."""
        self.move(now)
        for packet in self.packets(now):
            self.input.receive(self.host, packet, now)
        self.input.play(now)

    def end(self, _: float) -> None:
        """It has gone for ever."""
        for who in [who for who in self.session.crew if self.host in who]:
            self.session.leave(who)


class Puppet(Phone):
    """A program that sends VMC by UDP."""

    protocol = "vmc"
    host = "10.0.0.8"

    def packets(self, now: float) -> list[bytes]:
        """The packets of one frame."""
        return encode_vmc(dict(zip(NAMES, self.weights.tolist(), strict=True)), self.head, (0.0, 0.0), now)


class Automatic(Kind):
    """What a character does by itself, switched off and on; `twin` does the same and is never switched off."""

    rate = RATE
    ways: ClassVar[tuple[str, ...]] = ("switched off",)

    def begin(self, now: float) -> None:
        """It opens its link, or is switched on."""
        if now == 0.0:
            self.twin = Performer(self.session.cast)
            self.shown = np.zeros(len(NAMES) + 7)
            self.twin.set_motion(0.5, seed=7)
            self.twin.look_at("direction", yaw=0.6, pitch=0.2)
        obey(self.session, OPERATOR, SetMotion(self.character, 0.5, seed=7), now)
        obey(self.session, OPERATOR, LookAt(self.character, "direction", yaw=0.6, pitch=0.2), now)

    def lose(self, _: str, now: float) -> None:
        """It is switched off."""
        obey(self.session, OPERATOR, SetMotion(self.character, 0.0), now)
        obey(self.session, OPERATOR, LookAt(self.character, "ahead"), now)

    def end(self, now: float) -> None:
        """It has gone for ever."""
        self.lose("", now)

    @property
    def cut(self) -> Values:
        """What the twin shows."""
        frame = self.twin.advance(1 / RATE)
        eyes = [frame.gaze.yaw, frame.gaze.pitch] * 2
        head = [frame.head.yaw, frame.head.pitch, frame.head.roll]
        return np.array([*(frame.channels.get(name, 0.0) for name in NAMES), *head, *eyes])


KINDS: dict[str, type[Kind]] = {
    "tracker": Tracker, "tracker, idle when lost": Idle, "phone, Live Link Face": Phone, "puppet program, VMC": Puppet,
    "program, playback": Program, "page, lips at 100 Hz": Speech, "automatic motion": Automatic,
}  # fmt: skip
"""What is lost and returns, each beside a character that nothing plays; another kind is a line here."""


class Trial:
    """A kind on its character: when it is lost and returns, and how far what shows changes its step."""

    def __init__(self, kind: Kind) -> None:
        self.kind = kind
        self.plays = True
        self.until = 2.0
        self.way = ""
        self.count = 0
        self.last = {name: [np.zeros(len(NAMES) + 7)] * 2 for name in ("cut", "ours", "never lost")}
        self.worst = dict.fromkeys(self.last, 0.0)
        self.due = 0.0

    def step(self, now: float) -> None:
        """What happens until now."""
        kind = self.kind
        if now >= self.until:
            self.plays = not self.plays
            if self.plays and self.way in ("ends", "link breaks", "switched off"):
                kind.begin(now)
            elif not self.plays:
                self.way = str(kind.rng.choice(kind.ways))
                self.count = self.count + 1
                kind.lose(self.way, now)
            self.until = now + kind.rng.exponential(MEAN_PLAY if self.plays else MEAN_LOSS)
        while self.due <= now:
            (kind.send if self.plays else kind.move)(now)
            self.due = max(self.due, now - 1 / RATE) + 1 / kind.rate

    def note(self, shown: Values, now: float) -> None:
        """What shows now."""
        sent = self.kind.cut
        never = self.kind.never if isinstance(self.kind, Speech) else sent
        told = {"cut": sent if self.plays else np.zeros_like(sent), "ours": shown, "never lost": never}
        for name, value in told.items():
            first, second = self.last[name]
            if now > 2.0:  # all begin at rest
                self.worst[name] = max(self.worst[name], float(np.abs(value - 2.0 * second + first).max()))
            self.last[name] = [second, value]

    @property
    def share(self) -> float:
        """Our change of step beside cutting; of automatic motion and of lips what is more than their own."""
        own = self.worst["never lost"] if isinstance(self.kind, Automatic | Speech) else 0.0
        return max(0.0, self.worst["ours"] - own) / self.worst["cut"]


def values_of(state: CharacterState) -> Values:
    """Channels, head and eyes."""
    return np.array([*(state.channels.get(name, 0.0) for name in NAMES), *state.head, *state.eyes])


def measure(cast: omote.Cast, seed: int, count: int) -> tuple[dict[str, Trial], list[str], float]:
    """The trial of each kind, the characters on which something sticks in the end, and the seconds played."""
    rng = np.random.default_rng(seed)
    session = ShowSession(cast)
    session.receive(OPERATOR, Hello("console", PROTOCOL_VERSION, OPERATOR), 0.0)
    session.tick(0.0)
    trials = {}
    for number, (name, kind) in enumerate(KINDS.items()):
        obey(session, OPERATOR, AddCharacter(f"add{number}", f"c{number}", name, "generic"), 0.0)
        trials[name] = Trial(kind(session, f"c{number}", rng))
    expressions = [name for name, title in cast.titles.items() if title.kind == "performed"]
    frame = 0
    while min(trial.count for trial in trials.values()) < count:
        frame += 1
        if rng.random() < 1 / 180:
            call = CallExpression("*", f"e{frame}", str(rng.choice(expressions)), 0.7, "smooth")
            obey(session, OPERATOR, call, frame / RATE)
        for trial in trials.values():
            trial.step(frame / RATE)
        characters = session.tick(frame / RATE).characters
        for number, trial in enumerate(trials.values()):
            trial.note(values_of(characters[f"c{number}"]), frame / RATE)
    return trials, find_stuck(session, trials, frame), frame / RATE


def find_stuck(session: ShowSession, trials: dict[str, Trial], frame: int) -> list[str]:
    """The kinds whose character shows another than one that nothing played, when all have gone."""
    for trial in trials.values():
        trial.kind.end(frame / RATE)
    obey(session, OPERATOR, CallExpression("*", "last", "neutral", 0.5, "smooth"), frame / RATE)
    for _ in range(round(AFTER * RATE)):
        frame += 1
        characters = session.tick(frame / RATE).characters
    own = {"label": "", "place": None, "motion": None, "presence": 1.0}
    plain = msgspec.structs.replace(characters[PLAIN], **own)
    found = {name: msgspec.structs.replace(characters[f"c{n}"], **own) for n, name in enumerate(trials)}
    return [name for name, state in found.items() if state != plain]


def main() -> int:
    """Measures and prints; 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--count", type=int, default=COUNT)
    asked = parser.parse_args()
    seed = secrets.randbits(32) if asked.seed is None else asked.seed
    trials, stuck, seconds = measure(omote.load_cast(), seed, asked.count)
    table = Table(title=f"losses and returns in {seconds:.0f} s at {RATE} Hz, seed {seed}")
    for column in ("kind", "losses", "ways", "cutting", "ours", "never lost", "of cutting"):
        table.add_column(column)
    for name, trial in trials.items():
        worst = [f"{trial.worst[each]:.4f}" for each in ("cut", "ours", "never lost")]
        beside = "less than its own" if trial.share == 0.0 else f"1/{1 / trial.share:.0f}"
        table.add_row(name, str(trial.count), ", ".join(trial.kind.ways), *worst, beside)
    Console().print(table)
    share = max(trial.share for trial in trials.values())
    claims = (
        (f"change of step at most {share:.4f} of cutting, of {BAR:.4f}", share <= BAR),
        (f"what sticks after all have gone: {', '.join(stuck) or 'nothing'}", not stuck),
    )
    for told, holds in claims:
        Console().print(f"{'ok    ' if holds else 'MISSED'} {told}")
    return 0 if all(holds for _, holds in claims) else 1


if __name__ == "__main__":
    sys.exit(main())
