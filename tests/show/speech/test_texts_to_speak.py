"""Texts that a voice is to speak, asked for, ended and refused through a session."""

from __future__ import annotations

import pytest

from omote.show.declaration import ClientMessage
from omote.show.objects.calls import Panic
from omote.show.objects.link import Refused
from omote.show.objects.speech import Say, SayByVoice, StopSpeaking
from omote.show.session import ShowSession
from tests import synthetic


@pytest.fixture
def session() -> ShowSession:
    """A show with a sender."""
    session = ShowSession(synthetic.cast())
    session.join("osc desk", "OSC desk")
    return session


def test_a_text_is_taken_once_and_said_once(session: ShowSession) -> None:
    assert session.receive("osc desk", SayByVoice("one", "1", "Hello", "de"), 0.0) == []
    (text,) = session.texts.take()
    assert (text.who, text.message.text, text.message.voice, text.characters) == ("osc desk", "Hello", "de", ("one",))
    assert session.texts.take() == []
    assert session.texts.finish(text)
    assert not session.texts.finish(text)


@pytest.mark.parametrize(
    "ends", [StopSpeaking("one"), Panic("one", "2"), Say("one", "2", "No"), SayByVoice("*", "2", "No")]
)
def test_what_a_character_does_meanwhile_ends_the_waiting(session: ShowSession, ends: ClientMessage) -> None:
    session.receive("osc desk", SayByVoice("one", "1", "Hello"), 0.0)
    (text,) = session.texts.take()
    assert session.receive("osc desk", ends, 0.1) == []
    assert not session.texts.finish(text, "it could not be spoken")
    assert session.texts.take_refused(lambda _: True) == [], "nobody wants it any more"


def test_what_is_not_spoken_is_told_to_who_asked(session: ShowSession) -> None:
    session.receive("osc desk", SayByVoice("one", "1", "Hello"), 0.0)
    (text,) = session.texts.take()
    session.texts.finish(text, "no voice")
    assert session.texts.take_refused(lambda who: who != "osc desk") == []
    assert session.texts.take_refused(lambda who: who == "osc desk") == [(text, "no voice")]
    assert session.texts.take_refused(lambda _: True) == []


def test_a_character_that_there_is_not_is_refused(session: ShowSession) -> None:
    (answer,) = session.receive("osc desk", SayByVoice("two", "1", "Hello"), 0.0)
    assert isinstance(answer.message, Refused)
    assert "there is no character 'two'" in answer.message.reason
    assert session.texts.take() == []
