"""Poses and bodies are called as expressions and faces are."""

from __future__ import annotations

import pytest

import omote
from omote.perform.figures.figure_axes import FACES_OWN
from omote.perform.frame import FigureFrame

CAST = omote.load_cast()


def figure_after(performer: omote.Performer, seconds: float) -> FigureFrame:
    figure = performer.advance(seconds).figure
    assert figure is not None
    return figure


def test_poses_are_called_interrupted_and_held_as_expressions_are() -> None:
    performer = omote.Performer(CAST)
    assert performer.advance(0.1).figure is None
    performer.call_pose("bow", seconds=1.0)
    before = figure_after(performer, 0.4).poses["bow"]
    rate = (figure_after(performer, 1 / 240).poses["bow"] - before) * 240
    performer.call_pose("wave", seconds=1.0)
    here = figure_after(performer, 0.0).poses["bow"]
    after = (figure_after(performer, 1 / 240).poses["bow"] - here) * 240
    assert after == pytest.approx(rate, rel=0.1)  # it goes on at its speed
    performer.call_pose("point", seconds=0.0, region="arm_right")
    figure = figure_after(performer, 2.0)
    assert (figure.poses, figure.regions) == ({"wave": 1.0}, {"arm_right": {"point": 1.0}})
    restored = omote.Performer.restored(CAST, performer.snapshot())
    assert restored.advance(0.5) == performer.advance(0.5)
    performer.call_body("heavy", seconds=1.0)
    performer.call_body("own", seconds=0.0)
    assert figure_after(performer, 0.0).bodies == {FACES_OWN: 1.0}
    elsewhere = omote.Performer(CAST)
    elsewhere.call_pose("bow", seconds=0.5)
    elsewhere.call_pose("stand", seconds=0.5)
    assert elsewhere.advance(2.0).figure is None  # at rest as if nothing had been called
    performer.panic()
    still = performer.advance(1.0).figure
    assert still == performer.advance(1.0).figure
    for name, region, seconds in (("jump", None, 1.0), ("bow", "tail", 1.0), ("bow", None, -1.0)):
        with pytest.raises(ValueError, match=r"pose|region|time"):
            performer.call_pose(name, region=region, seconds=seconds)
    with pytest.raises(ValueError, match="body"):
        performer.call_body("teapot")
