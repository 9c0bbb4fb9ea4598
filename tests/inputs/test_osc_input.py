"""Senders and surfaces of OSC at a show, without a socket."""

import math
from collections.abc import Callable

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.inputs.osc_input import (
    ERROR,
    MOST_SENDERS,
    MOST_SURFACES,
    SURFACE_SECONDS,
    Endpoint,
    OscInput,
)
from omote.inputs.osc_packet import Argument, OscMessage, decode_packet, encode_bundle, encode_message
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import Panic
from omote.show.objects.characters import AddCharacter
from omote.show.objects.cues import Go, PauseCues, PutCue
from omote.show.objects.faders import Hands, SetChannel
from omote.show.objects.leases import Lease, SetLeases
from omote.show.objects.link import Hello
from omote.show.objects.stages import Crew
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from tests import synthetic

DESK: Endpoint = ("10.0.0.5", 9001)
Send = Callable[..., list[tuple[Endpoint, bytes]]]


@pytest.fixture
def session() -> ShowSession:
    return ShowSession(synthetic.cast())


@pytest.fixture
def osc(session: ShowSession) -> OscInput:
    return OscInput(lambda: session)


@pytest.fixture
def send(osc: OscInput) -> Send:
    return lambda address, *arguments, place=DESK, now=0.0: osc.receive(place, encode_message(address, *arguments), now)


def told(news: list[tuple[Endpoint, bytes]], place: Endpoint = DESK) -> dict[str, tuple[Argument, ...]]:
    messages = [message for to, packet in news if to == place for message in decode_packet(packet)]
    return {message.address: message.arguments for message in messages}


def test_a_surface_is_told_which_cue_was_called_which_stands_by_and_that_cues_are_paused(
    session: ShowSession, osc: OscInput, send: Send
) -> None:
    """What colours the buttons of a Stream Deck; a show without cues tells nothing of them."""
    session.receive("a", Hello("console", PROTOCOL_VERSION, "Ana"), 0.0)
    send("/omote/subscribe")
    assert not {"/omote/go", "/omote/standby", "/omote/pause"} & told(osc.news(session.tick(0.1), 0.1)).keys()
    for number in ("1", "12.5"):
        session.receive("a", PutCue(f"p{number}", number=number), 0.2)
    news = told(osc.news(session.tick(0.2), 0.2))
    cues = {"/omote/go": ("",), "/omote/standby": ("1",), "/omote/pause": (0.0,), "/omote/cue_list": ("main",)}
    assert cues.items() <= news.items()
    session.receive("a", Go("g1"), 0.3)
    assert told(osc.news(session.tick(0.4), 0.4)) == {"/omote/go": ("1",), "/omote/standby": ("12.5",)}
    session.receive("a", PauseCues("g2"), 0.5)
    assert told(osc.news(session.tick(0.6), 0.6)) == {"/omote/pause": (1.0,)}


def test_a_sender_plays_and_consoles_see_whose_hand_it_is(session: ShowSession, send: Send) -> None:
    session.receive("a", Hello("console", PROTOCOL_VERSION, "Ana"), 0.0)
    send("/omote/one/face", "broad", 0.0)
    send("/omote/*/channel/jawOpen", 0.5)
    state = session.tick(0.1)
    assert (state.characters["one"].faces, state.characters["one"].channels) == ({"broad": 1.0}, {"jawOpen": 0.5})
    (hands,) = session.hands_now(0.1)
    assert hands.message == Hands({"one/set_channel:jawOpen": "OSC 10.0.0.5"})
    assert session.crew_now(0.1) == Crew([], 1)


def test_the_same_call_twice_calls_twice(session: ShowSession, send: Send) -> None:
    for name in ("broad", "long", "broad"):
        send("/omote/one/face", name, 0.0)
    assert session.tick(0.0).characters["one"].faces == {"broad": 1.0}


@pytest.mark.parametrize("value", [math.nan, math.inf, 1.6, -0.6])
def test_a_value_out_of_range_is_rejected_and_counted(
    session: ShowSession, osc: OscInput, send: Send, value: float
) -> None:
    send("/omote/one/channel/jawOpen", value)
    assert session.tick(0.0).characters["one"].channels == {}
    assert (osc.heard, osc.rejected) == (1, 1)
    assert osc.last_rejection is not None
    assert osc.last_rejection.reason.startswith("/omote/one/channel/jawOpen: ")


