"""Messages of OSC: each address becomes its message, and what is wrong is said in words."""

import contextlib
import math

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.osc_addresses import ADDRESSES
from omote.inputs.osc_orders import OrderReader
from omote.inputs.osc_packet import Argument, OscError, OscMessage
from omote.perform.easing import HAND_SECONDS
from omote.perform.limits import GAZE_LIMITS
from omote.show.declaration import ClientMessage, Message
from omote.show.objects.calls import (
    CallExpression,
    CallFace,
    FadeExpression,
    FadeFace,
    Panic,
    ReleaseExpression,
    ReleaseFace,
)
from omote.show.objects.characters import EnterCharacter, LeaveCharacter, PlaceCharacter
from omote.show.objects.cues import Go, SetStandby
from omote.show.objects.faders import SetChannel, SetGaze, SetHead
from omote.show.objects.layers import SetLayer
from omote.show.objects.leases import Lease, ReleaseLease
from omote.show.objects.memories import CallMemory, KeepMemory
from omote.show.objects.motion import LookAt, SetMotion, SetSkin, SetSpring
from omote.show.objects.pictures import CallBlack, CallFraming, CallLight
from tests import synthetic

CAST = synthetic.cast()


def orders(address: str, *arguments: Argument, there: tuple[str, ...] = ("one",)) -> tuple[ClientMessage, ...]:
    return OrderReader(CAST, dict(zip(there, there, strict=True))).read(OscMessage(address, arguments), "c1")


@pytest.mark.parametrize(
    ("address", "arguments", "message"),
    [
        ("face", ["broad"], CallFace("one", "c1", "broad", 1.0, "smooth")),
        ("face", ["Broad", 2], CallFace("one", "c1", "broad", 2.0, "smooth")),
        ("face", ["broad", "0.25"], CallFace("one", "c1", "broad", 0.25, "smooth")),
        ("face", ["broad", "hand"], CallFace("one", "c1", "broad", None, "smooth")),
        ("expression", ["smile", 0.0], CallExpression("one", "c1", "smile", 0.0, "smooth")),
        ("expression/brows", ["smile"], CallExpression("one", "c1", "smile", 1.0, "smooth", "brows")),
        ("expression/Mouth", ["Smile", 0], CallExpression("one", "c1", "smile", 0.0, "smooth", "mouth")),
        ("channel/jawOpen", [0.5], SetChannel("one", "jawOpen", 0.5)),
        ("channel/jaw-open", ["1"], SetChannel("one", "jawOpen", 1.0)),
        ("channel/jawOpen", [True], SetChannel("one", "jawOpen", 1.0)),
        ("head", [90, "-90", 0.0], SetHead("one", math.pi / 2, -math.pi / 2, 0.0)),
        ("gaze", [40, -30], SetGaze("one", GAZE_LIMITS["yaw"], -GAZE_LIMITS["pitch"])),
        ("look_ahead", [], LookAt("one", "ahead")),
        ("look_at/direction", [90, -45], LookAt("one", "direction", yaw=math.pi / 2, pitch=-math.pi / 4)),
        ("look_at/point", [0.5, "1", -2], LookAt("one", "point", x=0.5, y=1.0, z=-2.0)),
        ("look_at/gaze_point", ["front row"], LookAt("one", "gaze_point", "front row")),
        ("look_at/character", ["ONE"], LookAt("one", "character", "one")),
        ("look_at/stage", ["left"], LookAt("one", "stage", "left")),
        ("motion/idle", [True], SetMotion("one", idle=True)),
        ("spring/ears-sway", [0.5], SetSpring("one", "ears-sway", 0.5)),
        ("skin/folds", [0.5], SetSkin("one", "folds", 0.5)),
        ("fade/face", [0.5], FadeFace("one", 0.5)),
        ("fade/expression", [1], FadeExpression("one", 1.0)),
        ("release/face", [], ReleaseFace("one")),
        ("release/expression", [1.0], ReleaseExpression("one")),
        ("panic", [], Panic("one")),
        ("lease/face", [], Lease("c1", "one", "face")),
        ("lease/Head", [1], Lease("c1", "one", "head")),
        ("take_over/all", [1.0], Lease("c1", "one", "*", take_over=True)),
        ("release_lease/gaze", [], ReleaseLease("c1", "one", "gaze")),
        ("enter", [], EnterCharacter("c1", "one", 1.0)),
        ("leave", ["2"], LeaveCharacter("c1", "one", 2.0)),
        ("place", [-1, 0.5, 2, 90], PlaceCharacter("one", -1.0, 0.5, 2.0, math.pi / 2, 1.0)),
        ("place", [0, 0, 1, 0, 3], PlaceCharacter("one", 0.0, 0.0, 1.0, 0.0, 3.0)),
    ],
)
def test_an_address_of_a_character_becomes_its_message(
    address: str, arguments: list[Argument], message: ClientMessage
) -> None:
    assert orders(f"/omote/one/{address}", *arguments) == (message,)
    assert orders(f"/omote/*/{address}/", *arguments) == (message,), "all, where there is one"
    three = ("one", "two", "three")
    for_all = msgspec.structs.replace(message, character="*")
    assert orders(f"/omote/*/{address}", *arguments, there=three) == (for_all,)
    told = orders(f"/omote/t*/{address}", *arguments, there=three)
    assert [getattr(each, "character", "") for each in told] == ["two", "three"]
    ids = [name for each in told if (name := getattr(each, "id", ""))]
    assert len({*ids}) == len(ids), "an id executes once"


