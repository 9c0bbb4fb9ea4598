"""A source that is open: its newest values, what its performer has shown, and what an operator sets of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from omote.arrays import Values
from omote.model.body.pose_regions import POSE_REGIONS
from omote.perform.figures.packed_pose import BESIDE_BONES, unpack_pose
from omote.perform.frame import with_fields
from omote.perform.layers.layer_names import LayerName
from omote.perform.layers.source_frame import BodyFrame, check_share
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, check_known, check_within
from omote.show.objects.sources import CalibrationStep, Drive, SourceState, SourceValues, StreamKind
from omote.show.sources.calibration import Calibration, Measure
from omote.show.sources.sources_snapshot import Route
from omote.show.validation import Refusal

LAYER_OF: Mapping[StreamKind, LayerName] = {
    "tracker": "tracker", "lips": "lips", "playback": "playback", "program": "playback", "breath": "breath",
    "gaze": "gaze", "blink": "blink",
}  # fmt: skip
"""The layer that a source of a kind drives until it is routed elsewhere."""
TUNED = "mirror", "dead_zone", "curve", "gain", "smoothing", "lids"
"""What an operator sets of how a source is read."""
REST_SHARE = 0.1
"""How much a frame counts in the face at rest: that is the mean of about the last ten, so that nothing trembles in."""


@dataclass(frozen=True, eq=False)
class OpenSource:
    """A source that is open. who: the client whose link it comes by; sent: its newest values as it sent them; rest:
    their running mean; ranging: the largest of each since it has been listened to, of the channels ranged (none: all);
    frames: since the consoles were last told; smoothing: what it asks for itself, seconds; direct: it is smooth
    already; body: its newest frame has one;
    share: how much of its layer it takes; seen: when it was last known to see somebody; known: since
    when consoles know it."""

    name: str
    kind: StreamKind
    who: str
    names: tuple[str, ...]
    performer: str
    measure: Measure
    sent: Values | None = None
    rest: Values | None = None
    ranging: Values | None = None
    ranged: tuple[str, ...] = ()
    frames: int = 0
    found: bool = False
    smoothing: float = 0.0
    direct: bool = False
    share: float = 1.0
    seen: float = float("inf")
    known: float = float("inf")
    body: bool = False


def read_values(source: OpenSource, frame: Drive) -> Values | None:
    """The values of a frame, or the newest ones where it has found nobody; Refusal or ValueError for what is wrong.
    source: who sent it."""
    if len(frame.values) != 4 * len(source.names):
        raise Refusal(
            f"{source.name} sent {len(frame.values)} bytes for {len(source.names)} channels; send 4 for each."
        )
    if not frame.found:
        return source.sent
    sent: Values = np.frombuffer(frame.values, "<f4").astype(np.float64)
    wrong = ~((sent >= CHANNEL_LOWEST) & (sent <= CHANNEL_HIGHEST))
    if wrong.any():
        place = int(np.argmax(wrong))
        check_within(float(sent[place]), CHANNEL_LOWEST, CHANNEL_HIGHEST, f"{source.names[place]} of {source.name}")
    return sent


def read_share(source: OpenSource, frame: Drive) -> float:
    """How much of its layer a source takes; Refusal where it is not direct and takes less than all: it would jump.
    frame: what it sent."""
    if frame.share != 1.0 and not source.direct:
        raise Refusal(
            f"{source.name} takes {frame.share} of its layer; only a source that is direct takes less than 1."
        )
    return check_share(frame.share)


def read_body(frame: Drive) -> BodyFrame | None:
    """The body of a frame, None where it has none; ValueError where it is none. frame: what a source sent."""
    if not frame.body or not frame.seen:
        return None
    bones = (len(frame.body) // 2 - BESIDE_BONES) // 3
    return BodyFrame(unpack_pose(frame.body, bones), tuple(region for region in POSE_REGIONS if region in frame.seen))


def hear_values(
    source: OpenSource, sent: Values | None, *, found: bool, share: float, body: bool = False
) -> OpenSource:
    """The source after a frame. sent: one value for each channel, None before the first; found: whether it found a
    face; share: how much of its layer it takes, 0 to 1; body: whether it has sent a body."""
    ranging = source.ranging
    rest = source.rest
    if found and sent is not None:
        ranging = None if ranging is None else np.maximum(ranging, sent)
        rest = sent if rest is None else rest + REST_SHARE * (sent - rest)
    return with_fields(
        source, sent=sent, rest=rest, ranging=ranging, frames=source.frames + 1, found=found, share=share, body=body
    )


def check_channels(source: OpenSource, channels: list[str]) -> tuple[str, ...]:
    """The channels of a source by their names; ValueError for one that it does not send."""
    return tuple(check_known(name, source.names, f"channel of {source.name}") for name in channels)


def begin_range(source: OpenSource, channels: tuple[str, ...]) -> OpenSource:
    """The source as its performer's largest moves are listened to. channels: those that are measured, none for all."""
    return replace(source, ranging=source.sent, ranged=channels)


def measured_by(source: OpenSource, before: Calibration, step: CalibrationStep) -> Calibration:
    """The measure of a performer after a step; ValueError where there is nothing to measure. source: what was heard;
    before: the measure until now."""
    if step == "reset":
        return replace(before, neutral={}, highest={})
    if source.rest is None:
        raise ValueError(f"{source.name} has not sent a frame yet; show it a face first")
    if step == "neutral":
        return replace(before, neutral=_by_name(source, source.rest))
    if source.ranging is None:
        raise ValueError(f"{source.name} is not listened to; send the step range first")
    reached = _by_name(source, source.ranging)
    wanted = {name: reached[name] for name in source.ranged or source.names}
    return replace(before, highest={**before.highest, **wanted} if source.ranged else wanted)


def source_state(source: OpenSource, route: Route, console: str) -> SourceState:
    """What consoles are told of a source. route: what it drives; console: the name of the console that it belongs
    to."""
    measure = source.measure.calibration
    return SourceState(
        name=source.name,
        kind=source.kind,
        console=console,
        characters=list(route.characters),
        layer=route.layer,
        regions=route.regions,
        performer=source.performer,
        rate=source.frames,
        found=source.found,
        body=source.body,
        calibrated=bool(measure.neutral or measure.highest),
        ranging=source.ranging is not None,
        neutral=dict(measure.neutral),
        highest=dict(measure.highest),
        **{name: getattr(measure, name) for name in TUNED},
    )


def source_values(source: OpenSource) -> SourceValues | None:
    """What a source sends now, and what its measure makes of it; None before its first frame."""
    if source.sent is None:
        return None
    weights = source.measure.weights(source.sent, CHANNEL_LOWEST, CHANNEL_HIGHEST)
    sent, read = (values.astype("<f4").tobytes() for values in (source.sent, weights))
    return SourceValues(source.name, list(source.names), sent, read)


def _by_name(source: OpenSource, values: Values) -> dict[str, float]:
    return dict(zip(source.names, values.tolist(), strict=True))
