"""Sources of a session: opened once, driven by the frame, routed, measured, and gone with their link."""

from dataclasses import replace
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.model.space.expression import Title
from omote.perform.layers.drivers import BACK_ACCELERATION
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.characters import AddCharacter
from omote.show.objects.faders import SetChannel
from omote.show.objects.layers import SetLayer
from omote.show.objects.link import Hello, Refused
from omote.show.objects.sources import (
    CalibrateSource,
    Drive,
    LeaveSource,
    MeasureSource,
    RouteSource,
    Source,
    SourceIs,
    Sources,
    SourceState,
    SourceValues,
    StreamKind,
    TuneSource,
    WatchSource,
)
from omote.show.objects.state import State
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from omote.show.sources.open_sources import OpenSources
from omote.show.wire import encode

DT = 1.0 / 60.0


class Show:
    """A session with a console, a phone and its clock."""

    def __init__(self, cast: Cast) -> None:
        self.session = ShowSession(cast)
        self.now = 0.0
        self.calls = 0
        for who in ("console", "phone"):
            self.session.receive(who, Hello("console", PROTOCOL_VERSION, who), 0.0)
        self.session.receive("console", AddCharacter("two", "two", "Two", "generic"), 0.0)

    def open(self, kind: StreamKind = "tracker", name: str = "face", who: str = "phone", **more: Any) -> int:
        more = {"names": ["jawOpen", "smile"], "characters": ["one"], **more}
        (answer,) = self.session.receive_bytes(who, encode(Source(name, kind, **more)), self.now)
        assert isinstance(answer.message, SourceIs), answer.message
        return answer.message.index

    def drive(self, index: int, values: list[float], who: str = "phone", **more: Any) -> None:
        frame = Drive(index, np.array(values, "<f4").tobytes(), **more)
        assert self.session.receive_bytes(who, encode(frame), self.now) == []

    def play(self, seconds: float, index: int = 0, values: list[float] | None = None, **more: Any) -> State:
        for _ in range(round(seconds / DT)):
            if values is not None:
                self.drive(index, values, **more)
            self.now += DT
            state = self.session.tick(self.now)
        return state

    def change(self, message: Any, who: str = "console") -> None:
        assert self.session.receive(who, message, self.now) == []

    def refused(self, message: Any, who: str = "phone") -> str:
        (answer,) = self.session.receive(who, message, self.now)
        assert isinstance(answer.message, Refused)
        return answer.message.reason

    def told(self) -> list[SourceState]:
        self.now += 1.0
        return self.news()[-1].sources

    def watched(self) -> list[SourceValues]:
        told = [each.message for each in self.session.hands_now(self.now) if each.who == "console"]
        return [each for each in told if isinstance(each, SourceValues)]

    def play_all(self, seconds: float, frames: dict[int, list[float]]) -> State:
        for _ in range(round(seconds / DT)):
            for index, values in frames.items():
                self.drive(index, values)
            self.now += DT
            state = self.session.tick(self.now)
        return state

    def news(self) -> list[Sources]:
        told = [each.message for each in self.session.hands_now(self.now) if each.who == "console"]
        return [each for each in told if isinstance(each, Sources)]


def jaw(state: State, character: str = "one") -> float:
    return state.characters[character].channels.get("jawOpen", 0.0)


def test_a_source_drives_its_characters_and_no_others(cast: Cast) -> None:
    show = Show(cast)
    state = show.play(4.0, show.open(), [0.75, 0.25])
    assert jaw(state) == pytest.approx(0.75, abs=1e-3)
    layer = state.characters["one"].layers["tracker"]
    assert layer.source == "face"
    assert layer.trust == pytest.approx(1.0, abs=1e-3)
    assert (jaw(state, "two"), state.characters["two"].layers) == (0.0, {})


def test_all_characters_are_driven_by_a_source_for_all(cast: Cast) -> None:
    show = Show(cast)
    state = show.play(4.0, show.open(characters=["*"]), [0.75, 0.25])
    assert jaw(state) == jaw(state, "two") == pytest.approx(0.75, abs=1e-3)


