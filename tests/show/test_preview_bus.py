"""The preview: what is set there shows nowhere on air until it is taken, and then both look the same."""

from __future__ import annotations

import itertools
import json
from collections.abc import Callable, Sequence
from typing import Any

import msgspec
import numpy as np
import pytest

from omote.perform.cues.tracking import tracked_at
from omote.perform.scene.scene_snapshot import names_held_by
from omote.perform.scene.two_scenes import TAKEN_PARTS, differing_parts
from omote.show.cues.cue_edits import shown_goals
from omote.show.declaration import CharacterCommand, ClientMessage, DeviceMessage, FileRequest, SceneCommand
from omote.show.messages import CLIENT_MESSAGES, PROTOCOL_VERSION
from omote.show.objects import calls, characters, cues, faders, gaze_points, layers, memories, motion, pictures, speech
from omote.show.objects.clips import PlayClip
from omote.show.objects.hand.pads import MovePad
from omote.show.objects.leases import Leases, SetLeases
from omote.show.objects.link import Bus, Hello, Refused
from omote.show.objects.preview import PreviewCue, ResetPreview, Take
from omote.show.objects.stages import Crew, Drawing
from omote.show.objects.state import CharacterState, State
from omote.show.preview_bus import PreviewBus
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from omote.show.wire import encode
from tests import synthetic
from tests.synthetic import Recast

CAST = synthetic.cast()
FACES = tuple(CAST.faces)
EXPRESSIONS = tuple(name for name in CAST.expressions if name != "neutral")
CHANNELS = ("jawOpen", "smile", "browInnerUp")
FRAME = 1.0 / 60.0


class Show:
    """A session with a console on air (`air`) and one in preview (`ana`); two characters are on the stage."""

    def __init__(self) -> None:
        self.session = ShowSession(CAST)
        self.now = 5.0
        self.ids = map(str, itertools.count())
        self.meet("air")
        self.obey("air", characters.AddCharacter(self.id(), "two", "Two", FACES[1]))
        self.obey("air", characters.EnterCharacter(self.id(), "two", 0.0))
        self.meet("ana", "preview")
        self.run(0.2)

    def id(self) -> str:
        return next(self.ids)

    def meet(self, who: str, bus: Bus = "air", role: Any = "console") -> None:
        self.obey(who, Hello(role, PROTOCOL_VERSION, who if role == "console" else "", bus=bus))

    def say(self, who: str, message: ClientMessage) -> list[str]:
        """Sends a message, and returns why it was rejected."""
        answers = self.session.receive(who, message, self.now)
        return [each.message.reason for each in answers if isinstance(each.message, Refused)]

    def obey(self, who: str, message: ClientMessage) -> None:
        assert self.say(who, message) == []

    def run(self, seconds: float) -> tuple[State, State | None]:
        """Goes on by some time; returns the states of both buses."""
        for _ in range(max(1, round(seconds / FRAME))):
            self.now += FRAME
            state = self.session.tick(self.now)
        return state, self.session.preview_state

    def look(self) -> State:
        """What shows in preview now."""
        _, unseen = self.run(FRAME)
        assert unseen is not None
        return unseen

    def restart(self) -> None:
        """Ends the process and goes on from what it wrote."""
        written = msgspec.msgpack.encode(self.session.snapshot())
        snapshot, _ = read_session_snapshot(msgspec.msgpack.decode(written))
        self.session = ShowSession.restored(CAST, snapshot, epoch=self.session.epoch + 1)
        self.meet("air")
        self.meet("ana", "preview")


@pytest.fixture
def show() -> Show:
    return Show()


