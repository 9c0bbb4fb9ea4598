"""Pads that play a performer: from what shows, at its speed, and back, whoever interrupts them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import msgspec
import numpy as np
import pytest

from omote.model.cast import Cast
from omote.perform.frame import Frame
from omote.perform.pads.blend_space import Pad, PadLook
from omote.perform.pads.pad_point import FACE_SECONDS, TAKE_UP_SECONDS
from omote.perform.panic import PANIC_SECONDS
from omote.perform.performer import Performer
from omote.perform.snapshot import Snapshot, check_snapshot

STEP = 1.0 / 240.0
MOMENT = 1e-5
"""Seconds in which nothing that is smooth changes its speed by much."""
MOOD = Pad(
    "mood",
    "expression",
    2,
    (
        PadLook("Neutral", {"neutral": 1.0}, (0.0, 0.0)),
        PadLook("Smile", {"smile": 1.0}, (1.0, 0.0)),
        PadLook("Jaw", {"jawOpen": 1.0}, (0.0, 1.0)),
    ),
)
MOUTH = Pad(
    "mouth",
    "mouth",
    1,
    (PadLook("Smile", {"smile": 1.0}, (-1.0,)), PadLook("Jaw", {"jawOpen": 0.5, "neutral": 0.5}, (1.0,))),
)
FACES = Pad("faces", "face", 1, (PadLook("G", {"generic": 1.0}, (-1.0,)), PadLook("B", {"broad": 1.0}, (1.0,))))


def shown(frame: Frame, region: str = "mouth") -> Mapping[str, float]:
    return frame.regions.get(region, frame.expressions)  # type: ignore[call-overload, no-any-return]


def test_the_mixture_of_a_place_shows_and_stays_when_the_hand_is_gone(cast: Cast) -> None:
    performer = Performer(cast)
    performer.move_pad(MOOD, 0.5, 0.0)
    frame = performer.advance(1.0)
    assert frame.expressions == pytest.approx(MOOD.mix_at((0.5, 0.0)))
    assert performer.advance(60.0).expressions == frame.expressions
    assert (frame.pads["mood"].place, frame.pads["mood"].plays) == ((0.5, 0.0), True)
    assert frame.expression_call is None


def test_one_dimension_is_moved_alone(cast: Cast) -> None:
    performer = Performer(cast)
    performer.move_pad(MOOD, None, 0.5)
    performer.move_pad(MOOD, x=-0.25)
    assert performer.advance(0.0).pads["mood"].place == (-0.25, 0.5)


def test_a_pad_of_faces_plays_faces_and_one_of_a_region_that_alone(cast: Cast) -> None:
    performer = Performer(cast)
    performer.move_pad(FACES, 0.0)
    performer.move_pad(MOUTH, 1.0)
    frame = performer.advance(1.0)
    assert frame.faces == {"generic": 0.5, "broad": 0.5}
    assert (frame.expressions, frame.regions) == ({"neutral": 1.0}, {"mouth": {"jawOpen": 0.5, "neutral": 0.5}})


def test_faces_are_followed_more_slowly_than_expressions_after_a_restart_too(cast: Cast) -> None:
    first = Performer(cast)
    first.move_pad(FACES, -1.0)
    first.advance(1.0)
    first.move_pad(FACES, 1.0)
    for performer in (Performer.restored(cast, first.snapshot()), first):
        for _ in range(12):
            frame = performer.advance(FACE_SECONDS / 12)
        assert frame.faces["broad"] == pytest.approx(0.9, abs=0.03)


def test_a_pad_of_the_whole_face_that_is_taken_up_takes_the_regions_along_and_leaves_them_while_it_is_moved_on(
    cast: Cast,
) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=0.0, region="mouth")
    performer.move_pad(MOOD, 0.0, 1.0)
    frame = performer.advance(1.0)
    assert (frame.expressions, frame.regions) == ({"jawOpen": 1.0}, {})
    performer.move_pad(MOUTH, -1.0)
    performer.advance(1.0)
    performer.move_pad(MOOD, 0.0, 0.0)
    frame = performer.advance(1.0)
    assert (frame.expressions, frame.regions) == ({"neutral": 1.0}, {"mouth": {"smile": 1.0}})
    assert all(status.plays for status in frame.pads.values())
    performer.call_expression("smile", seconds=0.0)
    performer.move_pad(MOOD, 0.0, 1.0)
    assert performer.advance(1.0).regions == {}


def test_who_moves_last_has_the_part(cast: Cast) -> None:
    other = Pad("other", "mouth", 1, MOUTH.looks)
    performer = Performer(cast)
    performer.move_pad(MOUTH, -1.0)
    performer.advance(1.0)
    performer.move_pad(other, 1.0)
    frame = performer.advance(1.0)
    assert (shown(frame), frame.pads["mouth"].plays, frame.pads["other"].plays) == (
        {"jawOpen": 0.5, "neutral": 0.5},
        False,
        True,
    )
    performer.call_expression("smile", seconds=0.0, region="mouth")
    assert not any(status.plays for status in performer.advance(0.0).pads.values())


def weights_of(frames: list[Frame]) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """The weights of the mouth and of faces, a row for each frame."""
    names = sorted({name for frame in frames for name in (*shown(frame), *frame.faces)})
    return np.array([[frame.faces.get(n, 0.0) + shown(frame).get(n, 0.0) for n in names] for frame in frames])


def jolt(frames: list[Frame], step: float) -> float:
    """The largest change of velocity from one step (seconds) to the next, half the sum of all weights, per second."""
    return float(0.5 * np.abs(np.diff(weights_of(frames), 2, axis=0)).sum(1).max() / step)


INTERRUPTIONS: dict[str, Callable[[Performer], None]] = {
    "a call": lambda one: one.call_expression("smile", seconds=1.0),
    "a call of the region": lambda one: one.call_expression("smile", seconds=1.0, region="mouth"),
    "a call of a face": lambda one: one.call_face("broad", seconds=1.0),
    "another pad": lambda one: one.move_pad(MOUTH, 1.0),
    "a pad that is gone": lambda one: one.wear_pads({}),
    "a look that is dragged": lambda one: one.wear_pads({"mood": dragged(), "faces": FACES}),
    "panic": lambda one: one.panic(),
}


def dragged() -> Pad:
    """The pad of moods with a look a little farther on."""
    neutral, smile, jaw = MOOD.looks
    return Pad("mood", "expression", 2, (neutral, smile, PadLook("Jaw", jaw.mix, (0.005, 0.995))))


@pytest.mark.parametrize("what", INTERRUPTIONS)
def test_nothing_jumps_in_value_or_speed_where_a_moving_pad_is_interrupted(cast: Cast, what: str) -> None:
    performer = Performer(cast)
    performer.wear_pads({"mood": MOOD, "faces": FACES})
    for step in range(120):
        performer.move_pad(MOOD, 0.4, step / 120.0)
        performer.move_pad(FACES, step / 120.0 - 0.5)
        performer.advance(STEP)
    frames = [performer.advance(MOMENT) for _ in range(5)]
    INTERRUPTIONS[what](performer)
    frames += [performer.advance(MOMENT) for _ in range(5)]
    speed = np.abs(np.diff(weights_of(frames), axis=0)).sum(1).max() / 2.0 / MOMENT
    assert speed > 1.0
    assert jolt(frames, MOMENT) < 0.02 * speed  # which a freeze would lose


def test_a_point_that_is_taken_up_moves_nothing_at_once(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=1.0)
    frames = [performer.advance(STEP) for _ in range(120)]
    performer.move_pad(MOOD, 0.0, 1.0)
    frames += [performer.advance(STEP) for _ in range(120)]
    assert frames[-1].expressions == {"jawOpen": 1.0}
    assert jolt(frames, STEP) <= 8.0 * STEP / TAKE_UP_SECONDS**2


def test_panic_lets_go_and_forgets_where_points_are(cast: Cast) -> None:
    performer = Performer(cast)
    performer.move_pad(MOOD, 1.0, 0.0)
    performer.move_pad(MOUTH, 1.0)
    performer.move_pad(FACES, 0.0)
    performer.advance(1.0)
    performer.panic()
    frame = performer.advance(PANIC_SECONDS)
    assert (frame.expressions, frame.regions, frame.pads) == ({"neutral": 1.0}, {}, {})
    assert frame.faces == {"generic": 0.5, "broad": 0.5}
    performer.advance(1.0)
    performer.panic()
    assert performer.advance(3.0).faces == {"generic": 1.0}


@pytest.mark.parametrize("steps", [0, 5, 30, 240])
def test_a_snapshot_goes_on_to_the_bit_wherever_it_is_taken(cast: Cast, steps: int) -> None:
    performer = Performer(cast)
    performer.call_face("broad", seconds=2.0)
    performer.move_pad(MOOD, 0.3, 0.4)
    performer.move_pad(MOUTH, 0.3)
    for _ in range(steps):
        performer.advance(STEP)
    performer.move_pad(MOOD, 0.7, -0.2)
    written = msgspec.json.encode(performer.snapshot())
    other = Performer.restored(cast, msgspec.json.decode(written, type=Snapshot))
    for _ in range(60):
        assert performer.advance(STEP) == other.advance(STEP)
        performer.move_pad(MOOD, 0.1)
        other.move_pad(MOOD, 0.1)
    assert performer.snapshot() == other.snapshot()


def test_looks_that_a_cast_lacks_count_as_neutral_and_come_with_it(cast: Cast) -> None:
    pad = Pad("p", "expression", 1, (PadLook("B", {"beam": 1.0}, (-1.0,)), PadLook("S", {"smile": 1.0}, (1.0,))))
    performer = Performer(cast)
    performer.wear_pads({"p": pad})
    performer.move_pad(pad, -1.0)
    assert performer.advance(1.0).expressions == {"neutral": 1.0}
    performer.recast(cast.with_expressions(beam=cast.expressions["smile"]))
    performer.wear_pads({"p": pad})
    assert performer.advance(1.0).expressions == {"beam": 1.0}
    with pytest.raises(ValueError, match="beam"):
        performer.recast(cast)  # it is on air


def test_what_no_performer_can_have_written_is_refused(cast: Cast) -> None:
    performer = Performer(cast)
    performer.move_pad(MOUTH, 0.5)
    performer.advance(0.1)
    plain = msgspec.to_builtins(performer.snapshot())
    check_snapshot(msgspec.convert(plain, Snapshot), cast)
    wrong: dict[str, Callable[[dict[str, object]], object]] = {
        "the place on the pad mouth is 2": lambda point: point.update(place=[2.0]),
        "the name of a pad is ''": lambda point: point.update(pad=""),
        "the number of dimensions of the pad mouth is 0": lambda point: point.update(place=[]),
        "sum to 0": lambda point: point.update(first={"smile": 0.0}),
        "gone": lambda point: point.update(goal={"gone": 1.0}),
    }
    for message, damage in wrong.items():
        damaged = msgspec.to_builtins(performer.snapshot())
        damage(damaged["regions"]["mouth"]["point"])
        with pytest.raises(ValueError, match=message):
            check_snapshot(msgspec.convert(damaged, Snapshot), cast)
    damaged = {**plain, "pads": {"mouth": [2.0]}}
    with pytest.raises(ValueError, match="the place on the pad mouth is 2"):
        check_snapshot(msgspec.convert(damaged, Snapshot), cast)


def test_what_is_no_pad_is_refused(cast: Cast) -> None:
    with pytest.raises(TypeError, match="the pad is a str; give an"):
        Performer(cast).move_pad("mouth", 0.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="has 1 dimensions and no y"):
        Performer(cast).move_pad(MOUTH, 0.5, 0.5)


POSES = Pad(
    "moves",
    "pose",
    1,
    (PadLook("Stand", {"stand": 1.0}, (-1.0,)), PadLook("Bow", {"bow": 1.0}, (1.0,))),
)


def test_a_pad_of_poses_plays_the_figure_and_takes_its_regions_along_until_it_is_called_away(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_pose("wave", seconds=0.0, region="arm_left")
    performer.move_pad(POSES, 0.0)
    figure = performer.advance(1.0).figure
    assert figure is not None
    assert (figure.poses, dict(figure.regions)) == ({"stand": 0.5, "bow": 0.5}, {})
    again = Performer.restored(cast, performer.snapshot())
    again.wear_pads({"moves": POSES})
    for each in (performer, again):
        each.move_pad(POSES, 1.0)
    assert performer.advance(0.1) == again.advance(0.1)
    assert performer.advance(1.0).figure == again.advance(1.0).figure

    performer.call_pose("wave", seconds=0.0, region="arm_right")  # a call takes one region away
    performer.move_pad(POSES, 0.0)
    frame = performer.advance(1.0)
    assert frame.figure is not None
    assert frame.pads["moves"].plays
    assert (frame.figure.poses["bow"], dict(frame.figure.regions)) == (0.5, {"arm_right": {"wave": 1.0}})
    performer.wear_pads({"other": replace(POSES, name="other")}, {"moves": "other"})
    assert performer.advance(0.0).pads["other"].plays
    performer.panic()
    stopped = performer.advance(PANIC_SECONDS)
    assert stopped.pads == {}
    assert stopped.figure == performer.advance(1.0).figure


def test_a_pose_that_a_cast_lacks_counts_as_the_stand(cast: Cast) -> None:
    performer = Performer(cast)
    performer.move_pad(replace(POSES, looks=(*POSES.looks[:1], PadLook("Gone", {"gone": 1.0}, (1.0,)))), 1.0)
    assert performer.advance(1.0).figure is not None
    assert performer.advance(0.0).figure.poses == {"stand": 1.0}  # type: ignore[union-attr]
