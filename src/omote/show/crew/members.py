"""The clients of a show: consoles with their names, stages with their reports, sources."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Literal

from omote.show.access.people_list import ANYBODY, Visitor
from omote.show.declaration import ClientMessage, tag_of
from omote.show.objects.link import Bus, Hello, Role
from omote.show.objects.stages import Crew, Drawing, StageReport
from omote.show.validation import DARK, FPS, Refusal, validate_number

LONGEST_NAME = 24
"""Characters of a console's name, as a hello may have it."""
NAMELESS = "console 1"
"""What a console is called that asks for nothing, with another number where that is taken."""
LOST_SECONDS = 600.0
"""How long a stage that does not come back is missed: after that somebody has put it away."""
SILENCE = 3.0
"""Seconds without a heartbeat after which a stage counts as not drawing."""


GIVEN, ASKED_FOR, OF_TOKEN = range(3)
"""How good the claim of a console on its name is: who has a better one gets it."""


@dataclass(frozen=True)
class Member:
    """A connected client: its role, its last report with the time of it, and the name of a console or a source.

    claim: on that name, `OF_TOKEN` where its token has it, `ASKED_FOR`, else `GIVEN`; page: the page that the link
    belongs to; seat: the operator at it, or the source itself; "" for a stage; bus: what it looks at.
    """

    role: Role | Literal["source"]
    report: StageReport | None = None
    heard: float = -math.inf
    name: str = ""
    claim: int = GIVEN
    page: str = ""
    seat: str = ""
    bus: Bus = "air"


class Members:
    """Who is connected. present: each client's entry; people: tells the names of tokens, which nobody else may have."""

    def __init__(self) -> None:
        self.people: Callable[[], Iterable[str]] = lambda: ()
        self.present: dict[str, Member] = {}
        self._visitors: dict[str, Visitor] = {}
        self._lost_stages: list[float] = []  # when the links broke

    def __getitem__(self, who: str) -> Member:
        if who not in self.present:
            raise Refusal("nothing is heard before hello: send hello with role and version first.")
        return self.present[who]

    def refuse_a_stage(self, who: str, message: ClientMessage) -> None:
        """Refuses a message that plays (Refusal) where it comes from a stage, or from a client (who) that said no
        hello."""
        if self[who].role == "stage":
            raise Refusal(f"{tag_of(type(message))} came from a stage, but only a console plays.")

    def looks_at(self, who: str) -> Bus:
        """The bus that a client (who) looks at, and plays on."""
        member = self.present.get(who)
        return "air" if member is None else member.bus

    @property
    def any_in_preview(self) -> bool:
        """Whether anybody looks at the preview."""
        return any(member.bus == "preview" for member in self.present.values())

    def identify(self, who: str, visitor: Visitor) -> None:
        """Notes who has opened a link, by their token; who is not noted is on this machine and may do all. who: the
        client; visitor: whose token it is."""
        self._visitors[who] = visitor

    def visitor(self, who: str) -> Visitor:
        """Who has opened a link."""
        return self._visitors.get(who, ANYBODY)

    def join(self, who: str, name: str, seat: str = "", bus: Bus = "air") -> None:
        """Adds a source: it hears nothing and needs no hello. seat: for whom it plays, where not for itself. who: the
        client; name: what it is called; bus: which it plays on."""
        self.present[who] = Member("source", name=name, seat=seat or who, bus=bus)

    def leave(self, who: str, *, lost: float | None = None) -> None:
        """Removes a client (who); lost: when its link broke, where its page was not closed."""
        member = self.present.pop(who, None)
        self._visitors.pop(who, None)
        if member is not None and member.role == "stage" and member.bus == "air" and lost is not None:
            self._lost_stages.append(lost)

    def report(self, who: str, drawing: Drawing, now: float) -> None:
        """Notes what a stage draws; Refusal where it said no hello, and for a rate that none has. who: the client;
        drawing: its report; now: seconds."""
        fps = validate_number(drawing.fps, FPS)
        dark = validate_number(drawing.dark, DARK)
        sound = (drawing.sound, drawing.sound_here)
        report = StageReport(fps, drawing.level, drawing.name, *sound, dark, drawing.awake)
        self.present[who] = replace(self[who], report=report, heard=now)

    def admit(self, who: str, hello: Hello) -> list[str]:
        """Adds a client that says hello, or changes it; returns whose names are new: another's too, where that was
        given the name that a console claims. Links of the same page must have left. Whose token has a name is called so
        whatever the hello says, and nobody else is, who came before or comes after. who: the client."""
        if hello.role == "stage" and hello.bus == "air" and who not in self.present:
            del self._lost_stages[:1]  # one of them is back, or another in its place
        if hello.role != "console":
            self.present[who] = Member(hello.role, bus=hello.bus)
            return [who]
        own = self.visitor(who).name
        name = own or hello.name.strip()
        claim = OF_TOKEN if own else ASKED_FOR if name else GIVEN
        seat = f"seat {hello.seat or hello.page or who}"
        self.present[who] = Member("console", name=name, claim=claim, page=hello.page, seat=seat, bus=hello.bus)
        consoles = {client: (self.present[client].name, self.present[client].claim) for client in self.consoles()}
        names = name_apart(consoles, who, self.people())
        for client, name in names.items():
            self.present[client] = replace(self.present[client], name=name)
        return list(names)

    def links_of_page(self, page: str) -> list[str]:
        """The clients of a page: a link of it that has broken, or its own before another hello."""
        return [who for who, member in self.present.items() if page and member.page == page]

    def now(self, now: float) -> Crew:
        """Who is connected, and what each stage draws that shows what is on air."""
        members = list(self.present.values())
        on_air = [m for m in members if m.role == "stage" and m.bus == "air"]
        stages = [m.report if now - m.heard <= SILENCE else None for m in on_air]
        lost = sum(now - broke <= LOST_SECONDS for broke in self._lost_stages)
        return Crew(stages, sum(m.role == "console" for m in members), lost)

    def consoles(self) -> dict[str, str]:
        """The names of the consoles, by client."""
        return {who: member.name for who, member in self.present.items() if member.role == "console"}

    def sources(self) -> dict[str, str]:
        """The names of the sources, by client."""
        return {who: member.name for who, member in self.present.items() if member.role == "source"}


