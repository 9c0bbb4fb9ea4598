"""A show with one console, for the tests of clips."""

from __future__ import annotations

from typing import Any

from omote.model.cast import Cast
from omote.show.declaration import CharacterCommand, ClientMessage, Outgoing
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Hello, Refused
from omote.show.objects.state import CharacterState
from omote.show.session import ShowSession

DT = 1.0 / 60.0


class Show:
    """A session with one console, and its clock."""

    def __init__(self, cast: Cast, session: ShowSession | None = None) -> None:
        self.session = ShowSession(cast) if session is None else session
        self.now = 0.0
        self.calls = 0
        self.session.receive("a", Hello("console", PROTOCOL_VERSION), 0.0)
        self.session.tick(self.now)

    def send(self, kind: type[ClientMessage], *values: Any, **named: Any) -> list[Outgoing]:
        self.calls += 1
        place = int(issubclass(kind, CharacterCommand))  # of the id
        given = (*values[:place], f"call {self.calls}", *values[place:])
        return self.session.receive("a", kind(*given, **named), self.now)

    def run(self, seconds: float) -> list[dict[str, float]]:
        return [dict(state.channels) for state in self.states(seconds)]

    def states(self, seconds: float, character: str = "one") -> list[CharacterState]:
        shown = []
        for _ in range(round(seconds / DT)):
            self.now += DT
            shown.append(self.session.tick(self.now).characters[character])
        return shown

    def set(self, **channels: float) -> None:
        for name, value in channels.items():
            self.session.receive("a", SetChannel("one", name, value), self.now)

    def playing(self) -> list[str]:
        return [clip.name for clip in self.session.tick(self.now).characters["one"].clips]


def reason(answers: list[Outgoing]) -> str:
    (answer,) = answers
    assert isinstance(answer.message, Refused)
    return answer.message.reason
