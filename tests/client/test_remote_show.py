"""The calls of a program: each is one message that the session obeys as the engine obeys its own call."""

import inspect
import math
import struct
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from msgspec import structs

import omote
from omote.client.remote_character import RemoteCharacter
from omote.client.remote_show import RemoteShow
from omote.inputs.voices.spoken_text import WantedSpeech
from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import make_curve
from omote.perform.frame import Frame, LayerStatus, SpeechStatus
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.perform.performer import Performer
from omote.perform.scene.scene import Scene
from omote.show.declaration import ClientMessage
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.leases import Leases
from omote.show.objects.link import Hello
from omote.show.objects.sources import Drive, Source, SourceIs, SourceState
from omote.show.objects.speech import Say
from omote.show.objects.state import Place
from omote.show.session import ShowSession
from tests.client.test_program_link import ticking
from tests.server.conftest import ShowHarness

NO_CALLS = {
    "set_channels",  # of a session's own devices; a program sends a frame of many by `drive`
    *("goal_of", "shown_goal", "call_goal", "set_pace"),  # of cues and memories; a program has the call of each part
    *("channels_of", "call_channels", "keep_look_of"),  # of the preview
    "advance",
    "recast",
    "restored",
    "snapshot",
    "call_light",
    "drive_layer",
    "leave_layer",
    "recalibrate_layer",
    *("move_pad", "wear_pads"),  # an engine is given a pad, a program calls those of the show by name
    *("find_pad", "follow_pads"),  # of the show, and of the preview
    "note_camera",  # stages say where theirs are
    *(
        "play_clip",
        "find_clips",
        "set_clips",
        "clips_playing",
        "resume_clips",
        "play_sound",
    ),  # an engine is given clips and the seconds of sounds, a program calls those of the show by name
}
"""What is the server's, and the scene's."""

MOUTH = MacroMapping("mouth", (MacroTarget("channel/jawOpen", high=0.5, rise=0.1),))
CALLS: dict[str, Callable[[Any], Any]] = {
    "call_face": lambda one: one.call_face("broad", seconds=2, easing="gentle"),
    "call_face by hand": lambda one: one.call_face("broad", seconds=math.inf),
    "call_expression": lambda one: one.call_expression("smile", seconds=0.5),
    "call_expression in a region": lambda one: one.call_expression("smile", seconds=0.5, region="brows"),
    "call_expression of the whole again": lambda one: (
        one.call_expression("smile", seconds=0, region="eyes"),
        one.call_expression("jawOpen", seconds=0.5, easing="sharp"),
    ),
    "call_pose": lambda one: one.call_pose("bow", seconds=0.5),
    "call_pose in a region": lambda one: one.call_pose("wave", seconds=0.5, region="arm_left"),
    "fade_pose": lambda one: (one.call_pose("bow", seconds=math.inf), one.fade_pose(0.5)),
    "release_pose": lambda one: (one.call_pose("bow"), one.fade_pose(0.5), one.release_pose()),
    "call_body": lambda one: one.call_body("broad", seconds=0.5),
    "stop_clip": lambda one: one.stop_clip("line1", seconds=0.5),
    "fade_face": lambda one: (one.call_face("broad", seconds=math.inf), one.fade_face(0.5)),
    "fade_expression": lambda one: (one.call_expression("smile", seconds=math.inf), one.fade_expression(0.5)),
    "release_face": lambda one: (one.call_face("broad"), one.fade_face(0.5), one.release_face()),
    "release_expression": lambda one: (
        one.call_expression("smile"),
        one.fade_expression(0.5),
        one.release_expression(),
    ),
    "set_channel": lambda one: one.set_channel("jawOpen", 0.4),
    "set_head": lambda one: one.set_head(0.1, 0.2, 0.3),
    "set_gaze": lambda one: one.set_gaze(0.1, -0.2),
    "drive": lambda one: one.drive({"jawOpen": 0.5, "smile": 0.25}, layer="lips", head=(0.125, 0, 0), gaze=(0, 0.25)),
    "drive not found": lambda one: (
        one.drive({"jawOpen": 0.5}, layer="blink"),
        one.drive({"jawOpen": 1.0}, found=False, layer="blink"),
    ),
    "set_layer": lambda one: one.set_layer("emotion", region="mouth", influence=0.5),
    "set_motion": lambda one: one.set_motion(0.5, blinks=1.5, seed=3),
    "set_spring": lambda one: one.set_spring("jowls-sway", 0.25),
    "set_skin": lambda one: one.set_skin("blood", 0.25),
    "look_at": lambda one: one.look_at("direction", yaw=0.02, pitch=-0.01),
    "look_at a point, idle": lambda one: (one.look_at("point", z=1.5), one.set_motion(idle=True)),
    "set_layer off": lambda one: one.set_layer("emotion", on=False),
    "call_expression in part": lambda one: one.call_expression("smile", seconds=0.5, strength=0.75),
    "say": lambda one: one.say("Ah", timing="words", marks=["Papa"], times=[0.0, 0.5], delay=0.25, offset=0.125),
    "say after": lambda one: (one.say("Papa"), one.say("Mama", language="de", seconds=2.0, queue=True)),
    "stop_speaking": lambda one: one.stop_speaking(),
    "gesture": lambda one: one.gesture("nod", amplitude=0.5, seconds=1.0),
    "set_mapping": lambda one: one.set_mapping(MOUTH, key="k"),
    "set_mappings": lambda one: one.set_mappings([MOUTH, MOUTH.with_name("jaw")], key="k"),
    "move_macro": lambda one: (one.set_mapping(MOUTH), one.move_macro("mouth", 0.5)),
    "rename_mapping": lambda one: (one.set_mapping(MOUTH), one.rename_mapping("mouth", "jaw", key="k")),
    "drop_mapping": lambda one: (one.set_mapping(MOUTH), one.move_macro("mouth", 1.0), one.drop_mapping("mouth")),
    "restore_mapping": lambda one: (one.set_mapping(MOUTH), one.restore_mapping("mouth")),
    "set_home": lambda one: one.set_home("broad", seconds=3),
    "panic": lambda one: (one.set_channel("jawOpen", 0.4), one.panic()),
}


