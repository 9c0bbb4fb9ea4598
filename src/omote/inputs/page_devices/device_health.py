"""How devices and other sources do: what came from them, how often, what was rejected, and where controls stand."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from omote.inputs.page_devices.input_log import LineLog
from omote.inputs.page_devices.sender_activity import SenderActivity
from omote.inputs.rejection import Rejection
from omote.inputs.trackers.tracker_input import SenderCounts, TrackerInput
from omote.show.objects.bindings import SourceKind
from omote.show.objects.devices import DeviceState

MOST_VALUES = 64
RATE_SECONDS = 1.0


class DeviceHealth:
    """Counts of one device or source. heard, rejected: since it was first there; values: the newest, by control."""

    def __init__(self, now: float) -> None:
        self.heard = self.rejected = 0
        self.values: dict[str, float] = {}
        self._rate = 0.0
        self._begun = now
        self._before = 0

    def note(self, count: int = 1, rejected: int = 0) -> None:
        """Notes what came. count: how much; rejected: how much more was not obeyed."""
        self.heard += count
        self.rejected += rejected

    def read(self, control: str, value: float) -> None:
        """Notes where a control stands. value: 0 to 1."""
        if control not in self.values and len(self.values) >= MOST_VALUES:
            del self.values[next(iter(self.values))]
        self.values[control] = value

    def rate(self, now: float) -> float:
        """What comes a second, as it was in the last second or so."""
        passed = now - self._begun
        if passed >= RATE_SECONDS:
            self._rate = (self.heard - self._before) / passed
            self._begun = now
            self._before = self.heard
        return self._rate


@dataclass(frozen=True)
class SourceCounts:
    """A source beside the pages, such as OSC: its counts, the newest that came, the last rejection, and what to do at
    whoever sends it. senders: those of a tracker's protocol, each with its channels, instead of the newest. remark:
    what was said last of what is left out without being wrong, remarks: how often. alike: how many of the last were of
    the newest's control; None where it is not known."""

    name: str
    kind: SourceKind
    where: str
    heard: int
    rejected: int
    newest: str = ""
    last_rejection: Rejection | None = None
    values: dict[str, float] = field(default_factory=dict)
    advice: str = ""
    senders: tuple[SenderCounts, ...] = ()
    remarks: int = 0
    remark: Rejection | None = None
    alike: int | None = None


def count_tracker(trackers: TrackerInput, advice: str) -> SourceCounts:
    """The counts of all trackers of one protocol. advice: what to do at the sender."""
    return SourceCounts(
        name=trackers.protocol.title,
        kind="tracker",
        where=trackers.where,
        heard=trackers.heard,
        rejected=trackers.rejected,
        last_rejection=trackers.last_rejection,
        values=trackers.values(),
        advice=advice,
        senders=trackers.senders(),
        remarks=trackers.remarks,
        remark=trackers.remark,
    )


class SourceHealth:
    """Looks at the counts of a source now and then, so that a flood costs it nothing. probe: gives them."""

    def __init__(self, probe: Callable[[], SourceCounts]) -> None:
        self._probe = probe
        self._health = DeviceHealth(0.0)
        self._remarks = 0
        self._senders: dict[str, tuple[DeviceHealth, SenderActivity]] = {}

    def look(self, now: float, log: LineLog) -> DeviceState:
        """Its state now; what has come since the last look goes to the log."""
        counts = self._probe()
        health = self._health
        came = counts.heard - health.heard
        rejected = counts.rejected - health.rejected
        health.note(came, rejected)
        if came and counts.newest:
            alike = came if counts.alike is None else min(came, counts.alike)
            others = f" (and {came - alike} of others before it)" if came > alike else ""
            log.note(counts.name, counts.newest + others, now, count=alike)
        self._look_at_senders(counts, now, log)
        if counts.remarks > self._remarks and counts.remark is not None:
            log.note(counts.name, f"{counts.remark.sender}: {counts.remark.reason}", now)
        self._remarks = counts.remarks
        if rejected and counts.last_rejection is not None:
            reason = f"{counts.last_rejection.sender}: {counts.last_rejection.reason}"
            log.note(counts.name, reason, now, rejected=True, count=rejected)
        return DeviceState(
            name=counts.name,
            kind=counts.kind,
            where=counts.where,
            plugged=True,
            rate=round(health.rate(now), 1),
            heard=health.heard,
            rejected=health.rejected,
            values=counts.values,
            advice=counts.advice,
        )

    def _look_at_senders(self, counts: SourceCounts, now: float, log: LineLog) -> None:
        """Each sender that has sent since the last look is one line, which shows what moves."""
        known = self._senders
        self._senders = {}
        for sender in counts.senders:
            before = known.get(sender.name)
            begins = before is None or before[0].heard > sender.heard  # it has gone and come back meanwhile
            health, activity = (DeviceHealth(now), SenderActivity()) if begins or before is None else before
            self._senders[sender.name] = health, activity
            came = sender.heard - health.heard
            rate = health.rate(now)
            if came > 0:
                health.note(came)
                log.follow(counts.name, sender.name, now, count=came, rate=rate, bars=activity.look(sender.values))
