"""A whole show without a socket: messages and times in, messages and states out."""

import itertools
import math
from dataclasses import replace

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS
from omote.perform.frame import MotionSettings
from omote.perform.lights import LIGHTS
from omote.perform.limits import GAZE_LIMITS
from omote.perform.panic import PANIC_SECONDS
from omote.perform.scene.scene_snapshot import SceneSnapshot
from omote.show.crew.members import LOST_SECONDS, SILENCE
from omote.show.declaration import ClientMessage, FileRequest, KeepRequest, Outgoing
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import (
    CallExpression,
    CallFace,
    FadeExpression,
    FadeFace,
    Panic,
    ReleaseExpression,
    ReleaseFace,
    SetHome,
)
from omote.show.objects.characters import AddCharacter, EnterCharacter, PlaceCharacter, RemoveCharacter, RenameCharacter
from omote.show.objects.faders import Hands, SetChannel, SetGaze, SetHead
from omote.show.objects.items import DeleteItem, KeepExpression, KeepFace
from omote.show.objects.layouts import DropLayout, Layouts, RenameLayout, SetLayout
from omote.show.objects.link import Hello, Notice, Notices, Ping, Pong, Refused, Welcome
from omote.show.objects.motion import SetMotion
from omote.show.objects.pictures import CallBlack, CallFraming, CallLight
from omote.show.objects.stages import CastChanged, Crew, Drawing, StageReport
from omote.show.objects.state import Place
from omote.show.pad_list import list_pads
from omote.show.session import ShowSession
from omote.show.session_snapshot import SessionSnapshot
from omote.show.state import EYE_SECONDS
from omote.show.wire import encode
from tests import synthetic
from tests.synthetic import Recast

FRAME = 1.0 / 60.0

call = st.one_of(
    st.builds(
        CallFace,
        st.just("one"),
        st.uuids().map(str),
        st.sampled_from(synthetic.FACES),
        st.floats(0.0, 3.0),
        st.just("smooth"),
    ),
    st.builds(
        CallExpression,
        st.just("one"),
        st.uuids().map(str),
        st.sampled_from(synthetic.EXPRESSIONS),
        st.floats(0.0, 3.0),
        st.just("smooth"),
    ),
    st.builds(
        CallFace,
        st.just("one"),
        st.uuids().map(str),
        st.sampled_from(synthetic.FACES),
        st.none(),
        st.just("smooth"),
    ),
    st.builds(
        CallExpression,
        st.just("one"),
        st.uuids().map(str),
        st.sampled_from(synthetic.EXPRESSIONS),
        st.floats(0.0, 3.0),
        st.just("smooth"),
        st.sampled_from(PLAY_REGIONS),
    ),
    st.builds(CallLight, st.uuids().map(str), st.sampled_from([*LIGHTS]), st.floats(0.0, 3.0), st.just("smooth")),
)
command = st.one_of(
    call,
    st.builds(FadeFace, st.just("one"), st.floats(0.0, 1.0)),
    st.builds(FadeExpression, st.just("one"), st.floats(0.0, 1.0)),
    st.builds(SetChannel, st.just("one"), st.sampled_from(synthetic.EXPRESSIONS[1:]), st.floats(-0.5, 1.5)),
    st.builds(SetHead, st.just("one"), *[st.floats(-1.0, 1.0)] * 3),
    st.builds(SetGaze, st.just("one"), *(st.floats(-limit, limit) for limit in GAZE_LIMITS.values())),
    st.builds(CallBlack, st.floats(0.0, 1.0), st.floats(0.0, 3.0)),
    st.sampled_from([ReleaseFace("one"), ReleaseExpression("one"), Panic("one"), SetHome("one", "broad", 1.0)]),
)
wrong = st.one_of(
    st.builds(
        SetChannel,
        st.just("one"),
        st.text(min_size=1, max_size=20),
        st.sampled_from([math.nan, math.inf, -math.inf, 1.6, 1e308]),
    ),
    st.builds(SetHead, st.just("one"), *[st.sampled_from([math.nan, math.inf, 4.0])] * 3),
    st.builds(FadeFace, st.just("one"), st.sampled_from([math.nan, -0.001, 1.001, 1e308])),
    st.builds(CallFace, st.just("one"), st.just("x"), st.just("nobody"), st.just(1.0), st.just("smooth")),
    st.builds(
        CallFace,
        st.just("one"),
        st.just("x"),
        st.just("generic"),
        st.sampled_from([math.nan, -1.0, 1e9]),
        st.just("smooth"),
    ),
    st.builds(CallFace, st.just("one"), st.just("x"), st.just("generic"), st.just(1.0), st.just("jerky")),
    st.builds(CallLight, st.just("x"), st.sampled_from(["candle", "flat"]), st.just(-1.0), st.just("smooth")),
    st.builds(
        SetHome, st.just("one"), st.sampled_from(["nobody", "broad"]), st.sampled_from([math.nan, math.inf, -1.0])
    ),
    st.builds(
        CallExpression,
        st.just("one"),
        st.just("x"),
        st.just("smile"),
        st.sampled_from([None, math.inf, -1.0]),
        st.just("smooth"),
        st.sampled_from(PLAY_REGIONS),
    ),
    st.builds(CallBlack, st.sampled_from([math.nan, -0.1, 1.1]), st.just(1.0)),
    st.builds(CallBlack, st.just(1.0), st.sampled_from([math.inf, -1.0])),
    st.builds(Ping, st.sampled_from([math.nan, math.inf])),
)