class Wired:
    """A session in this process, a show that plays it, and its clock."""

    def __init__(self, cast: Cast) -> None:
        self.session = ShowSession(cast, epoch=1)
        self.now = 0.0
        self.sent = 0
        self.session.receive("p", Hello("console", PROTOCOL_VERSION, "program"), 0.0)
        self.state = self.session.tick(0.0)
        self.show = RemoteShow[None, None](self.send, lambda: self.state, self.next_id, self.drive, self.speak)

    def send(self, message: ClientMessage) -> None:
        assert self.session.receive("p", message, self.now) == []
        self.state = self.session.tick(self.now)

    def speak(self, message: Say, sound: bytes | WantedSpeech | None) -> None:
        assert sound is None
        self.send(message)

    def drive(self, source: Source, frame: Drive) -> None:
        (opened,) = self.session.receive("p", source, self.now)
        assert isinstance(opened.message, SourceIs)
        self.send(structs.replace(frame, index=opened.message.index))

    def next_id(self) -> str:
        self.sent += 1
        return str(self.sent)

    def later(self, seconds: float) -> None:
        self.now += seconds
        self.state = self.session.tick(self.now)


def test_a_program_has_every_call_of_a_performer() -> None:
    calls = {name for name, _ in inspect.getmembers(Performer, inspect.isfunction) if not name.startswith("_")}
    assert {name.split()[0] for name in CALLS} == calls - NO_CALLS
    for name in calls - NO_CALLS:
        theirs, ours = (inspect.signature(getattr(kind, name)) for kind in (Performer, RemoteCharacter))
        more = [("voice", "")] if name == "say" else []  # a show has voices, an engine starts no process
        assert [*map(asked, theirs.parameters.values()), *more] == list(map(asked, ours.parameters.values())), name


def asked(parameter: inspect.Parameter) -> tuple[object, ...]:
    """What a caller who gives all by name must know of a parameter."""
    return parameter.name, parameter.default


def nameless(frame: Frame) -> dict[str, LayerStatus]:
    """The layers of a frame without the names of their sources."""
    return {layer: each._replace(source="") for layer, each in frame.layers.items()}


def keyless(frame: Frame) -> SpeechStatus | None:
    """The speech of a frame without the keys, which only a program has always."""
    return None if frame.speech is None else replace(frame.speech, keys=())


@pytest.mark.parametrize("name", CALLS)
def test_a_call_over_the_wire_does_what_the_engine_does(cast: Cast, name: str) -> None:
    wired = Wired(cast)
    scene = Scene.begun(cast)
    CALLS[name](wired.show["one"])
    CALLS[name](scene["one"])
    wired.later(0.4)
    expected = scene.advance(0.4).characters["one"].frame
    frame = wired.show["one"].frame
    # a source over the wire has a name
    seen, wanted = (replace(each, layers=nameless(each), speech=keyless(each)) for each in (frame, expected))
    assert seen == wanted