def built(rng: np.random.Generator, new_id: Callable[[], str]) -> ClientMessage:
    """A command at random of all that build a look."""
    who = str(rng.choice(("one", "two", "*")))
    face, expression = str(rng.choice(FACES)), str(rng.choice(EXPRESSIONS))
    seconds = float(rng.choice((0.0, 0.3, 1.0)))
    [share, other] = rng.uniform(0.0, 1.0, 2).tolist()
    made: Sequence[Callable[[], ClientMessage]] = (
        lambda: calls.CallFace(who, new_id(), face, seconds),
        lambda: calls.CallExpression(who, new_id(), expression, seconds),
        lambda: calls.CallExpression(who, new_id(), expression, seconds, strength=share),
        lambda: calls.CallExpression(
            who, new_id(), expression, seconds, region=rng.choice(("brows", "eyes", "mouth", "rest")).item()
        ),
        lambda: calls.FadeFace(who, share),
        lambda: calls.ReleaseExpression(who),
        lambda: faders.SetChannel(who, str(rng.choice(CHANNELS)), round(share, 3)),
        lambda: faders.SetHead(who, share - 0.5, 0.2 * other, 0.1),
        lambda: faders.SetGaze(who, 0.5 * share, 0.2 * other),
        lambda: characters.PlaceCharacter(who, share, other, 1.0 + share, 0.3, seconds),
        lambda: characters.LeaveCharacter(new_id(), who, seconds),
        lambda: characters.EnterCharacter(new_id(), who, seconds),
        lambda: pictures.CallLight(new_id(), str(rng.choice(("theatre", "flat", "portrait"))), seconds),
        lambda: pictures.CallFraming(new_id(), [str(rng.choice(("one", "two")))], seconds),
        lambda: pictures.CallBlack(share, seconds),
        lambda: motion.SetMotion(who, liveliness=share, blinks=other, idle=share > 0.5),
        lambda: motion.LookAt(who, "point", x=share, y=other, z=2.0),
        lambda: motion.MakeGesture(who, new_id(), "nod"),
        lambda: layers.SetLayer(who, "emotion", "mouth", share),
        lambda: layers.SetLayer(who, "tracker", on=share > 0.5),
    )
    return made[int(rng.integers(len(made)))]()


# --- what goes where ---


def test_what_follows_the_bus_plays_on_a_scene_alone() -> None:
    """Who declares it plays by `session.scene` alone: all else of a session is of air."""
    followers = {kind for kind in CLIENT_MESSAGES if kind.follows_bus}
    assert all(issubclass(kind, CharacterCommand | SceneCommand) for kind in followers)
    for kind in followers:
        assert kind.act in (CharacterCommand.act, SceneCommand.act, PlayClip.act, MovePad.act), kind
    of_air = {kind for kind in CLIENT_MESSAGES if not kind.follows_bus}
    assert {calls.Panic, speech.Say, speech.SayByVoice, characters.RemoveCharacter, cues.Go, cues.GoBack} <= of_air
    assert {kind for kind in CLIENT_MESSAGES if issubclass(kind, DeviceMessage | FileRequest)} <= of_air


@pytest.mark.parametrize("seed", range(4))
def test_nothing_that_is_built_in_preview_changes_a_byte_on_air(seed: int) -> None:
    rng = np.random.default_rng(seed)
    built_up, untouched = Show(), Show()
    for _ in range(60):
        built_up.say("ana", built(rng, lambda: f"x{rng.integers(10**12)}"))
        seconds = float(rng.choice((FRAME, 0.1)))
        assert encode(built_up.run(seconds)[0]) == encode(untouched.run(seconds)[0])
    assert built_up.session.scene.snapshot() == untouched.session.scene.snapshot()


def test_preview_begins_as_what_is_on_air_and_goes_its_own_way(show: Show) -> None:
    air, unseen = show.run(FRAME)
    assert unseen is not None
    assert msgspec.structs.replace(unseen, bus="air") == air
    show.obey("ana", calls.CallFace("one", show.id(), FACES[2], 0.0))
    show.obey("air", calls.CallFace("one", show.id(), FACES[1], 0.0))
    air, unseen = show.run(FRAME)
    assert unseen is not None
    assert (air.characters["one"].faces, unseen.characters["one"].faces) == ({FACES[1]: 1.0}, {FACES[2]: 1.0})
    assert (air.bus, unseen.bus, unseen.time, unseen.number) == ("air", "preview", air.time, air.number)


def test_nothing_is_made_while_nobody_looks_and_nothing_is_kept_that_nobody_set(show: Show) -> None:
    show.session.leave("ana")
    _, unseen = show.run(0.1)
    assert (unseen, show.session.snapshot().preview) == (None, None)
    show.obey("air", calls.CallFace("one", show.id(), FACES[2], 0.0))
    show.run(FRAME)
    show.meet("ana", "preview")
    assert show.look().characters["one"].faces == {FACES[2]: 1.0}


