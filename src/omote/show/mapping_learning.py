"""A mapping learned by touching: what a console moves meanwhile becomes the targets of a macro."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from omote.perform.frame import Held
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS
from omote.perform.mappings.mapping import CHANNEL, GAZE, HEAD, MOST_TARGETS, MacroMapping, MacroTarget, fitted
from omote.perform.scene.scene import Scene
from omote.show.declaration import ClientMessage
from omote.show.objects.faders import SetChannel, SetGaze, SetHead
from omote.show.objects.hand.macros import MappingLearned, MoveMacro, SetMapping

LEARNS_SECONDS = 60.0
"""After which learning ends by itself, where nothing is touched: what was touched is kept."""
CALL_KEPT = 56
"""Letters of the id of a lesson in that of its mapping, which has 64 at most."""
MOVED = 1e-4
"""Of a weight, or radians: what moved less was not touched."""


@dataclass(frozen=True)
class Touched:
    """A target that was moved: its value before, where it was left last, and where it was farthest from before."""

    before: float
    now: float
    farthest: float

    def left_at(self, to: str) -> float:
        """Where it counts as left: a head and a gaze that are where they were before have been brought back by the
        springs of a pad, and count as left where they were farthest. to: the target."""
        springs = to.partition("/")[0] in (HEAD, GAZE) and abs(self.now - self.before) <= MOVED
        return self.farthest if springs else self.now


@dataclass(frozen=True)
class Learner:
    """Who learns what. call: the id of the message that began; touched: by target; until: seconds, monotonic."""

    who: str
    call: str
    character: str
    name: str
    touched: dict[str, Touched]
    until: float


class MappingLearning:
    """What is learned of mappings in a session: one macro at a time. scene: on air now; name_of: what others call a
    client."""

    def __init__(self, scene: Callable[[], Scene], name_of: Callable[[str], str]) -> None:
        self._scene = scene
        self._name_of = name_of
        self._learner: Learner | None = None
        self._told: MappingLearned | None = None

    def begin(self, who: str, call: str, character: str, name: str, now: float) -> None:
        """Learns the targets of a macro from what a client moves from now on; ValueError while another learns.

        who: the client; call: the id of its message; character: whose macro it is; name: of the macro; now: seconds,
        monotonic.
        """
        learner = self._learner
        if learner is not None and learner.who != who:
            raise ValueError(
                f"{self._name_of(learner.who)} is teaching the macro {learner.name}; wait until it is done"
            )
        self._learner = Learner(who, call, character, name, {}, now + LEARNS_SECONDS)

    def is_learner(self, who: str) -> bool:
        """Whether a client (who) teaches a macro now."""
        return self._learner is not None and self._learner.who == who

    def positions(self, message: ClientMessage) -> dict[str, float]:
        """Where the targets of a message of the learner stand that it may move, by target."""
        learner = self._learner
        if learner is None or getattr(message, "character", "") != learner.character:
            return {}
        held = self._scene()[learner.character].held_by_faders
        if isinstance(message, SetChannel):
            return {f"{CHANNEL}/{message.name}": held.channels.get(message.name, 0.0)}
        if isinstance(message, SetHead):
            return {f"{HEAD}/{angle}": getattr(held.head, angle) for angle in HEAD_LIMITS}
        if isinstance(message, SetGaze):
            return {f"{GAZE}/{angle}": getattr(held.gaze, angle) for angle in GAZE_LIMITS}
        return {}

    def touch(self, message: ClientMessage, before: dict[str, float], now: float) -> None:
        """Notes what a message has moved. before: where its targets stood; now: seconds, monotonic."""
        learner = self._learner
        if learner is None:
            return
        touched = dict(learner.touched)
        for to, value in self.positions(message).items():
            known = touched.get(to)
            if known is not None:
                farther = abs(value - known.before) > abs(known.farthest - known.before)
                touched[to] = replace(known, now=value, farthest=value if farther else known.farthest)
            elif abs(value - before[to]) > MOVED and len(touched) < MOST_TARGETS:
                touched[to] = Touched(before[to], value, value)
        self._learner = replace(learner, touched=touched, until=now + LEARNS_SECONDS)

    def end(self, *, keeps: bool) -> tuple[str, list[ClientMessage]]:
        """Ends learning; returns who learned, and the messages that set the mapping and leave on air what shows: the
        macro stands at 1 and holds what was touched, and the faders are where they were before.

        keeps: whether what was touched becomes the mapping.
        """
        learner = self._learner
        self._learner = None
        if learner is None:
            return "", []
        mapping = mapping_of(learner)
        if not keeps or mapping is None or learner.character not in self._scene():
            return learner.who, []
        messages: list[ClientMessage] = [SetMapping(learner.character, f"{learner.call[-CALL_KEPT:]} learned", mapping)]
        faders = _faders_back(learner, self._scene()[learner.character].held_by_faders)
        return learner.who, [*messages, *faders, MoveMacro(learner.character, learner.name, 1.0)]

    def is_over(self, now: float) -> bool:
        """Whether nothing was touched for too long, or who learned has gone. now: seconds, monotonic."""
        return self._learner is not None and now >= self._learner.until

    def state(self) -> MappingLearned:
        """Who learns what, for consoles; no name where nobody does."""
        learner = self._learner
        if learner is None:
            return MappingLearned("", "", "", [])
        mapping = mapping_of(learner)
        targets = [] if mapping is None else [*mapping.targets]
        return MappingLearned(learner.character, learner.name, self._name_of(learner.who), targets)

    def news(self) -> MappingLearned | None:
        """What consoles were not told yet; None where they know all."""
        state = self.state()
        before = self._told
        self._told = state
        return None if state == before or (before is None and not state.name) else state


def mapping_of(learner: Learner) -> MacroMapping | None:
    """The mapping of what was touched: each target from where it was to where it was left; None of nothing."""
    targets = tuple(
        MacroTarget(to, 0.0, fitted(to, each.left_at(to) - each.before))
        for to, each in learner.touched.items()
        if abs(each.left_at(to) - each.before) > MOVED
    )
    return MacroMapping(learner.name, targets) if targets else None


def _faders_back(learner: Learner, held: Held) -> list[ClientMessage]:
    """The messages that bring faders back to where they were before they were touched. held: by faders now."""
    before = {to: each.before for to, each in learner.touched.items()}
    kinds = {to.partition("/")[0] for to in before}
    head = [before.get(f"{HEAD}/{angle}", getattr(held.head, angle)) for angle in HEAD_LIMITS]
    gaze = [before.get(f"{GAZE}/{angle}", getattr(held.gaze, angle)) for angle in GAZE_LIMITS]
    channels = {to.partition("/")[2]: value for to, value in before.items() if to.startswith(f"{CHANNEL}/")}
    return [
        *(SetChannel(learner.character, name, value) for name, value in channels.items()),
        *([SetHead(learner.character, *head)] if HEAD in kinds else []),
        *([SetGaze(learner.character, *gaze)] if GAZE in kinds else []),
    ]
