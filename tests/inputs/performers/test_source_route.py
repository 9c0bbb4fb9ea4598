"""What a page chooses becomes the route of its source, as far as the show allows it."""

from __future__ import annotations

import pytest

from omote.inputs.performers.hand_input import HAND
from omote.inputs.performers.source_route import SourceChoice, route_source
from omote.inputs.trackers.tracker_frame import TrackerFrame
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.perform.layers.layer_names import LAYER_PARTS
from omote.show.session import ShowSession
from tests import synthetic


@pytest.fixture
def session() -> ShowSession:
    return ShowSession(synthetic.cast())


def test_a_source_plays_what_was_chosen_where_it_is_there(session: ShowSession) -> None:
    trackers = TrackerInput(HAND, lambda: session)
    chosen = SourceChoice(["one"], ["mouth", "head"])
    assert route_source(session, trackers, "Ada", chosen, 0.0) == ""
    assert session.sources.route("Hand Ada").characters == ()
    trackers.note("", TrackerFrame({"jawOpen": 0.5}, subject="Ada"))
    trackers.play(0.0)
    assert route_source(session, trackers, "Ada", chosen, 0.0) == ""
    route = session.sources.route("Hand Ada")
    assert (route.characters, route.layer, route.parts) == (("one",), "tracker", ("mouth", "head"))
    assert route_source(session, trackers, "Ada", SourceChoice([]), 0.0) == ""
    assert session.sources.route("Hand Ada").parts == LAYER_PARTS
    assert "two" in route_source(session, trackers, "Ada", SourceChoice(["two"]), 0.0)