def test_what_was_built_up_waits_for_who_comes_back(show: Show) -> None:
    show.obey("ana", calls.CallFace("one", show.id(), FACES[2], 1.0))
    show.run(FRAME)
    show.session.leave("ana")
    show.run(3.0)
    show.meet("ana", "preview")
    assert show.look().characters["one"].faces == {FACES[2]: 1.0}


def test_a_second_hello_turns_to_the_other_bus(show: Show) -> None:
    show.meet("ana", "air")
    show.obey("ana", calls.CallFace("one", show.id(), FACES[2], 0.0))
    assert show.run(FRAME)[0].characters["one"].faces == {FACES[2]: 1.0}


# --- take ---


FOLLOWED = (motion.LookAt, layers.SetLayer)
"""What is set at once and shows in time, as far as it can be told apart: as exactly only in the end."""
MOVING = (motion.SetMotion, motion.MakeGesture)
"""What moves by itself has its own time on each bus."""


def drawn(character: CharacterState) -> CharacterState:
    """All that a stage draws of a character, and how it is set."""
    hands: dict[str, Any] = {
        "face_fader": 0.0,
        "expression_fader": 0.0,
        "face_call": None,
        "expression_call": None,
        "region_calls": {},
    }
    return msgspec.structs.replace(character, **hands, motion=None)


def rounded(value: Any) -> Any:
    """A value without what rounding makes of a sum of two."""
    return json.loads(msgspec.json.encode(value), parse_float=lambda text: round(float(text), 9))


@pytest.mark.parametrize("seed", range(8))
def test_after_a_take_both_buses_look_the_same(seed: int) -> None:
    rng = np.random.default_rng(100 + seed)
    show = Show()
    for _ in range(40):
        message = built(rng, show.id)
        if not isinstance(message, FOLLOWED + MOVING):
            show.say(str(rng.choice(("air", "ana"), p=(0.25, 0.75))), message)
        show.run(float(rng.choice((FRAME, 0.2))))
    show.obey("air", Take(show.id(), 0.5))
    air, unseen = show.run(8.0)  # chests have come after their heads
    assert unseen is not None
    for name, each in air.characters.items():
        assert rounded(drawn(each)) == rounded(drawn(unseen.characters[name]))
    assert rounded((air.light, air.framing, air.black)) == rounded((unseen.light, unseen.framing, unseen.black))


@pytest.mark.parametrize("seed", range(4))
def test_a_take_leaves_nothing_that_goes_or_is_set_otherwise(seed: int) -> None:
    rng = np.random.default_rng(200 + seed)
    show = Show()
    for _ in range(6):
        for _ in range(8):
            show.say(str(rng.choice(("air", "ana"))), built(rng, show.id))
            show.run(float(rng.choice((FRAME, 0.2))))
        show.run(0.2)  # a T-bar follows its hand in less
        show.obey("air", Take(show.id(), 0.5))
        show.run(float(rng.choice((0.0, 0.2))))
        assert differing_parts(show.session.preview.scene(), show.session.scene) == []


def test_what_eyes_look_at_and_layers_are_taken_too(show: Show) -> None:
    show.obey("ana", motion.LookAt("one", "direction", yaw=0.3))
    show.obey("ana", layers.SetLayer("one", "emotion", "mouth", 0.4))
    show.obey("air", Take(show.id(), 0.5))
    air, unseen = show.run(12.0)
    assert unseen is not None
    ours, theirs = air.characters["one"], unseen.characters["one"]
    assert ours.gaze == pytest.approx(theirs.gaze, abs=1e-6)
    assert ours.layers["emotion"].influence == theirs.layers["emotion"].influence
    assert ours.motion is not None
    assert theirs.motion is not None
    assert ours.motion.target == theirs.motion.target


def test_a_take_goes_in_its_time_and_moves_nothing_that_is_the_same(show: Show) -> None:
    show.obey("ana", calls.CallFace("one", show.id(), FACES[2], 0.0))
    show.obey("ana", faders.SetChannel("one", "jawOpen", 0.8))
    show.obey("air", calls.CallFace("two", show.id(), FACES[0], 10.0))
    show.run(FRAME)
    show.session.preview.scene()["two"].call_face(FACES[0], seconds=0.0)  # as it goes on air: no part of the take
    before = show.run(FRAME)[0].characters["two"].face_call
    show.obey("ana", Take(show.id(), 2.0))
    air, _ = show.run(1.0)
    assert air.characters["one"].faces[FACES[2]] == pytest.approx(0.5, abs=0.03)
    assert air.characters["one"].channels["jawOpen"] == pytest.approx(0.4, abs=0.03)
    after = air.characters["two"].face_call
    assert before is not None
    assert after is not None
    assert after.start == before.start


