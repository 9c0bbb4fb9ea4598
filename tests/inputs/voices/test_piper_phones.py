"""The signs of Piper as phones: joined, timed by rule, and stops laid on the silence of the sound."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.voices.phones import Segment, visemes_of
from omote.inputs.voices.piper_phones import Sign, join_signs, lay_stops_on_silence, share_seconds

RATE = 1000


def phones(signs: str) -> list[tuple[str, tuple[str, ...] | None]]:
    return [(segment.name, segment.shapes) for segment in join_signs([Sign(sign, 0.1) for sign in signs])]


@pytest.mark.parametrize(
    ("signs", "joined"),
    [
        ("ˈaː", [("ˈaː", ("aa",))]),
        ("tʃi", [("tʃ", ("CH",)), ("i", ("I",))]),
        ("mˈi", [("m", ("PP",)), ("ˈi", ("I",))]),
        ("^m, a.$", [("^", ("sil",)), ("m", ("PP",)), (", ", ("sil",)), ("a", ("aa",)), (".$", ("sil",))]),
        ("a m", [("a", ("aa",)), (" ", ()), ("m", ("PP",))]),
        ("a  m", [("a", ("aa",)), ("  ", ("sil",)), ("m", ("PP",))]),
    ],
)
def test_signs_become_phones(signs: str, joined: list[tuple[str, tuple[str, ...]]]) -> None:
    assert phones(signs) == joined


@given(
    st.lists(st.tuples(st.sampled_from("ptkmaiˈː .,^"), st.floats(0.0, 0.3)), max_size=30), st.integers(0, 2**32 - 1)
)
def test_phones_follow_each_other_without_gaps_also_on_any_sound(signs: list[tuple[str, float]], seed: int) -> None:
    segments = join_signs([Sign(*sign) for sign in signs])
    loud = np.repeat(np.random.default_rng(seed).integers(0, 2, 200), 20).astype(float)
    laid = lay_stops_on_silence(segments, loud, RATE)
    for found in (segments, laid):
        assert all(before.end == after.start for before, after in pairwise(found))
        assert all(segment.start < segment.end for segment in found)
    assert [segment.name for segment in laid] == [segment.name for segment in segments]
    if segments:
        assert (laid[0].start, laid[-1].end) == (segments[0].start, segments[-1].end)
        assert segments[-1].end == pytest.approx(sum(seconds for _, seconds in signs))


def test_a_stop_lies_on_the_silence_that_ends_nearest_to_it() -> None:
    sound = np.r_[np.ones(200), np.zeros(60), np.ones(240)]
    vowel, stop, after = lay_stops_on_silence(
        [Segment(0.0, 0.22, "a", ("aa",)), Segment(0.22, 0.3, "p", ("PP",)), Segment(0.3, 0.5, "a", ("aa",))],
        sound, RATE,
    )  # fmt: skip
    assert (vowel.end, stop.start, stop.end, after.start) == pytest.approx((0.2, 0.2, 0.26, 0.26))


def test_without_lengths_what_is_heard_is_shared_by_those_of_running_speech() -> None:
    sound = np.r_[np.zeros(100), np.ones(350), np.zeros(50)]
    marks, times = visemes_of(join_signs(share_seconds(["^", "m", "a", ".", "$"], sound, RATE)), 0.5)
    assert marks == ["sil", "PP", "aa", "sil"]
    assert times == pytest.approx([0.0, 0.1, 0.1 + 0.35 * 0.075 / 0.175, 0.45, 0.5], abs=2e-3)
    assert share_seconds(["^", "$"], np.zeros(50), RATE) == [Sign("", 0.05)]
