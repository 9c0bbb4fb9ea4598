"""What characters say, and the sounds that a show keeps for it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Annotated, Any, ClassVar

import msgspec
import numpy as np

from omote.perform.performer import Performer
from omote.perform.speech.number_words import Language
from omote.perform.speech.speaking import LONGEST_DELAY
from omote.perform.speech.speech_timing import TimingKind
from omote.show.declaration import (
    SPEECH_LIMIT,
    CallId,
    CharacterCommand,
    ClientMessage,
    Outgoing,
    RequestId,
    ServerMessage,
    Session,
    characters_of,
)
from omote.show.objects.documents import Document
from omote.show.osc import PRESS, Value, osc
from omote.show.validation import Refusal

SOUNDS_PATH = "/sounds"
"""Where sounds are sent, over HTTP."""
MOST_SOUNDS = 256
MOST_BYTES = 2**26
"""Of all sounds that a show keeps; the oldest makes room."""
USUAL_VOICE = "en-gb"
"""Who speaks where no voice is named."""
MOST_MARKS = 1500
"""Words, characters or mouth shapes of one message."""
LONGEST_SOUND_NAME = 60
MOST_NAMED_SOUNDS = 256
MOST_NAMED_BYTES = 2**26
"""Of all sounds that a show file keeps: an hour as MP3, and a good copy of the file takes as many again."""
SoundName = Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_SOUND_NAME)]


def _refuse_unseen(session: Session, who: str) -> None:
    """Refuses what would be heard in the house of a client (who) that looks at the preview."""
    if session.members.looks_at(who) == "preview":
        raise Refusal("speech is heard in the house, so it is not for the preview: look at what is on air to play it.")


class SayByVoice(CharacterCommand, frozen=True):  # before `Say`, whose address with a language would take its own
    """A character says a text by a voice of the show (`GET /voices`), which speaks it first: the sound begins a moment
    later, on the stage that plays sounds, with lips in time. What it says meanwhile, a stop and a panic end the
    waiting. An `id` executes once. A program speaks by `say(voice=...)`, which tells it when it is over."""

    follows_bus = False
    method = None
    longest = SPEECH_LIMIT
    osc = (
        osc(
            "say/voice",
            "says a text by a voice of the show (de, en-us, de+f2, a model of Piper), which the stage plays",
            "text",
            "voice",
        ),
    )

    id: CallId
    text: Annotated[str, msgspec.Meta(max_length=2000), Value("speech")]
    voice: Annotated[str, msgspec.Meta(max_length=120), Value("text", default=USUAL_VOICE)] = USUAL_VOICE

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Asks for it. session: the show; who: the client; now: seconds, monotonic."""
        _refuse_unseen(session, who)
        session.ask_to_speak(who, self, characters_of(session.scene, self.character))
        return ()


class Say(CharacterCommand, frozen=True):
    """A character speaks: its lips move in time with a sound. `timing`: what `marks` are, each beginning at its place
    of `times` (float32, little-endian, seconds from the beginning of the sound; one more is the end of the last):
    words, characters, visemes (Oculus), azure (ids), rhubarb (letters); `text`: none, the text's letters are timed by
    rule, in `language`. `seconds`: the length, where it is known. `sound`: the key of one that was sent to `/sounds`,
    which one stage plays; "": something else does. `delay`: seconds until the sound begins; `offset`: by which the
    mouth is later. `queue`: after all that is said already, else in its place. `key`: what to call it: the
    state's `speech.keys` have it until it is over, and `spoken` once it was said to its end. An `id` executes once."""

    follows_bus = False
    longest = SPEECH_LIMIT
    osc = (
        osc(
            "say",
            "moves its lips to an English text, timed by rule; the sound, which another plays, begins after the delay",
            "text",
            "delay",
        ),
        osc("say/{language}", "the same in a language: en or de", "text", "delay"),
    )

    id: CallId
    text: Annotated[str, msgspec.Meta(max_length=2000), Value("speech")] = ""
    timing: TimingKind = "text"
    marks: Annotated[list[Annotated[str, msgspec.Meta(max_length=80)]], msgspec.Meta(max_length=MOST_MARKS)] = []
    times: Annotated[bytes, msgspec.Meta(max_length=4 * (MOST_MARKS + 1))] = b""
    language: Annotated[Language, Value("language")] = "en"
    seconds: float | None = None
    sound: Annotated[str, msgspec.Meta(max_length=64)] = ""
    delay: Annotated[float, Value(high=LONGEST_DELAY, unit="s", default=0.0)] = 0.0
    offset: float = 0.0
    queue: bool = False
    key: Annotated[str, msgspec.Meta(max_length=64)] = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Speaks, for the length of its sound where it gives none; ValueError for a sound that is not there. session:
        the show; who: the client; now: seconds, monotonic."""
        _refuse_unseen(session, who)
        answers = super(Say, session.sounds.complete(self)).act(session, who, now)
        session.texts.drop(characters_of(session.scene, self.character))
        return answers

    def play(self, performer: Performer) -> None:
        """Plays it."""
        if len(self.times) % 4:
            raise Refusal(f"the times have {len(self.times)} bytes; send float32 numbers of 4 bytes each.")
        performer.say(
            self.text,
            timing=self.timing,
            marks=self.marks,
            times=np.frombuffer(self.times, "<f4").astype(np.float64).tolist(),
            language=self.language,
            seconds=self.seconds,
            sound=self.sound,
            delay=self.delay,
            offset=self.offset,
            queue=self.queue,
            key=self.key,
        )


class PlaySound(CharacterCommand, frozen=True):
    """A sound is heard without lips, in the place of what a character says: who plays its mouth goes on, so that it can
    be performed to a line. `sound`: the key of one that was sent to `/sounds`; `delay`: seconds until it begins, below
    0: so long ago; `key`: as of `say`. `stop_speaking` and a panic end it. An `id` executes once."""

    follows_bus = False
    osc = (osc("play_sound", "has a sound heard without lips", "sound", "delay"),)

    id: CallId
    sound: Annotated[str, msgspec.Meta(min_length=1, max_length=64), Value("text")]
    delay: Annotated[float, Value(low=-LONGEST_DELAY, high=LONGEST_DELAY, unit="s", default=0.0)] = 0.0
    seconds: float | None = None
    key: Annotated[str, msgspec.Meta(max_length=64)] = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Plays it, for its length; ValueError for a sound that is not there. session: the show; who: the client; now:
        seconds, monotonic."""
        _refuse_unseen(session, who)
        answers = super(PlaySound, session.sounds.complete(self)).act(session, who, now)
        session.texts.drop(characters_of(session.scene, self.character))
        return answers

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.play_sound(self.sound, self.seconds or 0.0, delay=self.delay, key=self.key)