@pytest.mark.parametrize("pattern", ["four", "o", "[!ot]*", ""])
def test_an_address_of_nobody_is_rejected(pattern: str) -> None:
    with pytest.raises(OscError, match=r"there is no (character|address)"):
        orders(f"/omote/{pattern}/release/face", there=("one", "two"))


@pytest.mark.parametrize(
    ("address", "arguments", "message"),
    [
        ("light", ["Flat", 3], CallLight("c1", "flat", 3.0, "smooth")),
        ("black", [0.5], CallBlack(0.5, HAND_SECONDS)),
        ("black", ["1", 3], CallBlack(1.0, 3.0)),
        ("fade_to_black", [], CallBlack(1.0, 1.0)),
        ("memory", ["finale", 2.5], CallMemory("c1", "finale", 2.5)),
        ("memory/finale", [1.0], CallMemory("c1", "finale", 1.0)),
        ("keep_memory", ["finale"], KeepMemory("c1", "finale")),
        ("fade_up", [0], CallBlack(0.0, 0.0)),
        ("framing", ["*"], CallFraming("c1", [], 1.0, "smooth")),
        ("framing", ["one", 2], CallFraming("c1", ["one"], 2.0, "smooth")),
        ("framing", ["two + one"], CallFraming("c1", ["two", "one"], 1.0, "smooth")),
        ("shot", ["bust"], CallFraming("c1", None, 1.0, "smooth", "bust")),
        ("panic", [], Panic("*")),
        ("panic", [1], Panic("*")),
        ("lease/light", [], Lease("c1", "*", "light")),
        ("take_over/framing", [1], Lease("c1", "*", "framing", take_over=True)),
        ("release_lease/all", [], ReleaseLease("c1", "*", "*")),
    ],
)
def test_an_address_of_the_show_names_no_character(
    address: str, arguments: list[Argument], message: ClientMessage
) -> None:
    assert orders(f"/omote/{address}", *arguments, there=("one", "two")) == (message,)


@pytest.mark.parametrize(
    "address", ["panic", "one/panic", "one/lease/face", "take_over/light", "one/release/face", "*/release/expression"]
)
@pytest.mark.parametrize("value", [0, 0.0, False, "0", -1], ids=repr)
def test_a_button_that_is_let_go_does_nothing(address: str, value: Argument) -> None:
    assert orders(f"/omote/{address}", value) == ()


