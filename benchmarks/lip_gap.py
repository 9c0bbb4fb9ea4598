"""The gap between the lips of the built-in head: of a show that hears a sound, and of visemes without a show."""

from __future__ import annotations

import msgspec
import numpy as np

from omote.builtin import load_cast
from omote.inputs.microphone.microphone_input import MicrophoneInput
from omote.inputs.microphone.microphone_messages import Begin, Sound
from omote.inputs.microphone.sound_features import HOP, SAMPLE_RATE
from omote.model.space.lid_lip_lines import chains
from omote.perform.blending.evaluate import evaluate
from omote.perform.performer import Performer
from omote.perform.speech.viseme_stream import VisemeStream, follow_visemes
from omote.perform.speech.visemes import MOUTH_UNITS, RECIPES
from omote.show.session import ShowSession

TICK = 1.0 / 60.0


class Lips:
    """The gap between the lips of the built-in head under weights of units, 1 where an `aa` is played in full."""

    def __init__(self) -> None:
        cast = load_cast()
        line = next(each for each in cast.space.lines if each.kind == "lips")
        upper, lower = chains(cast.space.points, line.loop)
        self._pair = upper[len(upper) // 2], lower[len(lower) // 2]
        self.rest = self._gap_of({})
        self._slopes = {unit: (self._gap_of({unit: 0.5}) - self.rest) / 0.5 for unit in MOUTH_UNITS}
        self._open = sum(self._slopes[unit] * 0.7 * value for unit, value in RECIPES["aa"].items())

    def gap(self, channels: dict[str, float]) -> float:
        """How far the lips are apart."""
        return sum(self._slopes[unit] * channels.get(unit, 0.0) for unit in MOUTH_UNITS) / self._open

    def _gap_of(self, units: dict[str, float]) -> float:
        performer = Performer(load_cast())
        for unit, value in units.items():
            performer.set_channel(unit, value)
        points = evaluate(load_cast(), performer.advance(1.0))
        return float(points[self._pair[0], 1] - points[self._pair[1], 1])


def play_sound(sound: np.ndarray, begin: Begin, lips: Lips) -> np.ndarray:
    """The gap at each tick of a show that hears this sound."""
    session = ShowSession(load_cast())
    microphones = MicrophoneInput(lambda: session)
    microphones.hear("page", msgspec.msgpack.encode(begin), 0.0)
    pcm = (np.clip(sound, -1, 1) * 32767).astype("<i2")
    gaps = []
    sent = 0
    for tick in range(int(len(sound) / SAMPLE_RATE / TICK)):
        now = (tick + 1) * TICK
        while (sent + 1) * HOP <= now * SAMPLE_RATE:
            piece = pcm[sent * HOP : (sent + 1) * HOP].tobytes()
            microphones.hear("page", msgspec.msgpack.encode(Sound(piece)), now)
            sent += 1
        microphones.play(now)
        character = next(iter(session.tick(now).characters.values()))
        gaps.append(lips.gap(dict(character.channels)))
    return np.array(gaps)


def smooth(weights: np.ndarray, lips: Lips) -> np.ndarray:
    """The gap at each tick of visemes that come every 10 ms."""
    stream = VisemeStream()
    gaps = []
    for row in weights:
        stream = follow_visemes(stream, np.clip(row, 0.0, 1.0), 1.0, HOP / SAMPLE_RATE)
        gaps.append(lips.gap(dict(zip(MOUTH_UNITS, (0.7 * stream.mouth).tolist(), strict=True))))
    times = (np.arange(int(len(gaps) * 0.01 / TICK)) + 1) * TICK
    return np.array([gaps[min(len(gaps) - 1, int(time / 0.01))] for time in times])