def opened(cast: Cast, *consoles: str) -> ShowSession:
    """A session with these consoles."""
    session = ShowSession(cast, epoch=5)
    for who in consoles:
        session.receive(who, Hello("console", PROTOCOL_VERSION), 0.0)
    session.tick(0.0)
    return session


def reasons(outgoing: list[Outgoing]) -> list[str]:
    """The sentences of the refusals."""
    return [each.message.reason for each in outgoing if isinstance(each.message, Refused)]


def test_hello_is_answered_with_who_we_are(cast: Cast) -> None:
    session = ShowSession(cast, epoch=5, revision=2)
    welcome = Welcome(PROTOCOL_VERSION, 5, 2, cast.digest)
    assert session.receive("a", Hello("stage", PROTOCOL_VERSION), 0.0) == [Outgoing("a", welcome)]


def test_consoles_are_told_what_the_crew_must_know_and_stages_are_not(cast: Cast) -> None:
    session = ShowSession(cast)
    session.notices = [Notice("1", 1.7e9, "The show's process ended.")]
    told = [session.receive(role, Hello(role, PROTOCOL_VERSION), 0.0)[1:] for role in ("console", "stage")]
    pads = list_pads(session.scene.pads, cast)
    assert told == [[Outgoing("console", Notices(session.notices)), Outgoing("console", pads)], []]
    assert session.notices_for("console") == told[0][:1]


def test_a_page_of_another_version_is_told_to_reload(cast: Cast) -> None:
    session = opened(cast)
    assert "reload the page" in reasons(session.receive("a", Hello("console", 99), 0.0))[0]
    assert "before hello" in reasons(session.receive("a", Panic("one"), 0.0))[0]


def test_a_call_brings_its_face_on_air_in_its_time(cast: Cast) -> None:
    session = opened(cast, "a")
    assert session.receive("a", CallFace("one", "1", "broad", 2.0, "smooth"), 0.0) == []
    half = session.tick(1.0)
    done = session.tick(2.0)
    assert half.characters["one"].faces == pytest.approx({"generic": 0.5, "broad": 0.5})
    assert half.characters["one"].face_call is not None
    assert half.characters["one"].face_call.remaining == pytest.approx(1.0)
    assert done.characters["one"].faces == {"broad": 1.0}
    assert done.number == half.number + 1


def test_a_call_by_hand_waits_for_the_hand(cast: Cast) -> None:
    session = opened(cast, "a")
    session.receive("a", CallFace("one", "1", "broad", None, "smooth"), 0.0)
    assert session.tick(100.0).characters["one"].faces == {"generic": 1.0}
    session.receive("a", FadeFace("one", 0.0), 100.0)
    session.receive("a", FadeFace("one", 1.0), 100.0)
    assert session.tick(110.0).characters["one"].faces == {"broad": 1.0}


def test_an_id_executes_once(cast: Cast) -> None:
    session = opened(cast, "a", "b")
    first = CallFace("one", "same", "broad", 1.0, "smooth")
    session.receive("a", first, 0.0)
    session.tick(0.5)
    for _ in range(1000):
        assert session.receive("a", first, 0.5) == []
    assert session.commands == 1
    assert session.tick(1.0).characters["one"].faces == {"broad": 1.0}


def test_a_panic_that_comes_again_by_a_new_link_brings_no_home_face(cast: Cast) -> None:
    """A page whose link broke does not know whether its panic was heard; two presses are two panics."""
    session = opened(cast, "a", "b")
    session.receive("a", Panic("one", "page-1"), 0.0)
    session.receive("a", Panic("one", "page-1"), 0.1)
    assert session.tick(0.2).characters["one"].panics == 1
    session.receive("a", Panic("one", "page-2"), 0.3)
    assert session.tick(0.4).characters["one"].panics == 2


def test_a_fader_beside_a_retry_makes_no_call_execute_twice(cast: Cast) -> None:
    session = opened(cast, "a", "b")
    call = CallFace("one", "page-1", "broad", 0.0, "smooth")
    session.receive("a", call, 0.0)
    for number in range(600):
        session.receive("b", PlaceCharacter("one", 0.0, 0.0, 1.0, 0.0, 0.0, f"other-{number}"), 0.0)
        session.receive("a", PlaceCharacter("one", 0.0, 0.0, 1.0, 0.0, 0.0, f"page-{number + 2}"), 0.0)
    session.receive("a", CallFace("one", "page-700", "generic", 0.0, "smooth"), 0.0)
    session.receive("a", call, 0.0)
    assert session.tick(0.1).characters["one"].faces == {"generic": 1.0}