def test_a_region_that_goes_its_own_way_stays_when_the_whole_expression_is_taken(show: Show) -> None:
    for who in ("air", "ana"):
        show.obey(who, calls.CallExpression("one", show.id(), EXPRESSIONS[0], 0.0, region="brows"))
    show.obey("ana", calls.CallExpression("one", show.id(), EXPRESSIONS[1], 0.0))
    show.obey("ana", calls.CallExpression("one", show.id(), EXPRESSIONS[0], 0.0, region="brows"))
    show.obey("air", Take(show.id(), 1.0))
    air, _ = show.run(1.5)
    one = air.characters["one"]
    assert (one.expressions, one.regions) == ({EXPRESSIONS[1]: 1.0}, {"brows": {EXPRESSIONS[0]: 1.0}})


def test_a_take_of_some_parts_leaves_the_others_in_preview(show: Show) -> None:
    show.obey("ana", calls.CallFace("*", show.id(), FACES[2], 0.0))
    show.obey("ana", pictures.CallLight(show.id(), "flat", 0.0))
    show.obey("air", Take(show.id(), 0.0, parts=["one"]))
    assert differing_parts(show.session.preview.scene(), show.session.scene) == ["*/light", "two/face"]
    assert show.say("air", Take(show.id(), 0.0, parts=["one/nose"])) != []


def test_a_take_executes_once_and_again_takes_nothing(show: Show) -> None:
    show.obey("ana", calls.CallFace("one", show.id(), FACES[2], 0.0))
    take = Take("once", 0.0)
    show.obey("ana", take)
    show.obey("air", calls.CallFace("one", show.id(), FACES[1], 0.0))
    show.obey("ana", take)
    assert show.run(FRAME)[0].characters["one"].faces == {FACES[1]: 1.0}
    show.obey("ana", Take(show.id(), 0.0))
    before = show.session.scene.snapshot()
    show.obey("ana", Take(show.id(), 0.0))
    assert show.session.scene.snapshot() == before


def test_what_another_holds_is_not_taken_and_nothing_is(show: Show) -> None:
    show.obey("air", SetLeases(show.id(), on=True))
    show.obey("air", calls.CallFace("one", show.id(), FACES[1], 0.0))  # holds the face
    show.obey("ana", calls.CallFace("one", show.id(), FACES[2], 0.0))  # what is not on air needs no lease
    show.obey("ana", pictures.CallLight(show.id(), "flat", 0.0))
    before = show.session.scene.snapshot()
    [said] = show.say("ana", Take(show.id(), 0.0))
    assert "holds the face of one" in said
    assert show.session.scene.snapshot() == before
    show.obey("ana", Take(show.id(), 0.0, parts=["*/light"]))
    held = show.session.leasing.snapshot().held
    assert set(held) == {"one/face"}


# --- what is of air alone ---


@pytest.mark.parametrize("who", ["ana", "air"])
def test_a_panic_of_either_bus_stops_the_air_and_leaves_the_preview(show: Show, who: str) -> None:
    show.obey("air", calls.CallFace("one", show.id(), FACES[1], 0.0))
    for each in ("air", "ana"):
        show.obey(each, calls.CallExpression("one", show.id(), EXPRESSIONS[0], 0.0))
    show.obey(who, calls.Panic("one", show.id()))
    air, unseen = show.run(1.0)
    assert unseen is not None
    assert air.characters["one"].expressions == {"neutral": 1.0}
    assert unseen.characters["one"].expressions == {EXPRESSIONS[0]: 1.0}
    assert unseen.characters["one"].panics == air.characters["one"].panics == 1
    assert unseen.characters["one"].home_next
    assert air.characters["one"].home_next


