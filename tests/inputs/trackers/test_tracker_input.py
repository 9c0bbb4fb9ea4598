"""Trackers at a session: each is a source, drives by its newest frame, keeps what it does not say, and may be lost."""

from collections.abc import Callable

import numpy as np
import pytest

from omote.inputs.osc_packet import encode_bundle, encode_message
from omote.inputs.trackers.face_text import encode_face_text
from omote.inputs.trackers.tracker_input import MOST_FACES, MOST_SAID, TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.inputs.trackers.vmc_messages import encode_vmc
from omote.model.cast import Cast
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.characters import AddCharacter
from omote.show.objects.link import Hello
from omote.show.objects.sources import RouteSource, Source, SourceState
from omote.show.objects.state import State
from omote.show.session import ShowSession
from omote.show.sources.open_sources import QUIET_SECONDS
from tests.inputs.trackers.packets import live_link_face, motion_frame, motion_schema, open_see_face

TICK = 1.0 / 60.0
HOST = "10.0.0.7"
PHONE = (
    b'{"FaceFound":true,"Rotation":{"x":1,"y":2,"z":3},"BlendShapes":[{"k":"JawOpen","v":0.25},{"k":"smile","v":1}]}'
)

PARAMETERS = (
    b'{"apiName":"VTubeStudioPublicAPI","apiVersion":"1.0","messageType":"InputParameterListResponse","requestID":"a",'
    b'"data":{"modelLoaded":true,"customParameters":[],"defaultParameters":[{"name":"MouthOpen","value":0.5}]}}'
)


class Stage:
    """A session with one character, trackers of a protocol, and a clock."""

    def __init__(self, cast: Cast, protocol: str) -> None:
        self.session = ShowSession(cast)
        self.now = 0.0
        self.trackers = TrackerInput(TRACKER_PROTOCOLS[protocol], lambda: self.session)
        self.session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)

    def play(self, seconds: float, *packets: bytes, host: str = HOST) -> State:
        for _ in range(max(1, round(seconds / TICK))):
            for packet in packets:
                self.trackers.receive(host, packet, self.now)
            self.trackers.play(self.now)
            self.now += TICK
            state = self.session.tick(self.now)
        return state

    def sources(self) -> list[SourceState]:
        return self.session.sources.states({})


def apply(**values: float) -> bytes:
    messages = [encode_message("/VMC/Ext/Blend/Val", name, value) for name, value in values.items()]
    return encode_bundle([*messages, encode_message("/VMC/Ext/Blend/Apply")])


FACES: dict[str, Callable[[], bytes]] = {
    "vmc": lambda: apply(JawOpen=0.5, Smile=1.0),
    "livelink": lambda: live_link_face([0.5 if index == 17 else 0.0 for index in range(61)]),
    "ifacialmocap": lambda: encode_face_text({"jawOpen": 0.5}, (0.1, 0.0, 0.0), (0.0, 0.0)),
    "facemotion3d": lambda: encode_face_text({"jawOpen": 0.5}, (0.1, 0.0, 0.0), (0.0, 0.0)),
    "openseeface": lambda: open_see_face(features={"mouth_open": 0.5}),
    "vtubestudio": lambda: PHONE,
    "meowface": lambda: PHONE,
    "mediapipe": lambda: b'{"faceBlendshapes":[{"categories":[{"score":0.5,"categoryName":"jawOpen"}]}]}',
    "vmc-performer": lambda: apply(jawopen=0.5),
    "ifacialmocap-v3": lambda: motion_frame((25, 50)),
    "facemotion3d-v3": lambda: motion_frame((25, 50)),
    "vtubestudio-pc": lambda: PARAMETERS,
    "ifacialmocap-tcp": lambda: encode_face_text({"jawOpen": 0.5}, (0.1, 0.0, 0.0), (0.0, 0.0)),
    "facemotion3d-tcp": lambda: encode_face_text({"jawOpen": 0.5}, (0.1, 0.0, 0.0), (0.0, 0.0)),
}
BEFORE = {name: motion_schema(["eyeBlinkLeft", "jawOpen"]) for name in TRACKER_PROTOCOLS if name.endswith("-v3")}
"""What comes before the first frame."""


