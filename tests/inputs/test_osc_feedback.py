"""What a surface is told: addresses that the show itself would obey, and only what is new."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.osc_addresses import read_order
from omote.inputs.osc_feedback import QUIET_SECONDS, Feedback, tell_state
from omote.inputs.osc_packet import OscMessage
from omote.perform.performer import Performer
from omote.show import messages as wire
from omote.show.session import ShowSession
from tests import synthetic


def test_all_that_is_told_can_be_sent_back_and_changes_nothing() -> None:
    cast = synthetic.cast()
    session = ShowSession(cast, Performer(cast))
    session.join("a", "Ana")
    for message in (wire.CallFace("1", "broad", 0.0, "smooth"), wire.SetChannel("smile", 0.5), wire.SetHead(0.1, 0, 0)):
        session.receive("a", message, 0.0)
    state = session.tick(0.0)
    for number, (address, values) in enumerate(tell_state(state, "one").items()):
        order = read_order(OscMessage(address, values), cast, f"c{number}")
        assert order is not None
        assert session.receive("a", order.message, 0.0) == []
    again = session.tick(5.0)
    assert (again.faces, again.channels, again.light) == (state.faces, state.channels, state.light)
    assert again.head == pytest.approx(state.head, abs=1e-5)


values = st.dictionaries(st.sampled_from("abc"), st.tuples(st.floats(0.0, 1.0)), max_size=3)


@given(st.lists(values, max_size=8))
def test_who_follows_the_news_knows_all_that_has_a_value(states: list[dict[str, tuple[float]]]) -> None:
    feedback, known = Feedback(), dict[str, object]()
    for number, state in enumerate(states):
        news = feedback.news(state, float(number))
        assert all(known.get(address) != told for address, told in news.items())
        known |= news
        assert {address: told for address, told in known.items() if told != (0.0,)} == {
            address: told for address, told in state.items() if told != (0.0,)
        }


def test_an_address_that_a_hand_moves_is_told_once_the_hand_rests() -> None:
    feedback = Feedback()
    feedback.note("a", 0.0)
    assert feedback.news({"a": (1.0,)}, 0.5 * QUIET_SECONDS) == {}
    assert feedback.news({"a": (1.0,)}, 1.5 * QUIET_SECONDS) == {"a": (1.0,)}
