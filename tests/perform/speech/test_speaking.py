"""What a character says: begins, queues, interruptions, ends; the lips are taken and given back without a jump."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from omote.perform.speech.speaking import (
    GIVE_SECONDS,
    MOST_WAITING,
    SOUND_LEAD_SECONDS,
    Speaking,
    Speech,
    advance_speaking,
    check_speaking,
    find_spoken,
    make_speech,
    mouth_of_speaking,
    say,
    share_of_lips,
    speech_status,
    stop,
)
from omote.perform.speech.viseme_track import LEAD_SECONDS, VisemeTrack
from omote.perform.speech.visemes import MOUTH_UNITS, VISEMES

JAW = MOUTH_UNITS.index("jawOpen")
OPEN = VisemeTrack((0.0,), (VISEMES.index("aa"),), 1.0)


def _speech(number: int = 1, *, sound: str = "", delay: float = 0.0, offset: float = 0.0) -> Speech:
    return make_speech(OPEN, text="Ah", sound=sound, delay=delay, offset=offset, number=number)


def test_keys_name_what_is_said_and_the_newest_that_ended_by_itself_is_known() -> None:
    first, second = (replace(_speech(number), key=f"key {number}") for number in (1, 2))
    both = say(say(None, first, queue=False), second, queue=True)
    assert speech_status(both).keys == ("key 1", "key 2")  # type: ignore[union-attr]
    assert find_spoken(both, advance_speaking(both, 0.1)) is None
    later = advance_speaking(both, 1.4)
    assert later is not None
    assert (speech_status(later).keys, find_spoken(both, later)) == (("key 2",), "key 1")  # type: ignore[union-attr]
    assert find_spoken(both, advance_speaking(both, 20.0)) == "key 2"
    assert find_spoken(Speaking(None, lips=1.0), None) is None
    with pytest.raises(ValueError, match="a key of at most 64"):
        replace(first, key="k" * 65)


def _later(speaking: Speaking | None, seconds: float) -> Speaking | None:
    for _ in range(round(seconds * 100)):
        speaking = None if speaking is None else advance_speaking(speaking, 0.01)
    return speaking


def test_a_speech_begins_after_its_lead_and_ends_after_its_length() -> None:
    speaking = say(None, _speech(), queue=False)
    assert speech_status(speaking).elapsed == -LEAD_SECONDS  # type: ignore[union-attr]
    spoken = _later(speaking, LEAD_SECONDS + 0.5)
    assert spoken is not None
    assert mouth_of_speaking(spoken)[JAW] > 0.5
    assert share_of_lips(spoken) == 1.0
    ended = _later(spoken, 0.5 + LEAD_SECONDS + 0.1)
    assert speech_status(ended) is None
    assert _later(ended, GIVE_SECONDS) is None


def test_a_sound_of_the_stage_has_time_to_be_fetched_and_a_delay_is_kept() -> None:
    assert _speech(sound="a").elapsed == -SOUND_LEAD_SECONDS
    assert _speech(sound="a", delay=3.0).elapsed == -3.0
    assert _speech(offset=-0.5).elapsed <= -0.5 - LEAD_SECONDS


def test_an_offset_moves_the_mouth_against_the_sound() -> None:
    early, late = (
        mouth_of_speaking(Speaking(Speech(OPEN, offset=offset, elapsed=0.0), lips=1.0))[JAW] for offset in (-0.3, 0.3)
    )
    assert early > 0.5
    assert late == 0.0


def test_what_is_queued_is_said_after() -> None:
    speaking = say(say(None, _speech(1), queue=False), _speech(2, sound="b"), queue=True)
    status = speech_status(speaking)
    assert status is not None
    assert (status.number, status.waiting, status.next_sound) == (1, 1, "b")
    later = speech_status(_later(speaking, LEAD_SECONDS + 1.0 + LEAD_SECONDS + 0.1))
    assert later is not None
    assert (later.number, later.waiting) == (2, 0)
    assert later.elapsed == pytest.approx(-SOUND_LEAD_SECONDS + 0.1, abs=0.02)


def test_an_interruption_and_a_stop_do_not_jump() -> None:
    for interrupt in (lambda spoken: say(spoken, _speech(2), queue=False), stop):
        speaking: Speaking | None = _later(say(None, _speech(), queue=False), 0.5)
        ways = [mouth_of_speaking(speaking)] if speaking else []
        speaking = interrupt(speaking)
        for _ in range(100):
            if speaking is not None:
                ways.append(mouth_of_speaking(speaking))
                speaking = advance_speaking(speaking, 0.005)
        assert np.abs(np.diff(ways, axis=0)).max() < 0.1
        assert ways[40][JAW] < 0.05 or interrupt is not stop


def test_a_speech_that_begins_in_an_hour_takes_no_lips_yet() -> None:
    speaking = _later(say(None, _speech(delay=100.0), queue=False), 1.0)
    assert speaking is not None
    assert not speaking.moves
    assert share_of_lips(speaking) == 0.0


def test_nothing_stops_nothing() -> None:
    assert stop(None) is None
    assert speech_status(None) is None


def test_rejects_what_cannot_be_said() -> None:
    for wrong in (-0.1, 3601.0, math.nan):
        with pytest.raises(ValueError, match="delay of a speech"):
            _speech(delay=wrong)
    for wrong in (-1.1, 1.1, math.nan):
        with pytest.raises(ValueError, match="offset of a speech"):
            _speech(offset=wrong)
    with pytest.raises(ValueError, match="at most 2000"):
        Speech(OPEN, text="a" * 2001)
    with pytest.raises(ValueError, match="a sound and a key of at most 64"):
        Speech(OPEN, sound="a" * 65)
    full = Speaking(_speech(), (_speech(),) * MOST_WAITING)
    with pytest.raises(ValueError, match="wait already"):
        say(full, _speech(), queue=True)


def test_rejects_a_saved_speech_that_nobody_can_have_said() -> None:
    assert check_speaking(None) is None
    assert check_speaking(Speaking(_speech())) is not None
    for wrong in (
        Speaking(mouth=(0.0,)),
        Speaking(mouth=(2.0,) * len(MOUTH_UNITS)),
        Speaking(since=-1.0),
        Speaking(lips=1.1),
        Speaking(waiting=(_speech(),) * (MOST_WAITING + 1)),
    ):
        with pytest.raises(ValueError, match=r"mouth|wait|interrupted|lips"):
            check_speaking(wrong)
