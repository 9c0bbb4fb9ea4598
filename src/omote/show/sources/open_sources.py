"""The sources that are open: their frames, whom they drive, and the measures of their performers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from omote.perform.frame import Gaze, Head
from omote.perform.layers.layer_names import LAYER_PARTS, RANGES, RULES, LayerName, check_driven
from omote.perform.layers.source_frame import AUTOMATIC, SourceFrame, check_names, check_share, check_smoothing
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, check_known, check_within
from omote.perform.scene.character_names import ALL
from omote.perform.scene.scene import Scene
from omote.perform.snapshot import Playable
from omote.show import messages as wire
from omote.show.sources.calibration import AS_IT_IS, Calibration, Measure, Values, measure_of
from omote.show.sources.sources_snapshot import MOST_REMEMBERED, Route, SourcesSnapshot
from omote.show.validation import Refusal

SOURCE_CHANGES = wire.RouteSource, wire.CalibrateSource, wire.TuneSource
"""What an operator changes of a source."""
MOST_SOURCES = 32
TOLD_SECONDS = 1.0
LAYER_OF: Mapping[wire.StreamKind, LayerName] = {
    "tracker": "tracker", "lips": "lips", "playback": "playback", "program": "playback", "breath": "breath",
    "gaze": "gaze", "blink": "blink",
}  # fmt: skip
"""The layer that a source of a kind drives until it is routed elsewhere."""
Kept = TypeVar("Kept")


@dataclass(frozen=True, eq=False)
class OpenSource:
    """A source that is open. who: the client whose link it comes by; sent: its newest values as it sent them; ranging:
    the largest of each since it has been listened to; frames: since the consoles were last told; smoothing:
    what it asks for itself, seconds; direct: it is smooth already; share: how much of its layer it takes."""

    name: str
    kind: wire.StreamKind
    who: str
    names: tuple[str, ...]
    performer: str
    measure: Measure
    sent: Values | None = None
    ranging: Values | None = None
    frames: int = 0
    found: bool = False
    smoothing: float = 0.0
    direct: bool = False
    share: float = 1.0


class OpenSources:
    """All sources of a session, by index."""

    def __init__(self, snapshot: SourcesSnapshot | None = None) -> None:
        kept = SourcesSnapshot() if snapshot is None else snapshot
        self._open: dict[int, OpenSource] = {}
        self._routes, self._calibrations = dict(kept.routes), dict(kept.calibrations)
        self._count = 0
        self._told, self._changed = 0.0, False

    def snapshot(self) -> SourcesSnapshot:
        """What stays with the show."""
        return SourcesSnapshot(dict(self._routes), dict(self._calibrations))

    def hear(
        self, who: str, message: wire.Source | wire.Drive | wire.LeaveSource, scene: Scene, cast: Playable
    ) -> wire.SourceIs | None:
        """What a source says of itself; the answer where there is one. Errors as of the methods below."""
        if isinstance(message, wire.Source):
            return self.begin(who, message, scene, cast)
        if isinstance(message, wire.Drive):
            self.drive(who, message, scene)
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
        if len(frame.values) != 4 * len(source.names):
            raise Refusal(
                f"{source.name} sent {len(frame.values)} bytes for {len(source.names)} channels; send 4 for each."
            )
        sent = np.frombuffer(frame.values, "<f4").astype(np.float64) if frame.found else source.sent
        if frame.found and sent is not None:
            _check(sent, source)
        head = None if frame.head is None else Head(*frame.head)
        gaze = None if frame.gaze is None else Gaze(*frame.gaze)
        ranging = source.ranging if source.ranging is None or sent is None else np.maximum(source.ranging, sent)
        self._changed = self._changed or frame.found != source.found
        self._open[frame.index] = OpenSource(
            source.name, source.kind, source.who, source.names, source.performer, source.measure, sent, ranging,
            source.frames + 1, frame.found, source.smoothing, source.direct, _share(frame, source),
        )  # fmt: skip
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
        for index in [index for index, each in self._open.items() if each.who == who]:
            self.end(who, index, scene)

    def route(self, name: str) -> Route:
        """Whom a source drives."""
        return self._routes.get(name, Route())

    def change(self, asked: wire.RouteSource | wire.CalibrateSource | wire.TuneSource, scene: Scene) -> None:
        """Routes or measures a source; ValueError where it cannot be."""
        if isinstance(asked, wire.RouteSource):
            self._route(asked, scene)
            return
        index = self._index_of(asked.source)
        source = self._open[index]
        if isinstance(asked, wire.TuneSource):
            before = self._calibrations.get(source.performer, AS_IT_IS)
            tuned = {each: getattr(asked, each) for each in ("mirror", "dead_zone", "curve", "gain", "smoothing")}
            self._calibrate(scene, source.performer, replace(before, **tuned))
            return
        self._step(scene, index, asked.step)

    def states(self, consoles: Mapping[str, str]) -> list[wire.SourceState]:
        """All open sources; consoles: the names of links."""
        return [self._state(each, consoles) for each in self._open.values()]

    def news(self, consoles: Mapping[str, str], now: float) -> wire.Sources | None:
        """What consoles are told: with each change, and once a second while there are any; None for nothing new."""
        if not self._changed and (not self._open or now - self._told < TOLD_SECONDS):
            return None
        states = self.states(consoles)
        self._told, self._changed = now, False
        self._open = {index: replace(each, frames=0) for index, each in self._open.items()}
        return wire.Sources(states)

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
        smoothing = max(source.smoothing, source.measure.calibration.smoothing)
        frame = SourceFrame(
            source.names, values, head if turned else None, gaze if turned else None, source=source.name,
            parts=route.parts, smoothing=smoothing, direct=source.direct, share=source.share,
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
        """Characters that the source no longer drives, or drives on another layer, are let go."""
        before = self.route(name)
        gone = set(self._driven(scene, name))
        self._routes, self._changed = _with(self._routes, name, route), True
        stay = set(self._driven(scene, name)) if route.layer == before.layer else set[str]()
        for each in sorted(gone - stay):
            scene[each].leave_layer(before.layer, name)

    def _step(self, scene: Scene, index: int, step: wire.CalibrationStep) -> None:
        source = self._open[index]
        before = self._calibrations.get(source.performer, AS_IT_IS)
        if step == "reset":
            self._open[index] = replace(source, ranging=None)
            self._calibrate(scene, source.performer, replace(before, neutral={}, highest={}))
        elif source.sent is None:
            raise ValueError(f"{source.name} has not sent a frame yet; show it a face first")
        elif step == "neutral":
            self._calibrate(scene, source.performer, replace(before, neutral=_by_name(source, source.sent)))
        elif step == "range":
            self._open[index], self._changed = replace(source, ranging=source.sent), True
        elif source.ranging is None:
            raise ValueError(f"{source.name} is not listened to; send the step range first")
        else:
            self._open[index] = replace(source, ranging=None)
            self._calibrate(scene, source.performer, replace(before, highest=_by_name(source, source.ranging)))

    def _calibrate(self, scene: Scene, performer: str, calibration: Calibration) -> None:
        """Another measure of a performer: what it drives lets go before it follows again."""
        self._calibrations, self._changed = _with(self._calibrations, performer, calibration), True
        for index, each in self._open.items():
            if each.performer == performer:
                self._open[index] = replace(each, measure=measure_of(calibration, each.names))
                for name in self._driven(scene, each.name):
                    scene[name].recalibrate_layer(self.route(each.name).layer, each.name)

    def _state(self, source: OpenSource, consoles: Mapping[str, str]) -> wire.SourceState:
        route, measure = self.route(source.name), source.measure.calibration
        return wire.SourceState(
            name=source.name,
            kind=source.kind,
            console=consoles.get(source.who, ""),
            characters=list(route.characters),
            layer=route.layer,
            regions=list(route.parts),
            performer=source.performer,
            rate=source.frames,
            found=source.found,
            calibrated=bool(measure.neutral or measure.highest),
            ranging=source.ranging is not None,
            mirror=measure.mirror,
            dead_zone=measure.dead_zone,
            curve=measure.curve,
            gain=measure.gain,
            smoothing=measure.smoothing,
        )


def _by_name(source: OpenSource, values: Values) -> dict[str, float]:
    return dict(zip(source.names, values.tolist(), strict=True))


def _check(sent: Values, source: OpenSource) -> None:
    """Rejects values out of range, by the channel's name."""
    wrong = ~((sent >= CHANNEL_LOWEST) & (sent <= CHANNEL_HIGHEST))
    if wrong.any():
        place = int(np.argmax(wrong))
        check_within(float(sent[place]), CHANNEL_LOWEST, CHANNEL_HIGHEST, f"{source.names[place]} of {source.name}")


def _share(frame: wire.Drive, source: OpenSource) -> float:
    """How much of its layer a source takes; Refusal where it is not direct and takes less than all: it would jump."""
    if frame.share != 1.0 and not source.direct:
        raise Refusal(
            f"{source.name} takes {frame.share} of its layer; only a source that is direct takes less than 1."
        )
    return check_share(frame.share)


def _with(kept: Mapping[str, Kept], name: str, value: Kept) -> dict[str, Kept]:
    """The same with one more, the newest last; the oldest goes where there are too many."""
    others = [(each, old) for each, old in kept.items() if each != name]
    return dict([*others, (name, value)][-MOST_REMEMBERED:])
