"""Bytes that are no message are refused, whatever they are."""

import math

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.show.declaration import MESSAGE_LIMIT, SPEECH_LIMIT
from omote.show.objects.faders import SetChannel
from omote.show.objects.sources import MeasureSource
from omote.show.objects.speech import MOST_MARKS, Say
from omote.show.validation import Refusal
from omote.show.wire import decode, encode, id_in

BAD = {
    "nothing": b"",
    "no map": msgspec.msgpack.encode([1, 2, 3]),
    "no type": msgspec.msgpack.encode({"value": 1.0}),
    "an unknown type": msgspec.msgpack.encode({"type": "explode"}),
    "a type that is no text": msgspec.msgpack.encode({"type": 7}),
    "a field missing": msgspec.msgpack.encode({"type": "fade_face"}),
    "text for a number": msgspec.msgpack.encode({"type": "fade_face", "value": "0.5"}),
    "a bool for a number": msgspec.msgpack.encode({"type": "fade_face", "value": True}),
    "a level that there is not": msgspec.msgpack.encode({"type": "drawing", "fps": 60.0, "level": "best"}),
    "a message of the server": msgspec.msgpack.encode({"type": "refused", "reason": "no"}),
    "no name": msgspec.msgpack.encode({"type": "set_channel", "name": "", "value": 0.5}),
    "a name without end": msgspec.msgpack.encode({"type": "set_channel", "name": "x" * 81, "value": 0.5}),
    "a deep nest": b"\x91" * 3000,
    "broken UTF-8": b"\x81\xa4type\xa4\xff\xff\xff\xff",
    "too many bytes": bytes(SPEECH_LIMIT + 1),
    "a promise of 4 GB": b"\xdf\xff\xff\xff\xff",
    "JSON": b'{"type": "panic"}',
}


@pytest.mark.parametrize("data", BAD.values(), ids=BAD)
def test_what_is_no_message_is_refused_with_a_sentence(data: bytes) -> None:
    with pytest.raises(Refusal) as refused:
        decode(data)
    assert str(refused.value).endswith(".")
    assert len(str(refused.value)) < 300


def test_the_longest_text_of_any_script_with_the_times_of_all_its_characters_is_read() -> None:
    said = Say("one", "id" * 32, "😀" * 2000, "characters", ["😀"] * MOST_MARKS, bytes(4 * (MOST_MARKS + 1)))
    assert decode(encode(said)) == said
    words = Say("one", "id", "ä" * 2000, "words", ["Straßenbahn"] * MOST_MARKS, bytes(4 * (MOST_MARKS + 1)))
    assert decode(encode(words)) == words


def test_what_is_no_speech_is_read_no_further_than_ever() -> None:
    with pytest.raises(Refusal, match=f"at most {MESSAGE_LIMIT} are read"):
        decode(encode(MeasureSource("a", "b", {"n" * MESSAGE_LIMIT: 0.0}, {})))


@given(st.binary(max_size=200))
def test_random_bytes_are_refused_or_are_a_message(data: bytes) -> None:
    try:
        message = decode(data)
    except Refusal:
        return
    assert decode(encode(message)) == message


@given(st.data())
def test_a_message_with_one_byte_changed_is_refused_or_is_a_message(data: st.DataObject) -> None:
    changed = bytearray(encode(SetChannel("one", "jawOpen", 0.5)))
    changed[data.draw(st.integers(0, len(changed) - 1))] = data.draw(st.integers(0, 255))
    try:
        message = decode(bytes(changed))
    except Refusal:
        return
    if isinstance(message, SetChannel) and not math.isnan(message.value):
        assert decode(encode(message)) == message


@pytest.mark.parametrize("data", BAD.values(), ids=BAD)
def test_what_has_no_id_has_none(data: bytes) -> None:
    assert id_in(data) == ""


@given(st.text(max_size=64), st.dictionaries(st.text(max_size=9), st.integers(0, 9) | st.text(max_size=9), max_size=4))
def test_the_id_of_a_message_that_is_none_can_be_read(name: str, other: dict[str, int | str]) -> None:
    assert id_in(msgspec.msgpack.encode({**other, "type": "dance", "id": name})) == name
    assert id_in(msgspec.msgpack.encode({"type": "dance", "id": 65 * "x"})) == ""
