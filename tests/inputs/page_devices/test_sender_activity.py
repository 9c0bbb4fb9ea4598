"""What moves is shown, with where it stands; what never moved, where there is room; order stays the sender's."""

import math

from omote.inputs.page_devices.sender_activity import MOST_SHOWN, SenderActivity
from omote.inputs.trackers.arkit_names import ARKIT_NAMES

STILL = dict.fromkeys(ARKIT_NAMES, 0.1)


def test_of_fifty_two_channels_the_few_that_move_are_shown() -> None:
    activity = SenderActivity()
    moving = ("jawOpen", "mouthSmileLeft", "browInnerUp")
    for look in range(40):
        values = STILL | {name: 0.5 + 0.3 * math.sin(look) for name in moving} | {"cheekPuff": 0.9}
        shown = activity.look(values)
    assert set(moving) < set(shown)
    assert len(shown) == MOST_SHOWN
    assert all(shown[name] == values[name] for name in shown)
    assert list(shown) == [name for name in ARKIT_NAMES if name in shown]


def test_at_rest_the_highest_are_shown_and_zeros_never() -> None:
    activity = SenderActivity()
    assert activity.look(dict.fromkeys(ARKIT_NAMES, 0.0)) == {}
    assert activity.look({"jawOpen": 0.0, "cheekPuff": 0.7}) == {"cheekPuff": 0.7}


def test_what_moved_long_ago_makes_room() -> None:
    activity = SenderActivity()
    for value in (0.0, 1.0, 0.0):
        activity.look(STILL | {"tongueOut": value})
    for look in range(100):
        shown = activity.look(STILL | {"tongueOut": 0.0, "jawOpen": 0.3 + 0.2 * (look % 2)})
    assert "jawOpen" in shown
    assert "tongueOut" not in shown