@pytest.mark.parametrize(
    ("address", "arguments", "said"),
    [
        ("/omote/one/nose", [1], "there is no address '/omote/one/nose'; near are /omote/one/"),
        ("/omote/ONE/expresion", ["smile"], "near are /omote/ONE/expression"),
        ("/omote/dog/expresion", ["smile"], "near are /omote/{character}/expression"),
        ("/other", [1], "they are like /omote/{character}/face; /omote of the show's pages lists all"),
        ("/omote/face", ["broad"], "there is no address"),
        ("/VMC/Ext/Blend/Apply", [], "this is VMC: switch that on (--listen vmc)"),
        ("/omote//face", ["broad"], "there is no address"),
        ("/other/one/face", ["broad"], "there is no address"),
        ("/VMC/Ext/Blend/Apply", [], "this is VMC: switch that on (--listen vmc) and send it to port 39539"),
        ("/omote/one/face", [], "the name is missing"),
        ("/omote/one/face", ["brood"], "there is no face 'brood' in this cast; near are broad"),
        ("/omote/one/face", [7], "the name is '7'; expected the name of a face"),
        ("/omote/one/face", ["broad", "soon"], "the seconds is 'soon'"),
        ("/omote/one/face", ["broad", 1, 2], "3 values came; expected at most 2"),
        ("/omote/one/expression/nose", ["smile"], "there is no region 'nose' to play in; expected one of brows, eyes"),
        ("/omote/one/expression/brows", ["smile", "hand"], "the seconds is 'hand'"),
        ("/omote/one/channel/jawOpen", [], "the weight is missing; expected a number from -0.5 to 1.5"),
        ("/omote/one/channel/jawOpen", ["nan"], "the weight is 'nan'"),
        ("/omote/one/channel/jawOpen", ["1_0"], "the weight is '1_0'"),
        ("/omote/one/channel/jawOpen", [b"1"], "expected a number from -0.5 to 1.5"),
        ("/omote/one/head", [1, 2], "the roll is missing"),
        ("/omote/light", ["disco"], "there is no light 'disco'"),
        ("/omote/framing", ["one+nobody"], "there is no character 'nobody'"),
        ("/omote/framing", [""], "there is no character ''"),
        ("/omote/framing", [1], "expected the name of a framing"),
        ("/omote/one/enter", ["hand"], "the seconds is 'hand'"),
        ("/omote/one/place", [0, 0, 1], "the turn is missing; expected a number from -180 to 180"),
        ("/omote/one/gaze", [41.0, 0.0], "the yaw is 41 degrees; give a number from -40 to 40"),
        ("/omote/one/gaze", [0, "-31"], "the pitch is -31 degrees; give a number from -30 to 30"),
        ("/omote/one/head", [0.0, 0.0, float("nan")], "the roll is nan degrees"),
        ("/omote/one/place", [0, 0, 1, 181], "the turn is 181 degrees; give a number from -180 to 180"),
        ("/omote/one/lease/nose", [], "there is no part of a character to hold 'nose'"),
        ("/omote/lease/brows", [], "there is no part of the scene to hold 'brows'"),
        ("/omote/lease/brows", [], "for it is a character's: name that in the address"),
        ("/omote/one/lease/light", [], "the light is a part of the scene, not of a character: leave the character out"),
        ("/omote/layer_on/tracker", [1], "there is no address '/omote/layer_on/tracker'"),
        ("/omote/expression/brows", ["smile"], "there is no address '/omote/expression/brows'"),
        ("/omote/one/face", [], "the name is missing; expected the name of a face, as text"),
        ("/omote/take_over/face", [], "names no character; write whose it is: /omote/one/take_over/face"),
        ("/omote/motion/blinks", [1.0], "near are /omote/{character}/motion/blinks"),
        ("/omote/one/layer_on/tracker", [2], "the on is 2; expected 1 or true for on, 0 or false for off"),
        ("/omote/one/layer_on/tracker", [0.5], "the on is 0.5; expected 1 or true for on"),
        ("/omote/one/layer_on/tracker", ["yes"], "the on is 'yes'; expected 1 or true for on"),
        ("/omote/one/layer_on/tracker", [float("nan")], "the on is nan"),
        ("/omote/one/layer_on/tracker", [], "the on is missing; expected 1 or true for on"),
    ],
)
def test_what_is_wrong_is_said(address: str, arguments: list[Argument], said: str) -> None:
    with pytest.raises(OscError) as raised:
        orders(address, *arguments)
    assert said in str(raised.value)


