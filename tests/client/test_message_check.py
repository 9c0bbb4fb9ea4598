"""All that a program gives is checked at one place: plain numbers go on, everything else is named in a sentence."""

import math
import struct
from pathlib import Path
from typing import Any, get_args, get_type_hints

import numpy as np
import pytest

from omote.client.message_check import check_fields, encode_checked, explain, pack_numbers
from omote.show.declaration import ClientMessage
from omote.show.objects.calls import CallExpression, FadeFace
from omote.show.objects.motion import LookAt, SetMotion
from omote.show.objects.sources import Drive
from omote.show.objects.speech import Say
from omote.show.wire import decode


def call(**changed: Any) -> CallExpression:
    given = {"character": "one", "id": "1", "name": "smile", "seconds": 1.0, "easing": "smooth", **changed}
    return CallExpression(**given)


@pytest.mark.parametrize("kind", [np.float32, np.float64, float, np.array])
def test_numbers_of_numpy_are_numbers(kind: Any) -> None:
    number = kind(0.5)
    message = check_fields(call(strength=number, seconds=np.int64(2), name=np.str_("smile")))
    assert message == call(strength=0.5, seconds=2.0)
    assert decode(encode_checked(message)) == message


def test_arrays_are_lists() -> None:
    frame = Drive(0, b"", np.array([0.1, 0.2, 0.3]), np.array([0.1, 0.2]))  # type: ignore[arg-type]
    assert check_fields(frame) == Drive(0, b"", (0.1, 0.2, 0.3), (0.1, 0.2))


def test_what_is_right_stays_the_same_object() -> None:
    message = call()
    assert check_fields(message) is message


@pytest.mark.parametrize(
    ("error", "words", "message"),
    [
        (TypeError, "^text is 42; give text, at most 2000 characters$", Say("one", "1", 42)),  # type: ignore[arg-type]
        (TypeError, "^strength is 'much'; give a number$", call(strength="much")),
        (TypeError, "^strength is True; give a number$", call(strength=True)),
        (TypeError, r"^strength is \[\]; give a number$", call(strength=[])),
        (TypeError, r"^name is PosixPath\('smile'\); give text", call(name=Path("smile"))),
        (TypeError, r"^seconds is '2'; give a number or None$", call(seconds="2")),
        (TypeError, "^x is 'up'; give a number$", FadeFace("one", "up")),  # type: ignore[arg-type]
        (TypeError, "^queue is 'yes'; give True or False$", Say("one", "1", queue="yes")),  # type: ignore[arg-type]
        (TypeError, "^seed is 1.5; give a whole number or None$", SetMotion("one", seed=1.5)),  # type: ignore[arg-type]
        (TypeError, "^head is 3; give 3 numbers or None$", Drive(0, b"", 3, None)),  # type: ignore[arg-type]
        (TypeError, "^marks is ", Say("one", "1", marks=[1, 2])),  # type: ignore[list-item]
        (ValueError, "^text is 'aaaa.*at most 2000 characters: say it in several", Say("one", "1", "a" * 2001)),
        (ValueError, r"^text is 'a{39}\.\.\. \(2001 characters\)", Say("one", "1", "a" * 2001)),
        (ValueError, "^kind is 'nose'; give one of ahead, ", LookAt("one", "nose")),  # type: ignore[arg-type]
        (ValueError, "^head is .* give 3 numbers or None$", Drive(0, b"", (1.0, 2.0), None)),  # type: ignore[arg-type]
    ],
)  # fmt: skip
def test_what_cannot_be_is_named_with_what_to_give(error: type[Exception], words: str, message: Any) -> None:
    with pytest.raises(error, match=words):
        check_fields(message)


def test_ranges_are_the_show_s_to_check() -> None:
    assert math.isnan(check_fields(call(strength=math.nan)).strength)  # type: ignore[attr-defined]


def test_every_field_of_every_message_has_words() -> None:
    own = {"values", "configuration"}
    for kind in get_args(ClientMessage):
        hints = get_type_hints(kind, include_extras=True)
        for field in set(kind.__struct_fields__) - own:
            assert explain(hints[field]), (kind, field)


def test_numbers_of_any_kind_are_packed() -> None:
    assert pack_numbers([1, 0.5, np.float32(0.25)], "a time") == struct.pack("<3f", 1.0, 0.5, 0.25)


@pytest.mark.parametrize("values", [["0.1"], [None], [True], "0.1", 3])
def test_what_is_no_number_is_said(values: object) -> None:
    with pytest.raises(TypeError, match="give a"):
        pack_numbers(values, "a time")  # type: ignore[arg-type]


def test_a_number_that_no_single_float_holds_is_said() -> None:
    with pytest.raises(ValueError, match="not so large"):
        pack_numbers([1e300], "a time")
