"""What a voice makes of a text: a sound that shows read, and visemes in it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.sounds.sound_file import read_sound
from omote.inputs.voices.phones import Segment
from omote.inputs.voices.spoken_text import WantedSpeech, check_wanted, encode_wav, put_together


@given(st.integers(300, 4000), st.sampled_from([8000, 22050]))
def test_a_wav_holds_its_samples_and_lasts_as_long(count: int, rate: int) -> None:
    sound = np.random.default_rng(count).integers(-32768, 32767, count, np.int16, endpoint=True)
    data = encode_wav(sound, rate)
    assert data.endswith(sound.astype("<i2").tobytes())
    assert read_sound(data).type == "audio/wav"
    assert read_sound(data).seconds == pytest.approx(count / rate)


@given(st.text(max_size=300))
def test_a_text_loses_no_letter_and_has_no_run_that_a_voice_cuts_off(text: str) -> None:
    try:
        wanted = check_wanted(WantedSpeech(text))
    except ValueError:
        return
    assert check_wanted(wanted) == wanted
    letters = [letter for letter in wanted.text if not letter.isspace()]
    assert [letter for letter in text if letter in set(letters)] == letters
    assert max(map(len, wanted.text.split(" "))) <= 300
    assert max(len(run) for run in wanted.text.split()) < 41 or any(mark in wanted.text for mark in "。、,.!?;:")


@pytest.mark.parametrize("speed", [0.4, 2.1, float("nan")])
def test_a_speed_is_refused_that_no_voice_has(speed: float) -> None:
    with pytest.raises(ValueError, match="the speed of a voice"):
        check_wanted(WantedSpeech("Hi", speed=speed))


def test_what_is_not_heard_or_has_too_many_sounds_is_refused() -> None:
    sound = np.zeros(1000, np.int16)
    segments = [Segment(0.0, 0.05, "m", ("PP",)), Segment(0.05, 0.1, "a", ("aa",))]
    assert put_together(sound, 10000, segments, most=2).marks == ["PP", "aa"]
    with pytest.raises(ValueError, match="the text has 2 sounds, at most 1 at once"):
        put_together(sound, 10000, segments, most=1)
    with pytest.raises(ValueError, match="finds nothing to speak"):
        put_together(sound, 10000, [Segment(0.0, 0.1, "", ("sil",))], most=2)
