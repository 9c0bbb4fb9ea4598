"""The springs that a cast has, and what of a face is kept without them."""

import pytest

from omote.perform.springs.cast_springs import check_spring, springs_of, without_springs


def test_a_cast_has_the_springs_of_its_channels() -> None:
    assert [*springs_of({"ears-flap", "smile"})] == ["ears-flap"]
    with pytest.raises(ValueError, match="there is no spring 'tail'"):
        check_spring("tail")


def test_what_is_kept_of_a_face_has_no_swing_of_the_moment_in_it() -> None:
    shown = {"jawOpen": 0.5, "ears-sway": 0.75, "ears-flap": -0.5}
    assert without_springs(shown, {"ears-sway": 0.25, "jawOpen": 0.125}) == {"jawOpen": 0.5, "ears-sway": 0.25}
    assert without_springs(shown, None) == shown
