"""What a cue does beside moving parts, read from the text that people write."""

import struct
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.osc_packet import decode_packet, encode_message
from omote.perform.cues.cue import Cue
from omote.perform.cues.cue_action import MOST_ACTIONS, CueAction, MidiSend, OscSend, SpokenLine
from omote.perform.cues.show_control import ShowControl, encode_show_control


def osc(what: str, to: str = "10.0.0.2:53000") -> OscSend:
    meant = CueAction("osc", to, what).meant
    assert isinstance(meant, OscSend)
    return meant


def test_an_argument_has_the_type_that_it_is_written_as() -> None:
    sent = osc('/cue/12/start 1 1.0 -2 .5e1 "1" "a \\"b\\" c" true false word')
    assert sent == OscSend("10.0.0.2", 53000, "/cue/12/start", (1, 1.0, -2, 5.0, "1", 'a "b" c', True, False, "word"))
    assert [type(each) for each in sent.arguments[:3]] == [int, float, int]
    assert osc("/go", "[::1]:9000") == OscSend("::1", 9000, "/go")
    assert osc(" /go ", "desk.local:1").arguments == ()


@given(st.text(max_size=60))
def test_any_text_is_a_message_that_arrives_or_a_sentence(text: str) -> None:
    try:
        sent = osc(f"/a {text}")
    except ValueError:
        return
    (message,) = decode_packet(encode_message(sent.address, *sent.arguments))
    assert message.address == "/a"
    assert [type(each) for each in message.arguments] == [type(each) for each in sent.arguments]
    single = [
        struct.unpack(">f", struct.pack(">f", each))[0] if isinstance(each, float) else each for each in sent.arguments
    ]
    assert message.arguments == tuple(single)


def test_midi_is_bytes_or_show_control() -> None:
    assert CueAction("midi", "Pad", "90 3c 7F").meant == MidiSend("Pad", b"\x90\x3c\x7f")
    control = encode_show_control(ShowControl("go", number="12.5"))
    assert CueAction("midi", "Desk", "msc go 12.5").meant == MidiSend("Desk", control)
    control = encode_show_control(ShowControl("stop", device=3))
    assert CueAction("midi", "Desk", "MSC 3 STOP").meant == MidiSend("Desk", control)


def test_a_line_is_who_says_what() -> None:
    assert CueAction("say", "one", " Good evening. ", voice="de").meant == SpokenLine("one", "Good evening.", "de")
    assert CueAction("say", "one", "", sound="bell").meant == SpokenLine("one", "", sound="bell")


@pytest.mark.parametrize(
    ("wrong", "reason"),
    [
        (("fire", "a", "b"), "there is no action of a cue 'fire'"),
        (("osc", "10.0.0.2", "/go"), "give a host and a port"),
        (("osc", "10.0.0.2:0", "/go"), "give a host and a port"),
        (("osc", "10.0.0.2:65536", "/go"), "give a host and a port"),
        (("osc", "a b:9000", "/go"), "give a host and a port"),
        (("osc", "a:9000", "go"), "'go' is no message of OSC"),
        (("osc", "a:9000", '/go "open'), "is no message of OSC"),
        (("osc", "a:9000", "/go 99999999999999999999"), "more than a number of OSC"),
        (("osc", "a:9000", "/go 1e39"), "more than a number of OSC"),
        (("osc", "a:9000", '/go "\\u0000"'), "zero byte"),
        (("osc", "a:9000", "/go " + "x" * 1000), "more than 1000 characters"),
        (("midi", " ", "90 3C 7F"), "names no MIDI device"),
        (("midi", "Pad", "9 3C"), "is no MIDI"),
        (("midi", "Pad", "3C 7F"), "is no whole message"),
        (("midi", "Pad", "F0 7E"), "is no whole message"),
        (("midi", "Pad", "msc fire 1"), "no command of MIDI Show Control 'fire'"),
        (("midi", "Pad", "msc 200 go 1"), "the device of MIDI Show Control is 200"),
        (("say", "one", " "), "a line has nothing that is said"),
        (("say", "one", "Ho", -1.0), "the delay of an action"),
        (("osc", "a:9000", "/go", 0.0, "de"), "the voice 'de' speaks nothing"),
        (("osc", "a:9000", "/go", 0.0, "", "bell"), "the sound 'bell' is not heard"),
        (("say", "one", "Ho", 0.0, "de", "bell"), "the sound 'bell' is not heard"),
    ],
)
def test_what_cannot_be_done_is_rejected_in_words(wrong: tuple[Any, ...], reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        CueAction(*wrong)


def test_a_cue_lasts_until_its_last_action_and_has_not_too_many() -> None:
    assert Cue("a", "1", actions=(CueAction("say", "one", "Ho", 2.5),)).length == 2.5
    with pytest.raises(ValueError, match=f"the cue has {MOST_ACTIONS + 1} actions"):
        Cue("a", "1", actions=(CueAction("say", "one", "Ho"),) * (MOST_ACTIONS + 1))