@given(messages=st.lists(st.tuples(st.sampled_from(["a", "b"]), command, st.floats(0.0, 0.5)), max_size=25))
def test_a_replayed_show_is_the_same_show(cast: Cast, messages: list[tuple[str, ClientMessage, float]]) -> None:
    shown = []
    for _ in range(2):
        session = opened(cast, "a", "b")
        now = 0.0
        states = []
        for who, message, wait in messages:
            now += wait
            session.receive(who, message, now)
            states.append(encode(session.tick(now)))
        shown.append(states)
    assert shown[0] == shown[1]


@given(messages=st.lists(st.tuples(st.sampled_from(["a", "b"]), command), max_size=25))
def test_consoles_agree_because_all_see_one_state(cast: Cast, messages: list[tuple[str, ClientMessage]]) -> None:
    mixed = opened(cast, "a", "b")
    alone = opened(cast, "a")
    for number, (who, message) in enumerate(messages):
        now = 2 * PANIC_SECONDS * number  # later than hands that cannot know of a panic
        mixed.receive(who, message, now)
        alone.receive("a", message, now)
    assert mixed.tick(FRAME) == alone.tick(FRAME)


@given(before=st.lists(command, max_size=5), bad=st.lists(wrong, min_size=1, max_size=10))
def test_a_refused_message_changes_nothing_and_says_why(
    cast: Cast, before: list[ClientMessage], bad: list[ClientMessage]
) -> None:
    session = opened(cast, "a")
    for message in before:
        session.receive("a", message, 0.0)
    left = session.snapshot()
    for message in bad:
        sentences = reasons(session.receive("a", message, 0.0))
        assert len(sentences) == 1
        assert sentences[0].endswith(".")
    assert session.snapshot() == left
    assert session.refused == len(bad)


@pytest.mark.parametrize(
    "call",
    [
        CallFace("one", "1", "generic", math.inf, "smooth"),
        CallExpression("one", "1", "smile", math.inf, "smooth"),
        CallLight("1", "flat", math.inf, "smooth"),
        CallFraming("1", [], math.inf, "smooth"),
    ],
    ids=lambda call: type(call).__name__,
)
def test_an_infinite_call_is_refused_since_nil_calls_by_hand(cast: Cast, call: ClientMessage) -> None:
    session = opened(cast, "a")
    (sentence,) = reasons(session.receive("a", call, 0.0))
    assert "inf" in sentence
    assert session.snapshot().executed == {}


@given(data=st.binary(max_size=100))
def test_noise_is_refused_and_counted(cast: Cast, data: bytes) -> None:
    session = opened(cast, "a")
    answer = session.receive_bytes("a", data, 0.0)
    assert len(reasons(answer)) == session.refused == 1


def test_bytes_are_obeyed_like_messages(cast: Cast) -> None:
    session = opened(cast, "a")
    assert session.receive_bytes("a", encode(SetChannel("one", "jawOpen", 0.5)), 0.0) == []
    assert session.tick(0.0).characters["one"].channels == {"jawOpen": 0.5}


def test_a_stage_shows_and_does_not_play(cast: Cast) -> None:
    session = opened(cast)
    session.receive("s", Hello("stage", PROTOCOL_VERSION), 0.0)
    assert "only a console plays" in reasons(session.receive("s", Panic("one"), 0.0))[0]
    assert session.receive("s", Drawing(60.0, "high"), 0.0) == []


@pytest.mark.parametrize("fps", [math.nan, math.inf, -1.0, 1e9])
def test_a_stage_cannot_draw_at_no_rate(cast: Cast, fps: float) -> None:
    session = opened(cast)
    session.receive("s", Hello("stage", PROTOCOL_VERSION), 0.0)
    session.receive("s", Drawing(50.0, "low"), 0.0)
    assert len(reasons(session.receive("s", Drawing(fps, "low"), 0.0))) == 1
    assert session.crew_now(0.0).stages == [StageReport(50.0, "low")]


def test_a_stage_says_for_how_long_it_draws_nothing_and_whether_its_screen_stays_on(cast: Cast) -> None:
    session = opened(cast)
    session.receive("s", Hello("stage", PROTOCOL_VERSION), 0.0)
    session.receive("s", Drawing(0.0, "low", "left", dark=12.5, awake="insecure"), 0.0)
    refused = reasons(session.receive("s", Drawing(0.0, "low", dark=math.nan), 0.0))
    assert "the seconds for which a stage draws nothing" in refused[0]
    assert session.crew_now(0.0).stages == [StageReport(0.0, "low", "left", dark=12.5, awake="insecure")]


