"""Several sources on one layer of one character: each plays the parts that it may, and none takes another's."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.space.expression import Title
from omote.perform.channels import GAZE_UNITS
from omote.perform.frame import Frame
from omote.perform.layers.layer_names import LAYER_PARTS, LayerPart
from omote.perform.layers.source_frame import SourceFrame, source_frame
from omote.perform.performer import Performer

DT = 1.0 / 60.0
FACE = {"browInnerUp": 0.8, "jawOpen": 0.6}
OTHER = {"browInnerUp": 0.2, "jawOpen": 0.9}


@pytest.fixture(scope="session")
def people(cast: Cast) -> Cast:
    """A cast whose channels belong to parts of the face."""
    titles = {"jawOpen": Title("jaw", region="jaw"), "browInnerUp": Title("brows", region="brows")}
    return replace(cast, titles={**cast.titles, **titles})


@dataclass(frozen=True)
class Sender:
    """A tracker: what it sends, and the parts that it is routed to."""

    name: str
    weights: dict[str, float]
    parts: tuple[LayerPart, ...] = LAYER_PARTS

    def frame(self, cast: Cast, **angles: Any) -> SourceFrame:
        made = source_frame(cast.expressions, self.weights, angles.get("head"), angles.get("gaze"))
        return replace(made, source=self.name, parts=self.parts)


def play(cast: Cast, performer: Performer, senders: Sequence[Sender], seconds: float) -> list[Frame]:
    frames = []
    for _ in range(round(seconds / DT)):
        for each in senders:
            performer.drive_layer("tracker", each.frame(cast))
        frames.append(performer.advance(DT))
    return frames


def shown(frames: Sequence[Frame], name: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([frame.channels.get(name, 0.0) for frame in frames])


def ends(frames: Sequence[Frame]) -> list[float]:
    return [frames[-1].channels.get(name, 0.0) for name in FACE]


def test_the_lips_of_one_and_the_brows_of_another_play_on_one_layer(people: Cast) -> None:
    performer = Performer(people)
    brows = Sender("a", FACE, ("brows",))
    lips = Sender("b", OTHER, ("mouth",))
    frames = play(people, performer, [brows, lips], 4.0)
    assert ends(frames) == pytest.approx([0.8, 0.9], abs=1e-3)
    status = frames[-1].layers["tracker"]
    assert {each.source: (each.parts, round(each.trust, 2)) for each in status.sources} == {
        "a": (("brows",), 1.0),
        "b": (("mouth",), 1.0),
    }


@pytest.mark.parametrize("first", [0, 1])
def test_who_is_routed_to_a_part_keeps_it_from_one_that_plays_all(people: Cast, first: int) -> None:
    performer = Performer(people)
    senders = [Sender("all", FACE), Sender("lips", OTHER, ("mouth",))]
    frames = play(people, performer, [senders[first]], 2.0) + play(people, performer, senders, 6.0)
    assert ends(frames) == pytest.approx([0.8, 0.9], abs=1e-3)
    assert max(np.abs(np.diff(shown(frames, name))).max() for name in FACE) < 0.05


def test_two_that_may_play_the_same_do_not_take_it_from_each_other(people: Cast) -> None:
    performer = Performer(people)
    one = Sender("one", FACE)
    other = Sender("other", OTHER)
    frames = play(people, performer, [one], 3.0)
    assert ends(frames) == pytest.approx([0.8, 0.6], abs=1e-3)
    both = play(people, performer, [one, other], 8.0)
    assert ends(both) == pytest.approx([0.2, 0.9], abs=1e-3), "the newest has it"
    lost = play(people, performer, [one], 8.0)
    assert ends(lost) == pytest.approx([0.8, 0.6], abs=1e-3), "it is lost"
    back = play(people, performer, [one, other], 8.0)
    assert ends(back) == pytest.approx([0.2, 0.9], abs=1e-3), "it is back"
    performer.leave_layer("tracker", "other")
    assert ends(play(people, performer, [one], 8.0)) == pytest.approx([0.8, 0.6], abs=1e-3), "it has gone"
    changes = [np.abs(np.diff(shown([*frames[-1:], *both, *lost, *back], name), 2)).max() for name in FACE]
    assert max(changes) < 0.9 / 30, "no part of it jumps"


def test_a_measure_of_one_leaves_the_part_of_the_other_alone(people: Cast) -> None:
    performer = Performer(people)
    brows = Sender("a", FACE, ("brows",))
    lips = Sender("b", OTHER, ("mouth",))
    play(people, performer, [brows, lips], 4.0)
    performer.recalibrate_layer("tracker", "a")
    frames = play(people, performer, [replace(brows, weights={**FACE, "browInnerUp": 0.4}), lips], 6.0)
    assert shown(frames, "browInnerUp").min() < 0.01
    assert ends(frames) == pytest.approx([0.4, 0.9], abs=1e-2)
    assert shown(frames, "jawOpen").min() > 0.899


def test_the_loss_of_one_leaves_the_part_of_the_other_alone(people: Cast) -> None:
    performer = Performer(people)
    brows = Sender("a", FACE, ("brows",))
    lips = Sender("b", OTHER, ("mouth",))
    play(people, performer, [brows, lips], 4.0)
    frames = play(people, performer, [lips], 4.0)
    assert ends(frames) == pytest.approx([0.0, 0.9], abs=1e-2)
    assert shown(frames, "jawOpen").min() > 0.899
    assert ends(play(people, performer, [brows, lips], 4.0)) == pytest.approx([0.8, 0.9], abs=1e-3)


def test_eyes_of_one_with_angles_do_not_stay_when_another_without_takes_them(people: Cast) -> None:
    performer = Performer(people)
    other = Sender("other", {**dict.fromkeys(GAZE_UNITS, 0.0), **FACE})
    for _ in range(240):
        performer.drive_layer("tracker", Sender("eyes", FACE).frame(people, gaze=(0.4, 0.2)))
        frame = performer.advance(DT)
    assert frame.gaze.yaw == pytest.approx(0.4, abs=1e-3)
    performer.leave_layer("tracker", "eyes")
    frame = play(people, performer, [other], 6.0)[-1]
    assert (frame.gaze.yaw, frame.gaze.pitch) == pytest.approx((0.0, 0.0), abs=1e-3)


def test_eyes_by_angles_do_not_stay_when_the_same_source_sends_coefficients(people: Cast) -> None:
    performer = Performer(people)
    sender = Sender("phone", dict.fromkeys(GAZE_UNITS, 0.0))
    for n in range(600):
        performer.drive_layer("tracker", sender.frame(people, gaze=(0.4, 0.2) if n < 120 else None))
        frame = performer.advance(DT)
    assert (frame.gaze.yaw, frame.gaze.pitch) == pytest.approx((0.0, 0.0), abs=1e-3)


parts = st.lists(st.sampled_from(LAYER_PARTS), min_size=1, max_size=6, unique=True).map(tuple)
SENT = {"a": FACE, "b": OTHER, "c": {"browInnerUp": 1.0, "jawOpen": 0.0}}
Deed = tuple[str, str, tuple[LayerPart, ...], float]
"""A source, what it does, the parts that it is routed to, and the seconds after it."""
deeds = st.lists(
    st.tuples(
        st.sampled_from("abc"), st.sampled_from(["drive", "drive", "leave", "measure"]), parts, st.floats(0.0, 1.5)
    ),
    max_size=8,
)


@given(deeds)
@settings(max_examples=8)
def test_whoever_comes_goes_and_is_routed_nothing_jumps_and_every_part_has_who_may_play_it(
    people: Cast, show: list[Deed]
) -> None:
    check_smooth(people, show)


def test_a_source_that_leaves_while_it_is_measured_anew_does_not_jump(people: Cast) -> None:
    """It was forgotten while it still showed, since what lets go follows nobody."""
    check_smooth(people, [("c", "drive", ("brows",), 1.5), ("c", "measure", ("brows",), 0.0), ("c", "leave", (), 0.03)])


def check_smooth(people: Cast, show: Sequence[Deed]) -> None:
    """Plays what sources do, and asserts who is on air at the end, limits, and that nothing jumps on the way."""
    performer = Performer(people)
    sending = dict[str, Sender]()
    frames = [performer.advance(DT)]
    for name, what, routed, seconds in show:
        {"drive": _drives, "leave": _leaves, "measure": _measures}[what](
            performer, sending, Sender(name, SENT[name], routed)
        )
        frames += play(people, performer, list(sending.values()), seconds)
    frames += play(people, performer, list(sending.values()), 8.0)
    for name, part in (("browInnerUp", "brows"), ("jawOpen", "mouth")):
        may = [each.weights[name] for each in sending.values() if part in each.parts]
        assert any(frames[-1].channels.get(name, 0.0) == pytest.approx(each, abs=0.01) for each in may or [0.0])
        values = shown(frames, name)
        assert values.min() >= 0.0
        assert values.max() <= 1.0
        assert np.abs(np.diff(values, 2)).max(initial=0.0) < 0.1


def _drives(_: Performer, sending: dict[str, Sender], sender: Sender) -> None:
    sending[sender.name] = sender


def _leaves(performer: Performer, sending: dict[str, Sender], sender: Sender) -> None:
    sending.pop(sender.name, None)
    performer.leave_layer("tracker", sender.name)


def _measures(performer: Performer, _: dict[str, Sender], sender: Sender) -> None:
    performer.recalibrate_layer("tracker", sender.name)
