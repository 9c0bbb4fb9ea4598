"""Addresses of OSC: each becomes its message, and what is wrong is said in words."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.osc_addresses import ADDRESSES, Address, Order, read_order
from omote.inputs.osc_packet import Argument, OscError, OscMessage
from omote.perform.limits import GAZE_LIMITS
from omote.show import messages as wire
from tests import synthetic

CAST = synthetic.cast()


def order(address: str, *arguments: Argument) -> Order | None:
    return read_order(OscMessage(address, arguments), CAST, "c1")


@pytest.mark.parametrize(
    ("address", "arguments", "message"),
    [
        ("face", ["broad"], wire.CallFace("c1", "broad", 1.0, "smooth")),
        ("face", ["Broad", 2], wire.CallFace("c1", "broad", 2.0, "smooth")),
        ("face", ["broad", "0.25"], wire.CallFace("c1", "broad", 0.25, "smooth")),
        ("face", ["broad", "hand"], wire.CallFace("c1", "broad", None, "smooth")),
        ("expression", ["smile", 0.0], wire.CallExpression("c1", "smile", 0.0, "smooth")),
        ("channel/jawOpen", [0.5], wire.SetChannel("jawOpen", 0.5)),
        ("channel/jaw-open", ["1"], wire.SetChannel("jawOpen", 1.0)),
        ("channel/jawOpen", [True], wire.SetChannel("jawOpen", 1.0)),
        ("head", [90, "-90", 0.0], wire.SetHead(math.pi / 2, -math.pi / 2, 0.0)),
        ("gaze", [40, -30], wire.SetGaze(GAZE_LIMITS["yaw"], -GAZE_LIMITS["pitch"])),
        ("fade/face", [0.5], wire.FadeFace(0.5)),
        ("fade/expression", [1], wire.FadeExpression(1.0)),
        ("release/face", [], wire.ReleaseFace()),
        ("release/expression", [1.0], wire.ReleaseExpression()),
    ],
)
def test_an_address_of_a_character_becomes_its_message(
    address: str, arguments: list[Argument], message: wire.FromClient
) -> None:
    assert order(f"/omote/one/{address}", *arguments) == Order("one", message)
    assert order(f"/omote/*/{address}/", *arguments) == Order("*", message)


@pytest.mark.parametrize(
    ("address", "arguments", "message"),
    [
        ("light", ["Flat", 3], wire.CallLight("c1", "flat", 3.0, "smooth")),
        ("panic", [], wire.Panic()),
        ("panic", [1], wire.Panic()),
    ],
)
def test_an_address_of_the_show_names_no_character(
    address: str, arguments: list[Argument], message: wire.FromClient
) -> None:
    assert order(f"/omote/{address}", *arguments) == Order("", message)


@pytest.mark.parametrize("address", ["panic", "one/release/face", "one/release/expression"])
@pytest.mark.parametrize("value", [0, 0.0, False, "0", -1], ids=repr)
def test_a_button_that_is_let_go_does_nothing(address: str, value: Argument) -> None:
    assert order(f"/omote/{address}", value) is None


@pytest.mark.parametrize(
    ("address", "arguments", "said"),
    [
        ("/omote/one/nose", [1], "there is no address '/omote/one/nose'; there are /omote/{character}/face"),
        ("/omote/face", ["broad"], "there is no address"),
        ("/omote//face", ["broad"], "there is no address"),
        ("/other/one/face", ["broad"], "there is no address"),
        ("/omote/one/face", [], "the name is missing"),
        ("/omote/one/face", ["brood"], "there is no face 'brood' in this cast; near are broad"),
        ("/omote/one/face", [7], "the name is '7'; expected the name of a face"),
        ("/omote/one/face", ["broad", "soon"], "the seconds is 'soon'"),
        ("/omote/one/face", ["broad", 1, 2], "3 values came; expected at most 2"),
        ("/omote/one/channel/jawOpen", [], "the weight is missing; expected a number from -0.5 to 1.5"),
        ("/omote/one/channel/jawOpen", ["nan"], "the weight is 'nan'"),
        ("/omote/one/channel/jawOpen", ["1_0"], "the weight is '1_0'"),
        ("/omote/one/channel/jawOpen", [b"1"], "expected a number from -0.5 to 1.5"),
        ("/omote/one/head", [1, 2], "the roll is missing"),
        ("/omote/light", ["disco"], "there is no light 'disco'"),
    ],
)
def test_what_is_wrong_is_said(address: str, arguments: list[Argument], said: str) -> None:
    with pytest.raises(OscError) as raised:
        order(address, *arguments)
    assert said in str(raised.value)


@pytest.mark.parametrize("address", ADDRESSES, ids=lambda address: address.path)
@given(st.lists(st.one_of(st.text(max_size=5), st.floats(), st.integers(), st.none(), st.binary()), max_size=5))
def test_no_arguments_raise_anything_else(address: Address, given: list[Argument]) -> None:
    written = address.pattern.replace("{character}", "one").replace("{name}", "smile")
    try:
        found = order(written, *given)
    except OscError:
        return
    assert found is None or isinstance(found.message, wire.Message)
