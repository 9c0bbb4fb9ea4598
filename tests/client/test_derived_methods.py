"""Methods that commands declare."""

import inspect
from typing import Any

import pytest

from omote.client.derived_methods import add_methods, method_of, named
from omote.show.objects.calls import FadeFace, SetHome
from omote.show.objects.faders import SetHead
from omote.show.objects.gaze_points import SetGazePoint


class Owner:
    """Keeps what is sent."""

    def __init__(self) -> None:
        self.sent: list[tuple[type, dict[str, Any]]] = []

    def build(self, command: type, fields: dict[str, Any]) -> None:
        self.sent.append((command, fields))

    def set_head(self) -> str:
        return "its own"


def test_a_method_has_the_arguments_and_the_words_of_its_command() -> None:
    method = method_of(SetHome, "set_home", {"character", "id"})
    assert str(inspect.signature(method)) == "(self, face, *, seconds=2.0)"
    assert method.__doc__ == SetHome.__doc__


def test_a_class_keeps_the_methods_of_its_own() -> None:
    owner: Any = Owner
    add_methods(owner, [FadeFace, SetHead, SetGazePoint], filled=["character"])
    made = owner()
    made.fade_face(x=0.5)
    made.set_gaze_point("seat", 1.0, y=2.0, z=3.0)
    assert made.set_head() == "its own"
    assert made.sent == [
        (FadeFace, {"value": 0.5}),
        (SetGazePoint, {"name": "seat", "x": 1.0, "y": 2.0, "z": 3.0}),
    ]
    with pytest.raises(TypeError, match="missing a required argument: 'x'"):
        made.fade_face()


def test_commands_that_have_an_id_are_given_the_next() -> None:
    assert (named(SetGazePoint, lambda: "a-1"), named(FadeFace, lambda: "a-2")) == ({"id": "a-1"}, {})