def test_a_hand_in_preview_is_nobodys_on_air(show: Show) -> None:
    show.obey("ana", faders.SetHead("one", 0.1, 0.0, 0.0))
    show.obey("air", faders.SetHead("two", 0.1, 0.0, 0.0))
    told = show.session.hands_now(show.now)
    assert [(each.who, each.message) for each in told if isinstance(each.message, faders.Hands | Leases)] == []
    show.obey("air", calls.Panic("one", show.id()))
    show.obey("ana", faders.SetHead("one", 0.2, 0.0, 0.0))  # the panic of another refuses hands on air alone


def test_speech_is_refused_in_preview(show: Show) -> None:
    assert "heard in the house" in show.say("ana", speech.Say("one", show.id(), "hello"))[0]
    assert "heard in the house" in show.say("ana", speech.SayByVoice("one", show.id(), "hello"))[0]
    assert show.run(FRAME)[0].characters["one"].speech is None


def test_a_stage_of_the_preview_is_none_of_the_house(show: Show) -> None:
    show.meet("wall", role="stage")
    show.meet("desk", "preview", role="stage")
    show.obey("desk", Drawing(60.0, "good", "desk", (0.0, 0.0, 1.0), sound="ready", sound_here=True))
    assert show.session.crew_now(show.now) == Crew([None], 1 + 1)
    assert show.session.scene.snapshot().cameras == {}
    assert [each for each in show.session.hands_now(show.now) if each.who == "desk"] == []
    show.session.leave("desk", lost=show.now)
    assert show.session.crew_now(show.now).lost == 0


# --- who is in the show ---


def test_the_preview_follows_who_comes_and_goes(show: Show) -> None:
    show.obey("ana", calls.CallFace("two", show.id(), FACES[2], 0.0))
    show.obey("ana", pictures.CallFraming(show.id(), ["two"], 0.0))
    show.obey("ana", characters.AddCharacter(show.id(), "three", "Three", FACES[0]))
    show.obey("air", characters.RenameCharacter(show.id(), "two", "Rex"))
    unseen = show.look()
    assert list(unseen.characters) == ["one", "two", "three"]
    assert (unseen.characters["two"].label, unseen.characters["two"].faces) == ("Rex", {FACES[2]: 1.0})
    show.obey("air", characters.RemoveCharacter(show.id(), "two", 0.2))
    assert show.look().characters["two"].leaves
    show.run(0.5)
    unseen = show.look()
    assert (list(unseen.characters), unseen.framing) == (["one", "three"], {"*": 1.0})
    show.obey("air", characters.AddCharacter(show.id(), "two", "Two", FACES[1]))
    assert show.look().characters["two"].faces == {FACES[1]: 1.0}


def test_points_and_memories_are_of_the_show(show: Show) -> None:
    show.obey("ana", gaze_points.SetGazePoint(show.id(), "seat", 0.0, 0.0, 3.0))
    show.obey("ana", motion.LookAt("one", "gaze_point", "seat"))
    show.obey("ana", calls.CallFace("one", show.id(), FACES[2], 0.0))
    show.obey("ana", memories.KeepMemory(show.id(), "built"))
    show.obey("ana", ResetPreview(show.id()))
    assert show.look().memories == ["built"]
    show.obey("air", memories.CallMemory(show.id(), "built", 0.0))
    assert show.run(FRAME)[0].characters["one"].faces == {FACES[2]: 1.0}
    show.obey("ana", motion.LookAt("one", "gaze_point", "seat"))
    show.obey("air", gaze_points.DeleteGazePoint(show.id(), "seat"))
    looks = show.look().characters["one"].motion
    assert looks is not None
    assert looks.target.kind == "ahead"


# --- what is kept ---


def test_a_restart_keeps_what_was_built_up(show: Show) -> None:
    show.obey("ana", calls.CallFace("one", show.id(), FACES[2], 0.0))
    show.obey("ana", faders.SetChannel("two", "jawOpen", 0.4))
    before = show.look()
    show.restart()
    after = show.look()
    assert {name: (each.faces, each.channels) for name, each in after.characters.items()} == {
        name: (each.faces, each.channels) for name, each in before.characters.items()
    }
    show.obey("air", Take(show.id(), 0.0))
    assert show.run(FRAME)[0].characters["one"].faces == {FACES[2]: 1.0}