def test_the_crew_is_who_said_hello_and_silent_stages_show(cast: Cast) -> None:
    session = opened(cast, "a", "b")
    for who in ("s", "t"):
        session.receive(who, Hello("stage", PROTOCOL_VERSION), 0.0)
    session.receive("s", Drawing(60.0, "high"), 10.0)
    assert session.crew_now(10.0 + SILENCE) == Crew(stages=[StageReport(60.0, "high"), None], consoles=2)
    session.leave("s")
    session.leave("b", lost=99.0)  # a console says so itself
    session.leave("nobody")
    assert session.crew_now(99.0) == Crew(stages=[None], consoles=1)


def test_a_stage_whose_link_broke_is_missed_until_one_comes_back_or_for_some_minutes(cast: Cast) -> None:
    session = opened(cast)
    for who in ("s", "t", "u"):
        session.receive(who, Hello("stage", PROTOCOL_VERSION), 0.0)
    session.leave("s", lost=100.0)
    session.leave("t", lost=200.0)
    session.leave("u")  # its page was closed
    session.leave("t", lost=201.0)  # is not lost twice
    assert session.crew_now(201.0) == Crew(stages=[], consoles=0, lost=2)
    session.receive("v", Hello("stage", PROTOCOL_VERSION), 202.0)
    session.receive("v", Hello("stage", PROTOCOL_VERSION), 202.0)
    assert session.crew_now(203.0).lost == 1
    assert session.crew_now(200.0 + LOST_SECONDS).lost == 1
    assert session.crew_now(201.0 + LOST_SECONDS).lost == 0


def test_who_leaves_lets_nothing_drop(cast: Cast) -> None:
    session = opened(cast, "a", "b")
    session.receive("a", SetChannel("one", "jawOpen", 0.7), 0.0)
    session.leave("a")
    assert session.tick(60.0).characters["one"].channels == {"jawOpen": 0.7}


def test_a_ping_tells_the_clock_of_the_states(cast: Cast) -> None:
    session = opened(cast, "a")
    state = session.tick(4.0)
    assert session.receive("a", Ping(123.0), 4.25) == [Outgoing("a", Pong(123.0, state.time + 0.25))]


def test_after_a_long_sleep_the_show_is_at_now_in_one_step(cast: Cast) -> None:
    session = opened(cast, "a")
    session.receive("a", CallFace("one", "1", "broad", 2.0, "smooth"), 0.0)
    before = session.tick(1.0)
    after = session.tick(1801.0)
    assert after.number == before.number + 1
    assert after.time == pytest.approx(1801.0)
    assert after.characters["one"].faces == {"broad": 1.0}


def test_a_clock_that_goes_back_stops_the_show_for_that_step_only(cast: Cast) -> None:
    session = opened(cast, "a")
    times = [session.tick(now).time for now in (1.0, 0.5, 1.5)]
    assert times == pytest.approx([1.0, 1.0, 2.0])


@given(messages=st.lists(command, max_size=20))
def test_a_restored_show_goes_on_frame_by_frame_the_same(cast: Cast, messages: list[ClientMessage]) -> None:
    session = opened(cast, "a")
    for number, message in enumerate(messages):
        session.receive("a", message, number * 0.1)
        session.tick(number * 0.1)
    data = msgspec.msgpack.encode(session.snapshot())
    other = ShowSession.restored(cast, msgspec.msgpack.decode(data, type=SessionSnapshot), epoch=6)
    last = max(0, len(messages) - 1) * 0.1
    other.tick(last)
    for step in range(1, 5):
        one = session.tick(last + step * FRAME)
        two = other.tick(last + step * FRAME)
        assert two.epoch == 6
        assert one.characters["one"].faces == pytest.approx(two.characters["one"].faces, abs=1e-9)
        assert one.characters["one"].expressions == pytest.approx(two.characters["one"].expressions, abs=1e-9)
        assert one.characters["one"].regions == two.characters["one"].regions
        assert one.characters["one"].region_calls == two.characters["one"].region_calls
        assert (one.characters["one"].channels, one.characters["one"].head, one.characters["one"].gaze) == (
            two.characters["one"].channels,
            two.characters["one"].head,
            two.characters["one"].gaze,
        )


def test_a_call_repeated_after_a_restart_still_executes_once(cast: Cast) -> None:
    session = opened(cast, "a")
    session.receive("a", CallFace("one", "same", "broad", 1.0, "smooth"), 0.0)
    other = ShowSession.restored(cast, session.snapshot(), epoch=6)
    other.receive("a", Hello("console", PROTOCOL_VERSION), 0.0)
    other.receive("a", CallFace("one", "same", "broad", 1.0, "smooth"), 0.0)
    assert other.commands == 0


