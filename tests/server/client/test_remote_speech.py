"""What a program has a character say, as messages."""

import struct

import pytest

from omote.server.client.remote_speech import RemoteSpeech
from omote.show import messages as wire


def _speech(sent: list[wire.FromClient]) -> RemoteSpeech[None]:
    return RemoteSpeech("one", lambda: "id", sent.append)


def test_times_go_as_single_floats() -> None:
    sent: list[wire.FromClient] = []
    _speech(sent).say("Hi", timing="azure", marks=["21"], times=[0.5, 1.0], sound="a", queue=True)
    assert sent == [wire.Say("one", "id", "Hi", "azure", ["21"], struct.pack("<2f", 0.5, 1.0), sound="a", queue=True)]


def test_gestures_and_stops_are_messages() -> None:
    sent: list[wire.FromClient] = []
    _speech(sent).gesture("tilt", amplitude=-1.0)
    _speech(sent).stop_speaking()
    assert sent == [wire.MakeGesture("one", "id", "tilt", -1.0), wire.StopSpeaking("one", "id")]


def test_rejects_names_that_there_are_not_before_anything_is_sent() -> None:
    sent: list[wire.FromClient] = []
    with pytest.raises(ValueError, match="kind of timing"):
        _speech(sent).say("a", timing="morse")
    with pytest.raises(ValueError, match="language"):
        _speech(sent).say("a", language="fr")
    with pytest.raises(ValueError, match="gesture"):
        _speech(sent).gesture("dance")
    with pytest.raises(TypeError, match="queue"):
        _speech(sent).say("a", queue="yes")  # type: ignore[arg-type]
    assert sent == []