def test_a_program_has_every_call_of_a_scene() -> None:
    calls = {name for name, _ in inspect.getmembers(Scene, inspect.isfunction) if not name.startswith("_")}
    for name in calls - NO_CALLS - {"call_light"}:
        theirs, ours = (inspect.signature(getattr(kind, name)) for kind in (Scene, RemoteShow))
        more = [("voice", "")] if name == "say" else []  # a show has voices, an engine starts no process
        assert [*map(asked, theirs.parameters.values()), *more] == list(map(asked, ours.parameters.values())), name


def test_a_program_plays_a_clip_of_the_show_by_its_name(cast: Cast) -> None:
    wired = Wired(cast)
    clip = Clip([Lane(make_curve([0.0, 9.0], {"jawOpen": [0.9] * 2}, {}))])
    wired.session.clips.load({"line1": clip})
    wired.show["one"].play_clip("line1", seconds=0, weights={"mouth": 1.0})
    performer = Performer(cast)
    performer.play_clip(clip, name="line1", seconds=0, weights={"mouth": 1.0})
    wired.later(0.4)
    assert wired.show["one"].frame == performer.advance(0.4)


def test_what_is_asked_of_all_or_of_a_text_is_refused_in_words(cast: Cast) -> None:
    show = Wired(cast).show
    wrong = cast_to_any("one")
    with pytest.raises(ValueError, match="\\* means all characters; what is on air is of one: one"):
        _ = show["*"].frame
    with pytest.raises(TypeError, match="are the text 'one'; give a list of their names"):
        show.call_framing(wrong)
    with pytest.raises(ValueError, match="there is no character 'two' in this scene"):
        show.call_framing(["two"])
    with pytest.raises(KeyError, match="the character is 5; give its name, one of one"):
        _ = show[cast_to_any(5)]
    for seconds in (None, "2", True):
        with pytest.raises(TypeError, match=f"seconds is {seconds!r}; give a number, or math.inf, which waits"):
            show["one"].call_face("broad", seconds=cast_to_any(seconds))
    with pytest.raises(ValueError, match="there is no character 'two' in this scene"):
        show["one"].look_at("character", "two")
    with pytest.raises(KeyError, match="there is no character 'two' in this scene"):
        show.place("two", x=0.1)
    assert (repr(show), repr(show["one"])) == (
        "<running show with the characters one>", "<character 'one' of a running show>",
    )  # fmt: skip


def cast_to_any(value: object) -> Any:
    return value


def test_characters_come_enter_move_are_framed_and_go(cast: Cast) -> None:
    wired = Wired(cast)
    show = wired.show
    show.add("two", face="broad", label="Beta")
    assert (show.characters, list(show), len(show)) == (("one", "two"), ["one", "two"], 2)
    two = show["two"]
    assert (two.frame.faces, two.presence) == ({"broad": 1.0}, 0.0)
    show.enter("two", seconds=0.5)
    show.place("two", x=0.4, depth=0.1, size=1.2, seconds=0)
    show.place("two", turn=-0.3, seconds=0.5)
    show.call_framing(["one", "two"], seconds=0.5)
    show.call_light("flat", seconds=0.5)
    show.call_black(0.5, seconds=0.5)
    show.rename("two", "Gamma")
    show["*"].call_expression("smile", seconds=0.5)
    wired.later(1.0)
    state = show.state
    assert (two.presence, two.place) == (1.0, Place(0.4, 0.1, 1.2, -0.3))
    assert (state.framing, state.light, state.characters["two"].label) == ({"one+two": 1.0}, {"flat": 1.0}, "Gamma")
    assert state.black == 0.5
    assert [show[name].frame.expressions for name in show] == [{"smile": 1.0}] * 2
    show.panic()
    show.leave("two", seconds=0.5)
    wired.later(1.0)
    assert [show[name].frame.expressions for name in show] == [{"neutral": 1.0}] * 2
    assert two.presence == 0.0
    show.call_framing(seconds=0)
    show.remove("two")
    wired.later(5.0)
    assert show.characters == ("one",)
    with pytest.raises(ValueError, match="there is no character 'two' in this scene"):
        _ = two.frame
    with pytest.raises(KeyError, match="there is no character 'two' in this scene, which has one"):
        _ = show["two"]


def test_a_program_switches_leases_takes_and_releases(cast: Cast) -> None:
    wired = Wired(cast)
    table = wired.session.leasing.table
    wired.show.set_leases(True)
    wired.show.lease("one", "face")
    wired.show.lease("*", "light", take_over=True)
    assert [*table.held] == ["one/face", "*/light"]
    wired.show.release_lease("one", "face")
    assert [*table.held] == ["*/light"]
    wired.show.lease("one")
    assert "one/head" in table.held
    wired.show.release_lease("*")
    assert table.held == {}
    wired.show.set_leases(False)
    assert not table.on


