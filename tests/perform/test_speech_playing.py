"""What a performer says, and sounds that leave its lips to others."""

from __future__ import annotations

import pytest

from omote.model.cast import Cast
from omote.perform.performer import Performer
from omote.perform.speech.speaking import LEAD_SECONDS


def test_a_sound_leaves_the_lips_to_who_plays_them_until_it_is_over(cast: Cast) -> None:
    performer = Performer(cast)
    performer.set_channel("jawOpen", 0.5)
    performer.play_sound("bell", 2.0, delay=-0.5, key="line")
    for _ in range(10):
        frame = performer.advance(0.1)
        assert frame.channels == {"jawOpen": 0.5}
    assert frame.speech is not None
    assert (frame.speech.sound, frame.speech.keys) == ("bell", ("line",))
    assert frame.speech.elapsed == pytest.approx(1.5)
    again = Performer.restored(cast, performer.snapshot())
    assert again.advance(0.1) == performer.advance(0.1)
    frame = performer.advance(0.4 + LEAD_SECONDS)
    assert (frame.speech, frame.spoken) == (None, "line")


def test_a_sound_takes_the_place_of_what_is_said_and_gives_the_lips_back(cast: Cast) -> None:
    performer = Performer(cast)
    performer.say("Mama", seconds=1.0)
    performer.advance(0.5)
    performer.play_sound("bell", 2.0)
    frame = performer.advance(1.0)
    assert frame.speech is not None
    assert frame.speech.text == ""
    assert frame.layers["lips"].share < 0.01
    performer.stop_speaking()
    assert performer.advance(0.1).speech is None


def test_what_is_no_sound_is_refused(cast: Cast) -> None:
    with pytest.raises(ValueError, match="the delay of a sound"):
        Performer(cast).play_sound("bell", 2.0, delay=-4000.0)
