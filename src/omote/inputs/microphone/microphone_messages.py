"""What a page with a microphone and the show say to each other, as MessagePack."""

from __future__ import annotations

import math
from typing import Annotated, Literal, get_args

import msgspec

from omote.inputs.microphone.sound_features import BANDS, SAMPLE_RATE
from omote.inputs.microphone.speaker_profile import SpeakerProfile
from omote.inputs.rejection import PacketError

MICROPHONE_PATH = "/voice"
"""Where pages send their sound."""
LONGEST_SOUND = SAMPLE_RATE
"""Bytes of samples: half a second."""
LONGEST_MESSAGE = LONGEST_SOUND + 256
LONGEST_NAME = 60


class MicrophoneError(PacketError):
    """What came is nothing that a microphone sends, and why."""


class Begin(msgspec.Struct, frozen=True, tag="begin"):
    """A microphone: its name at the show, and its speaker as measured before."""

    name: Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_NAME)]
    bands: Annotated[list[float], msgspec.Meta(max_length=BANDS)] = []
    level: float = 0.0

    @property
    def profile(self) -> SpeakerProfile | None:
        """The speaker, None of one who was not measured; MicrophoneError where the numbers are no speaker's."""
        try:
            return SpeakerProfile(tuple(self.bands), self.level) if self.bands else None
        except ValueError as error:
            raise MicrophoneError(str(error)) from error


class Sentence(msgspec.Struct, frozen=True, tag="sentence"):
    """The speaker begins, or has finished, the sentence that measures the voice."""

    step: Literal["start", "finish", "forget"]


class Speak(msgspec.Struct, frozen=True, tag="speak"):
    """Through which character the microphone speaks; "" none, "*" all."""

    character: Annotated[str, msgspec.Meta(max_length=80)]


class Sound(msgspec.Struct, frozen=True, tag="sound"):
    """What was heard: `samples` of 16 bits at 16 kHz, mono, little-endian, at most half a second; `sent`: the page's
    clock when the last was heard, ms."""

    samples: Annotated[bytes, msgspec.Meta(max_length=LONGEST_SOUND)]
    sent: float = 0.0


FromMicrophone = Begin | Sentence | Speak | Sound
_DECODER = msgspec.msgpack.Decoder(FromMicrophone)


class Voice(msgspec.Struct, frozen=True, tag="voice"):
    """What is heard now. `level`: dB of full scale; `speaks`: 0..1; `viseme`: the strongest; `characters`: who speaks
    by it; `there`: who there is, by name and label; `calibrated`, `calibrating`: of the speaker; `sent`: the clock of
    the newest sound that this is of, ms."""

    level: float
    speaks: float
    viseme: str
    characters: list[str]
    there: dict[str, str]
    calibrated: bool
    calibrating: bool
    sent: float


class Measured(msgspec.Struct, frozen=True, tag="measured"):
    """The speaker, for the page to keep; without bands it was forgotten."""

    bands: list[float]
    level: float


class Rejected(msgspec.Struct, frozen=True, tag="rejected"):
    """What was not obeyed, in words."""

    reason: str


ToMicrophone = Voice | Measured | Rejected


MICROPHONE_MESSAGES: tuple[type[msgspec.Struct], ...] = get_args(FromMicrophone)
PAGE_MESSAGES: tuple[type[msgspec.Struct], ...] = get_args(ToMicrophone)


def read_message(data: bytes) -> FromMicrophone:
    """What a page says; MicrophoneError where it is nothing that there is."""
    try:
        message: FromMicrophone = _DECODER.decode(data)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as error:
        raise MicrophoneError(f"this is nothing that a microphone says: {str(error)[:200]}") from error
    if isinstance(message, Sound):
        if len(message.samples) % 2:
            raise MicrophoneError(f"{len(message.samples)} bytes of sound are no whole samples of 2 bytes each")
        if not math.isfinite(message.sent):
            raise MicrophoneError("the clock of the sound is no number")
    return message
