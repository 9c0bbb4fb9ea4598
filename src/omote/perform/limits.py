"""The ranges of everything that can be played, and the validation of numbers and names against them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from numbers import Real
from typing import Any, TypeVar

from omote.model.known_names import explain_unknown

Known = TypeVar("Known", bound=str)

CHANNEL_LOWEST = -0.5
CHANNEL_HIGHEST = 1.5
"""Trackers send up to 1.08, artists exaggerate; beyond this a face breaks."""
HEAD_LIMITS: Mapping[str, float] = dict.fromkeys(("yaw", "pitch", "roll"), math.pi / 2)
GAZE_LIMITS: Mapping[str, float] = {"yaw": math.radians(40.0), "pitch": math.radians(30.0)}
"""Radians either way; beyond those of the gaze the iris goes out of sight behind the lids."""
LONGEST_CALL = 3600.0
"""Seconds; whoever wants longer wants the T-bar."""
SHORTEST_CALL = 1e-3
"""Seconds; what is shorter is a cut."""
FOREVER = 1e9
"""Seconds; more than any show."""


def check_within(value: object, low: float, high: float, what: str) -> float:
    """Returns `value` as a float where it is a real number from `low` to `high`; else raises with a message.

    what: what messages call it.
    """
    if type(value) is float and low <= value <= high:
        return value  # what nearly all are
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{what} must be a number, not {value!r}; give {low:g} to {high:g}")
    number: Any = value  # typeshed gives Real no comparison with float
    if not low <= number <= high:  # also catches NaN
        raise ValueError(f"{what} is {_format(value)}; give a number from {low:.4g} to {high:.4g}")
    return float(number)


def check_switch(value: object, what: str) -> bool:
    """Returns `value` where it is True or False; else raises TypeError with a message. what: what messages call it."""
    if isinstance(value, bool):
        return value
    raise TypeError(f"{what} is {value!r}; give True or False")


def check_call_seconds(seconds: object) -> float:
    """Returns the seconds of a call, 0 for one that is so short that it is a cut; else raises with a message."""
    number = check_within(seconds, 0.0, LONGEST_CALL, "the time of a call (seconds)")
    return number if number >= SHORTEST_CALL else 0.0


def check_known(name: object, names: Iterable[Known], what: str) -> Known:
    """Returns the one of `names` that is `name`; else raises ValueError with the nearest ones.

    what: what messages call it.
    """
    choices = list(names)
    for choice in choices if isinstance(name, str) else ():
        if choice == name:
            return choice
    raise ValueError(explain_unknown(name, choices, what))


def check_free(name: str, names: Iterable[str], what: str) -> None:
    """Raises ValueError where one of `names` is `name`, in any case of its letters. what: what messages call it."""
    twin = next((each for each in names if each.casefold() == name.casefold()), None)
    if twin is not None:
        raise ValueError(f"there is a {what} {twin!r} already; give another name")


def _format(value: Real) -> str:
    try:
        number = float(value)
        return "no number (NaN)" if math.isnan(number) else "infinite" if math.isinf(number) else repr(number)
    except OverflowError:  # an integer of more digits than a message wants
        return "far too large"