def name_apart(consoles: Mapping[str, tuple[str, int]], who: str, people: Iterable[str] = ()) -> dict[str, str]:
    """The names of a console that comes, and of one that gives way to it; consoles: by client, what each is called or
    wants to be, and its claim on that: the better one has it. who: the client that comes; people: names of tokens,
    which only these have."""
    wanted, claim = consoles[who]
    same = [other for other, (name, _) in consoles.items() if name.casefold() == wanted.casefold()]
    yields = [other for other in same if other != who and claim > consoles[other][1]]
    names = {other: name for other, (name, _) in consoles.items() if other not in (who, *yields)}
    kept = {name.casefold() for name in people}
    for client in (who, *yields):
        taken = {name.casefold() for name in names.values()}
        name, claim = consoles[client]
        # with a number beside it, it would look like another page of theirs
        is_kept = claim < OF_TOKEN and without_number(name).casefold() in kept
        names[client] = free_name(NAMELESS if is_kept or not name else name, taken)
    return {client: names[client] for client in (who, *yields)}


def without_number(name: str) -> str:
    """A name without the number that sets it apart."""
    return re.sub(r"(?<=\S) \d+$", "", name)


def free_name(wanted: str, taken: set[str]) -> str:
    """The name of a console: the one wanted, else the lowest number beside its words that makes it its own. taken:
    names of others, in lower case."""
    words = without_number(wanted)
    room = LONGEST_NAME - len(f" {len(taken) + 3}")
    numbered = (f"{words[:room]} {number}" for number in range(2, len(taken) + 4))
    return next(name for name in (wanted, *numbered) if name.casefold() not in taken)