def test_there_is_a_packet_of_every_protocol() -> None:
    assert set(FACES) == set(TRACKER_PROTOCOLS)


@pytest.mark.parametrize("protocol", TRACKER_PROTOCOLS)
def test_a_packet_is_on_air_with_the_next_tick(cast: Cast, protocol: str) -> None:
    stage = Stage(cast, protocol)
    state = stage.play(0.0, *([BEFORE[protocol]] if protocol in BEFORE else []), FACES[protocol]())
    assert stage.trackers.rejected == 0
    assert state.characters["one"].layers["tracker"].strongest["jawOpen"] > 0.0
    assert state.characters["one"].layers["tracker"].source == stage.sources()[0].name


def test_channels_of_the_cast_s_own_are_played_by_their_names(cast: Cast) -> None:
    stage = Stage(cast, "vmc")
    state = stage.play(4.0, apply(SMILE=0.75, Unknown=1.0))
    assert state.characters["one"].channels["smile"] == pytest.approx(0.75, abs=1e-3)
    assert stage.trackers.values() == {"smile": 0.75}
    (sender,) = stage.trackers.senders()
    assert (sender.name, sender.values) == (HOST, {"smile": 0.75})
    assert sender.heard == stage.trackers.heard


def test_what_a_frame_lacks_stays_as_it_was(cast: Cast) -> None:
    stage = Stage(cast, "ifacialmocap")
    stage.play(0.0, b"jawOpen&40|smile&10|")
    stage.play(0.0, b"smile&20|")
    assert stage.trackers.values() == pytest.approx({"jawOpen": 0.4, "smile": 0.2})
    assert len(stage.sources()) == 1


def test_the_newest_of_several_packets_of_a_tick_counts(cast: Cast) -> None:
    stage = Stage(cast, "ifacialmocap")
    stage.play(0.0, b"jawOpen&10|", b"jawOpen&90|")
    assert stage.trackers.values() == pytest.approx({"jawOpen": 0.9})
    assert stage.sources()[0].rate == 1


def test_head_and_eyes_turn_and_a_sender_without_angles_leaves_them(cast: Cast) -> None:
    stage = Stage(cast, "vmc")
    state = stage.play(3.0, *encode_vmc({"jawOpen": 0.1}, (0.3, -0.2, 0.1), (0.2, 0.1), 0.0))
    assert state.characters["one"].head == pytest.approx((0.3, -0.2, 0.1), abs=1e-3)
    assert stage.trackers.values()["head yaw"] == pytest.approx(0.5 + 0.3 / np.pi, abs=1e-4)
    still = Stage(cast, "livelink")
    still.play(0.0, live_link_face([0.1] * 52 + [0.0] * 9))
    assert [name for name in still.trackers.values() if " " in name] == []
    far = Stage(cast, "vmc")
    far.play(0.0, *encode_vmc({"jawOpen": 0.1}, (3.0, 0.0, 0.0), (0.0, 0.0), 0.0))
    assert far.trackers.rejected == 0


def test_a_tracker_of_the_head_alone_plays(cast: Cast) -> None:
    stage = Stage(cast, "vmc")
    turned = encode_vmc({}, (0.3, 0.0, 0.0), (0.0, 0.0), 0.0)
    assert stage.play(3.0, *turned).characters["one"].head[0] == pytest.approx(0.3, abs=1e-3)


