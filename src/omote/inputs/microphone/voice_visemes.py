"""A voice as it comes in, as visemes: features, the network, and a gate that opens for speech alone."""

from __future__ import annotations

import numpy as np

from omote.arrays import Floats
from omote.inputs.microphone.sound_features import (
    BANDS,
    FRAME_SECONDS,
    SAMPLE_RATE,
    WINDOW,
    FeatureStream,
    SoundFeatures,
)
from omote.inputs.microphone.speaker_profile import SpeakerProfile, SpeakerState, measure_speaker
from omote.inputs.microphone.viseme_frame import VisemeFrame
from omote.inputs.microphone.viseme_network import (
    AHEAD,
    FRAME_INPUTS,
    STACK,
    VisemeNetwork,
    frame_inputs,
    stack_frames,
)
from omote.perform.speech.visemes import PP, SIL

DELAY_SECONDS = AHEAD * FRAME_SECONDS + 0.5 * WINDOW / SAMPLE_RATE
"""How far a decision is behind the sound: the frames that it waits for, and half a window."""
MARGIN = 2.0
CERTAIN = 6.0
"""dB above the noise at which sound begins to count as speech, and does in full; whether it is speech says the
network."""
LIPS_SHUT = 4.0
LIPS_SHUT_IN_NOISE = 6.0
"""How much more a bilabial counts than the network says: lips that miss a closure are seen, those that close too
often are not; in noise it is less sure of them."""
NOISY = 12.0
CLEAR = 24.0
"""dB of speech above the noise where it counts as noise in full, and not at all."""
SPOKEN_SHARE = 0.12
"""Share of the way that this goes from 0 in silence to its whole in speech, each frame: after silence lips are shut as
it is, and parting late is what would be seen."""
SILENT = 0.5
"""How much silence counts beside what the network says: lips that part late are seen."""
LONGEST_SENTENCE = 15.0
"""Seconds of a calibration that are kept."""


class VoiceVisemes:
    """One voice. level: dB of full scale of the newest frame; calibrating: whether a sentence is being measured."""

    def __init__(self, network: VisemeNetwork, profile: SpeakerProfile | None = None) -> None:
        self._network = network
        self.profile = profile
        self._features = FeatureStream()
        self._speaker = SpeakerState(profile)
        self._frames = np.zeros((STACK - 1, FRAME_INPUTS), np.float32)
        self._state = network.begin()
        self._levels = np.full(AHEAD, -200.0, np.float32)  # of the frames that a decision waits for
        self._heard = 0
        self._spoken = 0.0
        self._sentence: list[SoundFeatures] | None = None
        self.level = -100.0

    @property
    def calibrating(self) -> bool:
        """Whether a sentence is being measured."""
        return self._sentence is not None

    @property
    def loudness(self) -> float:
        """dB of the speaker's speech so far."""
        return self._speaker.level

    def push(self, samples: Floats) -> list[VisemeFrame]:
        """The visemes of the frames that these samples (-1..1, 16 kHz) complete; a decision is `DELAY_SECONDS` late."""
        sound = self._features.push(samples)
        if not len(sound):
            return []
        self.level = float(sound.level[-1])
        if self._sentence is not None and sum(map(len, self._sentence)) * FRAME_SECONDS < LONGEST_SENTENCE:
            self._sentence.append(sound)
        self._frames = np.concatenate([self._frames, frame_inputs(sound, self._speaker)])
        shares, self._state = self._network.run(stack_frames(self._frames), self._state)
        self._frames = self._frames[1 - STACK :]
        levels = np.concatenate([self._levels, sound.level])
        self._levels = levels[-AHEAD:]
        loudest = np.lib.stride_tricks.sliding_window_view(levels, AHEAD + 1).max(axis=1)
        return [self._frame(*measures) for measures in zip(shares, levels.tolist(), loudest.tolist(), strict=False)]

    def start_sentence(self) -> None:
        """Measures the speaker from now on."""
        self._sentence = []

    def finish_sentence(self) -> SpeakerProfile:
        """The profile of the speaker, which counts from now on; ValueError where no sentence was heard."""
        sentence = self._sentence or []
        self._sentence = None
        parts = [np.concatenate([getattr(s, name) for s in sentence] or [_NONE[name]]) for name in _NONE]
        self.profile = measure_speaker(SoundFeatures(*parts))
        floor = self._speaker.floor
        level = self._speaker.floor_level
        self._speaker = SpeakerState(self.profile)
        self._speaker.floor = floor
        self._speaker.floor_level = level
        return self.profile

    def _lips_shut(self) -> float:
        """How much more a bilabial counts now."""
        above = self._speaker.level - self._speaker.floor_level
        return float(np.interp(above, (NOISY, CLEAR), (LIPS_SHUT_IN_NOISE, LIPS_SHUT)))

    def _frame(self, shares: Floats, level: float, loudest: float) -> VisemeFrame:
        """A decision. loudest: of its frame and those that it waited for: the gate may open before the lips do."""
        self._heard += 1
        opened = (loudest - self._speaker.floor_level - MARGIN) / (CERTAIN - MARGIN)
        weights = shares.astype(float)
        weights[PP] *= 1.0 + (self._lips_shut() - 1.0) * self._spoken
        self._spoken += SPOKEN_SHARE * (1.0 - float(shares[SIL]) - self._spoken)
        weights[SIL] *= SILENT
        weights /= weights.sum()
        return VisemeFrame(self._heard * FRAME_SECONDS, tuple(weights.tolist()), level, min(max(opened, 0.0), 1.0))


_NONE = {
    "bands": np.zeros((0, BANDS), np.float32),
    "level": np.zeros(0, np.float32),
    "voicing": np.zeros(0, np.float32),
}
