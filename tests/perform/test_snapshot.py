"""A snapshot comes back exactly, and one that no performer has written is refused."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import msgspec
import pytest

from omote.model.cast import Cast
from omote.perform.axis import Axis, Call
from omote.perform.easing import Glide
from omote.perform.frame import Gaze, Home
from omote.perform.lights import FIRST_LIGHT
from omote.perform.limits import GAZE_LIMITS
from omote.perform.panic import Carried, EasingToRest
from omote.perform.performer import Performer
from omote.perform.snapshot import Snapshot, check_snapshot, limit_gaze


def running(cast: Cast) -> Snapshot:
    """A snapshot with an interrupted call, a T-bar on it, and a channel."""
    performer = Performer(cast)
    performer.call_face("broad", seconds=0.8)
    performer.advance(0.4)
    performer.call_face("long", seconds=2.0)
    performer.fade_face(0.2)
    performer.set_channel("jawOpen", 0.5)
    performer.advance(0.02)
    return performer.snapshot()


def test_it_is_written_and_read_exactly(cast: Cast) -> None:
    snapshot = running(cast)
    for form in (msgspec.msgpack, msgspec.json):
        assert form.decode(form.encode(snapshot), type=Snapshot) == snapshot
    assert check_snapshot(snapshot, cast) is snapshot


def with_call(**changes: Any) -> Callable[[Snapshot], Snapshot]:
    def change(snapshot: Snapshot) -> Snapshot:
        assert snapshot.face.call is not None
        return replace(snapshot, face=replace(snapshot.face, call=replace(snapshot.face.call, **changes)))

    return change


def with_face(**changes: Any) -> Callable[[Snapshot], Snapshot]:
    return lambda snapshot: replace(snapshot, face=replace(snapshot.face, **changes))


BROKEN: dict[str, Callable[[Snapshot], Snapshot]] = {
    "there is no face 'gone'": with_face(on_air="gone"),
    r"the face T-bar is no number \(NaN\)": with_face(hand=math.nan),
    "there is no face 'nobody'": with_call(target="nobody"),
    "there is no face 'someone'": with_call(start={"someone": 1.0}),
    "the weight of the face broad is 1.5": with_call(start={"broad": 1.5, "long": -0.5}),
    "the weights of the faces in the snapshot sum to 0.5": with_call(start={"broad": 0.5}),
    "the velocities of the faces in the snapshot sum to 3.0": with_call(velocity={"broad": 3.0}),
    "velocities of the faces in the snapshot sum to nan": with_call(velocity={"broad": math.nan}),
    "no easing 'bounce'": with_call(easing="bounce"),
    r"the decay of a call \(seconds\) is 5.0": with_call(decay=5.0),
    r"the elapsed time of a call \(seconds\) is -1.0": with_call(elapsed=-1.0),
    r"the time of a call \(seconds\) is 0.0": with_call(seconds=0.0),
    "the origin of a T-bar's way is 3.0": with_call(way=Glide(3.0, 0.0, 1.0, 0.1)),
    "the goal of a T-bar's way is inf": with_call(way=Glide(0.0, 0.0, math.inf, 0.1)),
    r"the rate of a T-bar \(per second\) is no number": with_call(way=Glide(0.0, math.nan, 1.0, 0.1)),
    r"the time of a T-bar's way \(seconds\) is -1.0": with_call(way=Glide(0.0, 0.0, 1.0, -1.0)),
    "the channel jawOpen is 2.0": lambda snapshot: replace(snapshot, channels={"jawOpen": 2.0}),
    "there is no channel 'tail'": lambda snapshot: replace(snapshot, channels={"tail": 0.5}),
    "there is no light 'candle'": lambda snapshot: replace(snapshot, light=Axis("candle")),
    "there is no face 'nowhere'": lambda snapshot: replace(snapshot, home=Home("nowhere")),
    "there is no channel 'ear'": lambda snapshot: replace(snapshot, easing_to_rest=EasingToRest({"ear": 0.5})),
    r"the elapsed time of a panic \(seconds\) is 9.0": lambda snapshot: replace(
        snapshot, easing_to_rest=EasingToRest(elapsed=9.0)
    ),
    "the speed of jawOpen after a panic .* is no number": lambda snapshot: replace(
        snapshot,
        easing_to_rest=EasingToRest({"jawOpen": 0.5}, moving={"channels": {"jawOpen": Carried(math.nan, 0.1)}}),
    ),
    "the speed of yaw after a panic .* is 1000.0": lambda snapshot: replace(
        snapshot, easing_to_rest=EasingToRest(moving={"gaze": {"yaw": Carried(1000.0, 0.1)}})
    ),
    "the decay of the speed of yaw after a panic .* is 9.0": lambda snapshot: replace(
        snapshot, easing_to_rest=EasingToRest(moving={"head": {"yaw": Carried(1.0, 9.0)}})
    ),
    r"the time of the last panic \(seconds\) is 1000.0": lambda snapshot: replace(snapshot, panicked=1000.0),
    "the weights of the faces in the snapshot sum to 0.25": with_face(stands={"broad": 0.25}),
    "there is no face 'half'": with_call(goal={"half": 1.0}),
    r"the snapshot's time \(seconds\) is no number": lambda snapshot: replace(snapshot, time=math.nan),
}


@pytest.mark.parametrize("sentence", BROKEN)
def test_what_no_performer_has_written_is_refused(cast: Cast, sentence: str) -> None:
    broken = BROKEN[sentence](running(cast))
    with pytest.raises(ValueError, match=sentence):
        Performer.restored(cast, broken)


def test_a_show_of_before_there_were_lights_begins_with_the_first(cast: Cast) -> None:
    written = msgspec.to_builtins(running(cast))
    for added in ("light", "easing_to_rest", "home", "panicked", "panics"):
        del written[added]
    read = msgspec.convert(written, Snapshot)
    assert Performer.restored(cast, read).advance(0.0).light == {FIRST_LIGHT: 1.0}


def test_calls_are_values(cast: Cast) -> None:
    call = running(cast).face.call
    assert isinstance(call, Call)
    assert hash(call.way) == hash(replace(call).way)


@pytest.mark.parametrize("saved", [None, [], {}, {"gaze": 3}, {"gaze": {"yaw": "far", "pitch": math.nan}}])
def test_what_is_no_gaze_is_left_to_be_rejected(saved: Any) -> None:
    before = repr(saved)
    assert not limit_gaze(saved)
    assert repr(saved) == before


@pytest.mark.parametrize(("yaw", "pitch"), [(0.1, -0.2), (1.5, 0.0), (-0.1, -1.5), (9.0, 9.0)])
def test_a_gaze_beyond_its_range_is_brought_to_its_end(yaw: float, pitch: float) -> None:
    gaze = {"yaw": yaw, "pitch": pitch}
    assert limit_gaze({"gaze": gaze}) == (abs(yaw) > GAZE_LIMITS["yaw"] or abs(pitch) > GAZE_LIMITS["pitch"])
    assert Gaze(**gaze) == Gaze(
        *(max(-limit, min(limit, angle)) for angle, limit in zip((yaw, pitch), GAZE_LIMITS.values(), strict=True))
    )
