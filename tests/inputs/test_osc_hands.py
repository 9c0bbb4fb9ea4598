"""Hands by OSC: axes of a device, the newest of each; what is no number of a hand is refused by its address."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target
from omote.inputs.osc_hands import HAND_AXES, OscHands
from omote.inputs.osc_input import OscInput
from omote.inputs.osc_packet import OscError, OscMessage, encode_bundle, encode_message
from omote.show.session import ShowSession
from tests import synthetic

WHO = {"one"}


def hear(hands: OscHands, address: str, *arguments: float | str) -> bool:
    return hands.hear(OscMessage(address, arguments), "10.0.0.9", WHO)


def test_the_newest_value_of_each_axis_is_taken_once() -> None:
    hands = OscHands()
    for opening in (0.2, 0.7):
        assert hear(hands, "/omote/one/hand/right/opening", opening)
    assert hear(hands, "/omote/one/hand/left/yaw", -math.pi / 4)
    taken = [(host, each.device, each.control, each.value) for host, each in hands.take()]
    assert taken == [
        ("10.0.0.9", "Hand one right", "opening", 0.7),
        ("10.0.0.9", "Hand one left", "yaw", 0.25),
    ]
    assert list(hands.take()) == []


def test_what_is_not_of_a_hand_is_left_to_others() -> None:
    hands = OscHands()
    for address in ("/omote/one/channel/jawOpen", "/omote/hand", "/hand/right/opening", "/omote/one/hands/right"):
        assert not hear(hands, address, 0.5)


@pytest.mark.parametrize(
    ("address", "arguments", "reason"),
    [
        ("/omote/one/hand/right/thumb", (0.5,), "expected /omote/CHARACTER/hand/right or left/ one of opening"),
        ("/omote/one/hand/both/opening", (0.5,), "right or left"),
        ("/omote/two/hand/right/opening", (0.5,), "no character 'two'"),
        ("/omote/one/hand/right/opening", (math.nan,), "one finite number"),
        ("/omote/one/hand/right/opening", (0.1, 0.2), "one finite number"),
        ("/omote/one/hand/right/opening", ("wide",), "one finite number"),
    ],
)
def test_what_cannot_be_read_is_refused_with_what_was_expected(
    address: str, arguments: tuple[float | str, ...], reason: str
) -> None:
    with pytest.raises(OscError, match=reason):
        hear(OscHands(), address, *arguments)


@given(st.sampled_from(HAND_AXES), st.floats(allow_nan=False, allow_infinity=False))
def test_every_number_is_a_position(axis: str, value: float) -> None:
    hands = OscHands()
    hear(hands, f"/omote/one/hand/right/{axis}", value)
    ((_, reading),) = hands.take()
    assert 0.0 <= reading.value <= 1.0


@given(st.lists(st.tuples(st.integers(0, 300), st.integers(0, 255)), max_size=12))
def test_a_damaged_bundle_gives_positions_or_a_reason(damage: list[tuple[int, int]]) -> None:
    osc = OscInput(lambda: session)
    packet = bytearray(encode_bundle([encode_message(f"/omote/one/hand/right/{axis}", 0.5) for axis in HAND_AXES]))
    for place, byte in damage:
        packet[place % len(packet)] = byte
    osc.receive(("10.0.0.9", 9000), bytes(packet), 0.0)
    assert all(0.0 <= reading.value <= 1.0 for _, reading in osc.hands.take())


session = ShowSession(synthetic.cast())


def test_an_axis_of_a_hand_is_never_picked_up() -> None:
    target = read_target("/omote/one/channel/jawOpen", [])
    assert not Binding("Hand one right", "opening", target, pick_up=True).pick_up
    assert Binding("desk", "1/cc7", target).pick_up
