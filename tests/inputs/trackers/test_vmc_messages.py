"""Messages of VMC: complete when their sender says so, bones turn head and eyes, damage costs itself alone."""

import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.osc_packet import Argument, encode_bundle, encode_message
from omote.inputs.rejection import PacketError
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.tracker_frame import TrackerFrame
from omote.inputs.trackers.vmc_messages import MOST_NAMES, VmcDecoder, encode_vmc, open_vmc
from tests.inputs.trackers.packets import head_matrix, quaternion
from tests.inputs.trackers.test_head_angles import UNITY

ANGLE = st.floats(-1.4, 1.4)
APPLY = "/VMC/Ext/Blend/Apply"


def value(name: Argument, weight: Argument) -> bytes:
    return encode_message("/VMC/Ext/Blend/Val", name, weight)


def bone(name: str, head: tuple[float, float, float]) -> bytes:
    turn = quaternion(UNITY @ head_matrix(*head) @ UNITY)
    return encode_message("/VMC/Ext/Bone/Pos", name, 0.0, 0.0, 0.0, *(float(each) for each in turn))


def heard(*packets: bytes) -> list[TrackerFrame]:
    decoder = VmcDecoder()
    return [frame for packet in packets for frame in decoder.decode(packet)]


def test_values_are_a_frame_when_they_are_applied_and_stay_until_they_are_said_again() -> None:
    frames = heard(
        value("JawOpen", 0.5),
        value("A", 1),
        encode_message(APPLY),
        encode_bundle([value("A", 0.0), encode_message(APPLY)]),
    )
    assert [frame.weights for frame in frames] == [{"JawOpen": 0.5, "A": 1.0}, {"JawOpen": 0.5, "A": 0.0}]
    assert [frame.head for frame in frames] == [None, None]


@given(st.tuples(ANGLE, ANGLE, ANGLE), st.tuples(st.floats(-0.6, 0.6), st.floats(-0.5, 0.5)))
def test_what_is_sent_is_read_as_it_was(head: tuple[float, float, float], gaze: tuple[float, float]) -> None:
    weights = {name: index / 64.0 for index, name in enumerate(ARKIT_NAMES)}
    packets = encode_vmc(weights, head, gaze, 3.5)
    assert all(len(packet) <= 1500 for packet in packets)
    frames = heard(*packets)
    assert frames[-1].weights == weights
    assert frames[-1].head == pytest.approx(head, abs=1e-5)
    assert frames[-1].gaze == pytest.approx(gaze, abs=1e-5)
    assert frames[-1].time == 3.5


def test_a_sender_of_bones_alone_is_heard_and_the_neck_carries_the_head() -> None:
    frames = heard(bone("Head", (0.2, 0.0, 0.0)), bone("Neck", (0.3, 0.0, 0.0)), bone("Hips", (1.0, 0.0, 0.0)))
    assert [frame.head for frame in frames] == [
        pytest.approx((0.2, 0.0, 0.0), abs=1e-6), *[pytest.approx((0.5, 0.0, 0.0), abs=1e-6)] * 2,
    ]  # fmt: skip
    assert [frame.bones is not None for frame in frames] == [False, False, True]


def test_bones_beside_values_wait_for_the_values() -> None:
    assert len(heard(value("A", 0.1), bone("LeftEye", (0.2, 0.0, 0.0)), encode_message(APPLY))) == 1


@pytest.mark.parametrize(("said", "found"), [((0,), False), ((1,), None), ((1, 3, 0, 0), False), ((1, 3, 0, 1), None)])
def test_a_sender_says_when_it_sees_nobody(said: tuple[int, ...], found: bool | None) -> None:
    frames = heard(encode_message("/VMC/Ext/OK", *said))
    assert [frame.found for frame in frames] == ([] if found is None else [found])


def test_a_value_may_come_as_any_number_each_time() -> None:
    """What stands before a float's bytes is remembered; a double begins alike and ends otherwise."""
    double = b"/VMC/Ext/Blend/Val\0\0,sd\0A\0\0\0" + struct.pack(">d", 0.75)
    other = double[:-4] + struct.pack(">d", 0.75000001)[-4:]
    frames = heard(
        *(
            encode_bundle([each, encode_message(APPLY)])
            for each in (double, other, value("A", 1), value("A", 0.5), value("A", 0.25))
        )
    )
    assert [frame.weights["A"] for frame in frames] == pytest.approx([0.75, 0.75, 1.0, 0.5, 0.25])


def test_senders_do_not_mix() -> None:
    first = open_vmc()
    second = open_vmc()
    first(value("A", 1.0))
    assert [frame.weights for frame in second(encode_message(APPLY))] == [{}]


def test_what_is_not_for_a_face_is_left_out() -> None:
    assert (
        heard(encode_message("/VMC/Ext/Cam", "c"), encode_message("/other"), encode_message("/VMC/Ext/Root/Pos")) == []
    )


