"""A show at random, with all that a session can do, for recordings: also on the built-in cast, by the benchmark."""

from __future__ import annotations

import math
import zlib
from collections.abc import Callable, Mapping
from typing import Any

import msgspec
import numpy as np

from omote.perform.clips.clip import Clip
from omote.perform.complexion import SKIN_FADERS
from omote.perform.cues.cue_action import CueAction
from omote.perform.lights import LIGHTS
from omote.perform.mappings.mapping import HalfBelow, MacroCondition, MacroMapping, MacroTarget
from omote.perform.pads.blend_space import PadLook
from omote.perform.snapshot import Playable
from omote.perform.springs.cast_springs import SPRING_NAMES
from omote.show.declaration import ClientMessage
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects import cues as cue_messages
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
from omote.show.objects.characters import (
    AddCharacter,
    EnterCharacter,
    LeaveCharacter,
    PlaceCharacter,
    RemoveCharacter,
    RenameCharacter,
    RestoreCharacter,
)
from omote.show.objects.clips import (
    DropClip,
    EditClip,
    KeepPass,
    PlayClip,
    RecordClip,
    RestoreClip,
    StopClip,
    StoredClip,
    clip_of,
    stored_clip,
)
from omote.show.objects.faders import SetChannel, SetGaze, SetHead
from omote.show.objects.gaze_points import DeleteGazePoint, SetGazePoint
from omote.show.objects.hand.macros import (
    DropMapping,
    MoveMacro,
    RenameMapping,
    RestoreMapping,
    SetMapping,
    SetMappings,
)
from omote.show.objects.hand.pads import AddCastPads, CopyPad, DropPad, MovePad, RenamePad, RestorePad, SetPad
from omote.show.objects.layers import SetLayer
from omote.show.objects.leases import SetLeases
from omote.show.objects.link import Hello
from omote.show.objects.memories import CallMemory, DeleteMemory, KeepMemory, RestoreMemory
from omote.show.objects.motion import LookAt, MakeGesture, SetMotion, SetSkin, SetSpring
from omote.show.objects.pictures import CallBlack, CallFraming, CallLight
from omote.show.objects.preview import PreviewCue, ResetPreview, Take
from omote.show.objects.show_notes import BeginShow, SetNote
from omote.show.objects.sources import CalibrateSource, Drive, RouteSource, Source, SourceIs, TuneSource
from omote.show.objects.speech import PlaySound, Say, SayByVoice, StopSpeaking, StoredSound
from omote.show.objects.stages import Drawing
from omote.show.recording.entries import AnyEntry, decode_entries, encode_entries, name_clips
from omote.show.recording.recorder import Recorder
from omote.show.session import ShowSession
from omote.show.wire import encode

CONSOLES = ("ana", "bo", "cy", "di")
MACROS = ("m1", "m2", "m3")
TRACKERS = ("phone one", "phone two")