def test_channels_go_on_through_a_restart(show: Show) -> None:
    show.obey("ana", faders.SetChannel("one", "jawOpen", 0.8))
    show.obey("ana", Take(show.id(), 2.0))
    show.run(1.0)
    assert "jawOpen" in names_held_by(show.session.scene.snapshot())[1]
    show.restart()
    assert show.run(1.2)[0].characters["one"].channels == {"jawOpen": 0.8}


def test_what_is_in_preview_is_held_as_what_is_on_air_is(show: Show) -> None:
    show.obey("ana", calls.CallFace("one", show.id(), "long", 0.0))
    assert "long" in show.session.names_held()[0]
    before = show.session.snapshot()
    faces = [name for name in FACES if name != "long"]
    with pytest.raises(ValueError, match="long"):
        show.session.recast(Recast(CAST, faces, [*CAST.expressions]))
    assert show.session.snapshot() == before
    show.session.recast(Recast(CAST, [*FACES, "cousin"], [*CAST.expressions]))
    show.obey("ana", calls.CallFace("one", show.id(), "cousin", 0.0))
    assert show.look().characters["one"].faces == {"cousin": 1.0}


def test_a_preview_that_cannot_be_played_costs_no_show(show: Show) -> None:
    show.obey("ana", calls.CallFace("one", show.id(), FACES[2], 0.0))
    written: Any = msgspec.msgpack.decode(msgspec.msgpack.encode(show.session.snapshot()))
    written["preview"]["scene"]["characters"]["one"]["performer"]["face"]["on_air"] = "gone"
    session = ShowSession.restored(CAST, read_session_snapshot(written)[0], epoch=2)
    [said] = session.take_lost()
    assert "built up in preview cannot be played" in said
    assert (session.take_lost(), session.snapshot().preview) == ([], None)
    assert session.scene.snapshot() == show.session.scene.snapshot()


