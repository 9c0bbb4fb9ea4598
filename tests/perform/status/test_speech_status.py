"""What is said now, on the wire and in a frame: the same fields."""

from dataclasses import fields

from msgspec import structs

from omote.perform.status.speech_status import SpeechStatus
from omote.show.messages import SpeechState


def test_the_wire_has_every_field() -> None:
    assert [each.name for each in fields(SpeechStatus)] == [each.name for each in structs.fields(SpeechState)]
