"""The sources that are open: their frames, whom they drive, and the measures of their performers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from omote.arrays import Values
from omote.perform.frame import Gaze, Head
from omote.perform.layers.layer_names import LAYER_PARTS, RANGES, ROUTE_PARTS, RULES, LayerName, check_driven
from omote.perform.layers.source_frame import AUTOMATIC, BodyFrame, SourceFrame, check_names, check_smoothing
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, check_known
from omote.perform.newest_entries import with_newest
from omote.perform.scene.character_names import ALL
from omote.perform.scene.scene import Scene
from omote.perform.snapshot import Playable
from omote.show.objects.sources import (
    CalibrateSource,
    Drive,
    MeasureSource,
    RouteSource,
    Source,
    SourceIs,
    Sources,
    SourceState,
    SourceValues,
    StreamKind,
    TuneSource,
)
from omote.show.sources.calibration import AS_IT_IS, Calibration, measure_of
from omote.show.sources.open_source import (
    LAYER_OF,
    TUNED,
    OpenSource,
    begin_range,
    check_channels,
    hear_values,
    measured_by,
    read_body,
    read_share,
    read_values,
    source_state,
    source_values,
)
from omote.show.sources.sources_snapshot import MOST_REMEMBERED, Route, SourcesSnapshot
from omote.show.validation import Refusal

MOST_SOURCES = 32
TOLD_SECONDS = 1.0
QUIET_SECONDS = 10.0
"""After which a source that sees nobody keeps its characters from no other."""
WATCH_SECONDS = 0.05
"""Between two reports of what a source sends, to who watches it."""


@dataclass(frozen=True)
class RecordedSource:
    """A source that is open, as a recording keeps it: `OpenSource` without what follows from its performer's measure
    and what only consoles are told."""

    index: int
    name: str
    kind: StreamKind
    who: str
    names: tuple[str, ...]
    performer: str
    sent: list[float] | None
    rest: list[float] | None
    ranging: list[float] | None
    ranged: tuple[str, ...]
    found: bool
    smoothing: float
    direct: bool
    share: float


@dataclass(frozen=True)
class RecordedSources:
    """All sources that are open, as a recording keeps them. count: how many there were so far."""

    opened: tuple[RecordedSource, ...] = ()
    count: int = 0


class OpenSources:
    """All sources of a session, by index."""

    def __init__(self, snapshot: SourcesSnapshot | None = None) -> None:
        kept = SourcesSnapshot() if snapshot is None else snapshot
        self._open: dict[int, OpenSource] = {}
        self._routes = dict(kept.routes)
        self._calibrations = dict(kept.calibrations)
        self._count = 0
        self._told = 0.0
        self._changed = False
        self._watchers = dict[str, str]()
        self._watched = 0.0

    def snapshot(self) -> SourcesSnapshot:
        """What stays with the show."""
        return SourcesSnapshot(dict(self._routes), dict(self._calibrations))

    def playing(self) -> RecordedSources:
        """The sources that are open, for a recording."""
        return RecordedSources(tuple(
            RecordedSource(
                index, source.name, source.kind, source.who, source.names, source.performer,
                sent=_listed(source.sent), rest=_listed(source.rest), ranging=_listed(source.ranging),
                ranged=source.ranged, found=source.found, smoothing=source.smoothing, direct=source.direct,
                share=source.share,
            )
            for index, source in self._open.items()
        ), self._count)  # fmt: skip

    def replay(self, playing: RecordedSources) -> None:
        """Opens the sources as they were recorded. playing: those that were open."""
        self._count = playing.count
        for each in playing.opened:
            measure = measure_of(self._calibrations.get(each.performer, AS_IT_IS), each.names)
            self._open[each.index] = OpenSource(
                each.name, each.kind, each.who, each.names, each.performer, measure,
                sent=_array(each.sent), rest=_array(each.rest), ranging=_array(each.ranging), ranged=each.ranged,
                found=each.found, smoothing=each.smoothing, direct=each.direct, share=each.share,
            )  # fmt: skip

    def begin(self, who: str, asked: Source, scene: Scene, cast: Playable) -> SourceIs:
        """Opens a source; one of the same link and name gives way to it. Refusal where it cannot be. who: the client;
        asked: what it sends; scene: of the characters that it drives; cast: of the channels."""
        names = check_names(asked.names, cast.expressions)
        if asked.name == AUTOMATIC:
            raise Refusal(f"{AUTOMATIC} is what a character does by itself; choose another name.")
        if ALL not in asked.characters:
            for character in asked.characters:
                check_known(character, scene, "character")
        same = [index for index, source in self._open.items() if source.name == asked.name]
        if any(self._open[index].who != who for index in same):
            raise Refusal(f"another link sends as {asked.name} already; choose another name.")
        if not same and len(self._open) >= MOST_SOURCES:
            raise Refusal(f"{MOST_SOURCES} sources are open already; end one first.")
        performer = asked.performer or asked.name
        measure = measure_of(self._calibrations.get(performer, AS_IT_IS), names)
        index = same[0] if same else self._next()
        smoothing = check_smoothing(asked.smoothing)
        self._open[index] = OpenSource(
            asked.name, asked.kind, who, names, performer, measure, smoothing=smoothing, direct=asked.direct
        )
        self._changed = True
        if asked.characters or asked.name not in self._routes:
            layer = self._routes[asked.name].layer if asked.name in self._routes else LAYER_OF[asked.kind]
            self.set_route(scene, asked.name, Route(tuple(asked.characters), layer))
        return SourceIs(index, asked.name)

    def drive(self, who: str, frame: Drive, scene: Scene) -> None:
        """Plays a frame of a source: every layer that it drives follows it. Refusal, ValueError or TypeError where it
        cannot be, and nothing has changed. who: the client; scene: what is played."""
        source = self._of(who, frame.index)
        sent = read_values(source, frame)
        head = None if frame.head is None else Head(*frame.head)
        gaze = None if frame.gaze is None else Gaze(*frame.gaze)
        self._changed = self._changed or frame.found != source.found
        share = read_share(source, frame)
        body = read_body(frame)
        self._open[frame.index] = hear_values(source, sent, found=frame.found, share=share, body=body is not None)
        if sent is not None:
            self._play(scene, self._open[frame.index], sent, head, gaze, body)

    def end(self, who: str, index: int, scene: Scene) -> None:
        """Ends a source: its layers let go. Refusal where this link (who) has none of that index. scene: what it
        played."""
        source = self._of(who, index)
        self._let_go(scene, source.name)
        self._changed = True
        del self._open[index]

    def leave(self, who: str, scene: Scene) -> None:
        """Ends the sources of a link (who) that has ended. scene: what they played."""
        self._watchers.pop(who, None)
        for index in [index for index, source in self._open.items() if source.who == who]:
            self.end(who, index, scene)

    def route(self, name: str) -> Route:
        """Whom a source drives."""
        return self._routes.get(name, Route())

    def find_alone(self, name: str, characters: Iterable[str], layer: LayerName, now: float) -> list[str]:
        """Whom a source drives that comes for the first time: the character of a show that has one, where no other
        source plays it on this layer or did until a moment ago. name: of the source; characters: of the show; now:
        seconds."""
        alone = self._free(characters, layer, now)
        return alone if name not in self._routes else []

    def remembers(self, name: str) -> bool:
        """Whether there is a route of a source of this name."""
        return name in self._routes

    def let_wait(self, name: str) -> None:
        """Lets a source that plays nobody, and of which nobody has said so, take over where the one that plays is
        silent for long. name: the source's."""
        self._routes[name] = replace(self.route(name), waits=True)

    def _free(self, characters: Iterable[str], layer: LayerName, now: float) -> list[str]:
        """The character of a show that has one, where no source plays it on a layer or did until a moment ago."""
        routes = ((source, self.route(source.name)) for source in self._open.values())
        driven = any(
            route.characters and route.layer == layer and now - source.seen < QUIET_SECONDS for source, route in routes
        )
        alone = list(characters)
        return alone if len(alone) == 1 and not driven else []

    def take_over(self, scene: Scene, now: float) -> dict[str, Route]:
        """What waits and sees somebody plays the character that is free; returns the new routes by source. After a
        restart the one that played has its time to come back. scene: what is played; now: seconds, as of `news`."""
        taken: dict[str, Route] = {}
        for source in self._open.values():
            route = self.route(source.name)
            waited = route.waits and source.found and source.seen == now and now - source.known >= QUIET_SECONDS
            if waited and (alone := self._free(scene, route.layer, now)):
                taken[source.name] = Route(tuple(alone), route.layer, route.parts, body=route.body)
                self.set_route(scene, source.name, taken[source.name])
        return taken

    def reroute(self, asked: RouteSource, scene: Scene) -> None:
        """Routes a source; ValueError for a layer or a character that there is not. asked: the source and its new
        route; scene: what is played."""
        layer = check_driven(asked.layer)
        for character in asked.characters:
            if character != ALL:
                check_known(character, scene, "character")
        wanted = asked.regions or ROUTE_PARTS
        parts = tuple(part for part in LAYER_PARTS if part in wanted)
        self.set_route(scene, asked.source, Route(tuple(asked.characters), layer, parts, body="body" in wanted))

    def tune(self, asked: TuneSource, scene: Scene) -> None:
        """Sets how a source is read; ValueError where there is none, or for a number out of its range. asked: the
        source and its numbers; scene: what is played."""
        tuned = {name: getattr(asked, name) for name in TUNED}
        self._recalibrate(scene, asked.source, tuned)

    def measure(self, asked: MeasureSource, scene: Scene) -> None:
        """Sets what was measured of the performer before a source; ValueError as `tune`. asked: the source and its
        weights; scene: what is played."""
        self._recalibrate(scene, asked.source, {"neutral": dict(asked.neutral), "highest": dict(asked.highest)})

    def calibrate(self, asked: CalibrateSource, scene: Scene) -> None:
        """Measures the performer before a source, a step at a time; ValueError where there is none, or for a channel
        that it does not send. asked: the source and the step; scene: what is played."""
        self._step(scene, self._index_of(asked.source), asked)

    def _recalibrate(self, scene: Scene, name: str, changes: Mapping[str, Any]) -> None:
        performer = self._open[self._index_of(name)].performer
        before = self._calibrations.get(performer, AS_IT_IS)
        self._calibrate(scene, performer, replace(before, **changes))

    def states(self, consoles: Mapping[str, str]) -> list[SourceState]:
        """All open sources; consoles: the names of links."""
        return [
            source_state(source, self.route(source.name), consoles.get(source.who, ""))
            for source in self._open.values()
        ]

    def tell_watchers(self, now: float) -> list[tuple[str, SourceValues]]:
        """What each watcher is told of its source, as often as `WATCH_SECONDS` says."""
        if not self._watchers or now - self._watched < WATCH_SECONDS:
            return []
        self._watched = now
        values = {
            source.name: source_values(source)
            for source in self._open.values()
            if source.name in self._watchers.values()
        }
        return [(who, message) for who, name in self._watchers.items() if (message := values.get(name)) is not None]

    def news(self, consoles: Mapping[str, str], now: float) -> Sources | None:
        """What consoles are told: with each change, and once a second while there are any; None for nothing new.
        consoles: their names by client; now: seconds."""
        if not self._changed and (not self._open or now - self._told < TOLD_SECONDS):
            return None
        states = self.states(consoles)
        self._told = now
        self._changed = False
        self._open = {
            index: replace(
                source, frames=0, known=min(source.known, now),
                seen=now if source.found and source.frames else min(source.seen, now),
            )
            for index, source in self._open.items()
        }  # fmt: skip
        return Sources(states)

    def watch(self, who: str, name: str) -> None:
        """Tells a client (who) from now on what a source of this name sends; "" ends it. ValueError where there is
        none."""
        if name:
            self._watchers[who] = self._open[self._index_of(name)].name
        else:
            self._watchers.pop(who, None)

    def _next(self) -> int:
        self._count += 1
        return self._count

    def _of(self, who: str, index: int) -> OpenSource:
        source = self._open.get(index)
        if source is None or source.who != who:
            raise Refusal(f"this link has no source {index}; send source first, source_is has its index.")
        return source

    def _index_of(self, name: str) -> int:
        check_known(name, [source.name for source in self._open.values()], "source")
        return next(index for index, source in self._open.items() if source.name == name)

    def _driven(self, scene: Scene, name: str) -> list[str]:
        route = self.route(name)
        return [character for character in scene if ALL in route.characters or character in route.characters]

    def _play(
        self,
        scene: Scene,
        source: OpenSource,
        sent: Values,
        head: Head | None,
        gaze: Gaze | None,
        body: BodyFrame | None,
    ) -> None:
        route = self.route(source.name)
        low, high = RANGES.get(RULES[route.layer], (CHANNEL_LOWEST, CHANNEL_HIGHEST))
        values = source.measure.weights(sent, low, high)
        head, gaze = source.measure.turn(head, gaze)
        turned = RULES[route.layer] != "fill"  # what fills closes what is open, and turns nothing
        smoothing = source.measure.calibration.smoothing or source.smoothing
        frame = SourceFrame(
            source.names, values, head if turned else None, gaze if turned else None, source=source.name,
            found=source.found, parts=route.parts, smoothing=smoothing, direct=source.direct, share=source.share,
            route_number=route.number, body=source.measure.mirror_body(body) if route.body and turned else None,
        )  # fmt: skip
        for name in self._driven(scene, source.name):
            scene[name].drive_layer(route.layer, frame)

    def _let_go(self, scene: Scene, name: str) -> None:
        for character in self._driven(scene, name):
            scene[character].leave_layer(self.route(name).layer, name)

    def set_route(self, scene: Scene, name: str, route: Route) -> None:
        """Routes a source of a name. Characters that the source no longer drives, or drives on another layer, are let
        go; of sources that play the same, it is the one that was told to. scene: what is played; route: its new one."""
        before = self.route(name)
        gone = set(self._driven(scene, name))
        route = replace(route, number=1 + max((other.number for other in self._routes.values()), default=0))
        self._routes = with_newest(self._routes, name, route, MOST_REMEMBERED)
        self._changed = True
        stay = set(self._driven(scene, name)) if route.layer == before.layer else set[str]()
        for character in sorted(gone - stay):
            scene[character].leave_layer(before.layer, name)

    def _step(self, scene: Scene, index: int, asked: CalibrateSource) -> None:
        source = self._open[index]
        channels = check_channels(self._open[index], asked.channels)
        if asked.step == "range" and source.sent is not None:
            self._open[index], self._changed = begin_range(source, channels), True
            return
        before = self._calibrations.get(source.performer, AS_IT_IS)
        measured = measured_by(source, before, asked.step)
        if asked.step != "neutral":
            self._open[index] = replace(source, ranging=None)
        self._calibrate(scene, source.performer, measured)

    def _calibrate(self, scene: Scene, performer: str, calibration: Calibration) -> None:
        """Another measure of a performer: what it drives lets go before it follows again, but not where it is smoothed
        otherwise alone, which changes no value."""
        before = self._calibrations.get(performer, AS_IT_IS)
        same = replace(before, smoothing=calibration.smoothing) == calibration
        self._calibrations = with_newest(self._calibrations, performer, calibration, MOST_REMEMBERED)
        self._changed = True
        for index, source in self._open.items():
            if source.performer == performer:
                self._open[index] = replace(source, measure=measure_of(calibration, source.names))
                for name in () if same else self._driven(scene, source.name):
                    scene[name].recalibrate_layer(self.route(source.name).layer, source.name)


def _listed(values: Values | None) -> list[float] | None:
    return None if values is None else values.tolist()


def _array(values: list[float] | None) -> Values | None:
    return None if values is None else np.array(values, np.float64)
