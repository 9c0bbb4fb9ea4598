"""The clients of a show: consoles with their names, stages with their reports, sources."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Literal

from omote.show import messages as wire
from omote.show.access.people_list import ANYBODY, Visitor
from omote.show.crew.contention import name_apart
from omote.show.validation import FPS, Refusal, validate_number

LOST_SECONDS = 600.0
"""How long a stage that does not come back is missed: after that somebody has put it away."""
SILENCE = 3.0
"""Seconds without a heartbeat after which a stage counts as not drawing."""


@dataclass(frozen=True)
class Member:
    """A connected client: its role, its last report with the time of it, and the name of a console or a source.

    claims: it asked for that name, else it was given one; page: the page that the link belongs to; seat: the operator
    at it, or the source itself; "" for a stage.
    """

    role: wire.Role | Literal["source"]
    report: wire.StageReport | None = None
    heard: float = -math.inf
    name: str = ""
    claims: bool = False
    page: str = ""
    seat: str = ""


def report_in(message: wire.Drawing) -> wire.StageReport:
    """What a stage reports; Refusal for a rate that none has."""
    fps = validate_number(message.fps, FPS)
    return wire.StageReport(fps, message.level, message.name, message.sound, message.sound_here)


class Members:
    """Who is connected. present: each client's entry."""

    def __init__(self) -> None:
        self.present: dict[str, Member] = {}
        self._visitors: dict[str, Visitor] = {}
        self._lost_stages: list[float] = []  # when the links broke

    def __getitem__(self, who: str) -> Member:
        if who not in self.present:
            raise Refusal("nothing is heard before hello: send hello with role and version first.")
        return self.present[who]

    def refuse_a_stage(self, who: str, message: wire.FromClient) -> None:
        """Refusal where a message that plays comes from a stage, or from who said no hello."""
        if self[who].role == "stage":
            raise Refusal(f"{type(message).__struct_config__.tag} came from a stage, but only a console plays.")

    def identify(self, who: str, visitor: Visitor) -> None:
        """Notes who has opened a link, by their token; who is not noted is on this machine and may do all."""
        self._visitors[who] = visitor

    def visitor(self, who: str) -> Visitor:
        """Who has opened a link."""
        return self._visitors.get(who, ANYBODY)

    def join(self, who: str, name: str, seat: str = "") -> None:
        """Adds a source: it hears nothing and needs no hello. seat: for whom it plays, where not for itself."""
        self.present[who] = Member("source", name=name, seat=seat or who)

    def leave(self, who: str, *, lost: float | None = None) -> None:
        """Removes a client; lost: when its link broke, where its page was not closed."""
        member = self.present.pop(who, None)
        self._visitors.pop(who, None)
        if member is not None and member.role == "stage" and lost is not None:
            self._lost_stages.append(lost)

    def report(self, who: str, report: wire.StageReport, now: float) -> None:
        """Notes what a stage draws; Refusal where it said no hello."""
        self.present[who] = replace(self[who], report=report, heard=now)

    def admit(self, who: str, hello: wire.Hello) -> list[str]:
        """Adds a client that says hello, or changes it; returns whose names are new: another's too, where that was
        given the name that a console claims. Links of the same page must have left."""
        if hello.role == "stage" and who not in self.present:
            del self._lost_stages[:1]  # one of them is back, or another in its place
        if hello.role != "console":
            self.present[who] = Member(hello.role)
            return [who]
        name = hello.name.strip() or self.visitor(who).name
        seat = f"seat {hello.seat or hello.page or who}"
        self.present[who] = Member("console", name=name, claims=bool(name), page=hello.page, seat=seat)
        consoles = {each: (self.present[each].name, self.present[each].claims) for each in self.consoles()}
        names = name_apart(consoles, who)
        for each, name in names.items():
            self.present[each] = replace(self.present[each], name=name)
        return list(names)

    def links_of_page(self, page: str) -> list[str]:
        """The clients of a page: a link of it that has broken, or its own before another hello."""
        return [who for who, each in self.present.items() if page and each.page == page]

    def now(self, now: float) -> wire.Crew:
        """Who is connected, and what each stage draws."""
        members = list(self.present.values())
        stages = [m.report if now - m.heard <= SILENCE else None for m in members if m.role == "stage"]
        lost = sum(now - broke <= LOST_SECONDS for broke in self._lost_stages)
        return wire.Crew(stages, sum(m.role == "console" for m in members), lost)

    def consoles(self) -> dict[str, str]:
        """The names of the consoles, by client."""
        return {who: member.name for who, member in self.present.items() if member.role == "console"}

    def sources(self) -> dict[str, str]:
        """The names of the sources, by client."""
        return {who: member.name for who, member in self.present.items() if member.role == "source"}
