"""A client of the session that is one source: it joins, opens its source, and hears what is refused."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from omote.show.declaration import Outgoing
from omote.show.objects.link import Refused
from omote.show.objects.sources import Source, SourceIs, StreamKind
from omote.show.session import ShowSession
from omote.show.sources.open_source import LAYER_OF

LONGEST_NAME = 24
"""Letters of a client's name in the list of those at the show."""


@dataclass
class SourceClient:
    """name: the source's; who: the client's id. index: by which the session knows the source, None before it does."""

    name: str
    who: str
    index: int | None = field(default=None, kw_only=True)

    def join(self, session: ShowSession) -> None:
        """Joins the session, where it is not there; its source is then to be opened anew."""
        if self.who not in session.crew:
            session.join(self.who, self.name[:LONGEST_NAME])
            self.index = None

    def open(
        self, session: ShowSession, kind: StreamKind, names: Iterable[str], now: float, *, direct: bool = False
    ) -> list[str]:
        """Opens its source; returns why that is refused. One that comes for the first time drives the character of a
        show that has one, if no other source does; else it waits until that is silent for long.

        session: the show; kind, names, direct: of the source; now: seconds of the show's clock.
        """
        sources = session.sources
        alone = sources.find_alone(self.name, session.scene, LAYER_OF[kind], now)
        first = not alone and not sources.remembers(self.name)
        answers = session.receive(self.who, Source(self.name, kind, list(names), alone, direct=direct), now)
        self.index = next((answer.message.index for answer in answers if isinstance(answer.message, SourceIs)), None)
        if first and self.index is not None:
            sources.let_wait(self.name)
        return refusals(answers)


def refusals(answers: Iterable[Outgoing]) -> list[str]:
    """Why answers of the session refuse something."""
    return [answer.message.reason for answer in answers if isinstance(answer.message, Refused)]