def test_a_loss_and_a_silence_let_go_and_a_return_plays_again(cast: Cast) -> None:
    stage = Stage(cast, "vmc")
    seen = apply(JawOpen=0.8)
    unseen = encode_message("/VMC/Ext/OK", 0)

    def weight(state: State) -> float:
        return state.characters["one"].channels.get("jawOpen", 0.0)

    assert weight(stage.play(4.0, seen)) == pytest.approx(0.8, abs=1e-3)
    assert weight(stage.play(3.0, unseen)) == pytest.approx(0.0, abs=1e-3)
    assert not stage.sources()[0].found
    assert weight(stage.play(2.0, encode_message("/VMC/Ext/OK", 1), seen)) == pytest.approx(0.8, abs=0.02)
    assert weight(stage.play(3.0)) == pytest.approx(0.0, abs=1e-3)
    assert weight(stage.play(2.0, seen)) == pytest.approx(0.8, abs=0.02)


def test_a_source_drives_the_only_character_at_first_and_then_whom_it_is_routed_to(cast: Cast) -> None:
    stage = Stage(cast, "livelink")
    stage.play(0.0, FACES["livelink"]())
    (source,) = stage.sources()
    assert (source.name, source.characters, source.kind) == ("Live Link Face Phone 10.0.0.7", ["one"], "tracker")
    stage.session.receive("console", RouteSource("r", source.name, [], "tracker"), stage.now)
    again = TrackerInput(stage.trackers.protocol, lambda: stage.session)
    stage.session.leave("livelink 10.0.0.7 Phone")
    stage.trackers = again
    stage.play(0.0, FACES["livelink"]())
    assert stage.sources()[0].characters == []


def test_a_second_tracker_does_not_take_the_layer_from_the_first(cast: Cast) -> None:
    stage = Stage(cast, "livelink")
    packet = FACES["livelink"]()
    stage.play(0.0, packet)
    stage.play(0.0, packet, host="10.0.0.8")
    assert [each.characters for each in stage.sources()] == [["one"], []]


def test_a_new_tracker_plays_where_the_first_has_been_silent_for_long(cast: Cast) -> None:
    stage = Stage(cast, "livelink")
    packet = FACES["livelink"]()

    def pass_time(seconds: float) -> None:
        for _ in range(round(seconds)):
            stage.now += 1.0
            stage.session.hands_now(stage.now)

    stage.play(0.1, packet)
    pass_time(QUIET_SECONDS - 3.0)
    stage.play(0.0, packet, host="10.0.0.8")
    assert [each.characters for each in stage.sources()] == [["one"], []], "it may come back"
    pass_time(6.0)
    stage.play(0.0, packet, host="10.0.0.9")
    assert [each.characters for each in stage.sources()] == [["one"], [], ["one"]]


@pytest.mark.parametrize("told", [False, True])
def test_one_that_waits_takes_over_where_the_first_has_been_silent_for_long(cast: Cast, told: bool) -> None:
    """But not one that somebody has told to play nobody."""
    stage = Stage(cast, "livelink")
    packet = FACES["livelink"]()

    def play(seconds: float, *hosts: str) -> list[list[str]]:
        for _ in range(round(seconds)):
            for host in hosts:
                stage.play(0.0, packet, host=host)
            stage.now += 1.0
            stage.session.hands_now(stage.now)
        return [each.characters for each in stage.sources()]

    assert play(2.0, HOST, "10.0.0.8", "10.0.0.9") == [["one"], [], []]
    if told:
        second = stage.sources()[1].name
        stage.session.receive("console", RouteSource("r", second, [], "tracker"), stage.now)
    assert play(QUIET_SECONDS - 2.0, "10.0.0.8") == [["one"], [], []], "it may come back"
    assert play(4.0, "10.0.0.8") == ([["one"], [], []] if told else [["one"], ["one"], []])
    state = stage.play(0.5, packet, host="10.0.0.8").characters["one"]
    assert (state.channels.get("jawOpen", 0.0) > 0.1) is not told
    assert play(2.0, HOST, "10.0.0.8", "10.0.0.9")[2] == [], "one plays"


