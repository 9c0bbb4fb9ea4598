"""MIDI Show Control: the standard's bytes, and what is none."""

from contextlib import suppress
from typing import get_args

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.cues.show_control import Command, ShowControl, decode_show_control, encode_show_control

numbers = st.text("0123456789.", max_size=12)
messages = st.builds(
    ShowControl, st.sampled_from(get_args(Command)), st.integers(0, 127), st.integers(0, 127), numbers, numbers, numbers
)


def test_go_is_what_the_standard_writes() -> None:
    go = ShowControl("go", device=2, number="12.5", cue_list="3", path="1")
    assert encode_show_control(go) == b"\xf0\x7f\x02\x02\x01\x01" + b"12.5\x003\x001" + b"\xf7"
    assert encode_show_control(ShowControl("go")) == bytes.fromhex("F0 7F 7F 02 01 01 F7")
    assert encode_show_control(ShowControl("stop"))[5] == 2
    assert encode_show_control(ShowControl("load", number="7")) == bytes.fromhex("F0 7F 7F 02 01 05 37 F7")


@given(messages)
def test_what_is_written_is_read_back(message: ShowControl) -> None:
    assert decode_show_control(encode_show_control(message)) == message


@given(st.binary(max_size=40).map(lambda data: b"\xf0\x7f\x7f\x02" + data + b"\xf7"))
def test_any_bytes_are_a_message_or_another_or_a_sentence(data: bytes) -> None:
    with suppress(ValueError):
        message = decode_show_control(data)
        assert message is None or encode_show_control(message)[:6] == data[:6]


@pytest.mark.parametrize(
    "other",
    ["F0 7E 7F 06 01 F7", "F0 7F 7F 01 01 01 00 00 00 00 F7", "F0 7F 7F 02 F7", "F0 7F 7F 02 01 0B F7", "90 3C 7F"],
)
def test_another_message_of_system_exclusive_is_none(other: str) -> None:
    assert decode_show_control(bytes.fromhex(other)) is None


@pytest.mark.parametrize(
    ("wrong", "reason"),
    [
        ({"command": "fire"}, "there is no command of MIDI Show Control 'fire'"),
        ({"command": "go", "device": 128}, "the device of MIDI Show Control is 128"),
        ({"command": "go", "form": -1}, "the form of MIDI Show Control is -1"),
        ({"command": "go", "number": "12a"}, "has more than 32 digits and points"),
    ],
)
def test_what_no_message_has_is_rejected(wrong: dict[str, object], reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        ShowControl(**wrong)  # type: ignore[arg-type]
