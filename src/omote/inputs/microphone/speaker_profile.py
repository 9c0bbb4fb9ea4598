"""How a speaker and a room sound: the mean of the bands of speech, and the noise below it; both are followed."""

from __future__ import annotations

from dataclasses import dataclass

import msgspec
import numpy as np

from omote.arrays import Floats
from omote.inputs.microphone.sound_features import BANDS, SoundFeatures

TYPICAL_LEVEL = -34.0
"""dB of the level of speech before any was heard."""
TYPICAL_BANDS = np.interp(np.arange(BANDS), [0, 4, 10, 16, 23], [-8, -6, -16, -22, -27]).astype(np.float32)
"""dB of each band of speech above its level: the long-term mean, which falls towards the treble."""
CALIBRATED_FRAMES = 300.0
TYPICAL_FRAMES = 15.0
MOST_FRAMES = 600.0
"""What a calibration, and the typical voice, count for beside frames that are heard; and the most of them together."""
FIRST_FRAMES = 3
"""Frames at the begin whose window is not full of sound yet: they are quieter than the noise is."""
CHANGE = 4.0
LEAST_CHANGE = 0.05
"""dB of mean change from frame to frame at which a frame counts in full, and what one that stays counts: who holds one
vowel says nothing of the voice's mean."""
ABOVE_FLOOR = 9.0
"""dB above the noise from which a frame counts as speech."""
FLOOR_FALL = 0.25
FLOOR_RISE = 0.03
"""Share of the way down, and dB up, that the noise is followed in a frame."""


@dataclass(frozen=True)
class SpeakerProfile:
    """A speaker, measured by one sentence. bands: mean dB of the 24 bands while speaking; level: its mean level, dB."""

    bands: tuple[float, ...]
    level: float

    def __post_init__(self) -> None:
        """Rejects what is no mean of 24 bands; ValueError with the value."""
        if len(self.bands) != BANDS:
            raise ValueError(f"a speaker has {len(self.bands)} bands; there are {BANDS}")
        for value in (*self.bands, self.level):
            if not -200.0 <= value <= 20.0:
                raise ValueError(f"a speaker's band is {value} dB; it is from -200 to 20 of full scale")

    def to_json(self) -> bytes:
        """The profile as JSON."""
        return msgspec.json.encode(self)

    @staticmethod
    def from_json(data: bytes) -> SpeakerProfile:
        """The profile that `to_json` wrote; ValueError where it is none."""
        try:
            return msgspec.json.decode(data, type=SpeakerProfile)
        except msgspec.MsgspecError as error:
            raise ValueError(f"this is no speaker's profile: {str(error)[:200]}") from error


class SpeakerState:
    """What is known of the speaker now: bands and level of speech, and the floor of noise below each."""

    def __init__(self, profile: SpeakerProfile | None = None) -> None:
        self.bands = TYPICAL_BANDS + TYPICAL_LEVEL if profile is None else np.array(profile.bands, np.float32)
        self.level = TYPICAL_LEVEL if profile is None else profile.level
        self.frames = TYPICAL_FRAMES if profile is None else CALIBRATED_FRAMES
        self._before: Floats | None = None
        self._heard = 0
        self.floor: Floats | None = None
        self.floor_level = 0.0

    def follow(self, bands: Floats, level: float) -> Floats:
        """Takes one frame into account; returns the floor of each band, dB. bands: (24,) dB; level: dB."""
        self._heard += 1
        if self.floor is None or self._heard <= FIRST_FRAMES:
            self.floor = bands.copy()
            self.floor_level = min(level, self.level - 2 * ABOVE_FLOOR)
        down = bands < self.floor
        self.floor += np.where(down, FLOOR_FALL * (bands - self.floor), FLOOR_RISE)
        self.floor_level += FLOOR_FALL * (level - self.floor_level) if level < self.floor_level else FLOOR_RISE
        if level > self.floor_level + ABOVE_FLOOR and level > self.level - 25.0:
            change = 0.0 if self._before is None else float(np.abs(bands - self._before).mean())
            counts = max(LEAST_CHANGE, min(change / CHANGE, 1.0))
            share = counts / (self.frames + counts)
            self.bands = self.bands + share * (bands - self.bands)
            self.level += share * (level - self.level)
            self.frames = min(self.frames + counts, MOST_FRAMES)
        self._before = bands
        return self.floor


def measure_speaker(sound: SoundFeatures) -> SpeakerProfile:
    """The profile of a speaker by the frames of one sentence; ValueError where too little of it is speech."""
    floor, loud = np.percentile(sound.level, [10, 95]) if len(sound) else (0.0, 0.0)
    speech = sound.level > max(floor + ABOVE_FLOOR, loud - 25.0)
    if loud - floor < ABOVE_FLOOR or int(np.sum(speech)) < LEAST_FRAMES:
        raise ValueError("no sentence was heard above the noise: speak nearer to the microphone, or turn it up")
    bands = np.mean(sound.bands[speech], axis=0)
    return SpeakerProfile(tuple(float(band) for band in bands), float(np.mean(sound.level[speech])))


LEAST_FRAMES = 80
"""Frames of speech that a calibration needs: .8 s."""
