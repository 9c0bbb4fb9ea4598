"""Runs of clips: how much shows of each as time goes, and who makes way for whom."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.clip_runs import ClipRun, advance_run, advance_runs, check_runs, run_of, stopped
from tests.perform.clips.curves import curve

CLIP = Clip([Lane(curve(1))], blend_in=0.25, blend_out=0.5)


def run(**options: object) -> ClipRun:
    usual = {"seconds": None, "start": 0.0, "speed": None, "loop": None, "weights": None, "number": 1}
    return run_of(CLIP, "a", **{**usual, **options})  # type: ignore[arg-type]


@given(
    steps=st.lists(st.sampled_from([0.0, 1 / 64, 1 / 8, 1 / 2]), max_size=12), speed=st.sampled_from([0.5, 1.0, 2.0])
)
def test_one_long_step_lands_where_many_short_ones_do(steps: list[float], speed: float) -> None:
    for loop in (False, True):
        begun = run(speed=speed, loop=loop)
        many = begun
        for step in steps:
            many = advance_run(many, step)
        assert many == advance_run(begun, sum(steps))


def test_it_comes_and_goes_within_its_own_time() -> None:
    shares = [advance_run(run(), at).share for at in (0.0, 0.125, 0.25, 1.0, 1.5, 1.75, 2.0)]
    assert shares == [0.0, 0.5, 1.0, 1.0, 1.0, 0.5, 0.0]
    assert advance_runs((run(),), 2.0) == ()
    gone = advance_run(stopped(advance_run(run(), 1.0), 0.25), 0.125)
    assert gone.share == 0.5
    assert stopped(gone, 9.0) is gone
    assert stopped(run(seconds=0.0), 0.0).share == 0.0


def test_an_older_clip_is_over_once_a_newer_one_shows_altogether_in_its_parts() -> None:
    both = (run(), replace(run(weights={"mouth": 1.0, "brows": 0.5}), number=2))
    coming = advance_runs(both, 0.125)
    assert [each.weights for each in coming] == [each.weights for each in both]
    come = advance_runs(both, 0.5)
    assert set(come[0].weights) == {"brows", "eyes", "rest", "head", "gaze"}
    assert advance_runs((*both, replace(run(), number=3)), 0.5)[0].number == 3


def test_what_is_paused_stands() -> None:
    held = replace(advance_run(run(), 0.5), pace=0.0)
    assert advance_run(held, 5.0) is held
    assert advance_run(replace(held, pace=0.5), 0.5).position == 0.75


def test_what_no_performer_played_is_rejected() -> None:
    assert check_runs((run(),)) == (run(),)
    for wrong in ({"speed": 0.0}, {"position": -1.0}, {"weights": {"mouth": 2.0}}, {"pace": 2.0}, {"blend_in": -1.0}):
        with pytest.raises(ValueError, match=r"expected|give"):
            check_runs((replace(run(), **wrong),))
    with pytest.raises(ValueError, match="plays 9 clips"):
        check_runs((run(),) * 9)