@given(messages=st.lists(command, max_size=25), pause=st.floats(0.0, 2.0))
def test_a_recast_changes_nothing_that_is_on_air(cast: Cast, messages: list[ClientMessage], pause: float) -> None:
    session = opened(cast, "a")
    plain = opened(cast, "a")
    for message in messages:
        for each in (session, plain):
            each.receive("a", message, 0.0)
            each.tick(pause)
    told = session.recast(Recast(cast, [*cast.faces, "cousin"], [*cast.expressions, "grin"]))
    assert told == CastChanged(revision=2, digest="other")
    for step in range(1, 5):
        now = pause + step * FRAME
        assert session.tick(now) == msgspec.structs.replace(plain.tick(now), revision=2)


@given(messages=st.lists(command, max_size=25), pause=st.floats(0.0, 2.0))
def test_a_recast_without_what_is_held_is_refused_and_with_it_alone_is_not(
    cast: Cast, messages: list[ClientMessage], pause: float
) -> None:
    session = opened(cast, "a")
    for message in messages:
        session.receive("a", message, 0.0)
        session.tick(pause)
    faces, expressions, _ = session.names_held()
    rest = ["neutral", *(name for name in cast.expressions if name.startswith("eyeLook"))]
    before = session.tick(pause)
    for name in faces:
        with pytest.raises(ValueError, match=rf"there is no face {name!r}"):
            session.recast(Recast(cast, [*(faces - {name}), "cousin"], [*expressions, *rest]))
    for name in expressions - {*rest}:
        with pytest.raises(ValueError, match=rf"there is no (expression|channel)( \(\w+\))? {name!r}"):
            session.recast(Recast(cast, [*faces], [*(expressions - {name}), *rest]))
    assert session.revision == 1
    session.recast(Recast(cast, [*faces], [*expressions, *rest]))
    after = session.tick(pause)
    assert (after.characters["one"].faces, after.characters["one"].expressions, after.characters["one"].channels) == (
        before.characters["one"].faces,
        before.characters["one"].expressions,
        before.characters["one"].channels,
    )


@given(
    weight=st.floats(0.1, 1.0), angles=st.lists(st.floats(-0.4, 0.4), min_size=4, max_size=4), times=st.integers(1, 3)
)
def test_eyes_of_an_expression_that_changes_on_air_ease(
    cast: Cast, weight: float, angles: list[float], times: int
) -> None:
    """However often it changes: no jump, no way back, and after a quarter of a second where the last one has them."""
    session = opened(cast, "a")
    now = 0.0
    session.receive("a", CallExpression("one", "1", "smile", 0.0, "smooth"), now)
    session.receive("a", SetChannel("one", "smile", weight), now)
    for turn in range(1, times + 1):
        before = np.array(session.tick(now).characters["one"].eyes)
        other = Recast(cast, [*cast.faces], [*cast.expressions])
        turned = turn * np.array(angles).reshape(2, 2)
        other.expressions["smile"] = replace(cast.expressions["smile"], eyes=turned)
        session.recast(other)
        assert session.tick(now).characters["one"].eyes == pytest.approx(before, abs=1e-12)
        now += EYE_SECONDS / 3
        session.tick(now)
    way = np.array([session.tick(now + step * FRAME).characters["one"].eyes for step in range(20)])
    wanted = (1.0 + weight) * turned.ravel()
    assert way[-1] == pytest.approx(wanted, abs=1e-9)
    left = np.abs(way - wanted)
    assert (np.diff(left, axis=0) <= 1e-12).all()
    assert (np.abs(np.diff(way, axis=0)) <= 2.0 * FRAME / EYE_SECONDS * np.abs(before - wanted) + 1e-12).all()


def test_own_names_can_be_called_once_they_are_there(cast: Cast) -> None:
    session = opened(cast, "a")
    call = CallExpression("one", "1", "grin", 0.0, "smooth")
    assert "there is no expression 'grin'" in reasons(session.receive("a", call, 0.0))[0]
    session.recast(Recast(cast, [*cast.faces], [*cast.expressions, "grin"]))
    assert session.receive("a", call, 0.0) == []
    assert session.tick(0.0).characters["one"].expressions == {"grin": 1.0}
    welcome = session.receive("s", Hello("stage", PROTOCOL_VERSION), 0.0)
    assert welcome == [Outgoing("s", Welcome(PROTOCOL_VERSION, 5, 2, "other"))]


def test_keep_requests_are_taken_once_and_only_of_consoles(cast: Cast) -> None:
    session = opened(cast, "a")
    session.receive("s", Hello("stage", PROTOCOL_VERSION), 0.0)
    assert "only a console plays" in reasons(session.receive("s", KeepFace("one", "k"), 0.0))[0]
    keep = KeepFace("one", "k")
    undo = DeleteItem("u", "face", "on_air_1", unedited=True)
    layouts: list[FileRequest] = [
        SetLayout("desk", "{}"),
        RenameLayout("desk", "left"),
        DropLayout("x"),
    ]
    said: list[FileRequest] = [keep, keep, KeepExpression("one", "l"), undo, *layouts, undo]
    for message in said:
        assert session.receive("a", message, 0.0) == []
    assert session.take_keep_requests() == [KeepRequest("a", message) for message in said[1:-1]]
    assert session.take_keep_requests() == []
    assert "k" in session.snapshot().executed["seat a"]


