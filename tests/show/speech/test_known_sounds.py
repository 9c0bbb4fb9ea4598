"""Sounds that a speech may name."""

import pytest

from omote.show.objects.speech import PlaySound, Say
from omote.show.speech.known_sounds import KnownSounds


def test_a_speech_has_the_length_of_its_sound_where_it_gives_none() -> None:
    sounds = KnownSounds()
    sounds.set({"a": 2.5})
    completed = sounds.complete(Say("one", "1", sound="a"))
    assert isinstance(completed, Say)
    assert completed.seconds == 2.5
    given = Say("one", "2", sound="a", seconds=1.0)
    assert sounds.complete(given) is given
    silent = Say("one", "3", "Hello")
    assert sounds.complete(silent) is silent
    assert sounds.complete(PlaySound("one", "4", "a")).seconds == 2.5


def test_rejects_a_sound_that_is_not_there_or_no_longer() -> None:
    sounds = KnownSounds()
    sounds.set({"a": 1.0})
    sounds.set({"b": 1.0})
    with pytest.raises(ValueError, match="there is no sound 'a' any more, or not yet: send it to /sounds first"):
        sounds.complete(Say("one", "1", sound="a"))
    assert [*sounds.keys] == ["b"]
