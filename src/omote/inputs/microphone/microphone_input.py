"""Microphones at a show session: sound and times in; each is a source of the kind *lips*, driven once a tick."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import chain, count

from omote.inputs.microphone.microphone_messages import (
    Begin,
    Measured,
    MicrophoneError,
    Rejected,
    Sentence,
    Sound,
    Speak,
    ToMicrophone,
    Voice,
    read_message,
)
from omote.inputs.microphone.sound_features import SAMPLE_RATE, read_pcm
from omote.inputs.microphone.spoken_mouth import SpokenMouth
from omote.inputs.microphone.viseme_frame import VisemeFrame
from omote.inputs.microphone.viseme_network import VisemeNetwork, load_network
from omote.inputs.microphone.voice_visemes import VoiceVisemes
from omote.inputs.source_client import SourceClient, refusals
from omote.perform.speech.visemes import SIL, VISEMES, speech_frame
from omote.show.objects.sources import Drive, RouteSource, StreamKind
from omote.show.session import ShowSession
from omote.show.sources.open_source import LAYER_OF

MOST_MICROPHONES = 8
MOST_WAITING = 0.25
"""Seconds of sound that wait for a tick; what is older is left out, for a mouth that is late is worse than one that
misses a sound."""
PAUSE_SECONDS = 0.15
"""Without a packet, after which the voice counts as silent."""
RETRY_SECONDS = 1.0
"""Between two tries to become a source, where the show refused the first."""
LET_GO_SECONDS = 1.0
"""Without a packet, after which the source says that it hears nobody."""
KIND: StreamKind = "lips"


@dataclass
class Microphone(SourceClient):
    """One microphone. who: its client at the session; heard, rested: when sound came, and when the mouth went on;
    asked: when it last asked to be a source; gone: its page has."""

    voice: VoiceVisemes
    mouth: SpokenMouth = field(default_factory=SpokenMouth)
    waiting: deque[Sound] = field(default_factory=deque)
    names: tuple[str, ...] = ()
    newest: VisemeFrame | None = None
    heard: float = 0.0
    rested: float = 0.0
    sent: float = 0.0
    asked: float = -RETRY_SECONDS
    gone: bool = False


class MicrophoneInput:
    """All microphones of a show. rejected: how much was not obeyed."""

    def __init__(self, session: Callable[[], ShowSession], network: VisemeNetwork | None = None) -> None:
        self._session = session
        self._network = network
        self._open: dict[str, Microphone] = {}
        self.rejected = 0

    def __len__(self) -> int:
        return len(self._open)

    def hear(self, who: str, data: bytes, now: float) -> list[ToMicrophone]:
        """Does what a page says; its sound is played at the next tick. Returns what the page is told.

        who: the page; data: its message; now: seconds of the show's clock.
        """
        try:
            message = read_message(data)
            return self._begin(who, message, now) if isinstance(message, Begin) else self._obey(who, message, now)
        except MicrophoneError as error:
            self.rejected += 1
            return [Rejected(str(error))]

    def leave(self, who: str) -> None:
        """Lets a page go: its mouth comes to rest, then its source ends."""
        if who in self._open:
            self._open[who].gone = True

    def play(self, now: float) -> list[tuple[str, Rejected]]:
        """Drives the session by what has come since the last tick; returns what pages are told."""
        rejections = []
        for who, microphone in list(self._open.items()):
            _go_on(microphone, now)
            if microphone.gone and not microphone.mouth.share:
                self._end(who)
                continue
            rejections += [(who, Rejected(reason)) for reason in self._drive(microphone, now)]
        self.rejected += len(rejections)
        return rejections

    def voice(self, who: str) -> Voice | None:
        """What a page is told of its microphone; None of one that has not begun."""
        microphone = self._open.get(who)
        if microphone is None:
            return None
        newest = microphone.newest
        session = self._session()
        return Voice(
            level=round(microphone.voice.level, 1),
            speaks=0.0 if newest is None else round(newest.speaks, 2),
            viseme=VISEMES[SIL] if newest is None else newest.strongest,
            characters=list(session.sources.route(microphone.name).characters),
            there={name: session.scene.labels.get(name, name) for name in session.scene},
            calibrated=microphone.voice.profile is not None,
            calibrating=microphone.voice.calibrating,
            sent=microphone.sent,
        )

    def _of(self, who: str) -> Microphone:
        if who not in self._open:
            raise MicrophoneError("the microphone has no name yet: send begin first")
        return self._open[who]

    def _begin(self, who: str, asked: Begin, now: float) -> list[ToMicrophone]:
        """A microphone begins, or goes on under another name."""
        if who not in self._open and len(self._open) >= MOST_MICROPHONES:
            raise MicrophoneError(f"{MOST_MICROPHONES} microphones are open already; close one first")
        self._network = self._network or load_network()
        voice = VoiceVisemes(self._network, asked.profile)
        self._end(who)
        for gone in [
            microphone.who for microphone in self._open.values() if microphone.gone and microphone.name == asked.name
        ]:
            self._end(gone)  # a page that was loaded anew
        name = self._free_name(asked.name)
        self._open[who] = Microphone(name, who, voice, heard=now, rested=now)
        self._open[who].join(self._session())
        return []

    def _end(self, who: str) -> None:
        if self._open.pop(who, None) is not None:
            self._session().leave(who)

    def _free_name(self, asked: str) -> str:
        """The name, with a number behind it where another source has it."""
        taken = {source.name for source in self._session().sources.states({})} | {
            microphone.name for microphone in self._open.values()
        }
        return next(name for name in chain([asked], (f"{asked} {number}" for number in count(2))) if name not in taken)

    def _obey(self, who: str, message: Sentence | Speak | Sound, now: float) -> list[ToMicrophone]:
        microphone = self._of(who)
        if isinstance(message, Sound):
            _wait(microphone, message, now)
            return []
        if isinstance(message, Speak):
            characters = [message.character] if message.character else []
            call = RouteSource(f"voice {who} {now}", microphone.name, characters, LAYER_OF[KIND], [])
            return [Rejected(reason) for reason in refusals(self._session().receive(who, call, now))]
        if message.step == "start":
            microphone.voice.start_sentence()
            return []
        if message.step == "forget":
            microphone.voice = VoiceVisemes(self._network or load_network())
            return [Measured([], 0.0)]
        try:
            profile = microphone.voice.finish_sentence()
        except ValueError as error:
            raise MicrophoneError(str(error)) from error
        return [Measured(list(profile.bands), profile.level)]

    def _drive(self, microphone: Microphone, now: float) -> list[str]:
        """Sends the mouth to the session; returns the reasons of rejections."""
        session = self._session()
        names = session.cast.expressions
        microphone.join(session)
        frame = speech_frame(microphone.mouth.mouth, names, source=microphone.name)
        if microphone.index is None or frame.names != microphone.names:
            if now - microphone.asked < RETRY_SECONDS:
                return []
            microphone.asked = now
            refused = microphone.open(session, KIND, frame.names, now, direct=True)
            if microphone.index is None:
                return refused
            microphone.names = frame.names
        values = frame.values.astype("<f4").tobytes()
        hears = now - microphone.heard < LET_GO_SECONDS
        drive = Drive(microphone.index, values, found=hears, share=microphone.mouth.share)
        return refusals(session.receive(microphone.who, drive, now))


def _wait(microphone: Microphone, sound: Sound, now: float) -> None:
    """Keeps sound for the next tick."""
    microphone.waiting.append(sound)
    microphone.heard = now
    while sum(len(part.samples) for part in microphone.waiting) > 2 * MOST_WAITING * SAMPLE_RATE:
        microphone.waiting.popleft()


def _go_on(microphone: Microphone, now: float) -> None:
    """Reads what has come; the mouth goes to rest where nothing comes."""
    if microphone.waiting:
        packets = list(microphone.waiting)
        microphone.waiting.clear()
        frames = microphone.voice.push(read_pcm(b"".join(packet.samples for packet in packets)))
        microphone.mouth.follow(frames)
        microphone.newest = frames[-1] if frames else microphone.newest
        microphone.rested = now
        microphone.sent = packets[-1].sent
    if now - microphone.heard > PAUSE_SECONDS:
        microphone.mouth.rest(max(0.0, now - microphone.rested))
        microphone.rested = now
        microphone.newest = None
