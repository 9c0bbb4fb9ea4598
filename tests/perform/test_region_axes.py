"""Calls in one region of the face: each region plays as a whole face would that was called likewise."""

import math
from dataclasses import replace
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS, PlayRegion
from omote.perform.frame import Frame
from omote.perform.performer import Performer
from omote.perform.snapshot import Snapshot
from tests.conftest import Command, calls, regional_calls

timed_calls = st.one_of(calls, regional_calls).filter(lambda each: each.seconds != math.inf)


def shown(frame: Frame, region: PlayRegion) -> dict[str, float]:
    return dict(frame.regions.get(region, frame.expressions))


@given(st.lists(timed_calls, max_size=12))
def test_a_region_plays_as_a_whole_face_that_is_called_likewise(cast: Cast, show: list[Command]) -> None:
    performer, alone = Performer(cast), {region: Performer(cast) for region in PLAY_REGIONS}
    whole = Performer(cast)
    for command in show:
        command.play(performer)
        for region, other in alone.items():
            if command.region in (None, region):
                replace(command, region=None).play(other)
        if command.region is None:
            command.play(whole)
        frame = performer.advance(command.wait)
        rest = whole.advance(command.wait)
        assert (frame.expressions, frame.faces, frame.expression_call) == (
            rest.expressions, rest.faces, rest.expression_call,
        )  # fmt: skip
        for region, other in alone.items():
            assert shown(frame, region) == dict(other.advance(command.wait).expressions)


@given(st.lists(timed_calls, max_size=8), regional_calls)
def test_a_call_of_the_whole_face_brings_its_regions_together(cast: Cast, show: list[Command], last: Command) -> None:
    performer = Performer(cast)
    for command in [*show, last]:
        command.play(performer)
        performer.advance(command.wait)
    performer.call_expression("smile", seconds=0.5)
    frame = performer.advance(10.0)
    assert (frame.expressions, frame.regions, frame.region_calls) == ({"smile": 1.0}, {}, {})
    assert performer.snapshot().regions == {}


def test_a_region_that_comes_to_show_what_the_face_does_goes_with_it(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=1.0, region="mouth")
    assert performer.advance(0.4).region_calls["mouth"].remaining == pytest.approx(0.6)
    assert shown(performer.advance(1.0), "mouth") == {"smile": 1.0}
    assert performer.advance(0.0).region_calls == {}
    performer.call_expression("neutral", seconds=1.0, region="mouth")
    assert performer.advance(1.0).regions == {}


def test_the_t_bar_moves_regions_that_were_called_with_the_face_and_passes_others_by(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=0.0, region="mouth")
    performer.call_expression("jawOpen", seconds=math.inf)
    performer.call_expression("browInnerUp", seconds=2.0, region="brows")
    performer.fade_expression(0.5)
    frame = performer.advance(1.0)
    assert frame.expressions == pytest.approx({"neutral": 0.5, "jawOpen": 0.5})
    assert shown(frame, "mouth") == pytest.approx({"smile": 0.5, "jawOpen": 0.5})
    assert frame.region_calls["brows"].by_hand is False
    assert frame.region_calls["brows"].remaining == pytest.approx(1.0)
    performer.fade_expression(1.0)
    frame = performer.advance(1.0)
    assert shown(frame, "mouth") == shown(frame, "rest") == {"jawOpen": 1.0}
    assert shown(frame, "brows") == {"browInnerUp": 1.0}


def test_a_bar_left_at_its_far_end_begins_the_next_call_of_all_regions_there(cast: Cast) -> None:
    """Its end is the start of a call for regions too, whichever end it was when they were called alone."""
    performer = Performer(cast)
    performer.call_expression("smile", seconds=0.0, region="mouth")
    performer.fade_expression(1.0)
    performer.call_expression("jawOpen", seconds=math.inf)
    performer.fade_expression(0.5)
    frame = performer.advance(1.0)
    assert shown(frame, "mouth") == pytest.approx({"smile": 0.5, "jawOpen": 0.5})
    assert shown(frame, "rest") == pytest.approx({"neutral": 0.5, "jawOpen": 0.5})


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"region": "nose"}, "there is no region 'nose' to play in; expected one of brows, eyes, mouth, rest"),
        ({"region": "mouth", "seconds": math.inf}, "the time of a call"),
        ({"region": "mouth", "easing": "jumpy"}, "jumpy"),
    ],
    ids=["no region", "by hand", "no easing"],
)
def test_a_call_in_a_region_that_cannot_be_is_refused_and_changes_nothing(
    cast: Cast, options: dict[str, Any], said: str
) -> None:
    performer = Performer(cast)
    before = performer.snapshot()
    with pytest.raises(ValueError, match=said):
        performer.call_expression("smile", **options)
    assert performer.snapshot() == before


def test_a_snapshot_of_a_region_that_is_none_is_refused(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", region="mouth")
    plain = msgspec.to_builtins(performer.snapshot())
    plain["regions"]["mouth"]["on_air"] = "nobody"
    with pytest.raises(ValueError, match="nobody"):
        Performer.restored(cast, msgspec.convert(plain, Snapshot))
    strange: Any = {"tail": performer.snapshot().expression}
    with pytest.raises(ValueError, match="no region 'tail'"):
        Performer.restored(cast, replace(performer.snapshot(), regions=strange))
