"""Phones in time as visemes."""

import numpy as np
import pytest

from omote.inputs.voices.phones import Segment, claim_closures, shapes_in_place, shapes_of_ipa, visemes_of


@pytest.mark.parametrize(
    ("phone", "shapes"),
    [
        ("p", ("PP",)), ("tʃ", ("CH",)), ("ˈeɪ", ("E", "I")), ("mʲ", ("PP",)), ("ä", ("aa",)), ("ɔ̃", ("O",)),
        ("h", ()), ("ʲ", ()), ("", ("sil",)), ("_:", ("sil",)), ("%", None),
    ],
)  # fmt: skip
def test_a_phone_of_ipa_looks_like_a_viseme(phone: str, shapes: tuple[str, ...] | None) -> None:
    assert shapes_of_ipa(phone) == shapes


def test_a_phone_without_a_shape_of_its_own_looks_like_the_next() -> None:
    phones = [("h", ()), ("a", ("aa",)), ("h", ()), ("", ("sil",))]
    segments = [Segment(at, at + 1.0, name, shapes) for at, (name, shapes) in enumerate(phones)]
    assert shapes_in_place(segments) == [("aa",), ("aa",), (), ("sil",)]


def test_visemes_follow_each_other_with_the_end_of_the_last() -> None:
    segments = [Segment(0.1, 0.2, "m", ("PP",)), Segment(0.2, 0.3, "b", ("PP",)), Segment(0.3, 1.3, "ai", ("aa", "I"))]
    marks, times = visemes_of(segments, 1.5)
    assert marks == ["PP", "aa", "I"]
    assert times == pytest.approx([0.1, 0.3, 0.85, 1.5])
    assert visemes_of([], 1.0) == ([], [])


def test_a_stop_has_the_silence_before_its_burst() -> None:
    sound = np.r_[np.ones(100), np.zeros(50), np.ones(50)]
    vowel, stop = claim_closures([Segment(0.0, 0.15, "a", ("aa",)), Segment(0.15, 0.2, "p", ("PP",))], sound, 1000)
    assert vowel.end == stop.start
    assert vowel.end == pytest.approx(0.1, abs=0.006)
