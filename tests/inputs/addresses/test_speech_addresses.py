"""The addresses by which a character speaks: what each message becomes, and what is rejected."""

import pytest

from omote.inputs.osc_orders import read_orders
from omote.inputs.osc_packet import Argument, OscError, OscMessage
from omote.show import messages as wire
from tests import synthetic

CAST = synthetic.cast()


def _read(path: str, *arguments: Argument) -> tuple[wire.FromClient, ...]:
    return read_orders(OscMessage(f"/omote/one/{path}", arguments), CAST, {"one": "One"}, "id")


def test_a_text_is_said_in_a_language_after_a_delay() -> None:
    assert _read("say", "Hello there") == (wire.Say("one", "id", "Hello there"),)
    assert _read("say/de", "Guten Tag", 0.5) == (wire.Say("one", "id", "Guten Tag", language="de", delay=0.5),)


def test_a_button_makes_a_gesture_when_it_is_pressed_alone() -> None:
    assert _read("gesture/nod") == _read("gesture/nod", 1.0) == (wire.MakeGesture("one", "id", "nod"),)
    assert _read("gesture/wink", 1.0, -0.5) == (wire.MakeGesture("one", "id", "wink", -0.5),)
    assert _read("gesture/nod", 0.0) == _read("stop_speaking", 0.0) == ()
    assert _read("stop_speaking") == (wire.StopSpeaking("one", "id"),)


def test_a_gesture_is_made_by_its_name() -> None:
    assert _read("gesture", "nod") == _read("gesture/nod")
    assert _read("gesture", "nod", 0.5) == (wire.MakeGesture("one", "id", "nod", 0.5),)


def test_an_expression_is_called_in_part() -> None:
    (call,) = _read("expression", "smile", 0.5, 0.25)
    assert isinstance(call, wire.CallExpression)
    assert (call.seconds, call.strength) == (0.5, 0.25)


@pytest.mark.parametrize(
    ("path", "arguments", "match"),
    [
        ("say", (), "text is missing"),
        ("say", (3.0,), "text is"),
        ("say", ("Hello", "soon"), "delay is"),
        ("say/fr", ("Bonjour",), "language 'fr'"),
        ("gesture", ("dance",), "gesture 'dance'"),
        ("gesture", ("nod", 0.5, 1.0), "expected at most"),
        ("gesture/dance", (), "gesture 'dance'"),
        ("gesture/nod", (1.0, "far"), "amplitude is"),
        ("gesture/nod", (1.0, 1.0, 1.0), "expected at most"),
    ],
)
def test_rejects_what_cannot_be_said(path: str, arguments: tuple[Argument, ...], match: str) -> None:
    with pytest.raises(OscError, match=match):
        _read(path, *arguments)