def test_a_number_that_no_hand_can_have_set_is_named_with_what_to_do(cast: Cast) -> None:
    session = opened(cast, "a")
    (sentence,) = reasons(session.receive("a", SetChannel("one", "jawOpen", math.nan), 0.0))
    assert sentence == (
        "the channel jawOpen is no number (NaN); give a number from -0.5 to 1.5. Nothing has changed. "
        "Send a finite number; a page that sends another is to be reloaded."
    )
    (sentence,) = reasons(session.receive("a", SetChannel("one", "jawOpen", 2.0), 0.0))
    assert sentence.endswith("from -0.5 to 1.5. Nothing has changed.")


def test_panic_stops_everything_and_a_second_one_brings_the_home_face(cast: Cast) -> None:
    session = opened(cast, "a", "b")
    session.receive("b", SetHome("one", "long", 2.0), 0.0)
    session.receive("a", CallFace("one", "1", "broad", None, "smooth"), 0.0)
    session.receive("a", FadeFace("one", 0.0), 0.0)
    session.receive("a", FadeFace("one", 0.48), 0.0)
    session.tick(1.0)
    session.receive("a", CallExpression("one", "2", "smile", 0.0, "smooth"), 1.0)
    session.receive("a", Panic("one"), 1.0)
    state = session.tick(2.0)
    assert state.characters["one"].faces == pytest.approx({"generic": 0.52, "broad": 0.48})
    assert state.characters["one"].expressions == {"neutral": 1.0}
    assert (
        state.characters["one"].face_call,
        state.characters["one"].expression_call,
        state.characters["one"].face_fader,
        state.characters["one"].panics,
    ) == (None, None, 0.0, 1)
    assert (
        state.characters["one"].home_face,
        state.characters["one"].home_seconds,
        state.characters["one"].home_next,
    ) == ("long", 2.0, True)
    session.receive("b", Panic("one"), 2.0)
    coming = session.tick(3.0)
    assert coming.characters["one"].face_call is not None
    assert (
        coming.characters["one"].face_call.target,
        coming.characters["one"].panics,
        coming.characters["one"].home_next,
    ) == ("long", 2, False)
    assert coming.characters["one"].face_call.start == state.characters["one"].faces
    assert session.tick(4.0).characters["one"].faces == {"long": 1.0}


@pytest.mark.parametrize(
    "hand",
    [
        FadeFace("one", 0.5),
        FadeExpression("one", 0.5),
        SetChannel("one", "jawOpen", 0.9),
        SetGaze("one", 0.2, 0.0),
    ],
)
def test_a_hand_at_another_console_does_not_undo_a_panic_that_it_cannot_know_of(
    cast: Cast, hand: ClientMessage
) -> None:
    session = opened(cast, "a", "b")
    session.receive("a", Panic("one"), 0.0)
    (sentence,) = reasons(session.receive("b", hand, PANIC_SECONDS / 2))
    assert "hands are off" in sentence
    assert session.tick(PANIC_SECONDS / 2).characters["one"].panics == 1
    assert session.receive("a", hand, PANIC_SECONDS / 2) == []
    assert session.receive("b", hand, PANIC_SECONDS * 2) == []
    assert session.receive("b", CallFace("one", "1", "broad", 1.0, "smooth"), 0.0) == []


def two_characters(cast: Cast) -> ShowSession:
    session = opened(cast, "a", "b")
    session.receive("a", AddCharacter("add", "two", "Two", "long"), 0.0)
    session.receive("a", EnterCharacter("enter", "two", 0.0), 0.0)
    return session


def motions_of(session: ShowSession) -> dict[str, MotionSettings]:
    characters = session.snapshot().scene.characters.items()
    return {name: character.performer.motion.settings for name, character in characters if character.performer.motion}


@pytest.mark.parametrize(("first", "third"), [(0.0, 0.0), (0.5, 0.5), (0.2, 0.9)])
def test_a_character_that_is_added_begins_as_lively_as_the_liveliest_and_moves_its_own_way(
    cast: Cast, first: float, third: float
) -> None:
    session = opened(cast, "a")
    session.receive("a", SetMotion("one", liveliness=first), 0.0)
    session.receive("a", AddCharacter("2", "two", "Two", "long"), 0.0)
    assert motions_of(session)["two"].liveliness == first
    session.receive("a", SetMotion("one", liveliness=third), 0.0)
    session.receive("a", SetMotion("two", liveliness=0.0), 0.0)
    session.receive("a", AddCharacter("3", "three", "Three", "long"), 0.0)
    session.receive("a", RemoveCharacter("away", "two", 0.0), 0.0)
    session.receive("a", AddCharacter("4", "four", "Four", "long"), 0.0)
    motions = motions_of(session)
    assert motions["three"].liveliness == third
    assert motions["four"].liveliness == third
    assert len({motion.seed for motion in motions.values()}) == len(motions)


