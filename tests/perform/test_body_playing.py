"""Poses and bodies are called as expressions and faces are."""

from __future__ import annotations

import pytest

import omote
from omote.perform.figures.figure_axes import FACES_OWN

CAST = omote.load_cast()


def test_poses_are_called_interrupted_and_held_as_expressions_are() -> None:
    performer = omote.Performer(CAST)
    assert performer.advance(0.1).figure is None
    performer.call_pose("bow", seconds=1.0)
    before = performer.advance(0.4).figure.poses["bow"]
    rate = (performer.advance(1 / 240).figure.poses["bow"] - before) * 240
    performer.call_pose("wave", seconds=1.0)
    here = performer.advance(0.0).figure.poses["bow"]
    after = (performer.advance(1 / 240).figure.poses["bow"] - here) * 240
    assert after == pytest.approx(rate, rel=0.1)  # it goes on at its speed
    performer.call_pose("point", seconds=0.0, region="arm_right")
    figure = performer.advance(2.0).figure
    assert (figure.poses, figure.regions) == ({"wave": 1.0}, {"arm_right": {"point": 1.0}})
    restored = omote.Performer.restored(CAST, performer.snapshot())
    assert restored.advance(0.5) == performer.advance(0.5)
    performer.call_body("heavy", seconds=1.0)
    performer.call_body("own", seconds=0.0)
    assert performer.advance(0.0).figure.bodies == {FACES_OWN: 1.0}
    elsewhere = omote.Performer(CAST)
    elsewhere.call_pose("bow", seconds=0.5)
    elsewhere.call_pose("stand", seconds=0.5)
    assert elsewhere.advance(2.0).figure is None  # at rest as if nothing had been called
    performer.panic()
    still = performer.advance(1.0).figure
    assert still == performer.advance(1.0).figure
    for wrong in ({"name": "jump"}, {"name": "bow", "region": "tail"}, {"name": "bow", "seconds": -1.0}):
        with pytest.raises(ValueError, match=r"pose|region|seconds"):
            performer.call_pose(**wrong)
    with pytest.raises(ValueError, match="body"):
        performer.call_body("teapot")