def test_a_preview_that_breaks_ends_no_tick(show: Show, monkeypatch: pytest.MonkeyPatch) -> None:
    show.obey("ana", calls.CallFace("one", show.id(), FACES[2], 0.0))
    monkeypatch.setattr(PreviewBus, "advance", lambda *_: 1 // 0)
    air, unseen = show.run(FRAME)
    assert (air.characters["one"].faces, unseen) == ({FACES[0]: 1.0}, None)
    assert len(show.session.take_lost()) == 1
    monkeypatch.undo()
    assert show.look().characters["one"].faces == {FACES[0]: 1.0}


# --- cues ---


@pytest.fixture
def cued(show: Show) -> Show:
    """Cues 1 to 3, of which 3 is on air: 1 has a face and a light, 2 a region, 3 another face."""
    moves = (
        {"one/face": {FACES[1]: 1.0}, "*/light": {"flat": 1.0}},
        {"one/brows": {EXPRESSIONS[0]: 1.0}},
        {"one/face": {FACES[2]: 1.0}, "two/expression": {EXPRESSIONS[1]: 1.0}},
    )
    for number, goals in enumerate(moves, start=1):
        show.obey("air", cues.PutCue(show.id(), number=str(number)))
        identity = show.session.cues.book.orders["main"][-1]
        for part, goal in goals.items():
            show.obey("air", cues.PutMove(show.id(), identity, part, goal, seconds=0.0))
        show.run(0.3)
        show.obey("air", cues.Go(show.id()))
    show.run(0.3)
    return show


def test_a_cue_is_looked_at_as_it_will_stand_while_another_runs(cued: Show) -> None:
    air = cued.run(FRAME)[0]
    cued.obey("ana", PreviewCue(cued.id(), "2"))
    now, unseen = cued.run(FRAME)
    assert unseen is not None
    assert unseen.looked_at is not None
    assert unseen.looked_at.number == "2"
    tracked = tracked_at(cued.session.cues.book.cues_of("main"), 1)
    shown = shown_goals(cued.session.preview.scene())
    assert {part: shown[part] for part in tracked} == tracked
    assert now.characters == air.characters


def test_a_cue_is_edited_in_preview_and_has_only_what_was_changed_there(cued: Show) -> None:
    cued.obey("ana", PreviewCue(cued.id(), "2"))
    cued.run(FRAME)
    cued.obey("ana", cues.UpdateCue(cued.id()))
    book = cued.session.cues.book
    [_, second, third] = book.cues_of("main")
    assert second.moves.keys() == {"one/brows"}
    cued.obey("ana", faders.SetHead("one", 0.3, 0.0, 0.0))
    cued.run(FRAME)
    cued.obey("ana", cues.UpdateCue(cued.id()))
    [_, second, still] = cued.session.cues.book.cues_of("main")
    assert second.moves.keys() == {"one/brows", "one/head"}
    assert still == third
    cued.obey("ana", faders.SetHead("one", 0.0, 0.0, 0.0))  # and back
    cued.run(FRAME)
    cued.obey("ana", cues.UpdateCue(cued.id()))
    assert cued.session.cues.book.cues_of("main")[1].moves["one/head"].goal["yaw"] == 0.0


def test_a_cue_is_recorded_from_preview_behind_the_one_that_is_looked_at(cued: Show) -> None:
    cued.obey("ana", PreviewCue(cued.id(), "2"))
    cued.run(FRAME)
    cued.obey("ana", calls.CallExpression("two", cued.id(), EXPRESSIONS[0], 0.0))
    cued.run(FRAME)
    cued.obey("ana", cues.RecordCue(cued.id()))
    recorded = cued.session.cues.book.cues_of("main")
    assert [cue.number for cue in recorded] == ["1", "2", "2.5", "3"]
    assert recorded[2].moves.keys() == {"two/expression"}


def test_cues_recorded_in_preview_one_after_the_other_stand_so(cued: Show) -> None:
    """The one that was recorded is looked at from then on: the next has what was changed since."""
    cued.obey("ana", PreviewCue(cued.id(), "2"))
    for expression in EXPRESSIONS[:2]:
        cued.obey("ana", calls.CallExpression("two", cued.id(), expression, 0.0))
        cued.run(FRAME)
        cued.obey("ana", cues.RecordCue(cued.id()))
    recorded = cued.session.cues.book.cues_of("main")
    assert [cue.number for cue in recorded] == ["1", "2", "2.5", "2.6", "3"]
    assert [dict(cue.moves["two/expression"].goal) for cue in recorded[2:4]] == [{e: 1.0} for e in EXPRESSIONS[:2]]
    unseen = cued.run(FRAME)[1]
    assert unseen is not None
    assert unseen.looked_at is not None
    assert unseen.looked_at.number == "2.6"


def test_a_cue_runs_in_preview_in_its_times(cued: Show) -> None:
    [first, *_] = cued.session.cues.book.cues_of("main")
    cued.obey("air", cues.PutMove(cued.id(), first.identity, "one/face", {FACES[1]: 1.0}, seconds=1.0, delay=0.5))
    cued.obey("ana", PreviewCue(cued.id(), "1", run=True))
    assert FACES[1] not in cued.look().characters["one"].faces
    cued.run(1.0)
    assert 0.0 < cued.look().characters["one"].faces[FACES[1]] < 1.0
    cued.run(1.0)
    assert cued.look().characters["one"].faces == {FACES[1]: 1.0}


def test_the_cue_that_is_looked_at_is_kept_through_a_restart(cued: Show) -> None:
    cued.obey("ana", PreviewCue(cued.id(), "2"))
    before = cued.session.snapshot().preview
    assert before is not None
    cued.restart()
    after = cued.session.snapshot().preview
    assert after is not None
    assert (after.looked_at, after.scene.light) == (before.looked_at, before.scene.light)


def test_go_of_who_looks_at_the_preview_plays_on_air(cued: Show) -> None:
    cued.obey("ana", cues.GoToCue(cued.id(), "1"))
    assert cued.run(0.3)[0].characters["one"].faces == {FACES[1]: 1.0}


def test_what_cannot_be_called_in_preview_costs_that_part_and_is_said(cued: Show) -> None:
    identity = cued.session.cues.book.orders["main"][0]
    cued.obey("air", cues.PutMove(cued.id(), identity, "zoe/face", {FACES[1]: 1.0}))
    [said] = cued.say("ana", PreviewCue(cued.id(), "1"))
    assert "zoe" in said
    assert cued.look().light == {"flat": 1.0}


def test_all_that_is_taken_is_said_once() -> None:
    assert len(set(TAKEN_PARTS)) == len(TAKEN_PARTS)
