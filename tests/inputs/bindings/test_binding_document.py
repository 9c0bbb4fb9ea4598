"""Bindings as documents: each comes back the same, and what cannot be is left out with a reason."""

from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.bindings.binding_document import decode_stored, document_of, encode_stored, read_document
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target
from omote.show.objects.bindings import BindingDocument

TARGETS = (
    read_target("/omote/one/channel/jawOpen"),
    read_target("/omote/*/head", axis="pitch"),
    read_target("/omote/one/face", ["dog", 2.0]),
    read_target("/omote/panic"),
    read_target("bank:B"),
)
bindings = st.builds(
    lambda target, control, low, high, curve, bank, pick_up: Binding(
        "pad",
        control,
        target,
        low if target.is_level else 0.0,
        high if target.is_level else 1.0,
        curve=curve,
        bank=bank,
        pick_up=pick_up,
    ),
    st.sampled_from(TARGETS),
    st.sampled_from(["1/cc7", "axis0", "1/note60"]),
    st.floats(-0.5, 0.4),
    st.floats(0.5, 1.0),
    st.floats(0.2, 5.0),
    st.sampled_from(["", "A"]),
    st.booleans(),
)


@given(
    st.lists(bindings, max_size=6), st.dictionaries(st.text(min_size=1, max_size=5), st.text(max_size=5), max_size=3)
)
def test_what_is_stored_comes_back(found: list[Binding], presets: dict[str, str]) -> None:
    assert decode_stored(encode_stored(found, presets)) == (found, presets, [])
    assert [read_document(document_of(each)) for each in found] == found


@pytest.mark.parametrize(
    "more", [{"button": "toggle", "pick_up": False}, {"relative": "binary_offset", "step": 0.25}, {"high": -0.5}]
)
def test_buttons_encoders_and_turned_ranges_come_back(more: dict[str, Any]) -> None:
    binding = Binding("pad", "1/cc7", TARGETS[0], **more)
    assert read_document(document_of(binding)) == binding


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"to": "/omote/one/nose"}, "near are"),
        ({"low": float("nan")}, "low is nan"),
        ({"high": 9.0}, "high is 9"),
        ({"curve": 0.0}, "curve is 0"),
        ({"to": "/omote/one/head"}, "one axis of yaw, pitch, roll"),
        ({"to": "/omote/one/face", "arguments": ["dog", float("inf")]}, "finite"),
        ({"device": "sACN", "control": "17"}, "no slot"),
    ],
)
def test_a_document_that_is_no_binding_says_why(wrong: dict[str, Any], said: str) -> None:
    given = {"device": "pad", "control": "1/cc7", "to": "/omote/one/channel/jawOpen", **wrong}
    with pytest.raises(ValueError, match=said):
        read_document(BindingDocument(**given))


def test_what_a_show_file_has_that_cannot_be_is_left_out_and_said() -> None:
    good = document_of(Binding("pad", "1/cc7", TARGETS[0]))
    gone = msgspec.structs.replace(good, to="/omote/one/wings")
    data = msgspec.json.encode({"bindings": [good, gone], "presets": {}, "newer": 1})
    found, _, (sentence,) = decode_stored(data)
    assert [document_of(each) for each in found] == [good]
    assert "1/cc7 of pad is not bound" in sentence
    assert decode_stored(b"") == ([], {}, [])
    (unreadable,) = decode_stored(b"{")[2]
    assert "nothing is bound" in unreadable