class StopSpeaking(CharacterCommand, frozen=True):
    """Ends what a character says, and all that it would say after: its mouth goes to rest."""

    follows_bus = False
    osc = (osc("stop_speaking", "ends what it says, and all that it would say after", PRESS),)

    id: RequestId = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Plays it, and ends the waiting for a voice. session: the show; who: the client; now: seconds, monotonic."""
        session.texts.drop(characters_of(session.scene, self.character))
        return super().act(session, who, now)

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.stop_speaking()


# --- the sounds that a show keeps ---


class StoredSound(Document, frozen=True):
    """A sound, under its name. `sound`: its key, as of `/sounds`; `content`: that of its bytes in the file; `size`: how
    many they are. `former`: the names that it had before, by which clips and cues find it still."""

    kind: ClassVar[str] = "sound"
    most: ClassVar[int] = MOST_NAMED_SOUNDS

    sound: str
    seconds: float
    content: str
    size: int
    former: tuple[str, ...] = ()

    def contents(self) -> Iterable[str]:
        """The key of its bytes."""
        return (self.content,)


class NamedSound(msgspec.Struct, frozen=True):
    """A sound that the show file keeps: its name, its key and its seconds. `former`: names that it had before, by which
    clips and cues find it still."""

    name: str
    sound: str
    seconds: float
    former: list[str] = []


class Sounds(ServerMessage, frozen=True):
    """The sounds that the show file keeps, sorted by name: complete, to consoles after the welcome and with each
    change. One is sent to `/sounds?name=NAME`, and `GET /sounds/KEY` gives its bytes."""

    sounds: list[NamedSound]


class SoundDropped(ServerMessage, frozen=True):
    """Answers drop_sound: who needs the sound, clips and cues in words, and is silent now."""

    name: str
    needed_by: list[str]


class SoundCommand(ClientMessage, frozen=True):
    """A change of the sounds that the show file keeps. An `id` executes once, as of all that follow; answered with
    `sounds`."""

    access = "edit"
    recorded = False
    method: ClassVar[str | None] = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Makes the change. session: the show; who: the client; now: seconds, monotonic."""
        self.change(session.named_sounds)
        return ()

    def change(self, sounds: Any) -> None:
        """Makes the change; ValueError where it cannot be made. sounds: those of the show."""
        raise NotImplementedError


class RenameSound(SoundCommand, frozen=True):
    """Gives a sound another name, which none has yet. Clips and cues that name it find it still."""

    id: CallId
    name: SoundName
    to: SoundName

    def change(self, sounds: Any) -> None:
        """Gives it. sounds: those of the show."""
        sounds.rename(self.name, self.to)


class DropSound(SoundCommand, frozen=True):
    """Takes a sound out of the show; `restore_sound` brings it back until the server restarts. Answered with
    `sound_dropped` too: clips and cues that need it are silent."""

    id: CallId
    name: SoundName

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Takes it out. session: the show; who: the client; now: seconds, monotonic."""
        needed_by = session.named_sounds.drop(self.name, session.clips.clips, session.cues.book)
        return [Outgoing(who, SoundDropped(self.name, needed_by))]


class RestoreSound(SoundCommand, frozen=True):
    """Brings back the sound that was dropped last under a name."""

    id: CallId
    name: SoundName

    def change(self, sounds: Any) -> None:
        """Brings it back. sounds: those of the show."""
        sounds.restore(self.name)