def test_a_route_moves_a_source_elsewhere_and_what_it_left_fades(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    show.play(3.0, index, [0.75, 0.25])
    show.change(RouteSource("r1", "face", ["two"], "playback", ["mouth", "brows", "eyes", "rest"]))
    state = show.play(6.0, index, [0.75, 0.25])
    assert [jaw(state), jaw(state, "two")] == pytest.approx([0.0, 0.75], abs=1e-3)
    assert (state.characters["one"].layers, list(state.characters["two"].layers)) == ({}, ["playback"])
    assert show.told()[0].characters == ["two"]


def test_the_end_of_a_link_is_a_loss(cast: Cast) -> None:
    show = Show(cast)
    shown = jaw(show.play(3.0, show.open(), [0.75, 0.25]))
    show.session.leave("phone")
    values = [shown, *(jaw(show.play(DT)) for _ in range(300))]
    assert values[-1] == 0.0
    assert np.abs(np.diff(values)).max() < 0.03, "it fades out"
    assert show.told() == []


def test_a_source_that_ends_is_gone_and_its_index_too(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    show.play(1.0, index, [0.75, 0.25])
    show.change(LeaveSource(index), "phone")
    assert (
        show.refused(Drive(index, bytes(8)))
        == f"this link has no source {index}; send source first, source_is has its index."
    )


def test_a_source_of_another_link_cannot_be_driven_nor_its_name_taken(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    assert "this link has no source" in show.refused(Drive(index, bytes(8)), "console")
    taken = Source("face", "lips", ["smile"])
    assert show.refused(taken, "console") == "another link sends as face already; choose another name."


def test_what_cannot_be_played_is_refused_and_changes_nothing(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    before = show.play(1.0, index, [0.5, 0.0])
    assert "face sent 4 bytes for 2 channels" in show.refused(Drive(index, bytes(4)))
    bad = np.array([0.0, np.nan], "<f4").tobytes()
    assert "smile of face is no number (NaN)" in show.refused(Drive(index, bad))
    far = show.refused(Drive(index, bytes(8), head=(9.0, 0.0, 0.0)))
    assert "the head's yaw (radians; 90 degrees at most) is 9.0" in far
    assert "there is no channel 'gone'" in show.refused(Source("x", "lips", ["gone"]))
    assert "there is no character 'three'" in show.refused(Source("x", "lips", ["smile"], ["three"]))
    assert "there is no source 'x'" in show.refused(CalibrateSource("c", "x", "neutral"), "console")
    assert "there is no layer for a source 'hands'" in show.refused(RouteSource("r", "face", [], "hands"), "console")
    assert "is not listened to" in show.refused(CalibrateSource("d", "face", "done"), "console")
    show.open(name="new")
    assert "new has not sent a frame yet" in show.refused(CalibrateSource("n", "new", "neutral"), "console")
    assert jaw(show.play(DT)) >= jaw(before)


def test_a_performer_is_measured_and_the_layer_lets_go_meanwhile(cast: Cast) -> None:
    show = Show(cast)
    index = show.open(performer="Aki")
    show.play(3.0, index, [0.25, 0.0])
    show.change(CalibrateSource("n", "face", "neutral"))
    show.change(CalibrateSource("r", "face", "range"))
    show.play(0.5, index, [0.75, 0.5])
    show.change(CalibrateSource("d", "face", "done"))
    assert show.told()[0].calibrated
    assert jaw(show.play(6.0, index, [0.5, 0.0])) == pytest.approx(0.5, abs=1e-3)
    assert jaw(show.play(4.0, index, [0.25, 0.0])) == pytest.approx(0.0, abs=1e-3)
    show.change(TuneSource("t", "face", mirror=True, dead_zone=0.1, curve=0.0, gain=0.5))
    assert jaw(show.play(6.0, index, [0.75, 0.0])) == pytest.approx(0.5, abs=1e-3)
    show.change(CalibrateSource("x", "face", "reset"))
    assert (show.told()[0].mirror, show.told()[0].calibrated) == (True, False)


def test_routes_and_measures_stay_with_the_show(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    show.play(1.0, index, [0.25, 0.0])
    show.change(CalibrateSource("n", "face", "neutral"))
    show.change(RouteSource("r", "face", ["two"], "playback"))
    show.play(0.5, index, [0.25, 0.0])
    saved = msgspec.msgpack.decode(msgspec.msgpack.encode(show.session.snapshot()))
    snapshot, _ = read_session_snapshot(saved)
    assert snapshot == show.session.snapshot()
    show.session = ShowSession.restored(cast, snapshot, epoch=2)
    show.session.receive("phone", Hello("console", PROTOCOL_VERSION, "phone"), show.now)
    show.session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), show.now)
    index = show.open(characters=[])
    (told,) = show.told()
    assert (told.characters, told.layer, told.calibrated) == (["two"], "playback", True)
    assert jaw(show.play(5.0, index, [1.25, 0.0]), "two") == pytest.approx(1.0, abs=1e-3)


def test_a_show_goes_on_bit_for_bit_from_its_snapshot(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    show.play(0.3, index, [0.75, 0.25], head=(0.2, 0.0, 0.0))
    snapshot, _ = read_session_snapshot(msgspec.msgpack.decode(msgspec.msgpack.encode(show.session.snapshot())))
    again = ShowSession.restored(cast, snapshot, epoch=1)
    again.tick(show.now)
    for n in range(1, 120):
        state = show.session.tick(show.now + n * DT)
        other = again.tick(show.now + n * DT)
        assert other.characters == state.characters


def test_a_log_of_messages_replays_bit_for_bit(cast: Cast) -> None:
    rng = np.random.default_rng(5)
    shows = Show(cast), Show(cast)
    for show in shows:
        show.open(), show.open("lips", "mic", names=["jawOpen"], characters=["*"])
    for n in range(200):
        values = rng.random(2).tolist()
        states = []
        for show in shows:
            show.drive(1, values, gaze=(0.1, 0.0) if n % 7 else None)
            if n % 3 == 0:
                show.drive(2, values[:1], found=n % 9 != 0)
            if n % 40 == 0:
                show.change(SetLayer("one", "tracker", "mouth", values[0]))
                show.change(SetChannel("one", "smile", values[1]))
            states.append(encode(show.play(DT)))
        assert states[0] == states[1]


def test_consoles_are_told_once_a_second_and_with_each_change(cast: Cast) -> None:
    show = Show(cast)
    assert show.news() == []
    index = show.open()
    assert len(show.news()) == 1
    assert show.news() == []
    show.play(0.5, index, [0.5, 0.5])
    (now,) = show.told()
    assert (now.rate, now.found, now.console, now.kind) == (30, True, "phone", "tracker")
    show.drive(index, [0.5, 0.5], found=False)
    assert not show.told()[0].found


@pytest.mark.parametrize("gap", [DT, 0.1, 0.2])
def test_one_that_has_lost_its_performer_for_a_moment_comes_back_elsewhere_without_a_jump(
    cast: Cast, gap: float
) -> None:
    """That it was lost never reached the layers: they followed it at once after less than a quarter of a second."""
    show = Show(cast)
    index = show.open()
    show.play(1.0, index, [0.0, 0.0])
    show.drive(index, [0.0, 0.0], found=False)
    show.play(gap)
    shown = [jaw(show.play(DT, index, [0.9, 0.0])) for _ in range(120)]
    assert np.abs(np.diff([0.0, 0.0, *shown], 2)).max() < 1.25 * BACK_ACCELERATION * DT * DT
    assert shown[-1] == pytest.approx(0.9, abs=1e-3)


def test_a_stage_drives_nothing(cast: Cast) -> None:
    show = Show(cast)
    show.session.receive("stage", Hello("stage", PROTOCOL_VERSION), 0.0)
    assert "only a console plays" in show.refused(Source("x", "lips", ["smile"]), "stage")


def test_a_source_is_smoothed_as_its_performer_is_tuned_or_as_it_asks(cast: Cast) -> None:
    shown = []
    for tuned, asked in ((0.0, 0.0), (1.5, 0.0), (0.0, 1.5)):
        show = Show(cast)
        index = show.open(smoothing=asked)
        show.play(1.0, index, [0.0, 0.0])
        show.change(TuneSource("t", "face", False, 0.0, 0.0, 1.0, tuned))
        show.play(1.0, index, [0.0, 0.0])
        shown.append(jaw(show.play(0.3, index, [0.75, 0.0])))
        assert show.told()[0].smoothing == tuned
    assert shown[0] > 0.7
    assert shown[1] == pytest.approx(shown[2])
    assert shown[1] < 0.5 * shown[0]
    assert "the smoothing of a source (seconds) is 9" in show.refused(
        TuneSource("u", "face", False, 0.0, 0.0, 1.0, 9.0), "console"
    )


def test_two_trackers_share_a_character_by_region_on_one_layer(cast: Cast) -> None:
    titles = {"jawOpen": Title("jaw", region="jaw"), "smile": Title("brow", region="brows")}
    show = Show(replace(cast, titles={**cast.titles, **titles}))
    frames = {show.open(name="lips"): [0.75, 0.75], show.open(name="brows"): [0.25, 0.25]}
    show.change(RouteSource("r1", "lips", ["one"], "tracker", ["mouth"]))
    show.change(RouteSource("r2", "brows", ["one"], "tracker", ["brows"]))
    one = show.play_all(5.0, frames).characters["one"]
    assert [one.channels["jawOpen"], one.channels["smile"]] == pytest.approx([0.75, 0.25], abs=1e-3)
    assert {each.source: each.parts for each in one.layers["tracker"].sources} == {
        "lips": ["mouth"],
        "brows": ["brows"],
    }


routes = st.lists(
    st.tuples(
        st.sampled_from(["a", "b", "c"]), st.sets(st.sampled_from(["one", "two"])), st.sampled_from(["mouth", "brows"])
    ),
    max_size=6,
)


@given(routes)
@settings(max_examples=6)
def test_each_part_of_each_character_is_played_by_one_that_is_routed_to_it(
    cast: Cast, asked: list[tuple[str, set[str], Any]]
) -> None:
    titles = {"jawOpen": Title("jaw", region="jaw"), "smile": Title("brow", region="brows")}
    show = Show(replace(cast, titles={**cast.titles, **titles}))
    sent = {"a": 0.25, "b": 0.5, "c": 0.75}
    index = {name: show.open(name=name, characters=[]) for name in sent}
    frames = {index[name]: [value] * 2 for name, value in sent.items()}
    routed = dict[str, tuple[set[str], str]]()
    for n, (name, characters, part) in enumerate(asked):
        show.change(RouteSource(f"r{n}", name, sorted(characters), "tracker", [part]))
        routed[name] = characters, part
        show.play_all(0.2, frames)
    state = show.play_all(7.0, frames)
    for character in ("one", "two"):
        for channel, part in (("jawOpen", "mouth"), ("smile", "brows")):
            may = [sent[name] for name, (who, of) in routed.items() if character in who and of == part]
            shown = state.characters[character].channels.get(channel, 0.0)
            assert any(shown == pytest.approx(each, abs=0.01) for each in may or [0.0])


def test_a_range_is_measured_of_some_channels_and_the_others_stay(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    for number, (names, values) in enumerate([(["jawOpen"], [0.5, 0.9]), (["smile"], [0.1, 0.4])]):
        show.play(0.2, index, [0.0, 0.0])
        show.change(CalibrateSource(f"r{number}", "face", "range", names))
        show.play(0.5, index, values)
        show.change(CalibrateSource(f"d{number}", "face", "done"))
    assert show.told()[0].highest == pytest.approx({"jawOpen": 0.5, "smile": 0.4})
    assert jaw(show.play(6.0, index, [0.25, 0.0])) == pytest.approx(0.5, abs=1e-3)
    assert "there is no channel of face 'tongueOut'" in show.refused(
        CalibrateSource("x", "face", "range", ["tongueOut"]), "console"
    )


def test_a_face_at_rest_is_the_mean_of_some_frames(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    for n in range(120):
        show.drive(index, [0.3 + 0.1 * (-1) ** n, 0.0])
    show.change(CalibrateSource("n", "face", "neutral"))
    assert show.told()[0].neutral["jawOpen"] == pytest.approx(0.3, abs=0.01)


def test_a_measure_is_taken_back_and_done_again(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    show.play(1.0, index, [0.25, 0.0])
    show.change(CalibrateSource("n", "face", "neutral"))
    after = show.told()[0]
    show.change(MeasureSource("m", "face", {}, {}))
    assert not show.told()[0].calibrated
    show.change(MeasureSource("o", "face", after.neutral, after.highest))
    assert show.told()[0].neutral == after.neutral
    wrong = show.refused(MeasureSource("p", "face", {"jawOpen": 3.0}, {}), "console")
    assert "jawOpen in the face at rest of a performer is 3.0; give a number from -0.5 to 1.5" in wrong


def test_who_watches_a_source_sees_what_comes_and_what_is_made_of_it(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    show.change(WatchSource("face"))
    assert show.watched() == [], "nothing has come"
    show.play(1.0, index, [0.5, 0.0])
    show.change(TuneSource("t", "face", False, 0.0, 0.0, 2.0))
    (told,) = show.watched()
    assert (told.source, told.names) == ("face", ["jawOpen", "smile"])
    assert np.frombuffer(told.sent, "<f4").tolist() == [0.5, 0.0]
    assert np.frombuffer(told.weights, "<f4").tolist() == [1.0, 0.0]
    assert show.watched() == [], "not oftener than it can be seen"
    show.now += 1.0
    show.change(WatchSource(""))
    assert show.watched() == []
    assert "there is no source 'gone'" in show.refused(WatchSource("gone"), "console")


def test_a_source_that_is_smoothed_otherwise_does_not_let_go(cast: Cast) -> None:
    show = Show(cast)
    index = show.open()
    show.play(3.0, index, [0.75, 0.0])
    show.change(TuneSource("t", "face", False, 0.0, 0.0, 1.0, 1.0))
    assert min(jaw(show.play(DT, index, [0.75, 0.0])) for _ in range(120)) > 0.74


def shares(show: Show, frames: dict[int, list[float]]) -> float:
    """The jaw that is on air once all has settled."""
    return round(jaw(show.play_all(8.0, frames)), 2)


def test_one_that_comes_back_takes_nothing_from_one_that_was_told_to_play_since(cast: Cast) -> None:
    show = Show(cast)
    for who in ("camera", "phone"):
        show.session.receive(who, Hello("console", PROTOCOL_VERSION, who), 0.0)
    first = show.open(name="camera", who="camera")
    show.drive(first, [0.2, 0.0], who="camera")
    show.session.leave("camera")
    show.play(8.0)
    phone = show.open(name="phone")
    assert shares(show, {phone: [0.8, 0.0]}) == 0.8
    show.session.receive("camera", Hello("console", PROTOCOL_VERSION, "camera"), 0.0)
    camera = show.open(name="camera", who="camera", characters=[])
    assert show.session.sources.route("camera").characters == ("one",), "it is remembered"

    def both(seconds: float) -> State:
        for _ in range(round(seconds / DT)):
            show.drive(camera, [0.2, 0.0], who="camera")
            state = show.play(DT, phone, [0.8, 0.0])
        return state

    assert jaw(both(8.0)) == pytest.approx(0.8, abs=1e-2), "the phone plays on"
    show.change(RouteSource("r", "camera", ["one"], "tracker"))
    assert jaw(both(8.0)) == pytest.approx(0.2, abs=1e-2), "an operator has said so"
    show.change(LeaveSource(camera), "camera")
    assert shares(show, {phone: [0.8, 0.0]}) == 0.8
    camera = show.open(name="camera", who="camera", characters=[])
    assert jaw(both(8.0)) == pytest.approx(0.2, abs=1e-2), "it was told to play last, and is back"


def test_who_was_told_to_play_last_is_known_after_a_restart(cast: Cast) -> None:
    show = Show(cast)
    for name in ("camera", "phone"):
        show.open(name=name)
    show.change(RouteSource("r", "camera", ["one"], "tracker"))
    kept = msgspec.msgpack.encode(show.session.snapshot())
    sources = read_session_snapshot(msgspec.msgpack.decode(kept))[0].sources
    later = OpenSources(sources)
    assert later.route("camera").number > later.route("phone").number > 0
