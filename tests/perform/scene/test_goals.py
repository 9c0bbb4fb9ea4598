"""Goals of the parts of characters and of the scene."""

import pytest

from omote.perform.scene.goals import (
    CHARACTER_PARTS,
    SCENE_PARTS,
    WITH_FACE,
    check_goal,
    check_names,
    ranges_of,
    regions_of,
    whole_of,
)

PARTS = (*(f"one/{part}" for part in CHARACTER_PARTS), *(f"*/{part}" for part in SCENE_PARTS))


@pytest.mark.parametrize(
    ("part", "goal", "reason"),
    [
        ("one/tail", {}, "there is no part 'one/tail'; expected CHARACTER/face"),
        ("one/light", {}, "there is no part 'one/light'"),
        ("face", {}, "there is no part 'face'"),
        (
            "one/head",
            {"yaw": 0.0},
            "the goal of one/head has yaw; expected yaw, pitch, roll; add pitch = 0, roll = 0",
        ),
        (
            "one/head",
            {"yaw": 20.0, "pitch": 0.0, "roll": 0.0},
            r"yaw of one/head \(radians; 1 is 57.3 degrees\) is 20.0",
        ),
        ("*/black", {"black": 2.0}, r"black of \*/black is 2.0; give a number from 0 to 1"),
        ("one/face", {"a": 0.5}, "the weights of one/face sum to 0.5"),
        ("one/face", {}, "the weights of one/face sum to 0"),
    ],
)
def test_what_no_part_can_go_to_is_rejected(part: str, goal: dict[str, float], reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        check_goal(part, goal)


def test_a_name_that_there_is_not_is_rejected() -> None:
    with pytest.raises(ValueError, match="there is no face 'c'"):
        check_names({"a": 0.5, "c": 0.5}, ["a", "b"], "face")


def test_a_region_goes_with_its_face_alone_and_a_face_takes_all_of_its_regions() -> None:
    for part in PARTS:
        whole = whole_of(part)
        assert whole is None or part in regions_of(whole)
        regions = (*regions_of("one/expression"), *regions_of("one/pose"))
        assert (whole is not None) == (ranges_of(part) is None and part in regions)
    assert check_goal("one/brows", WITH_FACE) == WITH_FACE