@pytest.mark.parametrize("back", [False, True])
def test_after_a_restart_one_that_waited_leaves_the_first_its_time_to_come_back(cast: Cast, back: bool) -> None:
    stage = Stage(cast, "livelink")
    packet = FACES["livelink"]()
    stage.play(0.0, packet)
    stage.play(0.0, packet, host="10.0.0.8")
    stage.session = ShowSession.restored(cast, stage.session.snapshot(), epoch=2)
    stage.trackers = TrackerInput(stage.trackers.protocol, lambda: stage.session)
    for second in range(round(QUIET_SECONDS) + 3):
        stage.play(0.0, packet, host="10.0.0.8")
        if back and second > 2:
            stage.play(0.0, packet)
        stage.now += 1.0
        stage.session.hands_now(stage.now)
        played = {each.name[-8:]: each.characters for each in stage.sources()}
        assert second > QUIET_SECONDS - 2.0 or played["10.0.0.8"] == []
    assert played == ({"10.0.0.8": [], "10.0.0.7": ["one"]} if back else {"10.0.0.8": ["one"]})


def test_two_trackers_share_a_character_by_region_on_two_layers(cast: Cast) -> None:
    stage = Stage(cast, "ifacialmocap")
    lips = b"jawOpen&80|=head#0,5,0|"
    head = b"jawOpen&0|=head#0,30,0|"
    stage.play(0.0, lips)
    stage.play(0.0, head, host="10.0.0.8")
    first, second = (each.name for each in stage.sources())
    route = RouteSource("r", second, ["one"], "playback", ["head"])
    assert stage.session.receive("console", route, stage.now) == []
    for _ in range(300):
        stage.trackers.receive(HOST, lips, stage.now)
        state = stage.play(0.0, head, host="10.0.0.8").characters["one"]
    assert first != second
    assert (state.channels["jawOpen"], state.head[0]) == pytest.approx((0.8, np.radians(30.0)), abs=1e-2)


def test_of_several_characters_none_is_driven_by_surprise(cast: Cast) -> None:
    stage = Stage(cast, "livelink")
    stage.session.receive("console", AddCharacter("two", "two", "Two", "generic"), 0.0)
    stage.play(0.0, FACES["livelink"]())
    assert stage.sources()[0].characters == []


def test_each_performer_is_a_source_and_the_one_that_was_silent_longest_makes_room(cast: Cast) -> None:
    stage = Stage(cast, "livelink")
    for index in range(MOST_FACES + 2):
        stage.play(0.0, live_link_face([0.1] * 61, f"phone {index}"))
    assert [each.name for each in stage.sources()] == [
        f"Live Link Face phone {index} {HOST}" for index in range(2, MOST_FACES + 2)
    ]
    for index in range(2 * MOST_FACES):
        stage.play(0.0, live_link_face([0.1] * 61), host=f"10.0.1.{index}")
    assert len(stage.sources()) == MOST_FACES
    assert len(stage.trackers._decoders) <= MOST_FACES


def test_what_cannot_be_read_is_counted_and_what_is_out_of_range_is_at_its_end(cast: Cast) -> None:
    stage = Stage(cast, "livelink")
    stage.play(0.0, FACES["livelink"](), b"hello", live_link_face([9.0] * 61))
    assert (stage.trackers.heard, stage.trackers.rejected, stage.trackers.where) == (3, 2, HOST)
    assert stage.trackers.last_rejection is not None
    assert stage.trackers.last_rejection.sender == f"Live Link Face from {HOST}"
    assert "eyeLookInLeft is 9, so 1.5 is taken" in stage.trackers.last_rejection.reason
    assert "more" in stage.trackers.last_rejection.reason
    assert stage.trackers.values()["jawOpen"] == 1.5


def test_what_is_left_out_is_said_once_by_name_and_names_that_the_cast_lacks_are_no_fault(cast: Cast) -> None:
    stage = Stage(cast, "vmc")
    stage.play(1.0, apply(HeartRate=72.0, JawOpen=0.5, Smile=float("nan")))
    assert stage.trackers.values()["jawOpen"] == 0.5
    assert (stage.trackers.rejected, stage.trackers.remarks) == (1, 1)
    assert stage.trackers.last_rejection is not None
    assert stage.trackers.last_rejection.reason == "Smile is no number"
    assert stage.trackers.remark is not None
    assert stage.trackers.remark.reason.startswith("HeartRate: the cast has no such channel")
    stage.play(0.0, apply(Smile=0.25, JawOpen=float("inf"), Heart=1.0))
    stage.play(0.0, apply(Smile=9.0, JawOpen=0.75))
    assert (stage.trackers.rejected, stage.trackers.remarks) == (2, 2)
    assert stage.trackers.values()["jawOpen"] == 0.75