def test_an_angle_out_of_range_is_said_in_degrees_each_time() -> None:
    reader = OrderReader(CAST, {"one": "One"})
    reader.read(OscMessage("/omote/one/gaze", (40.0, -30.0)), "c1")
    with pytest.raises(OscError, match=r"/omote/one/gaze: the yaw is 90 degrees; give a number from -40 to 40"):
        reader.read(OscMessage("/omote/one/gaze", (90.0, 0.0)), "c2")


OFF: tuple[Argument, ...] = (0, 0.0, False, "FALSE", "0", "0.0")


@pytest.mark.parametrize(
    ("value", "on"),
    [*((each, True) for each in (1, 1.0, True, "true", "1", " True ")), *((each, False) for each in OFF)],
    ids=repr,
)
def test_a_switch_is_on_or_off(value: Argument, on: bool) -> None:
    assert orders("/omote/one/layer_on/tracker", value) == (SetLayer("one", "tracker", None, None, on),)


@pytest.mark.parametrize(
    ("argument", "cue"), [("42", "42"), (" 12.5 ", "12.5"), (43, "43"), (12.125, "12.125"), (3.0, "3")]
)
def test_a_cue_is_numbered_by_text_or_by_a_number(argument: Argument, cue: str) -> None:
    assert orders("/omote/go", argument) == (Go("c1", cue),)
    assert orders("/omote/standby", argument) == (SetStandby("c1", cue),)


def test_a_button_plays_go_once_and_a_cue_whose_number_must_be_named_is_no_button() -> None:
    assert orders("/omote/go") == orders("/omote/go", 1.0) == orders("/omote/go", True) == (Go("c1"),)
    assert orders("/omote/go", 0.0) == orders("/omote/go", False) == ()
    assert orders("/omote/standby", 1.0) == (SetStandby("c1", "1"),)
    for argument in ("1.2.3", -1, b"1"):
        with pytest.raises(OscError, match="a cue cannot be numbered"):
            orders("/omote/go", argument)
    with pytest.raises(OscError, match="a cue cannot be numbered 'True'"):
        orders("/omote/standby", True)


def test_a_reader_says_the_same_each_time() -> None:
    reader = OrderReader(CAST, {"one": "One", "two": "Two"})
    for _ in range(2):
        (message,) = reader.read(OscMessage("/omote/t*/channel/jaw open", (0.5,)), "c1")
        assert message == SetChannel("two", "jawOpen", 0.5)
        with pytest.raises(OscError, match="there is no face 'brood' in this cast; near are broad"):
            reader.read(OscMessage("/omote/one/face", ("brood",)), "c1")


@pytest.mark.parametrize("label", ["Rex", "Old Rex"])
def test_a_character_is_found_by_its_label(label: str) -> None:
    reader = OrderReader(CAST, {"one": "Two", "two": label})
    written = label.lower().replace(" ", "_")
    assert reader.read(OscMessage(f"/omote/{written}/panic", ()), "c1") == (Panic("two"),)
    assert reader.read(OscMessage("/omote/two/panic", ()), "c1") == (Panic("two"),)  # a name wins over a label
    (framing,) = reader.read(OscMessage("/omote/framing", (f"one+{written}",)), "c1")
    assert isinstance(framing, CallFraming)
    assert sorted(framing.characters or ()) == ["one", "two"]


def test_a_reader_fits_its_own_cast_and_characters_alone() -> None:
    reader = OrderReader(CAST, {"one": "One"})
    assert reader.fits(CAST, {"one": "One"})
    assert not reader.fits(CAST, {"one": "One", "two": "Two"})
    assert not reader.fits(CAST, {"one": "Rex"})
    assert not reader.fits(synthetic.cast.__wrapped__(), {"one": "One"})


@given(st.lists(st.one_of(st.text(max_size=5), st.floats(), st.integers(), st.none(), st.binary()), max_size=5))
def test_no_arguments_raise_anything_else(given: list[Argument]) -> None:
    for address in ADDRESSES:
        written = address.pattern.replace("{character}", "one").replace("{name}", "smile").replace("{region}", "eyes")
        with contextlib.suppress(OscError):
            assert all(isinstance(message, Message) for message in orders(written, *given))
