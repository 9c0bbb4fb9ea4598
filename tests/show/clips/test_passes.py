"""Passes of clips at another speed, and of what one pair of hands plays."""

from __future__ import annotations

import math

import numpy as np
import pytest

from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import MotionCurve, make_curve
from omote.perform.layers.layer_names import LayerPart
from omote.show.clips import show_clips
from omote.show.objects import clips as wire
from omote.show.objects.speech import PlaySound
from tests.show.clips.clip_show import Show, reason

CURVE = 1e-3
"""Radians: by which two cubics through 60 and through more frames a second differ, of a head that swings by .2 three
times a second."""
TIMES = np.arange(121) / 60.0


def swinging(part: LayerPart, rate: float) -> Clip:
    """Two seconds of a head or a gaze that swings so many times a second."""
    yaw = 0.2 * np.sin(2.0 * math.pi * rate * TIMES)
    still = np.zeros(len(TIMES))
    if part == "head":
        curve = make_curve(TIMES, {}, {}, head=np.column_stack([yaw, still, still]))
    else:
        curve = make_curve(TIMES, {}, {}, gaze=np.column_stack([yaw, still]))
    return Clip([Lane(curve, parts=(part,))], blend_out=0.0)


@pytest.mark.parametrize(
    ("speed", "rate", "start"), [(0.25, 3.0, 0.0), (0.5, 3.0, 0.25), (0.75, 1.0, 0.25), (1.0, 3.0, 0.0)]
)
def test_a_pass_of_motion_at_its_own_speed_is_that_at_full_speed_in_the_time_of_the_clip(
    cast: Cast, speed: float, rate: float, start: float
) -> None:
    def kept(speed: float) -> tuple[Lane, list[float]]:
        show = Show(cast)
        show.session.clips.put("moves", swinging("head", rate))
        show.session.clips.put("line1", swinging("gaze", rate))
        show.send(wire.PlayClip, "one", "moves", seconds=0.0, start=start, speed=speed)
        show.send(wire.RecordClip, "one", "line1", ["head"], "head", start=start, speed=speed)
        played = [state.gaze[0] for state in show.states(1.5 / speed)]
        show.send(wire.KeepPass, "one")
        return show.session.clips.clips["line1"].lanes[1], played

    def yaw(curve: MotionCurve, part: str, at: float) -> float:
        return float(curve.values(at)[curve.layout.columns.index(f"{part}/yaw")])

    (whole, _), (slow, played) = kept(1.0), kept(speed)
    assert (slow.start, slow.stop) == pytest.approx((start, start + 1.5), abs=1e-9)
    for at in np.arange(start + 0.05, start + 1.5, 0.0173):  # at its first frame a pass has what the first tick showed
        assert yaw(slow.curve, "head", at) == pytest.approx(yaw(whole.curve, "head", at), abs=CURVE)
    (below,) = swinging("gaze", rate).lanes
    for tick, gaze in enumerate(played, 1):
        if tick / 60 > show_clips.MEETING_SECONDS:
            assert gaze == pytest.approx(yaw(below.curve, "gaze", start + tick / 60 * speed), abs=1e-9)


def test_a_pass_at_half_speed_hears_no_sound_and_says_so(cast: Cast) -> None:
    show = Show(cast)
    show.session.set_sounds({"line": 2.0})
    show.send(wire.RecordClip, "one", "line1", sound="line", speed=0.5)
    assert "without its sound: it plays at the speed 0.5, its sound at 1 alone" in show.session.lost[-1]
    show.run(0.5)
    assert show.session.tick(show.now).characters["one"].speech is None
    show.send(PlaySound, "one", "line", seconds=0.0)
    show.send(wire.KeepPass, "one")
    assert show.session.tick(show.now).characters["one"].speech is not None, "what else is heard goes on"
    clip = show.session.clips.clips["line1"]
    assert (clip.sound, clip.sound_at) == ("line", 0.0)
    assert clip.seconds == pytest.approx(0.25, abs=1e-9)
    show.send(wire.RecordClip, "one", "line1", ["brows"], speed=0.5)
    show.run(0.1)
    state = show.session.tick(show.now).characters["one"]
    assert [each.silent for each in state.clips] == ["the clip plays at the speed 0.5, its sound at 1 alone"]


@pytest.mark.parametrize("speed", [0.2, 1.5, float("nan")])
def test_a_pass_is_not_recorded_at_a_speed_that_nobody_can_play_along_with(cast: Cast, speed: float) -> None:
    show = Show(cast)
    assert "the speed of a pass is" in reason(show.send(wire.RecordClip, "one", "line1", speed=speed))
    assert show.session.clips.passes == {}


def test_consoles_are_told_at_what_speed_a_pass_is_recorded(cast: Cast) -> None:
    show = Show(cast)
    show.send(wire.RecordClip, "one", "line1", speed=0.5)
    assert [each.speed for each in show.session.clips.work.passes] == [0.5]