def test_a_character_is_added_placed_shot_played_and_removed(cast: Cast) -> None:
    session = two_characters(cast)
    added = session.tick(0.0).characters["two"]
    assert (added.label, added.faces, added.home_face, added.presence) == ("Two", {"long": 1.0}, "long", 1.0)
    for message in (
        RenameCharacter("rename", "two", "Kaori"),
        PlaceCharacter("two", 0.5, 1.0, 2.0, 0.25, 1.0),
        CallFraming("shot", ["two"], 1.0, "smooth"),
        CallExpression("two", "smile", "smile", 0.0, "smooth"),
    ):
        assert session.receive("b", message, 0.0) == []
    session.tick(0.0)
    state = session.tick(1.0)
    assert (state.characters["two"].label, state.characters["two"].place) == ("Kaori", Place(0.5, 1.0, 2.0, 0.25))
    assert state.framing == {"two": 1.0}
    assert state.characters["two"].expressions == {"smile": 1.0}
    assert state.characters["one"].expressions == {"neutral": 1.0}
    session.receive("b", RemoveCharacter("remove", "two"), 1.0)
    assert session.tick(1.5).characters["two"].leaves
    gone = session.tick(3.0)
    assert ([*gone.characters], gone.framing) == (["one"], {"*": 1.0})
    assert session.names_held()[0] == {"generic"}


def test_one_that_is_added_again_while_it_leaves_stays(cast: Cast) -> None:
    session = two_characters(cast)
    session.tick(0.0)
    session.receive("a", RemoveCharacter("remove", "two"), 0.0)
    session.tick(0.5)
    assert session.receive("a", AddCharacter("again", "two", "Twice", "broad"), 0.5) == []
    two = session.tick(3.0).characters["two"]
    assert (two.label, two.faces, two.presence, two.leaves) == ("Twice", {"broad": 1.0}, 1.0, False)


def test_a_message_for_all_is_played_by_each_and_a_retry_once(cast: Cast) -> None:
    session = two_characters(cast)
    for _ in range(2):
        session.receive("a", CallFace("*", "1", "broad", 0.0, "smooth"), 0.0)
        session.receive("a", AddCharacter("add", "two", "Two", "long"), 0.0)
    state = session.tick(0.0)
    assert [each.faces for each in state.characters.values()] == [{"broad": 1.0}] * 2
    for message in (
        CallFace("three", "2", "broad", 0.0, "smooth"),
        KeepFace("*", "3"),
        KeepFace("three", "4"),
        RenameCharacter("5", "*", "All"),
        RemoveCharacter("6", "*"),
    ):
        (sentence,) = reasons(session.receive("a", message, 0.0))
        assert "there is no character" in sentence
        assert sentence.endswith(".")
    assert "one, two" in reasons(session.receive("a", Panic("three"), 0.0))[0]


def test_panic_of_one_character_leaves_the_hands_on_the_others(cast: Cast) -> None:
    session = two_characters(cast)
    for who in ("one", "two"):
        session.receive("b", SetChannel(who, "jawOpen", 0.5), 0.0)
    session.receive("a", Panic("one"), 0.0)
    (told,) = [each.message for each in session.hands_now(0.0) if each.who == "a"]
    assert told == Hands({"two/set_channel:jawOpen": "console 2"})
    assert reasons(session.receive("b", SetChannel("one", "jawOpen", 0.6), 0.1)) != []
    assert reasons(session.receive("b", SetChannel("*", "jawOpen", 0.6), 0.1)) != []
    assert session.receive("b", SetChannel("two", "jawOpen", 0.6), 0.1) == []
    assert session.receive("b", PlaceCharacter("one", 0.0, 0.0, 1.0, 0.0, 0.0), 0.1) == []
    session.tick(0.1)
    state = session.tick(1.0)
    assert [each.panics for each in state.characters.values()] == [1, 0]
    assert [each.channels for each in state.characters.values()] == [{}, {"jawOpen": 0.6}]
    session.receive("a", Panic("*"), 2.0)
    assert [each.panics for each in session.tick(3.0).characters.values()] == [2, 1]