def test_of_a_bundle_each_message_stands_for_itself(session: ShowSession, osc: OscInput) -> None:
    packets = [encode_message("/omote/one/channel/nose", 1.0), encode_message("/omote/one/channel/jawOpen", 1.0)]
    osc.receive(DESK, encode_bundle(packets), 0.0)
    assert (session.tick(0.0).characters["one"].channels, osc.rejected) == ({"jawOpen": 1.0}, 1)


def test_a_character_that_there_is_not_is_said(osc: OscInput, send: Send) -> None:
    send("/omote/bob/face", "broad")
    assert osc.last_rejection is not None
    assert osc.last_rejection.reason == "there is no character 'bob' in this scene, which has one, and * for all"


@pytest.mark.parametrize(
    ("packet", "name"),
    [
        (encode_message("/VMC/Ext/Blend/Val", "JawOpen", 0.5), "vmc"),
        (encode_bundle([encode_message("/VMC/Ext/Blend/Apply")]), "vmc"),
        (b"jawOpen&50|smile&20|=head#0,5,0|", "ifacialmocap"),
    ],
)
def test_what_is_of_a_tracker_is_told_the_port_where_that_is_heard(osc: OscInput, packet: bytes, name: str) -> None:
    osc.receive(DESK, packet, 0.0)
    assert osc.last_rejection is not None
    assert f"--listen {name}" in osc.last_rejection.reason
    osc.port_of = {name: 8371}.get
    osc.receive(DESK, packet, 0.0)
    assert osc.last_rejection.reason.endswith("is heard at port 8371: send it there")


def test_a_surface_hears_everything_once_then_what_is_new(session: ShowSession, osc: OscInput, send: Send) -> None:
    send("/omote/subscribe", 9001)
    first = told(osc.news(session.tick(0.0), 0.0))
    assert first["/omote/one/face"] == ("generic",)
    assert first["/omote/light"] == ("theatre",)
    assert first["/omote/one/head"] == (0.0, 0.0, 0.0)
    assert osc.news(session.tick(0.1), 0.1) == []
    send("/omote/one/channel/jawOpen", 0.5, place=("10.0.0.6", 5), now=0.1)
    assert told(osc.news(session.tick(0.2), 0.2)) == {"/omote/one/channel/jawOpen": (0.5,)}
    send("/omote/one/channel/jawOpen", 0.0, place=("10.0.0.6", 5), now=0.2)
    assert told(osc.news(session.tick(0.3), 0.3)) == {"/omote/one/channel/jawOpen": (0.0,)}
    assert osc.news(session.tick(0.4), 0.4) == []


def test_a_surface_is_not_told_what_it_sends_while_it_sends_it(session: ShowSession, osc: OscInput, send: Send) -> None:
    send("/omote/subscribe")
    osc.news(session.tick(0.0), 0.0)
    send("/omote/one/channel/jawOpen", 0.5, now=0.1)
    assert osc.news(session.tick(0.2), 0.2) == []
    assert told(osc.news(session.tick(1.0), 1.0)) == {"/omote/one/channel/jawOpen": (0.5,)}


def test_a_surface_may_send_from_another_port_than_it_hears_at(session: ShowSession, osc: OscInput, send: Send) -> None:
    sends = ("10.0.0.5", 51234)
    hears = DESK
    send("/omote/subscribe", hears[1], place=sends)
    osc.news(session.tick(0.0), 0.0)
    assert list(told(send("/omote/one/face", "nobody", place=sends), hears)) == [ERROR]
    last = SURFACE_SECONDS - 1.0
    send("/omote/one/channel/jawOpen", 0.5, place=sends, now=last)
    assert osc.news(session.tick(last), last) == [], "its fader is in a hand"
    later = SURFACE_SECONDS + 1.0
    assert told(osc.news(session.tick(later), later), hears) == {"/omote/one/channel/jawOpen": (0.5,)}, "not silent"


