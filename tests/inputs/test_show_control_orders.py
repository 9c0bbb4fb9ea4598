"""MIDI Show Control as orders: who is meant, and the numbers that desks write."""

import pytest

from omote.inputs.show_control_orders import is_meant, read_show_control
from omote.perform.cues.show_control import ShowControl
from omote.show.objects.cues import CuePlay, Go, PauseCues, SetStandby


@pytest.mark.parametrize(
    ("control", "order"),
    [
        (ShowControl("go"), Go("c")),
        (ShowControl("go", number="12.5"), Go("c", "12.5")),
        (ShowControl("go", number="012.500"), Go("c", "12.5")),
        (ShowControl("go", number="100."), Go("c", "100")),
        (ShowControl("go", number="0"), Go("c", "0")),
        (ShowControl("go", number="3", cue_list="2", path="1"), Go("c", "3", cue_list="matinee")),
        (ShowControl("go", cue_list="7"), Go("c", cue_list="7")),
        (ShowControl("stop", number="3"), PauseCues("c", on=True)),
        (ShowControl("resume"), PauseCues("c", on=False)),
        (ShowControl("load", number="8"), SetStandby("c", "8")),
    ],
)
def test_each_command_asks_for_what_a_desk_means_by_it(control: ShowControl, order: CuePlay) -> None:
    assert read_show_control(control, "c", ["main", "matinee", "7"]) == order


@pytest.mark.parametrize(
    ("control", "reason"),
    [
        (ShowControl("load"), "a cue cannot be numbered ''"),
        (ShowControl("go", number="1.2.3"), "a cue cannot be numbered '1.2.3'"),
        (ShowControl("go", number="1.2345"), "a cue cannot be numbered"),
        (ShowControl("go", cue_list="9"), "there is no list of cues '9'; there are 2: main, matinee"),
        (ShowControl("go", cue_list="1.5"), "there is no list of cues"),
    ],
)
def test_a_number_that_there_cannot_be_is_rejected(control: ShowControl, reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        read_show_control(control, "c", ["main", "matinee"])


def test_a_message_is_for_its_device_or_for_all_and_for_what_shows_pictures() -> None:
    assert is_meant(ShowControl("go", device=3), 3)
    assert is_meant(ShowControl("go"), 3)
    assert is_meant(ShowControl("go", form=0x7F), 3)
    assert not is_meant(ShowControl("go", device=4), 3)
    assert not is_meant(ShowControl("go", form=0x60), 3)  # fireworks