class RandomShow:
    """A show that plays at random, and its recording. casts: those that it changes between, by digest; calm: seconds
    between two acts, in the mean."""

    def __init__(self, seed: int, casts: Mapping[str, Playable], *, calm: float = 0.1) -> None:
        self.rng = np.random.default_rng(seed)
        self.casts = casts
        self.calm = calm
        self.cast = next(iter(casts.values()))
        self.faces = sorted(set.intersection(*(set(cast.faces) for cast in casts.values())))
        self.expressions = sorted(set.intersection(*(set(cast.expressions) for cast in casts.values())))
        self.session = ShowSession(self.cast)
        self.session.set_sounds({"bell": 1.5})
        self.now = 1000.0 * float(self.rng.random())
        self.sent = 0
        self.refused = 0
        self.indices: dict[str, int] = {}
        self.states: list[bytes] = []
        for who in CONSOLES:
            self.send(who, Hello("console", PROTOCOL_VERSION, who, bus="preview" if who == "di" else "air"))
        self.send("wall", Hello("stage", PROTOCOL_VERSION))
        self.recorder = Recorder(self.session)
        self.entries: list[AnyEntry] = []
        for who in TRACKERS:
            self.track(who)

    def id(self) -> str:
        self.sent += 1
        return f"id-{self.sent}"

    def pick(self, things: Any) -> Any:
        listed = list(things)
        return listed[self.rng.integers(len(listed))]

    def number(self, low: float, high: float) -> float:
        return float(self.rng.uniform(low, high))

    def character(self) -> str:
        return str(self.pick((*self.session.scene, "*", "nobody")))

    def send(self, who: str, message: ClientMessage) -> None:
        answers = self.session.receive(who, message, self.now)
        for answer in answers:
            if isinstance(answer.message, SourceIs):
                self.indices[who] = answer.message.index

    def track(self, who: str) -> None:
        """A tracker comes, and drives somebody."""
        self.session.join(who, who)
        names = [str(name) for name in self.rng.permutation(self.expressions)[:8]]
        self.send(who, Source(who, "tracker", names, [self.pick(self.session.scene)]))

    def drive(self, who: str) -> None:
        """A frame of a tracker; one of a wrong index is refused."""
        open_source = self.session.sources._open.get(self.indices.get(who, 0))
        count = 8 if open_source is None else len(open_source.names)
        phase = self.now * (1.0 + TRACKERS.index(who))
        values = np.array([0.5 + 0.5 * math.sin(phase + place) for place in range(count)], "<f4")
        head = (0.3 * math.sin(phase), 0.1, 0.0)
        found = bool(self.rng.random() < 0.98)
        self.send(who, Drive(self.indices.get(who, 0), values.tobytes(), head, (0.1, 0.0), found=found))

    def mapping(self) -> MacroMapping:
        """What a macro plays: a channel, the head and the point of a pad, under a condition by chance."""
        targets = (
            MacroTarget(f"channel/{self.pick(self.expressions)}", high=self.number(0, 1), rise=0.1, fall=0.3),
            MacroTarget("head/yaw", high=0.3, curve=((0.0, 0.0), (0.4, 0.1), (1.0, 1.0)), below=HalfBelow(-0.1)),
            MacroTarget("pad/mouth/x", low=-1.0, rise=0.05),
        )
        when = MacroCondition(f"macro/{self.pick(MACROS)}", 0.3) if self.rng.random() < 0.4 else None
        return MacroMapping(self.pick(MACROS), targets[: int(self.rng.integers(1, 4))], when)

    def messages(self) -> list[Callable[[], ClientMessage]]:
        """One of each kind that plays."""
        who, number, pick, new = self.character, self.number, self.pick, self.id
        names = ("one", "two", "three")
        return [
            lambda: CallFace(who(), new(), pick(self.faces), number(0, 3)),
            lambda: CallFace(who(), new(), pick(self.faces), None),
            lambda: CallExpression(who(), new(), pick(self.expressions), number(0, 2)),
            lambda: CallExpression(who(), new(), pick(self.expressions), 0.5, region=pick(("brows", "eyes", "mouth"))),
            lambda: FadeFace(who(), number(0, 1)),
            lambda: FadeExpression(who(), number(0, 1)),
            lambda: pick((ReleaseFace, ReleaseExpression))(who()),
            lambda: Panic(who(), new()),
            lambda: SetHome(who(), pick(self.faces), 1.0),
            lambda: SetChannel(who(), pick(self.expressions), number(-0.6, 1.6)),
            lambda: SetHead(who(), number(-0.5, 0.5), number(-0.3, 0.3), 0.0),
            lambda: SetGaze(who(), number(-0.3, 0.3), 0.0),
            lambda: SetMapping(who(), new(), self.mapping(), pick(("a", "b"))),
            lambda: SetMappings(who(), new(), [self.mapping()]),
            lambda: MoveMacro(who(), pick(MACROS), number(-1.1, 1.1)),
            lambda: MoveMacro(who(), pick(MACROS), number(-1, 1)),
            lambda: RenameMapping(who(), new(), pick(MACROS), pick(MACROS)),
            lambda: DropMapping(who(), new(), pick(MACROS), "c"),
            lambda: RestoreMapping(who(), new(), pick(("a", "b", "c"))),
            lambda: SetLayer(who(), "tracker", influence=number(0, 1), region=pick(("brows", "mouth", None))),
            lambda: SetLayer(who(), "tracker", on=pick((True, False))),
            lambda: SetMotion(who(), number(0, 1), seed=int(self.rng.integers(1000))),
            lambda: SetSpring(who(), pick(SPRING_NAMES), number(0, 2)),
            lambda: SetSkin(who(), pick(SKIN_FADERS), number(0, 1.5)),
            lambda: LookAt(who(), "direction", yaw=number(-0.4, 0.4)),
            lambda: LookAt(who(), "character", name=pick(names)),
            lambda: LookAt(who(), "gaze_point", name="door"),
            lambda: LookAt(who(), "stage"),
            lambda: MakeGesture(who(), new(), pick(("nod", "shake", "wink", "shrug")), number(-1, 1)),
            lambda: SetGazePoint(new(), "door", number(-2, 2), 0.0, 2.0),
            lambda: DeleteGazePoint(new(), "door"),
            lambda: Drawing(60.0, "good", "wall", (number(-1, 1), 0.0, 3.0)),
            lambda: CallLight(new(), pick(LIGHTS), number(0, 2)),
            lambda: CallFraming(new(), [pick(names)], 1.0),
            lambda: CallBlack(number(0, 1), number(0, 1)),
            lambda: KeepMemory(new(), pick(names), pick(("a", "b"))),
            lambda: CallMemory(new(), pick(names), number(0, 1)),
            lambda: DeleteMemory(new(), pick(names), pick(("c", "d"))),
            lambda: RestoreMemory(new(), pick(("a", "b", "c", "d"))),
            lambda: AddCharacter(new(), pick(names), pick(("Ann", "Ben", "Cid")), pick(self.faces)),
            lambda: RemoveCharacter(new(), pick(names), 0.5, key=pick(("e", "f"))),
            lambda: RestoreCharacter(new(), pick(("e", "f"))),
            lambda: RenameCharacter(new(), pick(names), pick(("Dot", "Eve"))),
            lambda: PlaceCharacter(who(), number(-1, 1), 0.2, 1.0, 0.1, 1.0),
            lambda: EnterCharacter(new(), who(), 1.0),
            lambda: LeaveCharacter(new(), who(), 1.0),
            lambda: Say(who(), new(), "Good evening everybody", seconds=number(0.5, 2), queue=pick((True, False))),
            lambda: Say(who(), new(), "ding", sound=pick(("bell", "gong", "chime"))),
            lambda: PlaySound(who(), new(), pick(("bell", "gong", "chime")), number(-0.5, 0.5)),
            lambda: SayByVoice(who(), new(), "Good evening"),
            lambda: StopSpeaking(who()),
            lambda: SetNote(new(), f"note {self.sent}"),
            lambda: BeginShow(new()),
            lambda: RouteSource(new(), pick(TRACKERS), [pick(names)], pick(("tracker", "playback"))),
            lambda: TuneSource(new(), pick(TRACKERS), mirror=pick((True, False)), curve=number(-1, 1)),
            lambda: CalibrateSource(new(), pick(TRACKERS), pick(("neutral", "range", "done", "reset"))),
            lambda: SetLeases(new(), pick((True, False))),
            lambda: MovePad(who(), pick(("moods", "mouth", "faces", "p")), number(-1, 1), pick((None, 0.5))),
            lambda: MovePad(who(), pick(("moods", "mouth", "p")), None, number(-1.1, 1.1)),
            lambda: SetPad(new(), "p", pick(("mouth", "rest", "expression")), 2, self.looks(), pick(("", "g", "h"))),
            lambda: RenamePad(new(), pick(("moods", "p")), pick(("p", "moods")), pick(("g", "h"))),
            lambda: CopyPad(new(), "mouth", pick(("p", "q"))),
            lambda: DropPad(new(), pick(("moods", "p", "q")), pick(("g", "h"))),
            lambda: pick((AddCastPads(new()), RestorePad(new(), pick(("g", "h"))))),
            lambda: RecordClip(new(), pick(names), pick(("c1", "c2")), pick(([], ["mouth"]))),
            lambda: RecordClip(new(), pick(names), pick(("c1", "c2")), sound=pick(("bell", "gong", "chime"))),
            lambda: RecordClip(new(), pick(names), pick(("c1", "c2")), pick(([], ["mouth"])), speed=pick((0.25, 0.5))),
            lambda: KeepPass(new(), pick(names), keep=pick((True, True, False))),
            lambda: KeepPass(new(), pick(names)),
            lambda: PlayClip(who(), new(), pick(("c1", "c2")), pick((None, 0.2)), loop=pick((True, None))),
            lambda: PlayClip(who(), new(), pick(("c1", "c2")), start=number(0, 0.5), speed=pick((0.5, 1.0))),
            lambda: PlayClip(who(), new(), pick(("c1", "c2")), weights={"mouth": number(0, 1)}),
            lambda: StopClip(who()),
            lambda: EditClip(new(), pick(("c1", "c2")), blend_in=number(0, 0.5), speed=pick((0.5, 1.0))),
            lambda: EditClip(new(), pick(("c1", "c2")), sound=pick(("bell", "chime", "")), sound_at=number(-0.5, 0.5)),
            lambda: DropClip(new(), "c2"),
            lambda: RestoreClip(new(), "c2"),
        ]  # fmt: skip

    def looks(self) -> list[PadLook]:
        """The looks of a pad."""
        count = int(self.rng.integers(2, 6))
        places = ((self.number(-1, 1), self.number(-1, 1)) for _ in range(count))
        return [PadLook(f"l{n}", {self.pick(self.expressions): 1.0}, place) for n, place in enumerate(places)]

    def action(self) -> CueAction:
        """Something that a cue does beside moving parts."""
        line = CueAction("say", self.pick(("one", "two", "*")), "Good evening", delay=self.pick((0.0, 0.3)))
        if self.rng.random() < 0.2:
            line = CueAction("say", "one", self.pick(("", "ding")), sound=self.pick(("bell", "gong", "chime")))
        return line if self.rng.random() < 0.7 else CueAction("osc", "127.0.0.1:9", "/cue/1/start")

    def cue_messages(self) -> list[Callable[[], ClientMessage]]:
        """What plays and edits cues."""
        lists = self.session.cues
        cues = [*lists.book.cues] or ["none"]
        number = lists.book.cues[self.pick(cues)].number if lists.book.cues else "1"
        new, pick = self.id, self.pick
        part = pick(("one/face", "one/expression", "one/brows", "one/clip", "*/light", "*/black"))
        goal = {"face": {pick(self.faces): 1.0}, "light": {"flat": 1.0}, "black": {"black": 0.5}}
        goal["expression"] = pick(({pick(self.expressions): 1.0}, {":pad moods": 1.0, ":x": 0.5, ":y": -0.5}))
        goal["clip"] = pick(({}, {"c1": 1.0}, {"c2": 1.0, ":start": 0.1, ":loop": 1.0, ":mouth": 0.5}))
        aimed = goal.get(part.rpartition("/")[2], {pick(self.expressions): 1.0})
        return [
            lambda: cue_messages.PutCue(new(), goes_on=pick(("", "follow", "continue")), post_wait=0.5),
            lambda: cue_messages.PutMove(new(), pick(cues), part, aimed, self.number(0, 1), delay=pick((0.0, 0.4))),
            lambda: cue_messages.PutCue(new(), cue=pick(cues), actions=[self.action()]),
            lambda: cue_messages.RecordCue(new()),
            lambda: cue_messages.DropCue(new(), pick(cues)),
            lambda: cue_messages.UndoCues(new()),
            lambda: cue_messages.RedoCues(new()),
            lambda: cue_messages.Go(new()),
            lambda: cue_messages.Go(new(), seen="none"),
            lambda: cue_messages.GoBack(new()),
            lambda: cue_messages.GoToCue(new(), number, whole=pick((True, False))),
            lambda: cue_messages.AssertLook(new()),
            lambda: cue_messages.SetStandby(new(), number),
            lambda: Take(new(), self.number(0, 2)),
            lambda: Take(new(), 1.0, parts=[pick(("one/face", "one/expression", "*/light", "two"))]),
            lambda: PreviewCue(new(), number, run=pick((True, False))),
            lambda: ResetPreview(new()),
            lambda: cue_messages.PauseCues(new(), on=pick((True, False))),
            lambda: cue_messages.SetShowMode(new(), on=bool(self.rng.random() < 0.1)),
        ]

    def act(self) -> None:
        """Something happens between two ticks."""
        chance = self.rng.random()
        if chance < 0.02:
            self.session.leave("phone two")
            self.track("phone two")
        elif chance < 0.04:
            self.cast = self.pick(self.casts.values())
            self.session.recast(self.cast)
        elif chance < 0.05:
            self.session.set_sounds(self.pick(({}, {"bell": 1.5}, {"bell": 1.5, "gong": 2.0})))
            self.session.named_sounds.load(self.pick(({}, {"chime": StoredSound("0a", 1.0, "c", 9, ("gong",))})))
        elif chance < 0.1:
            self.session.set_channels("phone one", "one", {name: self.number(0, 1) for name in self.expressions[:3]},
                                      self.now)  # fmt: skip
        elif chance < 0.4:
            self.send(self.pick(CONSOLES), self.pick(self.cue_messages())())
        else:
            self.send(self.pick(CONSOLES), self.pick(self.messages())())

    def tick(self) -> None:
        """What comes in within one sixtieth of a second, and a tick; now and then one is late."""
        self.now += 1.0 / 60.0 if self.rng.random() < 0.99 else 0.3
        for who in TRACKERS:
            if self.rng.random() < 0.9:
                self.drive(who)
        while self.rng.random() < 1.0 / 60.0 / self.calm:
            self.act()
        data = encode(self.session.tick(self.now))
        self.entries += self.recorder.take(zlib.crc32(data))
        self.session.hands_now(self.now)
        self.session.take_keep_requests()
        self.session.take_device_messages()
        self.states.append(data)

    def play(self, seconds: float) -> None:
        """Plays for some seconds of ticks."""
        for _ in range(round(60 * seconds)):
            self.tick()


def as_stored(entries: list[AnyEntry]) -> tuple[list[AnyEntry], dict[str, Clip]]:
    """The entries as a file keeps them, and read again; and the clips by their keys."""
    keys: dict[Clip, str] = {}
    named = name_clips(entries, lambda clip: keys.setdefault(clip, f"clip-{len(keys)}"))
    clips = {
        key: clip_of(msgspec.json.decode(stored_clip(clip).encode(), type=StoredClip)) for clip, key in keys.items()
    }
    return decode_entries(encode_entries(named)), clips
