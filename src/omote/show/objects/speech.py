"""What characters say."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import msgspec
import numpy as np

from omote.perform.performer import Performer
from omote.perform.speech.number_words import Language
from omote.perform.speech.speaking import LONGEST_DELAY
from omote.perform.speech.speech_timing import TimingKind
from omote.show.declaration import SPEECH_LIMIT, CallId, CharacterCommand, Outgoing, RequestId, Session, characters_of
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