def test_a_part_that_there_is_not_is_refused_with_what_is_near(cast: Cast) -> None:
    with pytest.raises(ValueError, match="there is no part 'fase'"):
        Wired(cast).show.lease("one", "fase")  # type: ignore[arg-type]


@pytest.mark.asyncio
async def test_what_another_holds_raises_its_name_and_the_program_knows_who_holds_what(
    show_harness: ShowHarness,
) -> None:
    url = str(show_harness.client.make_url("/"))
    async with (
        ticking(show_harness),
        await omote.connect_async(url, name="Ana") as ana,
        await omote.connect_async(url, name="robot") as robot,
    ):
        with pytest.raises(ValueError, match="leases are off"):
            await robot.lease("one", "face")
        await ana.set_leases(True)
        await ana["one"].call_face("broad", seconds=0)
        with pytest.raises(ValueError, match=r"Ana holds the face of one: take it over"):
            await robot["one"].fade_face(0.5)
        await robot.lease("one", "face", take_over=True)
        assert {key: (seat.name, seat.number == robot.leases.you) for key, seat in robot.leases.held.items()} == {
            "one/face": ("robot", True)
        }
        with pytest.raises(ValueError, match="robot holds the face of one"):
            await ana["one"].call_face("generic", seconds=0)
        assert isinstance(ana.leases, Leases)


@pytest.fixture
def wired(cast: Cast) -> Wired:
    """A show of two characters, and one frame of a source."""
    wired = Wired(cast)
    wired.show.add("two", label="Rex")
    wired.session.receive("p", Source("phone", "tracker", ["jawOpen"], ["one"]), 0.0)
    drive(wired, 0.5)
    return wired


def drive(wired: Wired, value: float) -> None:
    wired.send(Drive(1, struct.pack("<f", value)))


def told(wired: Wired) -> SourceState:
    (source,) = wired.session.sources.states({})
    return source


def test_every_call_takes_a_character_by_its_label(wired: Wired) -> None:
    show = wired.show
    show.enter("REX", seconds=0)
    show.place("rex", x=0.2, seconds=0)
    show.call_framing(["one", "Rex"], seconds=0)
    wired.later(0.1)
    assert (show.state.characters["two"].place.x, show.state.framing) == (0.2, {"one+two": 1.0})
    with pytest.raises(ValueError, match="there is no character 'max'"):
        show.lease("max", "face")
    show.leave("Rex", seconds=0)
    show.rename("rex", "Ann")
    show.remove("ann", seconds=0)
    wired.later(5.0)
    assert show.characters == ("one",)
    with pytest.raises(ValueError, match="there is no character 'ann' in this scene, which has one"):
        show.remove("ann")


def test_a_source_is_routed_by_label_to_regions_of_several(wired: Wired) -> None:
    wired.show.route_source("phone", ["one", "rex"], layer="playback", regions=["mouth", "brows"])
    source = told(wired)
    assert (source.characters, source.layer, source.regions) == (["one", "two"], "playback", ["brows", "mouth"])
    wired.show.route_source("phone", ["*"])
    assert (told(wired).characters, told(wired).layer) == (["*"], "tracker")
    wired.show.route_source("phone", [])
    assert told(wired).characters == []


def test_a_source_is_measured_and_tuned(wired: Wired) -> None:
    wired.show.calibrate_source("phone", "range", ["jawOpen"])
    drive(wired, 0.75)
    wired.show.calibrate_source("phone", "done")
    wired.show.tune_source("phone", mirror=True, lids=1.5, smoothing=0.25)
    source = told(wired)
    assert source.highest == {"jawOpen": 0.75}
    assert (source.mirror, source.lids, source.smoothing, source.gain) == (True, 1.5, 0.25, 1.0)


WRONG: dict[str, tuple[type[Exception], Any]] = {
    "there is no character 'gone'": (ValueError, lambda show: show.route_source("a", ["gone"])),
    "there is no layer for a source 'hands'": (ValueError, lambda show: show.route_source("a", ["one"], layer="hands")),
    "there is no region of a source 'nose'": (
        ValueError,
        lambda show: show.route_source("a", ["one"], regions=["nose"]),
    ),
    "lists of names; give": (TypeError, lambda show: show.route_source("a", "one")),
}


@pytest.mark.parametrize("message", WRONG)
def test_what_is_named_wrong_is_refused_in_words(wired: Wired, message: str) -> None:
    error, call = WRONG[message]
    with pytest.raises(error, match=message):
        call(wired.show)
