"""All that a program gives is checked at one place: plain numbers go on, everything else is named in a sentence."""

import math
from pathlib import Path
from typing import Any, get_args, get_type_hints

import numpy as np
import pytest

from omote.server.client.link.message_check import check_fields, encode_checked, explain
from omote.show import messages as wire
from omote.show.wire import decode


def call(**changed: Any) -> wire.CallExpression:
    given = {"character": "one", "id": "1", "name": "smile", "seconds": 1.0, "easing": "smooth", **changed}
    return wire.CallExpression(**given)


@pytest.mark.parametrize("kind", [np.float32, np.float64, float, np.array])
def test_numbers_of_numpy_are_numbers(kind: Any) -> None:
    number = kind(0.5)
    message = check_fields(call(strength=number, seconds=np.int64(2), name=np.str_("smile")))
    assert message == call(strength=0.5, seconds=2.0)
    assert decode(encode_checked(message)) == message


def test_arrays_are_lists() -> None:
    frame = wire.Drive(0, b"", np.array([0.1, 0.2, 0.3]), np.array([0.1, 0.2]))  # type: ignore[arg-type]
    assert check_fields(frame) == wire.Drive(0, b"", (0.1, 0.2, 0.3), (0.1, 0.2))


def test_what_is_right_stays_the_same_object() -> None:
    message = call()
    assert check_fields(message) is message


@pytest.mark.parametrize(
    ("error", "words", "message"),
    [
        (TypeError, "^text is 42; give text, at most 2000 characters$", wire.Say("one", "1", 42)),  # type: ignore[arg-type]
        (TypeError, "^strength is 'much'; give a number$", call(strength="much")),
        (TypeError, "^strength is True; give a number$", call(strength=True)),
        (TypeError, r"^strength is \[\]; give a number$", call(strength=[])),
        (TypeError, r"^name is PosixPath\('smile'\); give text", call(name=Path("smile"))),
        (TypeError, r"^seconds is '2'; give a number or None$", call(seconds="2")),
        (TypeError, "^x is 'up'; give a number$", wire.FadeFace("one", "up")),  # type: ignore[arg-type]
        (TypeError, "^queue is 'yes'; give True or False$", wire.Say("one", "1", queue="yes")),  # type: ignore[arg-type]
        (TypeError, "^seed is 1.5; give a whole number or None$", wire.SetMotion("one", seed=1.5)),  # type: ignore[arg-type]
        (TypeError, "^head is 3; give 3 numbers or None$", wire.Drive(0, b"", 3, None)),  # type: ignore[arg-type]
        (TypeError, "^marks is ", wire.Say("one", "1", marks=[1, 2])),  # type: ignore[list-item]
        (ValueError, "^text is 'aaaa.*at most 2000 characters: say it in several", wire.Say("one", "1", "a" * 2001)),
        (ValueError, "^kind is 'nose'; give one of ahead, ", wire.LookAt("one", "nose")),  # type: ignore[arg-type]
        (ValueError, "^head is .* give 3 numbers or None$", wire.Drive(0, b"", (1.0, 2.0), None)),  # type: ignore[arg-type]
    ],
)  # fmt: skip
def test_what_cannot_be_is_named_with_what_to_give(error: type[Exception], words: str, message: Any) -> None:
    with pytest.raises(error, match=words):
        check_fields(message)


def test_ranges_are_the_show_s_to_check() -> None:
    assert math.isnan(check_fields(call(strength=math.nan)).strength)  # type: ignore[union-attr]


def test_every_field_of_every_message_has_words() -> None:
    own = {"values", "configuration"}
    for kind in get_args(wire.FromClient):
        hints = get_type_hints(kind, include_extras=True)
        for field in set(kind.__struct_fields__) - own:
            assert explain(hints[field]), (kind, field)