@pytest.mark.parametrize(
    ("packet", "why"),
    [
        (b"hello!!!", "begins with"),
        (value("JawOpen", "1"), "must be a number"),
        (value("", 1.0), "where a name"),
        (value("x" * 81, 1.0), "where a name"),
        (encode_message("/VMC/Ext/Blend/Val", "A"), "1 arguments, expected 2"),
        (b"/VMC/Ext/Blend/Val\0\0,sq\0A\0\0\0\0\0\0\0", "does not know"),
        (encode_message("/VMC/Ext/OK"), "0 arguments"),
        (encode_message("/VMC/Ext/T", "now"), "where a number"),
        (encode_message("/VMC/Ext/Bone/Pos", "Head", 1.0), "2 arguments, expected 8"),
        (encode_message("/VMC/Ext/Bone/Pos", "Head", *[0.0] * 7), "no quaternion"),
        (encode_message("/VMC/Ext/Bone/Pos", "Head", *[float("nan")] * 7), "where a number"),
    ],
)
def test_damage_costs_itself_and_not_its_bundle(packet: bytes, why: str) -> None:
    decoder = VmcDecoder()
    decoder.decode(value("Joy", 0.5))
    with pytest.raises(PacketError, match=why):
        decoder.decode(packet)
    for bundle in ([packet, value("Fun", 1.0)], [value("A", 0.25), packet]):
        assert decoder.decode(encode_bundle(bundle)) == []
    (frame,) = decoder.decode(encode_message(APPLY))
    assert frame.weights == {"Joy": 0.5, "Fun": 1.0, "A": 0.25}
    assert frame.head is None
    assert all(why in reason for _, reason in frame.left_out)
    assert len(frame.left_out) == 2


@pytest.mark.parametrize(("wrong", "taken"), [(float("nan"), {}), (float("inf"), {}), (2.0, {"JawOpen": 1.5})])
def test_a_value_that_no_channel_takes_costs_itself(wrong: float, taken: dict[str, float]) -> None:
    decoder = VmcDecoder()
    for _ in range(2):  # as a name that is new, and as one that is known
        (frame,) = decoder.decode(encode_bundle([value("JawOpen", wrong), value("A", 0.25), encode_message(APPLY)]))
        assert frame.weights == {"A": 0.25, **taken}
        assert [name for name, _ in frame.left_out] == ["JawOpen"]


def test_a_bundle_that_is_cut_gives_what_it_holds() -> None:
    decoder = VmcDecoder()
    whole = encode_bundle([value("JawOpen", 0.5), value("A", 0.25), encode_message(APPLY)])
    for size in range(len(whole)):
        try:
            decoder.decode(whole[:size])
        except PacketError:
            continue
    (frame,) = decoder.decode(encode_message(APPLY))
    assert frame.weights == {"JawOpen": 0.5, "A": 0.25}
    assert decoder.decode(encode_bundle([])) == []


@pytest.mark.parametrize("clips", [300, 1500])
def test_a_model_with_many_clips_drives_a_face(clips: int) -> None:
    """Names that no face has never keep out one that a face has, wherever it stands, in however many packets."""
    many = [value(f"clip{index}", 0.0) for index in range(clips)]
    jaw = value("JawOpen", 0.5)
    for messages in ([jaw, *many], [*many, jaw]):
        decoder = VmcDecoder()
        frames = [decoder.decode(encode_bundle([*messages, encode_message(APPLY)]))[0] for _ in range(5)]
        assert frames[-1].weights["JawOpen"] == 0.5
        for at in range(0, len(messages), 40):
            decoder.decode(encode_bundle(messages[at : at + 40]))
        assert decoder.decode(encode_message(APPLY))[0].weights["JawOpen"] == 0.5


def test_bones_of_a_body_and_other_messages_keep_no_value_out() -> None:
    bones = [bone(f"Bone{index}", (0.1, 0.0, 0.0)) for index in range(600)]
    (frame,) = heard(encode_bundle([*bones, bone("Head", (0.2, 0.0, 0.0)), value("A", 0.5), encode_message(APPLY)]))
    assert frame.weights == {"A": 0.5}
    assert frame.head == pytest.approx((0.2, 0.0, 0.0), abs=1e-6)


def test_new_names_in_each_packet_fill_no_memory() -> None:
    decoder = VmcDecoder()
    decoder.decode(value("JawOpen", 0.5))
    for packet in range(40):
        names = [value(f"n{packet}.{index}", 0.1) for index in range(1000)]
        (frame,) = decoder.decode(encode_bundle([*names, encode_message(APPLY)]))
    assert frame.weights["JawOpen"] == 0.5
    assert len(frame.weights) <= 2 * MOST_NAMES
    assert len(decoder._names) <= 2 * MOST_NAMES
