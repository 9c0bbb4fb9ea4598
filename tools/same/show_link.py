"""Records a show's link: what a seeded script of several clients is answered with, and every state."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import TypeVar

import msgspec
import numpy as np

from omote.builtin import load_cast
from omote.model.cast import Cast
from omote.model.space.expression import Expression
from omote.perform.easing import EASINGS
from omote.show.declaration import Message, Outgoing
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import (
    CallExpression,
    CallFace,
    FadeExpression,
    FadeFace,
    Panic,
    ReleaseExpression,
    ReleaseFace,
    SetHome,
)
from omote.show.objects.faders import SetChannel, SetGaze, SetHead
from omote.show.objects.items import KeepExpression, KeepFace
from omote.show.objects.layouts import SetLayout
from omote.show.objects.link import Hello, Ping, Refused, Role
from omote.show.objects.pictures import CallLight
from omote.show.objects.stages import Drawing
from omote.show.session import ShowSession
from omote.show.wire import encode
from omote.showfile.changes import content_key
from omote.showfile.contents import pack_expression, pack_face
from omote.stage_data.playing_cast import Own, PlayingCast, build_playing_cast
from tools.same.compounds import SEED
from tools.same.recording import Recording

STEPS = 900
CLIENTS = ("stage one", "stage two", "console one", "console two", "stranger")
BROKEN = (b"", b"\xff" * 40, b"\x00" * 5000, b"\x80", b"\x81\xa4type\xa5dance", b"\x81\xa4type\xa5hello")
Value = TypeVar("Value")
ROLES: tuple[Role, ...] = ("stage", *("console",) * 7)  # most hellos leave a console a console

STRANGE = (math.nan, math.inf, -math.inf, 1e300, -7.0, 90.0)


@dataclass
class Script:
    """Draws what clients send."""

    cast: Cast
    rng: np.random.Generator
    names: dict[str, list[str]] = field(default_factory=dict)
    calls: int = 0

    def one(self, *values: Value) -> Value:
        """One of these."""
        return values[int(self.rng.integers(len(values)))]

    def face(self) -> str:
        """The name of a face, seldom of none."""
        return (
            self.one(*self.cast.faces, "own_face")
            if self.rng.random() < 0.95
            else self.one("nobody", "kaoru", "x" * 80)
        )

    def expression(self) -> str:
        """The name of an expression, seldom of none."""
        known = self.rng.random() < 0.95
        return self.one(*self.cast.expressions, "own_smile") if known else self.one("smirk", "smle", "y" * 80)

    def number(self, low: float, high: float) -> float:
        """A number in a range, at its end, or one that nobody may send."""
        kind = self.rng.random()
        return (
            self.one(*STRANGE)
            if kind < 0.06
            else self.one(low, high)
            if kind < 0.12
            else float(self.rng.uniform(low, high))
        )

    def seconds(self) -> float | None:
        """How long a call takes."""
        return self.one(None, 0.0, 0.0005, 0.2, self.number(0.0, 4.0), self.number(0.0, 3600.0))

    def call(self) -> str:
        """An id, now and then one that was used already."""
        self.calls += self.rng.random() < 0.85
        return f"call-{self.calls}"

    def easing(self) -> str:
        """The name of an easing, seldom of none."""
        return self.one(*EASINGS, *EASINGS, "bouncy")

    def message(self) -> Message:
        """What a client sends."""
        kinds = [*MESSAGES]
        weights = np.array([WEIGHT.get(kind, 1.0) for kind in kinds])
        return MESSAGES[kinds[int(self.rng.choice(len(kinds), p=weights / weights.sum()))]](self)


MESSAGES: dict[str, Callable[[Script], Message]] = {
    "hello": lambda s: Hello(s.one(*ROLES), s.one(1, 1, 1, 2)),
    "call_face": lambda s: CallFace("one", s.call(), s.face(), s.seconds(), s.easing()),
    "call_expression": lambda s: CallExpression("one", s.call(), s.expression(), s.seconds(), s.easing()),
    "call_light": lambda s: CallLight(
        s.call(), s.one("theatre", "portrait", "flat", "moon"), s.number(0.0, 3.0), s.easing()
    ),
    "fade_face": lambda s: FadeFace("one", s.number(0.0, 1.0)),
    "release_face": lambda _: ReleaseFace("one"),
    "fade_expression": lambda s: FadeExpression("one", s.number(0.0, 1.0)),
    "release_expression": lambda _: ReleaseExpression("one"),
    "set_channel": lambda s: SetChannel("one", s.expression(), s.one(0.0, s.number(-0.5, 1.5))),
    "set_head": lambda s: SetHead("one", s.number(-1.5, 1.5), s.number(-1.5, 1.5), s.number(-1.5, 1.5)),
    "set_gaze": lambda s: SetGaze("one", s.number(-1.5, 1.5), s.number(-1.5, 1.5)),
    "panic": lambda _: Panic("one"),
    "set_home": lambda s: SetHome("one", s.face(), s.number(0.0, 5.0)),
    "keep_face": lambda s: KeepFace("one", s.call()),
    "keep_expression": lambda s: KeepExpression("one", s.call()),
    "set_layout": lambda s: SetLayout("console", f'{{"columns": {s.rng.integers(9)}}}'),
    "ping": lambda s: Ping(s.number(0.0, 1e6)),
    "drawing": lambda s: Drawing(s.number(1.0, 120.0), s.one("lowest", "low", "medium", "good", "high")),
}
WEIGHT = {
    "hello": 0.5, "call_face": 4.0, "call_expression": 5.0, "fade_face": 3.0, "fade_expression": 3.0, "panic": 0.4,
    "set_channel": 4.0, "set_gaze": 2.0,
}  # fmt: skip


def record_session(recording: Recording) -> None:
    """A whole show: commands, states, what is kept, another cast, and a restart in the middle."""
    cast = load_cast()
    session = ShowSession(cast, epoch=3)
    script = Script(cast, np.random.default_rng(SEED))
    now = 100.0
    for place, client in enumerate(CLIENTS[:4]):
        hello = encode(Hello("stage" if place < 2 else "console", PROTOCOL_VERSION))
        _record_answers(recording, f"greeting {client}", session.receive_bytes(client, hello, now))
    for step in range(STEPS):
        key = f"{step:04d}"
        now = now + float(script.rng.exponential(0.15))
        if step == STEPS // 3:
            changed = session.recast(own_troupe(cast))
            recording.data("show: messages", f"{key} recast", encode(changed))
        if step == STEPS // 2:
            session = _restarted(recording, session)
        _step(recording, session, script, key, now)
    recording.data("show: messages", "at the end", repr((session.refused, session.commands)).encode())


def _step(recording: Recording, session: ShowSession, script: Script, key: str, now: float) -> None:
    rng = script.rng
    who = script.one(*CLIENTS, *CLIENTS[2:4] * 6)
    if who not in session.crew and who != CLIENTS[-1]:
        data = encode(Hello("stage" if "stage" in who else "console", PROTOCOL_VERSION))
        _record_answers(recording, f"{key} joins", session.receive_bytes(who, data, now))
    data = encode(script.message()) if rng.random() < 0.93 else script.one(*BROKEN, rng.bytes(30))
    recording.data("show: sent by the script", key, data)
    _record_answers(recording, key, session.receive_bytes(who, data, now))
    recording.data("show: states", key, encode(session.tick(now)))
    wishes = [(wish.who, msgspec.to_builtins(wish.message)) for wish in session.take_keep_requests()]
    held = [sorted(names) for names in session.names_held()]
    recording.data("show: wishes and names held", key, repr((wishes, held, session.clock(now + 0.01))).encode())
    if rng.random() < 0.1:
        recording.data("show: messages", f"{key} crew", encode(session.crew_now(now + rng.uniform(0.0, 4.0))))
    if rng.random() < 0.02:
        session.leave(who)
    recording.data("show: snapshots", key, encode(session.snapshot()))


def _restarted(recording: Recording, session: ShowSession) -> ShowSession:
    """The show as another server would go on with it, from the bytes of its snapshot."""
    data = encode(session.snapshot())
    snapshot = msgspec.msgpack.decode(data, type=type(session.snapshot()))
    again = ShowSession.restored(session.cast, snapshot, epoch=session.epoch + 1, revision=session.revision)
    for client, member in session.crew.items():
        if member.role == "source":
            continue  # it says no hello
        _record_answers(recording, f"again {client}", again.receive_bytes(client, encode(Hello(member.role, 1)), 0.0))
    return again


def _record_answers(recording: Recording, key: str, answers: Iterable[Outgoing]) -> None:
    """Messages as they go out; the reason of a refusal goes to the sentences."""
    plain = []
    for place, each in enumerate(answers):
        message = each.message
        if isinstance(message, Refused):
            recording.sentence(f"show {key} {place}", message.reason)
            message = Refused("")
        plain.append((each.who, encode(message)))
    recording.data("show: messages", key, repr(plain).encode())


def own_contents(cast: Cast) -> dict[str, bytes]:
    """Two contents, an expression's and a face's, by key."""
    smile = cast.expressions["smile"]
    wider = Expression(
        smile.dtheta * 1.2, smile.dh * 1.2, smile.ratio, smile.residual, smile.parts, smile.eyes, smile.radius,
        smile.transfer, smile.pupil,
    )  # fmt: skip
    packed = (pack_expression(wider), pack_face(cast.faces["dog"], cast.looks["kaori"]))
    return {content_key(data): data for data in packed}


def own_troupe(cast: Cast) -> PlayingCast:
    """The cast with an own expression and an own face."""
    contents = own_contents(cast)
    smile, face = contents
    own = (
        Own("expression", "own_smile", "Own smile", ("wide",), 1.0, smile),
        Own("face", "own_face", "Own face", (), 2.0, face),
    )
    return build_playing_cast(cast, own, contents)
