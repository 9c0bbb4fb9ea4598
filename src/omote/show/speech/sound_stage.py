"""Which stage plays the sounds of a show: one at a time, for several would be an echo."""

from __future__ import annotations

from collections.abc import Mapping

from omote.show.crew.members import SILENCE, Member
from omote.show.declaration import Outgoing
from omote.show.objects.stages import PlaysSound


class SoundStage:
    """The stage that plays sounds, by client; "" while none does."""

    def __init__(self) -> None:
        self.who = ""

    def tell(self, members: Mapping[str, Member], now: float) -> list[Outgoing]:
        """What stages must be told now: the last one first, that it plays no more.

        A stage whose address asks for it goes before others, one that can play before one that waits for a click, and
        the one that does before those that could: members stand in the order in which they came.
        """
        able = {who: member for who, member in members.items() if _is_able(member, now)}
        chosen = min(able, key=lambda who: (*_rank(able[who]), who != self.who), default="")
        if chosen == self.who:
            return []
        before = self.who
        self.who = chosen
        ended = [(before, False)] if before in members else []
        return [Outgoing(who, PlaysSound(on)) for who, on in [*ended, *([(chosen, True)] if chosen else [])]]


def _is_able(member: Member, now: float) -> bool:
    report = member.report
    on_air = member.role == "stage" and member.bus == "air"
    return on_air and report is not None and report.sound != "" and now - member.heard <= SILENCE


def _rank(member: Member) -> tuple[bool, bool]:
    report = member.report
    assert report is not None
    return not report.sound_here, report.sound != "ready"
