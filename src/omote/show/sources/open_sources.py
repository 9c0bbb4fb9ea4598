"""The sources that are open: their frames, whom they drive, and the measures of their performers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TypeVar

from omote.perform.frame import Gaze, Head
from omote.perform.layers.layer_names import LAYER_PARTS, RANGES, RULES, LayerName, check_driven
from omote.perform.layers.source_frame import AUTOMATIC, SourceFrame, check_names, check_smoothing
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, check_known
from omote.perform.scene.character_names import ALL
from omote.perform.scene.scene import Scene
from omote.perform.snapshot import Playable
from omote.show import messages as wire
from omote.show.sources.calibration import AS_IT_IS, Calibration, Values, measure_of
from omote.show.sources.open_source import (
    LAYER_OF,
    TUNED,
    OpenSource,
    begin_range,
    check_channels,
    hear_values,
    measured_by,
    read_share,
    read_values,
    source_state,
    source_values,
)
from omote.show.sources.sources_snapshot import MOST_REMEMBERED, Route, SourcesSnapshot
from omote.show.validation import Refusal

SOURCE_CHANGES = wire.RouteSource, wire.CalibrateSource, wire.MeasureSource, wire.TuneSource
"""What an operator changes of a source."""
MOST_SOURCES = 32
TOLD_SECONDS = 1.0
QUIET_SECONDS = 10.0
"""After which a source that sees nobody keeps its characters from no other."""
WATCH_SECONDS = 0.05
"""Between two reports of what a source sends, to who watches it."""
Kept = TypeVar("Kept")


class OpenSources:
    """All sources of a session, by index."""

    def __init__(self, snapshot: SourcesSnapshot | None = None) -> None:
        kept = SourcesSnapshot() if snapshot is None else snapshot
        self._open: dict[int, OpenSource] = {}
        self._routes, self._calibrations = dict(kept.routes), dict(kept.calibrations)
        self._count = 0
        self._told, self._changed = 0.0, False
        self._watchers, self._watched = dict[str, str](), 0.0

    def snapshot(self) -> SourcesSnapshot:
        """What stays with the show."""
        return SourcesSnapshot(dict(self._routes), dict(self._calibrations))

    def hear(
        self,
        who: str,
        message: wire.SourceMessage,
        scene: Scene,
        cast: Playable,
    ) -> wire.SourceIs | None:
        """What a source says of itself; the answer where there is one. Errors as of the methods below."""
        if isinstance(message, wire.Source):
            return self.begin(who, message, scene, cast)
        if isinstance(message, wire.Drive):
            self.drive(who, message, scene)
        elif isinstance(message, wire.WatchSource):
            self._watch(who, message.source)
        else:
            self.end(who, message.index, scene)
        return None

    def begin(self, who: str, asked: wire.Source, scene: Scene, cast: Playable) -> wire.SourceIs:
        """A source opens; one of the same link and name takes its place. Refusal where it cannot be."""
        names = check_names(asked.names, cast.expressions)
        if asked.name == AUTOMATIC:
            raise Refusal(f"{AUTOMATIC} is what a character does by itself; choose another name.")
        if ALL not in asked.characters:
            for character in asked.characters:
                check_known(character, scene, "character")
        same = [index for index, each in self._open.items() if each.name == asked.name]
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
            self._set_route(scene, asked.name, Route(tuple(asked.characters), layer))
        return wire.SourceIs(index, asked.name)

    def drive(self, who: str, frame: wire.Drive, scene: Scene) -> None:
        """A frame of a source: every layer that it drives follows it. Refusal, ValueError or TypeError where it cannot
        be, and nothing has changed."""
        source = self._of(who, frame.index)
        sent = read_values(source, frame)
        head = None if frame.head is None else Head(*frame.head)
        gaze = None if frame.gaze is None else Gaze(*frame.gaze)
        self._changed = self._changed or frame.found != source.found
        share = read_share(source, frame)
        self._open[frame.index] = hear_values(source, sent, found=frame.found, share=share)
        if frame.found and sent is not None:
            self._play(scene, self._open[frame.index], sent, head, gaze)

    def end(self, who: str, index: int, scene: Scene) -> None:
        """A source ends: its layers let go. Refusal where this link has none of that index."""
        source = self._of(who, index)
        self._let_go(scene, source.name)
        self._changed = True
        del self._open[index]

    def leave(self, who: str, scene: Scene) -> None:
        """The end of a link is the end of its sources."""
        self._watchers.pop(who, None)
        for index in [index for index, each in self._open.items() if each.who == who]:
            self.end(who, index, scene)

    def route(self, name: str) -> Route:
        """Whom a source drives."""
        return self._routes.get(name, Route())

    def find_alone(self, name: str, characters: Iterable[str], layer: LayerName, now: float) -> list[str]:
        """Whom a source drives that comes for the first time: the character of a show that has one, where no other
        source plays it on this layer or did until a moment ago."""
        routes = ((each, self.route(each.name)) for each in self._open.values())
        driven = any(
            route.characters and route.layer == layer and now - each.seen < QUIET_SECONDS for each, route in routes
        )
        found = list(characters)
        return found if len(found) == 1 and name not in self._routes and not driven else []

    def change(
        self, asked: wire.RouteSource | wire.CalibrateSource | wire.MeasureSource | wire.TuneSource, scene: Scene
    ) -> None:
        """Routes or measures a source; ValueError where it cannot be."""
        if isinstance(asked, wire.RouteSource):
            self._route(asked, scene)
            return
        index = self._index_of(asked.source)
        performer = self._open[index].performer
        before = self._calibrations.get(performer, AS_IT_IS)
        if isinstance(asked, wire.TuneSource):
            tuned = {each: getattr(asked, each) for each in TUNED}
            self._calibrate(scene, performer, replace(before, **tuned))
        elif isinstance(asked, wire.MeasureSource):
            measured = replace(before, neutral=dict(asked.neutral), highest=dict(asked.highest))
            self._calibrate(scene, performer, measured)
        else:
            self._step(scene, index, asked)

    def states(self, consoles: Mapping[str, str]) -> list[wire.SourceState]:
        """All open sources; consoles: the names of links."""
        return [source_state(each, self.route(each.name), consoles.get(each.who, "")) for each in self._open.values()]

    def tell_watchers(self, now: float) -> list[tuple[str, wire.SourceValues]]:
        """What each watcher is told of its source, as often as `WATCH_SECONDS` says."""
        if not self._watchers or now - self._watched < WATCH_SECONDS:
            return []
        self._watched = now
        values = {
            each.name: source_values(each) for each in self._open.values() if each.name in self._watchers.values()
        }
        return [(who, told) for who, name in self._watchers.items() if (told := values.get(name)) is not None]

    def news(self, consoles: Mapping[str, str], now: float) -> wire.Sources | None:
        """What consoles are told: with each change, and once a second while there are any; None for nothing new."""
        if not self._changed and (not self._open or now - self._told < TOLD_SECONDS):
            return None
        states = self.states(consoles)
        self._told, self._changed = now, False
        self._open = {
            index: replace(each, frames=0, seen=now if each.found and each.frames else min(each.seen, now))
            for index, each in self._open.items()
        }
        return wire.Sources(states)

    def _watch(self, who: str, name: str) -> None:
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
        check_known(name, [each.name for each in self._open.values()], "source")
        return next(index for index, each in self._open.items() if each.name == name)

    def _driven(self, scene: Scene, name: str) -> list[str]:
        route = self.route(name)
        return [each for each in scene if ALL in route.characters or each in route.characters]

    def _play(self, scene: Scene, source: OpenSource, sent: Values, head: Head | None, gaze: Gaze | None) -> None:
        route = self.route(source.name)
        low, high = RANGES.get(RULES[route.layer], (CHANNEL_LOWEST, CHANNEL_HIGHEST))
        values = source.measure.weights(sent, low, high)
        head, gaze = source.measure.turn(head, gaze)
        turned = RULES[route.layer] != "fill"  # what fills closes what is open, and turns nothing
        smoothing = source.measure.calibration.smoothing or source.smoothing
        frame = SourceFrame(
            source.names, values, head if turned else None, gaze if turned else None, source=source.name,
            parts=route.parts, smoothing=smoothing, direct=source.direct, share=source.share,
            route_number=route.number,
        )  # fmt: skip
        for name in self._driven(scene, source.name):
            scene[name].drive_layer(route.layer, frame)

    def _let_go(self, scene: Scene, name: str) -> None:
        for each in self._driven(scene, name):
            scene[each].leave_layer(self.route(name).layer, name)

    def _route(self, asked: wire.RouteSource, scene: Scene) -> None:
        layer = check_driven(asked.layer)
        for character in asked.characters:
            if character != ALL:
                check_known(character, scene, "character")
        parts = tuple(part for part in LAYER_PARTS if part in asked.regions) if asked.regions else LAYER_PARTS
        self._set_route(scene, asked.source, Route(tuple(asked.characters), layer, parts))

    def _set_route(self, scene: Scene, name: str, route: Route) -> None:
        """Characters that the source no longer drives, or drives on another layer, are let go; of sources that play the
        same, it is the one that was told to."""
        before, gone = self.route(name), set(self._driven(scene, name))
        route = replace(route, number=1 + max((each.number for each in self._routes.values()), default=0))
        self._routes, self._changed = _with(self._routes, name, route), True
        stay = set(self._driven(scene, name)) if route.layer == before.layer else set[str]()
        for each in sorted(gone - stay):
            scene[each].leave_layer(before.layer, name)

    def _step(self, scene: Scene, index: int, asked: wire.CalibrateSource) -> None:
        source, channels = self._open[index], check_channels(self._open[index], asked.channels)
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
        self._calibrations, self._changed = _with(self._calibrations, performer, calibration), True
        for index, each in self._open.items():
            if each.performer == performer:
                self._open[index] = replace(each, measure=measure_of(calibration, each.names))
                for name in () if same else self._driven(scene, each.name):
                    scene[name].recalibrate_layer(self.route(each.name).layer, each.name)


def _with(kept: Mapping[str, Kept], name: str, value: Kept) -> dict[str, Kept]:
    """The same with one more, the newest last; the oldest goes where there are too many."""
    others = [(each, old) for each, old in kept.items() if each != name]
    return dict([*others, (name, value)][-MOST_REMEMBERED:])
