"""What a surface is told: addresses that the show itself would obey, and only what is new."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.osc_feedback import QUIET_SECONDS, AddressValues, Feedback, tell_state
from omote.inputs.osc_orders import OrderReader
from omote.inputs.osc_packet import OscMessage
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace
from omote.show.objects.characters import AddCharacter
from omote.show.objects.faders import SetChannel, SetHead
from omote.show.objects.layers import SetLayer
from omote.show.objects.link import Hello
from omote.show.objects.motion import SetSpring
from omote.show.objects.pictures import CallBlack, CallFraming
from omote.show.session import ShowSession
from tests import synthetic


def test_all_that_is_told_can_be_sent_back_and_changes_nothing() -> None:
    cast = synthetic.cast()
    session = ShowSession(cast)
    session.join("a", "Ana")
    for message in (
        CallFace("one", "1", "broad", 0.0, "smooth"),
        AddCharacter("2", "two", "Two", "long"),
        CallExpression("one", "4", "smile", 0.0, "smooth", "mouth"),
        SetChannel("two", "jawOpen", 0.25),
        CallFraming("3", ["two", "one"], 0.0, "smooth"),
        CallBlack(0.5, 0.0),
        SetChannel("one", "smile", 0.5),
        SetHead("one", 0.1, 0, 0),
        SetLayer("one", "tracker", "mouth", 0.5, on=False),
        SetSpring("one", "jowls-sway", 0.25),
    ):
        session.receive("a", message, 0.0)
    state = session.tick(0.0)
    for number, (address, values) in enumerate(tell_state(state).items()):
        orders = OrderReader(cast, {"one": "One", "two": "Two"}).read(OscMessage(address, values), f"c{number}")
        assert len(orders) == 1
        assert session.receive("a", orders[0], 0.0) == []
    again = session.tick(5.0)
    assert (again.characters["one"].faces, again.characters["one"].channels, again.light, again.black) == (
        state.characters["one"].faces,
        state.characters["one"].channels,
        state.light,
        0.5,
    )
    assert again.characters["one"].springs == {"jowls-sway": 0.25}
    assert again.characters["one"].regions == {"mouth": {"smile": 1.0}}
    assert (again.characters["two"], again.framing) == (state.characters["two"], {"one+two": 1.0})
    assert again.characters["one"].head == pytest.approx(state.characters["one"].head, abs=1e-5)


def test_a_region_is_told_what_it_shows_its_own_or_that_of_the_face() -> None:
    session = ShowSession(synthetic.cast())
    session.join("a", "Ana")

    def told() -> dict[str, object]:
        own = "/omote/one/expression"
        values = tell_state(session.tick(0.0))
        return {address.removeprefix(own): value for address, (value, *_) in values.items() if address.startswith(own)}

    assert told() == dict.fromkeys(["", "/brows", "/eyes", "/mouth", "/rest"], "neutral")
    session.receive("a", CallExpression("one", "1", "jawOpen", 1.0, "smooth", "mouth"), 0.0)
    session.receive("a", CallExpression("one", "2", "smile", 0.0, "smooth", "brows"), 0.0)
    assert told() == {"": "neutral", "/brows": "smile", "/eyes": "neutral", "/mouth": "jawOpen", "/rest": "neutral"}


values = st.dictionaries(st.sampled_from("abc"), st.tuples(st.floats(0.0, 1.0)), max_size=3)


@given(st.lists(values, max_size=8))
def test_who_follows_the_news_knows_all_that_has_a_value(states: list[dict[str, tuple[float]]]) -> None:
    feedback = Feedback()
    known = dict[str, object]()
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


def test_on_air_tells_each_address_as_the_whole_list_does() -> None:
    session = ShowSession(synthetic.cast())
    session.receive("a", Hello("console", PROTOCOL_VERSION), 0.0)
    session.receive("a", SetChannel("one", "jawOpen", 0.25), 0.0)
    session.receive("a", SetHead("one", 0.5, 0.25, 0.0), 0.0)
    session.receive("a", SetLayer("one", "tracker", "mouth", 0.5, on=False), 0.0)
    state = session.tick(0.1)
    on_air = AddressValues(state)
    told = tell_state(state)
    assert {path: on_air.get(path) for path in told} == told
    assert {path: on_air.get(path.replace("/one/", "/*/")) for path in told} == told
    assert on_air.get("/omote/one/channel/smile") == (0.0,)
    assert on_air.get("/omote/one/layer/tracker/mouth") == (0.5,)
    assert on_air.get("/omote/one/layer_on/tracker") == (0.0,), "its switch, not its influence"
    assert on_air.get("/omote/one/layer_on/lips") == (1.0,)


@pytest.mark.parametrize("path", ["/omote/two/head", "/omote/one/panic", "/omote/one/expression/nose", "/omote/panic"])
def test_what_has_no_value_on_air_is_told_as_the_default(path: str) -> None:
    assert AddressValues(ShowSession(synthetic.cast()).tick(0.0)).get(path) == ()
    assert AddressValues().get(path, (1.0,)) == (1.0,)


def test_on_air_tells_an_address_by_label_as_by_name() -> None:
    session = ShowSession(synthetic.cast())
    session.join("a", "Ana")
    session.receive("a", AddCharacter("1", "two", "Big Rex", "long"), 0.0)
    session.receive("a", SetChannel("two", "jawOpen", 0.25), 0.0)
    assert AddressValues(session.tick(0.0)).get("/omote/big_rex/channel/jawOpen") == (0.25,)
