"""What programs know of a speech becomes a track: words, characters, shapes, text alone."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import pytest

from omote.perform.speech.speech_timing import make_track
from omote.perform.speech.viseme_track import VisemeTrack
from omote.perform.speech.visemes import VISEMES


def _made(kind: str, marks: Sequence[str] = (), times: Sequence[float] = (), **given: object) -> VisemeTrack:
    options: dict[str, object] = {"text": "", "language": "en", "seconds": None, **given}
    return make_track(kind, str(options["text"]), marks, times, language=str(options["language"]),
                      seconds=options["seconds"])  # type: ignore[arg-type]  # fmt: skip


def _at(track: VisemeTrack, time: float) -> str:
    place = max((at for at, start in enumerate(track.starts) if start <= time + 1e-9), default=-1)
    return VISEMES[track.visemes[place]] if place >= 0 and time < track.seconds else "sil"


def test_words_begin_at_their_times() -> None:
    track = _made("words", ["Papa", "fell", "off"], [0.5, 1.0, 1.3, 1.6])
    assert [_at(track, time) for time in (0.2, 0.5, 1.0, 1.59)] == ["sil", "PP", "FF", "FF"]
    assert track.seconds == pytest.approx(1.6)


def test_a_word_before_a_long_pause_ends_by_itself() -> None:
    track = _made("words", ["Papa", "fell"], [0.0, 4.0, 4.3])
    assert _at(track, 2.0) == "sil"
    assert _at(track, 4.0) == "FF"


def test_a_last_word_without_an_end_takes_what_it_takes() -> None:
    assert 0.2 < _made("words", ["Papa"], [0.0]).seconds < 0.6


def test_characters_give_each_viseme_the_time_of_its_letters() -> None:
    text = "a map"
    times = [0.0, 0.2, 0.5, 0.9, 1.4, 1.5]
    track = _made("characters", list(text), times)
    assert [_at(track, time) for time in (0.1, 0.55, 1.0, 1.45)] == ["aa", "PP", "aa", "PP"]


def test_shapes_of_azure_oculus_and_rhubarb_are_where_they_are_said_to_be() -> None:
    azure = _made("azure", ["0", "21", "11", "0"], [0.0, 0.1, 0.2, 0.4, 0.5])
    assert [_at(azure, time) for time in (0.05, 0.15, 0.25, 0.35, 0.45)] == ["sil", "PP", "aa", "I", "sil"]
    assert _at(_made("visemes", ["viseme_PP", "ou"], [0.0, 0.1, 0.3]), 0.2) == "U"
    assert _at(_made("rhubarb", ["X", "G"], [0.0, 0.1]), 0.15) == "FF"


def test_text_alone_is_stretched_to_the_length_that_is_known() -> None:
    text = "Hello my friend, how are you?"
    rule = _made("text", text=text)
    longer = _made("text", text=text, seconds=6.0)
    assert 1.0 < rule.seconds < 4.0
    assert longer.seconds == pytest.approx(6.0)
    assert longer.visemes[: len(rule.visemes)] == rule.visemes
    assert "sil" in [VISEMES[each] for each in rule.visemes]  # the comma


def test_nothing_said_is_silence_of_its_length() -> None:
    assert _made("text").seconds == 0.0
    assert _made("text", seconds=2.0).seconds == 2.0
    assert _made("words", ["..."], [0.0, 1.0]).visemes == ()


def test_a_track_never_goes_back() -> None:
    for track in (
        _made("text", text="What a wonderful day! 1, 2, 3. " * 20),
        _made("words", ["a", "b", "c"], [0.0, 0.0, 0.0, 0.1]),
        _made("characters", list("abc def"), [0.1] * 7),
    ):
        assert all(before <= after for before, after in pairwise(track.starts))


@pytest.mark.parametrize(
    ("kind", "marks", "times", "given", "match"),
    [
        ("morse", ["a"], [0.0], {}, "kind of timing"),
        ("words", ["a"], [0.0], {"language": "fr"}, "language"),
        ("words", ["a"], [], {}, "send one for each"),
        ("words", [], [], {}, "send one for each"),
        ("words", ["a"], [0.0, 0.1, 0.2], {}, "send one for each"),
        ("words", ["a", "b"], [0.5, 0.1], {}, "time 2 is 0.1 s, before"),
        ("words", ["a"], [-0.1], {}, "time 1"),
        ("words", ["a"], [601.0], {}, "time 1"),
        ("words", ["a"], [math.nan], {}, "time 1"),
        ("words", ["a"], [math.inf], {}, "time 1"),
        ("text", ["a"], [0.0], {"text": "a"}, "marks came with text alone"),
        ("text", [], [], {"text": "a" * 2001}, "2001 characters"),
        ("text", [], [], {"seconds": 601.0}, "length of a speech"),
        ("text", [], [], {"seconds": -1.0}, "length of a speech"),
        ("text", [], [], {"seconds": math.nan}, "length of a speech"),
        ("characters", ["ab"], [0.0], {}, "each character by itself"),
        ("visemes", ["ZZ"], [0.0], {}, "viseme"),
        ("azure", ["22"], [0.0], {}, "viseme id"),
        ("rhubarb", ["Q"], [0.0], {}, "mouth shape"),
    ],
)
def test_rejects_what_is_no_timing(
    kind: str, marks: list[str], times: list[float], given: dict[str, object], match: str
) -> None:
    with pytest.raises(ValueError, match=match):
        _made(kind, marks, times, **given)
