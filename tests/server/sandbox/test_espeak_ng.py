"""The library of eSpeak NG as it is installed, in a child process as shows load it."""

import espeakng_loader
import pytest

from omote.inputs.voices.phones import shapes_of_ipa
from omote.server.sandbox.child_task import Limits, run_limited
from omote.server.sandbox.espeak_ng import Espeak

LIMITS = Limits(seconds=20, patience=60.0, memory=2**30)


def load() -> Espeak:
    return Espeak(espeakng_loader.get_library_path(), espeakng_loader.get_data_path())


def test_phones_come_in_their_order_within_the_sound() -> None:
    def speak(_: object) -> tuple[int, int, list[tuple[int, str]]]:
        sounded = load().speak("gmw/de", "Mama")
        return len(sounded.sound), sounded.rate, sounded.phones

    count, rate, phones = run_limited(speak, tuple[int, int, list[tuple[int, str]]], LIMITS, exhausted="it ended")
    starts = [start for start, _ in phones]
    assert starts == sorted(starts)
    assert 0.3 * rate < starts[-1] <= count < rate
    assert [shapes_of_ipa(name) for _, name in phones if name] == [("PP",), ("aa",), ("PP",), ("aa",)]


def test_what_is_not_there_is_said() -> None:
    with pytest.raises(ValueError, match="espeak-ng has no voice none"):
        run_limited(lambda _: load().speak("none", "Hi").rate, int, LIMITS, exhausted="it ended")
    with pytest.raises(OSError, match="none"):
        Espeak("/none.so")