def test_a_sender_with_new_names_in_each_packet_is_remembered_within_bounds(cast: Cast) -> None:
    stage = Stage(cast, "meowface")
    for packet in range(20):
        shapes = ",".join(f'{{"k":"n{packet}.{name}","v":7}}' for name in range(100))
        stage.play(0.0, f'{{"BlendShapes":[{shapes},{{"k":"JawOpen","v":0.25}}]}}'.encode())
    (face,) = stage.trackers._faces.values()
    assert len(face.said) == MOST_SAID
    assert stage.trackers.remarks == 3, "what comes after so many is left out in silence"
    assert stage.trackers.values()["jawOpen"] == 0.25


def test_feelings_and_looks_of_vrm_are_the_cast_s(cast: Cast) -> None:
    stage = Stage(cast, "vmc")
    stage.play(0.0, apply(FUN=0.25, lookleft=0.5))
    assert stage.trackers.values() == {"eyeLookInRight": 0.5, "eyeLookOutLeft": 0.5, "smile": 0.25}


def test_another_name_of_the_same_source_is_rejected_with_the_session_s_reason(cast: Cast) -> None:
    stage = Stage(cast, "livelink")
    stage.session.receive("console", Source("Live Link Face Phone 10.0.0.7", "tracker", []), 0.0)
    stage.play(0.0, FACES["livelink"]())
    assert stage.trackers.last_rejection is not None
    assert "another link sends" in stage.trackers.last_rejection.reason


@pytest.mark.parametrize("protocol", TRACKER_PROTOCOLS)
def test_damaged_packets_raise_nothing_and_put_no_nan_on_air(cast: Cast, protocol: str) -> None:
    generator = np.random.default_rng(5)
    stage = Stage(cast, protocol)
    golden = FACES[protocol]()
    if protocol in BEFORE:
        assert stage.trackers.receive(HOST, BEFORE[protocol], stage.now), "the names are acknowledged"
    for count in range(600):
        damaged = bytearray(golden)
        for place in generator.integers(0, len(damaged), generator.integers(1, 5)):
            damaged[place] = generator.integers(256)
        for packet in (bytes(damaged), golden[: int(generator.integers(len(golden)))], generator.bytes(40)):
            stage.trackers.receive(HOST, packet, stage.now)
        if count % 20 == 0:
            state = stage.play(0.0).characters["one"]
            sent = [*state.channels.values(), *state.head, *state.gaze]
            assert np.isfinite(sent).all()


@pytest.mark.parametrize("names", [("JawOpen", "A"), ("A", "JawOpen")], ids=["first", "last"])
def test_of_names_that_mean_the_same_the_largest_counts(cast: Cast, names: tuple[str, str]) -> None:
    """Who sends all clips of a model says that those of VRM are 0 beside ARKit's."""
    stage = Stage(cast, "vmc")
    said = {name: 0.8 if name == "JawOpen" else 0.0 for name in names}
    assert stage.play(4.0, apply(**said)).characters["one"].channels["jawOpen"] == pytest.approx(0.8, abs=0.01)
    rest = stage.play(4.0, apply(**dict.fromkeys(names, 0.0)))
    assert rest.characters["one"].channels.get("jawOpen", 0.0) < 0.01


def test_a_vowel_opens_the_mouth_by_its_share(cast: Cast) -> None:
    state = Stage(cast, "vmc").play(4.0, apply(A=0.5))
    assert state.characters["one"].channels["jawOpen"] == pytest.approx(0.35, abs=0.01)
