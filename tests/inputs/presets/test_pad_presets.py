"""Gamepads and space mice by the standard mapping: sticks look and turn, triggers and keys play."""

import math

import pytest

from omote.show.objects.devices import Controls
from omote.show.objects.state import CharacterState
from tests.inputs.presets.test_midi_presets import Plugged


@pytest.mark.parametrize("name", ["Xbox Wireless Controller (045e:0b13)", "DualSense Wireless Controller (054c:0ce6)"])
def test_a_pad_plays_when_it_is_plugged_in(name: str) -> None:
    pad = Plugged(name, "gamepad")

    def hold(**values: float) -> CharacterState:
        assert pad.devices.receive("a", Controls(name, values), pad.now) == []
        return pad.tick()

    assert hold(axis0=1.0, axis1=0.0).gaze == pytest.approx((math.radians(35), math.radians(25)))
    assert hold(axis0=0.5, axis1=0.51).gaze == (0.0, 0.0)
    assert hold(axis2=0.0).head[0] == pytest.approx(math.radians(-60))
    assert hold(trigger7=0.5, button7=0.5).channels == {"jawOpen": 0.5}
    assert hold(trigger7=0.0, button7=0.0, button4=1.0).channels == {"eyeBlinkRight": 1.0}
    called = hold(button4=0.0, button0=1.0).expression_call
    assert called is not None
    assert called.target == "smile"
    assert hold(button8=1.0).panics == 1


def test_a_space_mouse_turns_the_head() -> None:
    mouse = Plugged("SpaceMouse Compact", "space_mouse")
    mouse.devices.receive("a", Controls(mouse.name, {"rz": 1.0, "rx": 0.0, "ry": 0.5}), 0.0)
    assert mouse.tick().head == pytest.approx((math.radians(60), math.radians(40), 0.0))