def test_what_of_a_bundle_is_no_message_costs_itself_and_is_said_once(session: ShowSession, osc: OscInput) -> None:
    jaw = encode_message("/omote/one/channel/jawOpen", 1.0)
    osc.receive(DESK, encode_bundle([b"hello", b"/a\0\0,q\0\0", jaw, b"/"]), 0.0)
    assert (session.tick(0.0).characters["one"].channels, osc.heard, osc.rejected) == ({"jawOpen": 1.0}, 1, 1)
    assert osc.last_rejection is not None
    assert "begins with b'hello'" in osc.last_rejection.reason
    assert "2 more" in osc.last_rejection.reason


def test_a_surface_hears_why_something_was_rejected_and_others_do_not(osc: OscInput, send: Send) -> None:
    assert send("/omote/one/face", "nobody") == []
    send("/omote/subscribe")
    assert list(told(send("/omote/one/face", "nobody"))) == [ERROR]
    send("/omote/unsubscribe")
    assert send("/omote/one/face", "nobody") == []


def test_a_silent_surface_is_told_no_more_but_for_a_lasting_one(session: ShowSession, osc: OscInput) -> None:
    lasting = ("10.0.0.9", 9)
    osc.subscribe(DESK, 0.0)
    osc.subscribe(lasting, 0.0, lasting=True)
    later = SURFACE_SECONDS + 1.0
    assert {place for place, _ in osc.news(session.tick(later), later)} == {lasting}


def test_surfaces_are_told_on_after_a_restart_until_they_were_silent_for_as_long_as_before(
    session: ShowSession, osc: OscInput, send: Send
) -> None:
    silent, gone, connection = ("10.0.0.6", 9001), ("10.0.0.7", 9001), ("10.0.0.8#1", 0)
    for place in (DESK, silent, gone, connection):
        send("/omote/subscribe", place=place)
    osc.subscribe(("10.0.0.9", 9), 0.0, lasting=True)  # the next process is told by its options
    last = SURFACE_SECONDS - 1.0
    send("/omote/one/channel/jawOpen", 0.5, now=last)
    send("/omote/unsubscribe", place=gone)
    written = msgspec.msgpack.encode(session.snapshot())
    snapshot, _ = read_session_snapshot(msgspec.msgpack.decode(written))

    def told_at(now: float, *, allows: Callable[[str], bool] = lambda _: True) -> set[Endpoint]:
        after = ShowSession.restored(session.cast, snapshot, epoch=2)
        resumed = OscInput(lambda: after)
        resumed.resume(now, allows)
        errors = resumed.receive(DESK, encode_message("/omote/one/face", "nobody"), now)
        assert list(told(errors)) == ([ERROR] if allows(DESK[0]) and now > 0.0 else [])
        return {place for place, _ in resumed.news(after.tick(now), now)}

    assert told_at(last + 0.5) == {DESK, silent}
    assert told_at(last + 3.0) == {DESK}
    assert told_at(last + 0.5, allows=lambda host: host == silent[0]) == {silent}
    assert told_at(-1.0) == set(), "the machine was started anew, and its clock with it"


@pytest.mark.parametrize("port", [0, -1, 65536, 1.5, "9001", math.nan, math.inf])
def test_a_port_that_cannot_be_is_rejected(osc: OscInput, send: Send, port: Argument) -> None:
    send("/omote/subscribe", port)
    assert osc.last_rejection is not None
    assert "expected a port" in osc.last_rejection.reason


def test_neither_senders_nor_surfaces_pile_up(session: ShowSession, osc: OscInput, send: Send) -> None:
    for number in range(3 * MOST_SENDERS):
        send("/omote/subscribe", place=(f"10.0.0.{number}", 9))
        send("/omote/one/channel/jawOpen", 0.5, place=(f"10.0.0.{number}", 9))
    assert len(session.crew) == MOST_SENDERS
    assert len({place for place, _ in osc.news(session.tick(0.0), 0.0)}) == MOST_SURFACES


def test_a_connection_that_is_gone_leaves_the_show(session: ShowSession, osc: OscInput, send: Send) -> None:
    place = ("10.0.0.5#1", 0)
    send("/omote/subscribe", place=place)
    send("/omote/one/channel/jawOpen", 0.5, place=place)
    osc.leave(place)
    assert session.crew == {}
    assert osc.news(session.tick(0.0), 0.0) == []


