"""A character as a program plays it: what is wrong is said before it is sent; others by their labels."""

from typing import Any

import pytest

from omote.model.cast import Cast
from tests.server.client.test_remote_show import Wired


@pytest.mark.parametrize("seconds", [None, "2", True])
def test_only_infinite_seconds_wait_for_the_t_bar(cast: Cast, seconds: Any) -> None:
    one = Wired(cast).show["one"]
    for call in (one.call_face, one.call_expression):
        with pytest.raises(TypeError, match=f"seconds is {seconds!r}; give a number, or math.inf, which waits"):
            call("broad", seconds=seconds)


def test_another_character_is_looked_at_by_its_label(cast: Cast) -> None:
    show = Wired(cast).show
    show.add("two", label="Beta")
    show["one"].look_at("character", "beta")
    motion = show["one"].frame.motion
    assert motion is not None
    assert (motion.target.kind, motion.target.name) == ("character", "two")
    with pytest.raises(ValueError, match="there is no character 'gamma' in this scene"):
        show["one"].look_at("character", "gamma")