def test_a_show_of_several_characters_goes_on_after_a_restart(cast: Cast) -> None:
    session = two_characters(cast)
    session.tick(0.0)
    session.receive("a", CallFace("two", "1", "broad", 3.0, "smooth"), 0.0)
    session.receive("a", PlaceCharacter("two", 1.0, 0.0, 1.0, 0.0, 3.0), 0.0)
    session.tick(1.0)
    written = msgspec.msgpack.encode(session.snapshot())
    other = ShowSession.restored(cast, msgspec.msgpack.decode(written, type=SessionSnapshot), epoch=6)
    other.tick(1.0)
    assert other.tick(2.0).characters == session.tick(2.0).characters
    empty = msgspec.structs.replace(session.snapshot(), scene=SceneSnapshot())
    with pytest.raises(ValueError, match="the scene of the snapshot is empty"):
        ShowSession.restored(cast, empty, epoch=7)


def test_consoles_are_told_the_layouts_that_there_are_and_stages_are_not(cast: Cast) -> None:
    session = opened(cast, "a")
    session.receive("s", Hello("stage", PROTOCOL_VERSION), 0.0)
    assert session.list_documents("layout", ["desk", "left"]) == [Outgoing("a", Layouts(["desk", "left"]))]
    _, *told = session.receive("late", Hello("console", PROTOCOL_VERSION), 0.0)
    assert told[:1] == [Outgoing("late", Layouts(["desk", "left"]))]


def test_every_console_has_a_name_of_its_own_and_may_change_it(cast: Cast) -> None:
    session = opened(cast)
    names = []
    for who, wanted in [("a", "Ana"), ("b", ""), ("c", " ana "), ("d", ""), ("b", "Ben"), ("a", "Ana")]:
        hello = Hello("console", PROTOCOL_VERSION, wanted)
        welcome = session.receive(who, hello, 0.0)[0]
        assert isinstance(welcome.message, Welcome)
        names.append(welcome.message.name)
    assert names == ["Ana", "console 1", "ana 2", "console 2", "Ben", "Ana"]
    assert session.crew_now(0.0).consoles == 4


def names_after(session: ShowSession, *hellos: tuple[str, str, str]) -> dict[str, str]:
    """What consoles were last told that they are called, after hellos of (client, name, page)."""
    told: dict[str, str] = {}
    for who, name, page in hellos:
        for each in session.receive(who, Hello("console", PROTOCOL_VERSION, name, page), 0.0):
            if isinstance(each.message, Welcome):
                told[each.who] = each.message.name
    return told


@pytest.mark.parametrize("order", list(itertools.permutations([0, 1, 2])))
def test_names_stay_with_their_pages_in_whatever_order_these_come_back(cast: Cast, order: tuple[int, ...]) -> None:
    first = names_after(opened(cast), ("a", "", "1"), ("b", "", "2"), ("c", "Ana", "3"))
    assert first == {"a": "console 1", "b": "console 2", "c": "Ana"}
    back = [(who, name, page) for (who, name), page in zip(first.items(), "123", strict=True)]
    assert names_after(opened(cast), *(back[each] for each in order)) == first
    late = names_after(opened(cast), ("new", "", "4"), *(back[each] for each in order))
    assert late == {**first, "new": late["new"]}, "who claims a name gets it from one that was given it"
    assert late["new"] not in first.values()


def test_a_page_that_comes_back_before_its_old_link_is_known_to_be_lost_keeps_its_name(cast: Cast) -> None:
    session = opened(cast)
    told = names_after(session, ("old", "Ana", "1"), ("other", "", "2"), ("new", "Ana", "1"))
    assert told == {"old": "Ana", "other": "console 1", "new": "Ana"}
    assert session.crew_now(0.0).consoles == 2
    session.leave("old", lost=0.0)
    assert session.crew_now(0.0).consoles == 2


def test_a_console_is_told_whose_hands_move_what(cast: Cast) -> None:
    session = opened(cast, "a", "b")
    session.receive("s", Hello("stage", PROTOCOL_VERSION), 0.0)
    session.receive("b", SetChannel("one", "jawOpen", 0.5), 1.0)
    session.receive("b", SetChannel("one", "nobody", 0.5), 1.0)  # rejected: no hand is on it
    assert session.hands_now(1.0) == [Outgoing("a", Hands({"one/set_channel:jawOpen": "console 2"}))]
    session.receive("a", Panic("one"), 1.1)
    assert session.hands_now(1.1) == [Outgoing("a", Hands({}))]


def test_a_page_is_told_which_of_its_messages_was_rejected(cast: Cast) -> None:
    session = opened(cast, "a")
    unknown = msgspec.msgpack.encode({"type": "keep_everything", "id": "a-1"})
    [of_unknown] = session.receive_bytes("a", unknown, 0.0)
    [of_call] = session.receive("a", CallFace("one", "a-2", "nobody", 1.0, "smooth"), 0.0)
    [of_fader] = session.receive("a", FadeFace("one", 2.0), 0.0)
    told = [each.message for each in (of_unknown, of_call, of_fader)]
    assert [each.id for each in told if isinstance(each, Refused)] == ["a-1", "a-2", ""]