def test_whatever_comes_the_state_stays_whole(session: ShowSession, osc: OscInput) -> None:
    rng = np.random.default_rng(2)
    whole = [
        encode_message("/omote/one/face", "broad", 0.5), encode_message("/omote/one/head", 10.0, 20, 3),
        encode_message("/omote/*/channel/smile", 0.5), encode_message("/omote/one/fade/face", 0.5),
        encode_message("/omote/subscribe", 9001), encode_message("/omote/panic"),
    ]  # fmt: skip
    for number in range(5_000):
        data = bytearray(whole[rng.integers(len(whole))])
        for _ in range(rng.integers(0, 4)):
            data[rng.integers(len(data))] = rng.integers(256)
        osc.receive(DESK, bytes(data), number / 100)
        state = session.tick(number / 100)
        assert math.fsum(state.characters["one"].faces.values()) == pytest.approx(1.0)
        assert all(
            map(
                math.isfinite,
                [
                    *state.characters["one"].channels.values(),
                    *state.characters["one"].head,
                    *state.characters["one"].gaze,
                    *state.characters["one"].eyes,
                ],
            )
        )
    assert osc.rejected > 500


weights = st.one_of(st.floats(-0.5, 1.5), st.sampled_from([0.0, 9.0]))
played = st.one_of(
    st.builds(
        lambda who, name, weight: OscMessage(f"/omote/{who}/channel/{name}", (weight,)),
        st.sampled_from(["one", "two", "*", "nobody"]),
        st.sampled_from(["jawOpen", "smile", "neutral", "nothing"]),
        weights,
    ),
    st.builds(lambda yaw: OscMessage("/omote/one/head", (yaw, 0.0, 0.0)), st.sampled_from([5.0, 200.0])),
    st.just(OscMessage("/omote/one/panic")),
)


def play(ticks: list[list[OscMessage]], *, at_once: bool, panicked: bool, held: bool) -> dict[str, object]:
    """What a show has come to after some ticks. panicked: another console has just pressed panic of all; held: it holds
    the channels of one character."""
    show = ShowSession(synthetic.cast())
    show.receive("a", Hello("console", PROTOCOL_VERSION, "Ana"), 0.0)
    show.receive("a", AddCharacter("add", "two", "Two", "generic"), 0.0)
    if held:
        show.receive("a", SetLeases("on", True), 0.0)
        show.receive("a", SetChannel("two", "smile", 0.5), 0.0)
    osc = OscInput(lambda: show)
    told = list[object]()
    osc.subscribe(DESK, 0.0)
    for number, messages in enumerate(ticks):
        now = 0.2 * number
        if panicked and number == 1:
            show.receive("a", Panic("*"), now)
        answers = (
            osc.obey_all(DESK, messages, now) if at_once else [a for m in messages for a in osc.obey(DESK, m, now)]
        )
        told += [answers, show.tick(now), show.hands_now(now), osc.news(show.tick(now), now)]
    return {"snapshot": show.snapshot(), "told": told, "counts": (osc.heard, osc.rejected), "newest": osc.newest}


@settings(max_examples=40)
@given(st.lists(st.lists(played, max_size=8), min_size=2, max_size=5), st.booleans(), st.booleans())
def test_channels_that_are_set_at_once_do_what_they_do_one_by_one(
    ticks: list[list[OscMessage]], panicked: bool, held: bool
) -> None:
    one_by_one = play(ticks, at_once=False, panicked=panicked, held=held)
    at_once = play(ticks, at_once=True, panicked=panicked, held=held)
    assert at_once == one_by_one


def test_a_sender_holds_takes_over_and_releases_as_an_operator_does(
    session: ShowSession, osc: OscInput, send: Send
) -> None:
    session.receive("a", Hello("console", PROTOCOL_VERSION, "Ana", "page", "ana"), 0.0)
    session.receive("a", SetLeases("on", True), 0.0)
    session.receive("a", Lease("l", "one", "face"), 0.0)
    send("/omote/one/lease/face")
    assert osc.last_rejection is not None
    assert ": Ana holds the face of one: take it over" in osc.last_rejection.reason
    send("/omote/one/take_over/face", 1.0)
    send("/omote/lease/light")
    held = {key: session.leasing.seats[seat].name for key, seat in session.leasing.table.held.items()}
    assert set(held) == {"one/face", "*/light"}
    assert all(name.startswith("OSC ") for name in held.values())
    send("/omote/one/take_over/face", 0.0)  # let go: nothing
    send("/omote/release_lease/all")
    assert session.leasing.table.held == {}
